"""One changed value in a finished result: where it stands, what it was, what it is."""

import copy
import json
import math
import re
import struct


class NoChange(Exception):
    """Nothing to change at the drawn place."""


def leaves(node, path=()):
    """Paths of all values of a JSON document, empty lists and objects included."""
    if isinstance(node, (dict, list)) and node:
        items = node.items() if isinstance(node, dict) else enumerate(node)
        for key, value in items:
            yield from leaves(value, (*path, key))
    else:
        yield path


def at(node, path):
    for step in path:
        node = node[step]
    return node


def words(path):
    """`cases[].history[].seconds`: the key without numbers."""
    out = ""
    for step in path:
        out += "[]" if isinstance(step, int) else ("." if out else "") + step
    return out


def other_number(r, x):
    """Another number: a little or a lot off."""
    if isinstance(x, int) and not isinstance(x, bool):
        return x + r.choice([-1, 1, 2, 10])
    if x == 0.0:
        return r.choice([1e-3, -1e-3, 1.0])
    return x * (1.0 + r.choice([-1, 1]) * 10.0 ** r.uniform(-6, 0.3))


OTHER_WORD = {
    "ok": "not_ok", "not_ok": "ok", "undecided": "ok", "none": "ok",
    "elastic": "limit", "limit": "elastic", "failed": "ok", "information": "ok",
    "frictionless": "coulomb", "associated": "frictionless", "coulomb": "associated",
    "optimal": "time limit",
}


def json_change(r, document):
    """Changes one value, or takes a key or an entry out, or doubles an entry."""
    out = copy.deepcopy(document)
    path = r.choice(list(leaves(out)))
    if r.random() < 0.15 and path:
        path = path[: r.randint(1, len(path))]
        return removed_or_doubled(r, out, path)
    old = at(out, path)
    if isinstance(old, bool):
        new = not old
    elif isinstance(old, (int, float)):
        new = other_number(r, old)
    elif isinstance(old, str):
        new = OTHER_WORD.get(old) or old + r.choice(["x", " 2", "0"])
    elif isinstance(old, list):
        new = ["more"]
    else:
        raise NoChange
    at(out, path[:-1])[path[-1]] = new
    return out, words(path), old, new


def removed_or_doubled(r, out, path):
    holder, last = at(out, path[:-1]), path[-1]
    old = holder[last]
    if isinstance(holder, list) and r.random() < 0.5:
        holder.insert(last, copy.deepcopy(old))
        return out, words(path) + " doubled", shown(old), "twice"
    del holder[last]
    return out, words(path) + " removed", shown(old), "nothing"


def shown(value):
    return json.dumps(value)[:80]


NUMBER = re.compile(r"(?<![\w.])-?\d+(\.\d+)?(e[-+]?\d+)?(?![\w.])", re.I)


def text_change(r, text, lines=lambda line: True):
    """Another number in a text; only lines that pass the test are touched."""
    rows = text.split("\n")
    places = [
        (i, m) for i, row in enumerate(rows) if lines(row) for m in NUMBER.finditer(row)
    ]
    if not places:
        raise NoChange
    i, m = r.choice(places)
    old = float(m.group())
    new = other_number(r, old)
    rows[i] = rows[i][: m.start()] + repr(new) + rows[i][m.end() :]
    return "\n".join(rows), rows[i].split(":")[0].strip() or f"line {i + 1}", old, new


def mesh_change(r, text):
    """Moves a node, or gives a tet another node or body."""
    rows = text.split("\n")
    first, last = rows.index("$Nodes") + 2, rows.index("$EndNodes")
    start, end = rows.index("$Elements") + 2, rows.index("$EndElements")
    if r.random() < 0.6:
        i = r.randrange(first, last)
        row = rows[i].split(" ")
        k = r.randint(1, 3)
        old = float(row[k])
        new = other_number(r, old)
        row[k] = repr(new)
        key = "node"
    else:
        i = r.choice([m for m in range(start, end) if rows[m].split(" ")[1] == "4"])
        row = rows[i].split(" ")
        k = r.choice([3, 5, 6, 7, 8])
        old = int(row[k])
        new = old + r.choice([-1, 1])
        row[k] = str(new)
        key = "tet body" if k == 3 else "tet node"
    rows[i] = " ".join(row)
    return "\n".join(rows), key, old, new


ARRAY = re.compile(rb'<DataArray type="(\w+)" Name="(\w+)"[^>]*offset="(\d+)"')


def field_change(r, data):
    """Another value of one array of a field file."""
    base = data.index(b"<AppendedData")
    base = data.index(b"_", base) + 1
    arrays = ARRAY.findall(data[:base])
    kind, name, offset = r.choice(arrays)
    at = base + int(offset)
    size = struct.unpack_from("<Q", data, at)[0]
    width = {b"Float64": 8, b"Int64": 8, b"UInt8": 1}[kind]
    n = size // width
    if n == 0:
        raise NoChange
    at += 8
    out = bytearray(data)
    pick = r.randrange(n)
    if kind == b"Float64":
        values = struct.unpack_from(f"<{n}d", data, at)
        size = max(abs(v) for v in values if math.isfinite(v))
        old = values[pick]
        # a change that counts against the largest value of the array
        new = old + r.choice([-1, 1]) * (size or 1.0) * 10.0 ** r.uniform(-5, 0)
        struct.pack_into("<d", out, at + 8 * pick, new)
    else:
        code = "<q" if kind == b"Int64" else "<B"
        old = struct.unpack_from(code, data, at + width * pick)[0]
        new = old + 1
        struct.pack_into(code, out, at + width * pick, new)
    return bytes(out), name.decode(), old, new
