// Frames of a descriptor to what a driver is asked for at once.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/bus/bus_kind.hpp"
#include "generator/descriptor/frames.hpp"

namespace finemote::gen::timing {

/// Frames of one stage that go over a bus together.
struct FrameUnit {
  FrameStage stage = FrameStage::update;
  std::vector<Frame> frames;
  bool reads = false;   ///< something comes back
  bool writes = false;  ///< something is sent
  bool sets = false;    ///< something is sent, and nothing comes back with it
  /// How often the device has to ask its driver for all of it, which takes one request at a time; 0: never.
  std::int64_t turns = 0;

  /// A stage of the device begins it, and not the flush of its bucket or its part.
  [[nodiscard]] bool is_asked() const { return stage == FrameStage::update || stage == FrameStage::handle; }
};

/// In the order of their stages' names: frames with one number together, those with 0 alone.
std::vector<FrameUnit> frame_units(const std::vector<Frame>& frames, BusKind kind);

/// Of all that stages of the device begin.
std::int64_t turns_of(const std::vector<FrameUnit>& units);

}  // namespace finemote::gen::timing
