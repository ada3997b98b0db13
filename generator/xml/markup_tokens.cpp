#include "generator/xml/markup_tokens.hpp"

namespace finemote::gen {
namespace {

using Kind = MarkupToken::Kind;

/// Past `close`, searched from `from`; the end of the text when it is missing.
std::size_t past(std::string_view text, std::size_t from, std::string_view close) {
  const std::size_t at = text.find(close, from);
  return at == std::string_view::npos ? text.size() : at + close.size();
}

/// Past the `>` of the tag at `from`; quoted values may hold one.
std::size_t end_of_tag(std::string_view text, std::size_t from) {
  for (std::size_t at = from; at < text.size(); ++at) {
    if (text[at] == '>') return at + 1;
    if (text[at] == '"' || text[at] == '\'') at = past(text, at + 1, text.substr(at, 1)) - 1;
  }
  return text.size();
}

/// Past the `>` of a document type, which may hold declarations in brackets, comments and quoted values.
std::size_t end_of_doctype(std::string_view text, std::size_t from) {
  bool is_inside = false;  // the brackets
  for (std::size_t at = from + 2; at < text.size();) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = past(text, at, "-->");
    } else if (rest.starts_with("<?")) {
      at = past(text, at, "?>");
    } else if (rest.front() == '"' || rest.front() == '\'') {
      at = past(text, at + 1, rest.substr(0, 1));
    } else {
      if (rest.front() == '>' && !is_inside) return at + 1;
      if (rest.front() == '[' || rest.front() == ']') is_inside = rest.front() == '[';
      ++at;
    }
  }
  return text.size();
}

/// The attributes in the bytes of a tag after its name.
std::vector<MarkupAttribute> attributes_in(std::string_view rest) {
  std::vector<MarkupAttribute> attributes;
  for (std::size_t at = rest.find_first_not_of(kBlanks); at < rest.size() && rest[at] != '/' && rest[at] != '>';
       at = rest.find_first_not_of(kBlanks, at)) {
    const std::size_t end = rest.find_first_of(" \t\r\n=", at);
    const std::size_t quote = rest.find_first_of("\"'", end);
    const std::size_t close = rest.find(rest[quote], quote + 1);
    attributes.push_back({rest.substr(at, end - at), rest.substr(quote + 1, close - quote - 1)});
    at = close + 1;
  }
  return attributes;
}

MarkupToken tag(std::string_view bytes) {
  MarkupToken token{Kind::start, bytes, {}, {}};
  if (bytes.starts_with("</")) token.kind = Kind::end;
  if (bytes.ends_with("/>")) token.kind = Kind::empty;
  const std::size_t begin = token.kind == Kind::end ? 2 : 1;
  const std::size_t end = bytes.find_first_of(" \t\r\n/>", begin);
  token.name = bytes.substr(begin, end - begin);
  if (token.kind != Kind::end) token.attributes = attributes_in(bytes.substr(end));
  return token;
}

}  // namespace

MarkupToken markup_token_at(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  const auto token = [&](Kind kind, std::size_t end) { return MarkupToken{kind, text.substr(at, end - at), {}, {}}; };
  if (rest.front() != '<') return token(Kind::text, std::min(text.find('<', at), text.size()));
  if (rest.starts_with("<!--")) return token(Kind::comment, past(text, at, "-->"));
  if (rest.starts_with("<![CDATA[")) return token(Kind::other, past(text, at, "]]>"));
  if (rest.starts_with("<?")) return token(Kind::other, past(text, at, "?>"));
  if (rest.starts_with("<!")) return token(Kind::other, end_of_doctype(text, at));
  return tag(text.substr(at, end_of_tag(text, at) - at));
}

std::vector<MarkupToken> markup_tokens(std::string_view text) {
  std::vector<MarkupToken> tokens;
  for (std::size_t at = 0; at < text.size(); at += tokens.back().bytes.size())
    tokens.push_back(markup_token_at(text, at));
  return tokens;
}

}  // namespace finemote::gen
