#include "emulator/core/own_times.hpp"

namespace finemote::emulator {
namespace {

void count(OwnTime& all, Time own) {
  if (own > all.longest) all.longest = own;
  ++all.runs;
}

}  // namespace

void OwnTimes::add(const ExecutionLog& log) {
  for (const ExecutionEvent& event : log) add(event);
}

void OwnTimes::add(const ExecutionEvent& event) {
  if (event.kind == ExecutionEvent::Kind::due) return;
  frames_.back().own += event.at - last_;
  last_ = event.at;
  switch (event.kind) {
    case ExecutionEvent::Kind::enter:
      frames_.push_back({event.number});
      break;
    case ExecutionEvent::Kind::tail:
      end_top();
      frames_.push_back({event.number});
      break;
    case ExecutionEvent::Kind::resume:
      end_top();
      break;
    case ExecutionEvent::Kind::mark:
      pass_mark(event.number);
      break;
    case ExecutionEvent::Kind::save:
      frames_.back().saved += event.number;
      break;
    case ExecutionEvent::Kind::reset:
      frames_.assign(1, Frame{});
      break;
    case ExecutionEvent::Kind::leave:
    case ExecutionEvent::Kind::mask:
    case ExecutionEvent::Kind::unmask:
    case ExecutionEvent::Kind::due:
    case ExecutionEvent::Kind::loop:
      break;
  }
}

/// Only the first start and the first end count: a jump may come back to the instruction at a mark.
void OwnTimes::pass_mark(unsigned number) {
  Frame& frame = frames_.back();
  const unsigned bracket = number / 2;
  const auto begun = frame.begun.find(bracket);
  if (number % 2 == 0) {
    if (begun != frame.begun.end()) return;
    frame.begun.emplace(bracket, frame.own - frame.saved);
    events_.push_back({last_, bracket, false, 0});
    return;
  }
  if (begun == frame.begun.end()) return;
  const Time own = frame.own - frame.saved - begun->second;
  count(brackets_[bracket], own);
  events_.push_back({last_, bracket, true, own});
  frame.begun.erase(begun);
}

void OwnTimes::end_top() {
  if (frames_.size() < 2) return;
  count(exceptions_[frames_.back().exception], frames_.back().own);
  frames_.pop_back();
}

}  // namespace finemote::emulator
