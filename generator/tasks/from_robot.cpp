#include "generator/tasks/from_robot.hpp"

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/model/connection.hpp"
#include "generator/model/conversion.hpp"
#include "generator/model/part_clock.hpp"
#include "generator/model/sample_interval.hpp"
#include "generator/tasks/frame_units.hpp"
#include "generator/tasks/publishing.hpp"
#include "generator/tasks/robot_costs.hpp"
#include "generator/tasks/robot_flushes.hpp"
#include "generator/tasks/streamed_work.hpp"
#include "generator/tasks/traffic.hpp"
#include "generator/tasks/unknown_age.hpp"

namespace finemote::gen::timing {
namespace {

/// How many words are copied at most of a state or command that crosses buckets. Generated code knows the types, the
/// generator does not: more does not compile (finemote::kCrossingBytes).
constexpr std::int64_t kCrossingWords = 32;
/// The largest of the interfaces that are shipped (latch_test).
constexpr std::int64_t kShippedWords = 24;

std::int64_t words_of(const Crossing& crossing) {
  return crossing.type.rfind("finemote::", 0) == 0 ? kShippedWords : kCrossingWords;
}

/// As the board's clock counts it.
std::optional<Acquisition> acquisition_of(const Robot& robot, const gen::Device& device) {
  if (device.type == nullptr || !device.type->acquisition) return {};
  const gen::Acquisition& given = *device.type->acquisition;
  Acquisition result;
  result.fixed = longest_counted(robot, given.latency);
  result.every = given.published_every;
  const Duration converter = measures_pins(device) ? robot.board->analog_conversion : Duration::zero();
  if (given.model == gen::Acquisition::Model::streamed) {
    result.interval = longest_of_part(robot, device, sample_interval(device).value_or(Duration::zero()));
    result.conversion = longest_counted(robot, converter);
  } else {
    result.periods = given.periods.value_or(1);
    result.begun_every = given.begun_every.value_or(result.periods);
    result.conversions = given.conversions;
    result.conversion = longest_counted(robot, std::max(conversion_time(device), converter));
  }
  return result;
}

/// Whether update() sets what goes out without a transfer of the device: channels of an output, pins, shared frames.
bool sets_late(const Robot& robot, const gen::Device& device) {
  const auto has_late = [&](std::optional<SegmentId> segment, const std::string& use) {
    const bool is_wired = segment && bus_type(robot.segments[*segment].bus_kind).unit != nullptr;
    const std::vector<Frame> frames = device.type->frames_over(use);
    return std::any_of(frames.begin(), frames.end(), [&](const Frame& frame) {
      return frame.stage == FrameStage::update && frame.write_bytes > 0 && (!is_wired || !frame.shared.empty());
    });
  };
  return has_late(device.segment, "") || std::any_of(device.uses.begin(), device.uses.end(), [&](const Use& use) {
           return has_late(use.segment, use.spec->role);
         });
}

/// The device's own role in its parent, and whose data end at it.
void add_roles(const Robot& robot, const Forest& forest, const gen::Device& device, Device& out) {
  if (device.parent && device.role) out.role = robot.devices[*device.parent].type->roles[*device.role].name;
  if (device.type == nullptr) return;
  const auto note = [&](DeviceId producer, std::size_t role) {
    if (!device.type->roles[role].passes) out.ends_here.push_back(forest.rank[producer]);
  };
  for (const DeviceId child : device.children) {
    if (robot.devices[child].role) note(child, *robot.devices[child].role);
  }
  for (const Read& r : device.reads) note(r.device, r.role);
}

/// Without its traffic.
Device make_device(const Robot& robot, const Forest& forest, DeviceId id, const RobotTimingOptions& options) {
  const gen::Device& device = robot.devices[id];
  Device out;
  out.name = device.name.text;
  out.at = device.at;
  if (device.parent) out.parent = forest.rank[*device.parent];
  out.period = device.period;
  out.update_wcet = device.wcet.update;
  out.handle_wcet = device.wcet.handle;
  out.source = source_of(device.wcet.source);
  out.update_static = device.wcet.update_static;
  out.handle_static = device.wcet.handle_static;
  out.is_above_declared = device.wcet.is_above_declared;
  if (out.source == WcetSource::assumed && options.assumed_wcet) {
    out.update_wcet = out.handle_wcet = *options.assumed_wcet;
  }
  if (options.monitor) out.handle_extra = monitor_cost(board_costs(robot).monitor_handle);
  if (robot.computed) {
    const ComputedCosts::Before& before = robot.computed->before[id];
    out.update_extra += before.update;
    out.handle_extra += before.handle;
  }
  out.takes_command = device.type != nullptr && device.type->has_command();
  out.actuator = device.type != nullptr && device.type->actuator;
  for (const Read& r : device.reads) out.reads.push_back(forest.rank[r.device]);
  add_roles(robot, forest, device, out);
  out.sets_late = device.type != nullptr && sets_late(robot, device);
  out.acquisition = acquisition_of(robot, device);
  out.unknown_age = unknown_age(robot, device);
  return out;
}

/// What publishing and snapshots add to the stages around them.
void add_crossings(const Robot& robot, const Forest& forest, const Schedule& schedule, Model& model) {
  const gen::Costs& costs = board_costs(robot);
  for (const Crossing& c : schedule.crossings) {
    const Duration copy = costs.latch + words_of(c) * costs.latch_per_word;
    Device& producer = model.devices[forest.rank[c.producer]];
    Device& consumer = model.devices[forest.rank[c.consumer]];
    const bool state = c.direction == Crossing::Direction::state;
    if (c.kind != Crossing::Kind::copy) (state ? producer.update_extra : producer.handle_extra) += copy;
    (state ? consumer.update_extra : consumer.handle_extra) += copy;
  }
}

/// The buses are looked at before the first stage of the fastest bucket.
void add_supervision(const Robot& robot, Model& model) {
  const auto faster = [](const Device& a, const Device& b) { return a.period < b.period; };
  const auto first = std::min_element(model.devices.begin(), model.devices.end(), faster);
  if (first != model.devices.end()) first->update_extra += supervision(robot);
}

/// What was computed is of the image without trace and monitor, or of another one.
void assume_computed(Model& model) {
  const auto assume = [](WcetSource& source) {
    if (source == WcetSource::computed) source = WcetSource::assumed;
  };
  assume(model.costs.source);
  for (Device& device : model.devices) assume(device.source);
  for (Bus& bus : model.buses) {
    if (!bus.sources) continue;
    for (InterruptSource& source : *bus.sources) assume(source.source);
  }
}

Requirement::Kind kind_of(gen::Requirement::Kind kind) {
  switch (kind) {
    case gen::Requirement::Kind::latency_end_to_end:
      return Requirement::Kind::latency_end_to_end;
    case gen::Requirement::Kind::latency_decision:
      return Requirement::Kind::latency_decision;
    case gen::Requirement::Kind::utilization:
      return Requirement::Kind::utilization;
    case gen::Requirement::Kind::jitter:
      return Requirement::Kind::jitter;
  }
  return Requirement::Kind::jitter;
}

/// Throws Overflow.
Model model_of(const Robot& robot, const Forest& forest, const Schedule& schedule, const RobotTimingOptions& options) {
  const BusPlaces places(robot);
  const Table<BusId, BusUse> uses = bus_uses(robot);
  Model model;
  model.tick = robot.tick;
  model.clock_ppm = board_clock_ppm(robot);
  model.has_target = true;
  model.costs = robot_costs(robot, schedule, options);
  DriverBuses buses = make_buses(robot, places, uses);
  model.buses = std::move(buses.buses);
  Traffic traffic(robot, places, uses, std::move(buses.counts), model);
  for (const DeviceId id : forest.order) {
    const gen::Device& device = robot.devices[id];
    const Rank place = model.devices.push_back(make_device(robot, forest, id, options));
    if (device.type != nullptr) traffic.add_device(device, place);
  }
  const bool is_computed = robot.computed && !robot.computed->is_guess;
  if (is_computed) {
    charge_publishing(robot, forest, schedule, model);
  } else {
    add_crossings(robot, forest, schedule, model);
  }
  add_flushes(robot, forest, schedule, places, traffic, model);
  traffic.settle();
  if (!is_computed) add_supervision(robot, model);
  return model;
}

/// Where a finding about the whole robot points while there is no model of it.
Position at_first_device(const Robot& robot, const Forest& forest) {
  return forest.order.empty() ? Position{} : robot.devices[forest.order[Rank{}]].at;
}

}  // namespace

WcetSource source_of(Wcet::Source source) {
  switch (source) {
    case Wcet::Source::assumed:
      return WcetSource::assumed;
    case Wcet::Source::budget:
    case Wcet::Source::static_analysis:
      return WcetSource::declared;
    case Wcet::Source::measured:
      return WcetSource::measured;
    case Wcet::Source::computed:
      return WcetSource::computed;
  }
  return WcetSource::unknown;
}

std::optional<Model> make_timing_model(const Robot& robot, const Forest& forest, const Schedule& schedule,
                                       Diagnostics& diagnostics, const RobotTimingOptions& options) {
  try {
    Model model = model_of(robot, forest, schedule, options);
    shorten_streamed_work(robot, forest, model);
    const bool is_guess = robot.computed && robot.computed->is_guess;
    if (options.trace || options.monitor || is_guess) assume_computed(model);
    return model;
  } catch (const Overflow& overflow) {
    report_overflow(at_first_device(robot, forest), overflow, diagnostics);
    return std::nullopt;
  }
}

std::vector<Requirement> timing_requirements(const Robot& robot, const Forest& forest) {
  const BusPlaces places(robot);
  std::vector<Requirement> list;
  for (const gen::Requirement& r : robot.requirements) {
    if (r.bus && !places.of(*r.bus)) continue;  // a bus without frames is never busy
    Requirement out;
    out.kind = kind_of(r.kind);
    out.text = r.text;
    for (const DeviceId d : r.from) out.from.push_back(forest.rank[d]);
    for (const DeviceId d : r.to) out.to.push_back(forest.rank[d]);
    if (r.bus) out.bus = places.of(*r.bus);
    out.max = r.max;
    out.max_fraction = r.max_fraction;
    out.at = r.at;
    list.push_back(std::move(out));
  }
  return list;
}

}  // namespace finemote::gen::timing
