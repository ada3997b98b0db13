"""Attacks the bounds: draws robots, loads them to their limit, runs each with random phases and clock errors, and holds
what the record of the run shows against what analyze proves. See README.md beside this file.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

import judge
import robots

STEPS = 8  # of the search for the largest load


class Tool:
    """The command line of FineMote."""

    def __init__(self, path, folder):
        self.path, self.folder = path, pathlib.Path(folder)

    def call(self, *arguments):
        return subprocess.run([self.path, *arguments], capture_output=True, text=True, check=False)

    def write(self, robot):
        path = self.folder / "robot.urdf"
        path.write_text(robot.text(), encoding="utf-8")
        return str(path)

    def analyze(self, robot):
        """The document of analyze, or None where the robot is refused or has no answer."""
        answer = self.call("analyze", self.write(robot), "--format", "json")
        return json.loads(answer.stdout) if answer.returncode in (0, 1) and answer.stdout else None

    def is_schedulable(self, robot):
        analysis = self.analyze(robot)
        return analysis is not None and analysis["target"]["schedulable"]

    def run(self, robot, number, phases):
        """Path of the record, or None with what went wrong."""
        record = self.folder / "audit.jsonl"
        answer = self.call("run", self.write(robot), "--duration", "300ms", "--phases", str(phases), "--seed",
                           str(number), "--audit", str(record), "--format", "json")
        if answer.returncode in (0, 1) and record.exists():
            return record, answer
        return None, answer


def scaled(robot, load):
    robot.load = load
    robots.set_loads(robot)
    return robot


def load_to_limit(tool, robot, share):
    """Scales the loads to this share of what is just schedulable; False where nothing is.

    @return  the breakdown load, or None
    """
    if not tool.is_schedulable(scaled(robot, 0.0)):
        return None
    low, high = 0.0, 8.0
    for _ in range(STEPS):
        middle = (low + high) / 2
        if tool.is_schedulable(scaled(robot, middle)):
            low = middle
        else:
            high = middle
    scaled(robot, low * share)
    return low


class Result:
    """What became of one drawn robot."""

    def __init__(self, number):
        self.number, self.state, self.verdict, self.breakdown = number, "discarded", None, None
        self.kinds, self.text, self.problem = [], "", ""


def attack(path, seed, number, phases, injected):
    """Draws, loads, runs and judges one robot."""
    result = Result(number)
    with tempfile.TemporaryDirectory() as folder:
        tool = Tool(path, folder)
        robot = robots.draw_robot(seed, number)
        share = 0.8 + 0.2 * robots.random.Random(f"{seed}/{number}/share").random()
        result.breakdown = load_to_limit(tool, robot, share)
        if result.breakdown is None:
            return result
        result.kinds, result.text = robots.kinds_of(robot), robot.text()
        analysis = tool.analyze(robot)
        record, answer = tool.run(robot, number, phases)
        if record is None:
            result.state, result.problem = "failed", answer.stderr[-2000:]
            return result
        result.verdict = judge.judge(record, analysis, judge.lowering(injected))
        result.state = "counted" if result.verdict.counts else "unjudged"
        if result.verdict.broken:
            result.state = "violated"
        return result


def shrink(path, seed, number, phases, injected):
    """The smallest robot that still breaks a bound: parts are left out one by one."""
    with tempfile.TemporaryDirectory() as folder:
        tool = Tool(path, folder)
        robot = robots.draw_robot(seed, number)
        share = 0.8 + 0.2 * robots.random.Random(f"{seed}/{number}/share").random()
        load_to_limit(tool, robot, share)

        def breaks():
            analysis = tool.analyze(robot)
            if analysis is None or not analysis["target"]["schedulable"]:
                return False
            record, _ = tool.run(robot, number, phases)
            return record is not None and bool(judge.judge(record, analysis, judge.lowering(injected)).broken)

        for siblings, index in robots.removable(robot):
            part = siblings.pop(index)
            if not breaks():
                siblings.insert(index, part)
        return robot.text()


def print_tightness(results, out):
    by_kind = {}
    for result in results:
        for kind, shares in result.verdict.tightness.items():
            by_kind.setdefault(kind, []).extend(shares)
    print("largest measured / bound   figures  median     p95     max", file=out)
    for kind, shares in sorted(by_kind.items()):
        shares.sort()
        print(f"  {kind:<24} {len(shares):>7}  {statistics.median(shares):6.3f}  "
              f"{shares[int(0.95 * (len(shares) - 1))]:6.3f}  {shares[-1]:6.3f}", file=out)


def print_census(results, out):
    kinds, chains = {}, []
    for result in results:
        for kind in set(result.kinds):
            kinds[kind] = kinds.get(kind, 0) + 1
        chains += [decide for _, _, decide in result.verdict.chains]
    total = max(len(results), 1)
    print("robots with a type: " + ", ".join(f"{kind} {100 * n // total} %" for kind, n in sorted(kinds.items())), file=out)
    short = sum(decide < 1_000_000 for decide in chains)
    print(f"{len(chains)} chains, {short} of them decide below 1 ms", file=out)
    breakdowns = [result.breakdown for result in results]
    if breakdowns:
        print(f"median breakdown load: {statistics.median(breakdowns):.3f}", file=out)


def options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--robots", type=int, default=40, help="how many have to count")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--phases", type=int, default=2, help="runs of each robot")
    parser.add_argument("--inject", choices=list(judge.INJECTIONS), help="make these bounds 2 %% too small")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--finemote", default="finemote", help="the program under attack")
    parser.add_argument("--keep-going", action="store_true", help="do not stop at the first violation")
    return parser.parse_args()


def main():
    asked = options()
    counted, drawn, discarded, unjudged, violated = [], 0, 0, 0, []
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        while len(counted) + len(violated) < asked.robots and not (violated and not asked.keep_going):
            batch = range(drawn, drawn + 4 * asked.jobs)
            drawn = batch.stop
            tasks = [(asked.finemote, asked.seed, number, asked.phases, asked.inject) for number in batch]
            for result in pool.map(lambda task: attack(*task), tasks):
                if len(counted) + len(violated) == asked.robots:
                    break
                if result.state == "failed":
                    print(f"robot {result.number} cannot be run:\n{result.problem}\n{result.text}", file=sys.stderr)
                    sys.exit(2)
                discarded += result.state == "discarded"
                unjudged += result.state == "unjudged"
                if result.state == "violated":
                    violated.append(result)
                elif result.state == "counted":
                    counted.append(result)
    for result in violated[:3]:
        print(f"robot {result.number} of seed {asked.seed}:")
        for line in result.verdict.broken[:5]:
            print("  " + line)
        print(shrink(asked.finemote, asked.seed, result.number, asked.phases, asked.inject))
    print_tightness(counted, sys.stdout)
    print_census(counted, sys.stdout)
    print(f"{drawn} drawn, {discarded} discarded as not schedulable, {unjudged} unjudged")
    print(f"{len(counted) + len(violated)} robots, {len(violated)} violations")
    return 1 if violated else 0


if __name__ == "__main__":
    sys.exit(main())
