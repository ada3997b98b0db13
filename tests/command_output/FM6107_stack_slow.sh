# An image is linked with as much stack as it is proven to need, and a project that was kept reserves it too. Others have to be
# told, so it is said; the run is none the worse for it.
probe_robot <<'Y'
struct Probe {
  finemote::Stamp state;
  void update() {
    volatile char room[40000];
    room[0] = 1;
    state.valid = room[1] == 1;
  }
  void handle() {}
};
Y
finemote run robot.urdf --build-only --keep work --format json 2>said | grep -oE '"stack": ?4[0-9]{4}\b' | sed 's/4[0-9]*$/40000 and some/'
echo "${PIPESTATUS[0]}"
sed -E 's/\b4[0-9]{4}\b/40000 and some/g' said >&2
grep -oE 'STACK 4[0-9]{4}' work/CMakeLists.txt | sed 's/4[0-9]*$/40000 and some/'
