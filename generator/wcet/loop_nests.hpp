// The loops of all functions that a walk comes through.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "generator/image/program.hpp"
#include "generator/wcet/loop_nest.hpp"

namespace finemote::gen::wcet {

/// Looks for them once per function.
class LoopNests {
 public:
  const LoopNest& of(const ProgramFunction& function) {
    auto& nest = nests_[function.graph.entry];
    if (!nest) nest = std::make_unique<LoopNest>(function.graph);
    return *nest;
  }

 private:
  std::map<std::uint32_t, std::unique_ptr<LoopNest>> nests_;  // by entry
};

}  // namespace finemote::gen::wcet
