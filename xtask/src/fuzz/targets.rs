//! The fuzz targets: one row each.

use std::sync::{Arc, OnceLock};

use sieben_cpu::retain::{Adoption, Numbers};
use sieben_cpu::{Cpu, Rack, Restart, RetainImage, RetentiveAreas, Settings};
use sieben_engine::machine::Registers;
use sieben_engine::{Interpreter, Machine, Program, StatementEvent};
use sieben_lang::Options;
use sieben_lang::encoding::{self, Encoding};
use sieben_lang::stl::instructions::Instruction;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::literal;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;
use sieben_sim::history::{History, Plan, Until, Watch};
use sieben_sim::scenario::Scenario;
use sieben_sim::timing_diagram::{self, Options as Drawn};
use sieben_sim::trace::{Memory, Trace, csv, vcd};
use sieben_workspace::{Pace, Plant, Speed, settings};

/// Something that must survive any input.
pub struct Target {
    /// The name on the command line.
    pub name: &'static str,
    /// Runs it on one input.
    pub fuzz: fn(&[u8]),
    /// The folder of its first inputs, in `fuzz-corpus/`.
    pub corpus: &'static str,
    /// Fences of the pages in `spec/` that are first inputs too.
    pub fences: &'static [&'static str],
    /// Words that its inputs are made of.
    pub words: fn() -> Vec<&'static str>,
}

/// All targets.
#[rustfmt::skip] // A table.
pub const TARGETS: &[Target] = &[
    Target { name: "lang-compile", fuzz: sieben_lang::project::fuzz, corpus: "stl", fences: &["stl"], words: stl_words },
    Target { name: "lang-database", fuzz: sieben_lang::database::fuzz, corpus: "stl", fences: &["stl", "st"], words: stl_words },
    Target { name: "cpu-run", fuzz: run, corpus: "stl", fences: &["stl"], words: stl_words },
    Target { name: "engines", fuzz: super::engines::fuzz, corpus: "engines", fences: &["stl"], words: stl_words },
    Target { name: "trees", fuzz: super::trees::fuzz, corpus: "engines", fences: &[], words: no_words },
    Target { name: "comm-wire", fuzz: sieben_comm::s7comm::fuzz::wire, corpus: "comm-wire", fences: &[], words: no_words },
    Target { name: "comm-session", fuzz: s7_session, corpus: "comm-session", fences: &[], words: no_words },
    Target { name: "cpu-retain", fuzz: retain, corpus: "retain", fences: &[], words: no_words },
    Target { name: "cpu-system", fuzz: sieben_cpu::system::fuzz, corpus: "system", fences: &[], words: no_words },
    Target { name: "lang-awlsim-project", fuzz: sieben_lang::awlsim_project::fuzz, corpus: "awlpro", fences: &[], words: project_words },
    Target { name: "lang-codesys-files", fuzz: sieben_lang::codesys_files::fuzz, corpus: "codesys", fences: &[], words: twincat_words },
    Target { name: "lang-diagram-lines", fuzz: sieben_lang::network::fuzz::lines, corpus: "diagrams", fences: &[], words: diagram_words },
    Target { name: "lang-diagram-statements", fuzz: sieben_lang::network::fuzz::statements, corpus: "diagrams", fences: &[], words: no_words },
    Target { name: "lang-encoding", fuzz: encoding, corpus: "encoding", fences: &[], words: no_words },
    Target { name: "lang-st", fuzz: sieben_lang::st::fuzz, corpus: "st", fences: &["st"], words: st_words },
    Target { name: "lang-stl", fuzz: sieben_lang::stl::fuzz, corpus: "stl", fences: &["stl"], words: stl_words },
    Target { name: "lang-diagrams", fuzz: sieben_lang::stl::fuzz_diagrams, corpus: "diagrams", fences: &["lad", "fbd"], words: diagram_words },
    Target { name: "cpu-diagrams", fuzz: run_diagrams, corpus: "diagrams", fences: &["lad", "fbd"], words: diagram_words },
    Target { name: "lang-symbols", fuzz: sieben_lang::symbols::fuzz, corpus: "symbols", fences: &[], words: symbol_words },
    Target { name: "sim-history", fuzz: history, corpus: "engines", fences: &["stl"], words: stl_words },
    Target { name: "sim-scenario", fuzz: scenario, corpus: "scenario", fences: &["check"], words: scenario_words },
    Target { name: "sim-recording", fuzz: recording, corpus: "recording", fences: &[], words: no_words },
    Target { name: "campaign-file", fuzz: sieben_campaign::fuzz::fuzz, corpus: "campaign", fences: &[], words: campaign_words },
    Target { name: "fleet-file", fuzz: sieben_workspace::fleet::fuzz::fuzz, corpus: "fleet", fences: &[], words: fleet_words },
    Target { name: "farm-messages", fuzz: sieben_farm::fuzz::fuzz, corpus: "farm", fences: &[], words: farm_words },
    Target { name: "workspace-settings", fuzz: settings, corpus: "settings", fences: &[], words: settings_words },
    Target { name: "workspace-control", fuzz: sieben_workspace::control::fuzz, corpus: "control", fences: &[], words: control_words },
    Target { name: "page-messages", fuzz: sieben_workbench::live::fuzz::fuzz, corpus: "page", fences: &[], words: page_words },
    Target { name: "ide-editing", fuzz: sieben_ide::editing::fuzz::fuzz, corpus: "stl", fences: &["stl", "st", "lad", "fbd"], words: stl_words },
    Target { name: "model-literal", fuzz: literal, corpus: "literal", fences: &[], words: literal_words },
];

/// Safe points that a fuzzed program may pass in one scan: enough to leave every loop of the corpus, few enough for thousands of runs a second.
const SAFE_POINTS_MAX: i64 = 10_000;

fn compiled(name: &str, data: &[u8]) -> sieben_lang::Compiled {
    let mut sources = Sources::default();
    sources.add(name, String::from_utf8_lossy(data));
    sieben_lang::compile(&sources, &SymbolTable::default(), &Options { extended: true, ..Options::default() })
}

/// Compiles the input and, if it has no errors, runs three scans of it.
fn run(data: &[u8]) {
    run_source("fuzz.awl", data);
}

/// The same for a source of diagrams.
fn run_diagrams(data: &[u8]) {
    run_source(if data.len().is_multiple_of(2) { "fuzz.lad" } else { "fuzz.fbd" }, data);
}

fn run_source(name: &str, data: &[u8]) {
    let compiled = compiled(name, data);
    if compiled.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error) {
        return;
    }
    let cpu_type = &CpuType::ALL[data.len() % CpuType::ALL.len()];
    let program = Arc::new(compiled.program);
    let settings = Settings { virtual_safe_points: SAFE_POINTS_MAX, ..Settings::default() };
    let mut cpu = Cpu::load(cpu_type, program, Interpreter::load, Rack::simulated(cpu_type), settings);
    cpu.restart(Restart::Warm);
    for scan in 0..3 {
        cpu.scan(scan * 10_000);
    }
}

/// Runs a program with a history, and goes back and on again: every moment is the one that the run had.
fn history(data: &[u8]) {
    /// Looks at every so many-th moment.
    const EVERY: u64 = 97;
    #[derive(Default)]
    struct Seen {
        executed: u64,
        registers: Vec<(u64, Registers)>,
    }
    impl Watch for Seen {
        fn after(&mut self, _machine: &Machine, event: &StatementEvent) -> bool {
            self.executed += 1;
            if self.executed % EVERY == 1 {
                self.registers.push((self.executed, event.after.clone()));
            }
            false
        }
    }
    let compiled = compiled("fuzz.awl", data);
    if compiled.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error) {
        return;
    }
    let cpu_type = &CpuType::ALL[data.len() % CpuType::ALL.len()];
    let settings = Settings { virtual_safe_points: 300, ..Settings::default() };
    let cpu = Cpu::load(cpu_type, Arc::new(compiled.program), Interpreter::load, Rack::simulated(cpu_type), settings);
    let mut history = History::new(cpu, Plan::new(70_000, Some(3), Vec::new()));
    let mut seen = Seen::default();
    history.run(Until { statements: 20_000, scans: u64::MAX }, &mut seen);
    let (end, last) = (history.position(), history.cpu().machine().clone());
    let leaps = seen.registers.iter().rev().step_by(3).chain(seen.registers.iter().skip(1).step_by(4)).take(12);
    for (at, registers) in leaps {
        history.go_to(*at);
        let found = history.last().map(|event| &event.after);
        assert_eq!(found, Some(registers), "after statement {at}");
    }
    history.go_to_position(end);
    assert!(*history.cpu().machine() == last, "the end of the run is what it was");
}

/// Reads the input as a `sieben.toml`: each place that is named lies in it, and the modules that it describes are plugged in or refused.
fn settings(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let (settings, diagnostics) = settings::parse(&text, FileId(0));
    for diagnostic in &diagnostics {
        assert!(diagnostic.span.end as usize <= text.len(), "the place lies in the file");
    }
    let cpu_type = &CpuType::ALL[data.len() % CpuType::ALL.len()];
    let _ = (settings::modules::problems(&settings.modules, cpu_type), settings.retain.beyond(cpu_type));
}

/// Takes the input back as retentive data, with and without judging the program, and goes on with what came of it.
fn retain(data: &[u8]) {
    const PROGRAM: &str = "DATA_BLOCK DB 1\nSTRUCT\n n : DINT ;\n m : DINT ;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
        ORGANIZATION_BLOCK OB 1\nBEGIN\nAN T 2; L S5T#1S; SD T 2; A T 2; CU C 0; L DB1.DBD 0; +1; T DB1.DBD 0;\nEND_ORGANIZATION_BLOCK\n";
    static COMPILED: OnceLock<Arc<Program>> = OnceLock::new();
    sieben_cpu::retain::fuzz(data);
    let program = COMPILED.get_or_init(|| Arc::new(compiled("fuzz.awl", PROGRAM.as_bytes()).program));
    let cpu_type = &CpuType::ALL[0];
    let retain = RetentiveAreas { timers: Numbers::range(0..=7), ..RetentiveAreas::default() };
    let settings = Settings { retain, ..Settings::default() };
    let mut cpu = Cpu::load(cpu_type, Arc::clone(program), Interpreter::load, Rack::simulated(cpu_type), settings);
    let image = RetainImage { bytes: data.to_vec(), ..RetainImage::default() };
    for adoption in [Adoption::SameProgram, Adoption::WhatFits] {
        // What is refused changes nothing.
        let _ = cpu.restore(&image, adoption);
        cpu.restart(Restart::Warm);
        cpu.scan(10_000);
        assert!(cpu.retain_image().is_none_or(RetainImage::is_sound), "what is handed out can be taken back");
    }
}

/// Gives the input to a session of an S7 client before a CPU with a few data blocks.
fn s7_session(data: &[u8]) {
    const PROGRAM: &str = "DATA_BLOCK DB 1\nSTRUCT\n b : ARRAY [0..299] OF BYTE ;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
        DATA_BLOCK DB 2\nREAD_ONLY\nSTRUCT\n n : DINT ;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
        ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 0; T DB1.DBW 0;\nEND_ORGANIZATION_BLOCK\n";
    static COMPILED: OnceLock<Arc<Program>> = OnceLock::new();
    let program = COMPILED.get_or_init(|| Arc::new(compiled("fuzz.awl", PROGRAM.as_bytes()).program));
    let cpu_type = &CpuType::ALL[data.len() % CpuType::ALL.len()];
    let mut cpu = Cpu::load(cpu_type, Arc::clone(program), Interpreter::load, Rack::simulated(cpu_type), Settings::default());
    cpu.restart(Restart::Warm);
    cpu.scan(0);
    let mut plant = Plant::new(cpu, Pace::new(Speed::Max, 10_000, u64::MAX, 0));
    sieben_comm::s7comm::fuzz::session(&mut plant, data);
}

/// Decodes the input; what was decoded without errors comes out again when it is encoded.
fn encoding(data: &[u8]) {
    // What is refused has no text.
    let _ = encoding::read_source(data);
    for encoding in Encoding::ALL {
        let decoded = encoding::decode_as(data, encoding);
        if !decoded.had_errors {
            let encoded = encoding::encode(&decoded.text, encoding).expect("what was decoded can be encoded");
            let again = encoding::decode_as(&encoded, encoding);
            assert_eq!(again.text, decoded.text, "{} gives the same text twice", encoding.name());
        }
    }
}

/// Reads the input as a constant; what is understood is spelled so that it is understood again.
fn literal(data: &[u8]) {
    for line in String::from_utf8_lossy(data).lines() {
        if let Ok(value) = literal::parse(line) {
            let spelled = value.spell();
            let again = literal::parse(&spelled).map(|again| again.spell());
            assert_eq!(again.as_deref().ok(), Some(spelled.as_str()), "`{line}` is spelled `{spelled}`");
        }
    }
}

/// Reads the input as a scenario.
fn scenario(data: &[u8]) {
    // What is wrong with it is said line by line.
    let _ = Scenario::parse(&String::from_utf8_lossy(data));
}

/// Opens the input as a recording and draws what is whole of it. Checksums are put right first, or no mutation would be read on.
fn recording(data: &[u8]) {
    for bytes in [data.to_vec(), sieben_sim::trace::recording::with_checksums(data)] {
        let Ok(trace) = Trace::open(Box::new(Memory::of(bytes))) else { continue };
        let range = trace.all();
        let mut out = String::new();
        timing_diagram::text(&trace, &Drawn::text()).expect("what was opened can be read");
        timing_diagram::svg(&trace, &Drawn::svg()).expect("what was opened can be read");
        vcd::write(&trace, &range, &mut out).expect("what was opened can be read");
        csv::write(&trace, &range, csv::Rows::Changes, &mut out).expect("what was opened can be read");
    }
}

/// Words of requests at a control socket.
fn control_words() -> Vec<&'static str> {
    let words = "{\"id\":1, \"verb\":\" \"state\" \"read\" \"write\" \"force\" \"unforce\" \"unforce_all\" \"diagnostics\" \"blocks\" \"status\" \"mode\" \
        \"time\" \"faults\" \"items\":[ \"values\":{ \"after\": \"from\": \"block\": \"restart\": \"scans\": \"speed\": \"inject\": \"mend\": MW10 I0.0 DB1.DBW0 T1 \
        C1 ACCU1 STW P#M0.0 BYTE #x FC1.#x W#16#FF S5T#2S 1.5 true null } ] , : -1 1e999 \\ud800 \\u0000";
    words.split_whitespace().chain(["\n"]).collect()
}

/// Words of messages of pages.
fn page_words() -> Vec<&'static str> {
    let words = "{\"t\":\"hello\" \"v\":1 \"lang\":\"de\" \"t\":\"sub\" \"t\":\"unsub\" \"t\":\"at\" \"t\":\"ack\" \"t\":\"rate\" \"t\":\"who\" \"t\":\"history\" \"id\":\"x\" \"what\":\"rows\" \
        \"what\":\"tags\" \"what\":\"leds\" \"block\":\"OB1\" \"names\":[ \"from\":0 \"to\":399 \"reason\":3 \"scan\":\"live\" \"seq\":1 \"hz\":0 \"channels\":[ \"points\":5 } ] , : -1 1e999 \\ud800 null";
    words.split_whitespace().chain(["\n"]).collect()
}

/// Keywords and signs of ST.
fn st_words() -> Vec<&'static str> {
    let mut words: Vec<&str> = sieben_lang::st::parser::words().collect();
    words.extend([
        ":=",
        "=>",
        "=:",
        ":=>",
        "==",
        "!=",
        "<>",
        "+=",
        "?=",
        "S=",
        "REF=",
        "**",
        "..",
        "^",
        "(*",
        "*)",
        "/*",
        "*/",
        "//",
        "{",
        "}",
        "#x",
        "\"x\"",
        "'x'",
        "T#1h2m",
        "D#2024-02-29",
        "16#FF",
        "INT#-5",
        "B#(1,2)",
        "P#M0.0",
        "%IX0.0",
        "%QW*",
        ".%X3",
        "x.3",
        "MW[i]",
        "DB10.DW4",
        "\nLD\n",
        "\nFBD\n",
        "\nNETWORK",
        "\n    OR\n",
        "\n    BRANCH\n",
        "\n    END\n",
        "\n    NO  x",
        "\n    COIL  /x",
        "\n        IN1:\n",
        "->",
        "|-",
        "M0.1",
        "x : INT;",
        "AT",
        "R_EDGE",
        "EXTENDS",
        "REF_TO",
        "POINTER TO",
        "ARRAY[1..3] OF",
        "STRING[5]",
        "{IF defined (x)}",
        "{ELSE}",
        "{END_IF}",
        "TITLE =",
        "VERSION : 0.1",
        "$>",
        "$<",
    ]);
    words
}

fn no_words() -> Vec<&'static str> {
    Vec::new()
}

/// Words of the file of a campaign.
fn campaign_words() -> Vec<&'static str> {
    let words = "[campaign] [exhaustive] [set] [sweep] [draw] [[fault]] [swarm] [disturb] [matrix] [[never]] [[response]] [[measure]] name= program= \
        for= seed= samples= settle= replay= within= inputs= \"A\" \"oven.gain\" {values=[1,2]} {from=1,to=8,steps=3} {uniform=[0,1]} {normal=[1,2]} \
        {walk={every=\"2s\",chance=0.1}} signal= fault= chance=0.5 expr= when= then= of=\"max\" \"10ms\" \"-15ms\" 1 -1 nan 1e999 true \"\" , ] }";
    words.split_whitespace().chain(["\n"]).collect()
}

/// Words of the file of a fleet.
fn fleet_words() -> Vec<&'static str> {
    let words = "[fleet] [[controller]] [[link]] name= count= program= cycle= seed= from= to= latency= kind= \"station\" \"station[i].QB 0\" \"station[i+1].IB 0\" \
        \"station[3].Q 0.0\" \"master.IW 0\" \"10ms\" \"1us\" \"io\" \"s7\" 1 0 -1 100000 1e999 [ ] i+ i- . \"";
    words.split_whitespace().chain(["\n"]).collect()
}

/// Words of the messages between a run and its workers.
fn farm_words() -> Vec<&'static str> {
    let words = "result whole given-up object new settled over meaning sha256 SIEBEN_ _JOBS 0 1 18446744073709551615 1f00 k3-1 worker-7";
    words.split_whitespace().chain([" ", "\n", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"]).collect()
}

fn settings_words() -> Vec<&'static str> {
    vec![
        "[project]\n",
        "[cpu]\n",
        "[[module]]\n",
        "[cyclic.35]\n",
        "retain = { m = \"0..15\" }\n",
        "kind = \"tank\"\n",
        "fault = \"level stuck@30s\"\n",
        "cycle = \"free\"\n",
        "input = 99999999999999999999\n",
        "level = nan\n",
        "\u{0}",
    ]
}

fn scenario_words() -> Vec<&'static str> {
    vec![
        "cpu 416-3",
        "recorded 00AA \"x\"\n",
        "end 3",
        "always Q 0.0=1",
        "start with I 0.0=1",
        "clock DT#2026-11-22-09:30:00",
        "interrupt OB 40 EVENT=16#1141",
        "cycle 10ms",
        "set I 0.0=1",
        "scan",
        "scan 3",
        "scan until 400ms",
        "at 310ms",
        "expect",
        "expect stop 16#2522",
        "within 20ms",
        "table",
        "->",
        "STW.RLO=1",
        "modules 0..63",
        "restart warm",
        "power failure",
        "retain m=0..31,40 t=1 c=",
        "interrupt OB 40 at safe point 17",
        "known-gap \"why\"",
        "ACCU1=",
        "DB1.DBD4=1.5",
    ]
}

fn twincat_words() -> Vec<&'static str> {
    vec![
        "<TcPlcObject>",
        "</TcPlcObject>",
        "<POU Name=\"A\">",
        "</POU>",
        "<Declaration>",
        "</Declaration>",
        "<Implementation>",
        "</Implementation>",
        "<ST>",
        "</ST>",
        "<NWL/>",
        "<![CDATA[",
        "]]>",
        "<Method Name=\"M\">",
        "</Method>",
        "<Property Name=\"P\">",
        "</Property>",
        "<Get>",
        "</Get>",
        "<Action Name=\"A\">",
        "</Action>",
        "FUNCTION_BLOCK A",
        "(* @NESTEDCOMMENTS := 'Yes' *)",
        "_FBD_BODY",
        "LIBRARY",
        "END_LIBRARY",
        "END_PROGRAM",
    ]
}

fn project_words() -> Vec<&'static str> {
    vec![
        "<awlsim_project format_version=\"1\">",
        "</awlsim_project>",
        "<cpu>",
        "<specs nr_accus=\"4\"/>",
        "nr_flags=\"65536\"",
        "<config mnemonics=\"2\"/>",
        "<language_awl>",
        "<language_fup>",
        "<symbols>",
        "<source name=\"a\" file=\"b\">",
        "</source>",
        "<![CDATA[",
        "]]>",
        "<lib_selection name=\"IEC\" type=\"FC\" index=\"2\"/>",
        "<!DOCTYPE a [",
        "&amp;",
        "&#0;",
        "<!--",
        "-->",
    ]
}

fn symbol_words() -> Vec<&'static str> {
    vec![
        "symbol,address,type,comment",
        "\"Start\",\"I 0.0\",\"BOOL\",\"\"",
        "I 0.0",
        "QW 4",
        "T 1",
        "DB 5",
        "FB 1",
        "UDT 7",
        "126,",
        "TABLE\n0,1\n\"\"\n",
        "VECTORS\n0,2\n\"\"\n",
        "DATA\n0,0\n\"\"\n",
        "-1,0\nBOT\n",
        "-1,0\nEOD\n",
        "1,0\n",
        "0,4711\nV\n",
        "Name;Adresse;Datentyp;Kommentar",
        "\"%I0.1\",\"Bool\",\"True\",\"True\",\"False\"",
        "\"\"",
        "\t",
        ";",
    ]
}

fn diagram_words() -> Vec<&'static str> {
    let signs = [
        "-> ",
        "|- ",
        " | ",
        "(",
        ")",
        "/",
        "!",
        "[",
        "]",
        "{",
        " ; ",
        "}",
        "#(",
        ":= ",
        "=> ",
        ", ",
        ".",
        "and(",
        "or(",
        "xor(",
        "= Q 4.0",
        "I 0.0",
        "MW 2",
        "NETWORK",
        "NETWORK LAD",
        "NETWORK FBD",
        "NETWORK STL",
        "TITLE = a",
        "// a",
        "\n",
        "\n    ",
        "\n        ",
        "\t",
        "\r\n",
        "T 1",
        "C 1",
        "DB1.DBW 2",
        "\"a\"",
        "#a",
        "L 20.0",
        "S5T#2S",
        "C#10",
        ">I",
        "==R",
        "<0",
        "OV",
        "BR",
        "FC 1",
        "FB 1, DB 1",
        "IN",
        "OUT",
        "S",
        "R",
        "TV",
        "PV",
        "CV",
        "BI",
        "EN",
        "LABEL a:",
        "JMP a",
        "OR ( )",
        "MID / M 0.0",
        "/OR",
        "/AND",
        "/XOR",
        "/CMP",
    ];
    let words = sieben_lang::network::elements::ELEMENTS.iter().map(|row| row.word);
    let boxes = sieben_lang::network::boxes::BOXES.iter().map(|row| row.name);
    signs.into_iter().chain(words).chain(boxes).collect()
}

fn literal_words() -> Vec<&'static str> {
    vec![
        "L#",
        "2#",
        "B#16#",
        "W#16#",
        "DW#16#",
        "B#(",
        "C#",
        "S5T#",
        "T#",
        "D#",
        "TOD#",
        "DT#",
        "P#",
        "P#DB1.DBX",
        " BYTE ",
        "'",
        "$'",
        "_",
        "e+",
        "TRUE",
    ]
}

/// Mnemonics of both languages and the words between them.
fn stl_words() -> Vec<&'static str> {
    const WORDS: &[&str] = &[
        "ORGANIZATION_BLOCK OB 1",
        "FUNCTION FC 1 : VOID",
        "FUNCTION_BLOCK FB 1",
        "DATA_BLOCK DB 1",
        "TYPE UDT 1",
        "STRUCT",
        "END_STRUCT",
        "END_TYPE",
        "END_FUNCTION",
        "END_FUNCTION_BLOCK",
        "END_ORGANIZATION_BLOCK",
        "END_DATA_BLOCK",
        "BEGIN",
        "NETWORK",
        "TITLE =",
        "VERSION : 0.1",
        "AUTHOR : x",
        "KNOW_HOW_PROTECT",
        "VAR",
        "VAR_INPUT",
        "VAR_OUTPUT",
        "VAR_IN_OUT",
        "VAR_TEMP",
        "END_VAR",
        "ARRAY [1..3] OF INT",
        "STRING[10]",
        "UDT 1",
        "FB 1",
        "BOOL",
        "BYTE",
        "WORD",
        "DWORD",
        "INT",
        "DINT",
        "REAL",
        "S5TIME",
        "TIME",
        "DATE",
        "DATE_AND_TIME",
        "POINTER",
        "ANY",
        ":=",
        ":",
        ";",
        "..",
        "//",
        "(*",
        "I 0.0",
        "E 0.0",
        "Q 0.0",
        "A 0.0",
        "MW 10",
        "MD 4",
        "L 0.0",
        "DB1.DBW 0",
        "DBX 0.0",
        "DIW 2",
        "T 1",
        "C 1",
        "Z 1",
        "PIW 256",
        "PEW 256",
        "#x",
        "\"s\"",
        "\"s\".a[1]",
        "[AR1,P#0.0]",
        "[MD 4]",
        "P##x",
        "P#M 0.0 BYTE 4",
        "W#16#FFFF",
        "S5T#2H46M30S",
        "L#-1",
        "2#1",
        "B#(1,2,3,4)",
        "C#999",
        "1.0e10",
        "'abc'",
        "D#2024-2-29",
        "TOD#23:59:59.999",
        "DT#24-1-1-0:0:0",
        "T#-1ms",
        "==0",
        "UO",
        "AR2",
        "STW",
        "__ASSERT== 1, 2",
        "__ASSERT==R",
        "__STWRST",
        "__SLEEP 1",
        "__FEATURE 0, 4",
        "__ACCU 1",
        "__STW VKE",
        "__CNST_PI",
        "SFC -1",
        "label:",
        "{ S7_m_c := 'true' }",
    ];
    let mnemonics = Instruction::ALL.iter().flat_map(|row| [row.english(), row.german()]);
    mnemonics.chain(WORDS.iter().copied()).collect()
}
