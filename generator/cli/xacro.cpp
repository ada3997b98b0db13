// finemote xacro: the drop-in for ROS xacro.
#include "generator/xacro/command.hpp"

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/load.hpp"

namespace finemote::gen {

int run_xacro_command(Context& context) {
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
  request.color = options.color == ColorMode::always;
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  return xacro::run_xacro(request, context.out, context.err);
}

}  // namespace finemote::gen
