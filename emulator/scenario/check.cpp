#include "emulator/scenario/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "emulator/scenario/build.hpp"
#include "emulator/scenario/entry.hpp"
#include "emulator/scenario/figures.hpp"
#include "emulator/scenario/names.hpp"
#include "emulator/scenario/wiring.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::scenario {
namespace {

namespace code = gen::code;
using gen::json::Value;

std::vector<std::string> verb_names(const std::vector<Verb>& verbs) {
  std::vector<std::string> names;
  for (const Verb& verb : verbs) names.push_back(verb.name);
  return names;
}

class Checker {
 public:
  Checker(const World& world, gen::Diagnostics& diagnostics)
      : world_(world),
        diagnostics_(diagnostics),
        names_(world, diagnostics),
        wiring_(world, names_, diagnostics),
        entry_(names_, diagnostics) {}

  void document(const Value& root);

 private:
  /// What an event happens to: what can happen there, and what to call it.
  struct Subject {
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
  void has_channel(const Value& entry);
  void event(std::size_t number, const Value& entry);
  void unknown_event(const Value& entry);
  void expectation(std::size_t number, const Value& entry);
  void expected_value(const World::Part& part, const Value& entry);
  void expected_limits(const Value& entry);
  std::optional<Subject> subject_of(const Value& entry);
  std::optional<Subject> named_subject(const std::string& key, const Value& name);
  const Verb* verb_of(const Value& entry, const Subject& subject);

  const World& world_;
  gen::Diagnostics& diagnostics_;
  Names names_;
  Wiring wiring_;
  EntryCheck entry_;
};

void Checker::document(const Value& root) {
  if (!root.is(Value::Kind::object)) {
    at(code::bad_scenario, root, fmt::format("a scenario must be an object, got {}", describe(root.kind)));
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
      at(code::bad_scenario, member.value, fmt::format("the format of a scenario must be '{}'", kFormat))
          .hint(fmt::format("\"schema\": \"{}\"", kFormat));
    } else {
      entry_.is_kind(member.key, member.value, Value::Kind::array);
    }
  }
  if (root.find("schema") == nullptr)
    at(code::bad_scenario, root, "'schema' is missing").hint(fmt::format("add \"schema\": \"{}\"", kFormat));
}

/// The scenario's own parts, before anything refers to them.
void Checker::collect(const Value& parts) {
  std::set<std::string> own;
  for (const Value& entry : parts.items) {
    if (const Value* name = word_in(entry, "name")) own.insert(name->text);
  }
  for (const Value& entry : parts.items) {
    const Value *name = word_in(entry, "name"), *type = word_in(entry, "type");
    if (name == nullptr) continue;
    if (name->text.empty()) at(code::bad_scenario, *name, "a part needs a name").hint("\"name\": \"part\"");
    World::Part part{name->text, type == nullptr ? "" : type->text};
    if (const Model* model = find_model(part.type)) {
      part.place = place_of(entry, *model);
      wiring_.judge(entry, *part.place, own);
    }
    if (!names_.add(part)) at(code::bad_scenario, *name, fmt::format("there is already a part '{}'", name->text));
  }
}

void Checker::part(std::size_t number, const Value& entry) {
  if (!entry_.is_kind(item_name("parts", number), entry, Value::Kind::object)) return;
  const Value* type = word_in(entry, "type");
  const Model* model = type == nullptr ? nullptr : find_model(type->text);
  if (type != nullptr && model == nullptr) {
    std::vector<std::string> types;
    for (const Model& known : models()) types.push_back(known.type);
    at(code::scenario_name, *type, fmt::format("there is no part model '{}'", type->text))
        .hint(gen::did_you_mean(type->text, types));
    return;
  }
  if (model == nullptr) return entry_.object(entry, part_members(), "a part");
  const std::string whose = fmt::format("a '{}'", model->type);
  entry_.object(entry, part_members() + model->figures, whose);
  entry_.exactly_one(entry, model->one_of, whose);
  has_channel(entry);
  if (model->check != nullptr) model->check(entry, *model, world_, diagnostics_);
}

/// A part behind an expander is at one of its channels.
void Checker::has_channel(const Value& entry) {
  for (const char* expander : {"mux", "pwm"}) {
    if (entry.find(expander) == nullptr || entry.find("channel") != nullptr) continue;
    at(code::bad_scenario, *entry.find(expander), fmt::format("'channel' of '{}' is missing", expander))
        .hint("\"channel\": 0");
  }
}

std::optional<Checker::Subject> Checker::named_subject(const std::string& key, const Value& name) {
  const auto words = [&name](const std::string& title) { return fmt::format("'{}' ({})", name.text, title); };
  if (key == "pin") {
    Member pin;
    pin.name = key, pin.kind = Member::Kind::pin;
    if (!entry_.value(pin, key, name)) return std::nullopt;
    return Subject{&pin_verbs(), key, fmt::format("pin '{}'", name.text)};
  }
  if (!entry_.is_kind(key, name, Value::Kind::string)) return std::nullopt;
  if (key == "port") {
    const PortKind* kind = names_.port_in_use(name);
    return kind == nullptr ? std::nullopt : std::optional(Subject{&kind->verbs, key, words(kind->title)});
  }
  const Model* model = names_.model_of(name);
  return model == nullptr ? std::nullopt : std::optional(Subject{&model->verbs, key, words(model->type)});
}

/// Nothing after a report.
std::optional<Checker::Subject> Checker::subject_of(const Value& entry) {
  std::vector<const gen::json::Member*> named;
  for (const gen::json::Member& member : entry.members) {
    if (member.key == "part" || member.key == "port" || member.key == "pin") named.push_back(&member);
  }
  if (named.size() > 1) {
    diagnostics_.error(code::bad_scenario, named[1]->at, "an event happens to one 'part', 'port' or 'pin'")
        .underline(named[1]->key.size() + 2);
    return std::nullopt;
  }
  if (!named.empty()) return named_subject(named[0]->key, named[0]->value);
  const Value* verb = word_in(entry, "do");
  if (verb != nullptr && find_verb(board_verbs(), verb->text) != nullptr)
    return Subject{&board_verbs(), "", "the board"};
  at(code::bad_scenario, entry, "an event happens to a 'part', a 'port' or a 'pin'")
      .note(fmt::format("only {} happens to the board as a whole", quoted(verb_names(board_verbs()), "and")));
  return std::nullopt;
}

/// Null after a report, and where there is no `do`, which is reported with the members.
const Verb* Checker::verb_of(const Value& entry, const Subject& subject) {
  const Value* word = word_in(entry, "do");
  if (word == nullptr) return nullptr;
  const Verb* verb = find_verb(*subject.verbs, word->text);
  if (verb != nullptr) return verb;
  auto& finding = at(code::scenario_name, *word, fmt::format("'{}' cannot happen to {}", word->text, subject.words));
  if (!subject.verbs->empty()) finding.hint(gen::did_you_mean(word->text, verb_names(*subject.verbs)));
  return nullptr;
}

/// Of the members beside those of every event nothing is known.
void Checker::unknown_event(const Value& entry) {
  for (const Member& row : event_members()) {
    if (const Value* found = entry.find(row.name)) entry_.value(row, row.name, *found);
  }
  entry_.complete(entry, event_members(), "an event");
}

void Checker::event(std::size_t number, const Value& entry) {
  if (!entry_.is_kind(item_name("events", number), entry, Value::Kind::object)) return;
  const auto subject = subject_of(entry);
  const Verb* verb = subject ? verb_of(entry, *subject) : nullptr;
  if (verb == nullptr) return unknown_event(entry);
  std::vector<Member> rows = event_members() + verb->members;
  if (!subject->key.empty()) rows.push_back(text(subject->key.c_str(), ""));
  const std::string whose = fmt::format("'{}' of {}", verb->name, subject->words);
  entry_.object(entry, rows, whose);
  if (verb->name == "nack") wiring_.is_heard(entry);
  const std::size_t fixed = event_members().size() + (subject->key.empty() ? 0 : 1);
  const bool says = entry.members.size() > fixed;  // a member that is none was reported
  if (!verb->needs_member || says) return;
  std::vector<std::string> names = names_of(verb->members);
  constexpr std::size_t kMany = 12;
  if (names.size() > kMany) {
    names.clear();
    for (const Member& row : verb->members) names.push_back(row.name);
  }
  at(code::bad_scenario, entry, fmt::format("{} changes nothing", whose))
      .hint(fmt::format("give one of {}", quoted(names, "or")));
}

void Checker::expectation(std::size_t number, const Value& entry) {
  if (!entry_.is_kind(item_name("expect", number), entry, Value::Kind::object)) return;
  entry_.object(entry, expectation_members(), "an expectation");
  expected_limits(entry);
  const Value* name = word_in(entry, "part");
  const World::Part* part = name == nullptr ? nullptr : names_.find(name->text);
  if (part != nullptr) expected_value(*part, entry);
}

void Checker::expected_value(const World::Part& part, const Value& entry) {
  const Value* name = word_in(entry, "value");
  const Model* model = find_model(part.type);
  if (name == nullptr || model == nullptr || find_quantity(model->values, name->text) != nullptr) return;
  auto& finding = at(code::scenario_name, *name,
                     fmt::format("'{}', a '{}', has no value '{}'", part.name, model->type, name->text));
  std::vector<std::string> names;
  for (const Quantity& row : model->values) {
    for (std::string& it : names_of(row.name, row.last)) names.push_back(std::move(it));
  }
  if (names.empty())
    finding.note("it has no value that can be looked at");
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

}  // namespace

void check(const Value& document, const World& world, gen::Diagnostics& diagnostics) {
  Checker(world, diagnostics).document(document);
}

}  // namespace finemote::scenario
