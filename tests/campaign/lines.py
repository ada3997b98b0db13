"""What can come over the serial line of a device: pieces that its parser knows, whole, damaged and too many of them."""

import re
import struct

#: Bytes of one draw at most: more than a parser takes in a period.
MOST_BYTES = 1800

_H30_HEADS, _LINK_HEADS = b"\x59\x53", b"\xa5\x5a"
_H30_TYPES = (0x10, 0x20, 0x40)  # acceleration, rates, angles
_LINK_LONGEST = 117


def some_bytes(draw, most=30):
    return draw.randbytes(draw.randint(1, most))


# ---- h30_imu


def h30_frame(records, is_good=True):
    """records: pairs of type and data."""
    payload = b"".join(bytes((kind, len(data))) + data for kind, data in records)
    body = b"\x00\x00" + bytes((len(payload) & 0xFF,)) + payload
    sum1 = sum2 = 0
    for byte in body:
        sum1 += byte
        sum2 += sum1
    return _H30_HEADS + body + bytes((sum1 & 0xFF, sum2 + (not is_good) & 0xFF))


def h30_vector(draw):
    return struct.pack("<3i", *(draw.choice((0, 1, -1, draw.randint(-90_000_000, 90_000_000))) for _ in range(3)))


def h30_piece(draw):
    known = [(kind, h30_vector(draw)) for kind in _H30_TYPES]
    others = [(draw.choice((0x41, 0x50, 0x51)), draw.randbytes(draw.choice((0, 0, 1, 12)))) for _ in range(draw.randint(0, 9))]
    draw.shuffle(known)
    return draw.choice((
        lambda: h30_frame(known),
        lambda: h30_frame(others + known),
        lambda: h30_frame(known + others, draw.random() < 0.5),
        lambda: h30_frame([(0x50, draw.randbytes(84))], draw.random() < 0.5),
        lambda: h30_frame(known)[:draw.randint(1, 48)],
        lambda: _H30_HEADS * draw.randint(1, 20),
        lambda: (_H30_HEADS + b"\x00\x00" + bytes((draw.choice((draw.randint(0, 0x5A), 0x58)),))) * draw.randint(1, 9),
    ))()


# ---- remote controls


def with_channels(values):
    """Eleven bits each, the least significant first."""
    bits = sum((value & 0x7FF) << 11 * place for place, value in enumerate(values))
    return bits.to_bytes((11 * len(values) + 7) // 8, "little")


def dr16_piece(draw):
    sticks = with_channels([draw.choice((364, 1024, 1684, draw.randint(300, 1750))) for _ in range(4)])
    switches = bytes((sticks[5] & 0x0F | draw.randint(1, 3) << 6 | draw.randint(1, 3) << 4,))
    frame = sticks[:5] + switches + draw.randbytes(6) + bytes((draw.randint(0, 1), draw.randint(0, 1))) + draw.randbytes(2)
    frame += struct.pack("<H", draw.choice((0, 364, 1024, 1684)))
    return draw.choice((frame, frame, frame[:draw.randint(1, 17)], frame + b"\x00", frame * draw.randint(2, 8)))


def sbus_piece(draw):
    channels = with_channels([draw.choice((172, 992, 1811, draw.randint(0, 2047))) for _ in range(16)])
    tail = draw.choice((0x00, 0x00, 0x04, 0x14, 0x24, 0x34, 0x55))
    frame = b"\x0f" + channels + bytes((draw.choice((0, 0, 0, 4, 8, 12)), tail))
    return draw.choice((frame, frame, frame[:draw.randint(1, 24)], b"\x0f" * draw.randint(1, 60), frame * draw.randint(2, 8)))


# ---- host_link


class LinkLayout:
    """What the generated files say of commands that come down: number of the layout, and sizes of the blocks."""

    SIZES = {"Bool": 1, "U8": 1, "I16": 2, "U16": 2, "I32": 4, "U32": 4, "F32": 4, "I64": 8}

    def __init__(self, text):
        self.number = int(re.search(r"LinkLayout \w+\{0x([0-9a-f]+)", text)[1], 16)
        fields = {name: 1 + sum(self.SIZES[kind] for kind in re.findall(r"LinkKind::k(\w+)>", body))
                  for name, body in re.findall(r"LinkSlot (\w+_down_\d+)\[\] = \{(.*?)\n\};", text, re.DOTALL)}
        self.sizes = {}
        for name, block in re.findall(r"(\w+_down_\d+), /\*block\*/ (\d+)", text):
            self.sizes[int(block)] = self.sizes.get(int(block), 0) + fields[name]

    @staticmethod
    def of_folder(generated):
        """Of the first link among the generated files; None: there is none."""
        for header in sorted(generated.glob("trees/*.hpp")):
            text = header.read_text(encoding="utf-8")
            if "LinkLayout" in text:
                return LinkLayout(text)
        return None


def crc16(data):
    """Polynomial x^16 + x^12 + x^5 + 1, from all ones on."""
    value = 0xFFFF
    for byte in data:
        value ^= byte << 8
        for _ in range(8):
            value = (value << 1 ^ (0x1021 if value & 0x8000 else 0)) & 0xFFFF
    return value


def link_frame(layout, block, payload, is_good=True):
    body = bytes((0x20 | block, len(payload))) + struct.pack("<I", layout) + b"\x00" + payload
    return _LINK_HEADS + body + struct.pack("<H", crc16(body) ^ (not is_good))


def link_piece(draw, layout):
    block = draw.choice(sorted(layout.sizes) or [0])
    payload = b"".join(b"\x01" + struct.pack("<f", draw.uniform(-1, 1)) for _ in range(24))
    ours, foreign = payload[:layout.sizes.get(block, 5)], draw.randbytes(_LINK_LONGEST)
    return draw.choice((
        lambda: link_frame(layout.number, block, ours),
        lambda: link_frame(layout.number, block, ours) * draw.randint(2, 8),
        lambda: link_frame(layout.number, block, ours, False),
        lambda: link_frame(layout.number ^ 1, 0, foreign, draw.random() < 0.5),
        lambda: link_frame(layout.number, block, ours)[:draw.randint(1, 20)],
        lambda: _LINK_HEADS * draw.randint(1, 20),
        lambda: (_LINK_HEADS + bytes((0x20, draw.choice((draw.randint(0, _LINK_LONGEST + 1), _LINK_LONGEST))))
                 + struct.pack("<I", draw.choice((layout.number, 0)))) * draw.randint(1, 9),
    ))()


# ---- finsrov

_WORDS = ("ON", "OFF", "ACL:ON", "ACL:OF", "UP", "DN", "W", "S", "A", "D", "Q", "E", "Z", "VA", "CA", "RPY:ON", "RPY:OFF",
          "BEG", "END", "IVA")
_LONGEST_MESSAGE = 100


def numbers(draw, count):
    values = (0, 1, 1500, 1900, 32767, -32767, "0001500", "-0001500")
    return ",".join(str(draw.choice((*values, draw.randint(-40000, 40000)))) for _ in range(count))


def order(draw):
    return draw.choice((
        lambda: draw.choice(_WORDS),
        lambda: "H:" + numbers(draw, 1),
        lambda: "ANG:" + numbers(draw, 1),
        lambda: "MOT:" + numbers(draw, 4),
        lambda: "TES:" + numbers(draw, 8),
        lambda: " " * draw.randint(1, 9),
        lambda: draw.choice(_WORDS) + "\r\n",
    ))()


def finsrov_piece(draw):
    """A message that is not too long; one that is is dropped."""
    message = ""
    for _ in range(draw.randint(1, 9)):
        more = order(draw)
        if len(message) + len(more) <= _LONGEST_MESSAGE:
            message += more
    return message.encode()


# ---- any of them

PIECES = {"h30_imu": h30_piece, "dr16": dr16_piece, "sbus": sbus_piece, "finsrov": finsrov_piece}


class Line:
    """Draws what comes over the line of a device of this type; layout: of a host_link, else None."""

    def __init__(self, kind, layout):
        self.kind, self.layout = kind, layout

    def piece(self, draw):
        if draw.random() < 0.1:
            return some_bytes(draw)
        if self.kind == "host_link" and self.layout is not None:
            return link_piece(draw, self.layout)
        return PIECES[self.kind](draw) if self.kind in PIECES else some_bytes(draw)

    def draw(self, draw):
        return b"".join(self.piece(draw) for _ in range(draw.choice((1, 1, 2, 4, 8))))[:MOST_BYTES]

    def mutated(self, data, draw):
        begin = draw.randint(0, len(data))
        end = min(len(data), begin + draw.randint(1, 40))
        return draw.choice((
            lambda: data[:begin] + self.piece(draw) + data[begin:],
            lambda: data[:begin] + self.piece(draw) + data[end:],
            lambda: data + self.piece(draw),
            lambda: data[:begin] + data[end:],
            lambda: data[:end] + data[begin:end] + data[end:],
            lambda: data + data,
            lambda: data[:begin] + draw.randbytes(1) + data[begin + 1:],
        ))()[:MOST_BYTES]


def as_events(port, at_ns, data):
    """Floods of the port, byte by byte, those that are the same in one."""
    for number, run in enumerate(re.finditer(rb"(?s)(.)\1*", data)):
        yield {"t_ns": at_ns + number, "port": port, "do": "flood", "byte": run[0][0], "bytes": len(run[0])}
