#!/usr/bin/env bash
# run_docs.sh FINEMOTE SOURCE: saves the files a page shows (<!-- file: NAME --> before a code block) and runs the commands
# of its console blocks ("$ command"), as somebody who follows the page would. Also checks that links lead somewhere.
set -euo pipefail
finemote=$(realpath "$1")
source=$(realpath "$2")
PATH=$(dirname "$finemote"):$PATH
passed=0
failed=0

fail() { printf 'FAILED %s\n' "$*"; failed=$((failed + 1)); }

run_page() {
  local page=$1 folder line in_block= file= pending=
  folder=$(mktemp -d)
  while IFS= read -r line; do
    case $in_block:$line in
      :'<!-- file: '*) pending=${line#'<!-- file: '}; pending=${pending%' -->'} ;;
      :'```console') in_block=console ;;
      :'```'*) in_block=text; file=$pending; pending=; [ -z "$file" ] || { mkdir -p "$(dirname "$folder/$file")"; : >"$folder/$file"; } ;;
      ?*:'```') in_block=; file= ;;
      console:'$ '*)
        if (cd "$folder" && bash -c "${line#'$ '}") >"$folder/.said" 2>&1; then
          passed=$((passed + 1))
        else
          fail "$page: ${line#'$ '}"
          cat "$folder/.said"
        fi ;;
      text:*) [ -z "$file" ] || printf '%s\n' "$line" >>"$folder/$file" ;;
    esac
  done <"$source/$page"
  rm -rf "$folder"
}

check_links() {
  local page=$1 target
  while IFS= read -r target; do
    case $target in http*|'#'*) continue ;; esac
    if [ -e "$source/$(dirname "$page")/${target%%#*}" ]; then passed=$((passed + 1)); else fail "$page: no $target"; fi
  done < <(grep -o '](\([^)]*\))' "$source/$page" | sed 's/^](//; s/)$//')
}

while IFS= read -r page; do
  run_page "$page"
  check_links "$page"
done < <(cd "$source" && { echo README.md; find docs -name '*.md' | sort; })
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
