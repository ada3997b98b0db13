#!/usr/bin/env bash
# A project may have sources of C and of the assembler, whatever the order of its languages.
. "$(dirname "$0")/common.sh"
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
lists='cmake_minimum_required(VERSION 3.25)
find_package(finemote REQUIRED)
finemote_add_firmware(p INPUT rover.urdf.xacro)
target_sources(p PRIVATE plain.c last.S)
target_compile_options(p PRIVATE -Wall -Wextra -Werror)'
objects="CMakeFiles/p.dir/plain.c.obj CMakeFiles/p.dir/last.S.obj"
cp -r "$here/rover" "$work/p"
echo 'int plain(int a) { return a + 1; }' >"$work/p/plain.c"
printf '#ifdef __thumb__\n.syntax unified\n.thumb\n.globl last\nlast: bx lr\n#endif\n' >"$work/p/last.S"
for project in 'project(p LANGUAGES C CXX ASM)' 'project(p LANGUAGES CXX ASM C)' 'project(p)#enable_language(ASM)'; do
  rm -rf "$work/p/build"
  sed "1a${project/\#/\\n}" <<<"$lists" >"$work/p/CMakeLists.txt"
  holds "configures: $project" configure_board p
  holds "compiles: $project" ninja -C "$work/p/build" $objects
  for object in $objects; do
    arm-none-eabi-readelf -h "$work/p/build/$object" | grep -q 'Machine: *ARM' || fail "$object is not for the board"
  done
done
holds "builds" ninja -C "$work/p/build" p.elf
