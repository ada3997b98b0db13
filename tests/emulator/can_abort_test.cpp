// Taking back what a mailbox was to send: at once, or, of the frame on the wire, at its end.
#include <vector>

#include "catch.hpp"
#include "tests/emulator/bench.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint32_t kApb1 = 0x40023840, kCan1 = 0x40006400, kTsr = kCan1 + 0x08;
constexpr std::uint32_t kCompleted = 1, kSent = 2, kAbort = 0x80;  // of mailbox 0, eight bits further for the next ones
constexpr std::uint64_t kWithinFrame = 100'000, kFrame = 300'000;  // ns; at most 135 bits of 2 us

/// CAN1 at 500 kbit/s and somebody who listens.
struct Controller : Bench {
  Controller() {
    board.chip().can("can1")->line.attach({{}, {}, [this](const CanFrame& frame) { heard.push_back(frame.data[0]); }});
    write(kApb1, 1U << 25);
    write(kCan1, 0x10001);                           // MCR: initialisation, awake
    write(kCan1 + 0x1C, 1U | 12U << 16 | 1U << 20);  // BTR: 16 MHz by 2 and 16
    write(kCan1, 0x10000);
  }
  void send(unsigned mailbox, std::uint32_t id, std::uint32_t byte) {
    const std::uint32_t at = kCan1 + 0x180 + 16 * mailbox;
    write(at + 4, 8);
    write(at + 8, byte);
    write(at, id << 21 | 1);
  }
  void abort(unsigned mailbox) { write(kTsr, kAbort << (8 * mailbox)); }
  bool is_empty(unsigned mailbox) { return (read(kTsr) >> (26 + mailbox) & 1) != 0; }
  /// Request completed, sent.
  std::uint32_t outcome(unsigned mailbox) { return read(kTsr) >> (8 * mailbox) & (kCompleted | kSent); }

  std::vector<int> heard;  ///< the first byte of each frame
};

}  // namespace

TEST_CASE("a mailbox whose frame is not on the wire is empty as soon as it is told to give up") {
  Controller can;
  can.send(0, 0x100, 1);
  can.send(1, 0x200, 2);
  can.run(kWithinFrame);
  can.abort(1);
  CHECK(can.is_empty(1));
  CHECK(can.outcome(1) == kCompleted);
  can.run(2 * kFrame);
  CHECK(can.outcome(0) == (kCompleted | kSent));
  CHECK(can.heard == std::vector<int>{1});
}

TEST_CASE("a frame on the wire that is aborted is sent all the same, and keeps its mailbox until its end") {
  Controller can;
  can.send(0, 0x100, 1);
  can.run(kWithinFrame);
  can.abort(0);
  CHECK_FALSE(can.is_empty(0));
  CHECK(can.outcome(0) == 0);
  can.run(kFrame);
  CHECK(can.is_empty(0));
  CHECK(can.outcome(0) == (kCompleted | kSent));
  CHECK(can.heard == std::vector<int>{1});
}

TEST_CASE("a frame that fails on the wire is tried again, but not after an abort") {
  for (const bool aborts : {false, true}) {
    INFO(aborts);
    Controller can;
    can.board.chip().can("can1")->line.disturbed_frames = 1;
    can.send(0, 0x100, 1);
    can.run(kWithinFrame);
    if (aborts) can.abort(0);
    CHECK_FALSE(can.is_empty(0));
    can.run(3 * kFrame);
    CHECK(can.is_empty(0));
    CHECK(can.outcome(0) == (aborts ? kCompleted : kCompleted | kSent));
    CHECK(can.heard.size() == (aborts ? 0 : 1));
    can.send(0, 0x100, 2);  // the next one is none of its business
    can.run(2 * kFrame);
    CHECK(can.outcome(0) == (kCompleted | kSent));
    CHECK(can.heard.back() == 2);
  }
}

TEST_CASE("a frame that is handed over while an aborted one of its identifier is on the wire is sent itself") {
  Controller can;
  can.send(0, 0x200, 1);
  can.run(kWithinFrame);
  can.abort(0);
  can.send(1, 0x200, 2);
  can.run(kFrame);
  CHECK(can.outcome(0) == (kCompleted | kSent));
  CHECK(can.outcome(1) == 0);
  can.run(kFrame);
  CHECK(can.outcome(1) == (kCompleted | kSent));
  CHECK(can.heard == std::vector<int>{1, 2});
  CHECK(can.board.reports().empty());
}
