#include "generator/run/image_owner.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>

#include "generator/diagnostic/printable.hpp"
#include "generator/image/schedule_layout.hpp"
#include "generator/wcet/marks.hpp"

namespace finemote::gen {
namespace {

/// As its schedule says; none: there is no schedule.
std::optional<std::string> robot_of(const Image& image) {
  constexpr std::uint32_t kLongest = 4096;
  const ImageSymbol* schedule = image.find("finemote_schedule");
  const auto text = schedule == nullptr ? std::nullopt : image.word(schedule->address + schedule_layout::kRobotAt);
  if (!text) return std::nullopt;
  const std::string_view bytes = image.bytes(*text, kLongest);
  return std::string(bytes.substr(0, bytes.find('\0')));
}

/// How many stages the image runs, by the marks at their begins.
std::size_t stages_in(const Image& image) {
  std::set<std::uint32_t> begins;
  for (const auto& [address, mark] : wcet::read_marks(image).brackets) {
    if (mark < wcet::kFirstWorkMark && mark % 2 == 0) begins.insert(mark);
  }
  return begins.size();
}

}  // namespace

bool is_image_of(const Robot& robot, const Forest& forest, const Image& image, const std::string& path,
                 Diagnostics& diagnostics) {
  const auto owner = robot_of(image);
  if (!owner || *owner != robot.name.text) {
    diagnostics
        .error(code::bad_image, {},
               fmt::format("'{}' is {}, not the firmware of '{}'", printable(path),
                           owner ? fmt::format("the firmware of '{}'", printable(*owner)) : "no firmware of finemote",
                           printable(robot.name.text)))
        .hint("name the image that was built from this robot");
    return false;
  }
  const std::size_t stages = 2 * forest.order.size(), found = stages_in(image);
  if (found == stages) return true;
  diagnostics
      .error(code::bad_image, {},
             fmt::format("'{}' runs {} stages, and '{}' has {}: it was built from another version of the robot",
                         printable(path), found, printable(robot.name.text), stages))
      .hint("build it again from this robot");
  return false;
}

}  // namespace finemote::gen
