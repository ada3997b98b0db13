// What exceptions have interrupted, found again by where its registers lie.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace finemote::emulator {

/// Kept for every exception from its entry to its return. A kernel returns to another thread than it left: to one that
/// was interrupted before, whose frame lies where it was put then, or to one that never ran. What a thread that ended
/// has left is taken for the state of one whose frame comes to lie at the same place.
template <class State>
class Interrupted {
 public:
  /// An exception takes over; the registers of what it interrupts are at `frame`.
  void leave(State state, std::uint32_t frame) { stack_.push_back({frame, std::move(state)}); }

  /// What goes on with the registers at `frame`; of what never ran: nothing yet.
  State come_back(std::uint32_t frame) {
    if (stack_.empty()) return State{};
    Entry top = std::move(stack_.back());
    stack_.pop_back();
    if (top.frame == frame) return std::move(top.state);
    parked_.insert_or_assign(top.frame, std::move(top.state));
    auto node = parked_.extract(frame);
    return node.empty() ? State{} : std::move(node.mapped());
  }

  void clear() {
    stack_.clear();
    parked_.clear();
  }

 private:
  struct Entry {
    std::uint32_t frame;
    State state;
  };
  std::vector<Entry> stack_;
  std::map<std::uint32_t, State> parked_;  ///< threads that do not run, by frame
};

}  // namespace finemote::emulator
