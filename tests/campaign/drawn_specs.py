"""Random specs of every template."""

import base_scenes
import bolted_scenes
import eaves_scenes
from spec_scenes import ALL_SIX, common, end_loads, splice, tees, to_column, to_web

# by template
SCENES = base_scenes.SCENES | bolted_scenes.SCENES | eaves_scenes.SCENES


def draw(r, catalogue, names=None):
    """A spec that keeps the rules of its template as far as they are known here.

    `names`: the templates to choose from; all of them without.
    """
    name = r.choice(sorted(names or catalogue.templates))
    template = catalogue.templates[name]
    spec = {"project": {"title": f"Campaign {name}"}, "template": name}
    if name == "beam_splice":
        section = splice(r, catalogue, spec)
    elif name == "t_stub":
        section = tees(r, catalogue, spec)
    elif name == "minor_axis_end_plate":
        section = to_web(r, catalogue, spec)
    elif name in SCENES:
        section = SCENES[name](r, catalogue, spec)
    else:
        section = to_column(r, catalogue, spec, name)
    common(r, catalogue, spec)
    without_fillet_welds(spec, catalogue)
    ends = [
        e for e in template["ends"]
        if e["name"] != "beam_left" or spec["parameters"].get("double_sided")
    ]
    if ends:
        names = ["N", "Vy", "Mz", "Vz", "My", "T"] if name == "t_stub" else ALL_SIX
        spec["loads"] = end_loads(r, section, ends, names)
    else:
        section = r.choice(["column_top", "column_top", "beam_right_end"])
        spec["loads"] = [{"name": "TOP", "section": section, "pressure": f"{r.randint(5, 60)} MPa"}]
    return spec


def without_fillet_welds(spec, catalogue):
    """Butt welds in place of fillet welds, where a steel has no strength in fillet welds."""
    used = [m["steel"] for m in spec["members"].values()] + [spec.get("plate", {}).get("steel")]
    if catalogue.not_fillet_welded.intersection(used):
        for name in ("flange_weld", "web_weld", "stiffener_weld", "rib_weld", "weld"):
            spec["parameters"].pop(name, None)
