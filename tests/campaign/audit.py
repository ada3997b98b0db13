"""Reads the record of `finemote run --audit` and recomputes every figure from it.

Nothing of FineMote is used: the record says when what happened, and the figures follow from it by the definitions of
docs/reference/audit.md. Times are integers in picoseconds.
"""

import bisect
import gc
import json

PS = 1000

#: Events that no figure is made of, left out before they are parsed.
NOT_NEEDED = ('"what":"return"', '"what":"mask"', '"what":"unmask"')


class Phase:
    """One run: its first line, and its events in the order of time."""

    def __init__(self, header):
        self.header = header
        self.events = []
        self.ready = None
        self.resets = 0
        self.overruns = 0

    def add(self, event):
        self.events.append(event)
        if event["what"] == "ready":
            self.ready = event["t"]
        self.resets += event["what"] == "reset"
        self.overruns += event["what"] == "overrun"


def read(path, not_needed=NOT_NEEDED):
    """All phases of a record, without the events that are not needed."""
    phases = []
    with open(path, encoding="utf-8") as file:
        lines = [line for line in file.read().splitlines() if not any(what in line for what in not_needed)]
    gc.disable()  # nothing of this can be garbage
    try:
        events = json.loads(f"[{','.join(lines)}]")  # three times as fast as line by line
    finally:
        gc.enable()
    for event in events:
        if event["what"] == "robot":
            phases.append(Phase(event))
        else:
            phases[-1].add(event)
    return phases


class Runs:
    """The completed runs of one stage, in the order of time."""

    def __init__(self):
        self.begins, self.ends, self.own = [], [], []

    def last_ended_by(self, t):
        """Index of the last run that ended at `t` or before; None where there is none."""
        index = bisect.bisect_right(self.ends, t) - 1
        return index if index >= 0 else None


class Frame:
    """What runs at one level of preemption: an exception, or the idle loop."""

    def __init__(self, exception=None):
        self.exception = exception
        self.own = 0
        self.stages = 0  # of `own`, in stages
        self.open = {}  # by stage: when it began, and `own` then


class Execution:
    """Runs of every stage by its number, and the longest own times of exceptions.

    An exception's time counts from the begin of stacking to the end of unstacking and belongs to it alone; a stage's
    from its begin to its end, without what came in between.
    """

    def __init__(self, phase):
        self.stages = {k: Runs() for k in range(len(phase.header["stages"]))}
        self.exceptions = {}  # longest own time, by exception
        self.around = {}  # the same without the stages it ran
        self.frames = [Frame()]
        last = None
        for event in phase.events:
            if event["what"] not in ("enter", "tail", "resume", "begin", "end", "reset"):
                continue
            if last is not None:
                self.frames[-1].own += event["t"] - last
            last = event["t"]
            self.take(event)

    def take(self, event):
        what, top = event["what"], self.frames[-1]
        if what == "reset":
            self.frames = [Frame()]
        elif what == "enter":
            self.frames.append(Frame(event["exception"]))
        elif what == "tail":
            self.leave()
            self.frames.append(Frame(event["exception"]))
        elif what == "resume":
            self.leave()
        elif what == "begin":
            top.open[event["stage"]] = (event["t"], top.own)
        elif event["stage"] in top.open:
            begin, own = top.open.pop(event["stage"])
            runs = self.stages[event["stage"]]
            runs.begins.append(begin)
            runs.ends.append(event["t"])
            runs.own.append(top.own - own)
            top.stages += top.own - own

    def leave(self):
        if len(self.frames) < 2:
            return
        frame = self.frames.pop()
        number = frame.exception
        self.exceptions[number] = max(self.exceptions.get(number, 0), frame.own)
        self.around[number] = max(self.around.get(number, 0), frame.own - frame.stages)


class Robot:
    """What analyze's document says of the structure: parents and readers."""

    def __init__(self, model):
        self.parent = {d["name"]: d["parent"] for d in model["devices"]}
        self.feeders = {name: [] for name in self.parent}
        for device in model["devices"]:
            self.feeders[device["name"]] += device.get("reads", [])
            if device["parent"]:
                self.feeders[device["parent"]].append(device["name"])
        self.wcet = {d["name"]: (d["update_wcet_ns"], d["handle_wcet_ns"]) for d in model["devices"]}

    def to_root(self, name):
        way = [name]
        while self.parent[way[-1]]:
            way.append(self.parent[way[-1]])
        return way

    def feeders_with_data_of(self, source, target):
        """Of each device whose updates read those of others: the others that data of the source come over on their way
        to the root of `target`'s tree. Where both are in one tree, that is its way up alone. None: no data come there."""
        root, up = self.to_root(target)[-1], self.to_root(source)
        if up[-1] == root:
            return {reader: [read] for read, reader in zip(up, up[1:])}
        found = {}

        def reach(device):
            if device != source and device not in found:
                found[device] = [feeder for feeder in self.feeders[device] if reach(feeder)]
            return device == source or bool(found[device])

        return found if reach(root) else None


class Origins:
    """From the runs of a chain's stages to the updates of its source, the oldest that any of its ways gives."""

    def __init__(self, stages, number, robot, source, target):
        self.stages, self.number, self.source = stages, number, source
        self.handles = robot.to_root(target)
        self.feeders = robot.feeders_with_data_of(source, target)
        self.known = {}

    def latest(self, device, is_handle, time):
        """The last run of a stage that ended by then: its number and its begin; None: none yet."""
        runs = self.stages[self.number[device, is_handle]]
        index = runs.last_ended_by(time)
        return None if index is None else (index, runs.begins[index])

    def of_command(self, begin):
        """The number of the update that data of a handle() which began at `begin` came from; None: none yet."""
        if self.feeders is None:
            return None
        for device in self.handles[1:]:
            run = self.latest(device, True, begin)
            if run is None:
                return None
            begin = run[1]
        return self.of_update(self.handles[-1], begin)

    def of_update(self, device, time):
        run = self.latest(device, False, time)
        if run is None or device == self.source:
            return run and run[0]
        if (device, run[0]) not in self.known:
            origins = [self.of_update(feeder, run[1]) for feeder in self.feeders[device]]
            self.known[device, run[0]] = None if None in origins else min(origins)
        return self.known[device, run[0]]


def samples_of(phase):
    """When each sample was taken, by part and number."""
    taken = {}
    for event in phase.events:
        if event["what"] == "sample":
            taken[event["part"], event["channel"], event["n"]] = event["from"]
    return taken


def used_of(phase, samples):
    """What each update() took, by device: lists of times, and of (oldest sample of all channels, claimed origin)."""
    used = {}
    for event in phase.events:
        if event["what"] == "used":
            times, what = used.setdefault(event["device"], ([], []))
            taken = samples.get((event["device"], event.get("channel", 0), event["n"]))
            if times and times[-1] == event["t"]:
                older = None if taken is None or what[-1][0] is None else min(taken, what[-1][0])
                what[-1] = (older, event.get("claimed"))
            else:
                times.append(event["t"])
                what.append((taken, event.get("claimed")))
    return used


def outputs_of(phase):
    """When the command of a job reached the world first, by device and job."""
    reached = {}
    for event in phase.events:
        if event["what"] == "output" and event.get("job") is not None:
            reached.setdefault((event["device"], event["job"]), event["t"])
    return reached


def overtaken_in(phase):
    """When an output showed that the command a driver was given in a job would not come any more, by device and job."""
    overtaken = {}
    for event in phase.events:
        if event["what"] == "superseded" and event["sent"]:
            overtaken.setdefault((event["device"], event["job"]), event["t"])
    return overtaken


class Longest:
    """The largest value of each figure, and how many there were."""

    def __init__(self):
        self.values = {}

    def add(self, key, value):
        largest, count = self.values.get(key, (value, 0))
        self.values[key] = (max(largest, value), count + 1)


class Measures:
    """All figures of one phase."""

    def __init__(self, phase, robot, chains):
        self.phase, self.robot = phase, robot
        self.execution = Execution(phase)
        self.stages = self.execution.stages
        self.number = {(s["device"], s["stage"] == "handle"): k for k, s in enumerate(phase.header["stages"])}
        self.used, self.reached = used_of(phase, samples_of(phase)), outputs_of(phase)
        self.overtaken = overtaken_in(phase)
        self.longest = Longest()
        self.false_claims = []  # (device, in words)
        for source, target in chains:
            self.measure_chain(source, target)
        self.measure_responses()
        self.measure_own_times()
        self.check_claims()

    def sample_of(self, device, update):
        """When the sample behind a run of update() was taken, and when the firmware says so; None where nobody knows."""
        if device not in self.used:
            return None, None
        runs = self.stages[self.number[device, False]]
        times, what = self.used[device]
        index = bisect.bisect_right(times, runs.ends[update]) - 1
        return what[index] if index >= 0 and times[index] >= runs.begins[update] else (None, None)

    def measure_chain(self, source, target):
        origins = Origins(self.stages, self.number, self.robot, source, target)
        updates = self.stages[self.number[source, False]]
        handles = self.stages[self.number[target, True]]
        ready = self.phase.ready
        for job, (begin, end) in enumerate(zip(handles.begins, handles.ends)):
            run = origins.of_command(begin)
            if run is None:
                continue
            start = updates.begins[run]
            if start < ready:
                continue
            (taken, claimed), reached = self.sample_of(source, run), self.reached.get((target, job))
            self.longest.add((source, target, "decide"), end - start)
            if taken is not None:
                self.longest.add((source, target, "acquire"), start - taken)
            if taken is not None and claimed is not None:
                self.longest.add((source, target, "claim"), start - claimed)
            waited_to = reached if reached is not None else self.overtaken.get((target, job))
            if waited_to is not None:
                self.longest.add((source, target, "wire"), waited_to - end)
            if taken is not None and reached is not None:
                self.longest.add((source, target, "end_to_end"), reached - taken)

    def measure_responses(self):
        """From the release of a job, the last one before it began, to the end of a stage."""
        releases = [e["t"] for e in self.phase.events if e["what"] == "due" and e["exception"] == 15]
        nominal = self.phase.header["nominal_hz"]
        scale = nominal / self.phase.header["clock_hz"]
        for k, stage in enumerate(self.phase.header["stages"]):
            period = stage["period_ns"] * PS * scale
            runs = self.stages[k]
            for begin, end in zip(runs.begins, runs.ends):
                if begin < self.phase.ready:
                    continue
                release = int(begin // period * period)
                index = bisect.bisect_right(releases, release + PS * 1000) - 1
                if index >= 0 and abs(releases[index] - release) <= PS * 1000:
                    release = releases[index]
                self.longest.add((stage["device"], stage["stage"], "response"), end - release)

    def measure_own_times(self):
        """On the board's clock: execution times are counts of its cycles."""
        scale = self.phase.header["clock_hz"] / self.phase.header["nominal_hz"]
        for k, stage in enumerate(self.phase.header["stages"]):
            for own in self.stages[k].own:
                self.longest.add((stage["device"], stage["stage"], "own"), own * scale)

        for number, meaning in self.phase.header["exceptions"].items():
            if int(number) not in self.execution.exceptions:
                continue
            own, around = self.execution.exceptions[int(number)], self.execution.around[int(number)]
            if meaning["kind"] == "release":
                self.longest.add(("processor", "release", "release"), own * scale)
            elif meaning["kind"] == "bus":
                self.longest.add((meaning["bus"], "routine", "interrupt"), own * scale)
            else:
                self.longest.add((str(meaning["period_ns"]), "job", "flush"), around * scale)

    def check_claims(self):
        """No device claims data fresher than they are, by more than a microsecond."""
        for device, (times, what) in self.used.items():
            for t, (taken, claimed) in zip(times, what):
                if t < self.phase.ready or taken is None or claimed is None:
                    continue
                if claimed > taken + PS * 1000:
                    self.false_claims.append((device, f"{device} claims {claimed} for a sample taken at {taken}"))
