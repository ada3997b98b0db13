"""Searches for scenarios in which stages and routines take longest, and holds what it finds against the bounds of the image.
See README.md beside this file.
"""

import argparse
import bisect
import concurrent.futures
import json
import math
import os
import pathlib
import random
import re
import statistics
import sys
import tempfile
import typing

import audit
import lines
import robots
import stimuli
import subjects
import tool
import vocabulary

SLOTS = 48  # of a run
BEST = 6  # slots that are kept for each figure
PLAIN_RUNS = 4  # of the stimuli of a campaign, each with two phases
SEEDS = 1 << 16

FIRST_LINE, LINE = 16, "finemote_line_"  # exception of interrupt line 0; routines of lines that are no bus

#: What no own time is made of.
NOT_NEEDED = (*audit.NOT_NEEDED, '"what":"due"', '"what":"sample"', '"what":"used"', '"what":"output"', '"what":"superseded"')

#: Where bounds are too small on purpose: so far from what the plain stimuli reach to the bound. They never come there.
INJECTED = 0.25

CYCLE_NS = 1e3 / 168


# ---- what a run shows


class Timed(audit.Execution):
    """Also when each exception ended, and its own time."""

    def __init__(self, phase):
        self.now, self.routines = 0, {}
        super().__init__(phase)

    def take(self, event):
        self.now = event["t"]
        super().take(event)

    def leave(self):
        if len(self.frames) > 1:
            self.routines.setdefault(self.frames[-1].exception, []).append((self.now, self.frames[-1].own))
        super().leave()


def name_of(meaning, number):
    """Of an exception, as the document of wcet calls it; meaning: None for a line that is no bus."""
    if meaning is None:
        return f"{LINE}{number - FIRST_LINE}", "routine"
    if meaning["kind"] == "bus":
        return f"{meaning['bus']}.{meaning['source']}", "routine"
    return ("scheduler", "release") if meaning["kind"] == "release" else ("scheduler", f"bucket {meaning['period_ns']}")


def own_times(phase):
    """Own times [ps] on the board's clock by figure: pairs of when it was and how long."""
    scale = phase.header["clock_hz"] / phase.header["nominal_hz"]
    execution, found = Timed(phase), {}
    for number, stage in enumerate(phase.header["stages"]):
        runs = execution.stages[number]
        found[stage["device"], stage["stage"]] = [(t, own * scale) for t, own in zip(runs.begins, runs.own)]
    for number, runs in execution.routines.items():
        meaning = phase.header["exceptions"].get(str(number))
        found[name_of(meaning, number)] = [(t, own * scale) for t, own in runs]
    return found


def bounds_of(timing, interrupt_ns):
    """Static bounds [ns] by figure, with faults: those of routines with what it takes to come there and back."""
    bounds = {(stage["device"], stage["stage"]): stage["wcet_ns"] for stage in timing["stages"]}
    for routine in timing["interrupts"]:
        bounds[routine["source"], "routine"] = routine["with_faults_ns"] + interrupt_ns
    for piece in timing["scheduler"]:
        if "with_faults_ns" in piece:
            name = "release" if piece["what"] == "release" else f"bucket {piece['period_ns']}"
            bounds["scheduler", name] = piece["with_faults_ns"] + interrupt_ns
    return bounds


def fpu_users(timing):
    """Interrupts that save and restore the registers of the FPU, which the chip's file does not charge them with."""
    return [entry.get("source") or entry["what"] for entry in (*timing["interrupts"], *timing["scheduler"]) if entry.get("uses_fpu")]


# ---- the search


class Run(typing.NamedTuple):
    """Everything that a run depends on beside the robot."""

    scenario: dict
    seed: int
    phases: int
    length_ns: int

    def duration(self):
        return f"{self.length_ns // 1000}us"

    def command(self, devices):
        return (f"finemote run robot.urdf --scenario scenario.json --slowest --seed {self.seed} --phases {self.phases} "
                f"--duration {self.duration()} --audit audit.jsonl --device-path {devices}\n")


class Figure:
    """The longest own times of a stage or routine [ns], its bound, and the slots in which it was longest."""

    def __init__(self, bound):
        self.bound, self.plain, self.longest = bound, 0.0, 0.0
        self.run, self.best = None, []  # entries of best: own, seed of the run, the slot before, the slot

    def keep(self, own, entry):
        self.best.append((own, *entry))
        self.best.sort(key=lambda kept: -kept[0])
        del self.best[BEST:]

    def is_among_best(self, own):
        return len(self.best) < BEST or own > self.best[-1][0]


class Search:
    """All that is tried on one robot."""

    def __init__(self, called, subject, seed):
        """Bounds the image, and runs the plain stimuli. Raises RuntimeError where the robot cannot be run."""
        self.called, self.subject, self.seed = called, subject, seed
        self.draw = random.Random(f"{seed}/{subject.name}/search")
        self.outline = robots.Outline(subject.text())
        timing_file = called.folder / "robot.timing.json"
        timing_file.unlink(missing_ok=True)
        self.assumed = self.analysis()["model"]["devices"]
        problem = called.bound(subject)
        if problem:
            raise RuntimeError(problem)
        interrupt_ns = self.analysis()["model"]["costs"]["interrupt_ns"]
        timing = json.loads(timing_file.read_text(encoding="utf-8"))
        if users := fpu_users(timing):
            raise RuntimeError(f"{subject.name}: interrupts that use the FPU are charged without: {', '.join(users)}")
        bounds = bounds_of(timing, interrupt_ns)
        self.figures = {key: Figure(bound) for key, bound in bounds.items() if bound > 0}
        self.run_plain()
        layout = lines.LinkLayout.of_folder(called.folder / "kept" / "generated")
        self.vocabulary = vocabulary.Vocabulary(self.outline, layout)

    def analysis(self):
        analysis = self.called.analyze(self.subject)
        if analysis is None:
            raise RuntimeError(f"{self.subject.name} cannot be analysed")
        return analysis

    def found_in(self, run):
        """Own times of each of its phases."""
        record, said = self.called.run(self.subject, run.scenario, run.seed, run.phases, run.duration())
        if record is None:
            raise RuntimeError(f"{self.subject.name} cannot be run: {said[-2000:]}")
        return [own_times(phase) for phase in audit.read(record, NOT_NEEDED)]

    def run_plain(self):
        """The first generation: what moves parts in a campaign, and noise."""
        for number in range(PLAIN_RUNS):
            for scenario, _ in stimuli.Stimuli(self.outline, self.seed, number).runs(self.outline):
                run = Run(scenario, self.seed + number, 2, stimuli.LENGTH_NS)
                for found in self.found_in(run):
                    self.take(found, run)
        for figure in self.figures.values():
            figure.plain = figure.longest

    def take(self, found, run, slots=()):
        """Keeps what was longest; slots: what the run was made of."""
        for key, times in found.items():
            figure = self.figures.get(key)
            if figure is None or not times:
                continue
            longest = max(own for _, own in times) / audit.PS
            if longest > figure.longest:
                figure.longest, figure.run = longest, run
            if slots:
                self.take_slots(figure, times, run.seed, slots)

    @staticmethod
    def take_slots(figure, times, seed, slots):
        begins = [t for t, _ in times]
        for number, slot in enumerate(slots):
            first, last = (bisect.bisect_left(begins, (number + k) * vocabulary.SLOT_NS * audit.PS) for k in (0, 1))
            own = max((own for _, own in times[first:last]), default=0) / audit.PS
            if figure.is_among_best(own):
                figure.keep(own, (seed, slots[number - 1] if number else (), slot))

    def one_of_best(self):
        """An entry of one of the figures, those that are far from their bounds more often than others. None: none yet."""
        figures = [figure for figure in self.figures.values() if figure.best]
        if not figures:
            return None
        weights = [math.sqrt(max(figure.bound - figure.longest, 1)) for figure in figures]
        return self.draw.choice(self.draw.choices(figures, weights)[0].best)

    def next_slots(self):
        """One slot, or two where what was before belongs to it."""
        entry, kind = self.one_of_best(), self.draw.random()
        if entry is None or kind < 0.2:
            return [self.vocabulary.slot(self.draw)]
        _, _, before, slot = entry
        if kind < 0.35:
            return [self.vocabulary.crossed(slot, self.one_of_best()[3], self.draw)]
        changed = self.vocabulary.mutated(slot, self.draw)
        if kind < 0.65:
            return [changed]
        return [before, changed] if kind < 0.85 else [self.vocabulary.mutated(before, self.draw), slot]

    def generation(self):
        slots = []
        while len(slots) < SLOTS:
            slots += self.next_slots()
        entry = self.one_of_best()
        seed = entry[1] if entry is not None and self.draw.random() < 0.5 else self.draw.randrange(SEEDS)
        run = Run(self.vocabulary.scenario(slots), seed, 1, SLOTS * vocabulary.SLOT_NS)
        for found in self.found_in(run):
            self.take(found, run, slots)


# ---- what comes out


class Row:
    """What was found of a stage or routine."""

    def __init__(self, subject, key, figure, kind, assumed):
        self.subject, self.key, self.kind, self.assumed = subject, key, kind, assumed
        self.bound, self.plain, self.longest, self.run = figure.bound, figure.plain, figure.longest, figure.run

    def name(self):
        return f"{self.kind} {self.key[1].split()[0]}"

    def held_to(self, is_injected):
        """Its bound, or what is too small on purpose."""
        return self.plain + INJECTED * (self.bound - self.plain) if is_injected else self.bound

    def cells(self):
        assumed = f"{self.assumed / 1000:.2f}" if self.assumed is not None else "-"
        times = (f"{time / 1000:.2f}" for time in (self.bound, self.plain, self.longest))
        return (self.name(), self.subject, *times, f"{self.bound / self.longest:.2f}" if self.longest else "-", assumed)


def kind_of(search, key):
    """Type of the device that a stage is of, or the line of a routine without the numbers of its port."""
    if key[1] == "routine":
        return "data ready" if key[0].startswith(LINE) else re.sub(r"(?<=[A-Za-z])[0-9]+(?=_|$)", "", key[0].split(".", 1)[1])
    return search.outline.types.get(key[0], key[0])


def nearest(rows):
    """Of each type and stage the row that came nearest to its bound."""
    best = {}
    for row in rows:
        other = best.get(row.name())
        if other is None or other.longest / other.bound < row.longest / row.bound:
            best[row.name()] = row
    return list(best.values())


def rows_of(search):
    assumed = {(d["name"], stage): d[stage + "_wcet_ns"] for d in search.assumed for stage in ("update", "handle")}
    return [Row(search.subject.name, key, figure, kind_of(search, key), assumed.get(key)) for key, figure in search.figures.items()]


def attack(finemote, folder, name, generations, seed):
    """Rows of one robot, or what keeps it from being run."""
    subject = subjects.all_subjects()[name]
    called = tool.Tool(finemote, pathlib.Path(folder) / f"{os.getpid()}_{subject.board()}", subject.devices, is_slowest=True)
    try:
        search = Search(called, subject, seed)
        for _ in range(generations):
            search.generation()
    except RuntimeError as problem:
        return [], str(problem)
    except tool.ToolFailed as failure:
        return [], f"{name}: {failure}"
    return rows_of(search), None


HEAD = ("stage or routine", "robot", "static", "plain", "longest", "ratio", "assumed")


def table(rows):
    cells = [HEAD, *(row.cells() for row in rows)]
    widths = [max(len(line[column]) for line in cells) for column in range(len(HEAD))]
    for line in cells:
        yield "  ".join(cell.ljust(width) if column < 2 else cell.rjust(width)
                        for column, (cell, width) in enumerate(zip(line, widths))).rstrip()


def summary(rows):
    """How far bounds of stages are above what was found, and how much of it the plain stimuli had found before."""
    stages = [row for row in rows if row.key[1] in ("update", "handle")]
    for what, longest in (("found", lambda row: row.longest), ("by plain stimuli", lambda row: row.plain)):
        ratios = [row.bound / longest(row) for row in stages if longest(row)]
        if ratios:
            yield f"static / longest {what}, median of {len(ratios)} stages: {statistics.median(ratios):.2f}"
    longer = sum(row.longest > row.plain + CYCLE_NS for row in rows)
    yield f"longer than by plain stimuli, by a cycle or more: {longer} of {len(rows)} figures"


def above_assumed(rows):
    """Stages that took longer than what counts without a timing file."""
    return [row for row in rows if row.assumed and row.longest > row.assumed]


#: Parsers: bounds of the image hold for all bytes that a line could bring, the assumed times for those that it is known to.
PARSERS = (*lines.PIECES, "host_link")


def below_bound(rows):
    """Stages of other types that are assumed to take less than the image can."""
    return [row for row in rows if row.assumed and row.kind not in PARSERS and row.bound > row.assumed]


def keep(folder, row):
    """The robot, the scenario in which it took so long, and the command that runs it."""
    place = pathlib.Path(folder) / f"{row.subject}_{row.kind}_{row.key[1]}".replace(" ", "_")
    place.mkdir(parents=True, exist_ok=True)
    subject = subjects.all_subjects()[row.subject]
    (place / "robot.urdf").write_text(subject.text(), encoding="utf-8")
    (place / "scenario.json").write_text(json.dumps(row.run.scenario), encoding="utf-8")
    (place / "command").write_text(row.run.command(subject.devices), encoding="utf-8")


def options():
    parser = tool.options(argparse.ArgumentParser(description=__doc__))
    parser.add_argument("--generations", type=int, default=100, help="runs of each robot behind those of plain stimuli")
    parser.add_argument("--inject", action="store_true", help="hold against bounds that only plain stimuli keep")
    parser.add_argument("--keep", metavar="FOLDER", help="write robots and scenarios there that break a bound")
    parser.add_argument("robots", nargs="*", help="their names; all of them if absent")
    return parser.parse_args()


def search_all(asked, names):
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ProcessPoolExecutor(asked.jobs) as pool:
        attacks = [pool.submit(attack, asked.finemote, folder, name, asked.generations, asked.seed) for name in names]
        for future in attacks:
            rows, problem = future.result()
            if problem:
                print(problem, file=sys.stderr)
                pool.shutdown(cancel_futures=True)
                sys.exit(2)
            yield from rows


def main():
    asked = options()
    known = list(subjects.all_subjects())
    if set(asked.robots) - set(known):
        print(f"the robots are {', '.join(known)}", file=sys.stderr)
        return 2
    rows = list(search_all(asked, [name for name in known if not asked.robots or name in asked.robots]))
    print("\n".join((*table(sorted(nearest(rows), key=Row.name)), *summary(rows))))
    broken = [row for row in rows if row.longest > row.held_to(asked.inject)]
    slower, guessed = above_assumed(rows), below_bound(rows)
    for row in broken:
        held_to = row.held_to(asked.inject)
        print(f"broken: {row.subject} {' '.join(row.key)}, {row.longest:.3f} ns seen, bound {held_to:.3f} ns")
    for row in slower:
        print(f"above what is assumed: {row.subject} {' '.join(row.key)}, {row.longest:.0f} ns of {row.assumed} ns")
    for row in guessed:
        print(f"assumed below its bound: {row.subject} {' '.join(row.key)}, {row.assumed} ns of {row.bound} ns")
    for row in (*broken, *slower) if asked.keep else ():
        keep(asked.keep, row)
    print(f"{len(rows)} figures, {len(broken)} above their bounds, {len(slower)} above what is assumed, "
          f"{len(guessed)} assumed below their bounds")
    return 1 if broken or slower or guessed else 0


if __name__ == "__main__":
    sys.exit(main())
