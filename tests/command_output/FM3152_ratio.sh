robot <<'X'
    <device name="base" type="sim_load" period="10ms">
      <device name="sensor" type="sim_load" period="4ms"><wcet update="20us" handle="1us"/></device>
    </device>
X
finemote lint robot.urdf
