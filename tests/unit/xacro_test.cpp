// Documents: positions, messages and bounds. What is expanded to what is in tests/xacro-cases.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/xacro/expand.hpp"
#include "generator/xacro/expand_file.hpp"
#include "generator/xacro/macro.hpp"
#include "generator/xml/write.hpp"
#include "tests/temporary_folder.hpp"

using namespace finemote::gen;
namespace fs = std::filesystem;

namespace {

struct Expanded {
  Sources sources;
  Diagnostics diagnostics;
  xacro::Dependencies dependencies;
  std::optional<xml::Document> document;
  [[nodiscard]] std::string report() const { return render_text(diagnostics, false); }
  [[nodiscard]] std::string text() const { return document ? xml::write(document->root) : report(); }
};

/// Expands a root element with this content.
Expanded expand(const std::string& content, const xacro::Arguments& arguments = {}) {
  Expanded e;
  const std::string text = "<r xmlns:xacro='http://www.ros.org/wiki/xacro'>" + content + "</r>";
  const SourceFile* file = e.sources.add(SourceFile{"in.xacro", "in.xacro", text});
  e.document = xacro::expand(*file, arguments, {}, e.sources, e.diagnostics, e.dependencies);
  return e;
}

/// A folder of files that exists as long as the test needs it.
class Folder {
 public:
  void add(const std::string& name, const std::string& content) const {
    fs::create_directories(fs::path(*this / name).parent_path());
    std::ofstream(*this / name, std::ios::binary) << content;
  }
  [[nodiscard]] std::string operator/(const std::string& name) const { return folder_.path(name); }

 private:
  finemote::test::TemporaryFolder folder_;
};

struct Run {
  int status;
  std::string out;
  std::string err;
};

/// What is printed of a file, and what is said of it.
Run run(const std::string& path) {
  Sources sources;
  Diagnostics diagnostics;
  std::ostringstream messages;
  const auto expanded = xacro::expand_file(path, {}, {}, sources, diagnostics, &messages);
  return {expanded ? 0 : 2, expanded ? expanded->document : "", messages.str() + render_text(diagnostics, false)};
}

std::string document(const std::string& content) {
  return "<r xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n" + content + "\n</r>\n";
}

}  // namespace

TEST_CASE("xacro: an element from a macro knows where it is written and where the macro was called") {
  const auto e = expand("\n<xacro:macro name='m' params='n'>\n  <link name='${n}'/>\n</xacro:macro>\n<xacro:m n='a'/>");
  REQUIRE(e.document);
  const auto& children = e.document->root.children;
  const auto link = std::find_if(children.begin(), children.end(), [](const auto& n) { return n.is_element("link"); });
  REQUIRE(link != children.end());
  CHECK(link->at.line == 3);
  CHECK(link->at.column == 3);
  REQUIRE(link->at.via != nullptr);
  CHECK(link->at.via->name == "m");
  CHECK(link->at.via->at.line == 5);
  CHECK(link->at.via->at.via == nullptr);
  CHECK(link->attributes.at(0).value_at.column == 15);
  CHECK(link->attributes.at(0).value_at.via == link->at.via);
}

TEST_CASE("xacro: a block keeps the place where its caller wrote it") {
  const auto e = expand(
      "\n<xacro:macro name='m' params='*b'><xacro:insert_block name='b'/></xacro:macro>\n<xacro:m><o/></xacro:m>");
  REQUIRE(e.document);
  const auto& children = e.document->root.children;
  const auto block = std::find_if(children.begin(), children.end(), [](const auto& n) { return n.is_element("o"); });
  REQUIRE(block != children.end());
  CHECK(block->at.line == 3);
  CHECK(block->at.via == nullptr);
}

TEST_CASE("xacro: an error inside macros and includes names the text and the whole way to it") {
  const Folder folder;
  folder.add("in.xacro", document("<xacro:include filename=\"lib.xacro\"/>\n<xacro:outer/>"));
  folder.add("lib.xacro", document("<xacro:macro name=\"inner\"><a v=\"1 ${nope}\"/></xacro:macro>\n"
                                   "<xacro:macro name=\"outer\"><xacro:inner/></xacro:macro>"));
  const auto r = run(folder / "in.xacro");
  CHECK(r.status == 2);
  CHECK(r.out.empty());
  CHECK(r.err == (folder / "lib.xacro") +
                     ":2:35: error[FM1010]: name 'nope' is not defined when evaluating expression 'nope'\n"
                     "    2 | <xacro:macro name=\"inner\"><a v=\"1 ${nope}\"/></xacro:macro>\n"
                     "      |                                   ^\n" +
                     "  note: expanded from macro 'inner' at " + (folder / "lib.xacro") + ":3:27\n" +
                     "  note: expanded from macro 'outer' at " + (folder / "in.xacro") + ":3:1\n");
}

TEST_CASE("xacro: a lazy property is blamed where it is written") {
  const auto e = expand("\n<xacro:property name='p' value='${1/0}'/>\n<a v='${p + 1}'/>");
  CHECK(
      e.report().find("in.xacro:2:33: error[FM1010]: division by zero when evaluating expression '1/0' when evaluating "
                      "expression 'p + 1'") == 0);
  CHECK(e.report().find("note: needed for 'p + 1' (in.xacro:3:7)") != std::string::npos);
}

TEST_CASE("xacro: a missing argument of a macro is answered with what to write") {
  const auto e = expand("<xacro:macro name='m' params='a b'/><xacro:m a='1'/>");
  CHECK(e.report().find("error[FM1024]: Undefined parameters [b]") != std::string::npos);
  CHECK(e.report().find("hint: add for example b=\"...\" to the call of 'm'") != std::string::npos);
}

TEST_CASE("xacro: arguments of a call into a namespace see the namespace first, then the caller") {
  const Folder folder;
  folder.add("lib.xacro", document("<xacro:property name=\"x\" value=\"lib\"/>"
                                   "<xacro:macro name=\"m\" params=\"v\"><a v=\"${v}\"/></xacro:macro>"));
  folder.add(
      "in.xacro",
      document("<xacro:include filename=\"lib.xacro\" ns=\"L\"/>"
               "<xacro:macro name=\"o\" params=\"x y\"><xacro:L.m v=\"${x}\"/><xacro:L.m v=\"${y}\"/></xacro:macro>"
               "<xacro:o x=\"1\" y=\"2\"/>"));
  const auto r = run(folder / "in.xacro");
  CHECK(r.out.find("<a v=\"lib\"/>") != std::string::npos);
  CHECK(r.out.find("<a v=\"2\"/>") != std::string::npos);
}

TEST_CASE("xacro: parameters of macros") {
  const auto call = [](const std::string& parameters, const std::string& arguments = "") {
    return expand("<xacro:property name='p' value='P'/><xacro:macro name='m' params=\"" + parameters +
                  "\"><x a='${a}'/></xacro:macro><xacro:m " + arguments + "/>")
        .text();
  };
  const auto gives = [&](const std::string& parameters, const std::string& value) {
    return call(parameters).find("<x a=\"" + value + "\"/>") != std::string::npos;
  };
  CHECK(gives("a:=1.50", "1.5"));
  CHECK(gives("a=b", "b"));
  CHECK(gives("a:='x  y' b:=1", "x  y"));
  CHECK(gives("a:=${p}_1", "P_1"));
  CHECK(gives("a:=${[1, 2]} b:=2", "[1, 2]"));
  CHECK(gives("a:=^|none", "none"));
  CHECK(gives("a:=''", ""));
  CHECK(gives("a:=", ""));
  CHECK(gives(" b:=2   a:=3 ", "3"));
  CHECK(call("a:=^").find("Undefined property to forward: a") != std::string::npos);
  CHECK(call("a", "a='1' c='2'").find("Invalid parameter \"c\"") != std::string::npos);
}

TEST_CASE("xacro: stored texts become the values Python would read") {
  const auto stored = [](const std::string& text) {
    return expand("<xacro:property name='p' value='" + text + "'/><a t='${python.type(p)}' v='${p}'/>").text();
  };
  const auto is = [&](const std::string& text, const std::string& type, const std::string& value) {
    return stored(text).find("<a t=\"&lt;class '" + type + "'&gt;\" v=\"" + value + "\"/>") != std::string::npos;
  };
  CHECK(is("007", "int", "7"));
  CHECK(is(" 42 ", "int", "42"));
  CHECK(is("1_000", "str", "1_000"));
  CHECK(is("1e400", "float", "inf"));
  CHECK(is("0x10", "str", "0x10"));
  CHECK(is("true", "bool", "True"));
  CHECK(is(std::string(5000, 'x'), "str", std::string(5000, 'x')));
  CHECK(is(std::string(5000, '9'), "float", "inf"));
}

TEST_CASE("xacro: xacro:attribute inside a condition reaches the element") {
  CHECK(expand("<a><xacro:if value='1'><xacro:attribute name='b' value='${1+1}'/></xacro:if></a>").text() ==
        "<r>\n  <a b=\"2\"/>\n</r>\n");
}

TEST_CASE("xacro: limits end what does not end by itself, with a place") {
  const auto ends = [](const Expanded& e, const std::string& words) {
    CAPTURE(e.report().substr(0, 300));
    return !e.document && e.report().find("in.xacro:1:") == 0 && e.report().find(words) != std::string::npos;
  };
  CHECK(ends(expand("<xacro:macro name='m'><xacro:m/></xacro:macro><xacro:m/>"), "maximum recursion depth exceeded"));
  CHECK(ends(expand("<xacro:macro name='m'><a><xacro:m/></a></xacro:macro><xacro:m/>"), "FM1011"));
  CHECK(expand("<xacro:macro name='m'><a><b><xacro:m/></b></a></xacro:macro><xacro:m/>")
            .report()
            .find("in.xacro:1:70: ") == 0);
  CHECK(ends(
      expand("<xacro:macro name='m' params='n'><xacro:if value='${n > 0}'><xacro:m n='${n-1}'/><xacro:m n='${n-1}'/>"
             "</xacro:if></xacro:macro><xacro:m n='60'/>"),
      "macro calls"));
  CHECK(ends(
      expand("<xacro:property name='b'><xacro:insert_block name='b'/></xacro:property><xacro:insert_block name='b'/>"),
      "inserts itself"));
  CHECK(ends(expand("<xacro:property name='a' value='${b}'/><xacro:property name='b' value='${a}'/><x v='${a}'/>"),
             "circular variable definition: a -> b -> a"));
  std::string chain = "<xacro:property name='p0' value='${[1]}'/>";
  for (int i = 1; i < 60; ++i) {
    const std::string before = "p" + std::to_string(i - 1);
    chain += "<xacro:property name='p" + std::to_string(i) + "' value='${" + before + "+" + before + "}'/>";
  }
  CHECK(ends(expand(chain + "<x v='${p59}'/>"), "FM1011"));
}

TEST_CASE("xacro: a thousand nested calls and elements are no problem") {
  const auto e = expand(
      "<xacro:macro name='m' params='n'><a><xacro:if value='${n > 1}'><xacro:m n='${n-1}'/></xacro:if></a>"
      "</xacro:macro><xacro:m n='1000'/>");
  REQUIRE(e.document);
  std::size_t depth = 0;
  for (const xml::Node* n = &e.document->root; !n->children.empty(); n = &n->children[0]) ++depth;
  CHECK(depth == 1000);
}

TEST_CASE("xacro: include cycles end with the way they took") {
  const Folder folder;
  folder.add("a.xacro", document("<xacro:include filename=\"b.xacro\"/>"));
  folder.add("b.xacro", document("<xacro:include filename=\"a.xacro\"/>"));
  const auto r = run(folder / "a.xacro");
  CHECK(r.status == 2);
  CHECK(r.err.find("FM1011") != std::string::npos);
  CHECK(r.err.find("included as '" + (folder / "b.xacro")) != std::string::npos);
}

TEST_CASE("xacro: files that cannot be read") {
  const Folder folder;
  folder.add("in.xacro", document("<xacro:include filename=\"none.xacro\"/>"));
  folder.add("optional.xacro", document("<xacro:include filename=\"none.xacro\" optional=\"true\"/><a/>"));
  folder.add("broken.xacro", document("<xacro:include filename=\"bad.xacro\" optional=\"true\"/>"));
  folder.add("bad.xacro", "<r>\n  <a>\n</r>");
  folder.add("bytes.xacro", document("<xacro:include filename=\"latin.xacro\"/>"));
  folder.add("latin.xacro", "<r>\xE9</r>");
  CHECK(run(folder / "in.xacro").err.find(":2:1: error[FM1027]: No such file or directory: ") != std::string::npos);
  CHECK(run(folder / "optional.xacro").status == 0);
  const auto broken = run(folder / "broken.xacro");
  CHECK(broken.status == 2);
  CHECK(broken.err.find((folder / "bad.xacro") +
                        ":3:3: error[FM1001]: XML parsing error: mismatched tag: line 3, column 2") == 0);
  CHECK(broken.err.find("note: included as") != std::string::npos);
  CHECK(run(folder / "bytes.xacro").err.find((folder / "latin.xacro") + ":1:4: error[FM0004]") == 0);
  CHECK(run(folder / "missing.xacro").err.find("error[FM0002]: cannot read") != std::string::npos);
  CHECK(run(folder / "missing.xacro").status == 2);
}

TEST_CASE("xacro: packages are found by the first of four ways") {
  const Folder folder;
  const auto package = [&](const std::string& path, const std::string& name) {
    folder.add(path + "/package.xml",
               "<?xml version=\"1.0\"?><package><!-- <name>no</name> --><name> " + name + "\n</name></package>");
  };
  package("ws/src/deep/arm", "arm_description");
  package("ws/src/deep/arm/inner", "hidden");
  package("ws/src/other", "arm_description");
  package("own", "own_pkg");
  folder.add("own/urdf/in.xacro", "<r/>");
  folder.add("prefix/share/base/x", "");
  folder.add("ws/src/skipped/COLCON_IGNORE", "");
  package("ws/src/skipped/pkg", "skipped_pkg");

  xacro::PackagePath packages;
  packages.add_ros_path(folder / "ws");
  packages.add_ament_path(folder / "prefix");
  packages.set_entry(folder / "own/urdf/in.xacro");
  REQUIRE(packages.find("arm_description", {}));
  CHECK(packages.find("arm_description", {})->folder == folder / "ws/src/deep/arm");
  CHECK(packages.find("arm_description", {})->others == std::vector<std::string>{folder / "ws/src/other"});
  CHECK(packages.find("base", {})->folder == folder / "prefix/share/base");
  CHECK(packages.find("own_pkg", {})->folder == folder / "own");
  CHECK_FALSE(packages.find("hidden", {}));
  CHECK_FALSE(packages.find("skipped_pkg", {}));
  CHECK_FALSE(packages.find("../share", {}));
  packages.add("arm_description", "/given");
  CHECK(packages.find("arm_description", {})->folder == "/given");
}

TEST_CASE("xacro: a missing package is an error with a hint") {
  const auto e = expand("<a v='$(find nowhere)/x'/>");
  CHECK(e.report().find("in.xacro:1:") == 0);
  CHECK(e.report().find("error[FM1016]: package 'nowhere' not found") != std::string::npos);
  CHECK(e.report().find("--package nowhere=FOLDER") != std::string::npos);
}

TEST_CASE("xacro: YAML aliases cost nothing, and mistakes are located") {
  const Folder folder;
  std::string bomb = "a0: &a0 [x, x]\n";
  for (int i = 1; i < 40; ++i) {
    const std::string n = std::to_string(i);
    const std::string before = "*a" + std::to_string(i - 1);
    bomb += "a" + n + ": &a" + n + " [" + before + ", " + before + "]\n";
  }
  folder.add("bomb.yaml", bomb);
  folder.add("len.xacro", document("<a v=\"${len(xacro.load_yaml('bomb.yaml').a39)}\"/>"));
  folder.add("print.xacro", document("<a v=\"${xacro.load_yaml('bomb.yaml')}\"/>"));
  folder.add("bad.yaml", "a: 1\nb: [1, 2\nc: 3\n");
  folder.add("bad.xacro", document("<a v=\"${xacro.load_yaml('bad.yaml')}\"/>"));
  folder.add("self.yaml", "a: &a [*a]\n");
  folder.add("self.xacro", document("<a v=\"${xacro.load_yaml('self.yaml')}\"/>"));
  folder.add("deep.yaml", std::string(3000, '[') + std::string(3000, ']'));
  folder.add("deep.xacro", document("<a v=\"${xacro.load_yaml('deep.yaml')}\"/>"));
  CHECK(run(folder / "len.xacro").out.find("<a v=\"2\"/>") != std::string::npos);
  CHECK(run(folder / "print.xacro").err.find("error[FM1011]") != std::string::npos);
  CHECK(run(folder / "bad.xacro").err.find((folder / "bad.yaml") + ":3:2: error[FM1028]: cannot parse YAML") == 0);
  CHECK(run(folder / "self.xacro").err.find("found unconstructable recursive node") != std::string::npos);
  CHECK(run(folder / "deep.xacro").err.find("error[FM1028]") != std::string::npos);
}

TEST_CASE("xacro: arguments are read as ROS reads them") {
  xacro::Arguments arguments;
  CHECK(xacro::add_argument("a:= 1 ", arguments));
  CHECK(xacro::add_argument("b:=", arguments));
  CHECK(xacro::add_argument("_private:=1", arguments));
  CHECK(xacro::add_argument("__name:=1", arguments));
  CHECK_FALSE(xacro::add_argument("a=1", arguments));
  CHECK(arguments == xacro::Arguments{{"__name", "1"}, {"a", "1"}});
}

namespace {

/// A text of some of the pieces that parameters of macros are made of, and some that they are not.
std::string random_parameters(std::mt19937& random) {
  constexpr std::string_view pieces[] = {"a",  "b",  "n",    "*",     "**", "*b",  "**b", ":=", "=",     ":",  "^",
                                         "^|", "|",  "${1}", "$(x)",  "${", "}",   "$(",  ")",  "'",     "\"", " ",
                                         "  ", "\n", "\t",   "'q r'", "é",  "1.5", "$",   ".",  "xacro:"};
  std::string text;
  const auto count = random() % 9;
  for (std::uint32_t i = 0; i < count; ++i) text += pieces[random() % std::size(pieces)];
  return text;
}

std::string in_attribute(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '"' ? "&quot;" : c == '\n' ? "&#10;" : c == '\t' ? "&#9;" : std::string(1, c);
  return out;
}

}  // namespace

TEST_CASE("xacro: any text as parameters ends in a document or in one located error") {
  std::mt19937 random(13);
  for (int i = 0; i < 3000; ++i) {
    const std::string parameters = random_parameters(random);
    CAPTURE(parameters);
    const std::string body = "<xacro:insert_block name='" +
                             std::string(i % 3 == 0   ? ""
                                         : i % 3 == 1 ? "b"
                                                      : "*") +
                             "'/>";
    const auto e = expand("<xacro:macro name='m' params=\"" + in_attribute(parameters) + "\"><x v='${a}'/>" + body +
                          "</xacro:macro><xacro:m><o/></xacro:m>");
    CHECK(e.document.has_value() != e.diagnostics.has_errors());
    CHECK(e.diagnostics.size() <= 1);
    if (!e.document) CHECK(e.report().find("in.xacro:1:") == 0);
  }
}

TEST_CASE("xacro: parameters are cut as the pattern of ROS xacro cuts them") {
  // Its pattern for a parameter with a default; a text it does not match is a name up to the next blank.
  const std::regex with_default(
      R"re(^\s*([^\s:=]+?)\s*:?=\s*(\^\|?)?(\$\{.*?\}|\$\(.*?\)|(?:'.*?'|".*?"|[^\s'"]+)+|)(?:\s+|$))re");
  std::mt19937 random(17);
  for (int i = 0; i < 3000; ++i) {
    const std::string text = random_parameters(random);
    CAPTURE(text);
    std::string rest = text;
    for (const xacro::Parameter& parameter : xacro::parse_parameters(text)) {
      std::smatch found;
      if (std::regex_search(rest, found, with_default)) {
        CHECK(parameter.name == found[1]);
        CHECK(parameter.is_forwarded == found[2].matched);
        CHECK(parameter.default_text.value_or("") == found[3]);
        rest = found.suffix();
      } else {
        const auto begin = rest.find_first_not_of(" \t\n");
        const auto end = std::min(rest.find_first_of(" \t\n", begin), rest.size());
        CHECK(parameter.name == rest.substr(begin, end - begin));
        CHECK_FALSE(parameter.has_default());
        rest = rest.substr(end);
      }
    }
    CHECK(rest.find_first_not_of(" \t\n") == std::string::npos);
  }
}

TEST_CASE("xacro: a block whose name is only stars is named like any other block that is missing") {
  const auto e = expand(
      "<xacro:macro name='m' params='*origin **=rest n'><xacro:insert_block name='nope'/></xacro:macro>"
      "<xacro:m n='1'><origin/><o/></xacro:m>");
  CHECK(e.report().find("error[FM1025]: Undefined block \"nope\"") != std::string::npos);
}
