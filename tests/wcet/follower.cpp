#include "wcet/follower.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "generator/image/exception.hpp"

namespace finemote::test {
namespace {

using namespace gen::wcet;
using Kind = Passage::Kind;

/// What the costs of exceptions pay and no way of a routine does. Cortex-M4 TRM 3.9.1 and 7.2.3: seventeen words that
/// were left to save, and a cycle until the instruction goes on.
constexpr double kLazyStacking = 18;
/// In flash the first line of a routine, and that of what goes on after one: RM0090 table 10.
constexpr double kLine = 5;
constexpr double kMostSkipped = 4;  ///< of an IT block: the emulator charges them with the instruction after it
constexpr Cycles kNoEdge = -1;      // the way into a block is not one of the graph's

/// A wait under way: of its iterations the last two are on the way, all others are in its limit.
struct OpenWait {
  std::uint32_t header = 0;
  std::size_t first = 0, again = 0;  ///< nodes of the header in its first and in its second iteration
  std::vector<Cycles> begun;         ///< where the iterations on the way began, the last two at most
};

/// A place on the way and what led there.
struct Step {
  std::size_t node = 0;
  Cycles at = 0;
  unsigned disturbed = 0;
};

struct OpenBracket {
  Cycles way = 0;
  double own = 0, added = 0;
  unsigned disturbed = 0;
};

/// One run of a routine.
struct Level {
  unsigned exception = 0;
  const Routine* routine = nullptr;  ///< null: thread mode, or a routine without a bound
  bool is_lost = false;              ///< where it is is not in the graph
  std::size_t node = 0;
  Cycles way = 0;    ///< static cycles up to the start of the block
  double own = 0;    ///< emulated cycles since the first instruction
  double added = 0;  ///< cycles that others pay for: iterations that interrupts add
  bool has_begun = false;
  bool uses_float = false;
  bool is_high = false;    ///< the peripheral raised it, not software alone
  double block_begun = 0;  ///< `own` when the block began
  Cycles edge = 0;         ///< that led to it
  unsigned block_disturbed = 0;
  unsigned by_release = 0, by_others = 0;  ///< what has come in between
  std::map<RetriedBy, unsigned> retried;
  Countdown countdown;  ///< iterations that are left of it
  std::vector<Step> steps;
  std::vector<OpenWait> waits;
  std::map<std::uint32_t, OpenBracket> brackets;

  [[nodiscard]] unsigned disturbed() const { return by_release + by_others; }
};

class Follower {
 public:
  Follower(const Recording& recording, const Routes& routes) : recording_(recording), routes_(routes) {
    for (const auto& [address, function] : routes.prepared.program().functions()) {
      for (const auto& [begin, block] : function.graph.blocks) {
        if (has_float(function, block)) float_blocks_.insert(begin);
        const gen::Instruction* before = function.body.before(begin);
        if (before != nullptr && before->is_conditional()) behind_it_.insert(begin);
      }
    }
    levels_.push_back({});
  }

  Findings result() {
    for (const Passage& passage : recording_.passages) take(passage);
    return std::move(findings_);
  }

 private:
  static bool has_float(const gen::ProgramFunction& function, const gen::BasicBlock& block) {
    for (std::uint32_t at = block.begin; at < block.end;) {
      const gen::Instruction* i = function.body.at(at);
      if (i == nullptr) return false;
      if (!i->text.empty() && i->text.front() == 'v') return true;
      at = i->end();
    }
    return false;
  }

  void take(const Passage& passage) {
    levels_.back().own += static_cast<double>(passage.at - last_) / static_cast<double>(recording_.cycle);
    last_ = passage.at;
    switch (passage.kind) {
      case Kind::begin:
        return begin(passage);
      case Kind::first:
        return begin_way(passage.value);
      case Kind::block:
        levels_.back().is_high |= passage.is_high;  // it may rise after software did, while the routine runs
        return arrive(passage.value);
      case Kind::mark:
        return pass_mark(passage.value);
      case Kind::leave:
        return leave();
      case Kind::resume:
        if (levels_.size() > 1) levels_.pop_back();
        return;
    }
  }

  void begin(const Passage& passage) {
    if (passage.is_tail && levels_.size() > 1) levels_.pop_back();
    Level& below = levels_.back();
    (passage.value == gen::kSysTickException ? below.by_release : below.by_others) += 1;
    Level level;
    level.exception = passage.value;
    level.is_high = passage.is_high;
    const auto routine = routes_.routines.find(passage.value);
    if (routine != routes_.routines.end()) level.routine = &routine->second;
    levels_.push_back(std::move(level));
  }

  void begin_way(std::uint32_t address) {
    Level& level = levels_.back();
    level.own = 0;
    level.has_begun = true;
    if (level.routine == nullptr) return;
    const auto& nodes = level.routine->walked.graph.nodes;
    if (nodes.empty() || nodes[0].block != address) return lose(level, address);
    pass(level, 0, 0);
  }

  void lose(Level& level, std::uint32_t address) {
    level.is_lost = true;
    const auto& nodes = level.routine->walked.graph.nodes;
    const std::uint32_t from = level.node < nodes.size() ? nodes[level.node].block : 0;
    std::string way;
    for (std::size_t i = level.steps.size() > 40 ? level.steps.size() - 40 : 0; i < level.steps.size(); ++i)
      way += fmt::format(" {:x}", nodes[level.steps[i].node].block);
    findings_.complain(fmt::format("exception {}: no edge leads from the block at {:#x} to {:#x}, behind{}",
                                   level.exception, from, address, way));
  }

  /// Goes on at `node`, which begins after `way` cycles.
  void pass(Level& level, std::size_t node, Cycles way) {
    level.node = node;
    level.way = way;
    level.steps.push_back({node, way, level.disturbed()});
    level.countdown = {};
    level.edge = kNoEdge;
    level.block_begun = level.own;
    level.block_disturbed = level.disturbed();
    findings_.nodes.emplace(level.exception, node);
    const std::uint32_t block = level.routine->walked.graph.nodes[node].block;
    if (float_blocks_.count(block) != 0) level.uses_float = true;
    count(level, block);
    // The iterations that a node stands for follow it at once.
    if (level.routine->walked.waits.count(node) != 0) return begin_wait(level, node, block);
    const auto countdown = level.routine->walked.countdowns.find(node);
    if (countdown != level.routine->walked.countdowns.end()) begin_countdown(level, node, countdown->second);
  }

  void count(Level& level, std::uint32_t block) {
    const Marks& marks = routes_.prepared.marks();
    if (marks.loop_bounds.count(block) != 0) findings_.bounds_passed.insert(block);
    if (marks.faults.count(block) != 0 && last_ >= recording_.ready_at) ++findings_.faults[block];
    const auto raised = marks.raised.find(block);
    if (raised != marks.raised.end() && !level.is_high && (raised->second & kRequest) == 0) {
      findings_.complain(fmt::format("exception {}: software raised it, and it passes {:#x}, where only others lead",
                                     level.exception, block));
    }
  }

  /// What a block took is covered by the way into it and by its own cost. The first instruction after it may be what
  /// its last one is waited for: a cycle that is the next one's.
  void judge_block(const Level& level) {
    if (level.edge == kNoEdge || level.block_disturbed != level.disturbed()) return;
    const UnrolledNode& node = level.routine->walked.graph.nodes[level.node];
    const double took = level.own - level.block_begun;
    double paid = static_cast<double>(level.edge + node.cost) + 1;
    if (float_blocks_.count(node.block) != 0) paid += kLazyStacking;
    if (behind_it_.count(node.block) != 0) paid += kMostSkipped;
    if (took > paid + 0.001)
      findings_.complain(fmt::format("exception {}: the block at {:#x} takes {:.1f} cycles, and {} are charged",
                                     level.exception, node.block, took, level.edge + node.cost));
  }

  void begin_wait(Level& level, std::size_t node, std::uint32_t block) {
    const auto first = level.routine->behind(node, block);
    if (!first) return lose(level, block);
    const Cycles way = level.way + level.routine->walked.graph.nodes[node].cost + first->cost;
    level.waits.push_back({block, first->to, first->to, {way}});
    pass(level, first->to, way);
  }

  void begin_countdown(Level& level, std::size_t node, const Countdown& countdown) {
    const UnrolledNode& rounds = level.routine->walked.graph.nodes[node];
    const auto last = level.routine->behind(node, rounds.block);
    if (!last) return lose(level, rounds.block);
    pass(level, last->to, level.way + rounds.cost + last->cost);
    level.countdown = countdown;
  }

  /// One of the iterations that are paid for together.
  static bool turn_countdown(Level& level, std::uint32_t address) {
    const UnrolledNode& node = level.routine->walked.graph.nodes[level.node];
    if (node.block != address || level.countdown.rounds == 0) return false;
    --level.countdown.rounds;
    level.edge = level.countdown.cost - node.cost;
    level.block_begun = level.own;
    level.block_disturbed = level.disturbed();
    return true;
  }

  void arrive(std::uint32_t address) {
    Level& level = levels_.back();
    if (level.routine == nullptr || level.is_lost) return;
    judge_block(level);
    if (turn_countdown(level, address)) return;
    const Cycles behind = level.way + level.routine->walked.graph.nodes[level.node].cost;
    if (const auto next = level.routine->behind(level.node, address)) {
      note_round(level, next->to, address, behind + next->cost);
      pass(level, next->to, behind + next->cost);
      if (level.node == next->to) level.edge = next->cost;
      return;
    }
    if (turn_wait(level, address, behind) || retry(level, address, behind) || store_again(level, address, behind))
      return;
    lose(level, address);
  }

  /// The second iteration of a wait, which is the last that the graph has.
  static void note_round(Level& level, std::size_t node, std::uint32_t address, Cycles way) {
    if (level.waits.empty()) return;
    OpenWait& wait = level.waits.back();
    if (wait.header != address || wait.begun.size() != 1 || node == wait.first) return;
    wait.again = node;
    wait.begun.push_back(way);
  }

  /// One more iteration of a wait: the oldest is in the limit from now on.
  bool turn_wait(Level& level, std::uint32_t address, Cycles behind) {
    while (!level.waits.empty() && level.waits.back().header != address) level.waits.pop_back();
    if (level.waits.empty()) return false;
    OpenWait& wait = level.waits.back();
    Cycles way = behind + routes_.cost.jump(address);
    if (wait.begun.size() == 2) {
      const Cycles oldest = wait.begun[1] - wait.begun[0];
      way -= oldest;
      wait.begun = {wait.begun[1] - oldest, way};
    } else {
      wait.begun.push_back(way);
    }
    pass(level, wait.again, way);
    return true;
  }

  /// Goes back to a step that was passed, and takes what was done since from the way: an interrupt pays for it.
  void repeat(Level& level, std::size_t step, Cycles behind, std::uint32_t address) {
    const Step back = level.steps[step];
    level.added += static_cast<double>(behind + routes_.cost.jump(address) - back.at);
    level.steps.resize(step);
    ++findings_.retries;
    pass(level, back.node, back.at);
  }

  std::optional<std::size_t> last_step_at(const Level& level, std::size_t node) const {
    for (std::size_t i = level.steps.size(); i-- > 0;) {
      if (level.steps[i].node == node) return i;
    }
    return std::nullopt;
  }

  /// `retried_if_interrupted`: once more for each interrupt of the kind.
  bool retry(Level& level, std::uint32_t address, Cycles behind) {
    for (const Retry& retry : level.routine->walked.retries) {
      const auto& nodes = level.routine->walked.graph.nodes;
      if (nodes[retry.begin].block != address) continue;
      const bool leads_here = std::any_of(retry.back.begin(), retry.back.end(),
                                          [&](const UnrolledEdge& edge) { return edge.from == level.node; });
      const auto step = leads_here ? last_step_at(level, retry.begin) : std::nullopt;
      if (!step) continue;
      const unsigned came = retry.by == RetriedBy::release ? level.by_release : level.by_others;
      if (++level.retried[retry.by] > came) {
        findings_.complain(
            fmt::format("exception {}: at {:#x} one more round than interrupts came", level.exception, address));
      }
      repeat(level, *step, behind, address);
      return true;
    }
    return false;
  }

  /// A store that was exclusive until something came in between.
  bool store_again(Level& level, std::uint32_t address, Cycles behind) {
    bool has_stored = false;
    for (std::size_t i = level.steps.size(); i-- > 0;) {
      const UnrolledNode& node = level.routine->walked.graph.nodes[level.steps[i].node];
      has_stored |= stores_exclusively(node);
      if (node.block != address) continue;
      if (!has_stored || level.steps[i].disturbed == level.disturbed()) return false;
      repeat(level, i, behind, address);
      return true;
    }
    return false;
  }

  static bool stores_exclusively(const UnrolledNode& node) {
    const gen::BasicBlock& block = node.function->graph.blocks.at(node.block);
    for (std::uint32_t at = block.begin; at < block.end;) {
      const gen::Instruction* i = node.function->body.at(at);
      if (i == nullptr) return false;
      if (i->id == ARM_INS_STREX || i->id == ARM_INS_STREXB || i->id == ARM_INS_STREXH) return true;
      at = i->end();
    }
    return false;
  }

  void pass_mark(std::uint32_t number) {
    Level& level = levels_.back();
    if (level.routine == nullptr || level.is_lost) return;
    if (number % 2 == 0) {
      level.brackets.try_emplace(number, OpenBracket{level.way, level.own, level.added, level.disturbed()});
      return;
    }
    const auto open = level.brackets.find(number - 1);
    if (open == level.brackets.end()) return;
    const OpenBracket from = open->second;
    level.brackets.erase(open);
    judge(level, fmt::format("bracket {}", number - 1), level.way - from.way, level.own - from.own,
          level.added - from.added, level.disturbed() - from.disturbed, findings_.brackets[number - 1]);
    const auto bound = level.routine->brackets.find(number - 1);
    if (bound == level.routine->brackets.end() || level.way - from.way > bound->second)
      findings_.complain(
          fmt::format("bracket {}: a way of {} cycles, which is above its bound", number - 1, level.way - from.way));
  }

  void leave() {
    Level& level = levels_.back();
    if (level.routine == nullptr || level.is_lost || !level.has_begun) return;
    if (!level.routine->is_exit[level.node]) {
      findings_.complain(fmt::format("exception {}: it ends at {:#x}, where no way leads out", level.exception,
                                     level.routine->walked.graph.nodes[level.node].block));
      return;
    }
    const Cycles way = level.way + level.routine->walked.graph.nodes[level.node].cost;
    if (way > level.routine->bound) {
      findings_.complain(
          fmt::format("exception {}: a way of {} cycles, the bound is {}", level.exception, way, level.routine->bound));
    }
    judge(level, fmt::format("exception {}", level.exception), way, level.own, level.added, level.disturbed(),
          findings_.routines[level.exception]);
  }

  /// (i): what the way costs covers what it took.
  void judge(const Level& level, const std::string& what, Cycles way, double own, double added, unsigned disturbed,
             Followed& followed) {
    const bool in_flash = routes_.loaded.placement == Placement::flash;
    double paid = static_cast<double>(way) + added + (in_flash ? kLine * (1 + disturbed) : 0);
    if (level.uses_float) paid += kLazyStacking * (1 + disturbed);
    // A mark and an instruction begin at a cycle: rounding of a cycle's length takes no part of one.
    if (own > paid + 0.001) {
      findings_.complain(fmt::format("{}: {:.1f} cycles, and {:.1f} paid for ({} by its way, {} disturbed)", what, own,
                                     paid, way, disturbed));
    }
    ++followed.runs;
    followed.longest_path = std::max(followed.longest_path, way);
    if (disturbed != 0) return;
    ++followed.undisturbed;
    followed.longest_run = std::max(followed.longest_run, own);
    if (way > 0) followed.closest = std::max(followed.closest, own / static_cast<double>(way));
  }

  const Recording& recording_;
  const Routes& routes_;
  Findings findings_;
  std::set<std::uint32_t> float_blocks_, behind_it_;
  std::vector<Level> levels_;
  std::uint64_t last_ = 0;
};

}  // namespace

Findings follow(const Recording& recording, const Routes& routes) { return Follower(recording, routes).result(); }

}  // namespace finemote::test
