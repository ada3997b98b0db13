// The <board> element: FM3005 to FM3007, the tick FM3036 and FM3038, its params.
#include <fmt/format.h>

#include <algorithm>

#include "generator/descriptor/library.hpp"
#include "generator/descriptor/whole_cycles.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

const Board* find_named_board(Reading& reading, const xml::Node& tag) {
  const xml::Attribute* name = tag.attribute("name");
  if (!reading.options.board.empty())
    return find_board(reading.library, reading.options.board, reading.sources, reading.diagnostics);
  if (name == nullptr) return nullptr;
  const std::vector<std::string> known = board_names(reading.library);
  if (std::find(known.begin(), known.end(), name->value) == known.end()) {
    suggest(
        at_value(reading.diagnostics, code::unknown_board, *name, fmt::format("there is no board '{}'", name->value)),
        name->value, known);
    return nullptr;
  }
  return find_board(reading.library, name->value, reading.sources, reading.diagnostics);
}

void read_tick(Reading& reading, const xml::Node& tag) {
  const Board* board = reading.robot.board;
  reading.robot.tick = board != nullptr ? board->default_tick : milliseconds(1);
  const xml::Attribute* attribute = tag.attribute("tick");
  if (attribute == nullptr) {
    reading.tick_is_known = true;
    return;
  }
  const auto tick = read_quantity(tag, "tick", units::parse_duration, reading.diagnostics);
  if (!tick) return;
  if (*tick == Duration::zero()) {
    at_value(reading.diagnostics, code::period_zero, *attribute, "the tick is zero")
        .hint("write for example tick=\"1ms\"");
    return;
  }
  if (board != nullptr && (*tick < board->min_tick || *tick > board->max_tick)) {
    at_value(reading.diagnostics, code::tick_cycles, *attribute,
             fmt::format("a tick of {} is out of range for board '{}'", attribute->value, board->name))
        .hint(fmt::format("write a tick from {} to {}", units::format_duration(board->min_tick),
                          units::format_duration(board->max_tick)));
    return;
  }
  reading.robot.tick = *tick;
  reading.tick_is_known = board == nullptr || is_whole_cycles(*board, *tick);
  if (reading.tick_is_known) return;
  at_value(reading.diagnostics, code::tick_cycles, *attribute,
           fmt::format("a tick of {} is not a whole number of CPU cycles", attribute->value))
      .note(fmt::format("board '{}' runs at {} Hz; releases would drift", board->name, board->cpu_hz))
      .hint(fmt::format("the next longer one that is: tick=\"{}\"",
                        units::format_duration(whole_tick_above(*board, *tick))));
}

void report_missing(Reading& reading) {
  if (reading.tags.blocks.empty()) return;
  std::string names;
  for (const std::string& name : board_names(reading.library)) names += (names.empty() ? "'" : ", '") + name + "'";
  at_tag(reading.diagnostics, code::board_missing, *reading.tags.blocks.front(), "the robot has no <board>")
      .note("boards: " + names)
      .hint(fmt::format("add <board name=\"{}\"/>", suggested_board(reading.library, reading.sources)));
}

/// @param place  instead of what the param says; empty: that
void place_code(const std::string& place, std::vector<Param>& params) {
  for (Param& param : params) {
    if (!place.empty() && param.spec->name == "code") param.value = place;
  }
}

}  // namespace

void read_board_tag(Reading& reading) {
  if (!reading.options.board.empty()) {
    const std::vector<std::string> known = board_names(reading.library);
    if (std::find(known.begin(), known.end(), reading.options.board) == known.end()) {
      suggest(reading.diagnostics.error(code::unknown_board, {},
                                        fmt::format("there is no board '{}'", reading.options.board)),
              reading.options.board, known);
    }
  }
  const auto& boards = reading.tags.boards;
  if (boards.empty()) return report_missing(reading);
  for (std::size_t i = 1; i < boards.size(); ++i) {
    at_tag(reading.diagnostics, code::board_twice, *boards[i], "the robot has a second <board>")
        .note("the first one is declared here", boards.front()->at);
  }
  const xml::Node& tag = *boards.front();
  reading.robot.board = find_named_board(reading, tag);
  read_tick(reading, tag);
  if (reading.robot.board == nullptr) return;
  reading.robot.board_params =
      read_param_tags(reading, tag, reading.robot.board->params, fmt::format("board '{}'", reading.robot.board->name));
  place_code(reading.options.code, reading.robot.board_params);
}

}  // namespace finemote::gen
