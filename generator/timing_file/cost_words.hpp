// Words of `finemote.wcet/1` for what is charged around stages, for who writes a timing file and who reads one.
#pragma once

namespace finemote::gen::cost_words {

inline constexpr const char* kRelease = "release";
inline constexpr const char* kBefore = "before";  ///< a stage
inline constexpr const char* kMasked = "masked";
inline constexpr const char* kRetry = "retry";

// What raises an interrupt of a bus.
inline constexpr const char* kRequest = "request";
inline constexpr const char* kStep = "step";
inline constexpr const char* kEnd = "end";
inline constexpr const char* kReceived = "received";
inline constexpr const char* kEvent = "event";

}  // namespace finemote::gen::cost_words
