// Whole robots with their code in SRAM against the same robots in flash: one order, chains that hold, no wait states.
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;

namespace {

nlohmann::json run(const std::string& robot, const std::string& flash) {
  return finemote_json({"run", robot, "--duration", "200ms", "--flash", flash});
}

/// The example with its code in flash.
std::string robot_in_flash(const TemporaryFolder& folder, const std::string& name) {
  const std::string from = "<param name=\"code\">sram</param>";
  std::string text = read_file(source_path("examples/" + name + ".urdf"));
  REQUIRE(text.find(from) != std::string::npos);
  text.replace(text.find(from), from.size(), "<param name=\"code\">flash</param>");
  std::string path = folder.path() + "/" + name + ".urdf";
  std::ofstream(path) << text;
  return path;
}

/// Devices and stages in the order they ran in.
std::vector<std::string> order_of(const nlohmann::json& document) {
  std::vector<std::string> order;
  for (const auto& event : document["events"])
    order.push_back(event["device"].get<std::string>() + " " + event["stage"].get<std::string>());
  return order;
}

}  // namespace

TEST_CASE("a robot with its code in SRAM runs as in flash, also where flash misses") {
  for (const std::string name : {"finsrov", "infantry"}) {
    INFO(name);
    const TemporaryFolder folder;
    const std::string robot = source_path("examples/" + name + ".urdf");
    const auto flash = run(robot_in_flash(folder, name), "hit");
    CHECK(flash["image"]["code_ram"] == 0);
    for (const std::string mode : {"hit", "miss"}) {
      const auto sram = run(robot, mode);  // exit status 0: chains, responses and own times hold
      CHECK(sram["order"]["judged"] == true);
      CHECK(sram["order"]["mistake"].is_null());
      CHECK(order_of(sram) == order_of(flash));
      CHECK(sram["image"]["code_ram"] > 16'000);
      CHECK(sram["image"]["ram"] == flash["image"]["ram"]);
      REQUIRE(!sram["stages"].empty());
      REQUIRE(sram["stages"].size() == flash["stages"].size());
      for (std::size_t i = 0; i < flash["stages"].size(); ++i) {
        const double in_sram = sram["stages"][i]["own_max_ns"], in_flash = flash["stages"][i]["own_max_ns"];
        INFO(sram["stages"][i].dump());
        CHECK(in_sram <= 1.1 * in_flash);  // the phases of the clocks differ
        CHECK(in_sram >= 0.9 * in_flash);
      }
    }
  }
}

// The design wants 16 KiB and 3.5 KiB, which are not reached.
TEST_CASE("FinsROV's image does not grow unnoticed") {
  const auto image = finemote_json({"run", source_path("examples/finsrov.urdf"), "--build-only"})["image"];
  REQUIRE(image["flash"].get<int>() > 8 * 1024);
  REQUIRE(image["ram"].get<int>() > 1024);
  CHECK(image["flash"].get<int>() <= 26 * 1024);
  CHECK(image["ram"].get<int>() <= 4608);
}
