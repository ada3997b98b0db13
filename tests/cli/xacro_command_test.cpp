// finemote xacro: what it writes, and what it keeps quiet about. What is expanded to what is in tests/xacro-cases.
#include <filesystem>

#include "catch.hpp"
#include "cli/program.hpp"

using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

std::string document(const std::string& content) {
  return "<r xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n" + content + "\n</r>\n";
}

}  // namespace

TEST_CASE("the xacro command writes nothing on failure, and makes folders on success") {
  const TemporaryFolder folder;
  write_file(folder.path("bad.xacro"), document("${"));
  write_file(folder.path("good.xacro"),
             document("<xacro:include filename=\"part.xacro\"/><v>${xacro.load_yaml('v.yaml')}</v>"));
  write_file(folder.path("part.xacro"), document("<p/>"));
  write_file(folder.path("v.yaml"), "3");
  const std::string made = folder.path("new/out.urdf");
  CHECK(run_finemote({"xacro", folder.path("bad.xacro"), "-o", made}).exit_status == 2);
  CHECK_FALSE(fs::exists(folder.path("new")));
  const auto good = run_finemote({"xacro", folder.path("good.xacro"), "-o", made});
  CHECK(good.exit_status == 0);
  CHECK(good.output.empty());
  CHECK(files_below(folder.path("new")).size() == 1);
  CHECK(run_finemote({"xacro", folder.path("good.xacro"), "--deps"}).output ==
        folder.path("part.xacro") + " " + folder.path("v.yaml"));
}

TEST_CASE("warnings do not fail the xacro command, and -q drops them") {
  const TemporaryFolder folder;
  const std::string path = folder.path("in.xacro");
  write_file(path, document("<xacro:property name=\"pi\" value=\"3\" extra=\"1\"/>"));
  const auto loud = run_finemote({"xacro", path});
  CHECK(loud.exit_status == 0);
  CHECK(loud.output.find(":2:34: warning[FM1051]: redefining global symbol: pi") != std::string::npos);
  CHECK(loud.output.find("warning[FM1050]: xacro:property: unknown attribute(s): extra") != std::string::npos);
  CHECK(run_finemote({"xacro", "-q", path}).output.find("warning") == std::string::npos);
}
