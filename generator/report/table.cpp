#include "generator/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/svg/svg.hpp"

namespace finemote::gen::report {

std::string table_of(const std::string& id, const std::string& caption, const std::vector<Column>& columns,
                     const std::string& rows) {
  std::string head;
  for (const Column& column : columns)
    head += fmt::format("<th scope=\"col\"{}>{}</th>", column.is_number ? " class=\"number\"" : "", column.title);
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{1}\"><table id=\"{0}\">\n"
      "<caption>{1}</caption>\n<thead><tr>{2}</tr></thead>\n<tbody>\n{3}</tbody></table></div>\n",
      id, svg::escaped(caption), head, rows);
}

std::string word(const std::string& text) { return "<td class=\"word\">" + svg::escaped(text) + "</td>"; }

std::string row_title(const std::string& text) { return "<th scope=\"row\">" + svg::escaped(text) + "</th>"; }

std::string share_bar(double share) {
  if (share <= 0) return "<td class=\"meter\" aria-hidden=\"true\"></td>";
  return fmt::format("<td class=\"meter\" aria-hidden=\"true\"><i style=\"width:{:.2f}%\"></i></td>",
                     100 * std::clamp(share, 0.0, 1.0));
}

}  // namespace finemote::gen::report
