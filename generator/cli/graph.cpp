// finemote graph: the device trees as a picture, or in a language of programs that draw graphs.
#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/graph/forest_svg.hpp"
#include "generator/graph/forest_text.hpp"

namespace finemote::gen {
namespace {

std::string drawn(GraphFormat format, const ForestView& view) {
  switch (format) {
    case GraphFormat::svg:
      return forest_svg(view);
    case GraphFormat::dot:
      return forest_dot(view);
    case GraphFormat::mermaid:
      return forest_mermaid(view);
  }
  return {};
}

}  // namespace

Answer run_graph(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const auto input = input_of(options, diagnostics);
  if (!input) return no_answer();
  const auto planned = plan_robot(*input, sources, diagnostics);
  if (!planned) return no_answer();
  Answer answer{kExitYes};
  answer.file = drawn(options.graph_format, view_of(planned->robot, planned->forest, planned->schedule));
  return answer;
}

}  // namespace finemote::gen
