//! What the assembly takes from the design code of a spec.

use super::code::DesignCode;
use super::factors::FactorsOfSpec;
use crate::eurocode::yielding::each_action_alone;
use bracket_base::math::vec3::V3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::CodeValues;
use bracket_joint::catalog::{Catalog, Steel};
use bracket_joint::spec::connection::{ConnectionSpec, MemberSpec};
use bracket_joint::strength::Nominal;
use std::collections::BTreeMap;

/// What the design code of a spec says about it.
pub(super) fn values(spec: &ConnectionSpec, catalog: &Catalog) -> CodeValues {
    let mut faults = Vec::new();
    let FactorsOfSpec { values: factors, annex, resolved, low } =
        FactorsOfSpec::read(&spec.code, catalog, &mut faults);
    let edition = spec.code.edition;
    let code = DesignCode::new(edition, factors);
    let of_member = |(role, m): (&String, &MemberSpec)| {
        Some((role.clone(), code.resistances(spec, m, catalog)?))
    };
    let members = spec.members.iter().filter_map(of_member).collect();
    let notes = low.into_iter().chain(foreign_grades(spec, catalog)).collect();
    CodeValues { edition, factors, annex, resolved, notes, members, faults }
}

impl DesignCode {
    /// Design resistances of a member's section to each action alone, in the order of
    /// [`CodeValues::members`]; `None` where the catalogue lacks the profile, the steel, or a
    /// strength at the thickness of the flange. The assembly reports that.
    fn resistances(
        &self,
        spec: &ConnectionSpec,
        member: &MemberSpec,
        catalog: &Catalog,
    ) -> Option<[V3; 2]> {
        let profile = catalog.profile(&member.profile).ok()?;
        let steel = catalog.steel(&member.steel).ok()?;
        let fy = Nominal::new(steel.fy_by(spec.code.fy_source, profile.tf).ok()?);
        match self {
            Self::En1993_2005(_) => Some(each_action_alone(profile, self.yield_strength(fy))),
        }
    }
}

/// A note on ASTM steels and bolts under the checks of a European code.
fn foreign_grades(spec: &ConnectionSpec, catalog: &Catalog) -> Option<Text> {
    let foreign = |standard: &str| standard.starts_with("ASTM");
    let mut steels: BTreeMap<&str, &Steel> = BTreeMap::new();
    let plate = spec.plate.as_ref().and_then(|p| p.steel.as_deref());
    let named = spec.members.iter().map(|(role, m)| (role.as_str(), m.steel.as_str()));
    for (role, name) in named.chain(plate.map(|name| ("plate", name))) {
        steels.extend(catalog.steel(name).ok().map(|steel| (role, steel)));
    }
    let steels = steels.values().filter(|s| foreign(&s.standard)).map(|s| Text::given(&s.grade));
    let bolts = spec.bolts.iter().filter_map(|b| catalog.bolt_grade(&b.grade).ok());
    let bolts = bolts.filter(|g| g.standard.as_deref().is_some_and(foreign));
    let mut grades: Vec<Text> = Vec::new();
    for name in steels.chain(bolts.map(|g| say!("bolts {}", &g.grade))) {
        if !grades.contains(&name) {
            grades.push(name);
        }
    }
    (!grades.is_empty()).then(|| {
        say!(
            "grades of ASTM standards ({}): the checks are those of EN 1993-1-8, which does not \
             list them; the checks of AISC 360 are not in this edition",
            Text::joined(", ", grades)
        )
    })
}
