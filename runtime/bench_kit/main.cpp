// main of the bench kit: the groups of tests one after the other, then the record, again and again.
#include <cstdint>

#include "finemote/board.hpp"
#include "finemote/fault.hpp"
#include "groups.hpp"
#include "record.hpp"
#include "report.hpp"
#include "runtime/chips/cortex_m4/fault.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

/// Every group takes less; the watchdog resets the board after at least this and at most four times as much.
constexpr Duration kLongestGroup = 3 * kSecond;
constexpr std::uint32_t kPauseUs = 2'000'000;

/// Whether a test of an earlier group has a value.
bool has(Test test) { return entry(static_cast<unsigned>(test)).missing == Missing::nothing; }

/// Fails by waiting for the watchdog: then the board is known to run on its reset clock.
void start_board() {
  if (!has(Test::clock_crystal_start_ns)) return miss(Test::clock_board_starts, Missing::clock);
  board::start_hardware();
  put(Test::clock_board_starts, 1);
}

struct Procedure {
  Group group;
  void (*run)();
};
constexpr Procedure kProcedures[] = {
    {Group::low_oscillator, time_low_oscillator},
    {Group::oscillators, time_oscillators},
    {Group::board_clock, start_board},
    {Group::clocks, measure_clocks},
    {Group::inertial_sensor, ask_inertial_sensor},
    {Group::magnetometer, ask_magnetometer},
    {Group::sleep, measure_sleep},
    {Group::flash, measure_flash},
    {Group::interrupt, measure_interrupt},
    {Group::serial, listen_to_silence},
    {Group::spi, watch_spi},
    {Group::i2c, watch_i2c},
    {Group::can, watch_can},
    {Group::i2c_wire, measure_i2c_wire},
    {Group::can_wire, measure_can_wire},
    {Group::serial_wire, measure_serial_wire},
    {Group::spi_wire, measure_spi_wire},
    {Group::robot, measure_robot},
};
static_assert(sizeof kProcedures / sizeof kProcedures[0] == kGroupCount);

void miss_group(Group group) {
  for (unsigned i = 0; i < kTestCount; ++i) {
    if (kTests[i].group == group) miss(static_cast<Test>(i), Missing::clock);
  }
}

void run(const Procedure& it) {
  enter_group(it.group);
  board::feed_watchdog();
  if (it.group <= Group::board_clock || has(Test::clock_board_starts)) return it.run();
  miss_group(it.group);
}

/// Every procedure from `first` on. Those before it were done when something reset the board.
void run_from(unsigned first) {
  if (first == 0) run(kProcedures[first++]);  // before the watchdog, which turns the LSI on
  board::start_watchdog(kLongestGroup);
  if (first > static_cast<unsigned>(Group::board_clock) && has(Test::clock_board_starts)) board::start_hardware();
  for (unsigned i = first; i < kGroupCount; ++i) run(kProcedures[i]);
  board::start_watchdog(kLongestGroup);  // the releases of the robot had it for themselves
  end_record();
}

[[noreturn]] void report_for_ever() {
  const bool runs = has(Test::clock_board_starts);
  write_report();
  for (;;) {
    board::feed_watchdog();
    send_report(runs ? kReportBusHz : kResetHz);
    const Stopwatch watch;
    while (!watch.has_passed(cycles_in(kPauseUs, runs ? kCoreHz : kResetHz))) {}
  }
}

}  // namespace
}  // namespace finemote::bench_kit

/// What the runtime does where it cannot go on: here it waits for the watchdog, and the next group begins.
[[noreturn]] void finemote::stop_safely(Module module, std::uint8_t number, const char*) {
  count_fault(module, number);
  for (;;) asm volatile("");
}

int main() {
  using namespace finemote;
  using namespace finemote::bench_kit;
  const unsigned first = begin_record();
  cortex_m4::start_guards();
  cortex_m4::start_cycles(0);
  run_from(first);
  report_for_ever();
}
