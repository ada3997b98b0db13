#!/usr/bin/env bash
# completion_test.sh FINEMOTE: what bash, zsh and fish offer for a line. The three are written from one table by functions of
# their own, and have to offer the same.
set -euo pipefail
finemote=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
PATH=$(dirname "$finemote"):$PATH
shells=(bash)
checks=0
for shell in zsh fish; do
  if command -v "$shell" >/dev/null; then shells+=("$shell"); else echo "$shell is missing: not tested"; fi
done
for shell in "${shells[@]}"; do finemote completion "$shell" >"$work/$shell"; done

fail() { printf 'FAILED %s\n' "$*"; exit 1; }

# offered_by SHELL LINE: the words offered for the last word of the line, which may be empty, sorted.
offered_by() {
  local words last
  IFS=' ' read -ra words <<<"$2"
  case $2 in *' ') words+=('') ;; esac
  last=${words[-1]}
  case $1 in
    bash) bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _finemote; printf "%s\n" "${COMPREPLY[@]}"' \
      - "$work/bash" "${words[@]}" ;;
    zsh) zsh -f "$work/ask.zsh" "$work/zsh" "${words[@]}" | grep -- "^$last" || true ;;
    fish) fish --no-config -c 'source $argv[1]; complete -C "$argv[2]"' "$work/fish" "$2" | cut -f 1 ;;
  esac | sort
}

# Outside of a line that is edited, zsh has none of what a completion is called with.
cat >"$work/ask.zsh" <<'END'
compdef() { :; }
compadd() { print -l -- "${@[2,-1]}"; }
_files() { :; }
source "$1"
shift
words=("$@") CURRENT=$# PREFIX=${@[-1]}
_finemote
END

# offers LINE WORD...: these words and no others are offered by every shell.
offers() {
  local shell expected seen
  expected=$(printf '%s\n' "${@:2}" | sort)
  for shell in "${shells[@]}"; do
    seen=$(offered_by "$shell" "$1")
    [ "$seen" = "$expected" ] || fail "$shell, '$1': offers $(echo $seen), not $(echo $expected)"
    checks=$((checks + 1))
  done
}

offers 'finemote ge' generate
offers 'finemote board ' show sources
offers 'finemote scaffold b' board
offers 'finemote completion ' bash fish zsh
offers 'finemote --format ' text json sarif github gcc
offers 'finemote --color never analyze robot.urdf --profile ' paper tight target
offers 'finemote run --flash m' miss
offers 'finemote -q generate robot.urdf --board q' qemu_f405
offers 'finemote board show st' stm32f4_discovery
offers 'finemote explain FM001' FM0010 FM0011
offers 'finemote schema x' xsd
offers 'finemote check --de' --deny --device-path
offers 'finemote --v' --verbose --version
offers 'finemote generate --v' --verbose

# Every option of every command, as --help has them.
mapfile -t commands < <(finemote man | sed -nE 's/^\.SS \\fB([a-z ]+)\\fR.*/\1/p')
[ ${#commands[@]} -ge 19 ] || fail "only ${#commands[@]} commands in the manual page"
for command in "${commands[@]}"; do
  mapfile -t options < <({ finemote $command --help; finemote --help; } | grep -oE '^  (-[A-Za-z],)?--[a-z-]+' | grep -o -- '--.*' |
    grep -v -- --version | sort -u)
  offers "finemote $command --" "${options[@]}"
done
printf '%d checks\n' "$checks"
