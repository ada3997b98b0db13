#!/usr/bin/env bash
# After a change the build makes exactly what depends on it, and without one it makes nothing.
. "$(dirname "$0")/common.sh"
new_project rover
holds "configures" configure_board rover
holds "builds" cmake --build "$work/rover/build" --target rover committed

# The steps of a build, sorted, without numbers: `objects of rover` has the files, for example.
steps() {
  ninja -C "$work/rover/build" rover committed >"$work/said" || { cat "$work/said"; fail "build"; }
  sed -nE 's/^\[[0-9/]+\] //p' "$work/said" | sed -E '/^Re-checking globbed directories/d' | sed -E 's/Building CXX object CMakeFiles\/([a-z]+)\.dir\//\1: /' | sort | paste -sd '|'
}
touched() {
  sleep 0.05
  touch "$1"
}
generated='Generating the sources of rover'

equal "nothing is touched" "$(steps)" ""
for input in rover.urdf.xacro wheels.xacro devices/meter.json; do
  touched "$work/rover/$input"
  equal "$input is touched, its bytes stay" "$(steps)" "$generated|Re-running CMake..."
done
for input in share/finemote/schemas/boards/robomaster_type_c.json share/finemote/schemas/chips/stm32f407.json \
  share/finemote/templates/tree.cpp.mustache bin/finemote; do
  touched "$prefix/$input"
  equal "$input is touched" "$(steps)" "$generated"
done
equal "and then nothing" "$(steps)" ""

touched "$work/rover/devices/meter.cpp"
equal "a source of the robot's own" "$(steps)" \
  "Linking CXX executable committed.elf|Linking CXX executable rover.elf|committed: devices/meter.cpp.obj|rover: devices/meter.cpp.obj"
touched "$work/rover/generated/trees/rover.cpp"
equal "a committed source" "$(steps)" "Linking CXX executable committed.elf|committed: generated/trees/rover.cpp.obj"
touched "$prefix/share/finemote/runtime/boards/robomaster_type_c/generated/board_sram.ld"
equal "the linker script" "$(steps)" "Linking CXX executable committed.elf|Linking CXX executable rover.elf"

# A comment in the URDF changes the manifest alone: nothing is compiled.
sed -i 's/Every kind of input/Each kind of input/' "$work/rover/rover.urdf.xacro"
equal "a comment" "$(steps)" "$generated|Re-running CMake..."
equal "and then nothing" "$(steps)" ""

# Settings beside the robot count as soon as they are there, and no more when they are gone.
settings=$work/rover/finemote.json
echo '{ "allow": ["FM3153"] }' >"$settings"
equal "settings are new" "$(steps)" "$generated|Re-running CMake..."
equal "and then nothing" "$(steps)" ""
echo '{ "arguments": { "period": "40ms" } }' >"$settings"
said=$(steps)
case $said in "$generated|"*"rover: rover.generated/trees/rover.cpp.obj"*) ;; *) fail "another argument: $said" ;; esac
rm "$settings"
said=$(steps)
case $said in "$generated|"*"rover: rover.generated/trees/rover.cpp.obj"*) ;; *) fail "no settings any more: $said" ;; esac
equal "and then nothing" "$(steps)" ""

# Another tree is a new file; committed sources are never written.
sed -i 's|</finemote>|<device name="second" type="sim_load" period="20ms"/></finemote>|' "$work/rover/rover.urdf.xacro"
said=$(steps)
case $said in *"rover: rover.generated/trees/second.cpp.obj"*) ;; *) fail "another tree: $said" ;; esac
case $said in *committed:*) fail "committed sources were compiled: $said" ;; esac
[ ! -e "$work/rover/generated/trees/second.cpp" ] || fail "committed sources were written"
equal "and then nothing" "$(steps)" ""
refuses "the test of the committed sources" "stale" ctest --test-dir "$work/rover/build" --output-on-failure -R committed-check
holds "committed-generate" ninja -C "$work/rover/build" committed-generate
said=$(steps)
case $said in *"committed: generated/trees/second.cpp.obj"*) ;; *) fail "after committed-generate: $said" ;; esac
holds "the test of the committed sources" ctest --test-dir "$work/rover/build" -R committed-check --no-tests=error

# A robot with a mistake stops the build with the message of the generator; mended, it goes on.
cp "$work/rover/wheels.xacro" "$work/wheels.xacro"
sed -i 's/sim_load/sim_lode/' "$work/rover/wheels.xacro"
refuses "a mistake" "did you mean 'sim_load'" ninja -C "$work/rover/build"
cp "$work/wheels.xacro" "$work/rover/wheels.xacro"
holds "a mended mistake" ninja -C "$work/rover/build" rover
