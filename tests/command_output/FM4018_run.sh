robot <<'Y'
    <device name="load" type="sim_load" period="10ms"/>
Y
status=0
finemote run robot.urdf --chain 'load -> lod' --keep work || status=$?
test ! -e work && exit $status  # nothing was generated or compiled
