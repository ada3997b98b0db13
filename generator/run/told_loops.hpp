// Holds bounds of loops that the sources tell against what a run has counted.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/source_names.hpp"
#include "generator/wcet/marked_loops.hpp"

namespace finemote::gen {

/// `LoopBound<n>` or `retried_if_interrupted()` in an image, and where it stands in the sources.
struct ToldLoop {
  wcet::MarkedLoop loop;
  std::string function;  ///< readable
  std::string file;      ///< empty: the image does not tell
  int line = 0;
};

/// Of an Arm image. Reports FM6101 where it cannot be read.
std::vector<ToldLoop> told_loops(const std::string& image_path, const SourceNames& names, Diagnostics& diagnostics);

/// What the emulated board watches: emulator/program/job.cpp.
nlohmann::ordered_json watched_loops(const std::vector<ToldLoop>& loops);

/// Reports FM6014 for every loop that turned more often than its mark says: bounds made from that are not proven.
/// @param passes  most of each loop, as the run has counted them; of fewer loops: the others did not run
/// @return  whether there is none
bool check_loops(const std::vector<ToldLoop>& loops, const std::vector<std::uint64_t>& passes,
                 Diagnostics& diagnostics);

/// Of the document of a run.
nlohmann::ordered_json loop_list(const std::vector<ToldLoop>& loops, const std::vector<std::uint64_t>& passes);

}  // namespace finemote::gen
