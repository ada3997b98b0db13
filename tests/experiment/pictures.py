"""Histograms, box plots and curves as SVG. The same numbers give the same bytes."""

import math

#: One colour for each firmware, in their order; told apart without colours by their places and dashes.
COLOURS = ("#0072b2", "#d55e00", "#e69f00", "#009e73", "#cc79a7")
DASHES = ("", "7 3", "2 2", "9 3 2 3", "4 4")
WIDTH, LEFT, RIGHT, TOP, ROW = 720, 150, 24, 34, 46
STYLE = ("<style>text{font:12px sans-serif;fill:#222}.t{font-weight:bold}.g{stroke:#ddd}.a{stroke:#666}"
         "svg{background:#fff}</style>")


def number(value):
    return f"{value:.2f}".rstrip("0").rstrip(".")


def text(x, y, words, anchor="start", kind=""):
    words = words.replace("&", "&amp;").replace("<", "&lt;")
    return f'<text x="{number(x)}" y="{number(y)}" text-anchor="{anchor}"{kind and f" class={kind!r}"}>{words}</text>'


def width_of(words):
    """About what a text takes, in a wide font."""
    return 6.7 * len(words)


def line(x1, y1, x2, y2, look):
    return f'<line x1="{number(x1)}" y1="{number(y1)}" x2="{number(x2)}" y2="{number(y2)}" {look}/>'


def document(width, height, elements, title):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{number(height)}" '
            f'viewBox="0 0 {width} {number(height)}" role="img"><title>{title}</title>{STYLE}\n'
            + "\n".join(elements) + "\n</svg>\n")


def ticks(low, high, most=7):
    """Round numbers from `low` to `high`."""
    raw = (high - low) / most or 1
    unit = 10 ** math.floor(math.log10(raw))
    step = next(unit * m for m in (1, 2, 5, 10) if unit * m >= raw)
    first = math.ceil(low / step - 1e-9)
    return [round((first + i) * step, 10) for i in range(int(math.floor(high / step + 1e-9)) - first + 1)]


class Scale:
    """From values to places; logarithmic where asked."""

    def __init__(self, low, high, begin, end, is_log=False):
        self.is_log = is_log
        self.low, self.high = (math.log10(low), math.log10(high)) if is_log else (low, high)
        self.begin, self.end = begin, end

    def __call__(self, value):
        value = math.log10(value) if self.is_log else value
        return self.begin + (value - self.low) / (self.high - self.low or 1) * (self.end - self.begin)

    def ticks(self):
        if not self.is_log:
            return ticks(self.low, self.high)
        return [10.0 ** k for k in range(math.ceil(self.low - 1e-9), math.floor(self.high + 1e-9) + 1)]


def quantile(ordered, share):
    place = share * (len(ordered) - 1)
    low = math.floor(place)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (ordered[high] - ordered[low]) * (place - low)


def axis(scale, top, bottom, unit):
    parts = []
    for tick in scale.ticks():
        x = scale(tick)
        parts += [line(x, top, x, bottom, 'class="g"'), text(x, bottom + 15, number(tick), "middle")]
    parts.append(text(scale.end, bottom + 30, unit, "end"))
    return parts


def boxes(title, rows, unit, is_log=False):
    """`rows`: names and values. The box holds the middle half, the line is the median, the whiskers are all of it."""
    values = [value for _, all_of_it in rows for value in all_of_it]
    low, high = min(values), max(values)
    if is_log:
        low, high = 10 ** math.floor(math.log10(low)), 10 ** math.ceil(math.log10(high))
    else:
        low, high = low - 0.03 * (high - low or 1), high + 0.03 * (high - low or 1)
    scale = Scale(low, high, LEFT, WIDTH - RIGHT, is_log)
    bottom = TOP + ROW * len(rows)
    parts = [text(LEFT, 18, title, kind="t")] + axis(scale, TOP - 6, bottom, unit)
    for i, (name, all_of_it) in enumerate(rows):
        ordered, y = sorted(all_of_it), TOP + ROW * i + ROW / 2 - 4
        a, b, middle, c, d = (scale(quantile(ordered, share)) for share in (0, 0.25, 0.5, 0.75, 1))
        parts += [text(LEFT - 8, y + 4, name, "end"), line(a, y, d, y, 'class="a"'),
                  f'<rect x="{number(b)}" y="{number(y - 11)}" width="{number(max(c - b, 1))}" height="22" fill="{COLOURS[i]}"/>',
                  line(middle, y - 11, middle, y + 11, 'stroke="#000" stroke-width="1.5"'),
                  line(a, y - 6, a, y + 6, 'class="a"'), line(d, y - 6, d, y + 6, 'class="a"')]
    return document(WIDTH, bottom + 40, parts, title)


def histograms(title, rows, unit, bins=60):
    """One below the other, each over its own range."""
    height, parts, top = 104, [text(LEFT, 18, title, kind="t")], TOP
    for i, (name, values) in enumerate(rows):
        low, high = min(values), max(values)
        if high - low < 1e-9:
            low, high = low - 0.5, high + 0.5
        counts = [0] * bins
        for value in values:
            counts[min(int((value - low) / (high - low) * bins), bins - 1)] += 1
        scale, most, base = Scale(low, high, LEFT, WIDTH - RIGHT), max(counts), top + height - 40
        parts += [text(LEFT - 8, base - 24, name, "end"), text(LEFT - 8, base - 8, f"{len(values)} values", "end")]
        wide = (WIDTH - RIGHT - LEFT) / bins
        for k, count in enumerate(counts):
            if count:
                tall = count / most * (height - 46)
                parts.append(f'<rect x="{number(LEFT + k * wide)}" y="{number(base - tall)}" width="{number(wide)}" '
                             f'height="{number(tall)}" fill="{COLOURS[i]}"/>')
        parts.append(line(LEFT, base, WIDTH - RIGHT, base, 'class="a"'))
        for tick in scale.ticks():
            parts.append(text(scale(tick), base + 15, number(tick), "middle"))
        top += height
    parts.append(text(WIDTH - RIGHT, top - 2, unit, "end"))
    return document(WIDTH, top + 10, parts, title)


def marks_of(marks, across, bottom):
    """A line for each, with its words to the right where they end before the next line, else to the left."""
    places = [across(at) for at, _ in marks] + [WIDTH]
    parts = []
    for (_, words), x, following in zip(marks, places, places[1:]):
        fits = x + 6 + width_of(words) < following
        parts += [line(x, TOP, x, bottom, 'stroke="#999" stroke-dasharray="2 3"'),
                  text(x + 3, TOP + 10, words) if fits else text(x - 3, TOP + 10, words, "end")]
    return parts


def curves(title, rows, unit, marks=()):
    """`rows`: names and points (seconds, value). `marks`: seconds and what happens then."""
    points = [point for _, all_of_it in rows for point in all_of_it]
    across = Scale(min(x for x, _ in points), max(x for x, _ in points), 60, WIDTH - RIGHT)
    low, high = min(y for _, y in points), max(y for _, y in points)
    margin = 0.06 * (high - low or 1)
    up, bottom = Scale(low - margin, high + margin, 300, TOP + 8), 300
    parts = [text(60, 18, title, kind="t")] + axis(across, TOP, bottom, "s")
    for tick in up.ticks():
        parts += [line(60, up(tick), WIDTH - RIGHT, up(tick), 'class="g"'), text(54, up(tick) + 4, number(tick), "end")]
    parts.append(text(54, TOP, unit, "end"))
    parts += marks_of(marks, across, bottom)
    legend = 16
    for i, (name, all_of_it) in enumerate(rows):
        path = " ".join(f"{number(across(x))},{number(up(y))}" for x, y in all_of_it)
        dash = f' stroke-dasharray="{DASHES[i]}"' if DASHES[i] else ""
        parts.append(f'<polyline points="{path}" fill="none" stroke="{COLOURS[i]}" stroke-width="1.6"{dash}/>')
        parts += [line(legend, bottom + 44, legend + 22, bottom + 44, f'stroke="{COLOURS[i]}" stroke-width="2"{dash}'),
                  text(legend + 26, bottom + 48, name)]
        legend += 26 + width_of(name) + 12
    return document(WIDTH, bottom + 60, parts, title)
