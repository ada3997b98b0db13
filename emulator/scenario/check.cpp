#include "emulator/scenario/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "emulator/scenario/build.hpp"
#include "emulator/scenario/figures.hpp"
#include "emulator/scenario/values.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/json/parse.hpp"

namespace finemote::scenario {
namespace {

namespace code = gen::code;
using gen::json::Value;

std::vector<std::string> member_names(const std::vector<Member>& rows) {
  std::vector<std::string> names;
  for (const Member& row : rows) {
    for (std::string& name : names_of(row.name, row.last)) names.push_back(std::move(name));
  }
  return names;
}

template <class Row>
std::vector<std::string> row_names(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) names.push_back(row.name);
  return names;
}

/// A string member, or null.
const Value* word_of(const Value& entry, const char* key) {
  const Value* value = entry.find(key);
  return value != nullptr && value->is(Value::Kind::string) ? value : nullptr;
}

std::string quoted(const std::vector<std::string>& names, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? fmt::format(" {} ", last) : ", ") + fmt::format("'{}'", names[i]);
  return text;
}

/// An item of a list: `events[2]`.
std::string item_name(const std::string& list, std::size_t number) { return fmt::format("{}[{}]", list, number); }

class Checker {
 public:
  Checker(const World& world, gen::Diagnostics& diagnostics)
      : world_(world), parts_(world.parts), ports_(world.ports), diagnostics_(diagnostics), values_(diagnostics) {}

  void document(const Value& root);

 private:
  /// What an event happens to: what can happen there, and what to call it.
  struct Target {
    const std::vector<Verb>* verbs;
    std::string key;  ///< part, port or pin; empty: the board
    std::string words;
  };

  gen::Diagnostic& at(gen::Code code, const Value& value, std::string message) {
    return diagnostics_.error(code, value.at, std::move(message)).underline(value.length);
  }
  void frame(const Value& root);
  void collect(const Value& parts);
  void part(std::size_t number, const Value& entry);
  void event(std::size_t number, const Value& entry);
  void expectation(std::size_t number, const Value& entry);
  void expected_value(const World::Part& part, const Value& entry);
  void expected_limits(const Value& entry);

  std::optional<Target> target_of(const Value& entry);
  std::optional<Target> part_target(const Value& name);
  std::optional<Target> port_target(const Value& name);
  const World::Part* find_part(const Value& name);
  void wiring(const Value& entry, const Place& place);
  void same_address(const Value& entry, const Place& place);
  void is_heard(const Value& event);
  std::vector<std::string> buses_above(const Place& place) const;

  void object(const Value& entry, const std::vector<Member>& rows, const std::string& whose);
  void missing(const Value& entry, const std::vector<Member>& rows, const std::string& whose);
  void exactly_one(const Value& entry, const std::vector<std::string>& names, const std::string& whose);
  void value(const Member& row, const std::string& name, const Value& value);
  void reference(const Member& row, const Value& value);
  void port(const Member& row, const Value& value);
  void is_in_use(const PortKind& kind, const Value& port);

  const World& world_;
  std::vector<World::Part> parts_;  ///< the world's, then the scenario's own
  std::set<std::string> later_;     ///< names of the scenario's own
  std::optional<std::vector<std::string>> ports_;
  gen::Diagnostics& diagnostics_;
  ValueCheck values_;
};

void Checker::document(const Value& root) {
  if (!root.is(Value::Kind::object)) {
    at(code::bad_scenario, root, fmt::format("a scenario is an object, but this is {}", describe(root.kind)));
    return;
  }
  frame(root);
  const auto list = [&root](const char* key) {
    const Value* found = root.find(key);
    return found != nullptr && found->is(Value::Kind::array) ? found : nullptr;
  };
  const Value *parts = list("parts"), *events = list("events"), *expectations = list("expect");
  const auto each = [](const Value* entries, auto check) {
    for (std::size_t i = 0; entries != nullptr && i < entries->items.size(); ++i) check(i, entries->items[i]);
  };
  if (parts != nullptr) collect(*parts);
  each(parts, [this](std::size_t i, const Value& entry) { part(i, entry); });
  each(events, [this](std::size_t i, const Value& entry) { event(i, entry); });
  each(expectations, [this](std::size_t i, const Value& entry) { expectation(i, entry); });
}

/// The members around the entries.
void Checker::frame(const Value& root) {
  const std::vector<std::string> known{"schema", "parts", "events", "expect"};
  for (const gen::json::Member& member : root.members) {
    if (std::find(known.begin(), known.end(), member.key) == known.end()) {
      diagnostics_.error(code::scenario_name, member.at, fmt::format("a scenario has no member '{}'", member.key))
          .underline(member.key.size() + 2)
          .hint(gen::did_you_mean(member.key, known));
    } else if (member.key == "schema") {
      if (member.value.is(Value::Kind::string) && member.value.text == kFormat) continue;
      at(code::bad_scenario, member.value, fmt::format("the format of a scenario is '{}'", kFormat))
          .hint(fmt::format("\"schema\": \"{}\"", kFormat));
    } else {
      values_.is_kind(member.key, member.value, Value::Kind::array);
    }
  }
  if (root.find("schema") == nullptr)
    at(code::bad_scenario, root, "'schema' is missing").hint(fmt::format("add \"schema\": \"{}\"", kFormat));
}

/// The scenario's own parts, before anything refers to them.
void Checker::collect(const Value& parts) {
  for (const Value& entry : parts.items) {
    if (const Value* name = word_of(entry, "name")) later_.insert(name->text);
  }
  for (const Value& entry : parts.items) {
    const Value *name = word_of(entry, "name"), *type = word_of(entry, "type");
    if (name == nullptr) continue;
    if (name->text.empty()) at(code::bad_scenario, *name, "a part needs a name").hint("\"name\": \"part\"");
    const auto known =
        std::find_if(parts_.begin(), parts_.end(), [&](const auto& it) { return it.name == name->text; });
    const std::string model = type == nullptr ? "" : type->text;
    const Model* row = find_model(model);
    const auto place = row == nullptr ? std::nullopt : std::optional(place_of(entry, *row));
    if (place && world_.judges_wiring) wiring(entry, *place);
    if (known == parts_.end())
      parts_.push_back({name->text, model, place});
    else if (known->type.empty())  // stands in for a device without a model
      known->type = model, known->place = place;
    else
      at(code::bad_scenario, *name, fmt::format("there is a part '{}' already", name->text));
  }
}

/// The bus a part is on, then those its muxes are on, up to the port.
std::vector<std::string> Checker::buses_above(const Place& place) const {
  std::vector<std::string> buses{place.bus};
  for (const Place* at = &place; !at->mux.empty() && buses.size() <= parts_.size();) {
    const auto mux = std::find_if(parts_.begin(), parts_.end(), [&](const auto& it) { return it.name == at->mux; });
    if (mux == parts_.end() || !mux->place) break;
    at = &*mux->place;
    buses.push_back(at->bus);
  }
  return buses;
}

/// What stands in the way of a part, among those before it.
void Checker::wiring(const Value& entry, const Place& place) {
  for (const char* key : {"mux", "pwm"}) {
    const Value* name = word_of(entry, key);
    const bool is_there = name == nullptr || std::any_of(parts_.begin(), parts_.end(),
                                                         [&](const auto& it) { return it.name == name->text; });
    if (!is_there && later_.count(name->text) != 0)
      at(code::bad_scenario, *name, fmt::format("'{}' is not above the part that is at it", name->text))
          .note("parts are wired in the order of the list");
  }
  const bool shares = std::find(world_.shared.begin(), world_.shared.end(), place.port) != world_.shared.end();
  for (const World::Part& other : parts_) {
    if (!other.place || shares) continue;
    for (const Place::Hold& hold : place.holds) {
      const auto& taken = other.place->holds;
      const bool clash = std::any_of(taken.begin(), taken.end(), [&](const auto& it) { return it.what == hold.what; });
      if (clash)
        at(code::bad_scenario, *entry.find(hold.member), fmt::format("'{}' has {} already", other.name, hold.what));
    }
  }
  same_address(entry, place);
}

/// A part on a bus is also heard behind every mux there.
void Checker::same_address(const Value& entry, const Place& place) {
  if (!place.address || place.bus.empty()) return;
  const auto has = [](const std::vector<std::string>& buses, const std::string& bus) {
    return std::find(buses.begin(), buses.end(), bus) != buses.end();
  };
  const Value* word = entry.find("address");
  if (word == nullptr) word = entry.find(place.mux.empty() ? "port" : "channel");
  for (const World::Part& other : parts_) {
    if (!other.place || other.place->address != place.address || other.place->bus.empty()) continue;
    if (!has(buses_above(*other.place), place.bus) && !has(buses_above(place), other.place->bus)) continue;
    at(code::bad_scenario, *word,
       fmt::format("'{}' has address {} on {} already", other.name, *place.address, other.place->bus));
  }
}

/// Of a `nack`: some part behind the port has the address.
void Checker::is_heard(const Value& event) {
  const Value *port = word_of(event, "port"), *address = event.find("address");
  if (!world_.judges_wiring || port == nullptr || address == nullptr || !address->is(Value::Kind::number)) return;
  std::vector<std::string> there;
  for (const World::Part& part : parts_) {
    if (!part.place || !part.place->address || buses_above(*part.place).back() != fmt::format("'{}'", port->text))
      continue;
    if (*part.place->address == number_of(*address)) return;
    there.push_back(fmt::format("{} ('{}')", *part.place->address, part.name));
  }
  auto& finding =
      at(code::scenario_name, *address, fmt::format("no part at '{}' has address {}", port->text, shown(*address)));
  std::string list;
  for (const std::string& it : there) list += (list.empty() ? "" : ", ") + it;
  finding.note(there.empty() ? "no part is there" : "there are " + list);
}

void Checker::part(std::size_t number, const Value& entry) {
  if (!values_.is_kind(item_name("parts", number), entry, Value::Kind::object)) return;
  const Value* type = word_of(entry, "type");
  const Model* model = type == nullptr ? nullptr : find_model(type->text);
  if (type != nullptr && model == nullptr) {
    std::vector<std::string> types;
    for (const Model& known : models()) types.push_back(known.type);
    at(code::scenario_name, *type, fmt::format("there is no model of a part '{}'", type->text))
        .hint(gen::did_you_mean(type->text, types));
    return;
  }
  std::vector<Member> rows = part_members();
  if (model != nullptr) rows.insert(rows.end(), model->figures.begin(), model->figures.end());
  const std::string whose = model == nullptr ? "a part" : fmt::format("a '{}'", model->type);
  object(entry, rows, whose);
  if (model == nullptr) return;
  exactly_one(entry, model->one_of, whose);
  check_figures(entry, *model, diagnostics_);
}

const World::Part* Checker::find_part(const Value& name) {
  std::vector<std::string> with_model;
  for (const World::Part& part : parts_) {
    if (!part.type.empty()) with_model.push_back(part.name);
    if (part.name != name.text) continue;
    if (!part.type.empty()) return &part;
    at(code::scenario_name, name, fmt::format("'{}' has no model on the emulated board", name.text))
        .note("what a scenario names is a part: a device on a bus, an expander, a body");
    return nullptr;
  }
  at(code::scenario_name, name, fmt::format("there is no part '{}'", name.text))
      .hint(gen::did_you_mean(name.text, with_model));
  return nullptr;
}

std::optional<Checker::Target> Checker::part_target(const Value& name) {
  if (!values_.is_kind("part", name, Value::Kind::string)) return std::nullopt;
  const World::Part* part = find_part(name);
  const Model* model = part == nullptr ? nullptr : find_model(part->type);
  if (model == nullptr) return std::nullopt;
  return Target{&model->verbs, "part", fmt::format("'{}' ({})", part->name, model->type)};
}

std::optional<Checker::Target> Checker::port_target(const Value& name) {
  if (!values_.is_kind("port", name, Value::Kind::string)) return std::nullopt;
  const PortKind* kind = kind_of_port(name.text);
  const bool has_bus = !ports_ || std::find(ports_->begin(), ports_->end(), name.text) != ports_->end();
  if (kind != nullptr && has_bus) return Target{&kind->verbs, "port", fmt::format("'{}' ({})", name.text, kind->title)};
  std::vector<std::string> ports = ports_.value_or(std::vector<std::string>());
  for (const PortKind& it : port_kinds()) {
    if (!ports_) ports.insert(ports.end(), it.ports.begin(), it.ports.end());
  }
  auto& finding = at(code::scenario_name, name,
                     kind == nullptr       ? fmt::format("the board has no port '{}'", name.text)
                     : kind->name == "adc" ? fmt::format("no device of the robot uses the converter '{}'", name.text)
                                           : fmt::format("the robot has no bus at port '{}'", name.text));
  if (!ports.empty()) finding.hint(gen::did_you_mean(name.text, ports));
  return std::nullopt;
}

/// Nothing after a report.
std::optional<Checker::Target> Checker::target_of(const Value& entry) {
  std::vector<const gen::json::Member*> targets;
  for (const gen::json::Member& member : entry.members) {
    if (member.key == "part" || member.key == "port" || member.key == "pin") targets.push_back(&member);
  }
  if (targets.size() > 1) {
    diagnostics_.error(code::bad_scenario, targets[1]->at, "an event happens to one 'part', 'port' or 'pin'")
        .underline(targets[1]->key.size() + 2);
    return std::nullopt;
  }
  if (targets.empty()) {
    const Value* verb = word_of(entry, "do");
    if (verb != nullptr && find_verb(board_verbs(), verb->text) != nullptr)
      return Target{&board_verbs(), "", "the board"};
    at(code::bad_scenario, entry, "an event happens to a 'part', a 'port' or a 'pin'")
        .note(fmt::format("only {} happens to the board as a whole", quoted(row_names(board_verbs()), "and")));
    return std::nullopt;
  }
  const Value& name = targets[0]->value;
  if (targets[0]->key == "part") return part_target(name);
  if (targets[0]->key == "port") return port_target(name);
  if (!values_.simple(row(Member::Kind::pin, "pin", "", ""), "pin", name)) return std::nullopt;
  return Target{&pin_verbs(), "pin", fmt::format("pin '{}'", name.text)};
}

void Checker::event(std::size_t number, const Value& entry) {
  if (!values_.is_kind(item_name("events", number), entry, Value::Kind::object)) return;
  const auto target = target_of(entry);
  const Value* word = word_of(entry, "do");
  const Verb* verb = target && word != nullptr ? find_verb(*target->verbs, word->text) : nullptr;
  if (target && word != nullptr && verb == nullptr) {
    auto& finding = at(code::scenario_name, *word, fmt::format("'{}' cannot happen to {}", word->text, target->words));
    if (!target->verbs->empty()) finding.hint(gen::did_you_mean(word->text, row_names(*target->verbs)));
  }
  std::vector<Member> rows = event_members();
  if (verb == nullptr) {  // of the other members nothing is known
    for (const Member& row : rows) {
      if (const Value* found = entry.find(row.name)) value(row, row.name, *found);
    }
    missing(entry, rows, "an event");
    return;
  }
  rows.insert(rows.end(), verb->members.begin(), verb->members.end());
  if (!target->key.empty()) rows.push_back(text(target->key.c_str(), ""));
  const std::string whose = fmt::format("'{}' of {}", verb->name, target->words);
  object(entry, rows, whose);
  if (verb->name == "nack") is_heard(entry);
  if (!verb->needs_member) return;
  const std::size_t fixed = event_members().size() + (target->key.empty() ? 0 : 1);
  const bool says = entry.members.size() > fixed;  // a member that is none was reported
  if (!says)
    at(code::bad_scenario, entry, fmt::format("{} changes nothing", whose))
        .hint(fmt::format(
            "give one of {}",
            quoted(member_names(verb->members).size() > 12 ? row_names(verb->members) : member_names(verb->members),
                   "or")));
}

void Checker::expectation(std::size_t number, const Value& entry) {
  if (!values_.is_kind(item_name("expect", number), entry, Value::Kind::object)) return;
  object(entry, expectation_members(), "an expectation");
  expected_limits(entry);
  const Value* name = word_of(entry, "part");
  if (name == nullptr) return;
  for (const World::Part& part : parts_) {
    if (part.name == name->text && !part.type.empty()) return expected_value(part, entry);
  }
}

void Checker::expected_value(const World::Part& part, const Value& entry) {
  const Value* name = word_of(entry, "value");
  const Model* model = find_model(part.type);
  if (name == nullptr || model == nullptr || find_quantity(model->values, name->text) != nullptr) return;
  auto& finding = at(code::scenario_name, *name,
                     fmt::format("'{}', a '{}', has no value '{}'", part.name, model->type, name->text));
  std::vector<std::string> names;
  for (const Quantity& row : model->values) {
    for (std::string& it : names_of(row.name, row.last)) names.push_back(std::move(it));
  }
  if (names.empty())
    finding.note("nothing of it can be looked at");
  else
    finding.hint(gen::did_you_mean(name->text, names));
}

void Checker::expected_limits(const Value& entry) {
  const auto ordered = [&](const char* low, const char* high) {
    const Value *a = entry.find(low), *b = entry.find(high);
    const bool both = a != nullptr && b != nullptr && a->is(Value::Kind::number) && b->is(Value::Kind::number);
    if (!both || number_of(*a) <= number_of(*b)) return;
    at(code::scenario_range, *b, fmt::format("'{}' is {}, below '{}', which is {}", high, shown(*b), low, shown(*a)));
  };
  ordered("from_ns", "to_ns");
  ordered("min", "max");
}

void Checker::object(const Value& entry, const std::vector<Member>& rows, const std::string& whose) {
  for (const gen::json::Member& member : entry.members) {
    const Member* row = find_member(rows, member.key);
    if (row != nullptr) {
      value(*row, member.key, member.value);
    } else {
      diagnostics_.error(code::scenario_name, member.at, fmt::format("{} has no member '{}'", whose, member.key))
          .underline(member.key.size() + 2)
          .hint(gen::did_you_mean(member.key, member_names(rows)));
    }
  }
  missing(entry, rows, whose);
}

void Checker::missing(const Value& entry, const std::vector<Member>& rows, const std::string& whose) {
  for (const Member& row : rows) {
    if (!row.required || entry.find(row.name) != nullptr) continue;
    auto& finding = at(code::bad_scenario, entry, fmt::format("'{}' is missing in {}", row.name, whose));
    if (!row.summary.empty()) finding.note(fmt::format("'{}': {}", row.name, row.summary));
  }
}

void Checker::exactly_one(const Value& entry, const std::vector<std::string>& names, const std::string& whose) {
  std::vector<const gen::json::Member*> found;
  for (const gen::json::Member& member : entry.members) {
    if (std::find(names.begin(), names.end(), member.key) != names.end()) found.push_back(&member);
  }
  if (names.empty() || found.size() == 1) return;
  if (found.empty()) {
    at(code::bad_scenario, entry, fmt::format("{} needs one of {}", whose, quoted(names, "and")));
    return;
  }
  diagnostics_
      .error(code::bad_scenario, found[1]->at, fmt::format("{} has only one of {}", whose, quoted(names, "and")))
      .underline(found[1]->key.size() + 2);
}

void Checker::value(const Member& row, const std::string& name, const Value& value) {
  switch (row.kind) {
    case Member::Kind::part:
    case Member::Kind::reference:
      if (values_.is_kind(name, value, Value::Kind::string)) reference(row, value);
      return;
    case Member::Kind::port:
      if (values_.is_kind(name, value, Value::Kind::string)) port(row, value);
      return;
    case Member::Kind::object:
      if (!values_.is_kind(name, value, Value::Kind::object)) return;
      object(value, row.members, fmt::format("'{}'", name));
      return exactly_one(value, row.one_of, fmt::format("'{}'", name));
    case Member::Kind::list:
      if (!values_.is_kind(name, value, Value::Kind::array)) return;
      for (std::size_t i = 0; i < value.items.size(); ++i) {
        const std::string item = item_name(name, i);
        if (values_.is_kind(item, value.items[i], Value::Kind::object))
          object(value.items[i], row.members, fmt::format("'{}'", item));
      }
      return;
    default:
      values_.simple(row, name, value);
  }
}

void Checker::reference(const Member& row, const Value& value) {
  const World::Part* part = find_part(value);
  const Model* model = part == nullptr ? nullptr : find_model(part->type);
  if (model == nullptr || row.choices.empty()) return;
  if (std::find(model->is.begin(), model->is.end(), row.choices[0]) != model->is.end()) return;
  std::vector<std::string> names;
  for (const World::Part& it : parts_) {
    const Model* other = find_model(it.type);
    if (other != nullptr && std::find(other->is.begin(), other->is.end(), row.choices[0]) != other->is.end())
      names.push_back(it.name);
  }
  auto& finding = at(code::scenario_name, value,
                     fmt::format("'{}' is a '{}', which cannot be a '{}'", value.text, model->type, row.name));
  if (!names.empty()) finding.hint(gen::did_you_mean(value.text, names));
}

/// A part hangs at a bus of the robot.
void Checker::is_in_use(const PortKind& kind, const Value& port) {
  if (!ports_ || std::find(ports_->begin(), ports_->end(), port.text) != ports_->end()) return;
  std::vector<std::string> ports;
  for (const std::string& name : *ports_) {
    if (kind_of_port(name) == &kind) ports.push_back(name);
  }
  auto& finding = at(code::scenario_name, port, fmt::format("the robot has no bus at port '{}'", port.text));
  if (!ports.empty()) finding.hint(gen::did_you_mean(port.text, ports));
}

void Checker::port(const Member& row, const Value& value) {
  const PortKind* kind = kind_of_port(value.text);
  if (kind != nullptr && kind->name == row.choices[0]) return is_in_use(*kind, value);
  for (const PortKind& wanted : port_kinds()) {
    if (wanted.name != row.choices[0]) continue;
    at(code::scenario_name, value, fmt::format("the board has no {} '{}'", wanted.title, value.text))
        .hint(gen::did_you_mean(value.text, wanted.ports));
  }
}

}  // namespace

void check(const Value& document, const World& world, gen::Diagnostics& diagnostics) {
  Checker(world, diagnostics).document(document);
}

}  // namespace finemote::scenario
