// function_bounds ELF NAME...: what each function takes at most, called with anything in its registers, one a line.
//
// For second_opinion.py, which computes the same from a disassembly and shares nothing with this.
#include <cstdio>
#include <string>
#include <vector>

#include "generator/wcet/longest_path.hpp"
#include "wcet/routes.hpp"

using namespace finemote;
using namespace finemote::gen;

namespace {

const ImageSymbol* function_named(const Image& image, const std::string& name) {
  for (const ImageSymbol& symbol : image.symbols) {
    if (symbol.kind == ImageSymbol::Kind::function && symbol.name == name) return &symbol;
  }
  return nullptr;
}

void print_bound(const test::LoadedImage& loaded, const wcet::PreparedImage& prepared, const std::string& name) {
  const ImageSymbol* symbol = function_named(loaded.image, name);
  if (symbol == nullptr) return;
  const wcet::Walked walked = prepared.walk_from(symbol->address);
  const auto path = longest_path(walked.graph);
  if (path && walked.problems.empty()) std::printf("%s %lld\n", name.c_str(), static_cast<long long>(path->bound));
  for (const auto& [at, problem] : walked.problems) std::printf("%s none: %s\n", name.c_str(), problem.why.c_str());
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) return 2;
  const test::LoadedImage loaded(words[1]);
  const wcet::PreparedImage prepared(loaded.image, loaded.kept, wcet::CodeCost(loaded.placement), loaded.marks);
  for (int i = 2; i < count; ++i) print_bound(loaded, prepared, words[i]);
}
