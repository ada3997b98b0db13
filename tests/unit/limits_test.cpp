// The generator's figures of what the firmware holds are the runtime's.
#include "generator/descriptor/runtime_limits.hpp"

#include "catch.hpp"
#include "finemote/can.hpp"
#include "finemote/ports.hpp"
#include "finemote/rs485.hpp"
#include "finemote/schedule.hpp"
#include "generator/bus/bus_type.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace finemote {

namespace limits = gen::runtime_limits;

TEST_CASE("the generator knows what the runtime holds") {
  CHECK(limits::kPeriodTicks == kMaxPeriodTicks);
  CHECK(limits::kBuckets == kMaxBuckets);
  CHECK(gen::bus_type(gen::BusKind::can).most_shared_frames == CanBus::kGroups);
  CHECK(gen::bus_type(gen::BusKind::can).most_devices == CanBus::kMaxSlots);
  CHECK(gen::bus_type(gen::BusKind::rs485).most_devices == Rs485::kMaxSlots);
  CHECK(limits::kShortestPwmPeriod.ns() == kShortestPwmPeriod);
  CHECK(limits::kLongestPwmPeriod.ns() == kLongestPwmPeriod);
  CHECK(gen::bus_type(gen::BusKind::rs485).longest.read == Rs485Slot::kMaxReply);
}

TEST_CASE("the generator knows the level of the release") {
  const std::string text = test::read(test::source_dir() + "/runtime/chips/cortex_m4/core.hpp");
  CHECK(text.find("kReleasePriority = " + std::to_string(limits::kReleaseLevel) + ";") != std::string::npos);
}

TEST_CASE("the generator knows what the release timer and its ring hold") {
  const std::string ring = test::read(test::source_dir() + "/runtime/chips/cortex_m4/release.cpp");
  CHECK(ring.find("kSlots = " + std::to_string(limits::kReleaseInstants + 1) + ";") != std::string::npos);
  const std::string timer = test::read(test::source_dir() + "/runtime/chips/cortex_m4/registers.hpp");
  REQUIRE(timer.find("kMaxInterval = 1U << 24;") != std::string::npos);
  CHECK(limits::kTickCycles == 1 << 24);
}

TEST_CASE("the generator knows how many filters a CAN controller has") {
  const std::string text = test::read(test::source_dir() + "/runtime/chips/stm32f4/ports/can.cpp");
  CHECK(text.find("kBanks = " + std::to_string(limits::kCanFilterBanks) + ";") != std::string::npos);
}

TEST_CASE("the generator knows how often a burst is filled") {
  const std::string text = test::read(test::source_dir() + "/runtime/src/pca9685.cpp");
  CHECK(text.find("attempt < " + std::to_string(limits::kBursts) + ";") != std::string::npos);
}

TEST_CASE("the generator knows what the drivers of the chip take at once") {
  const auto figure = [](const std::string& header, const std::string& name) {
    const std::string text = test::read(test::source_dir() + "/runtime/chips/stm32f4/ports/" + header);
    const std::size_t at = text.find(" " + name + " = ");
    REQUIRE(at != std::string::npos);
    return std::stoll(text.substr(at + name.size() + 4));
  };
  CHECK(gen::bus_type(gen::BusKind::uart).longest.written == figure("uart_hardware.hpp", "kUartTransmit"));
  CHECK(gen::bus_type(gen::BusKind::rs485).longest.written == figure("uart_hardware.hpp", "kUartTransmit"));
  CHECK(gen::bus_type(gen::BusKind::spi).longest.read == figure("spi_hardware.hpp", "kSpiCopy"));
}

}  // namespace finemote
