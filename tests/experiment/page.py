"""docs/case-study.md and its pictures, from the figures alone: whatever they say."""

import firmwares
import measure
import pictures as draw
import plans

NAMES = {firmware.name: firmware.title for firmware in firmwares.FIRMWARES}
OWN, PUBLIC = "generated", "public_polled"
#: The paper's figures [us], of its section "Results": mean and standard deviation of the interval, and jitter.
PAPER = {OWN: (53.64, 4.29, 5.34), PUBLIC: (1610.00, 10.68, 18.87)}
#: What was expected of the comparison: how many times shorter than of the public-style baseline.
SMALLER = {"decision": "shorter", "wire": "shorter", "jitter": "smaller"}
LARGER = {"decision": "longer", "wire": "longer", "jitter": "larger"}
GOALS = (("decision", 30), ("wire", 2), ("jitter", 3.5))


def us(ns, digits=1):
    return "-" if ns is None else f"{ns / 1000:.{digits}f}"


def ms(ns):
    return "-" if ns is None else f"{ns / 1e6:.2f}"


def seconds(value):
    return "no" if value is None else f"{value:.2f} s"


def percent(share):
    return f"{100 * share:.1f} %"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def of_code(entries, code):
    return {entry["name"]: entry for entry in entries if entry["code"] == code}


def value(entry, what):
    return entry["jitter_sd_ns"] if what == "jitter" else entry[what]["mean_ns"]


def ratio(entries, what):
    return value(entries[PUBLIC], what) / value(entries[OWN], what)


def timing_table(entries):
    head = ["firmware", "decision [us]", "sd", "longest", "wire [ms]", "longest", "attitude [ms]", "take to pulse [us]",
            "jitter sd [us]", "peak to peak"]
    return table(head, [[NAMES[name], us(e["decision"]["mean_ns"]), us(e["decision"]["sd_ns"]), us(e["decision"]["max_ns"]),
                         ms(e["wire"]["mean_ns"]), ms(e["wire"]["max_ns"]), ms(e["wire_imu"]["mean_ns"]),
                         us(e["take_to_pulse"]["mean_ns"]), us(e["jitter_sd_ns"]), us(e["jitter_pp_ns"])]
                        for name, e in entries.items()])


def cpu_table(entries):
    return table(["firmware", "control", "interrupts", "spinning", "nothing to do"],
                 [[NAMES[name], *(percent(e["cpu"][kind]) for kind in ("control", "interrupt", "spin", "idle"))]
                  for name, e in entries.items()])


def goals(entries):
    rows = []
    for what, least in GOALS:
        times = ratio(entries, what)
        rows.append([what, f"{times:.2f} times {SMALLER[what]}" if times >= 1 else f"{1 / times:.2f} times {LARGER[what]}",
                     f"{least:g} times", "reached" if times >= least else "not reached"])
    return table(["against the public-style baseline, code in SRAM", "measured", "expected", ""], rows)


#: Figures in which a smaller value is better: name, how it is read, how it is written.
COMPARED = (("decision, mean", lambda e: e["decision"]["mean_ns"], lambda v: us(v) + " us"),
            ("decision, longest", lambda e: e["decision"]["max_ns"], lambda v: us(v) + " us"),
            ("wire of the depth, mean", lambda e: e["wire"]["mean_ns"], lambda v: ms(v) + " ms"),
            ("wire of the depth, longest", lambda e: e["wire"]["max_ns"], lambda v: ms(v) + " ms"),
            ("wire of the attitude, mean", lambda e: e["wire_imu"]["mean_ns"], lambda v: ms(v) + " ms"),
            ("wire of the attitude, longest", lambda e: e["wire_imu"]["max_ns"], lambda v: ms(v) + " ms"),
            ("from the take of the depth to the last pulse, mean", lambda e: e["take_to_pulse"]["mean_ns"], lambda v: us(v) + " us"),
            ("jitter, standard deviation", lambda e: e["jitter_sd_ns"], lambda v: us(v) + " us"),
            ("jitter, peak to peak", lambda e: e["jitter_pp_ns"], lambda v: us(v) + " us"),
            ("processor in interrupts", lambda e: e["cpu"]["interrupt"], percent),
            ("processor busy", lambda e: 1 - e["cpu"]["idle"], percent))


def losses(entries):
    """Every figure in which a baseline is better than the generated firmware."""
    rows = []
    for what, read, written in COMPARED:
        own = read(entries[OWN])
        better = [name for name in entries if name != OWN and read(entries[name]) < own]
        if better:
            rows.append([what, written(own), ", ".join(f"{NAMES[name]} {written(read(entries[name]))}" for name in better)])
    return table(["figure", "generated", "better"], rows) if rows else "In none of the figures of this table of comparisons.\n"


def bounds_table(entry, analysis):
    """Measured beside bound, for the same sensor and all thrusters."""
    chains = [c for c in analysis["chains"] if (c["from"], c["to"]) in measure.CHAINS]
    longest = {key: max(c[key] for c in chains) for key in ("decide_ns", "end_to_end_ns")}
    return table(["generated, code in SRAM", "longest measured", "bound"],
                 [["wire of the depth [ms]", ms(entry["wire"]["max_ns"]), ms(longest["end_to_end_ns"])],
                  ["decision [us]", us(entry["decision"]["max_ns"]), us(longest["decide_ns"])]])


def turns(entries):
    """Jitter over whole turns of the public manner's phases: its own, and the generated firmware's."""
    return {"public_turn": us(entries[PUBLIC]["turn_sd_ns"]), "own_turn": us(entries[OWN]["turn_sd_ns"])}


def motion_table(motion):
    return table(["firmware", "depth settled after", "overshoot", "heading settled after", "overshoot", "pushed: depth", "pushed: heading"],
                 [[NAMES[one["name"]], seconds(one["depth_settled_s"]), f"{100 * one['depth_overshoot_m']:.1f} cm",
                   seconds(one["yaw_settled_s"]), f"{one['yaw_overshoot_deg']:.1f} deg",
                   f"{100 * one['push_depth_m']:.1f} cm", f"{one['push_yaw_deg']:.1f} deg"] for one in motion])


def fault_words(one):
    if one["fault"] == "tether":
        ends = one["forward_ends_s"]
        return "goes forward to the end of the run" if ends is None else f"goes forward for {ends:.2f} s more, then holds depth and heading"
    neutral, again = one["neutral_s"], one["driven_again_s"]
    if neutral is None:
        return f"driven on; pulses stood still for {one['longest_unchanged_s']:.2f} s at most"
    if again is None:
        return f"neutral after {neutral:.2f} s, and so it stays"
    return f"neutral after {neutral:.2f} s, driven again {again:.2f} s after the fault began"


def fault_table(faults, fault):
    return table(["firmware", "thrusters"], [[NAMES[one["name"]], fault_words(one)] for one in faults if one["fault"] == fault])


def pictures(figures, motion):
    plain = [(firmware.name, figures[firmware.name, "sram", ""]) for firmware in firmwares.FIRMWARES]

    def rows(which, scale):
        return [(NAMES[name], [v / scale for v in which(one)]) for name, one in plain]

    def middles(one):
        mean = sum(one.interval) / len(one.interval)
        return [interval - mean for interval in one.interval]

    steps = [(plans.STEP_DEPTH_NS / 1e9, "depth"), (plans.STEP_YAW_NS / 1e9, "heading"), (plans.PUSH_NS / 1e9, "pushed")]
    turns = [(plans.STEP_YAW_NS / 1e9, "heading"), (plans.PUSH_NS / 1e9, "pushed")]
    return {
        "case-study-decision.svg": draw.boxes("Decision: from the take of a depth to the last thruster", rows(lambda one: one.decision, 1e6),
                                              "us, logarithmic", True),
        "case-study-decision-histogram.svg": draw.histograms("Decision, each over its own range", rows(lambda one: one.decision, 1e6), "us"),
        "case-study-wire.svg": draw.boxes("Wire: from a sample of depth to the last pulse made of it", rows(lambda one: one.wire, 1e9), "ms"),
        "case-study-attitude.svg": draw.boxes("Wire: from a sample of attitude to the last pulse made of it", rows(lambda one: one.wire_imu, 1e9), "ms"),
        "case-study-jitter.svg": draw.boxes("Distance between two last ends, less its mean", rows(middles, 1e6), "us"),
        "case-study-jitter-histogram.svg": draw.histograms("Distance between two last ends, less its mean, each over its own range", rows(middles, 1e6), "us"),
        "case-study-depth.svg": draw.curves("Depth", [(NAMES[name], one["depth"]) for name, one in motion.items()], "m", steps),
        "case-study-heading.svg": draw.curves("Heading", [(NAMES[name], one["yaw"]) for name, one in motion.items()], "deg", turns),
    }


def paper_table(entries):
    rows = []
    for name, (mean, sd, jitter) in PAPER.items():
        e = entries[name]
        rows.append([NAMES[name], f"{mean:.2f} ({sd:.2f})", f"{us(e['decision']['mean_ns'], 2)} ({us(e['decision']['sd_ns'], 2)})",
                     f"{jitter:.2f}", us(e["jitter_sd_ns"], 2)])
    return table(["firmware", "paper: interval (sd) [us]", "here: decision (sd) [us]", "paper: jitter [us]", "here: jitter [us]"], rows)


def image(name, words):
    return f"![{words}](pictures/case-study-{name}.svg)\n"


def page(result, analysis, periods):
    sram, flash = (of_code(result["firmwares"], code) for code in firmwares.CODES)
    loaded = of_code(result["loaded"], "sram")
    faults = "\n".join(f"**{fault}**: {words}.\n\n{fault_table(result['faults'], fault)}" for fault, (words, _) in plans.FAULTS.items())
    return TEXT.format(
        seed=result["seed"], compiler=result["compiler"], periods=f"{periods:,}", goals=goals(sram), sram=timing_table(sram),
        flash=timing_table(flash), cpu=cpu_table(sram), loaded=timing_table(loaded),
        loaded_cpu=cpu_table(loaded), losses=losses(sram), loaded_losses=losses(loaded),
        bounds=bounds_table(sram[OWN], analysis), motion=motion_table(result["motion"]), faults=faults, paper=paper_table(sram), **turns(sram),
        fault_at=plans.FAULT_NS / 1e9, mended=(plans.MENDED_NS - plans.FAULT_NS) / 1e9,
        resolution=f"{max(one['resolution_s'] for one in result['faults']) * 1000:.0f}",
        box=image("decision", "Box plots of the decision"), histogram=image("decision-histogram", "Histograms of the decision"),
        wire=image("wire", "Box plots of the wire interval of depth"), attitude=image("attitude", "Box plots of the wire interval of attitude"),
        jitter=image("jitter", "Box plots of the jitter"), jitters=image("jitter-histogram", "Histograms of the jitter"),
        depth=image("depth", "Depth over time"), heading=image("heading", "Heading over time"))


TEXT = (firmwares.ROOT / "tests/experiment/page.md").read_text(encoding="utf-8")
