// A folder of template files to the files of a user's project, which are theirs from then on.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/emit/render.hpp"

namespace finemote::gen {

/// What stands for `@key@`.
using Keys = std::map<std::string, std::string>;

/// `text` with every `@key@` replaced; other characters `@` stay. Throws std::logic_error for a key that `keys` lacks.
std::string fill_keys(const std::string& text, const Keys& keys);

/// Every file below `folder`, sorted by name; keys are filled in names and texts, and `dot_` at the start of a name
/// stands for a dot, so that the templates have no effect where they lie. Throws what fill_keys() throws, and
/// std::filesystem::filesystem_error for a folder or file that cannot be read.
std::vector<OutputFile> fill_folder(const std::string& folder, const Keys& keys);

}  // namespace finemote::gen
