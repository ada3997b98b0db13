"""Attacks the bounds: draws robots, loads them to their limit, runs each with random phases and clock errors, and holds
what the record of the run shows against what analyze proves. See README.md beside this file.
"""

import argparse
import collections
import concurrent.futures
import itertools
import sys
import tempfile

import attack
import census
import inject
import state
import tool

MOST_SHOWN = 3  # robots that break a bound
MOST_LINES = 5  # of what each of them breaks


class Tally:
    """What became of the robots so far."""

    def __init__(self):
        self.drawn = 0
        self.by_state = collections.defaultdict(list)

    def add(self, result):
        self.drawn += 1
        self.by_state[result.state].append(result)

    @property
    def violated(self):
        return self.by_state["violated"]

    @property
    def counted(self):
        """The campaign's robots."""
        return self.by_state["counted"] + self.violated


def task_of(asked, folder, number):
    return attack.Task(asked.finemote, folder, asked.seed, number, asked.phases, asked.inject, asked.static)


def results(pool, asked, folder, first):
    """Results in the order of the robots, from the number `first` on; some robots ahead are under attack meanwhile."""
    tasks = (task_of(asked, folder, number) for number in itertools.count(first))
    ahead = collections.deque(pool.submit(attack.attack, task) for task in itertools.islice(tasks, 2 * asked.jobs))
    try:
        while True:
            yield ahead.popleft().result()
            ahead.append(pool.submit(attack.attack, next(tasks)))
    finally:
        for future in ahead:
            future.cancel()


def show_progress(tally, asked):
    if sys.stderr.isatty():
        print(f"\r{len(tally.counted)} of {asked.robots} robots, {tally.drawn} drawn ", end="", file=sys.stderr, flush=True)


def kept_results(pool, asked, folder, kept):
    """Those of a campaign that was stopped, and then new ones, which are kept as well."""
    yield from kept.results
    for result in results(pool, asked, folder, len(kept.results)):
        if result.state == "failed":
            print(f"robot {result.number} cannot be run:\n{result.problem}\n{result.text}", file=sys.stderr)
            sys.exit(2)
        kept.append(result)
        yield result


def draw_and_attack(pool, asked, folder, kept):
    """Until enough robots count, or one breaks a bound."""
    tally = Tally()
    for result in kept_results(pool, asked, folder, kept):
        tally.add(result)
        show_progress(tally, asked)
        if len(tally.counted) == asked.robots or tally.violated and not asked.keep_going:
            break
    if sys.stderr.isatty():
        print(file=sys.stderr)
    return tally


def show_violations(pool, tally, asked, folder):
    shown = tally.violated[:MOST_SHOWN]
    shrinking = [pool.submit(attack.shrink, task_of(asked, folder, result.number), result.load, result.verdict.kinds)
                 for result in shown]
    for result, smallest in zip(shown, shrinking):
        print(f"robot {result.number} of seed {asked.seed}:")
        for line in result.verdict.broken[:MOST_LINES]:
            print("  " + line)
        print(smallest.result())


def options():
    parser = tool.options(argparse.ArgumentParser(prog="./dev campaign", description=__doc__))
    parser.add_argument("--robots", type=int, default=40, help="how many have to count")
    parser.add_argument("--phases", type=int, default=2, help="runs of each robot")
    parser.add_argument("--inject", choices=list(inject.KINDS), help="make these bounds 2 %% too small")
    parser.add_argument("--static", action="store_true", help="hold runs against bounds that are computed from each image")
    parser.add_argument("--sweep", action="store_true", help="write down what is reached: reached.json, for --inject")
    parser.add_argument("--keep-going", action="store_true", help="do not stop at the first violation")
    parser.add_argument("--state", metavar="FILE", help="keep the results there, and go on from those that it has")
    return parser.parse_args()


def main():
    asked = options()
    try:
        kept = state.State(asked.state, (asked.seed, asked.phases, asked.inject, asked.static, state.digest_of(asked.finemote)))
    except state.Another as problem:
        print(problem, file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ProcessPoolExecutor(asked.jobs) as pool:
        tally = draw_and_attack(pool, asked, folder, kept)
        show_violations(pool, tally, asked, folder)
    if asked.sweep:
        inject.write(result.reached for result in tally.by_state["counted"])
    pessimism = census.pessimism(tally.counted) if asked.static else ()
    for line in itertools.chain(census.tightness(tally.counted), pessimism, census.contents(tally.counted)):
        print(line)
    discarded, unjudged = len(tally.by_state["discarded"]), len(tally.by_state["unjudged"])
    print(f"{tally.drawn} drawn, {discarded} discarded as not schedulable or without a bound, {unjudged} unjudged")
    print(f"{len(tally.counted)} robots, {len(tally.violated)} violations")
    return 1 if tally.violated else 0


if __name__ == "__main__":
    sys.exit(main())
