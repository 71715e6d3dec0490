//! `bracket templates`.

use super::common::{CommandResult, Common, Format};
use super::new::named_on_the_command_line;
use bracket_base::diag::{Diagnostics, ExitStatus, in_line};
use bracket_joint::assembly::template::{self, Template};
use bracket_joint::assembly::template_file::{self, SHIPPED};
use bracket_report::console::out;
use serde_json::{Value, json};
use std::path::Path;

/// List the connection templates, or show one.
#[derive(Debug, clap::Args)]
pub struct TemplatesArgs {
    /// Show this template: its members, parameters and loadable sections.
    #[arg(value_name = "NAME")]
    pub name: Option<String>,
}

/// Runs `bracket templates`.
pub fn run(args: &TemplatesArgs, common: &Common) -> CommandResult {
    let names: Vec<&str> = match &args.name {
        Some(n) => vec![n],
        None => SHIPPED.iter().map(|(n, _)| *n).collect(),
    };
    let loaded: Result<Vec<Template>, Diagnostics> =
        names.into_iter().map(|n| Ok(template_file::load(n, Path::new("."))?.0)).collect();
    let loaded = loaded.map_err(named_on_the_command_line)?;
    match (common.format, &args.name) {
        (Format::Json, None) => {
            out::data(&format!("{}\n", Value::from_iter(loaded.iter().map(data))))?;
        }
        (Format::Json, Some(_)) => {
            loaded.iter().try_for_each(|t| out::data(&format!("{}\n", data(t))))?;
        }
        (Format::Text, None) => {
            let width = loaded.iter().map(|t| t.name.len()).max().unwrap_or(0);
            let line =
                |t: &Template| format!("{:width$}  {}\n", in_line(&t.name), in_line(&t.title));
            out::text(&loaded.iter().map(line).collect::<String>())?;
        }
        (Format::Text, Some(_)) => loaded.iter().try_for_each(|t| out::text(&page(t)))?,
    }
    Ok(ExitStatus::Ok)
}

fn data(t: &Template) -> Value {
    let members: Vec<Value> =
        t.members.iter().map(|m| json!({"role": m.role, "about": m.about})).collect();
    let parameters: Vec<Value> = t
        .parameters
        .iter()
        .map(|p| json!({"name": p.name, "about": p.about, "required": p.default.is_none()}))
        .collect();
    let sections: Vec<Value> =
        t.sections.iter().map(|s| json!({"name": s.name, "about": s.about})).collect();
    let ends: Vec<Value> = t
        .ends
        .iter()
        .flat_map(|e| {
            e.names()
                .into_iter()
                .map(|n| json!({"name": n, "about": e.about, "at": e.point_words()}))
        })
        .collect();
    json!({
        "name": t.name, "title": t.title, "about": t.about,
        "members": members, "parameters": parameters, "sections": sections, "ends": ends,
    })
}

fn page(t: &Template) -> String {
    let mut out = format!("{}: {}\n\n{}\n", in_line(&t.name), in_line(&t.title), in_line(&t.about));
    let mut table = |title: &str, rows: Vec<(&str, String)>| {
        let width = rows.iter().map(|(n, _)| n.len()).max().unwrap_or(0);
        out.push_str(&format!("\n{title}\n"));
        for (name, about) in rows {
            out.push_str(&format!("  {:width$}  {}\n", in_line(name), in_line(&about)));
        }
    };
    table("Members", t.members.iter().map(|m| (m.role.as_str(), m.about.clone())).collect());
    let required = |p: &template::Parameter| if p.default.is_none() { " (required)" } else { "" };
    table(
        "Parameters",
        t.parameters
            .iter()
            .map(|p| (p.name.as_str(), format!("{}{}", p.about, required(p))))
            .collect(),
    );
    table(
        "Sections that loads can name",
        t.sections.iter().map(|s| (s.name.as_str(), s.about.clone())).collect(),
    );
    if !t.ends.is_empty() {
        let rows: Vec<(String, String)> = t
            .ends
            .iter()
            .flat_map(|e| {
                e.names()
                    .into_iter()
                    .map(|n| (n, format!("{}; at: {}", e.about, e.point_words().join(", "))))
            })
            .collect();
        table(
            "Member ends that forces and moments can act on",
            rows.iter().map(|(n, a)| (n.as_str(), a.clone())).collect(),
        );
    }
    out.push_str(&format!(
        "\n`bracket new {}` writes a starter with defaults and ranges.\n",
        t.name
    ));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_template_loads_under_its_name_and_explains_itself() {
        for (name, _) in SHIPPED {
            let (t, _) = template_file::load(name, Path::new("."))
                .unwrap_or_else(|e| panic!("{name}: {e:#?}"));
            assert_eq!(t.name, *name);
            let page = page(&t);
            for p in &t.parameters {
                assert!(!p.about.is_empty() && page.contains(&p.name), "{name}: {}", p.name);
            }
        }
    }
}
