#include "finemote/devices/finsrov_host.hpp"

#include "finemote/four_bytes.hpp"
#include "little_endian.hpp"

namespace finemote {

namespace {

using Verb = FinsRovOrder::Verb;

/// The first four characters, the first one lowest; those behind the end are 0.
constexpr std::uint32_t packed(const char* text, std::size_t size) {
  std::uint32_t four = 0;
  for (std::size_t i = 0; i < size && i < sizeof four; ++i)
    four |= std::uint32_t{static_cast<std::uint8_t>(text[i])} << 8 * i;
  return four;
}

/// A command word of one to eight letters, and how many comma-separated numbers follow it.
struct Word {
  std::uint32_t first, second;  ///< four letters each
  std::uint8_t letter, size;
  Verb verb;
  std::uint8_t numbers;

  template <std::size_t length>
  constexpr Word(const char (&word)[length], Verb means, std::uint8_t follow)
      : first(packed(word, length - 1)),
        second(length > 5 ? packed(word + 4, length - 5) : 0),
        letter(static_cast<std::uint8_t>(word[0])),
        size(length - 1),
        verb(means),
        numbers(follow) {
    static_assert(length > 1 && length <= 9, "words have one to eight letters");
  }

  /// Whether eight characters, packed by fours, begin with it.
  [[nodiscard]] bool begins(std::uint32_t four, std::uint32_t more) const {
    if (size < 4) return (four ^ first) << (32 - 8 * size) == 0;
    return four == first && (size == 4 || (more ^ second) << (64 - 8 * size) == 0);
  }
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
    while (word < kWordCount && kWords[word].letter == 'A' + letter) ++word;
    if (word - begin > index.most) index.most = word - begin;
  }
  index.first[kLetters] = static_cast<std::uint8_t>(word);
  return index;
}

constexpr Index kIndex = index_of_words();
static_assert(kIndex.first[kLetters] == kWordCount, "the words are in the order of their first letters");

/// What an order keeps takes no more bytes than its text, where each number has one digit and all but the last a comma.
constexpr bool is_compact(const Word& word) { return word.numbers == 0 || word.size >= 2; }
constexpr bool are_compact() {
  for (const Word& word : kWords) {
    if (!is_compact(word)) return false;
  }
  return true;
}
static_assert(are_compact(), "a message is taken apart where it stands");

/// Digits of a number at most, leading zeros among them.
constexpr unsigned kMostDigits = 7;

constexpr bool is_digit(std::uint8_t c) { return c >= '0' && c <= '9'; }
constexpr bool is_space(std::uint8_t c) { return c == ' ' || c == '\r' || c == '\n' || c == '\0'; }
constexpr std::int32_t kLargest = 32767;

}  // namespace

bool FinsRovHost::receive(Uart& uart) {
  if (stage_ == Stage::kObeying && at_ < size_) return true;
  if (stage_ == Stage::kObeying) begin_message();
  if (stage_ == Stage::kCollecting) collect(uart);
  if (stage_ == Stage::kTakingApart) take_apart();
  return stage_ == Stage::kObeying;
}

void FinsRovHost::begin_message() {
  stage_ = Stage::kCollecting;
  size_ = at_ = kept_ = numbers_ = 0;
  too_long_ = false;
}

void FinsRovHost::collect(Uart& uart) {
  std::uint8_t bytes[Uart::kChunk];
  uart.read_all(bytes, sizeof bytes, [&](std::size_t size) { append(bytes, size); });
  if (size_ == 0 || !uart.idle()) return;
  const bool is_disturbed = uart.counters().errors != line_errors_;
  line_errors_ = uart.counters().errors;
  stage_ = Stage::kTakingApart;
  origin_ = uart.began(0, size_);
  if (too_long_ || is_disturbed) drop();
}

void FinsRovHost::append(const std::uint8_t* bytes, std::size_t count) {
  const std::size_t size = size_ < kMaxMessage ? size_ : kMaxMessage, room = kMaxMessage - size;
  too_long_ = too_long_ || count > room;
  const std::size_t kept = count < room ? count : room;
  size_ = static_cast<std::uint8_t>(size + kept);
  move_bytes(bytes, text_ + size, kept);
}

void FinsRovHost::drop() {
  ++bad_messages_;
  begin_message();
}

/// Nothing is done before all of the message is known to be good.
void FinsRovHost::take_apart() {
  for (unsigned left = kMostPieces; at_ < size_ && left != 0; --left) {
    if (!take_piece()) return drop();
  }
  if (at_ < size_) return;
  if (numbers_ != 0) return drop();
  stage_ = Stage::kObeying;
  size_ = kept_;
  at_ = 0;
}

bool FinsRovHost::take_piece() {
  if (numbers_ != 0) return take_number();
  if (!is_space(text_[at_])) return take_word();
  ++at_;
  return true;
}

bool FinsRovHost::take_word() {
  const std::uint8_t letter = text_[at_];
  if (letter < 'A' || letter > 'Z') return false;
  const std::uint32_t four = four_bytes(text_ + at_), more = four_bytes(text_ + at_ + 4);
  const std::size_t begin = kIndex.first[letter - 'A'], end = kIndex.first[letter - 'A' + 1];
  for (std::size_t i = 0; i < kIndex.most && begin + i < end; ++i) {
    const Word& word = kWords[begin + i];
    if (!word.begins(four, more) || at_ + word.size > size_) continue;
    at_ = static_cast<std::uint8_t>(at_ + word.size);
    text_[kept_++] = static_cast<std::uint8_t>(begin + i);
    numbers_ = word.numbers;
    return true;
  }
  return false;
}

/// With the comma behind it, where another one has to follow.
bool FinsRovHost::take_number() {
  std::size_t at = at_;
  const bool negative = text_[at] == '-';
  if (negative) ++at;
  std::int32_t value = 0;
  unsigned digits = 0;
  for (; digits < kMostDigits && at < size_ && is_digit(text_[at]); ++digits) value = 10 * value + (text_[at++] - '0');
  if (digits == 0 || value > kLargest) return false;
  const bool is_last = --numbers_ == 0;
  if (is_last ? at < size_ && is_digit(text_[at]) : at == size_ || text_[at++] != ',') return false;
  at_ = static_cast<std::uint8_t>(at);
  keep(negative ? -value : value);
  return true;
}

void FinsRovHost::keep(std::int32_t number) {
  put_uint16(static_cast<std::uint16_t>(number), text_ + kept_);
  kept_ = static_cast<std::uint8_t>(kept_ + sizeof(std::uint16_t));
}

bool FinsRovHost::next(FinsRovOrder& order) {
  if (stage_ != Stage::kObeying || at_ >= size_) return false;
  const std::uint8_t* kept = text_ + at_;
  const Word& word = kWords[*kept++];
  order.verb = word.verb;
  const std::size_t numbers = word.numbers < kMostNumbers ? word.numbers : kMostNumbers;
  for (std::size_t i = 0; i < numbers; ++i, kept += 2) order.value[i] = int16_at(kept);
  at_ = static_cast<std::uint8_t>(kept - text_);
  return true;
}

}  // namespace finemote
