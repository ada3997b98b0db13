#include "generator/timing/processor.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

long double exact_ratio(Duration part, Duration whole) {
  return static_cast<long double>(part.ns()) / static_cast<long double>(whole.ns());
}

/// Runs per nanosecond: by the distance of two, or by budgets where they are slower.
long double rate(const Stream& stream) {
  const long double by_distance = 1.0L / static_cast<long double>(stream.separation.ns());
  if (stream.budgets.empty()) return by_distance;
  long double budget = 0;
  for (const Stream::Budget& b : stream.budgets)
    budget +=
        static_cast<long double>(b.count) / static_cast<long double>(b.period.ns()) / static_cast<long double>(b.every);
  return std::min(by_distance, budget);
}

double share(const Stream& stream) {
  return static_cast<double>(rate(stream) * static_cast<long double>(stream.cost.ns()));
}

/// What people call a flush: its output, the bus it goes over, or the first device it writes.
std::string flush_name(const Model& model, const Flush& flush) {
  if (!flush.output.empty()) return flush.output;
  if (flush.bus) return model.buses[*flush.bus].name;
  return flush.devices.empty() ? std::string("output") : model.devices[flush.devices.front()].name;
}

void add_buckets(const Model& model, const TaskSet& set, std::vector<ProcessorUse>& list) {
  for (const TaskBucket& bucket : set.buckets) {
    const Duration work = bucket.cost - bucket.after;
    list.push_back({ProcessorUse::Kind::bucket, units::format_duration(bucket.period), "", work, bucket.period,
                    static_cast<double>(exact_ratio(work, bucket.period))});
    if (bucket.after == Duration::zero()) continue;  // the profile has no flushes
    for (const Flush& flush : model.flushes) {
      if (flush.period != bucket.period) continue;
      list.push_back({ProcessorUse::Kind::flush, flush_name(model, flush), "", flush.wcet, flush.period,
                      static_cast<double>(exact_ratio(flush.wcet, flush.period))});
    }
  }
}

void add_interrupts(const TaskSet& set, std::vector<ProcessorUse>& list) {
  ProcessorUse release{ProcessorUse::Kind::release, "release", "", {}, nanoseconds(1), 0};
  const auto add = [&](ProcessorUse::Kind kind, const Stream& stream, const std::string& source) {
    list.push_back({kind, stream.bus, source, stream.cost, stream.separation, share(stream)});
  };
  for (const Stream& stream : set.sources) add(ProcessorUse::Kind::interrupt, stream, stream.source);
  for (const Stream& stream : set.dma) add(ProcessorUse::Kind::dma, stream, "");
  for (std::size_t s = set.bus_streams; s < set.streams.size(); ++s) {
    const Stream& stream = set.streams[s];
    release.cost += stream.cost;
    release.every = stream.separation;  // the release itself comes last
    release.utilization += share(stream);
  }
  list.push_back(release);
}

}  // namespace

std::string_view kind_name(ProcessorUse::Kind kind) {
  switch (kind) {
    case ProcessorUse::Kind::bucket:
      return "bucket";
    case ProcessorUse::Kind::flush:
      return "flush";
    case ProcessorUse::Kind::interrupt:
      return "interrupt";
    case ProcessorUse::Kind::dma:
      return "dma";
    case ProcessorUse::Kind::release:
      return "release";
  }
  return "";
}

std::string user_text(const ProcessorUse& use) {
  switch (use.kind) {
    case ProcessorUse::Kind::bucket:
      return fmt::format("devices every {}", use.name);
    case ProcessorUse::Kind::flush:
      return fmt::format("flush of '{}' every {}", use.name, units::format_duration(use.every));
    case ProcessorUse::Kind::interrupt:
      return use.source.empty() ? fmt::format("interrupts of bus '{}'", use.name)
                                : fmt::format("'{}' interrupts of bus '{}'", use.source, use.name);
    case ProcessorUse::Kind::dma:
      return fmt::format("DMA of bus '{}'", use.name);
    case ProcessorUse::Kind::release:
      return "release interrupts";
  }
  return "";
}

std::vector<ProcessorUse> processor_use(const Model& model, const TaskSet& set) {
  std::vector<ProcessorUse> list;
  add_buckets(model, set, list);
  add_interrupts(set, list);
  std::erase_if(list, [](const ProcessorUse& use) { return use.utilization <= 0; });
  std::stable_sort(list.begin(), list.end(),
                   [](const ProcessorUse& a, const ProcessorUse& b) { return a.utilization > b.utilization; });
  return list;
}

double processor_share(const TaskSet& set) {
  long double sum = 0;
  const auto add = [&](const Stream& stream) { sum += rate(stream) * static_cast<long double>(stream.cost.ns()); };
  for (const Stream& stream : set.sources) add(stream);
  for (const Stream& stream : set.dma) add(stream);
  for (std::size_t s = set.bus_streams; s < set.streams.size(); ++s) add(set.streams[s]);
  for (const TaskBucket& bucket : set.buckets) sum += exact_ratio(bucket.cost, bucket.period);
  return static_cast<double>(sum);
}

}  // namespace finemote::gen::timing
