// Whether a path lies below a folder.
#pragma once

#include <filesystem>
#include <optional>

namespace finemote::gen {

/// The path as seen from the folder; none if it does not lie below it. Compares names alone, both absolute and without
/// `..`: who has to follow links does so before.
inline std::optional<std::filesystem::path> inside(const std::filesystem::path& path,
                                                   const std::filesystem::path& folder) {
  const std::filesystem::path relative = path.lexically_relative(folder);
  return relative.empty() || *relative.begin() == ".." ? std::nullopt : std::optional(relative);
}

}  // namespace finemote::gen
