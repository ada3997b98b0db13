// RS-485: one question at a time, replies of the right length, silence.
#include "finemote/rs485.hpp"

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "runtime/src/start.hpp"

namespace {

using namespace finemote;

struct Fixture {
  Fixture() {
    bench::reset();
    bus.start();
  }
  Rs485Slot one{bus, 1, 1}, two{bus, 2, 2};
  Rs485Slot* const table[2] = {&one, &two};
  std::uint8_t ring[64];
  Rs485 bus{ports::usart1, 115200, ring, table};
  const std::uint8_t question[4] = {0x3E, 1, 2, 3};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "questions go one after the other, each with its reply") {
  two.start(question, 4, 3);
  one.start(question, 2, 2);
  host::usart1.feed(1 * kMillisecond, std::vector<std::uint8_t>{0x11, 0x12, 0x13});
  host::usart1.feed(3 * kMillisecond, std::vector<std::uint8_t>{0x21, 0x22});
  host::advance(2 * kMillisecond);
  CHECK(two.state() == SlotState::kDone);
  CHECK(two.reply()[0] == 0x11);
  CHECK(two.reply()[2] == 0x13);
  CHECK(one.busy());
  host::advance(2 * kMillisecond);
  CHECK(one.state() == SlotState::kDone);
  CHECK(one.reply()[1] == 0x22);
  CHECK(host::usart1.sent.size() == 2);
}

TEST_CASE_METHOD(Fixture, "no reply in time fails; three in a row are unreachable; the others go on") {
  for (int i = 0; i < 3; ++i) {
    CHECK_FALSE(one.unreachable());
    one.start(question, 4, 4);
    host::advance(10 * kMillisecond);
    CHECK(one.state() == SlotState::kNack);
  }
  CHECK(one.unreachable());
  two.start(question, 4, 1);
  host::usart1.feed(now() + kMillisecond, std::vector<std::uint8_t>{0x55});
  host::advance(5 * kMillisecond);
  CHECK(two.state() == SlotState::kDone);
  CHECK(bus.counters().errors == 3);
}

TEST_CASE_METHOD(Fixture, "behind a stop each question that waits goes out once, and the line goes on") {
  one.start(question, 2, 2);
  two.start(question, 4, 3);
  detail::set_stopped(true);
  for (int ms = 0; ms < 20; ++ms) {
    bus.supervise();
    host::advance(kMillisecond);
  }
  CHECK(one.state() == SlotState::kNack);
  CHECK(two.state() == SlotState::kNack);
  CHECK(host::usart1.sent.size() == 2);
  CHECK(one.start(question, 3, 1));
  CHECK(host::usart1.sent.size() == 3);
}
