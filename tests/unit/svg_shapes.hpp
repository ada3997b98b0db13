// The boxes and texts of a picture, as its SVG has them.
#pragma once

#include <regex>
#include <string>
#include <vector>

namespace finemote::test {

constexpr double kWidestCharacter = 0.61 * 13;  // of DejaVu Sans Mono and Menlo at 13 px

struct Box {
  std::string look;  ///< its class
  int x, y, width, height;

  [[nodiscard]] bool overlaps(const Box& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height && other.y < y + height;
  }
};

struct Text {
  int x, y;
  std::string text;

  /// What it covers at most.
  [[nodiscard]] Box box() const {
    return {"text", x, y - 11, static_cast<int>(kWidestCharacter * static_cast<double>(text.size())) + 1, 14};
  }
};

inline std::vector<std::smatch> matches(const std::string& svg, const std::regex& pattern) {
  return {std::sregex_iterator(svg.begin(), svg.end(), pattern), std::sregex_iterator()};
}

/// @param look  a regular expression that the class begins with
inline std::vector<Box> boxes_of(const std::string& svg, const std::string& look) {
  const std::regex pattern("<rect class=\"(" + look +
                           R"re([^"]*)" x="(\d+)" y="(\d+)" width="(\d+)" height="(\d+)")re");
  std::vector<Box> boxes;
  for (const std::smatch& m : matches(svg, pattern))
    boxes.push_back({m[1], std::stoi(m[2]), std::stoi(m[3]), std::stoi(m[4]), std::stoi(m[5])});
  return boxes;
}

inline std::vector<Text> texts_of(const std::string& svg) {
  static const std::regex pattern(R"re(<text[^>]*x="(\d+)" y="(\d+)">([^<]*)</text>)re");
  std::vector<Text> texts;
  for (const std::smatch& m : matches(svg, pattern)) texts.push_back({std::stoi(m[1]), std::stoi(m[2]), m[3]});
  return texts;
}

}  // namespace finemote::test
