#!/usr/bin/env python3
"""The page of `finemote report` in a browser: usage: report_test.py FINEMOTE SOURCE. 77: there is no Chromium."""
import json
import pathlib
import sys
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

from browser import Browser, program
from page_keys import Keys, at, document, finemote, measured

FINEMOTE, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
FOLDER = tempfile.TemporaryDirectory()
SIZE_LIMIT = 2_000_000


def wide_robot(count):
    leaves = "".join(f'<device name="leaf_{i}" type="sim_load"/>' for i in range(count - 1))
    return ('<robot name="wide"><link name="base"/><finemote version="1"><board name="robomaster_type_c"/>'
            f'<device name="root" type="group" period="40ms">{leaves}</device></finemote></robot>')


def hostile_robot():
    """Names that are markup, written from right to left, and long; a name of a device has no two odd characters in a row."""
    link = "</script><!--\u0645\u0631\u062d\u0628\u0627<svg/onload=x>'\"&amp; " + "y" * 280
    path = pathlib.Path(FOLDER.name) / "hostile.urdf"
    path.write_text(
        f'<robot name={quoteattr("a<b>c" + "x" * 290)}><link name={quoteattr(link)}/><finemote version="1">'
        '<board name="robomaster_type_c"/><bus name="esc" type="pwm" port="pwm1"/>'
        '<bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/><device name="r&amp;o&lt;o>t" type="group" period="10ms">'
        f'<device name="d&lt;i>e&quot;p\'th" type="ms5837" bus="i2c" address="0x76" link={quoteattr(link)}/>'
        f'<device name={quoteattr("z" * 300)} type="pwm_esc" bus="esc" channel="0"/></device></finemote></robot>')
    return path


def oldest(stages, up, down):
    """How old a command at the end of `down` gets, by passing the times of samples on from stage to stage."""
    edges, time = [], 0
    for i, (device, is_handle, gap, length) in enumerate(zip(*[iter(stages)] * 4)):
        time += gap
        # What ends comes before what begins then, but a stage that takes no time begins first.
        edges += [((time, 1, i, 0), True, device, is_handle), ((time + length, 0 if length else 1, i, 1), False, device, is_handle)]
    seen, state, command, taken, worst = {}, {}, {}, {}, 0
    for (at, *_), is_begin, device, is_handle in sorted(edges):
        if is_begin and not is_handle and device in up:
            place = up.index(device)
            seen[device] = at if place == 0 else state.get(up[place - 1])
        elif not is_begin and not is_handle and device in up:
            state[device] = seen.get(device)
        elif is_begin and is_handle and device in down:
            place = down.index(device)
            taken[device] = state.get(up[-1]) if place == 0 else command.get(down[place - 1])
        elif not is_begin and is_handle and device in down:
            command[device] = taken.get(device)
            if device == down[-1] and command[device] is not None:
                worst = max(worst, at - command[device])
    return worst


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()
        cls.robots = {"finsrov": SOURCE / "examples/finsrov.urdf", "infantry": SOURCE / "examples/infantry.urdf",
                      "wide": pathlib.Path(FOLDER.name) / "wide.urdf"}
        cls.robots["wide"].write_text(wide_robot(1000))
        cls.runs = {name: pathlib.Path(FOLDER.name) / f"{name}.run.json" for name in cls.robots}
        for name, robot in cls.robots.items():
            cls.runs[name].write_text(json.dumps(measured(document(FINEMOTE, "analyze", robot))))
            answer = finemote(FINEMOTE, "report", robot, "-o", cls.page(name), "--run", cls.runs[name])
            assert answer.returncode == 0, answer.stderr

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    @staticmethod
    def page(name):
        return pathlib.Path(FOLDER.name) / (name + ".html")

    def open(self, name, **how):
        page = self.browser.open(self.page(name), **how)
        self.addCleanup(lambda: self.assertEqual(page.complaints(), []))
        return page

    def test_every_number_is_that_of_its_document(self):
        for name, robot in self.robots.items():
            documents = {"timing": document(FINEMOTE, "analyze", robot), "simulation": document(FINEMOTE, "simulate", robot),
                         "run": json.loads(self.runs[name].read_text())}
            values = Keys(self.page(name).read_text()).values
            self.assertGreater(len(values), 100)
            for key, value, _ in values:
                self.assertEqual(json.loads(value), at(documents, key), key)
            shown = {key for key, _, _ in values}
            for i in range(len(documents["timing"]["chains"])):
                for part in ("acquire_ns", "decide_ns", "wire_ns", "end_to_end_ns"):
                    self.assertIn(f"timing#/chains/{i}/{part}", shown)

    def test_pages_are_small_and_quiet_at_every_width(self):
        for name in self.robots:
            self.assertLess(self.page(name).stat().st_size, SIZE_LIMIT)
            for width in (1280, 390, 360):
                page = self.open(name, width=width)
                self.assertEqual(page.run("document.documentElement.scrollWidth"), width, f"{name} at {width}")
                self.assertRegex(page.run("document.body.innerText.trim().split('\\n')[0]"), "meets every deadline")

    def test_a_page_without_script_shows_its_results(self):
        page = self.open("finsrov", script=False)
        text = self.page("finsrov").read_text()
        self.assertIn("default-src 'none'", text)
        self.assertNotIn("://", text.replace("http://www.w3.org/2000/svg", ""))
        self.assertEqual(page.complaints(), [])

    def test_a_chain_shows_its_way(self):
        for name in self.robots:
            with self.subTest(robot=name):
                self.check_way(self.open(name))

    def check_way(self, page):
        page.run("document.querySelector('.chain button').click()")
        name = page.run("document.querySelector('.chain button').textContent")
        source, end = name.split(" → ")
        lit = page.run("[...document.querySelectorAll('.forest .device.path')].map(card => card.dataset.device)")
        self.assertIn(source, lit)
        self.assertIn(end, lit)
        dim = page.run("[...document.querySelectorAll('.forest .device.off')].map(card => card.dataset.device)")
        self.assertEqual(set(lit) & set(dim), set())
        row = page.run(f"(row => [row.dataset.up, row.dataset.down])([...document.querySelectorAll('#chains-table tbody tr')]"
                       f".find(row => row.cells[0].textContent === {json.dumps(name)}))")
        devices = page.run("data.devices")
        self.assertEqual(set(lit), {devices[int(i)] for i in " ".join(row).split()})
        self.assertGreaterEqual(page.run("document.querySelectorAll('#timeline-view .path').length"), 2)
        self.assertEqual(page.run("document.querySelector('.chain button').getAttribute('aria-pressed')"), "true")
        page.run("document.querySelector('.chain button').click()")
        self.assertEqual(page.run("document.querySelectorAll('.path, .off').length"), 0)

    def test_the_way_of_a_chain_is_that_of_its_oldest_command(self):
        page = self.open("infantry")
        data = page.run("data")
        place = {name: i for i, name in enumerate(data["devices"])}
        marked = page.run("""readChains().map(chain => [chain.name, chain.up, chain.down,
            wayOf(chain, view.lanes).filter(s => s.kind !== 'frame').map(s => [s.kind, s.device, s.begin, s.end])])""")
        self.assertGreater(len(marked), 8)
        simulation = document(FINEMOTE, "simulate", self.robots["infantry"])
        worst = {f"{c['from']} \u2192 {c['to']}": c["max_ns"] for c in simulation["chains"]}
        for name, up, down, way in marked:
            self.assertEqual([step[:2] for step in way], [["update", d] for d in up] + [["handle", d] for d in down])
            for before, after in zip(way, way[1:]):
                self.assertLessEqual(before[3], after[2])
            age = way[-1][3] - way[0][2]
            self.assertEqual(age, oldest(data["stages"], up, down), name)
            self.assertLessEqual(age, worst[name])
        slow = next(row for row in marked if row[0] == "remote \u2192 yaw")  # read every 10 ms, used every 1 ms
        self.assertGreater(slow[3][-1][3] - slow[3][0][2], 10_000_000)
        page.run("document.querySelector('.chain button').click()")
        self.assertIn("oldest command", page.run("document.querySelector('#way').innerText"))
        self.assertEqual(set(place[d] for d in ("remote", "gimbal", "yaw")), set(slow[1] + slow[2]))

    def test_bars_compare_times_where_nothing_has_a_bound(self):
        robot = pathlib.Path(FOLDER.name) / "late.urdf"
        loads = "".join(f'<device name="load_{i}" type="sim_load"><wcet update="400us" handle="400us" source="budget"/></device>'
                        for i in range(4))
        robot.write_text('<robot name="late"><link name="base"/><finemote version="1"><board name="robomaster_type_c"/>'
                         f'<device name="root" type="group" period="1ms">{loads}</device></finemote></robot>')
        finemote(FINEMOTE, "report", robot, "-o", self.page("late"))
        page = self.open("late")
        self.assertIn("\u2717", page.run("document.querySelector('h1').innerText"))
        bars = page.run("""[...document.querySelectorAll('.chain .bar.seen')].map(bar => [
            bar.querySelector('.part.decide').getBoundingClientRect().width, Number(bar.querySelector('.total [data-value]').dataset.value)])""")
        self.assertEqual(len(bars), 4)
        per_pixel = [value / width for width, value in bars]
        self.assertLess(max(per_pixel) / min(per_pixel), 1.02)
        ticks = page.run("[...document.querySelectorAll('.axis i')].map(e => e.innerText)")
        self.assertTrue(all(text == "0" or "ms" in text or "µs" in text for text in ticks), ticks)

    def test_texts_of_pictures_keep_their_contrast(self):
        for dark in (False, True):
            page = self.open("infantry", dark=dark)
            page.run("document.documentElement.style.scrollBehavior = 'auto'; view.show(0, 400_000)")
            count, bad = page.run(PICTURE_CONTRASTS)
            self.assertGreater(count, 100)
            self.assertEqual(bad, [], "dark" if dark else "light")
            page.run("document.querySelector('.chain button').click()")
            self.assertEqual(page.run(PICTURE_CONTRASTS)[1], [], "of a chosen chain")

    def test_every_timeline_zooms_and_every_theme_changes(self):
        length = "(d => d.to - d.from)(document.querySelector('#timeline-view svg').dataset)"
        colour = "getComputedStyle(document.body).backgroundColor"
        for name in self.robots:
            page = self.open(name)
            whole, light = page.run(length), page.run(colour)
            page.run("document.querySelector('#timeline-view [aria-label=\"Zoom in\"]').click()")
            self.assertAlmostEqual(page.run(length), whole / 2, delta=1)
            page.run("document.querySelector('#theme').click()")
            self.assertNotEqual(page.run(colour), light, name)
            page.run("document.querySelector('#theme').click()")
            self.assertEqual(page.run(colour), light, name)

    def test_the_timeline_zooms_moves_and_tells(self):
        page = self.open("infantry")
        view = "(({from, to}) => [Number(from), Number(to)])(document.querySelector('#timeline-view svg').dataset)"
        whole = page.run(view)
        self.assertEqual(whole, [0, 10_000_000])
        page.run("document.querySelector('#timeline-view [aria-label=\"Zoom in\"]').click()")
        zoomed = page.run(view)
        self.assertAlmostEqual(zoomed[1] - zoomed[0], 5_000_000, delta=1)
        page.run("document.querySelector('#timeline-view svg').focus()")
        for key in ("+", "ArrowRight", "ArrowDown"):
            page.press(key)
        nearer = page.run(view)
        self.assertAlmostEqual(nearer[1] - nearer[0], 2_500_000, delta=1)
        detail = page.run("[...document.querySelectorAll('#detail [data-key]')].map(e => [e.dataset.key, e.dataset.value])")
        self.assertGreaterEqual(len(detail), 3)
        documents = {"timing": document(FINEMOTE, "analyze", self.robots["infantry"]),
                     "simulation": document(FINEMOTE, "simulate", self.robots["infantry"])}
        for key, value in detail:
            if not key.startswith("run#"):
                self.assertEqual(json.loads(value), at(documents, key))
        page.press("0")
        self.assertEqual(page.run(view), [0, 20_000_000])  # a hyperperiod more, in which commands are as old as they get

    def test_the_timeline_has_a_table(self):
        page = self.open("infantry")
        rows = "[...document.querySelectorAll('#timeline-table tbody tr')].map(row => [...row.cells].map(c => c.innerText))"
        self.assertEqual(page.run(rows), [])
        page.run("document.querySelector('#timeline > details summary').click()")
        page.settle()
        self.assertEqual(len(page.run(rows)), 200)
        self.assertIn("of", page.run("document.querySelector('#timeline-table caption').innerText"))
        page.run("view.show(0, 260_000)")
        near = page.run(rows)
        self.assertIn(["imu update()", "every 1 ms"], [row[:2] for row in near])
        self.assertTrue(any(row[4] != "0 ns" for row in near))  # a stage that waited
        self.assertEqual(page.run("document.documentElement.scrollWidth"), 1280)

    def test_the_theme_changes_and_texts_keep_their_contrast(self):
        for dark in (False, True):
            page = self.open("finsrov", dark=dark)
            before = page.run("getComputedStyle(document.body).backgroundColor")
            self.assertEqual(page.run(CONTRASTS), [], "dark" if dark else "light")
            page.run("document.querySelector('#theme').click()")
            self.assertNotEqual(page.run("getComputedStyle(document.body).backgroundColor"), before)
            self.assertEqual(page.run(CONTRASTS), [], "light" if dark else "dark")

    def test_what_changed_is_said_and_drawn(self):
        text = (SOURCE / "examples/finsrov.urdf").read_text()
        before = pathlib.Path(FOLDER.name) / "before.urdf"  # without its timing file, of which the other one has none
        before.write_text(text)
        slower = pathlib.Path(FOLDER.name) / "slower.urdf"
        slower.write_text(text.replace('bus="imu_uart" period="5ms"', 'bus="imu_uart" period="10ms"')
                          .replace('name="thruster_8" type', 'name="thruster_nine" type'))
        saved = pathlib.Path(FOLDER.name) / "before.json"
        saved.write_text(json.dumps(document(FINEMOTE, "analyze", before)))
        for against in (before, saved):
            answer = finemote(FINEMOTE, "report", slower, "-o", self.page("changed"), "--against", against)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            page = self.open("changed")
            rows = page.run("[...document.querySelectorAll('#changes-table tbody tr')].map(r => [...r.cells].map(c => c.innerText))")
            self.assertIn(["device imu", "period", "5 ms", "10 ms", "changed"], rows)
            self.assertIn(["device thruster_nine", "", "–", "–", "added"], rows)
            self.assertIn(["device thruster_8", "", "–", "–", "removed"], rows)
            worse = [row[0] for row in rows if row[4] == "worse"]
            self.assertTrue(worse)
            changed = page.run("[...document.querySelectorAll('.device.changed')].map(card => card.dataset.device)")
            self.assertEqual(set(changed), {"imu", "thruster_nine"})
            self.assertGreater(page.run("[...document.querySelectorAll('.bar .who')].filter(w => w.innerText === 'before').length"), 0)
            documents = {"timing": document(FINEMOTE, "analyze", slower), "simulation": document(FINEMOTE, "simulate", slower),
                         "against": json.loads(saved.read_text())}
            for key, value, _ in Keys(self.page("changed").read_text()).values:
                self.assertEqual(json.loads(value), at(documents, key), key)
        finemote(FINEMOTE, "report", before, "-o", self.page("changed"), "--against", saved)
        self.assertEqual(self.open("changed").run("document.querySelectorAll('#changes-table, .device.changed').length"), 0)

    def test_a_run_is_drawn_over_time(self):
        page = self.open("finsrov")
        self.assertEqual(page.run("document.querySelectorAll('#run figure').length"), 1 + 6)  # what moves, oldest chains
        self.assertEqual(page.run("document.querySelectorAll('#run .wanted').length"), 1)
        self.assertEqual(page.run("document.querySelectorAll('#run .limit').length"), 6)
        line = page.run("""(path => {
          const box = path.getBBox();
          return [path.getAttribute('d').split('L').length, box.x, box.y, box.x + box.width, box.y + box.height];
        })(document.querySelector('#run .line'))""")
        self.assertEqual(line[0], 90)
        self.assertTrue(all(0 < low and high < 360 for low, high in zip(line[1:3], line[3:])), line)
        for width in (1280, 360):
            page.resize(width, 900)
            page.settle()
            self.assertEqual(page.run("""[...document.querySelectorAll('.plot')].flatMap(svg => {
              const box = svg.getBoundingClientRect();
              return [...svg.querySelectorAll('text')].filter(e => {
                const b = e.getBoundingClientRect();
                return b.left < box.left || b.right > box.right || b.top < box.top || b.bottom > box.bottom;
              }).map(e => e.outerHTML);
            })"""), [])

    def test_paper_is_light_and_shows_all(self):
        page = self.open("finsrov", dark=True)
        page.run("document.querySelector('#theme').click(); document.querySelector('#theme').click()")  # dark by choice
        page.call("Emulation.setEmulatedMedia", media="print", features=[{"name": "prefers-color-scheme", "value": "dark"}])
        page.resize(700, 1000)
        page.settle()
        self.assertEqual(page.run("getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)")
        self.assertEqual(page.run(CONTRASTS), [])
        cut = """[...document.querySelectorAll('.scroll')].filter(e => e.checkVisibility() && e.getBoundingClientRect().width > 0)
                 .filter(e => e.scrollWidth > 701).map(e => e.getAttribute('aria-label'))"""
        self.assertEqual(page.run(cut), [])

    def test_expectations_of_a_scenario_are_told(self):
        page = self.open("finsrov")
        rows = "[...document.querySelectorAll('#expectations-table tbody tr')].map(row => [...row.cells].map(c => c.innerText))"
        self.assertEqual(page.run(rows), [["hull depth", "✓ met", "500 ms", "900 ms", "0.9", "1.1", "0.985", "0.9998"]])
        missed = json.loads(self.runs["finsrov"].read_text())
        missed["expectations"][0]["ok"] = False
        run = pathlib.Path(FOLDER.name) / "missed.run.json"
        run.write_text(json.dumps(missed))
        finemote(FINEMOTE, "report", self.robots["finsrov"], "-o", self.page("missed"), "--run", run)
        page = self.open("missed")
        self.assertRegex(page.run("document.querySelector('h1').innerText"), "fails 1 of 1 expectations of the scenario")
        self.assertEqual(page.run(rows)[0][1], "✗ not met")

    def test_hostile_names_change_nothing(self):
        answer = finemote(FINEMOTE, "report", hostile_robot(), "-o", self.page("hostile"))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        for width in (1280, 360):
            page = self.open("hostile", width=width)
            self.assertEqual(page.run("document.documentElement.scrollWidth"), width)
            self.assertEqual(page.run("document.scripts.length"), 2)
            self.assertEqual(page.run("[...document.querySelectorAll('b, i, o, svg svg')].filter(e => e.textContent.includes('>')).length"), 0)
            self.assertEqual(page.run("document.querySelectorAll('o, svg svg').length"), 0)
            self.assertTrue(page.run("document.querySelector('#parts-table').textContent.includes('<svg/onload=x>')"))

    def test_the_body_is_drawn_from_three_sides(self):
        page = self.open("finsrov")
        self.assertEqual(page.run("document.querySelectorAll('#body svg').length"), 3)
        devices = page.run("[...document.querySelectorAll('#parts-table tbody tr')].map(row => row.cells[0].innerText)")
        self.assertEqual(len(devices), 13)
        outside = page.run("""[...document.querySelectorAll('#body svg')].flatMap(svg => {
          const box = svg.getBoundingClientRect();
          return [...svg.querySelectorAll('circle, text')].filter(e => {
            const b = e.getBoundingClientRect();
            return b.left < box.left || b.right > box.right || b.top < box.top || b.bottom > box.bottom;
          }).map(e => e.outerHTML);
        })""")
        self.assertEqual(outside, [])
        overlapping = page.run("""[...document.querySelectorAll('#body svg')].flatMap(svg => {
          const all = [...svg.querySelectorAll('.number')].map(e => [Number(e.getAttribute('cx')), Number(e.getAttribute('cy'))]);
          return all.filter(([x, y], i) => all.some(([u, v], j) => j < i && Math.hypot(x - u, y - v) < 19));
        })""")
        self.assertEqual(overlapping, [])
        crossed = page.run("""[...document.querySelectorAll('#body svg')].flatMap(svg => {
          const number = (e, name) => Number(e.getAttribute(name));
          const shafts = [...svg.querySelectorAll('line.push, line.spin')];
          const nearest = (e, x, y) => Math.min(...[...Array(21).keys()].map(i => i / 20).map(share => Math.hypot(
              x - number(e, 'x1') - share * (number(e, 'x2') - number(e, 'x1')),
              y - number(e, 'y1') - share * (number(e, 'y2') - number(e, 'y1')))));
          return [...svg.querySelectorAll('.number')].filter(e =>
              shafts.some(shaft => nearest(shaft, number(e, 'cx'), number(e, 'cy')) < number(e, 'r') + 2)).map(e => e.outerHTML);
        })""")
        self.assertEqual(crossed, [])

    def test_the_keyboard_reaches_everything(self):
        page = self.open("finsrov")
        reached = []
        for _ in range(60):
            page.press("Tab")
            reached.append(page.run("(e => e.id || e.getAttribute('href') || e.tagName.toLowerCase())(document.activeElement)"))
        for wanted in ("theme", "#chains", "button", "summary", "svg"):
            self.assertIn(wanted, reached)
        page.run("document.querySelector('.chain button').focus()")
        page.press("Enter")
        self.assertEqual(page.run("document.querySelector('.chain button').getAttribute('aria-pressed')"), "true")


# The bytes of a colour, how light it is, and the contrast of two such: WCAG 2.2, relative luminance and contrast ratio.
COLOURS = """
  const canvas = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
  const numbers = (colour) => {
    canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = colour; canvas.fillRect(0, 0, 1, 1);
    return [...canvas.getImageData(0, 0, 1, 1).data];
  };
  const light = ([r, g, b]) => [r, g, b].map((v) => v / 255).map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
      .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
"""

# Texts on the page with too little contrast to what is behind them, as [text, ratio].
CONTRASTS = "(() => {" + COLOURS + """
  const behind = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const colour = numbers(getComputedStyle(e).backgroundColor);
      if (colour[3] === 255) return colour;
    }
    return [255, 255, 255, 255];
  };
  const bad = [];
  for (const element of document.querySelectorAll('body *')) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim() !== '');
    if (!own || !element.checkVisibility() || element.closest('svg') || ['SCRIPT', 'STYLE'].includes(element.tagName)) continue;
    const [a, b] = [light(numbers(getComputedStyle(element).color)), light(behind(element))];
    const ratio = contrast(a, b);
    if (ratio < 4.5) bad.push([element.textContent.slice(0, 30), ratio]);
  }
  return bad;
})()"""

# The same of texts in pictures: how many there are, and those with too little contrast.
PICTURE_CONTRASTS = "(() => {" + COLOURS + """
  const page = getComputedStyle(document.body).backgroundColor;
  const paint = (element) => {
    const style = getComputedStyle(element);
    const isShape = element instanceof SVGElement && element.tagName !== 'svg';
    const colour = isShape ? (style.fill.startsWith('url') ? page : style.fill) : style.backgroundColor;
    if (colour === 'none') return [0, 0, 0, 0];
    const [r, g, b, a] = numbers(colour);
    return [r, g, b, a / 255 * Number(style.opacity)];
  };
  const behind = (text, x, y) => {
    let colour = [0, 0, 0], left = 1;
    for (const element of document.elementsFromPoint(x, y)) {
      if (element === text || text.contains(element) || ['path', 'line'].includes(element.tagName)) continue;
      const [r, g, b, a] = paint(element);
      colour = colour.map((v, i) => v + left * a * [r, g, b][i]);
      left *= 1 - a;
      if (left < 0.01) break;
    }
    return colour;
  };
  const texts = [...document.querySelectorAll('svg text')].filter((text) => text.getBoundingClientRect().width > 0);
  const bad = [];
  for (const text of texts) {
    scrollTo(0, text.getBoundingClientRect().top + scrollY - 300);
    const box = text.getBoundingClientRect();
    const back = light(behind(text, box.left + Math.min(box.width / 2, 12), box.top + box.height / 2));
    for (const own of text.children.length ? text.children : [text]) {
      const ink = light(numbers(getComputedStyle(own).fill));
      const ratio = contrast(ink, back);
      if (ratio < 4.5) bad.push([own.textContent.slice(0, 20), text.getAttribute('class'), ratio]);
    }
  }
  return [texts.length, bad];
})()"""


if __name__ == "__main__":
    if program() is None:
        print("skipped: needs Chromium")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0]], verbosity=2)
