probe_robot <<'X'
extern finemote::Time started;
struct Probe {
  finemote::Stamp state;
  void update() { state.valid = finemote::now() > started; }
  void handle() {}
};
X
printf '#include "probe.hpp"\nfinemote::Time started = finemote::now();\n' >devices/probe.cpp
finemote run robot.urdf --build-only
