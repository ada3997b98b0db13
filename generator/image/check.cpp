#include "generator/image/check.hpp"

#include <fmt/format.h>

#include "generator/image/sizes.hpp"

namespace finemote::gen {
namespace {

struct Forbidden {
  std::string_view prefix;
  std::string_view brings;
};

// Names of newlib, libsupc++ and the Itanium C++ ABI.
constexpr Forbidden kForbidden[] = {
    {"malloc", "the heap"},
    {"calloc", "the heap"},
    {"realloc", "the heap"},
    {"free", "the heap"},
    {"_malloc_r", "the heap"},
    {"_free_r", "the heap"},
    {"_sbrk", "the heap"},
    {"_Znw", "the heap (operator new)"},
    {"_Zna", "the heap (operator new[])"},
    {"_Zdl", "the heap (operator delete)"},
    {"_Zda", "the heap (operator delete[])"},
    {"__cxa_throw", "exceptions"},
    {"__cxa_begin_catch", "exceptions"},
    {"__cxa_allocate_exception", "exceptions"},
    {"__gxx_personality", "exceptions"},
    {"_Unwind_", "the unwinder"},
    {"__aeabi_unwind_cpp", "the unwinder"},
    {"__cxa_guard_", "local static objects with a guard"},
    {"__cxa_atexit", "destructors of global objects"},
    {"__aeabi_atexit", "destructors of global objects"},
    {"_ZTI", "type information"},
    {"_ZTS", "type information"},
    {"_ZTV", "virtual functions"},
    {"__dynamic_cast", "type information"},
    {"__cxa_pure_virtual", "virtual functions"},
};

// The C names must match whole: a user's `free_slot` is nobody's heap.
bool matches(const std::string& name, std::string_view prefix) {
  const bool whole = prefix.back() != '_' && prefix.substr(0, 2) != "_Z" && prefix.substr(0, 2) != "__";
  return whole ? name == prefix : name.rfind(prefix, 0) == 0;
}

void check_symbols(const Image& image, Diagnostics& diagnostics) {
  for (const ImageSymbol& symbol : image.symbols) {
    if (symbol.section == 0 || symbol.kind == ImageSymbol::Kind::mapping) continue;
    for (const Forbidden& forbidden : kForbidden) {
      if (!matches(symbol.name, forbidden.prefix)) continue;
      diagnostics.error(code::forbidden_symbol, {},
                        fmt::format("the image contains '{}': {}", readable_name(symbol.name), forbidden.brings));
      break;
    }
  }
}

void check_constructors(const Image& image, ImagePromises promises, Diagnostics& diagnostics) {
  if (promises.constructors_allowed) return;
  for (const ImageSection& section : image.sections) {
    if (section.name != ".init_array" || section.size == 0) continue;
    Diagnostic& finding =
        diagnostics.error(code::code_before_main, {}, fmt::format("{} constructors run before main", section.size / 4));
    for (std::uint32_t at = 0; at + 4 <= section.bytes.size(); at += 4) {
      const std::uint32_t target = image.word(section.address + at).value_or(0) & ~1U;
      for (const ImageSymbol& symbol : image.symbols) {
        if (symbol.address == target && symbol.kind == ImageSymbol::Kind::function) {
          finding.note(readable_name(symbol.name));
          break;
        }
      }
    }
  }
}

}  // namespace

void check_image(const Image& image, const StackBound& stack, ImagePromises promises, Diagnostics& diagnostics) {
  check_symbols(image, diagnostics);
  check_constructors(image, promises, diagnostics);
  const std::uint32_t reserved = measure_image(image).stack_reserved;
  if (stack.known && stack.bytes > reserved) {
    diagnostics
        .error(code::stack_too_small, {},
               fmt::format("the stack needs {} bytes in the worst case, but {} are reserved", stack.bytes, reserved))
        .hint(fmt::format("in finemote_add_firmware(...) write STACK {}", rounded_stack(stack.bytes)));
  }
}

}  // namespace finemote::gen
