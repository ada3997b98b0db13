// Every shipped device on every port of the Type C board: what the model accepts is what the firmware starts with.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/model/build.hpp"
#include "generator/xml/parse.hpp"
#include "source_dir.hpp"

using namespace finemote::gen;

namespace {

constexpr const char* kBoard = "robomaster_type_c";

/// Numbers of the mistakes in a robot with these tags.
std::vector<int> mistakes(const std::string& tags) {
  Sources sources;
  Diagnostics diagnostics;
  auto library = load_library({finemote::test::source_dir(), "", {}, {}}, sources, diagnostics);
  REQUIRE(library);
  const SourceFile* file = sources.add(
      SourceFile{"robot.urdf", "robot.urdf",
                 fmt::format("<robot name=\"r\"><finemote version=\"1\"><board name=\"{}\"/>{}</finemote></robot>",
                             kBoard, tags)});
  const auto document = xml::parse(*file, diagnostics);
  REQUIRE(document);
  build_model(*document, *library, {}, sources, diagnostics);
  std::vector<int> numbers;
  for (const Diagnostic& finding : diagnostics.in_file_order()) numbers.push_back(finding.code.number);
  return numbers;
}

struct Shelf {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Library> library = load_library({finemote::test::source_dir(), "", {}, {}}, sources, diagnostics);
  const Board& board() { return *find_board(*library, kBoard, sources, diagnostics); }
  /// Shipped types that sit on a kind of bus.
  std::vector<const DeviceType*> types_on(BusKind kind) {
    std::vector<const DeviceType*> types;
    for (const std::string& name : device_type_names(*library)) {
      const DeviceType* type = find_device_type(*library, name, sources, diagnostics);
      if (std::find(type->buses.begin(), type->buses.end(), kind) != type->buses.end()) types.push_back(type);
    }
    return types;
  }
  std::vector<const Port*> ports_for(BusKind kind) {
    std::vector<const Port*> ports;
    for (const Port& port : board().ports) {
      if (std::find(port.kinds.begin(), port.kinds.end(), kind) != port.kinds.end()) ports.push_back(&port);
    }
    return ports;
  }
};

/// Children and uses that a type cannot be without are left out: only mistakes of lines count.
bool has(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

}  // namespace

TEST_CASE("a device on a serial line is accepted at the ports whose line is as it needs it, and nowhere else") {
  Shelf shelf;
  std::size_t pairs = 0, refused = 0;
  for (const DeviceType* type : shelf.types_on(BusKind::uart)) {
    for (const Port* port : shelf.ports_for(BusKind::uart)) {
      INFO(type->name << " on " << port->name);
      const std::int64_t rate = type->rates.empty() ? 115200 : type->rates.front();
      const auto found = mistakes(fmt::format(
          R"(<bus name="line" type="uart" port="{}" baud="{}baud"/><device name="d" type="{}" bus="line" period="10ms"/>)",
          port->name, rate, type->name));
      const bool fits = type->format.ends_with("_inverted") == port->has_inverter;
      CHECK(has(found, 3078) == !fits);
      ++pairs;
      refused += fits ? 0 : 1;
    }
  }
  CHECK(pairs >= 12);
  CHECK(refused >= 5);
}

TEST_CASE("a use of a serial line is held to its own format") {
  const char* robot = R"(<bus name="host" type="uart" port="{}" baud="115200baud"/>
    <device name="rov" type="finsrov" period="20ms"><use role="host" bus="host"/></device>)";
  CHECK(has(mistakes(fmt::format(fmt::runtime(robot), "usart3")), 3078));
  CHECK_FALSE(has(mistakes(fmt::format(fmt::runtime(robot), "usart1")), 3078));
}

TEST_CASE("every chip select of every SPI port is accepted, and no other") {
  Shelf shelf;
  for (const DeviceType* type : shelf.types_on(BusKind::spi)) {
    for (const Port* port : shelf.ports_for(BusKind::spi)) {
      for (std::uint32_t channel = 0; channel <= port->channels; ++channel) {
        INFO(type->name << " on " << port->name << " select " << channel);
        const auto found = mistakes(fmt::format(
            R"(<bus name="spi" type="spi" port="{}" clock="5250kHz"/><device name="d" type="{}" bus="spi" channel="{}" period="10ms"/>)",
            port->name, type->name, channel));
        CHECK(has(found, 3064) == (channel == port->channels));
      }
    }
  }
}
