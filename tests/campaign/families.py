"""Arm `families`: random specs of chosen templates, each by both kinds of analysis, beside the code.

It runs only where it is asked for: a joint takes minutes.
"""

import copy

from specs import first_case_only, one, valid

NAME = "families"
SHARE = 1.0
# `time_limit` of a run [s], by kind of analysis
SECONDS = {"elastic": 60, "limit": 150}
# one coarse mesh: bounds hold on any
FACTOR = 4.0


def run(case):
    spec = valid(case, case.templates)
    if spec is None:
        return
    first_case_only(spec)
    words = [f"{case.index:>4} {spec['template']}"]
    for kind, seconds in SECONDS.items():
        own = copy.deepcopy(spec)
        own["analysis"] = {"kind": kind, "decide": False, "time_limit": f"{seconds} s"}
        found, outcome = one(case, kind, own, FACTOR)
        lower, upper = next(iter(found.values()), (None, None))
        words.append(f"{kind} {shown(lower)} {shown(upper)} in {outcome.seconds:.0f} s")
        if None in (lower, upper):
            case.count(f"{kind} without both bounds")
            words.append(outcome.message()[:120])
        if kind == "limit":
            words.append(beside_code(case, upper))
    print("; ".join(words), flush=True)


def shown(bound):
    return "-" if bound is None else f"{bound:.6g}"


def beside_code(case, upper):
    """The largest factor by the code beside the upper bound."""
    result = case.result("limit")
    if result is None:
        return "no result"
    bound = [c for c in result["checks"] if c["binding"] != "information" and c.get("case")]
    undecided = [c["title"] for c in bound if c["status"] == "undecided"]
    if undecided:
        case.count("undecided by code")
        return f"undecided by code ({undecided[0]})"
    strengths = [c for c in bound if c.get("utilisation")]
    if not strengths:
        return "no strength by code"
    worst = max(strengths, key=lambda c: c["utilisation"])
    factor, title = 1 / worst["utilisation"], worst["title"]
    if upper is not None and upper < factor * (1 - 1e-6):
        case.count("upper bound below the code")
    return f"code {factor:.4g} ({title})"
