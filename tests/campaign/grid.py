"""Meshes of bodies made of the cells of a grid, written as gmsh 2.2 ASCII."""

from itertools import permutations


class Grid:
    """A grid of cells. `body(i, j, k)` names the body of a cell, `None` leaves it empty.

    `faces` maps the name of a physical surface to a test of (axis, plane, cell, other cell), with
    planes and cells of the coarse grid. `jitter` moves nodes inside bodies and faces; the bodies
    stay what they are.
    """

    def __init__(self, planes, body, faces):
        self.planes, self.body, self.faces = planes, body, faces
        self.shape = [len(p) - 1 for p in planes]

    def mesh(self, fine=1, jitter=0.0, random=None):
        """Nodes, tets with their bodies, and triangles of the named faces."""
        lines = [subdivided(p, fine) for p in self.planes]
        n = [len(line) - 1 for line in lines]

        def owner(i, j, k):
            if min(i, j, k) < 0 or i >= n[0] or j >= n[1] or k >= n[2]:
                return None
            return self.body(i // fine, j // fine, k // fine)

        numbers, nodes, places = {}, [], []

        def node(p):
            if p not in numbers:
                numbers[p] = len(nodes)
                places.append(p)
                nodes.append([lines[d][p[d]] for d in range(3)])
            return numbers[p]

        bodies = {}
        tets, owners = [], {}
        for i in range(n[0]):
            for j in range(n[1]):
                for k in range(n[2]):
                    name = owner(i, j, k)
                    if name is None:
                        continue
                    bodies.setdefault(name, len(bodies))
                    for corners in kuhn(i, j, k):
                        ids = [node(p) for p in corners]
                        for leave in range(4):
                            rest = [corners[m] for m in range(4) if m != leave]
                            key = tuple(sorted(ids[m] for m in range(4) if m != leave))
                            owners.setdefault(key, []).append((name, (i, j, k), rest, len(tets)))
                        tets.append((name, ids))
        named = {name: [] for name in self.faces}
        for key, sides in owners.items():
            flat = plane_of(sides[0][2])
            if flat is None or flat[1] % fine:
                continue
            cells = [tuple(c // fine for c in s[1]) for s in sides]
            for name, test in self.faces.items():
                pair = [s[0] for s in sides]
                if test(flat[0], flat[1] // fine, cells, pair):
                    named[name].append(list(key))
        if jitter and random:
            for p, x in zip(places, nodes):
                free = [d for d in range(3) if self.slides(owner, p, d)]
                # a border of a named face inside a plane must stay; only nodes inside bodies move
                if len(free) == 3:
                    for d in free:
                        step = min(
                            lines[d][p[d]] - lines[d][p[d] - 1], lines[d][p[d] + 1] - lines[d][p[d]]
                        )
                        x[d] += jitter * step * random.uniform(-1, 1)
        return Mesh(nodes, tets, {k: v for k, v in named.items() if v})

    @staticmethod
    def slides(owner, p, d):
        """True if the bodies around a node are the same on both sides along an axis."""
        others = [e for e in range(3) if e != d]
        for a in (-1, 0):
            for b in (-1, 0):
                cell = list(p)
                cell[others[0]] += a
                cell[others[1]] += b
                before = list(cell)
                before[d] -= 1
                here, there = owner(*cell), owner(*before)
                if here is None or here != there:
                    return False
        return True


class Mesh:
    """Nodes, (body, tet), and the triangles of named faces; nodes are counted from 0."""

    def __init__(self, nodes, tets, faces):
        self.nodes, self.tets, self.faces = nodes, tets, faces

    def mapped(self, place):
        return Mesh([place(x) for x in self.nodes], self.tets, self.faces)

    def bodies(self):
        return list(dict.fromkeys(name for name, _ in self.tets))

    def text(self):
        bodies = self.bodies()
        out = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames"]
        out.append(str(len(bodies) + len(self.faces)))
        out += [f'2 {1001 + i} "{name}"' for i, name in enumerate(self.faces)]
        out += [f'3 {1 + i} "{name}"' for i, name in enumerate(bodies)]
        out += ["$EndPhysicalNames", "$Nodes", str(len(self.nodes))]
        out += [f"{i + 1} {x[0]!r} {x[1]!r} {x[2]!r}" for i, x in enumerate(self.nodes)]
        out += ["$EndNodes", "$Elements"]
        elements = []
        for i, triangles in enumerate(self.faces.values()):
            for t in triangles:
                elements.append(f"2 2 {1001 + i} {1001 + i} " + " ".join(str(n + 1) for n in t))
        number = {name: 1 + i for i, name in enumerate(bodies)}
        for name, ids in self.tets:
            b = number[name]
            ids = " ".join(str(n + 1) for n in oriented(self.nodes, ids))
            elements.append(f"4 2 {b} {b} {ids}")
        out.append(str(len(elements)))
        out += [f"{i + 1} {line}" for i, line in enumerate(elements)]
        out.append("$EndElements")
        return "\n".join(out) + "\n"


def subdivided(plane, fine):
    out = [plane[0]]
    for a, b in zip(plane, plane[1:]):
        out += [a + (b - a) * m / fine for m in range(1, fine)] + [b]
    return out


def kuhn(i, j, k):
    """The six tets of a cell along its diagonal: neighbours match."""
    for order in permutations(range(3)):
        p = [i, j, k]
        corners = [tuple(p)]
        for d in order:
            p[d] += 1
            corners.append(tuple(p))
        yield corners


def plane_of(corners):
    """Axis and number of the grid plane that holds a triangle; `None` inside a cell."""
    for d in range(3):
        if corners[0][d] == corners[1][d] == corners[2][d]:
            return d, corners[0][d]
    return None


def oriented(nodes, ids):
    a, b, c, d = (nodes[n] for n in ids)
    u, v, w = ([q[m] - a[m] for m in range(3)] for q in (b, c, d))
    volume = (
        u[0] * (v[1] * w[2] - v[2] * w[1])
        - u[1] * (v[0] * w[2] - v[2] * w[0])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
    )
    return ids if volume > 0 else [ids[0], ids[1], ids[3], ids[2]]
