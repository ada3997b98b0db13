#!/usr/bin/env bash
# The targets beside a firmware, with programs that record how they are called instead of OpenOCD and gdb.
. "$(dirname "$0")/common.sh"
for program in openocd gdb; do
  printf '#!/bin/sh\nfor word in "$@"; do printf "%%s\\n" "$word"; done >"%s/%s.words"\n' "$work" "$program" >"$work/$program"
  chmod +x "$work/$program"
done
new_project rover
holds "configures" configure_board rover -DFINEMOTE_OPENOCD="$work/openocd" -DFINEMOTE_GDB="$work/gdb"
build=$work/rover/build
run() { holds "target $1" ninja -C "$build" "$1"; }

for target in rover committed traced rover-hex rover-bin rover-size rover-flash rover-debug rover-generate committed-flash \
  hex bin size flash debug generate; do
  run $target
done
holds "the image is an ELF file" arm-none-eabi-readelf -h "$build/rover.elf"
cfg=$prefix/share/finemote/templates/project/openocd/stlink.cfg
ninja -C "$build" flash >/dev/null
equal "flash" "$(paste -sd ' ' "$work/openocd.words")" "-f $cfg -c program {$build/rover.elf} verify reset exit"
grep -q "extended-remote | .*-f '$cfg' -c 'gdb_port pipe'" "$work/gdb.words" || fail "debug: $(cat "$work/gdb.words")"
refuses "rtt without a trace" "add TRACE" ninja -C "$build" rtt
run traced-rtt
address=$(arm-none-eabi-nm "$build/traced.elf" | sed -n 's/^\([0-9a-f]*\) . _SEGGER_RTT$/\1/p')
equal "rtt" "$(paste -sd ' ' "$work/openocd.words")" "-c set WORKAREASIZE 0 -f $cfg -c init -c rtt setup 0x$address 16 \
\"SEGGER RTT\" -c rtt polling_interval 1 -c rtt start -c rtt server start 9090 0"

# A robot that was edited since its committed sources were made: it can be built, and does not go to a board unless one wants to.
wheel='<xacro:wheel name="right"/>'
sed -i "s|$wheel|<xacro:wheel name=\"third\"/>|" "$work/rover/rover.urdf.xacro"
run committed
rm "$work/openocd.words"
for what in flash debug hex bin; do
  refuses "$what of a stale image" "stale" ninja -C "$build" committed-$what
done
[ ! -e "$work/openocd.words" ] || fail "a stale image was flashed"
holds "stale images are wanted" cmake -DFINEMOTE_FLASH_STALE=ON "$build"
run committed-flash
holds "stale images are not wanted" cmake -DFINEMOTE_FLASH_STALE=OFF "$build"
sed -i "s|<xacro:wheel name=\"third\"/>|$wheel|" "$work/rover/rover.urdf.xacro"
run committed-flash

# The configuration of the project comes first, and probes have names.
mkdir "$work/rover/openocd"
cp "${cfg%/*}/jlink.cfg" "$work/rover/openocd/"
holds "another probe" cmake -DFINEMOTE_PROBE=jlink "$build"
run flash
equal "the project's probe" "$(sed -n 2p "$work/openocd.words")" "$work/rover/openocd/jlink.cfg"
refuses "an unknown probe" "known are stlink, cmsis-dap and jlink" cmake -DFINEMOTE_PROBE=stlnk "$build"
holds "the probe again" cmake -DFINEMOTE_PROBE=stlink "$build"

# A program that is not there is named before anything starts.
rm "$work/gdb.words"
holds "no OpenOCD" cmake -DFINEMOTE_OPENOCD= "$build"
refuses "flash without OpenOCD" "needs openocd: apt-get install openocd, then configure again" ninja -C "$build" flash
refuses "debug without OpenOCD" "needs openocd: apt-get install openocd, then configure again" ninja -C "$build" debug
[ ! -e "$work/gdb.words" ] || fail "gdb was started without OpenOCD"
holds "neither" cmake -DFINEMOTE_GDB= "$build"
refuses "debug without both" "needs gdb-multiarch and openocd: apt-get install gdb-multiarch openocd" ninja -C "$build" debug
holds "both again" cmake -DFINEMOTE_OPENOCD="$work/openocd" -DFINEMOTE_GDB="$work/gdb" "$build"

# The flashed bytes are those that `finemote run` judges, the same in every build type, folder and place of finemote.
sum() { sha256sum <"$1" | cut -d ' ' -f 1; }
judged=$(finemote run "$here/rover/rover.urdf.xacro" --build-only --format json)
equal "image.sha256" "$(sum "$build/rover.bin")" "$(sed -n 's/.*"sha256": "\(.*\)".*/\1/p' <<<"$judged")"
ninja -C "$build" size >"$work/said"
flash=$(sed -n 's/.*"flash": \([0-9]*\).*/\1/p' <<<"$judged")
ram=$(sed -n 's/.*"ram": \([0-9]*\).*/\1/p' <<<"$judged")
grep -q "^ *$flash of 32768 .*flash" "$work/said" || fail "size: no $flash in $(cat "$work/said")"
grep -q "^ *$ram of 8192 .*RAM" "$work/said" || fail "size: no $ram in $(cat "$work/said")"
grep -q "^ *[0-9]*  left$" "$work/said" || fail "size: no device 'left' in $(cat "$work/said")"
sed -i 's/FLASH_BUDGET 32768/FLASH_BUDGET 1024/' "$work/rover/CMakeLists.txt"
refuses "a budget" "over budget: bytes of flash" ninja -C "$build" size

new_project elsewhere
cp -r "$prefix" "$work/other_prefix"
PATH=$work/other_prefix/bin:$PATH toolchain=$work/other_prefix/share/finemote/cmake/toolchain-arm-none-eabi.cmake
holds "configures elsewhere" configure_board elsewhere
holds "builds elsewhere" ninja -C "$work/elsewhere/build" rover.elf
equal "the ELF file of another place" "$(sum "$work/elsewhere/build/rover.elf")" "$(sum "$build/rover.elf")"
for type in Debug Release; do
  holds "configures as $type" configure_board elsewhere -DCMAKE_BUILD_TYPE=$type -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wconversion"
  holds "builds as $type" ninja -C "$work/elsewhere/build" rover-bin
  ! grep -i warning "$work/said" || fail "$type: a warning"
  equal "the image as $type" "$(sum "$work/elsewhere/build/rover.bin")" "$(sum "$build/rover.bin")"
done
