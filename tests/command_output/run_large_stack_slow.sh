# An image is linked with as much stack as it is proven to need, and a project that was kept reserves it too.
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
finemote run robot.urdf --build-only --keep work --format json | grep -oE '"stack": ?4[0-9]{4}\b' | sed 's/4[0-9]*$/40000 and some/'
echo "${PIPESTATUS[0]}"
grep -oE 'STACK 4[0-9]{4}' work/CMakeLists.txt | sed 's/4[0-9]*$/40000 and some/'
