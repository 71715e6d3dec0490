//! Lets one document extend another: what it leaves out is taken from the other document.

use super::place::PlaceIndex;
use serde_yaml::{Mapping, Value};

/// A list entry with this text stands for all entries of the base document's list that this list
/// does not name.
pub const REST: &str = "base";

/// Keys whose value names an entry of a list.
const NAMES: [&str; 2] = ["name", "role"];

/// Merges two documents. A key of `own` replaces the same key of `base`, with two exceptions:
/// - A list whose entries have names keeps the entries of `own` in their order. An entry that
///   `base` names too takes the keys that it leaves out from `base`. The entry [`REST`] stands for
///   all entries of `base` that the list does not name, in their order.
/// - The values of the keys `merged` are mappings. Every key that such a mapping of `own` leaves
///   out is taken from `base`.
///
/// The index gives the place of every entry in the document that it comes from.
pub(super) fn extend(
    own: (Mapping, &PlaceIndex),
    base: (Mapping, &PlaceIndex),
    merged: &[&str],
) -> (Mapping, PlaceIndex) {
    let ((own, own_index), (base, base_index)) = (own, base);
    let mut index = own_index.root();
    let mut all = Mapping::new();
    for (key, value) in own {
        let Some(path) = key.as_str().map(str::to_owned) else {
            // a key that is no text stays, so that the typed reader refuses it
            all.insert(key, value);
            continue;
        };
        let value = match (value, base.get(&key)) {
            (Value::Sequence(list), Some(Value::Sequence(of_base))) => {
                let list = entries(&path, (list, own_index), (of_base, base_index), &mut index);
                Value::Sequence(list)
            }
            (Value::Mapping(map), Some(Value::Mapping(of_base)))
                if merged.contains(&path.as_str()) =>
            {
                index.take(&path, own_index, &path);
                index.take(&path, base_index, &path);
                Value::Mapping(filled(map, of_base))
            }
            (value, _) => value,
        };
        index.take(&path, own_index, &path);
        all.insert(key, value);
    }
    for (key, value) in base {
        if !all.contains_key(&key) {
            if let Some(path) = key.as_str() {
                index.take(path, base_index, path);
            }
            all.insert(key, value);
        }
    }
    (all, index)
}

/// Merges a list with the list that it extends. `index` receives the places of its entries.
fn entries(
    path: &str,
    (own, own_index): (Vec<Value>, &PlaceIndex),
    (base, base_index): (&[Value], &PlaceIndex),
    index: &mut PlaceIndex,
) -> Vec<Value> {
    let named: Vec<String> = own.iter().filter_map(name).map(str::to_owned).collect();
    let mut all: Vec<Value> = Vec::new();
    let mut rest_taken = false;
    for (i, entry) in own.into_iter().enumerate() {
        // a second one stays a text, which the typed reader refuses: a chain of templates would
        // double its lists with every file
        if entry.as_str() == Some(REST) && !std::mem::replace(&mut rest_taken, true) {
            let rest = base.iter().enumerate();
            for (k, other) in
                rest.filter(|(_, e)| !name(e).is_some_and(|n| named.iter().any(|o| o == n)))
            {
                index.take(&at(path, all.len()), base_index, &at(path, k));
                all.push(other.clone());
            }
            continue;
        }
        let here = at(path, all.len());
        index.take(&here, own_index, &at(path, i));
        let same = name(&entry).and_then(|n| base.iter().position(|b| name(b) == Some(n)));
        all.push(match (entry, same.map(|k| (k, &base[k]))) {
            (Value::Mapping(map), Some((k, Value::Mapping(other)))) => {
                index.take(&here, base_index, &at(path, k));
                Value::Mapping(filled(map, other))
            }
            (entry, _) => entry,
        });
    }
    all
}

fn at(path: &str, i: usize) -> String {
    format!("{path}[{i}]")
}

/// The name of an entry, if it has one.
fn name(entry: &Value) -> Option<&str> {
    NAMES.iter().find_map(|key| entry.get(key)?.as_str())
}

/// The keys of `own`, completed by those of `base` that it leaves out.
///
/// The keys stand in the order of `base`, so that one that must be first stays there.
fn filled(mut own: Mapping, base: &Mapping) -> Mapping {
    let mut all = Mapping::new();
    for (key, value) in base {
        all.insert(key.clone(), own.shift_remove(key).unwrap_or_else(|| value.clone()));
    }
    all.extend(own);
    all
}
