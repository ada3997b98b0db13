// What the exit status of every command means.
#pragma once

namespace finemote::gen {

inline constexpr int kExitYes = 0;       ///< done; the answer is yes
inline constexpr int kExitNo = 1;        ///< ran; the answer is no: stale, different, unschedulable, overrun
inline constexpr int kExitInvalid = 2;   ///< no answer: usage, unreadable or invalid input, missing tool
inline constexpr int kExitInternal = 3;  ///< a defect of this program

}  // namespace finemote::gen
