# A disk in memory is a disk: its files are inputs like others, and outputs are written there.
disk=$(mktemp -d /dev/shm/finemote-test-XXXXXX) || exit 1
trap 'rm -rf "$disk"' EXIT
cp "$source/examples/two_devices.urdf" "$disk/robot.urdf"
finemote xacro "$disk/robot.urdf" -o "$disk/robot.urdf" 2>&1 | sed "s#$disk#DISK#g" >&2
finemote xacro "$disk/robot.urdf" -o "$disk/copy.urdf" && test -s "$disk/copy.urdf" && echo written
