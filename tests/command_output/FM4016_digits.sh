robot <<'X'
    <device name="a" type="sim_load" period="10ms"><wcet update="10us" handle="10us"/></device>
    <device name="b" type="sim_load" period="10ms"><wcet update="10us" handle="10us"/></device>
    <require utilization="cpu" max="0.0000001%"/>
    <require latency="a -> b" max="1ms"/>
X
finemote analyze robot.urdf -q
