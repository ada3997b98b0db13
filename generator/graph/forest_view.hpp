// A planned robot to what pictures of its device trees say: a row for every device, and the buses they are on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/forest/forest.hpp"
#include "generator/model/robot.hpp"
#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// A device in a picture. Indices are places in ForestView::rows and ForestView::buses.
struct ForestRow {
  DeviceId device;
  Rank rank;
  std::size_t depth = 0;              ///< 0: a root
  std::optional<std::size_t> parent;  ///< always before it
  std::string name;                   ///< as written
  std::string type;
  std::string period;              ///< `10 ms`
  std::size_t bucket = 0;          ///< shortest period first
  std::string place;               ///< `segment_0 0x76`, `pwm channel 3`; empty: on no bus
  std::optional<std::size_t> bus;  ///< the physical one
  std::vector<std::size_t> reads;  ///< devices outside its own subtree that it observes
};

/// A physical bus, and the parts that divide it.
struct BusRow {
  std::string name;
  std::string what;                 ///< `uart on usart1, 921600 baud`
  std::vector<std::string> behind;  ///< `mux: tca9548a on i2c`
};

struct ForestView {
  std::string robot, board, tick;  ///< `FinsROV`, `robomaster_type_c`, `1 ms`
  std::vector<ForestRow> rows;     ///< tree after tree, each from its root down, children in document order
  std::vector<BusRow> buses;       ///< document order
};

ForestView view_of(const Robot& robot, const Forest& forest, const Schedule& schedule);

}  // namespace finemote::gen
