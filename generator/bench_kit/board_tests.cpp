#include "generator/bench_kit/board_tests.hpp"

#include "generator/bench_kit/bench_ports.hpp"

namespace finemote::gen {
namespace {

using namespace bench_ports;
using Tests = std::vector<BenchTest>;

/// `value`, and `ppm` parts per million to both sides.
BenchTest around(const char* group, const char* name, std::int64_t value, std::int64_t ppm, Ground ground,
                 const char* source) {
  const std::int64_t margin = value / 1'000'000 * ppm + value % 1'000'000 * ppm / 1'000'000;
  return {group, name, value - margin, value + margin, ground, source};
}

BenchTest exactly(const char* group, const char* name, std::int64_t value, Ground ground, const char* source) {
  return {group, name, value, value, ground, source};
}

BenchTest at_most(const char* group, const char* name, std::int64_t value, Ground ground, const char* source) {
  return {group, name, 0, value, ground, source};
}

constexpr const char* kFile = "clocks of the board file";

Tests tests_of_start(const Board& board) {
  constexpr std::int64_t kTrimmed = 40'000;  // ppm
  return {
      at_most("low_oscillator", "clock.lsi_start_ns", 40'000, Ground::data_sheet, "DS8626 5.3.9"),
      at_most("oscillators", "clock.crystal_start_ns", 10'000'000, Ground::assumed,
              "DS8626 5.3.8 has 2 ms as typical and no limit"),
      // By the HSI, as ST trimmed it: 4 % from -10 to 85 degrees Celsius, DS8626 5.3.9.
      around("oscillators", "clock.crystal_hz", board.clocks->crystal_hz, kTrimmed, Ground::board_file, kFile),
      at_most("oscillators", "clock.pll_lock_ns", 300'000, Ground::data_sheet, "DS8626 5.3.10"),
  };
}

Tests tests_of_clocks(const Board& board) {
  constexpr std::int64_t kCounted = 100;  // ppm
  return {
      exactly("board_clock", "clock.board_starts", 1, Ground::board_file, kFile),
      around("clocks", "clock.core_hz", board.cpu_hz, kCounted, Ground::board_file, kFile),
      {"clocks", "clock.lsi_hz", 17'000, 47'000, Ground::data_sheet, "DS8626 5.3.9"},
      {"clocks", "clock.cycles_per_1000_ticks", 1'999, 2'001, Ground::board_file,
       "apb1_timer_hz of the board file, and PM0214: the cycle counter counts every cycle of the core"},
  };
}

Tests tests_of_parts() {
  const char *const kImu = "BMI088 data sheet 5.3, 5.5", *const kCompass = "IST8310 data sheet, WAI",
                    *const kAlways = "a register that does not change";
  return {
      exactly("inertial_sensor", "bmi088.accelerometer_id", 0x1E, Ground::data_sheet, kImu),
      exactly("inertial_sensor", "bmi088.gyroscope_id", 0x0F, Ground::data_sheet, kImu),
      exactly("inertial_sensor", "bmi088.accelerometer_misreads", 0, Ground::data_sheet, kAlways),
      exactly("inertial_sensor", "bmi088.gyroscope_misreads", 0, Ground::data_sheet, kAlways),
      exactly("magnetometer", "ist8310.identity", 0x10, Ground::data_sheet, kCompass),
  };
}

Tests tests_of_core(const Board& board) {
  const std::int64_t wait_states = board.clocks->flash_wait_states;
  constexpr std::int64_t kTolerated = 100;  // cycles: what the tests themselves take
  return {
      {"sleep", "sleep.cycles_lost", 0, 0, Ground::assumed, "reported both ways; nothing here rests on it", "", false},
      at_most("sleep", "sleep.cycles_lost_with_debug_clock", kTolerated, Ground::manual, "RM0090 38.16.3"),
      exactly("sleep", "sleep.instructions_lost", 0, Ground::manual, "ES0182 says otherwise of some addresses"),
      exactly("flash", "flash.wait_cycles_per_line", wait_states, Ground::board_file, "flash_wait_states"),
      {"flash", "flash.cycles_per_100_instructions", 100, 112, Ground::manual,
       "RM0090 3.5.2: as if there were no wait states"},
      at_most("interrupt", "interrupt.entry_ns", board.costs.exception_entry.ns(), Ground::assumed, "exception_entry"),
      at_most("interrupt", "interrupt.exit_ns", board.costs.exception_exit.ns(), Ground::assumed, "exception_exit"),
  };
}

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::int64_t kRise = 300;  // ns, of SCL in fast mode: UM10204, table 10

/// At 400 kHz, three counts a bit; without the rise of the line.
std::int64_t i2c_bit_ns(const Board& board) {
  constexpr std::int64_t kParts = 3, kRate = 400'000;
  const std::int64_t clock = *board.port(kCompass)->clock_hz;
  return clock / (kParts * kRate) * kParts * kNsPerSecond / clock;
}

/// What the drivers do not rely on: each is a freedom that the manual of a chip leaves.
Tests tests_of_buses(const Board& board) {
  constexpr std::int64_t kPoll = 1'000, kFrame = 200'000;  // ns: half a bit at 328 kHz is 1.5 us; a frame at 1 Mbit/s
  constexpr std::int64_t kSeen = 200;  // ns: an iteration of the loop that looks, and four clocks of APB1
  return {
      exactly("serial", "serial.bytes_of_noise", 0, Ground::manual, "RM0090 30.3.3: an idle line brings nothing"),
      at_most("spi", "spi.busy_after_last_byte_ns", kPoll, Ground::manual, "RM0090 28.3.7, read as if at once"),
      exactly("spi", "spi.bytes_kept", 0, Ground::manual, "RM0090 28.3.8 does not say what becomes of such a byte"),
      exactly("spi", "dma.bytes_behind_count", 0, Ground::manual, "RM0090 10.3.14, read as if at once"),
      exactly("spi", "dma.flags_behind_count", 0, Ground::manual, "RM0090 10.3.14, read as if at once"),
      exactly("i2c", "i2c.late_stops", 0, Ground::manual, "RM0090 27.3.3"),
      at_most("i2c", "i2c.stop_ns", i2c_bit_ns(board) + kRise + kSeen, Ground::manual,
              "RM0090 27.3.3 and UM10204, table 10: low phase, rise and set-up time are a bit"),
      at_most("can", "can.initialisation_ns", kFrame, Ground::assumed,
              "RM0090 32.4.1 has no time; nothing is on the bus, so at most one frame's"),
  };
}

/// `bits` at the rate that a divider makes of the port's clock, to half a percent; over a jumper.
BenchTest wire_time(const char* group, const char* name, const Port& port, std::int64_t bits, std::int64_t divider,
                    const char* needs) {
  constexpr std::int64_t kTolerated = 5'000;  // ppm
  const std::int64_t ns = bits * divider * kNsPerSecond / *port.clock_hz;
  BenchTest test = around(group, name, ns, kTolerated, Ground::board_file, "clock_hz of the port, by its divider");
  test.needs = needs;
  return test;
}

BenchTest no_wrong_bytes(const char* group, const char* name, const char* needs) {
  BenchTest test = exactly(group, name, 0, Ground::manual, "what is sent comes back");
  test.needs = needs;
  return test;
}

Tests tests_of_wires(const Board& board) {
  constexpr std::int64_t kBaud = 115'200, kSpiDivider = 16;
  const Port &serial = *board.port(kSerialLoop), &spi = *board.port(kSpiLoop);
  const std::int64_t divider = (*serial.clock_hz + kBaud / 2) / kBaud;
  constexpr std::int64_t kBitsOfByte = 9, kPpm = 5'000;
  const std::int64_t i2c_least = kBitsOfByte * i2c_bit_ns(board), i2c_most = i2c_least + kBitsOfByte * kRise;
  // Identifier 0x2AA and eight bytes 0x55: 98 bits up to the checksum and none stuffed, then 13 (ISO 11898-1).
  constexpr std::int64_t kFrameBits = 98 + 13, kCanBit = 1'000;
  return {
      {"i2c_wire", "wire.i2c_byte_ns", i2c_least - i2c_least * kPpm / 1'000'000, i2c_most + i2c_most * kPpm / 1'000'000,
       Ground::board_file, "clock_hz of the port, by its divider; each clock longer by the rise of the line"},
      around("can_wire", "wire.can_frame_ns", kFrameBits * kCanBit, kPpm, Ground::board_file,
             "clock_hz of the port, by its divider"),
      no_wrong_bytes("can_wire", "wire.can_wrong_frames", ""),
      wire_time("serial_wire", "wire.serial_byte_ns", serial, 10, divider, kNeedsSerialJumper),
      no_wrong_bytes("serial_wire", "wire.serial_wrong_bytes", kNeedsSerialJumper),
      wire_time("spi_wire", "wire.spi_byte_ns", spi, 8, kSpiDivider, kNeedsSpiJumper),
      no_wrong_bytes("spi_wire", "wire.spi_wrong_bytes", kNeedsSpiJumper),
  };
}

}  // namespace

std::vector<BenchTest> board_tests(const Board& board) {
  Tests all;
  for (const Tests& some : {tests_of_start(board), tests_of_clocks(board), tests_of_parts(), tests_of_core(board),
                            tests_of_buses(board), tests_of_wires(board)})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace finemote::gen
