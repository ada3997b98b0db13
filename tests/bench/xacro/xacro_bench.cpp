// Times the expansion of synthetic robots: many macro calls (growth has to be linear), and a robot of PR2's size in
// many files. Prints one line per input; where ROS xacro is installed, its time stands beside.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "generator/diagnostic/render.hpp"
#include "generator/xacro/expand_file.hpp"

namespace {

namespace fs = std::filesystem;
namespace xacro = finemote::gen::xacro;

/// Processor time used so far, by this process or by its finished children.
double used_ms(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto ms = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) / 1e3;
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// `calls` calls with expressions, a default, a block, a condition and a nested macro each.
std::string many_calls(int calls) {
  std::string text = R"(<robot name="bench" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="base" value="0.25"/>
  <xacro:macro name="inertia" params="m r">
    <inertial><mass value="${m}"/><inertia ixx="${m*r*r/2}" iyy="${m*r**2/2}" izz="${m*r*r}"/></inertial>
  </xacro:macro>
  <xacro:macro name="part" params="name n mass:=${base*4} *origin">
    <link name="${name}_link"><xacro:inertia m="${mass}" r="${base + n*0.001}"/></link>
    <xacro:if value="${n % 2 == 0}"><joint name="${name}_joint" type="fixed"><xacro:insert_block name="origin"/>
      <parent link="base"/><child link="${name}_link"/></joint></xacro:if>
  </xacro:macro>
)";
  for (int i = 0; i < calls; ++i) {
    text += fmt::format("  <xacro:part name=\"p{0}\" n=\"{0}\"><origin xyz=\"0 0 ${{{0}*base}}\"/></xacro:part>\n", i);
  }
  return text + "</robot>\n";
}

/// About 90 links in 40 files, each with macros, properties and a YAML file read once.
void write_robot(const fs::path& folder) {
  constexpr int files = 40;
  std::string top =
      "<robot name=\"big\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
      "<xacro:property name=\"limits\" value=\"${xacro.load_yaml('limits.yaml')}\"/>\n";
  std::string limits;
  for (int i = 0; i < files; ++i) {
    limits += fmt::format("joint_{}: {{lower: !degrees -90, upper: 1.57, effort: {}}}\n", i, 10 + i);
    top += fmt::format("<xacro:include filename=\"part_{}.xacro\"/>\n", i);
    std::string part = "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";
    for (int k = 0; k < 30; ++k)
      part += fmt::format("<xacro:property name=\"p_{0}_{1}\" value=\"${{{1}*pi/180}}\"/>\n", i, k);
    part += fmt::format("<xacro:macro name=\"part_{}\" params=\"side reflect:=1 *origin\">\n", i);
    for (int k = 0; k < 12; ++k) {
      part += fmt::format(
          "<gazebo reference=\"${{side}}_{0}_{1}\"><mu v=\"${{p_{0}_{1}*reflect}}\"/><kp>1000.0</kp></gazebo>\n", i, k);
    }
    part += fmt::format(
        "<link name=\"${{side}}_link_{0}\"/><joint name=\"${{side}}_joint_{0}\" type=\"revolute\">"
        "<xacro:insert_block name=\"origin\"/><limit lower=\"${{limits.joint_{0}.lower}}\" "
        "upper=\"${{limits['joint_{0}']['upper']}}\"/></joint></xacro:macro>\n</robot>\n",
        i);
    write(folder / fmt::format("part_{}.xacro", i), part);
    top += fmt::format(
        "<xacro:part_{0} side=\"r\" reflect=\"-1\"><origin xyz=\"0 ${{0.1*{0}}} 0\"/></xacro:part_{0}>"
        "<xacro:part_{0} side=\"l\"><origin xyz=\"0 0 0\"/></xacro:part_{0}>\n",
        i);
  }
  write(folder / "limits.yaml", limits);
  write(folder / "robot.xacro", top + "</robot>\n");
}

/// Median time of a few runs.
template <typename Work>
double median_ms(int runs, int who, Work work) {
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    const double begin = used_ms(who);
    work();
    times.push_back(used_ms(who) - begin);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

bool has_ros_xacro() { return std::system("command -v xacro > /dev/null 2>&1") == 0; }

void bench(const std::string& label, const fs::path& file, int runs, bool with_ros) {
  std::size_t bytes = 0;
  const double ours = median_ms(runs, RUSAGE_SELF, [&] {
    finemote::gen::Sources sources;
    finemote::gen::Diagnostics diagnostics;
    const auto expanded = xacro::expand_file(file.string(), {}, {}, sources, diagnostics);
    bytes = expanded ? expanded->document.size() : 0;
    if (!expanded) std::cerr << finemote::gen::render_text(diagnostics, false);
  });
  std::cout << fmt::format("{:<28} {:>10.2f} ms {:>12} bytes", label, ours, bytes);
  if (with_ros && has_ros_xacro()) {
    const std::string command = "xacro '" + file.string() + "' > /dev/null";
    const double theirs = median_ms(1, RUSAGE_CHILDREN, [&] { return std::system(command.c_str()); });
    std::cout << fmt::format("   ROS xacro {:>10.2f} ms   factor {:.0f}", theirs, theirs / ours);
  }
  std::cout << '\n';
}

}  // namespace

int main() {
  const fs::path folder = fs::temp_directory_path() / "finemote_xacro_bench";
  fs::create_directories(folder);
  write_robot(folder);
  bench("robot of 80 links, 40 files", folder / "robot.xacro", 9, true);
  for (const int calls : {1'000, 2'000, 5'000, 10'000, 20'000}) {
    const fs::path file = folder / fmt::format("calls_{}.xacro", calls);
    write(file, many_calls(calls));
    bench(fmt::format("{} macro calls", calls), file, 3, calls <= 1'000);
  }
  fs::remove_all(folder);
  return 0;
}
