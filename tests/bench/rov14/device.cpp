#include "device.hpp"

namespace bench {

void Empty::update() { asm volatile(""); }
void Empty::handle() { asm volatile(""); }

}  // namespace bench
