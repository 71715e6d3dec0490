"""Random specs of joints whose bolts lap plates: fin plates, header plates, cover-plate splices."""

from spec_scenes import NoRoom, bolt_name, fitting, flags, hexagon, mm, rows_between, steel


def beam_and_column(r, catalogue, spec, to_web):
    """A beam and a column; on its web the beam goes between the flanges."""
    pairs = [
        (column, beam)
        for column in catalogue.profiles
        for beam in catalogue.profiles
        if not to_web or column["h"] - 2 * column["tf"] >= beam["b"] + 1
    ]
    column, beam = r.choice(pairs)
    spec["members"] = {
        "column": {"profile": column["name"], "steel": steel(r, catalogue)},
        "beam": {"profile": beam["name"], "steel": steel(r, catalogue)},
    }
    return column, beam


def rows_on_web(r, beam, bolt, spec, notches):
    """Rows and a plate on the flat web of the beam, and notches beside the plate."""
    flat, corner = hexagon(bolt)
    high = beam["h"] / 2 - beam["tf"] - beam["r"]
    if notches:
        depth = mm(r.uniform(beam["tf"] + beam["r"] + 0.1, beam["h"] / 3))
        high = min(high, beam["h"] / 2 - depth)
        spec["parameters"]["notch_length"] = mm(r.uniform(5, beam["h"] / 2))
        spec["parameters"]["notch_depth"] = depth
    pitch = max(2 * corner + 1.5, r.choice([2.2, 2.5, 3.5]) * bolt["hole_normal"])
    rows = rows_between(r, -high + flat + 1, high - flat - 1, pitch, 4)
    if not rows:
        raise NoRoom
    spec["bolts"]["rows"] = rows
    edge = max(flat, r.choice([1.0, 1.2, 2.0]) * bolt["hole_normal"]) + 0.5
    spec["plate"]["z"] = [mm(max(-high, rows[0] - edge)), mm(min(high, rows[-1] + edge))]


def fin_plate(r, catalogue, spec):
    to_web = r.random() < 0.4
    column, beam = beam_and_column(r, catalogue, spec, to_web)
    bolt = r.choice(catalogue.bolts)
    _, corner = hexagon(bolt)
    spec["parameters"] = flags(r, ["weld"]) | {"to_web": to_web}
    spec["bolts"] = {"size": bolt_name(bolt)}
    spec["plate"] = {"thickness": mm(r.uniform(5, 25))}
    rows_on_web(r, beam, bolt, spec, r.random() < 0.3)
    given = spec["parameters"]
    given["gap"] = r.choice([5, 10, 15, 20])
    given["end_distance"] = mm(max(corner, r.choice([1.2, 2.0]) * bolt["hole_normal"]) + 0.5)
    given["edge_distance"] = mm(max(corner, r.choice([1.2, 2.0]) * bolt["hole_normal"]) + 0.5)
    if r.random() < 0.4:
        given["two_columns"] = True
        if r.random() < 0.5:
            spec["bolts"]["gauge"] = mm(max(2 * corner + 1.5, r.uniform(2.4, 4) * bolt["d"]))
    if r.random() < 0.2:
        given["beam_held"] = False
    return beam


def header_plate(r, catalogue, spec):
    to_web = r.random() < 0.4
    column, beam = beam_and_column(r, catalogue, spec, to_web)
    room = column["h"] - 2 * (column["tf"] + column["r"]) if to_web else column["b"]
    web = beam["tw"] if to_web else max(beam["tw"], column["tw"] + 2 * column["r"])
    bolt, gauge, _ = fitting(r, catalogue, lambda f, c: web + 2 * c + 2, lambda f, c: room - 2 * c)
    _, corner = hexagon(bolt)
    spec["parameters"] = flags(r, ["weld"]) | {"to_web": to_web}
    spec["bolts"] = {"size": bolt_name(bolt), "gauge": gauge}
    spec["plate"] = {
        "thickness": mm(r.uniform(5, 25)),
        "width": mm(r.uniform(gauge + 2 * corner + 0.2, room)),
    }
    rows_on_web(r, beam, bolt, spec, r.random() < 0.3)
    return beam


def cover_splice(r, catalogue, spec):
    beam = r.choice(catalogue.profiles)
    spec["members"] = {"beam": {"profile": beam["name"], "steel": steel(r, catalogue)}}
    web = beam["tw"] + 2 * beam["r"]
    width = mm(r.uniform(0.7, 1.0) * beam["b"])
    bolt, gauge, _ = fitting(r, catalogue, lambda f, c: web + 2 * c + 2, lambda f, c: width - 2 * c)
    flat, corner = hexagon(bolt)
    spec["bolts"] = {"size": bolt_name(bolt), "gauge": gauge}
    spec["plate"] = {"thickness": mm(r.uniform(5, 25)), "width": width}
    given = flags(r, [])
    gap = given["gap"] = r.choice([5, 10, 20])
    pitch = max(2 * corner + 1.5, r.choice([2.2, 3.0]) * bolt["hole_normal"])
    first = mm(gap / 2 + max(corner, r.choice([1.2, 2.0]) * bolt["hole_normal"]) + 0.5)
    number = r.choice([1, 2, 2, 3])
    given["flange_columns"] = [mm(first + i * pitch) for i in range(number)]
    last = given["flange_columns"][-1]
    given["flange_cover"] = mm(last + max(corner, 1.3 * bolt["hole_normal"]) + 0.5)
    nut = max(bolt["head_height"], bolt["nut_height"])
    high = min(beam["h"] / 2 - beam["tf"] - beam["r"], beam["h"] / 2 - beam["tf"] - nut - 2)
    rows = rows_between(r, -high + corner + 1, high - corner - 1, pitch, 3)
    if not rows:
        raise NoRoom
    given["web_rows"] = rows
    given["web_height"] = mm(2 * (max(abs(z) for z in rows) + corner + 0.5))
    given["web_thickness"] = mm(r.uniform(4, 15))
    given["web_column"] = first
    last = first
    if r.random() < 0.3:
        given["web_columns"] = 2
        given["web_pitch"] = mm(pitch)
        last += pitch
    given["web_cover"] = mm(last + max(corner, 1.3 * bolt["hole_normal"]) + 0.5)
    given["beam_length"] = mm(max(given["flange_cover"], given["web_cover"]) + beam["h"])
    spec["parameters"] = given
    return beam


SCENES = {
    "fin_plate": fin_plate,
    "header_plate": header_plate,
    "cover_plate_splice": cover_splice,
}
