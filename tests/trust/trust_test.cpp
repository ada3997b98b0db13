// docs/trust.md against the README: every word of a claim has a row, and what a row names exists. So do the tests that
// docs/timing.md names for the assumptions of the bounds.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <vector>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace fs = std::filesystem;
using finemote::test::read;

namespace {

const fs::path kRoot = finemote::test::source_dir();

/// Sections of the README that claim nothing: links, and terms.
const std::set<std::string> kWithoutClaims = {"Read on", "Licence"};
const std::set<std::string> kKinds = {"proof", "test", "emulator", "frames by others", "nothing yet"};

struct Row {
  std::string claim, kinds, which;
};

/// Text as a reader sees it: no marks of emphasis and code, links as their text, one space between words.
std::string plain(const std::string& markdown) {
  std::string text;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    const char c = markdown[i];
    if (c == '*' || c == '`' || c == '[') continue;
    if (c == ']') {
      const std::size_t end = i + 1 < markdown.size() && markdown[i + 1] == '(' ? markdown.find(')', i) : i;
      i = end == std::string::npos ? i : end;
      continue;
    }
    const bool space = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!space) text += c;
    if (space && !text.empty() && text.back() != ' ') text += ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(' ');
  return from == std::string::npos ? std::string() : text.substr(from, text.find_last_not_of(' ') - from + 1);
}

/// The sentences of the README, without headings, code, tables and sections without claims.
std::string claims_of(const std::string& readme) {
  std::istringstream lines(readme);
  std::string text;
  bool code = false, claims = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("```", 0) == 0) code = !code;
    if (line.rfind("## ", 0) == 0) claims = kWithoutClaims.count(line.substr(3)) == 0;
    if (code || !claims || line.rfind("```", 0) == 0 || line.rfind('#', 0) == 0 || line.rfind('|', 0) == 0) continue;
    text += (line.rfind("- ", 0) == 0 ? line.substr(2) : line) + '\n';
  }
  return plain(text);
}

/// Tables with three columns.
std::vector<Row> rows_of(const std::string& page) {
  std::istringstream lines(page);
  std::vector<Row> rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| the README says", 0) == 0) continue;
    std::vector<std::string> cells;
    std::istringstream rest(line.substr(1));
    for (std::string cell; std::getline(rest, cell, '|');) cells.push_back(trimmed(cell));
    if (cells.size() == 3) rows.push_back({plain(cells[0]), cells[1], cells[2]});
  }
  return rows;
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t to; (to = text.find(separator, from)) != std::string::npos; from = to + separator.size())
    parts.push_back(text.substr(from, to - from));
  parts.push_back(text.substr(from));
  return parts;
}

/// What stands between the marks of code: names of tests, or files from the root.
std::vector<std::string> names_in(const std::string& cell) {
  std::vector<std::string> names;
  const std::vector<std::string> parts = split(cell, "`");
  for (std::size_t i = 1; i < parts.size(); i += 2) names.push_back(parts[i]);
  return names;
}

std::vector<std::string> links_in(const std::string& cell) {
  std::vector<std::string> links;
  for (const std::string& part : split(cell, "](")) links.push_back(part.substr(0, part.find(')')));
  links.erase(links.begin());
  return links;
}

const std::set<std::string>& tests() {
  static const std::set<std::string> kNames = [] {
    std::istringstream lines(read(FINEMOTE_TEST_NAMES));
    std::set<std::string> names;
    for (std::string line; std::getline(lines, line);) names.insert(line);
    return names;
  }();
  return kNames;
}

std::vector<Row> rows() { return rows_of(read(kRoot / "docs/trust.md")); }

/// The numbered items of a section.
std::vector<std::string> items_of(const std::string& page, const std::string& heading) {
  const std::size_t begin = page.find("\n## " + heading + "\n");
  REQUIRE(begin != std::string::npos);
  std::istringstream lines(page.substr(begin, page.find("\n## ", begin + 1) - begin));
  std::vector<std::string> items;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t digits = line.find_first_not_of("0123456789");
    if (digits != 0 && digits != std::string::npos && line.compare(digits, 2, ". ") == 0) items.emplace_back();
    if (!items.empty()) items.back() += line + " ";
  }
  return items;
}

/// At its end, in brackets: names of tests, or why there are none. @return whether that is so, and they exist
bool says_its_tests(const std::string& item) {
  const std::size_t begin = item.rfind('('), end = item.find_last_not_of(' ');
  if (begin == std::string::npos || item[end] != ')') return false;
  const std::string inside = item.substr(begin + 1, end - begin - 1);
  if (inside.rfind("no test: ", 0) == 0) return inside.size() > 10;
  const std::vector<std::string> names = names_in(inside);
  return !names.empty() && std::all_of(names.begin(), names.end(), [](const auto& it) { return tests().count(it); });
}

}  // namespace

TEST_CASE("every claim of the README has a row, and every row a claim") {
  const std::string claims = claims_of(read(kRoot / "README.md"));
  std::vector<bool> covered(claims.size());
  for (const Row& row : rows()) {
    INFO(row.claim);
    const std::size_t at = claims.find(row.claim);
    REQUIRE(at != std::string::npos);
    std::fill_n(covered.begin() + static_cast<std::ptrdiff_t>(at), row.claim.size(), true);
  }
  std::string uncovered;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (!covered[i]) uncovered += claims[i];
  }
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  INFO("without a row: " << uncovered);
  CHECK(std::none_of(uncovered.begin(), uncovered.end(), is_letter));
}

TEST_CASE("what stands behind a claim is of a known kind, and exists") {
  REQUIRE(rows().size() > 20);
  for (const Row& row : rows()) {
    INFO(row.claim);
    for (const std::string& kind : split(row.kinds, ", ")) CHECK(kKinds.count(kind) == 1);
    const std::vector<std::string> names = names_in(row.which), links = links_in(row.which);
    CHECK((row.kinds == "nothing yet" || !names.empty() || !links.empty()));
    for (const std::string& name : names) {
      INFO(name);
      CHECK((tests().count(name) == 1 || fs::exists(kRoot / name)));
    }
    for (const std::string& link : links) {
      INFO(link);
      CHECK(fs::exists(kRoot / "docs" / link.substr(0, link.find('#'))));
    }
  }
}

TEST_CASE("a claim without a row, and a test that is gone, are found") {
  CHECK(claims_of("# T\n\nIt **flies** to the [moon](a.md).\n\n## Licence\n\nFree.\n") == "It flies to the moon.");
  const std::vector<Row> parsed =
      rows_of("| the README says | b | w |\n|---|---|---|\n| It `flies` | test | `a_test`, [b](b.md#c) |\n");
  REQUIRE(parsed.size() == 1);
  CHECK(parsed[0].claim == "It flies");
  CHECK(names_in(parsed[0].which) == std::vector<std::string>{"a_test"});
  CHECK(links_in(parsed[0].which) == std::vector<std::string>{"b.md#c"});
  CHECK(tests().count("trust_test") == 1);
  CHECK(tests().count("a_test") == 0);
}

TEST_CASE("every assumption of the bounds names tests that exist, or says why it has none") {
  const std::vector<std::string> items = items_of(read(kRoot / "docs/timing.md"), "Assumptions");
  CHECK(items.size() >= 20);
  for (const std::string& item : items) {
    INFO(item);
    CHECK(says_its_tests(item));
  }
}

TEST_CASE("an assumption without a test, or with one that is gone, is found") {
  const auto items = items_of("# T\n\n## A\n\n1. **b** (c): d.\n   (`trust_test`)\n12. e (f)\n\n## G\n\n1. h\n", "A");
  REQUIRE(items.size() == 2);
  CHECK(says_its_tests(items[0]));
  CHECK_FALSE(says_its_tests(items[1]));
  CHECK_FALSE(says_its_tests("1. d. (`trust_test`, `a_test`)"));
  CHECK_FALSE(says_its_tests("1. d. (`trust_test`) e."));
  CHECK_FALSE(says_its_tests("1. d."));
  CHECK_FALSE(says_its_tests("1. d. (no test: )"));
  CHECK(says_its_tests("1. d. (no test: nothing stands for it)"));
}
