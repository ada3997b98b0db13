// A motor on each CAN bus, written by hand: every millisecond a command word in the group frame 0x200, and what the
// motor answered with 0x201.
#include <finemote/can.hpp>
#include <finemote/constinit.hpp>
#include <finemote/schedule.hpp>

extern "C" {
void finemote_line_48();
/// Milliseconds between two looks at the buses: set by the test.
std::uint32_t supervised_every = 1;
/// Read by the test: frames received on CAN1, its last first byte; the same for CAN2; milliseconds; off the bus,
/// transmit errors and recoveries of CAN1.
std::uint32_t seen[8];
}

namespace can_image {

namespace slots {
extern finemote::CanSlot left, right;
}
namespace {
finemote::CanSlot* const left_slots[] = {&slots::left};
finemote::CanSlot* const right_slots[] = {&slots::right};
}  // namespace
FINEMOTE_CONSTINIT finemote::CanBus left_bus{finemote::ports::can1, 1000000, left_slots};
FINEMOTE_CONSTINIT finemote::CanBus right_bus{finemote::ports::can2, 500000, right_slots};
namespace slots {
FINEMOTE_CONSTINIT finemote::CanSlot left{
    left_bus, 1, 0x201, finemote::CanSlot::kAnyTime, 1, finemote::CanShare{0x200, 0, 2}};
FINEMOTE_CONSTINIT finemote::CanSlot right{
    right_bus, 1, 0x201, finemote::CanSlot::kAnyTime, 1, finemote::CanShare{0x200, 6, 2}};
}  // namespace slots

void put_word(finemote::CanSlot& slot, std::int16_t word) {
  const std::uint8_t bytes[]{static_cast<std::uint8_t>(static_cast<std::uint16_t>(word) >> 8),
                             static_cast<std::uint8_t>(word & 0xFF)};
  slot.set_shared(bytes);
}

void run_1ms() {
  if (seen[4] % supervised_every == 0) {
    left_bus.supervise();
    right_bus.supervise();
  }
  const auto from_left = slots::left.received(), from_right = slots::right.received();
  seen[0] = from_left.count;
  seen[1] = from_left.frame.data[0];
  seen[2] = from_right.count;
  seen[3] = from_right.frame.data[0];
  ++seen[4];
  seen[5] = left_bus.unreachable() ? 1 : 0;
  seen[6] = left_bus.transmit_errors();
  seen[7] = left_bus.counters().recoveries;
  put_word(slots::left, static_cast<std::int16_t>(seen[4]));
  put_word(slots::right, -1234);
  left_bus.flush();
  right_bus.flush();
}

void start_buses() {
  left_bus.start();
  right_bus.start();
}
void safe_outputs() {}
bool buses_quiet() {
  const bool is_left_quiet = left_bus.quiet();
  return right_bus.quiet() && is_left_quiet;
}

namespace {
constexpr finemote::Bucket buckets[] = {{finemote_line_48, 1'000'000, 48, 4, 3}};
}

}  // namespace can_image

extern "C" void finemote_line_48() {
  can_image::run_1ms();
  finemote::complete(0);
}
extern "C" const finemote::Schedule finemote_schedule{"can",
                                                      1'000'000,
                                                      can_image::buckets,
                                                      finemote::Overrun::skip,
                                                      can_image::start_buses,
                                                      can_image::safe_outputs,
                                                      nullptr,
                                                      can_image::buses_quiet};
