cat >robot.urdf <<'X'
<robot name="rover">
  <finemote version="1">
    <board name="robomaster_type_c"><param name="overrun">safe_stop</param></board>
    <device name="load" type="sim_load" period="1ms">
      <param name="update">2ms</param>
      <wcet update="10us" handle="10us" source="budget"/>
    </device>
  </finemote>
</robot>
X
finemote run robot.urdf --board host
