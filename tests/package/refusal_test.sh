#!/usr/bin/env bash
# What a project can get wrong is said in a sentence.
. "$(dirname "$0")/common.sh"
head='cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES CXX)\nfind_package(finemote REQUIRED)\n'

# project NAME LINE...: a project with these lines.
project() {
  mkdir -p "$work/$1"
  cp -r "$here/rover/." "$work/$1/"
  printf "$head" >"$work/$1/CMakeLists.txt"
  printf '%s\n' "${@:2}" >>"$work/$1/CMakeLists.txt"
}

project no_toolchain 'finemote_add_firmware(p INPUT rover.urdf.xacro)'
refuses "no toolchain file" "board 'robomaster_type_c' needs a compiler for 'arm-none-eabi', and this one is for" \
  cmake -G Ninja -S "$work/no_toolchain" -B "$work/no_toolchain/build"
project device_test 'finemote_add_device_test(t SOURCES meter_test.cpp)'
refuses "a device test for a board" "board 'host' runs on this computer" configure_board device_test
project committed 'finemote_add_firmware(p INPUT rover.urdf.xacro COMMITTED)'
refuses "no committed sources" "there are no generated sources in .*; write them with finemote generate" configure_board committed
finemote -q generate "$work/committed/rover.urdf.xacro" -o "$work/committed/generated"
rm "$work/committed/generated/buses.cpp"
refuses "a committed source is missing" "buses.cpp is missing; write it with finemote generate" configure_board committed
finemote -q generate "$work/committed/rover.urdf.xacro" -o "$work/committed/generated"
holds "committed sources with Makefiles" cmake -G "Unix Makefiles" -S "$work/committed" -B "$work/committed/make" \
  -DCMAKE_TOOLCHAIN_FILE="$toolchain"
project makefiles 'finemote_add_firmware(p INPUT rover.urdf.xacro)'
refuses "Makefiles" "the build needs Ninja: configure with -G Ninja" cmake -G "Unix Makefiles" -S "$work/makefiles" \
  -B "$work/makefiles/build" -DCMAKE_TOOLCHAIN_FILE="$toolchain"
project robot 'finemote_add_firmware(p INPUT rover.urdf.xacro)'
sed -i 's/robomaster_type_c/robomaster_type_d/' "$work/robot/rover.urdf.xacro"
refuses "a robot with a mistake" "did you mean 'robomaster_type_c'.*no firmware can be made of this robot" configure_board robot
project word 'finemote_add_firmware(p INPUT rover.urdf.xacro MONITOR)'
refuses "an unknown word" "finemote_add_firmware(p): unknown 'MONITOR'" configure_board word
project ends 'finemote_add_firmware(p INPUT rover.urdf.xacro DURATION 1s)'
refuses "a run that does not end" "a run on board 'robomaster_type_c' does not end" configure_board ends
project two 'finemote_add_firmware(p INPUT rover.urdf.xacro OUTPUT_DIR out)' 'finemote_add_firmware(q INPUT other.urdf.xacro OUTPUT_DIR out)'
cp "$work/two/rover.urdf.xacro" "$work/two/other.urdf.xacro"
refuses "two robots in one folder" "are those of .*rover.urdf.xacro or of other arguments; give each robot an OUTPUT_DIR of its own" configure_board two
project 'in [a] c++' 'finemote_add_firmware(p INPUT rover.urdf.xacro)'
holds "a folder whose name is no pattern" configure_board 'in [a] c++'
grep -q 'devices/meter.cpp' "$work/in [a] c++/build/build.ninja" || fail "the robot's own sources are left out"
project empty 'finemote_add_firmware(p TRACE)'
refuses "no input" "needs INPUT, or GENERATED and BOARD" configure_board empty
project version 'find_package(finemote 0.99 REQUIRED)'
refuses "another minor version" "version: 0.1" configure_board version
