// Pictures of connectors, and what a board file says of their contacts.
#include <algorithm>

#include "catch.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/document/connector_page.hpp"
#include "generator/document/connector_picture.hpp"
#include "generator/document/contact_use.hpp"
#include "source_dir.hpp"
#include "unit/svg_shapes.hpp"

using namespace finemote::gen;
using namespace finemote::test;

namespace {

constexpr int kNarrowScreen = 358;  // of 390 px, less the margins of a page

struct Shelf {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Library> library = load_library({finemote::test::source_dir(), "", {}, {}}, sources, diagnostics);
  const Board& board(const char* name) { return *find_board(*library, name, sources, diagnostics); }
};

/// Of the contacts, without the frame around them.
std::vector<Box> contact_boxes(const std::string& svg) { return boxes_of(svg, "(?!body)"); }

bool is_inside(const Text& text, const Box& box) {
  const double end = text.x + kWidestCharacter * static_cast<double>(text.text.size());
  return text.x >= box.x && end <= box.x + box.width && text.y - 13 >= box.y && text.y + 3 <= box.y + box.height;
}

Connector one_contact(const Contact& contact) { return {"plug", "", {{contact}}, {}, true}; }

}  // namespace

TEST_CASE(
    "pictures of the shipped boards are readable: nothing overlaps, texts are in their boxes, narrow screens suffice") {
  Shelf shelf;
  for (const char* name : {"robomaster_type_c", "stm32f4_discovery"}) {
    for (const Picture& picture : connector_pictures(shelf.board(name))) {
      INFO(name << ' ' << picture.name);
      const auto boxes = contact_boxes(picture.svg);
      REQUIRE_FALSE(boxes.empty());
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        CHECK(boxes[i].x + boxes[i].width <= kNarrowScreen);
        for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(boxes[i].overlaps(boxes[j]));
      }
      for (const Text& text : texts_of(picture.svg)) {
        INFO(text.text);
        CHECK(std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return is_inside(text, box); }));
      }
    }
  }
}

TEST_CASE("a contact says its number, its name, its pin and the ports that use it") {
  Shelf shelf;
  const Board& discovery = shelf.board("stm32f4_discovery");
  const auto texts = texts_of(connector_picture(one_contact({"37", "PB13", "PB13", "", {}}), discovery));
  REQUIRE(texts.size() == 2);
  CHECK(texts[0].text == "37 PB13");
  CHECK(texts[1].text == "can2 spi2");
  const ContactUse use = use_of({"1", "SELECT", "PB12", "", {}}, discovery);
  REQUIRE(use.ports.size() == 1);
  CHECK(use.ports[0].signal == "select");
}

TEST_CASE("a contact behind a transceiver has the port, and no pin") {
  Shelf shelf;
  const Board& board = shelf.board("robomaster_type_c");
  const auto texts = texts_of(connector_picture(one_contact({"1", "CANL", "", "can1", {}}), board));
  REQUIRE(texts.size() == 2);
  CHECK(texts[1].text == "can1");
  CHECK(connector_page(board).find("| 1 | CANL | | [`can1`](can1.md) (can) | |") != std::string::npos);
}

TEST_CASE("names are written as XML has them") {
  Shelf shelf;
  const std::string svg = connector_picture(one_contact({"1", "A<B&C", "", "", {}}), shelf.board("robomaster_type_c"));
  CHECK(svg.find(">1 A&lt;B&amp;C<") != std::string::npos);
}

TEST_CASE("every contact of a shipped board leads to a pin or port that the board has, or says why not") {
  Shelf shelf;
  for (const char* name : {"robomaster_type_c", "stm32f4_discovery"}) {
    const Board& board = shelf.board(name);
    for (const Connector& connector : board.connectors) {
      for (const auto& line : connector.lines) {
        for (const Contact& contact : line) {
          INFO(connector.name << ' ' << contact.number);
          CHECK((contact.port.empty() || board.port(contact.port) != nullptr));
          CHECK_FALSE((!contact.pin.empty() && contact.volts.has_value()));
        }
      }
    }
  }
}

TEST_CASE("pins of the contacts are those that hints offer, in their order") {
  Shelf shelf;
  const Connector& user = shelf.board("robomaster_type_c").connectors.front();
  CHECK(user.pins == std::vector<std::string>{"PB12", "PB13", "PB15", "PF1", "PB14", "PF0"});
}
