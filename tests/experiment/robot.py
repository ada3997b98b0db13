"""What the robot did in a run: how its curves settle, and what its thrusters did while something was broken."""

import plans

NEUTRAL_US, NEAR_US = 1500, 3
THRUSTERS = [f"thruster_{n}" for n in range(1, 9)]


def series(record, part, value):
    """[(s since the first tick, value)]"""
    one = next(s for s in record["series"] if s["part"] == part and s["value"] == value)
    return [((one["from_ns"] + i * one["every_ns"]) / 1e9, v) for i, v in enumerate(one["values"])]


def between(points, begin, end):
    return [(at, value) for at, value in points if begin <= at < end]


def settled_after(points, begin_ns, end_ns, target, band):
    """Seconds from `begin_ns` until the value stays within `band` of the target; None: it does not."""
    last, inside = None, False
    for at, value in between(points, begin_ns / 1e9, end_ns / 1e9):
        inside = abs(value - target) <= band
        if not inside:
            last = at
    if not inside:
        return None
    return 0.0 if last is None else last - begin_ns / 1e9


def overshoot(points, begin_ns, end_ns, target):
    """How far the value went beyond its target, which is above where it came from."""
    return max(0.0, max(value for _, value in between(points, begin_ns / 1e9, end_ns / 1e9)) - target)


def deviation(points, begin_ns, end_ns, target):
    return max(abs(value - target) for _, value in between(points, begin_ns / 1e9, end_ns / 1e9))


def motion(record):
    depth, yaw = series(record, "base_link", "depth"), series(record, "base_link", "yaw")
    calm = plans.PUSH_NS - 2_000_000_000
    return {"depth": depth, "yaw": yaw,
            "depth_settled_s": settled_after(depth, plans.STEP_DEPTH_NS, plans.PUSH_NS, plans.DEPTH_M, 0.02),
            "depth_overshoot_m": overshoot(depth, plans.STEP_DEPTH_NS, plans.PUSH_NS, plans.DEPTH_M),
            "yaw_settled_s": settled_after(yaw, plans.STEP_YAW_NS, plans.PUSH_NS, plans.YAW_DEG, 2),
            "yaw_overshoot_deg": overshoot(yaw, plans.STEP_YAW_NS, plans.PUSH_NS, plans.YAW_DEG),
            "push_depth_m": deviation(depth, plans.PUSH_NS, plans.MOTION_END_NS, plans.DEPTH_M),
            "push_yaw_deg": deviation(yaw, plans.PUSH_NS, plans.MOTION_END_NS, plans.YAW_DEG),
            "ripple_depth_m": deviation(depth, calm, plans.PUSH_NS, plans.DEPTH_M)}


def pulses(record):
    """[(s, [us of every thruster])]"""
    each = [series(record, name, "pulse") for name in THRUSTERS]
    return [(at, [one[i][1] for one in each]) for i, (at, _) in enumerate(each[0])]


def changes(looks, begin, end):
    """Times at which the pulses were not what they had been at the look before."""
    return [now for (_, before), (now, present) in zip(looks, looks[1:]) if begin < now <= end and present != before]


def forward(pulse):
    """How far the horizontal thrusters, which push forward together, are off neutral in the mean [us]."""
    return sum(abs(pulse[i] - NEUTRAL_US) for i in (0, 3, 4, 7)) / 4


def ends_forward(looks, begin):
    """Seconds from `begin` until the way forward is over for good; None: it is not."""
    half = forward(next(present for at, present in looks if at >= begin)) / 2
    on = [at for at, present in looks if at >= begin and forward(present) > half]
    return None if on and on[-1] == looks[-1][0] else (on[-1] - begin if on else 0.0)


def is_neutral(pulse):
    return all(abs(us - NEUTRAL_US) <= NEAR_US for us in pulse)


def fault(record):
    """What the thrusters did from the fault on."""
    looks = pulses(record)
    begin, mended, end = (ns / 1e9 for ns in (plans.FAULT_NS, plans.MENDED_NS, plans.FAULT_END_NS))
    neutral = [at for at, present in looks if begin <= at and is_neutral(present)]
    moving = changes(looks, begin, end)
    gaps = [begin, *moving, end]
    after = [at for at, present in looks if at > (neutral[0] if neutral else end) and not is_neutral(present)]
    longest = max(b - a for a, b in zip(gaps, gaps[1:]))
    return {"neutral_s": neutral[0] - begin if neutral else None,
            "driven_again_s": after[0] - begin if after else None,
            "longest_unchanged_s": longest, "mended_s": mended - begin,
            "forward_ends_s": ends_forward(looks, begin), "resolution_s": looks[1][0] - looks[0][0]}
