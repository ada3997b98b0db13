#include "generator/emit/bounds.hpp"

#include <fmt/format.h>

namespace finemote::gen {
namespace {

using timing::DeviceBounds;
using timing::RobotBounds;

/// `12.146` without zeros at the end, from thousandths.
std::string thousandths(std::int64_t value) {
  std::string text = fmt::format("{}.{:03}", value / 1000, value % 1000);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string bound_value(std::optional<Duration> bound) {
  return bound ? std::to_string(bound->ns()) : "finemote::kUnproven";
}

/// Of data behind a command: a device that takes none has nothing to bound.
std::string age_value(const RobotBounds& bounds, const DeviceBounds& of, std::optional<Duration> bound) {
  return bounds.answered && !of.has_input ? "finemote::kNothingToBound" : bound_value(bound);
}

}  // namespace

std::string bound_text(Duration bound) {
  if (bound < milliseconds(1)) return thousandths(bound.ns()) + " us";
  return thousandths(ceil_div(bound, microseconds(1))) + " ms";
}

void set_device_bound(const Plan& plan, const RobotBounds& bounds, DeviceId device, Data& data) {
  const DeviceBounds& of = bounds.devices[device];
  const auto set = [&data](const std::string& name, std::optional<Duration> bound) {
    data.set("has_" + name, bound.has_value());
    if (bound) data.set(name, bound_text(*bound));
  };
  const bool has_age = of.response && of.has_input;
  data.set("is_answered", bounds.answered);
  set("response", of.response);
  set("age", has_age ? of.age : std::nullopt);
  set("output", of.output);
  data.set("has_unproven_age", has_age && !of.age);
  data.set("oldest", of.oldest ? plan.robot.devices[*of.oldest].name.text : std::string());
}

void set_job_bound(const RobotBounds& bounds, std::size_t bucket, Data& data) {
  const auto response = bounds.jobs[bucket];
  data.set("is_answered", bounds.answered);
  data.set("has_bound", response.has_value());
  if (response) data.set("bound", bound_text(*response));
}

Data bound_list(const Plan& plan, const RobotBounds& bounds) {
  Data list(Data::type::list);
  for (const DeviceId device : plan.forest.order) {
    const DeviceBounds& of = bounds.devices[device];
    Data entry;
    entry.set("device", plan.robot.devices[device].name.cpp);
    entry.set("response", bound_value(of.response));
    entry.set("age", age_value(bounds, of, of.age));
    entry.set("output", age_value(bounds, of, of.output));
    list.push_back(entry);
  }
  return list;
}

Data monitored_list(const Plan& plan, const RobotBounds& bounds) {
  Data list(Data::type::list);
  for (const DeviceId device : plan.forest.order) {
    const DeviceBounds& of = bounds.devices[device];
    const Device& d = plan.robot.devices[device];
    const bool has_command = d.parent && d.type->has_command();
    Data entry;
    entry.set("bucket", std::to_string(plan.schedule.bucket_of[device]));
    entry.set("response", bound_value(of.response));
    entry.set("age", age_value(bounds, of, of.age));
    entry.set("has_command", has_command);
    entry.set("space", plan.forest.trees[plan.forest.tree_of[device]].space);
    entry.set("device", d.name.cpp);
    if (has_command) entry.set("command", d.type->provides.front().command);
    entry.set("name", d.name.text);
    list.push_back(entry);
  }
  return list;
}

}  // namespace finemote::gen
