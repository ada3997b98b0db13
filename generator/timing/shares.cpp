#include "generator/timing/shares.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/timing/words.hpp"

namespace finemote::gen::timing {
void add_share(std::vector<Share>& shares, const std::string& who, double load, bool autonomous) {
  const auto known = std::find_if(shares.begin(), shares.end(),
                                  [&](const Share& s) { return s.who == who && s.autonomous == autonomous; });
  if (known == shares.end()) return shares.push_back({who, load, autonomous});
  known->load += load;
}

std::vector<Share> bus_shares(const Model& model, BusPlace bus) {
  std::vector<Share> lines[2];
  for (const Device& device : model.devices) {
    for (const Transfer& t : device.transfers) {
      if (t.bus != bus) continue;
      const bool autonomous = t.after == Transfer::After::autonomous;
      const Duration period = autonomous && t.min_interval > Duration::zero() ? t.min_interval : device.period;
      add_share(lines[t.receive ? 1 : 0], quoted(device.name), ratio(t.wire, period), autonomous);
    }
  }
  for (const Flush& flush : model.flushes) {
    if (flush.bus != bus || flush.devices.empty()) continue;
    const std::string more = flush.devices.size() > 1 ? fmt::format(" and {} more", flush.devices.size() - 1) : "";
    add_share(lines[0], quoted(model.devices[flush.devices.front()].name) + more, ratio(flush.wire, flush.period),
              false);
  }
  const auto sum = [](const std::vector<Share>& shares) {
    double load = 0;
    for (const Share& share : shares) load += share.load;
    return load;
  };
  std::vector<Share>& busier = lines[sum(lines[1]) > sum(lines[0]) ? 1 : 0];
  std::stable_sort(busier.begin(), busier.end(), [](const Share& a, const Share& b) { return a.load > b.load; });
  return busier;
}

std::string shares_text(const std::vector<Share>& shares) {
  constexpr std::size_t kMost = 12;
  std::string text;
  for (std::size_t i = 0; i < shares.size() && i < kMost; ++i) {
    text += fmt::format("{}{}{}: {}", i > 0 ? ", " : "", shares[i].who, shares[i].autonomous ? " by itself" : "",
                        percent(shares[i].load));
  }
  if (shares.size() > kMost) text += fmt::format(" and {} more", shares.size() - kMost);
  return text;
}

namespace {

/// Devices with a transfer on the bus that is wanted, or in a flush over it.
template <class Wanted>
std::vector<Rank> users(const Model& model, BusPlace bus, const Wanted& is_wanted) {
  Table<Rank, bool> uses(model.devices.size(), false);
  for (const Rank d : model.devices.ids()) {
    for (const Transfer& t : model.devices[d].transfers) uses[d] = uses[d] || (t.bus == bus && is_wanted(t));
  }
  for (const Flush& flush : model.flushes) {
    if (flush.bus != bus) continue;
    for (const Rank d : flush.devices) uses[d] = true;
  }
  std::vector<Rank> list;
  for (const Rank d : uses.ids()) {
    if (uses[d]) list.push_back(d);
  }
  return list;
}

std::optional<BusPlace> first_undeclared(const Device& device) {
  return device.undeclared.empty() ? std::nullopt : std::optional(device.undeclared.front());
}

}  // namespace

std::vector<Rank> periodic_users(const Model& model, BusPlace bus) {
  return users(model, bus, [](const Transfer& t) {
    return t.after != Transfer::After::autonomous || t.min_interval == Duration::zero();
  });
}

std::vector<Rank> bus_users(const Model& model, BusPlace bus) {
  return users(model, bus, [](const Transfer&) { return true; });
}

std::optional<BusPlace> command_bus(const Model& model, Rank to) {
  for (const Transfer& t : model.devices[to].transfers) {
    if (t.command) return t.bus;
  }
  for (const Flush& flush : model.flushes) {
    if (flush.bus && std::find(flush.devices.begin(), flush.devices.end(), to) != flush.devices.end()) return flush.bus;
  }
  return first_undeclared(model.devices[to]);
}

std::optional<BusPlace> sample_bus(const Model& model, Rank from) {
  const std::vector<Transfer>& transfers = model.devices[from].transfers;
  for (const Transfer& t : transfers) {
    if (!t.command) return t.bus;
  }
  if (transfers.empty()) return first_undeclared(model.devices[from]);
  return transfers.front().bus;  // it is asked together with its command
}

std::string undeclared_text(const Model& model, BusPlace bus) {
  constexpr std::size_t kMost = 3;
  std::string who;
  std::size_t count = 0;
  for (const Device& device : model.devices) {
    if (std::find(device.undeclared.begin(), device.undeclared.end(), bus) == device.undeclared.end()) continue;
    if (++count <= kMost) who += (who.empty() ? "" : ", ") + quoted(device.name);
  }
  if (count == 0) return {};
  if (count > kMost) who += fmt::format(" and {} more", count - kMost);
  return fmt::format("the load of bus '{}' is unknown: {} not declare {} there ('frames')", model.buses[bus].name,
                     who + (count > 1 ? " do" : " does"), count > 1 ? "what they send" : "what it sends");
}

std::vector<Rank> devices_between(const Model& model, const ChainResult& chain) {
  std::vector<Rank> way;
  for (std::optional<Rank> d = chain.from; d; d = model.devices[*d].parent) way.push_back(*d);
  for (std::optional<Rank> d = chain.to; d; d = model.devices[*d].parent) way.push_back(*d);
  return way;
}

}  // namespace finemote::gen::timing
