#include "generator/expression/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/expression/attribute.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/number.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/real_format.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/subscript.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

constexpr std::size_t kMaxWidth = 1'000'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A number in a pattern; moves `at` behind it.
std::size_t read_count(std::string_view pattern, std::size_t& at) {
  std::size_t count = 0;
  for (; at < pattern.size() && is_digit(pattern[at]); ++at) {
    count = count * 10 + static_cast<std::size_t>(pattern[at] - '0');
    if (count > kMaxWidth) fail_limit("the width of a format is too large");
  }
  return count;
}

std::string pad(std::string text, std::size_t width, char align, const std::string& fill) {
  const std::size_t length = count_characters(text);
  if (length >= width) return text;
  const std::size_t missing = width - length;
  const std::size_t left = align == '<' ? 0 : align == '^' ? missing / 2 : missing;
  const auto repeat = [&](std::size_t times) {
    std::string out;
    for (std::size_t i = 0; i < times; ++i) out += fill;
    return out;
  };
  return repeat(left) + text + repeat(missing - left);
}

/// Zeros between the sign (and 0x) and the digits.
std::string pad_with_zeros(const std::string& sign, const std::string& digits, std::size_t width) {
  const std::size_t length = sign.size() + digits.size();
  return sign + std::string(length < width ? width - length : 0, '0') + digits;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
  return text;
}

/// The digits of |i| in the base that a format letter stands for.
std::string integer_digits(const Integer& i, char type) {
  const Integer magnitude = i.is_negative() ? -i : i;
  switch (type) {
    case 'x':
      return magnitude.to_string(16);
    case 'X':
      return upper(magnitude.to_string(16));
    case 'o':
      return magnitude.to_string(8);
    case 'b':
      return magnitude.to_string(2);
    default:
      return magnitude.to_string();
  }
}

// ---- '%' ----------------------------------------------------------------------------------------

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
    if (f.precision && count_characters(text) > *f.precision) {
      const auto characters = split_characters(text);
      std::string cut;
      for (std::size_t i = 0; i < *f.precision; ++i) cut += characters[i];
      text = cut;
    }
    return pad(std::move(text), f.width, f.left ? '<' : '>', " ");
  }

  static std::string character(const Value& value) {
    if (value.text() != nullptr && count_characters(*value.text()) == 1) return *value.text();
    const auto code = as_integer(value);
    if (!code) fail_eval("%c requires int or char");
    if (!code->is_small() || code->small() < 0 || code->small() > 0x10FFFF) fail_eval("%c arg not in range(0x110000)");
    return encode(static_cast<char32_t>(code->small()));
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

// ---- '{}' ---------------------------------------------------------------------------------------

struct Specification {
  std::string fill = " ";
  char align = '\0';
  char sign = '-';
  bool alternate = false;
  bool zero = false;
  char grouping = '\0';
  std::size_t width = 0;
  std::optional<std::size_t> precision;
  char type = '\0';
};

bool is_align(char c) { return c == '<' || c == '>' || c == '^' || c == '='; }

Specification parse_specification(std::string_view text, const Value& value) {
  Specification s;
  std::size_t at = 0;
  const auto characters = split_characters(text);
  if (characters.size() > 1 && is_align(characters[1][0])) {
    s.fill = characters[0];
    s.align = characters[1][0];
    at = characters[0].size() + 1;
  } else if (!text.empty() && is_align(text[0])) {
    s.align = text[at++];
  }
  const auto accept = [&](std::string_view any) {
    return at < text.size() && any.find(text[at]) != std::string_view::npos;
  };
  if (accept("+- ")) s.sign = text[at++];
  if (accept("#")) s.alternate = true, ++at;
  if (accept("0")) s.zero = true, ++at;
  s.width = read_count(text, at);
  if (accept(",_")) s.grouping = text[at++];
  if (accept(".")) {
    ++at;
    if (at >= text.size() || !is_digit(text[at])) fail_eval("Format specifier missing precision");
    s.precision = read_count(text, at);
  }
  if (at < text.size()) s.type = text[at++];
  if (at < text.size()) {
    fail_eval(fmt::format("Invalid format specifier '{}' for object of type '{}'", text, type_name(value)));
  }
  return s;
}

[[noreturn]] void fail_type(char type, const Value& value) {
  fail_eval(fmt::format("Unknown format code '{}' for object of type '{}'", type, type_name(value)));
}

std::string grouped(const std::string& digits, char separator, std::size_t every) {
  const auto end = std::min(digits.find_first_not_of("0123456789abcdefABCDEF"), digits.size());
  std::string out;
  for (std::size_t i = 0; i < end; ++i) {
    if (i > 0 && (end - i) % every == 0) out += separator;
    out += digits[i];
  }
  return out + digits.substr(end);
}

std::string laid_out_number(const Specification& s, bool negative, std::string lead, std::string digits) {
  lead.insert(0, negative ? "-" : s.sign == '+' ? "+" : s.sign == ' ' ? " " : "");
  const bool zeros = s.zero && s.align == '\0';
  if (zeros || (s.align == '=' && s.fill == "0")) return pad_with_zeros(lead, digits, s.width);
  if (s.align == '=') {
    const std::size_t rest = s.width > lead.size() ? s.width - lead.size() : 0;
    return lead + pad(std::move(digits), rest, '>', s.fill);
  }
  return pad(lead + digits, s.width, s.align == '\0' ? '>' : s.align, s.zero && s.fill == " " ? "0" : s.fill);
}

std::string format_integer(const Specification& s, const Value& value, const Integer& i);

std::string format_real(const Specification& s, const Value& value, double d) {
  std::string digits;
  switch (s.type) {
    case '\0':
      if (!s.precision) {
        digits = real_to_text(std::abs(d));
      } else {
        digits = format_magnitude(d, 'g', static_cast<int>(*s.precision), s.alternate);
        const bool is_whole = digits.find_first_of(".en") == std::string::npos;
        if (is_whole) digits += ".0";
      }
      break;
    case 'n':
      digits = format_magnitude(d, 'g', static_cast<int>(s.precision.value_or(6)), s.alternate);
      break;
    case 'e':
    case 'E':
    case 'f':
    case 'F':
    case 'g':
    case 'G':
      digits = format_magnitude(d, s.type, static_cast<int>(s.precision.value_or(6)), s.alternate);
      break;
    case '%':
      digits = format_magnitude(d * 100, 'f', static_cast<int>(s.precision.value_or(6)), s.alternate) + "%";
      break;
    default:
      fail_type(s.type, value);
  }
  if (s.grouping != '\0') digits = grouped(digits, s.grouping, 3);
  return laid_out_number(s, std::signbit(d) && !std::isnan(d), "", digits);
}

std::string format_integer(const Specification& s, const Value& value, const Integer& i) {
  const char type = s.type == '\0' || s.type == 'n' ? 'd' : s.type;
  if (std::string_view("eEfFgG%").find(type) != std::string_view::npos) return format_real(s, value, i.to_double());
  if (type == 'c') return pad(encode(static_cast<char32_t>(i.is_small() ? i.small() : 0xFFFD)), s.width, '<', s.fill);
  if (std::string_view("dxXob").find(type) == std::string_view::npos) fail_type(type, value);
  if (s.precision) fail_eval("Precision not allowed in integer format specifier");
  std::string digits = integer_digits(i, type);
  if (s.grouping != '\0') digits = grouped(digits, s.grouping, type == 'd' ? 3 : 4);
  const std::string lead = s.alternate && type != 'd' ? std::string("0") + type : "";
  return laid_out_number(s, i.is_negative(), lead, digits);
}

std::string format_text(const Specification& s, const Value& value, std::string text) {
  if (s.type != '\0' && s.type != 's') fail_type(s.type, value);
  if (s.align == '=') fail_eval("'=' alignment not allowed in string format specifier");
  if (s.precision && count_characters(text) > *s.precision) {
    const auto characters = split_characters(text);
    std::string cut;
    for (std::size_t i = 0; i < *s.precision; ++i) cut += characters[i];
    text = cut;
  }
  return pad(std::move(text), s.width, s.align == '\0' ? '<' : s.align, s.zero && s.fill == " " ? "0" : s.fill);
}

class BraceFormatter {
 public:
  BraceFormatter(Runtime& runtime, const CallArguments& arguments) : runtime_(runtime), arguments_(arguments) {}

  std::string run(std::string_view pattern, int depth = 0) {
    std::string out;
    for (std::size_t at = 0; at < pattern.size(); ++at) {
      const char c = pattern[at];
      const bool doubled = at + 1 < pattern.size() && pattern[at + 1] == c;
      if ((c == '{' || c == '}') && doubled && depth == 0) {
        out += c;
        ++at;
      } else if (c == '{') {
        const std::size_t end = closing(pattern, at);
        out += field(pattern.substr(at + 1, end - at - 1), depth);
        at = end;
      } else if (c == '}') {
        fail_eval("Single '}' encountered in format string");
      } else {
        out += c;
      }
      if (out.size() > kMaxText) fail_limit("the text is too long");
    }
    return out;
  }

 private:
  static std::size_t closing(std::string_view pattern, std::size_t open) {
    std::size_t depth = 0;
    for (std::size_t at = open; at < pattern.size(); ++at) {
      if (pattern[at] == '{') ++depth;
      if (pattern[at] == '}' && --depth == 0) return at;
    }
    fail_eval(open + 1 == pattern.size() ? "Single '{' encountered in format string"
                                         : "expected '}' before end of string");
  }

  std::string field(std::string_view text, int depth) {
    if (depth > 1) fail_eval("Max string recursion exceeded");
    const auto end = std::min(text.find_first_of("!:"), text.size());
    Value value = argument(text.substr(0, end));
    text.remove_prefix(end);
    if (text.starts_with('!')) {
      if (text.size() < 2) fail_eval("end of string while looking for conversion specifier");
      value = text[1] == 's' ? Value(to_text(runtime_, value)) : Value(to_source(runtime_, value));
      text.remove_prefix(2);
    }
    if (text.starts_with(':')) text.remove_prefix(1);
    std::string formatted = format_value(runtime_, value, run(text, depth + 1));
    runtime_.budget.spend(cost_of_bytes(formatted.size()));
    return formatted;
  }

  /// `0`, `name`, empty for the next one, followed by `.attribute` and `[key]`.
  Value argument(std::string_view text) {
    const auto end = std::min(text.find_first_of(".["), text.size());
    Value value = first(text.substr(0, end));
    text.remove_prefix(end);
    while (!text.empty()) {
      const bool is_key = text[0] == '[';
      const auto stop = is_key ? text.find(']') : std::min(text.find_first_of(".[", 1), text.size());
      if (stop == std::string_view::npos) fail_eval("Missing ']' in format string");
      const std::string_view name = text.substr(1, stop - 1);
      if (name.empty()) fail_eval("Empty attribute in format string");
      if (!is_key && name.starts_with("__")) fail_eval(fmt::format("Use of invalid name(s):  {}", name));
      value = is_key ? subscript(runtime_, value, key(name)) : attribute_of(runtime_, value, std::string(name));
      text.remove_prefix(stop + (is_key ? 1 : 0));
    }
    return value;
  }

  static Value key(std::string_view name) {
    const bool is_number = std::all_of(name.begin(), name.end(), is_digit);
    return is_number ? Value(*parse_integer(name)) : Value(name);
  }

  Value first(std::string_view name) {
    const bool is_number = !name.empty() && std::all_of(name.begin(), name.end(), is_digit);
    if (name.empty() || is_number) {
      const auto index = is_number ? parse_integer(name)->small() : static_cast<std::int64_t>(next_++);
      if (index < 0 || index >= static_cast<std::int64_t>(arguments_.positional.size())) {
        fail_eval(fmt::format("Replacement index {} out of range for positional args tuple", index));
      }
      return arguments_.positional[static_cast<std::size_t>(index)];
    }
    for (const auto& [given, value] : arguments_.named) {
      if (given == name) return value;
    }
    fail_eval(fmt::format("'{}'", name));
  }

  Runtime& runtime_;
  const CallArguments& arguments_;
  std::size_t next_ = 0;
};

}  // namespace

Value format_percent(Runtime& runtime, const std::string& pattern, const Value& arguments) {
  return PercentFormatter(runtime, pattern, arguments).run();
}

std::string format_braces(Runtime& runtime, const std::string& pattern, const CallArguments& arguments) {
  return BraceFormatter(runtime, arguments).run(pattern);
}

std::string format_value(Runtime& runtime, const Value& value, std::string_view specification) {
  if (specification.empty()) return to_text(runtime, value);
  runtime.budget.spend(cost_of_printing(value));
  const Specification s = parse_specification(specification, value);
  if (const double* d = as_real(value)) return format_real(s, value, *d);
  if (const auto i = as_integer(value)) return format_integer(s, value, *i);
  if (value.text() != nullptr) return format_text(s, value, *value.text());
  fail_eval(fmt::format("unsupported format string passed to {}.__format__", type_name(value)));
}

}  // namespace finemote::gen::expression
