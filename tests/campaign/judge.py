"""Holds the figures of a record against the bounds of `finemote analyze --format json`."""

import json
import pathlib

import audit

KINDS = ("acquire", "decide", "wire", "end_to_end")


#: Kind of the figures that an attack lowers, by what it is called.
INJECTIONS = {"release": "release", "flush": "flush", "interrupt": "interrupt", "acquire": "acquire", "wire": "wire",
              "WCET": "own"}

#: The largest share of its bound that each kind of figure reached in the sweep of README.md.
REACHED = json.loads((pathlib.Path(__file__).parent / "reached.json").read_text(encoding="utf-8"))


def lowering(kind):
    """What becomes of bounds where those of one kind are 2 % too small; None: of none.

    Too small is a bound that lies 2 % below what is reached. Bounds lie above that by what nobody has reached.
    """
    if kind is None:
        return lambda key, bound: bound
    name = INJECTIONS[kind]
    return lambda key, bound: bound * 0.98 * REACHED[name] if key[2] == name else bound


#: Frames in a receive FIFO, and mailboxes: one run of a routine of bxCAN can serve as many. RM0090 32.7.
CAN_DEPTH = 3


class Verdict:
    """What one robot showed."""

    def __init__(self):
        self.broken = []  # what was above its bound, in words
        self.unjudged = []  # chains of which some part is neither held nor broken
        self.chains = []  # (source, target, decide bound [ns]) of chains that were judged in every part
        self.tightness = {}  # by kind: lists of measured maximum / bound

    @property
    def counts(self):
        """Whether the robot is one of the campaign's."""
        return bool(self.chains)


def bounds_of(analysis):
    """All bounds in ns by what they bound; None where there is none."""
    bounds = {}
    for chain in analysis["chains"]:
        for kind in KINDS:
            bounds[chain["from"], chain["to"], kind] = chain[kind + "_ns"]
    for device in analysis["target"]["devices"]:
        bounds[device["name"], "update", "response"] = device["r_plus_ns"]
        bounds[device["name"], "handle", "response"] = device["r_minus_ns"]
    for device in analysis["model"]["devices"]:
        for stage in ("update", "handle"):
            bounds[device["name"], stage, "own"] = device[stage + "_wcet_ns"]
    add_costs(analysis["model"], bounds)
    return bounds


def add_costs(model, bounds):
    """What the scheduler and the drivers may use around the stages."""
    costs = model["costs"]
    periods = {device["period_ns"] for device in model["devices"]}
    bounds["processor", "release", "release"] = costs["release_ns"] + len(periods) * costs["release_per_bucket_ns"]
    for bus in model["buses"]:
        routines = [source["wcet_ns"] for source in bus.get("sources", [])] or [bus["wcet_ns"]]
        at_once = CAN_DEPTH if bus.get("arbitrated") else 1
        bounds[bus["name"], "routine", "interrupt"] = at_once * max(routines) + costs["interrupt_ns"]
    for period in periods:
        devices = [device for device in model["devices"] if device["period_ns"] == period]
        around = costs["job_ns"] + 2 * len(devices) * costs["stage_ns"]
        around += sum(d.get("update_extra_ns", 0) + d.get("handle_extra_ns", 0) for d in devices)
        around += sum(f["wcet_ns"] for f in model.get("flushes", []) if f["period_ns"] == period)
        bounds[str(period), "job", "flush"] = around


def judge(record, analysis, lowered=lambda key, bound: bound):
    """Verdict over all phases of a record.

    lowered: what becomes of a bound before it is held against: for the attack that must be found.
    """
    robot = audit.Robot(analysis["model"])
    chains = [(c["from"], c["to"]) for c in analysis["chains"]]
    verdict, seen = Verdict(), {}
    for phase in audit.read(record):
        measures = audit.Measures(phase, robot, chains)
        verdict.broken += measures.mistakes
        if phase.overruns:
            verdict.broken.append(f"{phase.overruns} overruns in phase {phase.header['phase']}")
        if phase.resets:
            verdict.broken.append(f"{phase.resets} resets in phase {phase.header['phase']}")
        for key, (largest, _) in measures.longest.values.items():
            seen[key] = max(seen.get(key, 0), largest)
    bounds = bounds_of(analysis)
    for key, largest in sorted(seen.items()):
        bound = bounds.get(key)
        if bound is None:
            continue
        bound = lowered(key, bound)
        if largest > bound * audit.PS:
            verdict.broken.append(f"{' '.join(key)}: {largest / audit.PS:.3f} ns seen, bound {bound} ns")
        if bound > 0:
            verdict.tightness.setdefault(key[2], []).append(largest / audit.PS / bound)
    for source, target in chains:
        keys = [(source, target, kind) for kind in KINDS]
        if all(key in seen and bounds[key] is not None for key in keys):
            verdict.chains.append((source, target, bounds[source, target, "decide"]))
        else:
            missing = [key[2] for key in keys if key not in seen or bounds[key] is None]
            verdict.unjudged.append(f"{source} -> {target}: {', '.join(missing)}")
    return verdict
