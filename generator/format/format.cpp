#include "generator/format/format.hpp"

#include <algorithm>

#include "generator/model/grammar.hpp"
#include "generator/xml/markup_tokens.hpp"

namespace finemote::gen {
namespace {

using Kind = MarkupToken::Kind;
using Tokens = std::vector<MarkupToken>;

constexpr std::size_t kColumns = 120;

bool is_blank(std::string_view text) { return text.find_first_not_of(kBlanks) == std::string_view::npos; }

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

/// The index of the end tag that belongs to the start tag at `start`.
std::size_t end_of(const Tokens& tokens, std::size_t start) {
  std::size_t depth = 0;
  for (std::size_t i = start; i < tokens.size(); ++i) {
    if (tokens[i].kind == Kind::start) ++depth;
    if (tokens[i].kind == Kind::end && --depth == 0) return i;
  }
  return tokens.size() - 1;
}

/// Attributes in the order of the grammar, then those it does not know, as they come.
std::vector<MarkupAttribute> ordered(const MarkupToken& tag) {
  std::vector<MarkupAttribute> attributes = tag.attributes;
  const grammar::ElementRule* rule = grammar::rule(tag.name);
  if (rule == nullptr) return attributes;
  const auto place = [&](const MarkupAttribute& attribute) {
    return std::find_if(rule->attributes.begin(), rule->attributes.end(),
                        [&](const grammar::AttributeRule& known) { return known.name == attribute.name; });
  };
  std::stable_sort(attributes.begin(), attributes.end(),
                   [&](const MarkupAttribute& a, const MarkupAttribute& b) { return place(a) < place(b); });
  return attributes;
}

/// Writes one <finemote> element with all that is in it.
class Layout {
 public:
  /// @param margin  the blanks before the element's first line
  Layout(const Tokens& tokens, std::string margin, std::string_view line_break)
      : tokens_(tokens), margin_(std::move(margin)), line_break_(line_break) {}

  std::string run(std::size_t first) {
    element(first, 0);
    return std::move(text_);
  }

 private:
  /// The element at `first`, from where the line stands; returns the index after it.
  std::size_t element(std::size_t first, std::size_t depth) {
    const std::size_t last = tokens_[first].kind == Kind::empty ? first : end_of(tokens_, first);
    if (is_empty(first, last)) {
      tag(tokens_[first], depth, "/>");
    } else if (has_text(first, last)) {
      tag(tokens_[first], depth, ">");
      words(first, last);
      end_tag(last);
    } else {
      tag(tokens_[first], depth, ">");
      children(first, last, depth + 1);
      new_line(depth);
      end_tag(last);
    }
    return last + 1;
  }

  /// What is between the tags, a line each; comments that stood after something stay after it.
  void children(std::size_t first, std::size_t last, std::size_t depth) {
    std::size_t breaks = 0;
    bool is_first = true;
    for (std::size_t i = first + 1; i < last;) {
      const MarkupToken& token = tokens_[i];
      if (token.kind == Kind::text) {
        breaks += static_cast<std::size_t>(std::count(token.bytes.begin(), token.bytes.end(), '\n'));
        ++i;
        continue;
      }
      if (token.kind == Kind::comment && breaks == 0) {
        text_ += "  " + std::string(token.bytes);
        ++i;
      } else {
        if (breaks > 1 && !is_first) text_ += line_break_;
        new_line(depth);
        i = piece(i, depth);
      }
      is_first = false;
      breaks = 0;
    }
  }

  std::size_t piece(std::size_t i, std::size_t depth) {
    if (tokens_[i].kind == Kind::start || tokens_[i].kind == Kind::empty) return element(i, depth);
    text_ += tokens_[i].bytes;
    return i + 1;
  }

  /// Text as it is; of a param without the blanks around it, which mean nothing.
  void words(std::size_t first, std::size_t last) {
    if (tokens_[first].name == "param" && last == first + 2) {
      text_ += trimmed(tokens_[first + 1].bytes);
      return;
    }
    for (std::size_t i = first + 1; i < last; ++i) text_ += tokens_[i].bytes;
  }

  void tag(const MarkupToken& token, std::size_t depth, const char* end) {
    text_ += '<';
    text_ += token.name;
    const std::size_t indent = margin_.size() + 2 * depth + token.name.size() + 2;
    std::size_t column = indent - 1;
    for (const MarkupAttribute& attribute : ordered(token)) {
      const char quote = attribute.value.find('"') == std::string_view::npos ? '"' : '\'';
      const std::string word = std::string(attribute.name) + "=" + quote + std::string(attribute.value) + quote;
      const bool fits = column + 1 + word.size() + 2 <= kColumns || column + 1 == indent;
      if (fits) {
        text_ += ' ';
        column += 1 + word.size();
      } else {
        text_ += line_break_;
        text_ += margin_ + std::string(indent - margin_.size(), ' ');
        column = indent + word.size();
      }
      text_ += word;
    }
    text_ += end;
  }

  void end_tag(std::size_t last) { text_ += "</" + std::string(tokens_[last].name) + ">"; }

  void new_line(std::size_t depth) {
    text_ += line_break_;
    text_ += margin_ + std::string(2 * depth, ' ');
  }

  [[nodiscard]] bool is_empty(std::size_t first, std::size_t last) const {
    return std::all_of(tokens_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                       tokens_.begin() + static_cast<std::ptrdiff_t>(std::max(first + 1, last)),
                       [](const MarkupToken& token) { return token.kind == Kind::text && is_blank(token.bytes); });
  }

  /// Whether text that is not blank, or CDATA, stands directly in the element.
  [[nodiscard]] bool has_text(std::size_t first, std::size_t last) const {
    std::size_t depth = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const MarkupToken& token = tokens_[i];
      if (token.kind == Kind::end) --depth;
      const bool is_words = token.kind == Kind::text && !is_blank(token.bytes);
      if (depth == 0 && (is_words || token.bytes.starts_with("<![CDATA["))) return true;
      if (token.kind == Kind::start) ++depth;
    }
    return false;
  }

  const Tokens& tokens_;
  std::string margin_;
  std::string_view line_break_;
  std::string text_;
};

/// The blanks between the beginning of the last line of `text` and its end; none where something else stands there.
std::string margin_at(const std::string& text) {
  const std::string line = text.substr(text.rfind('\n') + 1);
  return is_blank(line) ? line : std::string();
}

}  // namespace

std::string formatted(std::string_view text) {
  const Tokens tokens = markup_tokens(text);
  const std::size_t first_break = text.find('\n');
  const bool has_returns = first_break != std::string_view::npos && first_break > 0 && text[first_break - 1] == '\r';
  std::string result;
  for (std::size_t i = 0; i < tokens.size();) {
    const MarkupToken& token = tokens[i];
    const bool is_tag = token.kind == Kind::start || token.kind == Kind::empty;
    if (is_tag && token.name == "finemote") {
      result += Layout(tokens, margin_at(result), has_returns ? "\r\n" : "\n").run(i);
      i = token.kind == Kind::empty ? i + 1 : end_of(tokens, i) + 1;
    } else {
      result += token.bytes;
      ++i;
    }
  }
  return result;
}

}  // namespace finemote::gen
