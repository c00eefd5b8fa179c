//! The inputs of a recording, disturbed: moved in time, bouncing, off by a little.

use std::collections::BTreeMap;

use sieben_sim::scenario::changing::Timed;

use crate::draws::Stream;
use crate::spec::Disturb;

/// What is known of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// A bit: it bounces.
    Bit,
    /// A word of so many bits: something is added to it.
    Word(u32),
}

/// An input of a recording as it comes in a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replayed {
    /// As it was recorded.
    pub recorded: Timed,
    /// When it comes, in microseconds.
    pub time_us: u64,
    /// Its value.
    pub value: String,
    /// From when until when a bit bounces, in microseconds: it is the opposite between the two.
    pub bounce: Option<(u64, u64)>,
}

impl Replayed {
    /// One that comes as it was recorded.
    pub fn as_recorded(recorded: Timed) -> Self {
        Self { time_us: recorded.time_us, value: recorded.value.clone(), recorded, bounce: None }
    }

    /// In how many ways it is disturbed.
    pub fn changes(&self) -> usize {
        [self.moved_us() > 0, self.value != self.recorded.value, self.bounce.is_some()].into_iter().filter(|&is| is).count()
    }

    /// How far it is from when it was recorded, in microseconds.
    pub fn moved_us(&self) -> u64 {
        self.time_us.abs_diff(self.recorded.time_us)
    }

    /// When it has its value for good.
    fn end_us(&self) -> u64 {
        self.bounce.map_or(self.time_us, |(_, until)| until)
    }
}

/// Whether each name has its values in the order of the recording; values of one name lie together.
pub fn is_in_order(replayed: &[Replayed]) -> bool {
    replayed.windows(2).all(|pair| pair[0].recorded.name != pair[1].recorded.name || pair[0].end_us() <= pair[1].time_us)
}

/// The values in the order of their times.
pub fn timed(replayed: &[Replayed]) -> Vec<Timed> {
    let mut all = Vec::with_capacity(replayed.len());
    for one in replayed {
        let at = |time_us: u64, value: String| Timed { time_us, name: one.recorded.name.clone(), value };
        all.push(at(one.time_us, one.value.clone()));
        if let Some((open, closed)) = one.bounce {
            all.extend([at(open, opposite(&one.value)), at(closed, one.value.clone())]);
        }
    }
    all.sort_by_key(|one| one.time_us);
    all
}

/// The inputs as they come in the scenario with this seed, name by name. The order on each name is kept.
pub fn disturbed(recorded: &[Timed], disturb: &Disturb, seed: u64, width: &dyn Fn(&str) -> Width) -> Vec<Replayed> {
    let mut names: BTreeMap<&str, Vec<&Timed>> = BTreeMap::new();
    for one in recorded {
        names.entry(&one.name).or_default().push(one);
    }
    let mut all = Vec::with_capacity(recorded.len());
    for (name, values) in names {
        // Each kind of disturbance of each name has draws of its own.
        let stream = |kind: &str| Stream::new(seed, &format!("disturb {name}: {kind}"));
        let (mut times, mut bounces, mut noise) = (stream("time"), stream("bounce"), stream("value"));
        let mut last = 0;
        let moved: Vec<u64> = values
            .iter()
            .map(|one| {
                let by = disturb.time.map_or(0.0, |law| times.draw(&law));
                // Conversions of floats saturate.
                last = ((one.time_us as f64 + by).max(0.0).round() as u64).max(last);
                last
            })
            .collect();
        for (index, (&one, &time_us)) in values.iter().zip(&moved).enumerate() {
            let mut replayed = Replayed { time_us, ..Replayed::as_recorded(one.clone()) };
            match width(name) {
                Width::Word(bits) => {
                    let by = disturb.value.map_or(0.0, |law| noise.draw(&law));
                    replayed.value = added(&one.value, by, bits);
                }
                Width::Bit => {
                    if let Some((chance, lasts)) = disturb.bounce {
                        let (comes, first, second) = (bounces.fraction() < chance, bounces.fraction(), bounces.fraction());
                        let next = moved.get(index + 1).copied().unwrap_or(u64::MAX);
                        let when = |part: f64| time_us + 1 + (part * lasts as f64) as u64;
                        let (open, closed) = (when(first.min(second)), when(first.max(second)));
                        // One that would not be over before the next change does not come.
                        replayed.bounce = (comes && closed < next && open < closed).then_some((open, closed));
                    }
                }
            }
            all.push(replayed);
        }
    }
    all
}

fn opposite(bit: &str) -> String {
    let is_set = bit == "1" || bit.eq_ignore_ascii_case("true");
    if is_set { "0" } else { "1" }.to_owned()
}

/// A value with something added to it, written as it was; what is no number stays.
fn added(value: &str, by: f64, bits: u32) -> String {
    let limit = 2_f64.powi(bits.clamp(1, 64) as i32 - 1);
    if let Ok(number) = value.parse::<i64>() {
        return format!("{:.0}", (number as f64 + by).round().clamp(-limit, limit - 1.0));
    }
    if let Some(digits) = value.strip_prefix("16#")
        && let Ok(number) = u64::from_str_radix(digits, 16)
    {
        // A word in hex has no sign.
        let most = 2.0 * limit - 1.0;
        return format!("16#{:0width$X}", (number as f64 + by).round().clamp(0.0, most) as u64, width = digits.len());
    }
    match value.parse::<f64>() {
        Ok(number) if number.is_finite() => format!("{:?}", number + by),
        _ => value.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::Law;

    fn recorded() -> Vec<Timed> {
        let one = |time_us, name: &str, value: &str| Timed { time_us, name: name.to_owned(), value: value.to_owned() };
        vec![
            one(10_000, "Start", "1"),
            one(12_000, "Level", "100"),
            one(20_000, "Start", "0"),
            one(25_000, "Start", "1"),
            one(900_000, "Raw", "16#7FFF"),
        ]
    }

    fn width(name: &str) -> Width {
        if name == "Start" { Width::Bit } else { Width::Word(16) }
    }

    #[test]
    fn nothing_asked_for_changes_nothing() {
        let replayed = disturbed(&recorded(), &Disturb::default(), 5, &width);
        assert_eq!(timed(&replayed), recorded());
        assert!(replayed.iter().all(|one| one.changes() == 0));
    }

    #[test]
    fn the_order_on_one_name_is_kept() {
        let disturb =
            Disturb { time: Some(Law::Uniform(-15_000.0, 15_000.0)), bounce: Some((0.5, 30_000)), value: Some(Law::Normal(0.0, 3.0)) };
        let mut bounced = 0;
        for seed in 0..500 {
            let replayed = disturbed(&recorded(), &disturb, seed, &width);
            assert!(is_in_order(&replayed));
            let all = timed(&replayed);
            assert!(all.windows(2).all(|pair| pair[0].time_us <= pair[1].time_us));
            let start: Vec<&str> = all.iter().filter(|one| one.name == "Start").map(|one| one.value.as_str()).collect();
            bounced += usize::from(start.len() > 3);
            // Where nothing bounces the bit comes and goes as it was recorded; a bounce adds a pair.
            assert!(start.len() % 2 == 1 && start.first() == Some(&"1") && start.last() == Some(&"1"), "{start:?}");
            let level = all.iter().find(|one| one.name == "Level").expect("it is there");
            assert!(level.value.parse::<i64>().is_ok_and(|level| (80..120).contains(&level)), "{}", level.value);
        }
        assert!((100..450).contains(&bounced), "{bounced}");
    }

    #[test]
    fn words_keep_how_they_are_written_and_their_range() {
        assert_eq!(added("100", 2.6, 16), "103");
        assert_eq!(added("32766", 5.0, 16), "32767");
        assert_eq!(added("16#FFFE", 5.0, 16), "16#FFFF");
        assert_eq!(added("16#0001", -5.0, 16), "16#0000");
        assert_eq!(added("1.5", 0.25, 32), "1.75");
        assert_eq!(added("S5T#2S", 5.0, 16), "S5T#2S");
    }
}
