// How large functions, classes and files may be, and what may stand in them.
#include <algorithm>
#include <filesystem>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"
#include "tests/structure/definitions.hpp"
#include "tests/structure/tokens.hpp"

namespace fs = std::filesystem;
using namespace finemote::test;

namespace {

constexpr int kFunctionLines = 60;
constexpr int kTypeLines = 200;
constexpr int kFileLines = 400;
constexpr std::size_t kLongFiles = 5;
constexpr std::string_view kReasonOfLongFile = "// One file because ";

/// What is longer than the limit on purpose: cut in two, it would be harder to read.
struct Exception {
  std::string_view file;
  std::string_view name;
  std::string_view reason;
};

constexpr Exception kExceptions[] = {
    {"emulator/core/interpreter.cpp", "Interpreter::run_with", "the loop over instructions, kept in registers"},
    {"emulator/core/floating.cpp", "Interpreter::floating", "a decoder: one case per instruction"},
    {"emulator/core/media.cpp", "Interpreter::media", "a decoder: one case per instruction"},
    {"emulator/core/system_space.cpp", "SystemSpace::read_word", "a decoder: one case per register"},
    {"emulator/core/system_space.cpp", "SystemSpace::write_word", "a decoder: one case per register"},
};

/// A place that breaks a rule, and how.
struct Offence {
  std::string file;
  std::string name;
  std::string what;
};

struct Source {
  std::string file;  ///< from the root of the project
  std::string text;

  [[nodiscard]] int lines() const { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }
  [[nodiscard]] bool gives_reason() const { return text.rfind(kReasonOfLongFile, 0) == 0; }
};

std::vector<Source> all_sources() {
  const fs::path root = finemote::test::source_dir();
  std::vector<Source> sources;
  for (const char* folder : {"generator", "runtime", "emulator"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp") continue;
      sources.push_back({entry.path().lexically_relative(root).generic_string(), read(entry.path())});
    }
  }
  std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.file < b.file; });
  return sources;
}

std::vector<Definition> definitions_of(const Source& source) {
  try {
    return definitions_in(source.text);
  } catch (const std::exception& error) {
    throw std::runtime_error(source.file + ": " + error.what());
  }
}

void find_long_definitions(const Source& source, std::vector<Offence>& offences) {
  for (const Definition& definition : definitions_of(source)) {
    const int allowed = definition.kind == DefinitionKind::function ? kFunctionLines : kTypeLines;
    if (definition.lines() <= allowed) continue;
    offences.push_back({source.file, definition.name,
                        "line " + std::to_string(definition.first_line) + ": '" + definition.name + "' takes " +
                            std::to_string(definition.lines()) + " lines, at most " + std::to_string(allowed)});
  }
}

void find_long_file(const Source& source, std::vector<Offence>& offences) {
  const std::string begins = " begin with '" + std::string(kReasonOfLongFile) + "...'";
  if (source.lines() > kFileLines && !source.gives_reason())
    offences.push_back({source.file, "", std::to_string(source.lines()) + " lines have to" + begins});
  if (source.lines() <= kFileLines && source.gives_reason())
    offences.push_back({source.file, "", std::to_string(source.lines()) + " lines need not" + begins});
}

void find_const_casts(const Source& source, std::vector<Offence>& offences) {
  if (source.file.rfind("emulator/", 0) == 0) return;
  for (const Token& token : tokens_of(source.text)) {
    if (token.text == "const_cast")
      offences.push_back({source.file, token.text, "line " + std::to_string(token.line) + ": const_cast"});
  }
}

std::vector<Offence> all_offences(const std::vector<Source>& sources) {
  std::vector<Offence> offences;
  for (const Source& source : sources) {
    find_long_definitions(source, offences);
    find_long_file(source, offences);
    find_const_casts(source, offences);
  }
  return offences;
}

bool excepts(const Exception& entry, const Offence& offence) {
  return entry.file == offence.file && entry.name == offence.name;
}

}  // namespace

TEST_CASE("functions, classes and files are as long as one concept takes, and constants stay constant") {
  const std::vector<Offence> offences = all_offences(all_sources());
  for (const Offence& offence : offences) {
    const auto holds = [&](const Exception& entry) { return excepts(entry, offence); };
    if (std::any_of(std::begin(kExceptions), std::end(kExceptions), holds)) continue;
    FAIL_CHECK(offence.file << ": " << offence.what);
  }
  const auto is_needed = [&](const Exception& entry) {
    return std::any_of(offences.begin(), offences.end(),
                       [&](const Offence& offence) { return excepts(entry, offence); });
  };
  for (const Exception& entry : kExceptions) {
    if (!is_needed(entry)) FAIL_CHECK(entry.file << ": '" << entry.name << "' needs no exception any more");
  }
}

TEST_CASE("few files are long") {
  std::vector<std::string> long_files;
  for (const Source& source : all_sources()) {
    if (source.gives_reason()) long_files.push_back(source.file);
  }
  CAPTURE(long_files);
  CHECK(long_files.size() <= kLongFiles);
}
