probe_robot <<'X'
#include <finemote/loop_bound.hpp>
struct Probe {
  finemote::Stamp state;
  void update() {
    for (unsigned i = 0; i < entries; i = i + 1) {
      finemote::retried_if_interrupted<finemote::RetriedBy::event>();
      sum = sum + i;
    }
    state.valid = true;
  }
  void handle() {}
  volatile unsigned entries = 6, sum = 0;
};
X
finemote run robot.urdf --duration 50ms >/dev/null
