// Control flow of functions that compilers write, and of some that only look like it.
#include "generator/image/flow_graph.hpp"

#include <utility>

#include "catch.hpp"
#include "generator/image/program.hpp"

using namespace finemote::gen;

namespace {

constexpr std::uint32_t kBase = 0x08000000;
constexpr std::uint16_t kReturn = 0x4770;  // bx lr

struct Label {
  std::uint32_t offset = 0, size = 0;  ///< size 0: a mapping symbol
  std::string name;
};

/// An image of these halfwords; every label with a size is a function.
Image image_of(const std::vector<std::uint16_t>& code, const std::vector<Label>& labels) {
  Image image;
  for (const std::uint16_t half : code) {
    image.file.push_back(static_cast<char>(half & 0xFF));
    image.file.push_back(static_cast<char>(half >> 8));
  }
  ImageSection text;
  text.name = ".text";
  text.address = kBase;
  text.size = static_cast<std::uint32_t>(image.file.size());
  text.allocated = text.has_bytes = text.executable = true;
  text.bytes = {image.file.data(), image.file.size()};
  image.sections = {{}, text};
  for (const Label& label : labels) {
    const auto kind = label.size == 0 ? ImageSymbol::Kind::mapping : ImageSymbol::Kind::function;
    image.symbols.push_back({label.name, kBase + label.offset, label.size, kind, 1});
  }
  return image;
}

/// What the compiler makes of a switch of three; `guard` stands before `tbb [pc, r3]`.
Image switch_of_three(std::vector<std::uint16_t> guard) {
  const auto table = static_cast<std::uint32_t>(2 * guard.size() + 4);
  std::vector<std::uint16_t> code = std::move(guard);
  code.insert(code.end(), {0xe8df, 0xf003, 0x0302, 0x0004, kReturn, kReturn, kReturn, kReturn});
  return image_of(code, {{0, table + 12, "f"}, {0, 0, "$t"}, {table, 0, "$d"}, {table + 4, 0, "$t"}});
}

std::vector<std::string> problems_of(const Image& image) {
  const Program program(image);
  std::vector<std::string> problems;
  for (const auto& [address, function] : program.functions()) {
    for (const FlowProblem& problem : function.graph.problems) problems.push_back(problem.text);
  }
  return problems;
}

constexpr std::uint16_t kCompareR3 = 0x2b02;    // cmp r3, #2
constexpr std::uint16_t kOutIfHigher = 0xd806;  // bhi, to the last return where it stands before the table
using Problems = std::vector<std::string>;
const Problems kUnknownSize{"a branch table of unknown size"};

}  // namespace

TEST_CASE("a table is as long as the unsigned comparison on the only way to it says") {
  const Image image = switch_of_three({kCompareR3, kOutIfHigher});
  CHECK(problems_of(image).empty());
  const FlowGraph graph = Program(image).at(kBase)->graph;
  REQUIRE(graph.blocks.size() == 6);
  const BasicBlock& jump = graph.blocks.at(kBase + 4);
  REQUIRE(jump.edges.size() == 3);
  for (std::uint32_t i = 0; i < 3; ++i) CHECK(jump.edges[i].to == kBase + 12 + 2 * i);
  CHECK(graph.blocks.at(kBase + 12).leaves);
}

TEST_CASE("what looks like the comparison of a table and is not is a problem") {
  CHECK(problems_of(switch_of_three({0x2a02, kOutIfHigher})) == kUnknownSize);              // cmp r2, #2
  CHECK(problems_of(switch_of_three({kCompareR3, 0xdc06})) == kUnknownSize);                // bgt: signed
  CHECK(problems_of(switch_of_three({kCompareR3, 0xd807, 0x3301})) == kUnknownSize);        // adds r3, #1
  CHECK(problems_of(switch_of_three({kCompareR3, 0x3001, 0xd806})) == kUnknownSize);        // adds r0: its flags
  CHECK(problems_of(switch_of_three({0xb108, kCompareR3, kOutIfHigher})) == kUnknownSize);  // cbz around it
  CHECK(problems_of(switch_of_three({0xbf00, 0xbf00})) == kUnknownSize);                    // none at all
  CHECK(problems_of(switch_of_three({0x2bc8, kOutIfHigher})) == kUnknownSize);              // 201: leaves f
  CHECK(problems_of(switch_of_three({kCompareR3, 0xd807, 0x3001})).empty());                // r0 is another
}

TEST_CASE("behind a call that does not return nothing is followed, behind others everything") {
  const std::vector<Label> labels{{0, 8, "f"}, {0, 0, "$t"}, {4, 0, "$d"}, {8, 2, "g"}, {8, 0, "$t"}};
  const Image stays = image_of({0xf000, 0xf802, 0xffff, 0xffff, 0xe7fe}, labels);  // bl g; data; g: b .
  CHECK(problems_of(stays).empty());
  CHECK_FALSE(Program(stays).at(kBase)->returns);
  const Image returns = image_of({0xf000, 0xf802, 0xffff, 0xffff, kReturn}, labels);
  CHECK(problems_of(returns) == Problems{"goes on in data"});
}

TEST_CASE("functions that call each other for ever do not return") {
  const Image image = image_of({0xf000, 0xf801, kReturn, 0xf7ff, 0xfffb, kReturn},  // f: bl g; bx lr; g: bl f; bx lr
                               {{0, 6, "f"}, {0, 0, "$t"}, {6, 6, "g"}});
  const Program program(image);
  CHECK_FALSE(program.at(kBase)->returns);
  CHECK_FALSE(program.at(kBase + 6)->returns);
}

TEST_CASE("a function that ends without a jump goes on in the next one") {
  const Image image = image_of({0x2001, kReturn}, {{0, 2, "f"}, {0, 0, "$t"}, {2, 2, "g"}});  // f: movs r0, #1
  const Program program(image);
  const ProgramFunction& f = *program.at(kBase);
  REQUIRE(f.graph.blocks.size() == 1);
  REQUIRE(f.graph.blocks.at(kBase).call);
  CHECK(f.graph.blocks.at(kBase).call->target == kBase + 2);
  CHECK(f.graph.blocks.at(kBase).call->is_tail);
  CHECK(f.returns);
}

TEST_CASE("a return under a condition leaves and goes on") {
  const Image image = image_of({0x2800, 0xbf08, kReturn, 0x2001, kReturn},  // cmp r0, #0; it eq; bxeq lr; movs r0, #1
                               {{0, 10, "f"}, {0, 0, "$t"}});
  const FlowGraph graph = Program(image).at(kBase)->graph;
  REQUIRE(graph.blocks.size() == 2);
  CHECK(graph.blocks.at(kBase).leaves);
  REQUIRE(graph.blocks.at(kBase).edges.size() == 1);
  CHECK(graph.blocks.at(kBase).edges[0].to == kBase + 6);
  CHECK(graph.blocks.at(kBase + 6).leaves);
}

TEST_CASE("a call of a part of the function is a jump there, from which a return leads to behind it") {
  // push {lr}; bl +2; pop {pc}; part: bx lr
  const Image image = image_of({0xb500, 0xf000, 0xf801, 0xbd00, kReturn}, {{0, 10, "f"}, {0, 0, "$t"}});
  const FlowGraph graph = Program(image).at(kBase)->graph;
  REQUIRE(graph.blocks.size() == 3);
  CHECK_FALSE(graph.blocks.at(kBase).call);
  REQUIRE(graph.blocks.at(kBase).edges.size() == 1);
  CHECK(graph.blocks.at(kBase).edges[0].to == kBase + 8);
  REQUIRE(graph.blocks.at(kBase + 8).edges.size() == 1);
  CHECK(graph.blocks.at(kBase + 8).edges[0].to == kBase + 6);
}

TEST_CASE("what is left of a function into which another one jumps returns for both") {
  // f: b g+2; g: nop; bx lr
  const Image image = image_of({0xe000, 0xbf00, kReturn}, {{0, 2, "f"}, {0, 0, "$t"}, {2, 4, "g"}});
  const Program program(image);
  const ProgramFunction* rest = program.at(kBase + 4);
  REQUIRE(rest != nullptr);
  CHECK(rest->symbol->name == "g");
  CHECK(rest->graph.entry == kBase + 4);
  CHECK(rest->returns);
  CHECK(program.at(kBase)->returns);
  CHECK(program.at(kBase + 2)->graph.entry == kBase + 2);
  CHECK(program.at(kBase + 2)->graph.blocks.count(kBase + 4) == 1);  // the same blocks
}

TEST_CASE("blocks end where they are told to") {
  const Image image = image_of({0xbf00, 0xbf00, kReturn}, {{0, 6, "f"}, {0, 0, "$t"}});
  const FunctionBody body(image, image.symbols.front());
  const FlowGraph graph = trace(image, body, [](const FlowCall&) { return true; }, {kBase, {kBase + 2, kBase + 100}});
  REQUIRE(graph.blocks.size() == 2);
  CHECK(graph.blocks.at(kBase).end == kBase + 2);
  CHECK(graph.blocks.at(kBase).edges[0].to == kBase + 2);
}

TEST_CASE("an instruction that the decoder does not know, and a jump to who knows where, are problems") {
  const std::vector<Label> labels{{0, 6, "f"}, {0, 0, "$t"}};
  CHECK(problems_of(image_of({0xffff, 0xffff, kReturn}, labels)) ==
        Problems{"an instruction that the decoder does not know"});
  CHECK(problems_of(image_of({0x469f, kReturn, kReturn}, labels)) ==  // mov pc, r3
        Problems{"'mov pc, r3' jumps to an unknown place"});
}
