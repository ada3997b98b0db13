// pattern.format(arguments).
#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/attribute.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/format.hpp"
#include "generator/expression/letters.hpp"
#include "generator/expression/number.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/subscript.hpp"

namespace finemote::gen::expression {
namespace {

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
      const Integer index = is_number ? *parse_integer(name) : Integer(static_cast<std::int64_t>(next_++));
      if (!index.is_small()) fail_eval("Too many decimal digits in format string");
      if (index.small() >= static_cast<std::int64_t>(arguments_.positional.size())) {
        fail_eval(fmt::format("Replacement index {} out of range for positional args tuple", index.small()));
      }
      return arguments_.positional[static_cast<std::size_t>(index.small())];
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

std::string format_braces(Runtime& runtime, const std::string& pattern, const CallArguments& arguments) {
  return BraceFormatter(runtime, arguments).run(pattern);
}

}  // namespace finemote::gen::expression
