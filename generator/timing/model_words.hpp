// The words that the JSON form of a model has for its kinds.
#pragma once

#include <string_view>
#include <utility>

#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

template <class Kind>
using Word = std::pair<Kind, std::string_view>;

inline constexpr Word<Transfer::After> kAfterWords[] = {{Transfer::After::update, "update"},
                                                        {Transfer::After::handle, "handle"},
                                                        {Transfer::After::bucket, "bucket"},
                                                        {Transfer::After::autonomous, "autonomous"}};

inline constexpr Word<InterruptCause> kCauseWords[] = {{InterruptCause::clock, "clock"},
                                                       {InterruptCause::request, "request"},
                                                       {InterruptCause::transfer, "transfer"},
                                                       {InterruptCause::look, "look"}};

inline constexpr Word<AskedIn> kAskedInWords[] = {
    {AskedIn::handle, "handle"}, {AskedIn::update, "update"}, {AskedIn::flush, "flush"}};

inline constexpr Word<UnknownAge> kUnknownAgeWords[] = {{UnknownAge::none, "none"},
                                                        {UnknownAge::no_acquisition, "no_acquisition"},
                                                        {UnknownAge::sent_by_itself, "sent_by_itself"},
                                                        {UnknownAge::busy_slot, "busy_slot"},
                                                        {UnknownAge::shared_converter, "shared_converter"}};

template <class Kind, std::size_t kCount>
constexpr std::string_view word_of(Kind kind, const Word<Kind> (&words)[kCount]) {
  for (const auto& [value, word] : words) {
    if (value == kind) return word;
  }
  return {};
}

}  // namespace finemote::gen::timing
