// pattern % arguments.
#include <fmt/format.h>

#include <cmath>

#include "generator/expression/cost.hpp"
#include "generator/expression/format.hpp"
#include "generator/expression/layout.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/real_format.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/subscript.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

struct PercentField {
  bool left = false;
  bool plus = false;
  bool blank = false;
  bool zero = false;
  bool alternate = false;
  std::size_t width = 0;
  std::optional<std::size_t> precision;
  char type = 's';
};

class PercentFormatter {
 public:
  PercentFormatter(Runtime& runtime, const std::string& pattern, const Value& arguments)
      : runtime_(runtime), pattern_(pattern), arguments_(arguments) {
    if (const auto* tuple = arguments.object<const Tuple>()) several_ = &tuple->items;
  }

  std::string run() {
    runtime_.budget.spend(cost_of_bytes(pattern_.size()));
    std::string out;
    while (at_ < pattern_.size()) {
      if (pattern_[at_] != '%') {
        out += pattern_[at_++];
        continue;
      }
      ++at_;
      const std::string text = field();
      runtime_.budget.spend(cost_of_bytes(text.size()));
      out += text;
      if (out.size() > kMaxText) fail_limit("the text is too long");
    }
    const bool used_all = several_ != nullptr ? next_ >= several_->size() : next_ > 0 || by_name_ || is_mapping();
    if (!used_all) fail_eval("not all arguments converted during string formatting");
    return out;
  }

 private:
  [[nodiscard]] bool is_mapping() const {
    return arguments_.object<Dict>() != nullptr || arguments_.object<List>() != nullptr;
  }

  [[nodiscard]] char peek() const {
    if (at_ >= pattern_.size()) fail_eval("incomplete format");
    return pattern_[at_];
  }

  std::string field() {
    PercentField f;
    std::optional<Value> named;
    if (peek() == '(') named = named_argument();
    read_flags(f);
    f.width = count(f);
    if (at_ < pattern_.size() && pattern_[at_] == '.') {
      ++at_;
      PercentField ignored;
      f.precision = count(ignored);
    }
    while (peek() == 'l' || peek() == 'h' || peek() == 'L') ++at_;
    f.type = pattern_[at_++];
    if (f.type == '%') return "%";
    const Value value = named ? *named : next();
    return text_of(f, value);
  }

  Value named_argument() {
    const auto end = pattern_.find(')', at_);
    if (end == std::string::npos) fail_eval("incomplete format key");
    const std::string key = pattern_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    if (arguments_.object<Dict>() == nullptr) fail_eval("format requires a mapping");
    by_name_ = true;
    return subscript(runtime_, arguments_, Value(key));
  }

  void read_flags(PercentField& f) {
    for (;; ++at_) {
      switch (peek()) {
        case '-':
          f.left = true;
          break;
        case '+':
          f.plus = true;
          break;
        case ' ':
          f.blank = true;
          break;
        case '0':
          f.zero = true;
          break;
        case '#':
          f.alternate = true;
          break;
        default:
          return;
      }
    }
  }

  std::size_t count(PercentField& f) {
    if (peek() != '*') return read_count(pattern_, at_);
    ++at_;
    const auto value = as_integer(next());
    if (!value) fail_eval("* wants int");
    if (value->is_negative()) f.left = true;
    const Integer size = value->is_negative() ? -*value : *value;
    if (!size.is_small() || size.small() > static_cast<std::int64_t>(kMaxWidth)) {
      fail_limit("the width of a format is too large");
    }
    return static_cast<std::size_t>(size.small());
  }

  Value next() {
    if (several_ != nullptr) {
      if (next_ >= several_->size()) fail_eval("not enough arguments for format string");
      return (*several_)[next_++];
    }
    if (next_++ > 0) fail_eval("not enough arguments for format string");
    return arguments_;
  }

  std::string text_of(const PercentField& f, const Value& value) {
    runtime_.budget.spend(cost_of_printing(value));
    switch (f.type) {
      case 's':
        return padded_text(f, to_text(runtime_, value));
      case 'r':
      case 'a':
        return padded_text(f, to_source(runtime_, value));
      case 'c':
        return padded_text(f, character(value));
      case 'd':
      case 'i':
      case 'u':
      case 'x':
      case 'X':
      case 'o':
        return integer(f, value);
      case 'e':
      case 'E':
      case 'f':
      case 'F':
      case 'g':
      case 'G':
        return real(f, value);
      default:
        fail_eval(fmt::format("unsupported format character '{}' (0x{:x}) at index {}", f.type,
                              static_cast<unsigned char>(f.type), at_ - 1));
    }
  }

  static std::string padded_text(const PercentField& f, std::string text) {
    text = shortened(std::move(text), f.precision);
    return pad(std::move(text), f.width, f.left ? '<' : '>', " ");
  }

  static std::string character(const Value& value) {
    if (value.text() != nullptr && count_characters(*value.text()) == 1) return *value.text();
    const auto code = as_integer(value);
    if (!code) fail_eval("%c requires int or char");
    return character_of(*code);
  }

  static std::string sign(const PercentField& f, bool negative) {
    return negative ? "-" : f.plus ? "+" : f.blank ? " " : "";
  }

  static std::string padded_number(const PercentField& f, const std::string& sign, const std::string& digits) {
    if (f.zero && !f.left) return pad_with_zeros(sign, digits, f.width);
    return pad(sign + digits, f.width, f.left ? '<' : '>', " ");
  }

  static std::string integer(const PercentField& f, const Value& value) {
    auto i = as_integer(value);
    const bool is_based = f.type == 'x' || f.type == 'X' || f.type == 'o';
    if (!i && !is_based && as_real(value) != nullptr) i = integer_of(*as_real(value));
    if (!i) {
      fail_eval(fmt::format("%{} format: {} is required, not {}", f.type, is_based ? "an integer" : "a real number",
                            type_name(value)));
    }
    std::string digits = integer_digits(*i, f.type == 'i' || f.type == 'u' ? 'd' : f.type);
    if (f.precision && digits.size() < *f.precision) digits.insert(0, *f.precision - digits.size(), '0');
    std::string lead = sign(f, i->is_negative());
    if (f.alternate && is_based) lead += std::string("0") + f.type;
    return padded_number(f, lead, digits);
  }

  static std::string real(const PercentField& f, const Value& value) {
    const auto i = as_integer(value);
    if (!i && as_real(value) == nullptr) fail_eval(fmt::format("must be real number, not {}", type_name(value)));
    const double d = i ? i->to_double() : *as_real(value);
    const auto precision = static_cast<int>(f.precision.value_or(6));
    const std::string digits = format_magnitude(d, f.type, precision, f.alternate);
    return padded_number(f, sign(f, std::signbit(d) && !std::isnan(d)), digits);
  }

  Runtime& runtime_;
  const std::string& pattern_;
  const Value& arguments_;
  const Values* several_ = nullptr;
  std::size_t at_ = 0;
  std::size_t next_ = 0;
  bool by_name_ = false;
};

}  // namespace

Value format_percent(Runtime& runtime, const std::string& pattern, const Value& arguments) {
  return PercentFormatter(runtime, pattern, arguments).run();
}

}  // namespace finemote::gen::expression
