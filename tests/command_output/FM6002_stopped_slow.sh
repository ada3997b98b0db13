probe_robot <<'X'
#include <cstdlib>
struct Probe {
  finemote::Stamp state;
  void update() { std::exit(7); }
  void handle() {}
};
X
finemote run robot.urdf --board host
