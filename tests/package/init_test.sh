#!/usr/bin/env bash
# What `finemote init` and `scaffold` write builds, is tested and runs as its README and its CI files say.
. "$(dirname "$0")/common.sh"
cd "$work"
export FINEMOTE_DEB=$work/finemote.deb
touch "$FINEMOTE_DEB"
# What the steps install is here already.
mkdir stub
printf '#!/bin/sh\necho "$@" >>"%s/installed"\n' "$work" >stub/apt-get
chmod +x stub/apt-get
PATH=$work/stub:$PATH
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi

# run_steps PROJECT PATTERN FILE: every step of a CI file, one line each, in its order.
run_steps() {
  local step count=0
  while IFS= read -r step; do
    count=$((count + 1))
    holds "$1: $step" bash -c "cd '$1' && $step"
  done < <(sed -nE "s/$2/\1/p" "$1/$3")
  [ $count -ge 10 ] || fail "$3: only $count steps"
}

holds "init" finemote init lantern
run_steps lantern '^ +run: (.*)$' .github/workflows/firmware.yml
grep -q 'install -y --no-install-recommends .*/finemote.deb' installed || fail "the package was not installed"
equal "a line for every step of GitHub" "$(grep -c '^ *run:' lantern/.github/workflows/firmware.yml)" \
  "$(grep -cE '^ +run: [^|>]' lantern/.github/workflows/firmware.yml)"
holds "what is beside the findings" grep -q '"version": "2.1.0"' lantern/finemote.sarif
equal "actions of others, pinned" "$(sed -nE 's/^ *- uses: ([^ ]*)@[0-9a-f]{40} # v[0-9.]+$/\1/p' lantern/.github/workflows/firmware.yml | paste -sd ' ')" \
  "$(sed -nE 's/^ *- uses: ([^@]*).*$/\1/p' lantern/.github/workflows/firmware.yml | paste -sd ' ')"
equal "what is not tracked" "$(cd lantern && git init -q . && git -c core.excludesFile=/dev/null add -A && git -c core.excludesFile=/dev/null status --short --ignored | grep '!!' | sort | paste -sd ' ')" \
  "!! build/ !! finemote.sarif"

# Another board, the other CI, and whatever the README shows.
holds "init for another board" finemote init discovery --board stm32f4_discovery
run_steps discovery '^    - (.*)$' .gitlab-ci.yml
while IFS= read -r line; do
  case $line in *openocd* | *--target\ flash*) continue ;; esac
  holds "README: $line" bash -c "cd lantern && $line"
done < <(sed -n '/^```sh$/,/^```$/p' lantern/README.md | grep -v '^```')

# The editors' files.
for file in lantern/CMakePresets.json lantern/.vscode/*.json lantern/.devcontainer/devcontainer.json; do
  holds "$file is JSON" python3 -m json.tool "$file"
done
python3 - lantern/.vscode/tasks.json >pattern <<'X'
import json, sys
tasks = json.load(open(sys.argv[1]))["tasks"]
print(next(t for t in tasks if t["label"] == "check")["problemMatcher"]["pattern"]["regexp"])
X
# Every task runs, but for those that need a probe.
python3 - lantern/.vscode/tasks.json >tasks <<'X'
import json, shlex, sys
tasks = json.load(open(sys.argv[1]))["tasks"]
labels = {task["label"] for task in tasks}
for task in tasks:
    assert task.get("dependsOn", task["label"]) in labels, task
    if task["label"] not in ("flash", "trace of the running board"):
        print(shlex.join([task["command"], *task["args"]]))
X
[ "$(wc -l <tasks)" -ge 9 ] || fail "few tasks: $(cat tasks)"
while IFS= read -r line; do holds "task: $line" bash -c "cd lantern && $line"; done <tasks
sed -i 's/"lantern" period/"lantren" period/' lantern/src/robot.urdf
(cd lantern && ! finemote check src/robot.urdf -o generated --format gcc) >findings 2>/dev/null || true
python3 - pattern findings <<'X' || fail "the problem matcher: $(cat findings)"
import re, sys
matches = [re.match(open(sys.argv[1]).read().strip(), line.rstrip()) for line in open(sys.argv[2])]
found = next(m for m in matches if m)
assert found.group(4) == "error" and found.group(6) == "FM3021" and found.group(1).endswith("src/robot.urdf"), found.groups()
X
sed -i 's/"lantren" period/"lantern" period/' lantern/src/robot.urdf
if command -v openocd >/dev/null; then
  for file in lantern/openocd/*.cfg; do holds "$file" openocd -f "$file" -c noinit -c shutdown; done
else
  echo "openocd is missing: its configuration files are not looked at"
fi

# A device of one's own, and a board.
holds "scaffold device" bash -c "cd lantern && finemote scaffold device depth_sensor"
sed -i 's|  </finemote>|    <device name="depth" type="depth_sensor" period="10ms"/>\n  </finemote>|' lantern/src/robot.urdf
holds "its test" bash -c "cd lantern && cmake --build --preset host && ctest --preset host -R depth_sensor_test"
holds "its firmware" bash -c "cd lantern && finemote generate src/robot.urdf -o generated && cmake --build --preset firmware"
holds "scaffold board" finemote scaffold board my_board -o boards
cp -r "$prefix/share/finemote" data
cp boards/my_board.json data/schemas/boards/
holds "the board" finemote board show my_board --data-dir data
holds "its sources" finemote board sources my_board -o sources --data-dir data

# Every example, and a robot with everything it reads.
for robot in "$prefix"/share/finemote/examples/*.urdf; do
  name=$(basename "$robot" .urdf)
  holds "example $name" finemote init "example_$name" --example "$name"
  holds "example $name: check" finemote check "example_$name/src/$name.urdf" -o "example_$name/generated"
  holds "example $name: times" finemote analyze "example_$name/src/$name.urdf" --require-static
done
holds "without tests" bash -c "cd example_user_device && cmake --preset host && cmake --build --preset host && ctest --preset host"
holds "from a robot" finemote init from --from "$here/rover/rover.urdf.xacro"
holds "its files" test -f from/src/wheels.xacro -a -f from/src/devices/meter.cpp
holds "its firmware" bash -c "cd from && cmake --preset firmware && cmake --build --preset firmware"
