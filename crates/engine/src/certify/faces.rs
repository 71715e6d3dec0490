//! Conditions on each outer face of the mesh: supports, loads, rigid motion, contact.

use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use crate::model::analysis::{BoundaryFace, ContactLaw, FacePair, SurfaceLoad, Tie, Weld};
use crate::model::loads::Loads;
use crate::model::opening::Bernstein;
use bracket_base::math::vec3::{self, V3};

/// Key of a boundary face: tet and local face.
pub type FaceKey = (u32, u8);

/// The role of one outer face.
#[derive(Clone, Debug, Default)]
pub struct FaceRole<'a> {
    /// Components that are fixed or move rigidly: their traction is a reaction.
    pub reaction: [bool; 3],
    /// Loads on the face, each with its factor.
    pub loads: Vec<(f64, &'a SurfaceLoad)>,
    /// True in contact, at a weld or at a tie: the traction is that of the interface.
    pub contact: bool,
    /// True on a cut: the traction is that of the other side.
    pub cut: bool,
}

impl FaceRole<'_> {
    /// Prescribed traction at a point \[MPa\].
    pub fn load(&self, x: V3, n: V3) -> V3 {
        self.loads
            .iter()
            .fold([0.0; 3], |t, (share, l)| vec3::add(t, vec3::scale(*share, l.at(x, n))))
    }
}

fn key(f: &BoundaryFace) -> FaceKey {
    (f.tet, f.local)
}

/// Roles of the outer faces under the given loads; faces without an entry are free.
pub fn roles(
    model: &AnalysisModel,
    loads: Loads,
) -> std::collections::BTreeMap<FaceKey, FaceRole<'_>> {
    let mut roles: std::collections::BTreeMap<FaceKey, FaceRole<'_>> = Default::default();
    for s in &model.supports {
        for f in &s.faces {
            let r = roles.entry(key(f)).or_default();
            (0..3).for_each(|d| r.reaction[d] |= s.fix[d]);
        }
    }
    for s in &model.rigid {
        for f in &s.faces {
            let r = roles.entry(key(f)).or_default();
            (0..3).for_each(|d| r.reaction[d] |= s.components[d]);
        }
    }
    for l in &model.surface_loads {
        for f in &l.faces {
            roles.entry(key(f)).or_default().loads.push((loads.share(l.dead), l));
        }
    }
    let contacts = model.interfaces.iter().flat_map(|i| &i.faces);
    let welds = model.welds.iter().flat_map(|w| &w.faces);
    for f in contacts.chain(welds).chain(model.ties.iter().flat_map(|t| &t.faces)) {
        roles.entry(key(&f.a)).or_default().contact = true;
        roles.entry(key(&f.b)).or_default().contact = true;
    }
    for g in &model.ground {
        for f in &g.faces {
            roles.entry(key(f)).or_default().contact = true;
        }
    }
    for f in model.cut_faces() {
        roles.entry(key(&f.a)).or_default().cut = true;
        roles.entry(key(&f.b)).or_default().cut = true;
    }
    roles
}

/// One face of an interface seen from side A.
pub struct InterfaceFace<'a, L> {
    /// Number among the faces of its kind; among contact faces, interfaces come first.
    pub index: usize,
    /// Law of the interface.
    pub law: &'a L,
    /// Number of its interface among those of its kind; contacts with the ground follow those
    /// between parts.
    pub of: usize,
    /// Side A.
    pub a: BoundaryFace,
    /// Vertices on side A, outward order.
    pub nodes_a: [u32; 3],
    /// Side B with the matching vertices; `None`: rigid ground.
    pub b: Option<(BoundaryFace, [u32; 3])>,
}

/// A face in contact.
pub type ContactFace<'a> = InterfaceFace<'a, ContactLaw>;
/// A face of a weld of finite strength.
pub type WeldFace<'a> = InterfaceFace<'a, Weld>;
/// A face of a tie.
pub type TieFace<'a> = InterfaceFace<'a, Tie>;

fn pair<'a, L>(law: &'a L, of: usize, f: &FacePair) -> InterfaceFace<'a, L> {
    InterfaceFace { index: 0, law, of, a: f.a, nodes_a: f.nodes_a, b: Some((f.b, f.nodes_b)) }
}

/// Every weld face of the model, weld by weld.
pub fn weld_faces(model: &AnalysisModel) -> Vec<WeldFace<'_>> {
    let welds = model.welds.iter().enumerate();
    numbered(welds.flat_map(|(of, weld)| weld.faces.iter().map(move |f| pair(weld, of, f))))
}

/// Every tie face of the model, tie by tie.
pub fn tie_faces(model: &AnalysisModel) -> Vec<TieFace<'_>> {
    let ties = model.ties.iter().enumerate();
    numbered(ties.flat_map(|(of, tie)| tie.faces.iter().map(move |f| pair(tie, of, f))))
}

/// Every contact face of the model, interfaces first.
pub fn contact_faces(model: &AnalysisModel) -> Vec<ContactFace<'_>> {
    let interfaces = model.interfaces.iter().enumerate();
    let interfaces =
        interfaces.flat_map(|(of, i)| i.faces.iter().map(move |f| pair(&i.law, of, f)));
    let ground = (model.interfaces.len()..).zip(&model.ground).flat_map(|(of, g)| {
        g.faces.iter().map(move |f| ContactFace {
            index: 0,
            law: &g.law,
            of,
            a: *f,
            nodes_a: FACES[f.local as usize].map(|i| model.mesh.tets[f.tet as usize][i]),
            b: None,
        })
    });
    numbered(interfaces.chain(ground))
}

fn numbered<'a, L>(faces: impl Iterator<Item = InterfaceFace<'a, L>>) -> Vec<InterfaceFace<'a, L>> {
    faces.enumerate().map(|(index, f)| InterfaceFace { index, ..f }).collect()
}

impl<L> InterfaceFace<'_, L> {
    /// Corners \[mm\].
    pub fn corners(&self, model: &AnalysisModel) -> [V3; 3] {
        self.nodes_a.map(|n| model.mesh.nodes[n as usize])
    }

    /// Unit normal out of side A and area \[mm²\].
    pub fn normal(&self, model: &AnalysisModel) -> (V3, f64) {
        let a = vec3::area_vector(&self.corners(model));
        let size = vec3::norm(a);
        (vec3::scale(1.0 / size, a), size)
    }
}

impl ContactFace<'_> {
    /// Bernstein coefficients of initial gap and shift \[mm\].
    pub fn opening(&self, model: &AnalysisModel) -> Bernstein {
        model.opening(self.index, self.law, &self.corners(model))
    }
}
