"""Robots as lists of parts that can be left out one by one, so that a broken bound can be shown on the smallest robot that
breaks it.
"""

import pathlib
import re
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]

#: Types of the campaign's own, as a user would add them.
DEVICES = pathlib.Path(__file__).resolve().parent / "devices"


class Part:
    """A device with the buses it needs and, where it has some, its children."""

    def __init__(self, kind, name, attributes, period_us, body=(), children=()):
        self.kind, self.name, self.attributes = kind, name, dict(attributes)
        self.period_us = period_us
        self.body, self.children = list(body), list(children)

    def lines(self, indent):
        pad = "  " * indent
        attributes = "".join(f' {key}="{value}"' for key, value in self.attributes.items())
        head = f'{pad}<device name="{self.name}" type="{self.kind}" period="{self.period_us}us"{attributes}'
        inner = [f"{pad}  {line}" for line in self.body]
        for child in self.children:
            inner += child.lines(indent + 1)
        return [head + ">"] + inner + [f"{pad}</device>"] if inner else [head + "/>"]

    def walk(self):
        yield self
        for child in self.children:
            yield from child.walk()


class Robot:
    """Buses, expanders and trees; `load` scales the work of all loads.

    `pairs` are names of sensors and actuators between which chains are asked for, `share` is how much of the largest load
    it gets. All robots have one name: a folder that was compiled for one of them is good for the next.
    """

    def __init__(self, tick_us):
        self.tick_us = tick_us
        self.buses, self.expanders, self.trees, self.pairs = [], [], [], []
        self.load, self.share = 1.0, 1.0
        self.is_in_sram = False

    def roots(self):
        """List of the parts that no part holds."""
        return self.trees

    def text(self):
        lines = ['<robot name="robot"><link name="base"/>', '<finemote version="1">']
        place = '<param name="code">sram</param>' if self.is_in_sram else ""
        lines.append(f'  <board name="robomaster_type_c" tick="{self.tick_us}us">{place}</board>')
        parts = [line for tree in self.trees for line in tree.lines(1)]
        used = re.findall(r'bus="(\w+)"', "\n".join(parts))
        expanders = [line for line in self.expanders if re.search(r'name="(\w+)"', line)[1] in used]
        used += re.findall(r'bus="(\w+)"', "\n".join(expanders))
        lines += ["  " + line for name, line in self.buses if name in used]
        lines += ["  " + line for line in expanders]
        return "\n".join(lines + parts + ["</finemote></robot>", ""])


class Shipped:
    """A shipped example with other periods, and with loads beside it: the composites that need a mechanism."""

    def __init__(self, path, factor, loads):
        text = path.read_text(encoding="utf-8")
        text = re.sub(r"<wcet [^>]*/>|<require [^>]*/>", "", text)
        text = re.sub(r'period="(\d+)ms"', lambda m: f'period="{int(m[1]) * factor}ms"', text)
        text = re.sub(r'<robot name="[^"]*"', '<robot name="robot"', text, count=1)
        self.before, self.after = text.split("</finemote>")
        self.loads, self.pairs = loads, []
        self.load, self.share = 1.0, 1.0

    def roots(self):
        return self.loads

    def text(self):
        lines = [line for part in self.loads for line in part.lines(1)]
        return "\n".join([self.before] + lines + ["</finemote>" + self.after])


#: Work that takes the same time in every job, and another in each: jobs that end early lets others meet.
LOADS = ("sim_load", "restless")


def set_load(robot, load):
    """Gives every load its work: its shares of its period, times `load`."""
    robot.load = load
    for root in robot.roots():
        for part in root.walk():
            if part.kind in LOADS:
                update, handle = (int(share * load * part.period_us * 1000) for share in part.shares)
                part.body = [f'<param name="update">{update}ns</param>', f'<param name="handle">{handle}ns</param>']
                if part.kind == "restless":
                    part.body.append(f'<param name="seed">{part.seed}</param>')


def removable(robot):
    """Places of parts that can be left out, the last ones first: lists of siblings with an index."""

    def places(siblings):
        for index in reversed(range(len(siblings))):
            yield from places(siblings[index].children)
            yield siblings, index

    return list(places(robot.roots()))


class Outline:
    """What the text of a robot says of its devices and ports, as everybody else reads it too."""

    def __init__(self, text):
        root = xml.etree.ElementTree.fromstring(text)
        self.types = {d.get("name"): d.get("type") for d in root.iter("device")}
        self.bus_of = {d.get("name"): d.get("bus") for d in root.iter("device")}
        self.uses_of = {d.get("name"): [use.get("bus") for use in d.findall("use")] for d in root.iter("device")}
        self.address_of = {p.get("name"): p.get("address") for kind in ("device", "expander") for p in root.iter(kind)}
        self.buses = {b.get("name"): (b.get("type"), b.get("port")) for b in root.iter("bus")}
        self.models = {e.get("name"): e.get("model") for e in root.iter("expander")}
        for expander in root.iter("expander"):
            self.bus_of[expander.get("name")] = expander.get("bus")
            self.bus_of.update((c.get("name"), expander.get("name")) for c in expander.iter("channel"))

    def place_of(self, name):
        """What a device hangs at: the kind of its bus, or an expander's model."""
        bus = self.bus_of[name]
        return self.models.get(bus) or self.buses.get(bus, ("none",))[0]

    def line_of(self, name):
        """The bus that a device or an expander hangs at, directly or behind expanders; None: at none."""
        at = self.bus_of.get(name)
        while at is not None and at not in self.buses:
            at = self.bus_of.get(at)
        return at
