// A robot with a device of a user's type whose code does what no device should.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catch.hpp"
#include "tests/emulator/judged_run.hpp"

namespace finemote::test {

/// Ended runs, as `run --format json` tells of them.
struct ProbeRun : JudgedRun {
  /// The firmware has noticed nothing.
  [[nodiscard]] bool counts_nothing() const {
    if (!document["fault_counts"].empty() || document["overruns"] != 0 || document["resets"] != 0) return false;
    REQUIRE(!document["monitor"].empty());
    for (const auto& device : document["monitor"]) {
      if (device["response_violations"] != 0 || device["age_violations"] != 0) return false;
    }
    return true;
  }
  /// The firmware's table holds this fault and nothing else.
  [[nodiscard]] bool counts_only(const char* module, unsigned number, unsigned count) const {
    return document["fault_counts"] == nlohmann::json{{{"module", module}, {"code", number}, {"count", count}}};
  }
};

/// The robot, in a folder of its own: the device `p` every 20 ms, and others.
class ProbeRobot {
 public:
  /// @param update  statements of the class `Probe`, which counts its updates in `count` from 1 and reaches a register
  ///                as `at(address)`
  /// @param update_ns  declared for it
  /// @param others  further tags of <finemote>
  ProbeRobot(const std::string& update, int update_ns, const std::string& others, const std::string& code = "sram") {
    const nlohmann::json descriptor = {{"schema", "finemote.device/1"},
                                       {"type", "probe"},
                                       {"summary", "does what it should not"},
                                       {"class", "my::Probe"},
                                       {"header", "probe.hpp"},
                                       {"provides", {{{"interface", "Any"}}}},
                                       {"constant_init", true},
                                       {"wcet", {{"update_ns", update_ns}, {"handle_ns", 1000}}}};
    std::filesystem::create_directories(folder_.path("devices"));
    for (const char* sway : {"sway.json", "sway.hpp"})
      write_file(folder_.path(std::string("devices/") + sway),
                 read_file(source_path(std::string("tests/emulator/bounds/devices/") + sway)));
    write_file(folder_.path("devices/probe.json"), descriptor.dump());
    write_file(folder_.path("devices/probe.hpp"), kBegin + update + kEnd);
    write_file(path(), R"(<robot name="r"><link name="base"/><finemote version="1"><board name="robomaster_type_c">
      <param name="code">)" +
                           code + R"(</param></board>)" + others +
                           R"(<device name="p" type="probe" period="20ms"/></finemote></robot>)");
  }

  [[nodiscard]] std::string path() const { return folder_.path("r.urdf"); }

  /// With the monitor, 200 ms long.
  [[nodiscard]] ProbeRun run(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> all = {"--monitor"};
    all.insert(all.end(), options.begin(), options.end());
    return {run_robot(path(), "200ms", all)};
  }

 private:
  static constexpr const char* kBegin = R"(#pragma once
#include <cstdint>
#include "finemote/contract.hpp"
#include "finemote/fault.hpp"
#include "finemote/sections.hpp"
namespace my {
FINEMOTE_DMA inline std::uint32_t source[8], target[8];
struct Probe {
  static volatile std::uint32_t& at(std::uint32_t address) {
    return *reinterpret_cast<volatile std::uint32_t*>(address);
  }
  static void spin(int turns) {
    for (int i = 0; i < turns; ++i) asm volatile("" ::: "memory");
  }
  void update() {
    ++count;
    )";
  static constexpr const char* kEnd = R"(
  }
  void handle() {}
  finemote::Stamp state;
  unsigned count = 0;
};
}  // namespace my
)";
  TemporaryFolder folder_;
};

/// A device every millisecond, more urgent than the probe.
inline const std::string kUrgentDevice = R"(<device name="urgent" type="sim_load" period="1ms">
  <param name="update">20us</param> <param name="handle">5us</param> <wcet update="25us" handle="10us"/></device>)";

}  // namespace finemote::test
