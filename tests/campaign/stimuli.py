"""Draws what happens to the parts of a robot: what moves them, and noise on one of its buses."""

import random

import workshop

SCHEMA = "finemote.scenario/1"
LENGTH_NS = 300_000_000  # of a run
EVERY_NS = 20_000_000  # about, from one event to the next
SHARE_OF_NOISY = 0.25  # of the robots
BURSTS = 4  # of noise


def pose(draw):
    return {"do": "move", **{angle: draw.uniform(-30, 30) for angle in ("roll", "pitch", "yaw")}}


def sticks(draw):
    return {"do": "move", **{stick: draw.uniform(-1, 1) for stick in ("right_x", "right_y", "left_x", "left_y")}}


def push(draw):
    return {"do": "disturb", "torque": draw.uniform(-0.1, 0.1)}


def command(draw):
    return {"do": "command", "value": draw.uniform(-0.3, 0.3)}


#: What moves a part, by the type of its device.
MOVES = {
    **dict.fromkeys(("h30_imu", "bmi088", "ist8310"), pose),
    **dict.fromkeys(("dr16", "sbus"), sticks),
    **dict.fromkeys(workshop.MOTORS, push),
    "host_link": command,
    "ms5837": lambda draw: {"do": "move", "pressure": draw.uniform(105_000, 125_000)},
    "gauge": lambda draw: {"do": "set", "r0": draw.randrange(256), "r1": draw.randrange(256)},
}

#: What an operator types; a vehicle that was not told to begin leaves its outputs as they are.
ORDERS = {"finsrov": ("ON", "ACL:ON", "ACL:OF", "UP", "DN", "W", "S", "A", "D", "Q", "E", "Z", "H:500", "VA", "RPY:ON")}

#: Noise on a port, by the type of its bus.
NOISE = {
    "can": (lambda draw: {"do": "flood", "identifier": draw.choice((1, 0x100, 0x7FF)), "frames": 40, "every_ns": 500_000},
            lambda draw: {"do": "disturb", "frames": draw.randint(1, 3)}),
    "uart": (lambda draw: {"do": "noise", "bytes": draw.randint(1, 20)},),
}


def scenario_of(events, outline):
    """What of the events concerns parts and ports that the robot has."""
    ports = {port for _, port in outline.buses.values()}
    here = [event for event in events if event.get("part", "").split(".")[0] in {"", *outline.types}
            and event.get("port") in {None, *ports}]
    return {"schema": SCHEMA, "events": sorted(here, key=lambda event: event["t_ns"])}


def typed(outline, draw, length_ns):
    """Orders of people at a terminal, the first of all ones at once."""
    for name, kind in outline.types.items():
        for number, t in enumerate(range(0, length_ns if kind in ORDERS else 0, 2 * EVERY_NS)):
            text = ORDERS[kind][0] if number == 0 else draw.choice(ORDERS[kind])
            yield {"t_ns": t, "part": f"{name}.host", "do": "send", "text": text + "\r\n"}


def moves(outline, draw, length_ns=LENGTH_NS):
    """Events that leave every assumption as it is."""
    parts = [(name, MOVES[kind]) for name, kind in outline.types.items() if kind in MOVES]
    events = list(typed(outline, draw, length_ns))
    for t in range(0, length_ns, EVERY_NS):
        at = t + draw.randrange(EVERY_NS)
        if "key" in outline.types.values() and draw.random() < 0.3:
            events.append({"t_ns": at, "pin": "PA0", "do": draw.choice(("low", "release"))})
        elif parts:
            name, make = draw.choice(parts)
            events.append({"t_ns": at, "part": name, **make(draw)})
    return events


class Stimuli:
    """Events for one robot, and for some robots noise on the bus `disturbed`, else None."""

    def __init__(self, outline, seed, number):
        draw = random.Random(f"{seed}/{number}/stimuli")
        self.moves, self.bursts, self.disturbed = moves(outline, draw), [], None
        buses = [name for name, (kind, _) in outline.buses.items() if kind in NOISE]
        if buses and draw.random() < SHARE_OF_NOISY:
            self.disturbed = draw.choice(buses)
            kind, port = outline.buses[self.disturbed]
            make = draw.choice(NOISE[kind])
            self.bursts = [{"t_ns": draw.randrange(LENGTH_NS * 9 // 10), "port": port, **make(draw)} for _ in range(BURSTS)]

    def runs(self, outline):
        """Scenarios for the robot, or for what was left of it, each with the bus that has noise in it."""
        yield scenario_of(self.moves, outline), None
        if self.disturbed in outline.buses:
            yield scenario_of(self.moves + self.bursts, outline), self.disturbed
