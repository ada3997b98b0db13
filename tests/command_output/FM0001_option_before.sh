for words in "--frobnicate generate robot.urdf" "xacro --device-path devices robot.urdf.xacro"; do finemote $words; done
robot <<X
    <device name="a" type="sim_load" period="10ms"/>
X
mkdir devices
finemote -q --device-path devices --board host --format json tree robot.urdf | head -c 40
finemote -q -o out --device-path=devices generate robot.urdf; ls out/finemote.manifest.json
finemote --help xacro | tail -n 1
