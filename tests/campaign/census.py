"""Says what a campaign was made of, and how near its figures came to their bounds."""

import statistics

SHORT_NS = 1_000_000  # a chain below it decides within a period of the fastest robots


def shares_by_kind(results):
    by_kind = {}
    for result in results:
        for key, (share, bound) in result.verdict.shares.items():
            by_kind.setdefault(key[2], []).append(share)
            if key[2] == "decide":
                span = "below" if bound < SHORT_NS else "above"
                by_kind.setdefault(f"decide {span} 1 ms", []).append(share)
    return by_kind


def tightness(results):
    yield "largest measured / bound   figures  median     p95     max"
    for kind, shares in sorted(shares_by_kind(results).items()):
        shares.sort()
        yield (f"  {kind:<24} {len(shares):>7}  {statistics.median(shares):6.3f}  "
               f"{shares[int(0.95 * (len(shares) - 1))]:6.3f}  {shares[-1]:6.3f}")


def pessimism(results):
    """Of bounds of the image: how far above the longest that was seen they are."""
    ratios = [1 / share for share in shares_by_kind(results).get("own", ()) if share > 0]
    if ratios:
        yield f"static / longest seen, median of {len(ratios)} own times: {statistics.median(ratios):.2f}"


def contents(results):
    """Types, chains, noise and loads of robots that counted."""
    total = max(len(results), 1)
    types = {}
    for result in results:
        for kind in set(result.types.values()):
            types[kind] = types.get(kind, 0) + 1
    ranked = sorted(types.items(), key=lambda entry: (-entry[1], entry[0]))
    yield "robots with a type: " + ", ".join(f"{kind} {100 * count / total:.1f} %" for kind, count in ranked)
    verdicts = [result.verdict for result in results]
    chains = [verdict.shares[(*chain, "decide")][1] for verdict in verdicts for chain in verdict.chains]
    short = sum(decide < SHORT_NS for decide in chains)
    yield f"{len(chains)} chains judged in every part, {100 * short / max(len(chains), 1):.1f} % of them decide below 1 ms"
    noisy = sum(result.is_noisy for result in results)
    yield f"{100 * noisy / total:.1f} % of the robots ran once more with noise on a bus"
    if results and results[0].breakdown is not None:
        yield f"median breakdown load: {statistics.median(result.breakdown for result in results):.3f}"
