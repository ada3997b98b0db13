// Robots for tests of their timing: from a URDF to the model the analysis is given.
#pragma once

#include "catch.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/forest/forest.hpp"
#include "generator/model/build.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/timing/analyse.hpp"
#include "generator/timing/from_robot.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen::timing {

struct Robots {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Library> library;
  std::optional<Robot> robot;
  Forest forest;
  Schedule schedule;
  timing::Model model;

  /// @param name  of a file, from the top of the project.
  explicit Robots(const std::string& name, const RobotTimingOptions& options = {}) {
    const SourceFile* file = xml::read_source(kSource + "/" + name, sources, diagnostics, name);
    REQUIRE(file);
    load(*file, options);
  }

  /// A Type C board with `inner` in its <finemote>.
  static Robots with(const std::string& inner) {
    return Robots(SourceFile{"r.urdf", "",
                             "<robot name=\"r\"><link name=\"base\"/><finemote version=\"1\">"
                             "<board name=\"robomaster_type_c\"/>\n" +
                                 inner + "</finemote></robot>\n"});
  }

  /// Place in the model.
  [[nodiscard]] std::size_t operator[](const std::string& name) const {
    for (std::size_t d = 0; d < model.devices.size(); ++d) {
      if (model.devices[d].name == name) return d;
    }
    FAIL("no device " << name);
    return 0;
  }

 private:
  explicit Robots(SourceFile text) { load(*sources.add(std::move(text)), {}); }

  void load(const SourceFile& file, const RobotTimingOptions& options) {
    library = load_library({kSource, kSource + "/examples", {}}, sources, diagnostics);
    REQUIRE(library);
    const auto document = xml::parse(file, diagnostics);
    REQUIRE(document);
    robot = build_model(*document, *library, {}, sources, diagnostics);
    INFO(render_text(diagnostics, false));
    REQUIRE(robot);
    forest = build_forest(*robot);
    schedule = plan_schedule(*robot, forest, diagnostics);
    model = make_timing_model(*robot, forest, schedule, options);
  }

  inline static const std::string kSource = FINEMOTE_SOURCE_DIR;
};

inline const ChainResult& chain(const Timing& timing, const std::string& from, const std::string& to) {
  for (const ChainResult& c : timing.chains) {
    if (timing.model.devices[c.from].name == from && timing.model.devices[c.to].name == to) return c;
  }
  FAIL("no chain " << from << " -> " << to);
  return timing.chains.front();
}

}  // namespace finemote::gen::timing
