"""Random specs of column bases on concrete."""

from math import ceil

from spec_scenes import NoRoom, bolt_name, fitting, hexagon, mm, steel


def column_base(r, catalogue, spec):
    """Column, plate, anchors beside the flanges or between them, grout and block."""
    column = r.choice(catalogue.profiles)
    spec["members"] = {"column": {"profile": column["name"], "steel": steel(r, catalogue)}}
    width = mm(max(200, column["b"] + r.uniform(0, 200)))
    inside = r.random() < 0.3
    least = column["tw"] + 2 * column["r"] if inside else 0
    bolt, gauge, _ = fitting(
        r, catalogue, lambda f, c: max(least + 2 * c + 2, 2 * c + 2), lambda f, c: width - 2 * c
    )
    _, corner = hexagon(bolt)
    corner = ceil(10 * corner) / 10
    spec["bolts"] = {"size": bolt_name(bolt), "gauge": gauge}
    half = column["h"] / 2
    if inside:
        clear = half - column["tf"] - corner - 2
        if clear < 0:
            raise NoRoom
        apart = 2 * corner + 2
        rows = [-clear, clear] if 2 * clear >= apart and r.random() < 0.8 else [0.0]
        reach = half
    else:
        near = half + corner + 2 + r.uniform(0, 80)
        rows = r.choice([[-near, near], [-near, near], [near]])
        reach = near + corner + 1
    if r.random() < 0.15 and min(abs(x) for x in rows) >= half:
        # a second row outside the flange, for which the tables have no tension side
        rows = rows + [rows[-1] + 2 * corner + 2]
        reach = rows[-1] + corner + 1
    spec["bolts"]["rows"] = [mm(x) for x in rows]
    length = mm(max(200, 2 * reach + r.uniform(1, 100)))
    spec["plate"] = {"thickness": mm(r.uniform(8, 60)), "width": width}
    if r.random() < 0.3:
        spec["plate"]["steel"] = steel(r, catalogue)
    given = spec["parameters"] = {"plate_length": length}
    # what the plate reaches beyond nuts and flanges
    spare = (length - 2 * max(reach, half)) / 2 - 0.5
    if spare > 0 and r.random() < 0.3:
        given["plate_offset"] = mm(r.uniform(-spare, spare))
    for name, low, high in (
        ("anchor_length", 100, 900), ("grout_thickness", 0, 60), ("concrete_edge", 0, 800),
        ("concrete_depth", 200, 2000), ("hole_clearance", 0, 8),
    ):
        if r.random() < 0.5:
            given[name] = mm(r.uniform(low, high))
    for name, values in (
        ("concrete_f_ck", [12, 20, 25, 30, 50]), ("grout_strength", [8, 20, 30, 60]),
        ("grout_friction", [0, 0.2, 0.3]), ("anchors_carry_shear", [True]),
        ("anchorage_checked", [True]), ("flange_weld", [4, 6, 8, 10]), ("web_weld", [3, 4, 6]),
    ):
        if r.random() < 0.4:
            given[name] = r.choice(values)
    return column


SCENES = {"column_base": column_base}
