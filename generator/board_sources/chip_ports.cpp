#include "generator/board_sources/chip_ports.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "generator/board_sources/chip_needs.hpp"
#include "generator/descriptor/pin_name.hpp"
#include "generator/descriptor/port_signals.hpp"
#include "generator/emit/template.hpp"

namespace finemote::gen {
namespace {

/// `kUsart1`: the chip's name of a peripheral.
std::string peripheral(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  name.front() = static_cast<char>(name.front() - 'a' + 'A');
  return "k" + name;
}

/// `PA9` to `{'A', 9}`.
std::string pin_text(const std::string& pin) { return pin_name(pin).initializer(); }

std::string stream_text(const DmaStream* stream) {
  if (stream == nullptr) return "{0, 0}";
  return fmt::format("{{stm32f4::dma::kController{}, {}}}", stream->controller.back(), stream->stream);
}

std::string line_text(const Port& port, const std::string& ending) {
  return std::to_string(interrupt_ending(port, ending)->number);
}

std::string line_of(const Port& port, const DmaStream& stream) { return line_text(port, interrupt_name(stream)); }

Data uart_data(const Port& port) {
  const DmaStream &receive = *dma_for(port, "rx"), &transmit = *dma_for(port, "tx");
  Data data;
  data.set("tx", pin_text(signal_pin(port, "tx")->pin));
  data.set("rx", pin_text(signal_pin(port, "rx")->pin));
  data.set("receive", stream_text(&receive));
  data.set("transmit", stream_text(&transmit));
  data.set("channel", std::to_string(receive.channel));
  data.set("line", std::to_string(own_interrupt(port)->number));
  data.set("receive_line", line_of(port, receive));
  data.set("inverter", port.has_inverter ? "true" : "false");
  return data;
}

Data i2c_data(const Port& port) {
  Data data;
  data.set("scl", pin_text(signal_pin(port, "scl")->pin));
  data.set("sda", pin_text(signal_pin(port, "sda")->pin));
  data.set("event_line", line_text(port, "_EV"));
  data.set("error_line", line_text(port, "_ER"));
  return data;
}

Data can_data(const Port& port) {
  Data data;
  data.set("rx", pin_text(signal_pin(port, "rx")->pin));
  data.set("tx", pin_text(signal_pin(port, "tx")->pin));
  data.set("transmit_line", line_text(port, "_TX"));
  data.set("receive_line", line_text(port, "_RX0"));
  data.set("error_line", line_text(port, "_SCE"));
  return data;
}

Data spi_data(const Port& port) {
  const DmaStream *receive = dma_for(port, "rx"), *transmit = dma_for(port, "tx");
  Data data;
  for (const char* signal : {"sck", "miso", "mosi"}) data.set(signal, pin_text(signal_pin(port, signal)->pin));
  std::string selects;
  for (const std::string& pin : port.selects) selects += (selects.empty() ? "" : ", ") + pin_text(pin);
  data.set("selects", selects);
  data.set("select_count", std::to_string(port.selects.size()));
  data.set("dma", receive != nullptr ? "true" : "false");
  data.set("receive", stream_text(receive));
  data.set("transmit", stream_text(transmit));
  data.set("channel", std::to_string(receive != nullptr ? receive->channel : 0));
  data.set("line", receive != nullptr ? line_of(port, *receive) : std::to_string(own_interrupt(port)->number));
  return data;
}

Data pwm_data(const Port& port) {
  Data data;
  data.set("channel", std::to_string(port.timer->channel));
  data.set("pin", pin_text(port.pins.front().pin));
  return data;
}

struct Kind {
  const char* file;  ///< of the template
  Data (*data)(const Port&);
};

Kind kind_of(PortClass kind) {
  switch (kind) {
    case PortClass::can:
      return {"can", can_data};
    case PortClass::i2c:
      return {"i2c", i2c_data};
    case PortClass::spi:
      return {"spi", spi_data};
    case PortClass::pwm:
      return {"pwm", pwm_data};
    case PortClass::uart:
      return {"uart", uart_data};
    case PortClass::edge:
    case PortClass::adc:
      break;
  }
  throw std::logic_error("no bus sits on a port of this class");
}

class PortFiles {
 public:
  PortFiles(const Board& board, Templates& templates) : board_(board), templates_(templates) {}

  std::vector<OutputFile> make() {
    std::map<std::uint32_t, std::vector<PortObject>> edges;  // by interrupt line
    for (const PortObject& object : port_objects(board_)) {
      if (object.kind == PortClass::edge) {
        edges[edge_interrupt(object.edge)].push_back(object);
      } else if (object.kind == PortClass::adc) {
        add_converter(object);
      } else {
        add_port(object);
      }
    }
    for (const auto& [line, group] : edges) add_edges(line, group);
    return std::move(files_);
  }

 private:
  void add(const std::string& name, const char* template_name, Data& data) {
    data.set("board", board_.name);
    files_.push_back({"ports/" + name + ".cpp",
                      templates_.fill(fmt::format("boards/stm32f4/{}.cpp.mustache", template_name), data)});
  }
  void add_port(const PortObject& object) {
    const Kind kind = kind_of(object.kind);
    Data data = kind.data(*object.port);
    data.set("name", object.name);
    data.set("place", object.port->connector);
    data.set("function", std::to_string(object.port->pins.front().alternate_function));
    data.set("peripheral", peripheral(object.port->timer ? object.port->timer->timer : object.name));
    add(object.name, kind.file, data);
  }
  void add_converter(const PortObject& object) {
    Data data;
    data.set("name", object.name);
    data.set("peripheral", peripheral(object.name));
    add(object.name, "adc", data);
  }
  void add_edges(std::uint32_t line, const std::vector<PortObject>& group) {
    Data list{Data::type::list}, data;
    std::string pins;
    for (const PortObject& object : group) {
      Data edge;
      edge.set("name", object.name);
      edge.set("pin", object.edge.initializer());
      edge.set("condition", group.size() == 1 ? "" : fmt::format("if (finemote::{}.is_pending()) ", object.name));
      list.push_back(edge);
      pins += fmt::format("{}{} of pin {}", pins.empty() ? "" : ", ", object.name, object.edge.text());
    }
    data.set("edges", list);
    data.set("line", std::to_string(line));
    data.set("place", pins);
    add(group.front().name, "edge", data);
  }

  const Board& board_;
  Templates& templates_;
  std::vector<OutputFile> files_;
};

}  // namespace

std::vector<OutputFile> chip_ports(const Board& board, Templates& templates) {
  return PortFiles(board, templates).make();
}

}  // namespace finemote::gen
