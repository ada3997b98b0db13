#include "emulator/program/job.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "emulator/board.hpp"
#include "emulator/firmware_clock.hpp"
#include "emulator/outfit/outfit.hpp"
#include "emulator/program/audit.hpp"
#include "emulator/program/firmware.hpp"
#include "emulator/program/traffic_count.hpp"
#include "emulator/program/value_series.hpp"

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;
constexpr unsigned kNoBracket = ~0U;
constexpr std::uint64_t kStep = 50'000;                 // ns
constexpr std::uint64_t kLongestStart = 2'000'000'000;  // ns: clocks and parts are up long before

/// The runtime marks its own work from bring-up on; stages come with releases.
bool has_begun_a_stage(Board& board) {
  const auto& events = board.own_times().events();
  return std::any_of(events.begin(), events.end(), [](const BracketEvent& e) { return e.bracket < kFirstWork; });
}

/// How the start of a firmware went.
struct Start {
  std::optional<std::int64_t> zero;  ///< time since power-on at which the trace counts 0; none: no stage has begun
  Stop stop = Stop::time;            ///< why there is none
  Json fault_ns;                     ///< when a fault was first seen, not more than a step late; null: none
};

/// Runs until the first stage has begun.
Start wait_for_first_release(Board& board, const Image& image) {
  Start start;
  Json& fault_ns = start.fault_ns;
  while (board.now_ns() < kLongestStart) {
    start.stop = board.run_for(kStep);
    if (start.stop != Stop::time) return start;
    if (fault_ns.is_null() && !faults_of(board, image).empty()) fault_ns = board.now_ns();
    if (!has_begun_a_stage(board)) continue;
    auto& world = board.world();
    const std::int64_t cycles = world.system().read(kCycleCounter, 4, world.now(), 0);
    start.zero = static_cast<std::int64_t>(board.now_ns()) - cycles_to_ns(cycles);
    return start;
  }
  return start;
}

const char* text_of(Stop stop) {
  return stop == Stop::exit     ? "ended itself"
         : stop == Stop::lockup ? "locked up"
         : stop == Stop::dead   ? "sleeps with nothing left to wake it"
                                : "did not come to its first release";
}

Json reports_of(const Board& board) {
  Json all = Json::array();
  for (const Report& report : board.reports()) {
    all.push_back({{"misuse", name_of(report.misuse)},
                   {"text", report.text},
                   {"count", report.count},
                   {"first_ns", report.first_ns},
                   {"pc", report.pc}});
  }
  return all;
}

/// A part that has to be seen before the board counts as up: its first sample, or its first output.
struct Awaited {
  std::string part;
  PartEvent::Kind kind;

  [[nodiscard]] std::optional<std::uint64_t> first_ns(const Outfit& outfit) const {
    for (const PartEvent& event : outfit.events()) {
      if (event.part == part && event.kind == kind) return to_ns(event.at);
    }
    return std::nullopt;
  }
};

/// How long after the first release the board was up, and who never was.
struct BringUp {
  std::int64_t end_ns = 0;
  Json absent = Json::array();
  Json faults;             ///< counted so far
  Stop stop = Stop::time;  ///< why it ended early
};

/// Runs until every awaited part has been seen, no shorter and no longer than the job says.
BringUp bring_up(Board& board, const Image& image, const Outfit& outfit, const Json& job, std::int64_t zero) {
  std::vector<Awaited> awaited;
  for (const Json& entry : job.at("await"))
    awaited.push_back({entry.at("part"), entry.at("output") ? PartEvent::Kind::output : PartEvent::Kind::sample});
  const std::int64_t last = zero + job.at("bring_up_ns").get<std::int64_t>();
  const std::int64_t least = job.value("least_bring_up_ns", std::int64_t{0});
  const auto all_seen = [&] {
    return std::all_of(awaited.begin(), awaited.end(), [&](const Awaited& a) { return a.first_ns(outfit); });
  };
  const auto is_before = [&](std::int64_t time) { return static_cast<std::int64_t>(board.now_ns()) < time; };
  constexpr std::uint64_t kLook = 200'000;  // ns: what is counted in the last of them is the bring-up's
  BringUp result;
  while (result.stop == Stop::time && (is_before(zero + least) || (!all_seen() && is_before(last))))
    result.stop = board.run_for(kLook);
  result.end_ns = least;
  result.faults = faults_of(board, image);
  for (const Awaited& a : awaited) {
    const auto first = a.first_ns(outfit);
    const std::int64_t end = first ? std::min(static_cast<std::int64_t>(*first), last) : last;
    result.end_ns = std::max(result.end_ns, end - zero);
    if (!first) result.absent.push_back(a.part);
  }
  return result;
}

/// `[ns since the first release, stage, begin]` of those before `duration_ns`, in the order of time.
Json stages_of(Board& board, std::int64_t zero, std::int64_t duration_ns) {
  Json all = Json::array();
  for (const BracketEvent& event : board.own_times().events()) {
    const std::int64_t at = static_cast<std::int64_t>(to_ns(event.at)) - zero;
    if (event.bracket < kFirstWork && at < duration_ns) all.push_back(Json::array({at, event.bracket, !event.is_end}));
  }
  return all;
}

/// Picoseconds since `zero`, which are nanoseconds.
std::int64_t since_ps(Time at, std::int64_t zero) { return static_cast<std::int64_t>(to_ps(at)) - zero * 1'000; }

/// Outputs have their value, and the stage of the handle whose run `n` they carry; null where none is known.
Json parts_of(const Outfit& outfit, std::int64_t zero) {
  Json all = Json::array();
  for (const PartEvent& event : outfit.events()) {
    all.push_back({{"part", event.part},
                   {"output", event.kind == PartEvent::Kind::output},
                   {"channel", event.channel},
                   {"from_ps", since_ps(event.from, zero)},
                   {"at_ps", since_ps(event.at, zero)},
                   {"stage", event.stage ? Json(*event.stage) : Json()},
                   {"n", event.n},
                   {"value", event.value}});
  }
  return all;
}

/// `[ps since the first release, stage of an update that ended, part, channel, number of the sample, when the data were
/// taken as the state says or null]`.
Json uses_of(const Outfit& outfit, std::int64_t zero) {
  Json all = Json::array();
  for (const SampleUse& use : outfit.uses()) {
    const Json claimed = use.claimed ? Json(*use.claimed * 1'000) : Json();  // the firmware counts from the release on
    all.push_back(Json::array({since_ps(use.at, zero), use.stage, use.part, use.channel, use.n, claimed}));
  }
  return all;
}

/// `[stage of a handle, number of its run]` of those that gave a driver something to send.
Json handed_over_in(Board& board) {
  Json all = Json::array();
  const Provenance& provenance = board.world().provenance();
  for (const Tag tag : provenance.handed_over())
    all.push_back(Json::array({provenance.origin(tag).source, provenance.origin(tag).n}));
  return all;
}

Json expectations_of(const Outfit& outfit) {
  Json all = Json::array();
  for (const Expectation& e : outfit.expectations()) {
    const bool seen = e.has_seen();
    all.push_back({{"part", e.part},
                   {"value", e.value},
                   {"from_ns", e.from_ns},
                   {"to_ns", e.to_ns},
                   {"min", e.min},
                   {"max", e.max},
                   {"lowest", seen ? Json(e.lowest) : Json()},
                   {"highest", seen ? Json(e.highest) : Json()},
                   {"finite", e.not_finite == 0},
                   {"ok", e.holds()}});
  }
  return all;
}

Json buses_of(Board& board, const Json& ports) {
  Json all = Json::array();
  for (const Json& port : ports) {
    const BusStatistics bus = board.bus(port.get<std::string>());
    const std::uint64_t busier = to_ns(std::max(bus.busy, bus.received));
    const double busy = static_cast<double>(busier) / static_cast<double>(board.now_ns());
    all.push_back({{"transfers", bus.transfers}, {"errors", bus.errors}, {"busy", std::min(busy, 1.0)}});
  }
  return all;
}

/// `[number, longest in ps, runs]` of numbers from `first` to below `end`, counted from `first`.
Json own_times_of(const std::map<unsigned, OwnTime>& times, unsigned first, unsigned end) {
  Json all = Json::array();
  for (auto it = times.lower_bound(first); it != times.end() && it->first < end; ++it) {
    all.push_back(Json::array({it->first - first, to_ps(it->second.longest), it->second.runs}));
  }
  return all;
}

/// `[place, borders, whether interrupts add iterations]` of each loop of a job.
std::vector<WatchedLoop> loops_of(const Json& job) {
  std::vector<WatchedLoop> loops;
  for (const Json& loop : job.value("loops", Json::array()))
    loops.push_back({loop.at(0), loop.at(1).get<std::vector<std::uint32_t>>(), loop.at(2)});
  return loops;
}

/// How often the place of each loop of a job was passed at most; 0: the loop was never entered.
Json loop_counts_of(Board& board, const Json& job) {
  const auto& most = board.loop_counts().most();
  const std::size_t count = job.value("loops", Json::array()).size();
  Json all = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = most.find(i);
    all.push_back(found == most.end() ? 0 : found->second);
  }
  return all;
}

BoardOptions options_of(const Json& job, bool keeps_log) {
  BoardOptions options;
  if (job.value("flash", "hit") == "miss") options.flash = FlashModel::miss_always;
  options.keeps_log = keeps_log || job.contains("audit");
  options.tags = job.value("tags", true);
  if (job.contains("silicon")) {
    const Json& silicon = job.at("silicon");
    options.silicon =
        Silicon::named(silicon.at("names").get<std::vector<std::string>>(), silicon.at("seed").get<std::uint64_t>());
  }
  return options;
}

/// A board with the job's image and parts, before power-on.
struct Bench {
  explicit Bench(const Json& job, bool keeps_log = false)
      : board(read_wiring(job.at("board")), options_of(job, keeps_log)),
        outfit(board),
        image(job.contains("image") ? load_image(job.at("image").get<std::string>()) : Image()) {
    if (job.contains("image")) board.load(image);
    board.watch_loops(loops_of(job));
    outfit.add(job.at("parts"));
  }

  Board board;
  Outfit outfit;
  const Image image;
};

/// When the firmware comes to its first release, since power-on; 0 where it does not. Nothing of a scenario happens
/// before, so a start without its events shows it.
std::int64_t first_release_ns(const Json& job) {
  if (!job.contains("image")) return 0;
  Bench start(job);
  Json parts = job.at("events");
  parts.erase("events");
  parts.erase("expect");
  start.outfit.add(parts);
  return wait_for_first_release(start.board, start.image).zero.value_or(0);
}

/// Null where there is no time.
Json since_zero(std::optional<std::int64_t> ns, std::int64_t zero) { return ns ? Json(*ns - zero) : Json(); }

Json violated_in(const Outfit& outfit) {
  Json list = Json::array();
  for (const Violation& violation : outfit.violated())
    list.push_back({{"assumption", violation.assumption}, {"part", violation.part}, {"port", violation.port}});
  return list;
}

/// What was counted up to now.
Json counted_in(Board& board, const Image& image, const TrafficCount& traffic) {
  return {{"fault_counts", faults_of(board, image)},
          {"monitor", monitor_of(board, image)},
          {"traffic", traffic.document()}};
}

/// Overruns that the firmware counted before a scenario reset it, by bucket.
class ForgottenOverruns {
 public:
  ForgottenOverruns(Board& board, const Image& image, Outfit& outfit) : board_(board), image_(image) {
    outfit.on_reset = [this] { before_ = in_all(); };
  }

  [[nodiscard]] std::vector<std::uint32_t> in_all() const {
    std::vector<std::uint32_t> all = overruns_of(board_, image_);
    for (std::size_t i = 0; i < all.size() && i < before_.size(); ++i) all[i] += before_[i];
    return all;
  }

 private:
  Board& board_;
  const Image& image_;
  std::vector<std::uint32_t> before_;
};

/// Lets the board run up to `end`. `undisturbed` becomes what was counted before the first event that violates an
/// assumption; it stays null where there is none, or where it came before `ready`. Both times in ns since power-on.
Stop run_to_end(Bench& bench, std::int64_t ready, std::int64_t end, const TrafficCount& traffic, Json& undisturbed) {
  Board& board = bench.board;
  Stop stop = Stop::time;
  const auto run_to = [&](std::int64_t time) {
    const std::int64_t rest = time - static_cast<std::int64_t>(board.now_ns());
    if (rest > 0 && stop == Stop::time) stop = board.run_for(static_cast<std::uint64_t>(rest));
  };
  const std::int64_t disturbed = bench.outfit.violated_from_ns().value_or(end);
  if (disturbed > ready && disturbed < end) {
    run_to(disturbed);
    undisturbed = counted_in(board, bench.image, traffic);
  }
  run_to(end);
  return stop;
}

Json run(Bench& bench, const Json& job) {
  auto& [board, outfit, image] = bench;
  std::optional<Audit> audit;
  if (job.contains("audit")) {
    using Numbers = std::vector<std::uint32_t>;
    audit.emplace(board, image, job.at("audit").get<Numbers>(), job.value("works", Numbers()));
  }
  const ForgottenOverruns overruns(board, image, outfit);
  const Start start = wait_for_first_release(board, image);
  if (!start.zero) {
    return {{"stop", text_of(start.stop)},
            {"reports", reports_of(board)},
            {"fault_counts", faults_of(board, image)},
            {"fault_ns", start.fault_ns}};
  }
  const std::int64_t zero = *start.zero;
  const BringUp ready = bring_up(board, image, outfit, job, zero);
  const std::int64_t judged_to =
      std::max(ready.end_ns + job.at("duration_ns").get<std::int64_t>(), job.at("last_event_ns").get<std::int64_t>());
  const std::int64_t end = zero + judged_to + 1;  // what is due at the last moment happens
  ValueSeries series(board, outfit, static_cast<std::int64_t>(board.now_ns()), end);
  const TrafficCount traffic(board, job.at("ports").get<std::vector<std::string>>());
  Json undisturbed;
  const Stop stop =
      ready.stop != Stop::time ? ready.stop : run_to_end(bench, zero + ready.end_ns, end, traffic, undisturbed);
  return {{"stop", stop == Stop::time ? Json() : Json(text_of(stop))},
          {"reports", reports_of(board)},
          {"resets", board.resets() - outfit.scripted_resets()},
          {"scripted_resets", outfit.scripted_resets()},
          {"overruns", overruns.in_all()},
          {"violated", violated_in(outfit)},
          {"violated_from_ns", since_zero(outfit.violated_from_ns(), zero)},
          {"undisturbed", undisturbed},
          {"fault_counts", faults_of(board, image)},
          {"first_release_ns", zero},
          {"ready_ns", ready.end_ns},
          {"faults_at_ready", ready.faults},
          {"absent", ready.absent},
          {"stages", stages_of(board, zero, judged_to)},
          {"parts", parts_of(outfit, zero)},
          {"uses", uses_of(outfit, zero)},
          {"handed_over", handed_over_in(board)},
          {"expectations", expectations_of(outfit)},
          {"series", series.document(zero)},
          {"buses", buses_of(board, job.at("ports"))},
          {"traffic", traffic.document()},
          {"own_stages", own_times_of(board.own_times().brackets(), 0, kFirstWork)},
          {"own_works", own_times_of(board.own_times().brackets(), kFirstWork, kNoBracket)},
          {"own_exceptions", own_times_of(board.own_times().exceptions(), 0, kNoBracket)},
          {"loop_passes", loop_counts_of(board, job)},
          {"monitor", monitor_of(board, image)},
          {"audit", audit ? audit->events(zero) : Json()}};
}

}  // namespace

Json run_job(const Json& job, const std::function<void(Board&)>& watch) {
  Bench bench(job, static_cast<bool>(watch));
  if (watch) watch(bench.board);
  try {
    if (job.contains("events")) bench.outfit.add(job.at("events"), first_release_ns(job));
  } catch (const std::invalid_argument& error) {
    return {{"error", error.what()}};
  }
  if (!job.contains("image")) return Json::object();
  return run(bench, job);
}

}  // namespace finemote::emulator
