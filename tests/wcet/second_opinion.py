"""A second opinion on bounds of functions: from the text of a disassembler, and costs of its own.

    second_opinion.py --finemote PROGRAM --bounds FUNCTION_BOUNDS [--objdump OBJDUMP] ROBOT

It compiles the robot, which has to run its code from SRAM, and compares all functions of the image that it can bound. It
follows no values: every way through a function counts, and every pointer but the stack's leads to the slowest memory that a
variable can be in. So its bound is never below one that leaves ways out, and equal where there are none to leave out. Loops,
jumps through tables and functions that hold the address of a peripheral are refused; calls are added with the bound of the
callee. Exit status 1 where the tool's bound is above the second opinion, or fewer than two dozen functions have the same.

Sources of its costs: Arm DDI 0439D tables 3-1 and 7-1, AN4031 table 5.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

REFILL, ADDRESS = 3, 1
CODE_MEMORY = 2  # a literal or a word behind a pointer: arbitration, and the fetch
ONE = set("""adc add addw adr and asr bfc bfi bic clz cmn cmp eor lsl lsr mla mls mov movt movw mul mvn neg nop orn orr rbit rev
rev16 revsh ror rrx rsb sbc sbfx smlal smull smulbb smlabb ssat sub subw sxtab sxtah sxtb sxth teq tst ubfx umaal umlal
umull usat uxtab uxtah uxtb uxth it itt ite ittt itte itet itee itttt ittte ittet ittee itett itete iteet iteee b bl bx blx
cbz cbnz""".split())
FLOAT = {"vadd", "vsub", "vmul", "vnmul", "vcvt", "vcvtr", "vabs", "vneg", "vcmp", "vcmpe", "vmov", "vmrs", "vmsr"}
FUSED = {"vmla", "vmls", "vnmla", "vnmls", "vfma", "vfms", "vfnma", "vfnms"}
CONDITIONS = "eq ne cs hs cc lo mi pl vs vc hi ls ge lt gt le".split()
ENOUGH = 24
PERIPHERALS, CORE = 0x4000_0000, 0xE000_0000
FLOATS = 0x4003_0000  # up to it all of them lie, and above it what may be a floating-point constant
#: Where the tool's bound is the higher one, and why.
EXPLAINED = {
    "__udivmoddi4": "a pointer comes on the stack, as an argument: the tool lets it lead anywhere",
    "_ZNK8finemote12UartHardware5driveEb": "the address of a register, computed from a byte: its bus is the tool's knowledge",
    "_ZNK8finemote7I2cPort10lines_freeEv": "the address of a register, computed from a byte: its bus is the tool's knowledge",
}
LINE = re.compile(r"^\s*([0-9a-f]+):\t([0-9a-f ]+?)\s*\t(\S+)(?:\t(.*))?$")


class Instruction:
    def __init__(self, match):
        self.address = int(match[1], 16)
        self.size = len(match[2].replace(" ", "")) // 2
        self.name, self.operands = match[3].removesuffix(".n").removesuffix(".w"), (match[4] or "").split(" @")[0].split("\t@")[0].strip()
        self.name, self.comment = self.name.split(".")[0], match[4] or ""

    def bare(self):
        """Without condition and S."""
        name = self.name
        if name in ONE or name in FLOAT or name in FUSED:
            return name
        for end in CONDITIONS:
            if name.endswith(end) and len(name) > len(end):
                shorter = name[: -len(end)]
                if known(shorter) or known(shorter.removesuffix("s")):
                    name = shorter
                    break
        return name if known(name) else name.removesuffix("s")

    def registers(self):
        inside = re.search(r"\{(.*)\}", self.operands)
        count = 0
        for part in inside[1].replace(" ", "").split(","):
            ends = part.split("-")
            numbers = [int(re.sub(r"\D", "", end) or 0) for end in ends]
            words = 2 if part.startswith("d") else 1
            count += words * (numbers[-1] - numbers[0] + 1 if len(ends) == 2 else 1)
        return count

    def to_stack(self):
        return "sp" in self.operands.split("[")[-1] if "[" in self.operands else self.operands.startswith("sp")

    def memory(self, words):
        return 0 if self.to_stack() else CODE_MEMORY * words

    def unaligned(self, name):
        """What a word or halfword costs besides where nobody knows whether it is aligned: two or one further accesses."""
        if self.to_stack() or "pc" in self.operands or name.endswith("b"):
            return 0
        return (1 if name.endswith("h") else 2) * (1 + self.memory(1))

    def cycles(self):
        name = self.bare()
        odd = 1 if self.size == 4 and self.address % 4 == 2 else 0
        if name in ("sdiv", "udiv"):
            return odd + 12
        if name in ("vdiv", "vsqrt"):
            return odd + 15
        if name in FUSED:
            return odd + 4
        if name in FLOAT:
            return odd + 2
        if name in ONE:
            return odd + 1
        if name in ("push", "pop", "vpush", "vpop"):
            return odd + 1 + self.registers() + ADDRESS
        if name.startswith(("ldm", "stm", "vldm", "vstm")):
            count = self.registers()
            return odd + 1 + count + ADDRESS + self.memory(count)
        if name in ("ldrd", "strd"):
            return odd + 3 + ADDRESS + self.memory(2)
        if name in ("vldr", "vstr"):
            words = 2 if self.operands.startswith("d") else 1
            return odd + 1 + words + ADDRESS + self.memory(words)
        if re.fullmatch(r"(ldr|str)(s?[bh])?", name):
            return odd + 2 + ADDRESS + self.memory(1) + self.unaligned(name)
        raise ValueError(f"no cost of '{self.name} {self.operands}' at {self.address:#x}")


def known(name):
    return (name in ONE or name in FLOAT or name in FUSED or name in ("sdiv", "udiv", "vdiv", "vsqrt", "push", "pop", "vpush", "vpop")
            or re.fullmatch(r"v?(ldm|stm)(ia|db)?|ldrd|strd|vldr|vstr|(ldr|str)(s?[bh])?", name) is not None)


class Image:
    def __init__(self, objdump, elf):
        text = subprocess.run([objdump, "-d", elf], capture_output=True, text=True, check=True).stdout
        self.code, self.entries, self.names, self.words = {}, {}, {}, {}
        for line in text.splitlines():
            if head := re.match(r"^([0-9a-f]+) <(.*)>:$", line):
                self.entries[head[2]] = int(head[1], 16)
                self.names[int(head[1], 16)] = head[2]
            elif (match := LINE.match(line)) and match[3] == ".word":
                self.words[int(match[1], 16)] = int(match[4].split()[0], 16)
            elif match and not match[3].startswith("."):
                instruction = Instruction(match)
                self.code[instruction.address] = instruction
        self.bounds = {}

    def bound(self, entry):
        """Longest way from an entry to a return: the graph has no cycles, so the program's optimum is that of its parts."""
        if entry not in self.bounds:
            self.bounds[entry] = None  # open
            self.bounds[entry] = self.longest(entry, {}, 0)
        if self.bounds[entry] is None:
            raise ValueError("recursion")
        return self.bounds[entry]

    def longest(self, start, known_ways, condition):
        """Iterative: post-order over places; a place is an address and how many instructions of an IT block are left."""
        opened, stack = set(), [(start, condition)]
        while stack:
            place = stack[-1]
            if place in known_ways:
                stack.pop()
                continue
            ways = self.ways(*place)
            missing = [to for _, to in ways if to is not None and to not in known_ways]
            if missing:
                if place in opened:
                    raise ValueError(f"a loop at {place[0]:#x}")
                opened.add(place)
                if any(to in opened for to in missing):
                    raise ValueError(f"a loop at {place[0]:#x}")
                stack.extend(missing)
                continue
            known_ways[place] = max(cost + (known_ways[to] if to is not None else 0) for cost, to in ways)
            stack.pop()
        return known_ways[start, condition]

    def check_constant(self, i):
        """What is above all RAM is a register of a peripheral, whose bus a disassembly does not tell."""
        literal = re.search(r"@ \(([0-9a-f]+) ", i.comment)
        value = self.words.get(int(literal[1], 16), 0) if literal else 0
        if i.name == "movt":
            value = int(i.operands.split("#")[1].split()[0], 0) << 16
        if value >= PERIPHERALS and (value < FLOATS or value >= CORE):
            raise ValueError(f"the address of a peripheral at {i.address:#x}")

    def ways(self, address, left):
        """Cost and place of all that can follow; None: it returns."""
        i = self.code[address]
        self.check_constant(i)
        name, cost, behind = i.bare(), i.cycles(), (address + i.size, max(0, left - 1))
        if name.startswith("it") and name in ONE:
            return [(cost, (address + i.size, len(name) - 1))]
        skipped = [(1 + (1 if i.size == 4 and address % 4 == 2 else 0), behind)] if left else []
        target = re.match(r"(?:\S+, )?([0-9a-f]+) <", i.operands)
        if name in ("cbz", "cbnz"):
            return [(cost, behind), (cost + REFILL, (int(target[1], 16), 0))]
        if name == "bl":
            callee = self.bound(int(target[1], 16))
            return [(cost + REFILL + callee + REFILL, behind), *skipped]
        if name == "b":
            to = int(target[1], 16)
            taken = [(cost + REFILL + self.bound(to), None)] if self.is_other(address, to) else [(cost + REFILL, (to, 0))]
            conditional = i.name != "b" and not left
            return taken + ([(cost, behind)] if conditional else []) + skipped
        if (name == "bx" and i.operands == "lr") or (name in ("pop", "ldm", "ldmia") and "pc" in i.operands.split("{")[1]):
            return [(cost, None), *skipped]
        if name in ("bx", "blx", "tbb", "tbh") or i.operands.startswith("pc,"):
            raise ValueError(f"'{i.name} {i.operands}' goes anywhere")
        return [(cost, behind)] if not left else [(max(cost, 1), behind)]

    def is_other(self, here, there):
        """A jump into another function: its return is that of this one."""
        begins = [entry for entry in self.names if entry <= here]
        first = max(begins)
        last = min((entry for entry in self.names if entry > here), default=1 << 32)
        return not first <= there < last


def compiled(finemote, robot, folder):
    words = [finemote, "run", robot, "--duration", "1ms", "--keep", folder]
    subprocess.run(words, capture_output=True, check=False)  # whether it did well in that time does not matter here
    return next(pathlib.Path(folder).rglob("firmware.elf"))


def compare(bounds, image, elf):
    """Numbers of functions with the same bound, with a lower one, and with a higher one."""
    told = subprocess.run([bounds, elf, *image.entries], capture_output=True, text=True, check=True).stdout
    tool = {name: int(cycles) for name, cycles in (line.split(" ", 1) for line in told.splitlines()) if cycles.isdigit()}
    same = lower = higher = 0
    for name, first in sorted(tool.items()):
        try:
            second = image.bound(image.entries[name])
        except ValueError as reason:
            print(f"{name}: {first}, no second opinion: {reason}")
            continue
        why = EXPLAINED.get(name) if first > second else None
        same, lower, higher = same + (first == second), lower + (first < second), higher + (first > second and why is None)
        print(f"{name}: {first} by the tool, {second} by the second opinion{f' ({why})' if why else ' WRONG' * (first > second)}")
    return same, lower, higher


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--finemote", required=True)
    parser.add_argument("--bounds", required=True)
    parser.add_argument("--objdump", default="arm-none-eabi-objdump")
    parser.add_argument("robot")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        elf = compiled(arguments.finemote, arguments.robot, folder)
        same, lower, higher = compare(arguments.bounds, Image(arguments.objdump, elf), elf)
    print(f"{same} bounds are the same, {lower} lower as they leave ways out, {higher} higher")
    sys.exit(1 if higher or same < ENOUGH else 0)


if __name__ == "__main__":
    main()
