#include "generator/descriptor/cpp_words.hpp"

#include <algorithm>
#include <array>

namespace finemote::gen {
namespace {

/// C++17 keywords, alternative tokens and what later standards add (generated code should compile as those too).
constexpr std::array kKeywords{
    "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
    "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
    "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
    "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
    "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
    "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
    "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
    "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
    "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
    "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
    "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
    "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
    "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
    "xor_eq"};

/// Macros of the C library and of compilers in their GNU modes.
constexpr std::array kMacros{"NULL",       "EOF",
                             "assert",     "errno",
                             "stdin",      "stdout",
                             "stderr",     "offsetof",
                             "setjmp",     "signbit",
                             "isnan",      "isinf",
                             "isfinite",   "isnormal",
                             "fpclassify", "unix",
                             "linux",      "i386",
                             "INFINITY",   "NAN",
                             "HUGE_VAL",   "HAVE_INITFINI_ARRAY",
                             "strdupa",    "strndupa"};

/// `UINT8_MAX`, `INT_FAST16_WIDTH`, `WCHAR_MIN`, `UINT64_C` and the like: macros of <cstdint>, which every generated
/// file includes.
bool is_limit_macro(std::string_view name) {
  const auto drop = [&](std::string_view front) {
    const bool has = name.substr(0, front.size()) == front;
    if (has) name.remove_prefix(front.size());
    return has;
  };
  constexpr std::array kWhole{"PTRDIFF", "SIZE", "SIG_ATOMIC", "WCHAR", "WINT"};
  if (std::none_of(kWhole.begin(), kWhole.end(), drop)) {
    drop("U");
    if (!drop("INT")) return false;
    if (!drop("PTR") && !drop("MAX")) {
      if (!drop("_LEAST")) drop("_FAST");
      constexpr std::array kBits{"8", "16", "32", "64"};
      if (std::none_of(kBits.begin(), kBits.end(), drop)) return false;
    }
  }
  return name == "_MIN" || name == "_MAX" || name == "_WIDTH" || name == "_C";
}

/// `ATOMIC_BOOL_LOCK_FREE` and the like: macros of <atomic>.
bool is_atomic_macro(std::string_view name) {
  const auto ends = [&](std::string_view end) { return name.size() > end.size() && name.ends_with(end); };
  return name.starts_with("ATOMIC_") && (ends("_LOCK_FREE") || ends("_INIT"));
}

template <typename List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

}  // namespace

std::optional<std::string> invalid_name(std::string_view cpp) {
  if (cpp.empty()) return "is empty";
  if (contains(kKeywords, cpp)) return "is a keyword of C++";
  if (cpp == "main") return "is where a C++ program begins";
  if (contains(kMacros, cpp) || is_limit_macro(cpp) || is_atomic_macro(cpp))
    return "is a macro of the C library or of a compiler";
  if (cpp.find("__") != std::string_view::npos) return "has two underscores in a row, which C++ keeps for itself";
  if (cpp.size() > 1 && cpp[0] == '_' && cpp[1] >= 'A' && cpp[1] <= 'Z')
    return "begins with an underscore and a capital, which C++ keeps for itself";
  if (std::none_of(cpp.begin(), cpp.end(), is_letter_or_digit)) return "has neither letter nor digit";
  if (cpp.substr(0, 9) == "FINEMOTE_") return "begins as the macros of FineMote do";
  return {};
}

}  // namespace finemote::gen
