// Names of unnamed namespaces differ among the files of a module, so that they can be compiled as one: `./dev demo`
// does. A type that headers define is the only one of its name in its namespace, whichever of them are read together.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"
#include "tests/structure/tokens.hpp"

namespace fs = std::filesystem;
using namespace finemote::test;

namespace {

using Tokens = std::vector<Token>;

/// What a declaration introduces: a name and, of a function, what makes it another than one of that name.
struct LocalName {
  std::string name, parameters;
  std::string stands_for{};  ///< of an alias, which may be declared again; else empty

  bool operator<(const LocalName& other) const {
    return std::tie(name, parameters) < std::tie(other.name, other.parameters);
  }
};

bool is_word(const Token& token) {
  return std::isalpha(static_cast<unsigned char>(token.text[0])) != 0 || token.text[0] == '_';
}

bool opens(const Token& token) { return token.text == "(" || token.text == "[" || token.text == "{"; }
bool closes(const Token& token) { return token.text == ")" || token.text == "]" || token.text == "}"; }

/// After the bracket that closes the one at `at`.
std::size_t behind_group(const Tokens& tokens, std::size_t at) {
  int depth = 0;
  do {
    depth += opens(tokens[at]) ? 1 : closes(tokens[at]) ? -1 : 0;
    ++at;
  } while (depth > 0 && at < tokens.size());
  return at;
}

/// After the template arguments that begin at `at`; `at` where none do.
std::size_t behind_angles(const Tokens& tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].text != "<") return at;
  int depth = 0;
  do {
    depth += tokens[at].text == "<" ? 1 : tokens[at].text == ">" ? -1 : 0;
    ++at;
  } while (depth > 0 && at < tokens.size());
  return at;
}

/// The parameters without their names, for those that have one.
std::string parameter_types(const Tokens& tokens, std::size_t begin, std::size_t end) {
  std::string types;
  for (std::size_t i = begin; i < end; ++i) {
    const bool ends_one = i + 1 == end || tokens[i + 1].text == ",";
    const bool is_name = ends_one && i > begin && is_word(tokens[i]) && tokens[i - 1].text != "::" &&
                         tokens[i - 1].text != "," && tokens[i - 1].text != "const";
    if (!is_name) types += tokens[i].text + " ";
  }
  return types;
}

/// Of `constexpr int kOne = 1, kTwo[] = {2}`.
void add_variables(const Tokens& head, std::set<LocalName>& names) {
  bool in_value = false;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (!in_value) i = behind_angles(head, i);
    if (i == head.size()) return;
    const std::string next = i + 1 < head.size() ? head[i + 1].text : ";";
    const bool ends_name = next == "=" || next == "[" || next == "{" || next == ";" || next == ",";
    if (!in_value && i > 0 && is_word(head[i]) && ends_name) names.insert({head[i].text, ""});
    if (head[i].text == "=" || head[i].text == "{") in_value = true;
    if (opens(head[i])) i = behind_group(head, i) - 1;
    if (i < head.size() && head[i].text == ",") in_value = false;
  }
}

void add_declaration(Tokens head, std::set<LocalName>& names) {
  while (!head.empty() && (head[0].text == "[" || head[0].text == "inline")) head.erase(head.begin());
  if (!head.empty() && head[0].text == "template")
    head.erase(head.begin(), head.begin() + static_cast<std::ptrdiff_t>(behind_angles(head, 1)));
  if (head.size() < 2) return;
  const std::string& first = head[0].text;
  if (first == "using" || first == "namespace") {
    if (head.size() < 3 || head[2].text != "=") return;  // brings in what stands elsewhere
    std::string stands_for;
    for (std::size_t i = 3; i < head.size(); ++i) stands_for += head[i].text;
    names.insert({head[1].text, "", stands_for});
  } else if (first == "struct" || first == "class" || first == "enum") {
    names.insert({head[1].text == "class" || head[1].text == "struct" ? head[2].text : head[1].text, ""});
  } else {
    const auto sign =
        std::find_if(head.begin(), head.end(), [](const Token& t) { return t.text == "(" || t.text == "="; });
    if (sign == head.end() || sign->text == "=") return add_variables(head, names);
    const std::size_t at = static_cast<std::size_t>(sign - head.begin());
    if (at > 0 && is_word(head[at - 1]))
      names.insert({head[at - 1].text, "(" + parameter_types(head, at + 1, behind_group(head, at) - 1)});
  }
}

/// The declarations from `at` to the brace that closes their namespace.
void add_scope(const Tokens& tokens, std::size_t at, std::set<LocalName>& names) {
  Tokens head;
  while (at < tokens.size() && tokens[at].text != "}") {
    if (tokens[at].text == ";") {
      add_declaration(std::move(head), names);
      head = {};
      ++at;
    } else if (opens(tokens[at])) {
      const std::size_t end = behind_group(tokens, at);
      const bool is_body =
          tokens[at].text == "{" && (end >= tokens.size() || (tokens[end].text != ";" && tokens[end].text != ","));
      head.insert(head.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
                  tokens.begin() + static_cast<std::ptrdiff_t>(end));
      at = end;
      if (is_body) {
        add_declaration(std::move(head), names);
        head = {};
      }
    } else {
      head.push_back(tokens[at++]);
    }
  }
}

std::set<LocalName> local_names(const std::string& text) {
  const Tokens tokens = tokens_of(text);
  std::set<LocalName> names;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
    if (tokens[i].text == "namespace" && tokens[i + 1].text == "{") add_scope(tokens, i + 2, names);
  return names;
}

/// Of `struct A final : B`, `enum class A : int`: `A`; empty for what defines no type, or one more form of a template.
std::string type_name(const Tokens& tokens, std::size_t at, std::size_t brace) {
  if (tokens[at].text == "template") at = behind_angles(tokens, at + 1);
  if (at >= brace || (tokens[at].text != "struct" && tokens[at].text != "class" && tokens[at].text != "enum"))
    return "";
  ++at;
  while (at < brace && (tokens[at].text == "class" || tokens[at].text == "struct" || opens(tokens[at])))
    at = opens(tokens[at]) ? behind_group(tokens, at) : at + 1;
  if (at >= brace || !is_word(tokens[at])) return "";
  const std::string next = tokens[at + 1].text;
  return next == "{" || next == ":" || next == "final" ? tokens[at].text : "";
}

/// The types that are defined from `at` to the brace that closes their namespace, which is where `at` then is.
void add_types(const Tokens& tokens, std::size_t& at, const std::string& scope, std::set<std::string>& types) {
  std::size_t first = at;  // of the declaration
  while (at < tokens.size() && tokens[at].text != "}") {
    const bool is_end = tokens[at].text == ";", is_brace = tokens[at].text == "{";
    if (is_brace && tokens[first].text == "namespace") {
      std::string inner = scope;
      for (std::size_t i = first + 1; i < at; ++i) inner += tokens[i].text;
      add_types(tokens, ++at, inner + "::", types);
      ++at;
    } else {
      const std::string type = is_brace ? type_name(tokens, first, at) : "";
      if (!type.empty()) types.insert(scope + type);
      at = opens(tokens[at]) ? behind_group(tokens, at) : at + 1;
    }
    if (is_end || is_brace) first = at;
  }
}

std::set<std::string> types_in(const std::string& text) {
  const Tokens tokens = tokens_of(text);
  std::set<std::string> types;
  std::size_t at = 0;
  add_types(tokens, at, "", types);
  return types;
}

/// The target whose batches the file is in; empty: it is compiled by itself.
std::string module_of(const std::string& file, const std::string& emulator_build) {
  const std::string folder = file.substr(0, file.rfind('/'));
  if (folder.rfind("emulator", 0) != 0 || folder == "emulator/program") return folder;
  const std::size_t alone = emulator_build.find("set_source_files_properties(");
  return emulator_build.find(file.substr(9), alone) == std::string::npos ? "emulator" : "";
}

}  // namespace

TEST_CASE("names of unnamed namespaces are read as they are written") {
  const auto has = [](const char* text, const char* name, const char* parameters) {
    return local_names(std::string("namespace a { namespace {\n") + text + "\n} }").count({name, parameters}) == 1;
  };
  CHECK(has("constexpr int kOne = 1, kTwo[] = {2, 3};", "kTwo", ""));
  CHECK(!has("constexpr int kOne = f(kTwo, 2);", "kTwo", ""));
  CHECK(!has("constexpr std::array<int, 2> kTwo = {1, 2};", "int", ""));
  CHECK(has("constexpr std::array<int, 2> kTwo = {1, 2};", "kTwo", ""));
  CHECK(has("template <bool (*Test)(char)> int all(int a) { return a; }", "all", "(int "));
  CHECK(has("enum Offset : unsigned { kA };", "Offset", ""));
  CHECK(has("using Row = Rows<int>;", "Row", ""));
  CHECK(has("bool is(const A& a, B b) { return a == b; }", "is", "(const A & , B "));
  CHECK(has("int f() { int g = 1; return g; } int h() { return 2; }", "h", "("));
  CHECK(!has("int f() { int g = 1; return g; }", "g", ""));
}

TEST_CASE("files of a module can be compiled as one") {
  const fs::path root = finemote::test::source_dir();
  const std::string emulator_build = read(root / "emulator/CMakeLists.txt");
  std::map<std::string, std::map<LocalName, std::string>> modules;  ///< the file that has each name
  std::size_t files = 0;
  for (const char* part : {"generator", "emulator"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      if (entry.path().extension() != ".cpp") continue;
      const std::string file = entry.path().lexically_relative(root).generic_string();
      const std::string module = module_of(file, emulator_build);
      if (module.empty()) continue;
      ++files;
      for (const LocalName& name : local_names(read(entry.path()))) {
        const auto [known, is_new] = modules[module].emplace(name, file);
        const bool is_same_alias = !name.stands_for.empty() && name.stands_for == known->first.stands_for;
        if (!is_new && !is_same_alias)
          FAIL_CHECK(file << ": '" << name.name << "' is also a name in an unnamed namespace of " << known->second);
      }
    }
  }
  CHECK(files > 400);
}

TEST_CASE("types are read with their namespaces") {
  CHECK(types_in("namespace a::b { struct S final { struct T {}; }; namespace c { enum class E : int { e }; } }") ==
        std::set<std::string>{"a::b::S", "a::b::c::E"});
  CHECK(types_in("namespace a { template <typename T> class C : B<T> {}; template <> class C<int> {}; }") ==
        std::set<std::string>{"a::C"});
  CHECK(types_in("namespace a { struct S; struct S make() { return {}; } inline S s{}; int f() {} class D {}; }") ==
        std::set<std::string>{"a::D"});
}

TEST_CASE("a type of the headers has its name for itself") {
  const fs::path root = finemote::test::source_dir();
  std::map<std::string, std::string> known;  ///< the header of each type
  for (const char* part : {"generator", "emulator"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      if (entry.path().extension() != ".hpp") continue;
      const std::string header = entry.path().lexically_relative(root).generic_string();
      for (const std::string& type : types_in(read(entry.path()))) {
        const auto [other, is_new] = known.emplace(type, header);
        if (!is_new) FAIL_CHECK(header << ": '" << type << "' is also defined in " << other->second);
      }
    }
  }
  CHECK(known.size() > 600);
}
