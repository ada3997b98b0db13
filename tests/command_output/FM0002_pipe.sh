# Nothing that a file names makes the tool wait: pipes, sockets and devices are refused where they are named.
mkfifo pipe
mkdir devices
mkfifo devices/probe.json
finemote() { timeout 20 "$(type -P finemote)" "$@"; }
xacro_robot <<'X'
  <xacro:include filename="pipe"/>
X
finemote xacro robot.urdf.xacro
xacro_robot <<'X'
  <xacro:include filename="/dev/zero"/>
X
finemote xacro robot.urdf.xacro
xacro_robot <<'X'
  <link name="${xacro.load_yaml('pipe')}"/>
X
finemote xacro robot.urdf.xacro
robot <<'X'
    <device name="probe" type="probe" period="10ms"/>
X
finemote tree robot.urdf
finemote tree pipe
rm -r devices
robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote tree -q <(cat robot.urdf) >/dev/null && echo "a descriptor of the shell is read"
finemote tree -q /dev/stdin <robot.urdf >/dev/null && echo "so is standard input"
