#include "generator/timing/frame_waits.hpp"

#include <algorithm>
#include <cstdint>

namespace finemote::gen::timing {
namespace {

/// What a slot of the firmware holds, CanSlot: 31 bits of nanoseconds, of which the largest number says that it is
/// unknown.
constexpr Duration kMostHeld = nanoseconds(INT32_MAX - 1);

/// Every stage ends with the period of its job.
Responses at_deadlines(const Model& model, const TaskSet& set) {
  Responses responses;
  for (const Device& device : model.devices) {
    responses.r_plus.push_back(device.period);
    responses.r_minus.push_back(device.period);
  }
  for (const TaskBucket& bucket : set.buckets) responses.bucket.push_back(bucket.period);
  responses.closed_form.assign(set.buckets.size(), false);
  return responses;
}

/// @param late  bounds where every stage ends with the period of its job
std::optional<Duration> longest_wait(const Model& model, const TransferBounds& transfers, const TransferBounds& late,
                                     Rank device) {
  std::optional<Duration> longest;
  for (std::size_t t = 0; t < model.devices[device].transfers.size(); ++t) {
    if (!is_arbitrated_answer(model, model.devices[device].transfers[t])) continue;
    const auto bound = transfers.arrival(device, t);
    if (!bound || !transfers.all_leave(model.devices[device].transfers[t].bus)) return std::nullopt;
    const Duration wait = late.arrival(device, t).value_or(std::max(transfers.interval(device, t), *bound));
    longest = std::max(longest.value_or(Duration::zero()), wait);
  }
  return longest && *longest <= kMostHeld ? longest : std::nullopt;
}

}  // namespace

bool is_arbitrated_answer(const Model& model, const Transfer& transfer) {
  return model.buses[transfer.bus].arbitrated && (transfer.after == Transfer::After::autonomous || transfer.reads);
}

Table<Rank, std::optional<Duration>> frame_waits(const Model& model, const TransferBounds& transfers, Effort& effort) {
  Table<Rank, std::optional<Duration>> waits(model.devices.size());
  const auto arbitrates = [](const Bus& bus) { return bus.arbitrated; };
  if (std::none_of(model.buses.begin(), model.buses.end(), arbitrates)) return waits;
  const TaskSet set = make_task_set(model, Profile::tight);
  const Responses responses = at_deadlines(model, set);
  const TransferBounds late(model, Profile::tight, set, responses, effort);
  for (const Rank d : model.devices.ids()) waits[d] = longest_wait(model, transfers, late, d);
  return waits;
}

}  // namespace finemote::gen::timing
