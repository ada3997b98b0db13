// Any bytes as a xacro file: no crash, no leak, no hang; an error always has a place.
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "generator/diagnostic/render.hpp"
#include "generator/xacro/expand.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/write.hpp"

using namespace finemote::gen;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Sources sources;
  Diagnostics diagnostics;
  xacro::Dependencies dependencies;
  std::ostringstream messages;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const SourceFile* file = sources.add(SourceFile{"fuzz.xacro", "/nonexistent/fuzz.xacro", text});
  const auto document = xacro::expand(*file, {{"a", "1"}}, {}, sources, diagnostics, dependencies, &messages);
  if (document.has_value() == diagnostics.has_errors()) std::abort();
  for (const Diagnostic& finding : diagnostics.in_file_order()) {
    if (finding.at.file == nullptr) std::abort();
  }
  render_text(diagnostics, false);
  if (document) xml::write(*document, "fuzz.xacro");
  return 0;
}
