#include "generator/xacro/substitution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "generator/xacro/engine.hpp"

namespace finemote::gen::xacro {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kKnown = "['find', 'env', 'optenv', 'dirname', 'arg']";

Words words_of(const std::string& text) {
  Words words;
  std::size_t at = 0;
  constexpr const char* blanks = " \t\r\n\f\v";
  while ((at = text.find_first_not_of(blanks, at)) != std::string::npos) {
    const auto end = std::min(text.find_first_of(blanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

[[noreturn]] void fail_words(const std::string& message) { fail(code::xacro_substitution, message); }

std::string find_package(SubstitutionHost& host, const Words& words, const std::string& all) {
  if (words.size() != 2) fail_words(fmt::format("$(find pkg) accepts exactly one argument [{}]", all));
  return host.package_folder(words[1]);
}

std::string argument(SubstitutionHost& host, const Words& words, const std::string& all) {
  if (words.size() < 2) fail_words(fmt::format("$(arg var) must specify a variable name [{}]", all));
  if (words.size() > 2) fail_words(fmt::format("$(arg var) may only specify one arg [{}]", all));
  const std::string* value = host.argument(words[1]);
  if (value != nullptr) return *value;
  throw Failure{code::xacro_argument,
                "Undefined substitution argument " + words[1],
                {},
                {},
                {fmt::format("give {0}:=VALUE on the command line, or declare it before its use: "
                             "<xacro:arg name=\"{0}\" default=\"...\"/>",
                             words[1])}};
}

std::string environment_variable(SubstitutionHost& host, const Words& words, const std::string& all) {
  if (words.size() != 2) fail_words(fmt::format("$(env var) command only accepts one argument [{}]", all));
  if (host.hides_environment()) {
    throw Failure{code::xacro_environment,
                  fmt::format("environment variable '{}' is hidden by the sandbox", words[1]),
                  {},
                  {},
                  {fmt::format("$(optenv {} DEFAULT) gives the default here", words[1])}};
  }
  const auto value = host.environment(words[1]);
  if (!value) fail_words(fmt::format("environment variable '{}' is not set", words[1]));
  return *value;
}

std::string optional_variable(SubstitutionHost& host, const Words& words, const std::string& all) {
  if (words.size() < 2) fail_words(fmt::format("$(optenv var) must specify an environment variable [{}]", all));
  if (const auto value = host.environment(words[1])) return *value;
  return fmt::format("{}", fmt::join(words.begin() + 2, words.end(), " "));
}

/// What one command stands for; nothing when this pass does not resolve it.
std::optional<std::string> resolve(SubstitutionHost& host, const std::string& inside, bool only_find) {
  const Words words = words_of(inside);
  const std::string command = words.empty() ? "" : words[0];
  if (command == "find") return find_package(host, words, inside);
  const bool is_known = command == "env" || command == "optenv" || command == "dirname" || command == "arg";
  if (!is_known) {
    fail_words(fmt::format("Unknown substitution command [{}]. Valid commands are {}", inside, kKnown));
  }
  if (only_find) return std::nullopt;
  if (command == "arg") return argument(host, words, inside);
  if (command == "env") return environment_variable(host, words, inside);
  if (command == "optenv") return optional_variable(host, words, inside);
  fail_words("Cannot substitute $(dirname),no file/directory information available.");
}

/// Resolves what an argument's value delivered: its $(find ...) commands.
std::string resolve_found(SubstitutionHost& host, const std::string& text) {
  std::string out;
  std::size_t at = 0;
  for (auto open = text.find("$("); open != std::string::npos; open = text.find("$(", at)) {
    const auto close = text.find(')', open);
    if (close == std::string::npos) break;
    const std::string inside = text.substr(open + 2, close - open - 2);
    if (inside.find('$') != std::string::npos) {
      fail_words(fmt::format("Dollar signs \"$\" cannot be inside of substitution args [{}]", text));
    }
    if (inside.find('(') != std::string::npos) {
      fail_words(fmt::format("Invalid left parenthesis \"(\" in substitution args [{}]", text));
    }
    out += text.substr(at, open - at);
    const auto value = inside.empty() ? std::nullopt : resolve(host, inside, true);
    out += value ? *value : "$(" + inside + ")";
    at = close + 1;
  }
  return out + text.substr(at);
}

}  // namespace

std::string substitute(SubstitutionHost& host, const std::string& inside) {
  std::error_code ignored;
  if (inside == "cwd") return std::filesystem::current_path(ignored).string();
  if (inside.empty()) return "$()";
  if (inside.find('$') != std::string::npos) {
    fail_words(fmt::format("Dollar signs \"$\" cannot be inside of substitution args [$({})]", inside));
  }
  if (inside.find('(') != std::string::npos) {
    fail_words(fmt::format("Invalid left parenthesis \"(\" in substitution args [$({})]", inside));
  }
  return resolve_found(host, *resolve(host, inside, false));
}

}  // namespace finemote::gen::xacro
