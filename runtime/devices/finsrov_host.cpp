#include "finemote/devices/finsrov_host.hpp"

namespace finemote {

namespace {

using Verb = FinsRovOrder::Verb;

/// A command word and how many comma-separated numbers follow it.
struct Word {
  char text[8];
  Verb verb;
  std::uint8_t numbers;
};

/// By first letter; longer words before their own beginnings.
constexpr Word kWords[] = {
    {"ACL:ON", Verb::kHeadingOn, 0}, {"ACL:OF", Verb::kHeadingOff, 0}, {"ANG:", Verb::kHeading, 1},
    {"A", Verb::kLeft, 0},           {"BEG", Verb::kNothing, 0},       {"CA", Verb::kCalibrate, 0},
    {"DN", Verb::kDown, 0},          {"D", Verb::kRight, 0},           {"END", Verb::kNothing, 0},
    {"E", Verb::kTurnRight, 0},      {"H:", Verb::kDepth, 1},          {"IVA", Verb::kNothing, 0},
    {"MOT:", Verb::kServos, 4},      {"OFF", Verb::kOff, 0},           {"ON", Verb::kOn, 0},
    {"Q", Verb::kTurnLeft, 0},       {"RPY:ON", Verb::kReportOn, 0},   {"RPY:OFF", Verb::kReportOff, 0},
    {"S", Verb::kBack, 0},           {"TES:", Verb::kTest, 8},         {"UP", Verb::kUp, 0},
    {"VA", Verb::kValues, 0},        {"W", Verb::kForward, 0},         {"Z", Verb::kStop, 0},
};
constexpr std::size_t kWordCount = sizeof kWords / sizeof kWords[0];
constexpr std::size_t kLetters = 26;

/// Where the words of each letter begin in kWords, and how many there are of one at most.
struct Index {
  std::uint8_t first[kLetters + 1];
  std::size_t most;
};

constexpr Index index_of_words() {
  Index index{};
  std::size_t word = 0;
  for (std::size_t letter = 0; letter < kLetters; ++letter) {
    index.first[letter] = static_cast<std::uint8_t>(word);
    const std::size_t begin = word;
    while (word < kWordCount && kWords[word].text[0] == static_cast<char>('A' + letter)) ++word;
    if (word - begin > index.most) index.most = word - begin;
  }
  index.first[kLetters] = static_cast<std::uint8_t>(word);
  return index;
}

constexpr Index kIndex = index_of_words();
static_assert(kIndex.first[kLetters] == kWordCount, "the words are in the order of their first letters");

/// Spaces that are passed over at once.
constexpr unsigned kMostSpaces = 8;
/// Digits of a number at most, leading zeros among them.
constexpr unsigned kMostDigits = 7;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_space(char c) { return c == ' ' || c == '\r' || c == '\n' || c == '\0'; }
constexpr std::int32_t kLargest = 32767;

/// Length of the word if `text` begins with it, else 0.
std::size_t matches(const Word& word, const char* text, std::size_t size) {
  for (std::size_t length = 0; length < sizeof word.text; ++length) {
    if (word.text[length] == '\0') return length;
    if (length == size || text[length] != word.text[length]) return 0;
  }
  return 0;
}

}  // namespace

bool FinsRovHost::receive(Uart& uart) {
  if (stage_ == Stage::kOrders && at_ < size_) return true;
  if (stage_ == Stage::kOrders) begin_message();
  if (stage_ == Stage::kCollecting) collect(uart);
  if (stage_ == Stage::kChecking) check();
  return stage_ == Stage::kOrders;
}

void FinsRovHost::begin_message() {
  stage_ = Stage::kCollecting;
  size_ = at_ = 0;
  too_long_ = false;
}

void FinsRovHost::collect(Uart& uart) {
  std::uint8_t bytes[Uart::kChunk];
  std::size_t read = sizeof bytes;
  for (std::size_t left = uart.full_reads(sizeof bytes) + 1; read == sizeof bytes && left != 0; --left) {
    read = uart.read(bytes, sizeof bytes);
    append(bytes, read);
  }
  if (size_ == 0 || !uart.idle()) return;
  const bool is_disturbed = uart.counters().errors != line_errors_;
  line_errors_ = uart.counters().errors;
  stage_ = Stage::kChecking;
  if (too_long_ || is_disturbed) drop();
}

void FinsRovHost::append(const std::uint8_t* bytes, std::size_t count) {
  const std::size_t size = size_ < kMaxMessage ? size_ : kMaxMessage, room = kMaxMessage - size;
  too_long_ = too_long_ || count > room;
  const std::size_t kept = count < room ? count : room;
  size_ = static_cast<std::uint8_t>(size + kept);
  if (kept == 0) return;
  std::size_t i = 0;
  do {
    text_[size + i] = static_cast<char>(bytes[i]);
  } while (++i != kept);
}

void FinsRovHost::drop() {
  ++bad_messages_;
  begin_message();
}

/// Nothing is done before all of the message is known to be good.
void FinsRovHost::check() {
  FinsRovOrder ignored;
  for (unsigned left = kMostOrders; at_ < size_ && left != 0; --left) {
    if (!parse(ignored)) return drop();
  }
  if (at_ < size_) return;
  stage_ = Stage::kOrders;
  at_ = 0;
}

bool FinsRovHost::next(FinsRovOrder& order) { return stage_ == Stage::kOrders && at_ < size_ && parse(order); }

/// The order that begins at at_ or behind spaces there, which is set behind it. Spaces without one are one, too.
bool FinsRovHost::parse(FinsRovOrder& order) {
  unsigned spaces = 0;
  std::size_t at = at_;
  for (; spaces < kMostSpaces && at < size_ && is_space(text_[at]); ++spaces) ++at;
  at_ = static_cast<std::uint8_t>(at);
  if (at >= size_ || spaces == kMostSpaces) {
    order = {};
    return true;
  }
  const char letter = text_[at];
  if (letter < 'A' || letter > 'Z') return false;
  const std::size_t begin = kIndex.first[letter - 'A'], end = kIndex.first[letter - 'A' + 1];
  for (std::size_t i = 0; i < kIndex.most && begin + i < end; ++i) {
    const Word& word = kWords[begin + i];
    const std::size_t length = matches(word, text_ + at, std::size_t{size_} - at);
    if (length == 0) continue;
    at_ = static_cast<std::uint8_t>(at + length);
    order.verb = word.verb;
    return parse_numbers(word.numbers, order);
  }
  return false;
}

bool FinsRovHost::parse_numbers(unsigned count, FinsRovOrder& order) {
  for (unsigned i = 0; i < kMostNumbers && i < count; ++i) {
    if (i != 0 && (at_ == size_ || text_[at_++] != ',')) return false;
    if (!parse_number(order.value[i])) return false;
  }
  return true;
}

bool FinsRovHost::parse_number(std::int32_t& number) {
  std::size_t at = at_;
  const bool negative = at < size_ && text_[at] == '-';
  if (negative) ++at;
  std::int32_t value = 0;
  unsigned digits = 0;
  for (; digits < kMostDigits && at < size_ && is_digit(text_[at]); ++digits) value = 10 * value + (text_[at++] - '0');
  at_ = static_cast<std::uint8_t>(at);
  const bool is_whole = digits != 0 && (at == size_ || !is_digit(text_[at]));
  number = negative ? -value : value;
  return is_whole && value <= kLargest;
}

}  // namespace finemote
