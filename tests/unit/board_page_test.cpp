// The page of the Type C board says what the chip's file says: costs, drivers, errata.
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catch.hpp"
#include "emulator/silicon/meanness.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace {

using Json = nlohmann::ordered_json;

std::string text(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string described(const Json& entry) {
  return text(entry.at("summary")) + (entry.at("assumed").get<bool>() ? "; assumed" : "");
}

std::string costs_table(const Json& chip) {
  std::string table = "| what | ns | |\n|---|---|---|\n";
  for (const auto& [name, cost] : chip.at("costs").items())
    table += row({"`" + name + "`", text(cost.at("ns")), described(cost)});
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

void put_table(std::string& page, const std::string& name, const std::string& table) {
  const std::string begin = "<!-- table: " + name + " -->\n";
  const std::size_t at = page.find(begin), end = page.find("<!-- end of table -->", at);
  INFO(name);
  REQUIRE(at != std::string::npos);
  REQUIRE(end != std::string::npos);
  page.replace(at + begin.size(), end - at - begin.size(), "\n" + table + "\n");
}

}  // namespace

TEST_CASE("the page of the Type C board has the figures and errata of its chip's file") {
  const std::string path = finemote::test::source_dir() + "/docs/reference/boards/robomaster_type_c.md";
  const Json chip = Json::parse(finemote::test::read(finemote::test::source_dir() + "/schemas/chips/stm32f407.json"));
  std::string page = finemote::test::read(path);
  put_table(page, "costs", costs_table(chip));
  put_table(page, "drivers", drivers_table(chip));
  put_table(page, "errata", errata_table(chip));
  put_table(page, "silicon", finemote::emulator::silicon_table());
  if (std::getenv("FINEMOTE_UPDATE_GOLDEN") != nullptr) std::ofstream(path, std::ios::binary) << page;
  CHECK(finemote::test::read(path) == page);
}
