mkdir devices; touch devices/mute.hpp
cat > devices/mute.json <<'D'
{
  "schema": "finemote.device/1", "type": "mute", "summary": "does not say what it sends", "class": "my::Mute", "header": "mute.hpp",
  "bus": { "types": ["uart"] }, "wcet": { "update_ns": 90000, "handle_ns": 3000 }
}
D
robot <<'B'
    <bus name="jetson" type="uart" port="usart1" baud="921600baud" isr_wcet="15us"/>
    <device name="link" type="mute" bus="jetson" period="10ms">
      <wcet update="90us" handle="3us"/>
    </device>
    <device name="arm" type="sim_load" period="1ms"><wcet update="60us" handle="40us"/></device>
B
finemote --device-path devices analyze robot.urdf | sed -n '1p;/^processor/,/^$/p'
# The hint about the rate, written into the file: every deadline is met, with the load it promised.
finemote --device-path devices analyze robot.urdf 2>said >/dev/null
hint=$(sed -n 's/^  hint: \(baud=.*\)/\1/p' said | head -n 1)
rate=${hint%% *}
sed -i "s/baud=\"921600baud\"/${rate:-no rate}/" robot.urdf
echo "with $rate, which promised ${hint##* needs }:"
finemote --device-path devices analyze robot.urdf | sed -n '1p;/^processor/p'
