"""Specs of the tests of joints: from tests/data/tests_of_joints/tests.toml to one folder of Bracket specs with their catalogue."""

import math
import pathlib
import shutil
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DATA = ROOT / "tests" / "data" / "tests_of_joints"
# β_w of EN 1993-1-8 Table 4.1 and α_v of Table 3.4 (12.9 is not in the table: the value of 10.9)
BETA_W = {"S235": 0.80, "S275": 0.85, "S355": 0.90, "S460": 1.00}
ALPHA_V = {"8.8": 0.6, "10.9": 0.5, "12.9": 0.5}
# name: h, b, t_w, t_f, r [mm]
PROFILES = {
    "RIGID51": (400, 300, 25, 51, 10),
    "WELDED294x250": (294, 250, 8, 12, 0),
    "WELDED294x200": (294, 200, 8, 12, 0),
    "H338x351x13x13": (338, 351, 13, 13, 13),
    "H400x200x8x13": (400, 200, 8, 13, 13),
}
# Strength: `run.py` says how many meshes. Route of analysis at a part of M_max. Stiffness: one mesh gives both bounds
LIMIT = "{kind: limit, decide: false, time_limit: 10 min}"
ROUTE = "{kind: limit, decide: true, time_limit: 15 min}"
ELASTIC = "{kind: elastic, max_passes: 1}"
ROUTE_SHARE = 0.7
ROUTE_TESTS = ("EP3", "EP6", "FE1", "A1", "T5")


def load() -> dict[str, dict]:
    """The tests by id, each complete: what `like` leaves out is filled in."""
    raw = tomllib.loads((DATA / "tests.toml").read_text(encoding="utf-8"))
    return {name: complete(raw, test) for name, test in raw.items()}


def complete(raw: dict, test: dict) -> dict:
    """A test with the keys of the one it is `like`."""
    if "like" not in test:
        return test
    return {**complete(raw, raw[test["like"]]), **{k: v for k, v in test.items() if k != "like"}}


def catalogue(tests: dict[str, dict], folder: pathlib.Path) -> None:
    """Tables of the profiles, steels and bolts that the program does not have."""
    folder.mkdir(parents=True, exist_ok=True)
    source = "# source: tests/data/tests_of_joints/tests.toml\n"
    columns = "Wel_y_cm3 Wpl_y_cm3 Wel_z_cm3 Wpl_z_cm3".replace(" ", ",")
    text = source + f"name,series,standard,h_mm,b_mm,tw_mm,tf_mm,r_mm,mass_kg_per_m,A_cm2,Iy_cm4,Iz_cm4,{columns}\n"
    for name, (h, b, tw, tf, r) in PROFILES.items():
        text += f"{name},tests,test,{h},{b},{tw},{tf},{r},,,,,,,,\n"
    (folder / "profiles.csv").write_text(text, encoding="utf-8")
    steels = source + "standard,grade,fy_t_le_40_MPa,fu_t_le_40_MPa,fy_t_40_to_80_MPa,fu_t_40_to_80_MPa,E_MPa,nu,density_kg_per_m3,beta_w\n"
    bolts = source + "grade,fyb_MPa,fub_MPa,alpha_v_threads_in_shear_plane,alpha_v_shank_in_shear_plane,preloadable\n"
    for name, test in tests.items():
        for part in ("column", "beam", "plate"):
            fy, fu = test[part]["strength"]
            grade = test.get("plate_grade", test["grade"]) if part == "plate" else test["grade"]
            steels += f"test,{name}-{part},{fy},{fu},{fy},{fu},210000,0.3,7850,{BETA_W[grade]}\n"
        (fyb, fub), alpha = test["bolts"]["strength"], ALPHA_V[test["bolts"]["class"]]
        bolts += f"{name}-bolt,{fyb},{fub},{alpha},0.6,yes\n"
    (folder / "steels.csv").write_text(steels, encoding="utf-8")
    (folder / "bolt_grades.csv").write_text(bolts, encoding="utf-8")


def throats(test: dict) -> dict[str, float]:
    """Throats of the welds: the sizes of the tests are read as legs, which gives the lesser throat; 0 is a butt weld."""
    if test["welds"] == "butt":
        return {}
    return {f"{k}_weld": round(v / math.sqrt(2), 2) for k, v in test["welds"].items()}


def parameters(test: dict) -> dict[str, object]:
    """Template parameters of a test."""
    half = test["column"]["length"] / 2
    values: dict[str, object] = {"column_above": half, "column_below": half, **throats(test)}
    if test.get("two_sided"):
        values["double_sided"] = "true"
    if "outer_gauge" in test["bolts"]:
        values["outer_gauge"] = test["bolts"]["outer_gauge"]
    stiffener = test.get("stiffener")
    if stiffener and stiffener["levels"] == "both":
        values.update(column_stiffeners="true", column_stiffener_thickness=stiffener["thickness"])
    elif stiffener:
        values["compression_stiffener_thickness"] = stiffener["thickness"]
    return values


def loads(test: dict, kind: str, share: float) -> list[str]:
    """Actions at the column face: M and V = M/L of the test, with its axial forces, or M alone for the stiffness.

    Axial forces grow with the moment, so that the load factor 1 is the point of the test. (A constant one needs a field of its own that
    carries it strictly inside the yield surface, which the programs do not always leave.)
    """
    moment = share * test["measured"]["M_max"]
    ends = ["beam"] if test.get("minor_axis") else ["beam_right"]
    if test.get("two_sided"):
        ends.append("beam_left")
    lines = []
    for end in ends:
        entry = f"name: TEST, end: {end}, at: column_face, My: {moment:.6g} kN m"
        if kind != "stiffness":
            entry += f", Vz: {-moment / test['beam']['length'] * 1e3:.6g} kN"
            if "axial" in test:
                entry += f", N: {share * test['axial']:.6g} kN"
        lines.append(entry)
    if "column_axial" in test and kind != "stiffness":
        h, b, tw, tf, _ = PROFILES[test["column"]["profile"]]
        area = 2 * b * tf + (h - 2 * tf) * tw
        lines.append(f"name: TEST, section: column_top, pressure: {share * test['column_axial'] * 1e3 / area:.6g} MPa")
    return lines


def spec(name: str, test: dict, kind: str) -> str:
    """The spec of a test. `kind`: limit, route (of analysis, at a part of M_max) or stiffness (elastic, M alone)."""
    thickness, width, height = test["plate"]["size"]
    rows = [round(height / 2 - r, 2) for r in test["bolts"]["rows"]]
    edge = test.get("plate_modelled", height) / 2
    stiffener = test.get("stiffener", {}).get("levels")
    template = "minor_axis_end_plate" if test.get("minor_axis") else "beam_to_column_end_plate"
    if stiffener == "compression":
        template = "compression_stiffener.yaml"
    analysis = {"limit": LIMIT, "route": ROUTE, "stiffness": ELASTIC}[kind]
    share = {"limit": 1.0, "route": ROUTE_SHARE, "stiffness": 0.25}[kind]
    values = ", ".join(f"{k}: {v}" for k, v in parameters(test).items())
    column, beam, bolts = test["column"], test["beam"], test["bolts"]
    return "\n".join(
        [
            f"project: {{title: 'Test {name}: {test['paper']}'}}",
            "code: {gamma_M0: 1.0, gamma_M1: 1.0, gamma_M2: 1.0}",
            f"template: {template}",
            "catalog: catalog",
            "members:",
            f"  column: {{profile: {column['profile']}, steel: {name}-column}}",
            f"  beam: {{profile: {beam['profile']}, steel: {name}-beam}}",
            f"plate: {{thickness: {thickness}, width: {width}, z: [{-edge}, {edge}], steel: {name}-plate}}",
            f"bolts: {{size: {bolts['size']}, grade: {name}-bolt, gauge: {bolts['gauge']}, rows: {rows}}}",
            f"parameters: {{{values}}}",
            "friction: {mu: 0}",
            "loads:",
            *(f"  - {{{entry}}}" for entry in loads(test, kind, share)),
            f"analysis: {analysis}",
            "",
        ]
    )


def runs(tests: dict[str, dict]) -> list[tuple[str, str]]:
    """What the study runs: (test, kind), strengths first."""
    ids = list(tests)
    # the template of the minor axis has no checks by code, and so no length of beam to subtract; under a constant axial force there
    # is no stiffness of one moment
    stiff = [name for name in ids if not tests[name].get("minor_axis") and "axial" not in tests[name]]
    return [(name, "limit") for name in ids] + [(name, "route") for name in ROUTE_TESTS] + [(name, "stiffness") for name in stiff]


def write(tests: dict[str, dict], folder: pathlib.Path) -> list[pathlib.Path]:
    """All specs with what they need."""
    folder.mkdir(parents=True, exist_ok=True)
    catalogue(tests, folder / "catalog")
    shutil.copyfile(DATA / "compression_stiffener.yaml", folder / "compression_stiffener.yaml")
    paths = []
    for name, kind in runs(tests):
        path = folder / f"{name}_{kind}.yaml"
        path.write_text(spec(name, tests[name], kind), encoding="utf-8")
        paths.append(path)
    return paths
