robot <<'X'
    <device name="base" type="group" period="10ms">
      <device name="base_children" type="sim_load"/>
    </device>
X
finemote generate robot.urdf -o out
