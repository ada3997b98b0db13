#include "emulator/program/watch.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "emulator/board.hpp"
#include "emulator/outfit/outfit.hpp"
#include "emulator/program/board_file.hpp"
#include "emulator/program/event_log.hpp"
#include "emulator/program/findings.hpp"
#include "emulator/program/onboard_parts.hpp"
#include "emulator/scenario/read.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/json/shallow.hpp"

namespace finemote::emulator {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::invalid_argument("cannot read '" + path + "'");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What hangs on the board, and what happens to it.
struct Setting {
  Json board_file = Json::object();
  Json parts;     ///< of the board
  Json scenario;  ///< null: none
  std::uint64_t last_event_ns = 0;
};

/// Mistakes are shown at their words; warnings go to stderr. @throws std::invalid_argument with all of them
void read_scenario(const std::string& path, Setting& setting) {
  const gen::SourceFile file{path, path, text_of(path)};
  const auto maybe_scenario = gen::json::parse_shallow<Json>(file.text);
  setting.parts = onboard_parts(setting.board_file, maybe_scenario);
  gen::Diagnostics diagnostics;
  const auto tree = scenario::read(file, world_of(setting.board_file, setting.parts), diagnostics);
  const std::string findings = gen::render_text(diagnostics, false);
  if (!tree) throw std::invalid_argument(findings);
  std::fputs(findings.c_str(), stderr);
  setting.scenario = maybe_scenario;
  setting.last_event_ns = static_cast<std::uint64_t>(scenario::last_event_ns(*tree));
}

Setting read_setting(const WatchOptions& options) {
  Setting setting;
  if (!options.board.empty()) setting.board_file = read_board_file(options.board);
  setting.parts = onboard_parts(setting.board_file, Json());
  if (!options.scenario.empty()) read_scenario(options.scenario, setting);
  return setting;
}

Wiring wiring_of(const WatchOptions& options, const Setting& setting) {
  Wiring wiring;
  if (!options.board.empty()) wiring = read_wiring(setting.board_file);
  if (options.crystal_hz != 0) wiring.crystal_hz = options.crystal_hz;
  return wiring;
}

BoardOptions options_of(const WatchOptions& options) {
  BoardOptions board_options;
  board_options.probe = false;
  board_options.silicon = Silicon::named(options.silicon, options.seed);
  if (options.flash_misses) board_options.flash = FlashModel::miss_always;
  return board_options;
}

}  // namespace

bool watch(const WatchOptions& options, std::ostream& out) {
  const Setting setting = read_setting(options);
  Board board(wiring_of(options, setting), options_of(options));
  board.chip().rcc.dead_crystal = options.dead_crystal;
  Outfit outfit(board);
  board.load(load_image(options.image));
  outfit.add(setting.parts);
  if (!setting.scenario.is_null()) outfit.add(setting.scenario);
  std::optional<EventLog> log;
  if (!options.as_document) log.emplace(board, out);
  const Stop stop = board.run_for(std::max(options.duration_ns, setting.last_event_ns));
  Findings findings(board, outfit, stop);
  if (options.as_document)
    out << findings.document(options.image).dump(2) << "\n";
  else
    findings.write_text(out);
  return findings.ran_as_expected();
}

}  // namespace finemote::emulator
