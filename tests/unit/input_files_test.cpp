// How a manifest names what was read.
#include "generator/output/input_files.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "generator/xml/read_source.hpp"

using namespace finemote::gen;
namespace fs = std::filesystem;

TEST_CASE("a file below the folder of the input is named from there, also where its folder begins with two dots") {
  const fs::path root = fs::temp_directory_path() / ("finemote-input-files-test-" + std::to_string(getpid()));
  fs::create_directories(root / "robot" / "..data");
  std::ofstream(root / "package.xml") << "<package><name>arm</name></package>";
  const fs::path included = root / "robot" / "..data" / "claw.xacro";
  std::ofstream(included) << "<robot/>";
  Sources sources;
  Diagnostics diagnostics;
  REQUIRE(xml::read_source(included.string(), sources, diagnostics) != nullptr);
  const auto files = input_files(sources, (root / "robot").string(), (root / "data").string());
  fs::remove_all(root);
  REQUIRE(files.size() == 1);
  CHECK(files.front().name == "..data/claw.xacro");
}

TEST_CASE("a file of a package is named by what the package calls itself, whatever its folder is called") {
  const fs::path root = fs::temp_directory_path() / ("finemote-input-files-test-" + std::to_string(getpid()));
  fs::create_directories(root / "robot");
  fs::create_directories(root / "checked_out" / "parts");
  std::ofstream(root / "checked_out" / "package.xml") << "<package><name> arm_parts </name></package>";
  const fs::path included = root / "checked_out" / "parts" / "claw.xacro";
  std::ofstream(included) << "<robot/>";
  Sources sources;
  Diagnostics diagnostics;
  REQUIRE(xml::read_source(included.string(), sources, diagnostics) != nullptr);
  const auto files = input_files(sources, (root / "robot").string(), (root / "data").string());
  fs::remove_all(root);
  REQUIRE(files.size() == 1);
  CHECK(files.front().name == "package://arm_parts/parts/claw.xacro");
}
