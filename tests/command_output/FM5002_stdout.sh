# no command leaves a result that is not whole unsaid
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
echo '<robot name="rover"/>' >plain.xacro
finemote -q generate robot.urdf -o out
refused() { "$@" >/dev/full 2>said; [ $? = 2 ] && grep -q '^finemote: error\[FM5002\]: cannot write to standard output: no space left on device$' said || { echo "not refused: $*"; cat said; }; }
for word in --help --version 'generate --help'; do refused finemote $word; done
for word in xacro tree analyze simulate lint 'generate --list' 'generate -o new --dry-run'; do refused finemote $word robot.urdf; done
sed 's#<device#<bus name="idle" type="can" port="can1" bitrate="1Mbit/s"/><device#' robot.urdf >idle.urdf
for format in json gcc github sarif; do refused finemote lint idle.urdf --format $format; done
for format in text json; do refused finemote check robot.urdf -o out --format $format; done
sed 's/10ms/20ms/' robot.urdf >other.urdf
refused finemote diff robot.urdf other.urdf
for word in explain 'explain FM3012' 'schema xsd' 'schema json' 'board show' 'board show robomaster_type_c' 'docs -o pages --dry-run' 'xacro plain.xacro'; do refused finemote $word; done
for word in --help --man; do
  finemote-emulator $word >/dev/full; echo "emulator $word: exit $?"
done
finemote xacro plain.xacro >&-
echo "exit $?"
finemote schema xsd >/dev/full
