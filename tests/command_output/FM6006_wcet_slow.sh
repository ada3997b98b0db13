sed 's|\(<device name="imu"[^/]*\)/>|\1><wcet update="5us" handle="100ns"/></device>|' "$source"/examples/finsrov.urdf > robot.urdf
finemote run robot.urdf --duration 20ms 2>said >/dev/null
status=$?
sed -E 's/[0-9.]+ us by itself, its/N us by itself, its/; s/update="[0-9]+us" handle="[0-9.]+[nu]?s" source/update="N" handle="N" source/' said >&2
exit $status
