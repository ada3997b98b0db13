// Bounds of execution times: ranges against all values, paths against all ways, code by hand against the rules.
#include <algorithm>
#include <functional>
#include <random>

#include "catch.hpp"
#include "generator/wcet/certificate.hpp"
#include "generator/wcet/comparison.hpp"
#include "generator/wcet/cost_table.hpp"
#include "generator/wcet/execute.hpp"
#include "generator/wcet/fpu_use.hpp"
#include "generator/wcet/interval.hpp"
#include "generator/wcet/longest_path.hpp"
#include "generator/wcet/loop_nest.hpp"
#include "generator/wcet/machine.hpp"
#include "generator/wcet/memory_map.hpp"
#include "generator/wcet/operands.hpp"
#include "generator/wcet/walk.hpp"
#include "generator/wcet/without.hpp"

using namespace finemote::gen;
using namespace finemote::gen::wcet;

namespace {

using Word = std::uint32_t;

std::mt19937& dice() {
  static std::mt19937 generator(7);
  return generator;
}

Word roll(Word limit) { return std::uniform_int_distribution<Word>(0, limit)(dice()); }

/// Small ones, ones around the wrap and around the sign.
Interval random_interval() {
  const Word around[] = {0, 0x7FFFFFFC, 0x80000000, 0xFFFFFFF8, 1000};
  const Word low = around[roll(4)] + roll(4);
  const Word high = low + roll(3);
  return high < low ? Interval{low, UINT32_MAX} : Interval{low, high};
}

template <class Each>
void for_each_word(Interval range, Each each) {
  for (std::uint64_t word = range.low; word <= range.high; ++word) each(static_cast<Word>(word));
}

void check_operation(Interval (*on_ranges)(Interval, Interval), Word (*on_words)(Word, Word)) {
  for (int i = 0; i < 300; ++i) {
    const Interval a = random_interval(), b = random_interval(), result = on_ranges(a, b);
    for_each_word(a, [&](Word x) {
      for_each_word(b, [&](Word y) {
        CAPTURE(a.low, a.high, b.low, b.high, x, y);
        REQUIRE(result.contains(Interval::of(on_words(x, y))));
      });
    });
  }
}

bool holds(arm_cc condition, Word a, Word b) {
  const auto x = static_cast<std::int32_t>(a), y = static_cast<std::int32_t>(b);
  switch (condition) {
    case ARM_CC_EQ:
      return a == b;
    case ARM_CC_NE:
      return a != b;
    case ARM_CC_HS:
      return a >= b;
    case ARM_CC_LO:
      return a < b;
    case ARM_CC_MI:
      return static_cast<std::int32_t>(a - b) < 0;
    case ARM_CC_PL:
      return static_cast<std::int32_t>(a - b) >= 0;
    case ARM_CC_HI:
      return a > b;
    case ARM_CC_LS:
      return a <= b;
    case ARM_CC_GE:
      return x >= y;
    case ARM_CC_LT:
      return x < y;
    case ARM_CC_GT:
      return x > y;
    case ARM_CC_LE:
      return x <= y;
    default:
      return true;
  }
}

}  // namespace

TEST_CASE("operations on ranges hold every result") {
  check_operation(add, [](Word a, Word b) { return a + b; });
  check_operation(subtract, [](Word a, Word b) { return a - b; });
  check_operation(multiply, [](Word a, Word b) { return a * b; });
  check_operation(bitwise_and, [](Word a, Word b) { return a & b; });
  check_operation(bitwise_or, [](Word a, Word b) { return a | b; });
  check_operation(exclusive_or, [](Word a, Word b) { return a ^ b; });
  check_operation(divide_unsigned, [](Word a, Word b) { return b == 0 ? 0 : a / b; });
  check_operation([](Interval a, Interval) { return complement(a); }, [](Word a, Word) { return ~a; });
  check_operation([](Interval a, Interval) { return shift_left(a, 3); }, [](Word a, Word) { return a << 3; });
  check_operation([](Interval a, Interval) { return shift_right(a, 3); }, [](Word a, Word) { return a >> 3; });
  check_operation([](Interval a, Interval) { return shift_right_signed(a, 3); },
                  [](Word a, Word) { return static_cast<Word>(static_cast<std::int32_t>(a) >> 3); });
}

TEST_CASE("a condition keeps every pair for which it holds, and none is left where it never does") {
  constexpr arm_cc kConditions[] = {ARM_CC_EQ, ARM_CC_NE, ARM_CC_HS, ARM_CC_LO, ARM_CC_MI, ARM_CC_PL,
                                    ARM_CC_HI, ARM_CC_LS, ARM_CC_GE, ARM_CC_LT, ARM_CC_GT, ARM_CC_LE};
  for (const arm_cc condition : kConditions) {
    for (int i = 0; i < 200; ++i) {
      Comparison flags;
      flags.left_range = random_interval();
      flags.right_range = random_interval();
      const auto sides = where(flags, condition);
      const auto difference = difference_where(flags, condition);
      for_each_word(flags.left_range, [&](Word a) {
        for_each_word(flags.right_range, [&](Word b) {
          CAPTURE(static_cast<int>(condition), a, b);
          REQUIRE(holds(opposite(condition), a, b) != holds(condition, a, b));
          if (!holds(condition, a, b)) return;
          REQUIRE(sides);
          REQUIRE(sides->first.contains(Interval::of(a)));
          REQUIRE(sides->second.contains(Interval::of(b)));
          REQUIRE(difference);
          REQUIRE(difference->contains(Interval::of(a - b)));
        });
      });
    }
  }
}

namespace {

/// Edges lead to later nodes only, as those of an unrolled graph do.
UnrolledGraph random_graph(std::size_t size) {
  UnrolledGraph graph;
  for (std::size_t node = 0; node < size; ++node) {
    UnrolledNode fresh;
    fresh.cost = roll(20);
    for (std::size_t from = 0; from < node; ++from) {
      if (from + 1 == node || roll(3) == 0) fresh.from.push_back({from, static_cast<Cycles>(roll(5))});
    }
    graph.nodes.push_back(std::move(fresh));
  }
  graph.exits = {size - 1, size / 2};
  return graph;
}

/// Over all ways, one by one.
Cycles longest_by_search(const UnrolledGraph& graph, std::size_t node) {
  Cycles longest = node == 0 ? 0 : -1;
  for (const UnrolledEdge& edge : graph.nodes[node].from) {
    const Cycles before = longest_by_search(graph, edge.from);
    if (before >= 0) longest = std::max(longest, before + edge.cost);
  }
  return longest < 0 ? -1 : longest + graph.nodes[node].cost;
}

}  // namespace

TEST_CASE("the longest path is that of all ways, and its certificate says so") {
  for (int i = 0; i < 300; ++i) {
    const UnrolledGraph graph = random_graph(2 + roll(8));
    Cycles longest = 0;
    for (const std::size_t exit : graph.exits) longest = std::max(longest, longest_by_search(graph, exit));
    const auto path = longest_path(graph);
    REQUIRE(path);
    CHECK(path->bound == longest);
    CHECK(check_certificate(graph, path->potentials, path->bound).empty());
    Cycles along = 0;
    for (std::size_t step = 0; step < path->nodes.size(); ++step) {
      along += graph.nodes[path->nodes[step]].cost;
      if (step == 0) continue;
      Cycles edge_cost = -1;
      for (const UnrolledEdge& edge : graph.nodes[path->nodes[step]].from) {
        if (edge.from == path->nodes[step - 1]) edge_cost = std::max(edge_cost, edge.cost);
      }
      REQUIRE(edge_cost >= 0);
      along += edge_cost;
    }
    CHECK(along == longest);
  }
}

TEST_CASE("without some blocks the longest way is that of all ways that pass none of them") {
  for (int i = 0; i < 300; ++i) {
    UnrolledGraph graph = random_graph(2 + roll(8));
    for (UnrolledNode& node : graph.nodes) node.block = roll(4);
    graph.nodes[0].block = 0;
    const std::set<Word> left_out{3, 4};
    UnrolledGraph cut = graph;  // no way leads into such a node
    for (UnrolledNode& node : cut.nodes) {
      if (left_out.count(node.block) != 0) node.from.clear();
    }
    Cycles longest = -1;
    for (const std::size_t exit : graph.exits) longest = std::max(longest, longest_by_search(cut, exit));
    const UnrolledGraph left = without(graph, left_out);
    const auto path = longest_path(left);
    CHECK(path.has_value() == (longest >= 0));
    if (!path) continue;
    CHECK(path->bound == longest);
    CHECK(check_certificate(left, path->potentials, path->bound).empty());
  }
}

TEST_CASE("a certificate that is a cycle short in any place proves nothing") {
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    const UnrolledGraph graph = random_graph(3 + roll(6));
    const auto path = longest_path(graph);
    REQUIRE(path);
    CHECK_FALSE(check_certificate(graph, path->potentials, path->bound - 1).empty());
    for (std::size_t step = 1; step < path->nodes.size(); ++step) {
      Potentials shorter = path->potentials;
      --shorter[path->nodes[step]];
      CHECK_FALSE(check_certificate(graph, shorter, path->bound).empty());
      ++refused;
    }
    UnrolledGraph longer = graph;
    ++longer.nodes[path->nodes[roll(static_cast<Word>(path->nodes.size() - 1))]].cost;
    CHECK_FALSE(check_certificate(longer, path->potentials, path->bound).empty());
  }
  CHECK(refused > 200);
}

TEST_CASE("between marks only what lies between them counts") {
  UnrolledGraph graph;  // 0 - 1 - 2 - 4, and 1 - 3 - 4
  graph.nodes = {{nullptr, 0, 5, {}},
                 {nullptr, 0, 7, {{0, 1}}},
                 {nullptr, 0, 11, {{1, 2}}},
                 {nullptr, 0, 2, {{1, 0}}},
                 {nullptr, 0, 100, {{2, 3}, {3, 1}}}};
  graph.exits = {4};
  const std::vector<bool> from{false, true, false, false, false}, to{false, false, false, false, true};
  const auto path = longest_between(graph, from, to);
  REQUIRE(path);
  CHECK(path->bound == 7 + 2 + 11 + 3);
  CHECK(path->nodes == std::vector<std::size_t>{1, 2});
  CHECK_FALSE(longest_between(graph, to, from));
}

namespace {

FlowGraph graph_of(const std::vector<std::pair<Word, std::vector<Word>>>& blocks) {
  FlowGraph graph;
  graph.entry = blocks.front().first;
  for (const auto& [begin, successors] : blocks) {
    BasicBlock block;
    block.begin = begin;
    for (const Word to : successors) block.edges.push_back({to, true});
    graph.blocks[begin] = block;
  }
  return graph;
}

}  // namespace

TEST_CASE("loops nest as their blocks do") {
  const LoopNest nest(graph_of({{1, {2}}, {2, {3, 6}}, {3, {4}}, {4, {3, 5}}, {5, {2}}, {6, {}}}));
  REQUIRE(nest.loops().size() == 2);
  CHECK(nest.irreducible().empty());
  const auto outer = nest.around(2), inner = nest.around(4);
  REQUIRE((outer && inner));
  CHECK(nest.loops()[*inner].parent == outer);
  CHECK(nest.loops()[*outer].blocks == std::set<Word>{2, 3, 4, 5});
  CHECK(nest.loops()[*inner].blocks == std::set<Word>{3, 4});
  CHECK_FALSE(nest.around(6));
  CHECK(nest.order({}) == std::vector<Word>{1, 2, 6});
  CHECK(nest.order(outer) == std::vector<Word>{2, 3, 5});
}

TEST_CASE("a cycle that is entered in two places is no loop") {
  const LoopNest nest(graph_of({{1, {2, 3}}, {2, {3}}, {3, {2, 4}}, {4, {}}}));
  CHECK_FALSE(nest.irreducible().empty());
}

namespace {

/// Decodes halfwords and runs them, one after the other.
Machine run_code(const std::vector<std::uint16_t>& halfwords, Machine machine) {
  std::string bytes;
  for (const std::uint16_t halfword : halfwords) {
    bytes.push_back(static_cast<char>(halfword & 0xFFU));
    bytes.push_back(static_cast<char>(halfword >> 8U));
  }
  static const Image kNoImage;
  const Constants constants(kNoImage, {});
  static Unknowns unknowns;
  for (const Instruction& i : decode(0x08000000, bytes)) execute(i, {constants, unknowns}, machine);
  return machine;
}

Machine machine_with_stack() {
  Machine machine;
  machine.set(ARM_REG_SP, Value::place(0x10001000));
  return machine;
}

}  // namespace

TEST_CASE("what was pushed is popped, and a store through an unknown pointer leaves it alone") {
  Machine machine = machine_with_stack();
  machine.set(ARM_REG_R4, Value::of(42));
  machine.set(ARM_REG_R1, Value::in(Interval::any()));
  machine = run_code({0xB410, 0x6008, 0xBC20}, machine);  // push {r4}; str r0, [r1]; pop {r5}
  CHECK(machine.get(ARM_REG_R5).range() == Interval::of(42));
  CHECK(machine.get(ARM_REG_SP).range() == Interval::of(0x10001000));
}

TEST_CASE("a store through a pointer into the stack that is not known makes its words unknown") {
  Machine machine = machine_with_stack();
  machine.set(ARM_REG_R4, Value::of(42));
  machine.set(ARM_REG_R2, Value::in({0, 64}));
  // push {r4}; sub sp, #8; add r1, sp, r2 (by mov r1, sp; add r1, r2); str r0, [r1]; ldr r5, [sp, #8]
  machine = run_code({0xB410, 0xB082, 0x4669, 0x4411, 0x6008, 0x9D02}, machine);
  CHECK_FALSE(machine.get(ARM_REG_R5).range().is_constant());
}

TEST_CASE("pointers are compared by their distance, wherever they lead") {
  Machine machine = machine_with_stack();
  machine.set(ARM_REG_R0, Value::in(Interval::any()));
  // mov r1, r0 (after a move that names it); adds r1, #8; adds r0, #8; cmp r0, r1
  machine = run_code({0x4603, 0x4619, 0x3108, 0x4618, 0x3008, 0x4288}, machine);
  Machine differs = machine, equals = machine;
  CHECK_FALSE(differs.assume(ARM_CC_NE));
  CHECK(equals.assume(ARM_CC_EQ));
}

TEST_CASE("a branch tells the range of what was compared, and of every copy of it") {
  Machine machine = machine_with_stack();
  machine.set(ARM_REG_R0, Value::in(Interval::any()));
  machine = run_code({0x4603, 0x4619, 0x461A, 0x2905}, machine);  // mov r3, r0; mov r1, r3; mov r2, r3; cmp r1, #5
  REQUIRE(machine.assume(ARM_CC_LS));
  CHECK(machine.get(ARM_REG_R1).range() == Interval{0, 5});
  CHECK(machine.get(ARM_REG_R2).range() == Interval{0, 5});
}

TEST_CASE("instructions cost what the reference manual says at most") {
  struct Row {
    std::vector<std::uint16_t> code;
    Cycles cycles;
  };
  // Cortex-M4 TRM (DDI 0439D), tables 3-1 and 7-1 and the notes below them.
  const Row rows[] = {
      {{0x3001}, 1},           // adds r0, #1
      {{0xFBB0, 0xF1F1}, 12},  // udiv r1, r0, r1
      {{0x6808}, 3},           // ldr r0, [r1]: 2, and 1 for an address just computed
      {{0xE9D1, 0x2300}, 4},   // ldrd r2, r3, [r1]: 3 and 1
      {{0xB4F0}, 6},           // push {r4-r7}: 1 + 4, and 1
      {{0xEE30, 0x0A20}, 2},   // vadd.f32: 1, and 1 where the next needs it
      {{0xEE80, 0x0A20}, 15},  // vdiv.f32: 14 and 1
      {{0xEEA0, 0x0A20}, 4},   // vfma.f32: 3 and 1
      {{0xF3EF, 0x8010}, 2},   // mrs r0, primask
  };
  for (const Row& row : rows) {
    std::string bytes;
    for (const std::uint16_t halfword : row.code) {
      bytes.push_back(static_cast<char>(halfword & 0xFFU));
      bytes.push_back(static_cast<char>(halfword >> 8U));
    }
    const auto decoded = decode(0, bytes);
    REQUIRE(decoded.size() == 1);
    CAPTURE(decoded[0].text);
    CHECK(longest_time(decoded[0]) == row.cycles);
  }
}

TEST_CASE("a move to the FPU leaves the core registers it reads, one from it does not") {
  const auto decoded = decode(0, std::string_view("\x06\xEE\x90\x3A"   // vmov s13, r3
                                                  "\x16\xEE\x90\x3A"   // vmov r3, s13
                                                  "\x41\xEC\x10\x0B"   // vmov d0, r0, r1
                                                  "\x51\xEC\x10\x0B"   // vmov r0, r1, d0
                                                  "\x43\xEC\x10\x2A",  // vmov s0, s1, r2, r3
                                                  20));
  REQUIRE(decoded.size() == 5);
  CHECK_FALSE(may_write(decoded[0], ARM_REG_R3));
  CHECK(may_write(decoded[0], ARM_REG_S13));
  CHECK(may_write(decoded[1], ARM_REG_R3));
  CHECK_FALSE(may_write(decoded[2], ARM_REG_R1));
  CHECK((may_write(decoded[3], ARM_REG_R0) && may_write(decoded[3], ARM_REG_R1)));
  CHECK_FALSE(may_write(decoded[4], ARM_REG_R2));
}

TEST_CASE("what an instruction only reads it leaves") {
  const auto decoded = decode(0, std::string_view("\x92\xFB\xF0\xF5"   // sdiv r5, r2, r0
                                                  "\x92\xFB\xF0\xF0"   // sdiv r0, r2, r0
                                                  "\xA1\xFB\x02\x30"   // umull r3, r0, r1, r2
                                                  "\xC1\xFB\x02\x30"   // smlal r3, r0, r1, r2
                                                  "\x48\x41"           // adcs r0, r1
                                                  "\x11\xFB\x02\xF0"   // smulbb r0, r1, r2
                                                  "\x50\xE8\x00\x1F",  // ldrex r1, [r0]
                                                  26));
  REQUIRE(decoded.size() == 7);
  CHECK((may_write(decoded[0], ARM_REG_R5) && may_write(decoded[1], ARM_REG_R0)));
  CHECK_FALSE((may_write(decoded[0], ARM_REG_R2) || may_write(decoded[0], ARM_REG_R0)));
  for (const std::size_t i : {2, 3}) {
    CAPTURE(decoded[i].text);
    CHECK((may_write(decoded[i], ARM_REG_R3) && may_write(decoded[i], ARM_REG_R0)));
    CHECK_FALSE((may_write(decoded[i], ARM_REG_R1) || may_write(decoded[i], ARM_REG_R2)));
  }
  CHECK((may_write(decoded[4], ARM_REG_R0) && !may_write(decoded[4], ARM_REG_R1)));
  CHECK((may_write(decoded[5], ARM_REG_R0) && !may_write(decoded[5], ARM_REG_R2)));
  CHECK(may_write(decoded[6], ARM_REG_R1));
}

TEST_CASE("waiting for an interrupt has no place in code that must end in time") {
  const auto decoded = decode(0, std::string_view("\x30\xBF", 2));  // wfi
  REQUIRE(decoded.size() == 1);
  CHECK_FALSE(longest_time(decoded[0]));
}

namespace {

constexpr Word kBase = 0x08000000;

/// One function of these halfwords.
Image image_of_code(const std::vector<std::uint16_t>& code) {
  Image image;
  for (const std::uint16_t half : code) {
    image.file.push_back(static_cast<char>(half & 0xFFU));
    image.file.push_back(static_cast<char>(half >> 8U));
  }
  ImageSection text;
  text.name = ".text";
  text.address = kBase;
  text.size = static_cast<Word>(image.file.size());
  text.allocated = text.has_bytes = text.executable = true;
  text.bytes = {image.file.data(), image.file.size()};
  image.sections = {{}, text};
  image.symbols = {{"f", kBase, text.size, ImageSymbol::Kind::function, 1},
                   {"$t", kBase, 0, ImageSymbol::Kind::mapping, 1}};
  return image;
}

struct Bound {
  std::optional<Cycles> cycles;
  std::uint64_t rounds = 0;
  std::string problem;
};

/// Gives `use` what a walk through the code says, while the program is there that it points into.
template <class Use>
auto with_walk(const std::vector<std::uint16_t>& code, const Marks& marks, Use&& use) {
  const Image image = image_of_code(code);
  const Program program(image, marks.addresses());
  const Constants constants(image, {});
  return use(walk({program, constants, marks, CodeCost(Placement::sram), nullptr, 0x10001000}, kBase));
}

Bound bound_of(const Walked& walked) {
  Bound bound;
  for (const auto& [header, loop] : walked.loops) bound.rounds = std::max(bound.rounds, loop.rounds);
  for (const auto& [address, problem] : walked.problems) bound.problem = problem.why;
  const auto path = longest_path(walked.graph);
  if (path && walked.problems.empty()) bound.cycles = path->bound;
  return bound;
}

Bound bound_of(const std::vector<std::uint16_t>& code, const Marks& marks = {}) {
  return with_walk(code, marks, [](const Walked& walked) { return bound_of(walked); });
}

constexpr std::uint16_t kReturn = 0x4770;

bool touches_fpu(const std::vector<std::uint16_t>& code) {
  return with_walk(code, {}, [](const Walked& walked) { return uses_fpu(walked.graph); });
}

}  // namespace

TEST_CASE("a routine uses the FPU where an instruction of it is on some way") {
  CHECK_FALSE(touches_fpu({0x2005, 0x3801, 0xD1FD, kReturn}));
  CHECK(touches_fpu({0xEE30, 0x0A81, kReturn}));                  // vadd.f32 s0, s1, s2
  CHECK(touches_fpu({0x7808, 0xB108, 0xED90, 0x0A00, kReturn}));  // ldrb r0, [r1]; cbz r0, +1; vldr s0, [r0]
  CHECK(touches_fpu({0xEEF1, 0xFA10, kReturn}));                  // vmrs apsr_nzcv, fpscr
  CHECK_FALSE(touches_fpu({0xE001, 0xEE30, 0x0A81, kReturn}));    // jumped over
}

TEST_CASE("a part of a routine that is called returns to where the link register says, or for the whole") {
  // movs r0, #1; push {lr}; bl part; bl part; pop {pc}; part: subs r0, #1; bmi out; bx lr; out: pop {pc}
  const Bound bound =
      bound_of({0x2001, 0xB500, 0xF000, 0xF803, 0xF000, 0xF801, 0xBD00, 0x3801, 0xD400, kReturn, 0xBD00});
  CHECK(bound.problem.empty());
  REQUIRE(bound.cycles);
  constexpr Cycles kSet = 1, kPush = 3, kCall = 4, kCount = 1, kFall = 1, kJump = 4, kBack = 4, kPop = 3;
  CHECK(*bound.cycles == kSet + kPush + (kCall + kCount + kFall + kBack) + (kCall + kCount + kJump) + kPop);
}

TEST_CASE("a loop that counts down is turned so often and no more") {
  // movs r0, #5; subs r0, #1; bne -2; bx lr
  const Bound bound = bound_of({0x2005, 0x3801, 0xD1FD, kReturn});
  CHECK(bound.rounds == 4);
  // 1; five times 1 + 1; four branches taken, 3; the return: 1
  CHECK(bound.cycles == 1 + 5 * 2 + 4 * 3 + 1);
}

TEST_CASE("a loop that only counts is not followed round by round") {
  // movw r0, #0; movt r0, #256 (16,777,216); subs r0, #1; bne -2; bx lr
  const Bound bound = bound_of({0xF240, 0x0000, 0xF2C0, 0x1000, 0x3801, 0xD1FD, kReturn});
  CHECK(bound.rounds == 0xFFFFFF);
  // 1 and 1; each iteration 1 + 1; a branch taken, 3, but in the last; the return: 1
  CHECK(bound.cycles == 2 + 0x1000000 * 2 + 0xFFFFFF * 3 + 1);
  CHECK(bound_of({0xF240, 0x0000, 0xF6CF, 0x7000, 0x3801, 0xD1FD, kReturn}).problem ==
        "a loop that counts for seconds");
}

TEST_CASE("what counts down by more than one, or does more, is followed") {
  // movs r0, #6; subs r0, #2; bne -2; bx lr
  CHECK(bound_of({0x2006, 0x3802, 0xD1FD, kReturn}).rounds == 2);
  // movs r0, #5; movs r1, #0; adds r1, #1; subs r0, #1; bne -3; then count r1 down
  const Bound bound = bound_of({0x2005, 0x2100, 0x3101, 0x3801, 0xD1FC, 0x3901, 0xD1FD, kReturn});
  CHECK(bound.cycles == 2 + 5 * 3 + 4 * 3 + 5 * 2 + 4 * 3 + 1);
}

TEST_CASE("a distance that passes zero does not hide what a word may be") {
  Machine machine = machine_with_stack();
  Unknowns unknowns;
  machine.set(ARM_REG_R0, unknowns.next({8, 8}, false));
  Value counter = sum(unknowns.next({8, 9}, false), Value::in({0, 57}));
  for (int i = 0; i < 8; ++i) counter = difference(counter, Value::of(1));
  CHECK(counter.range() == Interval{0, 58});
}

TEST_CASE("constants are found behind others that lie in the same section") {
  const Image image = image_of_code({0x1234, 0x5678, 0x9ABC, 0xDEF0});
  const Constants constants(image, {{kBase, kBase + 2}, {kBase + 1, kBase + 3}});
  CHECK(constants.load({Value::of(kBase + 4), 4}) == Interval::of(0xDEF09ABC));
  CHECK_FALSE(constants.load({Value::of(kBase + 6), 4}));
}

TEST_CASE("an element of a table is read whole, and nothing between two of them") {
  const Image image = image_of_code({0x0001, 0x1000, 0x0002, 0x1000});
  const Constants constants(image, {{kBase, kBase + 8}});
  const Value either = Value::in({kBase, kBase + 4});
  CHECK(constants.load({either, 4, 4}) == Interval{0x1000'0001, 0x1000'0002});
  CHECK(constants.load({either, 4})->low < 0x1000'0001);  // a member of a packed class may lie anywhere
}

TEST_CASE("an index that is shifted steps from element to element of a table that lies at a multiple of them") {
  constexpr std::uint16_t kLoad[] = {0xF851, 0x0022};  // ldr.w r0, [r1, r2, lsl #2]
  const auto step_at = [&](Word begin) {
    const Image image = image_of_code({kLoad[0], kLoad[1], kReturn});
    const Program program(image, {});
    Machine machine;
    machine.set(ARM_REG_R1, Value::of(begin));
    machine.set(ARM_REG_R2, Value::in({0, 3}));
    const MemoryUse use = memory_use(program.at(kBase)->body.instructions().front(), machine);
    REQUIRE(use.words.size() == 1);
    CHECK(use.words[0].access.address.range() == Interval{begin, begin + 12});
    return use.words[0].access.step;
  };
  CHECK(step_at(0x1000'0100) == 4);
  CHECK(step_at(0x1000'0102) == 1);
}

TEST_CASE("a pointer that may be none waits for no flash where code runs in SRAM") {
  const Interval none_or_variable{0, 0x1000'1000}, in_flash{0x0800'0000, 0x0800'0100};
  const MemoryWaits waits;
  CHECK(longest_wait(none_or_variable, Placement::sram, waits) == waits.fetched_sram);
  CHECK(longest_wait(none_or_variable, Placement::flash, waits) == waits.flash);
  CHECK(longest_wait(in_flash, Placement::sram, waits) == waits.flash);
  CHECK(longest_wait({0x0700'0000, 0x0800'0000}, Placement::sram, waits) == waits.flash);
}

TEST_CASE("a loop over what a caller gives has no bound") {
  const Bound bound = bound_of({0x3801, 0xD1FD, kReturn});  // subs r0, #1; bne -2; bx lr
  CHECK_FALSE(bound.cycles);
  CHECK(bound.problem == "a loop whose rounds are not known: bound it with LoopBound<n>");
}

TEST_CASE("a byte bounds a loop, and a smaller limit bounds it tighter") {
  // ldrb r0, [r1]; cbz r0, out; subs r0, #1; bne -2; out: bx lr
  CHECK(bound_of({0x7808, 0xB108, 0x3801, 0xD1FD, kReturn}).rounds == 254);
  // ldrb r0, [r1]; cmp r0, #7; bhi out; adds r0, #1; subs r0, #1; bne -2; out: bx lr
  CHECK(bound_of({0x7808, 0x2807, 0xD802, 0x3001, 0x3801, 0xD1FD, kReturn}).rounds == 7);
}

namespace {

/// A word: 3 and a wait of 2, and where it is not aligned two more accesses that wait as long.
constexpr Cycles kFromAnywhere = 3 + 2 + 2 * (1 + 2);

void add_wait(Word place, Marks& marks) {
  marks.waits.emplace(place, ARM_REG_R2);
  marks.ids[place] = {1};
}

/// A wait for a word to become 0, whose limit is in r2: ldr r0, [r1]; cmp r0, #0; bne -3; bx lr.
Bound bound_of_wait(std::vector<std::uint16_t> before, const std::vector<std::uint16_t>& behind = {kReturn}) {
  Marks marks;
  add_wait(kBase + static_cast<Word>(2 * before.size()), marks);
  before.insert(before.end(), {0x6808, 0x2800, 0xD1FC});
  before.insert(before.end(), behind.begin(), behind.end());
  return bound_of(before, marks);
}

}  // namespace

TEST_CASE("a wait lasts as long as its mark says, and two rounds") {
  const Bound bound = bound_of_wait({0x2264});  // movs r2, #100
  CHECK(bound.problem.empty());
  // 1; 100; twice the word from anywhere, 1 and 1; one branch taken, 3; the return: 1
  CHECK(bound.cycles == 1 + 100 + 2 * (kFromAnywhere + 1 + 1) + 3 + 1);
}

TEST_CASE("a loop that waits in each of its rounds is gone through as often as it turns") {
  // movs r2, #100; movs r3, #3; nop; ldr r0, [r1]; cmp r0, #0; bne -3; subs r3, #1; bne -6; bx lr
  Marks marks;
  add_wait(kBase + 6, marks);
  const Bound bound = bound_of({0x2264, 0x2303, 0xBF00, 0x6808, 0x2800, 0xD1FC, 0x3B01, 0xD1F9, kReturn}, marks);
  CHECK(bound.problem.empty());
  const Cycles wait = 100 + 2 * (kFromAnywhere + 1 + 1) + 3, round = 1 + wait + 1 + 1;
  CHECK(bound.cycles == 2 + 3 * round + 2 * 3 + 1);
}

TEST_CASE("a wait whose limit nobody knows has no bound") {
  CHECK(bound_of_wait({}).problem == "a wait whose limit is not known");
}

TEST_CASE("the largest limit that a wait can be given counts") {
  // movs r2, #100; ldrb r3, [r1]; cbz r3, +1; movs r2, #200
  const auto longest = bound_of_wait({0x2264, 0x780B, 0xB103, 0x22C8}).cycles;
  const auto shortest = bound_of_wait({0x2264, 0x780B, 0xB103, 0x2264}).cycles;
  REQUIRE((longest && shortest));
  CHECK(*longest - *shortest == 100);
}

TEST_CASE("what a wait changes from round to round is not known behind it") {
  // movs r2, #100; movs r3, #5; and in each iteration: adds r3, #1
  const std::vector<std::uint16_t> before{0x2264, 0x2305};
  const std::vector<std::uint16_t> count_down{0x3B01, 0xD1FD, kReturn};  // subs r3, #1; bne -2; bx lr
  CHECK(bound_of_wait(before, count_down).rounds == 4);
  Marks marks;
  add_wait(kBase + 4, marks);
  // ldr r0, [r1]; adds r3, #1; cmp r0, #0; bne -4; then count down
  const Bound bound = bound_of({0x2264, 0x2305, 0x6808, 0x3301, 0x2800, 0xD1FB, 0x3B01, 0xD1FD, kReturn}, marks);
  CHECK(bound.problem == "a loop whose rounds are not known: bound it with LoopBound<n>");
}

TEST_CASE("the two sides of an IT block are told apart to its end") {
  // ldrb r3, [r1]; cmp r3, #24; ite ls; rsbls r3, r3, #25; movhi r3, #0; cbz r3, out; subs r3, #1; bne -2; out: bx lr
  const std::vector<std::uint16_t> code{0x780B, 0x2B18, 0xBF94, 0xF1C3, 0x0319,
                                        0x2300, 0xB10B, 0x3B01, 0xD1FD, kReturn};
  CHECK(bound_of(code).rounds == 24);
}

TEST_CASE("a sum of two ranges is a range, from round to round") {
  // ldrb r3, [r1]; ldrb r4, [r1]; adds r2, r3, r4; movs r0, #0; cmp r0, r2; beq out; adds r0, #1; b -6; out: bx lr
  const Bound bound = bound_of({0x780B, 0x780C, 0x191A, 0x2000, 0x4290, 0xD001, 0x3001, 0xE7FB, kReturn});
  CHECK(bound.problem.empty());
  CHECK(bound.rounds == 255 + 255);
}

TEST_CASE("a mark bounds a loop, and each more pass costs more") {
  const std::vector<std::uint16_t> code{0x3801, 0xD1FD, kReturn};
  Marks marks;
  marks.loop_bounds[kBase] = 3;
  marks.ids[kBase] = {1};
  const Bound three = bound_of(code, marks);
  REQUIRE(three.cycles);
  marks.loop_bounds[kBase] = 4;
  const Bound four = bound_of(code, marks);
  REQUIRE(four.cycles);
  CHECK(*four.cycles - *three.cycles == 1 + 1 + 3);
  marks.begins.emplace(kBase, 2);  // of another loop
  CHECK(bound_of(code, marks).cycles == four.cycles);
}

TEST_CASE("a mark whose loop begins in this one, or that does not say where it begins, is of another loop") {
  const std::vector<std::uint16_t> code{0xBF00, 0x3801, 0xD1FC, kReturn};  // nop; subs r0, #1; bne -3; bx lr
  Marks marks;
  marks.loop_bounds[kBase + 2] = 3;
  CHECK(bound_of(code, marks).problem.find("the marks in it are of others") != std::string::npos);
  marks.ids[kBase + 2] = {1};
  CHECK(bound_of(code, marks).cycles);
  marks.begins.emplace(kBase, 1);
  CHECK(bound_of(code, marks).problem.find("the marks in it are of others") != std::string::npos);
}

TEST_CASE("a loop that its mark lets turn more often than is followed is called that") {
  Marks marks;
  marks.loop_bounds[kBase] = 20'000;
  marks.ids[kBase] = {1};
  // nop; subs r0, #1; bne -3; bx lr
  CHECK(bound_of({0xBF00, 0x3801, 0xD1FC, kReturn}, marks).problem ==
        "a loop that may turn more often than is followed: 10000 times");
}

TEST_CASE("two words that are equal are not held by two that are only in their ranges") {
  Unknowns unknowns;
  Machine equal = machine_with_stack(), apart = machine_with_stack();
  const Value one = unknowns.next(Interval::any(), false);
  equal.set(ARM_REG_R0, one);
  equal.set(ARM_REG_R1, one);
  apart.set(ARM_REG_R0, unknowns.next(Interval::any(), false));
  apart.set(ARM_REG_R1, unknowns.next(Interval::any(), false));
  CHECK_FALSE(equal.covers(apart));
  CHECK(equal.covers(equal));
  equal.widen(apart);
  CHECK(equal.covers(apart));
  CHECK(difference(equal.get(ARM_REG_R0), equal.get(ARM_REG_R1)).range() == Interval::any());
}

TEST_CASE("a constant member of a constant hides nothing of what lies around it") {
  const Image image = image_of_code({0x1111, 0x2222, 0x3333, 0x4444});
  const Constants constants(image, {{kBase, kBase + 2}, {kBase + 2, kBase + 4}});
  CHECK(constants.load({Value::of(kBase), 4}) == Interval::of(0x22221111));
  CHECK(constants.load({Value::of(kBase + 4), 4}) == Interval::of(0x44443333));
}

TEST_CASE("a call through a variable, and a function that calls itself, have no bound") {
  CHECK(bound_of({0x4780, kReturn}).problem == "'blx r0' calls what a variable says");
  CHECK(bound_of({0xB500, 0xF7FF, 0xFFFD, 0xBD00}).problem == "recursion: it has no bound");  // push {lr}; bl f; pop
}
