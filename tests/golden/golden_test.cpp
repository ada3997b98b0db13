// Every example's generated files against the ones in the repository.
#include "catch.hpp"
#include "cli/program.hpp"
#include "tests/rewrites.hpp"

#include <cstdlib>
#include <filesystem>

using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

/// `finsrov.urdf.xacro` beside `finsrov.urdf`: generate_test holds the two to the same files.
bool is_second_form(const std::string& robot) {
  return fs::path(robot).extension() == ".xacro" &&
         fs::exists(source_path("examples/" + fs::path(robot).stem().string()));
}

}  // namespace

TEST_CASE("every example generates the files that were reviewed") {
  const bool update = finemote::test::rewrites();
  for (const std::string& robot : example_robots()) {
    if (is_second_form(robot)) continue;
    INFO(robot);
    const std::string golden = source_path("tests/golden/" + robot);
    TemporaryFolder folder;
    REQUIRE(run_finemote({"generate", source_path("examples/" + robot), "-o", folder.path("out")}).exit_status == 0);
    fs::remove(folder.path("out/finemote.manifest.json"));  // its hashes change with every word of the input
    if (update) {
      fs::remove_all(golden);
      fs::copy(folder.path("out"), golden, fs::copy_options::recursive);
    }
    const auto expected = files_below(golden);
    const auto actual = files_below(folder.path("out"));
    CHECK(expected.size() == actual.size());
    for (const auto& [name, text] : actual) {
      INFO(name);
      const auto found = expected.find(name);
      REQUIRE(found != expected.end());
      CHECK(found->second == text);
    }
  }
}
