// A CAN bus: frames of all nodes take turns by identifier and take their bits' time, stuff bits included.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "emulator/chip/bus_statistics.hpp"
#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// A data frame with a standard identifier.
struct CanFrame {
  std::uint32_t id = 0;
  unsigned size = 0;
  std::array<std::uint8_t, 8> data{};
  std::array<Tag, 8> tags{};  ///< where the data come from
};

/// Bits of a frame on the wire with its stuff bits and the three bits of intermission: ISO 11898-1.
unsigned can_frame_bits(const CanFrame& frame);

/// How a transmission went.
enum class CanOutcome {
  received,        ///< by everybody else
  destroyed,       ///< on the wire
  unacknowledged,  ///< nobody else is there
};

class CanLine {
 public:
  /// What takes part: asked for its most urgent frame, told how its frame went, and given everybody else's.
  struct Node {
    std::function<std::optional<CanFrame>()> next;
    std::function<void(const CanFrame&, CanOutcome)> sent;
    std::function<void(const CanFrame&)> received;
  };

  explicit CanLine(World& world) : world_(world) {}

  /// @return its number
  std::size_t attach(Node node) {
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
  }
  void set_bitrate(std::uint32_t hz) { bitrate_ = hz; }
  /// A node has something to send.
  void request();

  unsigned disturbed_frames = 0;  ///< the next frames are destroyed on the wire
  bool cut = false;               ///< the wire ends behind the controller, the first node: nobody hears it
  /// Who is sending.
  [[nodiscard]] std::optional<std::size_t> sender() const { return sender_; }
  [[nodiscard]] const BusStatistics& statistics() const { return statistics_; }
  /// So many frames have ended, good or destroyed, each with eleven recessive bits.
  [[nodiscard]] std::uint64_t frames() const { return statistics_.transfers + statistics_.errors; }
  /// Whether it has been recessive for so long.
  [[nodiscard]] bool is_idle_for(Time time) const { return !sender_ && world_.now() - ended_at_ >= time; }
  [[nodiscard]] Time bit_time() const { return period_of(bitrate_); }

 private:
  void begin();
  void end(std::size_t sender, const CanFrame& frame, CanOutcome outcome);
  [[nodiscard]] std::size_t reachable() const { return cut ? 1 : nodes_.size(); }

  World& world_;
  std::vector<Node> nodes_;
  std::uint32_t bitrate_ = 1'000'000;
  std::optional<std::size_t> sender_;
  bool asked_ = false;
  Time ended_at_ = 0;  ///< the last frame
  BusStatistics statistics_;
};

}  // namespace finemote::emulator
