// Who spells generated code: templates/ its lines, generator/emit the values in them.
#include <algorithm>
#include <filesystem>
#include <set>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"
#include "tests/structure/tokens.hpp"

namespace fs = std::filesystem;
using namespace finemote::test;

namespace {

const fs::path kRoot = finemote::test::source_dir();

/// What no text in emit holds: ends of statements, comments, braces of C++ (which fmt writes twice), calls, indents,
/// words that declarations begin with. Templates and layout have braces and comments of their own to speak of.
constexpr std::string_view kShapes[] = {";",      "//",       "/*",        "{{",           "}}",
                                        "()",     "\\n",      "  ",        "FINEMOTE_",    "constexpr",
                                        "inline", "#include", "namespace", "static_assert"};

/// Files whose texts are no lines.
struct Exception {
  std::string_view file;
  std::string_view reason;
};
constexpr Exception kExceptions[] = {
    {"value.cpp", "values whose literal does not say their type: `std::int64_t{400000}`"},
    {"template.cpp", "reads templates: begins and ends of tags"},
    {"layout.cpp", "breaks and ends the lines of any template"},
};

struct Finding {
  std::string file, literal;
  std::string_view shape;
  int line;
};

std::vector<Finding> shapes_in_emit() {
  std::vector<Finding> findings;
  for (const auto& entry : fs::directory_iterator(kRoot / "generator/emit")) {
    if (entry.path().extension() != ".cpp") continue;
    for (const Token& token : tokens_of(read(entry.path()))) {
      for (const std::string_view shape : kShapes) {
        if (token.text == "\"\"" && token.literal.find(shape) != std::string::npos)
          findings.push_back({entry.path().filename().string(), token.literal, shape, token.line});
      }
    }
  }
  return findings;
}

bool excepts(const Exception& entry, const Finding& finding) { return entry.file == finding.file; }

/// `stage` for every `{{>stage}}` of the templates that output files are made from, and of those it names.
std::set<std::string> named_parts() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(kRoot / "templates")) {
    if (entry.path().extension() != ".mustache") continue;
    const std::string text = read(entry.path());
    for (std::size_t at = text.find("{{>"); at != std::string::npos; at = text.find("{{>", at + 1))
      names.insert(text.substr(at + 3, text.find("}}", at) - at - 3));
  }
  return names;
}

}  // namespace

TEST_CASE("emit supplies fields, and spells no line of generated code") {
  const std::vector<Finding> findings = shapes_in_emit();
  for (const Finding& finding : findings) {
    const auto holds = [&](const Exception& entry) { return excepts(entry, finding); };
    if (std::any_of(std::begin(kExceptions), std::end(kExceptions), holds)) continue;
    FAIL_CHECK("generator/emit/" << finding.file << ":" << finding.line << ": \"" << finding.literal << "\" has '"
                                 << finding.shape << "': a template spells that");
  }
  for (const Exception& entry : kExceptions) {
    const auto is_it = [&](const Finding& finding) { return excepts(entry, finding); };
    if (std::none_of(findings.begin(), findings.end(), is_it)) FAIL_CHECK(entry.file << " needs no exception any more");
  }
}

TEST_CASE("every template and folder is in the list of templates, and every part is named by one") {
  const std::string list = read(kRoot / "templates/README.md");
  const std::set<std::string> parts = named_parts();
  for (const auto& entry : fs::directory_iterator(kRoot / "templates")) {
    const std::string name = entry.path().stem().string();
    INFO(name);
    if (entry.is_directory()) CHECK(list.find("`" + name + "/`") != std::string::npos);
    if (entry.path().extension() != ".mustache") continue;
    const bool is_part = fs::path(name).extension().empty();
    CHECK(list.find("`" + name + (is_part ? "`" : ".mustache`")) != std::string::npos);
    if (is_part) CHECK(parts.count(name) == 1);
  }
}
