// Damaged robots end in a message with a place, or in a robot; never in a crash or a hang.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "catch.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/model/build.hpp"
#include "generator/xml/parse.hpp"

using namespace finemote::gen;
namespace fs = std::filesystem;

namespace {

const fs::path kSource = FINEMOTE_SOURCE_DIR;

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The library is shared by all mutants: types are read once.
struct Bench {
  Sources library_sources;
  Diagnostics library_diagnostics;
  std::optional<Library> library =
      load_library({kSource.string(), (kSource / "examples").string(), {}, {}}, library_sources, library_diagnostics);
  std::size_t accepted = 0, refused = 0, unexplained = 0;
  std::string first_unexplained;

  void run(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    const SourceFile* file = sources.add(SourceFile{"mutant.urdf", "", text});
    bool is_accepted = false;
    if (const auto document = xml::parse(*file, diagnostics)) {
      is_accepted = build_model(*document, *library, {}, sources, diagnostics).has_value();
    }
    ++(is_accepted ? accepted : refused);
    if (is_accepted != diagnostics.has_errors() && is_explained(diagnostics)) return;
    ++unexplained;
    if (first_unexplained.empty()) first_unexplained = text + "\n" + render_text(diagnostics, false);
  }
  /// Every finding has a line of the mutant.
  static bool is_explained(const Diagnostics& diagnostics) {
    for (const Diagnostic& finding : diagnostics.in_file_order()) {
      if (finding.at.file == nullptr || finding.at.line == 0 || finding.message.empty()) return false;
    }
    return !render_text(diagnostics, false).empty() || diagnostics.size() == 0;
  }
  void check() const {
    INFO(first_unexplained);
    CHECK(unexplained == 0);
  }
};

/// An element of a text: from `<` to behind its end tag, or of one of its attributes with the blank before it.
struct Stretch {
  std::size_t begin, end;
};

std::vector<Stretch> find_attributes(const std::string& text) {
  std::vector<Stretch> found;
  for (std::size_t quote = text.find("=\""); quote != std::string::npos; quote = text.find("=\"", quote)) {
    const std::size_t begin = text.find_last_of(" \n", quote);
    const std::size_t close = text.find('"', quote + 2);
    if (begin == std::string::npos || close == std::string::npos) break;
    found.push_back({begin, close + 1});
    quote = close + 1;
  }
  return found;
}

/// Tags that close themselves, and whole lines: what can be removed, doubled or moved with the text mostly well-formed.
std::vector<Stretch> find_tags(const std::string& text) {
  std::vector<Stretch> found;
  for (std::size_t open = text.find('<'); open != std::string::npos; open = text.find('<', open + 1)) {
    const std::size_t close = text.find('>', open);
    if (close == std::string::npos) break;
    if (text[close - 1] == '/') found.push_back({open, close + 1});
  }
  return found;
}

std::vector<std::string> examples() {
  std::vector<std::string> texts;
  for (const auto& entry : fs::directory_iterator(kSource / "examples")) {
    if (entry.path().extension() == ".urdf") texts.push_back(read(entry.path()));
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

}  // namespace

TEST_CASE("every single character of finsrov may be missing") {
  const std::string text = read(kSource / "examples" / "finsrov.urdf");
  Bench bench;
  for (std::size_t i = 0; i < text.size(); ++i) bench.run(text.substr(0, i) + text.substr(i + 1));
  bench.check();
  CHECK(bench.refused > 1000);
  CHECK(bench.accepted > 1000);  // blanks, comments, digits
}

TEST_CASE("every attribute of every example may be missing") {
  Bench bench;
  for (const std::string& text : examples()) {
    for (const Stretch& attribute : find_attributes(text))
      bench.run(text.substr(0, attribute.begin) + text.substr(attribute.end));
  }
  bench.check();
  CHECK(bench.refused > 100);
}

TEST_CASE("values and tags of the examples may be exchanged, doubled and removed") {
  std::mt19937 random(20240607);  // fixed: the same mutants on every run
  const auto pick = [&](std::size_t size) { return static_cast<std::size_t>(random() % size); };
  Bench bench;
  for (const std::string& text : examples()) {
    const auto attributes = find_attributes(text);
    const auto tags = find_tags(text);
    const auto piece = [&](const Stretch& stretch) { return text.substr(stretch.begin, stretch.end - stretch.begin); };
    for (int i = 0; i < 400; ++i) {
      const bool of_tags = i % 2 == 0;
      const auto& pieces = of_tags ? tags : attributes;
      if (pieces.empty()) continue;
      const Stretch& at = pieces[pick(pieces.size())];
      const Stretch& other = pieces[pick(pieces.size())];
      const std::size_t kind = pick(3);
      const std::string instead = kind == 0 ? piece(other) : kind == 1 ? piece(at) + piece(other) : "";
      bench.run(text.substr(0, at.begin) + instead + text.substr(at.end));
    }
  }
  bench.check();
  CHECK(bench.refused > 100);
}
