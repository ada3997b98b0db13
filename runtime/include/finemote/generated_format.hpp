// Which generated sources this runtime compiles.
#pragma once

namespace finemote {

/// Rises when sources of an older generator no longer compile with the runtime, or no longer mean the same. 2: members
/// of Config are assigned by name, and a slot on CAN knows its part of a shared frame.
inline constexpr int kGeneratedFormat = 2;

}  // namespace finemote
