// Where bytes come from, followed through the machine: what operations do to tags, what marks make of them, and how
// they pass peripherals. The firmware here is a few instructions; whole robots are in carried_test.
#include "catch.hpp"
#include "tests/emulator/bench.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint32_t kFrom = 0x20000000, kTo = 0x20000100, kBody = 0x08000210;
constexpr Tag kA{1}, kH{8};

BoardOptions tagged() {
  BoardOptions options;
  options.tags = true;
  return options;
}

/// A board whose reset routine is `code`; r0 points to eight bytes with the tags of eight samples, 'a' to 'h', r1 to
/// other memory, r2 to CPACR; r3 is 0.
struct Machine {
  explicit Machine(const Code& code) : board({}, tagged()) {
    board.load(bench_image(1, code + Code{0xE7FE}, {kFrom, kTo, 0xE000ED88, 0}));
    const std::uint32_t source = provenance().add_source();
    for (std::uint32_t n = 0; n < 8; ++n) {
      const Tag tag = provenance().sample(source, 0, 0);
      tags().put_in_memory(kFrom + n, 1, {tag});
    }
  }
  void run(std::uint64_t ns) { board.cpu().run_until(board.cpu().now() + from_ns(ns)); }
  Provenance& provenance() { return board.world().provenance(); }
  TagFlow& tags() { return board.world().tags(); }
  /// A letter a byte, the lowest first; '.': no tag, '*': another.
  static std::string text(const WordTags& word) {
    std::string text;
    for (const Tag tag : word) {
      const bool known = tag >= kA && tag <= kH;
      const auto letter = static_cast<char>('a' + static_cast<int>(tag) - static_cast<int>(kA));
      text += tag == Tag::none ? '.' : known ? letter : '*';
    }
    return text;
  }

  Board board;
};

/// Tags of r4 after `code`.
std::string after(const Code& code) {
  Machine machine(code);
  machine.run(20'000);
  return Machine::text(machine.tags().of_register(4));
}

constexpr std::uint16_t kLoad4 = 0x6804, kLoad5 = 0x6845;  // ldr r4, [r0]; ldr r5, [r0, #4]
const Code kBoth = {kLoad4, kLoad5};

}  // namespace

TEST_CASE("bytes that are copied keep their tags") {
  CHECK(after({kLoad4}) == "abcd");
  CHECK(after({0x7844}) == "b...");                                  // ldrb r4, [r0, #1]
  CHECK(after({0xF990, 0x4001}) == "bbbb");                          // ldrsb r4, [r0, #1]
  CHECK(after(kBoth + Code{0x462C}) == "efgh");                      // mov r4, r5
  CHECK(after({0xE890, 0x0030, 0x462C}) == "efgh");                  // ldm r0, {r4, r5}
  CHECK(after({0xE9D0, 0x4500, 0x462C}) == "efgh");                  // ldrd r4, r5, [r0]
  CHECK(after(kBoth + Code{0x600D, 0x680C}) == "efgh");              // str r5, [r1]; ldr r4, [r1]
  CHECK(after(kBoth + Code{0x600D, 0x704C, 0x680C}) == "eagh");      // and strb r4, [r1, #1]
  CHECK(after(kBoth + Code{0xC130, 0xF851, 0x4C04}) == "efgh");      // stm r1!, {r4, r5}; ldr r4, [r1, #-4]
  CHECK(after({0xE850, 0x4F00, 0xE841, 0x4200, 0x680C}) == "abcd");  // ldrex r4, [r0]; strex r2, r4, [r1]
  CHECK(after({kLoad4, 0xB410, 0x2400, 0xBC10}) == "abcd");          // push {r4}; movs r4, #0; pop {r4}
}

TEST_CASE("bytes that are moved inside of a word take their tags along") {
  CHECK(after({kLoad4, 0x0224}) == ".abc");              // lsls #8
  CHECK(after({kLoad4, 0x0C24}) == "cd..");              // lsrs #16
  CHECK(after({kLoad4, 0x0924}) == "bcdd");              // lsrs #4: where two meet, the newer one
  CHECK(after({kLoad4, 0xEA4F, 0x2434}) == "bcda");      // ror #8
  CHECK(after({kLoad4, 0xB2E4}) == "a...");              // uxtb
  CHECK(after({kLoad4, 0xBA24}) == "dcba");              // rev
  CHECK(after({kLoad4, 0xF404, 0x447F}) == ".b..");      // and #0xFF00
  CHECK(after({kLoad4, 0xF3C4, 0x240F}) == "bc..");      // ubfx #8, #16
  CHECK(after(kBoth + Code{0xF365, 0x240F}) == "aecd");  // bfi r4, r5, #8, #8
  CHECK(after(kBoth + Code{0xEAC4, 0x0405}) == "abgh");  // pkhbt
  CHECK(after(kBoth + Code{0x432C}) == "efgh");          // orrs r4, r5
  CHECK(turned({Tag{1}, Tag{2}, Tag{3}, Tag{4}}, 4) == WordTags{Tag{2}, Tag{3}, Tag{4}, Tag{4}});
}

TEST_CASE("what is computed has the newest tag of its operands, and constants have none") {
  CHECK(after(kBoth + Code{0x1964}) == "hhhh");                  // adds r4, r4, r5
  CHECK(after(kBoth + Code{0xFB04, 0xF405}) == "hhhh");          // mul
  CHECK(after(kBoth + Code{0xFBA4, 0x4505}) == "hhhh");          // umull
  CHECK(after({kLoad4, 0x2400}) == "....");                      // movs r4, #0
  const Code fpu_on = {0x6813, 0xF443, 0x0370, 0x6013};          // ldr r3, [r2]; orr r3, #0xF00000; str r3, [r2]
  const Code load = {0xED90, 0x0A00};                            // vldr s0, [r0]
  CHECK(after(fpu_on + load + Code{0xEE10, 0x4A10}) == "abcd");  // vmov r4, s0
  CHECK(after(fpu_on + load + Code{0xEE70, 0x0A00, 0xEDC1, 0x0A00, 0x680C}) == "dddd");  // vadd s1; vstr; ldr
}

TEST_CASE("a conditional instruction leaves the newer of what was there and what it writes, unless it is one of two") {
  const Code swapped = {0x6844, 0x6805, 0x2B00};           // ldr r4, [r0, #4]; ldr r5, [r0]; cmp r3, #0
  CHECK(after(swapped + Code{0xBF18, 0x462C}) == "efgh");  // movne r4, r5
  CHECK(after(swapped + Code{0xBF08, 0x462C}) == "efgh");  // moveq r4, r5
  CHECK(after(kBoth + Code{0x2B00, 0xBF08, 0x462C}) == "efgh");
  CHECK(after(kBoth + Code{0x2B00, 0xBF18, 0x462C}) == "abcd");
  CHECK(after(swapped + Code{0xBF0C, 0x462C, 0x4614}) == "abcd");  // ite eq; moveq r4, r5; movne r4, r2: either
}

TEST_CASE("registers of what an exception interrupts come back") {
  constexpr int kException = 16 + 28;
  Board board({}, tagged());
  board.load(bench_image(kException, {0x2400, kReturn}, {kFrom, kTo, 0, 0}));  // movs r4, #0
  board.run_for(1'000);
  Registers registers;
  registers.r[0] = kFrom;
  TagFlow& tags = board.world().tags();
  tags.put_in_memory(kFrom, 4, all_of(kA));
  tags.follow(take_apart(kLoad4, 0), registers, false, 0);
  REQUIRE(tags.of_register(4) == all_of(kA));
  auto& system = board.world().system();
  system.write(0xE000E100, 4, 1U << 28, 0, 0);
  system.nvic().pend(kException);
  board.cpu().kick();
  board.run_for(10'000);
  CHECK(system.nvic().times_entered(kException) == 1);
  CHECK(tags.of_register(4) == all_of(kA));
}

TEST_CASE("every store of a handle is its run's, whatever it stores, and no other store is") {
  // str r4, [r1]; [mark] str r4, [r1, #4]; push {r4}; pop {r4} [mark]; b to the start
  Machine machine({kLoad4, 0x600C, 0x604C, 0xB410, 0xBC10, 0xE7F9});
  constexpr std::uint32_t kSecond = kBody + 4, kEnd = kBody + 10, kHandle = 3;  // of the second device
  machine.board.cpu().mark(kSecond, 2 * kHandle);
  machine.board.cpu().mark(kEnd, 2 * kHandle + 1);
  machine.run(3'000);
  const auto job = [&] { return machine.provenance().job(machine.tags().in_memory(kTo + 4, 4)[3]); };
  REQUIRE(job() != nullptr);
  CHECK(job()->source == kHandle);
  const std::uint32_t first = job()->n;
  machine.run(3'000);
  CHECK(job()->n > first);
  CHECK(Machine::text(machine.tags().in_memory(kTo, 4)) == "abcd");
  CHECK(Machine::text(machine.tags().of_register(4)) == "abcd");  // it came back from the stack as it was
  CHECK(machine.provenance().uses().empty());
}

TEST_CASE("stores of a routine that comes in between are not the handle's") {
  Provenance provenance;
  provenance.pass_mark(2, 0, std::nullopt);
  CHECK(provenance.writes_as() != Tag::none);
  provenance.enter(0x20001000);
  CHECK(provenance.writes_as() == Tag::none);
  provenance.tail();
  CHECK(provenance.writes_as() == Tag::none);
  provenance.resume(0x20001000);
  CHECK(provenance.job(provenance.writes_as())->n == 0);
  provenance.pass_mark(3, 0, std::nullopt);
  CHECK(provenance.writes_as() == Tag::none);
  provenance.pass_mark(2, 0, std::nullopt);
  CHECK(provenance.job(provenance.writes_as())->n == 1);
}

TEST_CASE("a kernel comes back to another thread than it left, and each goes on with what it was at") {
  constexpr std::uint32_t kFirst = 0x20001000, kSecond = 0x20002000;
  Provenance provenance;
  provenance.pass_mark(2, 0, std::nullopt);  // the first thread is in a handle
  provenance.enter(kFirst);
  provenance.resume(kSecond);  // which never ran
  CHECK(provenance.writes_as() == Tag::none);
  provenance.pass_mark(6, 0, std::nullopt);
  CHECK(provenance.job(provenance.writes_as())->source == 3);
  provenance.enter(kSecond);
  provenance.tail();
  provenance.resume(kFirst);
  CHECK(provenance.job(provenance.writes_as())->source == 1);
  provenance.pass_mark(3, 0, std::nullopt);  // and ends it there
  provenance.enter(kFirst + 8);
  provenance.resume(kSecond);
  CHECK(provenance.job(provenance.writes_as())->source == 3);
}

TEST_CASE("registers of another thread come back with its tags") {
  Machine machine({kLoad4});
  machine.run(20'000);
  TagFlow& tags = machine.tags();
  REQUIRE(Machine::text(tags.of_register(4)) == "abcd");
  tags.enter(0x20001000);
  tags.resume(0x20002000);
  CHECK(Machine::text(tags.of_register(4)) == "....");
  tags.enter(0x20002000);
  tags.resume(0x20001000);
  CHECK(Machine::text(tags.of_register(4)) == "abcd");
}

TEST_CASE("an update's state is made of the newest sample it has looked at so far, whatever it says of its age") {
  Provenance provenance;
  const std::uint32_t source = provenance.add_source(), other = provenance.add_source();
  const auto update = [&](Time at, const std::vector<Tag>& loads) {
    provenance.pass_mark(0, at, std::nullopt);
    for (const Tag tag : loads) provenance.loaded(tag, at);
    provenance.pass_mark(1, at, std::nullopt);
  };
  const auto last = [&] { return provenance.origin(provenance.uses().back().sample); };
  update(5, {});
  CHECK(provenance.uses().empty());  // never any: unknown
  const Tag first = provenance.sample(source, 10, 12), second = provenance.sample(source, 20, 25);
  update(30, {second, first, Tag::none});
  CHECK(last().n == 1);
  CHECK(last().from == 20);
  const Tag third = provenance.sample(source, 40, 45);
  update(42, {second});  // published once more
  CHECK(last().n == 1);
  update(43, {first});
  CHECK(last().n == 1);
  update(44, {third});  // still arriving
  CHECK(last().n == 1);
  update(50, {});  // what it looked at has arrived
  CHECK(last().n == 2);
  update(70, {third});
  CHECK(last().n == 2);
  const std::size_t before = provenance.uses().size();
  update(80, {provenance.sample(other, 75, 75)});
  CHECK(provenance.uses().size() == before + 2);  // of each source one
  provenance.reset();
  update(90, {});
  CHECK(provenance.uses().size() == before + 2);
}

TEST_CASE("nobody knows of a sample whose end came while an update looked at it") {
  Provenance provenance;
  const std::uint32_t source = provenance.add_source();
  const Tag first = provenance.sample(source, 10, 12), second = provenance.sample(source, 20, 35);
  const auto update = [&](Time begin, Tag loads, Time end) {
    provenance.pass_mark(0, begin, std::nullopt);
    provenance.loaded(loads, begin);
    provenance.pass_mark(1, end, std::nullopt);
    return provenance.uses().size();
  };
  CHECK(update(15, first, 16) == 1);
  CHECK(update(30, second, 31) == 2);  // not there yet
  CHECK(update(33, second, 36) == 2);  // now or never
  CHECK(update(40, Tag::none, 41) == 3);
  CHECK(provenance.origin(provenance.uses().back().sample).n == 1);
}

TEST_CASE("what the firmware claims is kept with what it used, until its time begins anew") {
  Provenance provenance;
  const Tag sample = provenance.sample(provenance.add_source(), 10, 12);
  const auto claim_of = [&](Claim claim) {
    provenance.pass_mark(0, 20, 99);
    provenance.loaded(sample, 20);
    provenance.pass_mark(1, 20, claim);
    return provenance.uses().back().claimed;
  };
  provenance.reset();  // power-on
  CHECK(claim_of(17) == 17);
  CHECK(claim_of(std::nullopt) == std::nullopt);
  provenance.reset();
  CHECK(claim_of(17) == std::nullopt);
}

TEST_CASE("what an update loads counts, but not what comes back from the stack") {
  // [mark] ldr r4, [r0] [mark]; b to the start
  Machine machine({kLoad4, kNop, 0xE7FC});
  machine.board.cpu().mark(kBody, 0);
  machine.board.cpu().mark(kBody + 2, 1);
  machine.run(3'000);
  REQUIRE(!machine.provenance().uses().empty());
  CHECK(machine.provenance().uses().back().sample == Tag{4});
  // push {r4} in front of the first mark; [mark] pop {r4} [mark]
  Machine spilling({kLoad4, 0xB410, 0xBC10, kNop, 0xE7FB});
  spilling.board.cpu().mark(kBody + 4, 0);
  spilling.board.cpu().mark(kBody + 6, 1);
  spilling.run(3'000);
  CHECK(spilling.provenance().uses().empty());
}

namespace {

constexpr std::uint32_t kUsart6 = 0x40011400, kDma2 = 0x40026400;
constexpr Tag kSample{7};

/// Receives four bytes in a circle by DMA.
struct Receiver {
  Receiver() : board(finemote::test::type_c(), tagged()) {
    board.load(bench_image());
    board.run_for(1'000);
    const auto write = [this](std::uint32_t address, std::uint32_t value) { board.chip().write(address, 4, value); };
    const std::uint32_t stream1 = kDma2 + 0x10 + 0x18;
    write(0x40023830, 1U << 22);
    write(0x40023844, 1U << 5);
    write(kUsart6 + 0x08, 139);
    write(kUsart6 + 0x14, 1U << 6);
    write(stream1 + 0x08, kUsart6 + 4);
    write(stream1 + 0x0C, kTo);
    write(stream1 + 0x04, 4);
    write(stream1, 5U << 25 | 1U << 10 | 1U << 8 | 1);
    write(kUsart6 + 0x0C, 0x2004);
  }
  /// Tags of the four bytes in memory.
  WordTags receive() {
    board.chip().usart("usart6")->send_in({1, 2, 3, 4}, SerialFormat{115108, false, 1}, kSample);
    board.run_for(1'000'000);
    return board.world().tags().in_memory(kTo, 4);
  }
  Board board;
};

}  // namespace

TEST_CASE("the last byte of a frame on a serial line carries its sample, by way of DMA") {
  Receiver receiver;
  CHECK(receiver.receive() == WordTags{Tag::none, Tag::none, Tag::none, kSample});
}

TEST_CASE("a frame that was damaged on its way carries nothing, the next one does again") {
  Receiver receiver;
  receiver.board.chip().usart("usart6")->noisy_bytes = 1;
  CHECK(receiver.receive() == WordTags{});
  CHECK(receiver.receive()[3] == kSample);
  receiver.board.chip().usart("usart6")->silent = true;
  receiver.board.world().at(receiver.board.world().now() + from_ns(200'000),
                            [&] { receiver.board.chip().usart("usart6")->silent = false; });
  // Two bytes of it are heard; what came before it stays behind them.
  CHECK(receiver.receive() == WordTags{Tag::none, Tag::none, Tag::none, kSample});
}

TEST_CASE("bytes that leave by DMA carry their tags, and a store to a register its own") {
  Receiver receiver;
  Board& board = receiver.board;
  const auto write = [&](std::uint32_t address, std::uint32_t value) { board.chip().write(address, 4, value); };
  std::vector<Tag> sent;
  board.chip().usart("usart6")->on_sent = [&](WireByte byte) { sent.push_back(byte.tag); };
  const std::uint32_t stream6 = kDma2 + 0x10 + 6 * 0x18;
  board.world().tags().put_in_memory(kFrom, 3, {Tag{1}, Tag{2}, Tag{3}});
  write(stream6 + 0x08, kUsart6 + 4);
  write(stream6 + 0x0C, kFrom);
  write(stream6 + 0x04, 3);
  write(stream6, 5U << 25 | 1U << 10 | 1U << 6 | 1);
  write(kUsart6 + 0x14, 3U << 6);
  write(kUsart6 + 0x0C, 0x200C);
  board.run_for(1'000'000);
  CHECK(sent == std::vector<Tag>{Tag{1}, Tag{2}, Tag{3}});

  Machine machine({});
  Registers registers;
  registers.r[0] = kFrom;
  machine.tags().follow(take_apart(kLoad4, 0), registers, false, 0);
  registers.r[0] = kUsart6 + 4;
  machine.tags().follow(take_apart(0x6004, 0), registers, false, 0);  // str r4, [r0]
  machine.tags().give_stored();
  CHECK(Machine::text(machine.tags().crossing) == "abcd");
  machine.provenance().pass_mark(2, 0, std::nullopt);
  machine.tags().follow(take_apart(0x6004, 0), registers, false, 0);
  machine.tags().give_stored();
  CHECK(machine.provenance().job(machine.tags().crossing[0]) != nullptr);
}
