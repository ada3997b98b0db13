#include "cases.hpp"
#include "source_dir.hpp"

#include <fstream>
#include <sstream>

#include "generator/descriptor/library.hpp"
#include "generator/model/build.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::test {

using namespace gen;
namespace fs = std::filesystem;

fs::path source_folder() { return finemote::test::source_dir(); }
fs::path cases_folder() { return source_folder() / "tests" / "errors"; }

std::set<std::string> case_names() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(cases_folder())) {
    const fs::path suffix = entry.path().extension();
    if (entry.is_directory() || suffix == ".urdf" || suffix == ".expected") names.insert(entry.path().stem().string());
  }
  return names;
}

Case find_case(const std::string& name) {
  const fs::path folder = cases_folder() / name;
  if (fs::is_directory(folder)) return {name, folder / "robot.urdf", folder, folder / "expected", "robot.urdf"};
  const fs::path all = cases_folder();
  return {name, all / (name + ".urdf"), all, all / (name + ".expected"), name + ".urdf"};
}

void examine(const Case& test, const std::string& text, Said& said) {
  LibraryOptions options{source_folder().string(), test.folder.string(), {}, {}};
  if (fs::is_directory(test.folder / "boards")) options.board_paths.push_back((test.folder / "boards").string());
  auto library = load_library(options, said.sources, said.diagnostics);
  const SourceFile* file = text.empty()
                               ? xml::read_source(test.input.string(), said.sources, said.diagnostics, test.display)
                               : said.sources.add(SourceFile{test.display, test.input.string(), text});
  if (!library || file == nullptr) return;
  const auto document = xml::parse(*file, said.diagnostics);
  if (document) build_model(*document, *library, {}, said.sources, said.diagnostics);
}

}  // namespace finemote::test
