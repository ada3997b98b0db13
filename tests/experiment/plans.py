"""What happens to the robot in each experiment: scenarios of the emulated board, and random phases of its parts."""

import copy
import random

import measure

MS = 1_000_000
#: How far a sensor's clock may be off, as `finemote run --phases` draws it.
CLOCK_PPM = 8000
#: Before it the robot is still being switched on.
SETTLED_NS = 600 * MS


def send(at, text):
    return {"t_ns": at, "part": "rov.host", "do": "send", "text": text}


def dive(rng):
    """Depth and heading are held; the vehicle is under way to its depth while it is measured."""
    return [send(300 * MS + rng.randrange(10 * MS), "ON"), send(350 * MS + rng.randrange(10 * MS), "ACL:ON"),
            send(400 * MS + rng.randrange(10 * MS), "H:800")]


def traffic(rng, end):
    """The operator's program: 30 orders a second, and reports of the attitude."""
    events = [send(450 * MS + rng.randrange(10 * MS), "RPY:ON")]
    at = 500 * MS + rng.randrange(33 * MS)
    while at < end:
        events.append(send(at, rng.choice(("W", "S", "Q", "E", "H:750", "H:850", "Z"))))
        at += 33_333_333
    return events


def timing_job(base, seed, number, code, loaded, periods):
    """One of several runs that differ in when sensors sample and orders come. `periods` of 10 ms are measured. Code in
    flash never meets the accelerator."""
    rng = random.Random(f"{seed}/{number}")
    end = SETTLED_NS + (periods + 3) * 10 * MS
    job = copy.deepcopy(base)
    for part in job["parts"]["parts"]:
        if part["type"] == "h30_imu":
            part["phase_ns"] = rng.randrange(5 * MS)
            part["clock_ppm"] = rng.uniform(-CLOCK_PPM, CLOCK_PPM)
    events = dive(rng) + (traffic(rng, end) if loaded else [])
    events.sort(key=lambda event: event["t_ns"])
    return {**job, "flash": "miss" if code == "flash" else "hit", "audit": [], "works": measure.WORKS, "duration_ns": 0, "last_event_ns": end,
            "events": {"schema": "finemote.scenario/1", "events": events}}


def scenario_job(base, events, end):
    """A run that is only looked at from outside: no bytes are followed."""
    return {**copy.deepcopy(base), "tags": False, "await": [], "duration_ns": 0, "last_event_ns": end,
            "events": {"schema": "finemote.scenario/1", "events": sorted(events, key=lambda event: event["t_ns"])}}


STEP_DEPTH_NS, STEP_YAW_NS, PUSH_NS, MOTION_END_NS = 1000 * MS, 1600 * MS, 9000 * MS, 14000 * MS
#: What is asked for, and where the body's origin is then: the sensors sit below it.
ORDERED_DEPTH_M, DEPTH_M, YAW_DEG = 0.8, 0.75, 45


def motion():
    """A step in depth, a step in heading, a push to the side and up."""
    return [send(300 * MS, "ON"), send(STEP_DEPTH_NS, f"H:{ORDERED_DEPTH_M * 1000:.0f}"), send(1300 * MS, "ACL:ON"),
            send(STEP_YAW_NS, f"ANG:{YAW_DEG}"),
            {"t_ns": PUSH_NS, "part": "base_link", "do": "disturb", "force": [0, 0, 6], "moment": [0.1, 0, 0.3]},
            {"t_ns": PUSH_NS + 500 * MS, "part": "base_link", "do": "disturb"}]


FAULT_NS, MENDED_NS, FAULT_END_NS = 1500 * MS, 3000 * MS, 4500 * MS


def underway(end=FAULT_END_NS):
    """The vehicle goes forward at its depth, as it is told every 200 ms until `end`."""
    events = [send(300 * MS, "ON"), send(500 * MS, "H:800"), send(600 * MS, "ACL:ON")]
    return events + [send(at, "W") for at in range(700 * MS, end, 200 * MS)]


def at_fault(**event):
    return {"t_ns": FAULT_NS, **event}


def at_end(**event):
    return {"t_ns": MENDED_NS, **event}


#: By name: what happens, and the events.
FAULTS = {
    "imu": ("the attitude sensor falls silent",
            underway() + [at_fault(part="imu", do="silent"), at_end(part="imu", do="silent", on=False)]),
    "bus": ("a part holds the data line of the I2C bus until it has seen seven clocks",
            underway() + [at_fault(port="i2c2", do="hold_sda", clocks=7)]),
    "bus_held": ("a part holds the data line whatever is done",
                 underway() + [at_fault(port="i2c2", do="hold_sda"), at_end(port="i2c2", do="release_sda")]),
    "tether": ("the last order was to go forward, and no more comes", underway(FAULT_NS)),
}
