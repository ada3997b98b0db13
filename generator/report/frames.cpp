#include "generator/report/frames.hpp"

#include <algorithm>
#include <queue>

namespace finemote::gen::report {
namespace {

using timing::Transfer;

/// A frame that a line is asked for.
struct Request {
  Duration at;
  Duration period;  ///< the shorter, the more urgent
  Duration wire;
  Timeline::Frame frame;  ///< but for its bus and its time
};

/// One line of a bus: frames on it follow one another.
struct Line {
  timing::BusPlace bus;
  bool is_received = false;
  std::vector<Request> requests = {};
};

class Lines {
 public:
  explicit Lines(const timing::Model& model) {
    for (const timing::BusPlace bus : model.buses.ids()) {
      lines_.push_back({bus, false});
      lines_.push_back({bus, true});
    }
  }
  void ask(timing::BusPlace bus, bool is_received, Request request) {
    lines_[2 * bus.value() + (is_received ? 1 : 0)].requests.push_back(std::move(request));
  }
  std::vector<Line>& all() { return lines_; }

 private:
  std::vector<Line> lines_;
};

bool is_later(const Request& a, const Request& b) { return a.period != b.period ? a.period > b.period : a.at > b.at; }

/// Puts the requests of one line one after the other.
void send(Line& line, std::vector<Timeline::Frame>& frames) {
  std::stable_sort(line.requests.begin(), line.requests.end(),
                   [](const Request& a, const Request& b) { return a.at < b.at; });
  std::priority_queue<Request, std::vector<Request>, decltype(&is_later)> waiting(is_later);
  Duration now;
  std::size_t next = 0;
  while (next < line.requests.size() || !waiting.empty()) {
    if (waiting.empty()) now = std::max(now, line.requests[next].at);
    while (next < line.requests.size() && line.requests[next].at <= now) waiting.push(line.requests[next++]);
    const Request sent = waiting.top();
    waiting.pop();
    Timeline::Frame& frame = frames.emplace_back(sent.frame);
    frame.bus = line.bus;
    frame.is_received = line.is_received;
    frame.begin = now;
    frame.end = now += sent.wire;
  }
}

Timeline::Frame frame_of(Rank device, bool is_asked_for) {
  Timeline::Frame frame;
  frame.device = device;
  frame.is_asked_for = is_asked_for;
  return frame;
}

Timeline::Frame frame_of_flush(std::size_t flush) {
  Timeline::Frame frame;
  frame.flush = flush;
  return frame;
}

void ask_of_device(const timing::Model& model, Rank rank, Transfer::After after, Duration at, Lines& lines) {
  const timing::Device& device = model.devices[rank];
  for (const Transfer& t : device.transfers) {
    if (t.after == after && t.wire > Duration::zero())
      lines.ask(t.bus, t.receive, {at, device.period, t.wire, frame_of(rank, true)});
  }
}

void ask_by_itself(const timing::Model& model, Rank rank, Duration length, Lines& lines) {
  const timing::Device& device = model.devices[rank];
  constexpr std::int64_t kMost = 2000;  // more could not be told apart
  for (const Transfer& t : device.transfers) {
    if (t.after != Transfer::After::autonomous || t.wire <= Duration::zero()) continue;
    const Duration every = std::max(t.min_interval > Duration::zero() ? t.min_interval : device.period, t.wire);
    std::int64_t count = 0;
    for (Duration at; at < length && count < kMost; at += every, ++count)
      lines.ask(t.bus, t.receive, {at, every, t.wire, frame_of(rank, false)});
  }
}

void ask_of_jobs(const timing::Model& model, const Timeline& timeline, Lines& lines) {
  for (const Timeline::Job& job : timeline.jobs) {
    const Duration period = timeline.periods[job.bucket];
    for (std::size_t i = 0; i < model.flushes.size(); ++i) {
      const timing::Flush& flush = model.flushes[i];
      if (flush.period == period && flush.bus && flush.wire > Duration::zero())
        lines.ask(*flush.bus, false, {job.end, period, flush.wire, frame_of_flush(i)});
    }
    for (const Rank d : model.devices.ids()) {
      if (model.devices[d].period == period) ask_of_device(model, d, Transfer::After::bucket, job.end, lines);
    }
  }
}

}  // namespace

std::vector<Timeline::Frame> frames_of(const timing::Model& model, const Timeline& timeline) {
  Lines lines(model);
  for (const Timeline::Stage& stage : timeline.stages) {
    const auto after = stage.is_handle ? Transfer::After::handle : Transfer::After::update;
    ask_of_device(model, stage.device, after, stage.end, lines);
  }
  ask_of_jobs(model, timeline, lines);
  for (const Rank d : model.devices.ids()) ask_by_itself(model, d, timeline.length, lines);
  std::vector<Timeline::Frame> frames;
  for (Line& line : lines.all()) send(line, frames);
  return frames;
}

}  // namespace finemote::gen::report
