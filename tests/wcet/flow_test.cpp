// The control flow of a linked image against a second decoder, with each edge taken away once.
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "wcet/flow_check.hpp"
#include "wcet/ran_robot.hpp"
#include "wcet/routes.hpp"

using namespace finemote;
using namespace finemote::test;

TEST_CASE("the emulated core can go nowhere that the graph does not lead, and each edge that is missing shows") {
  const RanRobot ran({source_path("examples/finsrov.urdf"), "--duration", "1ms"});
  const LoadedImage loaded(ran.image());
  const gen::Program program(loaded.image, loaded.marks.addresses());
  std::size_t blocks = 0, dropped = 0, unseen = 0;
  for (const auto& [address, function] : program.functions()) {
    if (!function.graph.problems.empty()) continue;
    const auto missing = missing_edges(loaded.image, program, function, function.graph);
    for (const std::string& edge : missing) FAIL_CHECK(gen::readable_name(function.symbol->name) << ": " << edge);
    blocks += function.graph.blocks.size();
    for (const auto& [begin, block] : function.graph.blocks) {
      for (std::size_t i = 0; i < block.edges.size(); ++i) {
        gen::FlowGraph mutant;  // of this block alone
        mutant.entry = begin;
        mutant.blocks[begin] = block;
        auto& edges = mutant.blocks[begin].edges;
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(i));
        const auto& is_twice = [&](const gen::FlowEdge& other) { return other.to == block.edges[i].to; };
        if (std::any_of(edges.begin(), edges.end(), is_twice)) continue;  // it leads there by another condition, too
        ++dropped;
        if (missing_edges(loaded.image, program, function, mutant).empty()) {
          ++unseen;
          UNSCOPED_INFO(gen::readable_name(function.symbol->name) << " " << std::hex << begin);
        }
      }
    }
  }
  CHECK(unseen == 0);
  CHECK(blocks > 1000);
  CHECK(dropped > 1000);
}
