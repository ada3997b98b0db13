#!/usr/bin/env python3
"""Photographs reports of the examples for the pages: docs/pictures/*.png. usage: screenshots.py FINEMOTE

The pictures depend on the version of Chromium to the pixel: nothing compares them. 77: there is no Chromium.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = ROOT / "docs/pictures"
sys.path[:0] = [str(ROOT / "tests/report"), str(ROOT / "docs")]

import trace_picture  # noqa: E402
from browser import Browser, program  # noqa: E402

CHOOSE = "document.querySelectorAll('.chain button')[{}].click()"
FIRST_SIX = "document.querySelectorAll('#run .plots figure:nth-child(n+7)').forEach(figure => figure.remove())"
BARS = "document.querySelectorAll('#chains h2, #chains p, #chains .more, #chains details').forEach(one => one.remove())"
SHOW = "view.show({}, {})"
VIEWS = "document.querySelectorAll('#body h2, #body p, #body details').forEach(one => one.remove())"
CHANGES = "document.querySelector('.changes').style.maxHeight = '22rem'; document.querySelector('.changes').style.overflow = 'hidden'"


def report(finemote, folder, robot, *words):
    """The page of an example as it runs, for half a second unless `words` of `run` say more."""
    source, name = ROOT / f"examples/{robot}.urdf", "_".join([robot, *(pathlib.Path(word).stem for word in words)])
    page, run = folder / f"{name}.html", folder / f"{name}.json"
    measured = subprocess.run([finemote, "run", source, *(words or ["--duration", "500ms"]), "--format", "json"],
                              capture_output=True, text=True, check=True)
    run.write_text(measured.stdout)
    subprocess.run([finemote, "-q", "report", source, "-o", page, "--run", run], check=True, stdout=subprocess.DEVNULL)
    return page


def trace(finemote, folder):
    """A page with the begin of a simulated trace."""
    file, page = folder / "trace.json", folder / "trace.html"
    subprocess.run([finemote, "-q", "simulate", ROOT / "examples/infantry.urdf", "--duration", "20ms", "-o", file], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    page.write_text(trace_picture.page_of(json.loads(file.read_text())["traceEvents"], 220))
    return page


def changed(finemote, folder):
    """The page of FinsROV with an inertial sensor at half the rate, beside FinsROV as it is: with the same execution times."""
    before, after, page = ROOT / "examples/finsrov.urdf", folder / "slower.urdf", folder / "changed.html"
    after.write_text(before.read_text().replace('bus="imu_uart" period="5ms"', 'bus="imu_uart" period="10ms"'))
    shutil.copy(ROOT / "examples/finsrov.timing.json", folder / "slower.timing.json")
    subprocess.run([finemote, "-q", "report", after, "-o", page, "--against", before], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    return page


def take(browser, name, page, selector, *steps, **how):
    opened = browser.open(page, **how)
    for step in steps:
        opened.run(step)
        opened.settle()
    opened.screenshot(PICTURES / f"{name}.png", selector)
    complaints = opened.complaints()
    if complaints:
        sys.exit(f"{name}: {complaints}")


def main():
    if program() is None:
        print("no Chromium: the screenshots stay as they are", file=sys.stderr)
        return 77
    finemote = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name, Browser() as browser:
        finsrov, infantry = (report(finemote, pathlib.Path(name), robot) for robot in ("finsrov", "infantry"))
        dive = report(finemote, pathlib.Path(name), "finsrov", "--scenario", ROOT / "tests/emulator/scenarios/rov_loops.json",
                      "--duration", "14s")
        top = "document.body.style.height = '860px'; document.body.style.overflow = 'hidden'"
        take(browser, "report", infantry, None, top, width=1280)
        take(browser, "report_narrow_dark", infantry, None, top, width=390, dark=True)
        take(browser, "ages", infantry, "#chains", BARS, width=900)
        take(browser, "timeline_chain", infantry, "#timeline", CHOOSE.format(0), width=1100)
        take(browser, "preemption", infantry, "#timeline-view svg", SHOW.format(0, 260_000), width=1100)
        take(browser, "settling", dive, "#run .plots", FIRST_SIX, width=1100)
        take(browser, "thrusters", finsrov, "#body", VIEWS, width=1100)
        take(browser, "trace", trace(finemote, pathlib.Path(name)), "svg", width=1120)
        take(browser, "changes", changed(finemote, pathlib.Path(name)), "#changes", CHANGES, width=1000)
    return 0


if __name__ == "__main__":
    sys.exit(main())
