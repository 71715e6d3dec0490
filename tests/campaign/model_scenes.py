"""Random models of `bracket analyse`: bodies of grid cells, their laws, supports and loads.

A scene knows by construction whether the program must accept it (`refusals` is then empty), or
which codes it may be refused with.
"""

from grid import Grid


class Scene:
    def __init__(self):
        self.document = {}
        self.grid = None
        self.jitter = 0.0
        self.refusals = set()
        self.features = set()

    def cells(self):
        n = self.grid.shape
        return n[0] * n[1] * n[2]


def spread(r, low, high):
    """A number between the two, evenly in its logarithm, with three digits."""
    return float(f"{low * (high / low) ** r.random():.3g}")


def planes(r, cells, size):
    """Planes of a grid axis, evenly spaced or not."""
    steps = [1.0] * cells if r.random() < 0.5 else [spread(r, 0.4, 2.5) for _ in range(cells)]
    out, at = [0.0], 0.0
    for s in steps:
        at += s
        out.append(round(size * at / sum(steps), 6))
    return out


def outer(axis, plane, body=None):
    """Test of the outer faces on a plane of the grid."""

    def test(d, p, cells, bodies):
        return (
            d == axis and p == plane and len(bodies) == 1 and (body is None or bodies[0] in body)
        )

    return test


def materials(r, scene, kind, bodies):
    """Steels of the bodies; some never yield."""
    steels = {"s": {"E": spread(r, 2e3, 2.1e5), "nu": round(r.uniform(0, 0.45), 3)}}
    steels["s"]["fy"] = spread(r, 20, 460)
    steels["t"] = {"E": spread(r, 2e4, 4e5), "nu": 0.3, "fy": spread(r, 100, 700)}
    steels["r"] = {"E": 2.1e5, "nu": 0.25}
    names = {b: r.choice("ssst") for b in bodies}
    if r.random() < (0.2 if kind == "limit" else 0.3):
        names[r.choice(bodies)] = "r"
        scene.features.add("rigid body" if kind == "limit" else "elastic body")
        if kind == "limit":
            # the load may then reach the support through bodies that nothing moves
            scene.refusals |= {"model/program", "model/never-yields"}
    scene.document["materials"] = {k: v for k, v in steels.items() if k in names.values()}
    scene.document["bodies"] = names
    return min([steels[n]["fy"] for n in names.values() if n != "r"], default=235.0)


def contact(r, scene, kind):
    law = {"law": "contact", "mu": 0.0}
    if r.random() < 0.65:
        law["mu"] = spread(r, 0.05, 1.0)
        law["friction"] = r.choice(["associated", "associated", "coulomb"])
        scene.features.add("coulomb" if law["friction"] == "coulomb" else "associated")
    else:
        scene.features.add("frictionless")
        if r.random() < 0.5:
            law["friction"] = r.choice(["associated", "coulomb"])
    if r.random() < 0.2:
        law["gap"] = spread(r, 1e-4, 0.05)
        scene.features.add("gap")
    return law


def interface(r, scene, kind, pair):
    """Law between two bodies; `None`: tied."""
    choice = r.random()
    if choice < 0.2:
        return None
    if choice < 0.25:
        return {"between": pair, "law": "tied"}
    if choice < 0.45:
        scene.features.add("weld")
        if r.random() < 0.6:
            return {"between": pair, "law": "weld", "strength_traction": spread(r, 5, 500)}
        return {
            "between": pair,
            "law": "weld",
            "throat": spread(r, 2, 8),
            "thickness": spread(r, 5, 20),
            "strength": spread(r, 100, 300),
        }
    if r.random() < 0.5:
        pair = pair[::-1]
    return {"between": pair, **contact(r, scene, kind)}


def stack(r, scene, kind):
    """One to four slabs on each other, some as an L, on a clamp, on rollers or on rigid ground."""
    slabs = r.choice([1, 1, 2, 2, 3, 4])
    nx, ny = r.choice([1, 2, 2, 3]), r.choice([1, 1, 2, 3])
    layers = [r.choice([1, 1, 2]) for _ in range(slabs)]
    while nx * ny * sum(layers) > 60:
        nx = max(1, nx - 1)
    size = [spread(r, 5, 100), spread(r, 5, 100), spread(r, 5, 100)]
    if r.random() < 0.2:
        thin = r.randrange(3)
        cells = [nx, ny, sum(layers)]
        # one edge of the cells up to fifty times as short as the others
        size[thin] = max(size) / max(cells) * cells[thin] / spread(r, 5, 50)
        scene.features.add("slivers")
    names = [chr(ord("A") + i) for i in range(slabs)]
    level = [name for name, n in zip(names, layers) for _ in range(n)]
    nz = len(level)
    corner = (nx, nz)
    if nx > 1 and nz > 1 and r.random() < 0.3:
        corner = (r.randint(1, nx - 1), r.randint(1, nz - 1))
        scene.features.add("L")

    def body(i, j, k):
        return None if i >= corner[0] and k >= corner[1] else level[k]

    half = max(1, corner[0] // 2)
    faces = {
        "X0": outer(0, 0),
        "X1": outer(0, nx),
        "Y0": outer(1, 0),
        "Z0": outer(2, 0),
        "Z1": outer(2, nz),
        "PATCH": lambda d, p, cells, bodies: (
            d == 2 and p == nz and len(bodies) == 1 and cells[0][0] < half
        ),
    }
    axes = [planes(r, n, s) for n, s in zip((nx, ny, nz), size)]
    scene.grid = Grid(axes, body, faces)
    scene.jitter = r.choice([0.0, 0.2, 0.3])
    fy = materials(r, scene, kind, names)
    laws = [interface(r, scene, kind, list(p)) for p in zip(names, names[1:])]
    laws = [law for law in laws if law]
    if laws:
        scene.document["interfaces"] = laws
    smooth = any(law["law"] == "contact" and not law["mu"] for law in laws)
    base = r.choice(["clamp", "clamp", "rollers", "ground", "rigid"])
    supports, rigid = [], []
    if base == "clamp":
        supports.append({"face": "Z0", "fix": ["x", "y", "z"]})
    elif base == "rollers":
        supports.append({"face": "Z0", "fix": ["z"]})
        smooth = True
    elif base == "ground":
        law = contact(r, scene, kind)
        smooth |= not law["mu"]
        supports.append({"face": "Z0", **law})
        scene.features.add("ground")
    else:
        rigid.append({"face": "Z0", "components": ["x", "y", "z"]})
        scene.features.add("rigid face")
    if smooth:
        supports += [{"face": "X0", "fix": ["x"]}, {"face": "Y0", "fix": ["y"]}]
    opens = base == "ground" or any(law["law"] == "contact" for law in laws)
    top = axes[2][-1]
    live, dead, moved = stack_loads(r, scene, kind, fy, size, top, smooth, opens)
    for key, value in (("supports", supports), ("rigid", rigid + moved), ("loads", live)):
        if value:
            scene.document[key] = value
    if dead:
        scene.document["dead"] = dead
        scene.features.add("dead")


def stack_loads(r, scene, kind, fy, size, top, smooth, opens):
    """Live loads, dead loads, rigid faces that carry a load."""
    full = spread(r, 0.02, 0.4) * fy
    number = lambda low, high: round(full * r.uniform(low, high), 4)
    live, dead, moved = [], [], []
    # what opens is mostly pressed; the rest finds loads that nothing limits
    press = opens and r.random() < 0.8
    down = -abs(number(0.3, 1)) if press else number(-1, 1)
    choice = r.random()
    if choice < 0.3:
        side = [0.3, 0.3] if press else [1, 1]
        traction = [number(-side[0], side[0]), number(-side[1], side[1]), down]
        live.append({"face": r.choice(["Z1", "Z1", "PATCH"]), "traction": traction})
    elif choice < 0.5:
        live.append({"face": r.choice(["Z1", "PATCH"]), "pressure": -down})
    elif choice < 0.65:
        # along a support: ground and contacts below carry nothing
        live.append({"face": "X1", "traction": [number(-1, 1), 0.0, 0.0]})
        scene.features.add("sideways")
    elif choice < 0.75:
        gradient = [[0.0] * 3 for _ in range(3)]
        gradient[2][0] = round(full * r.uniform(-0.5, 0.5) / size[0], 6)
        live.append({"face": "Z1", "linear": {"traction0": [0.0, 0.0, down], "gradient": gradient}})
    elif choice < 0.85 and kind != "limit":
        force = [0.0, 0.0, -abs(number(0.1, 1)) / max(size)]
        live.append({"body": "ALL", "force": force})
    else:
        area = size[0] * size[1]
        entry = {"face": "Z1", "components": ["x", "y", "z"], "at": [size[0] / 2, size[1] / 2, top]}
        entry["free"] = ["ux", "uy", "uz", "rx", "ry", "rz"]
        if smooth:
            entry["components"], entry["free"] = ["z"], ["uz", "rx", "ry"]
        kept = [m for m in entry["free"] if r.random() < 0.7] or ["uz"]
        if opens and "uz" not in kept:
            kept.append("uz")
        force, moment = [0.0] * 3, [0.0] * 3
        for m in kept:
            d = "xyz".index(m[1])
            if m[0] == "u":
                force[d] = down * area if d == 2 else number(-0.3, 0.3) * area
            elif r.random() < 0.5:
                moment[d] = number(-0.1, 0.1) * area * min(size)
        if not any(force + moment):
            moment = [0.0] * 3
            d = "xyz".index(kept[0][1])
            (force if kept[0][0] == "u" else moment)[d] = full * area
        entry.update(free=kept, force=force, moment=moment)
        moved.append(entry)
        scene.features.add("rigid face")
    if r.random() < 0.25:
        weight = [0.0, 0.0, -spread(r, 1e-5, 0.02) * fy / top]
        dead.append({"body": "ALL", "force": weight})
    if r.random() < 0.15 and not moved:
        dead.append({"face": "Z1", "pressure": abs(number(0.02, 0.3))})
    return live, dead, moved


def bolted(r, scene, kind):
    """Two plates with a preloaded square bolt through them: shank, head and nut are one body."""
    steps = [spread(r, 5, 20) for _ in range(3)]
    axes = [[0.0, s, 2 * s, 3 * s] for s in steps[:2]]
    t = [spread(r, 4, 12) for _ in range(4)]
    axes.append([0.0, t[0], t[0] + t[1], t[0] + t[1] + t[2], sum(t)])

    def body(i, j, k):
        return "BOLT" if k in (0, 3) or (i == 1 and j == 1) else "LOWER" if k == 1 else "UPPER"

    faces = {
        "HOLD": outer(0, 0, ["LOWER"]),
        "PULL": outer(0, 3, ["UPPER"]),
        "TOP": outer(2, 4),
        "CUT": lambda d, p, cells, bodies: d == 2 and p == 2 and set(bodies) == {"BOLT"},
    }
    scene.grid = Grid(axes, body, faces)
    materials(r, scene, kind, ["BOLT", "LOWER", "UPPER"])
    law = {"law": "contact", "mu": r.choice([0.0, 0.1, 0.3, 0.6])}
    law["friction"] = r.choice(["associated", "coulomb"])
    scene.document["interfaces"] = [
        {"between": pair, **law}
        for pair in (["LOWER", "UPPER"], ["BOLT", "LOWER"], ["BOLT", "UPPER"])
    ]
    scene.document["supports"] = [{"face": "HOLD", "fix": ["x", "y", "z"]}]
    area = steps[0] * steps[1]
    force = round(area * spread(r, 10, 200), 3)
    scene.document["preload"] = [
        {"body": "BOLT", "cut": "CUT", "axis": [0.0, 0.0, 1.0], "force": force}
    ]
    pull = [round(r.uniform(-30, 30), 3), 0.0, round(r.uniform(-10, 10), 3)]
    scene.document["loads"] = [{"face": "PULL", "traction": pull}]
    coulomb = law["mu"] and law["friction"] == "coulomb"
    scene.features |= {"preload", "coulomb" if coulomb else "contact"}


def spoil(r, scene):
    """Makes a model wrong. The program must refuse it, or treat it as what it then is."""
    document = scene.document
    faces = [e for key in ("supports", "loads") for e in document.get(key, []) if "face" in e]
    choice = r.randrange(7)
    if choice == 0:
        document.pop("supports", None)
        document["rigid"] = [e for e in document.get("rigid", []) if e.get("free")]
        scene.refusals |= {"model/loose-part", "model/no-live-load", "model/no-load"}
    elif choice == 1:
        document["loads"] = []
        document["rigid"] = [e for e in document.get("rigid", []) if not e.get("free")]
        scene.refusals |= {"model/no-load", "model/no-live-load"}
    elif choice == 2 and faces:
        r.choice(faces)["face"] = "Q7"
        scene.refusals |= {"model/unknown-face"}
    elif choice == 3:
        document["bodies"]["Q7"] = "s"
        scene.refusals |= {"model/unknown-body", "model/unknown-material"}
    elif choice == 4:
        r.choice(list(document["materials"].values()))["nu"] = r.choice([0.5, -1.0, 0.7])
        scene.refusals |= {"model/value"}
    elif choice == 5:
        r.choice(list(document["materials"].values()))["E"] = r.choice([0.0, -1.0])
        scene.refusals |= {"model/value"}
    else:
        document["supports"] = document.get("supports", []) + [{"face": "Z0", "fix": []}]
        scene.refusals |= {"model/support", "model/unknown-face"}
    scene.features.add("spoilt")


def scene(r):
    """A random scene of a random kind of analysis."""
    out = Scene()
    kind = r.choice(["elastic", "elastoplastic", "limit", "limit"])
    bolt = r.random() < 0.08
    if bolt:
        kind = r.choice(["elastic", "elastic", "limit"])
    out.document = {"mesh": "m.msh", "analysis": kind}
    (bolted if bolt else stack)(r, out, kind)
    if r.random() < 0.12:
        out.document["adapt"] = {"target_gap": 0.01, "max_passes": 3, "max_macro_tets": 1000}
        out.features.add("adapt")
    if r.random() < 0.04:
        out.document["bounds"] = r.choice(["kinematic", "static"])
        out.features.add("one bound")
    if kind == "limit" and "coulomb" in out.features and r.random() < 0.2:
        laws = out.document.get("interfaces", []) + out.document.get("supports", [])
        if any(e.get("friction") == "coulomb" and e.get("mu") for e in laws):
            out.document["coulomb_estimate"] = True
    if r.random() < 0.05:
        spoil(r, out)
    return out
