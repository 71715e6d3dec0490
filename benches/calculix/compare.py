"""Solves the model of a result folder with CalculiX and prints its cost and its answer beside Bracket's.

usage: compare.py RESULT_FOLDER [--threads N] [--stiffness K] [--stick-ratio R] [--cpu S] [--work DIR]

RESULT_FOLDER is what `bracket run SPEC.yaml --out RESULT_FOLDER` wrote: `model.yaml`, `mesh.msh` and `result.json` are
read. The same straight-sided tetrahedra become C3D10 elements (E and nu of the model), the contact interfaces become
surface-to-surface penalty contact with Coulomb friction. What the input cannot express is an error, never left out.
Needs Python 3.9 and `ccx` on PATH (or its path in the variable CCX), nothing else. Units: mm, N, MPa, N mm.
"""

import argparse
import json
import math
import os
import pathlib
import resource
import subprocess
import sys
import time

# Local vertices of the faces S1..S4 and of the mid-edge nodes 5..10 of C3D10 (CalculiX manual, "Ten-node tetrahedral
# element"); entry i of FACES is face S(i+1).
FACES = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))
EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))
AXES = {"x": 0, "y": 1, "z": 2}


def fail(message):
    """Ends the program with one sentence."""
    sys.exit(f"compare.py: {message}")


# --- model.yaml and mesh.msh ------------------------------------------------------------------------------------------


def parse_yaml(text):
    """The block style that `bracket run` writes: mappings, lists, scalars. Anything else is an error."""
    lines = []
    for row in text.splitlines():
        if row.strip() and not row.lstrip().startswith("#"):
            lines.append([len(row) - len(row.lstrip()), row.strip()])

    def scalar(word):
        if word[0] in "[{&*|>!":
            fail(f"model.yaml: `{word}` is not in the block style that `bracket run` writes")
        try:
            return float(word)
        except ValueError:
            return word.strip("'\"")

    def block(at):
        indent, first = lines[at]
        if first.startswith("- "):
            items = []
            while at < len(lines) and lines[at][0] == indent and lines[at][1].startswith("- "):
                lines[at] = [indent + 2, lines[at][1][2:].strip()]
                item, at = block(at)
                items.append(item)
            return items, at
        if not (first.endswith(":") or ": " in first):
            return scalar(first), at + 1
        entries = {}
        while at < len(lines) and lines[at][0] == indent and not lines[at][1].startswith("- "):
            key, _, rest = lines[at][1].partition(":")
            at += 1
            if rest.strip():
                entries[key] = scalar(rest.strip())
            elif at < len(lines) and (lines[at][0] > indent or lines[at][0] == indent and lines[at][1][:2] == "- "):
                entries[key], at = block(at)
            else:
                fail(f"model.yaml: `{key}` has no value")
        return entries, at

    model, end = block(0)
    if end != len(lines):
        fail(f"model.yaml: cannot read `{lines[end][1]}`")
    return model


def check_model(model):
    """Refuses what the CalculiX input below does not express."""

    def only(what, entry, allowed):
        for key in entry:
            if key not in allowed:
                fail(f"{what}: `{key}` is not translated")

    allowed = "mesh nodes analysis bounds materials bodies interfaces supports loads symmetry adapt"
    only("model.yaml", model, allowed.split())
    if model["analysis"] != "elastic" or model["nodes"] != "shared":
        fail("only `analysis: elastic` with `nodes: shared` is translated")
    for entry in model.get("interfaces", []):
        only("interface", entry, ("between", "face", "law", "mu", "gap", "friction"))
        if entry["law"] != "contact" or "face" not in entry or entry.get("gap", 0.0) != 0.0:
            fail("only `law: contact` on a named `face` without a gap is translated")
    for entry in model["supports"]:
        only("support", entry, ("face", "fix"))
    for entry in model["loads"]:
        only("load", entry, ("face", "traction"))


def read_msh(path):
    """Nodes, tets (vertices, body name) and named triangles of a gmsh 2.2 ASCII mesh."""
    words = iter(path.read_text(encoding="utf-8").splitlines())
    names, nodes, tets, triangles = {}, {}, [], {}
    for line in words:
        if line == "$MeshFormat" and next(words).split()[0] != "2.2":
            fail("mesh.msh: only format 2.2 is read")
        if line == "$PhysicalNames":
            for _ in range(int(next(words))):
                dim, tag, name = next(words).split(maxsplit=2)
                names[int(dim), int(tag)] = name.strip('"')
        if line == "$Nodes":
            for _ in range(int(next(words))):
                tag, *xyz = next(words).split()
                nodes[int(tag)] = tuple(map(float, xyz))
        if line == "$Elements":
            for _ in range(int(next(words))):
                _, kind, count, physical, *rest = map(int, next(words).split())
                vertices = tuple(rest[count - 1 :])
                if kind == 4:
                    tets.append((vertices, names[3, physical]))
                elif kind == 2:
                    triangles.setdefault(names[2, physical], []).append(vertices)
                else:
                    fail(f"mesh.msh: element type {kind} is neither triangle nor tetrahedron")
    return nodes, tets, triangles


# --- vectors ----------------------------------------------------------------------------------------------------------


def minus(a, b):
    return tuple(p - q for p, q in zip(a, b))


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


# --- quadratic mesh with nodes of its own on either side of every contact ---------------------------------------------


class Mesh:
    """C3D10 mesh: `xyz` by node (from 1), `elements` (ten nodes, body), `sides` of a triangle as (element, face)."""

    def __init__(self, nodes, tets, open_triangles):
        """Vertices and edges get one copy per set of tets joined through faces that contain them and are not open:
        the rule by which Bracket splits its mesh, so bodies stay tied wherever no contact is named."""
        self.sides = {}
        for e, (t, _) in enumerate(tets):
            for f, local in enumerate(FACES):
                self.sides.setdefault(frozenset(t[v] for v in local), []).append((e, f))
        parent = list(range(10 * len(tets)))

        def root(i):
            while parent[i] != i:
                parent[i] = parent[parent[i]]
                i = parent[i]
            return i

        # `places` of a tet: its 4 vertices and 6 edges, in the order of the nodes of C3D10
        places = [[frozenset([v]) for v in t] + [frozenset((t[a], t[b])) for a, b in EDGES] for t, _ in tets]
        for key, owners in self.sides.items():
            if len(owners) == 2 and key not in open_triangles:
                (p, _), (q, _) = owners
                for i, place in enumerate(places[p]):
                    if place <= key:
                        a, b = root(10 * p + i), root(10 * q + places[q].index(place))
                        parent[max(a, b)] = min(a, b)
        number = {}
        self.xyz, self.elements = [None], []
        for e, (_, body) in enumerate(tets):
            ten = []
            for i, place in enumerate(places[e]):
                r = root(10 * e + i)
                if r not in number:
                    number[r] = len(self.xyz)
                    corners = [nodes[v] for v in place]
                    self.xyz.append(tuple(sum(c) / len(corners) for c in zip(*corners)))
                ten.append(number[r])
            self.elements.append((ten, body))
        self.places = places
        self.ties = []

    def part(self, pairs):
        """Copies the nodes that the two sides of a contact have in common, at the rim where the contact ends in a tie:
        all elements of the slave's body take the copy, and `ties` lists (copy, original) to be held together by
        equations. CalculiX counts the unsymmetric stiffness of a contact element with a repeated node twice on the
        diagonal (add_sm_st_as.f called from mafillsmas.f, version 2.20): with friction the iteration then diverges."""
        common = set()
        for (slave, f), (master, _) in (row for rows in pairs for row in rows):
            body = self.elements[slave][1]
            common |= {(body, a) for a, b in self.partners(slave, f, master) if a == b}
        copies = {}
        for body, node in sorted(common):
            copies[body, node] = len(self.xyz)
            self.ties.append((len(self.xyz), node))
            self.xyz.append(self.xyz[node])
        for ten, body in self.elements:
            ten[:] = [copies.get((body, n), n) for n in ten]

    def outside(self, triangle):
        """The (element, face) of a triangle on the boundary of the whole mesh."""
        sides = self.sides.get(frozenset(triangle), [])
        if len(sides) != 1:
            fail(f"triangle {triangle} is not on the boundary")
        return sides[0]

    def face_nodes(self, e, f):
        """Six nodes of a face: three vertices, three mid-edges."""
        ten = self.elements[e][0]
        local = FACES[f] + tuple(i for i in range(4, 10) if set(EDGES[i - 4]) <= set(FACES[f]))
        return [ten[i] for i in local]

    def partners(self, e, f, other):
        """Pairs of each of the six face nodes and the node of tet `other` at the same place."""
        mine = self.elements[e][0]
        theirs = dict(zip(self.places[other], self.elements[other][0]))
        return [(n, theirs[self.places[e][mine.index(n)]]) for n in self.face_nodes(e, f)]

    def area_normal(self, e, f):
        """Area times the unit normal out of tet `e` on its face `f`."""
        a, b, c = (self.xyz[self.elements[e][0][v]] for v in FACES[f])
        n = tuple(0.5 * k for k in cross(minus(b, a), minus(c, a)))
        opposite = self.xyz[self.elements[e][0][6 - sum(FACES[f])]]
        return tuple(-k for k in n) if dot(n, minus(opposite, a)) > 0.0 else n


# --- CalculiX ---------------------------------------------------------------------------------------------------------


def nodal_forces(model, mesh, triangles):
    """Consistent forces: the integral of a uniform traction over a straight 6-node triangle is A/3 at each mid-edge."""
    forces = {}
    for load in model["loads"]:
        for triangle in triangles[load["face"]]:
            e, f = mesh.outside(triangle)
            share = math.sqrt(dot(mesh.area_normal(e, f), mesh.area_normal(e, f))) / 3.0
            for node in mesh.face_nodes(e, f)[3:]:
                old = forces.get(node, (0.0, 0.0, 0.0))
                forces[node] = tuple(p + share * t for p, t in zip(old, load["traction"]))
    return forces


def contact_sides(model, mesh, tets, triangles):
    """(slave side, master side) of the triangles of every interface; the body named first is the slave."""
    pairs = []
    for entry in model.get("interfaces", []):
        rows = []
        for triangle in triangles[entry["face"]]:
            sides = mesh.sides[frozenset(triangle)]
            if sorted(tets[e][1] for e, _ in sides) != sorted(entry["between"]):
                fail(f"a triangle of {entry['face']} does not lie between {entry['between']}")
            rows.append(tuple(sorted(sides, key=lambda s: tets[s[0]][1] != entry["between"][0])))
        pairs.append(rows)
    return pairs


def write_input(path, model, mesh, triangles, pairs, forces, arguments):
    """The CalculiX input."""
    out = ["*NODE, NSET=NALL"]
    out += [f"{n}, " + ", ".join(f"{x:.12g}" for x in xyz) for n, xyz in enumerate(mesh.xyz) if n]
    for body in model["bodies"]:
        out.append(f"*ELEMENT, TYPE=C3D10, ELSET={body}")
        out += [f"{e + 1}, " + ", ".join(map(str, ten)) for e, (ten, b) in enumerate(mesh.elements) if b == body]
    for name, material in model["materials"].items():
        out += [f"*MATERIAL, NAME={name}", "*ELASTIC", f"{material['E']}, {material['nu']}"]
    for body, material in model["bodies"].items():
        out.append(f"*SOLID SECTION, ELSET={body}, MATERIAL={material}")
    for i, (entry, rows) in enumerate(zip(model.get("interfaces", []), pairs)):
        for name, side in (("SLAVE", 0), ("MASTER", 1)):
            out.append(f"*SURFACE, NAME={name}{i}, TYPE=ELEMENT")
            out += [f"{r[side][0] + 1}, S{r[side][1] + 1}" for r in rows]
        out += [f"*SURFACE INTERACTION, NAME=LAW{i}", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR"]
        out.append(f"{arguments.stiffness}")
        if entry["mu"] > 0.0:
            out += ["*FRICTION", f"{entry['mu']}, {arguments.stiffness * arguments.stick_ratio}"]
        out += [f"*CONTACT PAIR, INTERACTION=LAW{i}, TYPE=SURFACE TO SURFACE", f"SLAVE{i}, MASTER{i}"]
    fixed = set()
    for support in model["supports"]:
        for triangle in triangles[support["face"]]:
            e, f = mesh.outside(triangle)
            fixed |= {(n, AXES[a]) for n in mesh.face_nodes(e, f) for a in support["fix"]}
    for pair in mesh.ties:
        for axis in range(3):
            # a fixed node cannot depend on another one: then both are fixed
            held = {(n, axis) for n in pair}
            if held & fixed:
                fixed |= held
            else:
                out += ["*EQUATION", "2", f"{pair[0]}, {axis + 1}, 1., {pair[1]}, {axis + 1}, -1."]
    out.append("*BOUNDARY")
    out += [f"{n}, {a + 1}, {a + 1}" for n, a in sorted(fixed)]
    out += ["*STEP, INC=1000", "*STATIC", "1., 1.", "*CLOAD"]
    for node, force in sorted(forces.items()):
        out += [f"{node}, {a + 1}, {f:.12g}" for a, f in enumerate(force) if f != 0.0]
    out += ["*NODE PRINT, NSET=NALL, FREQUENCY=100000", "U"]
    out += ["*END STEP", ""]
    path.write_text("\n".join(out), encoding="utf-8")


def run_ccx(work, threads):
    """Runs ccx on `job.inp` in `work`; CPU and wall seconds, peak memory in MiB."""
    program = os.environ.get("CCX", "ccx")
    # OMP_NUM_THREADS is the default of all other thread settings of CalculiX, which are therefore removed
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("CCX_NPROC", "NUMBER_OF_"))}
    environment["OMP_NUM_THREADS"] = str(threads)
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    with open(work / "job.log", "w", encoding="utf-8") as log:
        try:
            code = subprocess.call([program, "-i", "job"], cwd=work, env=environment, stdout=log, stderr=log)
        except FileNotFoundError:
            fail(f"`{program}` was not found: install CalculiX (Debian: calculix-ccx) or set CCX to its path")
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if code != 0:
        fail(f"ccx ended with code {code}, see {work / 'job.log'}")
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return cpu, wall, after.ru_maxrss / 1024.0


def read_iterations(path):
    """(increments, iterations in all attempts) from the table of `job.sta`; an unfinished step is an error."""
    rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()[2:]]
    if not rows or rows[-1][2].endswith("U") or float(rows[-1][5]) != 1.0:
        fail("CalculiX did not reach the full load")
    return sum(not r[2].endswith("U") for r in rows), sum(int(r[3]) for r in rows)


def read_dat(path):
    """Displacements by node from `job.dat`, which holds those of the last increment only."""
    rows = (line.split() for line in path.read_text(encoding="utf-8").splitlines())
    return {int(r[0]): tuple(map(float, r[1:])) for r in rows if len(r) == 4}


# --- comparison -------------------------------------------------------------------------------------------------------


def contact_state(mesh, pairs, u):
    """Largest penetration and largest jump of displacement over the six nodes of every contact triangle, mm."""
    penetration, jump = 0.0, 0.0
    for (slave, f), (master, _) in (row for rows in pairs for row in rows):
        n = mesh.area_normal(slave, f)
        length = math.sqrt(dot(n, n))
        for a, b in mesh.partners(slave, f, master):
            g = minus(u[b], u[a])
            penetration = max(penetration, -dot(g, n) / length)
            jump = max(jump, math.sqrt(dot(g, g)))
    return penetration, jump


def bracket_result(folder, tets):
    """The only load case of `result.json` and its last pass, which must have been computed on this mesh."""
    cases = json.loads((folder / "result.json").read_text(encoding="utf-8"))["cases"]
    if len(cases) != 1:
        fail(f"{len(cases)} load cases in result.json, one is compared")
    last = cases[0]["history"][-1]
    if len(tets) != last["macro_tets"]:
        fail(f"mesh.msh has {len(tets)} tets, the last pass of result.json {last['macro_tets']}")
    return cases[0], last


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result", type=pathlib.Path, metavar="RESULT_FOLDER")
    parser.add_argument("--threads", type=int, default=1, help="OMP_NUM_THREADS of ccx (default 1)")
    parser.add_argument("--stiffness", type=float, help="pressure per penetration K, N/mm3 (default: E/mm)")
    parser.add_argument("--stick-ratio", type=float, default=0.1, help="stick slope over K (default 0.1)")
    parser.add_argument("--cpu", type=float, help="CPU seconds of the Bracket run (default: see the printed line)")
    parser.add_argument("--work", type=pathlib.Path, help="folder for CalculiX (default: RESULT_FOLDER-calculix)")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    folder = arguments.result.resolve()
    work = arguments.work or folder.with_name(folder.name + "-calculix")
    work.mkdir(parents=True, exist_ok=True)
    start = time.perf_counter()
    model = parse_yaml((folder / "model.yaml").read_text(encoding="utf-8"))
    check_model(model)
    nodes, tets, triangles = read_msh(folder / model["mesh"])
    case, last = bracket_result(folder, tets)
    if arguments.stiffness is None:
        arguments.stiffness = max(m["E"] for m in model["materials"].values())
    open_triangles = {frozenset(t) for entry in model.get("interfaces", []) for t in triangles[entry["face"]]}
    mesh = Mesh(nodes, tets, open_triangles)
    pairs = contact_sides(model, mesh, tets, triangles)
    mesh.part(pairs)
    forces = nodal_forces(model, mesh, triangles)
    write_input(work / "job.inp", model, mesh, triangles, pairs, forces, arguments)
    written = time.perf_counter() - start

    cpu, wall, memory = run_ccx(work, arguments.threads)
    increments, iterations = read_iterations(work / "job.sta")
    u = read_dat(work / "job.dat")
    if len(u) != len(mesh.xyz) - 1:
        fail(f"{len(u)} displacements for {len(mesh.xyz) - 1} nodes in job.dat")
    copies = model.get("symmetry", 1.0)
    potential = -0.5 * copies * sum(dot(f, u[n]) for n, f in forces.items())
    penetration, jump = contact_state(mesh, pairs, u)
    largest = max(math.sqrt(dot(v, v)) for v in u.values())
    lower, upper = case["lower"], case["upper"]
    programs = [(name, last[name]) for name in ("kinematic", "static")]
    total = sum(program["seconds"] for _, program in programs)
    if arguments.cpu is None:
        # result.json holds wall seconds; each program runs on one thread, so on a quiet machine they are CPU seconds
        spent, source = total, "seconds of both programs, mesh not counted"
    else:
        spent, source = arguments.cpu, f"{arguments.cpu:g} CPU seconds as given"
    where = "inside" if lower <= potential <= upper else "below" if potential < lower else "above"
    slope, stick = arguments.stiffness, arguments.stiffness * arguments.stick_ratio

    lines = [
        f"{folder.name}: {len(tets)} tets, {sum(map(len, pairs))} contact triangles; energies times {copies:g}",
        f"CalculiX: {len(mesh.xyz) - 1} nodes, {len(mesh.ties)} tied by equations; input written in {written:.1f} s",
        f"  K {slope:g} N/mm3, stick slope {stick:g} N/mm3, {arguments.threads} thread(s)",
        f"  CPU {cpu:.1f} s, wall {wall:.1f} s, {iterations} iterations in {increments} increment(s), {memory:.0f} MiB",
        f"  largest penetration {penetration:.2e} mm",
        f"    {100 * penetration / jump:.2f} % of the largest jump across a contact, {jump:.4f} mm",
        f"    {100 * penetration / largest:.2f} % of the largest displacement, {largest:.4f} mm",
        f"  -1/2 F.u = {potential:.0f} N mm",
        f"Bracket, {case['problem']} problem, certificate strict: {case['certificate']['strict']}",
    ]
    for name, program in programs:
        lines.append(f"  {name} program {program['seconds']:.1f} s, {program['iterations']} iterations")
    lines += [
        f"  both {total:.1f} s, {last['peak_memory_mib']:.0f} MiB; mesh {last['mesh_seconds']:.1f} s",
        f"  potential energy in [{lower:.0f}, {upper:.0f}] N mm, gap {100 * case['gap']:.2f} %, no penetration",
        "CalculiX over Bracket:",
        f"  CPU seconds {cpu / spent:.2f} (Bracket: {source}), memory {memory / last['peak_memory_mib']:.2f}",
        f"  -1/2 F.u is {where} the bracket, {100 * (potential / upper - 1.0):+.2f} % from the upper bound",
    ]
    print("\n".join(lines))


if __name__ == "__main__":
    main()
