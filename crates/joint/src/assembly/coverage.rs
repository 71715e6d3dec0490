//! Compares what the hand checks know of a joint with its geometry: a verdict by code must cover
//! all of it, and must not count what is not there.

use super::assembly::{Assembly, Solid, WeldRule};
use super::content::{
    Content, Extent, Fastener, Length, NotChecked, Piece, PieceKind, SAME_PLACE, Seam, touching,
};
use super::end_plate::EndPlate;
use super::member_ends::Frame;
use super::template::EndPlateEntry;
use bracket_base::say;
use bracket_base::words::Text;

/// Names the plates of the joint, and tells the hand checks the real grip of the bolts, the welds
/// and all that they do not cover. `frames` are those of the member ends named in `hand_checks`; if
/// empty, the beam runs along x through the origin.
pub(super) fn compare(
    content: &mut Content,
    assembly: &Assembly,
    frames: &[Frame],
    entry: &EndPlateEntry,
    seen: &mut EndPlate,
) {
    let upright = [Frame { origin: [0.0; 3], along: 0, depth: 2, outward: 1.0 }];
    let frames = if frames.is_empty() { &upright } else { frames };
    let mut named = Named { content: &mut *content, frames, entry, seen: &*seen };
    named.pieces();
    named.members();
    let plies = Plies::of(content, assembly, entry, seen);
    seen.grip = plies.grip.unwrap_or(seen.grip);
    let mut out = absent(content, seen, frames);
    out.extend(plies.faults);
    out.extend(strange_welds(content, assembly, frames, seen));
    out.extend(others(content, &plies.outer));
    out.extend(plies.notes);
    content.not_checked.clone_from(&out);
    seen.not_checked = out;
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < SAME_PLACE
}

/// A piece in the axes of a member's end: along the member, across it, and along the depth of its
/// section, from the bolt plane.
fn local(e: &Extent, f: &Frame) -> Extent {
    [f.along, 3 - f.along - f.depth, f.depth].map(|k| e[k].map(|x| x - f.origin[k]))
}

fn size(e: [f64; 2]) -> f64 {
    e[1] - e[0]
}

/// The pieces and members with those that the hand checks know.
struct Named<'a> {
    content: &'a mut Content,
    frames: &'a [Frame],
    entry: &'a EndPlateEntry,
    seen: &'a EndPlate,
}

impl Named<'_> {
    fn pieces(&mut self) {
        let Self { content, frames, entry, seen } = self;
        let with = |role: Option<&String>| -> Vec<&str> {
            let of = |m: &&Length| role.is_some_and(|r| *r == m.role);
            content.members.iter().filter(of).map(|m| m.part.as_str()).collect()
        };
        let (columns, beams) = (with(entry.column.as_ref()), with(Some(&entry.beam)));
        for p in &mut content.pieces {
            let kind =
                |f: &Frame| (kind(p, f, seen, &columns, &beams, &content.fasteners), f.depth);
            let Some((kind, depth)) = frames.iter().map(kind).min() else { continue };
            p.kind = kind;
            p.upright = (kind == PieceKind::EndPlate).then_some(depth);
            let label = match p.kind {
                PieceKind::EndPlate => "end plate",
                PieceKind::Stiffener => "column stiffener",
                PieceKind::Doubler => "web doubler",
                PieceKind::Rib => "rib",
                PieceKind::Haunch if p.outline.is_some() => "web of the haunch",
                PieceKind::Haunch if is_haunch_flange(p, seen) => "flange of the haunch",
                PieceKind::Haunch => "stiffener at the tip of the haunch",
                PieceKind::Checked | PieceKind::Other => continue,
            };
            p.label = label.into();
        }
    }

    /// A beam is known if it stands on an end plate, a column if the bolts pass it.
    fn members(&mut self) {
        let Self { content, entry, .. } = self;
        let plates: Vec<&Piece> =
            content.pieces.iter().filter(|p| p.kind == PieceKind::EndPlate).collect();
        for m in &mut content.members {
            let on_a_plate = || plates.iter().any(|p| touching(&p.extent, &m.bounds()).is_some());
            let bolted = || content.fasteners.iter().any(|b| b.passes(&m.part));
            m.known = m.role == entry.beam && on_a_plate()
                || entry.column.as_ref() == Some(&m.role) && bolted();
        }
    }
}

/// What a plate is in the frame of a member's end.
fn kind(
    p: &Piece,
    f: &Frame,
    e: &EndPlate,
    columns: &[&str],
    beams: &[&str],
    bolts: &[Fastener],
) -> PieceKind {
    if !p.is_box() {
        let known = beams.contains(&p.part.as_str()) && of_haunch(p, f, e);
        return if known { PieceKind::Haunch } else { PieceKind::Other };
    }
    let [a, y, z] = local(&p.extent, f);
    let levels = e.flange_levels();
    if same(size(a), e.thickness)
        && same(y[0], -0.5 * e.width)
        && same(y[1], 0.5 * e.width)
        && same(z[0], e.bottom)
        && same(z[1], e.top)
        && bolts.iter().any(|b| b.passes(&p.part))
    {
        return PieceKind::EndPlate;
    }
    if let Some(c) = e.column.as_ref().filter(|_| columns.contains(&p.part.as_str())) {
        let s = &c.section;
        let middle = 0.5 * (z[0] + z[1]);
        if same(size(z), c.stiffener)
            && levels.iter().any(|level| same(middle, *level))
            && same(size(a), s.h - 2.0 * s.tf)
            && same(y[0].abs().max(y[1].abs()), 0.5 * s.b)
            && same(y[0].abs().min(y[1].abs()), 0.5 * s.tw)
        {
            return PieceKind::Stiffener;
        }
        if same(size(y), c.doubler) && same(y[0].abs().min(y[1].abs()), 0.5 * s.tw) {
            return PieceKind::Doubler;
        }
    }
    let rib = same(size(y), e.rib)
        && same(y[0], -0.5 * e.rib)
        && same(z[0], 0.5 * e.beam.h)
        && same(z[1], e.top);
    match rib && beams.contains(&p.part.as_str()) {
        true => PieceKind::Rib,
        false => PieceKind::Other,
    }
}

/// True if a plate of the beam is what the hand checks know of its haunch: a web with an outline, a
/// flange that ends at the lower end of the depth, or a stiffener at its tip.
fn of_haunch(p: &Piece, f: &Frame, e: &EndPlate) -> bool {
    let Some(h) = e.rafter.as_ref().and_then(|r| r.haunch.as_ref()) else { return false };
    let across = 3 - f.along - f.depth;
    let [thickness, ..] = p.sizes();
    let [_, y, z] = local(&p.bounds(), f);
    let upright = p.outline.as_ref().is_some_and(|(axis, _)| *axis == across);
    match &p.outline {
        Some(_) => upright && same(thickness, h.web) && same(y[0], -y[1]),
        None if is_haunch_flange(p, e) => same(z[0], -0.5 * e.depth()) && same(y[0], -y[1]),
        None => h.stiffener > 0.0 && same(thickness, h.stiffener),
    }
}

/// True if a plate is as thick and as wide as the flange of the haunch.
fn is_haunch_flange(p: &Piece, e: &EndPlate) -> bool {
    let haunch = e.rafter.as_ref().and_then(|r| r.haunch.as_ref());
    let [thickness, a, b] = p.sizes();
    let fits = |h: &super::rafter::Haunch| {
        same(thickness, h.flange) && (same(a, h.width) || same(b, h.width))
    };
    p.outline.is_none() && haunch.is_some_and(fits)
}

/// What the hand checks count and the geometry lacks.
fn absent(content: &Content, e: &EndPlate, frames: &[Frame]) -> Vec<NotChecked> {
    let count = |kind: PieceKind| content.pieces.iter().filter(|p| p.kind == kind).count();
    let column = |of: fn(&super::ColumnSide) -> f64| e.column.as_ref().map_or(0.0, of) > 0.0;
    let plates = if e.column.is_some() { frames.len() } else { 2 };
    let haunch = e.rafter.as_ref().and_then(|r| r.haunch.as_ref());
    let of_haunch = plates * haunch.map_or(0, |h| if h.stiffener > 0.0 { 4 } else { 2 });
    [
        (haunch.is_some(), PieceKind::Haunch, of_haunch, "haunch", "haunch"),
        (true, PieceKind::EndPlate, plates, "end plates", "plate"),
        (column(|c| c.stiffener), PieceKind::Stiffener, 4, "stiffeners of the column", "stiffener"),
        (column(|c| c.doubler), PieceKind::Doubler, 1, "web doubler", "doubler"),
        (e.rib > 0.0, PieceKind::Rib, 1, "rib", "rib"),
    ]
    .into_iter()
    .filter(|(counted, kind, least, ..)| *counted && count(*kind) < *least)
    .map(|(_, _, _, label, key)| NotChecked {
        parts: vec![label.into()],
        label: label.into(),
        why: say!(
            "`hand_checks` of the template counts it ({}), and the parts of the template have \
             none at that place with these sizes",
            key.to_owned()
        ),
        step: "a template whose parts and `hand_checks` agree".into(),
        binds: true,
    })
    .collect()
}

/// The parts that the bolts of the end plates clamp.
struct Plies {
    /// Largest grip \[mm\].
    grip: Option<f64>,
    /// Parts outside end plate and flange, under head or nut alone.
    outer: Vec<String>,
    faults: Vec<NotChecked>,
    notes: Vec<NotChecked>,
}

impl Plies {
    fn of(content: &Content, assembly: &Assembly, entry: &EndPlateEntry, e: &EndPlate) -> Self {
        let mut out = Self { grip: None, outer: vec![], faults: vec![], notes: vec![] };
        let is_plate = |part: &str| {
            content.pieces.iter().any(|p| p.part == part && p.kind == PieceKind::EndPlate)
        };
        let column = |part: &str| {
            content.members.iter().any(|m| m.part == part && entry.column.as_ref() == Some(&m.role))
        };
        let flange = e.column.as_ref().map(|c| c.section.tf);
        let bolts =
            content.fasteners.iter().filter(|b| b.through.iter().any(|p| is_plate(&p.part)));
        let mut strange: Vec<Text> = Vec::new();
        let mut outer: Vec<(String, String)> = Vec::new();
        for b in bolts {
            let grip = b.grip();
            out.grip = Some(out.grip.map_or(grip, |g: f64| g.max(grip)));
            let core = |i: usize| {
                let p = &b.through[i];
                is_plate(&p.part) && same(p.thickness, e.thickness)
                    || column(&p.part) && flange.is_some_and(|t| same(t, p.thickness))
            };
            let cores: Vec<usize> = (0..b.through.len()).filter(|&i| core(i)).collect();
            let whole = match cores[..] {
                [i, j] => {
                    let plates = [i, j].map(|k| is_plate(&b.through[k].part));
                    let wanted = if flange.is_some() { 1 } else { 2 };
                    j == i + 1 && plates.iter().filter(|p| **p).count() == wanted
                }
                _ => false,
            };
            if !whole {
                strange.push(Text::given(&b.name));
                continue;
            }
            for (i, p) in b.through.iter().enumerate().filter(|(i, _)| !cores.contains(i)) {
                // the part that it lies on
                let inner = &b.through[if i < cores[0] { i + 1 } else { i - 1 }].part;
                if !outer.iter().any(|(part, _)| *part == p.part) {
                    outer.push((p.part.clone(), inner.clone()));
                }
            }
        }
        if !strange.is_empty() {
            let what = if flange.is_some() { "the column flange" } else { "the other end plate" };
            out.faults.push(NotChecked {
                parts: strange,
                label: "bolts".into(),
                why: say!(
                    "the checks take bolts through the end plate and {}, one on the other; these \
                     pass other parts between them, or other thicknesses (for packings EN \
                     1993-1-8 3.6.1(12) reduces the shear resistance)",
                    what
                ),
                step: "bolts through these two alone, or a check of them by hand".into(),
                binds: true,
            });
        }
        let alone = |(part, inner): &(String, String)| {
            let own = extents(assembly, part);
            !assembly.parts.iter().any(|p| {
                p.name != *part
                    && p.name != *inner
                    && !content.fasteners.iter().any(|b| b.name == p.name)
                    && extents(assembly, &p.name)
                        .iter()
                        .any(|o| own.iter().any(|e| touching(e, o).is_some()))
            })
        };
        out.outer = outer.iter().filter(|o| alone(o)).map(|o| o.0.clone()).collect();
        for (label, parts) in by_label(content, |p| out.outer.contains(&p.part)) {
            out.notes.push(NotChecked {
                parts,
                label,
                why: "it lies under heads or nuts alone: its thickness is in the grip of the \
                      bolts, its strength is neglected, which is on the safe side"
                    .into(),
                step: Text::default(),
                binds: false,
            });
        }
        out
    }
}

/// Boxes round the convex solids of a part.
fn extents(assembly: &Assembly, part: &str) -> Vec<Extent> {
    let bounds = |s: &Solid| match s {
        Solid::Box { min, max } => Some(std::array::from_fn(|k| [min[k], max[k]])),
        _ => None,
    };
    let solids = assembly.parts.iter().filter(|p| p.name == part).flat_map(|p| &p.convex);
    solids.filter_map(bounds).collect()
}

/// Names of the parts of plates with the same label.
fn by_label(content: &Content, of: impl Fn(&Piece) -> bool) -> Vec<(Text, Vec<Text>)> {
    let mut out: Vec<(Text, Vec<Text>)> = Vec::new();
    for p in content.pieces.iter().filter(|p| of(p)) {
        let part = Text::given(&p.part);
        match out.iter_mut().find(|(label, _)| *label == p.label) {
            Some((_, parts)) if parts.contains(&part) => {}
            Some((_, parts)) => parts.push(part),
            None => out.push((p.label.clone(), vec![part])),
        }
    }
    out
}

/// Plates and members that the hand checks do not know.
pub(super) fn others(content: &Content, outer: &[String]) -> Vec<NotChecked> {
    let mut out = Vec::new();
    let mut add = |label: &Text, part: &str, no_check: &Option<Text>| {
        let part = Text::given(part);
        let why = match no_check {
            Some(reason) => say!("the template says: {}", reason),
            None => "it is in the geometry and the drawing, no check by code covers it or what it \
                     changes in the joint"
                .into(),
        };
        let binds = no_check.is_none();
        let like = |n: &&mut NotChecked| n.label == *label && n.why == why;
        match out.iter_mut().find(like) {
            Some(n) if n.parts.contains(&part) => {}
            Some(n) => n.parts.push(part),
            None => out.push(NotChecked {
                parts: vec![part],
                label: label.clone(),
                why,
                step: "a check of it by hand; the template can then state that with `no_check`"
                    .into(),
                binds,
            }),
        }
    };
    let unknown = |p: &&Piece| p.kind == PieceKind::Other && !outer.contains(&p.part);
    content.pieces.iter().filter(unknown).for_each(|p| add(&p.label, &p.part, &p.no_check));
    let unknown = content.members.iter().filter(|m| !m.known);
    unknown.for_each(|m| add(&m.label, &m.part, &m.no_check));
    out
}

/// Fillet welds of the beams that the checks take otherwise: neither that of a flange nor that of
/// the web.
fn strange_welds(
    content: &Content,
    assembly: &Assembly,
    frames: &[Frame],
    e: &EndPlate,
) -> Vec<NotChecked> {
    let known = |w: &&WeldRule| {
        let is = |part: &str| {
            content.members.iter().any(|m| m.known && m.part == part)
                || content.pieces.iter().any(|p| p.kind == PieceKind::EndPlate && p.part == part)
        };
        w.between.iter().all(|p| is(p))
    };
    let flanges = e.flanges();
    let agrees = |w: &&WeldRule| {
        let super::assembly::Surface::Plane { min, max, .. } = w.surface else { return false };
        let surface: Extent = std::array::from_fn(|k| [min[k], max[k]]);
        frames.iter().any(|f| {
            let [_, _, z] = local(&surface, f).map(|i| [i[0], i[1]]);
            let of_flange = flanges.iter().any(|f| same(z[0], f[0]) && same(z[1], f[1]));
            let of_web = flanges.windows(2).any(|f| same(z[0], f[0][1]) && same(z[1], f[1][0]));
            of_flange && same(w.throat, e.flange_throat) || of_web && same(w.throat, e.web_throat)
        })
    };
    let welds: Vec<Text> = assembly
        .welds
        .iter()
        .filter(known)
        .filter(|w| !agrees(w))
        .map(|w| Text::given(&w.name))
        .collect();
    let why = "the checks know the welds of the beam's flanges and of its web to the end plate, \
               these have another place or another throat";
    let step = "a check of these welds by hand".into();
    let (label, why) = ("welds".into(), why.into());
    let one = NotChecked { parts: welds, label, why, step, binds: true };
    if one.parts.is_empty() { Vec::new() } else { vec![one] }
}

/// Welds of the plates that the hand checks do not know: fillets as the template gives them, and
/// full penetration where parts touch without a contact between them.
pub(super) fn seams(content: &Content, assembly: &Assembly) -> Vec<Seam> {
    let mut out: Vec<Seam> = Vec::new();
    let unknown: Vec<&Piece> =
        content.pieces.iter().filter(|p| p.kind >= PieceKind::Checked).collect();
    let is_unknown = |part: &str| unknown.iter().any(|p| p.part == part);
    for w in assembly.welds.iter().filter(|w| w.between.iter().any(|p| is_unknown(p))) {
        let super::assembly::Surface::Plane { axis, min, max, .. } = w.surface else { continue };
        let area: f64 = (0..3).filter(|k| *k != axis).map(|k| max[k] - min[k]).product();
        let length = w.length.unwrap_or(2.0 * area / w.thickness);
        out.push(Seam { between: w.between.clone(), throat: w.throat, length });
    }
    let joined = |a: &str, b: &str| {
        let both = |of: &[String; 2]| of.iter().any(|p| p == a) && of.iter().any(|p| p == b);
        assembly.welds.iter().any(|w| both(&w.between))
            || assembly.interfaces.iter().any(|i| both(&i.between))
    };
    for (i, p) in unknown.iter().enumerate() {
        // each pair of them once
        let later = |o: &&Piece| !unknown[..=i].iter().any(|u| std::ptr::eq(*u, *o));
        let pieces = content.pieces.iter().filter(later).map(|o| (&o.part, vec![o.bounds()]));
        let members = content.members.iter().map(|m| (&m.part, m.plates_in_space()));
        for (part, extents) in pieces.chain(members) {
            if part != &p.part && joined(part, &p.part) {
                continue;
            }
            let sides = extents.iter().filter_map(|e| touching(&p.bounds(), e));
            let length: f64 = sides.map(|[_, longer]| longer).sum();
            let between = [p.part.clone(), part.clone()];
            match out.iter_mut().find(|s| s.throat == 0.0 && s.between == between) {
                _ if length == 0.0 => {}
                Some(seam) => seam.length += length,
                None => out.push(Seam { between, throat: 0.0, length }),
            }
        }
    }
    out
}
