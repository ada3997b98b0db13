xacro_robot <<'X'
  <xacro:nobody/>
X
for format in text json sarif github gcc; do
  echo "== $format"
  finemote --format $format xacro robot.urdf.xacro 2>/dev/null
  echo "== exit $?"
done
finemote xacro robot.urdf.xacro
