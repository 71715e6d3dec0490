"""Random specs of end plates and T-stubs; profiles, bolts and steels are drawn evenly."""

import copy
import json
from math import sqrt


class Catalogue:
    """What the program lists."""

    def __init__(self, program):
        self.profiles = program.json("catalog", "list", "profiles")
        self.bolts = program.json("catalog", "list", "bolts")
        self.grades = program.json("catalog", "list", "bolt-grades")
        steels = program.json("catalog", "list", "steels")
        self.steels = [f"{s['standard']} {s['grade']}" for s in steels]
        self.not_fillet_welded = {n for n, s in zip(self.steels, steels) if not s.get("beta_w")}
        annexes = program.json("catalog", "list", "annexes")
        self.annexes = [a["annex"] for a in annexes if "annex" in a]
        self.templates = {t["name"]: t for t in program.json("templates")}


class NoRoom(Exception):
    """No bolt fits, or no row: another draw."""


def hexagon(bolt):
    width = max(bolt["head_width"], bolt["nut_width"])
    return width / 2, width / sqrt(3)


def bolt_name(bolt):
    return bolt["size"] if bolt["system"] == "ISO 4014" else f"{bolt['system']} {bolt['size']}"


def mm(x):
    return round(x, 1)


def fitting(r, catalogue, least, most):
    """A bolt size for which some gauge has room, and that gauge.

    `least` and `most` give the gauges from half the width of the nut and half its diagonal.
    """
    fit = []
    for bolt in catalogue.bolts:
        low, high = least(*hexagon(bolt)), most(*hexagon(bolt))
        if low + 2 < high:
            fit.append((bolt, low + 1, high - 1))
    if not fit:
        raise NoRoom
    bolt, low, high = r.choice(fit)
    return bolt, mm(r.uniform(low, high)), (low, high)


def rows_between(r, low, high, pitch, most):
    """Up to `most` rows from `low` to `high`, at least `pitch` apart."""
    if high < low:
        return []
    room = int((high - low) / pitch) + 1
    number = r.randint(1, min(most, room))
    slack = (high - low) - (number - 1) * pitch
    cuts = sorted(r.uniform(0, slack) for _ in range(number))
    return [mm(low + c + i * pitch) for i, c in enumerate(cuts)]


def end_plate(r, spec, beam, bolt, levels):
    """Height of the plate and bolt rows, clear of what stands at the flanges."""
    flat, _ = hexagon(bolt)
    hole = bolt["hole_normal"]
    half, centre = beam["h"] / 2, (beam["h"] - beam["tf"]) / 2
    clear = flat + levels / 2 + 1.5
    pitch = max(2 * flat + 1.5, r.choice([2.2, 2.2, 3.0]) * hole)
    ends, rows = [], rows_between(r, -centre + clear, centre - clear, pitch, 3)
    for _ in range(2):
        out, beyond = r.choice([5.0, 15.0]), []
        if r.random() < 0.5:
            start = max(centre + clear, half + 0.5)
            beyond = [start + r.uniform(0, 20) + i * pitch for i in range(r.choice([1, 1, 1, 2]))]
            out = beyond[-1] - half + max(flat, r.choice([1.2, 1.5]) * hole) + 1
        ends.append((mm(half + out), [mm(z) for z in beyond]))
    spec["plate"]["z"] = [-ends[0][0], ends[1][0]]
    rows = [-z for z in reversed(ends[0][1])] + rows + ends[1][1]
    if not rows:
        raise NoRoom
    if r.random() < 0.1:
        r.shuffle(rows)
    spec["bolts"]["rows"] = rows


def steel(r, catalogue):
    return "S355" if r.random() < 0.2 else r.choice(catalogue.steels)


def common(r, catalogue, spec):
    """Grade, preload, friction, code."""
    grade = r.choice(catalogue.grades)
    bolts = spec["bolts"]
    bolts["grade"] = grade["grade"]
    if grade["preloadable"] and r.random() < 0.25:
        bolts["preload"] = r.choice([0.7, 0.3, mm(r.uniform(0.1, 0.7))])
    if "preload" in bolts and r.random() < 0.4:
        bolts["category"] = r.choice("BCE")
    elif r.random() < 0.2:
        bolts["category"] = r.choice("AD")
    if r.random() < 0.3:
        spec["friction"] = {"class": r.choice("ABCD")}
    else:
        spec["friction"] = {"mu": r.choice([0, 0, 0.1, 0.2, 0.3, 0.5])}
    if r.random() < 0.6:
        spec["friction"]["law"] = r.choice(["coulomb", "associated"])
    code = {}
    if catalogue.annexes and r.random() < 0.3:
        code["annex"] = r.choice(catalogue.annexes)
    for name in ("gamma_M0", "gamma_M2"):
        if r.random() < 0.15:
            code[name] = mm(r.uniform(0.9, 1.5))
    if r.random() < 0.2:
        code["fy_source"] = "product_standard"
    if r.random() < 0.2:
        code["prying"] = "always"
    if code:
        spec["code"] = code


def actions(r, section, names, strength):
    """A random subset of the six actions, as parts of what the section carries."""
    fy = strength / 1000.0
    area, wy, wz = section["area"] * 100, section["w_pl_y"] * 1e3, section["w_pl_z"] * 1e3
    force = {"N": area * fy, "Vy": area * fy / 3, "Vz": area * fy / 4}
    moment = {"My": wy * fy / 1000, "Mz": wz * fy / 1000, "T": wz * fy / 4000}
    out = {}
    for name in names:
        size = r.uniform(0.02, 0.4) * r.choice([-1, 1])
        value = size * (force.get(name) or moment[name])
        out[name] = f"{value:.4g} {'kN' if name in force else 'kN m'}"
    return out


def end_loads(r, section, ends, names):
    """Load cases at the ends; `names`: the actions to draw from."""
    loads = []
    for number in range(r.choice([1, 1, 2, 3])):
        case = f"LC{number + 1}"
        state = "SLS" if r.random() < 0.15 else "ULS"
        used = [e for e in ends if r.random() < 0.7] or [ends[0]]
        for end in used:
            kept = [n for n in names if r.random() < 0.4] or [names[0]]
            if "My" in names and r.random() < 0.5 and "My" not in kept:
                kept.append("My")
            load = {"name": case, "end": end["name"], "at": r.choice(end["at"])}
            load.update(actions(r, section, kept, 235.0))
            if state == "SLS":
                load["state"] = state
            elif len(kept) > 1 and r.random() < 0.15:
                load["factor"] = kept[:1]
            loads.append(load)
        idle = [e for e in ends if e not in used]
        if idle and r.random() < 0.3 and state == "ULS":
            load = {"name": case, "end": idle[0]["name"], "at": idle[0]["at"][0], "dead": True}
            load.update(actions(r, section, [names[-1]], 20.0))
            loads.append(load)
    return loads


ALL_SIX = ["My", "Vz", "N", "Vy", "T", "Mz"]


def beam_on_plate(r, catalogue, spec, beam, width):
    """An end plate of this width whose bolts need to keep clear of the beam alone."""
    spec["plate"] = {"thickness": mm(r.uniform(6, 40)), "width": width}
    web = beam["tw"] + 2 * beam["r"]
    bolt, gauge, _ = fitting(r, catalogue, lambda f, c: web + 2 * c, lambda f, c: width - 2 * c)
    spec["bolts"] = {"size": bolt_name(bolt), "gauge": gauge}
    end_plate(r, spec, beam, bolt, beam["tf"])
    spec["parameters"] = flags(r, ["flange_weld", "web_weld"])
    return beam


def splice(r, catalogue, spec):
    beam = r.choice(catalogue.profiles)
    spec["members"] = {"beam": {"profile": beam["name"], "steel": steel(r, catalogue)}}
    width = mm(beam["b"] + r.choice([0, 10, r.uniform(0, 120)]))
    return beam_on_plate(r, catalogue, spec, beam, width)


def flags(r, welds):
    out = {}
    if r.random() < 0.25:
        out["hole_clearance"] = r.choice([1, 2, 3])
    if r.random() < 0.25:
        out["head_contact"] = True
    for name in welds:
        if r.random() < 0.3:
            out[name] = r.choice([3, 4, 5, 6, 8, 10])
    return out


def to_column(r, catalogue, spec, template):
    column, beam = r.choice(catalogue.profiles), r.choice(catalogue.profiles)
    spec["members"] = {
        "column": {"profile": column["name"], "steel": steel(r, catalogue)},
        "beam": {"profile": beam["name"], "steel": steel(r, catalogue)},
    }
    narrow, wide = beam["b"], min(2 * beam["b"] + 200, max(beam["b"], column["b"]) + 40)
    width = mm(r.uniform(narrow, wide))
    spec["plate"] = {"thickness": mm(r.uniform(6, 40)), "width": width}
    if r.random() < 0.3:
        spec["plate"]["steel"] = steel(r, catalogue)
    web = 2 * max(column["tw"] / 2 + column["r"], beam["tw"] / 2 + beam["r"])
    room = min(width, column["b"])
    bolt, gauge, (low, high) = fitting(
        r, catalogue, lambda f, c: web + 2 * c, lambda f, c: room - 2 * c
    )
    spec["bolts"] = {"size": bolt_name(bolt), "gauge": gauge}
    own = template == "beam_to_column_end_plate"
    given = flags(r, ["flange_weld", "web_weld"] if own else [])
    levels = beam["tf"]
    if r.random() < 0.6:
        given["column_stiffeners"] = r.random() < 0.7
    # most scenes have stiffeners, which no template adds by itself
    given.setdefault("column_stiffeners", True)
    if given["column_stiffeners"] and r.random() < 0.4:
        given["column_stiffener_thickness"] = mm(r.uniform(max(3, beam["tf"]), beam["tf"] + 10))
        levels = given["column_stiffener_thickness"]
    end_plate(r, spec, beam, bolt, levels)
    if own:
        extras(r, spec, given, beam, column, bolt, (low, high))
    for name in ("column_ends_above", "column_ends_below"):
        if r.random() < 0.15:
            given[name] = True
    spec["parameters"] = given
    return beam


def to_web(r, catalogue, spec):
    """A beam on the web of a column, between its root fillets."""
    def room(column):
        return column["h"] - 2 * column["tf"] - 2 * column["r"]

    pairs = [
        (column, beam)
        for column in catalogue.profiles
        for beam in catalogue.profiles
        if room(column) > beam["b"] + 1
    ]
    column, beam = r.choice(pairs)
    spec["members"] = {
        "column": {"profile": column["name"], "steel": steel(r, catalogue)},
        "beam": {"profile": beam["name"], "steel": steel(r, catalogue)},
    }
    width = mm(r.uniform(beam["b"], min(room(column), 2 * beam["b"] + 200)))
    return beam_on_plate(r, catalogue, spec, beam, width)


def extras(r, spec, given, beam, column, bolt, gauges):
    """Further parts of the beam-to-column joint."""
    _, corner = hexagon(bolt)
    given["double_sided"] = r.random() < 0.3
    far = max(4 * corner + 2, 4.8 * bolt["hole_normal"]) + 1
    if gauges[0] + far < gauges[1] and r.random() < 0.4:
        spec["bolts"]["gauge"] = mm(r.uniform(gauges[0], gauges[1] - far))
        given["outer_gauge"] = mm(r.uniform(spec["bolts"]["gauge"] + far, gauges[1]))
    if given["column_stiffeners"] and r.random() < 0.3:
        given["stiffener_weld"] = r.choice([3, 5, 6])
    if r.random() < 0.2:
        given["doubler"] = True
        if r.random() < 0.5:
            given["doubler_thickness"] = mm(r.uniform(4, 1.5 * column["tw"] + 4))
    if r.random() < 0.25 and spec["plate"]["z"][1] > beam["h"] / 2 + 21:
        given["rib"] = True
        given["rib_weld"] = r.choice([0, 4])


def tees(r, catalogue, spec):
    tee = r.choice(catalogue.profiles)
    spec["members"] = {"tee": {"profile": tee["name"], "steel": steel(r, catalogue)}}
    given = flags(r, [])
    web, width = tee["tw"] + 2 * tee["r"], tee["b"]
    if r.random() < 0.4:
        given["welded"] = True
        web, width = tee["tw"], tee["b"]
        if r.random() < 0.5:
            given["flange_thickness"] = mm(r.uniform(5, 40))
        if r.random() < 0.5:
            width = given["flange_width"] = mm(r.uniform(60, 350))
    bolt, gauge, _ = fitting(r, catalogue, lambda f, c: web + 2 * f, lambda f, c: width - 2 * f)
    if given.get("welded"):
        high = max(bolt["head_height"], bolt["nut_height"])
        given["web_height"] = mm(high + r.uniform(1, 60))
    flat, corner = hexagon(bolt)
    pitch = max(2 * corner + 1.5, 2.2 * bolt["hole_normal"])
    rows = [i * pitch for i in range(r.choice([1, 1, 2, 3]))]
    rows = [mm(z - rows[-1] / 2) for z in rows]
    given["length"] = mm(2 * (rows[-1] + corner + r.uniform(1, 40)) + 1)
    spec["bolts"] = {"size": bolt_name(bolt), "gauge": gauge, "rows": rows}
    spec["parameters"] = given
    return tee


def text(spec, flow=False):
    """The file of a spec: a key a line, or (`flow`) all of it as JSON, which is YAML too."""
    if flow:
        return json.dumps(spec, indent=1)
    return "".join(f"{key}: {json.dumps(value)}\n" for key, value in spec.items())


def doubled(spec):
    """The same spec under twice the load."""
    out = copy.deepcopy(spec)
    for load in out["loads"]:
        for key in (*ALL_SIX, "pressure"):
            if key in load:
                value, unit = load[key].split(" ", 1)
                load[key] = f"{2 * float(value)!r} {unit}"
    return out


def upside_down(spec):
    """A splice mirrored in its horizontal plane: the actions that see the plane change sign."""
    out = copy.deepcopy(spec)
    out["plate"]["z"] = [-z for z in reversed(out["plate"]["z"])]
    out["bolts"]["rows"] = [-z for z in out["bolts"]["rows"]]
    for load in out["loads"]:
        load["at"] = "bolt_plane"
        for key in ("My", "Vz", "T"):
            if key in load:
                text = load[key]
                load[key] = text[1:] if text.startswith("-") else f"-{text}"
    return out
