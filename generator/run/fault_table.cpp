#include "generator/run/fault_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/file/installed_file.hpp"

namespace finemote::gen {

using Json = nlohmann::ordered_json;

FaultTable load_fault_table(const std::string& data_dir) {
  const std::string path = data_dir + "/schemas/faults.json";
  const Json json = Json::parse(read_installed(path), nullptr, false);
  if (json.is_discarded()) throw DamagedInstallation(path);
  FaultTable table;
  for (const Json& entry : json.at("faults")) {
    FaultMeaning meaning;
    meaning.module = entry.at("module").get<unsigned>();
    if (entry.contains("number")) meaning.number = entry.at("number").get<unsigned>();
    meaning.module_name = entry.at("name").get<std::string>();
    meaning.what = entry.at("what").get<std::string>();
    meaning.effect = entry.at("effect").get<std::string>();
    meaning.stops = entry.value("stops", false);
    meaning.overrun = entry.value("overrun", false);
    table.push_back(std::move(meaning));
  }
  return table;
}

const FaultMeaning* meaning_of(const FaultTable& table, const FaultCount& fault) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const FaultMeaning& meaning) {
    return meaning.module == fault.module && meaning.number.value_or(fault.number) == fault.number;
  });
  return found == table.end() ? nullptr : &*found;
}

std::string fault_text(const FaultTable& table, const FaultCount& fault) {
  const FaultMeaning* meaning = meaning_of(table, fault);
  const std::string times = fault.count > 1 ? fmt::format(", {} times", fault.count) : "";
  if (meaning == nullptr) return fmt::format("fault {} of module {}{}", fault.number, fault.module, times);
  return fmt::format("{} ({} {}){}", meaning->what, meaning->module_name, fault.number, times);
}

const FaultCount* stopping_fault(const FaultTable& table, const std::vector<FaultCount>& faults, bool overrun_stops) {
  const auto find = [&](auto stops) {
    return std::find_if(faults.begin(), faults.end(), [&](const FaultCount& fault) {
      const FaultMeaning* meaning = meaning_of(table, fault);
      return meaning != nullptr && stops(*meaning);
    });
  };
  auto found = find([](const FaultMeaning& meaning) { return meaning.stops; });
  if (found == faults.end() && overrun_stops) found = find([](const FaultMeaning& meaning) { return meaning.overrun; });
  return found == faults.end() ? nullptr : &*found;
}

void report_safe_stop(const FaultTable& table, const std::vector<FaultCount>& faults, const FaultCount& stopped,
                      const std::string& when, Diagnostics& diagnostics) {
  auto& finding =
      diagnostics.error(code::firmware_stopped, {},
                        fmt::format("the firmware went to its safe stop {}: {}", when, fault_text(table, stopped)));
  for (const FaultCount& fault : faults) {
    if (&fault != &stopped) finding.note("it also counted: " + fault_text(table, fault));
  }
  finding.note("docs/reference/faults.md lists the faults");
}

}  // namespace finemote::gen
