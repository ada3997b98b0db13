#include "generator/emit/schedule_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/schedule/period.hpp"

namespace finemote::gen {
namespace {

/// A bucket starves when it completed no job in this many of its own periods; then the watchdog is not fed.
std::int64_t watchdog_periods(const Plan& plan) {
  return param_value(plan.robot.board_params, "watchdog_periods", std::int64_t{3});
}

/// Trees with a device in the bucket, in order.
std::vector<const Tree*> trees_in(const Plan& plan, std::size_t bucket) {
  std::vector<const Tree*> trees;
  for (const Tree& tree : plan.forest.trees) {
    const bool member = std::any_of(tree.devices.begin(), tree.devices.end(),
                                    [&](DeviceId device) { return plan.schedule.bucket_of[device] == bucket; });
    if (member) trees.push_back(&tree);
  }
  return trees;
}

std::vector<std::string> job_lines(const Plan& plan, std::size_t index) {
  const Bucket& bucket = plan.schedule.buckets[index];
  std::vector<const Tree*> trees = trees_in(plan, index);
  std::vector<std::string> lines;
  if (index == 0) lines.emplace_back("supervise_buses();");
  for (const Tree* tree : trees) lines.push_back(fmt::format("{}::update_{}();", tree->space, bucket.label));
  std::reverse(trees.begin(), trees.end());
  for (const Tree* tree : trees) lines.push_back(fmt::format("{}::handle_{}();", tree->space, bucket.label));
  for (SegmentId segment : bucket.flushes) {
    lines.push_back(plan.robot.segments[segment].name.cpp + ".flush();");
  }
  return lines;
}

Data bucket_list(const Plan& plan, const ProvenBounds& bounds) {
  Data list(Data::type::list);
  for (std::size_t i = 0; i < plan.schedule.buckets.size(); ++i) {
    const Bucket& bucket = plan.schedule.buckets[i];
    const std::size_t count = bucket.devices.size();
    Data entry;
    entry.set("index", std::to_string(i));
    entry.set("period", bucket.label);
    entry.set("period_text", period_text(bucket.period_ns));
    entry.set("period_ns", std::to_string(bucket.period_ns));
    entry.set("priority", std::to_string(bucket.priority));
    entry.set("line", std::to_string(bucket.line));
    entry.set("watchdog", std::to_string(watchdog_periods(plan)));
    entry.set("count_text", fmt::format("{} device{}", count, count == 1 ? "" : "s"));
    entry.set("lines", text_list(job_lines(plan, i)));
    entry.set("bound", job_comment(bounds.plain, i));
    list.push_back(entry);
  }
  return list;
}

std::string qualified(const Plan& plan, DeviceId device) {
  return plan.forest.trees[plan.forest.tree_of[device]].space + "::" + plan.robot.devices[device].name.cpp;
}

std::vector<std::string> safe_lines(const Plan& plan) {
  // Once stopped nothing else watches the buses: a stuck one must recover to take the safe output.
  std::vector<std::string> lines{"supervise_buses();"};
  for (auto device = plan.forest.order.rbegin(); device != plan.forest.order.rend(); ++device) {
    if (plan.robot.devices[*device].type->actuator) lines.push_back(qualified(plan, *device) + ".safe();");
  }
  for (const SegmentId segment : plan.robot.segments.ids()) {
    const bool shared = std::any_of(plan.schedule.buckets.begin(), plan.schedule.buckets.end(), [&](const Bucket& b) {
      return std::find(b.flushes.begin(), b.flushes.end(), segment) != b.flushes.end();
    });
    if (shared) lines.push_back(plan.robot.segments[segment].name.cpp + ".flush();");
  }
  return lines;
}

std::vector<std::string> crossing_lines(const Plan& plan) {
  std::vector<std::string> lines;
  for (const Crossing& crossing : plan.schedule.crossings) {
    const Device& producer = plan.robot.devices[crossing.producer];
    const Device& consumer = plan.robot.devices[crossing.consumer];
    const char* how = crossing.kind == Crossing::Kind::copy      ? "copied before the reader's update"
                      : crossing.kind == Crossing::Kind::to_slow ? "latch, written faster than read"
                                                                 : "latch, read faster than written";
    lines.push_back(fmt::format("{}.{} ({}) -> {} ({}): {}", producer.name.text,
                                crossing.direction == Crossing::Direction::state ? "update" : "handle",
                                period_text(producer.period_ns), consumer.name.text, period_text(consumer.period_ns),
                                how));
  }
  return lines;
}

/// Parent-child edges between objects that cannot be constant-initialised. An edge with one constant end needs no
/// check: constant initialisation comes first for children, and a constant parent only binds addresses.
std::vector<std::string> order_checks(const Plan& plan) {
  std::vector<std::string> lines;
  for (DeviceId device : plan.forest.order) {
    const Device& child = plan.robot.devices[device];
    if (!child.parent || child.type->constant_init) continue;
    const Device& parent = plan.robot.devices[*child.parent];
    if (parent.type->constant_init) continue;
    lines.push_back(fmt::format("{{{}.construction_number(), {}.construction_number(), {}, {}}},",
                                qualified(plan, device), qualified(plan, *child.parent),
                                string_literal(child.name.text), string_literal(parent.name.text)));
  }
  return lines;
}

std::string overrun_policy(const Plan& plan) {
  return param_value(plan.robot.board_params, "overrun", std::string("skip"));
}

bool has_assumed(const Robot& robot) {
  return std::any_of(robot.devices.begin(), robot.devices.end(),
                     [](const Device& d) { return d.wcet.source == Wcet::Source::assumed; });
}

}  // namespace

Data schedule_header(const Plan& plan, const ProvenBounds& bounds) {
  Data data = common_data(plan);
  data.set("buckets", bucket_list(plan, bounds));
  data.set("bounds", text_list(bound_constants(plan, bounds.plain)));
  data.set("assumed", has_assumed(plan.robot) ? "\n/// Some of the execution times behind it are assumed." : "");
  return data;
}

Data schedule_source(const Plan& plan, const ProvenBounds& bounds) {
  Data data = common_data(plan);
  std::vector<std::string> includes{"<finemote/schedule.hpp>", "\"schedule.hpp\"", "\"buses.hpp\""};
  for (const Tree& tree : plan.forest.trees) includes.push_back("\"trees/" + tree.space + ".hpp\"");
  data.set("includes", include_list(std::move(includes)));
  const std::vector<std::string> crossings = crossing_lines(plan);
  data.set("has_crossings", !crossings.empty());
  data.set("crossings", text_list(crossings));
  data.set("buckets", bucket_list(plan, bounds));
  data.set("monitored", text_list(monitored_lines(plan, bounds.monitored)));
  data.set("device_count", std::to_string(plan.forest.order.size()));
  data.set("safe_lines", text_list(safe_lines(plan)));
  const std::vector<std::string> checks = order_checks(plan);
  data.set("has_order_checks", !checks.empty());
  data.set("order_checks", text_list(checks));
  data.set("order", checks.empty() ? "nullptr" : "kOrder");
  data.set("tick_ns", std::to_string(plan.robot.tick_ns));
  data.set("overrun", overrun_policy(plan));
  return data;
}

}  // namespace finemote::gen
