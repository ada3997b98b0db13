# of very many mistakes in one descriptor the first hundred are shown
mkdir devices
echo '#pragma once' >devices/many.hpp
{ printf '{ "schema": "finemote.device/1", "type": "many", "summary": "for tests", "class": "Many", "header": "many.hpp",\n'
  printf '  "params": [{ "name": "first", "type": "int", "default": 1, "wrong": 0 }'
  for number in $(seq 149); do printf ',\n    { "name": "p%s", "type": "int", "default": 1, "wrong": 0 }' "$number"; done
  printf '] }\n'; } >devices/many.json
robot <<'X'
    <device name="many" type="many" period="10ms"/>
X
finemote analyze robot.urdf 2>said
status=$?
grep -c 'FM3102' said
grep -B4 -A1 'further mistakes' said >&2
exit $status
