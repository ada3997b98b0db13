"""Robots whose stages and routines are searched for their longest times: small ones that have all shipped types between them,
and the shipped examples.
"""

import re

import robots
from robots import Part

CAN = '<bus name="{0}" type="can" port="{0}" bitrate="1Mbit/s"/>'
UART = '<bus name="{0}" type="uart" port="{0}" baud="{1}baud"/>'
PWM = '<bus name="{0}" type="pwm" port="{0}"/>'
I2C = '<bus name="{0}" type="i2c" port="{0}" clock="400kHz"/>'

#: A link that sensors can be mounted at, so that they turn what they measure.
TILTED = ('<link name="base"/><link name="tilted"/><joint name="tilt" type="fixed"><parent link="base"/><child link="tilted"/>'
          '<origin xyz="0 0 0.1" rpy="0.3 -0.4 0.5"/></joint>')


class Subject:
    """A robot whose code runs from SRAM; `devices` is the folder of the users' types."""

    def __init__(self, name, text, devices=robots.DEVICES):
        self.name, self.devices, self.pairs = name, devices, []
        self._text = text

    def text(self):
        return self._text

    def board(self):
        return re.search(r'<board name="(\w+)"', self._text)[1]


def bmi088(period_us, **more):
    body = ['<use role="gyro" bus="spi" channel="1"/>', '<use role="heater" bus="imu_heater"/>',
            '<use role="ready" pin="bmi088_int_gyro"/>']
    return Part("bmi088", "bmi", {"bus": "spi", "channel": 0, **more}, period_us, body)


def motor(kind, name, bus, number, period_us, **more):
    return Part(kind, name, {"bus": bus, "id": number, **more}, period_us)


def line(kind, port, period_us, **more):
    return Part(kind, kind, {"bus": port, **more}, period_us)


def pulse(kind, bus, period_us, **more):
    return Part(kind, f"{kind}_{bus}", {"bus": bus, **more}, period_us)


SPI = '<bus name="spi" type="spi" port="spi1" clock="5250kHz"/>'

WHEELS = [motor("dji_m3508", f"wheel_{number}", "can1", number, 5000, role="wheels") for number in range(1, 5)]
JOINTS = [motor(kind, f"joint_{number}", "can1", number, 2000, role="joints")
          for number, kind in enumerate(("dji_m3508", "dji_m2006", "dji_m3508", "dji_m2006"), 1)]

#: By name: buses, expanders, and the root with its parts.
SMALL = {
    "h30_imu": ([UART.format("usart1", 921600)], [],
                Part("group", "root", {}, 10000, [], [line("h30_imu", "usart1", 10000)])),
    "dr16": ([UART.format("usart3", 100000)], [], Part("group", "root", {}, 10000, [], [line("dr16", "usart3", 10000)])),
    "sbus": ([UART.format("usart3", 100000)], [], Part("group", "root", {}, 10000, [], [line("sbus", "usart3", 10000)])),
    "host_link": ([UART.format("usart1", 921600), PWM.format("pwm1"), PWM.format("pwm2"), PWM.format("led_red"),
                   PWM.format("buzzer"), CAN.format("can1")], [],
                  Part("host_link", "root", {"bus": "usart1"}, 10000, [], [
                      pulse("pwm_servo", "pwm1", 10000), pulse("pwm_esc", "pwm2", 10000), pulse("led", "led_red", 10000),
                      pulse("buzzer", "buzzer", 10000), motor("dji_m3508", "wheel", "can1", 1, 10000)])),
    # With long periods: a line brings up to two of them at once.
    "slow_lines": ([UART.format("usart1", 921600), UART.format("usart3", 100000)], [],
                   Part("group", "root", {}, 50000, [], [line("h30_imu", "usart1", 50000), line("sbus", "usart3", 50000)])),
    "slow_link": ([UART.format("usart1", 921600), PWM.format("buzzer")], [],
                  Part("host_link", "root", {"bus": "usart1"}, 50000, [], [pulse("buzzer", "buzzer", 50000)])),
    "motors": ([CAN.format("can1"), CAN.format("can2")], [], Part("mixer", "root", {}, 1000, [], [
        motor("dji_m3508", "m3508", "can1", 1, 1000, role="motors"),
        motor("dji_m2006", "m2006", "can1", 2, 1000, role="motors"),
        motor("dji_gm6020", "gm6020", "can2", 1, 1000, role="motors")])),
    "i2c": ([I2C.format("i2c2"), I2C.format("i2c3")], ['<expander name="servos" model="pca9685" bus="i2c2" address="0x40"/>'],
            Part("mixer", "root", {}, 10000, [], [
                Part("ms5837", "ms5837", {"bus": "i2c2", "address": "0x76", "role": "inputs"}, 10000),
                Part("ist8310", "ist8310", {"bus": "i2c3", "role": "inputs"}, 10000),
                Part("gauge", "gauge", {"bus": "i2c2", "address": "0x2a", "role": "gauges"}, 10000),
                Part("pwm_servo", "servo", {"bus": "servos", "channel": 0, "role": "servos"}, 10000),
                Part("pwm_esc", "esc", {"bus": "servos", "channel": 1, "role": "thrusters"}, 10000)])),
    "bmi088": ([SPI, PWM.format("imu_heater")], [], Part("group", "root", {}, 1000, [], [bmi088(1000)])),
    "mounted": ([UART.format("usart1", 921600), SPI, PWM.format("imu_heater"), I2C.format("i2c3")], [],
                Part("group", "root", {}, 10000, [], [
                    line("h30_imu", "usart1", 5000, link="tilted"), bmi088(2000, link="tilted"),
                    Part("ist8310", "ist8310", {"bus": "i2c3", "link": "tilted"}, 10000)])),
    "onboard": ([PWM.format(port) for port in ("pwm1", "pwm2", "led_red", "buzzer")], [], Part("mixer", "root", {}, 5000, [], [
        Part("key", "key", {"role": "inputs"}, 5000, ['<use role="line" pin="key"/>']),
        Part("battery", "battery", {"role": "inputs"}, 5000, ['<use role="sense" pin="battery"/>']),
        pulse("pwm_servo", "pwm1", 5000, role="servos"), pulse("pwm_esc", "pwm2", 5000, role="thrusters"),
        pulse("led", "led_red", 5000, role="lights"), pulse("buzzer", "buzzer", 5000, role="sounders"),
        Part("sim_load", "load", {"role": "inputs"}, 5000,
             ['<param name="update">50us</param>', '<param name="handle">20us</param>'])])),
    "gimbal": ([UART.format("usart1", 921600), UART.format("usart3", 100000), CAN.format("can1")], [],
               Part("gimbal", "root", {}, 2000, [], [
                   motor("dji_gm6020", "yaw", "can1", 1, 1000, role="yaw"),
                   motor("dji_gm6020", "pitch", "can1", 2, 1000, role="pitch"),
                   line("h30_imu", "usart1", 2000, role="imu"), line("dr16", "usart3", 10000, role="remote")])),
    "mecanum_chassis": ([UART.format("usart3", 100000), CAN.format("can1")], [],
                        Part("mecanum_chassis", "root", {}, 5000, [],
                             [*WHEELS, line("dr16", "usart3", 10000, role="remote")])),
    "serial_arm": ([UART.format("usart3", 100000), CAN.format("can1")], [],
                   Part("serial_arm", "root", {}, 2000, [], [*JOINTS, line("sbus", "usart3", 10000, role="remote")])),
}


def small(name):
    buses, expanders, root = SMALL[name]
    robot = robots.Robot(1000)
    robot.is_in_sram = True
    robot.buses = [(bus.split('"')[1], bus) for bus in buses]
    robot.expanders, robot.trees = expanders, [root]
    return Subject(name, robot.text().replace('<link name="base"/>', TILTED))


def example(path):
    """All have one name, so that a folder that was compiled for one of them is good for the next."""
    text = re.sub(r'<robot name="[^"]*"', '<robot name="robot"', path.read_text(encoding="utf-8"), count=1)
    return Subject(path.stem, text, path.parent / "devices")


def all_subjects():
    """By name; all examples run their code from SRAM."""
    named = {name: small(name) for name in SMALL}
    for path in sorted((robots.ROOT / "examples").glob("*.urdf")):
        named[path.stem] = example(path)
    return named
