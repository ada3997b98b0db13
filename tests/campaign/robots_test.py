"""What is drawn, without a run: the same robots each time, of all types, and accepted by the tool.

usage: robots_test.py FINEMOTE
"""

import collections
import pathlib
import sys
import tempfile
import unittest

import census
import draw
import judge
import robots
import stimuli
import tool
import workshop

DRAWN, ANALYSED = 1000, 60
LEAST = 0.05  # of the drawn robots, for each type: more than 3 % of those that count

SHIPPED_TYPES = {path.stem for path in (robots.ROOT / "schemas" / "devices").glob("*.json")}
OWN_TYPES = {path.stem for path in robots.DEVICES.glob("*.json")}


def outlines(count):
    for number in range(count):
        yield number, robots.Outline(draw.draw_robot(1, number).text())


class Draws(unittest.TestCase):
    def test_a_number_draws_the_same_robot_again(self):
        for number in range(10):
            self.assertEqual(draw.draw_robot(1, number).text(), draw.draw_robot(1, number).text())
        self.assertNotEqual(draw.draw_robot(1, 0).text(), draw.draw_robot(2, 0).text())

    def test_every_type_is_in_enough_robots(self):
        seen = collections.Counter()
        for _, outline in outlines(DRAWN):
            seen.update(set(outline.types.values()))
        rare = {kind: seen[kind] for kind in SHIPPED_TYPES | OWN_TYPES if seen[kind] < LEAST * DRAWN}
        self.assertEqual(rare, {})

    def test_enough_robots_have_noise(self):
        noisy = sum(stimuli.Stimuli(outline, 1, number).disturbed is not None for number, outline in outlines(DRAWN))
        self.assertGreater(noisy, 0.15 * DRAWN)

    def test_stimuli_of_what_is_left_out_are_left_out(self):
        outline = robots.Outline(draw.draw_robot(1, 0).text())
        left = robots.Outline('<robot name="robot"/>')
        for scenario, _ in stimuli.Stimuli(outline, 1, 0).runs(left):
            self.assertEqual([event for event in scenario["events"] if "part" in event or "port" in event], [])


class Analyses(unittest.TestCase):
    def test_drawn_robots_are_accepted_and_a_third_of_the_chains_is_short(self):
        chains = []
        with tempfile.TemporaryDirectory() as folder:
            finemote = tool.Tool(FINEMOTE, pathlib.Path(folder) / "worker")
            for number in range(ANALYSED):
                robot = draw.draw_robot(1, number)
                robots.set_load(robot, 0.0)
                types = robots.Outline(robot.text()).types
                analysis = finemote.analyze(robot)
                self.assertIsNotNone(analysis, robot.text())
                chains += [c["decide_ns"] for c in analysis["chains"]
                           if judge.is_bounded(c) and types[c["from"]] in workshop.SAMPLED]
        self.assertGreater(len(chains), 5 * ANALYSED)
        self.assertGreater(sum(decide < census.SHORT_NS for decide in chains), len(chains) / 3)


if __name__ == "__main__":
    FINEMOTE = sys.argv.pop()
    unittest.main()
