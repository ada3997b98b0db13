#include "generator/emit/bounds.hpp"

#include <fmt/format.h>

namespace finemote::gen {
namespace {

using timing::DeviceBounds;
using timing::RobotBounds;

constexpr std::int64_t kNsPerUs = 1'000;
constexpr std::int64_t kNsPerMs = 1'000'000;

/// `12.146` without zeros at the end, from thousandths.
std::string thousandths(std::int64_t value) {
  std::string text = fmt::format("{}.{:03}", value / 1000, value % 1000);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string no_bound(const RobotBounds& bounds) {
  return bounds.answered ? "no bound: a job may not have ended when the next one is due"
                         : "no bound: the timing analysis gives no answer";
}

std::string constant(std::optional<std::int64_t> ns) { return ns ? std::to_string(*ns) : "finemote::kUnbounded"; }

}  // namespace

std::string bound_text(std::int64_t ns) {
  if (ns < kNsPerMs) return thousandths(ns) + " us";
  return thousandths((ns + kNsPerUs - 1) / kNsPerUs) + " ms";
}

std::string bound_comment(const Plan& plan, const RobotBounds& bounds, DeviceId device) {
  const DeviceBounds& of = bounds.devices[device];
  if (!of.response_ns) return no_bound(bounds);
  std::string text = "response <= " + bound_text(*of.response_ns);
  if (!of.has_input) return text;
  if (!of.age_ns) return text + "; no bound on the age of its command";
  text += fmt::format("; data age <= {} when handle() ends", bound_text(*of.age_ns));
  text +=
      of.output_ns ? fmt::format(", <= {} at the output", bound_text(*of.output_ns)) : ", without bound at the output";
  return text + fmt::format(" (oldest: {})", plan.robot.devices[*of.oldest].name.text);
}

std::string job_comment(const RobotBounds& bounds, std::size_t bucket) {
  const auto response = bounds.jobs[bucket];
  return response ? fmt::format("a job ends within {} of its release", bound_text(*response)) : no_bound(bounds);
}

std::vector<std::string> bound_constants(const Plan& plan, const RobotBounds& bounds) {
  std::vector<std::string> lines;
  for (const DeviceId device : plan.forest.order) {
    const DeviceBounds& of = bounds.devices[device];
    lines.push_back(fmt::format("inline constexpr finemote::Bounds {}{{{}, {}, {}}};",
                                plan.robot.devices[device].name.cpp, constant(of.response_ns), constant(of.age_ns),
                                constant(of.output_ns)));
  }
  return lines;
}

std::vector<std::string> monitored_lines(const Plan& plan, const RobotBounds& bounds) {
  std::vector<std::string> lines;
  for (const DeviceId device : plan.forest.order) {
    const DeviceBounds& of = bounds.devices[device];
    const Device& d = plan.robot.devices[device];
    const std::string space = plan.forest.trees[plan.forest.tree_of[device]].space;
    const std::string command = d.parent && d.type->has_command()
                                    ? fmt::format("&{}::{}.{}", space, d.name.cpp, d.type->provides.front().command)
                                    : "nullptr";
    lines.push_back(fmt::format("{{{}, {}, {}, {}}},  // {}", plan.schedule.bucket_of[device], constant(of.response_ns),
                                constant(of.age_ns), command, d.name.text));
  }
  return lines;
}

}  // namespace finemote::gen
