// finemote: from a robot description to firmware.
#include <iostream>
#include <map>
#include <new>
#include <string>
#include <vector>

#ifdef __GLIBC__  // known once a header of the library was read
#include <malloc.h>
#endif

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/sandbox.hpp"
#include "generator/diagnostic/render.hpp"

namespace {

using namespace finemote::gen;

int run(const Options& options) {
  static const std::map<std::string, int (*)(Context&)> kCommands{
      {"generate", run_generate},
      {"check", run_check},
      {"tree", run_tree},
      {"board show", run_board_show},
      {"run", run_run},
      {"diff", run_diff},
      {"docs", run_docs},
      {"explain", run_explain},
      {"lint", run_lint},
      {"schema", run_schema},
      {"xacro", run_xacro_command},
      {"analyze", run_analyze_command},
      {"simulate", run_simulate_command},
  };
  Diagnostics diagnostics;
  Sources sources(read_access(options, diagnostics));
  Context context{options, sources, diagnostics, std::cout, std::cerr};
  if (diagnostics.has_errors()) return finish(context, kExitInvalid);
  if (!options.sandbox) return kCommands.at(options.command)(context);
  bound_resources();
  try {
    return kCommands.at(options.command)(context);
  } catch (const std::bad_alloc&) {
    report_memory_limit(diagnostics);
    return finish(context, kExitInvalid);
  }
}

/// The tool lives for milliseconds: memory comes from the system in few large pieces, one pool for all threads.
void prepare_memory() {
#ifdef __GLIBC__
  constexpr int piece = 8 << 20;
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TOP_PAD, piece);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  prepare_memory();
  std::ios::sync_with_stdio(false);
  try {
    const ParsedCommandLine parsed = parse_command_line(std::vector<std::string>(argv + 1, argv + argc));
    if (parsed.options) return run(*parsed.options);
    (parsed.exit_status == kExitYes ? std::cout : std::cerr) << parsed.text;
    return parsed.exit_status;
  } catch (const std::exception& error) {
    Diagnostics diagnostics;
    diagnostics.error(code::internal, {}, std::string("internal error: ") + error.what())
        .hint("this is a defect of finemote; please report it with the input that shows it");
    std::cerr << render_text(diagnostics, false);
    return kExitInternal;
  }
}
