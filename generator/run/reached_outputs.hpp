// When the commands of a device reached its output, and what became of those that never did.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "generator/run/record.hpp"

namespace finemote::gen {

/// Of one device, by the number of the run of its handle.
class ReachedOutputs {
 public:
  ReachedOutputs(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId device);

  /// When the command of a run came out first; none: it never did.
  [[nodiscard]] std::optional<Duration> of(std::uint32_t run) const;

  /// When a later command came out in place of one that a driver was given; none: it had none, or nothing did.
  [[nodiscard]] std::optional<Duration> overtaken(std::uint32_t run) const;

  /// A driver was given a command, and neither that nor a later one has come out, where some have.
  [[nodiscard]] bool is_awaited(std::uint32_t run) const;

 private:
  std::map<std::uint32_t, Duration> own_;  ///< commands that came out by themselves
  std::map<std::uint32_t, Duration> any_;  ///< and those that a command for the same value may have brought along
  std::set<std::uint32_t> handed_over_;
};

}  // namespace finemote::gen
