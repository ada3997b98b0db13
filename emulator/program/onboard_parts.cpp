#include "emulator/program/onboard_parts.hpp"

#include <algorithm>

#include "emulator/scenario/place.hpp"
#include "generator/json/parse.hpp"

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;

/// A member that scenario and board say alike.
bool is_same(const Json& a, const Json& b, const char* key) {
  return a.contains(key) && b.contains(key) && a.at(key) == b.at(key);
}

bool takes_its_place(const Json& other, const Json& part) {
  if (!other.is_object()) return false;  // the checker says so
  return is_same(other, part, "name") || (is_same(other, part, "type") && is_same(other, part, "port"));
}

}  // namespace

Json onboard_parts(const Json& board, const Json& scenario) {
  Json own = scenario.is_object() ? scenario.value("parts", Json::array()) : Json::array();
  if (!own.is_array()) own = Json::array();
  Json parts = Json::array();
  for (const Json& part : board.value("on_board", Json::array())) {
    const bool is_replaced =
        std::any_of(own.begin(), own.end(), [&](const Json& it) { return takes_its_place(it, part); });
    if (!is_replaced) parts.push_back(part);
  }
  return {{"schema", scenario::kFormat}, {"parts", parts}};
}

scenario::World world_of(const Json& board, const Json& parts) {
  scenario::World world;
  gen::Diagnostics none;
  const auto tree = gen::json::parse({"", "", parts.dump()}, none);
  for (const gen::json::Value& entry : tree->find("parts")->items) {
    const std::string& type = entry.find("type")->text;
    world.parts.push_back({entry.find("name")->text, type});
    if (const scenario::Model* model = scenario::find_model(type))
      world.parts.back().place = scenario::place_of(entry, *model);
  }
  for (const Json& port : board.value("ports", Json::array())) {
    if (port.contains("selects"))
      world.selects[port.at("name").get<std::string>()] = static_cast<unsigned>(port.at("selects").size());
  }
  return world;
}

}  // namespace finemote::emulator
