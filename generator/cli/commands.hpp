// The commands of the tool; each returns its exit status.
#pragma once

#include "generator/cli/context.hpp"

namespace finemote::gen {

int run_generate(Context& context);
int run_check(Context& context);
int run_tree(Context& context);
int run_board_show(Context& context);
int run_board_sources(Context& context);
int run_run(Context& context);
int run_diff(Context& context);
int run_docs(Context& context);
int run_explain(Context& context);
int run_lint(Context& context);
int run_schema(Context& context);
int run_xacro_command(Context& context);
int run_analyze_command(Context& context);
int run_simulate_command(Context& context);

}  // namespace finemote::gen
