robot <<'B'
    <bus name="jetson" type="uart" port="usart1" baud="921600baud" isr_wcet="22us"/>
    <device name="link" type="host_link" bus="jetson" period="10ms">
      <wcet update="90us" handle="3us"/>
      <device name="arm" type="sim_load" period="1ms"><wcet update="60us" handle="40us"/></device>
    </device>
B
finemote analyze robot.urdf | sed -n '1p;/^processor/,/^$/p'
# The hint about the rate, written into the file: every deadline is met, with the load it promised.
finemote check robot.urdf -o out 2>said >/dev/null
hint=$(sed -n 's/^  hint: \(baud=.*\)/\1/p' said | head -n 1)
rate=${hint%% *}
sed -i "s/baud=\"921600baud\"/${rate:-no rate}/" robot.urdf
echo "with $rate, which promised ${hint##* needs }:"
finemote analyze robot.urdf | sed -n '1p;/^processor/p'
