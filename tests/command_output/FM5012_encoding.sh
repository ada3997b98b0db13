# an encoding that was converted for reading is not written under its old name; a byte order mark stays
printf '<?xml version="1.0" encoding="ISO-8859-1"?>\n<!-- caf\xe9 -->\n' >latin.urdf
robot <<'Y'
    <bus name="idle" type="can" port="can1" bitrate="1Mbit/s"/>
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
Y
cat robot.urdf >>latin.urdf
{ printf '\xef\xbb\xbf'; cat robot.urdf; } >mark.urdf
cp latin.urdf before
finemote lint latin.urdf --fix 2>&1 | grep -v FM3156 | grep -A1 FM5; cmp latin.urdf before && echo unchanged
finemote -q lint mark.urdf --fix 2>/dev/null; echo "exit $?"; head -c 3 mark.urdf | od -An -tx1; grep -c idle mark.urdf
finemote lint - --fix <robot.urdf
