#include "tests/evidence/page.hpp"

#include <map>
#include <set>
#include <stdexcept>

#include "tests/evidence/explanations.hpp"

namespace finemote::evidence {
namespace {

struct Row {
  std::set<std::string> commits, licences, origins, explanations;
  unsigned vectors = 0, agree = 0;
  bool has_decoder = true;
};

std::string joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    if (!word.empty()) text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string agreement(const Row& row) {
  if (!row.has_decoder) return "no device type yet";
  std::string text = row.agree == row.vectors ? "all" : std::to_string(row.agree);
  if (!row.explanations.empty()) text += ", else `" + joined(row.explanations) + "`";
  return text;
}

}  // namespace

std::string table_of_sources(const std::vector<Vector>& vectors) {
  std::map<std::pair<std::string, std::string>, Row> rows;
  for (const Vector& vector : vectors) {
    Row& row = rows[{vector.protocol, vector.source}];
    const Judgement judgement = judge(vector);
    ++row.vectors;
    row.agree += judgement.verdict == Verdict::agree ? 1 : 0;
    row.has_decoder = judgement.verdict != Verdict::no_decoder;
    row.commits.insert(vector.commit);
    row.licences.insert(vector.licence);
    row.origins.insert(vector.origin);
    if (judgement.verdict == Verdict::explained) row.explanations.insert(judgement.explanation);
  }
  std::string text =
      "| protocol | source | commit | licence | origin | vectors | agree |\n|---|---|---|---|---|---|---|\n";
  for (const auto& [key, row] : rows) {
    text += "| " + key.first + " | " + key.second + " | " + joined(row.commits) + " | " + joined(row.licences) + " | " +
            joined(row.origins) + " | " + std::to_string(row.vectors) + " | " + agreement(row) + " |\n";
  }
  return text;
}

std::string table_of_explanations() {
  std::string text = "| name | protocol | what differs | who else says so |\n|---|---|---|---|\n";
  for (const Explanation& it : explanations())
    text += std::string("| `") + it.name + "` | " + it.protocols + " | " + it.differs + " | " + it.third + " |\n";
  return text;
}

std::string with_table(const std::string& page, const std::string& name, const std::string& table) {
  const std::string begin = "<!-- " + name + " -->\n", end = "<!-- end of " + name + " -->\n";
  const std::size_t from = page.find(begin), to = page.find(end);
  if (from == std::string::npos || to == std::string::npos || to < from)
    throw std::runtime_error("no place for the table of " + name);
  return page.substr(0, from + begin.size()) + table + page.substr(to);
}

}  // namespace finemote::evidence
