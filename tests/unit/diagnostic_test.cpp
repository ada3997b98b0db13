#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/suggest.hpp"

using namespace finemote::gen;

TEST_CASE("a message names place, excerpt, caret, notes and hints") {
  Sources sources;
  const SourceFile* file = sources.add(SourceFile{"robot.urdf", "", "<robot>\n  <bus port=\"i2c9\"/>\n"});
  Diagnostics diagnostics;
  diagnostics.error(Code{3012}, {file, 2, 14}, "board 'x' has no port 'i2c9'")
      .underline(4)
      .hint("did you mean 'i2c2'?");
  CHECK(render_text(diagnostics, false) ==
        "robot.urdf:2:14: error[FM3012]: board 'x' has no port 'i2c9'\n"
        "    2 |   <bus port=\"i2c9\"/>\n"
        "      |              ^~~~\n"
        "  hint: did you mean 'i2c2'?\n");
}

TEST_CASE("findings are reported in file order, an expansion where its call stands") {
  Sources sources;
  const SourceFile* main = sources.add(SourceFile{"a.xacro", "", ""});
  const SourceFile* part = sources.add(SourceFile{"z.xacro", "", ""});
  const Expansion* call = sources.add(Expansion{Expansion::Kind::macro, "thruster", {main, 3, 1}});
  Diagnostics diagnostics;
  diagnostics.error(Code{1}, {main, 9, 1}, "last");
  diagnostics.error(Code{1}, {part, 1, 1, call}, "middle");
  diagnostics.error(Code{1}, {main, 2, 1}, "first");
  const auto sorted = diagnostics.in_file_order();
  CHECK(sorted[0].message == "first");
  CHECK(sorted[1].message == "middle");
  CHECK(sorted[2].message == "last");
  CHECK(render_text(diagnostics, false).find("note: expanded from macro 'thruster' at a.xacro:3:1") !=
        std::string::npos);
}

TEST_CASE("a mistyped word is one letter off, and a long one two") {
  for (const char* word : {"xzy", "zyx", "XYZ", "xy", "xyzz"}) CHECK(is_mistyped(word, "xyz"));
  CHECK(is_mistyped("limits", "limit"));
  CHECK(is_mistyped("intertail", "inertial"));
  for (const char* word : {"xyz", "abc", "x", "rgba", "quat_xyzw"}) CHECK_FALSE(is_mistyped(word, "xyz"));
  for (const char* word : {"visual", "transmission", "drake:limit", "material"})
    CHECK_FALSE(is_mistyped(word, "limit"));
}

TEST_CASE("the nearest names come first") {
  CHECK(did_you_mean("i2c9", {"usart1", "i2c2", "i2c3"}) == "did you mean 'i2c2' or 'i2c3'?");
  CHECK(did_you_mean("Baud", {"clock", "baud"}) == "did you mean 'baud'?");
  CHECK(did_you_mean("zzzzzz", {"a", "b"}) == "valid here: 'a', 'b'");
  CHECK(did_you_mean("x", {}).empty());
}

TEST_CASE("a name known in part is found: by a part of it, by a family, by a word they share") {
  const std::vector<std::string> types{"dji_gm6020", "dji_m2006", "dji_m3508",
                                       "dm_motor",   "h30_imu",   "mecanum_chassis"};
  CHECK(did_you_mean("m3508", types) == "did you mean 'dji_m3508'?");
  CHECK(did_you_mean("M3508_motor", types) == "did you mean 'dji_m3508' or 'dm_motor'?");
  CHECK(did_you_mean("dm4310", types) == "did you mean 'dm_motor'?");
  CHECK(did_you_mean("rm_imu", types) == "did you mean 'h30_imu'?");
  CHECK(did_you_mean("chassis_mecanum", types) == "did you mean 'mecanum_chassis'?");
  CHECK(did_you_mean("3508", types) == "did you mean 'dji_m3508'?");
  CHECK(did_you_mean("GM6020", types) == "did you mean 'dji_gm6020'?");
  CHECK(did_you_mean("type_c", {"host", "qemu_f405", "robomaster_type_c"}) == "did you mean 'robomaster_type_c'?");
  CHECK(did_you_mean("radius", {"reach", "wheel_radius"}) == "did you mean 'wheel_radius'?");
  CHECK(did_you_mean("xy", {"proxy_name", "xylophone"}) == "valid here: 'proxy_name', 'xylophone'");
}
