probe_robot <<'X'
struct Table {
  constexpr Table() : bytes() {
    for (unsigned i = 0; i < sizeof bytes; ++i) bytes[i] = static_cast<unsigned char>(7 * i);
  }
  unsigned char bytes[120'000];
};
inline constexpr Table table;
struct Probe {
  finemote::Stamp state;
  void update() { state.valid = table.bytes[next++ % sizeof table.bytes] != 0; }
  void handle() {}
  unsigned next = 0;
};
X
finemote run robot.urdf --build-only 2>said
status=$?
grep -o -e 'finemote: error.*' -e 'region .* overflowed' -e 'hint: .*' said >&2
exit $status
