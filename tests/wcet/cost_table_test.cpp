// The cost table against the documents it was made from, and against the core of the emulated board.
#include <iterator>

#include "catch.hpp"
#include "tests/page_table.hpp"
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

template <class Of>
struct Named {
  const char* name;
  Cycles Of::*figure;
};

constexpr Named<CostTable> kMembers[] = {{"single", &CostTable::single},
                                         {"exclusive", &CostTable::exclusive},
                                         {"two", &CostTable::two},
                                         {"float_single", &CostTable::float_single},
                                         {"float_two", &CostTable::float_two},
                                         {"several", &CostTable::several},
                                         {"word", &CostTable::word},
                                         {"unaligned_word", &CostTable::unaligned_word},
                                         {"unaligned_half", &CostTable::unaligned_half},
                                         {"taken", &CostTable::taken},
                                         {"skipped", &CostTable::skipped},
                                         {"straddling", &CostTable::straddling},
                                         {"wait_states", &CostTable::wait_states},
                                         {"read_in_flight", &CostTable::read_in_flight},
                                         {"fpu_context", &CostTable::fpu_context}};
constexpr Named<MemoryWaits> kWaits[] = {{"flash", &MemoryWaits::flash},
                                         {"fetched_sram", &MemoryWaits::fetched_sram},
                                         {"sram", &MemoryWaits::sram},
                                         {"ahb", &MemoryWaits::ahb},
                                         {"apb2", &MemoryWaits::apb2},
                                         {"apb1", &MemoryWaits::apb1},
                                         {"own", &MemoryWaits::own},
                                         {"bit_band_sram", &MemoryWaits::bit_band_sram},
                                         {"bit_band_apb", &MemoryWaits::bit_band_apb}};
static_assert(sizeof(CostTable) ==
                  sizeof(std::vector<CostTable::Row>) + sizeof(Cycles) * (std::size(kMembers) + std::size(kWaits)),
              "a figure without a mutant");

/// The mnemonic of the instructions that a row of fixed times is for.
std::string mnemonic(unsigned id) {
  for (const Decoded& decoded : documented_instructions()) {
    if (decoded.instruction.id == id) return decoded.instruction.text.substr(0, decoded.instruction.text.find(' '));
  }
  return "?";
}

std::vector<Mutant> mutants() {
  std::vector<Mutant> all;
  const auto add = [&](const std::string& name, Cycles value, auto change) {
    all.push_back({"`" + name + "`, " + std::to_string(value), documented_costs()});
    change(all.back().table);
  };
  const CostTable& right = documented_costs();
  for (std::size_t i = 0; i < right.fixed.size(); ++i)
    add(mnemonic(right.fixed[i].id), right.fixed[i].cycles, [i](CostTable& t) { --t.fixed[i].cycles; });
  for (const auto& [name, figure] : kMembers) add(name, right.*figure, [of = figure](CostTable& t) { --(t.*of); });
  for (const auto& [name, figure] : kWaits)
    add(std::string("waits.") + name, right.waits.*figure, [of = figure](CostTable& t) { --(t.waits.*of); });
  return all;
}

}  // namespace

TEST_CASE("a figure that is a cycle too small differs from its document, and most of them from the emulated core") {
  const std::vector<Decoded> grid = documented_instructions();
  std::string table = row({"figure", "by its document", "by the emulated core"}) + row({"---", "---", "---"});
  std::size_t by_core = 0, all = 0;
  for (const Mutant& mutant : mutants()) {
    CAPTURE(mutant.name);
    const std::vector<std::string> differences = differences_from_documents(mutant.table);
    CHECK_FALSE(differences.empty());
    const Excess excess = excess_over(mutant.table, grid);
    table += row({mutant.name, differences.empty() ? "survives" : differences.front(),
                  excess.count > 0 ? excess.found.front() : "–"});
    by_core += excess.count > 0 ? 1 : 0;
    ++all;
  }
  CHECK(all > 100);
  CHECK(by_core > 70);
  PageTables page("docs/reference/wcet-mutants.md");
  page.put("costs", table);
  page.hold();
}
