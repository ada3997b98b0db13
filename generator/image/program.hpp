// All functions of an image with their control flow, calls that never return taken into account.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "generator/image/body.hpp"
#include "generator/image/flow_graph.hpp"
#include "generator/image/image.hpp"

namespace finemote::gen {

struct ProgramFunction {
  const ImageSymbol* symbol = nullptr;  ///< of which it is all, or what a jump from elsewhere into its middle leads to
  FunctionBody body;
  FlowGraph graph;
  bool returns = false;  ///< some path leads back to the caller
  bool is_cut = true;    ///< the graph ends at a call that does not return, as far as was known when it was made
};

class Program {
 public:
  /// `image` outlives it. Blocks end at the `boundaries`, too, which are in order and may lie anywhere.
  explicit Program(const Image& image, std::vector<std::uint32_t> boundaries = {});

  /// The function that begins there, or what is left of one into which others jump there; or null.
  [[nodiscard]] const ProgramFunction* at(std::uint32_t address) const;
  /// False where the callee is known and never returns.
  [[nodiscard]] bool returns(const FlowCall& call) const;
  /// By address.
  [[nodiscard]] const std::map<std::uint32_t, ProgramFunction>& functions() const { return functions_; }

 private:
  void trace_all();
  bool trace_again();
  bool add_entries();
  [[nodiscard]] std::vector<std::uint32_t> boundaries_of(std::uint32_t entry, const ProgramFunction& function) const;
  [[nodiscard]] const ImageSymbol* around(std::uint32_t address) const;
  [[nodiscard]] bool is_cut(const FlowGraph& graph) const;

  const Image& image_;
  std::vector<std::uint32_t> boundaries_;
  std::map<std::uint32_t, ProgramFunction> functions_;
};

}  // namespace finemote::gen
