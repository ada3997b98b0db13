# Boards, descriptors and schemas of another data folder are held to the schemas as the user's own are.
mkdir -p data/schemas; cp -r "$source"/schemas/. data/schemas; ln -s "$source/templates" "$source/runtime" "$source/cmake" data
board=data/schemas/boards/robomaster_type_c.json
chip=data/schemas/chips/stm32f407.json
robot <<'X'
    <bus name="line" type="uart" port="usart1" baud="115200baud"/>
    <device name="imu" type="h30_imu" bus="line" period="10ms"/>
X
# try WORDS EDIT [FILE]: what is said about the board with this edit of its file, or its chip's
try() {
  cp "$source/schemas/boards/robomaster_type_c.json" "$board"
  cp "$source/schemas/chips/stm32f407.json" "$chip"
  sed -i "$2" "${3:-$board}"
  finemote board show robomaster_type_c --data-dir data >/dev/null; echo "$1: $?"
}
finemote tree robot.urdf -q --data-dir data >/dev/null; echo "as shipped: $?"
try "no such rule" '0,/"stm32_usart"/s//"stm32_magic"/'
try "a rule for another kind" '0,/"stm32_usart"/s//"stm32_can"/'
try "raised by nothing" '0,/"raised_by": "receive"/s//"raised_by": "the moon"/' $chip
try "a text for a number" '0,/"clock_hz": 84000000/s//"clock_hz": "84MHz"/'
try "no clock" '0,/"clock_hz": 84000000/s//"clock_hz": 0/'
try "a clock of 64 bits" '0,/"clock_hz": 84000000/s//"clock_hz": 18446744073709551615/'
try "a clock of 63 bits" '0,/"clock_hz": 84000000/s//"clock_hz": 9223372036854775807/'
try "no mailboxes" 's/"mailboxes": 3/"mailboxes": 0/' $chip
try "no interrupts" '0,/"interrupts": \[ {[^]]*\]/s//"interrupts": []/'
try "no driver" '/"pwm": { "isr_wcet_ns"/d' $chip
try "a tick out of range" 's/"min_ns": [0-9]*/"min_ns": 900000000/' $chip
try "no crystal" 's/"crystal_hz": 12000000, //'
try "a package without a pin" 's/"gpio": \[[^]]*\]/"gpio": ["PC3-PA0"]/'
finemote board show host --data-dir data >/dev/null; echo "a board over it: $?"
try "an unknown member of the chip" 's/"watchdog": {/"watchdogs": {/' $chip
finemote board show host --data-dir data >/dev/null; echo "a board over a board with it: $?"
try "no chip of this version" 's#finemote.chip/1#finemote.chip/2#' $chip
try "a chip of another name" 's/"name": "stm32f407"/"name": "stm32f405"/' $chip
cp "$source/schemas/boards/robomaster_type_c.json" "$board"
cp "$source/schemas/chips/stm32f407.json" "$chip"
sed -i 's/"class": "finemote/"class": "fine mote/' data/schemas/devices/h30_imu.json
finemote tree robot.urdf --data-dir data >/dev/null; echo "a shipped type changed: $?"
echo '{' >data/schemas/device.schema.json
finemote tree robot.urdf --data-dir data >/dev/null; echo "its schema is no JSON: $?"
echo '{ "type": 5 }' >data/schemas/device.schema.json
finemote tree robot.urdf --data-dir data >/dev/null; echo "its schema is none: $?"
