#include "generator/image/program.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace finemote::gen {
namespace {

/// Ways lead from a call of the second back to after a call of the first, which no graph of a function has.
bool is_long_jump(const std::string& name) {
  return name == "setjmp" || name == "_setjmp" || name == "longjmp" || name == "_longjmp";
}

}  // namespace

Program::Program(const Image& image, std::vector<std::uint32_t> boundaries)
    : image_(image), boundaries_(std::move(boundaries)) {
  for (const ImageSymbol& symbol : image.symbols) {
    if (symbol.kind != ImageSymbol::Kind::function || symbol.section == 0 || functions_.count(symbol.address) != 0)
      continue;
    functions_.try_emplace(symbol.address, ProgramFunction{&symbol, FunctionBody(image, symbol), {}, false, true});
  }
  trace_all();
  for (auto& [address, function] : functions_) {
    const std::string& name = function.symbol->name;
    if (is_long_jump(name))
      function.graph.problems.push_back({address, "a jump back to a function that waits in 'setjmp'"});
  }
}

/// A least fixed point: at first no function returns, then those do that reach a return without a call of one that
/// does not.
void Program::trace_all() {
  while (trace_again() || add_entries()) {}
}

/// libgcc jumps from one routine into the middle of another, which returns for both. True where one was added.
bool Program::add_entries() {
  std::set<std::uint32_t> entries;
  for (const auto& [address, function] : functions_) {
    for (const auto& [begin, block] : function.graph.blocks) {
      if (block.call && block.call->is_tail && block.call->target && at(*block.call->target) == nullptr)
        entries.insert(*block.call->target);
    }
  }
  bool is_one_new = false;
  for (const std::uint32_t entry : entries) {
    const ImageSymbol* symbol = around(entry);
    if (symbol == nullptr) continue;
    const FunctionBody& body = functions_.at(symbol->address).body;
    if (body.at(entry) == nullptr) continue;
    functions_.try_emplace(entry, ProgramFunction{symbol, body, {}, false, true});
    boundaries_.insert(std::upper_bound(boundaries_.begin(), boundaries_.end(), entry), entry);
    for (auto& [address, function] : functions_) function.is_cut |= function.body.contains(entry);
    is_one_new = true;
  }
  return is_one_new;
}

/// What is left of a function has the blocks that the whole has.
std::vector<std::uint32_t> Program::boundaries_of(std::uint32_t entry, const ProgramFunction& function) const {
  std::vector<std::uint32_t> all = boundaries_;
  if (entry == function.symbol->address) return all;
  for (const auto& [begin, block] : functions_.at(function.symbol->address).graph.blocks) all.push_back(begin);
  std::sort(all.begin(), all.end());
  return all;
}

/// The function in which it lies, or null.
const ImageSymbol* Program::around(std::uint32_t address) const {
  for (const auto& [begin, function] : functions_) {
    if (function.symbol->address == begin && function.body.contains(address)) return function.symbol;
  }
  return nullptr;
}

/// True where one more function was found to return.
bool Program::trace_again() {
  bool is_one_new = false;
  const auto call_returns = [this](const FlowCall& call) { return returns(call); };
  for (auto& [address, function] : functions_) {
    if (!function.is_cut) continue;
    function.graph = trace(image_, function.body, call_returns, {address, boundaries_of(address, function)});
    function.is_cut = is_cut(function.graph);
    if (function.returns || !function.graph.has_return(call_returns)) continue;
    function.returns = is_one_new = true;
  }
  return is_one_new;
}

/// Whether it ends at calls of functions of which no return is known: more is reached when they return.
bool Program::is_cut(const FlowGraph& graph) const {
  return std::any_of(graph.blocks.begin(), graph.blocks.end(),
                     [this](const auto& entry) { return entry.second.call && !returns(*entry.second.call); });
}

const ProgramFunction* Program::at(std::uint32_t address) const {
  const auto found = functions_.find(address);
  return found == functions_.end() ? nullptr : &found->second;
}

bool Program::returns(const FlowCall& call) const {
  const ProgramFunction* callee = call.target ? at(*call.target) : nullptr;
  return callee == nullptr || callee->returns;
}

}  // namespace finemote::gen
