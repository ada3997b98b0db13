#include "generator/model/names.hpp"

#include <algorithm>
#include <array>

namespace finemote::gen {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Names the C library declares beside a robot's namespace.
constexpr std::array kLibrary{
    "abort",  "abs",     "acos",    "acosh",     "asin",      "asinh",  "atan",   "atan2",   "atanh",    "atexit",
    "atof",   "atoi",    "atol",    "bsearch",   "calloc",    "cbrt",   "ceil",   "clock",   "copysign", "cos",
    "cosh",   "ctime",   "div",     "div_t",     "erf",       "exit",   "exp",    "exp2",    "expm1",    "fabs",
    "fdim",   "ffs",     "floor",   "fma",       "fmax",      "fmin",   "fmod",   "fopen",   "free",     "frexp",
    "gamma",  "getenv",  "hypot",   "ilogb",     "index",     "j0",     "j1",     "jn",      "labs",     "ldexp",
    "ldiv",   "log",     "log10",   "log2",      "logb",      "lrint",  "lround", "malloc",  "memchr",   "memcmp",
    "memcpy", "memmove", "memset",  "modf",      "nearbyint", "pow",    "printf", "puts",    "qsort",    "raise",
    "rand",   "random",  "realloc", "remainder", "remove",    "remquo", "rename", "rindex",  "rint",     "round",
    "scalb",  "scalbln", "select",  "signal",    "sin",       "sinh",   "size_t", "sprintf", "sqrt",     "srand",
    "strcat", "strchr",  "strcmp",  "strcpy",    "strlen",    "strtod", "strtol", "system",  "tan",      "tanh",
    "tgamma", "time",    "time_t",  "trunc",     "y0",        "y1",     "yn"};

template <typename List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// `run_5ms` for prefix `run_`: a number and a unit of time follow.
bool is_period_name(std::string_view name, std::string_view prefix) {
  if (name.substr(0, prefix.size()) != prefix) return false;
  name.remove_prefix(prefix.size());
  const std::size_t digits =
      static_cast<std::size_t>(std::find_if_not(name.begin(), name.end(), is_digit) - name.begin());
  constexpr std::array kUnits{"s", "ms", "us", "ns"};
  return digits > 0 && contains(kUnits, name.substr(digits));
}

/// Names Windows keeps for devices in every folder, whatever the extension: such a file cannot be made there, and a
/// repository that holds one cannot be checked out. Source: Microsoft, "Naming Files, Paths, and Namespaces".
bool is_windows_device(std::string_view name) {
  const std::string folded = fold_case(name);
  if (contains(std::array{"con", "prn", "aux", "nul"}, folded)) return true;
  const bool is_numbered = folded.rfind("com", 0) == 0 || folded.rfind("lpt", 0) == 0;
  return is_numbered && folded.size() == 4 && folded[3] >= '1' && folded[3] <= '9';
}

}  // namespace

std::string cpp_name(std::string_view text) {
  std::string name = !text.empty() && is_digit(text.front()) ? "n_" : "";
  for (const char c : text) name += is_digit(c) || is_letter(c) ? c : '_';
  return name;
}

std::optional<std::string> reserved_name(std::string_view cpp, NameScope scope) {
  constexpr std::array kOutermost{"finemote", "std"};
  constexpr std::array kInRobot{"slots",           "constants",   "bounds",       "start_buses",
                                "supervise_buses", "buses_quiet", "safe_outputs", "buckets",
                                "kBuckets",        "kOrder",      "kMonitored"};
  constexpr std::array kInTree{"ports", "slots", "constants", "Stage", "stage"};
  if (scope == NameScope::tree_file && contains(std::array{"buses", "constants"}, fold_case(cpp)))
    return "names a generated file that its tree's file includes";
  if (scope == NameScope::file || scope == NameScope::tree_file)
    return is_windows_device(cpp) ? std::optional<std::string>("is a reserved file name on Windows") : std::nullopt;
  if (contains(kOutermost, cpp)) return "is a namespace generated code uses";
  if (cpp.substr(0, 9) == "finemote_") return "begins as names of the runtime do";
  if (scope == NameScope::robot && cpp.front() == '_')
    return "begins with an underscore, which C++ keeps for itself in the outermost namespace";
  if (scope == NameScope::robot && contains(kLibrary, cpp)) return "is a name of the C library";
  const bool taken = (scope == NameScope::in_robot && (contains(kInRobot, cpp) || is_period_name(cpp, "run_"))) ||
                     (scope == NameScope::in_tree &&
                      (contains(kInTree, cpp) || is_period_name(cpp, "update_") || is_period_name(cpp, "handle_")));
  if (taken) return "is a name of generated code";
  return {};
}

std::string fold_case(std::string_view text) {
  std::string folded(text);
  for (char& c : folded) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return folded;
}

}  // namespace finemote::gen
