// What goes over the wire: `frames` of a device descriptor and of an expander's.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/units/duration.hpp"

namespace finemote::gen {

/// A CAN frame of eight bytes that the devices with an id in the range fill together, each its bytes in the order of
/// the ids.
struct SharedFrame {
  static constexpr std::uint32_t kBytes = 8;
  std::uint32_t identifier = 0;
  std::uint32_t id_min = 0, id_max = 0;
  std::uint32_t width = 2;  ///< bytes that belong to one id

  [[nodiscard]] bool holds(std::uint32_t id) const { return id >= id_min && id <= id_max; }
  /// Where the bytes of an id that it holds begin.
  [[nodiscard]] std::uint64_t offset(std::uint32_t id) const { return std::uint64_t{id - id_min} * width; }
};

/// What starts a frame: a stage of the device, the flush at the end of its bucket, or the part by itself.
enum class FrameStage { update, handle, flush, autonomous };

struct Frame {
  FrameStage stage = FrameStage::update;
  std::int64_t write_bytes = 0, read_bytes = 0;  ///< without address bytes
  std::string use;                               ///< over the bus of this use; empty: the device's own
  int unit = 0;                          ///< frames with the same number are one unit on the bus; 0: it stands alone
  std::optional<Duration> min_interval;  ///< autonomous: the least time between two, by the part's own clock
  std::vector<SharedFrame> shared;       ///< can: identifiers of the frame several devices fill
  bool has_sample = true;                ///< autonomous: measurements may come with it
  bool in_dma_memory = false;            ///< its bytes lie where the DMA reaches them (FINEMOTE_DMA)
  std::string summary;
};

/// As the descriptor spells it: `update`.
const char* to_string(FrameStage stage);

/// Reads entries that the schema accepts.
std::vector<Frame> read_frames(const nlohmann::ordered_json& list);

/// Bytes of one exchange on the bus, without address bytes.
struct Exchange {
  std::int64_t write_bytes = 0, read_bytes = 0;
};

/// What an expander adds to the bus it sits on.
struct ExpanderFrames {
  Exchange per_flush;
  Exchange per_channel;           ///< from the first to the last channel that is used, in the same exchange
  std::optional<Exchange> check;  ///< ahead of some flushes, in the same unit on the bus
  std::string checked_every;      ///< the param that counts the flushes from one check to the next; empty: each is
};

/// Reads a member that the schema accepts.
ExpanderFrames read_expander_frames(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
