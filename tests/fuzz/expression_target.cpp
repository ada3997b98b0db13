// Any text as an expression, with a few properties of every type to work on.
#include <cstdint>
#include <cstdlib>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/xacro/expand.hpp"
#include "tests/escaped.hpp"

using namespace finemote::gen;
using finemote::test::escaped;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string document =
      "<r xmlns:xacro='x'><xacro:property name='i' value='42'/><xacro:property name='s' value='text'/>"
      "<xacro:property name='l' value=\"${[1, 2.5, 'x', None]}\"/><xacro:property name='d' value=\"${dict(a=1, "
      "b=[2])}\"/>"
      "<x v=\"${" +
      escaped(text) + "}\"/></r>";
  Sources sources;
  Diagnostics diagnostics;
  xacro::Dependencies dependencies;
  const SourceFile* file = sources.add(SourceFile{"fuzz.xacro", "/nonexistent/fuzz.xacro", document});
  const auto result = xacro::expand(*file, {}, {}, sources, diagnostics, dependencies);
  if (result.has_value() == diagnostics.has_errors()) std::abort();
  return 0;
}
