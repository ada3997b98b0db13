probe_robot <<'X'
#include <cstdint>
struct Probe {
  finemote::Stamp state;
  void update() { *reinterpret_cast<volatile std::uint32_t*>(0x40000800) = 1; }  // TIM4, whose clock is off
  void handle() {}
};
X
finemote run robot.urdf --duration 20ms 2>said >/dev/null
status=$?
sed -E 's/[0-9]+ times/N times/; s/first at [0-9]+ ns/first at N ns/; s/pc 0x[0-9a-f]+/pc N/' said >&2
exit $status
