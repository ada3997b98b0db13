#include "generator/xacro/expand.hpp"

#include <new>

#include "generator/xacro/big_stack.hpp"
#include "generator/xacro/expander.hpp"

namespace finemote::gen::xacro {
namespace {

void report(const Failure& failure, const SourceFile& entry, Diagnostics& diagnostics) {
  Position at = failure.at;
  if (at.file == nullptr) at = {&entry, 1, 1};
  Diagnostic& finding = diagnostics.error(failure.code, at, failure.message);
  finding.notes = failure.notes;
  finding.hints = failure.hints;
}

}  // namespace

std::optional<xml::Document> expand(const SourceFile& entry, const Arguments& arguments, const PackagePath& packages,
                                    Sources& sources, Diagnostics& diagnostics, Dependencies& dependencies,
                                    std::ostream* messages) {
  std::optional<xml::Document> document;
  run_on_big_stack([&] {
    try {
      document = Expander(entry, arguments, packages, sources, diagnostics, dependencies, messages).run();
    } catch (const Failure& failure) {
      report(failure, entry, diagnostics);
    } catch (const std::bad_alloc&) {
      report({code::xacro_limit, "the expansion needs more memory than there is"}, entry, diagnostics);
    }
  });
  return document;
}

}  // namespace finemote::gen::xacro
