#include "generator/descriptor/port_signals.hpp"

namespace finemote::gen {

const PortPin* signal_pin(const Port& port, std::string_view signal) {
  for (const PortPin& pin : port.pins) {
    if (pin.signal == signal) return &pin;
  }
  return nullptr;
}

const DmaStream* dma_for(const Port& port, std::string_view signal) {
  for (const DmaStream& stream : port.dma) {
    if (stream.signal == signal) return &stream;
  }
  return nullptr;
}

}  // namespace finemote::gen
