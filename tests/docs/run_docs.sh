#!/usr/bin/env bash
# run_docs.sh PREFIX SOURCE: follows each page as somebody would who has FineMote installed at PREFIX. Saves the files it shows
# (<!-- file: NAME --> before a code block) and runs the commands of its console blocks ("$ command"), each in the folder where
# the one before ended. Lines below a command are lines that it prints, in their order, with others between them; a number may
# have fewer digits than the one printed. Also checks that links lead somewhere. Translations have the commands of what they
# translate (translations.py): of them the links alone.
set -euo pipefail
prefix=$(realpath "$1")
source=$(realpath "$2")
here=$(cd "$(dirname "$0")" && pwd)
PATH=$prefix/bin:$PATH
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
passed=0
failed=0

fail() { printf 'FAILED %s\n' "$*"; failed=$((failed + 1)); }

# What was shown below the last command is what it printed.
check_shown() {
  [ -s "$folder/.shown" ] || return 0
  if awk -f "$here/shown.awk" "$folder/.shown" "$folder/.said"; then passed=$((passed + 1)); else fail "$1: what it shows"; fi
  : >"$folder/.shown"
}

run_command() {
  check_shown "$1"
  if (cd "$where" && bash -c "$2"$'\n''status=$?; pwd >"$0"; exit $status' "$folder/.where") >"$folder/.said" 2>&1; then
    passed=$((passed + 1))
    where=$(cat "$folder/.where")
  else
    fail "$1: $2"
    cat "$folder/.said"
  fi
}

run_page() {
  local page=$1 folder where line in_block= file= pending=
  folder=$(mktemp -d)
  mkdir "$folder/page"
  where=$folder/page
  : >"$folder/.shown"
  while IFS= read -r line; do
    case $in_block:$line in
      :'<!-- file: '*) pending=${line#'<!-- file: '}; pending=${pending%' -->'} ;;
      :'```console') in_block=console ;;
      :'```'*) in_block=text; file=$pending; pending=; [ -z "$file" ] || { mkdir -p "$(dirname "$where/$file")"; : >"$where/$file"; } ;;
      ?*:'```') check_shown "$page"; in_block=; file= ;;
      console:'$ '*) run_command "$page" "${line#'$ '}"; in_block=shown ;;
      shown:'$ '*) run_command "$page" "${line#'$ '}" ;;
      shown:...) ;;
      shown:*) printf '%s\n' "$line" >>"$folder/.shown" ;;
      text:*) [ -z "$file" ] || printf '%s\n' "$line" >>"$where/$file" ;;
    esac
  done <"$source/$page"
  rm -rf "$folder"
}

check_links() {
  local page=$1 target
  while IFS= read -r target; do
    case $target in http*|'#'*) continue ;; esac
    if [ -e "$source/$(dirname "$page")/${target%%#*}" ]; then passed=$((passed + 1)); else fail "$page: no $target"; fi
  done < <(awk '/^```/ { code = !code } !code' "$source/$page" | grep -o '](\([^)]*\))' | sed 's/^](//; s/)$//')
}

while IFS= read -r page; do
  case $page in README.zh-CN.md | docs/zh/*) ;; *) run_page "$page" ;; esac
  check_links "$page"
done < <(cd "$source" && { ls README*.md; find docs -name '*.md' | sort; })
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
