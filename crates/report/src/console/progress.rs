//! Shows the events of a pass as lines and bars.

use crate::console::log::Log;
use crate::console::pace::{Pace, about};
use crate::figures::{Rounding, fixed, percent_up, significant};
use crate::result::refusal::{gib, refusal_words, room_words};
use bracket_engine::analysis::event::Event;
use bracket_engine::analysis::program::Program;
use bracket_engine::solve::{Forecast, Iteration};

fn forecast_words(unknowns: usize, forecast: Option<&Forecast>) -> String {
    let mut text = format!("{} unknowns", fixed(unknowns as f64, 0, Rounding::Nearest));
    if let Some(f) = forecast {
        let millions = significant(f.factor_entries as f64 / 1e6, 3, Rounding::Nearest);
        let memory = gib(f.bytes, Rounding::Up);
        text += &format!(
            ", {millions} million factor entries, {memory} of memory, {}",
            about(f.seconds)
        );
    }
    text
}

/// Logs an event of a program of a load case. `tolerance` is the gap at which its solve ends.
pub fn note(log: &Log, case: &str, tolerance: f64, program: Program, event: Event<'_>) {
    let name = program.name();
    match event {
        Event::Assembly => log.stage(format!("{case}: assembling the {name} program")),
        Event::Forecast { unknowns, forecast } => {
            log.line(format!("{case}: {name} program: {}", forecast_words(unknowns, forecast)));
        }
        Event::Waits { needed, room } => log.line(format!(
            "{case}: the programs run one after the other, the {name} one last: side by side they \
             need {} more memory, {}",
            gib(needed, Rounding::Up),
            room_words(&room)
        )),
        Event::Later { expected, within } => log.line(format!(
            "{case}: the lower bound comes first, the {name} program runs later: both may take {}, \
             and there are {}",
            about(expected),
            about(within)
        )),
        Event::Refused(refusal) => {
            log.line(format!(
                "{case}: the {name} program is not started: it {}",
                refusal_words(refusal)
            ));
        }
        Event::Solve { forecast } => {
            log.stage(format!("{case}: solving the {name} program"));
            log.begin(program, Pace::new(tolerance, forecast.map(|f| f.seconds)));
        }
        Event::Iteration(i) => {
            let Iteration { number, gap, residual, step, .. } = i;
            log.detail(format!(
                "{case}: {name} iteration {number}: gap {gap:.1e}, residual {residual:.1e}, step \
                 {step:.2}"
            ));
            // with bar and time left it fits into 80 columns
            log.iteration(
                program,
                i,
                &format!("iteration {number}, gap {gap:.0e}, residual {residual:.0e}"),
            );
        }
        Event::HandOver { bytes } => log.line(format!(
            "{case}: {name} program: no answer, and Clarabel takes over, with at most {} of memory",
            gib(bytes, Rounding::Up)
        )),
        Event::Tightening => log.line(format!("{case}: the bolts are tightened first")),
        Event::ConeShift { solves, change } => log.line(format!(
            "{case}: {name} program once more, cones shifted by its slips: solve {solves} changed \
             them by {} of the largest",
            percent_up(change)
        )),
        Event::Certify => {
            log.end(program);
            log.stage(format!("{case}: certifying the {name} field"));
        }
        Event::Yielding { tets } => {
            let tets = fixed(tets as f64, 0, Rounding::Nearest);
            log.line(format!("{case}: the {name} program with yield conditions in {tets} tets"));
        }
        Event::Coulomb => {
            log.line(format!("{case}: Coulomb's law by a fixed point on the {name} program"))
        }
        Event::Frictionless => {
            log.line(format!("{case}: the {name} program once more, without friction"))
        }
        Event::Ended(run) => {
            log.end(program);
            log.detail(format!(
                "{case}: {name} program: {} after {} iterations",
                run.status.words(),
                run.iterations
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GIB: u64 = 1 << 30;

    #[test]
    fn forecasts_are_in_the_words_of_users() {
        let forecast = Forecast {
            unknowns: 52_341,
            factor_entries: 12_400_000,
            factor_flops: 1e10,
            bytes: 3 * GIB / 10,
            seconds: 42.0,
        };
        assert_eq!(
            forecast_words(52_341, Some(&forecast)),
            "52\u{a0}341 unknowns, 12.4 million factor entries, 0.300 GiB of memory, about 40 s"
        );
        assert_eq!(forecast_words(912, None), "912 unknowns");
    }
}
