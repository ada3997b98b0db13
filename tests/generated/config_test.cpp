// Params reach a Config by name: shipped defaults are those of the descriptors, and what does not fit does not compile.
#include <cstdlib>
#include <filesystem>

#include "catch.hpp"
#include "cli/program.hpp"
#include "generated/compiler.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/emit/value.hpp"

using namespace finemote;
using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

/// One static_assert per param: the member has the param's type, and in `Config{}` its default.
std::string assertions(const std::string& cpp_class, const std::vector<gen::ParamSpec>& params) {
  std::string text;
  for (const gen::ParamSpec& spec : params) {
    if (!spec.fallback) continue;
    const std::string member = cpp_class + "::Config{}." + spec.name;
    text += "static_assert(" + member + " == finemote::exact<decltype(" + member + ")>(" +
            gen::value_expression(spec, *spec.fallback) + "));\n";
  }
  return text;
}

/// A robot with one device of a user's type `probe`, whose class has this Config, in a folder of its own.
class Probe {
 public:
  Probe(const std::string& config, const std::string& params, const std::string& given = {}) {
    write_file(folder_.path("devices/probe.hpp"), R"(#pragma once
#include <finemote/contract.hpp>
#include <finemote/time.hpp>
namespace my {
enum class Mode { kQuick, kSlow };
class Probe {
 public:
  struct Config {
)" + config + R"(
  };
  constexpr explicit Probe(const Config& config) : config_(config) {}
  void update() { finemote::busy(config_.hold); }
  void handle() {}
  finemote::Stamp state;

 private:
  Config config_;
};
}  // namespace my
)");
    write_file(folder_.path("devices/probe.json"), R"({"schema": "finemote.device/1", "type": "probe", "summary": "p",
      "class": "my::Probe", "header": "probe.hpp", "params": [)" +
                                                       params + "]}");
    write_file(folder_.path("r.urdf"), R"(<robot name="r"><link name="l"/><finemote version="1">
      <board name="host"/><device name="probe" type="probe" period="10ms">)" +
                                           given + R"(</device></finemote></robot>)");
  }
  [[nodiscard]] std::string input() const { return folder_.path("r.urdf"); }

  /// What the first compiler says of the generated tree; empty: it compiles.
  [[nodiscard]] std::string said() const {
    const auto generated = run_finemote({"generate", input(), "-o", folder_.path("out")});
    INFO(generated.output);
    REQUIRE(generated.exit_status == 0);
    return complaint_about(compilers().front(), folder_.path("out"), {folder_.path("devices")});
  }

  [[nodiscard]] std::string header() const { return read_file(folder_.path("out/trees/probe.hpp")); }

  /// `probe.hpp:15`: the place of the line of the tree's header that assigns `member`.
  [[nodiscard]] std::string line_of(const std::string& member) const {
    const std::string header = this->header();
    const auto at = header.find("c." + member + " =");
    REQUIRE(at != std::string::npos);
    return "probe.hpp:" + std::to_string(std::count(header.begin(), header.begin() + static_cast<long>(at), '\n') + 1);
  }

 private:
  TemporaryFolder folder_;
};

const std::string kParams = R"({"name": "hold", "type": "int", "unit": "ns", "default": "50us"},
  {"name": "gain", "type": "float", "default": 0.5}, {"name": "count", "type": "int", "default": 3},
  {"name": "invert", "type": "bool", "default": true}, {"name": "label", "type": "string", "default": "a\"b\\"},
  {"name": "rate", "type": "int", "unit": "Hz", "default": "50Hz"},
  {"name": "mode", "type": "enum", "values": ["quick", "slow"], "default": "slow",
   "enumerators": {"quick": "my::Mode::kQuick", "slow": "my::Mode::kSlow"}})";
const std::string kConfig = R"(finemote::Duration hold; float gain; std::int32_t count; bool invert; const char* label;
    std::int64_t rate; Mode mode;)";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), with);
}

}  // namespace

TEST_CASE("Config{} of every shipped type is what its descriptor says") {
  gen::Sources sources;
  gen::Diagnostics diagnostics;
  auto library = gen::load_library({source_path(""), {}, {}, {}}, sources, diagnostics);
  REQUIRE(library);
  std::string text = "#include <finemote/config.hpp>\n#include <finemote/pca9685.hpp>\n", checks;
  std::size_t types = 0;
  for (const std::string& name : gen::device_type_names(*library)) {
    const gen::DeviceType* type = gen::find_device_type(*library, name, sources, diagnostics);
    REQUIRE(type != nullptr);
    text += "#include <" + type->include + ">\n";
    checks += assertions(type->cpp_class, type->params);
    if (!type->params.empty()) ++types;
  }
  for (const std::string& name : gen::expander_type_names(*library)) {
    const gen::ExpanderType* type = gen::find_expander_type(*library, name, sources, diagnostics);
    REQUIRE(type != nullptr);
    if (!type->cpp_class.empty()) checks += assertions(type->cpp_class, type->params);
  }
  CHECK(types >= 15);
  const TemporaryFolder folder;
  write_file(folder.path("defaults.cpp"), text + checks);
  for (const Compiler& compiler : compilers()) CHECK(complaint(compiler, folder.path("defaults.cpp"), {}) == "");
}

TEST_CASE("a user's Config is assigned by name, whatever the order of its members") {
  CHECK(Probe(kConfig, kParams).said() == "");
  CHECK(Probe("Mode mode; std::int64_t rate; const char* label; bool invert; int more = 4; std::int32_t count; "
              "float gain; finemote::Duration hold;",
              kParams)
            .said() == "");
  CHECK(Probe(kConfig, kParams, R"(<param name="count">-2147483648</param><param name="hold">0ns</param>)").said() ==
        "");
}

TEST_CASE("a text of a user's Config compiles, whatever it holds") {
  const auto with_label = [](const std::string& label) {
    return Probe(kConfig, kParams, "<param name=\"label\">" + label + "</param>").said();
  };
  CHECK(with_label("what?\?/ ?\?=define \\ \"%s\" */ // \\") == "");
  CHECK(with_label("\u202eabc \u00e4\u4e2d &#10;#error") == "");
  CHECK(with_label(std::string(65535, 'x')) == "");
}

TEST_CASE("a small number of a user's Config is no zero") {
  const Probe probe(kConfig, kParams, R"(<param name="gain">1e-30</param>)");
  CHECK(probe.said() == "");
  CHECK(probe.header().find("c.gain = finemote::exact<decltype(c.gain)>(1e-30f);") != std::string::npos);
}

TEST_CASE("a member that a user's Config lacks, or has of another type, is an error at the line that names it") {
  struct Change {
    const char *member, *what, *with;
  };
  const std::vector<Change> changes{{"hold", "Duration hold", "Duration held, hold_"},
                                    {"hold", "finemote::Duration hold", "std::int32_t hold"},
                                    {"hold", "finemote::Duration hold", "bool hold"},
                                    {"hold", "finemote::Duration hold", "float hold"},
                                    {"gain", "float gain", "int gain"},
                                    {"gain", "float gain", "bool gain"},
                                    {"gain", "float gain", "double gain"},
                                    {"count", "std::int32_t count", "bool count"},
                                    {"count", "std::int32_t count", "float count"},
                                    {"count", "std::int32_t count", "Mode count"},
                                    {"count", "std::int32_t count", "std::uint32_t count"},
                                    {"invert", "bool invert", "int invert"},
                                    {"label", "const char* label", "bool label"},
                                    {"rate", "std::int64_t rate", "std::int32_t rate"},
                                    {"mode", "Mode mode", "int mode"},
                                    {"mode", "Mode mode", "bool mode"}};
  for (const Change& change : changes) {
    INFO(change.what << " -> " << change.with);
    const Probe probe(replaced(kConfig, change.what, change.with), kParams);
    const std::string said = probe.said();
    CAPTURE(said);
    CHECK(said.find(probe.line_of(change.member)) != std::string::npos);
    CHECK(said.find(std::string(": error: ")) != std::string::npos);
  }
}

TEST_CASE("the descriptor's default counts, not the one of the user's class") {
  const Probe probe("finemote::Duration hold = 7 * finemote::kMillisecond;",
                    R"({"name": "hold", "type": "int", "unit": "ns", "default": "50us"})");
  const auto run = finemote_json({"run", probe.input(), "--board", "host", "--duration", "100ms"});
  CHECK(run["stages"][0]["stage"] == "update");
  CHECK(run["stages"][0]["max_ns"] >= 50'000);
  CHECK(run["stages"][0]["max_ns"] < 1'000'000);
}

TEST_CASE("sources of another generated format say what to do") {
  const Probe probe(kConfig, kParams);
  REQUIRE(probe.said().empty());
  const std::string buses = fs::path(probe.input()).parent_path() / "out/buses.hpp";
  const std::string text = read_file(buses);
  const auto at = text.find("kGeneratedFormat == ");
  REQUIRE(at != std::string::npos);
  write_file(buses, text.substr(0, at + 20) + "1" + text.substr(text.find(',', at)));
  const std::string out = fs::path(buses).parent_path();
  const std::string said = complaint_about(compilers().front(), out, {fs::path(out).parent_path() / "devices"});
  CHECK(said.find("static assertion failed: made for another version of the runtime: run `finemote generate`") !=
        std::string::npos);
}
