//! The cases of a sweep: every combination of the steps of its dimensions, written into the base
//! spec. The last dimension changes fastest.

use super::derived::Derived;
use super::dimension::{Dimension, Setting, words};
use super::load_lists::{LoadLists, NamedTable, is_key};
use super::spec_path::SpecPath;
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_base::yaml::{self, PlaceIndex};
use bracket_joint::spec::connection::ConnectionSpec;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A base spec and the dimensions over which it varies.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Expansion {
    /// The base spec.
    pub base: Value,
    /// Its file, for messages.
    pub file: PathBuf,
    /// The dimensions.
    pub dimensions: Vec<Dimension>,
    /// Values that follow from others.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub derived: Vec<Derived>,
    /// Load cases by the table that rows and axes name.
    #[serde(default, skip_serializing_if = "LoadLists::is_empty")]
    pub loads: LoadLists,
}

/// Whose fault makes a combination unsound.
enum Fault {
    /// That of a value of the step.
    Setting(Diagnostic),
    /// That of another dimension.
    Other,
    /// That of the base.
    Base(Diagnostic),
}

/// Reads a spec from its value. A value of a wrong type is reported with its path in the spec.
pub fn typed(spec: &Value, file: &Path) -> Result<ConnectionSpec, Box<Diagnostic>> {
    ConnectionSpec::deserialize(spec).or_else(|plain| {
        // only the reader of text reports the path of a fault
        let text = yaml::to_string(spec).map_err(|f| Box::new(f.into_first()))?;
        match yaml::parse::<ConnectionSpec>(&text, file) {
            Ok(parsed) => Ok(parsed.value),
            Err(faults) => {
                let mut d = faults.into_first();
                (d.place.line, d.place.column) = (None, None);
                if d.place.path.is_none() && d.message.is_empty() {
                    d.message = plain.to_string();
                }
                Err(d.into())
            }
        }
    })
}

impl Expansion {
    /// Number of combinations; `None` beyond the range of the type.
    pub fn count(&self) -> Option<u64> {
        self.dimensions.iter().try_fold(1u64, |n, d| n.checked_mul(d.steps.len() as u64))
    }

    /// Position of the step of each dimension in a combination.
    pub fn positions(&self, mut index: u64) -> Vec<usize> {
        let mut positions: Vec<usize> = Vec::with_capacity(self.dimensions.len());
        for d in self.dimensions.iter().rev() {
            let n = d.steps.len() as u64;
            positions.push((index % n) as usize);
            index /= n;
        }
        positions.reverse();
        positions
    }

    /// The step of each dimension in a combination.
    pub fn steps(&self, index: u64) -> Vec<&Setting> {
        let positions = self.positions(index);
        self.dimensions.iter().zip(positions).map(|(d, i)| &d.steps[i]).collect()
    }

    /// The spec of a combination, without the values that follow from others.
    pub fn varied(&self, index: u64) -> Result<Value, String> {
        self.with(&self.steps(index)).map_err(|(_, message)| message)
    }

    fn with(&self, steps: &[&Setting]) -> Result<Value, (&SpecPath, String)> {
        let mut spec = self.base.clone();
        for (d, step) in self.dimensions.iter().zip(steps) {
            d.set(step, &mut spec)?;
        }
        self.loads.put(&mut spec);
        Ok(spec)
    }

    /// The values of a combination: each path with its value in the base or of the step.
    pub fn values(&self, index: u64) -> Vec<(&str, String)> {
        let of = |(d, step): (&'_ Dimension, &'_ Setting)| -> Vec<(usize, String)> {
            let text = |(i, v): (usize, &Option<Value>)| {
                let base = || d.paths[i].get(&self.base);
                (i, v.as_ref().or_else(base).map(words).unwrap_or_default())
            };
            step.values.iter().enumerate().map(text).collect()
        };
        let mut out = Vec::new();
        for (d, step) in self.dimensions.iter().zip(self.steps(index)) {
            out.extend(of((d, step)).into_iter().map(|(i, v)| (d.paths[i].text(), v)));
        }
        out
    }

    /// The notes of a combination by their columns.
    pub fn notes(&self, index: u64) -> Vec<(&str, &str)> {
        let pairs = self.dimensions.iter().zip(self.steps(index));
        let of = pairs.flat_map(|(d, step)| d.notes.iter().zip(&step.notes));
        of.map(|(header, text)| (header.as_str(), text.as_str())).collect()
    }

    /// Name of a combination: that of the table, followed by the values of the axes.
    pub fn name(&self, index: u64) -> String {
        let steps = self.steps(index);
        let parts: Vec<String> =
            steps.into_iter().map(Setting::name).filter(|part| !part.is_empty()).collect();
        if parts.is_empty() { "base".into() } else { parts.join(" ") }
    }

    /// The paths that the dimensions and the values of `set` write.
    pub fn paths(&self) -> Vec<&str> {
        let of_dimensions = self.dimensions.iter().flat_map(|d| &d.paths);
        let of_set = self.derived.iter().map(|d| &d.path);
        of_dimensions.chain(of_set).map(SpecPath::text).collect()
    }

    /// The spec with a step of the dimension `i` beside the first steps of the others.
    fn beside_first(&self, i: usize, step: &Setting) -> Result<Value, (&SpecPath, String)> {
        let mut steps: Vec<&Setting> = self.dimensions.iter().map(|d| &d.steps[0]).collect();
        steps[i] = step;
        self.with(&steps)
    }

    /// The tables of load cases that the rows and axes name, in every combination of those that
    /// do.
    pub fn load_tables<'a>(
        &'a self,
        base: &'a PlaceIndex,
    ) -> impl Iterator<Item = NamedTable<'a>> + 'a {
        let names = |d: &Dimension| d.paths.iter().any(is_key);
        let steps = move |d: &Dimension| if names(d) { d.steps.len() } else { 1 };
        let count: usize = self.dimensions.iter().map(steps).product();
        let of = move |mut index: usize| {
            let mut chosen: Vec<&Setting> = Vec::with_capacity(self.dimensions.len());
            for d in &self.dimensions {
                chosen.push(&d.steps[index % steps(d)]);
                index /= steps(d);
            }
            let loads = self.with(&chosen).ok()?.get_mut("loads")?.take();
            let place = move |at: &str| {
                let own = self.dimensions.iter().zip(&chosen).find_map(|(d, step)| {
                    let path = d.paths.iter().find(|p| covers(at, p.text()))?;
                    Some((path, &step.place))
                });
                match own {
                    Some((path, place)) => {
                        let path = place.path.clone().unwrap_or_else(|| path.text().into());
                        Place { path: Some(path), ..place.clone() }
                    }
                    None => base.place(at),
                }
            };
            Some(NamedTable { loads, place: Box::new(place) })
        };
        (0..count).filter_map(of)
    }

    /// Checks every value of every dimension on its own, beside the first values of the others.
    /// A number at a path that holds a text becomes a text: `8.8` of a bolt grade.
    pub fn settle(&mut self, place: &PlaceIndex) -> Result<(), Diagnostics> {
        let mut faults = Vec::new();
        self.words_for_numbers();
        for (i, d) in self.dimensions.iter().enumerate() {
            for step in &d.steps {
                let fault = match self.beside_first(i, step) {
                    Err((path, message)) => {
                        let help = "name entries as in the base spec, or give them there first";
                        let d = Diagnostic::input("sweep/path", message).help(help);
                        Some(d.path(canonical(path.text(), &self.base)))
                    }
                    Ok(spec) => typed(&spec, &self.file).err().map(|d| *d),
                };
                let Some(fault) = fault else { continue };
                match self.placed(fault, i, step, place) {
                    Fault::Setting(fault) => faults.push(fault),
                    // it is reported with the dimension that brings it
                    Fault::Other => {}
                    // a fault of the base is in every case
                    Fault::Base(fault) => return Err(Diagnostics::from(fault)),
                }
                break;
            }
        }
        if self.dimensions.is_empty()
            && let Err(d) = typed(&self.base, &self.file)
        {
            faults.push(*d);
        }
        Diagnostics::refuse(faults)
    }

    /// Whose fault it is, at its place.
    fn placed(
        &self,
        fault: Diagnostic,
        dimension: usize,
        step: &Setting,
        base: &PlaceIndex,
    ) -> Fault {
        let d = &self.dimensions[dimension];
        let at = fault.place.path.clone().unwrap_or_default();
        // a key or entry on the way to a value that the base does not have comes with the value
        let new = SpecPath::parse(&at).is_ok_and(|p| p.get(&self.base).is_none());
        let touches = |p: &SpecPath| {
            let path = canonical(p.text(), &self.base);
            covers(&path, &at) || (new && covers(&at, &path))
        };
        let own = d.paths.iter().find(|p| at.is_empty() || touches(p));
        match own {
            Some(path) => {
                let mut place = step.place.clone();
                if place.path.is_none() {
                    place.path = Some(path.text().into());
                }
                let message = format!("{}: {}", d.what, fault.message);
                Fault::Setting(Diagnostic { place, message, ..fault })
            }
            None if self.dimensions.iter().any(|o| o.paths.iter().any(touches)) => Fault::Other,
            None => Fault::Base(Diagnostic { place: base.place(&at), ..fault }),
        }
    }

    /// Makes texts of the numbers of a path where the spec takes only a text.
    fn words_for_numbers(&mut self) {
        for i in 0..self.dimensions.len() {
            for k in 0..self.dimensions[i].paths.len() {
                let is_number = |s: &Setting| matches!(s.values[k], Some(Value::Number(_)));
                let Some(step) = self.dimensions[i].steps.iter().find(|s| is_number(s)).cloned()
                else {
                    continue;
                };
                let at_fault = |step: &Setting| {
                    let spec = self.beside_first(i, step).ok();
                    let fault = spec.and_then(|s| typed(&s, &self.file).err());
                    let path = canonical(self.dimensions[i].paths[k].text(), &self.base);
                    fault.and_then(|f| f.place.path).is_some_and(|at| covers(&path, &at))
                };
                let mut as_text = step.clone();
                as_text.values[k] = as_text.values[k].as_ref().map(|v| Value::String(words(v)));
                if at_fault(&step) && !at_fault(&as_text) {
                    for s in &mut self.dimensions[i].steps {
                        if let Some(v @ Value::Number(_)) = &mut s.values[k] {
                            *v = Value::String(words(v));
                        }
                    }
                }
            }
        }
    }
}

/// A path with the positions of named entries: `loads.ULS1.My` is `loads[0].My`.
pub fn canonical(text: &str, base: &Value) -> String {
    let mut out = String::new();
    let mut at = Some(base);
    for part in text.split('.') {
        let list = at.and_then(Value::as_array);
        let named = list.and_then(|l| {
            l.iter().position(|v| v.get("name").and_then(Value::as_str) == Some(part))
        });
        at = match (named, at) {
            (Some(i), Some(v)) => {
                out.push_str(&format!("[{i}]"));
                v.get(i)
            }
            (_, v) => {
                if !out.is_empty() {
                    out.push('.');
                }
                out.push_str(part);
                v.and_then(|v| v.get(part))
            }
        };
    }
    out
}

/// True if the path `at` lies at or below `path`.
pub fn covers(path: &str, at: &str) -> bool {
    at.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}
