// finemote fmt: the canonical layout, and that it changes nothing else.
#include <filesystem>

#include "catch.hpp"
#include "cli/program.hpp"

using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

/// What fmt makes of a text.
std::string laid_out(const std::string& text) {
  const TemporaryFolder folder;
  write_file(folder.path("robot.urdf"), text);
  REQUIRE(run_finemote({"fmt", folder.path("robot.urdf"), "-q"}).exit_status == 0);
  return read_file(folder.path("robot.urdf"));
}

const std::string kUntidy = R"(<robot name='r'>
    <link   name='base_link' />
  <!-- before --><finemote version='1'>


    <board tick="1ms"   name='robomaster_type_c'></board>  <!-- of the
      year -->
      <!-- the tree
           of one -->
    <device period="10ms" type="group" name="g"><device name="a"
        role='children' type="sim_load">
      <param name="update"> 10us </param>
      <wcet handle='2us' update="1us"></wcet></device>



      <reads role="x" device='say "hi"'/><!-- last -->

    </device></finemote>
</robot>
)";

const std::string kTidy = R"(<robot name='r'>
    <link   name='base_link' />
  <!-- before --><finemote version="1">
  <board name="robomaster_type_c" tick="1ms"/>  <!-- of the
      year -->
  <!-- the tree
           of one -->
  <device name="g" type="group" period="10ms">
    <device name="a" type="sim_load" role="children">
      <param name="update">10us</param>
      <wcet update="1us" handle="2us"/>
    </device>

    <reads device='say "hi"' role="x"/>  <!-- last -->
  </device>
</finemote>
</robot>
)";

}  // namespace

TEST_CASE("fmt brings <finemote> into its layout and touches nothing else") {
  CHECK(laid_out(kUntidy) == kTidy);
  CHECK(laid_out(kTidy) == kTidy);
}

TEST_CASE("fmt breaks lines of more than 120 columns between attributes") {
  const std::string name(60, 'n'), link(60, 'l');
  CHECK(laid_out("<robot>\n  <finemote><device joint=\"j\" name=\"" + name + "\" link=\"" + link +
                 "\"/></finemote>\n</robot>") == "<robot>\n  <finemote>\n    <device name=\"" + name +
                                                     "\"\n            link=\"" + link +
                                                     "\" joint=\"j\"/>\n  </finemote>\n</robot>");
}

TEST_CASE("fmt keeps what it does not know: elements of xacro, mixed text, CR line ends, a byte order mark") {
  const std::string xacro = R"(<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="m" params="b a">
    <finemote>
      <xacro:wheel b="1" a="${'>'}"/>
      <param name="x"><![CDATA[ <raw> ]]></param>
      <note>some <b/> text</note>
      <?say x?>
    </finemote>
  </xacro:macro>
</robot>
)";
  CHECK(laid_out(xacro) == xacro);
  CHECK(laid_out("\xEF\xBB\xBF<robot>\r\n<finemote>\r\n<board/></finemote></robot>\r\n") ==
        "\xEF\xBB\xBF<robot>\r\n<finemote>\r\n  <board/>\r\n</finemote></robot>\r\n");
}

TEST_CASE("fmt takes nothing inside a document type for markup") {
  const std::string text = R"(<!DOCTYPE robot [
  <!-- parts [0] and [1]> of the robot -->
  <?note > ]> ?>
  <!ENTITY fm "<link name='x'/><finemote version='1'><board   name='host'/></finemote>">
  <!ENTITY bracket ']>'>
]>
<robot name="r"><link name="a"/>&fm;</robot>
)";
  CHECK(laid_out(text) == text);
}

TEST_CASE("every example is the same robot in canonical layout, and stays in it") {
  for (const std::string& robot : example_robots()) {
    INFO(robot);
    const TemporaryFolder folder;
    fs::copy(source_path("examples"), folder.path(), fs::copy_options::recursive);
    const std::string copy = folder.path(robot);
    REQUIRE(run_finemote({"fmt", copy}).exit_status == 0);
    CHECK(run_finemote({"fmt", copy, "--dry-run"}).output.empty());
    CHECK(run_finemote({"diff", source_path("examples/" + robot), copy}).exit_status == 0);
  }
}

TEST_CASE("fmt --dry-run says where a line break is lacking, and ends soon where every line changes") {
  const TemporaryFolder folder;
  std::string text = "<robot name='r'><link name='a'/><finemote version='1'>\n";
  for (int i = 0; i < 20000; ++i) text += "<device name='d" + std::to_string(i) + "' type='sim_load'/>\n";
  write_file(folder.path("robot.urdf"), text + "</finemote></robot>");
  const auto all = run_finemote({"fmt", folder.path("robot.urdf"), "--dry-run"});
  CHECK(all.exit_status == 1);
  CHECK(all.output.find("@@ -1,20002 +1,") != std::string::npos);
  CHECK(all.output.find("\n\\ No newline at end of file\n+") != std::string::npos);
}

TEST_CASE("fmt --dry-run shows what would change and writes nothing; of standard input the text is printed") {
  const TemporaryFolder folder;
  const std::string robot = folder.path("robot.urdf");
  write_file(robot, kUntidy);
  const auto said = run_finemote({"fmt", robot, "--dry-run"});
  CHECK(said.exit_status == 1);
  CHECK(said.output.find("--- a/robot.urdf\n+++ b/robot.urdf\n") == 0);
  CHECK(read_file(robot) == kUntidy);
  write_file(robot, "<robot><finemote></robot>");
  CHECK(run_finemote({"fmt", robot}).exit_status == 2);
  CHECK(read_file(robot) == "<robot><finemote></robot>");
}
