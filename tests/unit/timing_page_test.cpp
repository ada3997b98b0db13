// The table of costs in docs/timing.md has the figures of the chip's file, and leaves none out.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace {

using Json = nlohmann::ordered_json;

/// By the start of a row's first cell: the figures of its third one, in their order, as `costs.NAME`,
/// `DRIVER.supervise_ns` or `DRIVER.SOURCE.MEMBER`.
const std::map<std::string, std::vector<std::string>> kRows{
    {"exception entry and exit",
     {"costs.exception_entry", "costs.exception_exit", "costs.exception_entry.sram", "costs.exception_exit.sram"}},
    {"`event_entry`", {"costs.event_entry", "costs.event_pause"}},
    {"`fpu_context`", {"costs.fpu_context"}},
    {"`preemption`", {"costs.preemption"}},
    {"`release` ", {"costs.release"}},
    {"`release_per_bucket`", {"costs.release_per_bucket"}},
    {"`release_walk`", {"costs.release_walk", "costs.release_walk_per_bucket"}},
    {"`bucket`", {"costs.bucket", "costs.stage"}},
    {"`masked_section`", {"costs.masked_section", "costs.masked_section.sram"}},
    {"look at the buses", {"i2c.supervise_ns", "spi.supervise_ns", "can.supervise_ns", "rs485.supervise_ns"}},
    {"flush of a PWM expander", {"costs.flush_expander", "costs.flush_expander_per_channel"}},
    {"other flushes", {"costs.flush", "costs.flush_per_channel"}},
    {"crossing between buckets", {"costs.latch", "costs.latch_per_word"}},
    {"UART", {"uart.rx_idle.isr_wcet_ns", "uart.rx_dma.isr_wcet_ns", "uart.tx_complete.isr_wcet_ns"}},
    {"RS-485", {"rs485.rx_dma.isr_wcet_ns", "rs485.tx_complete.isr_wcet_ns"}},
    {"I2C: `request`",
     {"i2c.request.isr_wcet_ns", "i2c.step.isr_wcet_ns", "i2c.end.isr_wcet_ns", "i2c.request.isr_per_slot_ns",
      "i2c.end.isr_per_slot_ns"}},
    {"I2C: `end` where", {"i2c.end.isr_beside_wait_ns"}},
    {"SPI",
     {"spi.request.isr_wcet_ns", "spi.step.isr_wcet_ns", "spi.end.isr_wcet_ns", "spi.request.isr_per_slot_ns",
      "spi.end.isr_per_slot_ns"}},
    {"CAN: `rx`", {"can.rx.isr_wcet_ns", "can.rx.isr_per_slot_ns"}},
    {"CAN: `tx`", {"can.tx.isr_wcet_ns"}},
    {"CAN: `request`", {"can.request.isr_wcet_ns", "can.request.isr_per_frame_ns"}},
    {"trace, monitor", {"costs.trace_event", "costs.monitor_handle"}},
};

/// All figures of the chip's file by those names, but those of drivers that do not interrupt.
std::map<std::string, std::string> figures() {
  const Json chip = Json::parse(finemote::test::read(finemote::test::source_dir() + "/schemas/chips/stm32f407.json"));
  std::map<std::string, std::string> all;
  for (const auto& [name, cost] : chip.at("costs").items()) {
    all["costs." + name] = cost.at("ns").dump();
    if (cost.contains("sram_ns")) all["costs." + name + ".sram"] = cost.at("sram_ns").dump();
  }
  for (const auto& [name, driver] : chip.at("drivers").items()) {
    if (driver.contains("supervise_ns")) all[name + ".supervise_ns"] = driver.at("supervise_ns").dump();
    for (const Json& source : driver.at("sources")) {
      for (const auto& [member, value] : source.items()) {
        const bool is_time = member.size() > 3 && member.substr(member.size() - 3) == "_ns";
        if (is_time) all[name + "." + source.at("name").get<std::string>() + "." + member] = value.dump();
      }
    }
  }
  return all;
}

/// By the first cells of the table's rows: the numbers in the third.
std::map<std::string, std::vector<std::string>> rows() {
  const std::string page = finemote::test::read(finemote::test::source_dir() + "/docs/timing.md");
  const std::size_t begin = page.find("| cost | depends on |");
  std::istringstream table(page.substr(begin, page.find("\n\n", begin) - begin));
  std::map<std::string, std::vector<std::string>> all;
  for (std::string line; std::getline(table, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line.substr(1));
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell.substr(1));
    static const std::regex number(R"(\b\d+\b)");
    std::vector<std::string>& numbers = all[cells.at(0)];
    for (std::sregex_iterator it(cells.at(2).begin(), cells.at(2).end(), number), end; it != end; ++it)
      numbers.push_back(it->str());
  }
  return all;
}

/// What the group of the pattern matches in a source file.
double constant(const std::string& file, const std::string& pattern) {
  const std::string source = finemote::test::read(finemote::test::source_dir() + "/" + file);
  std::smatch found;
  REQUIRE(std::regex_search(source, found, std::regex(pattern)));
  std::string digits = found[1];
  digits.erase(std::remove(digits.begin(), digits.end(), '\''), digits.end());
  return std::stod(digits);
}

}  // namespace

TEST_CASE("the bound of a time stamp has the slack that the driver of serial lines gives") {
  CHECK(constant("generator/timing/stamps.cpp", R"(kEventSlack = microseconds\((\d+)\);)") ==
        constant("runtime/src/uart.cpp", R"(kEventSlack = (\d+) \* kMicrosecond;)"));
}

TEST_CASE("the chip's file has what the ports date events by") {
  const std::string source = "runtime/chips/cortex_m4/urgent_interrupt.cpp";
  const auto figure = figures();
  CHECK(std::stod(figure.at("costs.event_entry")) == constant(source, R"(Duration kEntry = ([\d']+);)"));
  CHECK(std::stod(figure.at("costs.event_pause")) ==
        Approx(constant(source, R"(kPause = (\d+);)") / 0.168).epsilon(0.005));
  CHECK(std::stod(figure.at("costs.event_pause")) >= constant(source, R"(kPause = (\d+);)") / 0.168);
}

TEST_CASE("the table of costs in docs/timing.md has the figures of the chip's file") {
  const auto figure = figures();
  const auto row = rows();
  std::set<std::string> shown;
  for (const auto& [begin, names] : kRows) {
    INFO(begin);
    const auto found = row.lower_bound(begin);
    REQUIRE(found != row.end());
    REQUIRE(found->first.rfind(begin, 0) == 0);
    std::vector<std::string> expected;
    for (const std::string& name : names) {
      expected.push_back(figure.at(name));
      shown.insert(name);
    }
    CHECK(found->second == expected);
  }
  for (const auto& [name, value] : figure) {
    INFO(name << " = " << value << " is in no row");
    CHECK((shown.contains(name) || name == "costs.monitor_job"));  // which has the figure of monitor_handle
  }
}
