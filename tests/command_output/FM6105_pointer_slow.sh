probe_robot <<'X'
struct Probe {
  finemote::Stamp state;
  void (*volatile callback)() = nullptr;
  void update() { callback(); }
  void handle() {}
};
X
finemote run robot.urdf --build-only 2>said
status=$?
sed -E 's/0x[0-9a-f]+/ADDRESS/' said >&2
exit $status
