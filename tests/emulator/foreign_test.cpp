// Programs as others build them, without FineMote's runtime: they do what their source says, and nothing is reported.
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "emulator/board.hpp"
#include "emulator/outfit/outfit.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint64_t kMs = 1'000'000;

struct Program {
  explicit Program(const std::string& name, const char* parts = R"({"schema": "finemote.scenario/1"})") {
    board.load(load_image(std::string(FINEMOTE_IMAGES) + "/" + name + ".elf"));
    outfit.add(nlohmann::ordered_json::parse(parts));
  }
  ~Program() {
    for (const Report& report : board.reports()) {
      INFO(name_of(report.misuse) << ": " << report.text << ", " << report.count << " times");
      CHECK(false);
    }
    CHECK(board.resets() == 0);
  }
  std::uint32_t word(const char* symbol, unsigned index = 0) { return board.word(symbol, 4 * index); }
  void run_ms(std::uint64_t ms) { board.run_for(ms * kMs); }

  Board board{finemote::test::type_c()};
  Outfit outfit{board};
};

}  // namespace

TEST_CASE("two tasks on process stacks take turns by PendSV, with their floating-point registers") {
  Program program("two_tasks");
  program.run_ms(200);
  const std::uint32_t first = program.word("rounds", 0), second = program.word("rounds", 1);
  CHECK(program.word("ticks") >= 195);
  CHECK(program.word("switches") >= program.word("ticks") - 10 + program.word("naps"));
  CHECK(program.word("naps") > 10);
  CHECK(first > 1000);
  CHECK(second > 1000);
  CHECK(first > second);  // it never gives time away
  CHECK(program.word("shared_rounds") >= first + second - 2);
  CHECK(program.word("wrong_stack") == 0);
  CHECK(program.word("wrong_sum") == 0);
}

TEST_CASE("a ring filled by DMA tells of its half, its end and an idle line, and an answer leaves by DMA") {
  Program program("serial_ring", R"({"schema": "finemote.scenario/1", "parts": [
    {"type": "host_terminal", "name": "far", "port": "usart6", "baud": 115200}]})");
  SerialTerminal& far = *program.outfit.terminal("far");
  program.run_ms(20);
  far.send("hello");
  program.run_ms(20);
  CHECK(far.text() == "HELLO");
  CHECK(program.word("idles") == 1);
  CHECK(program.word("halves") == 0);
  far.send("a longer line that goes around the ring of 32 bytes once more");
  program.run_ms(40);
  CHECK(far.text() == "HELLOA LONGER LINE THAT GOES AROUND THE RING OF 32 BYTES ONCE MORE");
  CHECK(program.word("taken") == 66);
  CHECK(program.word("halves") == 2);
  CHECK(program.word("ends") == 2);
  CHECK(program.word("idles") == 2);
  CHECK(program.word("sent") >= 2);
  CHECK(program.word("overruns") == 0);
}

TEST_CASE(
    "frames back to back go to the mailboxes that TSR.CODE names, reports come through FIFO 1 and their filters") {
  Program program("can_fifo", R"({"schema": "finemote.scenario/1", "parts": [
    {"type": "dji_motor", "name": "m1", "port": "can1", "id": 1, "feedback_id": 513, "command_id": 512, "word": 0,
     "torque_per_ampere": 0.015622, "rotor_inertia": 1.5e-5, "free_rotor_speed": 970, "gear": 19.2},
    {"type": "dji_motor", "name": "m2", "port": "can1", "id": 2, "feedback_id": 514, "command_id": 512, "word": 1,
     "torque_per_ampere": 0.015622, "rotor_inertia": 1.5e-5, "free_rotor_speed": 970, "gear": 19.2}]})");
  program.run_ms(200);
  CHECK(program.word("no_room") == 0);
  CHECK(program.word("sent_frames") >= 380);
  for (unsigned motor = 0; motor < 2; ++motor) CHECK(program.word("reports", motor) >= 190);
  CHECK(program.word("reports", 2) == 0);
  CHECK(program.word("filter_matches") == program.word("reports", 0) + program.word("reports", 1));
  CHECK(program.outfit.value("m1", "command") == 500);
  CHECK(program.outfit.value("m2", "commands") >= 190);
  CHECK(program.outfit.value("m1", "speed") > 0);
}

TEST_CASE("a program erases and programs its own flash, and stands still meanwhile") {
  Program program("self_programming");
  program.run_ms(1'200);
  CHECK(program.word("errors") == 0);
  CHECK(program.word("before_erase") == 0xFFFFFFFF);
  CHECK(program.word("after_erase") == 0xFFFFFFFF);
  CHECK(program.word("erase_ms") <= 2);  // the tick is not served while the core waits for the flash: at most one pends
  for (unsigned i = 0; i < 4; ++i) CHECK(program.word("programmed", i) == 0x11111111 * (i + 1));
  CHECK(program.word("bytes_programmed") == 0x5A);
  CHECK(program.word("is_locked") == 1);
}

TEST_CASE("what a generated start touches answers: clock, numbers, checksum, converters, timers, buses, USB") {
  Program program("set_up", R"({"schema": "finemote.scenario/1", "events": [
    {"t_ns": 0, "port": "adc3", "do": "volts", "input": 8, "volts": 2.378}]})");
  program.run_ms(100);
  CHECK(program.word("laps") > 1000);
  CHECK(program.word("seconds") == 0x30);
  CHECK(program.word("backup") == 0x32F2);
  CHECK(program.word("random_words", 0) != program.word("random_words", 1));
  CHECK(program.word("checksum") == 0xDF8A8A2B);                // of one word, CRC-32/MPEG-2
  CHECK(program.word("temperature") == Approx(943).margin(3));  // 0.76 V at 25 degrees Celsius: DS8626 5.3.22
  CHECK(program.word("reference") == Approx(1501).margin(3));   // 1.21 V: 5.3.24
  CHECK(program.word("battery") == Approx(2951).margin(3));
  CHECK(program.word("dac_code") == 2048);
  CHECK(program.word("updates") == 3);
  CHECK(program.word("encoder") == 0);
  CHECK(program.word("i2c_absent") == 1);
  CHECK(program.word("spi_answer") == 0xFF);
  CHECK(program.word("usb_interrupts") == 0);
}

TEST_CASE("compass and IMU answer to polling, in reads of one, two, three and six bytes") {
  Program program("on_board", R"({"schema": "finemote.scenario/1", "parts": [
    {"type": "bmi088", "name": "imu", "port": "spi1", "channel": 0, "gyro": 1},
    {"type": "ist8310", "name": "compass", "port": "i2c3", "field": [30e-6, -15e-6, 0]}]})");
  program.run_ms(500);
  CHECK(program.word("timeouts") == 0);
  CHECK(program.word("accelerometer_identity") == 0x1E);
  CHECK(program.word("gyroscope_identity") == 0x0F);
  CHECK(program.word("compass_identity") == 0x10);
  CHECK(program.word("compass_pair") == 0x080B);  // CNTL1, CNTL2
  CHECK(program.word("compass_three") == 0x080B);
  CHECK(program.word("ready_edges") >= 30);
  CHECK(program.word("field") == 0x00320064);  // 100 and 50 steps of 0.3 uT: its y axis points to the right
  CHECK(program.word("rounds") > 1000);
  CHECK(program.word("acceleration", 1) >> 16 == 0);                            // nothing read beyond the six bytes
  CHECK((program.word("acceleration", 1) & 0xFFFF) == Approx(5461).margin(5));  // 1 g of 6: the z axis
}

TEST_CASE("a remote control's frames go to two buffers in turn, and an idle line ends each") {
  Program program("remote", R"({"schema": "finemote.scenario/1",
    "parts": [{"type": "dbus_receiver", "name": "remote", "port": "usart3", "baud": 100000, "even_parity": true}],
    "events": [{"t_ns": 100000000, "part": "remote", "do": "move", "right_x": 0.5, "left_switch": "up"}]})");
  program.run_ms(400);
  CHECK(program.word("frames", 0) >= 12);
  CHECK(program.word("frames", 1) >= 12);
  CHECK(program.word("odd_lengths") <= 1);  // what was already on its way
  CHECK(program.word("channel") == Approx(1024 + 330).margin(2));
}

TEST_CASE("lights, sounder and heater show what timers and plain pins do with them, and a key interrupts") {
  Program program("panel", R"({"schema": "finemote.scenario/1",
    "parts": [{"type": "load", "name": "blue", "port": "led_blue"}, {"type": "load", "name": "green", "port": "led_green"},
              {"type": "load", "name": "buzzer", "port": "buzzer"},
              {"type": "bmi088", "name": "imu", "port": "spi1", "channel": 0, "gyro": 1, "heater": {"port": "imu_heater"}},
              {"type": "button", "name": "key", "pin": "PA0"}],
    "events": [{"t_ns": 100000000, "part": "key", "do": "press"}, {"t_ns": 250000000, "part": "key", "do": "release"}]})");
  program.run_ms(200);
  CHECK(program.outfit.value("blue", "share") == Approx(0.25).margin(0.001));
  CHECK(program.outfit.value("blue", "frequency") == Approx(1000).margin(0.1));
  CHECK(program.outfit.value("green", "share") == 1);
  CHECK(program.outfit.value("green", "frequency") == 0);
  CHECK(program.outfit.value("buzzer", "frequency") == Approx(2000).margin(0.1));
  CHECK(program.outfit.value("key", "pressed") == 1);
  program.run_ms(200);
  CHECK(program.outfit.value("green", "mean") == Approx(0.375).margin(0.001));  // 150 of 400 ms
  CHECK(program.outfit.value("green", "times_on") == 1);
  CHECK(program.outfit.value("buzzer", "share") == 0);  // its timer runs, but no longer has the pin
  CHECK(program.outfit.value("imu", "heat") == Approx(0.5).margin(0.001));
  CHECK(program.word("presses") == 1);
  CHECK(program.word("releases") == 1);
  CHECK(program.word("periods") >= 390);
}
