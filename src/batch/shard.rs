//! The part of a sweep that one process does: shard i of n.

use bracket_base::diag::{Diagnostic, Diagnostics};

/// Most shards of a sweep.
const MOST: u32 = 10_000;

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
        if count > MOST {
            return Err(refuse(format!("at most {MOST} shards are possible")));
        }
        Ok(Self { index: index - 1, count })
    }

    /// Positions of the items of this shard, ascending. The items are divided by their forecast
    /// seconds: the longest first, each to the shard with the least work.
    pub fn of(&self, seconds: &[f64]) -> Vec<usize> {
        let mut longest: Vec<usize> = (0..seconds.len()).collect();
        // a stable sort: equal items go to the shards in turn
        longest.sort_by(|a, b| seconds[*b].total_cmp(&seconds[*a]));
        let mut work = vec![0.0f64; self.count as usize];
        let mut own = Vec::new();
        for item in longest {
            let least = (0..work.len()).min_by(|a, b| work[*a].total_cmp(&work[*b])).unwrap_or(0);
            work[least] += seconds[item];
            if least == self.index as usize {
                own.push(item);
            }
        }
        own.sort_unstable();
        own
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shards(n: usize, seconds: &[f64]) -> Vec<Vec<usize>> {
        let shard = |i: usize| Shard::parse(&format!("{i}/{n}"), |_| None).expect("a shard");
        (1..=n).map(|i| shard(i).of(seconds)).collect()
    }

    #[test]
    fn every_item_is_in_one_shard() {
        for n in [1, 2, 5, 40] {
            for seconds in [vec![1.0; 23], (0..23).map(|i| f64::from(i % 7)).collect()] {
                let mut all = shards(n, &seconds).concat();
                all.sort_unstable();
                assert_eq!(all, (0..23).collect::<Vec<_>>(), "{n}");
            }
        }
    }

    /// Twelve joints of ten minutes and four of an hour: two shards of three hours.
    #[test]
    fn shards_have_equal_work() {
        let seconds: Vec<f64> = (0..16).map(|i| if i < 12 { 600.0 } else { 3600.0 }).collect();
        for shard in shards(2, &seconds) {
            assert_eq!(shard.iter().map(|i| seconds[*i]).sum::<f64>(), 10_800.0);
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
