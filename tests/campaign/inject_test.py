"""A WCET that is two percent too small has to be found.

usage: inject_test.py FINEMOTE
"""

import pathlib
import re
import subprocess
import sys
import unittest

CAMPAIGN = pathlib.Path(__file__).parent / "campaign.py"
BROKEN = re.compile(r"  \w+ (?:update|handle) own: [0-9.]+ ns seen, bound [0-9.]+ ns")


class Injected(unittest.TestCase):
    def test_own_times_above_a_wcet_are_found_and_nothing_else(self):
        words = ["--finemote", FINEMOTE, "--robots", "4", "--seed", "3", "--phases", "1", "--inject", "WCET", "--jobs", "1"]
        answer = subprocess.run([sys.executable, CAMPAIGN, *words], capture_output=True, text=True, check=False)
        self.assertEqual(answer.returncode, 1, answer.stderr)
        attacked = answer.stdout.split("largest measured / bound")[0]  # robots as XML, behind what each of them breaks
        broken = [line for line in attacked.splitlines() if line.startswith("  ") and not line.lstrip().startswith("<")]
        self.assertTrue(broken, answer.stdout)
        for line in broken:
            self.assertRegex(line, BROKEN)


if __name__ == "__main__":
    FINEMOTE = sys.argv.pop()
    unittest.main()
