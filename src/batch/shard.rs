//! The part of a sweep that one process does: shard i of n.

use crate::diag::{Diagnostic, Diagnostics};

/// A shard; `1/1` is the whole sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Number of the shard, from 0.
    index: u32,
    /// Number of shards.
    count: u32,
}

/// Environment variables with the number of an array task: name, and the number of the first task
/// where it is fixed. Slurm's arrays begin where their script says; those of `bracket batch slurm`
/// begin at 1.
const TASKS: [(&str, u32); 3] =
    [("SLURM_ARRAY_TASK_ID", 1), ("JOB_COMPLETION_INDEX", 0), ("AWS_BATCH_JOB_ARRAY_INDEX", 0)];

impl Shard {
    /// The whole sweep.
    pub const WHOLE: Self = Self { index: 0, count: 1 };

    /// Reads `i/n`, or `auto/n`, which takes i from the array index that Slurm, Kubernetes or AWS
    /// Batch sets; `variable` reads an environment variable.
    pub fn parse(
        text: &str,
        variable: impl Fn(&str) -> Option<String>,
    ) -> Result<Self, Diagnostics> {
        let refuse = |why: String| {
            Diagnostics::from(
                Diagnostic::input("cli/value", format!("--shard is `{text}`: {why}"))
                    .help("write `2/5` for the second of five shards, or `auto/5` in a job array"),
            )
        };
        let Some((index, count)) = text.split_once('/') else {
            return Err(refuse("it is not of the form i/n".into()));
        };
        let number = |word: &str| {
            word.trim().parse::<u32>().map_err(|_| refuse(format!("`{word}` is not a number")))
        };
        let count = number(count)?;
        let index = if index.trim() == "auto" {
            let task =
                TASKS.iter().find_map(|(name, first)| Some((*name, *first, variable(name)?)));
            let Some((name, first, value)) = task else {
                let names: Vec<&str> = TASKS.iter().map(|t| t.0).collect();
                return Err(refuse(format!("none of {} is set", names.join(", "))));
            };
            let task = value.trim().parse::<u32>().ok().and_then(|t| (t + 1).checked_sub(first));
            task.ok_or_else(|| refuse(format!("{name} is `{value}`")))?
        } else {
            number(index)?
        };
        if count == 0 || index == 0 || index > count {
            return Err(refuse(format!("shard {index} of {count} does not exist")));
        }
        Ok(Self { index: index - 1, count })
    }

    /// The items of this shard: item k of every n.
    pub fn of<'a, T>(&self, items: &'a [T]) -> impl Iterator<Item = &'a T> + use<'a, T> {
        items.iter().skip(self.index as usize).step_by(self.count as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_in_one_shard() {
        let items: Vec<u32> = (0..23).collect();
        for n in [1, 2, 5, 40] {
            let mut all: Vec<u32> = (1..=n)
                .flat_map(|i| {
                    let shard = Shard::parse(&format!("{i}/{n}"), |_| None).expect("a shard");
                    shard.of(&items).copied().collect::<Vec<_>>()
                })
                .collect();
            all.sort_unstable();
            assert_eq!(all, items, "{n}");
        }
    }

    #[test]
    fn array_indices() {
        let set = |name: &'static str, value: &'static str| {
            move |v: &str| (v == name).then(|| value.to_string())
        };
        for (name, value, index) in [
            ("SLURM_ARRAY_TASK_ID", "1", 0),
            ("SLURM_ARRAY_TASK_ID", "5", 4),
            ("JOB_COMPLETION_INDEX", "0", 0),
            ("AWS_BATCH_JOB_ARRAY_INDEX", "4", 4),
        ] {
            let shard = Shard::parse("auto/5", set(name, value));
            assert_eq!(shard, Ok(Shard { index, count: 5 }), "{name}={value}");
        }
        for (text, value) in
            [("auto/5", "6"), ("auto/5", "0"), ("auto/5", "x"), ("6/5", ""), ("0/5", ""), ("1", "")]
        {
            assert!(
                Shard::parse(text, set("SLURM_ARRAY_TASK_ID", value)).is_err(),
                "{text} {value}"
            );
        }
        assert!(Shard::parse("auto/5", |_| None).is_err());
        assert!(Shard::parse("1/0", |_| None).is_err());
    }
}
