// Robots for tests of what comes after the model: from a few elements, or an example, to the plan of their schedule.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "catch.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/forest/forest.hpp"
#include "generator/model/build.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"
#include "source_dir.hpp"

namespace finemote::gen {

/// A robot's file, from the top of the project: `examples/finsrov.urdf`.
struct RobotFile {
  std::string path;
};

struct RobotPlan {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Library> library;
  std::optional<Robot> robot;
  Forest forest;
  Schedule schedule;

  /// A Type C board with `inner` in its <finemote>; types of its own are those of tests/unit/devices.
  explicit RobotPlan(const std::string& inner) {
    load(*sources.add({"r.urdf", "",
                       "<robot name=\"r\"><link name=\"base\"/><finemote version=\"1\">"
                       "<board name=\"robomaster_type_c\"/>\n" +
                           inner + "</finemote></robot>\n"}),
         "tests/unit");
  }
  /// Types of its own are those beside the file.
  explicit RobotPlan(const RobotFile& robot_file) {
    const std::string path = finemote::test::source_dir() + "/" + robot_file.path;
    const SourceFile* file = xml::read_source(path, sources, diagnostics, robot_file.path);
    REQUIRE(file);
    load(*file, std::filesystem::path(robot_file.path).parent_path().string());
  }

  [[nodiscard]] std::string said() const { return render_text(diagnostics, false); }

  [[nodiscard]] const std::string& name(DeviceId device) const { return robot->devices[device].name.text; }
  /// The index of a device.
  [[nodiscard]] DeviceId device(const std::string& wanted) const {
    const auto found =
        std::find_if(forest.order.begin(), forest.order.end(), [&](DeviceId one) { return name(one) == wanted; });
    if (found == forest.order.end()) throw std::invalid_argument("no device " + wanted);
    return *found;
  }
  /// `imu baro rov`
  template <typename Devices>
  [[nodiscard]] std::string names(const Devices& devices) const {
    std::string all;
    for (const DeviceId device : devices) all += (all.empty() ? "" : " ") + name(device);
    return all;
  }

 private:
  /// @param folder  whose `devices` the robot can have, from the top of the project
  void load(const SourceFile& file, const std::string& folder) {
    library = load_library({finemote::test::source_dir(), finemote::test::source_dir() + "/" + folder, {}, {}}, sources,
                           diagnostics);
    REQUIRE(library);
    const auto document = xml::parse(file, diagnostics);
    REQUIRE(document);
    robot = build_model(*document, *library, {}, sources, diagnostics);
    INFO(said());
    REQUIRE(robot);
    forest = build_forest(*robot);
    schedule = plan_schedule(*robot, forest, diagnostics);
  }
};

}  // namespace finemote::gen
