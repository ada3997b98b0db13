// Names of headers that come with a compiler: newlib 3.3 and libstdc++ 12, and folders of theirs.
#pragma once

#include <string_view>

namespace finemote::gen {

// clang-format off
inline constexpr std::string_view kStandardHeaders[] = {
    "_ansi.h", "_newlib_version.h", "_syslist.h", "algorithm", "alloca.h", "any", "ar.h", "argz.h", "arm_acle.h",
    "arm_bf16.h", "arm_cde.h", "arm_cmse.h", "arm_fp16.h", "arm_mve.h", "arm_mve_types.h", "arm_neon.h", "array",
    "assert.h", "atomic", "barrier", "bit", "bitset", "cassert", "ccomplex", "cctype", "cerrno", "cfenv", "cfloat",
    "charconv", "chrono", "cinttypes", "ciso646", "climits", "clocale", "cmath", "codecvt", "compare", "complex",
    "complex.h", "concepts", "condition_variable", "coroutine", "cpio.h", "csetjmp", "csignal", "cstdalign",
    "cstdarg", "cstdbool", "cstddef", "cstdint", "cstdio", "cstdlib", "cstring", "ctgmath", "ctime", "ctype.h",
    "cuchar", "cwchar", "cwctype", "cxxabi.h", "deque", "devctl.h", "dirent.h", "elf.h", "envlock.h", "envz.h",
    "errno.h", "exception", "execution", "expected", "fastmath.h", "fcntl.h", "fenv.h", "filesystem", "float.h",
    "fnmatch.h", "forward_list", "fstream", "functional", "future", "getopt.h", "glob.h", "grp.h", "iconv.h",
    "ieeefp.h", "initializer_list", "inttypes.h", "iomanip", "ios", "iosfwd", "iostream", "iso646.h", "istream",
    "iterator", "langinfo.h", "latch", "libgen.h", "limits", "limits.h", "list", "locale", "locale.h", "malloc.h",
    "map", "math.h", "memory", "memory.h", "memory_resource", "mmintrin.h", "mutex", "ndbm.h", "new", "newlib.h",
    "numbers", "numeric", "optional", "ostream", "paths.h", "pthread.h", "pwd.h", "queue", "random", "ranges",
    "ratio", "reent.h", "regdef.h", "regex", "regex.h", "sched.h", "scoped_allocator", "search.h", "semaphore",
    "set", "setjmp.h", "shared_mutex", "signal.h", "source_location", "span", "spanstream", "spawn.h", "sstream",
    "stack", "stacktrace", "stdalign.h", "stdarg.h", "stdatomic.h", "stdbool.h", "stddef.h", "stdexcept",
    "stdfix.h", "stdint.h", "stdio.h", "stdio_ext.h", "stdlib.h", "stdnoreturn.h", "stop_token", "streambuf",
    "string", "string.h", "string_view", "strings.h", "syncstream", "system_error", "tar.h", "termios.h",
    "tgmath.h", "thread", "threads.h", "time.h", "tuple", "type_traits", "typeindex", "typeinfo", "unctrl.h",
    "unistd.h", "unordered_map", "unordered_set", "unwind-arm-common.h", "unwind.h", "utility", "utime.h", "utmp.h",
    "valarray", "varargs.h", "variant", "vector", "version", "wchar.h", "wctype.h", "wordexp.h",
};
// clang-format on

inline constexpr std::string_view kStandardFolders[] = {
    "backward", "bits", "debug", "decimal", "experimental", "ext", "machine",
    "parallel", "pstl", "rpc",   "ssp",     "sys",          "tr1", "tr2",
};

}  // namespace finemote::gen
