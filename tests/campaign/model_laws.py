"""Exact changes of a model, and what they make of its bounds."""

import copy

from grid import Mesh


def turned(document, rows):
    """The document after a signed permutation of the axes, `rows` of a matrix."""
    out = copy.deepcopy(document)
    det = determinant(rows)
    vector = lambda v: [plain(sum(row[d] * v[d] for d in range(3))) for row in rows]
    pseudo = lambda v: [plain(det * x) for x in vector(v)]
    place = {d: next(i for i in range(3) if rows[i][d]) for d in range(3)}
    axis = lambda name: "xyz"[place["xyz".index(name)]]
    for entry in out.get("supports", []):
        if "fix" in entry:
            entry["fix"] = [axis(a) for a in entry["fix"]]
    for entry in out.get("rigid", []):
        entry["components"] = [axis(a) for a in entry["components"]]
        if "free" in entry:
            entry["free"] = [m[0] + axis(m[1]) for m in entry["free"]]
        for key, change in (("at", vector), ("force", vector), ("moment", pseudo)):
            if key in entry:
                entry[key] = change(entry[key])
    for entry in out.get("loads", []) + out.get("dead", []):
        for key in ("traction", "force"):
            if key in entry:
                entry[key] = vector(entry[key])
        if "linear" in entry:
            linear = entry["linear"]
            linear["traction0"] = vector(linear["traction0"])
            g = linear["gradient"]
            half = [vector([g[i][j] for i in range(3)]) for j in range(3)]
            linear["gradient"] = [
                vector([half[j][i] for j in range(3)]) for i in range(3)
            ]
    for entry in out.get("preload", []):
        entry["axis"] = vector(entry["axis"])
    return out


def plain(x):
    """No minus zero."""
    return x + 0.0 if x else 0.0


def determinant(m):
    return (
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    )


MIRROR = [[-1, 0, 0], [0, 1, 0], [0, 0, 1]]
QUARTER = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]


def moved(mesh, rows):
    return mesh.mapped(lambda x: [plain(sum(row[d] * x[d] for d in range(3))) for row in rows])


def loads_times(document, factor, dead):
    out = copy.deepcopy(document)
    for entry in out.get("loads", []) + (out.get("dead", []) if dead else []):
        for key in ("traction", "force"):
            if key in entry:
                entry[key] = [factor * x for x in entry[key]]
        if "pressure" in entry:
            entry["pressure"] *= factor
        if "linear" in entry:
            linear = entry["linear"]
            linear["traction0"] = [factor * x for x in linear["traction0"]]
            linear["gradient"] = [[factor * x for x in row] for row in linear["gradient"]]
    for entry in out.get("rigid", []):
        for key in ("force", "moment"):
            if key in entry:
                entry[key] = [factor * x for x in entry[key]]
    return out


def stiffer(document, factor):
    out = copy.deepcopy(document)
    for material in out["materials"].values():
        material["E"] *= factor
    return out


def stronger(document, factor):
    out = copy.deepcopy(document)
    for material in out["materials"].values():
        if "fy" in material:
            material["fy"] *= factor
    for entry in out.get("interfaces", []):
        for key in ("strength", "strength_traction"):
            if key in entry:
                entry[key] *= factor
    return out


def larger(document, factor):
    """All lengths; stresses stay."""
    out = copy.deepcopy(document)
    for entry in out.get("interfaces", []) + out.get("supports", []):
        for key in ("gap", "throat", "thickness"):
            if key in entry:
                entry[key] *= factor
    for entry in out.get("rigid", []):
        for key, power in (("at", 1), ("force", 2), ("moment", 3)):
            if key in entry:
                entry[key] = [factor**power * x for x in entry[key]]
    for entry in out.get("loads", []) + out.get("dead", []):
        if "force" in entry:
            entry["force"] = [x / factor for x in entry["force"]]
        if "linear" in entry:
            rows = entry["linear"]["gradient"]
            entry["linear"]["gradient"] = [[x / factor for x in row] for row in rows]
    for entry in out.get("preload", []):
        entry["force"] *= factor**2
    return out


def split(mesh):
    """The same mesh with nodes of their own in each body."""
    numbers, nodes, tets, owners = {}, [], [], {}
    for body, ids in mesh.tets:
        for n in ids:
            if (body, n) not in numbers:
                numbers[body, n] = len(nodes)
                nodes.append(mesh.nodes[n])
        tets.append((body, [numbers[body, n] for n in ids]))
        for leave in ids:
            owners.setdefault(tuple(sorted(n for n in ids if n != leave)), set()).add(body)
    faces = {}
    for name, triangles in mesh.faces.items():
        sides = [(b, t) for t in triangles for b in sorted(owners[tuple(sorted(t))])]
        faces[name] = [[numbers[b, n] for n in t] for b, t in sides]
    return Mesh(nodes, tets, faces)


def laws(scene, mesh):
    """Name, document, mesh, factor on the bounds: every law that holds for the scene."""
    document, features = scene.document, scene.features
    limit = document["analysis"] == "limit"
    elastic = document["analysis"] == "elastic"
    yield "mirrored", turned(document, MIRROR), moved(mesh, MIRROR), 1.0
    yield "a quarter turn", turned(document, QUARTER), moved(mesh, QUARTER), 1.0
    yield (
        "lengths x 2",
        larger(document, 2.0),
        mesh.mapped(lambda x: [2.0 * c for c in x]),
        1.0 if limit else 8.0,
    )
    homogeneous = not features & {"gap", "preload"}
    if limit:
        yield "loads x 2", loads_times(document, 2.0, False), mesh, 0.5
        yield "E x 3", stiffer(document, 3.0), mesh, 1.0
        if "dead" not in features:
            yield "f_y x 2", stronger(document, 2.0), mesh, 2.0
    elif elastic and homogeneous:
        yield "loads x 2", loads_times(document, 2.0, True), mesh, 4.0
        yield "E x 3", stiffer(document, 3.0), mesh, 1.0 / 3.0
    if "preload" not in features:
        yield "nodes: split", dict(document, nodes="split"), split(mesh), 1.0
