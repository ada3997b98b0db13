"""Holds the figures of a record against the bounds of `finemote analyze --format json`."""

import audit

KINDS = ("acquire", "decide", "wire", "end_to_end")


INJECTIONS = ("acquire", "decide", "wire", "response", "WCET")


def lowering(kind):
    """What becomes of bounds when those of this kind are 2 % too small; kind: None for none.

    A bound that is above what was ever seen by more than that cannot be found too small: what is lowered is the
    largest figure that the sweeps of sweeps.json have reached.
    """
    if kind is None:
        return lambda key, bound: bound
    name = {"WCET": "own"}.get(kind, kind)
    return lambda key, bound: bound * 98 // 100 if key[2] == name else bound


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
    return bounds


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
        bound = bounds[key]
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
