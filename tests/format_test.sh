#!/usr/bin/env bash
# Every source is laid out as .clang-format says. Versions of clang-format disagree in details: only Debian 12's judges.
set -euo pipefail
cd "$(dirname "$0")/.."
if ! clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
  echo "skipped: needs clang-format 14"
  exit 77
fi
if ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  echo "skipped: needs the git work tree"
  exit 77
fi
# What the generator writes, and what stands for it in tests, has a layout of its own; templates of C++ are no C++ yet.
git ls-files '*.cpp' '*.hpp' |
  grep -v -e '^templates/scaffold/' -e '^tests/golden/' -e '^tests/bench/rov14/' -e '^tests/runtime/sample/' -e '^tests/firmware/images/' -e '^runtime/boards/[a-z0-9_]*/generated/' |
  xargs -n 40 clang-format --dry-run --Werror
echo "all sources are formatted"
