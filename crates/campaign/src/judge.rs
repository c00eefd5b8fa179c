//! Holds properties and measures against the scans of one scenario.

use sieben_sim::trace::Moment;

use crate::slots;
use crate::spec::{Measure, Of, Property, PropertyKind, Spec};

/// A property that does not hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Broken {
    /// Which of the file.
    pub property: usize,
    /// After which scan.
    pub at: Moment,
}

/// What a scenario has come to so far.
pub struct Judge<'s> {
    properties: Vec<(&'s Property, usize, Waiting)>,
    measures: Vec<(&'s Measure, usize, Gauge)>,
    came: Vec<bool>,
    cycle_s: f64,
    last: Option<Moment>,
}

/// Until when a response has time.
type Waiting = Option<u64>;

/// What is made of the values of a measure.
#[derive(Clone, Copy, Debug, Default)]
struct Gauge {
    value: Option<f64>,
    scans: f64,
    before: bool,
}

impl<'s> Judge<'s> {
    /// At the beginning of a scenario with this time from one scan to the next.
    pub fn new(spec: &'s Spec, cycle_us: u64) -> Self {
        let slots = slots::of_properties(spec);
        let first = slots.last().copied().unwrap_or(0);
        let properties: Vec<_> = spec.properties.iter().zip(slots).map(|(property, slot)| (property, slot, None)).collect();
        let measures = spec.measures.iter().zip(first..).map(|(measure, slot)| (measure, slot, Gauge::default())).collect();
        Self { came: vec![false; properties.len()], properties, measures, cycle_s: cycle_us as f64 / 1e6, last: None }
    }

    /// After a scan, with the values of all slots: the first property of the file that does not hold.
    pub fn scanned(&mut self, scan: Moment, values: &[f64]) -> Option<Broken> {
        self.last = Some(scan);
        for (measure, slot, gauge) in &mut self.measures {
            gauge.take(measure.of, values[*slot], scan, self.cycle_s);
        }
        let mut broken = None;
        for (index, (property, slot, waiting)) in self.properties.iter_mut().enumerate() {
            let holds = values[*slot] != 0.0;
            let wrong = match property.kind {
                PropertyKind::Never => holds,
                PropertyKind::Always => !holds,
                PropertyKind::Response => {
                    let answered = values[*slot + 1] != 0.0;
                    if answered {
                        *waiting = None;
                    } else if holds && waiting.is_none() {
                        *waiting = Some(scan.time_us.saturating_add(property.within_us));
                    }
                    waiting.is_some_and(|until| scan.time_us >= until)
                }
                PropertyKind::Sometimes => {
                    self.came[index] |= holds;
                    false
                }
                PropertyKind::Finally | PropertyKind::Same => false,
            };
            if wrong && broken.is_none() {
                broken = Some(Broken { property: index, at: scan });
            }
        }
        broken
    }

    /// After the last scan, whose values these are: the first property that has to hold then and does not.
    pub fn ended(&self, values: &[f64]) -> Option<Broken> {
        let scan = self.last?;
        let wrong = |(property, slot, _): &(&Property, usize, Waiting)| property.kind == PropertyKind::Finally && values[*slot] == 0.0;
        self.properties.iter().position(wrong).map(|property| Broken { property, at: scan })
    }

    /// Of each property whether it was true at least once, where that is asked.
    pub fn came(&self) -> &[bool] {
        &self.came
    }

    /// What the measures came to.
    pub fn measured(&self) -> Vec<Option<f64>> {
        self.measures.iter().map(|(measure, _, gauge)| gauge.result(measure.of)).collect()
    }
}

impl Gauge {
    fn take(&mut self, of: Of, value: f64, scan: Moment, cycle_s: f64) {
        self.scans += f64::from(u8::from(!value.is_nan()));
        let holds = value != 0.0;
        let sum = self.value.unwrap_or(0.0);
        self.value = match of {
            // What is no number is left out, so that one moment of it does not hide the others.
            Of::Min | Of::Max | Of::Mean | Of::Integral if value.is_nan() => self.value,
            Of::Min => Some(self.value.map_or(value, |least| least.min(value))),
            Of::Max => Some(self.value.map_or(value, |most| most.max(value))),
            Of::Last => Some(value),
            Of::Mean => Some(sum + value),
            Of::Integral => Some(sum + value * cycle_s),
            Of::Count => Some(sum + f64::from(u8::from(holds))),
            Of::Rises => Some(sum + f64::from(u8::from(holds && !self.before))),
            Of::FirstTime => self.value.or(holds.then_some(scan.time_us as f64 / 1e6)),
        };
        self.before = holds;
    }

    fn result(self, of: Of) -> Option<f64> {
        // What is no finite number is no result.
        self.value.map(|value| if of == Of::Mean { value / self.scans } else { value }).filter(|value| value.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::source::{FileId, Span};

    use super::*;
    use crate::spec::Placed;

    fn expression() -> Placed {
        Placed { text: "x".to_owned(), span: Span::new(FileId(0), 0, 1) }
    }

    fn judged(kind: PropertyKind, within_us: u64, scans: &[(u8, u8)]) -> Option<u64> {
        let property = Property {
            kind,
            name: "p".to_owned(),
            span: Span::new(FileId(0), 0, 1),
            expression: expression(),
            then: (kind == PropertyKind::Response).then(expression),
            within_us,
        };
        let spec = Spec { properties: vec![property], ..Spec::default() };
        let mut judge = Judge::new(&spec, 10_000);
        let mut last = Vec::new();
        for (number, &(first, then)) in (0..).zip(scans) {
            last = vec![f64::from(first), f64::from(then)];
            if let Some(broken) = judge.scanned(Moment { scan: number, time_us: number * 10_000 }, &last) {
                return Some(broken.at.scan);
            }
        }
        judge.ended(&last).map(|broken| broken.at.scan)
    }

    #[test]
    fn each_kind_breaks_where_it_says() {
        use PropertyKind::{Always, Finally, Never, Response, Sometimes};
        assert_eq!(judged(Never, 0, &[(0, 0), (1, 0)]), Some(1));
        assert_eq!(judged(Never, 0, &[(0, 0), (0, 0)]), None);
        assert_eq!(judged(Always, 0, &[(1, 0), (0, 0)]), Some(1));
        assert_eq!(judged(Finally, 0, &[(1, 0), (0, 0)]), Some(1));
        assert_eq!(judged(Finally, 0, &[(0, 0), (1, 0)]), None);
        assert_eq!(judged(Sometimes, 0, &[(0, 0)]), None);
        // At once.
        assert_eq!(judged(Response, 0, &[(0, 0), (1, 1), (1, 0)]), Some(2));
        // Within two scans: the first one asks, the third one has no time left.
        assert_eq!(judged(Response, 20_000, &[(1, 0), (0, 0), (0, 0)]), Some(2));
        assert_eq!(judged(Response, 20_000, &[(1, 0), (0, 0), (0, 1)]), None);
        // What is asked for at the end of a scenario has had no time.
        assert_eq!(judged(Response, 20_000, &[(0, 0), (1, 0)]), None);
        // Asked again while it waits is asked once.
        assert_eq!(judged(Response, 20_000, &[(1, 0), (1, 0), (1, 0)]), Some(2));
    }

    #[test]
    fn measures_are_what_their_words_say() {
        let values = [1.0, 0.0, 3.0, f64::NAN, 2.0];
        let all: Vec<Option<f64>> = Of::ALL
            .iter()
            .map(|&(of, _)| {
                let measure = Measure { name: String::new(), span: Span::new(FileId(0), 0, 0), of, expression: expression(), unit: None };
                let spec = Spec { measures: vec![measure], ..Spec::default() };
                let mut judge = Judge::new(&spec, 500_000);
                for (number, value) in (0..).zip(values) {
                    let value = if of.counts() && value.is_nan() { 0.0 } else { value };
                    judge.scanned(Moment { scan: number, time_us: number * 500_000 }, &[value]);
                }
                judge.measured()[0]
            })
            .collect();
        // min, max, last, mean, integral, count, rises, first_time
        assert_eq!(all, [Some(0.0), Some(3.0), Some(2.0), Some(1.5), Some(3.0), Some(3.0), Some(3.0), Some(0.0)]);
    }
}
