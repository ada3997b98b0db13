// Keeps the bytes of a stream that may still become a frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace finemote {

/// Bytes come in at the end and leave at the front, side by side in memory, `longest` of them at most. They are moved
/// only once in `longest` bytes: garbage costs no more than frames do.
template <std::size_t longest>
class ByteWindow {
 public:
  void push(std::uint8_t byte) { append(&byte, 1); }  ///< takes in one byte at the end
  /// Takes in `count` bytes at the end; with those that are there at most `longest`.
  void append(const std::uint8_t* bytes, std::size_t count) {
    if (end_ + count > sizeof bytes_) make_room();
    for (const std::uint8_t* last = bytes + count; bytes != last; ++bytes) bytes_[end_++] = *bytes;
  }

  /// Takes in a byte that goes on with the two that a frame begins with. What does not is left behind.
  void begin(std::uint8_t byte, std::uint8_t first, std::uint8_t second) {
    if (size() == 1) {
      if (byte == first) return;
      if (byte == second) return push(byte);
      drop(1);
    }
    if (byte == first) push(byte);
  }

  /// Takes `count` bytes away at the front, at most size(). They can be read until the next push().
  void drop(std::size_t count) { begin_ += count; }

  /// Takes the first byte away and all that follow up to the next `head`.
  void drop_to_next(std::uint8_t head) {
    do {
      ++begin_;
    } while (begin_ < end_ && bytes_[begin_] != head);
  }

  [[nodiscard]] std::uint8_t operator[](std::size_t at) const { return bytes_[begin_ + at]; }  ///< `at` < size()
  [[nodiscard]] const std::uint8_t* data() const { return bytes_ + begin_; }  ///< the first of size() bytes
  [[nodiscard]] std::size_t size() const { return end_ - begin_; }            ///< bytes there are

 private:
  void make_room() {
    std::memmove(bytes_, data(), size());
    end_ = size();
    begin_ = 0;
  }

  std::uint8_t bytes_[2 * longest]{};
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace finemote
