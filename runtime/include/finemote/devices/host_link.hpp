// Turns the states of devices into frames for a computer, and its frames into their commands.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"
#include "finemote/interfaces/link.hpp"
#include "finemote/link.hpp"
#include "finemote/uart.hpp"

namespace finemote {

/// Every update() takes what has arrived and, every `interval`, sends one block of states: the blocks in turn. A frame
/// that is damaged, or of another layout, is counted and changes nothing. A command's origin is when its frame began to
/// arrive; after `max_age` without a good frame all commands are invalid, so that actuators go safe.
class HostLink {
 public:
  struct Config {
    Duration max_age = 200 * kMillisecond;  ///< of the last command frame
    Duration interval = 10 * kMillisecond;  ///< between two frames sent
  };

  constexpr HostLink(const Config& config, const LinkLayout& layout, Uart& uart, Ports<Any> = {})
      : config_(config), layout_(&layout), uart_(&uart) {}

  void update();
  void handle();

  LinkState state;

 private:
  void receive();
  void take(std::uint8_t byte);
  [[nodiscard]] std::size_t expected() const;
  void judge();
  void restart();
  void apply(std::uint8_t block);
  void send();

  Config config_;
  const LinkLayout* layout_;
  Uart* uart_;
  Time next_send_ = 0;
  std::uint8_t block_ = 0, sequence_ = 0;
  std::size_t size_ = 0;    ///< of the frame under way
  std::size_t behind_ = 0;  ///< bytes that arrived together behind its last one
  std::uint8_t in_[link::kMaxFrame]{};
};

}  // namespace finemote
