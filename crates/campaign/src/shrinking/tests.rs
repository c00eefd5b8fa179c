//! What shrinking makes of cases whose failure is known.

use sieben_sim::scenario::PlantLine;
use sieben_sim::scenario::changing::Timed;
use sieben_sim::trace::Moment;
use sieben_sim::wrap::{Fault, FaultKind};

use super::*;

fn at(time_us: u64, name: &str, value: &str) -> Timed {
    Timed { time_us, name: name.to_owned(), value: value.to_owned() }
}

fn case() -> Case {
    let events: Vec<Timed> =
        (1..=40).map(|n| at(n * 1_234_567, ["A", "B", "C", "D"][n as usize % 4], if n % 8 < 4 { "1" } else { "0" })).collect();
    Case {
        cycle_us: 10_000,
        scans: 6_000,
        plants: vec![PlantLine {
            module: "oven".to_owned(),
            seed: Some(77),
            parameters: vec![("gain".to_owned(), 181.2345), ("noise".to_owned(), 0.3)],
        }],
        set: vec![
            SetValue { name: "On".to_owned(), value: "1".to_owned(), freedom: Freedom::Fixed },
            SetValue { name: "I 0.0".to_owned(), value: "1".to_owned(), freedom: Freedom::Usual("0".to_owned()) },
            SetValue { name: "Gain".to_owned(), value: "7.31".to_owned(), freedom: Freedom::Optional },
        ],
        at: events,
        replayed: Vec::new(),
        faults: vec![Fault {
            module: "oven".to_owned(),
            signal: "t".to_owned(),
            kind: FaultKind::Stuck(None),
            from_us: Some(3_100_000),
            until_us: None,
        }],
    }
}

fn signature(what: &str) -> Signature {
    Signature { what: what.to_owned(), place: None }
}

/// Breaks where `C` becomes 1 after `A` has become 1, if `Gain` is above 5.
fn breaks(case: &Case) -> Option<Break> {
    let gain = case.set.iter().find(|set| set.name == "Gain")?.value.parse::<f64>().ok()?;
    let first = case.at.iter().find(|one| one.name == "A" && one.value == "1")?;
    let then = case.at.iter().find(|one| one.name == "C" && one.value == "1" && one.time_us >= first.time_us)?;
    let scan = then.time_us.div_ceil(case.cycle_us);
    (gain > 5.0 && scan < case.scans).then(|| Break { signature: signature("p"), at: Moment { scan, time_us: scan * case.cycle_us } })
}

#[test]
fn only_what_it_takes_to_break_is_left() {
    let first = case();
    let broken = breaks(&first).expect("it breaks");
    let shrunk = shrink(first, broken, &mut breaks, &|| false);
    let case = &shrunk.case;
    let events: Vec<(u64, &str)> = case.at.iter().map(|one| (one.time_us, one.name.as_str())).collect();
    assert_eq!(events, [(0, "A"), (0, "C")]);
    assert_eq!((case.scans, case.faults.len(), shrunk.at.scan), (1, 0, 0));
    assert_eq!((case.plants[0].seed, case.plants[0].parameters.len()), (None, 0));
    let set: Vec<(&str, &str)> = case.set.iter().map(|set| (set.name.as_str(), set.value.as_str())).collect();
    assert_eq!(set, [("On", "1"), ("I 0.0", "0"), ("Gain", "7.0")]);
    assert!(shrunk.runs < 200, "{}", shrunk.runs);
    // The same once more: nothing of it is drawn.
    let first = self::case();
    let broken = breaks(&first).expect("it breaks");
    assert_eq!(shrink(first, broken, &mut breaks, &|| false), shrunk);
}

#[test]
fn a_fault_that_it_takes_comes_as_late_and_is_as_short_as_it_may() {
    let mut breaks = |case: &Case| {
        let fault = case.faults.first()?;
        let (from, until) = (fault.from_us.unwrap_or(0), fault.until_us.unwrap_or(u64::MAX));
        let fails = from <= 20_000_000 && until >= 20_010_000 && case.scans > 2_001;
        fails.then(|| Break { signature: signature("p"), at: Moment { scan: 2_001, time_us: 20_010_000 } })
    };
    let broken = breaks(&case()).expect("it breaks");
    let shrunk = shrink(case(), broken, &mut breaks, &|| false);
    let fault = &shrunk.case.faults[0];
    assert!(fault.from_us.is_some_and(|from| (19_900_000..=20_000_000).contains(&from)), "{fault:?}");
    assert_eq!((shrunk.case.at.len(), shrunk.case.scans), (0, 2_002));
}

#[test]
fn another_way_to_fail_is_not_taken_and_it_ends_when_it_is_told() {
    let mut runs = 0;
    let mut other = |case: &Case| {
        runs += 1;
        let what = if case.at.len() == 40 { "p" } else { "q" };
        Some(Break { signature: signature(what), at: Moment { scan: 5_999, time_us: 59_990_000 } })
    };
    let broken = other(&case()).expect("it breaks");
    assert_eq!(shrink(case(), broken.clone(), &mut other, &|| false).case.at.len(), 40);
    let told = shrink(case(), broken, &mut other, &|| true);
    assert_eq!((told.case, told.runs), (case(), 0));
    assert!(runs < RUNS_MAX, "{runs}");
}

/// Breaks where the third value of `Pulse` comes before `Stop`, whatever else is disturbed.
fn breaks_by_time(case: &Case) -> Option<Break> {
    let time = |name: &str, index: usize| case.replayed.iter().filter(|one| one.recorded.name == name).nth(index).map(|one| one.time_us);
    let (pulse, stop) = (time("Pulse", 2)?, time("Stop", 0)?);
    (pulse <= stop).then(|| Break { signature: signature("recording"), at: Moment { scan: 40, time_us: 400_000 } })
}

#[test]
fn of_a_recording_only_the_disturbance_goes_and_never_an_input() {
    let recorded = |time_us: u64, name: &str, value: &str| Replayed::as_recorded(at(time_us, name, value));
    let mut replayed: Vec<Replayed> =
        (1..=6).map(|n: u64| recorded(n * 100_000, "Pulse", if n.is_multiple_of(2) { "0" } else { "1" })).collect();
    replayed.push(recorded(290_000, "Stop", "0"));
    for (index, one) in replayed.iter_mut().enumerate() {
        one.time_us = if index.is_multiple_of(2) { one.time_us - 12_345 } else { one.time_us + 14_321 };
    }
    replayed[0].bounce = Some((90_000, 95_000));
    let first = Case { replayed, at: Vec::new(), set: Vec::new(), plants: Vec::new(), faults: Vec::new(), ..case() };
    assert_eq!(breaks_by_time(&first), None);
    let mut first = first;
    first.replayed[6].time_us = 301_000;
    let broken = breaks_by_time(&first).expect("it breaks");
    let shrunk = shrink(first, broken, &mut breaks_by_time, &|| false);
    let left: Vec<(&str, u64)> =
        shrunk.case.replayed.iter().filter(|one| one.changes() > 0).map(|one| (one.recorded.name.as_str(), one.time_us)).collect();
    assert_eq!((left.as_slice(), shrunk.case.replayed.len()), ([("Pulse", 290_000)].as_slice(), 7));
}
