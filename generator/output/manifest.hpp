// finemote.manifest.json: what was read and written, with hashes; the memory of the output folder.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/emit/render.hpp"

namespace finemote::gen {

inline constexpr const char* kManifestName = "finemote.manifest.json";

struct HashedFile {
  std::string name;  ///< inputs: as in Robot::inputs; outputs: below the output folder
  std::string sha256;
  friend bool operator==(const HashedFile&, const HashedFile&) = default;
};

struct Manifest {
  std::string tool;   ///< `finemote 0.1.0`
  int format = 1;     ///< of the generated files
  std::string robot;  ///< two robots never share a folder
  /// What else the output depends on, as on the command line: `period:=20ms`, `--board qemu_f405`. Written only when
  /// there is any.
  std::vector<std::string> options;
  std::vector<HashedFile> inputs, outputs;
};

/// The bytes of the manifest file.
std::string manifest_text(const Manifest& manifest);

/// Reads a manifest's bytes; none when they are no manifest of a format this version knows, or name a file that
/// generate cannot have written: outside the folder, not in normal form, or the manifest itself.
std::optional<Manifest> parse_manifest(const std::string& text);

}  // namespace finemote::gen
