"""A trace file to a picture of its begin, as a viewer of the trace event format lays it out: a track below the other, slices nested
in those around them, arrows from slice to slice."""
import html

WIDTH, LEFT, ROW, GAP, AXIS = 1100, 130, 22, 10, 24
COLOURS = ("#cfe8ff", "#d3f5d9", "#ffe3c2", "#e8dcff", "#f7eaa4", "#ffd9ec", "#c8f0ed", "#e1e4e8")
LETTER = 6.6  # width of a letter, about


class Picture:
    def __init__(self, events, to_us):
        self.to_us, self.parts, self.arrows = to_us, [], {}
        self.slices = [e for e in events if e["ph"] == "X" and e["ts"] < to_us]
        names = {e["tid"]: e["args"]["name"] for e in events if e["ph"] == "M" and e["name"] == "thread_name"}
        self.tops, y = {}, AXIS
        for track in sorted({e["tid"] for e in self.slices}):
            self.tops[track] = y
            self.text(8, y + 15, names[track], "600")
            y += ROW * max(self.depth(e) + 1 for e in self.slices if e["tid"] == track) + GAP
        self.height = y
        self.draw_axis()
        for event in self.slices:
            self.draw_slice(event)
        for event in events:
            if event["ph"] in "sf" and event["ts"] < to_us:
                self.arrows.setdefault(event["id"], {})[event["ph"]] = event
        for ends in self.arrows.values():
            if len(ends) == 2:
                self.draw_arrow(ends["s"], ends["f"])

    def x(self, time):
        return LEFT + min(time, self.to_us) / self.to_us * (WIDTH - LEFT)

    def depth(self, event):
        return sum(1 for e in self.slices if e["tid"] == event["tid"] and e is not event and e["dur"] > event["dur"]
                   and e["ts"] <= event["ts"] and event["ts"] + event["dur"] <= e["ts"] + e["dur"] + 1e-9)

    def row(self, track, time):
        inside = [e for e in self.slices if e["tid"] == track and e["ts"] <= time <= e["ts"] + e["dur"]]
        return self.tops[track] + ROW * (max(map(self.depth, inside), default=0)) + ROW / 2

    def text(self, x, y, words, weight="400", colour="#1f2328"):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-weight="{weight}" fill="{colour}">{html.escape(words)}</text>')

    def draw_axis(self):
        for time in range(0, int(self.to_us), 20):
            x = self.x(time)
            self.parts.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="18" y2="{self.height}" stroke="#d0d7de"/>')
            self.text(x + 3, 14, f"{time} µs", colour="#57606a")

    def draw_slice(self, event):
        x, end, top = self.x(event["ts"]), self.x(event["ts"] + event["dur"]), self.tops[event["tid"]] + ROW * self.depth(event)
        colour = COLOURS[sum(map(ord, event["name"].split(".")[0])) % len(COLOURS)]
        self.parts.append(f'<rect x="{x:.1f}" y="{top}" width="{max(1, end - x):.1f}" height="{ROW - 2}" fill="{colour}" '
                          'stroke="#57606a" stroke-width=".7"/>')
        if end - x > LETTER * len(event["name"]) + 6:
            self.text(x + 4, top + 14, event["name"])

    def draw_arrow(self, start, end):
        x, y, to_x, to_y = self.x(start["ts"]), self.row(start["tid"], start["ts"]), self.x(end["ts"]), self.row(end["tid"], end["ts"])
        self.parts.append(f'<path d="M{x:.1f} {y}C{x + 24:.1f} {y} {to_x - 24:.1f} {to_y} {to_x:.1f} {to_y}" fill="none" '
                          'stroke="#b42318" stroke-width="1.3" marker-end="url(#tip)"/>')


def page_of(events, to_us):
    """A page with nothing but the picture of the first `to_us` microseconds."""
    picture = Picture(events, to_us)
    tip = '<marker id="tip" markerWidth="7" markerHeight="7" refX="6" refY="3.5" orient="auto"><path d="M0 0L7 3.5L0 7Z" fill="#b42318"/></marker>'
    return ('<!DOCTYPE html><meta charset="utf-8"><body style="margin:0;background:#fff">'
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{picture.height}" font-family="DejaVu Sans, sans-serif" '
            f'font-size="11"><defs>{tip}</defs>{"".join(picture.parts)}</svg>')
