#include "emulator/outfit/element.hpp"

#include <set>
#include <stdexcept>

namespace finemote::emulator {
namespace {

template <class Row>
std::set<std::string> names_of(const std::map<std::string, Row>& rows) {
  std::set<std::string> names;
  for (const auto& [name, row] : rows) names.insert(name);
  return names;
}

void compare(const std::string& type, const std::set<std::string>& table, const std::set<std::string>& element) {
  for (const std::string& name : table) {
    if (element.count(name) == 0) throw std::logic_error("'" + type + "' lacks '" + name + "' of its table");
  }
  for (const std::string& name : element) {
    if (table.count(name) == 0) throw std::logic_error("the table of '" + type + "' lacks '" + name + "'");
  }
}

}  // namespace

bool Element::happen(const std::string& what, const Json& event) const {
  const auto handler = handlers_.find(what);
  if (handler == handlers_.end()) return false;
  handler->second(event);
  return true;
}

std::optional<double> Element::value(const std::string& quantity) const {
  const auto look = looks_.find(quantity);
  return look == looks_.end() ? std::nullopt : std::optional(look->second());
}

void Element::check_complete(const scenario::Model& model) const {
  std::set<std::string> verbs, values;
  for (const scenario::Verb& verb : model.verbs) verbs.insert(verb.name);
  for (const scenario::Quantity& row : model.values) {
    for (const std::string& name : scenario::names_of(row.name, row.last)) values.insert(name);
  }
  compare(model.type, verbs, names_of(handlers_));
  compare(model.type, values, names_of(looks_));
}

}  // namespace finemote::emulator
