// The texts that were read, to the inputs of a manifest.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/source.hpp"
#include "generator/output/manifest.hpp"

namespace finemote::gen {

/// Every file that was read, named for the manifest (relative to the folder of the input, `package://` outside it,
/// `builtin:` for shipped data) and hashed as it is on disk; sorted by name.
std::vector<HashedFile> input_files(const Sources& sources, const std::string& input_folder,
                                    const std::string& data_dir);

}  // namespace finemote::gen
