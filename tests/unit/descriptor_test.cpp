// Descriptors and board files as the generator reads them: values, what holds where a member is missing, and where
// mistakes are shown.
#include "catch.hpp"
#include "generator/descriptor/json_file.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/descriptor/pin_name.hpp"
#include "generator/descriptor/read_board.hpp"
#include "generator/descriptor/read_device_type.hpp"
#include "generator/descriptor/read_param.hpp"
#include "generator/diagnostic/render.hpp"
#include "source_dir.hpp"

using namespace finemote::gen;

namespace {

/// A device type made of the members that every one has, and these.
struct ReadType {
  Sources sources;
  Diagnostics diagnostics;
  DeviceType type;

  explicit ReadType(const std::string& members = {}) {
    const SourceFile* file = sources.add(
        {"probe.json", "",
         "{ \"schema\": \"finemote.device/1\", \"type\": \"probe\", \"summary\": \"s\",\n  \"class\": \"my::Probe\", "
         "\"header\": \"probe.hpp\"" +
             (members.empty() ? "" : ",\n  " + members) + " }\n"});
    const auto json = parse_json(*file, diagnostics);
    REQUIRE(json);
    type = read_device_type(json->value, *file, diagnostics);
  }
  [[nodiscard]] std::string said() const { return render_text(diagnostics, false); }
  [[nodiscard]] bool says(const std::string& words) const { return said().find(words) != std::string::npos; }
};

/// The one param of a type.
struct ReadParam : ReadType {
  explicit ReadParam(const std::string& members) : ReadType("\"params\": [{ \"name\": \"p\", " + members + " }]") {}
  [[nodiscard]] const ParamSpec& spec() const { return type.params.at(0); }
  /// The value of a text, or the number of what is wrong with it.
  [[nodiscard]] std::string parsed(const std::string& text) const {
    const auto result = parse_param(spec(), text);
    if (const auto* fault = std::get_if<ParamFault>(&result)) return code_name(fault->code);
    const auto& value = std::get<ParamValue>(result);
    if (const auto* words = std::get_if<std::string>(&value)) return *words;
    return Catch::StringMaker<double>::convert(number_of(value));
  }
};

struct ShippedLibrary {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Library> library = load_library({finemote::test::source_dir(), "", {}, {}}, sources, diagnostics);

  const Board& board(const std::string& name) {
    const Board* found = find_board(*library, name, sources, diagnostics);
    REQUIRE(found != nullptr);
    return *found;
  }
  const DeviceType& type(const std::string& name) {
    const DeviceType* found = find_device_type(*library, name, sources, diagnostics);
    REQUIRE(found != nullptr);
    return *found;
  }
};

}  // namespace

TEST_CASE("a type that names nothing more sits on no bus, provides nothing and takes no command") {
  const ReadType read;
  CHECK(read.said().empty());
  CHECK(read.type.name == "probe");
  CHECK(read.type.cpp_class == "my::Probe");
  CHECK(read.type.header == "probe.hpp");
  CHECK(read.type.buses.empty());
  CHECK(read.type.roles.empty());
  CHECK_FALSE(read.type.has_command());
  CHECK_FALSE(read.type.actuator);
  CHECK(read.type.constant_init);
  CHECK(read.type.spi_mode == kUsualSpiMode);
  CHECK_FALSE(read.type.wcet);
  CHECK_FALSE(read.type.acquisition);
}

TEST_CASE("the bus of a type, with its addresses and rates") {
  const ReadType read(
      R"("bus": { "types": ["i2c"], "required": true, "max_clock": "400kHz",
                  "address": { "default": "0x76", "allowed": ["0x76", "0x77"] } })");
  CHECK(read.said().empty());
  CHECK(read.type.buses == std::vector<BusKind>{BusKind::i2c});
  CHECK(read.type.bus_required);
  CHECK(read.type.needs_address);
  CHECK(read.type.default_address == 0x76);
  CHECK(read.type.addresses == std::vector<std::uint32_t>{0x76, 0x77});
  CHECK_FALSE(read.type.needs_id);
  CHECK(parse_hex("0x76") == 0x76);
}

TEST_CASE("interfaces of the runtime need no namespace, those of others keep theirs") {
  const ReadType read(R"("provides": [{ "interface": "Thruster", "command": true }, { "interface": "my::Grip" }])");
  REQUIRE(read.type.provides.size() == 2);
  CHECK(read.type.provides[0].cpp == "finemote::Thruster");
  CHECK(read.type.provides[0].state == "state");
  CHECK(read.type.provides[0].command == "command");
  CHECK(read.type.provides[1].cpp == "my::Grip");
  CHECK_FALSE(read.type.provides[1].has_command);
  CHECK(read.type.has_command());  // as the first one says
}

TEST_CASE("a role without max takes any number") {
  const ReadType read(
      R"("roles": [{ "name": "a", "interface": "any", "min": 0, "max": null }, { "name": "b", "interface": "Imu", "min": 1, "max": 1 }])");
  REQUIRE(read.type.roles.size() == 2);
  CHECK(read.type.roles[0].min == 0);
  CHECK_FALSE(read.type.roles[0].max);
  CHECK(read.type.roles[1].max == 1U);
  CHECK(read.type.roles[0].passes);
}

TEST_CASE("times are kept in ns, whatever unit they are written in") {
  const ReadParam read(R"("type": "int", "unit": "ns", "range": ["1ms", "2s"], "default": "20ms")");
  CHECK(read.said().empty());
  CHECK(read.spec().unit == Unit::time_ns);
  CHECK(read.spec().min == 1e6);
  CHECK(read.spec().max == 2e9);
  CHECK(read.spec().fallback == ParamValue{std::int64_t{20'000'000}});
  CHECK(std::get<ParamValue>(parse_param(read.spec(), "1.5ms")) == ParamValue{std::int64_t{1'500'000}});
  CHECK(std::get<ParamValue>(parse_param(read.spec(), "1500us")) == ParamValue{std::int64_t{1'500'000}});
  CHECK(read.parsed("3s") == "FM3026");
  CHECK(read.parsed("3m").rfind("FM303", 0) == 0);
}

TEST_CASE("a param without default is required, and a value has the kind it is declared with") {
  const ReadParam real(R"("type": "float", "range": [-1, 1])");
  CHECK_FALSE(real.spec().fallback);
  CHECK(std::get<ParamValue>(parse_param(real.spec(), "0.25")) == ParamValue{0.25});
  CHECK(real.parsed("1.5") == "FM3026");
  CHECK(real.parsed("much") == "FM3025");
  const ReadParam truth(R"("type": "bool", "default": true)");
  CHECK(truth.spec().fallback == ParamValue{true});
  CHECK(std::get<ParamValue>(parse_param(truth.spec(), "false")) == ParamValue{false});
}

TEST_CASE("contradictions are shown at the member that makes them") {
  const ReadType twice(
      "\"roles\": [{ \"name\": \"a\", \"interface\": \"any\" },\n    { \"name\": \"a\", \"interface\": \"any\" }]");
  INFO(twice.said());
  CHECK(twice.says("probe.json:4:"));
  CHECK(twice.says("error[FM3103]"));
  const ReadType crossed(R"("roles": [{ "name": "a", "interface": "any", "min": 3, "max": 2 }])");
  INFO(crossed.said());
  CHECK(crossed.says("probe.json:3:"));
  CHECK(crossed.says("error[FM3103]"));
  const ReadParam outside(R"("type": "int", "range": [1, 5], "default": 9)");
  INFO(outside.said());
  CHECK(outside.says("probe.json:3:"));
  CHECK(outside.says("error[FM3103]"));
}

TEST_CASE("a value is found again in the text it came from; what is not there, at what would hold it") {
  const SourceFile file{"a.json", "", "{\n  \"a\": [1,\n    { \"b\": 22 }]\n}\n"};
  const Extent b = find_value(file, {"a", "1", "b"});
  CHECK(b.at.line == 3);
  CHECK(b.at.column == 12);
  CHECK(b.length == 2);
  const Extent missing = find_value(file, {"a", "1", "c"});
  CHECK(missing.at.line == 3);
}

TEST_CASE("the clock of a part is as good as is usual, or as its descriptor says; frames come once for each sample") {
  const std::string sent = R"("frames": [{ "stage": "autonomous", "read": 8 }, { "stage": "autonomous", "read": 2,
      "min_interval_ns": 9000000 }], "acquisition": { "model": "streamed", "interval_ns": 5000000)";
  const ReadType usual(sent + " }"), other(sent + R"(, "tolerance_ppm": 400 })");
  CHECK(usual.said().empty());
  CHECK(usual.type.clock_ppm() == 10'000);
  CHECK(other.type.clock_ppm() == 400);
  CHECK(ReadType().type.clock_ppm() == 10'000);
  REQUIRE(usual.type.frames);
  CHECK(usual.type.says_interval_of(usual.type.frames->at(0)));
  CHECK(usual.type.says_interval_of(usual.type.frames->at(1)));
}

TEST_CASE("the interval of samples is fixed or the value of a param that is a time") {
  const std::string sent = R"("frames": [{ "stage": "autonomous", "read": 8 }],
      "params": [{ "name": "rate", "type": "int", "unit": "ns", "range": ["1ms", "1s"], "default": "5ms" },
                 { "name": "none", "type": "int", "unit": "ns", "range": ["0ns", "1s"], "default": "5ms" },
                 { "name": "size", "type": "int", "range": [1, 9], "default": 5 }],
      "acquisition": { "model": "streamed", "interval_param": )";
  const ReadType good(sent + R"("rate" })");
  CHECK(good.said().empty());
  REQUIRE(good.type.frames);
  CHECK(good.type.says_interval_of(good.type.frames->front()));
  CHECK(ReadType(sent + R"("pace" })").says("there is no param 'pace'"));
  CHECK(ReadType(sent + R"("none" })").says("param 'none' can be no interval"));
  CHECK(ReadType(sent + R"("size" })").says("param 'size' can be no interval"));
  CHECK(ReadType(sent + R"("rate", "interval_ns": 5000000 })").says("not both"));
}

TEST_CASE("samples that come more often than any frame are a contradiction") {
  const ReadType type(R"("frames": [{ "stage": "autonomous", "read": 8, "min_interval_ns": 6000000 }],
      "acquisition": { "model": "streamed", "interval_ns": 5000000 })");
  INFO(type.said());
  CHECK(type.says("FM3103"));
  CHECK(type.says("no frame comes every 5000000 ns: they are at least 6000000 ns apart"));
}

TEST_CASE("the clock of a board is a crystal's, or as its file says") {
  ShippedLibrary shipped;
  CHECK(shipped.board("robomaster_type_c").clock_ppm == 50);
  CHECK(Board().clock_ppm == 50);
}

TEST_CASE("a pin is a port and a number, spelled in one way only") {
  CHECK(parse_pin("PA9") == PinName{'A', 9});
  CHECK(pin_name("PI15") == PinName{'I', 15});
  CHECK(pin_name("PI15").text() == "PI15");
  CHECK(pin_name("PI15").initializer() == "{'I', 15}");
  for (const char* other : {"", "PA", "PA16", "PA09", "PA+1", "PA-1", "PA9 ", "PJ0", "pa9", "A9"}) {
    CAPTURE(other);
    CHECK_FALSE(parse_pin(other));
    CHECK_THROWS_AS(pin_name(other), std::invalid_argument);
  }
}

TEST_CASE("a board that extends another has all it does not say itself from there") {
  ShippedLibrary shipped;
  const Board& host = shipped.board("host");
  const Board& real = shipped.board("robomaster_type_c");
  CHECK(host.name == "host");
  CHECK(host.ports.size() == real.ports.size());
  CHECK(host.lines.size() == real.lines.size());
  CHECK(real.has_watchdog);
  CHECK_FALSE(host.has_watchdog);  // null takes a member away
}

TEST_CASE("the ports of a board name what they occupy, and its spare lines what buckets run in") {
  ShippedLibrary shipped;
  const Board& board = shipped.board("robomaster_type_c");
  CHECK(board.port("usart9") == nullptr);
  const Port* port = board.port("usart1");
  REQUIRE(port != nullptr);
  CHECK(port->kinds.front() == BusKind::uart);
  std::size_t pins = 0;
  for (const Resource& resource : port->resources) pins += resource.kind == "pin";
  CHECK(pins == port->pins.size());
  CHECK(board.first_bucket_level < board.last_bucket_level);
  for (const SpareLine& line : board.lines) {
    for (const ForbiddenLine& forbidden : board.forbidden_lines) CHECK(line.number != forbidden.number);
  }
}

TEST_CASE("shipped types and boards are read without a word, once") {
  ShippedLibrary shipped;
  for (const std::string& name : device_type_names(*shipped.library)) {
    const DeviceType& type = shipped.type(name);
    CHECK(type.name == name);
    CHECK(&shipped.type(name) == &type);
    CHECK_FALSE(type.summary.empty());
  }
  for (const std::string& name : board_names(*shipped.library)) CHECK(shipped.board(name).name == name);
  CHECK(find_device_type(*shipped.library, "no_such_type", shipped.sources, shipped.diagnostics) == nullptr);
  INFO(render_text(shipped.diagnostics, false));
  CHECK(shipped.diagnostics.size() == 0);
}
