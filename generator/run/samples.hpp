// What the states of a sensor's device were made of, update by update, found without its time stamps.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/run/record.hpp"

namespace finemote::gen {

/// The state that an update left.
struct SampledState {
  std::int64_t at_ps = 0;    ///< end of the update
  std::int64_t from_ps = 0;  ///< when the oldest sample in it was taken, of all channels of the device's part
  std::optional<std::int64_t> claimed_ps = {};  ///< when its data were taken, as the state says; none: it is not valid

  [[nodiscard]] Duration at() const { return picoseconds_down(at_ps); }
};

/// Of the updates that took a sample which is known, in the order of time.
std::vector<SampledState> states_of(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId device);

}  // namespace finemote::gen
