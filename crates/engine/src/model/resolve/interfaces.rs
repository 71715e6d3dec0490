//! Reads `interfaces`: the shared faces that open, and their laws.

use super::claims::{Claims, OpenInterface, OpenLaw};
use super::faults::Faults;
use super::names::Scene;
use crate::mesh::split::{OpenPair, TetFace};
use crate::mesh::topology::FaceRow;
use crate::model::FrictionLaw;
use crate::model::analysis::{ContactLaw, FacePair, Interface, Weld};
use crate::model::file::{Gap, InterfaceEntry, Law, ModelFile};
use bracket_base::diag::number;
use bracket_base::say;
use bracket_base::words::Text;

/// Reads all entries.
pub(super) fn claim(
    file: &ModelFile,
    scene: &Scene<'_>,
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) -> Claims {
    let mut claims = Claims::default();
    for (i, entry) in file.interfaces.iter().enumerate() {
        let path = format!("interfaces[{i}]");
        let law = read_law(entry, &path, faults, notes);
        let Some(found) = faces(entry, &path, scene, faults) else { continue };
        let name = match (&entry.face, &entry.between) {
            (Some(face), _) => face.clone(),
            (None, Some([a, b])) => format!("{a}-{b}"),
            (None, None) => continue,
        };
        let mut twice = None;
        for rows in &found {
            let first = TetFace::from(&rows[0]).min(TetFace::from(&rows[1]));
            twice = claims.claim(first, i, entry.law != Law::Tied).or(twice);
        }
        if let Some(other) = twice {
            let m =
                format!("faces of the interface `{name}` are already named by interfaces[{other}]");
            let help =
                "name each face once: give the wider entry a `face` that leaves the other's out";
            faults.add("model/face-twice", &path, m, help);
        }
        let Some(law) = law else { continue };
        if let OpenLaw::Contact(law) = &law {
            check_gap(&law.gap, &name, &path, scene, found.iter().map(|r| r[0].key), faults);
        }
        let faces =
            found.iter().map(|rows| [TetFace::from(&rows[0]), TetFace::from(&rows[1])]).collect();
        claims.open.push(OpenInterface { name, law, faces });
    }
    claims
}

/// The interior faces of an entry, side A first; `None` after a fault.
fn faces(
    entry: &InterfaceEntry,
    path: &str,
    scene: &Scene<'_>,
    faults: &mut Faults<'_>,
) -> Option<Vec<[FaceRow; 2]>> {
    let mut pair = None;
    if let Some([a, b]) = &entry.between {
        let at = format!("{path}.between");
        let ia = scene.body(a, &format!("{at}[0]"), faults);
        let ib = scene.body(b, &format!("{at}[1]"), faults);
        pair = Some((ia?, ib?));
        if ia == ib {
            let m = format!("an interface lies between two bodies, `{a}` is named twice");
            faults.add("model/interface", &at, m, "name two different bodies");
            return None;
        }
    }
    let ordered = |rows: &[FaceRow]| -> Option<[FaceRow; 2]> {
        let &[p, q] = rows else { return None };
        let (bp, bq) = (scene.body_of(&p), scene.body_of(&q));
        match pair {
            Some((a, b)) if (bp, bq) == (a, b) => Some([p, q]),
            Some((a, b)) if (bq, bp) == (a, b) => Some([q, p]),
            Some(_) => None,
            None if bp < bq => Some([p, q]),
            None if bp > bq => Some([q, p]),
            None => None,
        }
    };
    let Some(name) = &entry.face else {
        let Some([a, b]) = &entry.between else {
            let m =
                "an interface needs `between` (two bodies), `face` (a physical surface) or both";
            faults.add("model/interface", path, m, "write `between: [BODY_A, BODY_B]`");
            return None;
        };
        let found: Vec<_> = scene.table.faces().filter_map(ordered).collect();
        if found.is_empty() {
            let m = format!("the bodies `{a}` and `{b}` have no face in common");
            let help = "bodies touch where they share mesh faces: use `BooleanFragments` in gmsh, \
                        and `nodes: split` when each body has its own nodes";
            faults.add("model/no-contact", &format!("{path}.between"), m, help);
            return None;
        }
        return Some(found);
    };
    let at = format!("{path}.face");
    let named = scene.face(name, &at, faults)?;
    // a mesh that was split may give both sides the same name
    let mut found: Vec<[FaceRow; 2]> = Vec::new();
    let (mut outer, mut inside) = (0, None);
    for t in &named.triangles {
        let owners = scene.table.owners(*t);
        match ordered(owners) {
            Some(rows) => found.push(rows),
            None if owners.len() == 1 => outer += 1,
            None => {
                inside = Some(scene.body_of(&owners[0]))
                    .filter(|b| *b == scene.body_of(&owners[1]))
                    .or(inside)
            }
        }
    }
    found.sort_unstable();
    found.dedup();
    let all = named.triangles.len();
    if pair.is_none() && (outer > 0 || inside.is_some()) {
        let m = match inside {
            Some(b) => format!(
                "the face `{name}` lies inside the body `{}`",
                scene.mesh.bodies[b as usize]
            ),
            None => format!(
                "{outer} of the {all} triangles of `{name}` are outer faces: no second body \
                 touches there"
            ),
        };
        let help = "an interface lies between two bodies; add `between` to take the triangles of \
                    that pair only";
        faults.add("model/no-contact", &at, m, help);
        return None;
    }
    if found.is_empty() {
        let [a, b] = entry.between.clone().unwrap_or_default();
        let m = format!("the bodies `{a}` and `{b}` have no face in common on `{name}`");
        faults.add(
            "model/no-contact",
            &at,
            m,
            "check the pair and the physical surface; see `nodes: split`",
        );
        return None;
    }
    Some(found)
}

/// The law of an entry that opens its faces; `None` when tied, or after a fault.
fn read_law(
    entry: &InterfaceEntry,
    path: &str,
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) -> Option<OpenLaw> {
    let contact_keys = [
        ("mu", entry.mu.is_some()),
        ("gap", entry.gap.is_some()),
        ("friction", entry.friction.is_some()),
    ];
    let weld_keys = [
        ("throat", entry.throat),
        ("thickness", entry.thickness),
        ("strength", entry.strength),
        ("strength_traction", entry.strength_traction),
    ];
    let useless = |keys: &mut dyn Iterator<Item = &str>, law: &str, faults: &mut Faults<'_>| {
        for key in keys {
            let m = format!("`{key}` has no meaning for `law: {law}`");
            faults.add(
                "model/interface",
                &format!("{path}.{key}"),
                m,
                "remove it, or choose the law it belongs to",
            );
        }
    };
    let mut given_contact = contact_keys.iter().filter(|k| k.1).map(|k| k.0);
    let mut given_weld = weld_keys.iter().filter(|k| k.1.is_some()).map(|k| k.0);
    match entry.law {
        Law::Tied => {
            useless(&mut given_contact.chain(given_weld), "tied", faults);
            None
        }
        Law::Weld => {
            useless(&mut given_contact, "weld", faults);
            weld_strength(entry, path, faults)
                .map(|traction| OpenLaw::Weld(traction, entry.strength))
        }
        Law::Contact => {
            useless(&mut given_weld, "contact", faults);
            contact_law(entry.mu, &entry.gap, entry.friction, path, faults, notes)
                .map(OpenLaw::Contact)
        }
    }
}

/// Strength of a weld per area of its interface \[MPa\]: given directly, or computed from the two
/// throats along a plate, `2 · throat · strength / thickness`.
fn weld_strength(entry: &InterfaceEntry, path: &str, faults: &mut Faults<'_>) -> Option<f64> {
    let throat =
        [("throat", entry.throat), ("thickness", entry.thickness), ("strength", entry.strength)];
    let mut sound = true;
    for (key, value) in throat.into_iter().chain([("strength_traction", entry.strength_traction)]) {
        if let Some(v) = value
            && !(v.is_finite() && v > 0.0)
        {
            let m = format!("`{key}` of the weld is {}, it must be > 0", number(v));
            faults.add("model/value", &format!("{path}.{key}"), m, "mm and MPa, positive");
            sound = false;
        }
    }
    let strength = match (entry.throat, entry.thickness, entry.strength, entry.strength_traction) {
        (Some(throat), Some(thickness), Some(strength), None) => {
            2.0 * throat * strength / thickness
        }
        (None, None, None, Some(traction)) => traction,
        _ => {
            let absent: Vec<&str> = throat.iter().filter(|k| k.1.is_none()).map(|k| k.0).collect();
            let m = match (entry.strength_traction, absent.len()) {
                (Some(_), _) => "a weld has either `throat`, `thickness` and `strength`, or \
                                 `strength_traction`"
                    .into(),
                (None, 3) => "a weld needs `throat`, `thickness` and `strength`, or \
                              `strength_traction`"
                    .into(),
                (None, _) => format!("the weld lacks `{}`", absent.join("` and `")),
            };
            let help = "write `throat` and `thickness` in mm with `strength` in MPa on the \
                        throat, or `strength_traction` in MPa on the interface alone";
            faults.add("model/interface", path, m, help);
            return None;
        }
    };
    if sound && !(strength.is_finite() && strength > 0.0) {
        let m =
            format!("2 throat strength / thickness of the weld is {strength} MPa, out of range");
        faults.add("model/value", path, m, "check the units: mm and MPa");
        return None;
    }
    sound.then_some(strength)
}

/// The law of a contact between bodies or with the ground.
pub(super) fn contact_law(
    mu: Option<f64>,
    gap: &Option<Gap>,
    friction: Option<FrictionLaw>,
    path: &str,
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) -> Option<ContactLaw> {
    let Some(mu) = mu else {
        let help = "write `mu: 0.3`, or `mu: 0` for a frictionless contact";
        faults.add("model/contact", path, "a contact needs its friction coefficient `mu`", help);
        return None;
    };
    if !(mu.is_finite() && mu >= 0.0) {
        let m = format!("`mu` is {}, a friction coefficient is ≥ 0", number(mu));
        faults.add(
            "model/value",
            &format!("{path}.mu"),
            m,
            "write `mu: 0` for a frictionless contact",
        );
        return None;
    }
    let friction = match friction {
        Some(f) => f,
        None => {
            if mu > 0.0 {
                notes.push(say!(
                    "{} gives no friction law: associated friction is used",
                    path.to_owned()
                ));
            }
            FrictionLaw::Associated
        }
    };
    Some(ContactLaw { mu, gap: gap.clone().unwrap_or_default(), friction })
}

/// The initial gap must be finite and not negative at the vertices and the middles of the edges of
/// its faces.
pub(super) fn check_gap(
    gap: &Gap,
    name: &str,
    path: &str,
    scene: &Scene<'_>,
    triangles: impl Iterator<Item = [u32; 3]>,
    faults: &mut Faults<'_>,
) {
    let mut least = (f64::INFINITY, [0.0; 3]);
    let mut largest: f64 = 0.0;
    for t in triangles {
        let x = t.map(|n| scene.mesh.nodes[n as usize]);
        let middle = |i: usize, j: usize| [0, 1, 2].map(|k| 0.5 * (x[i][k] + x[j][k]));
        for p in [x[0], x[1], x[2], middle(0, 1), middle(1, 2), middle(2, 0)] {
            let g = gap.at(p);
            largest = largest.max(g.abs());
            // a NaN must not slip through the comparison
            if g.is_nan() || g < least.0 {
                least = (g, p);
            }
        }
    }
    // a negative value at rounding level is not a penetration
    if !largest.is_finite() || least.0 < -1e-9 * largest || least.0.is_nan() {
        let [x, y, z] = least.1;
        let m = format!(
            "the gap of `{name}` is {} mm at ({x}, {y}, {z}), a gap is finite and ≥ 0",
            least.0
        );
        faults.add(
            "model/value",
            &format!("{path}.gap"),
            m,
            "parts may not overlap at the start: change the gap or the geometry",
        );
    }
}

/// The contacts and the welds once the nodes are split; `pairs` are in the order of the claims.
pub(super) fn pairs(claims: &Claims, pairs: &[OpenPair]) -> (Vec<Interface>, Vec<Weld>) {
    let mut rest = pairs;
    let (mut interfaces, mut welds) = (Vec::new(), Vec::new());
    for open in &claims.open {
        let (mine, others) = rest.split_at(open.faces.len());
        rest = others;
        let (name, faces) = (open.name.clone(), mine.iter().map(FacePair::from).collect());
        match &open.law {
            OpenLaw::Contact(law) => interfaces.push(Interface { name, law: law.clone(), faces }),
            OpenLaw::Weld(strength, throat) => {
                welds.push(Weld { name, strength: *strength, throat_strength: *throat, faces })
            }
        }
    }
    (interfaces, welds)
}
