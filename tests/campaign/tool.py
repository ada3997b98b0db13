"""The command line of FineMote, as the attack uses it."""

import json
import os
import pathlib
import subprocess

import robots
import stimuli

DURATION = f"{stimuli.LENGTH_NS // 1000}us"

#: How programs take memory from the system: a record is some ten megabytes of small pieces.
LARGE_PIECES = ":".join(f"glibc.malloc.{name}={size}" for name, size in
                        (("top_pad", 1 << 25), ("trim_threshold", 1 << 30), ("mmap_threshold", 1 << 30)))


def options(parser):
    """Adds what every attack is asked for: a seed, how many workers, and the program."""
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--finemote", default="finemote", help="the program under attack")
    return parser


class ToolFailed(Exception):
    """The program crashed: an internal error, or a signal."""


class Tool:
    """Calls of one worker, each of which raises ToolFailed where the program crashes. Its folder is kept from robot to robot:
    the runtime is compiled once, a robot's own code anew."""

    def __init__(self, path, folder, devices=robots.DEVICES, is_slowest=False):
        """devices: folder of the users' device types."""
        self.path, self.folder, self.devices, self.is_slowest = path, pathlib.Path(folder), devices, is_slowest
        self.document = None  # of the last run that left a record
        self.folder.mkdir(exist_ok=True)
        # What is compiled once, the runtime, may be in the compiler's cache; a robot's own code never is, and a look there
        # costs as much as half of the compilation.
        has_runtime = (self.folder / "kept" / "build" / "build.ninja").exists()
        self.environment = {**os.environ, "GLIBC_TUNABLES": LARGE_PIECES, **({"CCACHE_DISABLE": "1"} if has_runtime else {})}

    @staticmethod
    def ask(words, **options):
        """What the program answers with the exit status 0, 1 or 2: yes, no, or no answer."""
        answer = subprocess.run(words, capture_output=True, text=True, check=False, **options)
        if answer.returncode not in (0, 1, 2):
            raise ToolFailed(f"{words[1]} ended with exit status {answer.returncode}\n{answer.stderr}")
        return answer

    def write(self, robot):
        """The robot in its file; its path."""
        file = self.folder / "robot.urdf"
        file.write_text(robot.text(), encoding="utf-8")
        return file

    def call(self, command, robot, *arguments):
        chains = [word for source, target in robot.pairs for word in ("--chain", f"{source}->{target}")]
        words = [self.path, command, str(self.write(robot)), "--device-path", str(self.devices), "--format", "json"]
        return self.ask([*words, *chains, *arguments], env=self.environment)

    def bound(self, robot):
        """Writes the robot's timing file, which every call after it reads. None, or what the tool said where something in
        the image has no bound."""
        file = self.write(robot)
        words = [self.path, "wcet", str(file), "--device-path", str(self.devices), "-o", str(file.with_suffix(".timing.json"))]
        answer = self.ask(words)
        return None if answer.returncode == 0 else answer.stdout + answer.stderr

    def analyze(self, robot):
        """The document of analyze, or None where the robot is refused."""
        answer = self.call("analyze", robot)
        return None if answer.returncode == 2 else json.loads(answer.stdout)

    def run(self, robot, scenario, number, phases, duration=DURATION):
        """Path of the record, or None where there is none, and what the tool said. Every other robot runs on a chip that
        uses the freedom its manual leaves, or all in the slowest mode of the emulated board."""
        record, events = self.folder / "audit.jsonl", self.folder / "scenario.json"
        record.unlink(missing_ok=True)
        events.write_text(json.dumps(scenario), encoding="utf-8")
        silicon = ["--slowest"] if self.is_slowest else ["--silicon", "strict"] if number % 2 == 1 else []
        answer = self.call("run", robot, "--duration", duration, "--phases", str(phases), "--seed", str(number), *silicon,
                           "--scenario", str(events), "--audit", str(record), "--keep", str(self.folder / "kept"))
        good = answer.returncode in (0, 1) and record.exists()
        self.document = json.loads(answer.stdout) if good else None
        return (record if good else None), answer.stderr
