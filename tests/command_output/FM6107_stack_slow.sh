probe_robot <<'X'
struct Probe {
  finemote::Stamp state;
  void update() {
    volatile char room[40000];
    room[0] = 1;
    state.valid = room[1] == 1;
  }
  void handle() {}
};
X
finemote run robot.urdf --build-only 2>said
status=$?
sed -E 's/needs [0-9]+ bytes/needs N bytes/; s/size=[0-9]+/size=N/' said >&2
exit $status
