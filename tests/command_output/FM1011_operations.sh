# What would take minutes or gigabytes ends at the place that asks for it.
try() { printf '== %s\n' "$1"; echo "$1" | xacro_robot; shift; finemote xacro robot.urdf.xacro "$@" >/dev/null; echo "exit $?"; }
{
  try '<xacro:property name="s" value="${'"'a'"'*1000000}"/><link name="${'"('a'*500000+'b')"' in s}"/>'
  try '<xacro:property name="n" value="${7**370000}"/><link name="${[n // (n >> i) for i in range(100000)]}"/>'
  try '<link name="${[list(range(1000000)) for i in range(100)]}"/>' --sandbox
  try '<link name="${['"'a'*60000000"' for i in range(1000)]}"/>' --sandbox
  mkdir -p a/b c/d
  try '<xacro:include filename="*/../*/../*/../*/../*/../*/../*/../*/../*/../*/../*/../*/../*/../x*"/>'
  try '<xacro:include filename="*/../*/../*/../*/../*/../*/../*/../*/../*/../*/../*/../*/../*/../x*"/>' --sandbox
} 2>&1
