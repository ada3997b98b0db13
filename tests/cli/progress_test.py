#!/usr/bin/env python3
"""Long commands say on a terminal what they do, and nowhere else. usage: progress_test.py FINEMOTE SOURCE"""
import os
import pathlib
import pty
import subprocess
import sys
import unittest

FINEMOTE, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
COMMAND = [FINEMOTE, "run", str(SOURCE / "examples/two_devices.urdf"), "--duration", "20ms", "--phases", "2"]


def on_terminal(*words, terminal="xterm"):
    """(stdout, what a terminal was sent by standard error)"""
    ours, theirs = pty.openpty()
    with subprocess.Popen([*COMMAND, *words], stdout=subprocess.PIPE, stderr=theirs,
                          env={**os.environ, "TERM": terminal}) as process:
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
        self.assertNotIn("compiling", on_terminal(terminal="dumb")[1])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]], verbosity=2)
