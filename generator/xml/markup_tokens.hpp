// The text of an XML document to its tokens, each with its bytes as they were written.
#pragma once

#include <string_view>
#include <vector>

namespace finemote::gen {

inline constexpr std::string_view kBlanks = " \t\r\n";  ///< white space of XML

struct MarkupAttribute {
  std::string_view name;
  std::string_view value;  ///< without the quotes, with its entities
};

struct MarkupToken {
  enum class Kind {
    start,    ///< `<device name="imu">`
    empty,    ///< `<wcet update="5us"/>`
    end,      ///< `</device>`
    comment,  ///< `<!-- ... -->`
    text,     ///< what stands between tags, blanks too
    other,    ///< instructions, CDATA, a document type
  };
  Kind kind = Kind::text;
  std::string_view bytes;                   ///< all of it
  std::string_view name;                    ///< of tags
  std::vector<MarkupAttribute> attributes;  ///< of Kind::start and Kind::empty
};

/// The token that starts at `at` < text.size(), of well-formed XML; it points into `text`.
MarkupToken markup_token_at(std::string_view text, std::size_t at);

/// @param text  well-formed XML; the tokens point into it, and are all of it.
std::vector<MarkupToken> markup_tokens(std::string_view text);

}  // namespace finemote::gen
