#include "generator/board_sources/board_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "generator/board_sources/chip_ports.hpp"
#include "generator/board_sources/port_objects.hpp"
#include "generator/emit/template.hpp"

namespace finemote::gen {
namespace {

/// 168'000'000
std::string grouped(std::uint32_t value) {
  if (value < 1000) return std::to_string(value);
  return fmt::format("{}'{:03}", grouped(value / 1000), value % 1000);
}

struct Objects {
  std::vector<PortObject> list;
  std::vector<std::string> mistakes;
};

/// The ports of the board itself, or of all boards it stands in for; of those with one name and different kinds the
/// first counts, and the others are in `mistakes`.
Objects objects_of(const Board& board, const std::vector<const Board*>& all) {
  if (!board.stands_in) return {port_objects(board), {}};
  Objects objects;
  std::map<std::string, PortClass> seen;
  for (const Board* other : all) {
    for (PortObject& object : port_objects(*other)) {
      const auto [entry, is_new] = seen.emplace(object.name, object.kind);
      if (!is_new && entry->second != object.kind)
        objects.mistakes.push_back(
            fmt::format("port '{}' of board '{}' is of another kind on another board that it stands in for",
                        object.name, other->name));
      if (is_new) objects.list.push_back(std::move(object));
    }
  }
  return objects;
}

/// Null: the board has none of that name.
const Memory* find_memory(const Board& board, std::string_view name) {
  const auto found =
      std::find_if(board.memory.begin(), board.memory.end(), [&](const Memory& memory) { return memory.name == name; });
  return found == board.memory.end() ? nullptr : &*found;
}

std::string sources_of(const Board& board, const std::vector<const Board*>& all) {
  if (!board.stands_in) return board.name + ".json";
  std::string text;
  for (const Board* other : all) text += (text.empty() ? "" : ", ") + other->name + ".json";
  return text;
}

/// Names by class, in the order of the classes; each list a line.
Data names_by_class(const std::vector<PortObject>& objects) {
  std::map<PortClass, std::string> names;
  for (const PortObject& object : objects) names[object.kind] += (names[object.kind].empty() ? "" : ", ") + object.name;
  Data list{Data::type::list};
  for (const auto& [kind, text] : names) {
    Data entry;
    entry.set("class", fmt::format("{}Port", class_name(kind)));
    entry.set("hardware", fmt::format("{}Hardware", class_name(kind)));
    entry.set("names", text);
    list.push_back(entry);
  }
  return list;
}

std::uint32_t origin_of(const Memory& memory) {
  return static_cast<std::uint32_t>(std::stoul(memory.origin, nullptr, 16));
}

Data region(const char* name, std::uint32_t origin, std::uint32_t bytes) {
  Data region;
  region.set("name", name);
  region.set("origin", fmt::format("0x{:08X}", origin));
  region.set("kib", std::to_string(bytes / 1024));
  return region;
}

/// Without core-coupled RAM the upper half of the RAM stands in for it: the stack has a place of its own.
Data regions(const Board& board) {
  const Memory *flash = find_memory(board, "flash"), *ram = find_memory(board, "ram"),
               *core = find_memory(board, "ccm");
  if (flash == nullptr || ram == nullptr) throw std::logic_error("sources of a board without memory");
  const std::uint32_t ram_bytes = core != nullptr ? ram->bytes : ram->bytes / 2;
  Data list{Data::type::list};
  list.push_back(region("FLASH    (rx) ", origin_of(*flash), flash->bytes));
  list.push_back(region("RAM      (rwx)", origin_of(*ram), ram_bytes));
  list.push_back(region("CORE_RAM (rw) ", core != nullptr ? origin_of(*core) : origin_of(*ram) + ram_bytes,
                        core != nullptr ? core->bytes : ram->bytes - ram_bytes));
  return list;
}

/// Of a board that can run its code in RAM mapped to 0: what is left of the RAM is for DMA, data lie in core-coupled
/// RAM.
Data regions_with_code(const Board& board) {
  const Memory *flash = find_memory(board, "flash"), *ram = find_memory(board, "ram"),
               *core = find_memory(board, "ccm"), *code = find_memory(board, "code");
  if (flash == nullptr || ram == nullptr || core == nullptr || code == nullptr)
    throw std::logic_error("code in RAM without memory");
  Data list{Data::type::list};
  list.push_back(region("FLASH    (rx) ", origin_of(*flash), flash->bytes));
  list.push_back(region("CODE     (rwx)", 0, code->bytes));
  list.push_back(region("RAM      (rw) ", origin_of(*ram) + code->bytes, ram->bytes - code->bytes));
  list.push_back(region("CORE_RAM (rw) ", origin_of(*core), core->bytes));
  return list;
}

void set_clocks(const Clocks& clocks, Data& data) {
  data.set("crystal_hz", grouped(clocks.crystal_hz));
  data.set("pll_m", std::to_string(clocks.pll_m));
  data.set("pll_n", std::to_string(clocks.pll_n));
  data.set("pll_p", std::to_string(clocks.pll_p));
  data.set("pll_q", std::to_string(clocks.pll_q));
  data.set("apb1_hz", grouped(clocks.apb1_hz));
  data.set("apb2_hz", grouped(clocks.apb2_hz));
  data.set("flash_wait_states", std::to_string(clocks.flash_wait_states));
}

Data clocks(const Board& board) {
  Data data;
  data.set("core_hz", grouped(static_cast<std::uint32_t>(board.cpu_hz)));
  data.set("has_clocks", board.clocks.has_value());
  if (board.clocks) set_clocks(*board.clocks, data);
  return data;
}

Data resting_pins(const Board& board) {
  Data data, resting{Data::type::list};
  std::size_t count = 0;
  for (const NamedPin& pin : board.pins) {
    if (!pin.rests_high) continue;
    Data entry;
    const auto [port, number] = pin_name(pin.pin);
    entry.set("letter", std::string(1, port));
    entry.set("number", std::to_string(number));
    entry.set("high", *pin.rests_high ? "true" : "false");
    entry.set("what", pin.summary);
    resting.push_back(entry);
    ++count;
  }
  data.set("resting", resting);
  data.set("resting_count", std::to_string(count));
  return data;
}

/// Where a class of ports is below runtime/boards/<board>/ports.
struct PortHeaders {
  const char* host;      ///< its recorder, of board host
  const char* stand_in;  ///< what other boards have, without its ending
};

PortHeaders headers_of(PortClass kind) {
  switch (kind) {
    case PortClass::uart:
      return {"uart_wire.hpp", "uart"};
    case PortClass::can:
      return {"can_wire.hpp", "can"};
    case PortClass::i2c:
      return {"i2c_wire.hpp", "i2c"};
    case PortClass::spi:
      return {"spi_wire.hpp", "spi"};
    case PortClass::pwm:
    case PortClass::edge:
    case PortClass::adc:
      return {"pins.hpp", "outputs"};
  }
  throw std::logic_error("no class of ports");
}

class SourceFiles {
 public:
  SourceFiles(const Board& board, const std::vector<const Board*>& all, const std::string& data_dir)
      : board_(board),
        objects_(objects_of(board, all).list),
        sources_(sources_of(board, all)),
        templates_(data_dir + "/templates") {}

  std::vector<OutputFile> make() {
    add_build();
    add_names();
    if (board_.is_host()) {
      add_host_ports();
      return std::move(files_);
    }
    add("board.ld", "board.ld", Data{"regions", regions(board_)});
    if (const Memory* code = find_memory(board_, "code"); code != nullptr) {
      Data data{"regions", regions_with_code(board_)};
      data.set("code_copy", code->origin);
      add("board_sram.ld", "board_sram.ld", data);
    }
    add("board/clocks.hpp", "clocks.hpp", clocks(board_));
    if (board_.chip == "stm32f4") {
      add("board/resting_pins.hpp", "stm32f4/resting_pins.hpp", resting_pins(board_));
      for (OutputFile& file : chip_ports(board_, templates_)) files_.push_back(std::move(file));
    } else {
      add_stand_ins();
    }
    return std::move(files_);
  }

 private:
  void add_build() {
    const bool is_chip = board_.chip == "stm32f4";
    Data data;
    data.set("chips", board_.is_host() ? "" : is_chip ? "stm32f4 cortex_m4" : board_.chip);
    data.set("definitions", is_chip ? "FINEMOTE_SILENT" : "");
    data.set("stands_in", board_.stands_in ? "ON" : "OFF");
    add("board.cmake", "board.cmake", data);
  }
  void add(const std::string& name, const std::string& template_name, Data data) {
    data.set("board", board_.name);
    data.set("sources", sources_);
    files_.push_back({name, templates_.fill("boards/" + template_name + ".mustache", data)});
  }
  void add_names() {
    Data classes = names_by_class(objects_);
    Data gpio;
    gpio.set("class", "GpioPort");
    gpio.set("hardware", "GpioHardware");
    gpio.set("names", "gpio");
    classes.push_back(gpio);
    add("board/port_names.hpp", "port_names.hpp", Data{"classes", classes});
    if (board_.is_host()) add("board/wires.hpp", "host/wires.hpp", Data{"classes", classes});
  }
  void add_host_ports() {
    Data data, ports{Data::type::list}, headers{Data::type::list};
    std::vector<std::string> seen;
    for (const PortObject& object : objects_) {
      Data port;
      port.set("class", fmt::format("{}Port", class_name(object.kind)));
      port.set("name", object.name);
      ports.push_back(port);
      seen.emplace_back(headers_of(object.kind).host);
    }
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    data.set("headers", text_list(seen));
    data.set("classes", names_by_class(objects_));
    data.set("ports", ports);
    add("ports/ports.cpp", "host/ports.cpp", data);
  }
  /// A bus has an interrupt of its own, pended by software: the first one of the real port.
  void add_stand_ins() {
    for (const PortObject& object : objects_) {
      const bool has_line =
          object.kind == PortClass::can || object.kind == PortClass::i2c || object.kind == PortClass::spi;
      Data data;
      data.set("name", object.name);
      data.set("source", object.board);
      data.set("kind", headers_of(object.kind).stand_in);
      data.set("class", fmt::format("{}Port", class_name(object.kind)));
      data.set("hardware", fmt::format("{}Hardware", class_name(object.kind)));
      data.set("has_line", has_line);
      data.set("line", has_line ? std::to_string(object.port->interrupts.front().number) : "");
      add("ports/" + object.name + ".cpp", "cortex_m4/port.cpp", data);
    }
  }

  const Board& board_;
  const std::vector<PortObject> objects_;
  const std::string sources_;
  Templates templates_;
  std::vector<OutputFile> files_;
};

}  // namespace

std::vector<std::string> mistakes_for_sources(const Board& board, const std::vector<const Board*>& all) {
  std::vector<std::string> mistakes = objects_of(board, all).mistakes;
  for (const char* name : {"flash", "ram"}) {
    if (!board.is_host() && find_memory(board, name) == nullptr)
      mistakes.push_back(fmt::format("there is no memory '{}'", name));
  }
  if (find_memory(board, "code") != nullptr && find_memory(board, "ccm") == nullptr)
    mistakes.emplace_back("there is no memory 'ccm', where data lie while code runs in RAM");
  return mistakes;
}

std::vector<OutputFile> board_sources(const Board& board, const std::vector<const Board*>& all,
                                      const std::string& data_dir) {
  return SourceFiles(board, all, data_dir).make();
}

}  // namespace finemote::gen
