// Turns the states of devices into frames for a computer, and its frames into their commands.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"
#include "finemote/interfaces/link.hpp"
#include "finemote/link.hpp"
#include "finemote/recent_bytes.hpp"
#include "finemote/uart.hpp"

namespace finemote {

/// Every update() takes what has arrived and, every `interval`, sends one block of states: the blocks in turn. A frame
/// that is damaged, or of another layout, is counted and changes nothing; of several good ones of a block the last
/// counts. A command's origin is when its frame began to arrive; after `max_age` without a good frame all commands are
/// invalid, so that actuators go safe.
class HostLink {
 public:
  struct Config {
    Duration max_age = 200 * kMillisecond;          ///< of the last command frame
    Duration interval = 10 * kMillisecond;          ///< between two frames sent
    Duration command_interval = 20 * kMillisecond;  ///< between two frames of commands: for the analysis alone
  };

  constexpr HostLink(const Config& config, const LinkLayout& layout, Uart& uart, Ports<Any> = {})
      : max_age_(config.max_age), interval_(config.interval), sizes_(layout), layout_(layout), uart_(uart) {}

  void update();
  void handle();

  LinkState state;

 private:
  /// Bytes of the payload of each block of commands.
  struct BlockSizes {
    constexpr explicit BlockSizes(const LinkLayout& layout) {
      for (const LinkTarget& target : layout.down)
        of[target.block] = static_cast<std::uint8_t>(of[target.block] + link::size_of(target));
      for (std::size_t block = 0; block < layout.down_blocks; ++block) {
        smallest = of[block] < smallest ? of[block] : smallest;
        largest = of[block] < largest ? largest : of[block];
      }
    }
    std::uint8_t of[link::kMaxBlocks]{};
    std::uint8_t smallest = link::kMaxPayload, largest = 0;
  };
  /// What one read has brought.
  struct Found;

  static constexpr std::size_t kMostBytes = RecentBytes<link::kMaxFrame>::kMost;

  void receive();
  void drop_old();
  const std::uint8_t* look(std::size_t size);
  std::size_t find(const std::uint8_t* begin, std::size_t count, Found& found);
  [[nodiscard]] unsigned most_frames() const;
  [[nodiscard]] bool is_ours(const std::uint8_t* frame) const;
  void judge_foreign(const std::uint8_t* frame);
  void apply(std::uint8_t block, const std::uint8_t* payload, Time arrival);
  void send();
  std::size_t fill(std::uint8_t* payload, Time at) const;

  const Duration max_age_, interval_;
  const BlockSizes sizes_;
  const LinkLayout& layout_;
  Uart& uart_;
  Time next_send_ = 0;
  std::uint8_t block_ = 0, sequence_ = 0;
  RecentBytes<link::kMaxFrame> recent_;
};

}  // namespace finemote
