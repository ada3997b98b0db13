// A command analyses a robot once and hands the result to whatever asks for it: every call is counted here, by the
// model it is given.
#include <algorithm>
#include <set>

#include "catch.hpp"
#include "cli/program.hpp"
#include "generator/cli/commands.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/timing/json.hpp"

using namespace finemote::gen;
using finemote::test::source_path;

namespace {

std::vector<std::string> analysed;  ///< the models, as text

}  // namespace

// The linker puts the second in the place of timing::analyse for all other sources (--wrap in CMakeLists.txt).
std::optional<timing::Timing> analyse_really(const timing::Model& model, const timing::AnalysisRequest& request,
                                             Diagnostics& diagnostics) asm("__real_" ANALYSE_SYMBOL);
std::optional<timing::Timing> analyse_counted(const timing::Model& model, const timing::AnalysisRequest& request,
                                              Diagnostics& diagnostics) asm("__wrap_" ANALYSE_SYMBOL);

std::optional<timing::Timing> analyse_counted(const timing::Model& model, const timing::AnalysisRequest& request,
                                              Diagnostics& diagnostics) {
  analysed.push_back(timing::model_json(model).dump());
  return analyse_really(model, request, diagnostics);
}

TEST_CASE("analyze says by how many degrees a chain lags at a frequency, and refuses what is none") {
  Options options;
  options.command = "analyze";
  options.input = source_path("examples/finsrov.urdf");
  options.data_dir = source_path(".");
  options.format = Format::json;
  const auto ask = [&](const std::string& crossover, Diagnostics& diagnostics) {
    Sources sources;
    options.crossover = crossover;
    return command_named("analyze").run(options, sources, diagnostics);
  };
  Diagnostics diagnostics;
  const Answer answer = ask("0.8Hz", diagnostics);
  REQUIRE_FALSE(answer.document.at("chains").empty());
  for (const auto& chain : answer.document.at("chains")) {
    const double age_s = static_cast<double>(chain.at("end_to_end_ns").get<std::int64_t>()) * 1e-9;
    CHECK(chain.at("phase_lag").at("crossover_hz") == 0.8);
    CHECK(chain.at("phase_lag").at("age_deg").get<double>() == Approx(360 * 0.8 * age_s));
    CHECK(chain.at("phase_lag").at("hold_deg").get<double>() == Approx(360 * 0.8 * 0.005));  // half of 10 ms
  }
  CHECK_FALSE(ask("", diagnostics).document.at("chains").at(0).contains("phase_lag"));
  for (const char* wrong : {"2", "0Hz", "-1Hz", "2 s", "nanHz", "2kHz"}) {
    Diagnostics refused;
    CHECK(ask(wrong, refused).status == kExitInvalid);
    CHECK_THAT(render_text(refused, false), Catch::Contains("--crossover"));
  }
}

TEST_CASE("a command analyses the given robot once") {
  // The files hold the bounds of the firmware with monitor and trace, too: the one variant that is analysed.
  const auto [command, models] = GENERATE(std::pair("generate", 2), std::pair("check", 2), std::pair("lint", 1),
                                          std::pair("analyze", 1), std::pair("simulate", 1));
  const auto robot = GENERATE("examples/finsrov.urdf", "examples/infantry.urdf", "examples/user_device.urdf");
  INFO(command << " " << robot);
  const finemote::test::TemporaryFolder folder;
  Options options;
  options.command = command;
  options.input = source_path(robot);
  options.data_dir = source_path(".");
  options.out = folder.path("out");
  options.duration = "10ms";
  Sources sources;
  Diagnostics diagnostics;
  analysed.clear();
  const Answer answer = command_named(command).run(options, sources, diagnostics);
  INFO(render_text(diagnostics, false));
  CHECK(answer.status != kExitInvalid);
  CHECK(analysed.size() == static_cast<std::size_t>(models));
  CHECK(std::set<std::string>(analysed.begin(), analysed.end()).size() == analysed.size());
}
