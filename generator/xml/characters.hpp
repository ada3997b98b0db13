// What may stand in an XML document, and where.
#pragma once

#include <string_view>

namespace finemote::gen::xml {

/// Whether a text can be the name of an element or attribute. Of letters beyond ASCII all are taken.
/// Source: XML 1.0, 2.3 (Name).
bool is_name(std::string_view text);

/// Whether all characters of a text may stand in a document, be it as references. Source: XML 1.0, 2.2 (Char).
bool are_characters(std::string_view text);

/// Whether a text can be that of a comment. Source: XML 1.0, 2.5.
bool is_comment_text(std::string_view text);

}  // namespace finemote::gen::xml
