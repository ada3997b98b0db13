"""Draws robots: sensors, actuators and loads of all types, on buses of the board as they happen to fit.

The same seed and number draw the same robot.
"""

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
#: Of sensor and actuator, for which a chain is asked: in a tree that runs every millisecond or faster, and in others.
MOST_PAIRS_OF_FAST, MOST_PAIRS = 9, 1


def draw_shipped(draw):
    shop = workshop.Workshop(draw, 1000)
    loads = [shop.load(None) for _ in range(draw.randint(1, 4))]
    return robots.Shipped(robots.ROOT / draw.choice(SHIPPED), draw.choice((1, 1, 2, 3, 5)), loads)


def pairs_of(draw, trees):
    """Some pairs of a sensor that gives samples and an actuator that can be watched, each in one tree."""
    pairs = []
    for tree in trees:
        parts = list(tree.walk())
        sources = [part.name for part in parts if part.kind in workshop.SAMPLED]
        targets = [part.name for part in parts if part.kind in workshop.WATCHED]
        found = [(source, target) for source in sources for target in targets]
        most = MOST_PAIRS_OF_FAST if tree.period_us <= 1000 else MOST_PAIRS
        pairs += draw.sample(found, min(len(found), most))
    return pairs


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
