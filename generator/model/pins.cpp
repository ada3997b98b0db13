#include "generator/model/pins.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/descriptor/pin_name.hpp"
#include "generator/model/attributes.hpp"

namespace finemote::gen {
namespace {

/// Without a board, any pin that a chip of the family has.
bool is_chip_pin(const Board* board, const std::string& name) {
  if (board == nullptr) return parse_pin(name).has_value();
  return std::find(board->chip_pins.begin(), board->chip_pins.end(), name) != board->chip_pins.end();
}

}  // namespace

bool may_be_used(const Board& board, const std::string& pin, const std::string& function,
                 const std::vector<std::string>& ports) {
  const ReservedPins* reserved = board.reserved_pin(pin);
  if (reserved == nullptr) return true;
  if (reserved->port.empty()) return false;
  return function == "interrupt" || std::find(ports.begin(), ports.end(), reserved->port) != ports.end();
}

namespace {

std::string pins_that_can(const Board& board, const std::string& function) {
  std::string able;
  for (const NamedPin& pin : board.pins) {
    const bool is_free = may_be_used(board, pin.pin, function, {});
    if (is_free && pin.can(function)) able += (able.empty() ? "'" : ", '") + pin.name + "'";
  }
  return able;
}

/// A named pin is wired for something; any other of the chip can be an input or an output.
bool is_plain(const std::string& function) { return function == "input" || function == "output"; }

void report_unknown(const Board* board, const std::string& name, const Position& at, const PinNeed& need,
                    Diagnostics& diagnostics) {
  auto& finding =
      diagnostics.error(code::pin_invalid, at, fmt::format("'{}' is not a pin", name)).underline(name.size());
  if (need.wired != nullptr) return void(finding.hint(fmt::format("write '{}'", need.wired->name)));
  std::vector<std::string> names;
  if (board != nullptr) {
    for (const NamedPin& pin : board->pins) {
      if (pin.can(need.function) && may_be_used(*board, pin.pin, need.function, {})) names.push_back(pin.name);
    }
  }
  suggest(finding, name, names);
  if (!is_plain(need.function)) return;
  const std::string chip = board != nullptr ? fmt::format("{} to {}", board->chip_pins.front(), board->chip_pins.back())
                                            : std::string("PA0 to PI15");
  finding.hint(fmt::format("{}write a pin of the chip, {}", names.empty() ? "" : "or ", chip));
}

void report_other_line(const std::string& name, const Position& at, const std::string& user, const NamedPin& wired,
                       Diagnostics& diagnostics) {
  diagnostics
      .error(
          code::pin_function, at,
          fmt::format("{} cannot be pin '{}': the board wires this line of the part to '{}'", user, name, wired.name))
      .underline(name.size())
      .note(fmt::format("'{}' ({}) is: {}", wired.name, wired.pin, wired.summary))
      .hint(fmt::format("write '{}'", wired.name));
}

}  // namespace

const NamedPin* data_ready_line(const Board& board, const std::string& port, std::optional<std::uint32_t> channel) {
  const auto found = std::find_if(board.pins.begin(), board.pins.end(), [&](const NamedPin& pin) {
    return pin.data_ready && pin.data_ready->port == port &&
           (!pin.data_ready->channel || pin.data_ready->channel == channel);
  });
  return found == board.pins.end() ? nullptr : &*found;
}

PlacedPin find_pin(const Board* board, const std::string& name, const Position& at, const std::string& user,
                   const PinNeed& need, Diagnostics& diagnostics) {
  const std::string& function = need.function;
  const NamedPin* named = board != nullptr ? board->named_pin(name) : nullptr;
  if (named == nullptr && !is_chip_pin(board, name)) {
    report_unknown(board, name, at, need, diagnostics);
    return {};
  }
  if (need.wired != nullptr && named != need.wired) {
    report_other_line(name, at, user, *need.wired, diagnostics);
    return {};
  }
  if (board == nullptr || (named == nullptr ? is_plain(function) : named->can(function)))
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
