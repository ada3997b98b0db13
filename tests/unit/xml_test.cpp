#include <cstdio>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"
#include "generator/xml/write.hpp"
#include "tests/temporary_folder.hpp"

using namespace finemote::gen;

namespace {

struct Parsed {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<xml::Document> document;
  [[nodiscard]] std::string messages() const { return render_text(diagnostics, false); }
};

Parsed parse(std::string text) {
  Parsed p;
  const SourceFile* file = p.sources.add(SourceFile{"robot.urdf", "robot.urdf", std::move(text)});
  p.document = xml::parse(*file, p.diagnostics);
  return p;
}

/// First line of the report on a text that is no XML.
std::string first_line(const Parsed& p) {
  const std::string text = p.messages();
  return text.substr(0, text.find('\n'));
}

std::string place(const Position& at) { return std::to_string(at.line) + ":" + std::to_string(at.column); }

/// A file that exists as long as the test needs it.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& content) { std::ofstream(path(), std::ios::binary) << content; }
  [[nodiscard]] std::string path() const { return folder_.path("file"); }

 private:
  finemote::test::TemporaryFolder folder_;
};

std::string read_error(const std::string& content) {
  const ScratchFile file(content);
  Sources sources;
  Diagnostics diagnostics;
  REQUIRE(xml::read_source(file.path(), sources, diagnostics, "in.xml") == nullptr);
  const std::string text = render_text(diagnostics, false);
  return text.substr(0, text.find('\n'));
}

}  // namespace

TEST_CASE("xml: elements and attributes know line and column") {
  const auto p = parse("<?xml version=\"1.0\"?>\n<robot name=\"r\"\n       b = 'x > y'>\n  <link/>text</robot>\n");
  REQUIRE(p.document);
  const xml::Node& root = p.document->root;
  CHECK(place(root.at) == "2:1");
  REQUIRE(root.attributes.size() == 2);
  CHECK(place(root.attributes[0].at) == "2:8");
  CHECK(place(root.attributes[0].value_at) == "2:14");
  CHECK(root.attributes[1].value == "x > y");
  CHECK(place(root.attributes[1].at) == "3:8");
  CHECK(place(root.attributes[1].value_at) == "3:13");
  REQUIRE(root.children.size() == 3);
  CHECK(root.children[0].text == "\n  ");
  CHECK(place(root.children[1].at) == "4:3");
  CHECK(root.children[2].text == "text");
  CHECK(place(root.children[2].at) == "4:10");
}

TEST_CASE("xml: columns count bytes, CRLF is a line break") {
  const auto p = parse("<r>\r\n<a ä=\"é\" n=\"1\"/>\r\n</r>");
  REQUIRE(p.document);
  const xml::Node& a = p.document->root.children.at(1);
  CHECK(place(a.attributes.at(1).at) == "2:12");
  CHECK(p.document->root.children.at(0).text == "\n");
}

TEST_CASE("xml: the tree keeps comments, CDATA, instructions and what stands around the root") {
  const auto p = parse("<!--head--><?go now?><r><![CDATA[<&]]><!-- c --></r><!--tail-->");
  REQUIRE(p.document);
  REQUIRE(p.document->prolog.size() == 2);
  CHECK(p.document->prolog[1].name == "go");
  CHECK(p.document->prolog[1].text == "now");
  CHECK(p.document->root.children.at(0).kind == xml::Node::Kind::cdata);
  CHECK(p.document->root.children.at(0).text == "<&");
  CHECK(p.document->root.children.at(1).text == " c ");
  CHECK(p.document->epilog.at(0).text == "tail");
}

TEST_CASE("xml: comments inside a document type are not part of the tree; entities are expanded") {
  const auto p = parse("<!DOCTYPE r [<!-- no --><!ENTITY e \"<b c='1'/>\">]><r>&e;&amp;</r>");
  REQUIRE(p.document);
  CHECK(p.document->prolog.empty());
  REQUIRE(p.document->root.children.size() == 2);
  CHECK(p.document->root.children[0].attribute("c")->value == "1");
  CHECK(place(p.document->root.children[0].at) == place(p.document->root.children[0].attributes[0].at));
}

TEST_CASE("xml: errors carry expat's words and the place") {
  CHECK(first_line(parse("<r>\n  <a></b>\n</r>")) == "robot.urdf:2:8: error[FM1001]: mismatched tag");
  CHECK(first_line(parse("hello")) == "robot.urdf:1:1: error[FM1001]: syntax error");
  CHECK(first_line(parse("<r><a></r>")) == "robot.urdf:1:9: error[FM1001]: mismatched tag");
  CHECK(first_line(parse("<r>\n  <a>")) == "robot.urdf:2:6: error[FM1001]: no element found");
  CHECK(first_line(parse("<r>\n<x:a/></r>")) == "robot.urdf:2:1: error[FM1001]: unbound prefix");
  CHECK(first_line(parse("<r x:a='1'/>")) == "robot.urdf:1:1: error[FM1001]: unbound prefix");
  CHECK(first_line(parse("<r xmlns:a='u'><a:b:c/></r>")) ==
        "robot.urdf:1:16: error[FM1001]: not well-formed (invalid token)");
  CHECK(first_line(parse("<r a='1' a='2'/>")).find("duplicate attribute") != std::string::npos);
  CHECK(first_line(parse("<r/><s/>")).find("junk after document element") != std::string::npos);
}

TEST_CASE("xml: a prefix is bound only inside its element") {
  CHECK(parse("<r><a xmlns:p='u'><p:b p:c='1'/></a></r>").document);
  CHECK(first_line(parse("<r><a xmlns:p='u'/><p:b/></r>")) == "robot.urdf:1:20: error[FM1001]: unbound prefix");
  CHECK(parse("<r xml:lang='en'/>").document);
}

TEST_CASE("xml: nesting is bounded") {
  const auto nested = [](std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += "<a>";
    for (std::size_t i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  CHECK(parse(nested(xml::kMaxDepth)).document);
  CHECK(first_line(parse(nested(xml::kMaxDepth + 1))).find("FM1003") != std::string::npos);
}

TEST_CASE("xml: an entity bomb is refused") {
  std::string text = "<!DOCTYPE r [<!ENTITY a0 \"0123456789012345678901234567890123456789\">";
  for (int i = 1; i < 12; ++i) {
    text += "<!ENTITY a" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) text += "&a" + std::to_string(i - 1) + ";";
    text += "\">";
  }
  CHECK(first_line(parse(text + "]><r>&a11;</r>")).find("amplification") != std::string::npos);
}

TEST_CASE("xml: the writer lays out as ROS xacro does") {
  const auto p =
      parse("<r z='1' a='&lt;\"'> <b>one</b>\n\n<c>two<d/>three</c><!-- k --><e> </e><f><![CDATA[x]]></f></r>");
  REQUIRE(p.document);
  CHECK(xml::write(*p.document) ==
        "<?xml version=\"1.0\" ?>\n"
        "<r a=\"&lt;&quot;\" z=\"1\">\n"
        "  <b>one</b>\n"
        "  <c>\n    two\n    <d/>\n    three\n  </c>\n"
        "  <!-- k -->\n"
        "  <e> </e>\n"
        "  <f>\n<![CDATA[x]]>  </f>\n"
        "</r>\n");
}

TEST_CASE("xml: the banner names the input and is a legal comment") {
  const auto p = parse("<r/>");
  const std::string text = xml::write(*p.document, "a--b.xacro");
  CHECK(text.find("<!-- |    This document was autogenerated by xacro from a- -b.xacro                    | -->") !=
        std::string::npos);
  CHECK(parse(text).document);
}

TEST_CASE("xml: reading checks the file") {
  CHECK(read_error("") == "in.xml: error[FM0003]: 'in.xml' is empty");
  CHECK(read_error("\xEF\xBB\xBF") == "in.xml: error[FM0003]: 'in.xml' is empty");
  CHECK(read_error("<a>\n \xFF</a>") == "in.xml:2:2: error[FM0004]: 'in.xml' is not UTF-8: byte 0xff");
  CHECK(read_error("<a>\xC0\x80</a>").find("FM0004") != std::string::npos);
  CHECK(read_error(std::string(xml::kMaxFileSize + 1, ' ')) == "in.xml: error[FM0005]: 'in.xml' is larger than 64 MiB");

  Sources sources;
  Diagnostics diagnostics;
  CHECK(xml::read_source("no-such-file.xml", sources, diagnostics) == nullptr);
  CHECK(xml::read_source("/", sources, diagnostics) == nullptr);
  const std::string text = render_text(diagnostics, false);
  CHECK(text.find("no-such-file.xml: error[FM0002]: cannot read 'no-such-file.xml': no such file or directory\n") !=
        std::string::npos);
  CHECK(text.find("/: error[FM0002]: cannot read '/': it is a folder\n") != std::string::npos);
}

TEST_CASE("xml: a byte order mark is dropped and Latin-1 converted") {
  Sources sources;
  Diagnostics diagnostics;
  const ScratchFile with_mark("\xEF\xBB\xBF<r/>");
  const SourceFile* file = xml::read_source(with_mark.path(), sources, diagnostics, "r.xml");
  REQUIRE(file != nullptr);
  CHECK(file->text == "<r/>");
  CHECK(file->name == "r.xml");

  const ScratchFile latin("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><r>\xE9</r>");
  file = xml::read_source(latin.path(), sources, diagnostics);
  REQUIRE(file != nullptr);
  const auto document = xml::parse(*file, diagnostics);
  REQUIRE(document);
  CHECK(document->root.children.at(0).text == "\xC3\xA9");
}
