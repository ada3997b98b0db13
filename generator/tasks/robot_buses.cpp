#include "generator/tasks/robot_buses.hpp"

#include <algorithm>
#include <cmath>

#include "generator/bus/bus_type.hpp"
#include "generator/bus/rate_form.hpp"
#include "generator/model/connection.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/part_clock.hpp"
#include "generator/model/port_rates.hpp"
#include "generator/units/clock_tolerance.hpp"

namespace finemote::gen::timing {
namespace {

Duration frame_time(std::int64_t bits, std::int64_t rate) {
  return std::max(floor_div(bits * seconds(1), rate), nanoseconds(1));
}

/// Null where there is no board.
const Port* port_of(const Robot& robot, const gen::Bus& bus) {
  return robot.board != nullptr ? robot.board->port(bus.port) : nullptr;
}

/// What limits the rate of a bus beside its port: the parts on it.
RateLimits limits_of(const Robot& robot, BusId bus) {
  RateLimits limits;
  const auto limit = [&](std::optional<std::int64_t> clock) {
    if (clock) limits.clock = std::min(*clock, limits.clock.value_or(*clock));
  };
  for (const gen::Device& device : robot.devices) {
    if (!device.segment || robot.segments[*device.segment].bus != bus || device.type == nullptr) continue;
    limit(device.type->max_clock_hz);
    if (!device.type->rates.empty()) limits.settings.push_back(device.type->rates);
  }
  for (const Expander& expander : robot.expanders) {
    if (robot.segments[expander.segment].bus == bus) limit(expander.type->max_clock_hz);
  }
  return limits;
}

/// Other rates that the port and all that sits on the bus can do, and another bus of the kind.
BusAdvice advice_for(const Robot& robot, BusId id) {
  const gen::Bus& bus = robot.buses[id];
  const Port* port = port_of(robot, bus);
  if (port == nullptr) return {};
  BusAdvice advice;
  advice.other_port = another_bus(robot.board, used_ports(robot), bus.kind, bus.rate);
  for (const std::int64_t rate : gen::faster_rates(*port, bus.kind, 0, limits_of(robot, id))) {
    const std::string text = std::string(rate_attribute(bus.kind)) + "=\"" + rate_text(bus.kind, rate) + "\"";
    if (rate > bus.rate) advice.rates.push_back({text, rate});
    if (rate < bus.rate) advice.slower.insert(advice.slower.begin(), {text, rate});
  }
  return advice;
}

/// Nobody begins a transfer on a bus that only we begin transfers on and nothing sits on.
bool is_idle(const BusType& type, const BusUse& use) { return type.is_mastered && !use.is_used; }

/// Not on an idle bus; a DMA makes the steps itself; a line that nobody writes to has no transmit interrupt.
bool can_interrupt(const DriverSource& source, const BusType& type, const BusUse& use, Mover mover) {
  if (is_idle(type, use)) return false;
  if (source.counts == DriverSource::Counts::steps && mover == Mover::dma) return false;
  const bool is_silent = type.has_two_lines && use.is_declared && !use.transmits;
  return !(is_silent && source.raised_by == DriverSource::RaisedBy::transmit);
}

/// The shortest distance of what comes in, of `bits` at the rate of the bus: by the fastest clock of the parts on it,
/// or of a stranger's that is as good as is usual.
Duration received_apart(const Robot& robot, BusId bus, Duration apart) {
  Duration least = shortest_counted(robot, shortest_time(apart, kUsualTolerancePpm));
  for (const gen::Device& device : robot.devices) {
    for (const Connection& connection : connections_of(device)) {
      const bool is_here = device.type != nullptr && robot.segments[connection.segment].bus == bus;
      if (is_here) least = std::min(least, shortest_of_bits(robot, device, apart));
    }
  }
  return std::max(least, nanoseconds(1));
}

/// What the board says of the driver; null where it says nothing.
const Driver* driver_of(const Robot& robot, BusId bus) {
  return robot.board != nullptr ? robot.board->driver(robot.buses[bus].kind) : nullptr;
}

bool is_of_transfer(DriverSource::Counts counts) {
  return counts == DriverSource::Counts::steps || counts == DriverSource::Counts::ends;
}

bool ends_frame(DriverSource::Counts counts) {
  return counts == DriverSource::Counts::received || counts == DriverSource::Counts::ends;
}

/// Frames that one request hands over at most: no more than the controller has room for.
std::size_t requested_frames(const Driver& driver, const BusUse& use) {
  return std::min(use.shared_frames, std::max<std::size_t>(driver.mailboxes, 1));
}

/// One run of a source's service routine. A request hands over no more frames than the controller has room for. A
/// routine that waits for the wire does most of its work meanwhile.
Duration routine(const Driver& driver, const DriverSource& source, const BusUse& use, std::int64_t rate) {
  const auto frames = static_cast<std::int64_t>(requested_frames(driver, use));
  const Duration work = source.isr_wcet + use.slots * source.isr_per_slot + frames * source.isr_per_frame;
  if (source.isr_waits_bits == 0) return work;
  const Duration wait = ceil_div(source.isr_waits_bits * seconds(1), std::max<std::int64_t>(rate, 1));
  return std::max(work, wait + source.isr_beside_wait.value_or(work));
}

/// What the bounds of the image call the event that raises a source.
DriverSource::Counts event_of(const DriverSource& source) {
  using Counts = DriverSource::Counts;
  if (source.counts != Counts::nothing) return source.counts;
  return source.raised_by == DriverSource::RaisedBy::transmit ? Counts::ends : Counts::received;
}

/// The bound of the image of a request; none: it does not tell them apart by their frames.
std::optional<Duration> computed_request(const Robot& robot, BusId bus, std::size_t frames) {
  const auto found = robot.computed->requests.find(bus);
  if (found == robot.computed->requests.end() || found->second.size() < frames) return std::nullopt;
  return found->second[frames - 1];
}

/// The bound of the image of one run, with what it makes others do again; none: it has none.
std::optional<Duration> computed_routine(const Robot& robot, BusId bus, const DriverSource& source,
                                         std::size_t frames) {
  if (!robot.computed) return std::nullopt;
  const auto request = computed_request(robot, bus, frames);
  if (source.counts == DriverSource::Counts::requests && request) return request;
  const auto found = robot.computed->routines.find({bus, event_of(source)});
  if (found == robot.computed->routines.end()) return std::nullopt;
  const ComputedCosts::Retries& retries = robot.computed->retries;
  if (source.counts == DriverSource::Counts::received) return found->second + retries.received;
  if (source.counts == DriverSource::Counts::events) return found->second + retries.event;
  return found->second;
}

/// What the port makes of the rate that is asked for, at its slowest.
std::int64_t line_rate(const Robot& robot, const gen::Bus& bus) {
  const Port* port = port_of(robot, bus);
  return port == nullptr ? bus.rate : slowest_rate(*port, bus.kind, bus.rate);
}

/// The rate that is asked for, or what the port makes of it where that is faster.
std::int64_t fastest_line_rate(const Robot& robot, const gen::Bus& bus) {
  const Port* port = port_of(robot, bus);
  if (port == nullptr || bus.rate <= 0) return bus.rate;
  const double made = std::ceil(made_rate(*port, bus.kind, static_cast<double>(bus.rate)));
  return std::max(bus.rate, static_cast<std::int64_t>(made));
}

/// The least bits between two interrupts of a source. Where all that goes over the bus is declared, those of the
/// shortest frame that raises one.
std::int64_t bits_apart(const DriverSource& source, const BusUse& use) {
  std::int64_t declared = 0;
  if (use.is_declared && source.counts == DriverSource::Counts::received) declared = use.least_received;
  if (use.is_declared && source.counts == DriverSource::Counts::ends) declared = use.least_sent;
  return std::max(source.min_frame_bits, declared);
}

/// A bound counts in place of what is assumed, and of what is declared where it is above that.
void set_time(std::optional<Duration> declared, std::optional<Duration> computed, Duration assumed,
              InterruptSource& source) {
  source.wcet = std::max(declared.value_or(Duration::zero()), computed.value_or(Duration::zero()));
  if (!declared && !computed) source.wcet = assumed;
  source.source = computed ? WcetSource::computed : declared ? WcetSource::declared : WcetSource::assumed;
}

/// What the DMA of a bus takes from the core for each byte: at most a transfer over the bridge to APB1 and two accesses
/// to SRAM, where both want the same at once (AN4031 2.1 and tables 4 and 5), in each direction.
InterruptSource dma_of(const Robot& robot, BusId id, const BusUse& use) {
  constexpr std::int64_t kBeat = 11;  // cycles
  const BusType& type = bus_type(robot.buses[id].kind);
  const bool is_both_ways = type.is_mastered || use.transmits || !use.is_declared;
  const Duration apart = frame_time(type.has_two_lines ? 10 : 8, fastest_line_rate(robot, robot.buses[id]));
  InterruptSource source;
  source.name = "dma";
  source.wcet = (is_both_ways ? 2 : 1) * ceil_div(kBeat * seconds(1), robot.board->cpu_hz);
  source.min_interval = type.is_mastered ? apart : received_apart(robot, id, apart);
  source.steals = true;
  source.source = robot.computed ? WcetSource::computed : WcetSource::assumed;
  return source;
}

std::optional<Duration> longest_of(const std::vector<InterruptSource>& sources) {
  std::optional<Duration> longest;
  for (const InterruptSource& source : sources) longest = std::max(longest.value_or(source.wcet), source.wcet);
  return longest;
}

/// One source of the driver of a bus, without budgets.
InterruptSource served_interrupt(const Robot& robot, BusId id, const BusUse& use, const Driver& driver,
                                 const DriverSource& given) {
  const gen::Bus& bus = robot.buses[id];
  const BusType& type = bus_type(bus.kind);
  const Duration apart = frame_time(bus.min_frame_bits.value_or(bits_apart(given, use)), fastest_line_rate(robot, bus));
  const bool is_foreign = !type.is_mastered && given.raised_by != DriverSource::RaisedBy::transmit;
  InterruptSource source;
  source.name = given.name;
  source.min_interval = is_foreign ? received_apart(robot, id, apart) : apart;
  source.of_transfers = type.is_mastered && is_of_transfer(given.counts);
  source.ends_frame = type.is_arbitrated && ends_frame(given.counts);
  const auto computed = computed_routine(robot, id, given, requested_frames(driver, use));
  set_time(bus.isr_wcet, computed, routine(driver, given, use, line_rate(robot, bus)), source);
  return source;
}

/// Without sources.
Bus make_bus(const Robot& robot, BusId id, const Driver& driver) {
  const gen::Bus& bus = robot.buses[id];
  const BusType& type = bus_type(bus.kind);
  Bus out;
  out.name = bus.name.text;
  out.at = bus.at;
  out.baud_bps = line_rate(robot, bus);
  out.arbitrated = type.is_arbitrated;
  out.polled = type.is_polled;
  out.min_frame_bits = std::max<std::int64_t>(bus.min_frame_bits.value_or(driver.min_frame_bits), 1);
  out.wcet = bus.isr_wcet.value_or(driver.isr_wcet);
  out.frame = frame_time(out.min_frame_bits, bus.rate);  // the fastest the wire can bring them
  out.advice = advice_for(robot, id);
  return out;
}

/// Adds the sources that can interrupt in this robot. Returns what those of the driver count; that of a DMA follows
/// them.
std::vector<DriverSource::Counts> add_sources(const Robot& robot, BusId id, const BusUse& use, const Driver& driver,
                                              Bus& bus) {
  const BusType& type = bus_type(robot.buses[id].kind);
  const Mover mover = mover_of(robot, id);
  std::vector<DriverSource::Counts> counts;
  bus.sources.emplace();
  for (const DriverSource& source : driver.sources) {
    if (!can_interrupt(source, type, use, mover)) continue;
    bus.sources->push_back(served_interrupt(robot, id, use, driver, source));
    counts.push_back(source.counts);
  }
  const bool has_dma = mover == Mover::dma && robot.board->cpu_hz > 0 && !is_idle(type, use);
  if (has_dma) bus.sources->push_back(dma_of(robot, id, use));
  if (robot.computed) bus.wcet = longest_of(*bus.sources).value_or(bus.wcet);
  return counts;
}

}  // namespace

BusPlaces::BusPlaces(const Robot& robot) : robot_(robot), places_(robot.buses.size()) {
  for (const BusId bus : robot.buses.ids()) {
    if (robot.buses[bus].rate <= 0) continue;
    places_[bus] = buses_.push_back(bus);
  }
}

std::size_t mailboxes_of(const Robot& robot, BusId bus) {
  const Driver* driver = driver_of(robot, bus);
  return driver == nullptr ? 0 : driver->mailboxes;
}

Mover mover_of(const Robot& robot, BusId bus) {
  const Port* port = port_of(robot, robot.buses[bus]);
  return port != nullptr && !port->dma.empty() ? Mover::dma : Mover::routine;
}

DriverBuses make_buses(const Robot& robot, const BusPlaces& places, const Table<BusId, BusUse>& uses) {
  DriverBuses made;
  for (const BusId id : places.buses()) {
    const Driver* driver = driver_of(robot, id);
    Bus& bus = made.buses[made.buses.push_back(make_bus(robot, id, driver != nullptr ? *driver : Driver{}))];
    made.counts.push_back(driver != nullptr ? add_sources(robot, id, uses[id], *driver, bus)
                                            : std::vector<DriverSource::Counts>{});
  }
  return made;
}

}  // namespace finemote::gen::timing
