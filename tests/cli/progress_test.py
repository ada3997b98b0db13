#!/usr/bin/env python3
"""Long commands say on a terminal what they do, and nowhere else; findings have colour there. usage: progress_test.py FINEMOTE SOURCE"""
import os
import pathlib
import pty
import subprocess
import sys
import tempfile
import unittest

FINEMOTE, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
PLAIN = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
COMMAND = [FINEMOTE, "run", str(SOURCE / "examples/two_devices.urdf"), "--duration", "20ms", "--phases", "2",
           "--color", "never"]


def on_terminal(*words, command=COMMAND, **environment):
    """(stdout, what a terminal was sent by standard error)"""
    ours, theirs = pty.openpty()
    with subprocess.Popen([*command, *words], stdout=subprocess.PIPE, stderr=theirs,
                          env={**PLAIN, "TERM": "xterm", **environment}) as process:
        os.close(theirs)
        said = b""
        try:
            while more := os.read(ours, 1 << 16):
                said += more
        except OSError:  # the other side is closed
            pass
        os.close(ours)
        return process.stdout.read(), said.decode()


class Progress(unittest.TestCase):
    def test_a_terminal_shows_each_step_and_is_clean_in_the_end(self):
        written, said = on_terminal()
        steps = said.split("\r\033[K")
        self.assertEqual([step.split(" ")[0] for step in steps[1:-1]], ["compiling", "running", "running"], said)
        self.assertIn(": 2 of 2", steps[-2])
        plain = subprocess.run(COMMAND, capture_output=True, check=False)
        self.assertEqual(plain.stdout, written)
        self.assertEqual(plain.stderr.decode().replace("\n", "\r\n"), steps[0] + steps[-1])

    def test_nothing_is_said_where_nobody_reads_it(self):
        self.assertNotIn("compiling", on_terminal("-q")[1])
        self.assertNotIn("compiling", on_terminal(TERM="dumb")[1])


class Color(unittest.TestCase):
    def has_color(self, *words, **environment):
        with tempfile.NamedTemporaryFile(suffix=".urdf") as robot:
            robot.write(b"<model/>")
            robot.flush()
            said = on_terminal(*words, command=[FINEMOTE, "tree", robot.name], **environment)[1]
        self.assertIn("FM2005", said)
        return "\033[" in said

    def test_a_terminal_has_color_unless_somebody_wants_none(self):
        self.assertTrue(self.has_color())
        self.assertTrue(self.has_color("--color", "auto"))
        self.assertTrue(self.has_color(NO_COLOR=""))
        self.assertFalse(self.has_color(NO_COLOR="1"))
        self.assertFalse(self.has_color("--color", "auto", NO_COLOR="1"))

    def test_always_and_never_mean_it(self):
        self.assertFalse(self.has_color("--color", "never"))
        self.assertTrue(self.has_color("--color", "always", NO_COLOR="1"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]], verbosity=2)
