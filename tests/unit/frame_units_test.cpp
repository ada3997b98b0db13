// What a driver is asked for at once, and how often a device has to ask for all that its frames say.
#include "generator/tasks/frame_units.hpp"

#include "catch.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

Frame frame(FrameStage stage, std::int64_t write, std::int64_t read, int unit = 0) {
  Frame made;
  made.stage = stage;
  made.write_bytes = write;
  made.read_bytes = read;
  made.unit = unit;
  return made;
}

std::int64_t turns(BusKind kind, const std::vector<Frame>& frames) { return turns_of(frame_units(frames, kind)); }

constexpr FrameStage kUpdate = FrameStage::update, kHandle = FrameStage::handle;

}  // namespace

TEST_CASE("each entry is a request, whichever stage begins it") {
  for (const BusKind kind : {BusKind::i2c, BusKind::spi, BusKind::rs485, BusKind::uart, BusKind::can}) {
    CHECK(turns(kind, {frame(kUpdate, 2, 0)}) == 1);
    CHECK(turns(kind, {frame(kUpdate, 2, 0), frame(kUpdate, 2, 2)}) == 2);
    CHECK(turns(kind, {frame(kUpdate, 2, 2), frame(kHandle, 2, 0), frame(kHandle, 1, 0)}) == 3);
    CHECK(turns(kind, {frame(FrameStage::autonomous, 0, 8), frame(FrameStage::flush, 8, 0)}) == 0);
  }
}

TEST_CASE("I2C alone takes an exchange and what is written behind it as one") {
  CHECK(turns(BusKind::i2c, {frame(kUpdate, 1, 2, 1), frame(kUpdate, 2, 0, 1)}) == 1);
  CHECK(turns(BusKind::i2c, {frame(kUpdate, 1, 2, 1), frame(kUpdate, 2, 0, 1), frame(kUpdate, 2, 0, 1)}) == 2);
  CHECK(turns(BusKind::i2c, {frame(kUpdate, 1, 2, 1), frame(kUpdate, 1, 2, 1)}) == 2);
  CHECK(turns(BusKind::spi, {frame(kUpdate, 7, 7, 1), frame(kUpdate, 3, 3, 1)}) == 2);
  CHECK(turns(BusKind::can, {frame(kHandle, 8, 0, 1), frame(kHandle, 8, 0, 1)}) == 2);
}

TEST_CASE("what is longer than a CAN frame is several of them, and an answer needs no request") {
  CHECK(turns(BusKind::can, {frame(kHandle, 40, 0)}) == 5);
  CHECK(turns(BusKind::can, {frame(kHandle, 0, 8)}) == 0);
  CHECK(turns(BusKind::i2c, {frame(kHandle, 0, 8)}) == 1);
}

TEST_CASE("SPI brings something with all that it sends") {
  const auto only = [](BusKind kind, std::int64_t write, std::int64_t read) {
    return frame_units({frame(kUpdate, write, read)}, kind).front();
  };
  CHECK((only(BusKind::spi, 7, 0).reads && only(BusKind::spi, 7, 0).writes && !only(BusKind::spi, 7, 0).sets));
  CHECK((!only(BusKind::i2c, 7, 0).reads && only(BusKind::i2c, 7, 0).sets));
  CHECK((only(BusKind::i2c, 7, 1).reads && !only(BusKind::i2c, 7, 1).sets));
}
