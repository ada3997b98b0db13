#!/usr/bin/env bash
# What the build of a firmware holds to a timing file: every figure, also those that the file does not have. The program that
# bounds the image is a script here; times_test.sh has real ones.
. "$(dirname "$0")/common.sh"
cd "$work"
cat >program <<'X2'
#!/bin/sh
while [ "$1" != -o ]; do shift; done
cp bounds.json "$2"
X2
chmod +x program
cat >robot.timing.json <<'X2'
{ "schema": "finemote.wcet/1", "robot": "robot",
  "stages": [{"device": "imu", "stage": "update", "wcet_ns": 2000, "without_faults_ns": 1900, "wcet_cycles": 336, "loops": []}],
  "interrupts": [{"source": "can.CAN1_TX", "wcet_ns": 12102, "with_faults_ns": 12298,
                  "raised_by": {"request": 12102, "end": 6465}, "requests": [6465, 9441, 12417]}],
  "scheduler": [{"what": "release", "wcet_ns": 3506, "with_faults_ns": 14953},
                {"what": "bucket 1 ms", "wcet_ns": 55042, "with_faults_ns": 77655, "period_ns": 1000000, "behind_ns": 3762},
                {"what": "before", "device": "imu", "stage": "update", "wcet_ns": 337}],
  "unresolved": [],
  "inputs": {"options": {"board": null}, "arguments": ["a:=1", "b:=2"], "hash": null} }
X2

# bounds FILE SCRIPT: the file after a change. `line` is its interrupt, `tasks` are the parts of its scheduler.
bounds() {
  python3 - "$2" >"$1" <<'X2'
import json, sys
d = json.load(open("robot.timing.json"))
line, tasks = d["interrupts"][0], d["scheduler"]
exec(sys.argv[1])
json.dump(d, sys.stdout)
X2
}
hold() {
  cmake -DPROGRAM="$work/program" "-DWORDS=robot.urdf;--data-dir;/data;side:=left" -DIMAGE=robot.elf -DTIMES="$times" \
    -DBOUNDS="$work/found.json" -P "$prefix/share/finemote/cmake/scripts/times.cmake"
}
# holds_with SCRIPT, refuses_with PATTERN SCRIPT: an image with these bounds
holds_with() { bounds bounds.json "$1"; holds "bounds: $1" hold; }
refuses_with() { bounds bounds.json "$2"; refuses "bounds: $2" "$1" hold; }

times=robot.timing.json
holds_with ''
refuses_with "can.CAN1_TX request of 3 has no bound any more" 'line["requests"].pop()'
refuses_with "release can take 9999 ns, 3506 ns are granted" 'tasks[0]["wcet_ns"] = 9999'
refuses_with "finemote wcet robot.urdf --data-dir /data side:=left -o robot.timing.json" 'tasks[0]["wcet_ns"] = 9999'

# What a request takes with one, two and three frames.
refuses_with "can.CAN1_TX request of 1 can take 6466 ns, 6465 ns are granted" 'line["requests"][0] += 1'
refuses_with "can.CAN1_TX request of 3 can take 12418 ns, 12417 ns are granted" 'line["requests"][2] += 1'
refuses_with "can.CAN1_TX request of 4 can take 15000 ns, and is not in the file" 'line["requests"].append(15000)'
refuses_with "can.CAN1_TX request of 1 has no bound any more" 'line["requests"].clear()'

# What a file that is complete does not list takes no time.
refuses_with "imu.handle before can take 5 ns, and is not in the file" \
  'tasks.append({"what": "before", "device": "imu", "stage": "handle", "wcet_ns": 5})'
holds_with 'tasks.append({"what": "before", "device": "imu", "stage": "handle", "wcet_ns": 0})'
refuses_with "can.CAN1_TX raised by event can take 90 ns, and is not in the file" 'line["raised_by"]["event"] = 90'
refuses_with "can.CAN1_SCE can take 80 ns, and is not in the file" \
  'd["interrupts"].append({"source": "can.CAN1_SCE", "wcet_ns": 80, "with_faults_ns": 90, "raised_by": {}})'
times=gaps.timing.json
bounds gaps.timing.json 'd["unresolved"].append({"function": "f", "why": "a loop"}); tasks.pop()'
holds_with ''

# A file of another board, or of other arguments, holds nothing; their order makes no difference.
times=robot.timing.json
longer='tasks[0]["wcet_ns"] = 9999; '
refuses_with "release can take 9999 ns" "$longer"'d["inputs"]["arguments"].reverse()'
for other in 'd["inputs"]["options"]["board"] = "stm32f4_discovery"' 'd["inputs"]["arguments"].pop()'; do
  holds_with "$longer$other"
  grep -q "robot.timing.json is of other arguments or another board: this image is held to nothing" "$work/said" || fail "$other: not said"
done
