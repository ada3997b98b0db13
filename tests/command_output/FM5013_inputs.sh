# no output goes over what was read, by whatever name it is called
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
mkdir devices
echo '{ "schema": "finemote.device/1", "type": "own", "summary": "for tests", "class": "Own", "header": "own.hpp", "provides": [] }' >devices/own.json
printf '#pragma once\n#include "deep/part.inl"\n' >devices/own.hpp
mkdir devices/deep
echo '// nothing' >devices/deep/part.inl
sed 's/type="sim_load"/type="own"/' robot.urdf >own.urdf
echo '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base_link"/></robot>' >part.xacro
echo '{"width": 1}' >sizes.yaml
cat >top.urdf.xacro <<'X'
<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="sizes" value="${xacro.load_yaml('sizes.yaml')}"/>
  <xacro:property name="width" value="${sizes['width']}"/>
  <xacro:include filename="part.xacro"/><link name="link_${width}"/>
</robot>
X
echo '{"schema": "finemote.scenario/1", "events": []}' >idle.json
ln -s robot.urdf link.d
ln robot.urdf second.d
mkdir kept
cp robot.urdf kept/CMakeLists.txt
sha256sum *.* devices/*.* devices/deep/* kept/* >before
refused() { "$@" </dev/null; echo "exit $?"; }
refused finemote generate robot.urdf -o out --depfile robot.urdf
refused finemote generate robot.urdf -o out --depfile link.d
refused finemote generate robot.urdf -o out --depfile second.d --dry-run
refused finemote generate own.urdf -o out --depfile ./devices/../devices/own.json
finemote generate - -o out --depfile robot.urdf <robot.urdf; echo "exit $?"
refused finemote simulate robot.urdf --duration 1ms -o robot.urdf
refused finemote xacro top.urdf.xacro -o top.urdf.xacro
refused finemote xacro top.urdf.xacro -o "$PWD/part.xacro"
refused finemote xacro top.urdf.xacro -o sizes.yaml
refused finemote run robot.urdf --keep work -o robot.urdf
refused finemote run own.urdf --keep work -o devices/own.hpp
refused finemote run own.urdf --json devices/deep/part.inl
refused finemote wcet own.urdf -o devices/own.hpp
refused finemote report own.urdf -o devices/own.hpp
refused finemote simulate own.urdf --duration 1ms -o devices/own.hpp
refused finemote generate own.urdf -o out --depfile devices/own.hpp
refused finemote run robot.urdf --scenario idle.json --keep work -o idle.json
refused finemote run kept/CMakeLists.txt --keep kept
sha256sum --quiet -c before && echo unchanged
ls -d out work/* kept/generated 2>/dev/null
finemote -q generate robot.urdf -o out --depfile /dev/null >/dev/null; echo "exit $?"
