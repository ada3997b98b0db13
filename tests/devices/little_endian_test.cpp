// Numbers out of bytes, and bytes out of numbers, the lowest first.
#include "runtime/devices/little_endian.hpp"

#include <vector>

#include "catch.hpp"

using namespace finemote;

TEST_CASE("the first byte is the lowest, wherever it lies") {
  const std::uint8_t bytes[] = {0xAA, 0x01, 0xFF, 0x80, 0xFE};
  CHECK(uint16_at(bytes + 1) == 0xFF01);
  CHECK(int16_at(bytes + 1) == -255);
  CHECK(uint24_at(bytes + 1) == 0x80FF01);
  CHECK(int32_at(bytes + 1) == static_cast<std::int32_t>(0xFE80FF01U));
}

TEST_CASE("eleven bits begin at any bit") {
  for (unsigned at = 0; at < 24; ++at) {
    std::uint8_t bytes[5] = {};
    for (const unsigned bit : {0U, 3U, 10U}) bytes[(at + bit) / 8] |= static_cast<std::uint8_t>(1U << (at + bit) % 8);
    CAPTURE(at);
    CHECK(eleven_bits_at(bytes, at) == 0x409);
  }
}

TEST_CASE("what is written is read again, and nothing beside it") {
  std::uint8_t bytes[8] = {};
  put_uint16(0xFEDC, bytes + 1);
  put_uint32(0x89ABCDEF, bytes + 3);
  CHECK(std::vector<std::uint8_t>(bytes, bytes + 8) ==
        std::vector<std::uint8_t>{0, 0xDC, 0xFE, 0xEF, 0xCD, 0xAB, 0x89, 0});
}
