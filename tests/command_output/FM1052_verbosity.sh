# --verbosity 0 and -q print no warnings, everything else does; -W error hears it anyway. -i and --inorder change no byte of the result.
echo 'a: 1' >legs.yaml
xacro_robot <<'X'
  <link name="${load_yaml('legs.yaml')['a']}"/>
X
finemote xacro robot.urdf.xacro 2>/dev/null >expected.urdf
warned() {
  echo "warnings with '$*': $(finemote xacro robot.urdf.xacro "$@" 2>&1 >said.urdf | grep -c 'warning\[FM1052\]')"
  cmp said.urdf expected.urdf
}
warned
for level in 0 1 2; do warned --verbosity $level; done
warned -q
warned --verbosity 0 -v
for order in -i --inorder; do
  finemote xacro robot.urdf.xacro -q $order >said.urdf
  cmp said.urdf expected.urdf && echo "$order: the same"
done
finemote xacro robot.urdf.xacro --verbosity loud
finemote xacro robot.urdf.xacro --verbosity 0 -W error
