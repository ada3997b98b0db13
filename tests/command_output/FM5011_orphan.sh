robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
cp out/buses.cpp out/old.cpp
finemote check robot.urdf -o out; echo "exit $?"
head -n 1 out/buses.cpp >"out/my list.hpp"; rm out/buses.hpp
finemote check robot.urdf -o out | cut -d ' ' -f 1
finemote check robot.urdf -o out 2>&1 >said | sed 's/^run: //' | sh; finemote check robot.urdf -o out
cp out/buses.cpp out/old.cpp
for format in gcc github; do finemote check robot.urdf -o out --format $format 2>/dev/null; done
finemote check robot.urdf -o out --format json 2>/dev/null | sed -n '/"diagnostics"/,$p'
