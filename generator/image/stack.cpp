#include "generator/image/stack.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/image/double_arithmetic.hpp"
#include "generator/image/exception.hpp"
#include "generator/image/program.hpp"
#include "generator/image/schedule_layout.hpp"
#include "generator/image/stack_use.hpp"

namespace finemote::gen {
namespace {

using namespace schedule_layout;

constexpr std::uint32_t kMaxLines = 240;

struct Deepest {
  std::uint32_t bytes = 0;
  std::vector<std::string> path;
};

class Analysis {
 public:
  Analysis(const Image& image, Diagnostics& diagnostics) : image_(image), diagnostics_(diagnostics), program_(image) {
    read_schedule();
  }

  StackBound bound() {
    StackBound bound;
    add(bound, "thread", vector(1), 0);
    for (const auto& [line, entry] : buckets_) {
      add(bound, fmt::format("bucket on line {}", line), vector(exception_of(line)).value_or(entry), kExceptionFrame);
    }
    add(bound, "release", vector(kSysTickException), kExceptionFrame);
    for (StackLevel& level : bus_levels()) push(bound, std::move(level));
    bound.known = !failed_;
    return bound;
  }

 private:
  // ---- what the image says about its interrupts

  [[nodiscard]] std::optional<std::uint32_t> vector(std::uint32_t number) const {
    const ImageSymbol* table = image_.find("finemote_vectors");
    if (table == nullptr || number * 4 >= table->size) return std::nullopt;
    const auto entry = image_.word(table->address + 4 * number);
    if (!entry || *entry == 0) return std::nullopt;
    return *entry & ~1U;
  }

  void read_schedule() {
    const ImageSymbol* schedule = image_.find("finemote_schedule");
    if (schedule == nullptr) return;
    const auto word = [&](std::uint32_t at) { return image_.word(schedule->address + at).value_or(0); };
    start_buses_ = word(kStartBusesAt) & ~1U;
    safe_outputs_ = word(kSafeOutputsAt) & ~1U;
    buses_quiet_ = schedule->size > kBusesQuietAt ? word(kBusesQuietAt) & ~1U : 0;
    const std::uint32_t count = std::min<std::uint32_t>(word(kBucketCountAt), 16);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t bucket = word(kBucketsAt) + i * kBucketSize;
      const std::uint32_t line = image_.word(bucket + kLineAt).value_or(0) & 0xFFU;
      buckets_.push_back({line, image_.word(bucket).value_or(0) & ~1U});
    }
    std::reverse(buckets_.begin(), buckets_.end());  // least urgent first
  }

  // Every line with a routine that is no bucket's: of these the two deepest can be nested, one per level.
  std::vector<StackLevel> bus_levels() {
    const ImageSymbol* unexpected = image_.find("finemote_unexpected_line");
    const ImageSymbol* table = image_.find("finemote_vectors");
    std::vector<StackLevel> levels;
    for (std::uint32_t line = 0; table != nullptr && line < kMaxLines; ++line) {
      const auto entry = vector(exception_of(line));
      const bool bucket = std::any_of(buckets_.begin(), buckets_.end(), [&](const auto& b) { return b.first == line; });
      if (!entry || bucket || unexpected == nullptr || *entry == unexpected->address) continue;
      const Deepest deepest = deepest_from(*entry);
      levels.push_back({fmt::format("bus interrupt on line {}", line), deepest.bytes, kExceptionFrame, deepest.path});
    }
    std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.bytes > b.bytes; });
    if (levels.size() > 2) levels.resize(2);
    return levels;
  }

  // ---- the call graph

  void add(StackBound& bound, std::string name, std::optional<std::uint32_t> entry, std::uint32_t frame) {
    if (!entry) {
      fail(code::unbounded_stack, fmt::format("no entry for the {} in the vector table", name));
      return;
    }
    const Deepest deepest = deepest_from(*entry);
    push(bound, {std::move(name), deepest.bytes, frame, deepest.path});
  }

  static void push(StackBound& bound, StackLevel level) {
    bound.bytes += level.bytes + level.frame;
    bound.levels.push_back(std::move(level));
  }

  Deepest deepest_from(std::uint32_t address) {
    const auto known = done_.find(address);
    if (known != done_.end()) return known->second;
    const ProgramFunction* function = program_.at(address);
    if (function == nullptr) {
      fail(code::unbounded_stack, fmt::format("no function at the called address 0x{:08x}", address));
      return {};
    }
    const std::string name = readable_name(function->symbol->name);
    if (!open_.insert(address).second) {
      fail(code::recursion, fmt::format("'{}' calls itself, directly or through others", name))
          .hint("the stack of recursive code has no bound: write a loop");
      return {};
    }
    trail_.push_back(name);
    Deepest deepest = deepest_of(stack_use(*function), name);
    trail_.pop_back();
    open_.erase(address);
    deepest.path.insert(deepest.path.begin(), name);
    return done_[address] = deepest;
  }

  /// Arithmetic on 'double' is what its caller does.
  void report(const std::string& problem, const std::string& name) {
    const auto caller =
        std::find_if(trail_.rbegin(), trail_.rend(), [](const std::string& n) { return !is_double_arithmetic(n); });
    if (!is_double_arithmetic(name) || caller == trail_.rend()) {
      fail(code::unbounded_stack, fmt::format("in '{}': {}", name, problem));
      return;
    }
    fail(code::unbounded_stack, fmt::format("in '{}': arithmetic on 'double' has no bound on this core", *caller))
        .hint(std::string(kInsteadOfDouble));
  }

  Deepest deepest_of(const StackUse& use, const std::string& name) {
    if (!use.problem.empty()) report(use.problem, name);
    Deepest deepest{use.depth, {}};
    for (const StackUse::Call& call : use.calls) {
      for (const std::uint32_t target : targets_of(call.call, name)) {
        const Deepest callee = deepest_from(target);
        if (call.depth + callee.bytes > deepest.bytes ||
            (deepest.path.empty() && call.depth + callee.bytes == deepest.bytes)) {
          deepest = {call.depth + callee.bytes, callee.path};
        }
      }
    }
    return deepest;
  }

  /// What main calls through the schedule.
  [[nodiscard]] std::vector<std::uint32_t> start_of_robot() const {
    std::vector<std::uint32_t> targets{start_buses_, safe_outputs_};
    if (buses_quiet_ != 0) targets.push_back(buses_quiet_);  // of a robot that brings it
    return targets;
  }

  std::vector<std::uint32_t> targets_of(const FlowCall& call, const std::string& caller) {
    if (call.target) return {*call.target};
    if (caller == "finemote_reset") return constructors();
    if (caller == "main" || caller.rfind("finemote::detail::start_robot(", 0) == 0 ||
        caller.find("::settle(") != std::string::npos)
      return start_of_robot();
    if (caller.rfind("finemote::stop_safely(", 0) == 0) return {safe_outputs_};
    fail(code::indirect_call, fmt::format("'{}' calls through a pointer at 0x{:08x}", caller, call.at))
        .hint("the stack of an unknown function has no bound: call it directly");
    return {};
  }

  [[nodiscard]] std::vector<std::uint32_t> constructors() const {
    std::vector<std::uint32_t> targets;
    for (const ImageSection& section : image_.sections) {
      if (section.name != ".init_array") continue;
      for (std::uint32_t at = 0; at + 4 <= section.bytes.size(); at += 4) {
        targets.push_back(image_.word(section.address + at).value_or(0) & ~1U);
      }
    }
    return targets;
  }

  Diagnostic& fail(Code code, const std::string& message) {
    failed_ = true;
    Diagnostic& diagnostic = diagnostics_.error(code, {}, message);
    if (trail_.size() > 1) diagnostic.note(fmt::format("called by {}", fmt::join(trail_, " -> ")));
    return diagnostic;
  }

  const Image& image_;
  Diagnostics& diagnostics_;
  Program program_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> buckets_;        // line, entry
  std::uint32_t start_buses_ = 0, safe_outputs_ = 0, buses_quiet_ = 0;  // what the runtime calls through the schedule
  std::map<std::uint32_t, Deepest> done_;
  std::set<std::uint32_t> open_;
  std::vector<std::string> trail_;
  bool failed_ = false;
};

}  // namespace

StackBound worst_case_stack(const Image& image, Diagnostics& diagnostics) {
  return Analysis(image, diagnostics).bound();
}

}  // namespace finemote::gen
