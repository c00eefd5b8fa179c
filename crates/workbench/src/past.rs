//! Scans of the past, for pages: one of them as if it were the newest, values of many, and who wrote a value.

use serde_json::{Value as Json, json};
use sieben_cpu::Station;
use sieben_engine::{FaultPlace, Machine, StatementEvent, Stored, Tracer};
use sieben_lang::reason::Language;
use sieben_model::format::{Figure, Format};
use sieben_model::item::Item;
use sieben_model::problems::Problem;
use sieben_model::value::{Kind, Value};
use sieben_sim::names::{Name, Shown};
use sieben_sim::timing_diagram::Options;
use sieben_sim::timing_diagram::svg;
use sieben_sim::trace::{CHANNELS_MAX, Keep, Memory, Origin, Recorder, TraceError, csv, vcd};
use sieben_workspace::Refusal;
use sieben_workspace::past::{Gone, Seen, Viewer};
use sieben_workspace::project::Build;

use crate::hub::{Hub, item_of};
use crate::live::message::{History, Who};
use crate::live::program::word;

/// Scans that one question runs again at most: some seconds of work.
const SCANS_MAX: u64 = 20_000;
/// Points that all channels of an answer have together at most.
const POINTS_MAX: usize = 10_000;
/// Scans of an answer whose times are said at most, and the last one: those between are on lines between them.
const TIMES_MAX: usize = 500;
/// Points that are kept of a group of them.
const GROUP_POINTS: usize = 4;
/// Scans that are looked through at a time for who wrote a value, from the newest on.
const WRITERS_STEP: u64 = 500;

pub(crate) fn not_kept(error: Gone) -> Refusal {
    Refusal::new(Problem::P7139, error.to_string())
}

/// A value as a number for a diagram.
fn number(value: &Value) -> Option<f64> {
    match value.shown() {
        Shown::Bit(bit) => Some(f64::from(u8::from(bit))),
        Shown::Number(number) => Some(number as f64),
        Shown::Real(number) => Some(f64::from(number)),
        Shown::LongReal(number) => Some(number),
        Shown::TimeLeft(word) => milliseconds(word),
        Shown::Formatted(shown) => match (shown.figure, &value.kind) {
            (Some(Figure::Whole(number)), _) => Some(number as f64),
            (Some(Figure::Real(number)), _) => Some(f64::from(number)),
            (Some(Figure::LongReal(number)), _) => Some(number),
            (Some(Figure::OfBase { count, base_ms }), _) => Some(f64::from(count) * f64::from(base_ms)),
            // Bits that are no number in this format.
            (None, Kind::Formatted(Format::Bcd | Format::S5Time | Format::Counter, _)) => None,
            (None, _) => value.content.bits().map(|bits| bits as f64),
        },
        _ => value.content.bits().map(|bits| bits as f64),
    }
}

/// What a timer has left.
fn milliseconds(word: u16) -> Option<f64> {
    sieben_model::literal::s5time_milliseconds(word).map(|milliseconds| milliseconds as f64)
}

/// Where values of the past became others.
struct Changes<'n> {
    items: &'n [Option<Item>],
    last: Vec<Option<f64>>,
    points: Vec<Vec<(u64, f64)>>,
    seen: Option<(u64, u64)>,
    /// Scans with their times, without those that a line between their neighbours has as well.
    times: Vec<(u64, u64)>,
}

impl Changes<'_> {
    fn look(&mut self, Seen { mark, cpu }: &Seen<'_>) {
        let first = self.seen.map_or(mark.scan, |(first, _)| first);
        self.seen = Some((first, mark.scan));
        add_time(&mut self.times, (mark.scan, mark.time_us));
        for ((item, last), points) in self.items.iter().zip(&mut self.last).zip(&mut self.points) {
            let Some(item) = item else { continue };
            let value = cpu.read_items(std::slice::from_ref(item)).into_iter().next().and_then(Result::ok);
            let now = value.as_ref().and_then(number);
            if let Some(number) = now.filter(|_| now != *last) {
                points.push((mark.scan, number));
            }
            *last = now;
        }
    }
}

/// Adds a scan with its time; the one before goes where it is on the line from the one before that to this.
fn add_time(times: &mut Vec<(u64, u64)>, (scan, us): (u64, u64)) {
    if let [.., one, other] = **times
        && other.1.saturating_sub(one.1) * (scan - other.0) == us.saturating_sub(other.1) * (other.0 - one.0)
    {
        times.pop();
    }
    times.push((scan, us));
}

/// As few points as are wanted: of each group the first, the least, the greatest and the last one.
fn thinned(points: Vec<(u64, f64)>, most: usize) -> Vec<(u64, f64)> {
    if points.len() <= most {
        return points;
    }
    let groups = (most / GROUP_POINTS).max(1);
    let mut thin = Vec::with_capacity(groups * GROUP_POINTS);
    for chunk in points.chunks(points.len().div_ceil(groups)) {
        let least = chunk.iter().min_by(|one, other| one.1.total_cmp(&other.1));
        let greatest = chunk.iter().max_by(|one, other| one.1.total_cmp(&other.1));
        let mut kept: Vec<(u64, f64)> = [chunk.first(), least, greatest, chunk.last()].into_iter().flatten().copied().collect();
        kept.sort_by_key(|&(scan, _)| scan);
        kept.dedup_by_key(|&mut (scan, _)| scan);
        thin.append(&mut kept);
    }
    thin
}

/// The scans of a question, of which the newest ones are wanted most where there are too many.
///
/// # Errors
/// None of them is kept, or they are given the wrong way round.
fn span(hub: &Hub, (from, to): (u64, u64)) -> Result<(u64, u64), Refusal> {
    if from > to {
        return Err(Refusal::new(Problem::P7131, format!("scan {from} comes after scan {to}")).help("`from` is the earlier one"));
    }
    let (oldest, newest) = hub.desk.past().range().ok_or_else(|| not_kept(Gone::NotKept))?;
    if from > newest.scan || to < oldest.scan {
        return Err(not_kept(Gone::NotKept));
    }
    Ok(newest_of((from, to), newest.scan))
}

/// Those of some scans that there are, and of too many the newest ones.
fn newest_of((from, to): (u64, u64), newest: u64) -> (u64, u64) {
    let to = to.min(newest);
    (from.max(to.saturating_sub(SCANS_MAX - 1)), to)
}

/// Values of the past, where they became others.
///
/// # Errors
/// None of the scans is kept.
pub(crate) fn history(hub: &Hub, viewer: &mut Viewer, asked: &History) -> Result<Json, Refusal> {
    let program = hub.program();
    let items: Vec<Option<Item>> = asked.channels.iter().map(|name| item_of(name, &program)).collect();
    let (from, to) = newest_of((asked.from, asked.to), hub.desk.past().range().map_or(0, |(_, newest)| newest.scan));
    let mut changes =
        Changes { items: &items, last: vec![None; items.len()], points: vec![Vec::new(); items.len()], seen: None, times: Vec::new() };
    let look = |seen: Seen<'_>| {
        changes.look(&seen);
        true
    };
    viewer.each(hub.desk.past(), (from, to), look).map_err(not_kept)?;
    let (first, last) = changes.seen.unwrap_or((to, to));
    let share = POINTS_MAX / asked.channels.len().max(1);
    let most = if asked.points == 0 { share } else { asked.points.min(share) };
    let points = changes
        .points
        .into_iter()
        .map(|points| -> Json { thinned(points, most).into_iter().map(|(scan, value)| json!([scan, value])).collect() });
    let channels: serde_json::Map<String, Json> = asked.channels.iter().cloned().zip(points).collect();
    let every = changes.times.len().div_ceil(TIMES_MAX).max(1);
    let end = changes.times.last().copied();
    let mut times: Vec<(u64, u64)> = changes.times.into_iter().step_by(every).collect();
    times.extend(end.filter(|end| times.last() != Some(end)));
    Ok(json!({ "t": "history", "id": asked.id, "from": first, "to": last, "times": times, "channels": channels }))
}

/// Finds the last statement of a scan that stored to a name.
struct Writer<'n> {
    name: &'n Name,
    /// What the compiler knows of the program, where that was kept.
    build: Option<&'n Build>,
    /// What stores is told before the statement has ended.
    is_pending: bool,
    place: Option<FaultPlace>,
}

impl Writer<'_> {
    /// Whether a statement would have stored something if its RLO had been 1.
    fn is_idle(&self, event: &StatementEvent) -> bool {
        let body = self.build.and_then(|build| build.compiled.bodies.get(&event.place.block));
        event.before.rlo & 1 == 0 && body.is_some_and(|body| body.stores_if_rlo().contains(&event.place.statement))
    }
}

impl Tracer for Writer<'_> {
    fn statement(&mut self, _: &Machine, event: &StatementEvent) {
        if std::mem::take(&mut self.is_pending) && !self.is_idle(event) {
            self.place = Some(event.place);
        }
    }

    fn stores(&mut self, machine: &Machine, stored: Stored) {
        self.is_pending |= self.name.is_stored(machine, &machine.registers, &stored);
    }
}

/// Who wrote a value last, up to a scan.
///
/// # Errors
/// The name means nothing, or the scan is not kept.
pub(crate) fn who(hub: &Hub, viewer: &mut Viewer, asked: &Who, language: Language) -> Result<Json, Refusal> {
    let program = hub.program();
    let facts = &program.facts;
    let name = Name::parse(&asked.name, &facts.symbols, &facts.program).map_err(|error| sieben_workspace::names::refused(&error))?;
    let (oldest, newest) = hub.desk.past().range().ok_or_else(|| not_kept(Gone::NotKept))?;
    let mut to = asked.scan.min(newest.scan);
    if to < oldest.scan {
        return Err(not_kept(Gone::NotKept));
    }
    let least = to.saturating_sub(SCANS_MAX).max(oldest.scan);
    let mut found: Option<(FaultPlace, u64)> = None;
    while found.is_none() && to >= least {
        let from = to.saturating_sub(WRITERS_STEP - 1).max(least);
        for scan in from..=to {
            let mut writer = Writer { name: &name, build: facts.build.as_deref(), is_pending: false, place: None };
            match viewer.traced(hub.desk.past(), scan, &mut writer) {
                // The oldest scans are forgotten while they are looked for.
                Ok(_) | Err(Gone::NotKept) => {}
                Err(error) => return Err(not_kept(error)),
            }
            found = writer.place.map(|place| (place, scan)).or(found);
        }
        match from.checked_sub(1) {
            Some(before) => to = before,
            None => break,
        }
    }
    let Some((place, scan)) = found else {
        let text = match language {
            Language::English => format!("No statement has written {} since scan {least}.", asked.name),
            Language::German => format!("Seit Zyklus {least} hat keine Anweisung {} geschrieben.", asked.name),
        };
        return Ok(json!({ "t": "who", "id": asked.id, "name": asked.name, "text": text }));
    };
    let line = facts.places().of(place).line.map_or(0, |(_, line)| line);
    let text = match language {
        Language::English => format!("{} was written last by {}, line {line}, in scan {scan}.", asked.name, place.block),
        Language::German => format!("{} wurde zuletzt von {}, Zeile {line}, in Zyklus {scan} geschrieben.", asked.name, place.block),
    };
    Ok(json!({
        "t": "who", "id": asked.id, "name": asked.name, "text": text, "block": word(place.block),
        "network": program.network(place), "line": line, "scan": scan,
    }))
}

/// How a trace is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Written {
    /// A table.
    Csv,
    /// A dump of signals.
    Vcd,
    /// A timing diagram.
    Svg,
}

impl Written {
    /// All of them with their words and kinds.
    pub(crate) const ALL: [(&'static str, Self, &'static str); 3] = [
        ("csv", Self::Csv, "text/csv; charset=utf-8"),
        ("vcd", Self::Vcd, "text/plain; charset=utf-8"),
        ("svg", Self::Svg, "image/svg+xml"),
    ];
}

/// Bytes that a trace takes in memory at most.
const TRACE_BYTES_MAX: usize = 16 * 1024 * 1024;

/// A trace of scans of the past, written as `sieben trace` writes it.
///
/// # Errors
/// A name means nothing, or none of the scans is kept.
pub(crate) fn trace(hub: &Hub, (from, to): (u64, u64), channels: &str, written: Written) -> Result<String, Refusal> {
    let program = hub.program();
    let facts = &program.facts;
    let names = sieben_workspace::names::split_list(channels);
    if names.is_empty() || names.len() > CHANNELS_MAX {
        return Err(Refusal::new(Problem::P7131, format!("`channels` names 1 to {CHANNELS_MAX} values, separated by commas")));
    }
    let meant = names.into_iter().map(|name| Name::parse(name, &facts.symbols, &facts.program).map(Name::readable));
    let meant = meant.collect::<Result<Vec<_>, _>>().map_err(|error| sieben_workspace::names::refused(&error))?;
    let (from, to) = span(hub, (from, to))?;
    let failed = |error: TraceError| Refusal::new(Problem::P7130, error.to_string());
    let origin = Origin { title: facts.project.clone().unwrap_or_default(), ..Origin::default() };
    let mut recorder = Recorder::new(meant, Keep::All, origin, Box::new(Memory::new(TRACE_BYTES_MAX))).map_err(failed)?;
    let (mut wrong, mut count) = (None, 0_u64);
    let look = |Seen { mark, cpu }: Seen<'_>| {
        count += 1;
        wrong = recorder.scan(cpu, mark.scan, mark.time_us).err();
        wrong.is_none()
    };
    Viewer::default().each(hub.desk.past(), (from, to), look).map_err(not_kept)?;
    if let Some(error) = wrong {
        return Err(failed(error));
    }
    if count == 0 {
        return Err(not_kept(Gone::NotKept));
    }
    let trace = recorder.finish().map_err(failed)?;
    let mut text = String::new();
    match written {
        Written::Csv => csv::write(&trace, &trace.all(), csv::Rows::All, &mut text).map_err(failed)?,
        Written::Vcd => vcd::write(&trace, &trace.all(), &mut text).map_err(failed)?,
        Written::Svg => text = svg(&trace, &Options::svg()).map_err(failed)?,
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_what_stands_out() {
        let points: Vec<(u64, f64)> = (0..10_000).map(|scan| (scan, if scan == 5_555 { 1_000.0 } else { (scan % 10) as f64 })).collect();
        let thin = thinned(points.clone(), 100);
        assert!(thin.len() <= 100 && thin.iter().any(|&(scan, value)| (scan, value) == (5_555, 1_000.0)), "{}", thin.len());
        assert!(thin.windows(2).all(|pair| pair[0].0 < pair[1].0), "in their order");
        assert_eq!((thin.first(), thin.last()), (points.first(), points.last()), "what it begins and ends with");
        assert_eq!(thinned(points[..50].to_vec(), 100), points[..50]);
        let few: Vec<u64> = thinned(points, 1).into_iter().map(|(scan, _)| scan).collect();
        assert_eq!(few, [0, 5_555, 9_999], "the first is the least one, too");
    }

    #[test]
    fn times_on_a_line_are_left_out() {
        let mut times = Vec::new();
        // The CPU stands for a second after scan 3, and each scan after scan 5 takes 20 ms.
        for scan in [(1, 0), (2, 10), (3, 20), (4, 1_030), (5, 1_040), (6, 1_060), (7, 1_080), (8, 1_100)] {
            add_time(&mut times, scan);
        }
        assert_eq!(times, [(1, 0), (3, 20), (4, 1_030), (5, 1_040), (8, 1_100)]);
    }

    #[test]
    fn a_value_is_the_number_that_it_is_in_its_format() {
        let of = |format, width, bits| number(&Value::bits(Kind::Formatted(format, Box::new(Kind::Bits(width))), bits));
        for (format, width, bits, wanted) in [
            (Format::Real, 32, u64::from(1.5_f32.to_bits()), Some(1.5)),
            (Format::Int, 16, 0xFFF9, Some(-7.0)),
            (Format::Bcd, 16, 0x0142, Some(142.0)),
            (Format::Bcd, 16, 0x00FA, None),
            (Format::S5Time, 16, 0x0250, Some(2_500.0)),
            (Format::Time, 32, 2_500, Some(2_500.0)),
            (Format::Hex, 16, 0x0142, Some(322.0)),
            (Format::Bool, 1, 1, Some(1.0)),
        ] {
            assert_eq!(of(format, width, bits), wanted, "{format:?} of {bits:X}");
        }
        assert_eq!(number(&Value::bits(Kind::TimeLeft, 0x0250)), Some(2_500.0));
    }
}
