# Descriptors, their headers, folders and inputs that are links out of the branch.
mkdir -p secret/devices
echo '{"schema": "finemote.device/1", "token": "5f2a"}' >secret/devices/probe.json
echo 'class Secret;' >secret/secret.hpp
probe_robot <<'X'
class Probe {};
X
finemote tree --sandbox -q robot.urdf >/dev/null; echo "plain: $?"
mkdir branch; mv devices robot.urdf branch; cd branch
sed -i 's#"probe.hpp"#"../../secret/secret.hpp"#' devices/probe.json
finemote tree --sandbox robot.urdf; echo "the header is outside: $?"
sed -i 's#secret.hpp#nothing.hpp#' devices/probe.json
finemote tree --sandbox robot.urdf; echo "there is none: $?"
rm devices/probe.json; ln -s ../../secret/devices/probe.json devices/probe.json
finemote tree --sandbox robot.urdf; echo "descriptor is a link: $?"
rm -r devices; ln -s ../secret/devices devices
finemote tree --sandbox robot.urdf; echo "devices is a link: $?"
rm devices; mv robot.urdf ../secret; ln -s ../secret/robot.urdf robot.urdf
finemote tree --sandbox robot.urdf; echo "IN is a link: $?"
rm robot.urdf; ln -s ../secret inner
finemote tree --sandbox inner/robot.urdf; echo "the folder of IN is a link: $?"
finemote tree --sandbox ../secret/robot.urdf --package p=inner; echo "a package is a link: $?"
