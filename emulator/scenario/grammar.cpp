#include "emulator/scenario/grammar.hpp"

#include "emulator/scenario/build.hpp"

namespace finemote::scenario {
namespace {

/// How far `name` is a member of the family: the text after `stem` is 0 to `last` in plain digits.
bool is_of_family(std::string_view name, std::string_view stem, int last) {
  if (last < 0) return name == stem;
  if (name.substr(0, stem.size()) != stem) return false;
  const std::string_view digits = name.substr(stem.size());
  const bool plain = !digits.empty() && digits.size() <= 3 && (digits.size() == 1 || digits[0] != '0') &&
                     digits.find_first_not_of("0123456789") == std::string_view::npos;
  return plain && std::stoi(std::string(digits)) <= last;
}

template <class Row>
const Row* find_row(const std::vector<Row>& rows, std::string_view name, int Row::*last) {
  for (const Row& row : rows) {
    if (is_of_family(name, row.name, row.*last)) return &row;
  }
  return nullptr;
}

}  // namespace

const Model* find_model(std::string_view type) {
  for (const Model& model : models()) {
    if (model.type == type) return &model;
  }
  return nullptr;
}

const PortKind* kind_of_port(std::string_view port) {
  for (const PortKind& kind : port_kinds()) {
    for (const std::string& name : kind.ports) {
      if (name == port) return &kind;
    }
  }
  return nullptr;
}

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const Model& model : models()) all.push_back({"part", model.type, nullptr, &model.verbs});
  for (const PortKind& kind : port_kinds()) all.push_back({"port", kind.title, &kind, &kind.verbs});
  all.push_back({"pin", "pin", nullptr, &pin_verbs()});
  all.push_back({"", "the board", nullptr, &board_verbs()});
  return all;
}

const std::vector<Member>& part_members() {
  static const std::vector<Member> kMembers{required(text("type", "its model")), required(text("name", ""))};
  return kMembers;
}

const std::vector<Member>& event_members() {
  static const std::vector<Member> kMembers{
      required(integer("t_ns", "ns", "when, since the first release", 0, kLongest)),
      required(text("do", "what happens"))};
  return kMembers;
}

const std::vector<Member>& expectation_members() {
  static const std::vector<Member> kMembers{
      required(integer("from_ns", "ns", "the first look, since the first release", 0, kLongest)),
      integer("to_ns", "ns", "the last look; without, `from_ns`", 0, kLongest),
      required(row(Kind::part, "part", "", "whose value")),
      required(text("value", "")),
      required(number("min", "", "")),
      required(number("max", "", "")),
  };
  return kMembers;
}

const Verb* find_verb(const std::vector<Verb>& verbs, std::string_view name) {
  for (const Verb& verb : verbs) {
    if (verb.name == name) return &verb;
  }
  return nullptr;
}

const Member* find_member(const std::vector<Member>& members, std::string_view name) {
  return find_row(members, name, &Member::last);
}

const Quantity* find_quantity(const std::vector<Quantity>& values, std::string_view name) {
  return find_row(values, name, &Quantity::last);
}

unsigned number_in_family(std::string_view name, std::string_view stem) {
  return name.size() == stem.size() ? 0 : static_cast<unsigned>(std::stoul(std::string(name.substr(stem.size()))));
}

std::vector<std::string> names_of(const std::string& name, int last) {
  if (last < 0) return {name};
  std::vector<std::string> names;
  for (int i = 0; i <= last; ++i) names.push_back(name + std::to_string(i));
  return names;
}

}  // namespace finemote::scenario
