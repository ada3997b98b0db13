#include "generator/xacro/macro.hpp"

#include <algorithm>

namespace finemote::gen::xacro {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";

bool is_blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

std::string_view without_leading_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(kBlanks), text.size()));
}

bool ends_at(std::string_view text, std::size_t at) { return at >= text.size() || is_blank(text[at]); }

/// Length of `${...}` or `$(...)` that a blank or the end follows, or 0.
std::size_t bracketed_length(std::string_view text, char open, char close) {
  if (!text.starts_with('$') || text.size() < 2 || text[1] != open) return 0;
  for (std::size_t at = 2; at < text.size() && text[at] != '\n'; ++at) {
    if (text[at] == close && ends_at(text, at + 1)) return at + 1;
  }
  return 0;
}

/// Length of words and quoted texts in a row that a blank or the end follows, or 0.
std::size_t concatenation_length(std::string_view text) {
  std::size_t at = 0;
  while (!ends_at(text, at)) {
    if (text[at] != '\'' && text[at] != '"') {
      ++at;
      continue;
    }
    const auto close = text.find(text[at], at + 1);
    const auto line_end = text.find('\n', at);
    if (close == std::string_view::npos || line_end < close) return 0;
    at = close + 1;
  }
  return at;
}

/// Length of the default at the start of a text; nothing when there is none of a known form.
std::optional<std::size_t> default_length(std::string_view text) {
  if (const std::size_t length = bracketed_length(text, '{', '}'); length > 0) return length;
  if (const std::size_t length = bracketed_length(text, '(', ')'); length > 0) return length;
  if (const std::size_t length = concatenation_length(text); length > 0) return length;
  return ends_at(text, 0) ? std::optional<std::size_t>(0) : std::nullopt;
}

/// A parameter with a default, and how long it is; nothing when the text does not begin with one.
struct Parsed {
  Parameter parameter;
  std::size_t length;
};

std::optional<Parsed> parse_with_default(std::string_view text) {
  const auto name_end = text.find_first_of(":= \t\r\n\f\v");
  if (name_end == 0 || name_end == std::string_view::npos) return std::nullopt;
  Parsed parsed{{std::string(text.substr(0, name_end)), false, std::nullopt}, 0};
  std::size_t at = name_end;
  while (at < text.size() && is_blank(text[at])) ++at;
  if (at < text.size() && text[at] == ':') ++at;
  if (at >= text.size() || text[at] != '=') return std::nullopt;
  ++at;

  const std::size_t after_sign = at;
  while (at < text.size() && is_blank(text[at])) ++at;
  if (at < text.size() && text[at] == '^') {
    parsed.parameter.is_forwarded = true;
    ++at;
    if (at < text.size() && text[at] == '|') ++at;
  }
  // `a:= b` gives a the default b, as the pattern of ROS xacro does; `a:=` at the end gives the empty one.
  auto length = default_length(text.substr(at));
  if (!length) {
    at = after_sign;
    length = default_length(text.substr(at));
    if (!length) return std::nullopt;
  }
  const std::string_view value = text.substr(at, *length);
  if (!value.empty() || !parsed.parameter.is_forwarded) parsed.parameter.default_text = value;
  parsed.length = at + *length;
  return parsed;
}

}  // namespace

std::vector<Parameter> parse_parameters(std::string_view text) {
  std::vector<Parameter> parameters;
  for (text = without_leading_blanks(text); !text.empty(); text = without_leading_blanks(text)) {
    if (auto parsed = parse_with_default(text)) {
      parameters.push_back(std::move(parsed->parameter));
      text.remove_prefix(parsed->length);
    } else {
      const auto end = std::min(text.find_first_of(kBlanks), text.size());
      parameters.push_back({std::string(text.substr(0, end)), false, std::nullopt});
      text.remove_prefix(end);
    }
  }
  return parameters;
}

void MacroScope::define(std::shared_ptr<const Macro> macro) {
  const std::string name = macro->name;
  entries_[name] = std::move(macro);
}

const MacroScope::Entry* MacroScope::find(std::string_view name) const {
  for (const MacroScope* scope = this; scope != nullptr; scope = scope->parent_) {
    const auto found = scope->entries_.find(name);
    if (found != scope->entries_.end()) return &found->second;
  }
  return fallback_ != nullptr ? fallback_->find(name) : nullptr;
}

std::vector<std::string> MacroScope::names() const {
  std::vector<std::string> names;
  for (const MacroScope* scope : {this, static_cast<const MacroScope*>(fallback_)}) {
    for (; scope != nullptr; scope = scope->parent_) {
      for (const auto& [name, entry] : scope->entries_) {
        if (std::holds_alternative<std::shared_ptr<const Macro>>(entry)) names.push_back(name);
      }
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::shared_ptr<const Macro> MacroScope::find_macro(std::string_view name) const {
  const Entry* entry = find(name);
  const auto* macro = entry != nullptr ? std::get_if<std::shared_ptr<const Macro>>(entry) : nullptr;
  return macro != nullptr ? *macro : nullptr;
}

MacroScope* MacroScope::find_namespace(std::string_view name) const {
  const Entry* entry = find(name);
  const auto* scope = entry != nullptr ? std::get_if<MacroScope*>(entry) : nullptr;
  return scope != nullptr ? *scope : nullptr;
}

}  // namespace finemote::gen::xacro
