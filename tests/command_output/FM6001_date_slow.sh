probe_robot <<'X'
struct Probe {
  void update() { state = __TIME__[7]; }
  void handle() {}
  char volatile state = 0;
};
X
finemote wcet robot.urdf -o robot.timing.json >answer 2>said
status=$?
grep -o -e 'finemote: error.*' -e '__TIME__.*prevent.*' -e 'hint: .*' said | awk '!seen[$0]++' >&2
exit $status
