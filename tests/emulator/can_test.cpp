// CAN: the wire's arithmetic, the driver against nodes, a lost and regained bus.
#include <algorithm>

#include "catch.hpp"
#include "emulator/board.hpp"
#include "tests/emulator/tested_chip.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint64_t kMs = 1'000'000;

/// Answers every group frame with its own identifier, and remembers what it was told.
struct Motor {
  explicit Motor(CanLine& bus) : line(bus) {
    line.attach(CanLine::Node{[this] { return answer; },
                              [this](const CanFrame&, CanOutcome outcome) {
                                if (outcome == CanOutcome::received) answer.reset();
                              },
                              [this](const CanFrame& frame) { hear(frame); }});
  }
  void hear(const CanFrame& frame) {
    heard.push_back(frame);
    answer = CanFrame{id, 8, {0x5A, 1, 2, 3, 4, 5, 6, 7}};
    line.request();
  }
  CanLine& line;
  std::uint32_t id = 0x201;
  std::optional<CanFrame> answer;
  std::vector<CanFrame> heard;
};

struct Bench {
  Bench() {
    board.load(load_image(std::string(FINEMOTE_IMAGES) + "/can.elf"));
    finemote::test::run_to_first_release(board);
  }
  std::uint32_t seen(unsigned index) { return board.word("seen", 4 * index); }
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  Motor left{board.chip().can("can1")->line}, right{board.chip().can("can2")->line};
};

/// Sends frames one after the other.
struct Talker {
  Talker(Board& from, CanLine& bus, unsigned frames) : board(from), left(frames) {
    bus.attach(CanLine::Node{[this] {
                               return left > 0 ? std::optional(CanFrame{0x701, 8, {}}) : std::nullopt;
                             },
                             [this](const CanFrame&, CanOutcome) {
                               --left;
                               ended_at = board.now_ns();
                             },
                             {}});
    bus.request();
  }
  Board& board;
  unsigned left;
  std::uint64_t ended_at = 0;
};

/// When the first release came where others send a number of frames on the buses from the beginning, one after the
/// other.
struct TalkedOver {
  TalkedOver(unsigned left_frames, unsigned right_frames)
      : left(board, board.chip().can("can1")->line, left_frames),
        right(board, board.chip().can("can2")->line, right_frames) {
    board.load(load_image(std::string(FINEMOTE_IMAGES) + "/can.elf"));
    finemote::test::run_to_first_release(board);
  }
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  Talker left, right;
};

}  // namespace

TEST_CASE("a frame's bits are counted with their stuffing") {
  // 44 bits for a frame without data, 8 per byte, and 3 of intermission; stuffing adds at most (34 + 8 n - 1) / 4.
  const unsigned empty = can_frame_bits(CanFrame{0x555, 0, {}});
  CHECK(empty >= 47);
  CHECK(empty <= 47 + 8);
  const unsigned zeros = can_frame_bits(CanFrame{0, 8, {}});
  CHECK(zeros > 111 + 15);
  CHECK(zeros <= 111 + 24);
  CHECK(can_frame_bits(CanFrame{0x2AA, 8, {0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55}}) <= 111 + 5);
}

TEST_CASE("commands go out every millisecond on both buses, answers come in, and nothing is used wrongly") {
  Bench bench;
  bench.board.run_for(110 * kMs);
  CHECK(bench.left.heard.size() >= 100);
  CHECK(bench.right.heard.size() >= 100);
  const CanFrame& last = bench.left.heard.back();
  CHECK(last.id == 0x200);
  CHECK(last.size == 8);
  CHECK(bench.seen(4) - (last.data[0] * 256U + last.data[1]) <= 1);
  CHECK(bench.right.heard.back().data[6] * 256 + bench.right.heard.back().data[7] == 0x10000 - 1234);
  CHECK(bench.left.heard.size() - bench.seen(0) <= 2);
  CHECK(bench.seen(1) == 0x5A);
  CHECK(bench.right.heard.size() - bench.seen(2) <= 2);
  for (const Report& report : bench.board.reports()) {
    INFO(name_of(report.misuse) << ": " << report.text);
    CHECK(false);
  }
}

TEST_CASE("identifiers nobody asked for are filtered in hardware") {
  Bench bench;
  bench.left.id = 0x202;
  bench.board.run_for(50 * kMs);
  CHECK(bench.left.heard.size() > 40);
  CHECK(bench.seen(0) == 0);
  CHECK(bench.board.world().system().nvic().times_entered(16 + 20) == 0);  // not even an interrupt
}

TEST_CASE("a disturbed bus goes off and comes back, with zero as the first command") {
  Bench bench;
  bench.board.run_for(50 * kMs);
  Can& can = *bench.board.chip().can("can1");
  can.line.disturbed_frames = 40;
  bench.left.heard.clear();
  bool was_off = false;
  for (int i = 0; i < 40; ++i) {
    bench.board.run_for(kMs);
    was_off = was_off || can.bus_off();
  }
  CHECK(was_off);
  CHECK(!can.bus_off());
  REQUIRE(!bench.left.heard.empty());
  bool zero = true;
  for (const std::uint8_t byte : bench.left.heard.front().data) zero = zero && byte == 0;
  CHECK(zero);
  const std::size_t before = bench.left.heard.size();
  bench.board.run_for(20 * kMs);
  CHECK(bench.left.heard.size() >= before + 19);
}

TEST_CASE("a bus that others keep busy is regained after 128 frames, and old commands do not leave then") {
  Bench bench;
  bench.board.run_for(50 * kMs);
  Can& can = *bench.board.chip().can("can1");
  can.line.disturbed_frames = 40;
  for (int i = 0; i < 400 && !can.bus_off(); ++i) bench.board.run_for(kMs / 10);
  REQUIRE(can.bus_off());
  can.line.disturbed_frames = 0;
  bench.left.heard.clear();
  const Talker talker(bench.board, can.line, 1000);
  bench.board.run_for(10 * kMs);
  CHECK(can.bus_off());
  std::vector<CanFrame> commands;
  for (int i = 0; i < 300 && commands.size() < 4; ++i) {
    bench.board.run_for(kMs / 10);
    commands.clear();
    for (const CanFrame& frame : bench.left.heard)
      if (frame.id == 0x200) commands.push_back(frame);
  }
  REQUIRE(commands.size() == 4);
  CHECK(bench.seen(7) == 1);  // recoveries
  const auto value = [](const CanFrame& frame) { return frame.data[0] * 256U + frame.data[1]; };
  CHECK(value(commands[0]) == 0);
  for (std::size_t i = 1; i < commands.size(); ++i) CHECK(bench.seen(4) - value(commands[i]) <= 8);
}

TEST_CASE("failed frames are counted by the controller, and good ones count down") {
  Bench bench;
  bench.board.run_for(50 * kMs);
  CHECK(bench.seen(6) == 0);
  bench.board.chip().can("can1")->line.disturbed_frames = 6;
  bench.board.run_for(3 * kMs);
  const auto errors = bench.seen(6);
  CHECK(errors > 40);
  CHECK(errors <= 48);
  CHECK(bench.seen(5) == 0);
  bench.board.run_for(60 * kMs);
  CHECK(bench.seen(6) == 0);
  CHECK(bench.seen(7) == 0);
}

TEST_CASE("a bus that is lost again before anybody looks is recovered all the same") {
  Bench bench;
  bench.board.run_for(50 * kMs);
  bench.board.set_word("supervised_every", 20);
  Can& can = *bench.board.chip().can("can1");
  can.line.disturbed_frames = 200;  // six times off the bus
  bench.board.run_for(600 * kMs);
  CHECK(can.line.disturbed_frames == 0);
  CHECK(!can.bus_off());
  CHECK(bench.seen(5) == 0);
  CHECK(bench.seen(7) >= 5);
  bench.left.heard.clear();
  bench.board.run_for(20 * kMs);
  CHECK(bench.left.heard.size() >= 19);
}

TEST_CASE("a bus nobody acknowledges on stays on, and the first frame after that is a fresh one") {
  Bench bench;
  bench.board.run_for(50 * kMs);
  Can& can = *bench.board.chip().can("can1");
  can.line.cut = true;
  bench.board.run_for(500 * kMs);
  CHECK(!can.bus_off());
  CHECK(bench.seen(6) == 128);  // error passive, and no further: ISO 11898-1
  CHECK(bench.seen(7) == 0);
  can.line.cut = false;
  bench.left.heard.clear();
  const std::uint32_t at = bench.seen(4);
  bench.board.run_for(20 * kMs);
  REQUIRE(bench.left.heard.size() >= 19);
  const auto& first = bench.left.heard.front();
  CHECK(static_cast<std::uint32_t>(first.data[0] * 256 + first.data[1]) + 2 >= at);
  CHECK(bench.seen(6) < 128);
}

TEST_CASE("an empty bus stops nothing") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.load(load_image(std::string(FINEMOTE_IMAGES) + "/can.elf"));
  finemote::test::run_to_first_release(board);
  REQUIRE(board.run_for(50 * kMs) == Stop::time);
  CHECK(board.word("seen", 16) >= 40);
}

TEST_CASE("the first release waits until no frame of others waits on any bus") {
  TalkedOver start(400, 150);  // for longer than the slowest chip takes to start
  CHECK(start.left.left == 0);
  CHECK(start.right.left == 0);
  const std::uint64_t last = std::max(start.left.ended_at, start.right.ended_at);
  CHECK(start.board.now_ns() > last);
  CHECK(start.board.now_ns() < last + 2 * kMs);
}

TEST_CASE("a bus that never falls silent holds the first release up for a tenth of a second") {
  TalkedOver silent(0, 0), loud(10'000, 0);
  CHECK(loud.left.left > 0);
  CHECK(loud.board.now_ns() > silent.board.now_ns() + 95 * kMs);
  CHECK(loud.board.now_ns() < silent.board.now_ns() + 110 * kMs);
}
