#include "generator/xacro/source_failure.hpp"

#include <fmt/format.h>

#include <cstring>

#include "generator/xml/read_source.hpp"

namespace finemote::gen::xacro {

void fail_outside(const std::string& file, const files::Denial& denial, const Position& at) {
  throw Failure{code::outside_sandbox,
                fmt::format("cannot read '{}': {}", file, denial.reason),
                at,
                {},
                {"with --sandbox name the package the file is in: --package NAME=FOLDER"}};
}

SystemError why_unreadable(const std::string& file, const Sources& sources, const Position& at) {
  const auto denial = sources.access().why_not(file);
  if (!denial) return {};
  if (denial->is_outside) fail_outside(file, *denial, at);
  if (denial->error != 0) return {denial->error, std::strerror(denial->error)};
  throw Failure{code::unreadable_file, fmt::format("cannot read '{}': {}", file, denial->reason), at};
}

const SourceFile* read_text(const std::string& file, Sources& sources, const Position& at) {
  Diagnostics found;
  const SourceFile* source = xml::read_source(file, sources, found, file, at);
  if (source != nullptr) return source;
  const Diagnostic reason = found.in_file_order().front();
  throw Failure{reason.code, reason.message, reason.at, reason.notes, reason.hints};
}

Failure failure_of(const xml::Malformed& malformed, const Expansion* via) {
  Position at = malformed.at;
  at.via = via;
  Failure failure{malformed.code, malformed.words, at};
  if (malformed.code == code::malformed_xml) {
    failure.message =
        fmt::format("XML parsing error: {}: line {}, column {}", malformed.words, malformed.line, malformed.column);
  }
  if (!malformed.open_name.empty()) {
    failure.notes.push_back({fmt::format("<{}> is still open", malformed.open_name), malformed.open});
    failure.hints.push_back(xml::closing_hint(malformed));
  }
  if (malformed.words == "unbound prefix") {
    failure.hints.push_back(
        "declare the prefix in the root element, for example xmlns:xacro=\"http://www.ros.org/wiki/xacro\"");
  }
  return failure;
}

}  // namespace finemote::gen::xacro
