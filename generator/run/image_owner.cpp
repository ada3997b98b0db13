#include "generator/run/image_owner.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "generator/diagnostic/printable.hpp"
#include "generator/image/schedule_layout.hpp"
#include "generator/units/units.hpp"
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

/// How many stages the image runs, by their begin marks.
std::size_t stages_in(const Image& image) {
  std::set<std::uint32_t> begins;
  for (const auto& [address, mark] : wcet::read_marks(image).brackets) {
    if (mark < wcet::kFirstWorkMark && mark % 2 == 0) begins.insert(mark);
  }
  return begins.size();
}

/// Of its buckets.
std::set<Duration> periods_in(const Image& image) {
  using namespace schedule_layout;
  constexpr std::uint32_t kMostBuckets = 16;
  const ImageSymbol* schedule = image.find("finemote_schedule");
  const auto word = [&](std::uint32_t address) { return image.word(address).value_or(0); };
  const std::uint32_t buckets = word(schedule->address + kBucketsAt);
  const std::uint32_t count = std::min(word(schedule->address + kBucketCountAt), kMostBuckets);
  std::set<Duration> periods;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t period = buckets + i * kBucketSize + kPeriodAt;
    const std::uint64_t ns = std::uint64_t{word(period + 4)} << 32U | word(period);
    periods.insert(nanoseconds(static_cast<std::int64_t>(ns)));
  }
  return periods;
}

std::set<Duration> periods_of(const Schedule& schedule) {
  std::set<Duration> periods;
  for (const Bucket& bucket : schedule.buckets) periods.insert(bucket.period);
  return periods;
}

std::string text_of(const std::set<Duration>& periods) {
  std::vector<std::string> words;
  for (const Duration period : periods) words.push_back(units::spaced_duration(period));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// What the image does otherwise than the robot; empty: nothing of what is compared.
std::string difference(const Robot& robot, const Forest& forest, const Schedule& schedule, const Image& image) {
  const std::size_t stages = 2 * forest.order.size(), found = stages_in(image);
  const std::string name = printable(robot.name.text);
  if (found != stages) return fmt::format("runs {} stages, and '{}' has {}", found, name, stages);
  const std::set<Duration> periods = periods_of(schedule), seen = periods_in(image);
  if (seen == periods) return {};
  return fmt::format("has periods of {}, and '{}' of {}", text_of(seen), name, text_of(periods));
}

}  // namespace

bool is_image_of(const Robot& robot, const Forest& forest, const Schedule& schedule, const Image& image,
                 const std::string& path, Diagnostics& diagnostics) {
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
  const std::string what = difference(robot, forest, schedule, image);
  if (what.empty()) return true;
  diagnostics
      .error(code::bad_image, {},
             fmt::format("'{}' {}: it was built from another version of the robot", printable(path), what))
      .hint("build it again from this robot");
  return false;
}

}  // namespace finemote::gen
