"""Draws one robot, loads it to its limit, runs it and judges what the record shows."""

import os
import pathlib

import draw
import inject
import judge
import robots
import stimuli
import tool
import workshop

STEPS = 5  # of the search for the largest load
MOST_LOAD = 8.0


class Task:
    """What a worker needs to know to attack one robot."""

    def __init__(self, finemote, folder, seed, number, phases, injected=None, is_static=False):
        self.finemote, self.folder = finemote, folder
        self.seed, self.number, self.phases, self.injected = seed, number, phases, injected
        self.is_static = is_static  # held against bounds of the image instead of assumed times

    def draw(self):
        return (draw.draw_bounded if self.is_static else draw.draw_robot)(self.seed, self.number)

    def tool(self):
        return tool.Tool(self.finemote, pathlib.Path(self.folder) / str(os.getpid()), is_slowest=self.is_static)


class Result:
    """What became of one drawn robot: discarded, failed, unjudged, counted or violated."""

    def __init__(self, number):
        self.number, self.state, self.verdict = number, "discarded", None
        self.load, self.breakdown = None, None  # what it got, and the largest that is schedulable
        self.types, self.reached, self.is_noisy, self.text, self.problem = {}, {}, False, "", ""


def demand_of(robot):
    """Share of the processor that the loads ask for at load 1."""
    return sum(sum(part.shares) for root in robot.roots() for part in root.walk() if part.kind in robots.LOADS)


def analysis_at(finemote, robot, load):
    """The document where the robot is schedulable with this load, else None."""
    robots.set_load(robot, load)
    analysis = finemote.analyze(robot)
    return analysis if analysis is not None and analysis["target"]["schedulable"] else None


def is_worth_a_run(analysis, robot):
    """Whether there is a chain with a bound in every part whose samples and outputs can be seen."""
    types = robots.Outline(robot.text()).types
    return any(judge.is_bounded(chain) and types[chain["from"]] in workshop.SAMPLED and types[chain["to"]] in workshop.WATCHED
               for chain in analysis["chains"])


def largest_load(finemote, robot, idle, fits):
    """The largest load at which the analysis is schedulable and fits, to a 32nd of what would fill the processor."""
    demand = demand_of(robot)
    low, high = 0.0, MOST_LOAD if demand == 0 else min(MOST_LOAD, (1 - idle["processor_load"]) / demand)
    for _ in range(STEPS if demand > 0 else 0):
        middle = (low + high) / 2
        analysis = analysis_at(finemote, robot, middle)
        if analysis is not None and fits(analysis):
            low = middle
        else:
            high = middle
    return low


def load_to_limit(finemote, robot):
    """Gives the robot its share of the largest schedulable load or, where no chain has all bounds at that, of the largest
    load at which one has. Returns the largest schedulable load and the analysis, each None where there is none.
    """
    idle = analysis_at(finemote, robot, 0.0)
    if idle is None:
        return None, None
    breakdown = largest_load(finemote, robot, idle, lambda analysis: True)
    analysis = analysis_at(finemote, robot, breakdown * robot.share)
    if analysis is not None and is_worth_a_run(analysis, robot):
        return breakdown, analysis
    if not is_worth_a_run(idle, robot):
        return breakdown, None
    lower = largest_load(finemote, robot, idle, lambda analysis: is_worth_a_run(analysis, robot))
    analysis = analysis_at(finemote, robot, lower * robot.share)
    return breakdown, analysis if analysis is not None and is_worth_a_run(analysis, robot) else None


def examine(finemote, robot, analysis, inputs, task):
    """Verdict on all runs of a robot, or None; and what the tool said where it cannot be run."""
    outline = robots.Outline(robot.text())
    figures = judge.Judge(analysis, inject.lowering(task.injected, inject.Classes(outline, analysis["model"])))
    for scenario, disturbed in inputs.runs(outline):
        phases = task.phases if disturbed is None else 1
        record, said = finemote.run(robot, scenario, task.number, phases)
        if record is None:
            return None, said[-2000:]
        figures.take(record, disturbed)
        figures.take_findings(said)
        figures.take_document(finemote.document)
    return figures.verdict(), ""


def bounded_analysis(finemote, robot):
    """The analysis that rests on the robot's image, None where it is not schedulable; and what has no bound."""
    problem = finemote.bound(robot)
    analysis = None if problem else finemote.analyze(robot)
    return analysis if analysis is not None and analysis["target"]["schedulable"] else None, problem


def attack(task):
    """What becomes of the robot; failed where the program crashes on it."""
    result, robot = Result(task.number), task.draw()
    try:
        attack_robot(task, robot, result)
    except tool.ToolFailed as failure:
        result.state, result.text, result.problem = "failed", robot.text(), str(failure)
    return result


def attack_robot(task, robot, result):
    """Fills in the result. Raises ToolFailed."""
    finemote = task.tool()
    if task.is_static:
        is_any = "<device" in robot.text()
        analysis, result.problem = bounded_analysis(finemote, robot) if is_any else (None, None)
        if result.problem:
            result.state, result.text = "failed", robot.text()
    else:
        result.breakdown, analysis = load_to_limit(finemote, robot)
    if analysis is None:
        return
    outline = robots.Outline(robot.text())
    inputs = stimuli.Stimuli(outline, task.seed, task.number)
    result.types, result.text, result.load = outline.types, robot.text(), robot.load
    result.is_noisy = inputs.disturbed is not None
    result.verdict, result.problem = examine(finemote, robot, analysis, inputs, task)
    if result.verdict is None:
        result.state = "failed"
        return
    result.reached = inject.largest_by_class(result.verdict.shares, inject.Classes(outline, analysis["model"]))
    if result.verdict.broken:
        result.state = "violated"
    else:
        result.state = "counted" if result.verdict.chains else "unjudged"


def breaks(finemote, robot, inputs, task, kinds):
    """Whether the robot breaks a bound of one of these kinds; one that the program fails on does not."""
    try:
        analysis = bounded_analysis(finemote, robot)[0] if task.is_static else analysis_at(finemote, robot, robot.load)
        verdict = None if analysis is None else examine(finemote, robot, analysis, inputs, task)[0]
    except tool.ToolFailed:
        return False
    return verdict is not None and not kinds.isdisjoint(verdict.kinds)


def shrink(task, load, kinds):
    """The smallest robot that still breaks a bound of one of these kinds: parts are left out one by one."""
    finemote = task.tool()
    robot = task.draw()
    inputs = stimuli.Stimuli(robots.Outline(robot.text()), task.seed, task.number)
    robots.set_load(robot, load)
    for siblings, index in robots.removable(robot):
        part, pairs = siblings.pop(index), robot.pairs
        names = robots.Outline(robot.text()).types
        robot.pairs = [pair for pair in pairs if pair[0] in names and pair[1] in names]
        if not breaks(finemote, robot, inputs, task, kinds):
            siblings.insert(index, part)
            robot.pairs = pairs
    return robot.text()
