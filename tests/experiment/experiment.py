#!/usr/bin/env python3
"""The case study: builds FinsROV's five firmwares, runs them on the emulated board, and writes what was measured.

experiment.py --finemote PROGRAM [--seed S] [-o DIR] [--work DIR] [--jobs N]

DIR gets case-study.md, experiment.json and pictures/case-study-*.svg. The same seed and toolchain give the same bytes.
"""

import argparse
import concurrent.futures
import json
import pathlib
import sys
import tempfile

import firmwares
import measure
import page
import plans
import robot

#: 2 runs of 510 periods make 1,020. A sensor whose clock is off meets every phase of a period in a run.
RUNS, PERIODS = 2, 510
#: Where the code is, and whether there is load.
VARIANTS = (("sram", ""), ("flash", ""), ("sram", "_loaded"))


class Experiment:
    """All runs, over a number of workers. Results do not depend on the order in which they end."""

    def __init__(self, bench, seed, jobs, runs=RUNS, periods=PERIODS, variants=VARIANTS):
        self.bench, self.seed, self.jobs, self.runs, self.periods = bench, seed, jobs, runs, periods
        self.variants = variants
        self.job = {}

    def prepare(self):
        names = [f"{f.name}_{code}{load}" for f in firmwares.FIRMWARES for code, load in self.variants]
        self.bench.build(names, self.jobs)
        self.job, flashed = self.bench.job()
        if flashed != self.bench.flashed("generated_sram"):
            raise RuntimeError("the generated firmware is not the one that `finemote run` judges")

    def over(self, tasks):
        """`tasks`: functions by key. Their results by key, in the same order."""
        with concurrent.futures.ProcessPoolExecutor(max_workers=self.jobs) as pool:
            running = {key: pool.submit(*task) for key, task in tasks.items()}
            return {key: result.result() for key, result in running.items()}

    def timing(self):
        """Figures by firmware, code and load."""
        tasks = {}
        for firmware in firmwares.FIRMWARES:
            for code, load in self.variants:
                jobs = [plans.timing_job(self.job, self.seed, number, code, bool(load), self.periods) for number in range(self.runs)]
                tasks[firmware.name, code, load] = (measured, self.bench, firmware, f"{firmware.name}_{code}{load}", jobs)
        return self.over(tasks)

    def motion(self):
        return self.over({firmware.name: (moved, self.bench, f"{firmware.name}_sram",
                                          plans.scenario_job(self.job, plans.motion(), plans.MOTION_END_NS))
                          for firmware in firmwares.FIRMWARES})

    def faults(self):
        return self.over({(fault, firmware.name): (broken, self.bench, f"{firmware.name}_sram", fault,
                                                   plans.scenario_job(self.job, events, plans.FAULT_END_NS))
                          for fault, (_, events) in plans.FAULTS.items() for firmware in firmwares.FIRMWARES})


def measured(bench, firmware, name, jobs):
    figures = measure.Figures()
    for number, job in enumerate(jobs):
        record = bench.run(name, job, f"{name}.{number}")
        figures.add(record, firmware, plans.SETTLED_NS * 1000)
    return figures


def moved(bench, name, job):
    return robot.motion(bench.run(name, job, f"{name}.motion"))


def broken(bench, name, fault, job):
    return robot.fault(bench.run(name, job, f"{name}.{fault}"))


def document(seed, compiler, figures, faults, motion):
    """experiment.json"""
    def entries(load):
        return [{"name": name, "code": code, **one.document()} for (name, code, loaded), one in figures.items() if loaded == load]

    def without_curves(one):
        return {key: value for key, value in one.items() if key not in ("depth", "yaw")}

    return {"schema": "finemote.experiment/1", "seed": seed, "compiler": compiler, "firmwares": entries(""),
            "loaded": entries("_loaded"),
            "motion": [{"name": name, **without_curves(one)} for name, one in motion.items()],
            "faults": [{"fault": fault, "name": name, **one} for (fault, name), one in faults.items()]}


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--finemote", required=True)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", dest="out", default="docs")
    parser.add_argument("--work", help="folder for builds, kept; without it a temporary one")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    compiler = firmwares.compiler()
    if firmwares.COMPILER not in compiler:
        print(f"skipped: the figures are those of arm-none-eabi-g++ {firmwares.COMPILER} of Debian 12, and this is {compiler}")
        return 77
    with tempfile.TemporaryDirectory(prefix="finemote-experiment-") as temporary:
        experiment = Experiment(firmwares.Workbench(arguments.finemote, arguments.work or temporary), arguments.seed, arguments.jobs)
        print("building five firmwares", file=sys.stderr)
        experiment.prepare()
        print("timing", file=sys.stderr)
        figures = experiment.timing()
        print("motion and faults", file=sys.stderr)
        motion, faults = experiment.motion(), experiment.faults()
        result = document(arguments.seed, compiler, figures, faults, motion)
        out = pathlib.Path(arguments.out)
        write(out / "experiment.json", json.dumps(result, indent=1) + "\n")
        for name, picture in page.pictures(figures, motion).items():
            write(out / "pictures" / name, picture)
        write(out / "case-study.md", page.page(result, experiment.bench.analysis(), experiment.runs * experiment.periods))
    print(out / "case-study.md")
    return 0


if __name__ == "__main__":
    sys.exit(main())
