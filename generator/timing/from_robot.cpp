#include "generator/timing/from_robot.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "generator/model/conversion.hpp"
#include "generator/model/offers.hpp"
#include "generator/timing/wire_time.hpp"

namespace finemote::gen::timing {
namespace {

/// A state or command that crosses buckets is copied as so many words at most. Generated code knows the types, the
/// generator does not: more does not compile (finemote::kCrossingBytes). The interfaces shipped have at most 24.
constexpr Ns kCrossingWords = 32;

/// What the monitor costs at a job or a handle, on a board that does not say: a generous guess.
constexpr Ns kMonitorGuess = 3000;

/// Costs of a robot without a board.
const gen::Costs kNoCosts{};
const Drivers kNoDrivers{};

class Adapter {
 public:
  Adapter(const Robot& robot, const Forest& forest, const Schedule& schedule, const RobotTimingOptions& options)
      : robot_(robot),
        forest_(forest),
        schedule_(schedule),
        options_(options),
        costs_(robot.board != nullptr ? robot.board->costs : kNoCosts),
        drivers_(robot.board != nullptr ? robot.board->drivers : kNoDrivers) {}

  Model make() {
    model_.tick_ns = robot_.tick_ns;
    model_.has_target = true;
    set_costs();
    for (const BusId bus : robot_.buses.ids()) add_bus(bus);
    for (const DeviceId d : forest_.order) add_device(d);
    add_crossings();
    for (const gen::Bucket& bucket : schedule_.buckets) {
      for (const SegmentId segment : bucket.flushes) add_flush(bucket, segment);
    }
    drop_silent_transmitters();
    drop_idle_masters();
    forget_crowded_identifiers();
    return std::move(model_);
  }

 private:
  void set_costs() {
    model_.costs.release_ns = costs_.release_ns + costs_.exception_ns();
    model_.costs.release_per_bucket_ns = costs_.release_per_bucket_ns;
    model_.costs.interrupt_ns = costs_.exception_ns();
    model_.costs.job_ns = costs_.bucket_ns + costs_.exception_ns();
    model_.costs.stage_ns = costs_.stage_ns + (options_.trace ? 2 * costs_.trace_event_ns : 0);
    model_.costs.masked_ns = costs_.masked_section_ns;
    if (options_.monitor) model_.costs.job_ns += costs_.monitor_job_ns.value_or(kMonitorGuess);
  }

  void add_bus(BusId index) {
    const gen::Bus& bus = robot_.buses[index];
    if (bus.rate <= 0) return;  // pulses and pins: no frames, no interrupts
    Bus out;
    const auto found = drivers_.find(bus.kind);
    const Driver driver = found == drivers_.end() ? Driver{} : found->second;
    out.name = bus.name.text;
    out.at = bus.at;
    out.baud_bps = bus.rate;
    out.arbitrated = bus.kind == BusKind::can;
    out.min_frame_bits = std::max<Ns>(bus.min_frame_bits.value_or(driver.min_frame_bits), 1);
    out.wcet_ns = bus.isr_wcet_ns.value_or(driver.isr_wcet_ns);
    out.frame_ns = frame_time(out.min_frame_bits, bus.rate);
    if (found != drivers_.end()) {
      out.sources.emplace();
      for (const DriverSource& s : driver.sources) {
        out.sources->push_back({s.name,
                                bus.isr_wcet_ns.value_or(s.isr_wcet_ns),
                                frame_time(bus.min_frame_bits.value_or(s.min_frame_bits), bus.rate),
                                {}});
      }
    }
    out.advice = advice(index);
    bus_of_[index] = model_.buses.size();
    model_.buses.push_back(std::move(out));
  }

  /// Faster rates that the port and all that sits on the bus can do, and another bus of the kind.
  [[nodiscard]] BusAdvice advice(BusId index) const {
    const gen::Bus& bus = robot_.buses[index];
    const Port* port = robot_.board != nullptr ? robot_.board->port(bus.port) : nullptr;
    if (port == nullptr) return {};
    RateLimits limits;
    const auto limit = [&](std::optional<std::int64_t> clock) {
      if (clock) limits.clock = std::min(*clock, limits.clock.value_or(*clock));
    };
    for (const gen::Device& device : robot_.devices) {
      if (!device.segment || robot_.segments[*device.segment].bus != index || device.type == nullptr) continue;
      limit(device.type->max_clock_hz);
      if (!device.type->rates.empty()) limits.settings.push_back(device.type->rates);
    }
    for (const Expander& expander : robot_.expanders) {
      if (robot_.segments[expander.segment].bus == index) limit(expander.type->max_clock_hz);
    }
    BusAdvice result;
    result.other_port = another_bus(robot_.board, used_ports(robot_), bus.kind, bus.rate);
    for (const std::int64_t rate : gen::faster_rates(*port, bus.kind, 0, limits)) {
      const std::string text = std::string(rate_attribute(bus.kind)) + "=\"" + rate_text(bus.kind, rate) + "\"";
      if (rate > bus.rate) result.rates.push_back({text, rate});
      if (rate < bus.rate) result.slower.insert(result.slower.begin(), {text, rate});
    }
    return result;
  }

  static Ns frame_time(Ns bits, Ns rate) { return std::max<Ns>(multiply(bits, 1'000'000'000) / rate, 1); }

  /// The model's bus under a segment; none for pulses and pins.
  [[nodiscard]] std::optional<std::size_t> bus_of(SegmentId segment) const {
    const auto found = bus_of_.find(robot_.segments[segment].bus);
    return found == bus_of_.end() ? std::nullopt : std::optional<std::size_t>(found->second);
  }

  void add_device(DeviceId index) {
    const gen::Device& device = robot_.devices[index];
    Device out;
    out.name = device.name.text;
    out.at = device.at;
    if (device.parent) out.parent = forest_.rank[*device.parent].value();
    out.period_ns = device.period_ns;
    out.update_wcet_ns = device.wcet.update_ns;
    out.handle_wcet_ns = device.wcet.handle_ns;
    out.source = source_of(device.wcet.source);
    if (out.source == WcetSource::assumed && options_.assumed_wcet_ns) {
      out.update_wcet_ns = out.handle_wcet_ns = *options_.assumed_wcet_ns;
    }
    if (options_.monitor) out.handle_extra_ns = costs_.monitor_handle_ns.value_or(kMonitorGuess);
    out.takes_command = device.type != nullptr && device.type->has_command();
    out.actuator = device.type != nullptr && device.type->actuator;
    for (const Read& r : device.reads) out.reads.push_back(forest_.rank[r.device].value());
    add_roles(device, out);
    const std::size_t place = model_.devices.size();
    model_.devices.push_back(std::move(out));
    if (device.type == nullptr) return;
    model_.devices[place].acquisition = acquisition_of(device);
    if (device.segment) add_frames(device, *device.segment, "", place);
    for (const Use& use : device.uses) {
      if (use.segment) add_frames(device, *use.segment, use.spec->role, place);
    }
    if (device.segment) add_interrupts(device);
  }

  /// The device's own role in its parent, and whose data end at it.
  void add_roles(const gen::Device& device, Device& out) const {
    if (device.parent && device.role) out.role = robot_.devices[*device.parent].type->roles[*device.role].name;
    if (device.type == nullptr) return;
    const auto note = [&](DeviceId producer, std::size_t role) {
      if (!device.type->roles[role].passes) out.ends_here.push_back(forest_.rank[producer].value());
    };
    for (const DeviceId child : device.children) {
      if (robot_.devices[child].role) note(child, *robot_.devices[child].role);
    }
    for (const Read& r : device.reads) note(r.device, r.role);
  }

  static WcetSource source_of(Wcet::Source source) {
    switch (source) {
      case Wcet::Source::assumed:
        return WcetSource::assumed;
      case Wcet::Source::budget:
        return WcetSource::budget;
      case Wcet::Source::measured:
        return WcetSource::measured;
      case Wcet::Source::static_analysis:
        return WcetSource::static_analysis;
    }
    return WcetSource::unknown;
  }

  static std::optional<Acquisition> acquisition_of(const gen::Device& device) {
    if (!device.type->acquisition) return {};
    const gen::Acquisition& given = *device.type->acquisition;
    Acquisition result;
    result.fixed_ns = given.latency_ns;
    if (given.model == gen::Acquisition::Model::streamed) {
      result.interval_ns = given.interval_ns.value_or(0);
    } else {
      result.periods = given.periods.value_or(1);
      result.every = given.published_every;
      result.conversion_ns = conversion_ns(device);
    }
    return result;
  }

  /// Frames of a device over its own bus, or (`role`) over that of a use: entries of one unit become one transfer,
  /// entries of unit 0 stand alone. A device that says nothing may send anything: its bus has no budgets.
  void add_frames(const gen::Device& device, SegmentId segment, const std::string& role, std::size_t place) {
    const auto bus = bus_of(segment);
    if (!bus) return;
    const std::vector<Frame> frames = frames_over(*device.type, role);
    const bool is_silent = role.empty() ? device.type->frames.has_value() : shares_own_bus(device, segment, role);
    if (frames.empty() && !is_silent) undeclared_.insert(*bus);
    if (frames.empty()) return;
    const BusKind kind = robot_.buses[robot_.segments[segment].bus].kind;
    const WireRate rate{kind, model_.buses[*bus].baud_bps, bits_per_byte(format_of(device, role))};
    std::map<std::pair<std::string_view, int>, std::pair<FrameStage, WireUse>> units;  // by the stage's name
    int alone = -1;
    for (const Frame& f : frames) {
      auto& [stage, use] = units[{to_string(f.stage), f.unit > 0 ? f.unit : alone--}];
      stage = f.stage;
      use.add(rate, f.write_bytes, f.read_bytes);
      use.min_interval_ns = std::max(use.min_interval_ns, f.min_interval_ns.value_or(0));
      if (f.write_bytes > 0 && f.stage != FrameStage::autonomous) transmits_.insert(*bus);
    }
    const bool muxed = robot_.segments[segment].kind == Segment::Kind::mux_channel;
    for (auto& [key, unit] : units) {
      auto& [stage, use] = unit;
      if (stage == FrameStage::flush) continue;  // one for all devices of the bucket: add_flush
      if (muxed) add_selection(*bus, rate, use);
      add_transfer(place, *bus, kind, stage, use);
      if (role.empty()) model_.devices[place].transfers.back().identifier = own_identifier(device, frames, stage);
      if (!role.empty()) model_.devices[place].transfers.back().command = false;
    }
  }

  /// Of the one frame that a part on CAN sends by itself; none where it may be another.
  static std::optional<Ns> own_identifier(const gen::Device& device, const std::vector<Frame>& frames,
                                          FrameStage stage) {
    const auto by_itself = std::count_if(frames.begin(), frames.end(),
                                         [](const Frame& frame) { return frame.stage == FrameStage::autonomous; });
    const auto base = device.type->receives_base;
    if (stage != FrameStage::autonomous || by_itself != 1 || !base || !device.id) return std::nullopt;
    return Ns{*base} + *device.id;
  }

  static std::vector<Frame> frames_over(const DeviceType& type, const std::string& role) {
    std::vector<Frame> frames;
    for (const Frame& f : type.frames.value_or(std::vector<Frame>())) {
      if (f.use == role) frames.push_back(f);
    }
    return frames;
  }

  /// A second chip select on the own bus: its frames may be declared with those of the first.
  [[nodiscard]] bool shares_own_bus(const gen::Device& device, SegmentId segment, const std::string& role) const {
    return !role.empty() && device.segment && bus_of(*device.segment) == bus_of(segment);
  }

  static const std::string& format_of(const gen::Device& device, const std::string& role) {
    for (const Use& use : device.uses) {
      if (use.spec->role == role) return use.spec->format;
    }
    return device.type->format;
  }

  /// A mux is set ahead of the unit; where there are several, the one set before is switched off first.
  void add_selection(std::size_t bus, const WireRate& rate, WireUse& use) const {
    const auto muxes = std::count_if(robot_.expanders.begin(), robot_.expanders.end(), [&](const Expander& e) {
      return e.model == Expander::Model::tca9548a && bus_of(e.segment) == bus;
    });
    use.add(rate, 1, 0);
    if (muxes > 1) use.add(rate, 1, 0);
  }

  /// Lines of the device's own, each named by a use, as further sources of the bus it sits on. What the driver raises
  /// for frames is in the board file.
  void add_interrupts(const gen::Device& device) {
    const auto bus = bus_of(*device.segment);
    if (!bus || !model_.buses[*bus].sources) return;
    for (const Interrupt& entry : device.type->interrupts) {
      const bool given = !entry.use.empty() && std::any_of(device.uses.begin(), device.uses.end(),
                                                           [&](const Use& use) { return use.spec->role == entry.use; });
      if (!given) continue;
      const Ns interval =
          entry.is_autonomous ? entry.min_interval_ns.value_or(1) : device.period_ns / std::max<Ns>(entry.count, 1);
      model_.buses[*bus].sources->push_back({device.name.text + ": " + entry.source,
                                             entry.wcet_ns.value_or(model_.buses[*bus].wcet_ns),
                                             std::max<Ns>(interval, 1),
                                             {}});
    }
  }

  void add_transfer(std::size_t place, std::size_t bus, BusKind kind, FrameStage stage, const WireUse& use) {
    Transfer t;
    t.bus = bus;
    t.wire_ns = use.wire_ns;
    t.interrupts = use.interrupts;
    t.after = stage == FrameStage::update   ? Transfer::After::update
              : stage == FrameStage::handle ? Transfer::After::handle
                                            : Transfer::After::autonomous;
    t.min_interval_ns = t.after == Transfer::After::autonomous ? use.min_interval_ns : 0;
    t.receive = kind == BusKind::uart && t.after == Transfer::After::autonomous;
    t.command = t.after == Transfer::After::handle && model_.devices[place].takes_command;
    model_.devices[place].transfers.push_back(t);
    if (kind == BusKind::i2c || (kind == BusKind::spi && has_dma(bus))) add_budget(bus, place, use.interrupts);
  }

  /// Without DMA every byte of a transfer interrupts, not only its begin and end.
  [[nodiscard]] bool has_dma(std::size_t bus) const {
    if (robot_.board == nullptr) return false;
    for (const auto& [index, place] : bus_of_) {
      const Port* port = place == bus ? robot_.board->port(robot_.buses[index].port) : nullptr;
      if (port != nullptr && !port->dma.empty()) return true;
    }
    return false;
  }

  /// On I2C and SPI every interrupt belongs to a transfer the robot asked for, once per period and slot (or in `every`
  /// periods).
  void add_budget(std::size_t bus, std::size_t place, Ns count, Ns every = 1) {
    if (!model_.buses[bus].sources || model_.buses[bus].sources->size() != 1 || undeclared_.contains(bus)) return;
    model_.buses[bus].sources->front().budgets.push_back({place, count, every});
  }

  void add_crossings() {
    const Ns copy = costs_.latch_ns + kCrossingWords * costs_.latch_per_word_ns;
    for (const Crossing& c : schedule_.crossings) {
      Device& producer = model_.devices[forest_.rank[c.producer].value()];
      Device& consumer = model_.devices[forest_.rank[c.consumer].value()];
      const bool state = c.direction == Crossing::Direction::state;
      if (c.kind != Crossing::Kind::copy) (state ? producer.update_extra_ns : producer.handle_extra_ns) += copy;
      (state ? consumer.update_extra_ns : consumer.handle_extra_ns) += copy;
    }
  }

  void add_flush(const gen::Bucket& bucket, SegmentId segment) {
    const Segment& output = robot_.segments[segment];
    Flush flush;
    flush.period_ns = bucket.period_ns;
    Ns channels = 0;
    for (const DeviceId d : bucket.devices) {
      const gen::Device& device = robot_.devices[d];
      const auto used =
          std::count_if(device.uses.begin(), device.uses.end(), [&](const Use& use) { return use.segment == segment; });
      const Ns mine = (device.segment == segment ? 1 : 0) + used;
      if (mine == 0) continue;
      flush.devices.push_back(forest_.rank[d].value());
      channels += mine;
    }
    flush.wcet_ns = costs_.flush_ns + channels * costs_.flush_per_channel_ns;
    if (flush.devices.empty()) return;
    if (output.kind == Segment::Kind::pwm_expander) {
      set_expander_burst(output, segment, flush);
    } else if (output.bus_kind == BusKind::can) {
      set_can_frames(segment, flush);
    }
    model_.flushes.push_back(std::move(flush));
  }

  void set_expander_burst(const Segment& output, SegmentId segment, Flush& flush) {
    const Expander& expander = robot_.expanders[*output.expander];
    const auto bus = bus_of(expander.segment);
    if (!bus) return;
    Ns first = 255, last = 0;
    const auto note = [&](std::optional<SegmentId> place, std::optional<std::uint32_t> channel) {
      if (place != segment || !channel) return;
      first = std::min<Ns>(first, *channel);
      last = std::max<Ns>(last, *channel);
    };
    for (const gen::Device& d : robot_.devices) {
      note(d.segment, d.channel);
      for (const Use& use : d.uses) note(use.segment, use.channel);
    }
    const ExpanderFrames& frames = expander.type->frames;
    WireUse use;
    const WireRate rate{BusKind::i2c, model_.buses[*bus].baud_bps, 9};
    use.add(rate, frames.per_flush.write_bytes + frames.per_channel.write_bytes * (last - first + 1), 0);
    if (robot_.segments[expander.segment].kind == Segment::Kind::mux_channel) add_selection(*bus, rate, use);
    flush.output = output.name.text;
    flush.bus = bus;
    add_budget(*bus, flush.devices.front(), use.interrupts);
    if (frames.check) {
      WireUse check;
      check.add(rate, frames.check->write_bytes, frames.check->read_bytes);
      add_budget(*bus, flush.devices.front(), check.interrupts, flushes_per_check(expander));
      use.add(rate, frames.check->write_bytes, frames.check->read_bytes);
    }
    flush.wire_ns = use.wire_ns;
    flush.interrupts = use.interrupts;
  }

  /// The driver counts its flushes, whichever bucket they are of: the jobs of one bucket check no more often than this.
  static Ns flushes_per_check(const Expander& expander) {
    return std::max<Ns>(param_value(expander.params, "refresh", Ns{1}), 1);
  }

  /// A flush sends whatever has changed, also of a slower bucket it preempts: at most every shared frame of the bus.
  void set_can_frames(SegmentId segment, Flush& flush) {
    const auto bus = bus_of(segment);
    if (!bus) return;
    std::set<std::uint32_t> identifiers;
    for (const gen::Device& device : robot_.devices) {
      if (device.segment != segment || device.type == nullptr) continue;
      for (const SharedFrame& f : device.type->shared_frames()) {
        const std::uint32_t id = device.id.value_or(0);
        if (f.id_max == 0 || (id >= f.id_min && id <= f.id_max)) identifiers.insert(f.identifier);
      }
    }
    WireUse use;
    for (std::size_t i = 0; i < std::max<std::size_t>(identifiers.size(), 1); ++i) {
      use.add({BusKind::can, model_.buses[*bus].baud_bps, 8}, 8, 0);
    }
    flush.bus = bus;
    flush.wire_ns = use.wire_ns;
    flush.interrupts = use.interrupts;
    flush.identifiers.assign(identifiers.begin(), identifiers.end());
    transmits_.insert(*bus);
  }

  /// A serial line nobody writes to has no transmit interrupt.
  void drop_silent_transmitters() {
    for (const gen::Device& device : robot_.devices) {
      for (const Use& use : device.uses) {
        if (!use.segment) continue;
        if (const auto bus = bus_of(*use.segment)) transmits_.insert(*bus);
      }
    }
    for (const auto& [index, bus] : bus_of_) {
      if (robot_.buses[index].kind != BusKind::uart || transmits_.contains(bus) || undeclared_.contains(bus)) continue;
      if (!model_.buses[bus].sources) continue;
      std::erase_if(*model_.buses[bus].sources, [](const InterruptSource& s) { return s.name.starts_with("tx"); });
    }
    for (const std::size_t bus : undeclared_) {
      if (!model_.buses[bus].sources) continue;
      for (InterruptSource& s : *model_.buses[bus].sources) s.budgets.clear();
    }
  }

  /// The controller sends by identifier among its mailboxes. With more frames of ours than those, or with others than
  /// the shared ones, one that waits for a mailbox may be the more urgent.
  void forget_crowded_identifiers() {
    const auto driver = drivers_.find(BusKind::can);
    const std::size_t mailboxes = driver == drivers_.end() ? 0 : driver->second.mailboxes;
    for (Flush& flush : model_.flushes) {
      const bool alone = std::all_of(model_.devices.begin(), model_.devices.end(), [&](const Device& device) {
        return std::all_of(device.transfers.begin(), device.transfers.end(), [&](const Transfer& t) {
          return t.bus != flush.bus || t.after == Transfer::After::autonomous;
        });
      });
      if (!alone || flush.identifiers.size() > mailboxes) flush.identifiers.clear();
    }
  }

  /// An I2C or SPI bus that nothing sits on: nobody begins a transfer, so nothing interrupts.
  void drop_idle_masters() {
    std::set<BusId> used;
    const auto note = [&](std::optional<SegmentId> segment) {
      if (segment) used.insert(robot_.segments[*segment].bus);
    };
    for (const gen::Device& device : robot_.devices) {
      note(device.segment);
      for (const Use& use : device.uses) note(use.segment);
    }
    for (const Expander& expander : robot_.expanders) note(expander.segment);
    for (const auto& [index, bus] : bus_of_) {
      const BusKind kind = robot_.buses[index].kind;
      const bool is_master = kind == BusKind::i2c || kind == BusKind::spi;
      if (is_master && !used.contains(index) && model_.buses[bus].sources) model_.buses[bus].sources->clear();
    }
  }

  const Robot& robot_;
  const Forest& forest_;
  const Schedule& schedule_;
  const RobotTimingOptions& options_;
  const gen::Costs& costs_;
  const Drivers& drivers_;
  Model model_;
  std::map<BusId, std::size_t> bus_of_;  ///< Robot bus -> model bus
  std::set<std::size_t> undeclared_;     ///< model buses with a device that does not say what it sends
  std::set<std::size_t> transmits_;      ///< model buses somebody writes to
};

}  // namespace

Model make_timing_model(const Robot& robot, const Forest& forest, const Schedule& schedule,
                        const RobotTimingOptions& options) {
  return Adapter(robot, forest, schedule, options).make();
}

std::vector<Requirement> timing_requirements(const Robot& robot, const Forest& forest) {
  Table<BusId, std::optional<std::size_t>> bus_of;
  std::size_t next = 0;
  for (const gen::Bus& bus : robot.buses) {
    bus_of.push_back(bus.rate > 0 ? std::optional<std::size_t>(next++) : std::nullopt);
  }
  std::vector<Requirement> list;
  for (const gen::Requirement& r : robot.requirements) {
    if (r.bus && !bus_of[*r.bus]) continue;  // a bus without frames is never busy
    Requirement out;
    using Kind = gen::Requirement::Kind;
    out.kind = r.kind == Kind::latency_end_to_end ? Requirement::Kind::latency_end_to_end
               : r.kind == Kind::latency_decision ? Requirement::Kind::latency_decision
               : r.kind == Kind::utilization      ? Requirement::Kind::utilization
                                                  : Requirement::Kind::jitter;
    out.text = r.text;
    for (const DeviceId d : r.from) out.from.push_back(forest.rank[d].value());
    for (const DeviceId d : r.to) out.to.push_back(forest.rank[d].value());
    if (r.bus) out.bus = bus_of[*r.bus];
    out.max_ns = r.max_ns;
    out.max_fraction = r.max_fraction;
    out.at = r.at;
    list.push_back(std::move(out));
  }
  return list;
}

}  // namespace finemote::gen::timing
