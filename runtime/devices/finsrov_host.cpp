#include "finemote/devices/finsrov_host.hpp"

#include "finemote/loop_bound.hpp"

namespace finemote {

namespace {

using Verb = FinsRovOrder::Verb;

/// A command word and how many comma-separated numbers follow it. Longer words before their own beginnings.
struct Word {
  char text[8];
  Verb verb;
  std::uint8_t numbers;
};

constexpr Word kWords[] = {
    {"ACL:ON", Verb::kHeadingOn, 0},
    {"ACL:OF", Verb::kHeadingOff, 0},
    {"RPY:ON", Verb::kReportOn, 0},
    {"RPY:OFF", Verb::kReportOff, 0},
    {"ANG:", Verb::kHeading, 1},
    {"TES:", Verb::kTest, 8},
    {"MOT:", Verb::kServos, 4},
    {"H:", Verb::kDepth, 1},
    {"BEG", Verb::kNothing, 0},
    {"END", Verb::kNothing, 0},
    {"IVA", Verb::kNothing, 0},
    {"OFF", Verb::kOff, 0},
    {"ON", Verb::kOn, 0},
    {"UP", Verb::kUp, 0},
    {"DN", Verb::kDown, 0},
    {"CA", Verb::kCalibrate, 0},
    {"VA", Verb::kValues, 0},
    {"W", Verb::kForward, 0},
    {"S", Verb::kBack, 0},
    {"A", Verb::kLeft, 0},
    {"D", Verb::kRight, 0},
    {"Q", Verb::kTurnLeft, 0},
    {"E", Verb::kTurnRight, 0},
    {"Z", Verb::kStop, 0},
};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_space(char c) { return c == ' ' || c == '\r' || c == '\n' || c == '\0'; }
constexpr std::int32_t kLargest = 32767;

/// Length of the word if `text` begins with it, else 0.
std::size_t matches(const Word& word, const char* text, std::size_t size) {
  std::size_t length = 0;
  for (; word.text[length] != '\0'; ++length) {
    if (length == size || text[length] != word.text[length]) return 0;
  }
  return length;
}

}  // namespace

bool FinsRovHost::receive(Uart& uart) {
  if (complete_) size_ = at_ = 0;
  complete_ = false;
  std::uint8_t bytes[32];
  for (std::size_t size = sizeof bytes, done = 0; size == sizeof bytes && done < 2 * kMaxMessage; done += size) {
    size = uart.read(bytes, sizeof bytes);
    const std::size_t room = kMaxMessage - size_;
    too_long_ = too_long_ || size > room;
    const std::size_t kept = size < room ? size : room;
    for (std::size_t i = 0; i < kept; ++i) {
      loop_bound<sizeof bytes>();
      text_[size_ + i] = static_cast<char>(bytes[i]);
    }
    size_ += kept;
  }
  if (size_ == 0 || !uart.idle()) return false;

  complete_ = true;
  const bool disturbed = uart.counters().errors != line_errors_;
  line_errors_ = uart.counters().errors;
  const bool good = !too_long_ && !disturbed && message_is_good();
  too_long_ = false;
  if (!good) {
    ++bad_messages_;
    size_ = 0;
  }
  at_ = 0;
  return good;
}

bool FinsRovHost::message_is_good() {
  std::size_t at = 0;
  FinsRovOrder ignored;
  while (at < size_) {
    if (!parse(at, ignored)) return false;
  }
  return true;
}

bool FinsRovHost::next(FinsRovOrder& order) { return at_ < size_ && parse(at_, order); }

bool FinsRovHost::parse(std::size_t& at, FinsRovOrder& order) const {
  if (is_space(text_[at])) {
    ++at;
    order = {};
    return true;
  }
  for (const Word& word : kWords) {
    const std::size_t length = matches(word, text_ + at, size_ - at);
    if (length == 0) continue;
    at += length;
    order.verb = word.verb;
    return parse_numbers(at, word.numbers, order);
  }
  return false;
}

bool FinsRovHost::parse_numbers(std::size_t& at, unsigned count, FinsRovOrder& order) const {
  for (unsigned i = 0; i < count; ++i) {
    if (i != 0 && (at == size_ || text_[at++] != ',')) return false;
    const bool negative = at < size_ && text_[at] == '-';
    if (negative) ++at;
    if (at == size_ || !is_digit(text_[at])) return false;
    std::int32_t value = 0;
    for (; at < size_ && is_digit(text_[at]); ++at) {
      value = 10 * value + (text_[at] - '0');
      if (value > kLargest) return false;
    }
    order.value[i] = negative ? -value : value;
  }
  return true;
}

}  // namespace finemote
