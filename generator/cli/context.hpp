// What every command works with: the options, the texts read, the findings, and where to print.
#pragma once

#include <ostream>

#include "generator/cli/options.hpp"
#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

struct Context {
  const Options& options;
  Sources& sources;
  Diagnostics& diagnostics;
  std::ostream& out;  ///< the result
  std::ostream& err;  ///< diagnostics as text, summaries
};

}  // namespace finemote::gen
