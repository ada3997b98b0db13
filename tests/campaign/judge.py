"""Holds the figures of records against the bounds of `finemote analyze --format json`."""

import audit
import inject

KINDS = ("acquire", "decide", "wire", "end_to_end")

#: Frames in a receive FIFO, and mailboxes: one run of a routine of bxCAN can serve as many. RM0090 32.7.
CAN_DEPTH = 3

#: Saving the registers of the floating-point unit, 17 cycles, which the preemption pays for (Cortex-M4 TRM 3.9.1): a record does not
#: say in which stage a routine came to it.
SAVE_NS = 102


def is_bounded(chain):
    return all(chain[kind + "_ns"] is not None for kind in KINDS)


def bounds_of(analysis):
    """All bounds in ns by what they bound; None where there is none."""
    bounds = {}
    for chain in analysis["chains"]:
        for kind in KINDS:
            bounds[chain["from"], chain["to"], kind] = chain[kind + "_ns"]
        bounds[chain["from"], chain["to"], "claim"] = chain["stamped_ns"]  # what commands are dropped by
    for device in analysis["target"]["devices"]:
        bounds[device["name"], "update", "response"] = device["r_plus_ns"]
        bounds[device["name"], "handle", "response"] = device["r_minus_ns"]
    for device in analysis["model"]["devices"]:
        for stage in ("update", "handle"):
            bounds[device["name"], stage, "own"] = device[stage + "_wcet_ns"] + SAVE_NS
    add_costs(analysis["model"], bounds)
    return bounds


def add_costs(model, bounds):
    """What the scheduler and the drivers may use around the stages."""
    costs = model["costs"]
    periods = {device["period_ns"] for device in model["devices"]}
    bounds["processor", "release", "release"] = costs["release_ns"] + len(periods) * costs["release_per_bucket_ns"]
    for bus in model["buses"]:
        at_once = CAN_DEPTH if bus.get("arbitrated") else 1
        routines = [at_once * bus["wcet_ns"]]
        if "sources" in bus:  # a request has as many frames in its figure
            routines = [s["wcet_ns"] * (1 if s["name"] == "request" else at_once) for s in bus["sources"]]
        if routines:  # what nobody interrupts for has none
            bounds[bus["name"], "routine", "interrupt"] = max(routines) + costs["interrupt_ns"]
    for period in periods:
        devices = [device for device in model["devices"] if device["period_ns"] == period]
        around = costs["job_ns"] + 2 * len(devices) * costs["stage_ns"]
        around += sum(d.get("update_extra_ns", 0) + d.get("handle_extra_ns", 0) for d in devices)
        around += sum(f["wcet_ns"] for f in model.get("flushes", []) if f["period_ns"] == period)
        bounds[str(period), "job", "flush"] = around


def devices_on(bus, model):
    """Names of the devices whose samples or commands go over a bus."""
    names = {d["name"] for d in model["devices"] if any(t["bus"] == bus for t in d.get("transfers", []))}
    return names.union(*(flush["devices"] for flush in model.get("flushes", []) if flush.get("bus") == bus))


#: Traffic that nobody declares, and execution times above those that bounds rest on.
FINDINGS = ("FM6015", "FM6006")


class Verdict:
    """What the runs of one robot showed.

    broken: what was above its bound, in words, and of which kinds it was. chains: those judged in every part, as
    (source, target). shares: by key, measured maximum / bound, and the bound [ns].
    """

    def __init__(self, mistakes):
        self.broken = list(mistakes)
        self.kinds = {"mistake"} if mistakes else set()
        self.chains, self.shares = [], {}

    def hold(self, key, largest, bound, lowered):
        if bound > 0:
            self.shares[key] = (largest / audit.PS / bound, bound)
        if largest > lowered * audit.PS:
            self.kinds.add(key[2])
            self.broken.append(f"{' '.join(key)}: {largest / audit.PS:.3f} ns seen, bound {lowered:.3f} ns")


class Judge:
    """Collects the figures of the runs of one robot."""

    def __init__(self, analysis, lowered=inject.nothing_lowered):
        """lowered: what becomes of a bound before it is held against; for the attack that must be found."""
        self.model, self.lowered = analysis["model"], lowered
        self.bounds = bounds_of(analysis)
        self.robot = audit.Robot(self.model)
        self.asked = list(dict.fromkeys((c["from"], c["to"]) for c in analysis["chains"]))
        self.seen, self.broken = {}, []

    def take(self, record, disturbed=None, is_recovering=False):
        """Adds all phases of a record. A bus `disturbed` by noise breaks the assumption bus-errors for acquire, wire and
        time stamps; where it is recovered, recovery is broken besides for what jobs do around their stages."""
        touched = devices_on(disturbed, self.model)
        for phase in audit.read(record):
            measures = audit.Measures(phase, self.robot, self.asked)
            self.broken += [words for device, words in measures.false_claims if device not in touched]
            for what, count in (("overruns", phase.overruns), ("resets", phase.resets)):
                if count:
                    self.broken.append(f"{count} {what} in phase {phase.header['phase']}")
            for key, (largest, _) in measures.longest.values.items():
                if not (is_left_out(key, touched) or is_recovering and key[2] == "flush"):
                    self.seen[key] = max(self.seen.get(key, 0), largest)

    def take_findings(self, said):
        """Adds what the tool itself finds of traffic, of which nothing is in the record, and of execution times."""
        self.broken += [line[line.index(": error") + 2:] for line in said.splitlines()
                        if any(f": error[{code}]" in line for code in FINDINGS)]

    def take_document(self, run):
        """Adds what the tool itself calls broken: of chains, too, that nobody asked for, and of time stamps."""
        judged = [(f"{c['from']} -> {c['to']} {kind}", c[kind]) for c in run["chains"] for kind in KINDS]
        judged += [(f"{one['device']} {name}", one) for name in ("responses", "jitter", "claims") for one in run[name]]
        judged += [(f"loop in {one['function']}", one) for one in run["loops"]]
        if run["order"]["mistake"]:
            self.broken.append(f"order: {run['order']['mistake']}")
        self.broken += [f"{name} is broken, says run" for name, one in judged if one["judged"] == "broken" and "assumption" not in one]

    def verdict(self):
        """Holds what all records showed against the bounds."""
        verdict = Verdict(self.broken)
        for key, largest in sorted(self.seen.items()):
            bound = self.bounds.get(key)
            if bound is not None:
                verdict.hold(key, largest, bound, self.lowered(key, bound))
        for source, target in self.asked:
            keys = [(source, target, kind) for kind in KINDS]
            if all(key in self.seen and self.bounds[key] is not None for key in keys):
                verdict.chains.append((source, target))
        return verdict


def is_left_out(key, touched):
    """Whether noise on the bus of these devices takes the ground from a bound."""
    source, target, kind = key
    begins, ends = source in touched, target in touched
    return {"acquire": begins, "claim": begins, "wire": ends, "end_to_end": begins or ends}.get(kind, False)
