#include "generator/run/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "generator/forest/stage.hpp"
#include "generator/image/exception.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

Json stages_of(const Robot& robot, const Forest& forest, const Schedule& schedule) {
  Json list = Json::array();
  for (const DeviceId device : forest.order) {
    for (const char* stage : {"update", "handle"}) {
      list.push_back({{"device", robot.devices[device].name.text},
                      {"stage", stage},
                      {"exception", exception_of(schedule.buckets[schedule.bucket_of[device]].line)},
                      {"period_ns", robot.devices[device].period.ns()}});
    }
  }
  return list;
}

Json exception_table(const Robot& robot, const Schedule& schedule) {
  Json list = Json::object();
  list[std::to_string(kSysTickException)] = {{"kind", "release"}};
  for (const Bucket& bucket : schedule.buckets)
    list[std::to_string(exception_of(bucket.line))] = {{"kind", "bucket"}, {"period_ns", bucket.period.ns()}};
  for (const Bus& bus : robot.buses) {
    const Port* port = robot.board->port(bus.port);
    if (port == nullptr) continue;
    for (const InterruptLine& line : port->interrupts) {
      list[std::to_string(exception_of(line.number))] = {
          {"kind", "bus"}, {"bus", bus.name.text}, {"source", line.name}};
    }
  }
  return list;
}

/// Everything of one run, on the true time.
class Audit {
 public:
  Audit(const Robot& robot, const Forest& forest, const RunRecord& record)
      : robot_(robot), forest_(forest), record_(record), sent_(record.handed_over.begin(), record.handed_over.end()) {
    add_log();
    add_samples();
    add_uses();
    add_outputs();
    add(record.ready.ns() * kPsPerNs, "\"what\":\"ready\"");
    std::stable_sort(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) { return a.at < b.at; });
  }

  [[nodiscard]] std::string text() const {
    std::string text;
    for (const Line& line : lines_) text += line.text + "\n";
    return text;
  }

 private:
  struct Line {
    std::int64_t at;
    std::string text;
  };

  /// The board's clock counts the record's times; rounded down.
  [[nodiscard]] std::int64_t true_ps(std::int64_t ps) const {
    if (record_.clock_ppm == 0) return ps;
    return static_cast<std::int64_t>(std::floor(static_cast<long double>(ps) / (1 + record_.clock_ppm * 1e-6L)));
  }

  /// @param members  of the line's object after its time, as JSON: there are tens of thousands of lines
  void add(std::int64_t ps, const std::string& members) {
    const std::int64_t at = true_ps(ps);
    lines_.push_back({at, fmt::format("{{\"t\":{},{}}}", at, members)});
  }

  void add_log() {
    for (const LoggedEvent& event : record_.log) {
      if (event.what == "begin" || event.what == "end") {
        add(event.ps, fmt::format("\"what\":\"{}\",\"stage\":{}", event.what, event.number));
      } else if (event.what != "mask" && event.what != "unmask" && event.what != "reset") {
        add(event.ps, fmt::format("\"what\":\"{}\",\"exception\":{}", event.what, event.number));
      } else {
        add(event.ps, fmt::format("\"what\":\"{}\"", event.what));
      }
    }
  }

  void add_samples() {
    for (const PartRecord& event : record_.parts) {
      if (event.is_output) continue;
      add(event.at_ps, fmt::format("\"what\":\"sample\",\"part\":{},\"channel\":{},\"n\":{},\"from\":{}",
                                   quoted(event.part), event.channel, event.n, true_ps(event.from_ps)));
    }
  }

  [[nodiscard]] const std::string& device_of(std::uint32_t stage) const {
    return robot_.devices[forest_.order[Stage::of_number(stage).rank]].name.text;
  }

  /// Of its own part: what others send is in the commands of a device.
  void add_uses() {
    for (const SampleUse& use : record_.uses) {
      const std::string& device = device_of(use.stage);
      if (use.part != device) continue;
      const std::string claimed = use.claimed_ps ? std::to_string(true_ps(*use.claimed_ps)) : "null";
      add(use.at_ps, fmt::format("\"what\":\"used\",\"device\":{},\"channel\":{},\"n\":{},\"claimed\":{}",
                                 quoted(device), use.channel, use.n, claimed));
    }
  }

  void add_outputs() {
    std::map<std::pair<std::string, std::uint32_t>, JobRun> next;  // of an output of a part
    for (const PartRecord& event : record_.parts) {
      if (!event.is_output) continue;
      if (event.stage) {
        JobRun& expected = next.try_emplace({event.part, event.channel}, JobRun{*event.stage, 0}).first->second;
        add_superseded(expected, event.is_repeated ? event.n + 1 : event.n, event.at_ps);
        expected.n = std::max(expected.n, event.n + 1);
      }
      const bool carries = event.stage && !event.is_repeated;
      const std::string carried = carries ? job_of({*event.stage, event.n}) : R"("device":null,"job":null)";
      add(event.at_ps,
          fmt::format("\"what\":\"output\",\"part\":{},\"channel\":{},{}", quoted(event.part), event.channel, carried));
    }
    for (const auto& [output, awaited] : next) add_awaited(awaited);
  }

  /// Commands before `end` never came out by themselves: the output shows what they or later ones ask for.
  void add_superseded(JobRun next, std::uint32_t end, std::int64_t ps) {
    for (; next.n < end; ++next.n) {
      const bool sent = sent_.count(next) != 0;
      add(ps, fmt::format("\"what\":\"superseded\",{},\"sent\":{}", job_of(next), sent));
    }
  }

  /// What a driver was given and had not come out when the last run of its handle ended.
  void add_awaited(JobRun next) {
    const auto is_end = [&](const LoggedEvent& event) { return event.what == "end" && event.number == next.stage; };
    const auto last = std::find_if(record_.log.rbegin(), record_.log.rend(), is_end);
    if (last == record_.log.rend()) return;
    for (auto run = sent_.lower_bound(next); run != sent_.end() && run->stage == next.stage; ++run)
      add(last->ps, fmt::format("\"what\":\"superseded\",{},\"sent\":true", job_of(*run)));
  }

  [[nodiscard]] std::string job_of(const JobRun& job) const {
    return fmt::format("\"device\":{},\"job\":{}", quoted(device_of(job.stage)), job.n);
  }

  static std::string quoted(const std::string& name) { return Json(name).dump(); }

  const Robot& robot_;
  const Forest& forest_;
  const RunRecord& record_;
  const std::set<JobRun> sent_;
  std::vector<Line> lines_;
};

}  // namespace

std::string audit_lines(const Robot& robot, const Forest& forest, const Schedule& schedule, const AuditedRun& run,
                        const RunRecord& record) {
  const double nominal = static_cast<double>(robot.board->cpu_hz);
  const Json first{{"what", "robot"},
                   {"image", run.image_sha256},
                   {"seed", run.seed},
                   {"phase", run.phase},
                   {"clock_hz", nominal * (1 + record.clock_ppm * 1e-6)},
                   {"nominal_hz", nominal},
                   {"stages", stages_of(robot, forest, schedule)},
                   {"exceptions", exception_table(robot, schedule)}};
  return first.dump() + "\n" + Audit(robot, forest, record).text();
}

}  // namespace finemote::gen
