//! Diagrams of IEC 61131-3 against Structured Text, and against what a drawing says: over all inputs, all types, and random networks.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use sieben_cpu::{Cpu, Restart};
use sieben_engine::Program;
use sieben_lang::Options;
use sieben_lang::network::flavour::{Drawing, Flavour};
use sieben_lang::network::model::{
    Branch, Content, Element, End, Kind, NamedBox, NamedInput, Network, Output, OutputKind, Place, Rung, XorInput,
};
use sieben_lang::network::operand::Operand;
use sieben_lang::network::{form_a, form_b};
use sieben_lang::st::dialect::Dialect;
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;

fn cpu_type() -> &'static CpuType {
    CpuType::by_name("416-3").expect("a CPU")
}

/// A program that runs.
struct Running {
    cpu: Cpu,
    program: Arc<Program>,
    scans: u64,
}

impl Running {
    /// The program on each engine.
    fn on_engines(text: &str, dialect: Dialect) -> Vec<(&'static str, Self)> {
        let compiled = program::compile_sources(&[("page.st", text)], None, Some(dialect), cpu_type());
        let compiled = compiled.unwrap_or_else(|why| panic!("[{}] {why}\n{text}", dialect.name()));
        let program = Arc::new(compiled.program);
        let start = |&(engine, load): &(&'static str, program::Load)| {
            let mut cpu = program::cpu(&program, cpu_type(), load, None);
            cpu.restart(Restart::Warm);
            (engine, Self { cpu, program: Arc::clone(&program), scans: 0 })
        };
        program::ENGINES.iter().map(start).collect()
    }

    fn name(&self, name: &str) -> Name {
        Name::parse(name, &SymbolTable::default(), &self.program).unwrap_or_else(|_| panic!("`{name}` is a variable"))
    }

    fn set(&mut self, name: &str, value: &str) {
        let place = self.name(name);
        place.write(&mut self.cpu, value).unwrap_or_else(|_| panic!("{name} := {value}"));
    }

    fn scan(&mut self, cycle_us: u64) {
        self.cpu.scan(self.scans * cycle_us);
        self.scans += 1;
    }

    fn get(&self, name: &str) -> String {
        self.name(name).read(&self.cpu).unwrap_or_else(|_| panic!("{name} is read")).to_string()
    }
}

/// Numbers that look random and are the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (mixed ^ (mixed >> 31)) % limit
    }

    fn chance(&mut self, one_of: u64) -> bool {
        self.below(one_of) == 0
    }
}

// The pages of the course.

/// A section of a page: its forms, and the names that its checks give values.
#[derive(Default)]
struct Item {
    dialects: Vec<Dialect>,
    forms: Vec<String>,
    inputs: Vec<String>,
}

/// The sections of the page by their headings.
fn items() -> BTreeMap<String, Item> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/course/s2_diagrams.md");
    let page = fs::read_to_string(path).expect("the page of the course");
    let mut items: BTreeMap<String, Item> = BTreeMap::new();
    let (mut heading, mut fence) = (String::new(), None::<&str>);
    for line in page.lines() {
        match (fence, line) {
            (_, line) if line.starts_with("## ") => heading = line.to_owned(),
            (None, line) if line.starts_with("```") => {
                fence = Some(line.trim_start_matches('`'));
                if let Some(dialects) = line.strip_prefix("```st ") {
                    let item = items.entry(heading.clone()).or_default();
                    item.dialects = dialects.split_whitespace().map(|word| Dialect::from_name(word).expect("a dialect")).collect();
                    item.forms.push(String::new());
                }
            }
            (Some(_), "```") => fence = None,
            (Some(info), line) if info.starts_with("st") => {
                let form = items.get_mut(&heading).and_then(|item| item.forms.last_mut()).expect("a fence has begun");
                form.push_str(line);
                form.push('\n');
            }
            (Some("check"), line) => {
                let item = items.get_mut(&heading).expect("a check stands behind a program");
                let mut words = line.split_whitespace();
                let names: Vec<&str> = match words.next() {
                    Some("set") => words.filter_map(|word| word.split_once('=')).map(|(name, _)| name).collect(),
                    Some("at") => words.skip(1).filter_map(|word| word.split_once('=')).map(|(name, _)| name).collect(),
                    Some("table") => words.take_while(|word| *word != "->").collect(),
                    _ => Vec::new(),
                };
                for name in names {
                    if !item.inputs.iter().any(|known| known == name) {
                        item.inputs.push(name.to_owned());
                    }
                }
            }
            _ => {}
        }
    }
    items
}

/// The variables of a program with their types.
fn variables(text: &str) -> Vec<(String, String)> {
    let declared = text.split("END_VAR").next().unwrap_or_default().trim_start().trim_start_matches("VAR");
    let mut variables = Vec::new();
    for declaration in declared.split(';') {
        let Some((names, data_type)) = declaration.split_once(':') else { continue };
        let data_type = data_type.split(":=").next().unwrap_or_default().trim().to_owned();
        variables.extend(names.split(',').map(|name| (name.trim().to_owned(), data_type.clone())));
    }
    variables
}

/// Values of a type: all of them where they are few, else those at the edges.
fn values(data_type: &str) -> Vec<String> {
    let written = |values: &[i64]| values.iter().map(i64::to_string).collect();
    match data_type {
        "BOOL" => written(&[0, 1]),
        "BYTE" => (0..=255).map(|value: i32| value.to_string()).collect(),
        "WORD" => ["0", "1", "16#00FF", "16#8000", "16#8001", "16#A55A", "16#FFFF"].map(str::to_owned).to_vec(),
        "DWORD" => ["0", "1", "16#80000000", "16#A55AA55A", "16#FFFFFFFF"].map(str::to_owned).to_vec(),
        _ => written(&[0, 1, 2, 3, 4, 15, 16, 17, -1, 32767, -32768]),
    }
}

/// Combinations of inputs are all tried up to this many, else so many at random.
const COMBINATIONS_MAX: usize = 4096;

#[test]
fn diagrams_of_the_course_do_what_their_text_does() {
    let items = items();
    assert!(items.len() >= 13, "{}", items.len());
    for (heading, item) in &items {
        assert_eq!(item.forms.len(), 3, "{heading}: in Structured Text, as LD and as FBD");
        for &dialect in &item.dialects {
            compare(heading, item, dialect);
        }
    }
}

fn compare(heading: &str, item: &Item, dialect: Dialect) {
    let declared = variables(&item.forms[0]);
    let is_input = |name: &str| item.inputs.iter().any(|input| input == name);
    let simple = ["BOOL", "BYTE", "WORD", "DWORD", "INT", "TIME"];
    let outputs: Vec<&str> =
        declared.iter().filter(|(name, of)| !is_input(name) && simple.contains(&of.as_str())).map(|(name, _)| name.as_str()).collect();
    assert!(!outputs.is_empty(), "{heading}");
    let choices: Vec<(&str, Vec<String>)> = item
        .inputs
        .iter()
        .map(|input| {
            let of = declared.iter().find(|(name, _)| name == input).unwrap_or_else(|| panic!("{heading}: `{input}` is declared"));
            (input.as_str(), values(&of.1))
        })
        .collect();
    let all: usize = choices.iter().map(|(_, values)| values.len()).product();
    let keeps = declared.iter().any(|(_, of)| !simple.contains(&of.as_str()));
    let mut random = Random(all as u64);
    // What remembers sees its inputs in many orders, and stay as they are for some scans.
    let rounds = if keeps { 600 } else { all.min(COMBINATIONS_MAX) };
    let mut forms: Vec<Vec<(&str, Running)>> = item.forms.iter().map(|form| Running::on_engines(form, dialect)).collect();
    for round in 0..rounds {
        let mut index = if all <= COMBINATIONS_MAX && !keeps { round } else { usize::try_from(random.below(all as u64)).unwrap_or(0) };
        let stays = keeps && round % 3 != 0;
        let mut inputs = Vec::new();
        for (name, values) in &choices {
            inputs.push((*name, values[index % values.len()].clone()));
            index /= values.len();
        }
        let mut shown: Vec<String> = Vec::new();
        for (engine, running) in forms.iter_mut().flatten() {
            if !stays {
                inputs.iter().for_each(|(name, value)| running.set(name, value));
            }
            running.scan(700_000);
            let values: Vec<String> = outputs.iter().map(|name| format!("{name}={}", running.get(name))).collect();
            let values = values.join(" ");
            assert!(
                shown.is_empty() || shown[0] == values,
                "{heading} [{}, {engine}] {inputs:?}: {} and {values}",
                dialect.name(),
                shown[0]
            );
            shown.push(values);
        }
        assert_eq!(shown.len(), 6, "three forms on two engines");
    }
}

// All types.

/// Types that compare, with three values in their order.
const COMPARED: [(&str, [&str; 3]); 21] = [
    ("BOOL", ["FALSE", "TRUE", "TRUE"]),
    ("BYTE", ["16#00", "16#7F", "16#FF"]),
    ("WORD", ["16#0000", "16#7FFF", "16#FFFF"]),
    ("DWORD", ["16#0", "16#7FFFFFFF", "16#FFFFFFFF"]),
    ("LWORD", ["16#0", "16#7FFFFFFFFFFFFFFF", "16#FFFFFFFFFFFFFFFF"]),
    ("SINT", ["-128", "0", "127"]),
    ("USINT", ["0", "128", "255"]),
    ("INT", ["-32768", "32", "32767"]),
    ("UINT", ["0", "32768", "65535"]),
    ("DINT", ["-2147483648", "-1", "2147483647"]),
    ("UDINT", ["0", "2147483648", "4294967295"]),
    ("LINT", ["-9223372036854775808", "0", "9223372036854775807"]),
    ("ULINT", ["0", "9223372036854775808", "18446744073709551615"]),
    ("REAL", ["-1.5", "0.0", "1.0E30"]),
    ("LREAL", ["-1.5", "0.0", "1.0E300"]),
    ("TIME", ["T#0s", "T#10s", "T#20d"]),
    ("DATE", ["D#1990-01-01", "D#2024-02-29", "D#2026-11-28"]),
    ("TOD", ["TOD#00:00:00", "TOD#12:00:00", "TOD#23:59:59.999"]),
    ("DT", ["DT#1990-01-01-00:00:00", "DT#2024-02-29-12:00:00", "DT#2026-11-28-00:00:00"]),
    ("STRING", ["''", "'a'", "'ab'"]),
    ("WSTRING", ["\"\"", "\"a\"", "\"ab\""]),
];

const COMPARISONS: [(&str, &str); 6] = [("GT", ">"), ("GE", ">="), ("EQ", "="), ("LE", "<="), ("LT", "<"), ("NE", "<>")];

/// An expression, and its networks in LD and FBD.
type Row = (String, String, String);

/// A program that fills an array in Structured Text, as LD and as FBD; each row is the expression, and the two networks.
fn three_forms(declarations: &str, of: &str, rows: &[Row]) -> String {
    let last = rows.len() - 1;
    let mut text = String::new();
    let calls = "text(); ladder(); blocks();";
    let mut block = |name: &str, first: &str, lines: fn(usize, &Row) -> String| {
        let _ =
            write!(text, "FUNCTION_BLOCK {name}\nVAR_OUTPUT o : ARRAY[0..{last}] OF {of}; END_VAR\nVAR\n{declarations}END_VAR\n{first}\n");
        rows.iter().enumerate().for_each(|(index, row)| text.push_str(&lines(index, row)));
        text.push_str("END_FUNCTION_BLOCK\n");
    };
    block("InText", "", |index, row| format!("o[{index}] := {};\n", row.0));
    block("AsLadder", "LD", |index, row| format!("NETWORK\n    {}\n", row.1.replace('@', &format!("o[{index}]"))));
    block("AsBlocks", "FBD", |index, row| format!("NETWORK\n    {}\n", row.2.replace('@', &format!("o[{index}]"))));
    let _ = write!(text, "PROGRAM Main\nVAR text : InText; ladder : AsLadder; blocks : AsBlocks; END_VAR\n{calls}\nEND_PROGRAM\n");
    text
}

fn holds(text: &str, dialect: Dialect, rows: &[(String, String, String)]) {
    for (engine, mut running) in Running::on_engines(text, dialect) {
        running.scan(10_000);
        for (index, row) in rows.iter().enumerate() {
            let read = |form: &str| running.get(&format!("Main.{form}.o[{index}]"));
            let (text, ladder, blocks) = (read("text"), read("ladder"), read("blocks"));
            assert_eq!([&ladder, &blocks], [&text, &text], "[{}, {engine}] {}: LD, FBD", dialect.name(), row.0);
        }
    }
}

#[test]
fn comparisons_are_boxes_of_every_type() {
    for (data_type, values) in COMPARED {
        for dialect in [Dialect::Iec, Dialect::Codesys] {
            let declarations: String =
                values.iter().enumerate().map(|(index, value)| format!("v{index} : {data_type} := {value};\n")).collect();
            let mut rows = Vec::new();
            for (name, sign) in COMPARISONS {
                for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 2), (2, 1), (0, 2), (2, 0)] {
                    rows.push((
                        format!("v{a} {sign} v{b}"),
                        format!("{name} v{a}, v{b}\n    COIL  @"),
                        format!("{name}\n        IN1 := v{a}\n        IN2 := v{b}\n        OUT => @"),
                    ));
                }
                // A constant takes the type of the other input.
                rows.push((
                    format!("v1 {sign} {}", values[1]),
                    format!("{name} v1, {}\n    COIL  @", values[1]),
                    format!("{name} IN1 := v1, IN2 := {} => @", values[1]),
                ));
            }
            holds(&three_forms(&declarations, "BOOL", &rows), dialect, &rows);
        }
    }
}

#[test]
fn what_stands_before_the_arrow_of_a_box_is_its_last_input() {
    let moved = [
        ("BOOL", "v : ARRAY[0..2] OF BOOL := [3(TRUE)];\n", ["TRUE", "true", "FALSE", "v[1]"].as_slice()),
        ("INT", "v : ARRAY[0..2] OF INT := [3(7)]; n : INT := 2;\n", &["5", "-5", "16#7F", "v[1]", "n+1", "n"]),
        ("WORD", "v : ARRAY[0..2] OF WORD := [3(16#FF)];\n", &["16#FF", "2#101", "v[2]", "5"]),
        ("REAL", "v : ARRAY[0..2] OF REAL := [3(1.5)];\n", &["1.5", "-2.5E3", "v[2]"]),
        ("TIME", "t : TON := (PT := T#3s);\n", &["T#5s", "t.PT"]),
        ("STRING", "s : STRING := 'ab';\n", &["'a, b => c'", "s"]),
    ];
    for dialect in [Dialect::Iec, Dialect::Codesys] {
        for (data_type, declarations, values) in moved {
            let row = |value: &&str| ((*value).to_owned(), format!("MOVE  {value} => @"), format!("|- MOVE({value} => @)"));
            let rows: Vec<Row> = values.iter().map(row).collect();
            holds(&three_forms(declarations, data_type, &rows), dialect, &rows);
        }
    }
}

/// A function with two inputs and an output beside its result.
const QUOTIENT: &str = "FUNCTION Quotient : INT\nVAR_INPUT a, b : INT; END_VAR\nVAR_OUTPUT rest : INT; END_VAR\nQuotient := a / b; rest := a MOD b;\nEND_FUNCTION\n";

#[test]
fn outputs_by_name_stand_beside_inputs_by_position() {
    let declarations = "n : INT := 17; b : INT := 5; none : INT; x : INT; ok : BOOL;\n";
    let numbers = [
        ("17 / 5", "DIV n, b => @, ENO => ok", "DIV(n, b => @, ENO => ok)"),
        ("17 / 5", "DIV n, b, ENO => ok, OUT => @", "DIV(n, b, OUT => @, ENO => ok)"),
        ("17 / 5", "Quotient n, b => @", "Quotient(n, b => @)"),
        ("17 / 5", "Quotient n, b => @, rest => x", "Quotient(n, b => @, rest => x)"),
        ("17 MOD 5", "Quotient n, b, rest => @", "Quotient(n, b, rest => @)"),
        ("17 MOD 5", "Quotient a := n, b := b, rest => @, ENO => ok", "Quotient(a := n, b := b, rest => @, ENO => ok)"),
        ("17", "MOVE n => @, ENO => ok", "MOVE(n => @, ENO => ok)"),
    ];
    let bits = [
        ("TRUE", "DIV n, b => x, ENO => @", "DIV(n, b => x, ENO => @)"),
        ("FALSE", "DIV n, none => x, ENO => @", "DIV(n, none => x, ENO => @)"),
        ("FALSE", "DIV n, none, ENO => @, OUT => x", "DIV(n, none, ENO => @, OUT => x)"),
        ("TRUE", "MOVE 16#7F => x, ENO => @", "MOVE(16#7F => x, ENO => @)"),
    ];
    for dialect in [Dialect::Iec, Dialect::Codesys] {
        for (of, rows) in [("INT", numbers.as_slice()), ("BOOL", bits.as_slice())] {
            let row = |&(text, ladder, line): &(&str, &str, &str)| (text.to_owned(), ladder.to_owned(), format!("|- {line}"));
            let rows: Vec<Row> = rows.iter().map(row).collect();
            holds(&format!("{QUOTIENT}{}", three_forms(declarations, of, &rows)), dialect, &rows);
        }
    }
    // What was read is printed as it was written.
    for (_, _, line) in numbers.iter().chain(&bits) {
        let line = line.replace('@', "y");
        let line = format!("|- {line}");
        let network = form_b::parse(&line, 0, Flavour::Iec).unwrap_or_else(|mistake| panic!("{line}: {mistake:?}"));
        assert_eq!(form_b::print(&network, Drawing::Lad), line);
    }
}

#[test]
fn shifts_and_rotations_are_boxes_of_every_width() {
    let types = [
        ("BYTE", 8, "16#A5"),
        ("WORD", 16, "16#A55A"),
        ("DWORD", 32, "16#A55A0FF0"),
        ("LWORD", 64, "16#A55A0FF012345678"),
        ("SINT", 8, "-91"),
        ("USINT", 8, "165"),
        ("INT", 16, "-23206"),
        ("UINT", 16, "42330"),
        ("DINT", 32, "-1520824336"),
        ("UDINT", 32, "2774142960"),
        ("LINT", 64, "-6531890735171447176"),
        ("ULINT", 64, "11914853338538104440"),
    ];
    for (data_type, width, value) in types {
        // Only codesys shifts integers.
        let dialects: &[Dialect] = if value.starts_with("16#") { &[Dialect::Iec, Dialect::Codesys] } else { &[Dialect::Codesys] };
        for &dialect in dialects {
            let declarations = format!("v : {data_type} := {value};\nb : BOOL := TRUE;\n");
            let mut rows = Vec::new();
            for name in ["SHL", "SHR", "ROL", "ROR"] {
                for n in [0, 1, 3, width - 1, width, width + 1] {
                    rows.push((
                        format!("{name}(v, {n})"),
                        format!("NO    b\n    {name} v, {n} => @"),
                        format!("{name}\n        IN := v\n        N := {n}\n        OUT => @"),
                    ));
                }
            }
            holds(&three_forms(&declarations, data_type, &rows), dialect, &rows);
        }
    }
}

#[test]
fn words_are_joined_in_every_width() {
    for (data_type, values) in [
        ("BOOL", ["FALSE", "TRUE", "TRUE"]),
        ("BYTE", ["16#62", "16#A5", "16#0F"]),
        ("WORD", ["16#6262", "16#A55A", "16#00FF"]),
        ("DWORD", ["16#62626262", "16#A55AA55A", "16#0000FFFF"]),
        ("LWORD", ["16#6262626262626262", "16#A55AA55AA55AA55A", "16#00000000FFFFFFFF"]),
    ] {
        let declarations: String =
            values.iter().enumerate().map(|(index, value)| format!("v{index} : {data_type} := {value};\n")).collect();
        let mut rows = vec![("NOT v0".to_owned(), "NOT v0 => @".to_owned(), "MOVE IN := / v0 => @".to_owned())];
        for name in ["AND", "OR", "XOR"] {
            rows.push((
                format!("v0 {name} v1"),
                format!("{name} v0, v1 => @"),
                format!("{name}\n        IN1 := v0\n        IN2 := v1\n        OUT => @"),
            ));
            rows.push((
                format!("v0 {name} v1 {name} NOT v2"),
                format!("{name}\n        IN1 := v0\n        IN2 := v1\n        IN3 := / v2\n        OUT => @"),
                format!("{name} IN1 := v0, IN2 := v1, IN3 := / v2 => @"),
            ));
        }
        for dialect in [Dialect::Iec, Dialect::Codesys] {
            holds(&three_forms(&declarations, data_type, &rows), dialect, &rows);
        }
    }
    // An output that is narrower than the inputs is refused.
    let text = "PROGRAM Main\nVAR a, b : WORD; x : BYTE; END_VAR\nFBD\nNETWORK\n    AND a, b => x\nEND_PROGRAM\n";
    let refused = program::compile_sources(&[("page.st", text)], None, Some(Dialect::Iec), cpu_type());
    assert!(refused.as_ref().is_err_and(|why| why.contains("BYTE")), "{:?}", refused.err());
}

/// A property whose GET and SET are drawn, and the same one in text.
const PROPERTY: &str = "
FUNCTION_BLOCK Drawn
VAR on, held : BOOL; n : INT; END_VAR
PROPERTY Running : BOOL
GET
VAR t : BOOL; END_VAR
LD
NETWORK
    NO held
    JMP  quiet
NETWORK
    NO on
    COIL t
NETWORK
LABEL quiet:
    NO t
    COIL Running
END_GET
SET
FBD
NETWORK
    OR
        NO Running
    OR
        NO held
    END
    COIL on
END_SET
END_PROPERTY
PROPERTY Level : INT
SET
LD
|- MOVE(Level => n)
GT(Level, 6) -> S held
LT(Level, 3) -> R held
END_SET
GET
LD
NETWORK
    ADD n, 1 => Level
END_GET
END_PROPERTY
LD
NETWORK
    NO on
    COIL held
END_FUNCTION_BLOCK
FUNCTION_BLOCK Written
VAR on, held : BOOL; n : INT; END_VAR
PROPERTY Running : BOOL
GET Running := NOT held AND on; END_GET
SET on := Running OR held; END_SET
END_PROPERTY
PROPERTY Level : INT
SET n := Level; IF Level > 6 THEN held := TRUE; ELSIF Level < 3 THEN held := FALSE; END_IF; END_SET
GET Level := n + 1; END_GET
END_PROPERTY
held := on;
END_FUNCTION_BLOCK
PROGRAM Main
VAR drawn : Drawn; written : Written; a, called : BOOL; n : INT; o : ARRAY[0..3] OF INT; END_VAR
drawn.Running := a; written.Running := a;
drawn.Level := n; written.Level := n;
IF called THEN drawn(); written(); END_IF;
o[0] := drawn.Level; o[1] := written.Level;
o[2] := BOOL_TO_INT(drawn.Running); o[3] := BOOL_TO_INT(written.Running);
END_PROGRAM
";

#[test]
fn get_and_set_of_a_property_are_drawn() {
    for (engine, mut running) in Running::on_engines(PROPERTY, Dialect::Codesys) {
        let mut random = Random(7);
        let mut seen = std::collections::BTreeSet::new();
        for scan in 0..64 {
            running.set("Main.a", if random.chance(2) { "1" } else { "0" });
            running.set("Main.called", if random.chance(3) { "1" } else { "0" });
            running.set("Main.n", &random.below(9).to_string());
            running.scan(10_000);
            let o: Vec<String> = (0..4).map(|index| running.get(&format!("Main.o[{index}]"))).collect();
            assert_eq!((&o[0], &o[2]), (&o[1], &o[3]), "[{engine}] scan {scan}");
            seen.insert(o[2].clone());
        }
        assert_eq!(seen.len(), 2, "{seen:?}");
    }
}

// What is wrong.

/// Compiles the body of a program that declares `a` and `b` as BOOL, `n` as INT, `s` as STRING, `t` as TON and `o` as TOF.
fn said(body: &str) -> Vec<(String, String, String)> {
    said_of(Dialect::Iec, &program_of(body))
}

/// Compiles the body of a block of a dialect, with variables of many types.
fn said_in(dialect: Dialect, body: &str) -> Vec<(String, String, String)> {
    let variables = "VAR a, b, c : BOOL; n : INT; w : WORD; s : STRING; d : DINT; r : REAL; t : TIME; END_VAR";
    let mut said = said_of(dialect, &format!("FUNCTION_BLOCK Tried\n{variables}\n{body}\nEND_FUNCTION_BLOCK\n"));
    // Nothing calls the block.
    said.retain(|one| one.0 != "P3013");
    said
}

fn program_of(body: &str) -> String {
    format!(
        "FUNCTION_BLOCK Own VAR_INPUT x : BOOL; END_VAR VAR_OUTPUT y : BOOL; z : INT; END_VAR y := x; END_FUNCTION_BLOCK\n\
         FUNCTION Nothing VAR_INPUT x : BOOL; END_VAR ; END_FUNCTION\n\
         PROGRAM Main VAR a, b : BOOL; n : INT; w : WORD; s : STRING; t : TON; o : TOF; own : Own; END_VAR\n{body}\nEND_PROGRAM\n"
    )
}

/// The code, the place and the message of all that is said about a source.
fn said_of(dialect: Dialect, text: &str) -> Vec<(String, String, String)> {
    let mut sources = Sources::default();
    sources.add("page.st", text);
    let options =
        Options { cpu: Some(cpu_type()), dialect: Some(dialect), system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
    let found = compiled.diagnostics.iter().map(|one| {
        let place = &text[one.span.start as usize..one.span.end as usize];
        (one.problem.code().to_owned(), place.to_owned(), one.message.clone())
    });
    found.collect()
}

#[test]
fn what_is_wrong_is_said_at_its_element() {
    let mut failures = Vec::new();
    for (body, code, place) in [
        ("LD\nNETWORK\n    NO a\n    COIL x", "P3001", "x"),
        ("LD\nNETWORK\n    NO a\n    COIL n", "P2444", "n"),
        ("LD\nNETWORK\n    NO n\n    COIL a", "P2444", "n"),
        ("LD\nNETWORK\n    NO a +\n    COIL b", "P6055", ""),
        ("LD\nNETWORK\n    NO a b\n    COIL b", "P6054", "b"),
        ("LD\nNETWORK\n    FOO n, 1 => n", "P3008", "FOO"),
        ("LD\nNETWORK\n    ADD_I n, 1 => n", "P2440", "ADD_I"),
        ("LD\nNETWORK\n    S_ODT t\n        TV := T#1s\n    COIL a", "P3008", "S_ODT"),
        ("FBD\nNETWORK\n    COIL a", "P2441", "COIL a"),
        ("LD\nNETWORK\n    TON\n        IN := a\n        PT := T#1s", "P4303", "TON"),
        ("LD\nNETWORK\n    NO a\n    TON o\n        PT := T#1s\n    COIL b", "P4304", "o"),
        ("FBD\nNETWORK\n    TON t\n        PT := T#1s\n        Q => b", "P4305", ""),
        ("LD\nNETWORK\n    NO a\n    TON t\n        IN := b\n        PT := T#1s", "P3011", "IN := b"),
        ("LD\nNETWORK\n    NO a\n    TON t\n        TP := T#1s", "P3009", "TP"),
        ("LD\nNETWORK\n    NO a\n    TON t\n        PT := s", "P6200", "s"),
        ("LD\nNETWORK\n    NO a\n    GE\n        EN := b\n        IN1 := n\n        IN2 := 1\n    COIL b", "P3011", ""),
        ("LD\nNETWORK\n    NO a\n    TON t\n        PT := T#1s\n        ET => b", "P4011", "b"),
        ("FBD\nNETWORK\n    Own own\n        y => n", "P4011", "n"),
        ("LD\nNETWORK\n    NO a\n    Own own\n        z => .\n    COIL b", "P4302", ""),
        ("FBD\nNETWORK\n    Nothing a => b", "P6218", ""),
        ("LD\nNETWORK\n    NO a\n    JMP nowhere", "P3004", "nowhere"),
        ("LD\nNETWORK\n    LABEL l:\n    NO a\n    COIL b\nNETWORK\n    LABEL l:\n    NO a\n    JMP l", "P3005", "l"),
        ("LD\nNETWORK\n    NO a\n    CMP >I n, 1\n    COIL b", "P2401", "CMP >I n, 1"),
        ("LD\nNETWORK\n    NO a\n    OR\n    OR\n        NO b\n    END\n    COIL b", "P2405", ""),
        ("LD\nNETWORK\n    NO a", "P2404", ""),
        ("LD\nNETWORK\n    XOR\n        NO a\n    XOR\n        NO b\n    END\n    COIL b", "P2407", ""),
        ("LD\na (b -> = b", "P2409", ""),
        ("LD\nn > 5 -> = b", "P2409", ">"),
        ("LD\n|- MOVE(n + 1 => n)", "P2409", "+"),
        ("LD\na AND b -> = b", "P2409", "A"),
        ("LD\n|- Own[own](a, b, y => b)", "P3009", "b"),
        ("LD\nNETWORK\n    Own own a, b, y => b", "P3009", "b"),
        ("FBD\nNETWORK\n    AND w, 16#FF => n", "P6200", ""),
        (
            "FBD\nNETWORK\n    OR\n        TON t\n            IN := a\n    OR\n        TON t\n            IN := b\n    END\n    COIL b",
            "P2443",
            "t",
        ),
    ] {
        let said = said(body);
        match said.iter().find(|one| one.0 == code) {
            Some(found) if place.is_empty() || found.1 == place => {}
            Some(found) => failures.push(format!("{body}\n{code} stands at `{}` and not at `{place}`", found.1)),
            None => failures.push(format!("{body}\nhas no {code}: {said:?}")),
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}

#[test]
fn a_second_call_of_one_instance_is_told_with_the_first() {
    let of = |second: &str| said(&format!("LD\nNETWORK\n    NO a\n    TON t\n        PT := T#1s\n    COIL b\nNETWORK\n{second}"));
    let again = of("    NO b\n    TON[t]\n        PT := T#2s\n    COIL a");
    assert_eq!(again, [("P2443".to_owned(), "t".to_owned(), "network 2: `t` is called twice, first in network 1".to_owned())]);
    // Other instances, and reading the outputs, are no second call.
    for second in ["    NO b\n    TOF o\n        PT := T#2s\n    COIL a", "    NO t.Q\n    COIL a"] {
        assert_eq!(of(second), [], "{second}");
    }
    // A block of the program may be called in two networks: it is not known to start anything.
    assert_eq!(said("LD\nNETWORK\n    Own own a\nNETWORK\n    Own own b"), []);
}

/// Elements that carry a BOOL, with a gap for their operand.
const BIT_ELEMENTS: [&str; 14] = [
    "LD\nNETWORK\n    NO …\n    COIL b",
    "LD\nNETWORK\n    NC …\n    COIL b",
    "LD\nNETWORK\n    NO a\n    NO …\n    COIL b",
    "LD\nNETWORK\n    OR\n        NO a\n    OR\n        NC …\n    END\n    COIL b",
    "FBD\nNETWORK\n    XOR\n        NO …\n    XOR\n        NO a\n    END\n    COIL b",
    "LD\nNETWORK\n    P …\n    COIL b",
    "LD\nNETWORK\n    N …\n    COIL b",
    "LD\nNETWORK\n    NO a\n    COIL …",
    "LD\nNETWORK\n    NO a\n    COIL / …",
    "LD\nNETWORK\n    NO a\n    PCOIL …",
    "LD\nNETWORK\n    NO a\n    SET …",
    "LD\nNETWORK\n    NO a\n    RESET …",
    "LD\nNETWORK\n    NO a\n    MID …\n    COIL b",
    "LD\nNETWORK\n    ABS\n        EN := …\n        IN := n\n        OUT => n",
];

#[test]
fn contacts_coils_and_en_take_a_bool_in_every_dialect() {
    for dialect in Dialect::ALL {
        for element in BIT_ELEMENTS {
            assert_eq!(said_in(dialect, &element.replace('…', "c")), [], "{dialect:?} {element}");
            for operand in ["n", "w", "s", "d", "r", "t"] {
                let said = said_in(dialect, &element.replace('…', operand));
                let codes: Vec<(&str, &str)> = said.iter().map(|one| (one.0.as_str(), one.1.as_str())).collect();
                assert_eq!(codes, [("P2444", operand)], "{dialect:?} {element} {said:?}");
                assert!(said[0].2.starts_with("network 1: "), "{said:?}");
            }
        }
    }
    // A pin takes what its box takes.
    assert_eq!(said("FBD\nNETWORK\n    ADD\n        IN1:\n            NO n\n        IN2 := 1\n        OUT => n"), []);
    // What the message proposes is right.
    for dialect in Dialect::ALL {
        for compared in ["n <> 0", "w <> 16#0", "r <> 0.0", "t <> T#0s"] {
            assert_eq!(said_in(dialect, &BIT_ELEMENTS[0].replace('…', compared)), [], "{dialect:?} {compared}");
        }
    }
    // A bit of a word is a BOOL, where the dialect has names for bits.
    assert_eq!(said_in(Dialect::Codesys, "LD\nNETWORK\n    NO w.3\n    COIL w.4"), []);
    assert_eq!(said_in(Dialect::Tia, "LD\nNETWORK\n    NO w.%X3\n    COIL w.%X4"), []);
}

#[test]
fn large_and_deep_bodies_end_in_a_message_or_a_program() {
    // Ten thousand contacts are more than a network has; a few thousand run.
    let wide = |count: usize| format!("LD\nNETWORK\n{}    COIL b", "    NO a\n".repeat(count));
    assert!(said(&wide(10_000)).iter().any(|one| one.0 == "P2408"));
    assert_eq!(said(&wide(4_000)), []);
    let branches = format!("LD\nNETWORK\n{}    END\n    COIL b", "    OR\n        NO a\n".repeat(2_000));
    assert_eq!(said(&branches), []);
    let coils = format!("LD\nNETWORK\n    NO a\n{}", "    COIL b\n".repeat(4_000));
    assert_eq!(said(&coils), []);
    let boxes = format!("LD\nNETWORK\n    NO a\n{}", "    ADD n, 1 => n\n".repeat(2_000));
    assert_eq!(said(&boxes), []);
    let mut deep = "LD\nNETWORK\n".to_owned();
    (0..1_000).for_each(|level| deep += &format!("{}OR\n", "  ".repeat(level + 2)));
    assert!(said(&deep).iter().any(|one| one.0 == "P2408"), "{:?}", said(&deep).first());
    let line = format!("LD\n{}a{} -> = b", "(a | ".repeat(1_000), ")".repeat(1_000));
    assert!(said(&line).iter().any(|one| one.0 == "P2408"), "{:?}", said(&line).first());
    let pins =
        format!("FBD\nNETWORK\n{}", (0..200).map(|level| format!("{}ADD\n{0}  IN1:\n", "  ".repeat(2 * level + 2))).collect::<String>());
    assert!(said(&pins).iter().any(|one| one.0 == "P2408"), "{:?}", said(&pins).first());
}

// Random networks.

/// BOOL variables `b0` … and INT variables `n0` … of the random programs.
const BITS: usize = 8;
const NUMBERS: usize = 3;
/// How many networks a random program has.
const NETWORKS: usize = 6;

/// Makes networks that the rules of diagrams allow.
struct Maker {
    random: Random,
    drawing: Drawing,
    /// A line is tapped, so that FBD may read it elsewhere.
    tapped: bool,
}

impl Maker {
    fn bit(&mut self) -> Operand {
        Operand::from(format!("b{}", self.random.below(BITS as u64)))
    }

    fn number(&mut self) -> Operand {
        Operand::from(format!("n{}", self.random.below(NUMBERS as u64)))
    }

    fn network(&mut self, index: usize) -> Network {
        let label = (index > 0).then(|| Operand::from(format!("l{index}")));
        self.tapped = false;
        let mut rung = self.rung(2);
        if index + 1 < NETWORKS
            && self.random.chance(5)
            && let End::Outputs(outputs) = &mut rung.end
        {
            let target = index as u64 + 1 + self.random.below((NETWORKS - index - 1) as u64);
            let label = Operand::from(format!("l{target}"));
            outputs.push(if self.random.chance(2) { OutputKind::Jump(label) } else { OutputKind::JumpNot(label) }.at(Place::default()));
        }
        Network { label, content: Content::Rung(rung) }
    }

    fn rung(&mut self, depth: u32) -> Rung {
        let first = !self.tapped;
        let mut line = self.line(depth, first);
        if self.tapped && self.random.chance(4) {
            line.clear();
        }
        let end = match self.random.below(6) {
            0 if depth > 0 => {
                let outer = std::mem::replace(&mut self.tapped, true);
                let rungs = (0..2 + self.random.below(2)).map(|_| self.rung(depth - 1)).collect();
                self.tapped = outer;
                End::Branches(rungs)
            }
            1 if line.last().is_some_and(|last| last.kind.is_box()) => End::Open,
            _ => End::Outputs((0..1 + self.random.below(3)).map(|_| self.output()).collect()),
        };
        if line.is_empty() && matches!(end, End::Branches(_)) {
            line.push(Kind::contact(self.bit(), false).at(Place::default()));
        }
        Rung::new(line, end)
    }

    fn output(&mut self) -> Output {
        let operand = self.bit();
        let kind = match self.random.below(7) {
            0 => OutputKind::Set(operand),
            1 => OutputKind::Reset(operand),
            2 => OutputKind::AssignNegated(operand),
            3 => OutputKind::AssignEdge { falling: self.random.chance(2), operand },
            _ => OutputKind::Assign(operand),
        };
        kind.at(Place::default())
    }

    /// Elements in series; what acts on the line to its left does not stand first.
    fn line(&mut self, depth: u32, first: bool) -> Vec<Element> {
        let mut line: Vec<Element> = Vec::new();
        for _ in 0..1 + self.random.below(3) {
            let alone = first && line.is_empty();
            let kind = self.element(depth, alone);
            line.push(kind.at(Place::default()));
        }
        line
    }

    fn element(&mut self, depth: u32, alone: bool) -> Kind {
        let fbd = self.drawing == Drawing::Fbd;
        match self.random.below(14) {
            0 | 1 if depth > 0 => {
                let branches =
                    (0..2 + self.random.below(2)).map(|_| Branch { line: self.line(depth - 1, true), bracketed: false }).collect();
                Kind::Parallel { branches, negated: fbd && self.random.chance(3) }
            }
            2 if fbd && depth > 0 => {
                let inputs = (0..2).map(|_| XorInput { line: self.line(depth - 1, true), negated: false }).collect();
                Kind::Xor { inputs, negated: self.random.chance(3) }
            }
            3 if !alone => Kind::Not,
            4 if !alone => Kind::Midline { operand: self.bit(), negated: fbd && self.random.chance(2) },
            5 => Kind::EdgeBox { falling: self.random.chance(2), operand: self.bit(), memory: None },
            6 => {
                let pins = vec![self.pin("IN1", depth), self.pin("IN2", depth)];
                self.named("GT", pins, Vec::new())
            }
            7 => {
                let output = (None, self.number());
                let pins = vec![self.pin("IN1", depth), self.pin("IN2", depth)];
                self.named("ADD", pins, vec![output])
            }
            8 if fbd && self.tapped => Kind::Parallel {
                branches: vec![
                    Branch { line: vec![Kind::Tap { negated: self.random.chance(2) }.at(Place::default())], bracketed: false },
                    Branch { line: vec![Kind::contact(self.bit(), false).at(Place::default())], bracketed: false },
                ],
                negated: false,
            },
            _ => Kind::contact(self.bit(), self.random.chance(2)),
        }
    }

    fn named(&mut self, name: &str, inputs: Vec<NamedInput>, outputs: Vec<(Option<Operand>, Operand)>) -> Kind {
        Kind::Named(Box::new(NamedBox { name: Operand::from(name), instance: None, inputs, outputs, power: None, flow: None }))
    }

    /// A number, a constant, or a box that gives one.
    fn pin(&mut self, name: &str, depth: u32) -> NamedInput {
        let line = match self.random.below(6) {
            0 => vec![Kind::contact(self.random.below(100).to_string(), false).at(Place::default())],
            1 if depth > 0 => {
                let pins = vec![self.pin("IN1", 0), self.pin("IN2", 0)];
                vec![self.named("ADD", pins, Vec::new()).at(Place::default())]
            }
            _ => vec![Kind::contact(self.number(), false).at(Place::default())],
        };
        NamedInput { name: Some(Operand::from(name)), negated: false, line }
    }
}

/// What a drawing says, element by element.
#[derive(Default)]
struct Drawn {
    bits: [bool; BITS],
    numbers: [i16; NUMBERS],
    /// What the edges saw, in the order in which they stand in the text.
    edges: Vec<bool>,
    edge: usize,
    drawing: Option<Drawing>,
    tap: bool,
}

impl Drawn {
    fn bit_of(operand: &Operand) -> usize {
        operand.text[1..].parse().expect("b and a number")
    }

    /// A value of a pin, and whether its box went well.
    fn number(&mut self, line: &[Element]) -> i16 {
        match &line[0].kind {
            Kind::Contact { operand, .. } => match operand.text.strip_prefix('n') {
                Some(index) => self.numbers[index.parse::<usize>().expect("n and a number")],
                None => operand.text.parse().expect("a constant"),
            },
            Kind::Named(one) => {
                let [a, b] = [0, 1].map(|index| self.number(&one.inputs[index].line));
                a.wrapping_add(b)
            }
            _ => unreachable!("pins are numbers and boxes"),
        }
    }

    fn edge(&mut self, now: bool, falling: bool) -> bool {
        if self.edges.len() <= self.edge {
            self.edges.resize(self.edge + 1, false);
        }
        let now = now != falling;
        let was = std::mem::replace(&mut self.edges[self.edge], now);
        self.edge += 1;
        now && !was
    }

    /// Passes over the edges of a part that is not executed.
    fn skip(&mut self, network: &Network) {
        fn in_line(line: &[Element]) -> usize {
            line.iter()
                .map(|element| match &element.kind {
                    Kind::EdgeBox { .. } => 1,
                    Kind::Parallel { branches, .. } => branches.iter().map(|branch| in_line(&branch.line)).sum(),
                    Kind::Xor { inputs, .. } => inputs.iter().map(|input| in_line(&input.line)).sum(),
                    Kind::Group { line, .. } => in_line(line),
                    _ => 0,
                })
                .sum()
        }
        fn in_rung(rung: &Rung) -> usize {
            in_line(&rung.line)
                + match &rung.end {
                    End::Open => 0,
                    End::Outputs(outputs) => outputs.iter().filter(|output| matches!(output.kind, OutputKind::AssignEdge { .. })).count(),
                    End::Branches(rungs) => rungs.iter().map(in_rung).sum(),
                }
        }
        if let Content::Rung(rung) = &network.content {
            self.edge += in_rung(rung);
        }
    }

    fn line(&mut self, line: &[Element], from: bool) -> bool {
        let mut value = from;
        for element in line {
            value = self.element(&element.kind, value);
        }
        value
    }

    fn element(&mut self, kind: &Kind, line: bool) -> bool {
        match kind {
            Kind::Contact { operand, negated } => line & (self.bits[Self::bit_of(operand)] != *negated),
            Kind::Parallel { branches, negated } => {
                let ladder = self.drawing == Some(Drawing::Lad);
                let mut any = false;
                for branch in branches {
                    any |= self.line(&branch.line, if ladder { line } else { true });
                }
                if ladder { any } else { line & (any != *negated) }
            }
            Kind::Xor { inputs, negated } => {
                let mut odd = false;
                for input in inputs {
                    odd ^= self.line(&input.line, true) != input.negated;
                }
                line & (odd != *negated)
            }
            Kind::Group { line: inner, negated } => line & (self.line(inner, true) != *negated),
            Kind::Tap { negated } => line & (self.tap != *negated),
            Kind::Not => !line,
            Kind::Midline { operand, negated } => {
                self.bits[Self::bit_of(operand)] = line;
                line != *negated
            }
            Kind::EdgeBox { falling, operand, .. } => {
                let now = self.bits[Self::bit_of(operand)];
                self.edge(now, *falling) & line
            }
            Kind::Named(one) => {
                let [a, b] = [0, 1].map(|index| self.number(&one.inputs[index].line));
                if one.name == "GT" {
                    return line && a > b;
                }
                if !line {
                    return false;
                }
                let index: usize = one.outputs[0].1.text[1..].parse().expect("n and a number");
                self.numbers[index] = a.wrapping_add(b);
                a.checked_add(b).is_some()
            }
            _ => unreachable!("the maker does not make it"),
        }
    }

    /// Where the rung jumps to.
    fn rung(&mut self, rung: &Rung, from: bool) -> Option<String> {
        let reads = sieben_lang::network::write::reads_tap(&rung.line);
        let value = self.line(&rung.line, from || reads);
        match &rung.end {
            End::Open => None,
            End::Branches(rungs) => {
                let outer = std::mem::replace(&mut self.tap, value);
                rungs.iter().for_each(|rung| drop(self.rung(rung, value)));
                self.tap = outer;
                None
            }
            End::Outputs(outputs) => {
                for output in outputs {
                    match &output.kind {
                        OutputKind::Assign(operand) => self.bits[Self::bit_of(operand)] = value,
                        OutputKind::AssignNegated(operand) => self.bits[Self::bit_of(operand)] = !value,
                        OutputKind::AssignEdge { falling, operand } => self.bits[Self::bit_of(operand)] = self.edge(value, *falling),
                        OutputKind::Set(operand) => self.bits[Self::bit_of(operand)] |= value,
                        OutputKind::Reset(operand) => self.bits[Self::bit_of(operand)] &= !value,
                        OutputKind::Jump(label) if value => return Some(label.text.clone()),
                        OutputKind::JumpNot(label) if !value => return Some(label.text.clone()),
                        _ => {}
                    }
                }
                None
            }
        }
    }

    fn scan(&mut self, networks: &[Network]) {
        self.edge = 0;
        let mut awaited: Option<String> = None;
        for network in networks {
            if awaited.is_some() && network.label.as_ref().map(|label| label.text.clone()) != awaited {
                self.skip(network);
                continue;
            }
            awaited = None;
            if let Content::Rung(rung) = &network.content {
                awaited = self.rung(rung, true);
            }
        }
    }
}

#[test]
fn random_networks_are_the_same_as_text_and_do_what_they_show() {
    for seed in 0..60 {
        let drawing = if seed % 2 == 0 { Drawing::Lad } else { Drawing::Fbd };
        let mut maker = Maker { random: Random(seed), drawing, tapped: false };
        let networks: Vec<Network> = (0..NETWORKS).map(|index| maker.network(index)).collect();
        let word = if drawing == Drawing::Lad { "LD" } else { "FBD" };
        let declarations = "VAR\n    b0, b1, b2, b3, b4, b5, b6, b7 : BOOL;\n    n0, n1, n2 : INT;\nEND_VAR\n";
        let (mut form_a, mut form_b) = (format!("PROGRAM Main\n{declarations}{word}\n"), format!("PROGRAM Main\n{declarations}{word}\n"));
        for network in &networks {
            let text = form_a::print(network, drawing, &|_, _| (Vec::new(), None));
            let parsed = form_a::parse(&text, 0, text.len(), Flavour::Iec);
            assert!(parsed.mistakes.is_empty(), "{text}{:?}", parsed.mistakes);
            assert_eq!(&parsed.network, network, "{text}");
            let _ = write!(form_a, "NETWORK\n{text}");
            let line = form_b::print(network, drawing);
            let parsed = form_b::parse(&line, 0, Flavour::Iec).unwrap_or_else(|mistake| panic!("{line}: {mistake:?}"));
            assert_eq!(&parsed, network, "{line}");
            let _ = writeln!(form_b, "{line}");
        }
        let programs: Vec<(&str, String)> = vec![("form A", form_a + "END_PROGRAM\n"), ("form B", form_b + "END_PROGRAM\n")];
        for (form, text) in &programs {
            for (engine, mut running) in Running::on_engines(text, Dialect::Iec) {
                let mut random = Random(seed + 1000);
                let mut drawn = Drawn { drawing: Some(drawing), ..Drawn::default() };
                for scan in 0..24 {
                    for index in 0..BITS {
                        if random.chance(3) {
                            let value = random.chance(2);
                            drawn.bits[index] = value;
                            running.set(&format!("Main.b{index}"), if value { "1" } else { "0" });
                        }
                    }
                    drawn.scan(&networks);
                    running.scan(10_000);
                    let bits = (0..BITS).map(|index| running.get(&format!("Main.b{index}")) == "1");
                    let numbers = (0..NUMBERS).map(|index| running.get(&format!("Main.n{index}")));
                    let shown: (Vec<bool>, Vec<String>) = (bits.collect(), numbers.collect());
                    let wanted = (drawn.bits.to_vec(), drawn.numbers.map(|number| number.to_string()).to_vec());
                    assert_eq!(shown, wanted, "seed {seed}, {form}, [{engine}], scan {scan}\n{text}");
                }
            }
        }
    }
}
