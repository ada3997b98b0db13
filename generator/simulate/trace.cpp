#include "generator/simulate/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <tuple>

#include "generator/timing/table.hpp"

namespace finemote::gen {
namespace {

std::string quoted(const std::string& text) { return nlohmann::ordered_json(text).dump(); }

/// Microseconds, exactly.
std::string stamp(Duration time) { return fmt::format("{}.{:03}", time.ns() / 1000, time.ns() % 1000); }

}  // namespace

TraceWriter::TraceWriter(const timing::Model& model, timing::Profile profile, std::ostream& out)
    : model_(model), set_(timing::make_task_set(model, profile)), out_(out), last_empty_(model.devices.size()) {
  find_buses();
  name_tracks();
}

void TraceWriter::close() {
  std::stable_sort(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) {
    return std::tie(a.at, a.is_inside, a.order) < std::tie(b.at, b.is_inside, b.order);
  });
  out_ << "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[";
  for (const Line& line : lines_) out_ << (&line == &lines_.front() ? "\n" : ",\n") << line.text;
  out_ << "\n]}\n";
}

/// Interrupts are called like their bus, or `bus.source` where it has several: the longest name that fits is the bus.
void TraceWriter::find_buses() {
  for (const timing::Stream& source : set_.sources) {
    const std::string& name = source.name;
    std::optional<timing::BusPlace> best;
    for (const timing::BusPlace b : model_.buses.ids()) {
      const std::string& bus = model_.buses[b].name;
      const bool fits = name == bus || name.rfind(bus + ".", 0) == 0;
      if (fits && (!best || bus.size() > model_.buses[*best].name.size())) best = b;
    }
    bus_of_.push_back(best.value_or(timing::BusPlace{}));
  }
}

std::size_t TraceWriter::bus_track(timing::BusPlace bus) { return bus.value() + 1; }

std::size_t TraceWriter::job_track(std::size_t bucket) const { return model_.buses.size() + 2 + bucket; }

void TraceWriter::name_tracks() {
  const auto name = [&](std::size_t track, const std::string& text) {
    add(Duration::zero(), false,
        fmt::format(R"({{"ph":"M","pid":1,"tid":{},"name":"thread_name","args":{{"name":{}}}}})", track, quoted(text)));
    add(Duration::zero(), false,
        fmt::format(R"({{"ph":"M","pid":1,"tid":{},"name":"thread_sort_index","args":{{"sort_index":{}}}}})", track,
                    track));
  };
  for (const timing::BusPlace b : model_.buses.ids()) name(bus_track(b), "bus " + model_.buses[b].name);
  name(model_.buses.size() + 1, "release");
  for (std::size_t w = 0; w < set_.buckets.size(); ++w) {
    name(job_track(w), "every " + timing::duration_text(set_.buckets[w].period));
  }
}

void TraceWriter::add(Duration time, bool is_inside, std::string text) {
  lines_.push_back({time, is_inside, lines_.size(), std::move(text)});
}

void TraceWriter::add_behind(std::size_t line, std::string text) {
  lines_.push_back({lines_[line].at, lines_[line].is_inside, line, std::move(text)});
}

void TraceWriter::slice(std::size_t track, const std::string& name, Duration begin, Duration end, bool is_inside) {
  add(begin, is_inside,
      fmt::format(R"({{"ph":"X","pid":1,"tid":{},"ts":{},"dur":{},"name":{}}})", track, stamp(begin),
                  stamp(end - begin), quoted(name)));
}

TraceWriter::Empty& TraceWriter::last_empty(Rank device, Stage stage) {
  LastEmpty& last = last_empty_[device];
  return stage == Stage::update ? last.update : last.handle;
}

std::size_t TraceWriter::bucket_track(Rank device) const { return job_track(set_.bucket_of[device]); }

void TraceWriter::job(std::size_t bucket, Duration begin, Duration end) {
  slice(job_track(bucket), "job", begin, end, false);
}

void TraceWriter::stage(Rank device, Stage stage, Duration begin, Duration end) {
  slice(bucket_track(device), model_.devices[device].name + (stage == Stage::update ? ".update" : ".handle"), begin,
        end, true);
  if (begin == end) last_empty(device, stage) = {end, lines_.size() - 1};
}

void TraceWriter::interrupt(std::size_t stream, Duration begin, Duration end) {
  const bool is_bus = stream < set_.sources.size();
  slice(is_bus ? bus_track(bus_of_[stream]) : model_.buses.size() + 1, is_bus ? set_.sources[stream].name : "release",
        begin, end, true);
}

/// The arrow leaves one nanosecond before the producer's end, inside its slice; where that is empty, at its end. It
/// ends at the slice of its track that begins next.
void TraceWriter::hand_over(Rank producer, Rank consumer, Stage stage, Duration published, Duration used) {
  const std::string name = quoted(stage == Stage::update ? "state" : "command");
  const Empty& empty = last_empty(producer, stage);
  const Duration left = empty.at == published || published == Duration::zero() ? published : published - nanoseconds(1);
  ++flow_;
  const std::string leaves = fmt::format(R"({{"ph":"s","pid":1,"tid":{},"ts":{},"id":{},"cat":"data","name":{}}})",
                                         bucket_track(producer), stamp(left), flow_, name);
  if (empty.at == published)
    add_behind(empty.line, leaves);
  else
    add(left, true, leaves);
  add(used, true,
      fmt::format(R"({{"ph":"f","pid":1,"tid":{},"ts":{},"id":{},"cat":"data","name":{}}})", bucket_track(consumer),
                  stamp(used), flow_, name));
}

}  // namespace finemote::gen
