"""Holds the shipped examples against their bounds: chains between all pairs of devices, random phases and clock errors, on an
ordinary and on a strict chip; undisturbed, and with everything that can go wrong on one bus after the other. See README.md
beside this file.
"""

import argparse
import concurrent.futures
import itertools
import pathlib
import random
import re
import shutil
import sys
import tempfile

import faults
import judge
import robots
import stimuli
import tool

EXAMPLES = robots.ROOT / "examples"

BATCH = 20  # phases whose record is read at once


class Example:
    """A robot as it is shipped, with its timing file; `pairs` are those that chains are asked for."""

    def __init__(self, path):
        self.path, self.pairs = path, []

    def text(self):
        return self.path.read_text(encoding="utf-8")

    def lay(self, folder):
        """Puts the timing file where the tool looks for it."""
        timing, beside = self.path.with_suffix(".timing.json"), folder / "robot.timing.json"
        if timing.exists():
            shutil.copy(timing, beside)


def analysis_of_all_pairs(called, example):
    """Gives the example every pair that data lead between; returns the analysis."""
    names = [device["name"] for device in called.analyze(example)["model"]["devices"]]
    example.pairs = list(itertools.permutations(names, 2))
    refused = set(re.findall(r"FM4018]: no data leads from '(.*)' to '(.*)'", called.call("analyze", example).stderr))
    example.pairs = [pair for pair in example.pairs if pair not in refused]
    return called.analyze(example)


def scenarios_of(outline, name):
    """What happens and how long, and the bus that faults are on, None: on none."""
    for bus, events in [(None, []), *faults.of_buses(outline)]:
        length_ns = faults.length_ns(events)
        moves = stimuli.moves(outline, random.Random(name), length_ns)
        yield bus, stimuli.scenario_of(moves + events, outline), length_ns


def batches(phases):
    """Numbers of runs with how many phases each has; the odd ones are on a strict chip."""
    first, size = 0, min(BATCH, (phases + 1) // 2)
    for number in itertools.count():
        if first >= phases:
            return
        yield number, min(size, phases - first)
        first += size


def attack(finemote, path, phases, seed):
    """Lines on an example, and those of what it breaks; a crash of the program is among them."""
    try:
        return hold(finemote, path, phases, seed)
    except tool.ToolFailed as failure:
        return [], [f"{path.stem}: {failure}"]


def hold(finemote, path, phases, seed):
    """The same. Raises ToolFailed."""
    with tempfile.TemporaryDirectory() as folder:
        example, called = Example(path), tool.Tool(finemote, pathlib.Path(folder) / "worker", EXAMPLES / "devices")
        example.lay(called.folder)
        analysis = analysis_of_all_pairs(called, example)
        outline, lines, broken = robots.Outline(example.text()), [], []
        for bus, scenario, length_ns in scenarios_of(outline, path.stem):
            held = judge.Judge(analysis)
            is_recovering = bus is not None and outline.buses[bus][0] == "i2c"
            for number, count in batches(phases):
                record, said = called.run(example, scenario, seed + number, count, f"{length_ns // 1000}us")
                if record is None:
                    return lines, [f"{path.stem} cannot be run: {said}"]
                held.take(record, bus, is_recovering)
            verdict = held.verdict()
            what = f"{path.stem}, {'undisturbed' if bus is None else 'faults on ' + bus}"
            lines.append(f"{what}: {len(verdict.shares)} figures, {len(verdict.chains)} of {len(held.asked)} chains "
                         f"judged in every part, {len(verdict.broken)} broken")
            broken += [f"{what}: {words}" for words in verdict.broken or ([] if verdict.shares else ["nothing was judged"])]
        return lines, broken


def options():
    parser = tool.options(argparse.ArgumentParser(description=__doc__))
    parser.add_argument("--phases", type=int, default=200, help="runs of each scenario")
    parser.add_argument("examples", nargs="*", help="their names; all of them if absent")
    return parser.parse_args()


def main():
    asked = options()
    known = sorted(EXAMPLES.glob("*.urdf"))
    paths = [path for path in known if not asked.examples or path.stem in asked.examples]
    if not paths or set(asked.examples) - {path.stem for path in known}:
        print(f"the examples are {', '.join(path.stem for path in known)}", file=sys.stderr)
        return 2
    violations = 0
    with concurrent.futures.ProcessPoolExecutor(asked.jobs) as pool:
        attacks = [pool.submit(attack, asked.finemote, path, asked.phases, asked.seed) for path in paths]
        for lines, broken in (future.result() for future in attacks):
            violations += len(broken)
            print("\n".join(lines + broken), flush=True)
    print(f"{len(paths)} examples, {violations} violations")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
