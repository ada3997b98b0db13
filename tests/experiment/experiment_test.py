#!/usr/bin/env python3
"""experiment_test.py FINEMOTE: builds the five firmwares, measures a few periods of each, and changes one of them.

Nothing here knows what the figures should be: that the marks and parts are where measure.py looks for them, that a
firmware that waits longer measures longer, and that the same run gives the same figures.
"""

import pathlib
import shutil
import sys
import tempfile

import experiment
import firmwares
import measure
import plans

PERIODS = 12
CHANGED, EXTRA_US = "competent_polled", 300
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED", what)


def document(bench, firmware, job):
    record = bench.run(f"{firmware.name}_sram", job, firmware.name)
    figures = measure.Figures()
    figures.add(record, firmware, plans.SETTLED_NS * 1000)
    return record, figures.document()


def check_places(name, record):
    """Stages and parts belong together as measure.py says. What the vehicle's update computes of others' data comes from
    their samples, too."""
    own = [use for use in record["uses"] if use[1] != measure.update(measure.ROV)]
    homes = {part: {use[1] for use in own if use[2] == part} for part in ("imu", "baro_1", "baro_4")}
    expect(homes == {"imu": {measure.update(0)}, "baro_1": {measure.update(1)}, "baro_4": {measure.update(4)}},
           f"{name}: stages that take samples: {homes}")
    outputs = {p["channel"]: p["stage"] for p in record["parts"] if p["output"] and p["stage"] is not None}
    expect(outputs == {k: measure.handle(device) for k, device in enumerate(measure.THRUSTERS)},
           f"{name}: stages that set pulses: {outputs}")
    expect(not record["reports"], f"{name}: {record['reports']}")


def check_figures(name, one):
    for what in ("decision", "wire", "wire_imu", "take_to_pulse"):
        expect(one[what]["n"] >= PERIODS // 4 and one[what]["min_ns"] > 0, f"{name}: {what} {one[what]}")
    expect(one["decision"]["max_ns"] < 10_000_000, f"{name}: decides within its period")
    expect(abs(sum(one["cpu"].values()) - 1) < 1e-3, f"{name}: shares {one['cpu']}")
    expect(one["cpu"]["control"] > 0 and one["cpu"]["idle"] > 0, f"{name}: shares {one['cpu']}")


def slowed(folder):
    """The baselines, one of which waits before it sends its pulses."""
    shutil.copytree(firmwares.BASELINES, folder)
    main = folder / CHANGED / "main.cpp"
    text = main.read_text(encoding="utf-8")
    place = "  const MarkedWork<Work::flush_expander> marked;\n"
    assert text.count(place) == 1
    main.write_text(text.replace(place, f"  wait_at_start({EXTRA_US} * kMicrosecond);\n" + place), encoding="utf-8")
    return folder


def main():
    with tempfile.TemporaryDirectory(prefix="finemote-experiment-test-") as temporary:
        folder = pathlib.Path(temporary)
        bench = firmwares.Workbench(sys.argv[1], folder / "work")
        study = experiment.Experiment(bench, 5, 2, runs=1, periods=PERIODS, variants=(("sram", ""),))
        study.prepare()
        job = plans.timing_job(study.job, 5, 0, "sram", False, PERIODS)
        seen = {}
        for firmware in firmwares.FIRMWARES:
            record, seen[firmware.name] = document(bench, firmware, job)
            check_places(firmware.name, record)
            check_figures(firmware.name, seen[firmware.name])
        changed = next(f for f in firmwares.FIRMWARES if f.name == CHANGED)
        expect(document(bench, changed, job)[1] == seen[CHANGED], "the same run gives the same figures")

        bench.baselines = slowed(folder / "slowed")
        bench.build([f"{CHANGED}_sram"], 2)
        longer = document(bench, changed, job)[1]["decision"]["mean_ns"] - seen[CHANGED]["decision"]["mean_ns"]
        expect(abs(longer - EXTRA_US * 1000) < 10_000, f"a wait of {EXTRA_US} us makes the decision {longer / 1000} us longer")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
