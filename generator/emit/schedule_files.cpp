#include "generator/emit/schedule_files.hpp"

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/emit/file_names.hpp"
#include "generator/emit/value.hpp"
#include "generator/units/units.hpp"

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

Data tree_list(const std::vector<const Tree*>& trees) {
  Data list(Data::type::list);
  for (const Tree* tree : trees) list.push_back(Data("space", tree->space));
  return list;
}

Data bus_list(const Plan& plan, const std::vector<SegmentId>& segments) {
  Data list(Data::type::list);
  for (const SegmentId segment : segments) list.push_back(Data("bus", plan.robot.segments[segment].name.cpp));
  return list;
}

/// What a bucket flushes at its end: of the frames on a bus those that are its own.
Data flush_list(const Plan& plan, std::size_t bucket) {
  Data list(Data::type::list);
  for (const SegmentId segment : plan.schedule.buckets[bucket].flushes) {
    const Segment& output = plan.robot.segments[segment];
    Data entry("bus", output.name.cpp);
    const bool has_frames = bus_type(output.bus_kind).flush == BusType::Flush::shared_frames;
    entry.set("frames_of", has_frames ? std::to_string(bucket) : std::string());
    list.push_back(entry);
  }
  return list;
}

/// The interrupt that the board does not need itself, in whose line the bucket runs.
std::string lender_of(const Plan& plan, const Bucket& bucket) {
  for (const SpareLine& line : plan.robot.board->lines) {
    if (line.number == bucket.line) return line.name;
  }
  return {};
}

void set_trees(const Plan& plan, std::size_t bucket, Data& entry) {
  std::vector<const Tree*> trees = trees_in(plan, bucket);
  entry.set("updates", tree_list(trees));
  std::reverse(trees.begin(), trees.end());
  entry.set("handles", tree_list(trees));
}

Data bucket_list(const Plan& plan, const ProvenBounds& bounds) {
  Data list(Data::type::list);
  for (std::size_t i = 0; i < plan.schedule.buckets.size(); ++i) {
    const Bucket& bucket = plan.schedule.buckets[i];
    Data entry;
    entry.set("index", std::to_string(i));
    entry.set("is_fastest", i == 0);
    entry.set("period", bucket.label);
    entry.set("period_text", units::spaced_duration(bucket.period));
    entry.set("period_value", duration_expression(bucket.period));
    entry.set("priority", std::to_string(bucket.priority));
    entry.set("line", std::to_string(bucket.line));
    entry.set("lender", lender_of(plan, bucket));
    entry.set("watchdog", std::to_string(watchdog_periods(plan)));
    entry.set("device_count", std::to_string(bucket.devices.size()));
    entry.set("is_single", bucket.devices.size() == 1);
    entry.set("flushes", flush_list(plan, i));
    set_trees(plan, i, entry);
    set_job_bound(bounds.plain, i, entry);
    list.push_back(entry);
  }
  return list;
}

/// A device as seen from the robot's namespace.
void set_device(const Plan& plan, DeviceId device, const std::string& prefix, Data& data) {
  data.set(prefix + "space", plan.forest.trees[plan.forest.tree_of[device]].space);
  data.set(prefix + "device", plan.robot.devices[device].name.cpp);
  data.set(prefix + "literal", string_literal(plan.robot.devices[device].name.text));
}

/// Actuators from root to leaf.
Data actuator_list(const Plan& plan) {
  Data list(Data::type::list);
  for (auto device = plan.forest.order.rbegin(); device != plan.forest.order.rend(); ++device) {
    if (!plan.robot.devices[*device].type->actuator) continue;
    Data entry;
    set_device(plan, *device, "", entry);
    list.push_back(entry);
  }
  return list;
}

/// Outputs that buckets write at their ends: the safe output has to be written too.
std::vector<SegmentId> shared_outputs(const Plan& plan) {
  std::vector<SegmentId> shared;
  for (const SegmentId segment : plan.robot.segments.ids()) {
    const bool flushed = std::any_of(plan.schedule.buckets.begin(), plan.schedule.buckets.end(), [&](const Bucket& b) {
      return std::find(b.flushes.begin(), b.flushes.end(), segment) != b.flushes.end();
    });
    if (flushed) shared.push_back(segment);
  }
  return shared;
}

Data crossing_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const Crossing& crossing : plan.schedule.crossings) {
    const Device& producer = plan.robot.devices[crossing.producer];
    const Device& consumer = plan.robot.devices[crossing.consumer];
    Data entry;
    entry.set("producer", producer.name.text);
    entry.set("producer_period", units::spaced_duration(producer.period));
    entry.set("consumer", consumer.name.text);
    entry.set("consumer_period", units::spaced_duration(consumer.period));
    entry.set("is_state", crossing.direction == Crossing::Direction::state);
    entry.set("is_copy", crossing.kind == Crossing::Kind::copy);
    entry.set("is_to_slow", crossing.kind == Crossing::Kind::to_slow);
    entry.set("is_to_fast", crossing.kind == Crossing::Kind::to_fast);
    list.push_back(entry);
  }
  return list;
}

/// Parent-child edges between objects that cannot be constant-initialised. An edge with one constant end needs no
/// check: constant initialisation comes first for children, and a constant parent only binds addresses.
Data order_checks(const Plan& plan) {
  Data list(Data::type::list);
  for (DeviceId device : plan.forest.order) {
    const Device& child = plan.robot.devices[device];
    if (!child.parent || child.type->constant_init) continue;
    if (plan.robot.devices[*child.parent].type->constant_init) continue;
    Data entry;
    set_device(plan, device, "child_", entry);
    set_device(plan, *child.parent, "parent_", entry);
    list.push_back(entry);
  }
  return list;
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
  data.set("bounds", bound_list(plan, bounds.plain));
  data.set("has_assumed", has_assumed(plan.robot));
  return data;
}

Data schedule_source(const Plan& plan, const ProvenBounds& bounds) {
  Data data = common_data(plan);
  std::vector<std::string> includes{"<finemote/schedule.hpp>", "\"schedule.hpp\"", "\"buses.hpp\""};
  for (const Tree& tree : plan.forest.trees) includes.push_back("\"" + tree_header_name(tree) + "\"");
  data.set("includes", include_list(std::move(includes)));
  data.set("has_crossings", !plan.schedule.crossings.empty());
  data.set("crossings", crossing_list(plan));
  data.set("buckets", bucket_list(plan, bounds));
  data.set("monitored", monitored_list(plan, bounds.monitored));
  data.set("device_count", std::to_string(plan.forest.order.size()));
  data.set("actuators", actuator_list(plan));
  data.set("shared_outputs", bus_list(plan, shared_outputs(plan)));
  const Data checks = order_checks(plan);
  data.set("has_order_checks", checks.is_non_empty_list());
  data.set("order_checks", checks);
  data.set("tick_value", duration_expression(plan.robot.tick));
  data.set("overrun", overrun_policy(plan));
  return data;
}

}  // namespace finemote::gen
