#!/usr/bin/env python3
"""Every result on the page of `finemote report` is that of its document, of all examples and of odd robots.
usage: results_test.py FINEMOTE SOURCE"""
import json
import pathlib
import sys
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

from page_keys import Keys, at, document, finemote, measured

FINEMOTE, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
ROBOT = ('<robot name={name}><link name={link}/><finemote version="1"><board name="robomaster_type_c"/>{buses}'
         '<device name={root} type="group" period="{period}">{devices}</device></finemote></robot>')
HOSTILE = "a<b>c\"d'e&f@title@g" + "x" * 280
LINK = "</script><!--\u0645\u0631\u062d\u0628\u0627<svg/onload=x>'\"&amp; " + "y" * 280


def robot(devices, buses="", period="10ms", name="odd", root="root", link="base"):
    return ROBOT.format(name=quoteattr(name), root=quoteattr(root), link=quoteattr(link), period=period, buses=buses, devices=devices)


def loads(count, wcet=""):
    return "".join(f'<device name="load_{i}" type="sim_load">{wcet}</device>' for i in range(count))


PARTS = '<bus name="esc" type="pwm" port="pwm1"/><bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/>'
DIVER = ('<device name={} type="ms5837" bus="i2c" address="0x76" link={}/><device name="thruster" type="pwm_esc" bus="esc"'
         ' channel="0"/>')
ODD = {
    "alone": robot("").replace('type="group"', 'type="sim_load"'),
    "unschedulable": robot(loads(30, '<wcet update="400us" handle="400us"/>'), period="1ms"),
    "sixty": robot(loads(60)),
    "hostile": robot(DIVER.format(quoteattr("d<i>e\"p'th"), quoteattr(LINK)), PARTS, name=HOSTILE,
                     root="r&o<o>t", link=LINK),
}


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        cls.robots = sorted((SOURCE / "examples").glob("*.urdf"))
        for name, text in ODD.items():
            cls.robots.append(folder / f"{name}.urdf")
            cls.robots[-1].write_text(text)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def page(self, source, *words):
        path = pathlib.Path(self.folder.name) / "page.html"
        answer = finemote(FINEMOTE, "report", source, "-o", path, *words)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return path.read_text()

    def check(self, page, documents):
        keys = Keys(page)
        for key, value, _ in keys.values:
            self.assertEqual(json.loads(value), at(documents, key), key)
        self.assertEqual(keys.bare, [])
        return {key for key, _, _ in keys.values}

    def complete(self, documents, shown):
        """Nothing that was proven or measured is left out."""
        timing = documents["timing"]
        wanted = {f"timing#/chains/{i}/{part}" for i in range(len(timing["chains"]))
                  for part in ("acquire_ns", "decide_ns", "wire_ns", "end_to_end_ns")}
        wanted |= {f"timing#/{list_name}/{i}/{member}" for list_name, member in (
            ("requirements", "slack"), ("requirements", "value"), ("bus_load", "utilization"),
            ("processor", "utilization")) for i in range(len(timing[list_name]))}
        profile = timing["profile"]
        wanted |= {f"timing#/{profile}/devices/{i}/r_minus_ns" for i in range(len(timing[profile]["devices"]))}
        for i in range(len(documents.get("run", {}).get("chains", []))):
            wanted.add(f"run#/chains/{i}/end_to_end/max_ns")
        self.assertEqual(wanted - shown, set())

    def test_results_are_those_of_the_documents(self):
        for source in self.robots:
            with self.subTest(robot=source.name):
                documents = {"timing": document(FINEMOTE, "analyze", source),
                             "simulation": document(FINEMOTE, "simulate", source)}
                shown = self.check(self.page(source), documents)
                self.complete(documents, shown)
                self.assertFalse([key for key in shown if key.startswith("run#")])
                run = pathlib.Path(self.folder.name) / "run.json"
                documents["run"] = measured(documents["timing"])
                run.write_text(json.dumps(documents["run"]))
                shown = self.check(self.page(source, "--run", run), documents)
                self.complete(documents, shown)
                self.assertIn("run#/values/0/values", shown)
                self.assertNotIn("run#/values/1/values", shown)  # it stays: in the table alone
                self.assertIn("run#/values/1/highest", shown)

    def test_odd_robots_are_odd(self):
        sources = {source.stem: source for source in self.robots}
        self.assertEqual(len(document(FINEMOTE, "analyze", sources["alone"])["chains"]), 1)
        self.assertEqual(len(document(FINEMOTE, "analyze", sources["sixty"])["model"]["devices"]), 61)
        self.assertIs(document(FINEMOTE, "analyze", sources["unschedulable"])["schedulable"], False)
        self.assertIn("can miss a deadline", self.page(sources["unschedulable"]))

    def test_names_are_nothing_but_names(self):
        page = self.page(next(source for source in self.robots if source.stem == "hostile"))
        self.assertIn("d&lt;i&gt;e&quot;p", page)
        for raw in ("c\"d'e&f", "<i>", "<o>", "</script><!--", "<svg/onload"):
            self.assertNotIn(raw, page.split('<script type="application/json"')[0], raw)

    def test_a_figure_without_its_key_is_found(self):
        keys = Keys('<p>takes 3 ms</p><td data-key="timing#/x" data-value="1">1 ms</td><td class="word">5 ms</td>')
        self.assertEqual(keys.bare, ["takes 3 ms"])
        self.assertEqual(keys.values, [["timing#/x", "1", "1 ms"]])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]], verbosity=2)
