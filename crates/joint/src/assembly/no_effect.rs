//! Values of a spec that have no effect beside its other values.

use super::error::AssemblyError;
use super::facts::Facts;
use super::scope::{Given, Scope, path_of};
use super::template::Template;
use crate::spec::connection::ConnectionSpec;
use bracket_base::say;
use bracket_base::words::Text;
use std::collections::BTreeMap;

/// Notes on the given parameters whose `used_if` is not true, and on the section `welds` of a joint
/// without fillet welds.
pub(super) fn notes(
    spec: &ConnectionSpec,
    template: &Template,
    given: &BTreeMap<String, Given>,
    scope: &Scope,
    seen: Option<&Facts>,
) -> Result<Vec<Text>, AssemblyError> {
    let mut out = Vec::new();
    for p in &template.parameters {
        let Some(condition) = &p.used_if else { continue };
        let used = scope
            .truth(condition)
            .map_err(|cause| AssemblyError::Template { at: p.name.clone(), cause })?;
        if !used && given.contains_key(&p.name) {
            let (path, condition) = (path_of(&p.name), condition.text().to_owned());
            out.push(say!("`{}` has no effect: it counts where `{}` is true", path, condition));
        }
    }
    let roles = template.hand_checks.as_ref().and_then(|h| h.end_plate());
    let roles = roles.and_then(|h| Some((h.column.as_ref()?, &h.beam)));
    let length = |role: &String| spec.members.get(role).and_then(|m| m.length);
    if let Some((column, beam)) = roles
        && length(column).is_some()
        && length(beam).is_none()
    {
        out.push(say!(
            "`members.{}.length` has no effect: it counts beside `members.{}.length`",
            column,
            beam
        ));
    }
    let fillets = match seen {
        Some(Facts::EndPlate(e)) => e.flange_throat > 0.0 || e.web_throat > 0.0,
        Some(Facts::Simple(e)) => e.throat > 0.0,
        Some(Facts::ColumnBase(e)) => e.flange_throat > 0.0 || e.web_throat > 0.0,
        Some(Facts::CoverSplice(_)) | None => false,
    };
    if !spec.welds.is_default() && !fillets {
        out.push(
            "`welds` has no effect: neither flanges nor web of the beam have fillet welds".into(),
        );
    } else if spec.welds.bearing_in_contact && !matches!(seen, Some(Facts::EndPlate(_))) {
        out.push(
            "`welds.bearing_in_contact` has no effect: these checks count compression like tension"
                .into(),
        );
    }
    Ok(out)
}
