"""A crash of the program under attack is a failure of its own, and no robot that is discarded. Scripts stand in for it."""

import pathlib
import tempfile
import unittest

import attack
import draw
import examples
import robots
import search
import tool

CRASHES = {"a signal": ("kill -SEGV $$", "status -11"), "an internal error": ("echo of its own >&2; exit 3", "of its own")}


class Crashes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, script):
        path = self.folder / "finemote"
        path.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        path.chmod(0o755)
        return str(path)

    def called(self, script):
        return tool.Tool(self.program(script), self.folder / "worker")

    def attacked(self, script, is_static=False):
        return attack.attack(attack.Task(self.program(script), self.folder, 1, 0, 1, is_static=is_static))

    def test_answers_are_documents(self):
        for status in (0, 1):
            self.assertEqual(self.called(f"echo '{{}}'; exit {status}").analyze(draw.draw_robot(1, 0)), {})
        self.assertIsNone(self.called("exit 2").analyze(draw.draw_robot(1, 0)))

    def test_no_call_takes_a_crash_for_an_answer(self):
        robot = draw.draw_robot(1, 0)
        for name, (script, said) in CRASHES.items():
            called = self.called(script)
            for call in (lambda: called.analyze(robot), lambda: called.bound(robot), lambda: called.run(robot, {}, 0, 1)):
                with self.subTest(name), self.assertRaisesRegex(tool.ToolFailed, said):
                    call()

    def test_a_robot_that_is_refused_is_discarded(self):
        self.assertEqual(self.attacked("exit 2").state, "discarded")

    def test_a_robot_on_which_the_program_crashes_has_failed(self):
        for name, (script, said) in CRASHES.items():
            for is_static in (False, True):
                with self.subTest(name, is_static=is_static):
                    result = self.attacked(script, is_static)
                    self.assertEqual(result.state, "failed")
                    self.assertIn(said, result.problem)
                    self.assertIn("<robot ", result.text)

    def test_search_and_examples_say_what_crashed(self):
        for name, (script, said) in CRASHES.items():
            with self.subTest(name):
                rows, problem = search.attack(self.program(script), self.folder, "two_devices", 1, 1)
                self.assertEqual(rows, [])
                self.assertIn(said, problem)
                lines, broken = examples.attack(self.program(script), robots.ROOT / "examples" / "two_devices.urdf", 1, 1)
                self.assertEqual((lines, len(broken)), ([], 1))
                self.assertIn(said, broken[0])


if __name__ == "__main__":
    unittest.main()
