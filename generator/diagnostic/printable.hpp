// Text of strangers to text for terminals, logs and comments.
#pragma once

#include <string>
#include <string_view>

namespace finemote::gen {

/// One line that is safe to print anywhere: `?` for control characters (line breaks and U+0080 to U+009F among them),
/// for characters that turn the direction of writing, and for bytes that are not UTF-8. Tabs stay. A `?` stands for
/// each byte, so that columns keep their places.
std::string printable(std::string_view text);

/// A text of several lines, each printable. All but the first begin with `  | `: a log reader that takes commands at
/// the start of a line, as GitHub does, finds none.
std::string printable_lines(std::string_view text);

}  // namespace finemote::gen
