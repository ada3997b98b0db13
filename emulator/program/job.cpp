#include "emulator/program/job.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "emulator/board.hpp"
#include "emulator/outfit.hpp"

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::uint32_t kCycleCounter = 0xE0001004;         // DWT_CYCCNT, PM0214 4.10
constexpr unsigned kFirstWork = 0x20000, kNoBracket = ~0U;  // runtime/include/finemote/mark.hpp
constexpr std::uint64_t kStep = 1'000'000;                  // ns
constexpr std::uint64_t kLongestStart = 2'000'000'000;      // ns: clocks and parts are up long before

/// Overruns the firmware counted since its last start, by bucket, as runtime/src/release.cpp keeps them.
Json overruns_of(Board& board, const Image& image) {
  constexpr const char* kCounts = "_ZN8finemote6detail12_GLOBAL__N_114overrun_countsE";
  Json all = Json::array();
  const auto counts = image.symbol(kCounts);
  for (std::uint32_t offset = 0; counts && offset + 4 <= counts->size; offset += 4)
    all.push_back(board.word(kCounts, offset));
  return all;
}

/// The faults the firmware counted since its last start, as runtime/src/faults.cpp keeps them: `[module, number,
/// count]`.
Json faults_of(Board& board, const Image& image) {
  constexpr const char* kRecords = "_ZN8finemote12_GLOBAL__N_17recordsE";
  Json all = Json::array();
  const auto records = image.symbol(kRecords);
  for (std::uint32_t offset = 0; records && offset + 4 <= records->size; offset += 4) {
    const std::uint32_t word = board.word(kRecords, offset);
    if (word != 0) all.push_back(Json::array({word >> 24, word >> 16 & 0xFF, word & 0xFFFF}));
  }
  return all;
}

/// The runtime marks its own work from bring-up on; stages come with releases.
bool has_run_a_stage(Board& board) {
  const auto& brackets = board.own_times().brackets();
  return !brackets.empty() && brackets.begin()->first < kFirstWork;
}

/// Runs until the first stage ended; returns the time since power-on at which the trace counts 0. `fault_ns` is
/// when a fault was first seen, not more than a step late; null: none.
std::optional<std::int64_t> wait_for_first_release(Board& board, const Image& image, Json& fault_ns) {
  while (board.now_ns() < kLongestStart) {
    if (board.run_for(kStep) != Stop::time) return std::nullopt;
    if (fault_ns.is_null() && !faults_of(board, image).empty()) fault_ns = board.now_ns();
    if (!has_run_a_stage(board)) continue;
    auto& world = board.world();
    const std::int64_t cycles = world.system().read(kCycleCounter, 4, world.now(), 0);
    return static_cast<std::int64_t>(board.now_ns()) - cycles * 125 / 21;  // 168 MHz: 21 cycles are 125 ns
  }
  return std::nullopt;
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

/// `[ns since the first release, stage, begin]` of those before `duration_ns`, in the order of time.
Json stages_of(Board& board, std::int64_t zero, std::int64_t duration_ns) {
  Json all = Json::array();
  for (const BracketEvent& event : board.own_times().events()) {
    const std::int64_t at = static_cast<std::int64_t>(to_ns(event.at)) - zero;
    if (event.bracket < kFirstWork && at < duration_ns) all.push_back(Json::array({at, event.bracket, !event.is_end}));
  }
  return all;
}

Json parts_of(const Outfit& outfit, std::int64_t zero) {
  Json all = Json::array();
  for (const PartEvent& event : outfit.events()) {
    all.push_back({{"part", event.part},
                   {"output", event.kind == PartEvent::Kind::output},
                   {"channel", event.channel},
                   {"from_ns", static_cast<std::int64_t>(event.from_ns) - zero},
                   {"at_ns", static_cast<std::int64_t>(event.at_ns) - zero}});
  }
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
    const double busy = static_cast<double>(to_ns(bus.busy)) / static_cast<double>(board.now_ns());
    all.push_back({{"transfers", bus.transfers}, {"errors", bus.errors}, {"busy", std::min(busy, 1.0)}});
  }
  return all;
}

/// The monitor's records, as finemote/monitor.hpp lays them out; none in an image without them.
Json monitor_of(Board& board, const Image& image) {
  constexpr const char* kRecords = "finemote_monitor_records";
  constexpr std::uint32_t kBytes = 24;
  Json all = Json::array();
  const auto records = image.symbol(kRecords);
  for (std::uint32_t i = 0; records && (i + 1) * kBytes <= records->size; ++i) {
    const auto word = [&](std::uint32_t offset) { return std::int64_t{board.word(kRecords, i * kBytes + offset)}; };
    const auto time = [&](std::uint32_t offset) { return word(offset) | word(offset + 4) << 32; };
    all.push_back(Json::array({time(0), time(8), word(16), word(20)}));
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

BoardOptions options_of(const Json& job) {
  BoardOptions options;
  if (job.value("flash", "hit") == "miss") options.flash = FlashModel::miss_always;
  return options;
}

/// A board with the job's image and parts, before power-on.
struct Bench {
  explicit Bench(const Json& job)
      : board(read_wiring(job.at("board")), options_of(job)),
        outfit(board),
        image(job.contains("image") ? load_image(job.at("image").get<std::string>()) : Image()) {
    if (job.contains("image")) board.load(image);
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
  Json fault_ns;
  return wait_for_first_release(start.board, start.image, fault_ns).value_or(0);
}

Json run(Bench& bench, const Json& job) {
  auto& [board, outfit, image] = bench;
  const auto duration_ns = job.at("duration_ns").get<std::int64_t>();
  Json fault_ns;
  const auto zero = wait_for_first_release(board, image, fault_ns);
  Stop stop = Stop::time;
  if (zero) {
    const std::int64_t end =
        *zero + job.at("run_ns").get<std::int64_t>() + 1;  // what is due at the last moment happens
    const std::int64_t rest = end - static_cast<std::int64_t>(board.now_ns());
    if (rest > 0) stop = board.run_for(static_cast<std::uint64_t>(rest));
  }
  if (!zero || stop != Stop::time) {
    return {{"stop", text_of(stop)},
            {"reports", reports_of(board)},
            {"fault_counts", faults_of(board, image)},
            {"fault_ns", fault_ns}};
  }
  return {{"stop", nullptr},
          {"reports", reports_of(board)},
          {"resets", board.resets() - outfit.scripted_resets()},
          {"overruns", overruns_of(board, image)},
          {"faulty", outfit.injects_faults()},
          {"fault_counts", faults_of(board, image)},
          {"stages", stages_of(board, *zero, duration_ns)},
          {"parts", parts_of(outfit, *zero)},
          {"expectations", expectations_of(outfit)},
          {"buses", buses_of(board, job.at("ports"))},
          {"own_stages", own_times_of(board.own_times().brackets(), 0, kFirstWork)},
          {"own_works", own_times_of(board.own_times().brackets(), kFirstWork, kNoBracket)},
          {"own_exceptions", own_times_of(board.own_times().exceptions(), 0, kNoBracket)},
          {"monitor", monitor_of(board, image)}};
}

}  // namespace

Json run_job(const Json& job) {
  Bench bench(job);
  try {
    if (job.contains("events")) bench.outfit.add(job.at("events"), first_release_ns(job));
  } catch (const std::invalid_argument& error) {
    return {{"error", error.what()}};
  }
  if (!job.contains("image")) return Json::object();
  return run(bench, job);
}

}  // namespace finemote::emulator
