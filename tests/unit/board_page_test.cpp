// The page of the Type C board says what the chip's file says: costs, drivers, errata.
#include <nlohmann/json.hpp>
#include <string>

#include "catch.hpp"
#include "emulator/silicon/strictness.hpp"
#include "tests/page_table.hpp"

namespace {

using finemote::test::row;
using Json = nlohmann::ordered_json;

std::string text(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::string described(const Json& entry) {
  return text(entry.at("summary")) + (entry.at("assumed").get<bool>() ? "; assumed" : "");
}

std::string costs_table(const Json& chip) {
  std::string table = "| what | ns | code in SRAM | |\n|---|---|---|---|\n";
  for (const auto& [name, cost] : chip.at("costs").items()) {
    const std::string in_sram = cost.contains("sram_ns") ? text(cost.at("sram_ns")) : "";
    table += row({"`" + name + "`", text(cost.at("ns")), in_sram, described(cost)});
  }
  return table;
}

std::string drivers_table(const Json& chip) {
  std::string table = "| bus driver | source | routine [ns] | apart [bit] | |\n|---|---|---|---|---|\n";
  for (const auto& [name, driver] : chip.at("drivers").items()) {
    table += row(
        {"`" + name + "`", "", text(driver.at("isr_wcet_ns")), text(driver.at("min_frame_bits")), described(driver)});
    for (const Json& source : driver.at("sources"))
      table +=
          row({"", text(source.at("name")), text(source.at("isr_wcet_ns")), text(source.at("min_frame_bits")), ""});
  }
  return table;
}

std::string errata_table(const Json& chip) {
  std::string table = "| erratum | description | effect | what is done |\n|---|---|---|---|\n";
  for (const Json& it : chip.at("errata"))
    table += row({text(it.at("id")), text(it.at("title")), text(it.at("effect")), text(it.at("here"))});
  return table;
}

}  // namespace

TEST_CASE("the page of the Type C board has the figures and errata of its chip's file") {
  const Json chip = Json::parse(finemote::test::read(finemote::test::source_dir() + "/schemas/chips/stm32f407.json"));
  finemote::test::PageTables page("docs/reference/boards/robomaster_type_c.md");
  page.put("costs", costs_table(chip));
  page.put("drivers", drivers_table(chip));
  page.put("errata", errata_table(chip));
  page.put("silicon", finemote::emulator::silicon_table());
  page.hold();
}
