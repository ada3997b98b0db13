xacro_robot <<'X'
  <xacro:arg name="side" default="left"/>
  <link name="$(arg side)"/>
X
for format in text json sarif github gcc; do
  echo "== $format"
  finemote --format $format xacro robot.urdf.xacro sied:=right 2>"$format.err"
  echo "== exit $?"
done
echo "== the same is on stderr each time"
cat text.err
for format in json sarif github gcc; do cmp text.err $format.err; done
echo "== with a file"
finemote --format gcc xacro robot.urdf.xacro sied:=right -o out.urdf 2>/dev/null
tail -1 out.urdf
echo "== dependencies"
finemote --format json xacro robot.urdf.xacro --deps
echo "== warnings as errors"
finemote -W error xacro robot.urdf.xacro sied:=right -o never.urdf
echo "== exit $?"
ls never.urdf
