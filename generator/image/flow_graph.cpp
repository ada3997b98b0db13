#include "generator/image/flow_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/image/branch_table.hpp"
#include "generator/image/successors.hpp"
#include "generator/image/transfer.hpp"

namespace finemote::gen {
namespace {

using Returns = std::function<bool(const FlowCall&)>;

class Trace {
 public:
  Trace(const Image& image, const FunctionBody& body, const Returns& returns, std::uint32_t entry)
      : image_(image), body_(body), returns_(returns), entry_(entry) {}

  /// Follows all instructions; tables once what leads to them is known.
  void follow() {
    if (body_.at(entry_) == nullptr) {
      problems_[entry_] = "begins with data";
      return;
    }
    reach(entry_);
    do follow_open();
    while (resolve_tables());
    confirm_tables();
  }

  FlowGraph blocks(const std::vector<std::uint32_t>& boundaries) {
    refuse_tails_of_parts();
    FlowGraph graph;
    graph.entry = entry_;
    std::set<std::uint32_t> begins = begins_of_blocks(boundaries);
    for (const std::uint32_t begin : begins) {
      BasicBlock block = block_from(begin, begins);
      graph.blocks.emplace(begin, std::move(block));
    }
    for (const auto& [address, text] : problems_) graph.problems.push_back({address, text});
    return graph;
  }

 private:
  void reach(std::uint32_t address) {
    if (reached_.insert(address).second) open_.push_back(address);
  }

  void go(std::uint32_t from, Successor successor) {
    if (body_.at(successor.to) == nullptr) {
      problems_[from] = "goes on in data";
      return;
    }
    successors_.add(from, successor);
    reach(successor.to);
  }

  void follow_open() {
    while (!open_.empty()) {
      const std::uint32_t address = open_.back();
      open_.pop_back();
      follow_from(*body_.at(address));
    }
  }

  void follow_from(const Instruction& i) {
    const Transfer transfer = transfer_of(i);
    switch (transfer.kind) {
      case Transfer::Kind::jump:
        if (body_.contains(transfer.target))
          go(i.address, {transfer.target, true});
        else
          calls_[i.address] = {i.address, transfer.target, true};
        break;
      case Transfer::Kind::call:
        if (is_part(transfer.target)) return call_part(i, transfer.target);
        calls_[i.address] = {i.address, transfer.target, false};
        break;
      case Transfer::Kind::indirect:
      case Transfer::Kind::tail:
        calls_[i.address] = {i.address, std::nullopt, transfer.kind == Transfer::Kind::tail};
        break;
      case Transfer::Kind::table:
        tables_.try_emplace(i.address);
        break;
      case Transfer::Kind::unknown:
        problems_[i.address] = i.is_known() ? fmt::format("'{}' jumps to an unknown place", i.text)
                                            : "an instruction that the decoder does not know";
        break;
      case Transfer::Kind::leave:
        return_to_parts(i);
        break;
      case Transfer::Kind::next:
      case Transfer::Kind::stop:
        break;
    }
    if (transfer.may_fall_through && comes_back(i)) fall_from(i);
  }

  /// In the middle of the body, where no other function begins.
  [[nodiscard]] bool is_part(std::uint32_t address) const {
    return body_.contains(address) && address != body_.begin() && !image_.is_function(address);
  }

  void call_part(const Instruction& call, std::uint32_t part) {
    go(call.address, {part, true});
    behind_parts_.insert(call.end());
    for (const std::uint32_t from : returns_to_parts_) go(from, {call.end(), true});
    if (call.is_conditional()) fall_from(call);
  }

  /// Where the callee of a jump returns to is not looked for.
  void refuse_tails_of_parts() {
    if (behind_parts_.empty()) return;
    for (const auto& [address, call] : calls_) {
      if (call.is_tail) problems_[address] = "a jump to another function, in one of which a part is called";
    }
  }

  void return_to_parts(const Instruction& i) {
    returns_to_parts_.insert(i.address);
    for (const std::uint32_t behind : behind_parts_) go(i.address, {behind, true});
  }

  /// What follows is reached: no call ends here for good.
  [[nodiscard]] bool comes_back(const Instruction& i) const {
    const auto call = calls_.find(i.address);
    return call == calls_.end() || call->second.is_tail || i.is_conditional() || returns_(call->second);
  }

  /// After the last instruction of a function another begins that it is a part of: libgcc does that.
  void fall_from(const Instruction& i) {
    if (body_.contains(i.end()))
      go(i.address, {i.end(), false});
    else
      calls_[i.address] = {i.address, i.end(), true};
  }

  bool resolve_tables() {
    bool is_one_new = false;
    for (auto& [address, targets] : tables_) {
      if (targets) continue;
      targets = table_targets(image_, body_, *body_.at(address), successors_, entry_);
      is_one_new |= targets.has_value();
      for (const std::uint32_t target : targets.value_or(std::vector<std::uint32_t>{})) go(address, {target, true});
    }
    return is_one_new;
  }

  /// What was found later may lead around the comparison before a table.
  void confirm_tables() {
    for (const auto& [address, targets] : tables_) {
      if (!targets || table_targets(image_, body_, *body_.at(address), successors_, entry_) != targets)
        problems_[address] = "a branch table of unknown size";
    }
  }

  std::set<std::uint32_t> begins_of_blocks(const std::vector<std::uint32_t>& boundaries) const {
    std::set<std::uint32_t> begins;
    if (!reached_.empty()) begins.insert(entry_);
    for (const std::uint32_t address : reached_) {
      if (!ends_block(address)) continue;
      for (const Successor& successor : successors_.of(address)) begins.insert(successor.to);
    }
    for (const std::uint32_t boundary : boundaries) {
      if (reached_.count(boundary) != 0) begins.insert(boundary);
    }
    return begins;
  }

  bool ends_block(std::uint32_t address) const {
    const auto& next = successors_.of(address);
    const Instruction* i = body_.at(address);
    return next.size() != 1 || next.front().is_taken || calls_.count(address) != 0 || tables_.count(address) != 0 ||
           transfer_of(*i).kind == Transfer::Kind::leave;
  }

  BasicBlock block_from(std::uint32_t begin, const std::set<std::uint32_t>& begins) const {
    BasicBlock block{begin, begin, {}, {}, false};
    const Instruction* last = body_.at(begin);
    while (!ends_block(last->address) && begins.count(last->end()) == 0) last = body_.at(last->end());
    block.end = last->end();
    for (const Successor& successor : successors_.of(last->address))
      block.edges.push_back({successor.to, successor.is_taken});
    const auto call = calls_.find(last->address);
    if (call != calls_.end()) block.call = call->second;
    block.leaves = transfer_of(*last).kind == Transfer::Kind::leave;
    return block;
  }

  const Image& image_;
  const FunctionBody& body_;
  const Returns& returns_;
  const std::uint32_t entry_;
  std::set<std::uint32_t> behind_parts_, returns_to_parts_;
  Successors successors_;
  std::set<std::uint32_t> reached_;
  std::vector<std::uint32_t> open_;
  std::map<std::uint32_t, FlowCall> calls_;                                    // by their instructions
  std::map<std::uint32_t, std::optional<std::vector<std::uint32_t>>> tables_;  // none: not resolved yet
  std::map<std::uint32_t, std::string> problems_;
};

}  // namespace

bool FlowGraph::has_return(const Returns& returns) const {
  return std::any_of(blocks.begin(), blocks.end(), [&](const auto& entry) {
    const BasicBlock& block = entry.second;
    return block.leaves || (block.call && block.call->is_tail && returns(*block.call));
  });
}

FlowGraph trace(const Image& image, const FunctionBody& body, const Returns& returns, const TraceLimits& limits) {
  Trace tracing(image, body, returns, limits.entry);
  tracing.follow();
  return tracing.blocks(limits.boundaries);
}

}  // namespace finemote::gen
