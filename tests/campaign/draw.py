"""Draws robots: sensors, actuators and loads of all types, on buses of the board as they happen to fit.

The same seed and number draw the same robot.
"""

import itertools
import random

import robots
import workshop

#: Examples whose composites need a mechanism. Those that only obey a computer have no chain that begins at a part.
SHIPPED = (
    "examples/infantry.urdf",
    "examples/six_joint_arm.urdf",
    "tests/emulator/robots/crane.urdf",
    "examples/finsrov.urdf",
    "examples/finsrov.urdf",  # as often as the others together: the only one with its type
    "examples/finsrov.urdf",
)
SHARE_OF_SHIPPED = 0.15
FAST_US = 1000
#: Of sensor and actuator of a tree, for which a chain is asked: where both run so fast, and of the others.
MOST_FAST_PAIRS, MOST_OTHER_PAIRS = 12, 1


def draw_shipped(draw):
    shop = workshop.Workshop(draw, 1000)
    loads = [shop.load(None) for _ in range(draw.randint(1, 4))]
    return robots.Shipped(robots.ROOT / draw.choice(SHIPPED), draw.choice((1, 1, 2, 3, 5)), loads)


def pairs_of(draw, trees):
    """Some pairs of a sensor that gives samples and an actuator that can be watched, each in one tree. What a computer is
    told goes nowhere else."""
    pairs = []
    for tree in trees:
        parts = list(tree.walk())
        told = {part.name for link in parts if link.kind == "host_link" for part in link.walk()} - {
            part.name for part in parts if part.kind == "host_link"}
        sources = [part for part in parts if part.kind in workshop.SAMPLED and part.name not in told]
        targets = [part for part in parts if part.kind in workshop.WATCHED]
        fast, others = [], []
        for source, target in itertools.product(sources, targets):
            is_fast = max(source.period_us, target.period_us) <= FAST_US
            (fast if is_fast else others).append((source.name, target.name))
        pairs += draw.sample(fast, min(len(fast), MOST_FAST_PAIRS))
        pairs += draw.sample(others, min(len(others), MOST_OTHER_PAIRS))
    return pairs


#: Of the work of loads where bounds of the image count: they are larger than what stages are assumed to take.
BOUNDED_LOAD = 0.25


def draw_bounded(seed, number):
    """The robot of this number with less work in its loads, of which an image tells how long it takes; code in SRAM."""
    robot = draw_robot(seed, number)
    robot.is_in_sram = True
    for part in (part for root in robot.roots() for part in root.walk() if part.kind in robots.LOADS):
        part.kind = "sim_load"
    robots.set_load(robot, BOUNDED_LOAD)
    return robot


def draw_robot(seed, number):
    """The robot of this number; its loads have their full shares."""
    draw = random.Random(f"{seed}/{number}")
    if draw.random() < SHARE_OF_SHIPPED:
        robot = draw_shipped(draw)
    else:
        robot = robots.Robot(draw.choice((500, 1000)))
        shop = workshop.Workshop(draw, robot.tick_us)
        for _ in range(draw.choice((1, 1, 2, 2, 3))):
            tree = shop.tree()
            if tree is not None:
                robot.trees.append(tree)
        robot.trees += [shop.load(None) for _ in range(draw.randint(0, 2))]
        robot.buses, robot.expanders = shop.buses, shop.expanders
        robot.pairs = pairs_of(draw, robot.trees)
    robot.share = draw.uniform(0.8, 1.0)
    robots.set_load(robot, 1.0)
    return robot
