// Turns the states of devices into frames for a computer, and its frames into their commands.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/byte_window.hpp"
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
  void take(const std::uint8_t* bytes, std::size_t size);
  void look();
  [[nodiscard]] std::size_t examine() const;
  [[nodiscard]] std::size_t expected() const;
  void judge();
  void apply(std::uint8_t block);
  void send();

  const Config config_;
  const LinkLayout* layout_;
  Uart* const uart_;
  Time next_send_ = 0;
  std::uint8_t block_ = 0, sequence_ = 0;
  ByteWindow<link::kMaxFrame> in_;  ///< the frame under way
  std::size_t needed_ = 2;          ///< bytes without which nothing new can be said
  std::size_t behind_ = 0;          ///< bytes that arrived together behind its last one
  std::uint8_t rejected_now_ = 0;   ///< frames with a wrong sum, in this update()
};

}  // namespace finemote
