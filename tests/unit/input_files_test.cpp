// How a manifest names what was read.
#include "generator/output/input_files.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "generator/xml/read_source.hpp"

using namespace finemote::gen;
namespace fs = std::filesystem;

namespace {

/// A robot in the folder `robot` that includes a file elsewhere, in or below a ROS package.
struct Included {
  ~Included() { fs::remove_all(root); }

  /// What the manifest calls the file.
  [[nodiscard]] std::string name(const std::string& package_folder, const std::string& file) const {
    fs::create_directories(root / "robot");
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / package_folder / "package.xml") << "<package><name> arm_parts </name></package>";
    std::ofstream(root / file) << "<robot/>";
    Sources sources;
    Diagnostics diagnostics;
    REQUIRE(xml::read_source((root / file).string(), sources, diagnostics) != nullptr);
    const auto files = input_files(sources, (root / "robot").string(), (root / "data").string());
    REQUIRE(files.size() == 1);
    return files.front().name;
  }

  const fs::path root = fs::temp_directory_path() / ("finemote-input-files-test-" + std::to_string(getpid()));
};

}  // namespace

TEST_CASE("a file below the folder of the input is named from there, also where its folder begins with two dots") {
  CHECK(Included().name(".", "robot/..data/claw.xacro") == "..data/claw.xacro");
}

TEST_CASE("a file of a package is named by what the package calls itself, whatever its folder is called") {
  CHECK(Included().name("checked_out", "checked_out/parts/claw.xacro") == "package://arm_parts/parts/claw.xacro");
}
