// The cost table against the documents it was made from, and against the core of the emulated board.
#include <iterator>

#include "catch.hpp"
#include "wcet/table_checks.hpp"

using namespace finemote::gen::wcet;
using namespace finemote::test;

TEST_CASE("every figure of the cost table is that of its document") {
  for (const std::string& difference : differences_from_documents(documented_costs())) FAIL_CHECK(difference);
}

TEST_CASE("no instruction takes the emulated core longer than the table says, alone or behind another") {
  const Excess excess = excess_over(documented_costs(), decoded_grid());
  for (const std::string& found : excess.found) FAIL_CHECK(found);
  CHECK(excess.count == 0);
  CHECK(excess.compared > 100'000);
}

namespace {

/// A table with one figure a cycle too small.
struct Mutant {
  std::string name;
  CostTable table;
};

constexpr Cycles CostTable::*kMembers[] = {
    &CostTable::single,    &CostTable::exclusive,  &CostTable::two,         &CostTable::float_single,
    &CostTable::float_two, &CostTable::several,    &CostTable::word,        &CostTable::taken,
    &CostTable::skipped,   &CostTable::straddling, &CostTable::wait_states, &CostTable::read_in_flight};
constexpr Cycles MemoryWaits::*kWaits[] = {
    &MemoryWaits::flash, &MemoryWaits::fetched_sram,  &MemoryWaits::sram,
    &MemoryWaits::ahb,   &MemoryWaits::apb2,          &MemoryWaits::apb1,
    &MemoryWaits::own,   &MemoryWaits::bit_band_sram, &MemoryWaits::bit_band_apb};
static_assert(sizeof(CostTable) ==
                  sizeof(std::vector<CostTable::Row>) + sizeof(Cycles) * (std::size(kMembers) + std::size(kWaits)),
              "a figure without a mutant");

std::vector<Mutant> mutants() {
  std::vector<Mutant> all;
  const auto add = [&](const std::string& name, auto change) {
    all.push_back({name, documented_costs()});
    change(all.back().table);
  };
  for (std::size_t i = 0; i < documented_costs().fixed.size(); ++i)
    add("row " + std::to_string(i), [i](CostTable& t) { --t.fixed[i].cycles; });
  for (std::size_t i = 0; i < std::size(kMembers); ++i)
    add("member " + std::to_string(i), [i](CostTable& t) { --(t.*kMembers[i]); });
  for (std::size_t i = 0; i < std::size(kWaits); ++i)
    add("wait " + std::to_string(i), [i](CostTable& t) { --(t.waits.*kWaits[i]); });
  return all;
}

}  // namespace

TEST_CASE("a figure that is a cycle too small differs from its document, and most of them from the emulated core") {
  const std::vector<Decoded> grid = documented_instructions();
  std::size_t by_core = 0, all = 0;
  for (const Mutant& mutant : mutants()) {
    CAPTURE(mutant.name);
    CHECK_FALSE(differences_from_documents(mutant.table).empty());
    by_core += excess_over(mutant.table, grid).count > 0 ? 1 : 0;
    ++all;
  }
  CHECK(all > 100);
  CHECK(by_core > 70);
}
