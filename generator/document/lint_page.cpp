#include "generator/document/lint_page.hpp"

#include <fmt/format.h>

#include "generator/diagnostic/render.hpp"
#include "generator/document/markdown.hpp"
#include "generator/lint/rules.hpp"

namespace finemote::gen {

std::string lint_page() {
  std::string text = table({"code", "finding"});
  for (const Rule& rule : lint_rules_by_number())
    text += row({fmt::format("[{0}](../diagnostics/{0}.md)", code_name(rule.code)), std::string(rule.finding)});
  return text;
}

}  // namespace finemote::gen
