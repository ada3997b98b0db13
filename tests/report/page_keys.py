"""The results of a page of `finemote report` as they stand in the file, before any script, and documents to show in one."""
import html.parser
import json
import re
import subprocess

# A number with a unit, as the page writes results.
FIGURE = re.compile(r"\d (ns|µs|ms|s|%|B)(?!\w)")
# Where such a number is no result: names and texts of the robot's file, axes of pictures, what is said of an input.
NO_RESULT = {"th", "h1", "h2", "svg", "script", "style", "title", "caption"}
NO_RESULT_CLASS = {"word", "board"}
VOID = {"meta", "link", "br", "img", "input"}


def finemote(program, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)


def document(program, *words):
    return json.loads(finemote(program, *words, "--format", "json").stdout)


class Keys(html.parser.HTMLParser):
    """`values`: [key, JSON text of its value, what is shown]. `bare`: figures that no key names."""

    def __init__(self, text):
        super().__init__()
        self.values, self.bare, self.open = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        is_keyed = "data-key" in found
        if is_keyed:
            self.values.append([found["data-key"], found["data-value"], ""])
        if tag not in VOID:
            is_free = tag in NO_RESULT or bool(NO_RESULT_CLASS & set((found.get("class") or "").split()))
            self.open.append((tag, is_keyed, is_free))

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        while self.open and self.open.pop()[0] != tag:
            pass

    def handle_data(self, data):
        if any(is_keyed for _, is_keyed, _ in self.open):
            self.values[-1][2] += data
        elif FIGURE.search(data) and not any(is_free for _, _, is_free in self.open):
            self.bare.append(data.strip())


def at(documents, key):
    """The member that a key names."""
    name, pointer = key.split("#")
    value = documents[name]
    for step in pointer.split("/")[1:]:
        value = value[int(step)] if isinstance(value, list) else value[step]
    return value


def measured(timing):
    """A run as if each chain had taken half its bound, with a quantity that settles and one that stays."""
    bound = {"acquire": "acquire_ns", "decide": "decide_ns", "wire": "wire_ns", "end_to_end": "end_to_end_ns"}
    times = list(range(10**8, 10**9, 10**7))
    chains = [{"from": c["from"], "to": c["to"],
               **{name: {"max_ns": c[part] and c[part] // 2, "bound_ns": c[part], "judged": "held"}
                  for name, part in bound.items()},
               "ages": {"t_ns": times, "age_ns": [(c["end_to_end_ns"] or c["decide_ns"] or 2) // 2 - i % 3
                                                  for i in range(len(times))]}} for c in timing["chains"]]
    settling = [round(1 - 0.9 ** i, 6) for i in range(90)]
    series = {"from_ns": 10**8, "every_ns": 10**7}
    values = [{"part": "hull", "value": "depth", "unit": "m", **series, "lowest": 0.0, "highest": settling[-1],
               "last": settling[-1], "values": settling},
              {"part": "hull", "value": "roll", "unit": "deg", **series, "lowest": 2, "highest": 2, "last": 2,
               "values": [2] * 90}]
    wanted = [{"part": "hull", "value": "depth", "from_ns": 5 * 10**8, "to_ns": 9 * 10**8, "min": 0.9, "max": 1.1,
               "lowest": 0.985, "highest": 0.9998, "ok": True}]
    return {"schema": "finemote.run/1", "chains": chains, "values": values, "expectations": wanted, "overruns": 0,
            "duration_ns": 10**9, "image": {"flash": 12345, "ram": 678, "stack": None}}
