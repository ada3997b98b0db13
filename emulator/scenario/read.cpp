#include "emulator/scenario/read.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emulator/scenario/values.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/json/parse.hpp"

namespace finemote::scenario {
namespace {

namespace code = gen::code;
using gen::json::Value;

/// The entries of a list that may be absent.
const std::vector<Value>& entries(const Value& document, const char* key) {
  static const std::vector<Value> kNone;
  const Value* list = document.find(key);
  return list == nullptr ? kNone : list->items;
}

gen::Diagnostic& warn(const Value& time, std::string words, gen::Diagnostics& diagnostics) {
  return diagnostics.warning(code::scenario_time, time.at, std::move(words)).underline(time.length);
}

void check_order(const Value& document, gen::Diagnostics& diagnostics) {
  double last = 0;
  for (const Value& event : entries(document, "events")) {
    const Value& time = *event.find("t_ns");
    if (number_of(time) < last) warn(time, "this event happens before the event above it", diagnostics);
    last = number_of(time);
  }
}

/// Expectations do not lengthen a run; events do.
void check_end(const Value& document, std::int64_t duration_ns, gen::Diagnostics& diagnostics) {
  const std::int64_t end = std::max(last_event_ns(document), duration_ns);
  for (const Value& entry : entries(document, "expect")) {
    const Value* to = entry.find("to_ns");
    const Value& time = to == nullptr ? *entry.find("from_ns") : *to;
    const auto at = static_cast<std::int64_t>(number_of(time));
    if (at <= end) continue;
    warn(time,
         fmt::format("the run ends after {} ns at the latest, before this expectation is judged: it will fail", end),
         diagnostics)
        .hint(fmt::format("--duration {}ms", at / 1'000'000 + 1));
  }
}

}  // namespace

std::optional<Value> read(const gen::SourceFile& file, const World& world, gen::Diagnostics& diagnostics) {
  gen::Diagnostics findings;
  auto tree = gen::json::parse(file, findings);
  gen::Diagnostics mistakes;
  for (gen::Diagnostic finding : findings.in_file_order()) {
    finding.code = code::bad_scenario;
    if (!tree) finding.message = "this is not JSON: " + finding.message;
    mistakes.add(finding);
  }
  if (tree) check(*tree, world, mistakes);
  if (!mistakes.has_errors()) {
    check_order(*tree, mistakes);
    if (world.duration_ns) check_end(*tree, *world.duration_ns, mistakes);
    const bool says =
        !entries(*tree, "parts").empty() || !entries(*tree, "events").empty() || !entries(*tree, "expect").empty();
    if (!says)
      mistakes.warning(code::scenario_unjudged, tree->at, "nothing happens in this scenario, and nothing is expected");
  }
  for (const gen::Diagnostic& finding : mistakes.in_file_order()) diagnostics.add(finding);
  if (mistakes.has_errors()) return std::nullopt;
  return tree;
}

std::int64_t last_event_ns(const Value& document) {
  double last = 0;
  for (const Value& event : entries(document, "events")) last = std::max(last, number_of(*event.find("t_ns")));
  return static_cast<std::int64_t>(last);
}

}  // namespace finemote::scenario
