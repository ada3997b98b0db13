// Compiles generated sources the way their users do: for this computer, and for the Type C board.
#pragma once

#include <string>
#include <vector>

namespace finemote::test {

/// A compiler with everything that does not depend on the robot: target, standard, warnings as errors, the runtime.
struct Compiler {
  std::string name;
  std::vector<std::string> command;
};

/// The one for this computer, and the one for the board with the flags of its firmware. A missing cross compiler is
/// left out, and said on stderr.
std::vector<Compiler> compilers();

/// What the compiler says of one source; empty: it compiles. Code is made as far as assembly, so that warnings of later
/// passes are heard; nothing is written.
std::string complaint(const Compiler& compiler, const std::string& source, const std::vector<std::string>& includes);

/// The same for every .cpp below a folder that `generate` wrote, each by itself; the first complaint.
std::string complaint_about(const Compiler& compiler, const std::string& generated,
                            const std::vector<std::string>& includes = {});

}  // namespace finemote::test
