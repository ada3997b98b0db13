// Lines of assembler that an image has, and a program on a computer has not.
#pragma once

/// An assembler statement. Compilers take it for as short as can be, whatever its text. On a computer it is nothing.
#ifdef __arm__
#define FINEMOTE_ASM(...) asm volatile inline(__VA_ARGS__)
#else
#define FINEMOTE_ASM(...) static_cast<void>(0)
#endif

/// The same, for operands that are constants, or in a register, only where the compiler optimises. Else it is nothing.
#ifdef __OPTIMIZE__
#define FINEMOTE_OPTIMIZED_ASM(...) FINEMOTE_ASM(__VA_ARGS__)
#else
#define FINEMOTE_OPTIMIZED_ASM(...) static_cast<void>(0)
#endif

/// Text of such a statement: puts `words` into a section that tools read and that is no part of what is flashed.
#define FINEMOTE_FOR_TOOLS(section, words) "\n\t.pushsection " section ",\"\",%%progbits\n\t" words "\n\t.popsection"
