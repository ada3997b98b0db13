// Where the project lies whose tests run.
#pragma once

#include <string>

namespace finemote::test {

/// Absolute path of the project's top folder, without a slash at its end. One file alone knows it when it is compiled,
/// so that clones in other folders find all others in the compiler's cache.
std::string source_dir();

}  // namespace finemote::test
