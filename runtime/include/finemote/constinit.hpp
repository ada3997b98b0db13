// Marks an object that must be initialised at compile time, so that no code runs for it before main.
#pragma once

/// C++20 calls this `constinit`; the generated code is C++17, where the compilers offer it under their own names.
/// A class whose constructor cannot be evaluated at compile time is then an error at the object, not a hidden start-up
/// call.
#if defined(__cpp_constinit)
#define FINEMOTE_CONSTINIT constinit
#elif defined(__clang__)
#define FINEMOTE_CONSTINIT [[clang::require_constant_initialization]]
#elif defined(__GNUC__) && __GNUC__ >= 10
#define FINEMOTE_CONSTINIT __constinit
#else
#error "finemote needs GCC 10, clang or C++20 for constant-initialised objects"
#endif
