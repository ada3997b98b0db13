// A linked image to the figures people ask for first.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/image_shares.hpp"

namespace finemote::gen {

struct ImageFacts {
  std::string sha256;                  ///< of what is flashed; of a host executable: of the file
  std::uint32_t flash = 0;             ///< bytes
  std::uint32_t ram = 0;               ///< bytes, without the stack
  std::uint32_t code_ram = 0;          ///< bytes of it that are code, copied to run there; `ram` does not have them
  std::optional<std::uint32_t> stack;  ///< proven worst case in bytes; none: not known
  std::uint32_t stack_reserved = 0;    ///< bytes
  std::vector<ImageShare> shares;      ///< of flash and RAM; empty of a host executable
};

/// Facts of an Arm image; of a host executable the hash alone. With an Arm image it also proves what the target code
/// promises: reports what check_image and worst_case_stack report.
std::optional<ImageFacts> image_facts(const std::string& path, bool is_arm, const Robot& robot,
                                      bool constructors_allowed, Diagnostics& diagnostics);

/// `flash`, `ram`, `code_ram` and `stack` in bytes: null where they are not known, as of a host executable.
nlohmann::ordered_json sizes_json(const ImageFacts& image);

}  // namespace finemote::gen
