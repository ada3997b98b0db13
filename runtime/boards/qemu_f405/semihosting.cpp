#include "semihosting.hpp"

namespace finemote::qemu_f405 {
namespace {

constexpr std::uint32_t kWrite0 = 0x04, kExitExtended = 0x20, kApplicationExit = 0x20026;

void call(std::uint32_t operation, const void* argument) {
  asm volatile(
      "mov r0, %0\n\t"
      "mov r1, %1\n\t"
      "bkpt 0xab"
      :
      : "r"(operation), "r"(argument)
      : "r0", "r1", "memory");
}

}  // namespace

void write(const char* text) { call(kWrite0, text); }

void exit(int status) {
  const std::uint32_t block[2] = {kApplicationExit, static_cast<std::uint32_t>(status)};
  call(kExitExtended, block);
  for (;;) {}
}

}  // namespace finemote::qemu_f405
