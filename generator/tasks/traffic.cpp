#include "generator/tasks/traffic.hpp"

#include <algorithm>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/bus/line_format.hpp"
#include "generator/descriptor/pin_name.hpp"
#include "generator/model/part_clock.hpp"
#include "generator/model/shared_frame.hpp"
#include "generator/model/streamed_frames.hpp"
#include "generator/tasks/frame_units.hpp"

namespace finemote::gen::timing {
namespace {

/// Of what software asks for: nothing but how often it does bounds it.
constexpr Duration kAnyDistance = nanoseconds(1);

/// It answers the frame that its device fills together with others.
bool is_reply(const gen::Device& device, const Frame& frame, const WireRate& rate) {
  return bus_type(rate.kind).is_arbitrated && frame.write_bytes == 0 && frame.read_bytes > 0 && shared_frame_of(device);
}

/// The routine of a line asks for each pin of the board that shares it, used or not: measured with five.
Duration looks_at_others(const Board& board, const std::string& pin) {
  constexpr Duration kLook = nanoseconds(300);
  std::set<std::string> others;
  for (const NamedPin& other : board.pins) {
    const bool is_shared = other.can("interrupt") && other.pin != pin &&
                           edge_interrupt(pin_name(other.pin)) == edge_interrupt(pin_name(pin));
    if (is_shared) others.insert(other.pin);
  }
  return static_cast<std::int64_t>(others.size()) * kLook;
}

/// What a unit of a device asks of its bus.
WireUse use_of(const Robot& robot, const gen::Device& device, const FrameUnit& unit, const WireRate& rate) {
  WireUse use;
  for (const Frame& frame : unit.frames) {
    if (frame.stage == FrameStage::autonomous)
      use.add_sent(rate, std::max(frame.write_bytes, frame.read_bytes));
    else if (is_reply(device, frame, rate))
      use.add_reply(rate, frame.read_bytes);
    else
      use.add(rate, frame.write_bytes, frame.read_bytes);
    if (frame.stage != FrameStage::autonomous) continue;
    const Duration apart = shortest_interval(robot, device, frame).value_or(device.period);
    const bool is_first = use.min_interval == Duration::zero();
    use.min_interval = is_first ? apart : std::min(use.min_interval, apart);
  }
  return use;
}

/// Of the one frame that a part on CAN sends by itself; none where it may be another.
std::optional<std::int64_t> own_identifier(const gen::Device& device, const std::vector<Frame>& frames,
                                           FrameStage stage) {
  const auto by_itself = std::count_if(frames.begin(), frames.end(),
                                       [](const Frame& frame) { return frame.stage == FrameStage::autonomous; });
  const std::vector<IdentifierRange> ranges = device.type->received(device.id.value_or(0));
  if (stage != FrameStage::autonomous || by_itself != 1 || ranges.size() != 1 || ranges.front().count != 1)
    return std::nullopt;
  return static_cast<std::int64_t>(ranges.front().first);
}

Transfer::After after(FrameStage stage) {
  switch (stage) {
    case FrameStage::update:
      return Transfer::After::update;
    case FrameStage::handle:
      return Transfer::After::handle;
    case FrameStage::flush:
      return Transfer::After::bucket;
    case FrameStage::autonomous:
      return Transfer::After::autonomous;
  }
  return Transfer::After::autonomous;
}

AskedIn asked_in(FrameStage stage) {
  if (stage == FrameStage::update) return AskedIn::update;
  return stage == FrameStage::flush ? AskedIn::flush : AskedIn::handle;
}

}  // namespace

Traffic::Traffic(const Robot& robot, const BusPlaces& places, const Table<BusId, BusUse>& uses,
                 Table<BusPlace, std::vector<DriverSource::Counts>> counts, Model& model)
    : robot_(robot),
      places_(places),
      uses_(uses),
      model_(model),
      counts_(std::move(counts)),
      user_(model.buses.size()) {
  pins_.name = "pins";
  pins_.is_pins = true;
  pins_.sources.emplace();
}

void Traffic::add_device(const gen::Device& device, Rank place) {
  for (const Connection& connection : connections_of(device)) add_frames(device, connection, place);
  mark_late_commands(device, place);
  add_own_lines(device, place);
}

void Traffic::add_frames(const gen::Device& device, const Connection& connection, Rank place) {
  const auto bus = places_.of(connection.segment);
  if (!bus) return;
  if (!user_[*bus]) {
    user_[*bus] = place;
    allow_events(*bus, place);
  }
  Device& own = model_.devices[place];
  const std::vector<Frame> frames = frames_over(device, connection);
  const BusId id = places_.buses()[*bus];
  if (bus_type(robot_.buses[id].kind).unit != nullptr && !is_declared(robot_, device, connection))
    own.undeclared.push_back(*bus);
  const WireRate rate{robot_.buses[id].kind, model_.buses[*bus].baud_bps, mover_of(robot_, id),
                      line_format(format_over(device, connection)).bits_per_byte()};
  const auto slot = static_cast<std::int64_t>(1 + own.transfers.size());  // of this connection alone
  for (const FrameUnit& unit : frame_units(frames, rate.kind)) {
    if (unit.stage == FrameStage::flush) continue;
    WireUse use = use_of(robot_, device, unit, rate);
    add_selection(connection.segment, rate, use);
    add_transfer(place, *bus, unit.stage, use);
    Transfer& transfer = own.transfers.back();
    const bool sends = unit.stage == FrameStage::autonomous || (unit.reads && !bus_type(rate.kind).is_mastered);
    if (sends) transfer.wire = longest_of_bits(robot_, device, transfer.wire);
    transfer.reads = unit.is_asked() && unit.reads;
    transfer.writes = unit.is_asked() && unit.writes;
    transfer.sets = unit.is_asked() && unit.sets;
    transfer.command = unit.stage == FrameStage::handle && unit.writes;
    transfer.slot = unit.turns > 0 ? slot : 0;
    transfer.turns = unit.turns;
    if (connection.use == nullptr) transfer.identifier = own_identifier(device, frames, unit.stage);
  }
  share_wire_of_answers(own.transfers, static_cast<std::size_t>(slot - 1));
}

/// A part has one wire for what it answers and for what it sends by itself: where it does both, neither passes the
/// other.
/// @param first  the first transfer of the connection
void Traffic::share_wire_of_answers(std::vector<Transfer>& transfers, std::size_t first) {
  const auto begin = transfers.begin() + static_cast<std::ptrdiff_t>(first);
  const auto answers = [](const Transfer& t) { return t.reads; };
  if (std::none_of(begin, transfers.end(), answers)) return;
  std::for_each(begin, transfers.end(), [](Transfer& t) { t.receive = false; });
}

/// A command may leave with what the next update() sends: where nothing leaves after handle(), or where both go over
/// one slot, which takes one transfer at a time. What a device decides without being commanded leaves in the same way.
/// A frame with which nothing comes back is no question for a sample.
void Traffic::mark_late_commands(const gen::Device& device, Rank place) {
  if (!device.type->has_command() && !device.type->actuator) return;
  const bool may_ask_alone = !may_send_late(device);
  for (Transfer& transfer : model_.devices[place].transfers) {
    const bool is_late =
        transfer.after == Transfer::After::update && (transfer.sets || (transfer.writes && !may_ask_alone));
    if (is_late) transfer.command = true;
  }
}

/// Not where the command goes to an output, nor where a sensor asks for its samples.
bool Traffic::may_send_late(const gen::Device& device) const {
  const auto is_output = [&](std::optional<SegmentId> segment) {
    return segment && bus_type(robot_.segments[*segment].bus_kind).channels == BusType::Channels::outputs;
  };
  if (device.type->has_command()) return !is_output(device.segment);
  return device.type->actuator && !is_output(device.segment) &&
         std::none_of(device.uses.begin(), device.uses.end(), [&](const Use& use) { return is_output(use.segment); });
}

void Traffic::add_selection(SegmentId segment, const WireRate& rate, WireUse& use) const {
  if (robot_.segments[segment].kind != Segment::Kind::mux_channel) return;
  const Expander& own = robot_.expanders[*robot_.segments[segment].expander];
  use.add(rate, own.type->select->bytes, 0);
  std::int64_t others = 0;  // of which at most one connects anything
  for (const Expander& mux : robot_.expanders) {
    const bool is_other = &mux != &own && mux.type->is_mux() && mux.segment == own.segment;
    if (is_other) others = std::max(others, mux.type->select->bytes);
  }
  if (others > 0) use.add(rate, others, 0);
}

void Traffic::add_transfer(Rank place, BusPlace bus, FrameStage stage, const WireUse& use) {
  const bool by_itself = stage == FrameStage::autonomous;
  Transfer transfer;
  transfer.bus = bus;
  transfer.wire = use.wire;
  transfer.interrupts = use.interrupts;
  if (bus_type(robot_.buses[places_.buses()[bus]].kind).is_arbitrated)
    transfer.frames = std::max<std::int64_t>(gen::add(use.ends, use.answers), 1);
  transfer.service = service(bus, use);
  transfer.after = after(stage);
  transfer.min_interval = by_itself ? use.min_interval : Duration::zero();
  transfer.receive = by_itself && bus_type(robot_.buses[places_.buses()[bus]].kind).has_two_lines;
  model_.devices[place].transfers.push_back(transfer);
  if (by_itself) {
    allow(bus, DriverSource::Counts::received, {place, use.ends, 1, use.min_interval});
  } else {
    add_budget(bus, place, use, stage);
  }
}

/// Frames of one slot that may be under way: in the mailboxes of the controller, and in the slot.
std::int64_t Traffic::under_way(BusPlace bus) const {
  constexpr std::size_t kOfBxCan = 3;  // where the board does not say: RM0090 32.7.1
  return static_cast<std::int64_t>(std::max(mailboxes_of(robot_, places_.buses()[bus]), kOfBxCan)) + 1;
}

void Traffic::add_budget(BusPlace bus, Rank place, const WireUse& use, FrameStage stage, std::int64_t every) {
  const bool together = use.in_one_request || bus_type(robot_.buses[places_.buses()[bus]].kind).is_mastered;
  FrameBudget budget{place, together ? 1 : use.ends, every, {}};
  budget.cause = InterruptCause::request;
  budget.asked_in = asked_in(stage);
  allow(bus, DriverSource::Counts::requests, budget);
  budget.cause = InterruptCause::transfer;
  budget.count = use.steps;
  allow(bus, DriverSource::Counts::steps, budget);
  budget.count = use.ends;
  allow(bus, DriverSource::Counts::ends, budget);
  allow_bytes(bus, use, budget);
  if (use.answers == 0) return;
  FrameBudget answers{place, use.answers, every, {}};
  const auto& measured = model_.devices[place].acquisition;
  answers.carry_in = 1 + under_way(bus) + (measured ? ceil_div(measured->conversion, model_.devices[place].period) : 0);
  allow(bus, DriverSource::Counts::received, answers);
}

/// The driver allows so many from one look of the reader to the next, whatever the line does; what is left is lost. A
/// window holds those left at its begin, and those that looks within it allow. Two looks are of two jobs: between them
/// lies the release of the second, so that a window of length L holds at most ceil(L/T) + 1 looks.
void Traffic::allow_events(BusPlace bus, Rank reader) {
  FrameBudget budget{reader, line_events(robot_, places_.buses()[bus]), 1, {}};
  budget.carry_in = 2;
  budget.cause = InterruptCause::look;
  allow(bus, DriverSource::Counts::events, budget);
}

/// What is asked for goes over the wire byte by byte. Nothing but the rate bounds what comes by itself.
void Traffic::allow_bytes(BusPlace bus, const WireUse& use, FrameBudget budget) {
  if (!bus_type(robot_.buses[places_.buses()[bus]].kind).is_mastered || !model_.buses[bus].sources) return;
  for (InterruptSource& source : *model_.buses[bus].sources) {
    if (!source.steals) continue;
    budget.count = ceil_div(use.wire, source.min_interval);
    source.budgets.push_back(budget);
  }
}

Duration Traffic::service(BusPlace bus, const WireUse& use) const {
  Duration total;
  const std::vector<DriverSource::Counts>& counts = counts_[bus];
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const InterruptSource& source = (*model_.buses[bus].sources)[i];
    if (!source.of_transfers) continue;
    total += (counts[i] == DriverSource::Counts::ends ? use.ends : use.steps) * source.wcet;
  }
  return total;
}

void Traffic::allow(BusPlace bus, DriverSource::Counts what, const FrameBudget& budget) {
  const bool is_of_driver = what == DriverSource::Counts::requests || what == DriverSource::Counts::events;
  if (!is_counted(bus) && !is_of_driver) return;
  const std::vector<DriverSource::Counts>& counts = counts_[bus];
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == what) (*model_.buses[bus].sources)[i].budgets.push_back(budget);
  }
}

bool Traffic::is_counted(BusPlace bus) const {
  const BusId id = places_.buses()[bus];
  return bus_type(robot_.buses[id].kind).counts_traffic && uses_[id].is_declared;
}

void Traffic::settle() {
  for (const BusPlace bus : model_.buses.ids()) {
    if (is_counted(bus)) {
      let_requests_meet(bus);
      drop_unraised(bus);
    } else {
      allow_requests_of_slots(bus);
    }
  }
  if (!pins_.sources->empty()) model_.buses.push_back(std::move(pins_));
}

/// Software asks whenever it likes: no distance bounds requests, only how often they are.
void Traffic::let_requests_meet(BusPlace bus) {
  const std::vector<DriverSource::Counts>& counts = counts_[bus];
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == DriverSource::Counts::requests) (*model_.buses[bus].sources)[i].min_interval = kAnyDistance;
  }
}

void Traffic::drop_unraised(BusPlace bus) {
  std::vector<DriverSource::Counts>& counts = counts_[bus];
  for (std::size_t i = counts.size(); i-- > 0;) {
    std::vector<InterruptSource>& sources = *model_.buses[bus].sources;
    if (counts[i] == DriverSource::Counts::nothing || !sources[i].budgets.empty()) continue;
    sources.erase(sources.begin() + static_cast<std::ptrdiff_t>(i));
    counts.erase(counts.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// A slot asks again only when its transfer has ended: as often as transfers end, and once more for each slot. Where
/// the driver does not say when they end, nothing but a distance of requests bounds them, which is assumed then.
void Traffic::allow_requests_of_slots(BusPlace bus) {
  const std::vector<DriverSource::Counts>& counts = counts_[bus];
  const auto ends = std::find(counts.begin(), counts.end(), DriverSource::Counts::ends);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] != DriverSource::Counts::requests) continue;
    std::vector<InterruptSource>& sources = *model_.buses[bus].sources;
    if (ends == counts.end() || !user_[bus]) {
      sources[i].budgets.clear();
      continue;
    }
    const Duration apart = sources[static_cast<std::size_t>(ends - counts.begin())].min_interval;
    const std::int64_t slots = std::max<std::int64_t>(uses_[places_.buses()[bus]].slots, 1);
    for (FrameBudget& budget : sources[i].budgets)
      budget.cause = InterruptCause::clock;  // some slots ask whenever they may
    sources[i].budgets.push_back({*user_[bus], slots, 1, slots * apart});
    sources[i].min_interval = kAnyDistance;
  }
}

/// Each named by a use, as further sources of the bus the device sits on, or of pins where there is none that
/// interrupts. What the driver raises for frames is in the board file.
void Traffic::add_own_lines(const gen::Device& device, Rank place) {
  for (const Interrupt& entry : device.type->interrupts) {
    const auto use = std::find_if(device.uses.begin(), device.uses.end(),
                                  [&](const Use& one) { return one.spec->role == entry.use; });
    if (use == device.uses.end()) continue;
    InterruptSource source = own_line(device, entry, place);
    if (source.source == WcetSource::assumed) source.wcet += looks_at_others(*robot_.board, use->pin);
    source.pin = DevicePin{place, use->pin};
    own_lines(device).push_back(std::move(source));
  }
}

/// The one it sits on; none: it sits on none, or on one without a rate.
std::optional<BusPlace> Traffic::bus_of(const gen::Device& device) const {
  return device.segment ? places_.of(*device.segment) : std::nullopt;
}

std::vector<InterruptSource>& Traffic::own_lines(const gen::Device& device) {
  const auto bus = bus_of(device);
  return bus && model_.buses[*bus].sources ? *model_.buses[*bus].sources : *pins_.sources;
}

/// What comes so many times in a period may come all at once, and of two periods together.
InterruptSource Traffic::own_line(const gen::Device& device, const Interrupt& entry, Rank place) const {
  const bool is_computed = robot_.computed && robot_.computed->pins > Duration::zero();
  InterruptSource source;
  source.name = device.name.text + ": " + entry.source;
  source.wcet =
      is_computed ? robot_.computed->pins + robot_.computed->retries.event : entry.wcet.value_or(pin_wcet(device));
  source.source = is_computed ? WcetSource::computed : WcetSource::assumed;
  source.min_interval = kAnyDistance;
  if (entry.is_autonomous) {
    source.min_interval =
        std::max(shortest_of_part(robot_, device, entry.min_interval.value_or(kAnyDistance)), kAnyDistance);
  } else {
    source.budgets.push_back({place, std::max<std::int64_t>(entry.count, 1), 1, {}});
  }
  return source;
}

/// Where the type does not say how long the routine of a line takes.
Duration Traffic::pin_wcet(const gen::Device& device) const {
  constexpr Duration kUsual = microseconds(5);
  const auto bus = bus_of(device);
  const Duration driver = bus ? model_.buses[*bus].wcet : Duration::zero();
  return driver > Duration::zero() ? driver : kUsual;
}

}  // namespace finemote::gen::timing
