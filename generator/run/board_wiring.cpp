#include "generator/run/board_wiring.hpp"

#include "generator/bus/bus_kind.hpp"
#include "generator/model/names.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

Json port_wiring(const Port& port) {
  Json pins = Json::array(), buses = Json::array();
  for (const PortPin& pin : port.pins) pins.push_back({{"signal", pin.signal}, {"pin", pin.pin}});
  for (const BusKind kind : port.kinds) buses.push_back(bus_kind_name(kind));
  Json wiring{{"name", port.name}, {"buses", buses}, {"pins", pins}, {"selects", port.selects}};
  if (port.timer) wiring["timer"] = {{"name", fold_case(port.timer->timer)}, {"channel", port.timer->channel}};
  return wiring;
}

}  // namespace

Json board_wiring(const Board& board) {
  Json ports = Json::array();
  for (const Port& port : board.ports) ports.push_back(port_wiring(port));
  return {{"clocks", {{"crystal_hz", board.clocks.value().crystal_hz}}}, {"ports", ports}};
}

}  // namespace finemote::gen
