#include "generator/diagnostic/render_ci.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/diagnostic/place.hpp"
#include "generator/diagnostic/printable.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/repeats.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// As workflow commands are called.
const char* command_name(Severity severity) { return severity == Severity::note ? "notice" : severity_name(severity); }

/// Message, notes and hints as one text.
std::string whole_message(const Message& message) {
  const Diagnostic& finding = message.finding;
  std::string text = finding.message;
  if (!message.repeats.empty()) text += "\nnote: " + repeats_text(message);
  for (const Note& note : finding.notes) text += "\nnote: " + note.message;
  for (const std::string& hint : finding.hints) text += "\nhint: " + hint;
  return text;
}

/// Workflow commands end at a line break, and their properties at `,` and `:`.
std::string escape_github(std::string_view text, bool is_property) {
  std::string escaped;
  for (const char c : text) {
    const bool needs = c == '%' || c == '\r' || c == '\n' || (is_property && (c == ':' || c == ','));
    escaped += needs ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return escaped;
}

std::string github_line(const Message& message) {
  const Diagnostic& finding = message.finding;
  std::string text = fmt::format("::{} ", command_name(finding.severity));
  const Position& at = finding.at;
  if (at.file != nullptr) text += fmt::format("file={},", escape_github(at.file->place(), true));
  if (at.file != nullptr && at.line > 0) text += fmt::format("line={},", at.line);
  if (at.file != nullptr && at.line > 0 && at.column > 0) text += fmt::format("col={},", at.column);
  return text + fmt::format("title={}::{}\n", code_name(finding.code), escape_github(whole_message(message), false));
}

/// A path as the address of an artifact: what is no letter, digit or one of -._~/ is escaped.
std::string to_uri(std::string_view path) {
  std::string uri;
  for (const char c : path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          std::string_view("-._~/").find(c) != std::string_view::npos;
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

Json sarif_location(const Position& at, std::size_t length, const std::string& input) {
  Json physical{{"artifactLocation", {{"uri", to_uri(at.file != nullptr ? at.file->place() : input)}}}};
  Json region{{"startLine", std::max<std::uint32_t>(at.line, 1)}};
  if (at.column > 0) {
    region["startColumn"] = at.column;
    region["endColumn"] = at.column + length;
  }
  physical["region"] = region;
  return Json{{"physicalLocation", physical}};
}

/// The calls that repeats of the finding came from, with what is said of each.
Json sarif_related(const Message& message, const std::string& input) {
  Json related = Json::array();
  for (const Diagnostic& repeat : message.repeats) {
    Json location = sarif_location(outermost(repeat.at), 1, input);
    location["id"] = related.size() + 1;
    location["message"] = Json{{"text", repeat.message}};
    related.push_back(std::move(location));
  }
  return related;
}

}  // namespace

std::string render_gcc(const Diagnostics& diagnostics) {
  std::string text;
  for (const Message& message : messages_of(diagnostics)) {
    const Diagnostic& finding = message.finding;
    const std::string place = printable(place_for_programs(finding.at));
    text += fmt::format("{}: {}: {} [{}]\n", place, severity_name(finding.severity), printable_lines(finding.message),
                        code_name(finding.code));
    for (const RepeatPlace& repeat : repeat_places(message))
      text += fmt::format("{}: note: the same for {} more expansion{} from here\n",
                          printable(place_for_programs(repeat.at)), repeat.count, repeat.count == 1 ? "" : "s");
    for (const Note& note : finding.notes)
      text += fmt::format("{}: note: {}\n", note.at.file != nullptr ? printable(place_for_programs(note.at)) : place,
                          printable_lines(note.message));
    for (const std::string& hint : finding.hints) text += fmt::format("{}: note: {}\n", place, printable_lines(hint));
  }
  return text;
}

std::string render_github(const Diagnostics& diagnostics) {
  constexpr std::size_t kShown = 10;
  std::map<Severity, std::size_t> total, written;
  const auto messages = messages_of(diagnostics);
  for (const Message& message : messages) ++total[message.finding.severity];
  std::string text;
  for (const Message& message : messages) {
    const Diagnostic& finding = message.finding;
    const std::size_t number = ++written[finding.severity];
    const bool is_last = number == kShown && total[finding.severity] > kShown;
    if (number > kShown) continue;
    text += is_last ? fmt::format("::{} title=FineMote::and {} more\n", command_name(finding.severity),
                                  total[finding.severity] - kShown + 1)
                    : github_line(message);
  }
  return text;
}

Json render_sarif(const Diagnostics& diagnostics, const std::string& tool_version, const std::string& input) {
  Json rules = Json::array();
  Json results = Json::array();
  std::map<std::uint16_t, std::size_t> rule_index;
  for (const Message& message : messages_of(diagnostics)) {
    const Diagnostic& finding = message.finding;
    const auto [rule, is_new] = rule_index.emplace(finding.code.number, rules.size());
    if (is_new)
      rules.push_back(
          {{"id", code_name(finding.code)}, {"help", {{"text", "finemote explain " + code_name(finding.code)}}}});
    Json result{{"ruleId", code_name(finding.code)},
                {"ruleIndex", rule->second},
                {"level", severity_name(finding.severity)},
                {"message", {{"text", whole_message(message)}}},
                {"locations", Json::array()}};
    if (finding.at.file != nullptr || !input.empty())
      result["locations"].push_back(sarif_location(finding.at, finding.length, input));
    if (!message.repeats.empty()) {
      result["occurrenceCount"] = message.repeats.size() + 1;
      result["relatedLocations"] = sarif_related(message, input);
    }
    results.push_back(std::move(result));
  }
  const Json driver{{"name", "finemote"}, {"version", tool_version}, {"rules", rules}};
  return Json{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
              {"version", "2.1.0"},
              {"runs", Json::array({Json{{"tool", {{"driver", driver}}}, {"results", results}}})}};
}

}  // namespace finemote::gen
