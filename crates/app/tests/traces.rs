//! Traces: what is recorded is what the CPU had, and diagrams, dumps and tables say the same.

use std::sync::Arc;

use proptest::prelude::*;
use sieben_cpu::{Cpu, Rack, Restart, Settings};
use sieben_engine::Interpreter;
use sieben_lang::Options;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::{Name, Sample};
use sieben_sim::timing_diagram::{self, Options as Drawn};
use sieben_sim::trace::{Keep, Memory, Origin, Recorder, Store, StoreError, Trace, TraceError, Trigger, csv, vcd};

/// A CPU in RUN with a program.
fn cpu(program: &str) -> Cpu {
    let mut sources = Sources::default();
    sources.add("main.awl", program);
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &Options::default());
    assert!(compiled.diagnostics.iter().all(|found| found.severity() != Severity::Error), "{:?}", compiled.diagnostics);
    let cpu_type = &CpuType::ALL[0];
    let mut cpu = Cpu::load(cpu_type, Arc::new(compiled.program), Interpreter::load, Rack::simulated(cpu_type), Settings::default());
    cpu.restart(Restart::Warm);
    cpu
}

fn names(cpu: &Cpu, names: &[&str]) -> Vec<Name> {
    names.iter().map(|name| Name::parse(name, &SymbolTable::default(), cpu.program()).expect("a name")).collect()
}

fn set(cpu: &mut Cpu, name: &str, value: &str) {
    names(cpu, &[name])[0].write(cpu, value).expect("the name can be set");
}

fn trigger(cpu: &Cpu, text: &str) -> Trigger {
    Trigger::parse(text, &SymbolTable::default(), cpu.program()).expect("a trigger")
}

/// A store whose bytes can be seen from outside.
#[derive(Clone, Default)]
struct Shared(Arc<std::sync::Mutex<Vec<u8>>>);

impl Store for Shared {
    fn append(&mut self, bytes: &[u8]) -> Result<(), StoreError> {
        self.0.lock().expect("one thread").extend_from_slice(bytes);
        Ok(())
    }
    fn read(&self, offset: u64, into: &mut [u8]) -> Result<usize, StoreError> {
        Memory::of(self.0.lock().expect("one thread").clone()).read(offset, into)
    }
    fn size(&self) -> Result<u64, StoreError> {
        Ok(self.0.lock().expect("one thread").len() as u64)
    }
}

/// All values of a trace, scan by scan: number, time, values as they are shown.
fn rows(trace: &Trace) -> Vec<(u64, u64, Vec<String>)> {
    let mut rows = Vec::new();
    trace
        .visit(&trace.all(), &mut |scans| {
            let values: Vec<String> =
                trace.channels().iter().zip(scans.values).map(|(channel, value)| value.display(&channel.kind).to_string()).collect();
            rows.extend(scans.moments().map(|moment| (moment.scan, moment.time_us, values.clone())));
            Ok(())
        })
        .expect("the trace can be read");
    rows
}

/// One scan of a random run: what is set, and how long after the scan before it comes.
#[derive(Clone, Debug)]
struct Moved {
    bit: bool,
    byte: u8,
    real: f32,
    step_us: u64,
}

fn moved() -> impl Strategy<Value = Moved> {
    let step = prop_oneof![8 => Just(10_000_u64), 1 => 0..50_000_u64, 1 => Just(1_000_000)];
    let real = prop_oneof![3 => Just(1.5_f32), 2 => any::<f32>(), 1 => Just(f32::NAN)];
    (any::<bool>(), prop_oneof![5 => Just(7_u8), 1 => any::<u8>()], real, step).prop_map(|(bit, byte, real, step_us)| Moved {
        bit,
        byte,
        real,
        step_us,
    })
}

const CHANNELS: [&str; 6] = ["I 0.0", "IB 1", "MD 4", "DB1.r", "T 1", "C 1"];
const PROGRAM: &str = "DATA_BLOCK DB 1\nSTRUCT\n r : REAL ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n\
    ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 0.0\n L S5T#100MS\n SE T 1\n A I 0.0\n CU C 1\n L IB 1\n T MD 4\nEND_ORGANIZATION_BLOCK\n";

/// Records a random run, and what a plain look at the CPU saw in it.
fn record(run: &[Moved], keep: Keep, store: Box<dyn Store>) -> (Trace, Vec<(u64, u64, Vec<String>)>) {
    let mut cpu = cpu(PROGRAM);
    let channels = names(&cpu, &CHANNELS);
    let mut recorder = Recorder::new(channels.clone(), keep, Origin::default(), store).expect("memory has room");
    let (mut now_us, mut seen) = (0, Vec::new());
    for (scan, moved) in (0..).zip(run) {
        set(&mut cpu, "I 0.0", if moved.bit { "1" } else { "0" });
        set(&mut cpu, "IB 1", &moved.byte.to_string());
        set(&mut cpu, "DB1.DBD 0", &format!("DW#16#{:08X}", moved.real.to_bits()));
        cpu.scan(now_us);
        recorder.scan(&cpu, scan, now_us).expect("memory has room");
        seen.push((scan, now_us, channels.iter().map(|name| name.read(&cpu).expect("a value").to_string()).collect()));
        now_us += moved.step_us;
    }
    (recorder.finish().expect("memory has room"), seen)
}

/// Values of a dump by name at each of its times; a small reader that knows nothing of the writer.
fn read_vcd(dump: &str) -> Vec<(u64, Vec<(String, String)>)> {
    let mut ids: Vec<(String, String, String)> = Vec::new();
    let (mut now, mut out, mut values) = (None, Vec::new(), std::collections::BTreeMap::new());
    let mut body = false;
    for line in dump.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            ["$var", kind, width, id, name, "$end"] => {
                assert!(width.parse::<u32>().is_ok() && matches!(*kind, "wire" | "integer" | "real" | "string"), "{line}");
                assert!(!ids.iter().any(|(known, _, other)| known == id || other == name), "{line}");
                ids.push(((*id).to_owned(), (*kind).to_owned(), (*name).to_owned()));
            }
            ["$enddefinitions", "$end"] => body = true,
            _ if !body => assert!(line.starts_with('$'), "{line}"),
            ["$dumpvars"] | ["$end"] => {}
            [time] if time.starts_with('#') => {
                let next = time[1..].parse::<u64>().expect("a time");
                if let Some(now) = now {
                    assert!(next >= now, "time runs backwards at {line}");
                    out.push((now, values.clone().into_iter().collect()));
                }
                now = Some(next);
            }
            [bit] => {
                let (value, id) = bit.split_at(1);
                let known = ids.iter().find(|(known, kind, _)| known == id && kind == "wire").expect("a declared bit");
                assert!(matches!(value, "0" | "1" | "x"), "{line}");
                values.insert(known.2.clone(), value.to_owned());
            }
            [value, id] => {
                let known = ids.iter().find(|(known, ..)| known == id).expect("a declared vector");
                let fits = match known.1.as_str() {
                    "real" => value.starts_with('r'),
                    "string" => value.starts_with('s'),
                    _ => value.starts_with('b') && value[1..].chars().all(|c| matches!(c, '0' | '1' | 'x')),
                };
                assert!(fits, "{line}");
                values.insert(known.2.clone(), value[1..].to_owned());
            }
            _ => panic!("{line}"),
        }
    }
    if let Some(now) = now {
        out.push((now, values.into_iter().collect()));
    }
    out
}

/// Fields of a table, as RFC 4180 has them.
fn read_csv(table: &str) -> Vec<Vec<String>> {
    let mut rows = vec![vec![String::new()]];
    let mut quoted = false;
    let mut rest = table.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            '"' if quoted && rest.peek() == Some(&'"') => {
                rest.next();
                rows.last_mut().expect("a row").last_mut().expect("a field").push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => rows.last_mut().expect("a row").push(String::new()),
            '\r' if !quoted => assert_eq!(rest.next(), Some('\n')),
            c => {
                assert!(quoted || c != '\n');
                rows.last_mut().expect("a row").last_mut().expect("a field").push(c);
            }
        }
        if c == '\r' && !quoted {
            rows.push(vec![String::new()]);
        }
    }
    rows.pop();
    rows
}

/// A dumped value in the notation of the table.
fn as_shown(index: usize, dumped: &str) -> String {
    match index {
        0 => dumped.to_owned(),
        1 => format!("16#{:02X}", u8::from_str_radix(dumped, 2).expect("eight bits")),
        2 => {
            let bits = u32::from_str_radix(dumped, 2).expect("32 bits");
            format!("16#{:04X}_{:04X}", bits >> 16, bits & 0xFFFF)
        }
        _ => u32::from_str_radix(dumped, 2).expect("a number").to_string(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_trace_holds_what_the_cpu_had_and_survives_its_bytes(run in prop::collection::vec(moved(), 1..120)) {
        let store = Shared::default();
        let (trace, seen) = record(&run, Keep::All, Box::new(store.clone()));
        prop_assert_eq!(rows(&trace), seen.clone());
        prop_assert_eq!(trace.summary().scans, run.len() as u64);
        let again = Trace::open(Box::new(store)).expect("a recording");
        prop_assert_eq!(rows(&again), seen);
        prop_assert_eq!(again.summary(), trace.summary());
        prop_assert!(again.is_whole());
    }

    #[test]
    fn a_part_of_a_trace_is_that_part(run in prop::collection::vec(moved(), 1..80), from in 0..80_u64, length in 0..40_u64) {
        let (trace, seen) = record(&run, Keep::All, Box::new(Memory::default()));
        let mut part = Vec::new();
        trace.visit(&(from..=from + length), &mut |scans| {
            part.extend(scans.moments().map(|moment| (moment.scan, moment.time_us)));
            Ok(())
        }).expect("the trace can be read");
        let expected: Vec<(u64, u64)> =
            seen.iter().filter(|row| (from..=from + length).contains(&row.0)).map(|row| (row.0, row.1)).collect();
        prop_assert_eq!(part, expected);
    }

    #[test]
    fn the_ring_keeps_the_last_scans(run in prop::collection::vec(moved(), 1..60), last in 1..70_u64) {
        let (trace, seen) = record(&run, Keep::Last(last), Box::new(Memory::default()));
        let skipped = seen.len().saturating_sub(last as usize);
        prop_assert_eq!(rows(&trace), seen[skipped..].to_vec());
    }

    #[test]
    fn dump_and_table_agree_with_the_trace(run in prop::collection::vec(moved(), 1..80)) {
        let (trace, seen) = record(&run, Keep::All, Box::new(Memory::default()));
        let (mut dump, mut table) = (String::new(), String::new());
        vcd::write(&trace, &trace.all(), &mut dump).expect("text takes all");
        csv::write(&trace, &trace.all(), csv::Rows::All, &mut table).expect("text takes all");
        let table = read_csv(&table);
        let head = [&["time_ms", "scan"], &CHANNELS[..]].concat();
        prop_assert_eq!(&table[0], &head);
        prop_assert_eq!(table.len() - 1, seen.len());
        let dump = read_vcd(&dump);
        for (row, (scan, time_us, values)) in table[1..].iter().zip(&seen) {
            prop_assert_eq!(&row[1], &scan.to_string());
            prop_assert!((row[0].parse::<f64>().expect("a time") * 1000.0 - *time_us as f64).abs() < 0.5);
            prop_assert_eq!(&row[2..], values.as_slice());
            let at = if trace.summary().stood_still { *scan } else { *time_us };
            let now = dump.iter().rev().find(|(time, _)| *time <= at).expect("the dump begins with the trace");
            for (index, channel) in CHANNELS.iter().enumerate().filter(|&(index, _)| index != 3) {
                let dumped = &now.1.iter().find(|(name, _)| *name == channel.replace(' ', "_")).expect("a channel").1;
                prop_assert_eq!(&as_shown(index, dumped), &values[index], "{} in scan {}", channel, scan);
            }
        }
    }

    #[test]
    fn every_step_of_an_svg_is_a_recorded_value(run in prop::collection::vec(moved(), 1..60)) {
        let (trace, seen) = record(&run, Keep::All, Box::new(Memory::default()));
        let svg = timing_diagram::svg(&trace, &Drawn::svg()).expect("the trace can be read");
        for (index, channel) in CHANNELS.iter().enumerate() {
            let begin = format!("<title>{channel} = ");
            let drawn: Vec<&str> = svg.split(&begin).skip(1).filter_map(|rest| rest.split_once(", ").map(|(value, _)| value)).collect();
            // A diagram writes `1.5` where the table has `1.5e+000`: the same number.
            let number = |label: &str| match label.parse::<f32>() {
                Ok(number) if channel.ends_with(".r") && number.is_finite() => format!("{number:?}"),
                _ => label.to_owned(),
            };
            let mut drawn: Vec<String> = drawn.into_iter().map(number).collect();
            let mut expected: Vec<String> = seen.iter().map(|row| number(&row.2[index])).collect();
            // A REAL can change without looking different.
            expected.dedup();
            drawn.dedup();
            prop_assert_eq!(drawn, expected, "{}", channel);
        }
    }

    #[test]
    fn every_column_of_a_text_is_a_recorded_value(run in prop::collection::vec(any::<bool>(), 2..40)) {
        let moved: Vec<Moved> = run.iter().map(|&bit| Moved { bit, byte: 0, real: 0.0, step_us: 10_000 }).collect();
        let (trace, _) = record(&moved, Keep::All, Box::new(Memory::default()));
        let text = timing_diagram::text(&trace, &Drawn { width: 120, ..Drawn::text() }).expect("the trace can be read");
        let lines: Vec<&str> = text.lines().collect();
        let at = lines.iter().position(|line| line.starts_with("I 0.0")).expect("the lane of the bit");
        let legend = lines.iter().find(|line| line.contains("10 ms (1 scan)")).expect("a legend");
        let columns: usize = legend.split(' ').next().expect("a number").parse().expect("a number");
        let gutter = lines.iter().find(|line| line.contains('┬')).and_then(|line| line.chars().position(|c| c != ' ')).expect("an axis");
        let column = |line: &str, index: usize| line.chars().nth(gutter + index).unwrap_or(' ');
        for (scan, &bit) in run.iter().enumerate() {
            // The last column of a scan has no edge; where a scan has only one column, the edge says where it leads.
            let index = (scan + 1) * columns - 1;
            let (top, bottom) = (column(lines[at - 1], index), column(lines[at], index));
            let high = matches!((top, bottom), ('─', ' ') | ('┌', '┘'));
            let low = matches!((top, bottom), (' ', '─') | ('┐', '└'));
            prop_assert_eq!((high, low), (bit, !bit), "scan {} in\n{}", scan, text);
        }
    }

    #[test]
    fn bytes_that_are_no_recording_are_told(mut bytes in prop::collection::vec(any::<u8>(), 0..400), keep_line in any::<bool>()) {
        if keep_line {
            let mut line = b"sieben trace 1\n".to_vec();
            line.append(&mut bytes);
            bytes = line;
        }
        prop_assert!(Trace::open(Box::new(Memory::of(bytes))).is_err());
    }
}

#[test]
fn a_recording_that_was_cut_anywhere_has_its_whole_blocks() {
    let run: Vec<Moved> =
        (0..8_000_u64).map(|scan| Moved { bit: scan % 3 == 0, byte: scan as u8, real: scan as f32, step_us: 10_000 }).collect();
    let store = Shared::default();
    let (whole, seen) = record(&run, Keep::All, Box::new(store.clone()));
    let bytes = store.0.lock().expect("one thread").clone();
    let mut most = 0;
    for end in (0..bytes.len()).step_by(bytes.len() / 30).chain([bytes.len() - 1]) {
        match Trace::open(Box::new(Memory::of(bytes[..end].to_vec()))) {
            Ok(trace) => {
                assert!(!trace.is_whole(), "cut at {end} of {}", bytes.len());
                let rows = rows(&trace);
                assert_eq!(rows, seen[..rows.len()]);
                most = most.max(rows.len());
            }
            Err(error) => assert!(matches!(error, TraceError::Damaged(_)) && end < 200, "cut at {end}: {error}"),
        }
    }
    assert!(most > 4_000 && whole.is_whole(), "{most}");
    let mut damaged = bytes.clone();
    let middle = damaged.len() / 2;
    damaged[middle] ^= 0x10;
    let error = Trace::open(Box::new(Memory::of(damaged))).expect_err("a damaged recording");
    assert!(error.to_string().contains("checksum"), "{error}");
}

#[test]
fn a_trigger_keeps_what_is_around_it() {
    let bit = |scan: u64| (5..9).contains(&scan) || scan >= 20;
    let run: Vec<Moved> = (0..40).map(|scan| Moved { bit: bit(scan), byte: scan as u8, real: 0.0, step_us: 10_000 }).collect();
    let cpu = cpu(PROGRAM);
    for (text, comes) in [
        ("I 0.0 rises", Some(5)),
        ("I0.0 falls", Some(9)),
        ("I 0.0 CHANGES", Some(5)),
        ("IB 1 > 10", Some(11)),
        ("IB1>=10", Some(10)),
        ("IB 1 = 12", Some(12)),
        ("IB 1 <> 0", Some(1)),
        ("IB 1 < 5", Some(0)),
        ("MD 4 <= L#3", Some(0)),
        ("C 1 = 2", Some(20)),
        ("scan 33", Some(33)),
        ("IB 1 > 100", None),
    ] {
        let (trace, seen) = record(&run, Keep::Around(trigger(&cpu, text), 3, 4), Box::new(Memory::default()));
        assert_eq!(trace.trigger().map(|moment| moment.scan), comes, "{text}");
        let expected = match comes {
            Some(comes) => comes.saturating_sub(3)..=comes + 4,
            None => 36..=39,
        };
        assert_eq!(rows(&trace), seen[*expected.start() as usize..=*expected.end() as usize], "{text}");
    }
    for (text, part) in [
        ("I 0.0", "no trigger"),
        ("I 0.0 jumps", "no trigger"),
        ("IB 1 rises", "no bit"),
        ("IB 1 >", "no trigger"),
        ("scan many", "no trigger"),
        ("IB 1 > 999", "does not fit"),
        ("nothing rises", "nothing is called"),
        ("", "no trigger"),
    ] {
        let error = Trigger::parse(text, &SymbolTable::default(), cpu.program()).expect_err(text);
        assert!(format!("{error:?}").contains(part), "{text}: {error:?}");
    }
}

#[test]
fn a_full_store_is_told_and_keeps_what_was_written() {
    let store = Memory::new(100_000);
    let mut cpu = cpu(PROGRAM);
    let channels = names(&cpu, &CHANNELS);
    let mut recorder = Recorder::new(channels, Keep::All, Origin::default(), Box::new(store)).expect("room for the head");
    let failed = (0..1_000_000_u64).find_map(|scan| {
        set(&mut cpu, "IB 1", &(scan as u8).to_string());
        cpu.scan(scan * 1000);
        recorder.scan(&cpu, scan, scan * 1000).err()
    });
    assert!(matches!(&failed, Some(TraceError::Store(error)) if error.to_string().contains("100000 bytes")), "{failed:?}");
}

#[test]
fn time_that_stands_still_is_drawn_by_scans() {
    let run: Vec<Moved> = (0..4).map(|scan| Moved { bit: scan % 2 == 1, byte: 0, real: 0.0, step_us: 0 }).collect();
    let (trace, _) = record(&run, Keep::All, Box::new(Memory::default()));
    let text = timing_diagram::text(&trace, &Drawn::text()).expect("the trace can be read");
    assert!(text.contains("\nscan") && text.contains("8 columns = 1 scan\n"), "{text}");
    let mut dump = String::new();
    vcd::write(&trace, &trace.all(), &mut dump).expect("text takes all");
    assert!(dump.contains("one unit is one scan") && dump.contains("\n#3\n"), "{dump}");
}

#[test]
fn what_changes_too_often_for_a_column_is_marked() {
    let run: Vec<Moved> = (0..5000).map(|scan| Moved { bit: scan % 2 == 1 && scan < 4500, byte: 0, real: 0.0, step_us: 10_000 }).collect();
    let (trace, _) = record(&run, Keep::All, Box::new(Memory::default()));
    let drawn = Drawn { ascii: true, ..Drawn::text() };
    let text = timing_diagram::text(&trace, &drawn).expect("the trace can be read");
    assert!(text.is_ascii(), "{text}");
    assert!(text.contains("#########+---") && text.contains("# several changes"), "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    let svg = timing_diagram::svg(&trace, &Drawn::svg()).expect("the trace can be read");
    assert!(svg.contains("class=\"crowd\"") && svg.contains("4500 changes"), "{svg}");
    assert!(svg.len() < 400_000, "{}", svg.len());
}

#[test]
fn a_value_that_is_not_there_is_no_zero() {
    let cpu = cpu(PROGRAM);
    let kind = &names(&cpu, &["DB1.r"])[0].recorded();
    assert_eq!(Sample::Absent.display(kind).to_string(), "-");
    assert_eq!(Sample::Absent.number(kind), None);
}
