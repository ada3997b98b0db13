// Keeps what a serial line has brought side by side in memory, as long as it may still become a frame.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/four_bytes.hpp"
#include "finemote/uart.hpp"

namespace finemote {

/// Bytes that a frame may begin with, `longest` at most, and behind them those that were read last. Looking for frames
/// in it takes a time that grows with the bytes read, whatever they are: nothing is taken in twice.
/// @code const std::size_t size = uart.read(recent.room(), Uart::kChunk);
/// ... look from recent.begin() to recent.room() + size; recent.keep(first_undecided, size); @endcode
template <std::size_t longest>
class RecentBytes {
 public:
  /// Bytes there are at most.
  static constexpr std::size_t kMost = longest + Uart::kChunk;

  [[nodiscard]] std::uint8_t* room() { return bytes_ + longest; }  ///< for Uart::kChunk bytes

  /// The first of those that were kept; room(): there are none.
  [[nodiscard]] const std::uint8_t* begin() const { return bytes_ + longest - kept(); }
  /// How many were kept.
  [[nodiscard]] std::size_t kept() const {
    return kept_ < longest ? kept_ : longest;  // never more, which only this line tells tools
  }

  /// Of `read` bytes in room() and those before them, the ones from `first` on are kept: `longest` at most.
  void keep(const std::uint8_t* first, std::size_t read) {
    kept_ = static_cast<std::uint16_t>(bytes_ + longest + read - first);
    move_bytes(bytes_ + read, bytes_, longest);
  }

  /// Forgets what was kept.
  void drop() { kept_ = 0; }

 private:
  std::uint8_t bytes_[kMost]{};
  std::uint16_t kept_ = 0;
};

}  // namespace finemote
