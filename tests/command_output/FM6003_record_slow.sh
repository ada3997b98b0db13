probe_robot <<'X'
#include <cstdio>
struct Probe {
  finemote::Stamp state;
  void update() { std::puts("E what a record"); }
  void handle() {}
};
X
finemote run robot.urdf --board host
