probe_robot <<'X'
struct Shape {
  virtual int corners() const { return 4; }
};
struct Probe {
  finemote::Stamp state;
  Shape shape;
  void update() { state.valid = shape.corners() == 4; }
  void handle() {}
};
X
finemote run robot.urdf --build-only
