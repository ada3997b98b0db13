#!/usr/bin/env python3
"""Writes the API pages for device authors, docs/reference/api, from the comments of the headers.

usage: api.py [--dry-run]

Doxygen reads the headers; this turns its XML into Markdown. A public name without a comment is an error. With --dry-run
nothing is written, and the exit status is 1 where a page is not what would be written. 77: that is not known, because Doxygen is
missing, or is not the one of Debian 12, which others need not agree with to the letter.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
RUNTIME = ROOT / "runtime"
FOLDER = ROOT / "docs/reference/api"
FINEMOTE = "include/finemote/"
WIRES = "boards/host/ports/"

# Page, title, headers below runtime/.
PAGES = [
    ("contract", "The device contract", [FINEMOTE + "contract.hpp"]),
    ("time", "Time", [FINEMOTE + "time.hpp"]),
    ("interfaces", "Interfaces", [FINEMOTE + f"interfaces/{name}.hpp" for name in (
        "any", "battery", "button", "imu", "light", "link", "magnetometer", "motor", "pressure", "remote", "servo",
        "sounder", "thruster")]),
    ("uart", "Serial lines", [FINEMOTE + "uart.hpp"]),
    ("slots", "States of a slot", [FINEMOTE + "slot_state.hpp"]),
    ("i2c", "I2C slots", [FINEMOTE + "i2c.hpp"]),
    ("spi", "SPI slots", [FINEMOTE + "spi.hpp"]),
    ("can", "CAN slots", [FINEMOTE + "can.hpp"]),
    ("rs485", "RS-485 slots", [FINEMOTE + "rs485.hpp"]),
    ("pins", "Pins", [FINEMOTE + name for name in ("pwm.hpp", "gpio.hpp", "analog.hpp")]),
    ("latches", "Latches", [FINEMOTE + "latch.hpp", FINEMOTE + "crossing.hpp"]),
    ("faults", "Faults and counters", [FINEMOTE + "fault.hpp", FINEMOTE + "bus_counters.hpp"]),
    ("helpers", "Helpers", [FINEMOTE + name for name in (
        "recent_bytes.hpp", "geometry.hpp", "control/numbers.hpp", "control/step_time.hpp", "control/pid.hpp", "control/attitude.hpp",
        "control/rotation.hpp")]),
    ("bench", "The bench", ["bench/finemote/bench/bench.hpp", "bench/finemote/bench/checks.hpp"] + [
        WIRES + name for name in ("uart_wire.hpp", "i2c_wire.hpp", "spi_wire.hpp", "can_wire.hpp", "pins.hpp",
                                  "i2c_parts.hpp", "h30_part.hpp")]),
    ("ports", "Ports", [FINEMOTE + "ports.hpp", FINEMOTE + "moment.hpp"]),
]
# What names of these kinds mean is said where they are listed.
SELF_EXPLANATORY = {"State", "Command"}
HIDDEN = {"Interface"}
# From this comment to its end a structure of the bench is nobody's business but its port's.
INTERNAL = "// ---- for the port"

DOXYGEN = "1.9.4"
UNKNOWN = 77

DOXYFILE = """
OUTPUT_DIRECTORY = {out}
INPUT = {inputs}
STRIP_FROM_PATH = {root}
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
JAVADOC_AUTOBRIEF = NO
AUTOLINK_SUPPORT = NO
MARKDOWN_SUPPORT = YES
SORT_MEMBER_DOCS = NO
MAX_INITIALIZER_LINES = 1
QUIET = YES
WARNINGS = NO
WARN_IF_INCOMPLETE_DOC = NO
"""


class Api:
    """All that Doxygen knows, by header."""

    def __init__(self, xml):
        self.undocumented = []
        self.compounds = []
        for path in sorted(xml.glob("*.xml")):
            for compound in ElementTree.parse(path).getroot().iter("compounddef"):
                self.compounds.append(compound)

    def of_header(self, header):
        """Classes and members of namespaces, in the order of the header."""
        found = []
        for compound in self.compounds:
            kind = compound.get("kind")
            is_public = compound.get("prot") == "public" and "::detail::" not in compound.findtext("compoundname")
            if kind in ("class", "struct") and is_public and is_in(compound, header):
                found.append(compound)
            if kind == "namespace" and not compound.findtext("compoundname").endswith("detail"):
                found += [member for member in compound.iter("memberdef") if is_in(member, header)]
        return sorted(found, key=line_of)


def is_in(element, header):
    location = element.find("location")
    return location is not None and location.get("file") == "runtime/" + header


def line_of(element):
    return int(element.find("location").get("line"))


def plain(element):
    """The text of an element without its markup."""
    return re.sub(r"\s+", " ", "".join(element.itertext())).strip() if element is not None else ""


def inline(element):
    """Text with code in backticks."""
    text = element.text or ""
    for child in element:
        if child.tag == "computeroutput":
            text += "`" + plain(child) + "`"
        elif child.tag not in ("parameterlist", "simplesect", "programlisting"):
            text += inline(child)
        text += child.tail or ""
    return text


def clean(text):
    text = re.sub(r"\s+", " ", text).strip()
    return text.replace("*", r"\*").replace("<", "&lt;").replace("|", r"\|")


def paragraphs(element):
    """The description: brief, then details, without the parameters."""
    texts = []
    for part in ("briefdescription", "detaileddescription"):
        for paragraph in element.findall(f"{part}/para"):
            texts.append(clean(inline(paragraph)))
    return [text for text in texts if text]


def parameters(element):
    for item in element.findall("detaileddescription/para/parameterlist/parameteritem"):
        name = plain(item.find("parameternamelist"))
        yield name, clean(inline(item.find("parameterdescription/para")))


def is_described(element):
    return bool(paragraphs(element)) or any(True for _ in parameters(element))


def code(text):
    """A declaration as our headers write it."""
    text = re.sub(r"\s+", " ", text).replace("( ", "(").replace(" )", ")").replace("< ", "<").replace(" >", ">")
    text = re.sub(r" ?([&*]+) ?(?=\w)", r"\1 ", text)
    text = re.sub(r" ?\(([&*]) (\w+)\)\[", r" (\1\2)[", text)
    return re.sub(r"(?<=[\w)])=(?=[\w{\"])", " = ", text)


def template_of(element):
    names = element.find("templateparamlist")
    if names is None:
        return ""
    words = []
    for parameter in names.findall("param"):
        default = plain(parameter.find("defval"))
        words.append(plain(parameter.find("type")) + " " + plain(parameter.find("declname")) +
                     (" = " + default if default else ""))
    return "template <" + ", ".join(word.strip() for word in words) + ">\n"


def declaration(member):
    kind, name = member.get("kind"), member.findtext("name")
    if kind == "typedef":
        return "using " + name + " = " + code(plain(member.find("type"))) + ";"
    value = plain(member.find("initializer"))
    if kind == "variable":
        return code(plain(member.find("type")) + " " + name + plain(member.find("argsstring"))) + (
            " " + value if value else "") + ";"
    kept = plain(member.find("type"))
    static = "static " if member.get("static") == "yes" and not kept.startswith("static") else ""
    return template_of(member) + code(static + kept + " " + name + plain(member.find("argsstring"))).strip() + ";"


def sentence(text):
    """As a paragraph of its own: comments behind a declaration begin and end like parts of a sentence."""
    return text[0].upper() + text[1:] + ("" if text.endswith((".", ":", "!", "?")) else ".")


def described(member):
    lines = [sentence(text) + "\n" for text in paragraphs(member)]
    lines += [f"- `{name}`: {text}" for name, text in parameters(member)]
    return "\n".join(lines).rstrip() + "\n"


def enumeration(member, level):
    text = f"{level} `{member.findtext('name')}`\n\n" + described(member) + "\n| value | |\n|---|---|\n"
    for value in member.findall("enumvalue"):
        number = plain(value.find("initializer"))
        text += f"| `{value.findtext('name')}{' ' + number if number else ''}` | {' '.join(paragraphs(value))} |\n"
    return text


def fields(members):
    text = "| member | |\n|---|---|\n"
    for member in members:
        text += f"| `{declaration(member).rstrip(';')}` | {' '.join(paragraphs(member))} |\n"
    return text


class Page:
    """What a header says, as Markdown."""

    def __init__(self, api, header):
        self.api = api
        self.header = header
        self.lines = (RUNTIME / header).read_text().splitlines()
        self.internal = set()
        is_internal = False
        for number, line in enumerate(self.lines, 1):
            is_internal = (is_internal or INTERNAL in line) and line != "};"
            if is_internal:
                self.internal.add(number)

    def introduction(self):
        """The comment that the header begins with."""
        words = []
        is_list = False
        for line in self.lines:
            if not line.startswith("//"):
                break
            was_list, is_list = is_list, line.startswith(("//   -", "//     "))
            if was_list != is_list:
                words.append("")
            words.append(line[5:] if is_list else line[2:].strip())
        return re.sub(r"\n{3,}", "\n\n", "\n".join(words))

    def include(self):
        """What a user writes: the headers of wires and parts come with two of the bench."""
        if self.header.startswith(WIRES):
            return "finemote/bench/" + ("parts.hpp" if self.header.endswith(("parts.hpp", "part.hpp")) else "bench.hpp")
        return self.header.removeprefix("include/").removeprefix("bench/")

    def text(self, level):
        text = self.introduction() + "\n\n```cpp\n#include <" + self.include() + ">\n```\n"
        pending = []
        for element in self.api.of_header(self.header):
            if line_of(element) in self.internal:
                continue
            if element.tag == "memberdef" and element.get("kind") in ("variable", "typedef"):
                pending.append(self.checked(element))
                continue
            text += self.table(pending)
            pending = []
            if element.tag == "compounddef":
                text += "\n" + self.compound(element, level)
            elif element.get("kind") == "enum":
                text += "\n" + enumeration(self.checked(element), level)
            elif element.get("kind") == "function":
                text += "\n" + self.function(element)
        return text + self.table(pending)

    def table(self, members):
        return "\n" + fields(members) if members else ""

    def function(self, member):
        return "```cpp\n" + declaration(self.checked(member)) + "\n```\n\n" + described(member)

    def compound(self, compound, level):
        """A class or structure: its values in a table, then types and functions."""
        name = compound.findtext("compoundname").removeprefix("finemote::").replace("< ", "<").replace(" >", ">")
        text = f"{level} `{name}`\n\n" + described(self.checked(compound))
        members = sorted((m for m in compound.iter("memberdef") if self.is_shown(m)), key=line_of)
        variables = [self.checked(m) for m in members if m.get("kind") in ("variable", "typedef")]
        text += self.table(variables)
        for member in members:
            if member.get("kind") == "enum":
                text += "\n" + enumeration(self.checked(member), level + "#")
            if member.get("kind") == "function":
                text += "\n" + self.function(member)
        return text

    def is_shown(self, member):
        """Public, and not what every class has."""
        if member.get("prot") != "public" or not is_in(member, self.header) or line_of(member) in self.internal:
            return False
        name = member.findtext("name")
        arguments = (member.findtext("argsstring") or "").replace(" ", "")
        return name not in HIDDEN and not name.startswith("~") and not arguments.endswith(("=default", "=delete"))

    def checked(self, element):
        """The element; noted where it has no comment."""
        name = element.findtext("name") or element.findtext("compoundname")
        if name not in SELF_EXPLANATORY and not is_described(element):
            self.api.undocumented.append(f"{RUNTIME / self.header}:{line_of(element)}: '{name}' has no comment")
        return element


def page_text(api, title, headers):
    text = f"# {title}\n\n<!-- made by ./dev docs from the comments of the headers -->\n"
    for header in headers:
        page = Page(api, header)
        if len(headers) > 1:
            text += f"\n## {pathlib.Path(header).name}\n"
        text += "\n" + page.text("###" if len(headers) > 1 else "##")
    return text


def read_headers(folder):
    headers = [str(RUNTIME / header) for _, _, headers in PAGES for header in headers]
    (folder / "Doxyfile").write_text(DOXYFILE.format(out=folder, root=ROOT, inputs=" ".join(headers)))
    subprocess.run(["doxygen", str(folder / "Doxyfile")], check=True, stdout=subprocess.DEVNULL)
    return Api(folder / "xml")


def doxygen_version():
    """Empty where there is none."""
    if shutil.which("doxygen") is None:
        return ""
    return subprocess.run(["doxygen", "--version"], check=True, capture_output=True, text=True).stdout.split()[0]


def main(words):
    version = doxygen_version()
    if not version:
        print("doxygen is missing: apt-get install doxygen")
        return UNKNOWN if "--dry-run" in words else 2
    with tempfile.TemporaryDirectory() as name:
        api = read_headers(pathlib.Path(name))
    status = 0
    for page, title, headers in PAGES:
        path = FOLDER / f"{page}.md"
        text = page_text(api, title, headers)
        if path.exists() and path.read_text() == text:
            continue
        print(("stale: " if "--dry-run" in words else "written: ") + str(path.relative_to(ROOT)))
        if "--dry-run" in words:
            status = 1
        else:
            path.write_text(text)
    for line in api.undocumented:
        print(line)
    if status == 1 and version != DOXYGEN and not api.undocumented:
        print(f"the pages were made with Doxygen {DOXYGEN}; this is {version}")
        return UNKNOWN
    return 1 if api.undocumented else status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
