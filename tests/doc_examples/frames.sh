# What stands around the examples of single pages, and which command shows the mistake. `$example` is the text of the page,
# `$which` is Wrong or Right. Sourced by run_examples.sh.

# ---- command line and files
any_robot() { example= robot; }
commands() { any_robot; eval "$example"; }
frame_FM0001() { commands; }
frame_FM0002() { commands; }
frame_FM0003() {
  any_robot
  cp robot.urdf good.urdf
  generator_that_fails() { :; }
  generator() { cp good.urdf robot.urdf; }
  eval "$example"
}
frame_FM0004() { printf '<robot name="r">\n%b\n</robot>\n' "$example" >robot.urdf; finemote xacro robot.urdf; }
frame_FM0011() { echo "$example" >finemote.json; mkdir parts; example= robot; ask; }
frame_FM2017() { echo "$example" >robot.urdf; finemote import robot.urdf; }

# ---- XML and xacro
frame_FM1001() { echo "$example" >robot.urdf; finemote xacro robot.urdf; }
frame_FM1002() {  # robot.urdf: <xacro:...>
  xacro_robot "${example#*: }<finemote version=\"1\"><board name=\"robomaster_type_c\"/>$load</finemote>"
  [ "${example%%:*}" = robot.urdf.xacro ] || mv robot.urdf.xacro robot.urdf
  finemote lint "${example%%:*}"
}
frame_FM1003() {
  if [ $which = Wrong ]; then { yes '<a>' | head -600; yes '</a>' | head -600; } >robot.urdf; else echo "$example" >robot.urdf; fi
  finemote xacro robot.urdf
}
xacro_with() { xacro_robot "$1
$example"; finemote xacro robot.urdf.xacro; }
frame_FM1010() { xacro_with '<xacro:property name="weight" value="2"/>'; }
frame_FM1011() { xacro_robot "$example<xacro:loop n=\"3\"/>"; finemote xacro robot.urdf.xacro; }
frame_FM1012() { xacro_with '<xacro:macro name="arm" params="side"><xacro:unless value="${side in ['"'left', 'right'"']}">${xacro.fatal("no such side")}</xacro:unless></xacro:macro>'; }
frame_FM1013() { xacro_with '<xacro:property name="x" value="2"/>'; }
frame_FM1014() { xacro_robot; finemote xacro robot.urdf.xacro --package arm_description=.; }
frame_FM1016() {
  mkdir ../arm_description.$$ && mkdir -p arm/arm_description
  rmdir ../arm_description.$$
  echo '<package><name>arm_description</name></package>' >arm/arm_description/package.xml
  echo '<robot/>' >arm/arm_description/arm.xacro
  xacro_robot '<xacro:include filename="$(find arm_description)/arm.xacro"/>'
  eval "${example//..\/arm_description/arm/arm_description}"
}
frame_FM0008() {
  mkdir robot arm_description
  echo '<robot/>' >arm_description/arm.xacro
  cd robot
  [ $which = Wrong ] && name=../arm_description || name='$(find arm_description)'
  xacro_robot "<xacro:include filename=\"$name/arm.xacro\"/>"
  eval "$example"
}
frame_FM1017() { xacro_robot; finemote xacro --sandbox robot.urdf.xacro; }
frame_FM1059() { xacro_robot '<xacro:arg name="wheel_radius" default="0.05"/>'; eval "$example"; }
frame_FM1023() { echo '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="wheel"><link name="wheel"/></xacro:macro></robot>' >wheel.xacro; default_frame; }
frame_FM1024() { [ $which = Wrong ] || example="<xacro:macro name=\"wheel\" params=\"name *origin\"/>$example"; default_frame; }
frame_FM1026() { xacro_with '<xacro:property name="answer" value="no"/>'; }
frame_FM1027() { mkdir urdf; echo '<robot/>' >urdf/wheel.xacro; default_frame; }
frame_FM1028() { echo "$example" >limits.yaml; xacro_robot '<a v="${xacro.load_yaml('"'limits.yaml'"')}"/>'; finemote xacro robot.urdf.xacro; }
frame_FM1029() { mkdir build; xacro_robot '<link name="a"/>'; eval "$example"; }
parts() { echo '<robot xmlns:g="'"${1:-http://a}"'"/>' | tee x.xacro arm.xacro wheel.xacro >/dev/null; }
frame_FM1050() { parts; default_frame; }
frame_FM1052() { echo 'reach: 1' >limits.yaml; default_frame; }
frame_FM1053() { mkdir parts; echo '<robot/>' >parts/a.xacro; default_frame; }
frame_FM1054() {
  parts "$(grep -o 'has xmlns:g="[^"]*"' <<<"$example" | sed 's/.*="//; s/"//')"
  sed 's#<robot #<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro" #' <<<"$example" >robot.urdf.xacro
  finemote xacro robot.urdf.xacro
}
frame_FM1055() { parts; default_frame; }
frame_FM1056() { xacro_with '<xacro:macro name="arm" params="model"><xacro:if value="${model == '"'old'"'}">${xacro.warning("an old arm")}</xacro:if></xacro:macro>'; }
frame_FM1057() {
  for place in ws ws_copy; do
    mkdir -p $place/arm
    echo '<package><name>arm</name></package>' >$place/arm/package.xml
    echo '<robot/>' >$place/arm/arm.xacro
  done
  xacro_robot '<xacro:include filename="$(find arm)/arm.xacro"/>'
  eval "$example"
}

# ---- links and joints
frame_FM2001() { links "$example"; ask; }
thruster='<joint name="thruster_joint" type="TYPE"><parent link="base_link"/><child link="prop"/></joint>'
with_links() {  # LINKS DEVICES
  example=$2 finemote_block "$2" | sed "s#<link name=\"base_link\"/>#<link name=\"base_link\"/>$1#" >robot.urdf
  ask
}
imu_link='<link name="imu_link"/><joint name="imu_joint" type="fixed"><parent link="base_link"/><child link="imu_link"/></joint>'
prop='<link name="prop"/>'
frame_FM2002() { with_links "$imu_link" "${example/ link=/ period=\"5ms\" link=}"; }
frame_FM2003() { with_links "$prop${thruster/TYPE/continuous}" "${example/ joint=/ period=\"5ms\" joint=}"; }
frame_FM2004() { with_links "$prop$example<parent link=\"base_link\"/><child link=\"prop\"/></joint>" '<device name="t" type="pwm_esc" period="5ms" bus="pwm" channel="0" joint="thruster_joint"/>'; }
frame_FM2005() {  # as the root element of a robot
  local start=${example%/>}\>
  local root=${start%% *}
  example= robot
  sed -i "s#<robot .*#$start#; s#</robot>#</${root#<}>#" robot.urdf
  ask
}
frame_FM2006() {  # FinsROV with this thruster
  sed "s#<device name=\"thruster_1\" .*joint=[^>]*>#$example#" "$source/examples/finsrov.urdf" >robot.urdf
  ask
}
frame_FM2007() { links "$example<joint name=\"elbow\" type=\"fixed\"><parent link=\"upper_arm\"/><child link=\"lower_arm\"/></joint>"; ask; }
frame_FM2008() { with_links "$prop<joint name=\"j\" type=\"fixed\">$example<parent link=\"base_link\"/><child link=\"prop\"/></joint>" '<device name="load" type="sim_load" period="10ms"/>'; }
frame_FM3084() { frame_FM2008; }
frame_FM3085() { links "<link name=\"base_link\"/><link name=\"yaw_link\"/>$example" '<device name="load" type="sim_load" period="10ms"/>'; ask; }
frame_FM2009() { with_links "$prop$example<parent link=\"base_link\"/><child link=\"prop\"/></joint>" '<device name="load" type="sim_load" period="10ms"/>'; }
frame_FM2010() {  # with the links it names
  links "$(grep -o 'link="[^"]*"' <<<"$example" | sort -u | sed 's#link=\(.*\)#<link name=\1/>#')$example"
  ask
}

# ---- the extension
block_with() { printf '<robot name="rover">\n<link name="base_link"/>\n%s\n<board name="robomaster_type_c"/>\n<device name="load" type="sim_load" period="10ms"/>\n</finemote>\n</robot>\n' "$example" >robot.urdf; ask; }
frame_FM3002() { block_with; }
frame_FM3003() { block_with; }
open_device() { robot "$example</device>"; ask; }  # the page shows a start tag
frame_FM3004() { of_example finsrov 'device name="rov"'; }
frame_FM3006() { robot "$example<device name=\"load\" type=\"sim_load\" period=\"10ms\"/>"; ask; }
frame_FM3007() { frame_FM3006; }
in_device() {  # START: the example inside this device
  local start=$1
  robot "$start$example</device>"
  example=$start$example
  robot "$example</device>"
  ask
}
depth='<device name="depth" type="ms5837" bus="i2c" period="20ms">'
esc='<device name="esc" type="pwm_esc" bus="pwm" channel="0" period="20ms">'
frame_FM3016() {
  robot "$(head -1 <<<"$example")<device name=\"load\" type=\"servo\" period=\"10ms\">$(tail -1 <<<"$example" | sed 's/select/line/')</device>"
  local text; text=$(cat robot.urdf)
  servo <<<', "uses": [{ "name": "line", "types": ["gpio"], "function": "output" }]'
  echo "$text" >robot.urdf
  ask
}
frame_FM3022() { in_device "$depth"; }
frame_FM3023() { in_device "$depth"; }
frame_FM3024() {
  local text=${example/my_servo/servo}
  servo <<<', "bus": { "types": ["pwm"], "channel": {} }, "params": [{ "name": "gain", "type": "float" }]'
  example=${text/ bus=/ period=\"10ms\" bus=}
  robot
  ask
}
frame_FM3025() { in_device "$esc"; }
frame_FM3026() { in_device "$depth"; }
frame_FM3027() { in_device "$esc"; }
frame_FM3028() { of_example finsrov 'device name="rov"'; }
frame_FM3032() { in_device '<device name="load" type="sim_load" period="10ms">'; }
frame_FM3041() { robot "<device name=\"rov\" type=\"group\" period=\"10ms\"/>$example"; ask; }
frame_FM3044() { of_example infantry 'reads device="remote"'; }
frame_FM3049() { robot "$example<device name=\"load\" type=\"sim_load\" period=\"10ms\"/>"; ask; }
mecanum() {  # [PARAMS]: an example in place of the front left wheel's axis, or among the chassis' params
  local name x y links= wheels= id=0
  while read -r name x y axis; do
    id=$((id + 1))
    links+="<link name=\"$name\"/><joint name=\"$name.joint\" type=\"continuous\"><parent link=\"base_link\"/><child link=\"$name\"/><origin xyz=\"$x $y 0\"/>${axis:-<axis xyz=\"0 1 0\"/>}</joint>"
    wheels+="<device name=\"$name\" type=\"dji_m3508\" bus=\"can\" id=\"$id\" joint=\"$name.joint\">$measured</device>"
  done <<X
fl 0.2 0.2 $([ -n "${1:-}" ] || echo "$example")
fr 0.2 -0.2
rl -0.2 0.2
rr -0.2 -0.2
X
  with_links "$links" "<bus name=\"can\" type=\"can\" port=\"can1\" bitrate=\"1Mbit/s\"/><bus name=\"dbus\" type=\"uart\" port=\"usart3\" baud=\"100000baud\"/><device name=\"base\" type=\"mecanum_chassis\" period=\"10ms\">${1:-}<device name=\"remote\" type=\"dr16\" bus=\"dbus\">$measured</device>$wheels</device>"
}
frame_FM2011() { mecanum; }
with_joint() {  # TYPE JOINT DEVICE: the example inside a joint, and what drives it
  with_links "$prop<joint name=\"j\" type=\"$1\"><parent link=\"base_link\"/><child link=\"prop\"/>$2$example</joint>" "$3"
}
servo_at='<bus name="led" type="pwm" port="pwm1"/><device name="servo" type="pwm_servo" period="20ms" bus="led" joint="j"/>'
frame_FM2012() { links "<link name=\"base_link\">$example</link>" '<device name="load" type="sim_load" period="10ms"/>'; ask; }
frame_FM2013() { with_joint continuous '' "$servo_at"; }
frame_FM2014() { with_joint revolute '' "$servo_at"; }
frame_FM2015() { of_example finsrov 'device name="rov"'; }
hull() {  # GEOMETRY AXIS: two thrusters
  local links= axis n=0
  mkdir -p devices
  echo '#pragma once' >devices/hull.hpp
  echo "{ \"schema\": \"finemote.device/1\", \"type\": \"hull\", \"summary\": \"x\", \"class\": \"Hull\", \"header\": \"hull.hpp\", \"roles\": [{ \"name\": \"thrusters\", \"interface\": \"Thruster\" }], $1 }" >devices/hull.json
  for axis in '<axis xyz="0 0 1"/>' "$2"; do
    n=$((n + 1))
    links+="<link name=\"l$n\"/><joint name=\"j$n\" type=\"continuous\"><parent link=\"base_link\"/><child link=\"l$n\"/>$axis</joint>"
  done
  with_links "$links" '<bus name="pwm" type="i2c" port="i2c3"/><expander name="outputs" model="pca9685" bus="pwm" address="0x40"/><device name="hull" type="hull" period="20ms"><device name="t1" type="pwm_esc" bus="outputs" channel="0" joint="j1"/><device name="t2" type="pwm_esc" bus="outputs" channel="1" joint="j2"/></device>'
}
frame_FM3158() { hull "$example" '<axis xyz="0 0 1"/>'; }
frame_FM3159() { hull '"geometry": [{ "kind": "allocation", "role": "thrusters" }]' "$example"; }
frame_FM3160() { with_joint revolute '' "$servo_at"; }
of_example() {  # NAME TAG: this tag of an example is that of the page
  sed "s#<$2.*#${example//$'\n'/ }#" "$source/examples/$1.urdf" >robot.urdf
  ask
}
frame_FM3163() { of_example infantry 'device name="imu"'; }
frame_FM3164() { of_example finsrov 'joint name="thruster_1_joint"'; }
frame_FM3165() {
  sed "/<joint name=\"thruster_1_joint\"/,/<\/joint>/s#<parent .*#$example#
    s#^  <finemote .*#<link name=\"pod_link\"/><joint name=\"pod_joint\" type=\"continuous\"><parent link=\"base_link\"/><child link=\"pod_link\"/></joint>&#
    s#<device name=\"rov\".*#<device name=\"turner\" type=\"pwm_servo\" period=\"10ms\" bus=\"pwm\" channel=\"8\" joint=\"pod_joint\"/>&#" "$source/examples/finsrov.urdf" >robot.urdf
  ask
}
frame_FM3166() {
  with_links "$example<joint name=\"shoulder\" type=\"continuous\"><parent link=\"base_link\"/><child link=\"upper_arm\"/></joint>" '<bus name="can" type="can" port="can1" bitrate="1Mbit/s"/><bus name="dbus" type="uart" port="usart3" baud="100000baud"/><device name="arm" type="serial_arm" period="10ms"><device name="remote" type="dr16" bus="dbus"/><device name="motor" type="dji_m3508" bus="can" id="1" joint="shoulder"/></device>'
}
frame_FM3167() { hull '"geometry": [{ "kind": "allocation", "role": "thrusters" }]' "$example<axis xyz=\"0 0 1\"/>"; }
frame_FM3168() {
  sed "s#<device name=\"gimbal\".*#&$example#" "$source/examples/infantry.urdf" >robot.urdf
  ask
}
frame_FM3169() {
  with_links "<joint name=\"tilt\" type=\"continuous\"><parent link=\"base_link\"/><child link=\"head_link\"/></joint><link name=\"head_link\"/><ros2_control name=\"head\" type=\"actuator\"><joint name=\"tilt\">$example</joint></ros2_control>" '<bus name="pwm" type="pwm" port="pwm1"/><device name="head" type="pwm_servo" period="10ms" bus="pwm" channel="0" joint="tilt"/>'
}
frame_FM3157() { mecanum "$example"; }
# a device type `servo` of the user's with these roles, which takes the place of the example's `finsrov`
with_roles() {
  local text=${example//finsrov/servo}
  servo <<<", \"roles\": [$1]"
  example=$text
}
frame_FM3051() {
  with_roles '{ "name": "depth", "interface": "Pressure" }'
  robot "<device name=\"rov\" type=\"servo\" period=\"20ms\">$example</device>"
  ask
}
frame_FM3054() {
  with_roles '{ "name": "imu", "interface": "Imu", "min": 0 }, { "name": "depth", "interface": "Pressure", "min": 0 }'
  robot "<device name=\"rov\" type=\"servo\" period=\"20ms\">$example</device>"
  ask
}
frame_FM3056() {
  with_roles '{ "name": "imu", "interface": "Imu", "max": 1 }'
  robot "$(grep -v '\.\.\.' <<<"$example")"
  ask
}
frame_FM3052() {
  with_roles '{ "name": "left", "interface": "Motor" }, { "name": "right", "interface": "Motor" }'
  robot "<device name=\"base\" type=\"servo\" period=\"10ms\">$example</device>"
  ask
}
frame_FM3057() { robot "$example<device name=\"load\" type=\"sim_load\"/></device>"; ask; }
frame_FM3062() { example="<bus name=\"i2c\" type=\"i2c\" port=\"i2c2\"/>$example"; robot; ask; }
frame_FM3065() { robot "<bus name=\"i2c\" type=\"i2c\" port=\"i2c2\"/><expander name=\"mux\" model=\"tca9548a\" bus=\"i2c\" address=\"0x70\">$example</expander>"; ask; }
host_line='<device name="ears" type="servo" period="10ms">'
frame_host() {
  local use=$example
  servo <<<', "uses": [{ "name": "host", "types": ["uart"] }, { "name": "select", "types": ["gpio"], "function": "output" }]'
  example=$use
  robot "$host_line$use</device>"
  ask
}
# the text of the page, with a type `servo` of the user's on CAN
can_servos() {  # MEMBERS
  local text=$example
  servo <<<', "bus": { "types": ["can"], "id": { "min": 1, "max": 40 }, "receives": { "base": 768 } }'"${1:-}"
  example=$text robot "$text"
  ask
}
frame_FM3080() {
  can_servos ', "frames": [{ "stage": "flush", "write": 8, "identifiers": [
    { "ids": [1, 1], "identifier": 257 }, { "ids": [2, 2], "identifier": 258 }, { "ids": [3, 3], "identifier": 259 },
    { "ids": [4, 4], "identifier": 260 }, { "ids": [5, 5], "identifier": 261 }, { "ids": [6, 6], "identifier": 262 }] }]'
}
frame_FM3083() {
  local id count=32
  [ $which = Right ] || count=33
  for id in $(seq $count); do example+="<device name=\"m$id\" type=\"servo\" bus=\"can\" id=\"$id\" period=\"10ms\"/>"; done
  can_servos
}
frame_FM3070() { frame_host; }
frame_FM3072() { frame_host; }
frame_FM3073() { frame_host; }
frame_FM3071() {
  local text=${example/my_imu/servo}
  servo <<<', "bus": { "types": ["spi"], "channel": {}, "required": true }, "uses": [{ "name": "reset", "types": ["gpio"], "min": 1, "function": "output" }]'
  example="<bus name=\"spi\" type=\"spi\" port=\"spi2\" clock=\"5250kHz\"/>${text/ bus=/ period=\"10ms\" bus=}"
  robot
  ask
}
frame_FM3074() {
  example="<bus name=\"i2c\" type=\"i2c\" port=\"i2c2\"/><expander name=\"outer\" model=\"tca9548a\" bus=\"i2c\" address=\"0x70\"><channel index=\"0\" name=\"segment_0\"/></expander>$example"
  robot
  ask
}
rov_with_imu='<device name="rov" type="group" period="10ms"><device name="imu" type="sim_load"><wcet update="10us" handle="5us"/></device><device name="thruster_1" type="sim_load"><wcet update="10us" handle="5us"/></device></device>'
frame_FM3081() { robot "${rov_with_imu//\"group\"/\"sim_load\"}${example/rov.thrusters/rov.children}"; ask; }
frame_FM3082() { robot "$rov_with_imu$example"; ask; }

frame_FM3170() { servo <<<", ${example//$'\n'/ }"; ask; }

# ---- descriptors
as_descriptor() {  # MEMBERS that the example lacks
  local text=$example
  servo </dev/null
  echo "${text%\}}, $1 }" >devices/servo.json
  ask
}
frame_FM3101() { as_descriptor '"schema": "finemote.device/1", "summary": "x", "header": "servo.hpp"'; }
frame_FM3102() {
  with_roles "$example"
  robot '<device name="base" type="servo" period="10ms"><device name="load" type="sim_load" role="arm"/></device>'
  ask
}
frame_FM3103() { servo <<<", \"params\": [$example]"; ask; }
frame_FM3104() { as_descriptor '"type": "servo", "summary": "x", "class": "Servo", "header": "servo.hpp"'; }
frame_FM3105() { local header=$example; servo <<<''; sed -i "s#\"header\": \"servo.hpp\"#${header//[\{\}]/}#" devices/servo.json; ask; }
frame_FM3106() { servo <<<''; sed "s/servo/$(basename "$example" .json)/" devices/servo.json >"$example"; ask; }
frame_FM3107() { local member=${example#*: }; servo <<<''; sed -i "s#\"type\": \"servo\"#${member//[\{\}]/}#" devices/servo.json; ask; }

# ---- lint
measured='<wcet update="10us" handle="5us"/>'
with_period() { sed "s#bus=#period=\"20ms\" bus=#" <<<"$example"; }
frame_FM3151() { robot "<device name=\"rov\" type=\"group\" period=\"20ms\">$example</device>"; ask; }
frame_FM3152() { robot "$example</device>"; ask; }
frame_FM3155() { robot "$example<device name=\"depth\" type=\"ms5837\" bus=\"i2c\" period=\"10ms\"/>"; sed -i '/<bus name="i2c".*clock="400kHz"\/>$/{x;s/^/x/;/^xx/{x;d};x}' robot.urdf; ask; }
frame_FM3156() { robot "$example<device name=\"load\" type=\"sim_load\" period=\"10ms\">$measured</device>"; ask; }

# ---- timing
frame_FM4001() { echo "$example" >model.json; finemote analyze model.json; }
frame_FM4002() { model "${example//[\{\}]/}, $one_device"; }
a_device() { model "\"tick_ns\": 1000, \"devices\": [$1]"; }
frame_FM4003() { model "\"tick_ns\": 1000, \"devices\": [{\"name\": \"a\", \"parent\": null, ${example//[\{\}]/}, \"update_wcet_ns\": 1, \"handle_wcet_ns\": 1}]"; }
frame_FM4004() { a_device "${example/\{/\{ \"parent\": null,}"; }
frame_FM4005() { frame_FM4003; }
frame_FM4006() { a_device "{\"name\": \"a\", \"parent\": null, \"period_ns\": 10000000, $example, \"handle_wcet_ns\": 1}"; }
devices_with() { model "\"tick_ns\": 1000, ${example//, .../, \"period_ns\": 10000000, \"update_wcet_ns\": 1, \"handle_wcet_ns\": 1}"; }
frame_FM4007() { example=${example//, .../, \"parent\": null, ...}; devices_with; }
frame_FM4008() { devices_with; }
frame_FM4009() { model "${example%%,*}, \"devices\": [{\"name\": \"a\", \"parent\": null, ${example#*... }, \"update_wcet_ns\": 1, \"handle_wcet_ns\": 1}]"; }
frame_FM4010() { model "\"tick_ns\": 1, \"devices\": [{\"name\": \"a\", \"parent\": null, \"period_ns\": 10000000, \"update_wcet_ns\": 9000, $example}]"; }
frame_FM4012() { model "\"tick_ns\": 1000, \"buses\": [{\"name\": \"x\", $example, \"wcet_ns\": 1}], $one_device"; }
frame_FM4013() { model "\"tick_ns\": 1000, $example"; }
frame_FM4014() { model "\"tick_ns\": 1000, \"devices\": [${example//, .../, \"parent\": null, \"period_ns\": 10000000, \"update_wcet_ns\": 1, \"handle_wcet_ns\": 1}]"; }
frame_FM4016() { robot "$rov_with_imu$example"; finemote analyze robot.urdf; }
frame_FM4017() { robot; finemote analyze robot.urdf; }
# a robot that a compiler makes an image of in a moment
button() { example= robot "<device name=\"button\" type=\"key\" period=\"10ms\"><use role=\"line\" pin=\"key\"/>${1:-}</device>"; }
timed() { button; eval "$example"; }
frame_FM4022() { timed; }
frame_FM4023() { timed; }
frame_FM4024() { button "$example"; finemote wcet robot.urdf -o robot.timing.json; finemote analyze robot.urdf; }
frame_FM4025() { timed; }
frame_FM4026() { timed; }
frame_FM4018() { example= robot "$rov_with_imu"; eval "$(block "$source/docs/diagnostics/$code.md" $which)"; }
frame_FM4019() { model "\"tick_ns\": 1000000, $one_device" >/dev/null 2>&1; mv model.json case.json; eval "$example"; }
frame_FM4020() { example=$(with_period); robot; finemote analyze robot.urdf; }
frame_FM4021() { robot "$example"; finemote analyze robot.urdf; }

# ---- output
# robot.urdf, generated into out, before the example
generated() { any_robot; finemote -q generate robot.urdf -o out; eval "$example"; }
frame_FM5004() { any_robot; mkdir out; echo 'int mine;' >out/buses.cpp; eval "$example"; }
frame_FM5007() { generated; }
frame_FM5008() { generated; }
frame_FM5009() { generated; }
frame_FM5010() { generated; }
frame_FM5011() { generated; }
frame_FM5012() { example= robot '<bus name="idle" type="can" port="can1" bitrate="1Mbit/s"/><device name="load" type="sim_load" period="10ms"/>'; eval "$example"; }
frame_FM5006() {
  any_robot
  finemote -q generate robot.urdf -o out
  become=(as_somebody)
  eval "$example"
  chmod 755 out
}
frame_FM5001() { any_robot; finemote generate robot.urdf -o out; [ $which = Right ] || sed -i 's/schema/shcema/' out/finemote.manifest.json; eval "$example"; }
frame_FM5002() { any_robot; mkdir elsewhere; ln -s elsewhere out; eval "$example"; }
frame_FM5013() { xacro_robot '<link name="base_link"/>'; eval "$example"; }
frame_FM5014() { any_robot; eval "$example"; }
frame_FM5015() { eval "$example"; }
frame_FM5016() {
  mkdir -p robots parts
  xacro_robot '<xacro:include filename="parts/wheel.xacro"/><link name="base_link"/><finemote version="1"><board name="robomaster_type_c"/><device name="load" type="sim_load" period="10ms"/></finemote>'
  mv robot.urdf.xacro rover.urdf.xacro
  sed 's|parts/|../parts/|' rover.urdf.xacro >robots/rover.urdf.xacro
  echo '<robot/>' >parts/wheel.xacro
  eval "$example"
}
frame_FM5003() {
  any_robot
  sed 's/rover/a/' robot.urdf >a.urdf
  sed 's/rover/b/' robot.urdf >b.urdf
  eval "$example"
}
