// Rows to a table of a page.
#pragma once

#include <string>
#include <vector>

namespace finemote::gen::report {

struct Column {
  const char* title;
  bool is_number = false;
};

/// `<table>` with a heading and these rows, in a box that scrolls where the screen is narrow. Rows are elements `<tr>`.
std::string table_of(const std::string& id, const std::string& caption, const std::vector<Column>& columns,
                     const std::string& rows);

/// `<td>` with this text, escaped.
std::string word(const std::string& text);

/// `<th scope="row">`
std::string row_title(const std::string& text);

/// A bar of `share` (0..1) of the width, drawn beside its value.
std::string share_bar(double share);

}  // namespace finemote::gen::report
