#include "generator/timing/unbounded.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/timing/shares.hpp"
#include "generator/timing/words.hpp"

namespace finemote::gen::timing {
namespace {

const BucketResult& bucket_of(const Timing& timing, Rank device) {
  const auto& buckets = timing.best().buckets;
  return *std::find_if(buckets.begin(), buckets.end(), [&](const BucketResult& bucket) {
    return bucket.period == timing.model.devices[device].period;
  });
}

/// What keeps one part of a chain from having a bound.
struct Cause {
  ChainPart part = ChainPart::acquire;
  std::optional<Duration> period;  ///< of a bucket that may miss its deadline
  std::optional<BusPlace> bus;     ///< else: where a message may wait without end, or longer than until the next
  Rank device;                     ///< whose bucket or message it is
  std::optional<Rank> ageless = std::nullopt;  ///< of which it is unknown how old its data are
  friend bool operator==(const Cause& a, const Cause& b) {
    return a.part == b.part && a.period == b.period && a.bus == b.bus && a.ageless == b.ageless;
  }
};

std::optional<Cause> late_bucket(const Timing& timing, ChainPart part, const std::vector<Rank>& on) {
  for (const Rank device : on) {
    const BucketResult& bucket = bucket_of(timing, device);
    if (!bucket.ok) return Cause{part, bucket.period, std::nullopt, device};
  }
  return std::nullopt;
}

std::vector<Cause> causes(const Timing& timing, const ChainResult& chain) {
  std::vector<Cause> list;
  const auto look = [&](ChainPart part, const std::vector<Rank>& on, std::optional<BusPlace> bus) {
    if (const auto late = late_bucket(timing, part, on)) return list.push_back(*late);
    list.push_back({part, std::nullopt, bus, on.front()});
  };
  if (timing.model.devices[chain.from].unknown_age != UnknownAge::none) {
    list.push_back({ChainPart::acquire, std::nullopt, std::nullopt, chain.from, chain.from});
  } else if (!chain.acquire) {
    look(ChainPart::acquire, {chain.from}, sample_bus(timing.model, chain.from));
  }
  if (!chain.decide) look(ChainPart::decide, devices_between(timing.model, chain), std::nullopt);
  if (!chain.wire) look(ChainPart::wire, {chain.to}, command_bus(timing.model, chain.to));
  return list;
}

std::string unknown_age_text(const Device& device) {
  if (device.unknown_age == UnknownAge::no_acquisition)
    return fmt::format("what '{}' reads is older than its update(), and its type does not say how much ('acquisition')",
                       device.name);
  if (device.unknown_age == UnknownAge::sent_by_itself)
    return fmt::format(
        "'{}' receives data that it has not asked for, but its type is 'polled' and does not say how often they come",
        device.name);
  if (device.unknown_age == UnknownAge::shared_converter)
    return fmt::format("the converter of '{}' measures another input, too, and drops what nobody has taken yet",
                       device.name);
  return fmt::format(
      "a measurement of '{}' may find its slot taken by another transfer of its own: its type does not say how many in "
      "a row ('published_every' of 'acquisition')",
      device.name);
}

std::string why(const Timing& timing, const Cause& cause) {
  if (cause.ageless) return unknown_age_text(timing.model.devices[*cause.ageless]);
  if (cause.period && timing.verdict().release && timing.verdict().release->is_guilty()) return "releases can be lost";
  if (cause.period) return bucket_text(*cause.period) + " may miss their deadline";
  if (!cause.bus) return "another device on the way may miss its deadline";
  const std::string undeclared = undeclared_text(timing.model, *cause.bus);
  if (!undeclared.empty()) return undeclared;
  const Bus& bus = timing.model.buses[*cause.bus];
  const double load = timing.bus_loads[*cause.bus].utilization;
  const std::string users = shares_text(bus_shares(timing.model, *cause.bus));
  if (load > 1)
    return fmt::format("bus '{}' is overloaded: it needs {} of its capacity ({})", bus.name, percent(load), users);
  const Device& device = timing.model.devices[cause.device];
  return fmt::format(
      "on bus '{}' a message of '{}' may still be queued when the next one is due: {} of the capacity is used, "
      "and in the worst case all of it at once ({})",
      bus.name, device.name, percent(load), users);
}

/// Chains of `after` to where `chains` of `before` lead that lack this part. Another source may be the worst one there.
std::size_t still_missing(const Timing& after, const Timing& before, ChainPart part,
                          const std::vector<std::size_t>& chains) {
  Table<Rank, bool> is_end(before.model.devices.size(), false);
  for (const std::size_t c : chains) is_end[before.chains[c].to] = true;
  return static_cast<std::size_t>(
      std::count_if(after.chains.begin(), after.chains.end(),
                    [&](const ChainResult& chain) { return is_end[chain.to] && !chain.bound_of(part); }));
}

std::vector<std::string> restored_by(const Timing& timing, const Cause& cause, const std::vector<std::size_t>& chains,
                                     Trials& trials) {
  if (!cause.bus || !undeclared_text(timing.model, *cause.bus).empty()) return {};  // the hints of FM4015
  const Goal goal{[&](const Timing& t) { return static_cast<double>(still_missing(t, timing, cause.part, chains)); }, 0,
                  true};
  std::vector<std::string> texts;
  const std::vector<Family> families{
      faster_rates(timing.model, *cause.bus),
      longer_periods(timing.model, periodic_users(timing.model, *cause.bus),
                     fmt::format("what sends on bus '{}'", timing.model.buses[*cause.bus].name)),
      other_bus(timing.model, *cause.bus)};
  for (const Remedy& remedy : trials.find(families, goal)) {
    if (remedy.enough) texts.push_back(remedy.proposal.text);
  }
  return texts;
}

}  // namespace

std::vector<MissingBound> missing_bounds(const Timing& timing, Trials& trials) {
  std::vector<MissingBound> list;
  std::vector<Cause> known;
  for (std::size_t c = 0; c < timing.chains.size(); ++c) {
    if (timing.chains[c].end_to_end) continue;
    for (const Cause& cause : causes(timing, timing.chains[c])) {
      const auto at = static_cast<std::size_t>(std::find(known.begin(), known.end(), cause) - known.begin());
      if (at == known.size()) {
        known.push_back(cause);
        list.push_back({cause.part, why(timing, cause), {}, {}});
      }
      list[at].chains.push_back(c);
    }
  }
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i].restored_by = restored_by(timing, known[i], list[i].chains, trials);
  return list;
}

}  // namespace finemote::gen::timing
