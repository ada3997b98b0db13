// From when exceptions came and went, and marks were passed, to the time that each routine and bracket used itself.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "emulator/core/execution_log.hpp"

namespace finemote::emulator {

/// Longest time of all runs, without what interrupted them.
struct OwnTime {
  Time longest = 0;
  std::uint64_t runs = 0;  ///< that ended
};

/// A bracket begins or ends.
struct BracketEvent {
  Time at = 0;
  unsigned bracket = 0;
  bool is_end = false;
  Time own = 0;  ///< at its end: its own time
};

/// An exception's own time reaches from the start of stacking to the end of unstacking, a stage's from mark to mark.
/// Time of an exception that came in between belongs to that exception alone. Saving floating-point registers for what
/// was preempted belongs to the exception that preempts, whichever stage comes to it first: to no stage.
class OwnTimes {
 public:
  /// Events in the order of time; call it as often as there are some.
  void add(const ExecutionLog& log);

  [[nodiscard]] const std::map<unsigned, OwnTime>& exceptions() const { return exceptions_; }
  /// By half the number of the begin mark.
  [[nodiscard]] const std::map<unsigned, OwnTime>& brackets() const { return brackets_; }
  /// In the order of time.
  [[nodiscard]] const std::vector<BracketEvent>& events() const { return events_; }

 private:
  /// What runs at one level of preemption.
  struct Frame {
    unsigned exception = 0;  ///< 0: the idle loop
    Time own = 0;
    Time saved = 0;                       ///< of it, saving registers
    std::map<unsigned, Time> begun = {};  ///< by bracket: `own` without `saved` when it began
  };

  void add(const ExecutionEvent& event);
  void pass_mark(unsigned number);
  void end_top();

  std::vector<Frame> frames_{Frame{}};
  Time last_ = 0;
  std::map<unsigned, OwnTime> exceptions_, brackets_;
  std::vector<BracketEvent> events_;
};

}  // namespace finemote::emulator
