# A folder that was kept is compiled anew for another runtime, also where the dates of its files are those of long ago.
mkdir data
cp -rL "$source"/schemas "$source"/templates "$source"/runtime "$source"/cmake data
robot <<'Y'
    <device name="load" type="sim_load" period="10ms"/>
Y
built() { finemote run robot.urdf --build-only --keep kept --format json --data-dir data | sed -n 's/.*"sha256": "\(.*\)".*/\1/p'; }
first=$(built)
[ "$(built)" = "$first" ] && echo "the same runtime"
magic=data/runtime/chips/cortex_m4/fault.hpp
sed -i 's/kFaultMagic = 0x46415553/kFaultMagic = 0x46415554/' $magic
touch -d 2001-01-01 $magic
changed=$(built)
[ -n "$changed" ] && [ "$changed" != "$first" ] && echo "another runtime"
sed -i 's/kFaultMagic = 0x46415554/kFaultMagic = 0x46415553/' $magic
touch -d 2001-01-01 $magic
[ "$(built)" = "$first" ] && echo "the first one again"
