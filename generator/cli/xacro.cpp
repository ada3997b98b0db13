// finemote xacro: the drop-in for ROS xacro.
#include "generator/xacro/command.hpp"

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/load.hpp"

namespace finemote::gen {

namespace {

xacro::XacroOptions request_of(Context& context) {
  const Options& options = context.options;
  xacro::XacroOptions request;
  request.input = options.input;
  request.arguments = xacro_arguments(options);
  request.output = options.out;
  request.only_dependencies = options.deps;
  request.in_order = options.in_order;
  request.verbosity = options.quiet ? 0 : options.verbosity + (options.verbose ? 1 : 0);
  request.packages = package_folders(context);
  request.access = context.sources.access();
  return request;
}

nlohmann::ordered_json document_of(const xacro::Expanded& expansion, const Options& options) {
  nlohmann::ordered_json document{{"schema", "finemote.xacro/1"}, {"dependencies", expansion.dependencies}};
  if (!options.out.empty()) document["output"] = options.out;
  if (options.out.empty() && !options.deps) document["document"] = expansion.document;
  return document;
}

}  // namespace

int run_xacro_command(Context& context) {
  const Options& options = context.options;
  const xacro::XacroOptions request = request_of(context);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  Diagnostics found;
  const auto expansion = xacro::expand_input(request, context.sources, found, context.err);
  // Nobody asks for warnings as errors and means not to hear of them.
  add_findings(options.warnings_are_errors ? found : xacro::heard(found, request), context.diagnostics);
  if (!expansion || is_refused(context)) return finish(context, kExitInvalid);
  const std::string text = xacro::result_text(*expansion, request);
  if (!options.out.empty()) xacro::write_output_file(options.out, text, context.diagnostics, context.sources);
  const int status = finish(context, kExitYes, document_of(*expansion, options));
  if (status == kExitYes && options.format == Format::text && options.out.empty()) context.out << text << std::flush;
  return status;
}

}  // namespace finemote::gen
