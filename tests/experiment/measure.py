"""Figures of one run, from what the emulated board saw: marks in the code, exceptions, samples and outputs of parts.

Nothing here asks a firmware for the time, and nothing depends on which firmware it is but what Firmware.buckets says.
Times are picoseconds of true time since the first tick.
"""

import bisect
import statistics

#: Places of the devices in the order of `finemote tree`, and their stages.
IMU, SENSOR, THRUSTERS, ROV = 0, 1, tuple(range(5, 13)), 13
SENSOR_PART, IMU_PART, OUTPUT_PART = "baro_1", "imu", "pwm"
#: What decision and wire are measured of, by the names of the devices.
CHAINS = tuple((SENSOR_PART, f"thruster_{k + 1}") for k in range(len(THRUSTERS)))
#: Periods after which the public manner has read its pressures once.
TURN = 3
#: Halves of marks: runtime/include/finemote/mark.hpp, examples/finsrov/baseline/marks.hpp.
FLUSH, SPIN, IDLE = 0x20005, 0x28000, 0x28001
WORKS = [FLUSH, SPIN, IDLE]
#: Spare lines that the board file gives to buckets, as exceptions: of FSMC, SDIO and SPI3.
BUCKETS = {16 + 48, 16 + 49, 16 + 51}


def update(device):
    return 2 * device


def handle(device):
    return 2 * device + 1


class Runs:
    """All runs of a stage: the n-th counted from power-on."""

    def __init__(self):
        self.begins, self.ends = [], []

    def last_ended(self, before):
        """Number of the last run that had ended by then; None: there is none."""
        at = bisect.bisect_right(self.ends, before) - 1
        return at if at >= 0 else None


def events_of(record):
    """(ps since zero, what, number) for each: emulator/program/audit.hpp says how they are written."""
    names, numbers = record["audit"]["names"], record["audit"]["events"]
    return [(at, names[what], number) for at, what, number in zip(*[iter(numbers)] * 3)]


def runs_of(events):
    runs = {}
    for at, what, number in events:
        if what == "begin":
            runs.setdefault(number, Runs()).begins.append(at)
        elif what == "end":
            runs.setdefault(number, Runs()).ends.append(at)
    return runs


class Period:
    """One turn of the control law and of what follows from it."""

    def __init__(self, begin):
        self.begin = begin  # of the vehicle's handle()
        self.thrusters = []  # (begin, end, stage, number of the run)
        self.last_end = None  # of the last thruster's handle, or of the call that hands its pulse to the bus
        self.last_output = None  # when the last pulse of this period was set


def periods_of(runs, events, outputs):
    """All complete periods, in order."""
    begins = runs[handle(ROV)].begins
    periods = [Period(begin) for begin in begins]

    def of(at):
        number = bisect.bisect_right(begins, at) - 1
        return periods[number] if number >= 0 else None

    for device in THRUSTERS:
        stage = handle(device)
        for number, (begin, end) in enumerate(zip(runs[stage].begins, runs[stage].ends)):
            period = of(begin)
            if period is None:
                continue
            period.thrusters.append((begin, end, stage, number))
            for at in outputs.get((stage, number), ()):
                period.last_output = max(at, period.last_output or at)
    flushes = [at for at, what, number in events if what == "done" and number == FLUSH]
    for period in periods:
        period.last_end = max((end for _, end, _, _ in period.thrusters), default=None)
    for at in flushes:
        period = of(at)
        if period is not None and period.last_end is not None:
            period.last_end = max(period.last_end, at)
    return [p for p in periods[:-1] if len(p.thrusters) == len(THRUSTERS)]


def decisions(runs, periods):
    """From the begin of the code that takes the sensor's data to the last thruster's end, where it is of the same turn."""
    begins, found = runs[update(SENSOR)].begins, []
    for before, period in zip(periods, periods[1:]):
        first = min(begin for begin, _, _, _ in period.thrusters)
        at = bisect.bisect_right(begins, first) - 1
        if at >= 0 and begins[at] > before.last_end:
            found.append((begins[at], period))
    return found


def sample_times(record, part):
    return {p["n"]: p["from_ps"] for p in record["parts"] if p["part"] == part and not p["output"] and p["channel"] == 0}


def wires(record, runs, periods, device, part):
    """From the sample that a period's commands are made of to the last of its pulses: back from the vehicle's handle() to
    its last update(), to the sensor's last one before that, and to the sample whose bytes that took."""
    taken = {at: n for at, stage, name, channel, n, _ in record["uses"] if stage == update(device) and name == part}
    sampled, found = sample_times(record, part), []
    for period in periods:
        own = runs[update(ROV)].last_ended(period.begin)
        if own is None or period.last_output is None:
            continue
        source = runs[update(device)].last_ended(runs[update(ROV)].begins[own])
        if source is None:
            continue
        n = taken.get(runs[update(device)].ends[source])
        if n is not None:
            found.append(period.last_output - sampled[n])
    return found


def shares(events, begin, end, buckets):
    """Of the processor's time: control, interrupts, looking at peripherals, nothing to do."""
    spent = {"control": 0, "interrupt": 0, "spin": 0, "idle": 0}
    active, spins, idles, last = [], False, buckets, begin

    def kind():
        if active and not (buckets and active[-1] in BUCKETS):
            return "interrupt"
        if active:
            return "control"
        return "idle" if idles else "spin" if spins else "control"

    for at, what, number in events:
        if at > end:
            break
        if at > last:
            spent[kind()] += at - last
            last = at
        if what == "enter":
            active.append(number)
        elif what == "tail" and active:
            active[-1] = number
        elif what == "resume" and active:
            active.pop()
        elif what in ("work", "done") and number == SPIN:
            spins = what == "work"
        elif what in ("work", "done") and number == IDLE:
            idles = what == "work"
    spent[kind()] += end - last
    return spent


def turns_of(ends):
    """Distances over whole turns of the public manner, which has done the same work at both ends of each."""
    return [after - before for before, after in zip(ends, ends[TURN:])]


class Figures:
    """Of all runs of one firmware."""

    def __init__(self):
        self.decision, self.wire, self.wire_imu, self.to_wire, self.interval, self.turn = [], [], [], [], [], []
        self.spent = {}

    def add(self, record, firmware, from_ps):
        events = events_of(record)
        runs = runs_of(events)
        outputs = {}
        for part in record["parts"]:
            if part["output"] and part["part"] == OUTPUT_PART and part["stage"] is not None:
                outputs.setdefault((part["stage"], part["n"]), []).append(part["at_ps"])
        periods = [p for p in periods_of(runs, events, outputs) if p.begin >= from_ps]
        for begin, period in decisions(runs, periods):
            self.decision.append(period.last_end - begin)
            if period.last_output is not None:
                self.to_wire.append(period.last_output - begin)
        self.wire += wires(record, runs, periods, SENSOR, SENSOR_PART)
        self.wire_imu += wires(record, runs, periods, IMU, IMU_PART)
        ends = [p.last_end for p in periods]
        self.interval += [after - before for before, after in zip(ends, ends[1:])]
        self.turn += turns_of(ends)
        for kind, time in shares(events, periods[0].begin, periods[-1].begin, firmware.buckets).items():
            self.spent[kind] = self.spent.get(kind, 0) + time

    def document(self):
        whole = sum(self.spent.values())
        return {"decision": summary(self.decision), "wire": summary(self.wire), "wire_imu": summary(self.wire_imu),
                "take_to_pulse": summary(self.to_wire), "jitter_sd_ns": nanoseconds(statistics.pstdev(self.interval)),
                "jitter_pp_ns": nanoseconds(max(self.interval) - min(self.interval)),
                "turn_sd_ns": nanoseconds(statistics.pstdev(self.turn)) if self.turn else None,
                "cpu": {kind: round(time / whole, 5) for kind, time in self.spent.items()}}


def nanoseconds(ps):
    return round(ps / 1000, 1)


def summary(values):
    if not values:
        return {"n": 0, "mean_ns": None, "sd_ns": None, "min_ns": None, "max_ns": None}
    return {"n": len(values), "mean_ns": nanoseconds(statistics.fmean(values)), "sd_ns": nanoseconds(statistics.pstdev(values)),
            "min_ns": nanoseconds(min(values)), "max_ns": nanoseconds(max(values))}
