#include "generator/model/pins.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/model/attributes.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

bool is_chip_pin(const std::string& name) {
  if (name.size() < 3 || name.size() > 4 || name[0] != 'P' || name[1] < 'A' || name[1] > 'I') return false;
  const auto number = units::parse_bare(name.substr(2));
  return number && *number <= 15 && name == fmt::format("P{}{}", name[1], *number);
}

bool has(const NamedPin& pin, const std::string& function) {
  return std::find(pin.functions.begin(), pin.functions.end(), function) != pin.functions.end();
}

std::string pins_that_can(const Board& board, const std::string& function) {
  std::string able;
  for (const NamedPin& pin : board.pins) {
    if (has(pin, function)) able += (able.empty() ? "'" : ", '") + pin.name + "'";
  }
  return able;
}

/// A named pin is wired for something; any other of the chip can be an input or an output.
bool is_plain(const std::string& function) { return function == "input" || function == "output"; }

void report_unknown(const Board* board, const std::string& name, const Position& at, const std::string& function,
                    Diagnostics& diagnostics) {
  auto& finding =
      diagnostics.error(code::pin_invalid, at, fmt::format("'{}' is not a pin", name)).underline(name.size());
  std::vector<std::string> names;
  if (board != nullptr) {
    for (const NamedPin& pin : board->pins) {
      if (has(pin, function)) names.push_back(pin.name);
    }
  }
  suggest(finding, name, names);
  if (is_plain(function))
    finding.hint(names.empty() ? "write a pin of the chip, PA0 to PI15" : "or write a pin of the chip, PA0 to PI15");
}

}  // namespace

PlacedPin find_pin(const Board* board, const std::string& name, const Position& at, const std::string& user,
                   const std::string& function, Diagnostics& diagnostics) {
  const NamedPin* named = board != nullptr ? board->named_pin(name) : nullptr;
  if (named == nullptr && !is_chip_pin(name)) {
    report_unknown(board, name, at, function, diagnostics);
    return {};
  }
  if (board == nullptr || (named == nullptr ? is_plain(function) : has(*named, function)))
    return {named != nullptr ? named->pin : name, named};
  auto& finding =
      diagnostics
          .error(code::pin_function, at,
                 fmt::format("{} needs pin '{}' as {}, which it cannot be on this board", user, name, function))
          .underline(name.size());
  if (named != nullptr) finding.note(fmt::format("'{}' ({}) is: {}", named->name, named->pin, named->summary));
  const std::string able = pins_that_can(*board, function);
  if (!able.empty()) finding.hint("these can: " + able);
  return {};
}

}  // namespace finemote::gen
