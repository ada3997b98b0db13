"""Everything that can go wrong on a bus of a robot, one fault after the other."""

import workshop

FIRST_NS, EVERY_NS = 150_000_000, 30_000_000
LASTS_NS = 15_000_000  # of faults that have to be ended

#: By the type of a bus, at its port.
OF_PORTS = {
    "uart": ({"do": "noise", "bytes": 20}, {"do": "silent"}, {"do": "dma_error"}),
    "i2c": ({"do": "disturb", "starts": 3}, {"do": "lose", "starts": 3}, {"do": "hold_sda", "clocks": 5}),
    "can": ({"do": "disturb", "frames": 5}, {"do": "silent"},
            {"do": "flood", "identifier": 1, "frames": 40, "every_ns": 250_000},
            {"do": "flood", "identifier": 0x7FF, "frames": 40, "every_ns": 250_000}),
    "spi": ({"do": "dma_error"},),
}

_SILENT, _DAMAGE, _CYCLE = {"do": "silent"}, {"do": "damage", "frames": 5}, {"do": "power_cycle"}

#: By the type of a device or the model of an expander, at its part.
OF_PARTS = {
    "h30_imu": (_SILENT, _DAMAGE), "dr16": (_SILENT, _DAMAGE), "sbus": (_SILENT, _DAMAGE, {"do": "failsafe"}),
    "ms5837": (_SILENT,), "ist8310": (_SILENT, _CYCLE), "bmi088": (_SILENT, {"do": "cut"}, _CYCLE),
    **dict.fromkeys(workshop.MOTORS, (_SILENT, _DAMAGE)),
    "tca9548a": (_CYCLE,), "pca9685": (_CYCLE,),
}

HAVE_AN_END = ("silent", "failsafe", "cut")


def on_bus(outline, bus):
    """Events without times: faults of the bus `bus` and of all parts on it."""
    kind, port = outline.buses[bus]
    yield from ({"port": port, **what} for what in OF_PORTS.get(kind, ()))
    for name, model in {**outline.types, **outline.models}.items():
        if outline.line_of(name) == bus:
            yield from ({"part": name, **what} for what in OF_PARTS.get(model, ()))


def of_buses(outline):
    """For each bus that something can go wrong on: its name, and all of that as events, one fault after the other."""
    for bus in outline.buses:
        events = []
        for number, what in enumerate(on_bus(outline, bus)):
            at = FIRST_NS + number * EVERY_NS
            events.append({"t_ns": at, **what})
            if what["do"] in HAVE_AN_END:
                events.append({"t_ns": at + LASTS_NS, **what, "on": False})
        if events:
            yield bus, events


def length_ns(events):
    """Until everything has recovered from the last one."""
    return max((event["t_ns"] for event in events), default=FIRST_NS) + 5 * EVERY_NS
