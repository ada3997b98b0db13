"""What the search is made of: all types, frames that parsers take, the same draws each time; and that it finds what plain
stimuli do not.

usage: search_test.py FINEMOTE
"""

import pathlib
import random
import subprocess
import sys
import unittest

import lines
import robots
import search
import subjects
import vocabulary

HERE = pathlib.Path(__file__).parent
SHIPPED_TYPES = {path.stem for path in (robots.ROOT / "schemas" / "devices").glob("*.json")}
LINK = """
inline constexpr finemote::LinkSlot link_down_0[] = {  // servo
    finemote::link_down<finemote::LinkKind::kF32>(servo.command.angle),
};
inline constexpr finemote::LinkTarget link_down[] = {
    {servo.command, link_down_0, /*block*/ 0},
};
inline constexpr finemote::LinkLayout link_layout{0x5c4913d6, link_up, link_down, /*blocks*/ 1, 1};
"""


class Subjects(unittest.TestCase):
    def test_every_shipped_type_is_searched(self):
        outlines = [robots.Outline(subject.text()) for subject in subjects.all_subjects().values()]
        self.assertEqual(SHIPPED_TYPES - {kind for outline in outlines for kind in outline.types.values()}, set())

    def test_all_run_their_code_from_sram(self):
        for name, subject in subjects.all_subjects().items():
            self.assertIn('<param name="code">sram</param>', subject.text(), name)


class Lines(unittest.TestCase):
    def test_sum_of_a_link(self):
        self.assertEqual(lines.crc16(b"123456789"), 0x29B1)

    def test_layout_of_a_link(self):
        layout = lines.LinkLayout(LINK)
        self.assertEqual((layout.number, layout.sizes), (0x5C4913D6, {0: 5}))

    def test_sums_of_an_attitude_sensor(self):
        self.assertEqual(lines.h30_frame([(0x10, b"\x01")]), b"\x59\x53\x00\x00\x03\x10\x01\x01\x15\x3f")

    def test_bytes_are_sent_one_after_the_other(self):
        events = list(lines.as_events("usart1", 5, b"\x01\x01\n"))
        self.assertEqual([(event["t_ns"], event["byte"], event["bytes"]) for event in events], [(5, 1, 2), (6, 10, 1)])


class Vocabulary(unittest.TestCase):
    def scenario(self, seed):
        text = subjects.small("gimbal").text()
        draw, known = random.Random(seed), vocabulary.Vocabulary(robots.Outline(text), None)
        slots = [known.slot(draw) for _ in range(20)]
        return known.scenario([known.mutated(slot, draw) for slot in slots])

    def test_a_seed_draws_the_same_scenario_again(self):
        self.assertEqual(self.scenario(1), self.scenario(1))
        self.assertNotEqual(self.scenario(1), self.scenario(2))

    def test_nothing_is_drawn_where_nothing_can_happen(self):
        text = subjects.all_subjects()["two_devices"].text()
        known = vocabulary.Vocabulary(robots.Outline(text), None)
        self.assertEqual(known.mutated(known.slot(random.Random(1)), random.Random(1)), ())


class Bounds(unittest.TestCase):
    TIMING = {"stages": [{"device": "eye", "stage": "update", "wcet_ns": 1000}],
              "interrupts": [{"source": "wire.EV", "with_faults_ns": 300}],
              "scheduler": [{"what": "release", "wcet_ns": 1, "with_faults_ns": 2}, {"what": "masked", "wcet_ns": 1},
                            {"what": "bucket 1 ms", "period_ns": 1_000_000, "with_faults_ns": 2000}]}

    def test_routines_have_what_it_takes_to_come_there_and_back(self):
        self.assertEqual(search.bounds_of(self.TIMING, 100), {
            ("eye", "update"): 1000, ("wire.EV", "routine"): 400, ("scheduler", "release"): 102,
            ("scheduler", "bucket 1000000"): 2100})

    def test_what_is_lowered_is_kept_by_plain_stimuli(self):
        figure = search.Figure(100)
        figure.plain = figure.longest = 50
        row = search.Row("robot", ("eye", "update"), figure, "camera", None)
        self.assertEqual((row.held_to(False), row.held_to(True)), (100, 62.5))


class Search(unittest.TestCase):
    def test_bounds_that_only_plain_stimuli_keep_are_broken(self):
        words = ["--finemote", FINEMOTE, "--generations", "16", "--jobs", "1", "--inject", "host_link"]
        answer = subprocess.run([sys.executable, HERE / "search.py", *words], capture_output=True, text=True, check=False)
        self.assertEqual(answer.returncode, 1, answer.stderr)
        self.assertIn("broken: host_link root update", answer.stdout)


if __name__ == "__main__":
    FINEMOTE = sys.argv.pop()
    unittest.main()
