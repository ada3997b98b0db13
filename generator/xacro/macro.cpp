#include "generator/xacro/macro.hpp"

#include <algorithm>

namespace finemote::gen::xacro {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";

bool is_blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

bool ends_at(std::string_view text, std::size_t at) { return at >= text.size() || is_blank(text[at]); }

/// Where a default that begins at each byte of a text may end: after it is a blank or the end of the text.
///
/// One pass from the end, so that no text takes more than time proportional to its length. A default stays in its line.
class DefaultEnds {
 public:
  explicit DefaultEnds(std::string_view text) : text_(text), at_(text.size() + 1) {
    std::size_t brace = kNone, parenthesis = kNone, quote = kNone, double_quote = kNone;
    at_[text.size()].words = text.size();
    for (std::size_t i = text.size(); i-- > 0;) {
      const char c = text[i];
      if (c == '\n') brace = parenthesis = quote = double_quote = kNone;
      at_[i] = {brace, parenthesis, words_end(i, c == '"' ? double_quote : quote)};
      if (c == '}' && ends_at(text, i + 1)) brace = i + 1;
      if (c == ')' && ends_at(text, i + 1)) parenthesis = i + 1;
      if (c == '\'' && at_[i + 1].words != kNone) quote = i + 1;
      if (c == '"' && at_[i + 1].words != kNone) double_quote = i + 1;
    }
  }

  /// End of the default that begins at `at`; nothing when there is none of a known form. Empty: at a blank or the end.
  [[nodiscard]] std::optional<std::size_t> find(std::size_t at) const {
    const std::string_view rest = text_.substr(at);
    if (rest.starts_with("${") && at_[at + 1].brace != kNone) return at_[at + 1].brace;
    if (rest.starts_with("$(") && at_[at + 1].parenthesis != kNone) return at_[at + 1].parenthesis;
    return at_[at].words != kNone ? std::optional(at_[at].words) : std::nullopt;
  }

 private:
  static constexpr std::size_t kNone = std::string_view::npos;

  struct Ends {
    std::size_t brace = kNone;        ///< of the nearest `}` further on
    std::size_t parenthesis = kNone;  ///< of the nearest `)`
    std::size_t words = kNone;        ///< of words and quoted texts in a row
  };

  [[nodiscard]] std::size_t words_end(std::size_t at, std::size_t behind_quoted) const {
    const char c = text_[at];
    if (is_blank(c)) return at;
    if (c != '\'' && c != '"') return at_[at + 1].words;
    return behind_quoted == kNone ? kNone : at_[behind_quoted].words;
  }

  std::string_view text_;
  std::vector<Ends> at_;
};

/// Cuts a text into parameters, from its start.
class ParameterCutter {
 public:
  explicit ParameterCutter(std::string_view text) : text_(text), ends_(text) {}

  std::vector<Parameter> run() {
    std::vector<Parameter> parameters;
    for (skip_blanks(at_); at_ < text_.size(); skip_blanks(at_)) {
      if (auto parameter = take_with_default()) {
        parameters.push_back(std::move(*parameter));
        continue;
      }
      const auto end = std::min(text_.find_first_of(kBlanks, at_), text_.size());
      parameters.push_back({std::string(text_.substr(at_, end - at_)), false, std::nullopt});
      at_ = end;
    }
    return parameters;
  }

 private:
  void skip_blanks(std::size_t& at) const { at = std::min(text_.find_first_not_of(kBlanks, at), text_.size()); }
  [[nodiscard]] bool is_at(std::size_t at, char c) const { return at < text_.size() && text_[at] == c; }

  /// A parameter with a default; nothing, and nothing taken, when the text does not go on with one.
  std::optional<Parameter> take_with_default() {
    const auto name_end = text_.find_first_of(":= \t\r\n\f\v", at_);
    if (name_end == at_ || name_end == std::string_view::npos) return std::nullopt;
    Parameter parameter{std::string(text_.substr(at_, name_end - at_)), false, std::nullopt};
    std::size_t at = name_end;
    skip_blanks(at);
    if (is_at(at, ':')) ++at;
    if (!is_at(at, '=')) return std::nullopt;
    const std::size_t after_sign = ++at;
    skip_blanks(at);
    if (is_at(at, '^')) {
      parameter.is_forwarded = true;
      at += is_at(at + 1, '|') ? 2 : 1;
    }
    // `a:= b` gives a the default b, as the pattern of ROS xacro does; `a:=` at the end gives the empty one.
    auto end = ends_.find(at);
    if (!end) {
      at = after_sign;
      parameter.is_forwarded = false;
      end = ends_.find(at);
    }
    if (!end) return std::nullopt;
    const std::string_view value = text_.substr(at, *end - at);
    if (!value.empty() || !parameter.is_forwarded) parameter.default_text = value;
    at_ = *end;
    return parameter;
  }

  std::string_view text_;
  DefaultEnds ends_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Parameter> parse_parameters(std::string_view text) { return ParameterCutter(text).run(); }

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
