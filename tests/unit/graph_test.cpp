// Pictures of device trees: readable on narrow screens, and the same robot in every language.
#include <algorithm>
#include <regex>
#include <set>

#include "catch.hpp"
#include "generator/graph/forest_svg.hpp"
#include "generator/graph/forest_text.hpp"
#include "generator/xml/parse.hpp"
#include "unit/robot_plan.hpp"
#include "unit/svg_shapes.hpp"

using namespace finemote::gen;
using namespace finemote::test;

namespace {

int width_of(const std::string& svg) {
  std::smatch found;
  REQUIRE(std::regex_search(svg, found, std::regex("<svg[^>]* width=\"(\\d+)\"")));
  return std::stoi(found[1]);
}

ForestView view_of(const RobotPlan& plan) { return view_of(*plan.robot, plan.forest, plan.schedule); }

/// Neighbours in the order of their tops: what is drawn goes down the page.
void check_no_overlap(std::vector<Box> boxes) {
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.y < b.y; });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].y < boxes[i].y + boxes[i].height; ++j) {
      INFO(boxes[i].look << " at " << boxes[i].x << ',' << boxes[i].y << " and " << boxes[j].look << " at "
                         << boxes[j].x << ',' << boxes[j].y);
      CHECK_FALSE(boxes[i].overlaps(boxes[j]));
    }
  }
}

/// One tree of `count` leaves, with long names among them.
std::string wide_robot(int count) {
  std::string text = "<device name=\"root\" type=\"group\" period=\"10ms\">";
  for (int i = 0; i < count; ++i)
    text +=
        "<device name=\"leaf_" + std::to_string(i) + std::string(i % 7 == 0 ? 30 : 0, 'w') + "\" type=\"sim_load\"/>";
  return text + "</device>";
}

}  // namespace

TEST_CASE("the picture of every example is readable: nothing overlaps, texts are inside, narrow screens suffice") {
  const std::string robot =
      GENERATE("finsrov", "infantry", "six_joint_arm", "two_devices", "deep_forest", "discovery", "user_device");
  INFO(robot);
  const RobotPlan plan(RobotFile{"examples/" + robot + ".urdf"});
  const std::string svg = forest_svg(view_of(plan));
  const int width = width_of(svg);
  CHECK(width <= 480);  // 0.75 of its size on a screen of 390 px
  const auto cards = boxes_of(svg, "card");
  CHECK(cards.size() == plan.robot->devices.size());
  check_no_overlap(cards);
  std::vector<Box> words;
  for (const Text& text : texts_of(svg)) words.push_back(text.box());
  check_no_overlap(words);
  for (const Box& word : words) CHECK(word.x + word.width <= width);
}

TEST_CASE("a picture of a thousand devices holds each of them, and stays a text of little size") {
  const RobotPlan plan(wide_robot(1000));
  const std::string svg = forest_svg(view_of(plan));
  const auto cards = boxes_of(svg, "card");
  CHECK(cards.size() == 1001);
  check_no_overlap(cards);
  CHECK(svg.size() < 1'000'000);
  CHECK(forest_dot(view_of(plan)).find("d1000 [label=") != std::string::npos);
  CHECK(forest_mermaid(view_of(plan)).find("d0 --> d1000\n") != std::string::npos);
}

TEST_CASE("a device says its type, its period, its place on a bus, and what it reads") {
  const RobotPlan plan(RobotFile{"examples/infantry.urdf"});
  const ForestView view = view_of(plan);
  std::set<std::string> lines;
  for (const Text& text : texts_of(forest_svg(view))) lines.insert(text.text);
  for (const ForestRow& row : view.rows) {
    INFO(row.name);
    CHECK(lines.count(row.name) == 1);
    CHECK((row.place.empty() || lines.count(row.place) == 1));
    const bool has_details = std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.rfind(row.type + ", " + row.period, 0) == 0;
    });
    CHECK(has_details);
    CHECK(row.reads.size() == plan.robot->devices[row.device].reads.size());
  }
}

TEST_CASE("every parent, read and bus is an edge in every language") {
  const RobotPlan plan(RobotFile{"examples/infantry.urdf"});
  const ForestView view = view_of(plan);
  const std::string dot = forest_dot(view), mermaid = forest_mermaid(view);
  for (std::size_t i = 0; i < view.rows.size(); ++i) {
    const std::string end = std::to_string(i) + "\n";
    if (view.rows[i].parent) {
      const std::string parent = std::to_string(*view.rows[i].parent);
      CHECK(dot.find("  d" + parent + " -> d" + end) != std::string::npos);
      CHECK(mermaid.find("  d" + parent + " --> d" + end) != std::string::npos);
    }
    for (const std::size_t read : view.rows[i].reads) {
      CHECK(dot.find("  d" + std::to_string(read) + " -> d" + std::to_string(i) + " [style=dotted") !=
            std::string::npos);
      CHECK(mermaid.find("  d" + std::to_string(read) + " -. reads .-> d" + end) != std::string::npos);
    }
  }
}

TEST_CASE("names of all kinds are written as each language has them") {
  ForestView view{"a<b>&\"c\"", "board", "1 ms", {}, {}};
  view.rows.push_back({{}, {}, 0, std::nullopt, "x\"y\\z#<", "type", "1 ms", 0, "", std::nullopt, {}});
  Sources sources;
  Diagnostics diagnostics;
  CHECK(xml::parse(*sources.add({"picture.svg", "", forest_svg(view)}), diagnostics));
  CHECK_FALSE(diagnostics.has_errors());
  CHECK(forest_dot(view).find(R"(label="x\"y\\z#<\ntype, 1 ms")") != std::string::npos);
  CHECK(forest_mermaid(view).find(R"(["x#34;y#92;z#35;#60;<br/>type, 1 ms"])") != std::string::npos);
}
