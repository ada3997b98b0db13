#include "emulator/program/watch.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "emulator/board.hpp"
#include "emulator/outfit.hpp"
#include "emulator/scenario/read.hpp"
#include "generator/diagnostic/render.hpp"

namespace finemote::emulator {
namespace {

/// Writes events with the time they happened at.
class Log {
 public:
  Log(Board& board, std::ostream& out) : board_(board), out_(out) {}

  template <class... Values>
  void line(const char* format, Values... values) {
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    out_ << board_.now_ns() << ' ' << text << '\n';
  }

 private:
  Board& board_;
  std::ostream& out_;
};

void watch_pins(Board& board, Log& log) {
  for (char port = 'A'; port <= 'I'; ++port) {
    board.chip().gpio(port).on_output = [&log, port](unsigned pin, bool output, bool high) {
      if (output) log.line("P%c%u %d", port, pin, high ? 1 : 0);
    };
  }
}

/// A byte as text where it is some.
void show_byte(Log& log, const char* name, std::uint8_t byte) {
  if (byte >= 0x20 && byte < 0x7F) return log.line("%s 0x%02X '%c'", name, byte, byte);
  log.line("%s 0x%02X", name, byte);
}

void watch_buses(Board& board, Log& log) {
  for (const auto& it : board.chip().usarts()) {
    it->on_sent = [&log, name = it->name().c_str()](std::uint8_t byte) { show_byte(log, name, byte); };
  }
  for (const auto& it : board.chip().i2cs()) {
    it->on_wire = [&log, name = it->name().c_str()](const char* what, std::uint8_t byte, bool acknowledged) {
      if (what[1] == 't') return log.line("%s stop", name);
      log.line("%s %s 0x%02X %s", name, what, byte, acknowledged ? "ACK" : "NACK");
    };
  }
  for (const auto& it : board.chip().spis()) {
    it->on_frame = [&log, name = it->name().c_str()](std::uint16_t out, std::uint16_t in, unsigned bits) {
      log.line("%s out 0x%0*X in 0x%0*X", name, bits / 4, out, bits / 4, in);
    };
  }
}

/// Pulse outputs; a part that listens to one already hears it still.
void watch_timers(Board& board, Log& log) {
  for (const auto& it : board.chip().timers()) {
    it->on_pulse = [&log, name = it->name().c_str(), other = it->on_pulse](unsigned channel, Timer::Pulse pulse) {
      log.line("%s.%u pulse %llu of %llu ns", name, channel, static_cast<unsigned long long>(pulse.width_ns),
               static_cast<unsigned long long>(pulse.period_ns));
      if (other) other(channel, pulse);
    };
  }
}

const char* end_of(Stop stop) {
  switch (stop) {
    case Stop::time:
      return "the time is over";
    case Stop::exit:
      return "the image ended itself";
    case Stop::lockup:
      return "the core locked up";
    case Stop::dead:
      break;
  }
  return "the core sleeps with nothing left to wake it";
}

void summarise(Board& board, Stop stop, std::ostream& out) {
  const Rcc& rcc = board.chip().rcc;
  out << "# " << end_of(stop) << " at " << board.now_ns() << " ns\n"
      << "# core " << rcc.core_hz() << " Hz, APB1 " << rcc.apb1_hz() << " Hz, APB2 " << rcc.apb2_hz() << " Hz, "
      << board.cpu().instructions() << " instructions, " << board.resets() << " resets\n";
  for (const auto& it : board.chip().usarts()) {
    if (it->statistics().bytes == 0) continue;
    out << "# " << it->name() << " " << it->format().baud << " baud, " << it->format().bits() << " bits a byte, "
        << it->statistics().bytes << " bytes\n";
  }
  for (const Report& report : board.reports()) {
    out << "# " << name_of(report.misuse) << ": " << report.text << " (" << report.count << " times, first at "
        << report.first_ns << " ns)\n";
  }
}

struct Scenario {
  Json document;
  std::uint64_t last_event_ns = 0;
};

/// Mistakes are shown at their words; warnings go to stderr. @throws std::invalid_argument with all of them
Scenario read_scenario(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::invalid_argument("cannot read '" + path + "'");
  const gen::SourceFile file{path, path, {std::istreambuf_iterator<char>(in), {}}};
  gen::Diagnostics diagnostics;
  const auto tree = scenario::read(file, {}, diagnostics);
  const std::string findings = gen::render_text(diagnostics, false);
  if (!tree) throw std::invalid_argument(findings);
  std::fputs(findings.c_str(), stderr);
  return {Json::parse(file.text), static_cast<std::uint64_t>(scenario::last_event_ns(*tree))};
}

Wiring wiring_of(const WatchOptions& options) {
  Wiring wiring;
  if (!options.board.empty()) {
    std::ifstream in(options.board, std::ios::binary);
    if (!in) throw std::invalid_argument("cannot read '" + options.board + "'");
    wiring = read_wiring(Json::parse(in));
  }
  if (options.crystal_hz != 0) wiring.crystal_hz = options.crystal_hz;
  return wiring;
}

}  // namespace

bool watch(const WatchOptions& options, std::ostream& out) {
  BoardOptions board_options;
  board_options.probe = false;
  if (options.flash_misses) board_options.flash = FlashModel::miss_always;
  Board board(wiring_of(options), board_options);
  Outfit outfit(board);
  board.load(load_image(options.image));
  std::uint64_t duration_ns = options.duration_ns;
  if (!options.scenario.empty()) {
    const Scenario scenario = read_scenario(options.scenario);
    outfit.add(scenario.document);
    duration_ns = std::max(duration_ns, scenario.last_event_ns);
  }
  Log log(board, out);
  watch_pins(board, log);
  watch_buses(board, log);
  watch_timers(board, log);
  const Stop stop = board.run_for(duration_ns);
  summarise(board, stop, out);
  for (const Expectation& e : outfit.expectations()) {
    out << "# " << e.part << " " << e.value << " " << (e.holds() ? "as expected" : "not as expected") << ": "
        << e.lowest << " to " << e.highest << "\n";
    if (!e.holds()) return false;
  }
  return stop != Stop::lockup && board.reports().empty();
}

}  // namespace finemote::emulator
