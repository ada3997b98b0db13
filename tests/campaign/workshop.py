"""What a board has to offer, and the parts that are made of it."""

from robots import LOADS, Part

PERIODS_US = (500, 1000, 2000, 2500, 4000, 5000, 7000, 8000, 10000, 13000, 20000, 25000, 50000)
#: Of trees whose devices all have the period of the root. Short ones make chains that decide within a millisecond.
COMMON_PERIODS_US = (500, 500, *12 * (1000,), 2000, 2500, 5000, 10000)
SHARE_OF_COMMON = 0.9
#: The board has lines for 11 periods; up to three trees have one of their own. Two suit all types.
MOST_PERIODS, ALWAYS_US = 8, (5000, 10000)

MOTORS = ("dji_m3508", "dji_m2006", "dji_gm6020")
#: Types whose parts on the emulated board give samples, and types whose outputs can be watched there.
SAMPLED = {"h30_imu", "dr16", "sbus", "host_link", "bmi088", "ist8310", "ms5837", *MOTORS, "gauge"}
WATCHED = {*MOTORS, "pwm_servo", "pwm_esc", "gauge"}

#: Roles of a mixer; what is not here is one of its inputs.
ROLES = {**dict.fromkeys(MOTORS, "motors"), "pwm_servo": "servos", "pwm_esc": "thrusters", "led": "lights",
         "buzzer": "sounders", "gauge": "gauges"}

#: Frames in a millisecond that a CAN bus takes before messages can still wait when the next ones are due. Commands count
#: twice: they can be sent at the end of one period and at the begin of the next.
CAN_FRAMES = 4.2


class Workshop:
    """What is left of a board. What makes a part returns None where there is no place for it.

    `common` is the period of the tree that is being made where its devices share one, else None.
    """

    def __init__(self, draw, tick_us):
        self.draw, self.tick_us = draw, tick_us
        fitting = [p for p in PERIODS_US if p % tick_us == 0]
        self.periods = sorted({*ALWAYS_US, *draw.sample(fitting, MOST_PERIODS - len(ALWAYS_US))})
        self.ports = ["usart1", "usart3", "usart6"]
        self.frames = {}  # by port: frames of commands with their periods; motors that share one share it
        self.ids = {"can1": set(), "can2": set()}  # of the feedback
        self.headers = [f"pwm{i}" for i in range(1, 8)]
        self.lamps = ["led_red", "led_green", "led_blue"]
        self.once = {"bmi088", "ist8310", "ms5837", "buzzer", "key", "battery"}
        self.addresses = list(range(0x2A, 0x2D))
        self.channels = list(range(16))
        self.clock = draw.choice((100, 200, 400, 400))  # of the user's I2C bus [kHz]
        self.has_servos = draw.random() < 0.4
        self.buses, self.expanders = [], []
        self.count = 0

    # ---- names, buses, periods

    def name(self, kind):
        self.count += 1
        return f"{kind}_{self.count}"

    def bus(self, name, line):
        if (name, line) not in self.buses:
            self.buses.append((name, line))
        return name

    def user_i2c(self):
        return self.bus("wire", f'<bus name="wire" type="i2c" port="i2c2" clock="{self.clock}kHz"/>')

    def take(self, kind):
        """Whether there was one left of what the board can have once."""
        if kind not in self.once:
            return False
        self.once.discard(kind)
        return True

    def period(self, common, least=0, most=50000):
        if common is not None and least <= common <= most:
            return common
        return self.draw.choice([p for p in self.periods if least <= p <= most])

    # ---- sensors

    def serial(self, kind, rates, common, most):
        inverted = kind in ("dr16", "sbus")  # one port has an inverter, and only receives
        ports = [port for port in self.ports if (port == "usart3") == inverted]
        if not ports:
            return None
        port = self.draw.choice(ports)
        self.ports.remove(port)
        rate = self.draw.choice(rates)
        bus = self.bus(f"line_{port}", f'<bus name="line_{port}" type="uart" port="{port}" baud="{rate}baud"/>')
        return Part(kind, self.name(kind), {"bus": bus}, self.period(common, 0, most))

    def imu(self, common):
        return self.serial("h30_imu", (460800, 921600), common, 10000)

    def remote(self, common):
        return self.serial(self.draw.choice(("dr16", "sbus")), (100000,), common, 20000)

    def link(self, common):
        """A computer at the other end, which is told about a load and mostly commands an actuator."""
        link = self.serial("host_link", (460800, 921600, 2625000), None, 20000)
        if link is not None:
            link.period_us = self.period(common, 1000, 20000)
            link.body = [f'<param name="command_interval">{self.draw.choice((1, 2, 5, 10, 20, 50, 100))}ms</param>']
            commanded = self.draw.choice((self.motor, self.servo, self.esc))(link.period_us)
            link.children = [self.load(None)] + [part for part in (commanded,) if part is not None]
        return link

    def bmi088(self, common):
        if not self.take("bmi088"):
            return None
        self.bus("spi", '<bus name="spi" type="spi" port="spi1" clock="5250kHz"/>')
        body = ['<use role="gyro" bus="spi" channel="1"/>']
        if self.draw.random() < 0.5:
            body.append('<use role="ready" pin="bmi088_int_gyro"/>')
        return Part("bmi088", self.name("bmi088"), {"bus": "spi", "channel": 0}, self.period(common, 1000, 5000), body)

    def ist8310(self, common):
        if not self.take("ist8310"):
            return None
        self.bus("compass", '<bus name="compass" type="i2c" port="i2c3" clock="400kHz"/>')
        return Part("ist8310", self.name("ist8310"), {"bus": "compass"}, self.period(common, 7000))

    def ms5837(self, common):
        if not self.take("ms5837"):
            return None
        return Part("ms5837", self.name("ms5837"), {"bus": self.user_i2c(), "address": "0x76"}, self.period(common, 2000))

    def key(self, common):
        if not self.take("key"):
            return None
        return Part("key", self.name("key"), {}, self.period(common, 1000, 20000), ['<use role="line" pin="key"/>'])

    def battery(self, common):
        if not self.take("battery"):
            return None
        return Part("battery", self.name("battery"), {}, self.period(common, 2000), ['<use role="sense" pin="battery"/>'])

    # ---- actuators

    def motor(self, common):
        port = self.draw.choice(("can1", "can2"))
        kind = self.draw.choice(MOTORS)
        base = 0x204 if kind == "dji_gm6020" else 0x200
        numbers = [n for n in range(1, 5 if kind == "dji_gm6020" else 9) if base + n not in self.ids[port]]
        if not numbers:
            return None
        number = self.draw.choice(numbers)
        frame = (kind == "dji_gm6020", number <= 4)
        frames = self.frames.setdefault(port, {})
        period = frames.get(frame) or self.period(common, 0, 10000)
        commands = sum(2000 / p for p in {**frames, frame: period}.values())
        if len(self.ids[port]) + 1 + commands > CAN_FRAMES:
            return None
        frames[frame] = period
        self.ids[port].add(base + number)
        bus = self.bus(port, f'<bus name="{port}" type="can" port="{port}" bitrate="1Mbit/s"/>')
        return Part(kind, self.name(kind), {"bus": bus, "id": number}, period)

    def pulse(self, kind, common):
        """At a header, or at a channel of an expander on the user's bus."""
        if self.has_servos and self.draw.random() < 0.5:
            line = f'<expander name="servos" model="pca9685" bus="{self.user_i2c()}" address="0x40"/>'
            if line not in self.expanders:
                self.expanders.append(line)
            channel = self.channels.pop(self.draw.randrange(len(self.channels)))
            return Part(kind, self.name(kind), {"bus": "servos", "channel": channel}, self.period(common, 2000))
        if not self.headers:
            return None
        port = self.headers.pop(self.draw.randrange(len(self.headers)))
        bus = self.bus(f"out_{port}", f'<bus name="out_{port}" type="pwm" port="{port}"/>')
        return Part(kind, self.name(kind), {"bus": bus}, self.period(common, 0))

    def servo(self, common):
        return self.pulse("pwm_servo", common)

    def esc(self, common):
        return self.pulse("pwm_esc", common)

    def lamp(self, common):
        if not self.lamps:
            return None
        port = self.lamps.pop()
        self.bus(port, f'<bus name="{port}" type="pwm" port="{port}"/>')
        return Part("led", self.name("led"), {"bus": port}, self.period(common, 1000))

    def buzzer(self, common):
        if not self.take("buzzer"):
            return None
        self.bus("sound", '<bus name="sound" type="pwm" port="buzzer"/>')
        return Part("buzzer", self.name("buzzer"), {"bus": "sound"}, self.period(common, 5000))

    def gauge(self, common):
        """A user's own type: a sensor that takes commands."""
        if not self.addresses:
            return None
        place = {"bus": self.user_i2c(), "address": hex(self.addresses.pop())}
        return Part("gauge", self.name("gauge"), place, self.period(common, 2000))

    def load(self, common):
        """Work of its own; how much is settled when the robot is loaded to its limit."""
        part = Part(self.draw.choice(LOADS), self.name("load"), {}, self.period(common))
        part.seed = self.draw.randint(1, 1_000_000)
        part.shares = (self.draw.uniform(0.01, 0.2), self.draw.uniform(0.01, 0.2))
        return part

    # ---- composites

    def tree(self):
        """A tree of some sensors and actuators; None where nothing of it has a place."""
        common = None
        if self.draw.random() < SHARE_OF_COMMON:
            common = self.draw.choice([p for p in COMMON_PERIODS_US if p % self.tick_us == 0])
        special = self.draw.choice((self.gimbal, self.arm, self.chassis)) if self.draw.random() < 0.25 else None
        return (special and special(common)) or self.mixed(common)

    def mixed(self, common):
        sensors = (self.imu, self.remote, self.bmi088, self.ist8310, self.ms5837, self.gauge, self.motor, self.motor)
        actuators = (self.motor, self.motor, self.servo, self.esc, self.gauge, self.lamp, self.buzzer)
        others = (self.load, self.load, self.key, self.battery, self.link)
        makers = [self.draw.choice(sensors) for _ in range(self.draw.randint(1, 3))]
        makers += [self.draw.choice(actuators) for _ in range(self.draw.randint(1, 4))]
        makers += [self.draw.choice(others) for _ in range(self.draw.randint(0, 2))]
        self.draw.shuffle(makers)
        children = [part for part in (maker(common) for maker in makers) if part is not None]
        if len(children) > 3 and self.draw.random() < 0.4:  # a composite in the composite
            cut = self.draw.randint(1, len(children) - 2)
            children = [self.join(common, children[:cut])] + children[cut:]
        return self.join(common, children) if children else None

    def join(self, common, children):
        """A group, or more often a mixer, whose actuators get another command in every run."""
        if self.draw.random() < 0.25:
            return Part("group", self.name("group"), {}, self.period(common), [], children)
        for child in children:
            child.attributes["role"] = ROLES.get(child.kind, "inputs")
        return Part("mixer", self.name("mixer"), {}, self.period(common), [], children)

    def composite(self, kind, common, roles):
        """None where one of the parts has no place; what was taken for the others is lost."""
        children = []
        for role, maker in roles:
            part = maker(common)
            if part is None:
                return None
            part.attributes["role"] = role
            children.append(part)
        return Part(kind, self.name(kind), {}, self.period(common, 0, 10000), [], children)

    def gimbal(self, common):
        imu = self.draw.choice((self.imu, self.bmi088))
        return self.composite("gimbal", common,
                              [("yaw", self.motor), ("pitch", self.motor), ("imu", imu), ("remote", self.remote)])

    def arm(self, common):
        joints = [("joints", self.motor)] * self.draw.randint(1, 3)
        return self.composite("serial_arm", common, joints + [("remote", self.remote)])

    def chassis(self, common):
        return self.composite("mecanum_chassis", common, [("wheels", self.motor)] * 4 + [("remote", self.remote)])
