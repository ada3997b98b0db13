#include "generator/run/emulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "emulator/outfit.hpp"
#include "generator/run/parts.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::uint32_t kCycleCounter = 0xE0001004;     // DWT_CYCCNT, PM0214 4.10
constexpr std::uint64_t kStep = 1'000'000;              // ns
constexpr std::uint64_t kLongestStart = 2'000'000'000;  // ns: clocks and parts are up long before

bool add_scenario(const std::string& path, emulator::Outfit& outfit, Diagnostics& diagnostics) {
  if (path.empty()) return true;
  std::ifstream file(path);
  try {
    if (!file) throw std::invalid_argument("cannot be read");
    outfit.add(Json::parse(file));
    return true;
  } catch (const std::exception& error) {
    diagnostics.error(code::bad_scenario, {}, fmt::format("scenario '{}': {}", path, error.what()));
    return false;
  }
}

/// Runs until the first stage was traced; returns the time since power-on at which the trace counts 0.
std::optional<std::int64_t> wait_for_first_release(emulator::Board& board) {
  while (board.now_ns() < kLongestStart) {
    if (board.run_for(kStep) != emulator::Stop::time) return std::nullopt;
    if (board.stages().empty()) continue;
    auto& world = board.world();
    const std::int64_t cycles = world.system().read(kCycleCounter, 4, world.now(), 0);
    return static_cast<std::int64_t>(board.now_ns()) - cycles * 125 / 21;  // 168 MHz: 21 cycles are 125 ns
  }
  return std::nullopt;
}

void report_stop(emulator::Stop stop, const emulator::Board& board, Diagnostics& diagnostics) {
  const char* how = stop == emulator::Stop::exit     ? "ended itself"
                    : stop == emulator::Stop::lockup ? "locked up"
                    : stop == emulator::Stop::dead   ? "sleeps with nothing left to wake it"
                                                     : "did not come to its first release";
  auto& finding = diagnostics.error(code::firmware_stopped, {}, fmt::format("the firmware {}", how));
  for (const emulator::Report& report : board.reports()) {
    finding.note(fmt::format("{} at {} ns: {}", emulator::name_of(report.misuse), report.first_ns, report.text));
  }
}

void warn_of_misuse(const emulator::Board& board, Diagnostics& diagnostics) {
  for (const emulator::Report& report : board.reports()) {
    diagnostics.warning(code::hardware_misuse, {},
                        fmt::format("{}: {} ({} times, first at {} ns, pc {:#010x})", emulator::name_of(report.misuse),
                                    report.text, report.count, report.first_ns, report.pc));
  }
}

/// The monitor's records, as finemote/monitor.hpp lays them out; none in an image without them.
std::vector<MonitorEntry> read_monitor(emulator::Board& board, const emulator::Image& image, const Forest& forest) {
  constexpr const char* kRecords = "finemote_monitor_records";
  constexpr std::uint32_t kBytes = 24;
  std::vector<MonitorEntry> entries;
  const auto records = image.symbol(kRecords);
  for (std::uint32_t i = 0; records && (i + 1) * kBytes <= records->size && i < forest.order.size(); ++i) {
    const auto word = [&](std::uint32_t offset) { return std::int64_t{board.word(kRecords, i * kBytes + offset)}; };
    const auto time = [&](std::uint32_t offset) { return word(offset) | word(offset + 4) << 32; };
    entries.push_back({forest.order[i], time(0), time(8), static_cast<std::uint64_t>(word(16)),
                       static_cast<std::uint64_t>(word(20))});
  }
  return entries;
}

RunRecord take_record(emulator::Board& board, const emulator::Outfit& outfit, const Robot& robot, const Forest& forest,
                      std::int64_t zero, std::int64_t duration_ns) {
  RunRecord record;
  for (const emulator::StageEvent& event : board.stages()) {
    if (event.t_ns >= duration_ns || event.stage / 2 >= forest.order.size()) continue;
    record.events.push_back({event.t_ns, forest.order[event.stage / 2], event.stage % 2 == 1, !event.begin});
  }
  for (const emulator::PartEvent& event : outfit.events()) {
    const bool is_output = event.kind == emulator::PartEvent::Kind::output;
    record.parts.push_back({event.part, is_output, event.channel, static_cast<std::int64_t>(event.from_ns) - zero,
                            static_cast<std::int64_t>(event.at_ns) - zero});
  }
  for (const emulator::Expectation& e : outfit.expectations()) {
    ExpectationRecord seen{
        e.part, e.value,  static_cast<std::int64_t>(e.from_ns), static_cast<std::int64_t>(e.to_ns), e.min, e.max, {},
        {},     e.holds()};
    if (e.looks > 0) seen.lowest = e.lowest, seen.highest = e.highest;
    record.expectations.push_back(seen);
  }
  for (std::size_t i = 0; i < robot.buses.size(); ++i) {
    if (robot.buses[i].port.empty()) continue;
    const emulator::BusStatistics bus = board.bus(robot.buses[i].port);
    const double busy = static_cast<double>(emulator::to_ns(bus.busy)) / static_cast<double>(board.now_ns());
    record.buses.push_back({i, bus.transfers, bus.errors, std::min(busy, 1.0)});
  }
  return record;
}

std::optional<RunRecord> run(emulator::Board& board, const emulator::Outfit& outfit, const Robot& robot,
                             const Forest& forest, const emulator::Image& image,
                             std::int64_t duration_ns, Diagnostics& diagnostics) {
  const auto zero = wait_for_first_release(board);
  if (!zero) {
    report_stop(emulator::Stop::time, board, diagnostics);
    return std::nullopt;
  }
  const std::int64_t rest = *zero + duration_ns - static_cast<std::int64_t>(board.now_ns());
  const emulator::Stop stop = rest > 0 ? board.run_for(static_cast<std::uint64_t>(rest)) : emulator::Stop::time;
  if (stop != emulator::Stop::time) {
    report_stop(stop, board, diagnostics);
    return std::nullopt;
  }
  warn_of_misuse(board, diagnostics);
  RunRecord record = take_record(board, outfit, robot, forest, *zero, duration_ns);
  record.resets = board.resets() - outfit.scripted_resets();
  record.faulty = outfit.injects_faults();
  record.monitor = read_monitor(board, image, forest);
  return record;
}

}  // namespace

std::optional<RunRecord> emulate(const std::string& image, const Robot& robot, const Forest& forest,
                                 std::int64_t duration_ns, const EmulationOptions& options, Diagnostics& diagnostics) {
  emulator::BoardOptions board_options;
  if (options.flash_misses) board_options.flash = emulator::FlashModel::miss_always;
  emulator::Board board(board_options);
  emulator::Outfit outfit(board);
  const emulator::Image loaded = emulator::load_image(image);
  board.load(loaded);
  const EmulatedParts parts = emulated_parts(robot);
  outfit.add(parts.scenario);
  if (!add_scenario(options.scenario, outfit, diagnostics)) return std::nullopt;
  try {
    auto record = run(board, outfit, robot, forest, loaded, duration_ns, diagnostics);
    if (record) record->silent = parts.silent;
    if (record) record->flash = options.flash_misses ? "miss" : "hit";
    return record;
  } catch (const std::invalid_argument& error) {  // an event that cannot happen to its part
    diagnostics.error(code::bad_scenario, {}, fmt::format("scenario '{}': {}", options.scenario, error.what()));
    return std::nullopt;
  }
}

}  // namespace finemote::gen
