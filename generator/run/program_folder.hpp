// Where this program lies: its data and its companion programs are beside it.
#pragma once

#include <filesystem>

namespace finemote::gen {

/// Folder of the running executable with all links resolved; empty where the system does not tell.
std::filesystem::path program_folder();

}  // namespace finemote::gen
