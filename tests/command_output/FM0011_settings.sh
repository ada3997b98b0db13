# every mistake in finemote.json at its place; what a stranger's file must not decide
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
mkdir parts
cat >finemote.json <<'X'
{
  "$schema": "settings.schema.json",
  "bord": "host",
  "force": true,
  "output": "/tmp/out",
  "sandbox": false,
  "data-dir": "/tmp",
  "profile": 3,
  "device-path": ["parts", "../other", "/etc", 5],
  "package": { "a": "parts", "b": ".." },
  "arguments": "period",
  "deny": [null]
}
X
finemote tree robot.urdf
echo '["host"]' >finemote.json; finemote diff robot.urdf robot.urdf
ln -s / parts/root; echo '{ "device-path": ["parts/root"] }' >finemote.json; finemote check robot.urdf -o out --format gcc
echo '{ "board": "host", }' >finemote.json; finemote analyze robot.urdf
echo '{ "board": "host", "board": "host" }' >finemote.json; finemote lint robot.urdf
