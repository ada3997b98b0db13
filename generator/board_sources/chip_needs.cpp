#include "generator/board_sources/chip_needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <stdexcept>

#include "generator/board_sources/port_objects.hpp"
#include "generator/descriptor/pin_name.hpp"
#include "generator/descriptor/port_signals.hpp"

namespace finemote::gen {
namespace {

bool ends_with(std::string_view text, std::string_view ending) {
  return text.size() >= ending.size() && text.substr(text.size() - ending.size()) == ending;
}

std::optional<std::string> missing_pin(const Port& port, const std::vector<const char*>& signals) {
  for (const char* signal : signals) {
    if (signal_pin(port, signal) == nullptr) return fmt::format("a pin '{}'", signal);
  }
  const int function = port.pins.front().alternate_function;
  const bool same = std::all_of(port.pins.begin(), port.pins.end(),
                                [function](const PortPin& pin) { return pin.alternate_function == function; });
  return same ? std::nullopt : std::optional<std::string>("one alternate function for all its pins");
}

std::optional<std::string> missing_interrupt(const Port& port, const std::vector<const char*>& endings) {
  for (const char* ending : endings) {
    if (interrupt_ending(port, ending) == nullptr) return fmt::format("an interrupt '...{}'", ending);
  }
  return {};
}

/// Both directions by one request channel, and the interrupt of the receiving stream.
std::optional<std::string> missing_dma(const Port& port) {
  const DmaStream *receive = dma_for(port, "rx"), *transmit = dma_for(port, "tx");
  if (receive == nullptr || transmit == nullptr) return "DMA streams 'rx' and 'tx'";
  if (receive->channel != transmit->channel) return "one DMA channel for 'rx' and 'tx'";
  const std::string name = interrupt_name(*receive);
  return interrupt_ending(port, name) != nullptr ? std::nullopt
                                                 : std::optional<std::string>(fmt::format("the interrupt '{}'", name));
}

std::optional<std::string> missing_own_interrupt(const Port& port) {
  return own_interrupt(port) != nullptr ? std::nullopt : std::optional<std::string>("an interrupt of its own name");
}

std::optional<std::string> first_of(std::optional<std::string> one, std::optional<std::string> other) {
  return one ? one : other;
}

}  // namespace

const InterruptLine* interrupt_ending(const Port& port, std::string_view ending) {
  for (const InterruptLine& line : port.interrupts) {
    if (ends_with(line.name, ending)) return &line;
  }
  return nullptr;
}

const InterruptLine* own_interrupt(const Port& port) {
  std::string name = port.name;
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return interrupt_ending(port, name);
}

std::string interrupt_name(const DmaStream& stream) {
  return fmt::format("DMA{}_Stream{}", stream.controller.back(), stream.stream);
}

namespace {

/// What is missing or does not fit, as it ends the sentence: port 'usart1' needs.
std::optional<std::string> missing_for_driver(const Port& port) {
  switch (port_class(port)) {
    case PortClass::can:
      return first_of(missing_pin(port, {"rx", "tx"}), missing_interrupt(port, {"_TX", "_RX0", "_SCE"}));
    case PortClass::i2c:
      return first_of(missing_pin(port, {"scl", "sda"}), missing_interrupt(port, {"_EV", "_ER"}));
    case PortClass::spi:
      if (port.selects.empty()) return "the pins of its chip selects";
      return first_of(missing_pin(port, {"sck", "miso", "mosi"}),
                      port.dma.empty() ? missing_own_interrupt(port) : missing_dma(port));
    case PortClass::pwm:
      if (!port.timer) return "a timer channel";
      return port.pins.size() == 1 ? std::nullopt : std::optional<std::string>("one pin");
    case PortClass::uart:
      return first_of(missing_own_interrupt(port), first_of(missing_pin(port, {"tx", "rx"}), missing_dma(port)));
    case PortClass::edge:
    case PortClass::adc:
      break;
  }
  throw std::logic_error("no bus sits on a port of this class");
}

}  // namespace

std::vector<std::string> mistakes_for_chip(const Board& board) {
  std::vector<std::string> mistakes;
  for (const Port& port : board.ports) {
    if (const auto missing = missing_for_driver(port))
      mistakes.push_back(fmt::format("port '{}' needs {}", port.name, *missing));
  }
  std::map<std::uint32_t, std::string> pins;  // that interrupt, by number
  for (const NamedPin& pin : board.pins) {
    if (!pin.can("interrupt")) continue;
    const std::string& first = pins.emplace(pin_name(pin.pin).number, pin.pin).first->second;
    if (first != pin.pin)
      mistakes.push_back(fmt::format("pins '{}' and '{}' share an external interrupt line", first, pin.pin));
  }
  return mistakes;
}

}  // namespace finemote::gen
