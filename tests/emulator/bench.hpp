// An emulated board without an image to speak of: tests use its registers as a driver would, or a few instructions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emulator/board.hpp"
#include "tests/emulator/type_c.hpp"

namespace finemote::emulator {

/// Thumb instructions, by halfwords.
using Code = std::vector<std::uint16_t>;

constexpr std::uint16_t kNop = 0xBF00, kReturn = 0x4770;
/// What every routine begins with: loads r0 to r3 from the four words of `bench_image`.
inline const Code kLoadWords = {0xF85F, 0x0014, 0xF85F, 0x1014, 0xF85F, 0x2014, 0xF85F, 0x3014};

inline Code operator+(Code first, const Code& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

/// Every exception goes to `b .`, but `exception` to `routine`, which r0 to r3 find holding `words`; exception 1 is the
/// reset.
inline Image bench_image(std::size_t exception = 0, const Code& routine = {},
                         const std::vector<std::uint32_t>& words = {}) {
  constexpr std::size_t kIdle = 0x188, kWords = 0x1F0, kRoutine = 0x200;
  Segment segment{0x08000000, std::vector<std::uint8_t>(0x400, 0)};
  const auto put = [&](std::size_t at, std::uint32_t value, unsigned bytes) {
    for (unsigned i = 0; i < bytes; ++i) segment.bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
  };
  put(0, 0x20001000, 4);
  for (std::size_t at = 4; at < kIdle; at += 4) put(at, 0x08000000 + kIdle + 1, 4);
  put(kIdle, 0xE7FEE7FE, 4);
  if (exception != 0) put(4 * exception, 0x08000000 + kRoutine + 1, 4);
  for (std::size_t i = 0; i < words.size(); ++i) put(kWords + 4 * i, words[i], 4);
  const Code all = kLoadWords + routine;
  for (std::size_t i = 0; i < all.size(); ++i) put(kRoutine + 2 * i, all[i], 2);
  Image image;
  image.segments.push_back(segment);
  return image;
}

struct Bench {
  explicit Bench(const Image& image = bench_image()) {
    board.load(image);
    board.run_for(1'000);
  }
  std::uint32_t read(std::uint32_t address) { return board.chip().read(address, 4); }
  void write(std::uint32_t address, std::uint32_t value) { board.chip().write(address, 4, value); }
  /// A register of the core.
  void write_core(std::uint32_t address, std::uint32_t value) {
    board.world().system().write(address, 4, value, board.world().now(), 0);
  }
  std::uint32_t read_core(std::uint32_t address) {
    return board.world().system().read(address, 4, board.world().now(), 0);
  }
  void enable_line(int line) { write_core(0xE000E100 + 4 * static_cast<std::uint32_t>(line / 32), 1U << (line % 32)); }
  [[nodiscard]] unsigned entered(int line) { return board.world().system().nvic().times_entered(16 + line); }
  /// What was started by registers takes its time.
  void run(std::uint64_t ns) { board.run_for(ns); }
  [[nodiscard]] bool reported(Misuse misuse) const {
    for (const Report& report : board.reports()) {
      if (report.misuse == misuse) return true;
    }
    return false;
  }
  Board board{finemote::test::type_c()};
};

}  // namespace finemote::emulator
