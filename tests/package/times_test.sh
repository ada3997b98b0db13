#!/usr/bin/env bash
# A firmware whose stages take longer than the robot's timing file says does not link.
. "$(dirname "$0")/common.sh"
new_project rover
# Without wheels, whose type keeps the core busy for a time that nothing bounds.
sed -i '/<xacro:wheel /d' "$work/rover/rover.urdf.xacro"
sed -i 's/if (wheels_.size() > 0) //' "$work/rover/devices/meter.cpp"
robot=$work/rover/rover.urdf.xacro times=$work/rover/rover.timing.json
holds "configures" configure_board rover
holds "builds without times" ninja -C "$work/rover/build" rover.elf
holds "bounds" finemote wcet "$robot" -o "$times"
holds "a static robot" finemote analyze "$robot" --require-static
holds "sources" finemote generate "$robot" -o "$work/out"
holds "fresh sources" finemote check "$robot" -o "$work/out"
holds "builds within its times" ninja -C "$work/rover/build" rover.elf
grep -q 'Linking CXX executable rover.elf' "$work/said" || fail "a new timing file: nothing was held to it"
bound() { sed -n '/"device": "rover"/,/wcet_ns/s/.*"wcet_ns": \([0-9]*\),/\1/p' "$times" | head -1; }
granted=$(bound)
[ "${granted:-0}" -gt 0 ] || fail "no bound of the rover in $(cat "$times")"

# An image with other periods is none of this robot.
refuses "bounds of an image with other periods" "has periods of 10 ms, and 'rover' of 20 ms: it was built from another version" \
  finemote wcet "$robot" period:=20ms --elf "$work/rover/build/rover.elf"

sed -i 's/++jobs_;/for (int volatile i = 0; i < 9; ++i) ++jobs_;/' "$work/rover/devices/meter.cpp"
grep -q 'volatile i' "$work/rover/devices/meter.cpp" || fail "no loop in meter.cpp"
refuses "a loop in a device" "rover.update can take [0-9]* ns, $granted ns are granted" ninja -C "$work/rover/build" rover.elf
refuses "check" "stale-timing" finemote check "$robot" -o "$work/out"
holds "bounds anew" finemote wcet "$robot" -o "$times"
[ "$(bound)" -gt "$granted" ] || fail "the loop costs nothing: $(bound)"
holds "builds again" ninja -C "$work/rover/build" rover.elf

sed -i 's/i < 9/i < static_cast<int>(jobs_)/' "$work/rover/devices/meter.cpp"
refuses "a loop without a bound" "rover.update has no bound any more" ninja -C "$work/rover/build" rover.elf
sed -i 's/i < static_cast<int>(jobs_)/i < 9/' "$work/rover/devices/meter.cpp"
holds "bounds of the loop again" finemote wcet "$robot" -o "$times"
holds "builds with the loop" ninja -C "$work/rover/build" rover.elf

# What runs around the stages counts as they do.
cp "$times" "$work/times"
sed -i '/"what": "release"/{n;s/: [0-9]*/: 5/}' "$times"
cmp -s "$times" "$work/times" && fail "no release in $times"
refuses "a longer release" "release can take [0-9]* ns, 5 ns are granted" ninja -C "$work/rover/build" rover.elf
cp "$work/times" "$times"

# They are of one image. Another one is refused before it is built, and one of a board that stands in is held to nothing.
lists=$work/rover/CMakeLists.txt
cp "$lists" "$work/lists"
with() { sed "s/finemote_add_firmware(rover INPUT rover.urdf.xacro/& $*/" "$work/lists" >"$lists"; }
with OPTIMIZE -O2
grep -q 'OPTIMIZE -O2' "$lists" || fail "no firmware rover in $lists"
refuses "another optimisation" "bounds the code of -Os, not of -O2: leave out OPTIMIZE" configure_board rover
with CODE flash
refuses "another place" 'bounds code in sram, not in flash: instead of CODE write <param name="code">flash</param>' \
  configure_board rover
with BOARD qemu_f405
holds "a board that stands in" configure_board rover
holds "an image for it" ninja -C "$work/rover/build" rover.elf

# The robot's own board is the same as none. With other arguments the file is of another robot, as it is for the sources.
holds "a robot on its own board" finemote analyze "$robot" --board robomaster_type_c --require-static
with BOARD robomaster_type_c
holds "the robot's own board" configure_board rover
holds "an image for it" ninja -C "$work/rover/build" rover.elf
! grep -q 'held to nothing' "$work/said" || fail "the robot's own board: held to nothing"
with ARGS period:=20ms
holds "other arguments" configure_board rover
holds "an image for them" ninja -C "$work/rover/build" rover.elf
grep -q 'rover.timing.json is of other arguments or another board: this image is held to nothing' "$work/said" || fail "other arguments: held"
cp "$work/lists" "$lists"

# Nobody knows how often it runs.
echo 'extern "C" void finemote_line_28() {}' > "$work/rover/devices/mine.cpp"
refuses "bounds with an interrupt of nobody" "finemote_line_28.*nobody knows how often it runs" finemote wcet "$robot"
holds "configures anew" configure_board rover
refuses "an interrupt of nobody" "finemote_line_28: no bus, pin or job" ninja -C "$work/rover/build" rover.elf
