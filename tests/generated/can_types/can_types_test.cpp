// What descriptors of the user say of CAN, on the wire: identifiers of three forms, and a frame that two devices fill.
#include <vector>

#include "buses.hpp"
#include "catch.hpp"
#include "finemote/host.hpp"
#include "runtime/boards/host/ports/can_wire.hpp"
#include "trees/root.hpp"

using namespace finemote;
namespace robot = can_types::root;

namespace {

CanFrame frame(std::uint16_t id) {
  CanFrame frame;
  frame.id = id;
  frame.size = 8;
  return frame;
}

}  // namespace

TEST_CASE("identifiers in lists, blocks and alone arrive; two devices fill one frame with four bytes each") {
  for (const std::uint16_t id : {0x183, 0x283, 0x184, 0x05F, 0x060, 0x211}) {
    host::interrupt_at(12 * kMillisecond, [id] { host::can1.feed(now(), frame(id)); });
  }
  REQUIRE(host::run(30 * kMillisecond));

  CHECK(robot::left.state.identifier == 0x283);   // of both entries
  CHECK(robot::right.state.identifier == 0x184);  // its second one never came
  CHECK(robot::drive.state.identifier == 0x05F);  // 2 * 32 + 31; 0x060 is the next id's
  CHECK(robot::meter.state.identifier == 0x211);

  REQUIRE_FALSE(host::can1.sent.empty());
  for (const CanHardware::Sent& sent : host::can1.sent) {
    CHECK(sent.frame.id == 0x301);
    CHECK(std::vector<std::uint8_t>(sent.frame.data, sent.frame.data + sent.frame.size) ==
          std::vector<std::uint8_t>{3, 3, 3, 0xF3, 4, 4, 4, 0xF4});
  }
  CHECK(host::can1.sent.size() >= 5);  // one for every job
  CHECK(host::can1.sent.size() <= 7);
}
