// Must not compile, and must say why: see crossing_size in CMakeLists.txt.
#include "finemote/latch.hpp"

struct AtTheLimit {
  unsigned char bytes[128];
};
struct TooLarge {
  unsigned char bytes[129];
};

finemote::LatchToFast<AtTheLimit> compiles;
finemote::LatchToFast<TooLarge> does_not;
