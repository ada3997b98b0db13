#include "emulator/scenario/schema.hpp"

#include "emulator/scenario/grammar.hpp"

namespace finemote::scenario {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kPin = "^P([A-H]([0-9]|1[0-5])|I([0-9]|1[01]))$";

Json object_of(const std::vector<Member>& rows, const std::vector<std::string>& one_of = {});

/// A whole number without its decimal point.
Json plain(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) == value ? Json(whole) : Json(value);
}

Json number_of(const Member& row) {
  Json schema{{"type", row.kind == Member::Kind::integer ? "integer" : "number"}};
  if (row.min != -kAny) schema[row.above_min ? "exclusiveMinimum" : "minimum"] = plain(row.min);
  if (row.max != kAny) schema["maximum"] = plain(row.max);
  return schema;
}

Json ports_of(const std::string& kind) {
  for (const PortKind& it : port_kinds()) {
    if (it.name == kind) return Json{{"enum", it.ports}};
  }
  return Json{{"type", "string"}};
}

Json value_of(const Member& row) {
  switch (row.kind) {
    case Member::Kind::flag:
      return Json{{"type", "boolean"}};
    case Member::Kind::integer:
    case Member::Kind::number:
      return number_of(row);
    case Member::Kind::choice:
      return Json{{"enum", row.choices}};
    case Member::Kind::vector:
    case Member::Kind::six: {
      const int count = row.kind == Member::Kind::vector ? 3 : 6;
      return Json{{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", count}, {"maxItems", count}};
    }
    case Member::Kind::port:
      return ports_of(row.choices[0]);
    case Member::Kind::pin:
      return Json{{"type", "string"}, {"pattern", kPin}};
    case Member::Kind::object:
      return object_of(row.members, row.one_of);
    case Member::Kind::list:
      return Json{{"type", "array"}, {"items", object_of(row.members)}};
    default:
      return Json{{"type", "string"}};
  }
}

Json described(const Member& row) {
  Json schema = value_of(row);
  std::string words = row.summary;
  if (!row.unit.empty()) words += (words.empty() ? "[" : " [") + row.unit + "]";
  if (!words.empty()) schema["description"] = words;
  if (!row.usual.empty()) schema["default"] = Json::parse(row.usual);
  return schema;
}

/// `^r([0-9]|...)$` without a limit on the digits' value: that is the checker's.
std::string family_pattern(const std::string& name) { return "^" + name + "[0-9]{1,3}$"; }

Json object_of(const std::vector<Member>& rows, const std::vector<std::string>& one_of) {
  Json schema{{"type", "object"}};
  Json required = Json::array(), properties = Json::object(), patterns = Json::object();
  for (const Member& row : rows) {
    if (row.required) required.push_back(row.name);
    (row.last < 0 ? properties[row.name] : patterns[family_pattern(row.name)]) = described(row);
  }
  if (!required.empty()) schema["required"] = required;
  for (const std::string& name : one_of) schema["oneOf"].push_back({{"required", {name}}});
  schema["properties"] = properties;
  if (!patterns.empty()) schema["patternProperties"] = patterns;
  schema["additionalProperties"] = false;
  return schema;
}

/// An event: the verb's members, and the target's; `target` empty: the board.
Json event_of(const Verb& verb, const std::string& target, const Json& target_schema) {
  std::vector<Member> rows = event_members();
  rows.insert(rows.end(), verb.members.begin(), verb.members.end());
  Json schema = object_of(rows);
  schema["properties"]["do"] = Json{{"const", verb.name}};
  if (!verb.summary.empty()) schema["properties"]["do"]["description"] = verb.summary;
  if (verb.needs_member) schema["minProperties"] = event_members().size() + 2;
  if (target.empty()) return schema;
  schema["required"].push_back(target);
  schema["properties"][target] = target_schema;
  return schema;
}

/// What can stand for the name of a target.
Json name_of(const Target& target) {
  if (target.port != nullptr) return Json{{"enum", target.port->ports}};
  if (target.key == "pin") return Json{{"type", "string"}, {"pattern", kPin}};
  return Json{{"type", "string"}};
}

Json events() {
  Json all = Json::array();
  for (const Target& target : targets()) {
    for (const Verb& verb : *target.verbs) {
      Json event = event_of(verb, target.key, name_of(target));
      event["title"] = target.title + ": " + verb.name;
      all.push_back(event);
    }
  }
  return Json{{"type", "array"}, {"items", {{"anyOf", all}}}, {"description", "What happens, and when."}};
}

Json parts() {
  Json all = Json::array();
  for (const Model& model : models()) {
    std::vector<Member> rows = part_members();
    rows.insert(rows.end(), model.figures.begin(), model.figures.end());
    Json part = object_of(rows, model.one_of);
    part["properties"]["type"] = Json{{"const", model.type}};
    part["title"] = model.type;
    part["description"] = model.summary;
    all.push_back(part);
  }
  return Json{{"type", "array"}, {"items", {{"anyOf", all}}}, {"description", "Parts beside those of the robot."}};
}

Json expectations() {
  return Json{{"type", "array"},
              {"items", object_of(expectation_members())},
              {"description", "What values of parts have to be, looked at every millisecond."}};
}

}  // namespace

Json json_schema() {
  return Json{{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", "FineMote scenario"},
              {"description",
               "What happens to the parts on the emulated board, and what has to be seen at them. "
               "docs/reference/emulator.md says more; names of parts, and values of each, are checked by the tool."},
              {"type", "object"},
              {"required", {"schema"}},
              {"additionalProperties", false},
              {"properties",
               {{"schema", {{"const", kFormat}, {"description", "Format of this file."}}},
                {"parts", parts()},
                {"events", events()},
                {"expect", expectations()}}}};
}

}  // namespace finemote::scenario
