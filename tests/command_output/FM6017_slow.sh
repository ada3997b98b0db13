mkdir far
printf 'inline constexpr int kRounds = 3;\n' >far/table.inc
probe_robot <<'X'
#define TEXT(x) #x
#define TABLE(name) TEXT(../far/name.inc)
#include TABLE(table)
struct Probe {
  void update() { state = kRounds; }
  void handle() {}
  int volatile state = 0;
};
X
finemote wcet robot.urdf -o robot.timing.json >answer
status=$?
[ ! -e robot.timing.json ] || echo 'there is a timing file' >&2
exit $status
