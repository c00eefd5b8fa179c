//! Programs beside their reference data: `cases.txt`, and what holds for every program.
//!
//! A case is `=== title`, the source, `---`, and what should come of it. A symbol table stands before the source as
//! lines `# name, address, type`. When the table does not match, the test prints the whole of it as it would be right.

use std::fmt::Write as _;

use proptest::prelude::*;
use sieben_ide::assignment_list::{AssignmentList, BitUse, PartOf};
use sieben_ide::call_structure::{CallStructure, Callee};
use sieben_ide::cross_reference::{CrossReference, Reference};
use sieben_ide::target::{Memory, Target};
use sieben_ide::unused::Unused;
use sieben_lang::stl::operands::{Actual, Location, NumberOperand, Operand};
use sieben_lang::{CheckedBody, Compiled, Options, compile};
use sieben_model::address;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Sources;
use sieben_model::symbols::{Symbol, SymbolTable};

fn compile_case(source: &str) -> (Compiled, SymbolTable) {
    let mut symbols = SymbolTable::default();
    let mut text = String::new();
    for line in source.lines() {
        match line.strip_prefix("# ") {
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
    (compile(&sources, &symbols, &Options::default()), symbols)
}

/// Everything that is said about a program, a line each.
fn render(compiled: &Compiled, symbols: &SymbolTable) -> String {
    const ENGLISH: Mnemonics = Mnemonics::English;
    let mut text = String::new();
    let references = CrossReference::new(compiled);
    let overlaps = references.overlaps();
    for (target, uses) in references.entries() {
        let _ = write!(text, "{}", target.spell(ENGLISH));
        if let Some(symbol) = target.symbol(symbols, &compiled.program.data) {
            let _ = write!(text, " ({symbol})");
        }
        for reference in uses {
            let parameter = reference.parameter.as_ref().map_or(String::new(), |name| format!(" {name}"));
            let Reference { usage, block, network, statement, .. } = reference;
            let _ = write!(text, "; {} {block} {network}/{statement}{parameter}", usage.word());
        }
        if let Target::Memory(memory) = target {
            let others: Vec<String> = overlaps.of(memory).into_iter().map(|other| Target::Memory(other).spell(ENGLISH)).collect();
            if !others.is_empty() {
                let _ = write!(text, "; overlaps {}", others.join(", "));
            }
        }
        text.push('\n');
    }
    let structure = CallStructure::new(compiled);
    for (mark, roots) in [("", &structure.roots), ("x ", &structure.not_called)] {
        for &root in roots {
            for line in structure.tree(root) {
                let callee = match &line.callee {
                    Callee::Block(block) => block.to_string(),
                    Callee::Unknown(target) => target.spell(ENGLISH),
                };
                let call = line.site.map_or(String::new(), |site| {
                    let instance = site.instance.as_ref().map_or(String::new(), |target| format!(", {}", target.spell(ENGLISH)));
                    format!(" {}{instance}", site.kind.word())
                });
                let _ = writeln!(text, "{mark}{}{callee}{call} {} {} {:?}", "> ".repeat(line.depth), line.own, line.local_data, line.mark);
            }
            let caller = &structure.blocks[&root];
            let _ = writeln!(
                text,
                "{mark}{root}: {} bytes, {} deep, recursive {}",
                caller.path_local_data, caller.path_depth, caller.recursive
            );
        }
    }
    let list = AssignmentList::new(&references);
    for (area, used) in &list.areas {
        for (number, byte) in &used.bytes {
            let bits: String = byte
                .bits
                .iter()
                .rev()
                .map(|bit| match bit {
                    BitUse::None => '.',
                    BitUse::Pointer => 'p',
                    BitUse::Wider => 'o',
                    BitUse::Direct => 'X',
                })
                .collect();
            let widths: String = [byte.byte, byte.word, byte.double_word]
                .map(|part| match part {
                    PartOf::None => '.',
                    PartOf::Inside => '|',
                    PartOf::First => 'X',
                })
                .iter()
                .collect();
            let _ = writeln!(text, "{}B {number} {bits} {widths}", area.prefix(ENGLISH));
        }
        for reference in &used.indirect {
            let _ = writeln!(text, "{} indirect: {}", area.prefix(ENGLISH), reference.target.spell(ENGLISH));
        }
    }
    for (letter, used) in [("T", &list.timers), ("C", &list.counters)] {
        if !used.is_empty() {
            let numbers: Vec<String> = used.iter().map(u16::to_string).collect();
            let _ = writeln!(text, "{letter} used: {}", numbers.join(" "));
        }
    }
    let unused = Unused::new(compiled, &references, symbols);
    for symbol in &unused.symbols {
        let _ = writeln!(text, "unused: {} {}", symbol.symbol.name, symbol.symbol.address);
    }
    for (target, _, count) in &unused.addresses {
        let _ = writeln!(text, "without a symbol: {} ×{count}", target.spell(ENGLISH));
    }
    text
}

#[test]
fn reference_data_is_what_the_cases_say() {
    let cases = include_str!("cases.txt").replace("\r\n", "\n");
    let mut right = String::new();
    for case in cases.split("=== ").skip(1) {
        let (title, rest) = case.split_once('\n').expect("a case has a title");
        let (source, _) = rest.split_once("---\n").expect("a case has `---`");
        let (compiled, symbols) = compile_case(source);
        assert!(!compiled.has_errors(), "{title}: {:?}", compiled.diagnostics);
        let _ = write!(right, "=== {title}\n{source}---\n{}\n", render(&compiled, &symbols));
    }
    assert!(right.trim_end() == cases.trim_end(), "cases.txt would be right as\n{right}");
}

/// How many references an operand must have: itself, and each pointer on the way.
fn expected(operand: &Operand) -> usize {
    fn places(location: &Location) -> usize {
        match location {
            Location::MemoryIndirect { pointer, .. } => 1 + places(pointer),
            _ => 1,
        }
    }
    match operand {
        Operand::Memory(access) => places(&access.location),
        Operand::Timer(_) | Operand::Counter(_) | Operand::ParameterAddress(_) => 1,
        Operand::Block(block) => usize::from(block.number != NumberOperand::Fixed(0)),
        Operand::Call(call) => {
            let actuals = call.parameters.iter().filter_map(|parameter| parameter.actual.as_ref());
            let of_actual = |actual: &Actual| match actual {
                Actual::Memory(access) => places(&access.location),
                Actual::Complex { location: place, .. } => places(place),
                Actual::Timer(_) | Actual::Counter(_) | Actual::Block(_) => 1,
                Actual::Constant(_) => 0,
            };
            1 + usize::from(call.instance.is_some()) + actuals.map(of_actual).sum::<usize>()
        }
        // An area-crossing pointer names memory.
        Operand::Constant(Value::Pointer(pointer)) => usize::from((0x80..=0x87).contains(&(pointer >> 24))),
        _ => 0,
    }
}

/// What holds for the reference data of every program.
fn check(compiled: &Compiled, symbols: &SymbolTable) {
    let all = CrossReference::new(compiled);
    let mut count = 0;
    for (&id, body) in &compiled.bodies {
        let CheckedBody::Stl(block) = &**body else { continue };
        let references = compiled.references(id);
        count += references.len();
        for (index, statement) in block.statements.iter().enumerate() {
            let found = references.iter().filter(|reference| reference.statement == index + 1);
            let found = found.inspect(|reference| {
                assert_eq!((reference.instruction, reference.network), (Some(statement.instruction.into()), statement.origin.network()))
            });
            assert!(found.count() >= expected(&statement.operand), "{} statement {}: {statement:?}", block.id, index + 1);
        }
    }
    assert_eq!(count, all.references.len());
    assert_eq!(count, all.entries().map(|(_, uses)| uses.len()).sum::<usize>());
    // What is printed can be asked for.
    for (target, _) in all.entries() {
        if let Some(operand) = target.operand() {
            for mnemonics in [Mnemonics::English, Mnemonics::German] {
                assert_eq!(address::Operand::parse(&target.spell(mnemonics)), Some(operand), "{target:?}");
            }
            assert_eq!(&Target::from(operand), target);
        }
    }
    // Overlaps are those that comparing every two addresses finds.
    let addresses: Vec<Memory> =
        all.entries().filter_map(|(target, _)| if let Target::Memory(memory) = target { Some(*memory) } else { None }).collect();
    let overlaps = all.overlaps();
    for memory in addresses.iter().take(200) {
        let naive: Vec<Memory> = addresses.iter().filter(|other| *other != memory && other.overlaps(memory)).copied().collect();
        assert_eq!(overlaps.of(memory), naive, "{memory:?}");
    }
    let structure = CallStructure::new(compiled);
    let calls: usize = structure.blocks.values().map(|caller| caller.calls.len()).sum();
    let mut shown = std::collections::BTreeSet::new();
    for &root in structure.roots.iter().chain(&structure.not_called) {
        let lines = structure.tree(root);
        assert!(lines.len() <= calls + 1, "the tree of {root} has more lines than there are calls");
        shown.extend(lines.into_iter().filter_map(|line| if let Callee::Block(block) = line.callee { Some(block) } else { None }));
    }
    assert!(structure.blocks.keys().all(|block| shown.contains(block)), "every block stands in a tree");
    let not_called: usize = structure.not_called_trees().iter().map(Vec::len).sum();
    assert!(not_called <= calls + structure.not_called.len(), "the trees of uncalled blocks repeat one another");
    let _ = AssignmentList::new(&all);
    let _ = Unused::new(compiled, &all, symbols);
}

#[test]
fn every_case_keeps_the_rules() {
    for case in include_str!("cases.txt").replace("\r\n", "\n").split("=== ").skip(1) {
        let source = case.split_once('\n').and_then(|(_, rest)| rest.split_once("---\n")).map_or(case, |(source, _)| source);
        let (compiled, symbols) = compile_case(source);
        check(&compiled, &symbols);
    }
}

/// First inputs of the fuzzer, whole and cut at every line.
#[test]
fn inputs_of_the_fuzzer_have_reference_data() {
    let inputs: [&[u8]; 5] = [
        include_bytes!("../../../fuzz-corpus/stl/arithmetic.awl"),
        include_bytes!("../../../fuzz-corpus/stl/blocks.awl"),
        include_bytes!("../../../fuzz-corpus/stl/cut.awl"),
        include_bytes!("../../../fuzz-corpus/stl/german.awl"),
        include_bytes!("../../../fuzz-corpus/stl/width-letter-before-a-wide-character.awl"),
    ];
    for input in inputs {
        let input = String::from_utf8_lossy(input);
        let ends = input.match_indices('\n').map(|(end, _)| end + 1).chain([input.len()]);
        for end in ends.step_by(3) {
            let (compiled, symbols) = compile_case(&input[..end]);
            check(&compiled, &symbols);
        }
    }
}

/// Statements of all kinds. Each compiles in every block of [`program`].
fn statement() -> impl Strategy<Value = String> {
    let select = |words: &[&'static str]| prop::sample::select(words.to_vec());
    let bits = ["I 0.0", "Q 4.7", "M 10.3", "DBX 2.1", "DB5.DBX 0.0", "L 0.5", "[AR1,P#0.1]", "M [MD 4]", "#flag"];
    let values = ["IW 2", "MD 8", "MB 10", "DBD 0", "DB5.DBW 0", "LW 20", "W [AR2,P#4.0]", "MW [LD 20]", "#value", "DB5.level", "#list[2]"];
    let blocks = [
        "UC FC 1",
        "CC FC 2",
        "UC FC [MW 2]",
        "OPN DB 5",
        "OPN DI [MW 4]",
        "OPN DB 0",
        "CALL FC 3(a := MW 10, b := Q 0.0, range := P#M 0.0 BYTE 4)",
        "CALL FC 3(a := #value, b := #flag, range := #list)",
        "CALL FB 1, DB 1(x := MW 2)",
        "UC FB 7",
        "LAR1 P#M 1.0",
        "LAR1 MD 8",
        "SE T 1",
        "CU C [MW 6]",
        "L C 3",
        "A T [MW 6]",
    ];
    let bits = (select(&["A", "ON", "=", "S", "FP"]), select(&bits)).prop_map(|(word, bit)| format!("{word} {bit}"));
    let values = (select(&["L", "T"]), select(&values)).prop_map(|(word, operand)| format!("{word} {operand}"));
    prop_oneof![2 => bits, 2 => values, 2 => select(&blocks).prop_map(str::to_owned)]
}

fn program() -> impl Strategy<Value = String> {
    let body = prop::collection::vec(statement(), 0..12);
    prop::collection::vec(body, 5).prop_map(|bodies| {
        let heads = [
            ("ORGANIZATION_BLOCK OB 1", "VAR_TEMP flag : BOOL; value : INT; list : ARRAY [0..3] OF INT; END_VAR", "END_ORGANIZATION_BLOCK"),
            ("FUNCTION FC 1 : VOID", "VAR_TEMP flag : BOOL; value : INT; list : ARRAY [0..3] OF INT; END_VAR", "END_FUNCTION"),
            ("FUNCTION FC 2 : VOID", "VAR_TEMP flag : BOOL; value : INT; list : ARRAY [0..3] OF INT; END_VAR", "END_FUNCTION"),
            (
                "FUNCTION FC 3 : VOID",
                "VAR_INPUT a : INT; range : ANY; END_VAR VAR_OUTPUT b : BOOL; END_VAR \
 VAR_TEMP flag : BOOL; value : INT; list : ARRAY [0..3] OF INT; END_VAR",
                "END_FUNCTION",
            ),
            (
                "FUNCTION_BLOCK FB 1",
                "VAR_INPUT x : INT; END_VAR VAR flag : BOOL; value : INT; list : ARRAY [0..3] OF INT; END_VAR",
                "END_FUNCTION_BLOCK",
            ),
        ];
        let mut text = String::from("DATA_BLOCK DB 5 STRUCT level : INT; END_STRUCT BEGIN END_DATA_BLOCK\n");
        for ((head, declarations, end), body) in heads.into_iter().zip(bodies) {
            let _ = write!(text, "{head}\n{declarations}\nBEGIN\nNETWORK\n");
            for statement in body {
                let _ = writeln!(text, "{statement};");
            }
            let _ = writeln!(text, "{end}");
        }
        text
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_operand_of_every_statement_is_in_the_cross_reference(source in program()) {
        let (compiled, symbols) = compile_case(&source);
        prop_assert_eq!(compiled.bodies.len(), 5, "{:?}", compiled.diagnostics);
        check(&compiled, &symbols);
    }
}

/// Takes minutes if each search looks at all addresses.
#[test]
fn one_long_range_does_not_make_every_search_long() {
    let mut source = String::from("DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY[0..9999] OF BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n");
    source.push_str("FUNCTION FC 1 : VOID\nVAR_INPUT\n a : ANY;\nEND_VAR\nBEGIN\nEND_FUNCTION\n");
    source.push_str("ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1 (a := P#DB1.DBX 0.0 BYTE 10000);\n");
    for position in 0..80_000 {
        let _ = writeln!(source, "A DB1.DBX {}.{};", position / 8, position % 8);
    }
    source.push_str("END_ORGANIZATION_BLOCK\n");
    let (compiled, _) = compile_case(&source);
    let references = CrossReference::new(&compiled);
    let overlaps = references.overlaps();
    let bits = references.entries().filter_map(|(target, _)| match target {
        Target::Memory(memory) => Some(overlaps.of(memory).len()),
        _ => None,
    });
    // Every bit with the range, and the range with every bit.
    assert_eq!(bits.sum::<usize>(), 160_000);
}
