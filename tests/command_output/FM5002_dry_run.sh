# --dry-run names the folder that cannot be written, as a run that writes does
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
both() { as_somebody finemote generate robot.urdf -o "$1" --dry-run; echo "exit $?"; as_somebody finemote generate robot.urdf -o "$1"; echo "exit $?"; }
mkdir locked
chmod 555 locked
both locked
both locked/inner/deep
finemote -q generate robot.urdf -o out
rm out/trees/load.cpp
chmod 777 out
chmod 555 out/trees
both out
chmod 755 out/trees
as_somebody finemote generate robot.urdf -o free --dry-run | head -1; ls -d free 2>&1
chmod 777 locked
