#include "errors/pipeline.hpp"

#include <stdexcept>

#include "generator/diagnostic/render.hpp"
#include "generator/emit/bounds.hpp"
#include "generator/emit/render.hpp"
#include "generator/forest/forest.hpp"
#include "generator/lint/lint.hpp"
#include "generator/model/build.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/tasks/from_robot.hpp"
#include "generator/timing/analyse.hpp"
#include "generator/xacro/expand.hpp"
#include "generator/xml/parse.hpp"
#include "source_dir.hpp"

namespace finemote::gen {
namespace {

const std::string kSource = finemote::test::source_dir();

/// Every finding says what is wrong, and in which line.
bool is_explained(const Diagnostics& diagnostics) {
  for (const Diagnostic& finding : diagnostics.in_file_order()) {
    if (finding.at.file == nullptr || finding.at.line == 0 || finding.message.empty()) return false;
  }
  return true;
}

Outcome outcome(Outcome::Kind kind, const Diagnostics& diagnostics) {
  const bool must_explain = kind == Outcome::Kind::refused || kind == Outcome::Kind::unschedulable;
  const bool is_good = is_explained(diagnostics) && (!must_explain || diagnostics.has_errors());
  return {is_good ? kind : Outcome::Kind::unexplained, render_text(diagnostics, false), {}, {}};
}

std::optional<xml::Document> read(const SourceFile& file, bool is_xacro, Sources& sources, Diagnostics& diagnostics) {
  if (!is_xacro) return xml::parse(file, diagnostics);
  xacro::Dependencies dependencies;
  return xacro::expand(file, {}, {}, sources, diagnostics, dependencies, nullptr);
}

}  // namespace

Pipeline::Pipeline(const std::string& folder, std::vector<std::string> device_paths)
    : library_(load_library({kSource, folder, std::move(device_paths), {}}, library_sources_, library_diagnostics_)) {
  if (!library_) throw std::runtime_error(render_text(library_diagnostics_, false));
}

const DeviceType* Pipeline::device_type(std::string_view name) {
  return find_device_type(*library_, name, library_sources_, library_diagnostics_);
}

Outcome Pipeline::run(const std::string& text, bool is_xacro) {
  Sources sources;
  Diagnostics diagnostics;
  const SourceFile* file = sources.add(SourceFile{"mutant.urdf", "", text});
  const auto document = read(*file, is_xacro, sources, diagnostics);
  if (!document) return outcome(Outcome::Kind::refused, diagnostics);
  ModelOptions options;
  options.from_xacro = is_xacro;
  const auto robot = build_model(*document, *library_, options, sources, diagnostics);
  if (!robot) return outcome(Outcome::Kind::refused, diagnostics);

  const Forest forest = build_forest(*robot);
  const Schedule schedule = plan_schedule(*robot, forest, diagnostics);
  if (diagnostics.has_errors()) return outcome(Outcome::Kind::refused, diagnostics);
  timing::AnalysisRequest request;
  request.requirements = timing::timing_requirements(*robot, forest);
  request.inputs = true;
  const auto model = timing::make_timing_model(*robot, forest, schedule, diagnostics);
  const auto timing = model ? timing::analyse(*model, request, diagnostics) : std::nullopt;
  if (!timing) return outcome(Outcome::Kind::refused, diagnostics);

  Diagnostics findings;
  lint(*robot, {}, findings);
  const ProvenBounds bounds{timing::robot_bounds(timing, forest, schedule),
                            timing::instrumented_bounds(*robot, forest, schedule)};
  Diagnostics rendering;
  auto files = render_files({*robot, forest, schedule}, bounds, kSource, rendering);
  if (rendering.has_errors()) return outcome(Outcome::Kind::refused, rendering);
  if (findings.has_errors()) return outcome(Outcome::Kind::refused, findings);
  if (files.empty() || !is_explained(findings)) return outcome(Outcome::Kind::unexplained, findings);
  const bool is_good = timing->schedulable && timing->requirements_hold();
  Outcome result = outcome(is_good ? Outcome::Kind::generated : Outcome::Kind::unschedulable, diagnostics);
  result.files = std::move(files);
  result.space = robot->name.cpp;
  return result;
}

}  // namespace finemote::gen
