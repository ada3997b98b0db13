"""Draws robots: sensors, actuators and loads of the shipped types, on buses of the board as they happen to fit.

The same seed draws the same robots. A robot is a list of parts that can be left out one by one, so that a broken bound
can be shown on the smallest robot that breaks it.
"""

import pathlib
import random
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHIPPED = tuple(
    ROOT / path
    for path in (
        "examples/infantry.urdf",
        "examples/six_joint_arm.urdf",
        "examples/finsrov.urdf",
        "tests/emulator/robots/crane.urdf",
        "tests/emulator/robots/rover.urdf",
        "tests/emulator/robots/rig.urdf",
    )
)
PERIODS_US = (500, 1000, 2000, 2500, 4000, 5000, 7000, 8000, 10000, 13000, 20000, 25000, 50000)
PWM_HEADERS = tuple(f"pwm{i}" for i in range(1, 8))


class Part:
    """A device with the buses it needs and, where it has some, its children."""

    def __init__(self, kind, name, attributes, period_us, body=(), children=()):
        self.kind, self.name, self.attributes = kind, name, attributes
        self.period_us = period_us
        self.body, self.children = list(body), list(children)

    def lines(self, indent):
        pad = "  " * indent
        attributes = "".join(f' {key}="{value}"' for key, value in self.attributes.items())
        head = f'{pad}<device name="{self.name}" type="{self.kind}" period="{self.period_us}us"{attributes}'
        inner = [f"{pad}  {line}" for line in self.body]
        for child in self.children:
            inner += child.lines(indent + 1)
        return [head + ">"] + inner + [f"{pad}</device>"] if inner else [head + "/>"]

    def walk(self):
        yield self
        for child in self.children:
            yield from child.walk()


class Robot:
    """Buses, expanders and trees; `load` scales the work of all loads."""

    def __init__(self, name, tick_us):
        self.name, self.tick_us = name, tick_us
        self.buses, self.expanders, self.trees = [], [], []
        self.load = 1.0

    def parts(self):
        for tree in self.trees:
            yield from tree.walk()

    def text(self):
        lines = [f'<robot name="{self.name}"><link name="base"/>', '<finemote version="1">']
        lines.append(f'  <board name="robomaster_type_c" tick="{self.tick_us}us"/>')
        used = " ".join(f'{part.attributes.get("bus", "")} {" ".join(part.body)}' for part in self.parts())
        used += " " + " ".join(self.expanders)
        for name, line in self.buses:
            if f"{name}" in used.replace('"', " ").split():
                lines.append("  " + line)
        for line in self.expanders:
            lines.append("  " + line)
        for tree in self.trees:
            lines += tree.lines(1)
        lines += ["</finemote></robot>", ""]
        return "\n".join(lines)


class Workshop:
    """What a board has left."""

    def __init__(self, draw):
        self.draw = draw
        self.serial = ["usart1", "usart3", "usart6"]
        self.frame_periods = {}  # by port and frame of four: motors that share a frame share their period
        self.pwm = list(PWM_HEADERS)
        self.lights = ["led_red", "led_green", "led_blue"]
        self.ids = {"can1": set(range(1, 9)), "can2": set(range(1, 9))}
        self.feedback = {"can1": set(), "can2": set()}
        self.once = {"bmi088", "ist8310", "buzzer", "key", "battery"}
        self.count = 0
        self.buses, self.expanders = [], []
        self.i2c, self.servos, self.channels = None, None, list(range(16))
        self.depth = 0

    def name(self, kind):
        self.count += 1
        return f"{kind}_{self.count}"

    def bus(self, name, line):
        if (name, line) not in self.buses:
            self.buses.append((name, line))
        return name

    def user_i2c(self):
        if self.i2c is None:
            self.i2c = self.draw.choice((100, 200, 400))
        return self.bus("wire", f'<bus name="wire" type="i2c" port="i2c2" clock="{self.i2c}kHz"/>')

    def servo_output(self):
        """A pulse output: a header, or a channel of an expander on the user's bus."""
        if self.servos is None:
            self.servos = self.draw.random() < 0.5
            if self.servos:
                bus = self.user_i2c()
                self.expanders.append(f'<expander name="servos" model="pca9685" bus="{bus}" address="0x40"/>')
        if self.servos and self.channels and self.draw.random() < 0.7:
            channel = self.draw.choice(self.channels)
            self.channels.remove(channel)
            return {"bus": "servos", "channel": channel}
        if not self.pwm:
            return None
        port = self.pwm.pop(self.draw.randrange(len(self.pwm)))
        return {"bus": self.bus(f"out_{port}", f'<bus name="out_{port}" type="pwm" port="{port}"/>')}


def period(draw, tick_us, most=50000, least=0):
    fitting = [p for p in PERIODS_US if p % tick_us == 0 and least <= p <= most]
    return draw.choice(fitting)


# ---- sensors and actuators; each returns a part, or None where the board has no place left


def serial_sensor(kind, baud, most):
    def make(shop, tick):
        inverted = kind in ("dr16", "sbus")  # one port of the board has an inverter, and only receives
        ports = [p for p in shop.serial if (p == "usart3") == inverted]
        if not ports:
            return None
        port = shop.draw.choice(ports)
        shop.serial.remove(port)
        rate = shop.draw.choice(baud)
        bus = shop.bus(f"line_{port}", f'<bus name="line_{port}" type="uart" port="{port}" baud="{rate}baud"/>')
        return Part(kind, shop.name(kind), {"bus": bus}, period(shop.draw, tick, most))

    return make


def motor(kind):
    def make(shop, tick):
        port = shop.draw.choice(("can1", "can2"))
        free = sorted(shop.ids[port] if kind != "dji_gm6020" else shop.ids[port] & set(range(1, 5)))
        base = 0x204 if kind == "dji_gm6020" else 0x200
        free = [i for i in free if base + i not in shop.feedback[port]]
        if not free or len(shop.feedback[port]) >= 6:
            return None
        number = shop.draw.choice(free)
        shop.ids[port].discard(number)
        shop.feedback[port].add(base + number)
        bus = shop.bus(port, f'<bus name="{port}" type="can" port="{port}" bitrate="1Mbit/s"/>')
        frame = (port, kind == "dji_gm6020", number <= 4)
        own = shop.frame_periods.setdefault(frame, period(shop.draw, tick, 10000))
        return Part(kind, shop.name(kind), {"bus": bus, "id": number}, own)

    return make


def bmi088(shop, tick):
    if "bmi088" not in shop.once:
        return None
    shop.once.discard("bmi088")
    shop.bus("spi", '<bus name="spi" type="spi" port="spi1" clock="5250kHz"/>')
    body = ['<use role="gyro" bus="spi" channel="1"/>']
    if shop.draw.random() < 0.5:
        body.append('<use role="ready" pin="bmi088_int_gyro"/>')
    return Part("bmi088", shop.name("bmi088"), {"bus": "spi", "channel": 0}, period(shop.draw, tick, 5000), body)


def ist8310(shop, tick):
    if "ist8310" not in shop.once:
        return None
    shop.once.discard("ist8310")
    shop.bus("compass", '<bus name="compass" type="i2c" port="i2c3" clock="400kHz"/>')
    return Part("ist8310", shop.name("ist8310"), {"bus": "compass"}, period(shop.draw, tick, 50000, 7000))


def ms5837(shop, tick):
    if shop.depth >= 1:
        return None
    shop.depth += 1
    return Part("ms5837", shop.name("ms5837"), {"bus": shop.user_i2c(), "address": "0x76"}, period(shop.draw, tick, 50000, 2000))


def pulse(kind):
    def make(shop, tick):
        place = shop.servo_output()
        if place is None:
            return None
        return Part(kind, shop.name(kind), place, period(shop.draw, tick, 50000, 2000))

    return make


def light(shop, tick):
    if not shop.lights:
        return None
    port = shop.lights.pop()
    shop.bus(port, f'<bus name="{port}" type="pwm" port="{port}"/>')
    return Part("led", shop.name("led"), {"bus": port}, period(shop.draw, tick, 50000, 2000))


def only_once(kind, make):
    def maker(shop, tick):
        if kind not in shop.once:
            return None
        shop.once.discard(kind)
        return make(shop, tick)

    return maker


def buzzer(shop, tick):
    shop.bus("sound", '<bus name="sound" type="pwm" port="buzzer"/>')
    return Part("buzzer", shop.name("buzzer"), {"bus": "sound"}, period(shop.draw, tick, 50000, 5000))


def key(shop, tick):
    return Part("key", shop.name("key"), {}, period(shop.draw, tick, 20000, 2000), ['<use role="line" pin="key"/>'])


def battery(shop, tick):
    return Part("battery", shop.name("battery"), {}, period(shop.draw, tick, 50000, 5000), ['<use role="sense" pin="battery"/>'])


def load(shop, tick):
    """Work of its own; how much is settled when the robot is loaded to its limit."""
    update, handle = shop.draw.uniform(0.01, 0.2), shop.draw.uniform(0.01, 0.2)
    part = Part("sim_load", shop.name("load"), {}, period(shop.draw, tick))
    part.shares = (update, handle)
    return part


SENSORS = (
    serial_sensor("h30_imu", (460800, 921600), 10000),
    serial_sensor("dr16", (100000,), 20000),
    serial_sensor("sbus", (100000,), 20000),
    bmi088, ist8310, ms5837,
    motor("dji_m3508"), motor("dji_m2006"), motor("dji_gm6020"),
)
ACTUATORS = (
    motor("dji_m3508"), motor("dji_m2006"), motor("dji_gm6020"),
    pulse("pwm_servo"), pulse("pwm_esc"), light, only_once("buzzer", buzzer),
)
OTHERS = (load, load, load, only_once("key", key), only_once("battery", battery))


def group(shop, tick, children):
    return Part("group", shop.name("group"), {}, period(shop.draw, tick), [], children)


class Shipped:
    """A shipped example with other periods and loads beside it: the composites that need a mechanism."""

    def __init__(self, path, draw):
        text = path.read_text(encoding="utf-8")
        text = re.sub(r"<wcet [^>]*/>|<require [^>]*/>", "", text)
        factor = draw.choice((1, 1, 2, 3, 5))
        text = re.sub(r'period="(\d+)ms"', lambda m: f'period="{int(m[1]) * factor}ms"', text)
        self.name, self.load = path.name, 1.0
        self.before, self.after = text.split("</finemote>")
        shop = Workshop(draw)
        self.loads = [load(shop, 1000) for _ in range(draw.randint(1, 4))]
        self.kinds = re.findall(r'<device [^>]*type="(\w+)"', text)

    def parts(self):
        yield from self.loads

    def text(self):
        return "\n".join([self.before] + [line for part in self.loads for line in part.lines(1)] + ["</finemote>" + self.after])


def removable(robot):
    """Places of parts that can be left out, the last ones first: lists of siblings with an index."""

    def places(siblings):
        for index in reversed(range(len(siblings))):
            yield from places(siblings[index].children)
            yield siblings, index

    yield from list(places(getattr(robot, "trees", getattr(robot, "loads", []))))


def kinds_of(robot):
    """Types of its devices."""
    return [part.kind for part in robot.parts()] + getattr(robot, "kinds", [])


def set_loads(robot):
    """Gives every load its work: its shares of its period, scaled."""
    for part in robot.parts():
        if part.kind == "sim_load":
            update, handle = (int(share * robot.load * part.period_us * 1000) for share in part.shares)
            part.body = [f'<param name="update">{update}ns</param>', f'<param name="handle">{handle}ns</param>']


def draw_robot(seed, number):
    """The robot of this number; its loads are not scaled yet."""
    draw = random.Random(f"{seed}/{number}")
    if draw.random() < 0.3:
        robot = Shipped(draw.choice(SHIPPED), draw)
        set_loads(robot)
        return robot
    robot = Robot(f"robot_{number}", draw.choice((500, 1000)))
    shop = Workshop(draw)
    for _ in range(draw.choice((1, 1, 2, 2, 3))):
        children = []
        makers = [draw.choice(SENSORS) for _ in range(draw.randint(1, 3))]
        makers += [draw.choice(ACTUATORS) for _ in range(draw.randint(1, 4))]
        makers += [draw.choice(OTHERS) for _ in range(draw.randint(0, 2))]
        draw.shuffle(makers)
        for maker in makers:
            part = maker(shop, robot.tick_us)
            if part is not None:
                children.append(part)
        if children and len(children) > 3 and draw.random() < 0.4:  # a group in the group
            cut = draw.randint(1, len(children) - 2)
            children = [group(shop, robot.tick_us, children[:cut])] + children[cut:]
        if children:
            robot.trees.append(group(shop, robot.tick_us, children))
    for _ in range(draw.randint(0, 3)):
        robot.trees.append(load(shop, robot.tick_us))
    robot.buses, robot.expanders = shop.buses, shop.expanders
    set_loads(robot)
    return robot
