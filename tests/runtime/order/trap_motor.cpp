#include "trap.hpp"

namespace order {

finemote::Ordered<Part> motor{1};

}  // namespace order
