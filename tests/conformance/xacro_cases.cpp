// Runs a folder of xacro cases (tests/xacro-cases/README.md): xacro_cases FOLDER, or xacro_cases --upstream for those
// of ROS xacro's own test-suite below $FINEMOTE_XACRO_CASES.
//
// Exit status: 0 all pass, 1 some fail, 77 the variable is not set (CTest calls that skipped).
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "generator/diagnostic/render.hpp"
#include "generator/xacro/expand_file.hpp"
#include "generator/xml/parse.hpp"
#include "tests/conformance/tree.hpp"
#include "tests/read.hpp"

namespace {

namespace fs = std::filesystem;
using finemote::gen::conformance::difference;
using finemote::gen::conformance::squeezed;
namespace xml = finemote::gen::xml;
namespace xacro = finemote::gen::xacro;
using Json = nlohmann::json;

constexpr int kSkipped = 77;

std::string with_case_mark(std::string text, const std::string& folder) {
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
    text.replace(at, folder.size(), "@CASE@");
  return text;
}

/// Sets variables as long as it lives.
class Environment {
 public:
  explicit Environment(const std::map<std::string, std::string>& variables) {
    for (const auto& [name, value] : variables) {
      names_.push_back(name);
      setenv(name.c_str(), value.c_str(), 1);
    }
  }
  ~Environment() {
    for (const std::string& name : names_) unsetenv(name.c_str());
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::vector<std::string> names_;
};

std::optional<xml::Document> parse(const std::string& text) {
  const finemote::gen::SourceFile file{"case", "case", text};
  auto result = xml::read_document(file);
  if (auto* document = std::get_if<xml::Document>(&result)) return std::move(*document);
  return std::nullopt;
}

std::string check_success(const fs::path& folder, const Json& facts, int status, const std::string& out,
                          const std::string& err) {
  if (status != 0) return "exit status " + std::to_string(status) + ": " + err;
  const auto expected = parse(finemote::test::read(folder / "expected.xml"));
  const auto given = parse(out);
  if (!expected || !given) return "the output is no XML";
  return difference(expected->root, given->root, facts.value("compare_comments", false));
}

/// The message of ROS xacro is part of ours; its interpreter's own words for endless recursion are not.
std::string check_failure(const fs::path& folder, int status, const std::string& out, const std::string& err) {
  if (status != 2) return "exit status " + std::to_string(status) + " where an error was expected";
  if (!out.empty()) return "an error, and output all the same";
  const std::string expected = finemote::test::read(folder / "expected_error.txt");
  const auto begin = expected.find("message: ");
  const auto end = expected.find("\n--- location");
  if (begin == std::string::npos || expected.find("class: RecursionError") == 0) return {};
  const std::string message = squeezed(expected.substr(begin + 9, end - begin - 9));
  return squeezed(err).find(message) != std::string::npos ? "" : "expected '" + message + "', got: " + err;
}

/// What is wrong with one case, or an empty text.
std::string run_case(const fs::path& folder) {
  const Json facts = Json::parse(finemote::test::read(folder / "args.json"));
  const Json given = facts.value("args", Json::object());
  xacro::Arguments arguments;
  for (const auto& [name, value] : given.items()) arguments[name] = value.get<std::string>();
  std::map<std::string, std::string> variables = facts.value("env", std::map<std::string, std::string>());
  const auto paths = facts.value("package_path", std::vector<std::string>());
  for (const std::string& path : paths) {
    variables["ROS_PACKAGE_PATH"] += (folder / path).string() + ":";
  }
  const Environment environment(variables);
  fs::current_path(folder);
  std::ostringstream messages;
  finemote::gen::Sources sources;
  finemote::gen::Diagnostics diagnostics;
  const auto expanded =
      xacro::expand_file(facts.value("entry", "input.xacro"), arguments, {}, sources, diagnostics, &messages);
  const int status = expanded ? 0 : 2;
  const std::string output = with_case_mark(expanded ? expanded->document : "", folder.string());
  const std::string report =
      with_case_mark(messages.str() + finemote::gen::render_text(diagnostics, false), folder.string());
  const bool is_error = fs::exists(folder / "expected_error.txt");
  return is_error ? check_failure(folder, status, output, report)
                  : check_success(folder, facts, status, output, report);
}

std::vector<fs::path> cases_in(const fs::path& folder, const std::string& origin) {
  std::vector<fs::path> cases;
  const Json index = Json::parse(finemote::test::read(folder / "index.json"));
  for (const Json& entry : index) {
    if (origin.empty() || entry["origin"] == origin) cases.push_back(folder / entry["name"].get<std::string>());
  }
  return cases;
}

}  // namespace

int main(int count, char** words) {
  const bool is_upstream = count > 1 && std::string(words[1]) == "--upstream";
  const char* const elsewhere = std::getenv("FINEMOTE_XACRO_CASES");
  if (is_upstream && elsewhere == nullptr) {
    std::cout << "SKIPPED: FINEMOTE_XACRO_CASES does not say where the cases of ROS xacro are\n";
    return kSkipped;
  }
  const std::string folder = is_upstream ? elsewhere : count > 1 ? words[1] : "";
  for (const char* name : {"ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"}) unsetenv(name);
  std::size_t failed = 0;
  const auto cases = cases_in(fs::canonical(folder), is_upstream ? "upstream" : "");
  for (const fs::path& one : cases) {
    const std::string wrong = run_case(one);
    if (wrong.empty()) continue;
    ++failed;
    std::cout << "FAIL " << one.filename().string() << ": " << wrong << '\n';
  }
  std::cout << cases.size() - failed << " of " << cases.size() << " cases pass\n";
  return failed == 0 && !cases.empty() ? 0 : 1;
}
