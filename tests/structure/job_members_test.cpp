// The comment on the documents between `finemote run` and the emulator names every member they have.
#include <filesystem>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"
#include "tests/structure/tokens.hpp"

namespace fs = std::filesystem;
using namespace finemote::test;

namespace {

using Names = std::set<std::string>;

const fs::path kProgram = fs::path(finemote::test::source_dir()) / "emulator/program";

/// Keys that are read, as `at("key")`, or written, as `{"key", ...}`.
Names keys_in(const std::string& text) {
  static const Names kReading = {"at", "value", "contains", "erase"};
  const std::vector<Token> tokens = tokens_of(text);
  Names keys;
  for (std::size_t i = 2; i + 1 < tokens.size(); ++i) {
    if (tokens[i].text != "\"\"") continue;
    const bool is_read = tokens[i - 1].text == "(" && kReading.count(tokens[i - 2].text) == 1;
    const bool is_written = tokens[i - 1].text == "{" && tokens[i + 1].text == ",";
    if (is_read || is_written) keys.insert(tokens[i].literal);
  }
  return keys;
}

/// What stands between `` ` `` and `` ` `` in a text.
Names quoted_in(const std::string& text) {
  Names names;
  for (std::size_t begin = text.find('`'); begin != std::string::npos;) {
    const std::size_t end = text.find('`', begin + 1);
    if (end == std::string::npos) break;
    names.insert(text.substr(begin + 1, end - begin - 1));
    begin = text.find('`', end + 1);
  }
  return names;
}

/// Those that begin a line of a list.
Names members_in(const std::string& text) {
  std::istringstream lines(text);
  Names names;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find('`');
    const std::string before = line.substr(0, begin);
    if (before == "// - " || before == "// - [")
      names.insert(line.substr(begin + 1, line.find('`', begin + 1) - begin - 1));
  }
  return names;
}

}  // namespace

TEST_CASE("keys are read as they are used") {
  CHECK(keys_in(R"(f(job.at("a"), job.value("b", "c") == "d"); return {{"e", 1}, {"f", g("h")}};)") ==
        Names{"a", "b", "e", "f"});
}

TEST_CASE("the members of a job and of its record stand in the header, one a line, and no others") {
  const Names keys = keys_in(read(kProgram / "job.cpp"));
  const std::string header = read(kProgram / "job.hpp");
  const Names named = quoted_in(header), members = members_in(header);
  REQUIRE(keys.size() > 50);
  REQUIRE(members.size() > 30);
  for (const std::string& key : keys)
    if (named.count(key) == 0) FAIL_CHECK("emulator/program/job.hpp does not name `" << key << "`, which job.cpp uses");
  for (const std::string& member : members)
    if (keys.count(member) == 0) FAIL_CHECK("job.cpp does not use `" << member << "`, which its header names");
}
