#include "generator/file/wild_card.hpp"

#include <fnmatch.h>

#include <string>

#include "catch.hpp"

using finemote::gen::files::matches;

TEST_CASE("wild card: answers as fnmatch does") {
  const std::string patterns[] = {"*",     "?",    "a*",   "*a",      "*a*b", "a?c",   "[a-c]x", "[!a-c]x",
                                  "[]x]*", "[",    "a[",   "\\*",     "\\",   "*\\?*", ".*",     "[.]a",
                                  "?a",    "**",   "a**b", "*.xacro", "[a",   "a*b*c", "*[0-9]", "[[:digit:]]*",
                                  "",      "[^a]", "x[]",  "[!]]"};
  const std::string names[] = {"",   "a",  "b",  "ab", "abc", "aXbXc", ".a",      ".",      "*",
                               "?",  "[",  "]",  "x",  "bx",  "dx",    "a.xacro", ".xacro", "7",
                               "a7", "7a", "\\", "a[", "[a",  "x[]",   "a*b"};
  for (const std::string& pattern : patterns) {
    for (const std::string& name : names) {
      CAPTURE(pattern, name);
      CHECK(matches(pattern, name) == (fnmatch(pattern.c_str(), name.c_str(), FNM_PERIOD) == 0));
    }
  }
}

TEST_CASE("wild card: many '*' in a name are not tried in every combination") {
  std::string pattern;
  for (int i = 0; i < 100; ++i) pattern += "*a";
  CHECK(!matches(pattern + "b", std::string(250, 'a')));
  CHECK(matches(pattern, std::string(250, 'a')));
}
