for period in $(seq 1 40); do
  printf '    <device name="load_%d" type="sim_load" period="%dms"/>\n' $period $period
done | robot
finemote generate robot.urdf -o out
