#!/usr/bin/env bash
# translations_test.sh SOURCE: the translations keep to the pages they translate, and each way not to is seen.
set -euo pipefail
source=$(realpath "$1")
check=$source/tests/docs/translations.py
failed=0

fail() { printf 'FAILED %s\n' "$*"; failed=1; }

# sees WHAT PATTERN SED_COMMAND FILE: after this edit of a copy the check fails, and says so.
sees() {
  local copy said
  copy=$(mktemp -d)
  cp --parents README.md README.zh-CN.md docs/tutorial.md docs/zh/tutorial.md "$copy"
  sed -i "$3" "$copy/$4"
  cmp -s "$4" "$copy/$4" && fail "$1: the edit changes nothing"
  if said=$(python3 "$check" "$copy"); then fail "$1: not seen"; fi
  grep -q -- "$2" <<<"$said" || fail "$1: no '$2' in: $said"
  rm -rf "$copy"
}

cd "$source"
python3 "$check" "$source" || fail "the translations"
sees "the English page changed" "README.md has changed since" '$s/$/ Or not./' README.md
sees "no stamp" "no line <!-- translation of README.md" '/^<!-- translation/d' README.zh-CN.md
sees "a heading is missing" "x heading, in English" '/^## 3/d' docs/zh/tutorial.md
sees "a heading of another level" "heading 2 is '###'" '0,/^## /s/^## /### /' docs/zh/tutorial.md
sees "another command" "block of code" 's/^\$ finemote tree diver.urdf/$ finemote tree/' docs/zh/tutorial.md
sees "another file" "block of code" 's/file: src.dive.json/file: src\/sink.json/' docs/zh/tutorial.md
sees "another link" "link 1 is" '0,/README.zh-CN.md#/s/README.zh-CN.md#[^)]*/README.zh-CN.md#许可证/' docs/zh/tutorial.md
sees "a link is missing" "x link, in English" 's/：\[上板\]([^)]*)//' docs/zh/tutorial.md
exit $failed
