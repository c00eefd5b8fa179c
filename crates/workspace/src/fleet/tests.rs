//! Fleets as a whole: when what is sent arrives, and that nothing else decides what comes of it.

use std::path::Path;

use proptest::prelude::*;
use sieben_engine::Interpreter;
use sieben_model::problems::Problem;
use sieben_model::source::FileId;

use super::{Failed, Fleet, Row, Summary};
use crate::campaign::Files;
use crate::project::{Overrides, Project};
use crate::refusal::Refusal;

/// Programs by their path.
struct Programs<'a>(&'a [(&'a str, &'a str)]);

impl Files for Programs<'_> {
    fn project(&self, path: &str) -> Result<Project, Refusal> {
        let (_, text) = self.0.iter().find(|(name, _)| *name == path).ok_or_else(|| Refusal::new(Problem::P7163, "no such program"))?;
        let mut project = Project::default();
        // What comes before a line of dashes is the project file.
        let (settings, source) = text.split_once("---\n").unwrap_or(("", text));
        if !settings.is_empty() {
            project.add_settings(Path::new("sieben.toml"), settings.as_bytes());
        }
        project.add_source(Path::new("main.awl"), source.as_bytes());
        Ok(project)
    }

    fn text(&self, _: &str) -> Result<String, Refusal> {
        Err(Refusal::new(Problem::P7163, "no text"))
    }
}

fn ob(number: u32, statements: &str) -> String {
    format!("ORGANIZATION_BLOCK OB {number}\nBEGIN\n{statements}\nEND_ORGANIZATION_BLOCK\n")
}

fn opened(text: &str, programs: &[(&str, &str)]) -> Result<Fleet, Vec<String>> {
    let (spec, diagnostics) = super::parse(text, FileId(0));
    let spec = spec.ok_or_else(|| diagnostics.into_iter().map(|diagnostic| diagnostic.message).collect::<Vec<_>>())?;
    super::open(spec, &Programs(programs), Overrides::default(), &|program, layout| Interpreter::load(program, layout)).map_err(|failed| {
        match failed {
            Failed::Spec(wrong) => {
                wrong.into_iter().map(|diagnostic| format!("{}: {}", diagnostic.problem.code(), diagnostic.message)).collect()
            }
            Failed::Program(build) => build.findings.iter().map(|finding| finding.diagnostic.message.clone()).collect(),
            Failed::Refused(refusal) => vec![refusal.message],
        }
    })
}

fn open(text: &str, programs: &[(&str, &str)]) -> Fleet {
    opened(text, programs).unwrap_or_else(|messages| panic!("{messages:?}\n{text}"))
}

/// Runs it with the controllers of each window in an order that `order` makes of the window.
fn run_in(fleet: &Fleet, for_us: u64, waits: bool, order: &dyn Fn(u64) -> u64) -> Summary {
    let windows = fleet.windows(for_us, waits);
    for window in (0..).map_while(|number| windows.get(number)) {
        let mut numbers: Vec<usize> = (0..fleet.len()).collect();
        numbers.sort_by_key(|&number| sieben_campaign::draws::mix(order(window.number) ^ number as u64));
        numbers.into_iter().for_each(|number| fleet.run(number, &window, &|| 0));
    }
    fleet.summary()
}

fn run(fleet: &Fleet, for_us: u64) -> Summary {
    run_in(fleet, for_us, false, &|window| window)
}

fn outputs(rows: &[Row]) -> Vec<&[u8]> {
    rows.iter().map(|row| &*row.outputs).collect()
}

/// Passes its input on and counts its scans.
fn station() -> String {
    ob(1, "L IB 0; T QB 0; L MB 0; L 1; +I; T MB 0; T QB 1;")
}

#[test]
fn what_is_sent_arrives_after_its_latency_and_not_before() {
    let text = "[fleet]\ncycle = \"10ms\"\n[[controller]]\nname = \"source\"\nprogram = \"source\"\n\
                [[controller]]\nname = \"station\"\ncount = 3\nprogram = \"station\"\n\
                [[link]]\nfrom = \"source.QB 0\"\nto = \"station[0].IB 0\"\nlatency = \"25ms\"\n\
                [[link]]\nfrom = \"station[i].QB 0\"\nto = \"station[i+1].IB 0\"\nlatency = \"10ms\"\n";
    // The scan number from 1 on.
    let source = ob(1, "L MB 0; L 1; +I; T MB 0; T QB 0;");
    let station = station();
    let programs = [("source", source.as_str()), ("station", station.as_str())];
    // What is sent by scan k arrives at 10 k + 25 ms: the scan at 10 k + 30 ms is the first with it.
    for (scans, last) in [(1, [0, 0, 0]), (3, [0, 0, 0]), (4, [1, 0, 0]), (5, [2, 1, 0]), (20, [17, 16, 15])] {
        let fleet = open(text, &programs);
        let summary = run(&fleet, scans * 10_000);
        let expected: Vec<Vec<u8>> = last.iter().map(|&value| vec![value, scans as u8]).collect();
        assert_eq!(outputs(&summary.rows)[1..], expected, "after {scans} scans");
        assert_eq!((summary.scans(), summary.rows[0].name(), summary.rows[3].name()), (4 * scans, "source".into(), "station[2]".into()));
    }
}

#[test]
fn of_messages_at_one_moment_the_one_of_the_last_sender_counts() {
    let text = "[[controller]]\nname = \"sender\"\ncount = 3\nprogram = \"sender\"\n[[controller]]\nname = \"hub\"\nprogram = \"hub\"\n\
                [[link]]\nfrom = \"sender[i].QB 0\"\nto = \"hub.IB 0\"\nlatency = \"10ms\"\n\
                [[link]]\nfrom = \"hub.QB 0\"\nto = \"sender[i].MB 0\"\nlatency = \"1ms\"\n";
    // Each sends what it was told and 1 more.
    let sender = ob(1, "L MB 0; L 1; +I; T QB 0;");
    let hub = ob(1, "L IB 0; L 10; +I; T QB 0;");
    let fleet = open(text, &[("sender", &sender), ("hub", &hub)]);
    let summary = run(&fleet, 30_000);
    // 0 ms: 1 of all, 10 of the hub; 10 ms: all were told 10, and the hub has 1; 20 ms: they were told 11.
    assert_eq!(outputs(&summary.rows), [[12], [12], [12], [21]]);
    assert_eq!(summary.rows[3].counts.received, 3 * 2);
}

#[test]
fn a_controller_in_stop_is_a_row_and_what_it_puts_out_is_0() {
    let text = "[fleet]\ncycle = \"10ms\"\n[[controller]]\nname = \"broken\"\nprogram = \"broken\"\n[[controller]]\nname = \"after\"\nprogram = \"station\"\n\
                [[link]]\nfrom = \"broken.QB 0\"\nto = \"after.IB 0\"\nlatency = \"10ms\"\n\
                [[link]]\nfrom = \"broken.MB 0\"\nto = \"after.MB 9\"\nlatency = \"10ms\"\n";
    let broken = ob(1, "L 7; T QB 0; L MB 0; L 1; +I; T MB 0; L 5; <I; JC go; CALL FC 99; go: NOP 0;");
    let broken = broken + "FUNCTION FC 99 : VOID\nBEGIN\nL P#M 65535.0; T MD 20; L MB [MD 20];\nEND_FUNCTION\n";
    let station = station();
    let programs = [("broken", broken.as_str()), ("station", station.as_str())];
    let at = |scans: u64| {
        let fleet = open(text, &programs);
        run(&fleet, scans * 10_000)
    };
    let before = at(5);
    assert_eq!(before.stopped().count(), 1, "{before:?}");
    let stop = before.rows[0].stop.clone().expect("in STOP");
    assert_eq!((stop.scan, stop.at_us), (Some(4), 40_000));
    assert!(stop.cause.expect("a cause").text.contains("FC 99"));
    assert_eq!(before.rows[1].outputs[0], 7);
    let after = at(8);
    assert_eq!(after.rows[1].outputs[..], [0, 8], "the others go on");
    assert_eq!(after.rows[0].counts.scans, 5);
}

#[test]
fn inputs_change_at_their_time_also_between_two_scans() {
    // OB 35 runs every 10 ms of a cycle of 100 ms: it sees the input 30 ms after the scan that sent it.
    let text = "[fleet]\ncycle = \"100ms\"\n[[controller]]\nname = \"a\"\nprogram = \"a\"\n[[controller]]\nname = \"b\"\nprogram = \"b\"\n\
                [[link]]\nfrom = \"a.Q 0.0\"\nto = \"b.I 0.0\"\nlatency = \"135ms\"\n";
    let a = ob(1, "SET; = Q 0.0;");
    let b = "[cyclic.35]\ninterval = \"10ms\"\n---\n".to_owned();
    let b = b + &ob(1, "NOP 0;") + &ob(35, "L PIB 0; L MB 1; +I; T MB 1; T QB 0;");
    let fleet = match opened(text, &[("a", &a), ("b", &b)]) {
        Ok(fleet) => fleet,
        Err(messages) => panic!("{messages:?}"),
    };
    let summary = run(&fleet, 201_000);
    // From 135 to 200 ms OB 35 starts at 140, 150, ... 200.
    assert_eq!(summary.rows[1].outputs[0], 7);
}

#[test]
fn plants_of_one_project_draw_from_seeds_of_their_own() {
    let text = |seed: u64| {
        format!(
            "[fleet]\nseed = {seed}\n[[controller]]\nname = \"oven\"\ncount = 3\nprogram = \"oven\"\n[[controller]]\nname = \"other\"\nprogram = \"oven\"\n"
        )
    };
    let oven = "[[module]]\nkind = \"thermal\"\nname = \"oven\"\ninput = 0\noutput = 0\nnoise = 10\n---\n".to_owned()
        + &ob(1, "L MD 0; L L#3; *D; L IW 0; +D; T MD 0; T QD 10;");
    let states = |seed| {
        let fleet = open(&text(seed), &[("oven", &oven)]);
        run(&fleet, 5_000_000)
    };
    let (one, again, other) = (states(1), states(1), states(2));
    assert_eq!(one.state_hash, again.state_hash);
    assert_ne!(one.state_hash, other.state_hash);
    let values = outputs(&one.rows);
    assert!(values.iter().enumerate().all(|(index, value)| !values[..index].contains(value)), "{values:?}");
}

#[test]
fn links_that_cannot_be_made_are_told_at_their_place() {
    let text = |from: &str, to: &str| {
        format!(
            "[[controller]]\nname = \"a\"\ncount = 2\nprogram = \"a\"\n[[controller]]\nname = \"b\"\nprogram = \"b\"\n\
             [[link]]\nfrom = '{from}'\nto = '{to}'\nlatency = \"1ms\"\n"
        )
    };
    let a =
        ob(1, "SET; = Q 0.0;") + "DATA_BLOCK DB 1\nSTRUCT\nspeed : INT;\nwide : ARRAY [1..9] OF INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";
    let told = |from: &str, to: &str| opened(&text(from, to), &[("a", &a), ("b", &a)]).err().unwrap_or_default();
    for (from, to, messages) in [
        ("a[i].QB 0", "b.IB 0", vec![]),
        ("a[i].DB1.speed", "b.DB1.speed", vec![]),
        ("a[0].PQW 300", "a[1].PIW 300", vec![]),
        ("a[i].T 1", "b.IB 0", vec!["P7172: `T 1` is no bit, byte, word or double word of inputs, outputs, bit memory or a data block"]),
        (
            "a[i].ACCU1",
            "b.ID 0",
            vec!["P7172: `ACCU1` is no bit, byte, word or double word of inputs, outputs, bit memory or a data block"],
        ),
        ("a[i].QB 0", "b.QB 0", vec!["P7172: `QB 0` is an output, which only the program of `b` sets"]),
        ("a[i].QB 0", "b.IW 0", vec!["P7172: `QB 0` has 8 bits and `IW 0` has 16 bits: both ends of a link have the same width"]),
        ("a[i].Q 0.0", "b.IB 0", vec!["P7172: `Q 0.0` has a bit and `IB 0` has 8 bits: both ends of a link have the same width"]),
        ("a[i].QB 5000", "b.IB 0", vec!["P7172: `QB 5000` lies outside what `a` has"]),
        ("a[i].QB 0", "a[i+2].IB 0", vec!["P7172: this link connects no two controllers: all its indices lie outside"]),
    ] {
        assert_eq!(told(from, to), messages, "{from} {to}");
    }
    for (from, to, part) in [
        ("a[i].nothing", "b.IB 0", "nothing"),
        ("a[i].DB9.DBB0", "b.IB 0", "DB9"),
        ("a[i].QB 0", "b.IB 5000", "outside"),
        ("a[i].DB1.wide", "b.IB 0", "wide"),
    ] {
        let told = told(from, to);
        assert!(told.len() == 1 && told[0].starts_with("P7172: ") && told[0].contains(part), "{from} {to}: {told:?}");
    }
    let thousand: String = (0..1000).map(|_| "[[link]]\nfrom = \"a[i].QB 0\"\nto = \"b.IW 0\"\nlatency = \"1ms\"\n").collect();
    let head = "[[controller]]\nname = \"a\"\ncount = 2\nprogram = \"a\"\n[[controller]]\nname = \"b\"\nprogram = \"b\"\n";
    assert_eq!(opened(&format!("{head}{thousand}"), &[("a", &a), ("b", &a)]).err().map(|told| told.len()), Some(101));
}

#[test]
fn a_controller_takes_no_more_than_32_kib_of_its_own() {
    let mut all = station() + &ob(35, "NOP 0;") + &ob(100, "CALL FC 1;") + &ob(121, "NOP 0;");
    all += "FUNCTION FC 1 : VOID\nVAR_TEMP\nbuffer : ARRAY [1..500] OF INT;\nEND_VAR\nBEGIN\nNOP 0;\nEND_FUNCTION\n";
    let fleet = open("[[controller]]\nname = \"a\"\ncount = 20\nprogram = \"a\"\n", &[("a", &all)]);
    let summary = run(&fleet, 1_000_000);
    for row in &summary.rows {
        let own = row.bytes - row.data_bytes;
        assert!(own <= 32 * 1024, "{own} bytes");
    }
    assert!(summary.bytes_per_instance() <= 100 * 1024);
}

#[test]
fn the_numbers_of_all_controllers_are_open_metrics() {
    let broken = ob(1, "L P#M 65535.0; T MD 20; L MB [MD 20];");
    let station = station();
    let text = "[[controller]]\nname = \"a\"\ncount = 2\nprogram = \"a\"\n[[controller]]\nname = \"b\"\nprogram = \"b\"\n";
    let fleet = open(text, &[("a", &station), ("b", &broken)]);
    let text = super::metrics(&run(&fleet, 30_000));
    for line in [
        "# TYPE sieben_fleet_scans counter",
        "sieben_fleet_scans_total{controller=\"a\",index=\"1\"} 3",
        "sieben_fleet_scans_total{controller=\"b\"} 1",
        "sieben_fleet_stopped{controller=\"a\",index=\"0\"} 0",
        "sieben_fleet_stopped{controller=\"b\"} 1",
        "sieben_fleet_messages_sent_total{controller=\"b\"} 0",
    ] {
        assert!(text.lines().any(|written| written == line), "{line}\n{text}");
    }
    assert!(text.lines().any(|line| line.starts_with("sieben_fleet_stop_info{controller=\"b\",event=\"16#")), "{text}");
    assert!(text.ends_with("# EOF\n"));
}

/// A link between two groups, by numbers.
fn links() -> impl Strategy<Value = Vec<(usize, i64, u8, usize, i64, u8, u64)>> {
    let link = (0..2_usize, -2..3_i64, 0..3_u8, 0..2_usize, -2..3_i64, 0..4_u8, 1000..60_000_u64);
    proptest::collection::vec(link, 0..5)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    /// The order of controllers, and how long windows are as long as they are not too long, decide nothing.
    #[test]
    fn nothing_but_the_file_decides_what_comes_of_it(
        counts in (1..5_u32, 1..4_u32),
        cycle_us in 1000..30_000_u64,
        links in links(),
        scans in 1..40_u64,
        orders in any::<(u64, u64)>(),
    ) {
        let mut text = format!("[fleet]\ncycle = \"{cycle_us}us\"\n");
        for (name, count) in [("a", counts.0), ("b", counts.1)] {
            text += &format!("[[controller]]\nname = \"{name}\"\ncount = {count}\nprogram = \"{name}\"\n");
        }
        for (from, from_add, source, to, to_add, target, latency) in links {
            let index = |add: i64| match add {
                0 => "i".to_owned(),
                add => format!("i{add:+}"),
            };
            let (from, to) = (["a", "b"][from], ["a", "b"][to]);
            let (source, target) = (["QB 0", "MB 2", "IB 1"][usize::from(source)], ["IB 0", "IB 1", "MB 3", "PIB 300"][usize::from(target)]);
            text += &format!(
                "[[link]]\nfrom = \"{from}[{}].{source}\"\nto = \"{to}[{}].{target}\"\nlatency = \"{latency}us\"\n",
                index(from_add), index(to_add)
            );
        }
        let a = ob(1, "L IB 0; L IB 1; +I; L MB 2; +I; INC 1; T MB 2; T QB 0; L MB 3; T QB 1;") + &ob(35, "L PIB 300; L MB 4; +I; T MB 4;");
        let b = ob(1, "L IB 0; L 3; *I; L MB 3; XOW; INC 1; T QB 0; L T 1; T MB 2; AN M 5.0; L S5T#30MS; SD T 1; A T 1; = M 5.0;");
        let programs = [("a", a.as_str()), ("b", b.as_str())];
        let Ok(fleet) = opened(&text, &programs) else { return Ok(()) };
        let one = run_in(&fleet, scans * cycle_us, false, &|_| orders.0);
        let fleet = open(&text, &programs);
        let other = run_in(&fleet, scans * cycle_us, true, &|window| orders.1 ^ window);
        prop_assert_eq!(one.state_hash, other.state_hash);
        prop_assert_eq!(one.messages(), other.messages());
        prop_assert_eq!(outputs(&one.rows), outputs(&other.rows));
    }
}
