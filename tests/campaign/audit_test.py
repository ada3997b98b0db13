"""The checker against a record made by hand, whose figures are plain to see."""

import json
import tempfile
import unittest

import audit
import inject
import judge
import robots

EYE = '<robot name="robot"><device name="eye" type="camera"/><device name="hand" type="claw"/></robot>'

US = 1_000_000  # picoseconds

HEADER = {
    "what": "robot", "image": "", "seed": 0, "phase": 0, "clock_hz": 168e6, "nominal_hz": 168e6,
    "stages": [{"device": d, "stage": s, "exception": 64, "period_ns": 1000000}
               for d in ("eye", "hand") for s in ("update", "handle")],
    "exceptions": {"15": {"kind": "release"}, "64": {"kind": "bucket", "period_ns": 1000000},
                   "49": {"kind": "bus", "bus": "wire", "source": "EV"}},
}


def job(at, sample, run):
    """One job from `at` [us] on; a bus interrupt of 3 us falls into the first update."""
    events = [
        ("due", 0, {"exception": 15}), ("enter", 0, {"exception": 15}), ("return", 1, {"exception": 15}),
        ("tail", 1, {"exception": 64}), ("begin", 2, {"stage": 0}),
        ("enter", 4, {"exception": 49}), ("return", 6, {"exception": 49}), ("resume", 7, {"exception": 49}),
        ("end", 10, {"stage": 0}), ("used", 10, {"device": "eye", "channel": 0, "n": sample, "claimed": None}),
        ("begin", 11, {"stage": 2}), ("end", 12, {"stage": 2}), ("begin", 12, {"stage": 3}), ("end", 15, {"stage": 3}),
        ("begin", 15, {"stage": 1}), ("end", 16, {"stage": 1}), ("return", 17, {"exception": 64}),
        ("resume", 18, {"exception": 64}),
        ("output", 40, {"part": "hand", "channel": 0, "device": "hand", "job": run}),
    ]
    return [{"t": (at + t) * US, "what": what, **rest} for what, t, rest in events]


def record():
    events = [{"t": -100 * US, "what": "sample", "part": "eye", "channel": 0, "n": 0, "from": -300 * US},
              {"t": 0, "what": "ready"}]
    events += job(0, 0, 0) + job(1000, 0, 1)
    events.sort(key=lambda event: event["t"])
    return [HEADER] + events


def analysis(**changed):
    bounds = {"acquire": 1302000, "stamped": 1400000, "decide": 14000, "wire": 26000, "end_to_end": 1340000, **changed}
    devices = [{"name": "eye", "parent": "hand", "period_ns": 1000000, "update_wcet_ns": 5000, "handle_wcet_ns": 1000},
               {"name": "hand", "parent": None, "period_ns": 1000000, "update_wcet_ns": 1000, "handle_wcet_ns": 3000}]
    return {
        "model": {"devices": devices, "buses": [], "costs": {"release_ns": 2000, "release_per_bucket_ns": 0, "interrupt_ns": 0,
                                                             "job_ns": 9000, "stage_ns": 0}},
        "target": {"devices": [{"name": "eye", "r_plus_ns": 11000, "r_minus_ns": 16000},
                               {"name": "hand", "r_plus_ns": 12000, "r_minus_ns": 15000}]},
        "chains": [{"from": "eye", "to": "hand", **{k + "_ns": v for k, v in bounds.items()}}],
    }


def verdict(events, bounds, disturbed=None, lowered=inject.nothing_lowered):
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
        file.writelines(json.dumps(event) + "\n" for event in events)
        file.flush()
        judged = judge.Judge(bounds, lowered)
        judged.take(file.name, disturbed)
        return judged.verdict()


class Figures(unittest.TestCase):
    def setUp(self):
        with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
            file.writelines(json.dumps(event) + "\n" for event in record())
            file.flush()
            phase = audit.read(file.name)[0]
        self.seen = audit.Measures(phase, audit.Robot(analysis()["model"]), [("eye", "hand")]).longest.values

    def figure(self, *key):
        return self.seen[key][0]

    def test_a_chain_is_taken_apart(self):
        self.assertEqual(self.figure("eye", "hand", "acquire"), 1302 * US)
        self.assertEqual(self.figure("eye", "hand", "decide"), 13 * US)
        self.assertEqual(self.figure("eye", "hand", "wire"), 25 * US)
        self.assertEqual(self.figure("eye", "hand", "end_to_end"), 1340 * US)

    def test_own_times_leave_interrupts_out(self):
        self.assertEqual(self.figure("eye", "update", "own"), 5 * US)
        self.assertEqual(self.figure("wire", "routine", "interrupt"), 3 * US)
        self.assertEqual(self.figure("processor", "release", "release"), 1 * US)
        self.assertEqual(self.figure("1000000", "job", "flush"), (18 - 1 - 3 - 10) * US)

    def test_responses_count_from_the_release(self):
        self.assertEqual(self.figure("hand", "handle", "response"), 15 * US)


class Verdicts(unittest.TestCase):
    def test_bounds_that_are_met_hold(self):
        seen = verdict(record(), analysis())
        self.assertEqual(seen.broken, [])
        self.assertEqual(seen.chains, [("eye", "hand")])

    def test_every_part_of_a_chain_can_break(self):
        for kind, bound in (("acquire", 1301999), ("decide", 12999), ("wire", 24999), ("end_to_end", 1339999)):
            seen = verdict(record(), analysis(**{kind: bound}))
            self.assertEqual([line.split(":")[0] for line in seen.broken], [f"eye hand {kind}"])

    def test_every_figure_of_the_processor_can_break(self):
        bounds = analysis()
        bounds["model"]["buses"] = [{"name": "wire", "wcet_ns": 3000, "sources": [{"name": "step", "wcet_ns": 3000}]}]
        for key, seen_ns in ((("eye", "update", "response"), 10000), (("hand", "handle", "response"), 15000),
                             (("eye", "update", "own"), 5000), (("wire", "routine", "interrupt"), 3000),
                             (("processor", "release", "release"), 1000), (("1000000", "job", "flush"), 4000)):
            def below(held, bound, key=key, seen_ns=seen_ns):
                return seen_ns - 1 if held == key else bound
            self.assertEqual([line.split(":")[0] for line in verdict(record(), bounds, lowered=below).broken], [" ".join(key)])

    def test_claims_fresher_than_the_sample_are_found(self):
        events = record()
        for event in events:
            if event["what"] == "used":
                event["claimed"] = -300 * US + 1_000_001
        self.assertEqual(len(verdict(events, analysis()).broken), 2)

    def test_data_that_look_older_than_they_may_are_found(self):
        for age, broken in ((1_420_000, ["eye hand claim"]), (1_390_000, [])):
            events = record()
            for event in events:
                if event["what"] == "used":
                    event["claimed"] = event["t"] - age * 1000
            seen = verdict(events, analysis())
            self.assertEqual([line.split(":")[0] for line in seen.broken], broken)

    def test_overruns_and_resets_are_found(self):
        events = record() + [{"t": 2000 * US, "what": "overrun", "exception": 64}, {"t": 2001 * US, "what": "reset"}]
        self.assertEqual(len(verdict(events, analysis()).broken), 2)

    def test_a_command_that_was_overtaken_waited_for_what_came_instead(self):
        for sent, broken in ((True, ["eye hand wire"]), (False, [])):
            events = [event for event in record() if (event["what"], event.get("job")) != ("output", 0)]
            events.append({"t": 1040 * US, "what": "superseded", "device": "hand", "job": 0, "sent": sent})
            seen = verdict(events, analysis())
            self.assertEqual([line.split(":")[0] for line in seen.broken], broken)

    def test_what_the_tool_calls_broken_counts_unless_the_scenario_excuses_it(self):
        held, broken = {"judged": "held"}, {"judged": "broken"}
        excused = {"judged": "broken", "assumption": "bus-errors"}
        chain = {"from": "eye", "to": "foot", **dict.fromkeys(judge.KINDS, held)}
        fine = {"chains": [chain], "responses": [], "jitter": [], "claims": [], "loops": [], "order": {"mistake": None}}
        for differs, said in (({}, []),
                              ({"chains": [{**chain, "wire": excused}], "claims": [{"device": "eye", **excused}]}, []),
                              ({"chains": [{**chain, "wire": broken}]}, ["eye -> foot wire"]),
                              ({"claims": [{"device": "eye", **broken}]}, ["eye claims"]),
                              ({"loops": [{"function": "f", **broken}]}, ["loop in f"]),
                              ({"order": {"mistake": "eye runs twice"}}, ["order: eye runs twice"])):
            judged = judge.Judge(analysis())
            judged.take_document({**fine, **differs})
            self.assertEqual([line.split(" is")[0] for line in judged.broken], said)

    def test_what_has_no_sample_does_not_count(self):
        events = [event for event in record() if event["what"] != "output"]
        self.assertEqual(verdict(events, analysis()).chains, [])

    def test_noise_takes_the_ground_from_what_goes_over_its_bus_and_from_nothing_else(self):
        bounds = analysis(acquire=1, decide=12999, wire=1, end_to_end=1)
        bounds["model"]["devices"][0]["transfers"] = [{"bus": "line"}]
        bounds["model"]["flushes"] = [{"period_ns": 1000000, "wcet_ns": 0, "bus": "wire", "devices": ["hand"]}]
        for bus, kinds in (("line", ["decide", "wire"]), ("wire", ["acquire", "decide"]), ("other", list(judge.KINDS))):
            seen = verdict(record(), bounds, disturbed=bus)
            self.assertEqual(sorted(line.split(":")[0].split()[2] for line in seen.broken), sorted(kinds))


class Injections(unittest.TestCase):
    def test_a_bound_two_percent_below_what_is_reached_is_found(self):
        classes = inject.Classes(robots.Outline(EYE), analysis()["model"])
        lowered = inject.lowered_to({"camera update": 0.5}, "own", classes)
        self.assertEqual(lowered(("eye", "update", "own"), 1000), 490)
        self.assertEqual(lowered(("eye", "handle", "own"), 1000), 1000)
        self.assertEqual(lowered(("eye", "hand", "acquire"), 1000), 1000)


if __name__ == "__main__":
    unittest.main()
