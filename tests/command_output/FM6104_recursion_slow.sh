probe_robot <<'X'
struct Probe {
  finemote::Stamp state;
  int n = 0;
  static int sum(volatile int* n, int k) { return k == 0 ? *n : sum(n, *n - k) + sum(n, k - *n); }
  void update() { n = sum(&n, n); }
  void handle() {}
};
X
finemote run robot.urdf --build-only
