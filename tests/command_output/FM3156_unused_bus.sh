robot <<'X'
    <bus name="spare" type="uart" port="usart1" baud="115200baud"/>
    <device name="load" type="sim_load" period="10ms"><wcet update="10us" handle="10us"/></device>
X
finemote lint robot.urdf
