# A firmware that stops after its first release is judged: a document, a record, exit status 1.
probe_robot <<'X'
#include <finemote/time.hpp>
struct Probe {
  finemote::Stamp state;
  int n = 0;
  void update() {
    if (++n == 20) finemote::busy(11'000'000);
  }
  void handle() {}
};
X
sed -i 's#<board name="robomaster_type_c"/>#<board name="robomaster_type_c"><param name="overrun">safe_stop</param></board>#' robot.urdf
finemote run robot.urdf --duration 500ms --audit record.jsonl --json run.json >text 2>said
echo "exit $?"
sed -n 1p text
grep -c '"what":"ready"' record.jsonl
python3 -c 'import json; d = json.load(open("run.json")); print(d["overruns"], [r["judged"] for r in d["responses"]])'
cat said >&2
