"""Holds runs of robots against bounds that were computed from their images: stages, interrupts, releases, what jobs take
around their stages, and every chain. A run knows nothing of the bounds, and judge.py shares nothing with FineMote.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import judge

FINEMOTE = sys.argv.pop(1)
EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"


class Computed(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.robot = pathlib.Path(self.folder.name) / "robot.urdf"

    def tearDown(self):
        self.folder.cleanup()

    def finemote(self, *words):
        return subprocess.run([FINEMOTE, *words], cwd=self.folder.name, capture_output=True, text=True, check=False)

    def analysis(self):
        answer = self.finemote("analyze", "robot.urdf", "--format", "json", "--require-static")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return json.loads(answer.stdout)

    def hold(self, example):
        text = (EXAMPLES / f"{example}.urdf").read_text()
        self.assertNotIn("<wcet", text)  # what counts is the image alone
        self.robot.write_text(text)
        bounded = self.finemote("wcet", "robot.urdf", "-o", "robot.timing.json")
        self.assertEqual(bounded.returncode, 0, bounded.stderr)
        analysis = self.analysis()
        self.assertEqual({entry["label"] for entry in analysis["wcet_labels"] + analysis["cost_labels"]}, {"static"})
        ran = self.finemote("run", "robot.urdf", "--duration", "300ms", "--seed", "7", "--phases", "2", "--audit",
                            "record.jsonl", "--slowest")
        self.assertIn(ran.returncode, (0, 1), ran.stderr)
        held = judge.Judge(analysis)
        held.take(pathlib.Path(self.folder.name) / "record.jsonl")
        verdict = held.verdict()
        self.assertEqual(verdict.broken, [])
        kinds = {key[2] for key in verdict.shares}
        self.assertLessEqual({"own", "response", "release", "interrupt", "flush", "decide"}, kinds)

    def test_finsrov(self):
        self.hold("finsrov")

    def test_infantry(self):
        self.hold("infantry")

    def test_six_joint_arm(self):
        self.hold("six_joint_arm")

    def test_discovery(self):
        self.hold("discovery")


if __name__ == "__main__":
    unittest.main()
