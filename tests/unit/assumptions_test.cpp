// The list of assumptions in docs/timing.md is the one in the code, item by item.
#include "generator/timing/assumptions.hpp"

#include <regex>
#include <set>

#include "catch.hpp"
#include "emulator/scenario/grammar.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace scenario = finemote::scenario;
using namespace finemote::gen::timing;

namespace {

struct Item {
  std::string number, id, detected, text;
};

std::string on_one_line(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), " "); }

/// `1. **id** (detected): text.` at the start of every item of the page's section.
std::vector<Item> items_of_page() {
  const std::string page = finemote::test::read(finemote::test::source_dir() + "/docs/timing.md");
  const std::size_t begin = page.find("\n## Assumptions\n");
  REQUIRE(begin != std::string::npos);
  const std::string section = page.substr(begin, page.find("\n## ", begin + 1) - begin);
  const std::regex item(
      R"re(\n(\d+)\. \*\*([a-z-]+)\*\* \((counted|stopped|undetectable)\): ([^.]*(?:\.[^ \n][^.]*)*)\.[ \n])re");
  std::vector<Item> items;
  for (std::sregex_iterator found(section.begin(), section.end(), item), end; found != end; ++found)
    items.push_back({(*found)[1], (*found)[2], (*found)[3], on_one_line((*found)[4])});
  return items;
}

}  // namespace

TEST_CASE("every assumption is on the page, in order, with its words and how it is detected") {
  const std::vector<Item> items = items_of_page();
  REQUIRE(items.size() == assumptions().size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Assumption& assumption = assumptions()[i];
    CHECK(items[i].number == std::to_string(i + 1));
    CHECK(items[i].id == assumption.id);
    CHECK(items[i].detected == to_string(assumption.detected));
    CHECK(items[i].text == assumption.text);
  }
}

TEST_CASE("what a fault of a scenario violates is an assumption") {
  std::set<std::string_view> ids{""};
  for (const Assumption& assumption : assumptions()) ids.insert(assumption.id);
  for (const scenario::Target& target : scenario::targets()) {
    for (const scenario::Verb& verb : *target.verbs) {
      INFO(target.title << " " << verb.name << " violates " << verb.violates);
      CHECK(ids.contains(verb.violates));
    }
  }
}

TEST_CASE("ids are words that name one assumption each") {
  std::set<std::string_view> ids;
  for (const Assumption& assumption : assumptions()) {
    CHECK(std::regex_match(std::string(assumption.id), std::regex("[a-z]+(-[a-z]+)*")));
    CHECK(ids.insert(assumption.id).second);
  }
}
