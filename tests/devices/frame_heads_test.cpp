// Places at which frames may begin, against a look at every byte; bytes moved four at a time.
#include <random>
#include <vector>

#include "catch.hpp"
#include "finemote/four_bytes.hpp"
#include "runtime/devices/frame_heads.hpp"

using namespace finemote;

namespace {

constexpr std::uint8_t kFirst = 0xA5, kSecond = 0x5A;
constexpr std::size_t kMost = 100;
using Bytes = std::vector<std::uint8_t>;

std::size_t first_from(const Bytes& bytes, std::size_t from) {
  for (std::size_t at = from; at < bytes.size(); ++at) {
    if (bytes[at] == kFirst && (at + 1 == bytes.size() || bytes[at + 1] == kSecond)) return at;
  }
  return FrameHeads<kMost>::kNone;
}

}  // namespace

TEST_CASE("the next place at which a frame may begin is the same that a look at every byte finds") {
  std::mt19937 dice(11);
  const std::uint8_t drawn[] = {kFirst, kSecond, kFirst, kSecond, 0x00, 0xFF, 0xA4, 0x5B, 0x25, 0xDA};
  for (int round = 0; round < 3000; ++round) {
    Bytes bytes(dice() % (kMost + 1));
    for (std::uint8_t& byte : bytes) byte = drawn[dice() % sizeof drawn];
    const std::size_t shift = dice() % 4;  // where in a word they begin
    Bytes placed(shift, kFirst);
    placed.insert(placed.end(), bytes.begin(), bytes.end());
    placed.push_back(kSecond);  // after the last byte: not theirs
    const FrameHeads<kMost> heads(placed.data() + shift, bytes.size(), kFirst, kSecond);
    for (std::size_t from = 0; from < bytes.size(); ++from) REQUIRE(heads.next(from) == first_from(bytes, from));
  }
}

TEST_CASE("bytes are moved to lower addresses, wherever they lie and overlap") {
  std::mt19937 dice(12);
  for (int round = 0; round < 1000; ++round) {
    Bytes bytes(64);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(dice());
    const std::size_t to = dice() % 8, from = to + dice() % 8, size = dice() % 48;
    Bytes expected = bytes;
    for (std::size_t i = 0; i < size; ++i) expected[to + i] = bytes[from + i];
    move_bytes(bytes.data() + from, bytes.data() + to, size);
    REQUIRE(bytes == expected);
  }
}
