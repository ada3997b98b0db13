mkdir devices
printf '#pragma once\n#include <finemote/contract.hpp>\nclass Sonar {};\n' >devices/sonar.hpp
printf '{ "schema": "finemote.device/1", "type": "sonar", "summary": "for tests", "class": "Sonar", "header": "sonar.hpp",\n  "bus": { "types": ["uart"] }, "provides": [], "emulation": { "part": "h30_im" } }\n' >devices/sonar.json
robot <<'X'
    <bus name="tether" type="uart" port="usart1" baud="115200baud"/>
    <device name="sonar" type="sonar" bus="tether" period="10ms"/>
X
finemote=$(command -v finemote)
PATH=/nonexistent "$finemote" run robot.urdf
