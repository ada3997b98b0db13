// No interrupt routine returns while a store of it may still wait for the bus (Arm erratum 838869).
#include <cstring>
#include <set>

#include "catch.hpp"
#include "emulator/core/operation.hpp"
#include "tests/emulator/fixture.hpp"

using namespace finemote::emulator;

namespace {

bool stores(const Operation& o) {
  return is_among(o.kind, Opcode::str_imm, Opcode::strh_imm) || is_among(o.kind, Opcode::str_reg, Opcode::strh_reg) ||
         o.kind == Opcode::stm || o.kind == Opcode::strd || o.kind == Opcode::strex || o.kind == Opcode::vstr ||
         o.kind == Opcode::vstr_word || o.kind == Opcode::vstm || (o.kind == Opcode::indexed && o.a >= 5);
}

/// Looks at every instruction and every return.
class Watch {
 public:
  explicit Watch(Board& board) : board_(board) {
    board.cpu().set_probe([this](std::uint32_t pc) { look(pc); });
    board.cpu().on_return = [this](int exception) {
      if (waiting_) late_.insert(exception);
      seen_.insert(exception);
    };
  }
  [[nodiscard]] const std::set<int>& late() const { return late_; }
  [[nodiscard]] const std::set<int>& seen() const { return seen_; }

 private:
  void look(std::uint32_t pc) {
    std::uint16_t halves[2];
    std::memcpy(halves, board_.cpu().memory(pc, 4), 4);
    const Operation o = take_apart(halves[0], halves[1]);
    if (stores(o)) waiting_ = true;
    // A load from a peripheral comes after the stores that went to the system bus: RAM and peripherals.
    if (o.kind == Opcode::dsb || loads_from_peripheral(o)) waiting_ = false;
  }
  [[nodiscard]] bool loads_from_peripheral(const Operation& o) const {
    return o.kind == Opcode::ldr_imm && board_.cpu().register_value(o.n) >> 28 == 4;
  }

  Board& board_;
  bool waiting_ = false;
  std::set<int> late_, seen_;
};

}  // namespace

TEST_CASE("every routine of ports, buckets and the release ends its stores before it returns") {
  MiniBoard mini;
  Watch watch(mini.board);
  mini.board.run_for(300'000'000);
  CHECK(watch.seen().size() >= 6);
  CHECK(watch.late() == std::set<int>{});
}

TEST_CASE("those of SPI and CAN too") {
  for (const char* name : {"spi", "can"}) {
    INFO(name);
    Board board{finemote::test::type_c()};
    board.load(test_image(name));
    Watch watch(board);
    board.run_for(50'000'000);
    CHECK(watch.seen().size() >= 3);
    CHECK(watch.late() == std::set<int>{});
  }
}
