// Reads where there is nothing, and waits for ever in the routine of the fault.
#include "registers.hpp"

int main() {
  touch(0x60000000);
  return 0;
}
