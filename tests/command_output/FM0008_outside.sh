# A branch that reaches out of its folder, every way there is: nothing of what lies outside is said, not even that it exists.
mkdir -p branch/devices secret
echo 'token-5f2a' >secret/token
echo '{"schema": "finemote.device/1"}' >secret/stolen.json
cd branch
ln -s ../secret linked
ln -s ../secret/token token.xacro
ln -s ../secret/nothing dangling.xacro
ln -s ../secret/stolen.json devices/stolen.json
mkdir .git
echo '[http] extraheader = token-5f2a' >.git/config
ask() {
  echo "== $1"
  printf '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">%s<link name="base_link"/></robot>\n' "$1" >robot.urdf.xacro
  finemote xacro --sandbox robot.urdf.xacro 2>&1
  echo "exit $?"
}
for name in ../secret/token "$PWD/../secret/token" linked/token token.xacro dangling.xacro linked/nothing ../secret/nothing \
  .git/config ../secret /etc/passwd /proc/self/environ /dev/stdin './devices/../../secret/token' 'linked/*' '../*/token' '*/token' \
  'file:///etc/passwd' '$(find nowhere)/token'; do
  ask "<xacro:include filename=\"$name\"/>"
done
mkdir d1 d2 d3 d4 d5 d6 d7 d8 d9
ask '<xacro:include filename="*/../*/../*/../*/../x"/>'
ask '<xacro:include filename="../secret/token" optional="true"/>'
ask '<a v="${xacro.load_yaml('"'../secret/token'"')}"/>'
ask '<a v="${xacro.load_yaml('"'.git/config'"')}"/>'
