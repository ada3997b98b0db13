// Which generated sources this runtime compiles.
#pragma once

namespace finemote {

/// Rises when sources of an older generator no longer compile with the runtime, or no longer mean the same. 2: members
/// of Config are assigned by name. 3: bounds that are missing say why; a slot on CAN knows its part of a shared frame.
inline constexpr int kGeneratedFormat = 3;

}  // namespace finemote
