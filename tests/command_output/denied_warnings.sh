# A denied warning turns an answer that is yes into exit status 2, and leaves one that is no.
robot <<'X'
    <device name="load" type="sim_load" period="1ms">
      <param name="update">2ms</param>
      <wcet update="2ms" handle="10us" source="budget"/>
    </device>
X
finemote analyze robot.urdf -W error --format json 2>said >document
echo "exit $?"
python3 -c 'import json; print(json.load(open("document"))["target"]["schedulable"])'
grep -o "FM4015" said >&2
sed -i '/<param name="update"/d; /<wcet/d' robot.urdf
finemote analyze robot.urdf -W error --format json 2>/dev/null >document
