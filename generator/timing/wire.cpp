#include "generator/timing/wire.hpp"

#include <algorithm>

#include "generator/timing/rest_of_job.hpp"
#include "generator/timing/utilization.hpp"

namespace finemote::gen::timing {
namespace {

/// Whether this transfer can bring a sample: one that reads. Where none is known to, as of a model in a file, any that
/// carries no command, or all where nothing is asked for in update().
bool measures(const Device& device, const Transfer& transfer) {
  const auto reads = [](const Transfer& other) { return other.reads; };
  if (std::any_of(device.transfers.begin(), device.transfers.end(), reads)) return transfer.reads;
  const auto is_of_update = [](const Transfer& other) { return other.after == Transfer::After::update; };
  return !transfer.command || std::none_of(device.transfers.begin(), device.transfers.end(), is_of_update);
}

}  // namespace

WireAnalysis::WireAnalysis(const Model& model, const ProfileAnalysis& profile, Effort& effort)
    : model_(model),
      profile_(profile),
      effort_(effort),
      transfers_(model, profile.result.profile, profile.set, profile.responses, effort) {}

/// One slot filled by several buckets. A flush leaves its data behind where the slot is still taken, or where it
/// preempts another flush. With L the longest time a flush lasts and w the longest a transfer does: what was handed
/// over without our data is handed over within L and over after another w; a flush that began before that has ended
/// after another L. The next flush of the fastest bucket (within T + R) sends our data, or finds them sent, or preempts
/// a flush that sends them within L.
std::optional<Duration> WireAnalysis::flush_response(std::size_t flush) const {
  const Flush& own = model_.flushes[flush];
  if (!own.bus) return Duration::zero();
  std::size_t sharers = 0, fastest = bucket_of(profile_.set, own);
  Duration wire, last;
  for (std::size_t f = 0; f < model_.flushes.size(); ++f) {
    if (f != flush && !share_slot(own, model_.flushes[f])) continue;
    const auto transfer = transfers_.of_flush(f);
    const std::size_t bucket = bucket_of(profile_.set, model_.flushes[f]);
    const Duration response = profile_.responses.bucket[bucket];
    const auto end =
        end_of_job(bucket, {}, profile_.set.flush_place(bucket), response, [response](Duration) { return response; });
    if (!transfer || !end) return std::nullopt;
    wire = std::max(wire, *transfer);
    last = std::max(last, *end);
    fastest = std::min(fastest, bucket_of(profile_.set, model_.flushes[f]));
    ++sharers;
  }
  if (sharers == 1) return wire;
  const Duration next = profile_.set.buckets[fastest].period + profile_.responses.bucket[fastest];
  return 2 * wire + 3 * last + next;
}

/// From the end of handle(device) to the end of the job.
std::optional<Duration> WireAnalysis::rest_of_job(Rank device) const {
  const TaskSet& set = profile_.set;
  const std::size_t w = set.bucket_of[device];
  Duration handles;
  for (const Rank d : set.buckets[w].devices) {
    if (d < device) handles += set.handle[d];
  }
  return end_of_job(w, handles, set.handle_place(device) + 1, profile_.responses.r_minus[device],
                    [&](Duration release) { return profile_.table.r_minus(device, release); });
}

/// From the release of a job to the end of the stage that begins a transfer of the device.
Duration WireAnalysis::stage_end(Rank device, Transfer::After stage) const {
  return (stage == Transfer::After::update ? profile_.responses.r_plus : profile_.responses.r_minus)[device];
}

/// From the release of a job, and thus from its handle(), to the end of the stage `jobs` jobs later.
std::optional<Duration> WireAnalysis::stage_after(Rank device, Transfer::After stage, std::int64_t jobs) const {
  if (!profile_.responses.ok(profile_.set.bucket_of[device])) return std::nullopt;
  return jobs * model_.devices[device].period + stage_end(device, stage);
}

/// The same to the end of the next job.
std::optional<Duration> WireAnalysis::end_of_next_job(Rank device) const {
  const std::size_t w = profile_.set.bucket_of[device];
  if (!profile_.responses.ok(w)) return std::nullopt;
  return profile_.set.buckets[w].period + profile_.responses.bucket[w];
}

/// From where `handles` is left of its handles, and the flush.
std::optional<Duration> WireAnalysis::end_of_job(std::size_t w, Duration handles, std::size_t stage, Duration latest,
                                                 const std::function<Duration(Duration release)>& of) const {
  if (!profile_.responses.ok(w)) return std::nullopt;
  const Duration work = profile_.set.buckets[w].after + handles;
  return RestOfJob(profile_.set, profile_.responses, effort_).from(w, work, stage, latest, of);
}

/// For how many jobs transfers of the same slot may leave a transfer no room: each has its turn before one has another,
/// and a turn lasts for as many jobs as begin until the transfer has ended.
std::optional<std::int64_t> WireAnalysis::jobs_to_wait(Rank device, std::int64_t slot) const {
  if (slot == 0) return 0;
  const std::vector<Transfer>& transfers = model_.devices[device].transfers;
  Duration end;  // of any, after the release of the job that begins it
  std::int64_t turns = 0;
  for (std::size_t t = 0; t < transfers.size(); ++t) {
    if (transfers[t].slot != slot) continue;
    const auto bound = transfers_.of(device, t);
    if (!bound) return std::nullopt;
    end = std::max(end, stage_end(device, transfers[t].after) + *bound);
    turns = add(turns, transfers[t].turns);
  }
  const std::int64_t jobs = std::max<std::int64_t>(ceil_div(end, model_.devices[device].period), 1);
  return multiply(turns, jobs) - 1;
}

std::optional<Duration> WireAnalysis::command(Rank to) const {
  const Device& device = model_.devices[to];
  if (!device.undeclared.empty()) return std::nullopt;
  std::optional<Duration> worst = device.output;
  const auto raise = [&](std::optional<Duration> value) {
    worst = worst && value ? std::optional<Duration>(std::max(*worst, *value)) : std::nullopt;
  };
  const auto after = [&](std::optional<Duration> first, std::optional<Duration> value) {
    raise(first && value ? std::optional<Duration>(*first + *value) : std::nullopt);
  };
  if (device.sets_late) after(stage_after(to, Transfer::After::update, 1), device.output);
  for (std::size_t t = 0; t < device.transfers.size(); ++t) {
    const Transfer& transfer = device.transfers[t];
    if (!transfer.command) continue;
    const auto bound = transfers_.of(to, t);
    const auto waits = jobs_to_wait(to, transfer.slot);
    if (transfer.after == Transfer::After::bucket)
      after(rest_of_job(to), bound);
    else if (!waits)
      worst = std::nullopt;
    else if (transfer.after == Transfer::After::update)
      after(stage_after(to, transfer.after, *waits + 1), bound);
    else if (*waits > 0)
      after(stage_after(to, transfer.after, *waits), bound);
    else
      raise(bound);
  }
  for (std::size_t f = 0; f < model_.flushes.size(); ++f) {
    const auto& devices = model_.flushes[f].devices;
    if (std::find(devices.begin(), devices.end(), to) == devices.end()) continue;
    after(device.sets_late ? end_of_next_job(to) : rest_of_job(to), flush_response(f));
  }
  return worst;
}

/// Whether what handle() sends may still take the slot when the next update() wants to ask.
bool WireAnalysis::is_in_the_way(Rank from) const {
  const Device& device = model_.devices[from];
  const auto asks = [&](const Transfer& t) { return t.after == Transfer::After::update && t.reads; };
  const auto question = std::find_if(device.transfers.begin(), device.transfers.end(), asks);
  if (question == device.transfers.end() || device.acquisition->every > 1) return false;
  for (std::size_t t = 0; t < device.transfers.size(); ++t) {
    const Transfer& other = device.transfers[t];
    if (other.after != Transfer::After::handle || other.bus != question->bus) continue;
    const auto bound = transfers_.of(from, t);
    if (!bound || profile_.responses.r_minus[from] + *bound > device.period) return true;
  }
  return false;
}

/// The part sends by itself.
std::optional<Duration> WireAnalysis::streamed(Rank from) const {
  const Device& device = model_.devices[from];
  Duration wire;
  for (std::size_t t = 0; t < device.transfers.size(); ++t) {
    if (device.transfers[t].after != Transfer::After::autonomous) continue;
    const BusPlace bus = device.transfers[t].bus;
    const auto bound = transfers_.arrival(from, t);
    if (!bound || (model_.buses[bus].arbitrated && !transfers_.all_leave(bus))) return std::nullopt;
    wire = std::max(wire, *bound);
  }
  const Acquisition& a = *device.acquisition;
  return a.fixed + a.interval + wire + profile_.set.blocking;
}

/// After the release of its job, at the latest: with its stage, or, where the part answers a frame that several devices
/// fill, when that one has been sent.
std::optional<Duration> WireAnalysis::asked_at(Rank device, const Transfer& transfer) const {
  Duration at = stage_end(device, transfer.after);
  if (transfer.slot != 0 || transfer.writes) return at;
  for (std::size_t f = 0; f < model_.flushes.size(); ++f) {
    const Flush& flush = model_.flushes[f];
    const bool is_of_device = std::find(flush.devices.begin(), flush.devices.end(), device) != flush.devices.end();
    if (!is_of_device || flush.bus != transfer.bus) continue;
    const auto sent = flush_response(f);
    if (!sent) return std::nullopt;
    at = std::max(at, profile_.responses.bucket[profile_.set.bucket_of[device]] + *sent);
  }
  return at;
}

/// The device asks.
std::optional<Duration> WireAnalysis::asked(Rank from) const {
  const Device& device = model_.devices[from];
  if (!profile_.responses.ok(profile_.set.bucket_of[from]) || is_in_the_way(from)) return std::nullopt;
  const Acquisition& a = *device.acquisition;
  Duration busy;  // from the release on, until what was asked for has come
  for (std::size_t t = 0; t < device.transfers.size(); ++t) {
    const Transfer& transfer = device.transfers[t];
    if (transfer.after == Transfer::After::autonomous || !measures(device, transfer)) continue;
    const auto bound = transfers_.of(from, t);
    if (!bound) return std::nullopt;
    const auto begin = asked_at(from, transfer);
    if (!begin) return std::nullopt;
    // After a measurement the answer may wait for as much as the question has.
    const bool waits_twice = model_.buses[transfer.bus].arbitrated && a.conversion > Duration::zero();
    busy = std::max(busy, *begin + (waits_twice ? 2 : 1) * *bound);
  }
  const Duration response = profile_.responses.r_plus[from];
  busy = std::max(busy, response) + a.conversion;
  const std::int64_t extra_of_each = std::max<std::int64_t>(ceil_div(busy, device.period) - 1, 0);
  const std::int64_t extra = multiply(std::max<std::int64_t>(a.conversions, 1), extra_of_each);
  // Measured in `periods` and published then; read until just before the next one that is published, of which each is
  // begun `apart` periods after the one before, and `every` of them make one value.
  const std::int64_t least = std::max<std::int64_t>(a.periods, 1);
  const std::int64_t apart = add(std::max<std::int64_t>(a.begun_every, 1), extra);
  const std::int64_t periods = add(add(least, extra), multiply(a.every, apart) - 1);
  return a.fixed + a.interval + response + periods * device.period;
}

std::optional<Duration> WireAnalysis::acquisition(Rank from) const {
  const Device& device = model_.devices[from];
  if (device.unknown_age != UnknownAge::none || !device.undeclared.empty()) return std::nullopt;
  if (!device.acquisition) return Duration::zero();
  if (device.acquisition->periods > 0) return asked(from);
  const auto sent = streamed(from);
  const auto is_answered = [](const Transfer& t) { return t.after != Transfer::After::autonomous && t.reads; };
  const bool asks_too = device.acquisition->conversion > Duration::zero() ||
                        std::any_of(device.transfers.begin(), device.transfers.end(), is_answered);
  if (!asks_too || !sent) return sent;
  const auto answered = asked(from);
  return answered ? std::optional(std::max(*sent, *answered)) : std::nullopt;
}

Table<Rank, std::optional<Duration>> WireAnalysis::acquisitions() const {
  Table<Rank, std::optional<Duration>> ages;
  for (const Rank d : model_.devices.ids()) ages.push_back(acquisition(d));
  return ages;
}

}  // namespace finemote::gen::timing
