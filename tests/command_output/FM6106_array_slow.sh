probe_robot <<'X'
struct Probe {
  finemote::Stamp state;
  volatile int n = 5;
  void update() {
    volatile char* room = static_cast<volatile char*>(__builtin_alloca(static_cast<unsigned>(n)));
    room[0] = 1;
  }
  void handle() {}
};
X
finemote run robot.urdf --build-only
