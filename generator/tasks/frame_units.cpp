#include "generator/tasks/frame_units.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "generator/bus/bus_type.hpp"
#include "generator/units/checked.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen::timing {
namespace {

/// Of one frame of a descriptor. What a part answers where others ask it needs no request.
std::int64_t turns_of(const Frame& frame, const BusType& type) {
  if (!type.is_mastered && frame.write_bytes == 0) return 0;
  return type.is_arbitrated ? std::max<std::int64_t>(ceil_div(frame.write_bytes, std::int64_t{SharedFrame::kBytes}), 1)
                            : 1;
}

/// Some drivers take an exchange and what is written after it in one request, none takes more.
std::int64_t turns_of(const FrameUnit& unit, const BusType& type) {
  std::int64_t turns = 0;
  bool has_room = false;  // in the last request, for what is only written
  for (const Frame& frame : unit.frames) {
    const bool fits = has_room && frame.read_bytes == 0;
    if (!fits) turns = add(turns, turns_of(frame, type));
    has_room = type.takes_then && !fits;
  }
  return turns;
}

}  // namespace

std::vector<FrameUnit> frame_units(const std::vector<Frame>& frames, BusKind kind) {
  const BusType& type = bus_type(kind);
  std::map<std::pair<std::string_view, int>, FrameUnit> units;
  int alone = -1;
  for (const Frame& frame : frames) {
    FrameUnit& unit = units[{to_string(frame.stage), frame.unit > 0 ? frame.unit : alone--}];
    unit.stage = frame.stage;
    unit.frames.push_back(frame);
    const bool answers = frame.read_bytes > 0 || (type.is_both_ways && frame.write_bytes > 0);
    unit.reads = unit.reads || answers;
    unit.writes = unit.writes || frame.write_bytes > 0;
    unit.sets = unit.sets || (frame.write_bytes > 0 && !answers);
  }
  std::vector<FrameUnit> list;
  for (auto& [key, unit] : units) {
    if (unit.is_asked()) unit.turns = turns_of(unit, type);
    list.push_back(std::move(unit));
  }
  return list;
}

std::int64_t turns_of(const std::vector<FrameUnit>& units) {
  std::int64_t turns = 0;
  for (const FrameUnit& unit : units) turns = add(turns, unit.turns);
  return turns;
}

}  // namespace finemote::gen::timing
