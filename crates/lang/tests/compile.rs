//! Sources beside what the compiler says about them: `diagnostics.txt` and `layout.txt`.
//!
//! A case is `=== title`, the source, `---`, and what should come of it. A symbol table stands before the source as
//! lines `# name, address, type`; `# extended` lets it use extension words. When a table does not match, the test prints the whole table as it would be right.

use std::fmt::Write as _;

use proptest::prelude::*;
use sieben_lang::{Compiled, Options, compile};
use sieben_model::block::{BlockAttributes, BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, SystemBlock, Variable};
use sieben_model::source::{FileId, Sources, Span};
use sieben_model::symbols::{Symbol, SymbolTable};
use sieben_model::types::{DataType, Structure};

fn system_blocks() -> Vec<SystemBlock> {
    let mut blocks = Vec::new();
    blocks.push(SystemBlock {
        block: BlockId::new(BlockKind::SystemFunction, 46),
        name: "STP",
        interface: Interface::default(),
        only: None,
    });
    let parameter = |name: &str, section, data_type, offset| Variable {
        name: name.to_owned(),
        section,
        data_type,
        offset,
        initial: Vec::new(),
        comment: String::new(),
        span: Span::default(),
    };
    blocks.push(SystemBlock {
        block: BlockId::new(BlockKind::SystemFunction, 20),
        name: "BLKMOV",
        interface: Interface {
            variables: vec![
                parameter("SRCBLK", Section::Input, DataType::Any, 0),
                parameter("DSTBLK", Section::Output, DataType::Any, 1),
                parameter("RET_VAL", Section::Return, DataType::Int, 2),
            ],
            ..Interface::default()
        },
        only: None,
    });
    blocks
}

/// The source of a case without its symbol lines, compiled.
fn compile_case(source: &str) -> (Sources, Compiled) {
    let mut symbols = SymbolTable::default();
    let mut text = String::new();
    let mut extended = false;
    for line in source.lines() {
        match line.strip_prefix("# ") {
            Some("extended") => extended = true,
            Some(row) => {
                let mut columns = row.split(',').map(|column| column.trim().to_owned());
                let mut next = || columns.next().unwrap_or_default();
                symbols.push(Symbol { name: next(), address: next(), data_type: next(), ..Symbol::default() });
            }
            None => {
                text.push_str(line);
                text.push('\n');
            }
        }
    }
    let mut sources = Sources::default();
    sources.add("case.awl", text);
    let options = Options { system_blocks: system_blocks(), extended, ..Options::default() };
    let compiled = compile(&sources, &symbols, &options);
    (sources, compiled)
}

fn diagnostics(source: &str) -> String {
    let (sources, compiled) = compile_case(source);
    let mut text = String::new();
    for diagnostic in &compiled.diagnostics {
        let (line, column) = sources.line_column(diagnostic.span);
        let _ = writeln!(text, "{line}:{column} {} {}", diagnostic.problem.code(), diagnostic.message);
    }
    if text.is_empty() { "nothing\n".to_owned() } else { text }
}

fn fields(text: &mut String, structure: &Structure, prefix: &str, base: u32) {
    for field in &structure.fields {
        let at = base + field.offset;
        let _ = writeln!(text, "  {}.{} {prefix}{} {} bits", at / 8, at % 8, field.name, field.data_type.bits());
        if let DataType::Struct(inner) | DataType::Instance { structure: inner, .. } = &field.data_type {
            fields(text, inner, &format!("{prefix}{}.", field.name), at);
        }
    }
}

fn layout(source: &str) -> String {
    let (_, compiled) = compile_case(source);
    let mut text = String::new();
    for block in compiled.program.data.values() {
        let _ = writeln!(text, "DB {}: {} bytes", block.number, block.image.len());
        fields(&mut text, &block.structure, "", 0);
        for (row, bytes) in block.image.chunks(16).enumerate() {
            let hex: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
            let _ = writeln!(text, "  {:>3}: {}", row * 16, hex.join(" "));
        }
    }
    for (id, block) in &compiled.program.code {
        if block.interface.variables.is_empty() {
            continue;
        }
        let _ = writeln!(text, "{id}: instance {}, local {}", block.interface.instance_size, block.interface.local_size);
        for variable in &block.interface.variables {
            let (byte, bit) = (variable.offset / 8, variable.offset % 8);
            let parameter_of_fc = id.kind == BlockKind::Function && variable.section != Section::Temp;
            let place = if parameter_of_fc { format!("#{}", variable.offset) } else { format!("{byte}.{bit}") };
            let _ = writeln!(text, "  {place} {:?} {}", variable.section, variable.name);
        }
    }
    for diagnostic in &compiled.diagnostics {
        let _ = writeln!(text, "{} {}", diagnostic.problem.code(), diagnostic.message);
    }
    text
}

/// The sources and results of a table.
fn cases(table: &str) -> Vec<(&str, &str, &str)> {
    table
        .split("=== ")
        .skip(1)
        .map(|case| {
            let (title, rest) = case.split_once('\n').expect("a title line");
            let (source, result) = rest.split_once("---\n").expect("a line `---` behind the source");
            (title, source, result)
        })
        .collect()
}

fn check(table: &str, result: fn(&str) -> String) {
    let mut right = String::new();
    let mut wrong = Vec::new();
    for (title, source, expected) in cases(table) {
        let actual = result(source);
        if actual.trim_end() != expected.trim_end() {
            wrong.push(title);
        }
        let _ = write!(right, "=== {title}\n{source}---\n{}\n\n", actual.trim_end());
    }
    assert!(wrong.is_empty(), "these cases differ: {wrong:?}; the table would be\n<<<\n{right}>>>");
}

#[test]
fn diagnostics_are_as_the_table_says() {
    check(include_str!("diagnostics.txt"), diagnostics);
}

#[test]
fn layouts_are_as_the_table_says() {
    check(include_str!("layout.txt"), layout);
}

#[test]
fn nothing_that_is_deleted_makes_the_compiler_panic() {
    for table in [include_str!("diagnostics.txt"), include_str!("layout.txt")] {
        for (_, source, _) in cases(table) {
            let lines: Vec<&str> = source.lines().collect();
            for missing in 0..lines.len() {
                let mut rest = lines.clone();
                rest.remove(missing);
                compile_case(&rest.join("\n"));
                compile_case(&lines[..missing].join("\n"));
            }
        }
    }
}

#[test]
fn a_block_may_stand_in_any_file_and_order() {
    let mut sources = Sources::default();
    sources.add("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1 (x := MW 10);\nEND_ORGANIZATION_BLOCK\n");
    sources.add("fc.awl", "FUNCTION FC 1 : VOID\nVAR_INPUT\nx : WORD;\nEND_VAR\nBEGIN\nL #x;\nEND_FUNCTION\n");
    let compiled = compile(&sources, &SymbolTable::default(), &Options::default());
    assert_eq!(compiled.diagnostics, []);
    assert_eq!(compiled.program.code.len(), 2);
}

#[test]
fn one_file_alone_is_not_blamed_for_what_others_may_define() {
    let mut sources = Sources::default();
    sources.add("part.awl", "FUNCTION FC 1 : VOID\nBEGIN\nCALL FC 200;\nA \"Start\";\nOPN DB 7;\nEND_FUNCTION\n");
    let options = Options { syntax_only: true, ..Options::default() };
    assert_eq!(compile(&sources, &SymbolTable::default(), &options).diagnostics, []);
    let all = compile(&sources, &SymbolTable::default(), &Options::default());
    let codes: Vec<&str> = all.diagnostics.iter().map(|diagnostic| diagnostic.problem.code()).collect();
    assert_eq!(codes, ["P3013", "P3008", "P3020", "P3018"]);
}

#[test]
fn two_blocks_with_one_number_are_reported_at_both_places() {
    let mut sources = Sources::default();
    sources.add("a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n");
    sources.add("b.awl", "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n");
    let compiled = compile(&sources, &SymbolTable::default(), &Options::default());
    let doubled = compiled.diagnostics.iter().filter(|diagnostic| diagnostic.problem.code() == "P3002");
    assert_eq!(doubled.map(|diagnostic| diagnostic.span.file).collect::<Vec<_>>(), [FileId(0), FileId(1)]);
}

#[test]
fn a_hundred_thousand_statements_are_compiled() {
    let mut text = String::from("ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n t : INT;\nEND_VAR\nBEGIN\n");
    for index in 0..10_000 {
        let (byte, bit) = (index % 1000, index % 8);
        let label = format!("{}{:03}", char::from(b'a' + (index / 1000) as u8), index % 1000);
        let _ = write!(
            text,
            "A \"Start\";\nAN I {byte}.{bit};\nJC {label};\nL MW {byte};\nL #t;\n+I;\nT \"Data\".list[{}];\nSET;\n= Q {byte}.{bit};\n{label}: NOP 0;\n",
            index % 100
        );
    }
    text.push_str("END_ORGANIZATION_BLOCK\nDATA_BLOCK DB 1\nSTRUCT\n list : ARRAY [0..99] OF INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n");
    let mut sources = Sources::default();
    sources.add("large.awl", text);
    let symbol = |name: &str, address: &str| Symbol { name: name.into(), address: address.into(), ..Symbol::default() };
    let symbols = SymbolTable::new(vec![symbol("Start", "I 0.0"), symbol("Data", "DB 1")]);
    let compiled = compile(&sources, &symbols, &Options::default());
    let said: Vec<&str> = compiled.diagnostics.iter().take(3).map(|diagnostic| diagnostic.message.as_str()).collect();
    assert_eq!(said, ["`OB 1` has at least 329762 bytes of code in a CPU; a block of CPU 315-2PN/DP has at most 65536"]);
    assert_eq!(compiled.program.code[&BlockId::ob(1)].code.statement_count(), 100_001, "the end of the block counts");
}

#[test]
fn a_name_that_was_meant_is_offered_as_it_is_written() {
    let (_, compiled) = compile_case("# Start, I 0.0, BOOL\nA \"Strat\"\n");
    let fix = compiled.diagnostics[0].fix.as_ref().expect("a fix");
    assert_eq!(fix.replacement, "\"Start\"");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn no_mixture_of_sources_makes_the_compiler_panic(
        pieces in prop::collection::vec((0usize..64, 0usize..4096, 1usize..200), 1..12),
    ) {
        let tables = [include_str!("diagnostics.txt"), include_str!("layout.txt")];
        let all: Vec<&str> = tables.iter().flat_map(|table| cases(table)).map(|(_, source, _)| source).collect();
        let mut text = String::new();
        for (case, start, length) in pieces {
            let source = all[case % all.len()];
            let words: Vec<&str> = source.split_inclusive([' ', '\n']).collect();
            text.extend(words.iter().skip(start % words.len()).take(length).copied());
            text.push('\n');
        }
        compile_case(&text);
    }
}

#[test]
fn a_function_has_as_many_parameters_as_a_call_can_hold() {
    for (count, fits) in [(16_384, true), (16_385, false), (70_000, false)] {
        let names: String = (0..count).map(|n| format!("p{n}:BOOL;\n")).collect();
        let actual: Vec<String> = (0..count).map(|n| format!("p{n}:=M 0.0")).collect();
        let mut sources = Sources::default();
        let text = format!(
            "FUNCTION FC 1 : VOID\nVAR_INPUT\n{names}END_VAR\nBEGIN\nA #p0;\nEND_FUNCTION\n\
             ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1 ({});\nEND_ORGANIZATION_BLOCK\n",
            actual.join(",")
        );
        sources.add("many.awl", text);
        let compiled = compile(&sources, &SymbolTable::default(), &Options::default());
        let refused = compiled.diagnostics.iter().any(|diagnostic| diagnostic.problem == sieben_model::problems::Problem::P5002);
        assert_eq!((compiled.has_errors(), refused), (!fits, !fits), "{count}: {:?}", compiled.diagnostics.first());
    }
}

#[test]
fn a_knot_of_jumps_is_compiled_in_reasonable_time() {
    // Every statement writes a variable of its own and jumps back, so that the paths can hardly be followed.
    let count = 1_500;
    let names: String = (0..count).map(|n| format!("v{n}:INT;\n")).collect();
    let label = |n: usize| {
        format!("a{}{}{}", (b'a' + (n / 676 % 26) as u8) as char, (b'a' + (n / 26 % 26) as u8) as char, (b'a' + (n % 26) as u8) as char)
    };
    let body: String = (0..count)
        .map(|n| format!("{}: T #v{n}; L #v{}; A I 0.0; JC {};\n", label(n), (n * 7) % count, label((n * 31 + 17) % count)))
        .collect();
    let mut sources = Sources::default();
    sources.add("knot.awl", format!("FUNCTION FC 1 : VOID\nVAR_TEMP\n{names}END_VAR\nBEGIN\n{body}END_FUNCTION\n"));
    // A CPU whose blocks may have that many local data.
    let cpu = sieben_model::cpu_type::CpuType::by_name("416-3");
    for temporaries in [sieben_lang::TemporaryReads::Certain, sieben_lang::TemporaryReads::Possible] {
        let compiled = compile(&sources, &SymbolTable::default(), &Options { temporaries, cpu, ..Options::default() });
        assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics.first());
    }
}

#[test]
fn types_without_a_byte_are_not_visited_one_by_one() {
    // FB 1 has no data, and each other block two instances of the one before: 2^30 instances in 0 bytes.
    let mut text = String::from("FUNCTION_BLOCK FB 1\nBEGIN\nEND_FUNCTION_BLOCK\n");
    for number in 2..=30 {
        let inner = number - 1;
        let _ = writeln!(text, "FUNCTION_BLOCK FB {number}\nVAR\n a : FB {inner}; b : FB {inner};\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK");
    }
    text.push_str("FUNCTION_BLOCK FB 31\nVAR\n a : FB 30; n : INT := 7;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 31\nBEGIN\nEND_DATA_BLOCK\n");
    let (_, compiled) = compile_case(&text);
    let errors: Vec<_> =
        compiled.diagnostics.iter().filter(|found| found.severity() == sieben_model::diagnostic::Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:?}");
    assert_eq!(compiled.program.data[&1].image, [0, 7]);
}

#[test]
fn what_headers_say_reaches_the_program() {
    const STL: &str = "FUNCTION FC 1 : VOID\nTITLE = Dosing of sand\nAUTHOR : 'Meyer'\nFAMILY : Plant\nNAME : DOSE\nVERSION : 2.11\nKNOW_HOW_PROTECT\n\
         BEGIN\nNETWORK\n L 1;\n T MW 0;\nEND_FUNCTION\n\
         FUNCTION FC 2 : VOID\nVERSION : new\nBEGIN\nNETWORK\n L 1;\nNETWORK LAD\n    NO I 0.0\n    COIL Q 0.0\nEND_FUNCTION\n\
         FUNCTION FC 3 : VOID\nBEGIN\nNETWORK FBD\n    NO I 0.0\n    COIL Q 0.0\nNETWORK LAD\n    NO I 0.0\n    COIL Q 0.0\nEND_FUNCTION\n\
         DATA_BLOCK DB 1\nAUTHOR : Meyer\nVERSION : 1.0\nNON_RETAIN\nSTRUCT a : INT; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
    const SCL: &str = "FUNCTION_BLOCK FB7\nTITLE = 'Mixer'\nVERSION : '1.2'\nAUTHOR : Huber\nFAMILY : mix\nNAME : MIX\nKNOW_HOW_PROTECT\n\
         BEGIN\n;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB7 FB7\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB1\nVAR_TEMP info : ARRAY[0..19] OF BYTE; END_VAR\nBEGIN\nFB7.DB7();\nEND_ORGANIZATION_BLOCK\n";
    const ST: &str = "PROGRAM Main\nVAR n : INT; END_VAR\nn := n + 1;\nEND_PROGRAM\n";
    let of = |files: &[(&str, &str)]| {
        let mut sources = Sources::default();
        for (name, text) in files {
            sources.add(*name, *text);
        }
        let program = compile(&sources, &SymbolTable::default(), &Options::default()).program;
        let line = |(id, of): (&BlockId, &BlockAttributes)| {
            let (major, minor) = of.version;
            let protected = if of.know_how_protected { " protected" } else { "" };
            let bytes = program.code.get(id).and_then(|code| code.mc7_bytes).map_or(String::new(), |bytes| format!(" {bytes} bytes"));
            format!("{id} {:?}/{}/{}/{}/{} {major}.{minor}{protected}{bytes}", of.language, of.title, of.author, of.family, of.name)
        };
        program.attributes.iter().map(line).collect::<Vec<_>>()
    };
    assert_eq!(
        of(&[("a.awl", STL), ("b.scl", SCL)]),
        [
            "OB 1 Scl//// 0.1",
            "FC 1 Stl/Dosing of sand/Meyer/Plant/DOSE 2.11 protected 8 bytes",
            "FC 2 Stl//// 0.1 10 bytes",
            "FC 3 Fbd//// 0.1 10 bytes",
            "FB 7 Scl/Mixer/Huber/mix/MIX 1.2 protected",
            "DB 1 Data//Meyer// 1.0",
            "DB 7 Data//// 0.1",
        ]
    );
    let made = of(&[("c.st", ST)]);
    assert_eq!(made[0], "OB 1 St//// 0.1", "{made:?}");
}
