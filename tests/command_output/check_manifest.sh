# what the manifest says of files, against what is there
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
cp -r out first
echo '-- a comment, CR: no file changes but the manifest'
sed -i 's#<link#<!-- base --><link#; s/$/\r/' robot.urdf
finemote check robot.urdf -o out; echo "exit $?"
finemote check robot.urdf -o out --format json | grep manifest_change
finemote generate robot.urdf -o out --dry-run
finemote generate robot.urdf -o out -v
finemote check robot.urdf -o out; echo "exit $?"
echo '-- a file edited into what would be generated now'
sed -i 's/10ms/20ms/' robot.urdf
finemote -q generate robot.urdf -o second
cp second/schedule.cpp out
finemote check robot.urdf -o out; echo "exit $?"
sed -i 's/$/\r/' out/schedule.cpp
finemote check robot.urdf -o out | grep schedule.cpp
finemote generate robot.urdf -o out; echo "exit $?"
echo '-- CR inside a word'
sed -i 's/namespace/name\rspace/' out/schedule.cpp
finemote check robot.urdf -o out; echo "exit $?"
echo '-- a manifest that lists a folder'
mkdir out/notes
sed -i 's#"outputs": \[#&\n    { "name": "trees", "sha256": "" }, { "name": "notes", "sha256": "" },#' out/finemote.manifest.json
finemote check robot.urdf -o out; echo "exit $?"
finemote generate robot.urdf -o out --force; echo "exit $?"
ls out
