#!/usr/bin/env python3
"""The figures of a run that is written down by hand, with what they have to be."""

import unittest

import measure
import page
import pictures
from measure import handle, update

US = 1_000_000  # ps


def stage(events, number, begin, end):
    events += [(begin * US, "begin", number), (end * US, "end", number)]


def record(wire_us=1000):
    """Three periods of 10 ms. The sensor's update takes sample n at 0 us of its period, which was taken 4 ms before; the
    vehicle decides at 200 us, thruster k at 300 + 10 k, pulses are set `wire_us` after the begin of the period."""
    events, parts, uses = [], [], []
    for n in range(3):
        at = n * 10_000
        stage(events, update(measure.SENSOR), at, at + 50)
        stage(events, update(measure.IMU), at + 60, at + 70)
        stage(events, update(measure.ROV), at + 100, at + 150)
        stage(events, handle(measure.ROV), at + 200, at + 250)
        parts.append({"part": "baro_1", "output": False, "channel": 0, "from_ps": (at - 4000) * US, "at_ps": 0, "stage": None, "n": n})
        uses.append([(at + 50) * US, update(measure.SENSOR), "baro_1", 0, n, None])
        parts.append({"part": "imu", "output": False, "channel": 0, "from_ps": (at - 2000) * US, "at_ps": 0, "stage": None, "n": n})
        uses.append([(at + 70) * US, update(measure.IMU), "imu", 0, n, None])
        for k, device in enumerate(measure.THRUSTERS):
            stage(events, handle(device), at + 300 + 10 * k, at + 305 + 10 * k)
            parts.append({"part": "pwm", "output": True, "channel": k, "from_ps": 0, "at_ps": (at + wire_us) * US,
                          "stage": handle(device), "n": n})
    events.sort(key=lambda event: event[0])
    return {"audit": events, "parts": parts, "uses": uses}


class FakeFirmware:
    buckets = False


def written(events):
    """As the emulated board writes them."""
    names = sorted({what for _, what, _ in events})
    return {"names": names, "events": [number for at, what, n in events for number in (at, names.index(what), n)]}


def figures(one):
    result = measure.Figures()
    result.add({**one, "audit": written(one["audit"])}, FakeFirmware, 0)
    return result


class TestFigures(unittest.TestCase):
    def test_decision_reaches_to_the_last_thruster(self):
        self.assertEqual(figures(record()).decision, [375 * US])

    def test_decision_reaches_to_the_call_that_hands_over_the_pulses(self):
        one = record()
        one["audit"] += [((n * 10_000 + 420) * US, "done", measure.FLUSH) for n in range(3)]
        one["audit"].sort(key=lambda event: event[0])
        self.assertEqual(figures(one).decision, [420 * US])

    def test_wire_begins_with_the_sample_that_was_taken(self):
        self.assertEqual(figures(record()).wire, [5000 * US] * 2)
        self.assertEqual(figures(record(2500)).wire, [6500 * US] * 2)
        self.assertEqual(figures(record(2500)).wire_imu, [4500 * US] * 2)

    def test_wire_goes_back_over_updates_that_had_ended(self):
        one = record()
        # The sensor's second update ends behind the begin of the vehicle's: that one saw the first sample still.
        one["audit"] = [((10_120 * US), what, number) if (at, number, what) == (10_050 * US, update(measure.SENSOR), "end")
                        else (at, what, number) for at, what, number in one["audit"]]
        one["audit"].sort(key=lambda event: event[0])
        next(use for use in one["uses"] if use[2] == "baro_1" and use[4] == 1)[0] = 10_120 * US
        self.assertEqual(figures(one).wire, [5000 * US, 15_000 * US])

    def test_intervals_between_last_ends(self):
        one = figures(record())
        self.assertEqual(one.interval, [10_000 * US])

    def test_jitter_over_whole_turns_is_free_of_phases(self):
        one = measure.Figures()
        ends = [n * 10_000 + 400 * (n % measure.TURN) for n in range(12)]
        one.interval = [b - a for a, b in zip(ends, ends[1:])]
        one.turn = measure.turns_of(ends)
        self.assertEqual(set(one.turn), {30_000})
        self.assertGreater(len(set(one.interval)), 1)

    def test_a_period_in_which_nothing_was_taken_has_no_decision(self):
        one = record()
        one["audit"] = [event for event in one["audit"] if event[2] != update(measure.SENSOR) or event[0] < 5000 * US]
        self.assertEqual(figures(one).decision, [])


class TestShares(unittest.TestCase):
    EVENTS = [(10, "work", measure.SPIN), (15, "enter", 50), (18, "resume", 50), (20, "done", measure.SPIN), (40, "work", measure.IDLE),
              (45, "enter", 64), (47, "tail", 50), (48, "resume", 50), (90, "done", measure.IDLE)]

    def test_time_goes_to_what_ran(self):
        spent = measure.shares(self.EVENTS, 0, 100, False)
        self.assertEqual(spent, {"control": 10 + 20 + 10, "interrupt": 3 + 2 + 1, "spin": 5 + 2, "idle": 5 + 42})

    def test_buckets_are_control_and_the_rest_is_idle(self):
        spent = measure.shares([event for event in self.EVENTS if event[1] not in ("work", "done")], 0, 100, True)
        self.assertEqual(spent, {"control": 2, "interrupt": 3 + 1, "spin": 0, "idle": 94})


class TestPage(unittest.TestCase):
    def test_a_worse_figure_is_named(self):
        good = figures(record()).document()
        good["jitter_sd_ns"] = 1.0
        good["cpu"] = {"control": 0.1, "interrupt": 0.1, "spin": 0.0, "idle": 0.8}
        late = {**good, "wire": {**good["wire"], "mean_ns": 2 * good["wire"]["mean_ns"]}}
        self.assertIn("wire of the depth, mean", page.losses({"generated": late, "public_polled": good}))
        self.assertNotIn("wire of the depth", page.losses({"generated": good, "public_polled": late}))
        self.assertIn("not reached", page.goals({"generated": late, "public_polled": good}))

    def test_bounds_are_those_of_what_is_measured(self):
        def chain(source, end, decide, whole):
            return {"from": source, "to": end, "decide_ns": decide * 1000, "end_to_end_ns": whole * 1_000_000}

        analysis = {"chains": [chain("imu", "thruster_1", 9000, 99), chain("baro_1", "thruster_1", 200, 30),
                               chain("baro_1", "thruster_8", 300, 20)]}
        rows = page.bounds_table(figures(record()).document(), analysis)
        self.assertIn("| 30.00 |", rows)
        self.assertIn("| 300.0 |", rows)

    def test_words_of_a_mark_end_before_the_next(self):
        across = pictures.Scale(0, 10, 0, 1000)
        near, far = (" ".join(pictures.marks_of([(1, "depth"), (at, "heading")], across, 300)) for at in (1.2, 5))
        self.assertIn('<text x="97" y="44" text-anchor="end">depth', near)
        self.assertIn('<text x="103" y="44" text-anchor="start">depth', far)

    def test_pictures_of_equal_values(self):
        for draw in (pictures.boxes, pictures.histograms):
            self.assertIn("</svg>", draw("title", [("one", [5.0, 5.0]), ("other", [7.0])], "us"))


if __name__ == "__main__":
    unittest.main()
