"""Makes bounds too small on purpose: an attack has to find that.

A true bound may lie above anything that a board ever shows, and two percent less of it would be as true. Too small is what
lies two percent below the largest share of its bound that figures of a class have reached in a sweep of other robots.
"""

import json
import pathlib

#: Kind of the figures whose bounds are lowered, by what it is called.
KINDS = {"release": "release", "flush": "flush", "interrupt": "interrupt", "acquire": "acquire", "wire": "wire", "WCET": "own"}

#: Shares by kind and class.
REACHED = pathlib.Path(__file__).parent / "reached.json"

TOO_SMALL = 0.98


class Classes:
    """Classes of the figures of one robot: what comes about in the same way reaches about the same share of its bound."""

    def __init__(self, outline, model):
        self.outline = outline
        self.in_bucket = {}  # what the devices of a period hang at
        for device in model["devices"]:
            self.in_bucket.setdefault(str(device["period_ns"]), set()).add(outline.place_of(device["name"]))

    def of(self, key):
        first, second, kind = key
        types = self.outline.types
        if kind == "acquire":
            return types[first]
        if kind == "wire":
            return f"{types[second]} at {self.outline.place_of(second)}"
        if kind == "own":
            return f"{types[first]} {second}"
        if kind == "interrupt":
            return self.outline.buses[first][0]
        if kind == "flush":
            return " ".join(sorted(self.in_bucket[first]))
        return f"{len(self.in_bucket)} periods"


def nothing_lowered(key, bound):
    return bound


def lowering(kind, classes):
    """What becomes of bounds where those of one kind (of KINDS) are too small; None: of none."""
    return nothing_lowered if kind is None else lowered_to(read()[KINDS[kind]], KINDS[kind], classes)


def lowered_to(reached, kind, classes):
    """The same, with the largest shares of the kind by class."""

    def lowered(key, bound):
        share = reached.get(classes.of(key)) if key[2] == kind else None
        return bound if share is None else bound * TOO_SMALL * share

    return lowered


def largest_by_class(shares, classes):
    """The largest shares of one robot by kind and class, of all kinds that can be lowered."""
    largest = {}
    for key, (share, _) in shares.items():
        if key[2] in KINDS.values():
            name = (key[2], classes.of(key))
            largest[name] = max(largest.get(name, 0), round(share, 4))
    return largest


def read():
    return json.loads(REACHED.read_text(encoding="utf-8"))


def write(all_largest):
    """Writes down the largest of many robots."""
    reached = {kind: {} for kind in KINDS.values()}
    for largest in all_largest:
        for (kind, name), share in largest.items():
            reached[kind][name] = max(reached[kind].get(name, 0), share)
    REACHED.write_text(json.dumps(reached, indent=1, sort_keys=True) + "\n", encoding="utf-8")
