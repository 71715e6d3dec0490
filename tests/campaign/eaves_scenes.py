"""Random specs of eaves and apex: sloping rafters with and without haunches."""

from math import atan, cos, degrees, radians, sin, tan

from spec_scenes import NoRoom, bolt_name, fitting, flags, hexagon, mm, steel


def haunched_eaves(r, catalogue, spec):
    column = r.choice(catalogue.profiles)
    spec["members"] = {"column": {"profile": column["name"], "steel": steel(r, catalogue)}}
    return rafter_end(r, catalogue, spec, column)


def haunched_apex(r, catalogue, spec):
    spec["members"] = {}
    return rafter_end(r, catalogue, spec, None)


def rafter_end(r, catalogue, spec, column):
    """Rafter, haunch, plate and rows; without a column of an apex, where a rafter that rises out of
    the joint has a negative slope."""
    rafter = r.choice(catalogue.profiles)
    spec["members"]["rafter"] = {"profile": rafter["name"], "steel": steel(r, catalogue)}
    given = spec["parameters"] = flags(r, ["flange_weld", "web_weld"])
    slope = radians(r.choice([0, 3, 6, 10, -5, 20]))
    given["slope"] = f"{degrees(slope if column else -slope):g} deg"
    depth = rafter["h"] / cos(slope)
    upper = lower = rafter["tf"] / cos(slope)
    levels = [-depth / 2 + lower / 2]
    down, web = slope, rafter["tw"]
    given["haunch"] = r.random() < 0.75
    if given["haunch"]:
        high = mm(r.uniform(0.4, 1.2) * rafter["h"])
        length = mm(max(r.uniform(1.3, 2.5) * high, high))
        flange, web = mm(rafter["tf"] + r.uniform(0, 5)), mm(rafter["tw"] + r.uniform(0, 4))
        given |= {
            "haunch_depth": high, "haunch_length": length, "haunch_flange_thickness": flange,
            "haunch_web_thickness": web, "tip_stiffeners": r.random() < 0.3,
        }
        down = slope + atan(high * cos(slope) / (length + high * sin(slope)))
        if abs(degrees(down)) > 43 or degrees(down - slope) < 6:
            raise NoRoom
        lower = flange / cos(down)
        total = depth + high
        levels = [-total / 2 + lower / 2, total / 2 - depth + upper / 2]
        depth = total
    levels.append(depth / 2 - upper / 2)
    width = rafter["b"] + 20
    least = 2 * max(rafter["tw"] / 2 + rafter["r"], web / 2)
    if column:
        width = min(column["b"], max(rafter["b"] + 10, min(column["b"], rafter["b"] + 40)))
        least = max(least, column["tw"] + 2 * column["r"])
    bolt, gauge, _ = fitting(
        r, catalogue, lambda f, c: least + 2 * c + 2, lambda f, c: width - 2 * c
    )
    spec["bolts"] = {"size": bolt_name(bolt), "gauge": gauge}
    flat, _ = hexagon(bolt)
    apart = flat + max(upper, lower) / 2 + bolt["head_height"] * max(abs(tan(down)), abs(tan(slope))) + 2
    if column:
        given["column_stiffeners"] = r.random() < 0.6
    if given.get("column_stiffeners"):
        thick = given["column_stiffener_thickness"] = mm(r.uniform(6, 25))
        apart = max(apart, flat + thick / 2 + 2)
    pitch = max(2 * flat + 1.5, r.choice([2.2, 3.0]) * bolt["hole_normal"])
    rows, z = [], depth / 2 + (apart if r.random() < 0.5 else -apart)
    while len(rows) < 5 and z > -depth / 2:
        near = [level for level in levels if abs(z - level) < apart]
        if near:
            z = near[0] - apart - 0.1
            continue
        rows.append(mm(z))
        z -= pitch + r.uniform(0, depth / 4)
    if not rows:
        raise NoRoom
    spec["bolts"]["rows"] = rows
    edge = flat + 1 + r.uniform(0, 30)
    spec["plate"] = {
        "thickness": mm(r.uniform(8, 35)),
        "z": [mm(-depth / 2 - r.uniform(1, 40)), mm(max(depth / 2 + 1, rows[0] + edge))],
    }
    return rafter


SCENES = {"haunched_eaves": haunched_eaves, "haunched_apex": haunched_apex}
