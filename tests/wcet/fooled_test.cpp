// Devices of users that once had a bound below what they took, or whose true marks a run called broken.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

constexpr const char* kDescriptor = R"({"schema": "finemote.device/1", "type": "walker", "summary": "walks",
  "class": "my::Walker", "header": "walker.hpp", "provides": [{"interface": "Any"}], "params": [],
  "wcet": {"update_ns": 700000, "handle_ns": 1000}, "constant_init": CONSTANT})";

/// With a device that preempts nothing but moves the stack of what it interrupts.
constexpr const char* kRobot = R"(<robot name="r"><link name="base"/><finemote version="1">
  <board name="robomaster_type_c"/>
  <device name="w" type="walker" period="1ms"/>
  <device name="load" type="sim_load" period="7ms"><param name="update">900us</param></device></finemote></robot>)";

std::vector<fs::path> all_cases() {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(source_path("tests/wcet/fooling"))) all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

/// Of a header that has a second device: the first is long, and the second comes in between.
constexpr const char* kPreempted = R"(<robot name="r"><link name="base"/><finemote version="1">
  <board name="robomaster_type_c"/>
  <device name="w" type="walker" period="20ms"/>
  <device name="u" type="urgent" period="1ms"/></finemote></robot>)";

std::string with(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

/// Into a folder with a robot that has one of it.
void write_robot(const TemporaryFolder& folder, const std::string& header) {
  const bool is_constant = header.find("Walker()") == std::string::npos;
  const bool is_preempted = header.find("struct Urgent") != std::string::npos;
  std::string descriptor = with(kDescriptor, "CONSTANT", is_constant ? "true" : "false");
  fs::create_directories(folder.path("devices"));
  if (is_preempted) {
    const std::string urgent = with(with(descriptor, "my::Walker", "my::Urgent"), "\"walker\"", "\"urgent\"");
    write_file(folder.path("devices/urgent.json"), with(urgent, "700000", "1000"));
    descriptor = with(descriptor, "700000", "5000000");
  }
  write_file(folder.path("devices/walker.json"), descriptor);
  write_file(folder.path("devices/walker.hpp"), header);
  write_file(folder.path("r.urdf"), is_preempted ? kPreempted : kRobot);
}

}  // namespace

TEST_CASE("nobody gets a bound from what only looks constant, and no true mark is called broken") {
  const std::vector<fs::path> cases = all_cases();
  REQUIRE(cases.size() >= 30);
  for (const fs::path& path : cases) {
    const std::string header = read_file(path.string());
    const bool is_bounded = header.rfind("// bounded: ", 0) == 0;
    CAPTURE(path.filename().string());
    REQUIRE((is_bounded || header.rfind("// refused: ", 0) == 0));
    const TemporaryFolder folder;
    write_robot(folder, header);
    const auto bounded = run_finemote({"wcet", folder.path("r.urdf"), "-o", folder.path("r.timing.json")});
    CAPTURE(bounded.output);
    CHECK(bounded.exit_status == (is_bounded ? 0 : 1));
    const auto ran = run_finemote({"run", folder.path("r.urdf"), "--slowest", "--duration", "50ms"});
    CAPTURE(ran.output);
    CHECK(ran.output.find("FM6006") == std::string::npos);
    CHECK(ran.output.find("FM6014") == std::string::npos);
    const bool has_stack =
        ran.output.find("FM6105") == std::string::npos && ran.output.find("FM6106") == std::string::npos;
    if (!is_bounded && !has_stack) continue;  // none is enough, or known to be: it does not run
    CHECK(ran.exit_status == 0);
  }
}
