# of very many mistakes in one descriptor the first hundred are shown
mkdir devices
{ printf '{ "schema": "finemote.device/1", "type": "many", "summary": "for tests", "class": "Many", "header": "many.hpp"'
  for number in $(seq 150); do printf ',\n  "wrong_%s": 1' "$number"; done
  printf ' }\n'; } >devices/many.json
robot <<'X'
    <device name="many" type="many" period="10ms"/>
X
finemote analyze robot.urdf --format gcc >said
grep -c 'FM3101' said
finemote analyze robot.urdf 2>&1 >/dev/null | grep -A3 'further mistakes' | head -2 >&2
