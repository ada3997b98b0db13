// Child before parent, both inline, both visible wherever the header is.
#pragma once

#include "part.hpp"

namespace order {

inline finemote::Ordered<Part> motor{1};
inline finemote::Ordered<Part> arm{motor};
inline finemote::Ordered<Part> body{arm};

inline constexpr finemote::OrderCheck checks[] = {
    {motor.construction_number(), arm.construction_number(), "motor", "arm"},
    {arm.construction_number(), body.construction_number(), "arm", "body"},
};

}  // namespace order
