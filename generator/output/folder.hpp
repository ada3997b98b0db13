// The output folder as it is on disk, and the files it should hold.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/output/manifest.hpp"

namespace finemote::gen {

/// Everything one run would write: the sources, and the manifest that describes them.
struct Output {
  std::vector<OutputFile> files;
  Manifest manifest;
};

/// Hashes the rendered files and the inputs (names beside their bytes) into a manifest.
Output make_output(std::vector<OutputFile> files, std::vector<HashedFile> inputs, const std::string& robot);

/// The bytes of a file; none when there is no such regular file.
std::optional<std::string> read_bytes(const std::string& path);

/// The manifest in `folder`; none when there is none. Reports FM5001 for one that cannot be used, FM5002 when `folder`
/// or a file in it that we would write is a symbolic link or no folder, FM5003 when it belongs to another robot.
std::optional<Manifest> open_folder(const std::string& folder, const Output& output, Diagnostics& diagnostics);

}  // namespace finemote::gen
