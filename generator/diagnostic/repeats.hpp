// Findings to messages: what is said again of the same text, because a macro was expanded again, is one message.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// A finding, and those that differ from it by the expansion they came through, and by names and numbers, alone.
struct Message {
  Diagnostic finding;
  std::vector<Diagnostic> repeats;
};

/// The findings in file order, each in one message. Two findings are one message when they have the same code, the same
/// place in the same text, different expansions, and the same words apart from what is quoted and from numbers.
std::vector<Message> messages_of(const Diagnostics& diagnostics);

/// A place, and how many repeats came from it.
struct RepeatPlace {
  Position at;
  std::size_t count = 0;
};
/// The outermost macro calls or includes of a message's repeats, each once, in file order.
std::vector<RepeatPlace> repeat_places(const Message& message);

/// `the same for 3 more expansions, at a.xacro:12:5, a.xacro:13:5 (2 times)`: at most twelve places; empty without
/// repeats.
std::string repeats_text(const Message& message);

}  // namespace finemote::gen
