# two robots at once into one folder: one of them is there, whole, and the other is refused
robot <<'Y'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
Y
sed 's/rover/boat/' robot.urdf >boat.urdf
cp robot.urdf rover.urdf
for name in rover boat; do finemote -q generate $name.urdf -o whole/$name; done
good=0
for round in $(seq 100); do
  for name in rover boat; do { finemote -q generate $name.urdf -o out 2>$name.said; echo $? >$name.status; } & done
  wait
  winner=$(grep -lx 0 rover.status boat.status); loser=$(grep -lx 2 rover.status boat.status)
  diff -r out "whole/${winner%.status}" && grep -q 'FM5003' "${loser%.status}.said" && good=$((good + 1))
  rm -r out
done
echo "$good of 100"
finemote -q generate rover.urdf -o out
finemote -q generate boat.urdf -o out
