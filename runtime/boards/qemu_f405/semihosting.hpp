// Arm semihosting: the image talks to QEMU (Semihosting for AArch32 and AArch64, Arm 100863).
#pragma once

#include <cstdint>

namespace finemote::qemu_f405 {

/// Writes a zero-terminated text (SYS_WRITE0).
void write(const char* text);

/// Ends QEMU with this exit status (SYS_EXIT_EXTENDED).
[[noreturn]] void exit(int status);

}  // namespace finemote::qemu_f405
