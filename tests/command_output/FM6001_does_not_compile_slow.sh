probe_robot <<'X'
struct Probe {
  finemote::Stamp state;
  void update() { state.valid = is_there(); }
  void handle() {}
};
X
finemote run robot.urdf --board host 2>said
status=$?
grep -o -e 'finemote: error.*' -e "probe.hpp:.*'is_there'.*" -e 'probe.hpp.*is_there.*' said | head -2 >&2
exit $status
