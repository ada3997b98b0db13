#include "generator/wcet/walk.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <utility>

#include "generator/wcet/call_chain.hpp"
#include "generator/wcet/countdown.hpp"
#include "generator/wcet/exclusive_stores.hpp"
#include "generator/wcet/frame.hpp"
#include "generator/wcet/loop_marks.hpp"
#include "generator/wcet/loop_nest.hpp"
#include "generator/wcet/loop_nests.hpp"
#include "generator/wcet/mark_passes.hpp"
#include "generator/wcet/masking.hpp"
#include "generator/wcet/presumed_return.hpp"
#include "generator/wcet/repetition.hpp"
#include "generator/wcet/step.hpp"

namespace finemote::gen::wcet {
namespace {

/// Where a walk gives up: no routine that must end in a period is longer.
constexpr std::size_t kMostNodes = 1'000'000;
/// Those of tries that leave no trace included.
constexpr std::size_t kMostVisits = 2'000'000;
/// A tenth of a second: longer ones are none of a routine that has a period.
constexpr Cycles kLongestWait = 16'800'000;
/// What is in the link register where a routine begins: ARMv7-M B1.5.8.
constexpr Interval kExceptionReturn{0xFFFF'FFE1, 0xFFFF'FFFD};
/// Ten seconds, of which an experiment may ask for one.
constexpr Cycles kLongestCount = 1'680'000'000;

/// What the marks of waits say while a loop is gone through.
class Waits {
 public:
  explicit Waits(const Marks& marks) : marks_(marks) {}

  void note(std::uint32_t block, const Machine& machine) {
    const auto wait = marks_.waits.find(block);
    if (wait == marks_.waits.end()) return;
    Cycles& limit = limits_[block];
    limit = std::max(limit, static_cast<Cycles>(machine.get(wait->second).range().high));
  }

  void forget(const Loop& loop) {
    for (const std::uint32_t block : loop.blocks) limits_.erase(block);
  }

  /// The longest of these: copies of one mark may have been given others.
  [[nodiscard]] Cycles limit_of(const std::vector<std::uint32_t>& waits) const {
    std::optional<Cycles> limit;
    for (const std::uint32_t block : waits) {
      const auto found = limits_.find(block);
      if (found != limits_.end()) limit = std::max(limit.value_or(0), found->second);
    }
    return limit.value_or(kLongestWait + 1);
  }

 private:
  const Marks& marks_;
  std::map<std::uint32_t, Cycles> limits_;  // by block of the mark
};

std::uint64_t marks_passed(const Frame& frame, const Loop& loop) {
  std::uint64_t sum = 0;
  for (const auto& [block, passes] : frame.passes) sum += loop.blocks.count(block) != 0 ? passes : 0;
  return sum;
}

/// One more iteration than its mark allows without an interrupt.
void note_retry(const Frame& frame, std::uint32_t block, const Marks& marks, std::vector<UnrolledEdge> back,
                std::vector<Retry>& retries) {
  const auto retry = marks.retries.find(block);
  if (retry != marks.retries.end()) retries.push_back({retry->second, frame.passed.at(block), std::move(back)});
}

/// The register that all of a loop counts down, where it holds more than zero and nothing is marked.
std::optional<int> counter_of(const Frame& frame, std::size_t index, const Marks& marks) {
  const Loop& loop = frame.nest.loops()[index];
  if (loop.blocks.size() != 1 || marks.loop_bounds.count(loop.header) != 0) return std::nullopt;
  const auto reg = counted_down(frame.function, frame.function.graph.blocks.at(loop.header));
  const bool wraps = reg && frame.arrivals.at(loop.header)->machine.get(*reg).range().low == 0;
  return wraps ? std::nullopt : reg;
}

std::set<std::uint32_t> places_of(const std::map<std::uint32_t, WalkProblem>& problems) {
  std::set<std::uint32_t> places;
  for (const auto& [place, problem] : problems) places.insert(place);
  return places;
}

/// The loop has no end, and went past what it was to go through.
void drop_stores_behind(const std::set<std::uint32_t>& known, std::map<std::uint32_t, WalkProblem>& problems) {
  std::erase_if(problems, [&](const auto& problem) {
    return problem.second.why == kStoreToConstant && known.count(problem.first) == 0;
  });
}

/// Of a block and the longest way out of it.
Cycles longest_round(const Step& step) {
  Cycles longest = step.cost;
  for (const Way& way : step.ways) longest = std::max(longest, step.cost + way.cost);
  return longest;
}

void note(const Frame& frame, const Loop& loop, std::uint64_t rounds, std::map<std::uint32_t, CountedLoop>& loops) {
  CountedLoop& counted = loops[loop.header];
  counted.function = &frame.function;
  counted.header = loop.header;
  counted.is_by_mark |= frame.is_cut_by_mark;
  counted.rounds = std::max(counted.rounds, rounds);
}

/// Place and reason why a block cannot be followed; none: it can.
std::optional<std::pair<std::uint32_t, std::string>> refusal_of(const Frame& frame, std::uint32_t block,
                                                                const Marks& marks) {
  if (is_passed_by_some(frame, block, marks)) return {{block, "a mark that not every round of its loop passes"}};
  const BasicBlock& code = frame.function.graph.blocks.at(block);
  if (const auto place = masks_by_itself(frame.function, code, marks))
    return {{*place, "interrupts are kept out, and what that delays has no bound"}};
  if (const auto place = sets_stack_pointer(frame.function, code))
    return {{*place, "the stack pointer is set, and what lies on the stack is not known"}};
  return std::nullopt;
}

constexpr const char* kUnlimitedWait = "a wait whose limit is not known";
constexpr const char* kWrongReturn = "it does not return to where it was called from";

/// Whether a way that leaves the function, if it does, leads to its caller.
bool is_back(const Way& way, const Frame& frame) {
  return way.back.is_made ? way.back.to == frame.back : meet(way.back.to, frame.back).has_value();
}

Machine at_entry(std::uint32_t stack_top) {
  Machine machine;
  for (int reg = ARM_REG_R0; reg <= ARM_REG_R12; ++reg) machine.set(reg, Value::in(Interval::any()));
  machine.set(ARM_REG_SP, Value::place(stack_top));
  machine.set(ARM_REG_LR, Value::in(kExceptionReturn));
  machine.keep_link();
  return machine;
}

/// Its number.
std::size_t add_node(UnrolledNode node, Walked& walked) {
  walked.graph.nodes.push_back(std::move(node));
  return walked.graph.nodes.size() - 1;
}

/// Where the walk was when it gave up: the loop that had turned most often by then, of equal ones the innermost.
class LongestLoop {
 public:
  void note(std::uint64_t rounds, WalkProblem place) {
    if (place_ && rounds <= rounds_) return;
    rounds_ = rounds;
    place_ = std::move(place);
  }
  [[nodiscard]] WalkProblem problem(WalkProblem otherwise) const {
    WalkProblem problem = place_.value_or(std::move(otherwise));
    problem.why = "too many ways lead through it: ";
    problem.why += place_ ? fmt::format("this loop may turn {} times or more; bound it with LoopBound<n>", rounds_)
                          : "bound its loops more tightly";
    return problem;
  }

 private:
  std::uint64_t rounds_ = 0;
  std::optional<WalkProblem> place_;
};

class Walker {
 public:
  explicit Walker(const WalkContext& context)
      : context_(context), goes_on_(context.stores == nullptr), waits_(context.marks) {}

  Walked result(std::uint32_t entry) {
    const auto end = enter(entry, Arrival{at_entry(context_.stack_top), {}}, entry, nullptr);
    if (is_spent() && walked_.problems.empty())
      walked_.problems[entry] = longest_.problem({entry, context_.program.at(entry), {}});
    for (const UnrolledEdge& edge : end ? end->from : std::vector<UnrolledEdge>{})
      walked_.graph.exits.push_back(edge.from);
    return std::move(walked_);
  }

 private:
  Surroundings surroundings() { return {context_.constants, unknowns_, context_.stores}; }
  [[nodiscard]] bool is_spent() const { return walked_.graph.nodes.size() > kMostNodes || visits_ > kMostVisits; }
  void fail(std::uint32_t address, const ProgramFunction* function, std::string why) {
    ++failures_;
    walked_.problems.try_emplace(address, WalkProblem{address, function, std::move(why), chain_.sites()});
  }

  /// Goes through a function; what leaves it, if something does.
  std::optional<Arrival> enter(std::uint32_t address, Arrival arrival, std::uint32_t from,
                               const ProgramFunction* caller) {
    const ProgramFunction* function = context_.program.at(address);
    if (const char* why = chain_.why_not(address, function, from)) return fail(from, caller, why), std::nullopt;
    chain_.enter(function, from);
    auto end = go_through(*function, std::move(arrival));
    chain_.leave();
    return end;
  }

  std::optional<Arrival> go_through(const ProgramFunction& function, Arrival arrival) {
    for (const FlowProblem& problem : function.graph.problems) fail(problem.address, &function, problem.text);
    const LoopNest& nest = nests_.of(function);
    for (const std::uint32_t block : nest.irreducible())
      fail(block, &function, "a loop with more than one entry: write it as one loop");
    if (!nest.irreducible().empty()) return std::nullopt;
    Frame frame{function, nest, {}, {}, {}, {}, false, {}, arrival.machine.get(ARM_REG_LR).anywhere()};
    frame.arrivals[function.graph.entry] = std::move(arrival);
    go_through(frame, std::nullopt);
    for (const std::uint32_t block : left_over(frame)) {
      if (is_spent()) break;  // given up on purpose
      fail(block, &function, "ways that lead here are not in the bound: a defect of this tool");
    }
    return std::move(frame.end);
  }

  /// The blocks of a loop in one iteration, or of the function.
  void go_through(Frame& frame, std::optional<std::size_t> loop) {
    for (const std::uint32_t block : frame.nest.order(loop)) {
      auto& arrival = frame.arrivals[block];
      if (!arrival || is_spent()) continue;
      const auto inner = frame.nest.around(block);
      const bool is_inner_header = inner != loop && inner && frame.nest.loops()[*inner].header == block;
      is_inner_header ? turn(frame, *inner) : visit(frame, block);
    }
  }

  /// A loop, iteration by iteration, until nothing comes back to its header.
  void turn(Frame& frame, std::size_t index) {
    const std::vector<std::uint32_t> waits = waits_of(frame.nest, index, context_.marks);
    if (!waits.empty()) return wait(frame, index, waits);
    if (const auto reg = counter_of(frame, index, context_.marks)) return count_down(frame, index, *reg);
    const Loop& loop = frame.nest.loops()[index];
    const std::size_t first = walked_.graph.nodes.size();
    const auto rounds = go_round(frame, index);
    if (is_long_repetition(frame, index, walked_.graph, first)) fail(loop.header, &frame.function, kLongRepetition);
    if (!rounds && !is_spent()) fail(loop.header, &frame.function, why_endless(frame.nest, index, context_.marks));
    note(frame, loop, rounds.value_or(0), walked_.loops);
  }

  /// How often it jumps back to its header, iterated until no way leads there; none: there is no end to it.
  std::optional<std::uint64_t> go_round(Frame& frame, std::size_t index) {
    const Loop& loop = frame.nest.loops()[index];
    for (const std::uint32_t block : loop.blocks) frame.passes.erase(block);
    frame.is_cut_by_mark = false;
    std::set<std::uint32_t> problems;  // of its first iteration
    for (std::uint64_t rounds = 0;; ++rounds) {
      const Machine before = exclusive_stores_.begin_turn(frame, index);
      const std::uint64_t passed = marks_passed(frame, loop);
      go_through(frame, index);
      auto& header = frame.arrivals[loop.header];
      if (is_spent()) longest_.note(rounds, {loop.header, &frame.function, {}, chain_.sites()});
      if (!header) return rounds;
      if (rounds == 0) problems = places_of(walked_.problems);
      const bool is_same =
          before.covers(header->machine) && header->machine.covers(before) && marks_passed(frame, loop) == passed;
      if (!is_same && rounds < kMostRounds && !is_spent()) continue;
      return header.reset(), drop_stores_behind(problems, walked_.problems), std::nullopt;
    }
  }

  /// All of its iterations but the last together, which are alike; then the last one, after which it is left.
  void count_down(Frame& frame, std::size_t index, int reg) {
    const Loop& loop = frame.nest.loops()[index];
    Arrival arrival = std::move(*frame.arrivals[loop.header]);
    const auto back = static_cast<Cycles>(arrival.machine.get(reg).range().high) - 1;
    const BasicBlock& block = frame.function.graph.blocks.at(loop.header);
    const Cycles cost =
        longest_round(wcet::step(frame.function, block, surroundings(), context_.cost, arrival.machine));
    frame.arrivals[loop.header].reset();
    if (back > kLongestCount / cost) return fail(loop.header, &frame.function, "a loop that counts for seconds");
    const std::size_t node = add_node({&frame.function, loop.header, back * cost, std::move(arrival.from)}, walked_);
    walked_.countdowns[node] = {static_cast<std::uint64_t>(back), cost};
    arrival.machine.set(reg, Value::of(1));
    frame.arrivals[loop.header] = Arrival{std::move(arrival.machine), {{node, 0}}};
    go_through(frame, index);
    note(frame, loop, static_cast<std::uint64_t>(back), walked_.loops);
  }

  /// A loop that ends when the time is over: that long; then the rest of the iteration that was under way, and the one
  /// that sees it, both from whatever state it has come to.
  void wait(Frame& frame, std::size_t index, const std::vector<std::uint32_t>& waits) {
    const auto around = std::exchange(frame.unmarked, index);  // its iterations are those of any time
    const Loop& loop = frame.nest.loops()[index];
    Arrival arrival = std::move(*frame.arrivals[loop.header]);
    frame.arrivals[loop.header].reset();
    waits_.forget(loop);
    while (!settle(frame, index, arrival.machine)) {}
    pass_time(frame, index, waits_.limit_of(waits), std::move(arrival));
    frame.unmarked = around;
  }

  void pass_time(Frame& frame, std::size_t index, Cycles limit, Arrival arrival) {
    const Loop& loop = frame.nest.loops()[index];
    if (limit > kLongestWait) return fail(loop.header, &frame.function, kUnlimitedWait);
    const std::size_t node = add_node({&frame.function, loop.header, limit, std::move(arrival.from)}, walked_);
    walked_.waits.insert(node);
    frame.arrivals[loop.header] = Arrival{std::move(arrival.machine), {{node, 0}}};
    for (int round = 0; round < 2 && frame.arrivals[loop.header]; ++round) go_through(frame, index);
    frame.arrivals[loop.header].reset();
  }

  /// Tries an iteration and widens `machine` by what it comes back with, leaving no trace. True where nothing is new.
  bool settle(Frame& frame, std::size_t index, Machine& machine) {
    const std::uint32_t header = frame.nest.loops()[index].header;
    const Snapshot before(frame, walked_);
    frame.arrivals[header] = Arrival{machine, {}};
    go_through(frame, index);
    const std::optional<Arrival> back = std::move(frame.arrivals[header]);
    before.restore(frame, walked_);
    if (!back || machine.covers(back->machine)) return true;
    machine.widen(back->machine);
    return false;
  }

  void visit(Frame& frame, std::uint32_t block) {
    ++visits_;
    Arrival arrival = std::move(*frame.arrivals[block]);
    frame.arrivals[block].reset();
    if (const auto refused = refusal_of(frame, block, context_.marks))
      return fail(refused->first, &frame.function, refused->second);
    if (!pass_mark(frame, block, context_.marks))
      return note_retry(frame, block, context_.marks, std::move(arrival.from), walked_.retries);
    frame.passed[block] = walked_.graph.nodes.size();
    arrival.machine.name_unknowns(unknowns_);
    waits_.note(block, arrival.machine);
    const BasicBlock& code = frame.function.graph.blocks.at(block);
    Step step = exclusive_stores_.step(frame, code, surroundings(), context_.cost, std::move(arrival.machine));
    if (step.problem) fail(step.problem->first, &frame.function, step.problem->second);
    if (step.problem && !goes_on_) return;
    const std::size_t node = add_node({&frame.function, block, step.cost, std::move(arrival.from)}, walked_);
    for (Way& way : step.ways) follow(frame, code, node, std::move(way));
  }

  void follow(Frame& frame, const BasicBlock& code, std::size_t node, Way way) {
    const std::vector<UnrolledEdge> here{{node, way.cost}};
    if (!is_back(way, frame)) return fail(code.begin, &frame.function, kWrongReturn);
    switch (way.kind) {
      case Way::Kind::edge:
        return arrive(frame.arrivals[way.to], std::move(way.machine), here);
      case Way::Kind::leave:
        return arrive(frame.end, std::move(way.machine), here);
      case Way::Kind::call:
        break;
    }
    const std::size_t failures = failures_;
    auto back = enter(way.to, Arrival{way.machine, here}, code.call->at, &frame.function);
    if (!back && failures_ != failures && goes_on_) back = Arrival{presumed_return(std::move(way.machine)), here};
    if (!back) return;
    back->machine.stack().drop_below(back->machine.get(ARM_REG_SP).range().low);
    if (way.is_tail) return arrive(frame.end, std::move(back->machine), back->from);
    if (way.behind == 0) return;
    for (UnrolledEdge& edge : back->from) edge.cost += context_.cost.jump(way.behind);
    arrive(frame.arrivals[way.behind], std::move(back->machine), back->from);
  }

  const WalkContext& context_;
  const bool goes_on_;  ///< after a problem, to find others; what is presumed there must be no ground of a constant
  Unknowns unknowns_;
  Walked walked_;
  LongestLoop longest_;
  std::size_t failures_ = 0, visits_ = 0;
  LoopNests nests_;
  ExclusiveStores exclusive_stores_;
  Waits waits_;
  CallChain chain_;
};

}  // namespace

Walked walk(const WalkContext& context, std::uint32_t entry) { return Walker(context).result(entry); }

}  // namespace finemote::gen::wcet
