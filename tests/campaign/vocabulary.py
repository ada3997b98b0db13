"""What can happen to a robot, in pieces that are drawn, changed a little, and put together to scenarios."""

import typing

import faults
import lines
import stimuli
import workshop

#: Of a scenario: what happens in one of them is drawn, kept and changed together.
SLOT_NS = 20_000_000
MOST_GENES = 6  # of a slot
MOST_LASTING_NS = 60_000_000

#: Motors listen to the identifiers from here on.
FIRST_REPORT = 0x201

#: Of the converter that the battery of the board hangs at.
BATTERY_INPUT = 8


class Gene(typing.NamedTuple):
    """What one maker made: an event without a time, or bytes on a line; how long it lasts where it has an end."""

    at_ns: int  # from the begin of its slot
    maker: int
    what: object
    lasts_ns: int


class Event:
    """Makes events of one kind; `make` is given a random.Random."""

    def __init__(self, make):
        self.make = make

    def draw(self, draw):
        return self.make(draw)

    def mutated(self, what, draw):
        """Most of it is drawn anew, the rest stays."""
        return {**what, **{key: value for key, value in self.make(draw).items() if draw.random() < 0.6 or key == "do"}}

    def events(self, what, at_ns, lasts_ns):
        yield {"t_ns": at_ns, **what}
        if what["do"] in faults.HAVE_AN_END:
            yield {"t_ns": at_ns + lasts_ns, **what, "on": False}
        if what["do"] == "hold_sda" and "clocks" not in what:
            yield {"t_ns": at_ns + lasts_ns, "port": what["port"], "do": "release_sda"}


class Bytes:
    """Makes bytes on a serial line."""

    def __init__(self, port, line):
        self.port, self.line = port, line

    def draw(self, draw):
        return self.line.draw(draw)

    def mutated(self, what, draw):
        return self.line.mutated(what, draw)

    def events(self, what, at_ns, lasts_ns):
        return lines.as_events(self.port, at_ns, what)


# ---- events of a robot


def wild_pose(draw):
    angles = {angle: draw.choice((0, 90, -90, 180, draw.uniform(-180, 180))) for angle in ("roll", "pitch", "yaw")}
    return {"do": "move", **angles}


def wild_motion(draw):
    return {**wild_pose(draw), "rate": [draw.choice((0, draw.uniform(-2000, 2000))) for _ in range(3)],
            "acceleration": [draw.choice((0, draw.uniform(-150, 150))) for _ in range(3)]}


def wild_hands(draw):
    """Sticks at their ends more often than in between."""
    names = ("right_x", "right_y", "left_x", "left_y", "wheel")
    sticks = {stick: draw.choice((-1, 0, 1, draw.uniform(-1, 1))) for stick in names}
    switches = {switch: draw.choice(("up", "middle", "down")) for switch in ("left_switch", "right_switch")}
    return {"do": "move", **sticks, **switches, "keys": draw.randrange(65536)}


def field(draw):
    return {**wild_pose(draw), "field": [draw.choice((0, 1e-9, draw.uniform(-1e-3, 1e-3))) for _ in range(3)]}


#: Beyond what a campaign moves, by the type of a device.
WILD = {
    "h30_imu": wild_motion, "bmi088": wild_motion, "ist8310": field, "dr16": wild_hands, "sbus": wild_hands,
    **dict.fromkeys(workshop.MOTORS, lambda draw: {"do": "disturb", "torque": draw.uniform(-20, 20)}),
    "ms5837": lambda draw: {"do": "move", "pressure": draw.choice((0, 101_325, draw.uniform(0, 3_000_000)))},
}


def of_parts(outline):
    for name, kind in outline.types.items():
        for moves in (stimuli.MOVES, WILD):
            if kind in moves:
                yield lambda draw, name=name, make=moves[kind]: {"part": name, **make(draw)}
        if kind == "ms5837":
            yield lambda draw, name=name: {"part": name, "do": "damage", "bits": draw.randint(1, 65535)}


def of_ports(outline):
    for bus, (kind, port) in outline.buses.items():
        for what in faults.on_bus(outline, bus):
            yield lambda draw, what=what: what
        if kind == "can":
            yield lambda draw, port=port: {"port": port, "do": "flood", "identifier": FIRST_REPORT + draw.randrange(11),
                                           "frames": draw.randint(1, 20), "every_ns": draw.choice((1_000, 130_000, 250_000))}
            yield lambda draw, port=port: {"port": port, "do": "disturb", "frames": draw.randint(1, 60)}
        if kind == "i2c":
            yield lambda draw, port=port: {"port": port, "do": "hold_sda", **draw.choice(({}, {"clocks": draw.randint(1, 9)}))}


def refusals(outline):
    """Parts at an I2C bus itself that do not answer for a while."""
    for name, stated in outline.address_of.items():
        kind, port = outline.buses.get(outline.bus_of[name], (None, None))
        if kind == "i2c":
            address = int(stated or "0x0e", 0)  # one type has one if it names none
            yield lambda draw, port=port, address=address: {"port": port, "do": "nack", "address": address,
                                                            "times": draw.randint(1, 4)}


def of_pins(outline):
    kinds = set(outline.types.values())
    if "key" in kinds:
        yield lambda draw: {"pin": "PA0", "do": draw.choice(("low", "high", "release"))}
    if "battery" in kinds:
        yield lambda draw: {"port": "adc3", "do": "silent"}
        yield lambda draw: {"port": "adc3", "do": "volts", "input": BATTERY_INPUT,
                            "volts": draw.choice((0, draw.uniform(0, 3.3)))}


def serial_lines(outline):
    """Type of the device at each serial port."""
    for name, device_type in outline.types.items():
        for bus in (outline.bus_of[name], *outline.uses_of[name]):
            kind, port = outline.buses.get(bus, (None, None))
            if kind == "uart":
                yield port, device_type


class Vocabulary:
    """All that can happen to a robot."""

    def __init__(self, outline, layout):
        """layout: of what comes over a host_link, else None."""
        makes = (*of_parts(outline), *of_ports(outline), *of_pins(outline), *refusals(outline))
        self.makers = [Event(make) for make in makes]
        speech = [Bytes(port, lines.Line(kind, layout)) for port, kind in serial_lines(outline)]
        self.weights = [1] * len(self.makers) + [len(self.makers) + 1] * len(speech)  # bytes are half of what happens, or more
        self.makers += speech

    def gene(self, draw):
        maker = draw.choices(range(len(self.makers)), self.weights)[0]
        lasts_ns = draw.randint(1_000_000, MOST_LASTING_NS)
        return Gene(draw.randrange(SLOT_NS), maker, self.makers[maker].draw(draw), lasts_ns)

    def slot(self, draw):
        """Genes of a slot, drawn; none where nothing can happen to the robot."""
        return tuple(self.gene(draw) for _ in range(draw.randint(0, 3))) if self.makers else ()

    def mutated(self, slot, draw):
        """The slot with one or two changes."""
        for _ in range(draw.randint(1, 2)):
            slot = self._once_mutated(list(slot), draw)
        return slot

    def _once_mutated(self, genes, draw):
        if not genes or len(genes) < MOST_GENES and draw.random() < 0.2:
            return (*genes, self.gene(draw)) if self.makers else ()
        place = draw.randrange(len(genes))
        gene = genes[place]
        if draw.random() < 0.15:
            del genes[place]
        elif draw.random() < 0.3:
            at_ns = draw.choice((draw.randrange(SLOT_NS), gene.at_ns + draw.randint(-1_000_000, 1_000_000)))
            genes[place] = gene._replace(at_ns=min(max(at_ns, 0), SLOT_NS - 1))
        else:
            genes[place] = gene._replace(what=self.makers[gene.maker].mutated(gene.what, draw))
        return tuple(genes)

    @staticmethod
    def crossed(one, other, draw):
        """Some of what happens in either."""
        genes = [gene for gene in (*one, *other) if draw.random() < 0.6]
        return tuple(genes[:MOST_GENES])

    def scenario(self, slots):
        events = [event for number, slot in enumerate(slots) for gene in slot
                  for event in self.makers[gene.maker].events(gene.what, number * SLOT_NS + gene.at_ns, gene.lasts_ns)]
        return {"schema": stimuli.SCHEMA, "events": sorted(events, key=lambda event: event["t_ns"])}
