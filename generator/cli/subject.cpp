#include "generator/cli/subject.hpp"

#include <fmt/format.h>

#include "generator/cli/robot_input.hpp"
#include "generator/input/input.hpp"
#include "generator/input/read_document.hpp"
#include "generator/timing/read_model.hpp"
#include "generator/units/units.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

std::optional<Subject> read_timing_model(const std::string& path, Sources& sources, Diagnostics& diagnostics) {
  const SourceFile* file = xml::read_source(path, sources, diagnostics);
  if (file == nullptr) return std::nullopt;
  auto model = timing::read_model(*file, diagnostics);
  if (!model || diagnostics.has_errors()) return std::nullopt;
  return Subject{std::move(*model), {}, std::nullopt};
}

}  // namespace

std::optional<Subject> read_subject(const Options& options, const timing::RobotTimingOptions& robot_options,
                                    Sources& sources, Diagnostics& diagnostics) {
  if (is_timing_model(options.input)) {
    if (refuse_arguments(options.input, options.arguments, diagnostics)) return std::nullopt;
    return read_timing_model(options.input, sources, diagnostics);
  }
  const auto input = input_of(options, diagnostics);
  if (!input) return std::nullopt;
  auto planned = plan_robot(*input, sources, diagnostics);
  if (!planned) return std::nullopt;
  const auto& [robot, forest, schedule] = planned->plan();
  auto model = timing::make_timing_model(robot, forest, schedule, diagnostics, robot_options);
  if (!model) return std::nullopt;
  return Subject{std::move(*model), timing::timing_requirements(robot, forest), std::move(planned)};
}

std::optional<Duration> time_option(const char* option, const std::string& text, const char* example,
                                    Diagnostics& diagnostics) {
  if (text.empty()) return std::nullopt;
  const auto parsed = units::parse_duration(text);
  if (parsed && *parsed > Duration::zero()) return *parsed;
  diagnostics.error(code::usage, {}, fmt::format("{} must be a time greater than zero, got '{}'", option, text))
      .hint(fmt::format("write for example {} {}", option, example));
  return std::nullopt;
}

std::optional<Duration> duration_option(const Options& options, const char* example, const char* gone_through,
                                        Diagnostics& diagnostics) {
  constexpr Duration kLongest = seconds(86'400);
  const auto duration = time_option("--duration", options.duration, example, diagnostics);
  if (!duration || *duration <= kLongest) return duration;
  diagnostics
      .error(code::usage, {},
             fmt::format("--duration is too long: '{}'; every {} of that time is simulated", options.duration,
                         gone_through))
      .hint(fmt::format("write at most {}", units::format_duration(kLongest)));
  return std::nullopt;
}

std::optional<timing::Profile> profile_option(const std::string& name, Diagnostics& diagnostics) {
  if (name.empty()) return std::nullopt;
  for (const timing::Profile profile : {timing::Profile::paper, timing::Profile::tight, timing::Profile::target}) {
    if (timing::profile_name(profile) == name) return profile;
  }
  diagnostics.error(code::usage, {}, fmt::format("there is no profile '{}'", name))
      .hint("valid here: 'paper', 'tight', 'target'");
  return std::nullopt;
}

}  // namespace finemote::gen
