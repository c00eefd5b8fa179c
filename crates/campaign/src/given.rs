//! What a scenario is given: what its number stands for, and all that is drawn for it.

use sieben_sim::wrap::Fault;

use crate::draws::{Stream, seed_of};
use crate::numbering::{Numbering, Point};
use crate::spec::{Draw, Drawn, FaultRow, Spec, Value, Walk};

/// Most faults that a plant can have are far more than this: a time of one microsecond is the least that a fault lasts.
const LEAST_US: f64 = 1.0;
/// Most changes of a walk.
const CHANGES_MAX: u64 = 1_000_000;

/// What a scenario is given.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// Its number.
    pub number: u64,
    /// What the number stands for.
    pub point: Point,
    /// Its seed.
    pub seed: u64,
    /// Values from the beginning: the place among all sweeps and, after them, all draws.
    pub values: Vec<(usize, Value)>,
    /// Values that change again and again.
    pub walks: Vec<Walked>,
    /// How signals of plants fail, each with the place of its row in the file.
    pub faults: Vec<(usize, Fault)>,
}

/// A walk.
#[derive(Clone, Debug, PartialEq)]
pub struct Walked {
    /// The place among all sweeps and, after them, all draws.
    pub index: usize,
    /// The changes with their times, in microseconds. A bit begins with 0.
    pub changes: Vec<(u64, Value)>,
}

impl Given {
    /// Of a number.
    pub fn of(spec: &Spec, numbering: &Numbering, number: u64) -> Self {
        let point = numbering.point(number);
        let seed = seed_of(spec.seed, number);
        let swept = |(sweep, &place): (&crate::spec::Sweep, &usize)| sweep.values.get(place).cloned();
        let mut values: Vec<(usize, Value)> = (0..).zip(spec.sweep.iter().zip(&point.sweep).filter_map(swept)).collect();
        let mut walks = Vec::new();
        for (index, draw) in (spec.sweep.len()..).zip(&spec.draw) {
            match drawn(draw, seed, spec) {
                Found::Value(value) => values.push((index, value)),
                Found::Changes(changes) => walks.push(Walked { index, changes }),
            }
        }
        let faults = (0..).zip(&spec.faults).filter_map(|(index, row)| Some((index, fault(row, seed, spec)?))).collect();
        Self { number, point, seed, values, walks, faults }
    }
}

enum Found {
    Value(Value),
    Changes(Vec<(u64, Value)>),
}

fn drawn(draw: &Draw, seed: u64, spec: &Spec) -> Found {
    let mut stream = Stream::new(seed, &draw.name.text);
    match &draw.drawn {
        Drawn::Once(law) => Found::Value(Value::Number(stream.draw(law))),
        Drawn::Choice(values) => Found::Value(values.get(stream.index(values.len())).cloned().unwrap_or(Value::Number(0.0))),
        Drawn::Walk(walk) => Found::Changes(walked(walk, &mut stream, spec)),
    }
}

/// The changes of a walk until the faults end.
fn walked(walk: &Walk, stream: &mut Stream, spec: &Spec) -> Vec<(u64, Value)> {
    let mut changes = Vec::new();
    let (mut bit, mut number) = (false, walk.least.max(0.0).min(walk.most));
    let end = spec.for_us.unwrap_or(0);
    for time in (1..=CHANGES_MAX).map(|count| walk.every_us.max(1).saturating_mul(count)).take_while(|&time| time < end) {
        // Both draws are taken, so that a step which does not come moves none that do.
        let (comes, up) = (stream.fraction() < walk.chance, stream.fraction() < 0.5);
        if !comes {
            continue;
        }
        let value = match walk.step {
            None => {
                bit = !bit;
                Value::Boolean(bit)
            }
            Some(step) => {
                number = (if up { number + step } else { number - step }).clamp(walk.least, walk.most);
                Value::Number(number)
            }
        };
        changes.push((time, value));
    }
    changes
}

/// A fault that comes in this scenario; it is over when the time to settle begins.
fn fault(row: &FaultRow, seed: u64, spec: &Spec) -> Option<Fault> {
    let name = |part: &str| format!("fault {}: {part}", row.stream);
    let possible = !spec.swarm_faults || Stream::new(seed, &format!("swarm {}", row.stream)).fraction() < 0.5;
    let comes = Stream::new(seed, &name("chance")).fraction() < row.chance;
    if !possible || !comes {
        return None;
    }
    let kind = *row.kinds.get(Stream::new(seed, &name("kind")).index(row.kinds.len()))?;
    let from = Stream::new(seed, &name("from")).draw(&row.from).max(0.0);
    let lasts = row.lasts.map(|law| Stream::new(seed, &name("for")).draw(&law).max(LEAST_US));
    let end = spec.for_us.filter(|_| spec.settle_us > 0);
    let until = lasts.map(|lasts| (from + lasts) as u64);
    let until = until.into_iter().chain(end).min();
    // Conversions of floats saturate.
    let from = from as u64;
    let (module, signal) = row.signal.text.split_once('.')?;
    let fault = Fault { module: module.to_owned(), signal: signal.to_owned(), kind, from_us: Some(from), until_us: until };
    until.is_none_or(|until| until > from).then_some(fault)
}

#[cfg(test)]
mod tests {
    use sieben_model::source::{FileId, Span};
    use sieben_sim::wrap::FaultKind;

    use super::*;
    use crate::spec::{Law, Placed};

    fn placed(text: &str) -> Placed {
        Placed { text: text.to_owned(), span: Span::new(FileId(0), 0, 0) }
    }

    fn once(name: &str, law: Law) -> Draw {
        Draw { name: placed(name), drawn: Drawn::Once(law), unit: None }
    }

    fn spec() -> Spec {
        let walk = |step| Walk { every_us: 2_000_000, chance: 0.5, step, least: 0.0, most: 10.0 };
        let walk_of = |name: &str, step| Draw { name: placed(name), drawn: Drawn::Walk(walk(step)), unit: None };
        Spec {
            seed: 7,
            samples: 1 << 40,
            for_us: Some(100_000_000),
            settle_us: 10_000_000,
            draw: vec![once("oven.gain", Law::Normal(180.0, 8.0)), walk_of("Bit", None), walk_of("Word", Some(3.0))],
            faults: vec![FaultRow {
                stream: "oven.temperature".to_owned(),
                chance: 0.5,
                signal: placed("oven.temperature"),
                kinds: vec![FaultKind::Stuck(None), FaultKind::Drift(0.2)],
                from: Law::Uniform(60e6, 120e6),
                lasts: Some(Law::Uniform(5e6, 60e6)),
            }],
            ..Spec::default()
        }
    }

    fn given(spec: &Spec, number: u64) -> Given {
        Given::of(spec, &Numbering::new(spec, 0).expect("they can be numbered"), number)
    }

    #[test]
    fn a_scenario_depends_on_its_number_alone() {
        let spec = spec();
        let alone = given(&spec, 123_456_789);
        let in_a_row: Vec<Given> = (123_456_780..123_456_790).map(|number| given(&spec, number)).collect();
        assert_eq!(in_a_row[9], alone);
        assert_eq!(in_a_row.iter().map(|one| one.seed).collect::<std::collections::HashSet<_>>().len(), 10);
    }

    #[test]
    fn what_is_drawn_beside_it_changes_nothing() {
        let before = spec();
        let mut after = before.clone();
        after.draw.push(once("oven.noise", Law::Uniform(0.0, 0.5)));
        after.swarm_faults = false;
        for number in 0..100 {
            let (one, other) = (given(&before, number), given(&after, number));
            assert_eq!((&one.values[..], &one.walks, &one.faults), (&other.values[..1], &other.walks, &other.faults));
        }
    }

    #[test]
    fn faults_come_as_often_as_their_chance_and_are_over_when_it_settles() {
        let spec = spec();
        let faults: Vec<Fault> = (0..2_000).flat_map(|number| given(&spec, number).faults).map(|(_, fault)| fault).collect();
        // A third of them would begin when it is over: from 100 to 120 of 60 to 120 seconds.
        assert!((560..780).contains(&faults.len()), "{}", faults.len());
        assert!(faults.iter().all(|fault| fault.until_us.is_some_and(|until| until <= 100_000_000 && Some(until) > fault.from_us)));
        let swarm = Spec { swarm_faults: true, ..spec };
        let fewer = (0..2_000).map(|number| given(&swarm, number).faults.len()).sum::<usize>();
        assert!((250..430).contains(&fewer), "{fewer}");
    }

    #[test]
    fn a_walk_keeps_its_times_and_its_limits() {
        let spec = spec();
        for number in 0..50 {
            let [bit, word] = &given(&spec, number).walks[..] else { panic!("two walks") };
            assert!(bit.changes.iter().all(|(time, _)| time % 2_000_000 == 0 && *time < 100_000_000));
            let values = bit.changes.iter().map(|(_, value)| value.clone());
            let changing = (0..bit.changes.len()).map(|index| Value::Boolean(index % 2 == 0));
            assert!(values.eq(changing));
            assert!(word.changes.iter().all(|(_, value)| matches!(value, Value::Number(number) if (0.0..=10.0).contains(number))));
        }
    }
}
