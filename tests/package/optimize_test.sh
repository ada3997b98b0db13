#!/usr/bin/env bash
# Firmware starts with any level of optimisation, also with its code in SRAM: what copies the code calls nothing of it before.
. "$(dirname "$0")/common.sh"
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
cp -r "$here/rover" "$work/p"
cat >"$work/p/CMakeLists.txt" <<'X'
cmake_minimum_required(VERSION 3.25)
project(p LANGUAGES CXX)
find_package(finemote REQUIRED)
finemote_add_firmware(p INPUT rover.urdf.xacro OPTIMIZE -O0 CODE sram)
X
holds "configures" configure_board p
holds "builds" ninja -C "$work/p/build" p.elf
calls=$(arm-none-eabi-objdump -d --disassemble=finemote_boot_copy "$work/p/build/p.elf" | sed -nE 's/.*\sblx?\s.*<(.*)>.*/\1/p' | sort -u)
case $calls in '' | finemote_reset | *finemote_reset_veneer) ;; *) fail "what copies the code calls: $calls" ;; esac
holds "runs" finemote-emulator --image "$work/p/build/p.elf" --board robomaster_type_c --duration 50ms
grep -q ' 0 resets' "$work/said" || fail "it does not run: $(tail -n 20 "$work/said")"
