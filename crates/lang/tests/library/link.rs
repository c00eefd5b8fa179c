//! How blocks of the library come into a program, and what every one of them keeps to.

use std::collections::BTreeSet;

use sieben_lang::description::describe;
use sieben_lang::library::{self, Selection};
use sieben_lang::stl::parser::parse;
use sieben_lang::{Compiled, Options, compile};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, SystemBlock};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::{Symbol, SymbolTable};

/// Local data that the smallest CPU types have for a whole priority class.
const LOCAL_BYTES_MAX: u32 = 256;

const DATA: &str = "DATA_BLOCK DB 1 STRUCT a : STRING; b : STRING; END_STRUCT BEGIN END_DATA_BLOCK\n";

fn compiled(text: &str, symbols: &[(&str, &str)], selection: Selection) -> (Compiled, Sources) {
    let mut sources = Sources::default();
    sources.add("main.awl", format!("{DATA}{text}"));
    let mut table = SymbolTable::default();
    for (name, address) in symbols {
        table.push(Symbol { name: (*name).to_owned(), address: (*address).to_owned(), ..Symbol::default() });
    }
    let options = Options { mnemonics: Some(Mnemonics::English), library: selection, ..Options::default() };
    let compiled = compile(&sources, &table, &options);
    compiled.add_library_sources(&mut sources);
    (compiled, sources)
}

fn ob1(call: &str) -> String {
    format!("ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL {call} (IN1 := DB1.a, IN2 := DB1.b, RET_VAL := DB1.a);\nEND_ORGANIZATION_BLOCK\n")
}

/// Number and name of the linked blocks.
fn linked(compiled: &Compiled) -> Vec<String> {
    compiled.library.iter().map(|linked| format!("{} = {}", linked.id, linked.block.name)).collect()
}

fn placed(name: &str, number: u16) -> Selection {
    Selection { numbers: [(name.to_owned(), BlockId::new(BlockKind::Function, number))].into(), ..Selection::default() }
}

#[test]
fn a_call_by_number_or_name_links_the_block() {
    for call in ["FC 2", "\"CONCAT\"", "\"concat\"", "CONCAT"] {
        let (compiled, sources) = compiled(&ob1(call), &[], Selection::default());
        assert!(compiled.diagnostics.is_empty(), "{call}: {:?}", compiled.diagnostics);
        assert_eq!(linked(&compiled), ["FC 2 = CONCAT"], "{call}");
        let fc2 = BlockId::new(BlockKind::Function, 2);
        assert!(compiled.program.code.contains_key(&fc2));
        assert_eq!(compiled.block_names[&fc2], "CONCAT");
        let span = compiled.program.code[&fc2].spans[0];
        assert_eq!(sources.file(span.file).name, "library/iec/fc002_concat.awl");
        assert!(sources.slice(span).starts_with("TAR2"), "places point into the source of the library");
    }
}

#[test]
fn nothing_is_linked_that_nothing_names() {
    let (compiled, _) = compiled("ORGANIZATION_BLOCK OB 1\nBEGIN\nUC SFC 43; L MW 2;\nEND_ORGANIZATION_BLOCK\n", &[], Selection::default());
    assert_eq!(compiled.library, []);
}

#[test]
fn the_symbol_table_and_the_project_place_a_block_elsewhere() {
    let (by_table, _) = compiled(&ob1("\"Concat\""), &[("CONCAT", "FC 102")], Selection::default());
    assert_eq!((linked(&by_table), by_table.has_errors()), (vec!["FC 102 = CONCAT".to_owned()], false));
    let (by_number, _) = compiled(&ob1("FC 102"), &[("CONCAT", "FC 102")], Selection::default());
    assert_eq!((linked(&by_number), by_number.has_errors()), (vec!["FC 102 = CONCAT".to_owned()], false));
    let (by_project, _) = compiled(&ob1("\"CONCAT\""), &[], placed("concat", 300));
    assert_eq!((linked(&by_project), by_project.has_errors()), (vec!["FC 300 = CONCAT".to_owned()], false));
    let (old_number, _) = compiled(&ob1("FC 2"), &[], placed("CONCAT", 300));
    assert!(old_number.diagnostics.iter().any(|found| found.problem == Problem::P3008), "FC 2 is free again");
    let (renamed, _) = compiled(&ob1("\"Join\""), &[("Join", "FC 2")], Selection::default());
    assert_eq!((linked(&renamed), renamed.has_errors()), (vec!["FC 2 = CONCAT".to_owned()], false));
}

#[test]
fn a_block_of_the_program_wins() {
    let own = "FUNCTION FC 2 : VOID\nVAR_INPUT x : INT; END_VAR\nBEGIN\nNOP 0;\nEND_FUNCTION\n";
    let (by_number, _) =
        compiled(&format!("{own}ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 2 (x := 1);\nEND_ORGANIZATION_BLOCK\n"), &[], Selection::default());
    assert_eq!((linked(&by_number), by_number.has_errors()), (vec![], false));
    let (by_name, _) = compiled(&format!("{own}{}", ob1("\"CONCAT\"")), &[], Selection::default());
    let found = by_name.diagnostics.iter().find(|found| found.problem == Problem::P3020).expect("the name has no block");
    assert!(found.help.as_ref().is_some_and(|help| help.contains("FC 2") && help.contains("[library]")), "{found:?}");
    assert!(!found.message.contains("did you mean"), "{found:?}");
    let (bare, _) = compiled(&format!("{own}{}", ob1("CONCAT")), &[], Selection::default());
    let found = bare.diagnostics.iter().find(|found| found.problem == Problem::P3001).expect("the name has no block");
    assert!(found.help.as_ref().is_some_and(|help| help.contains("FC 2") && help.contains("[library]")), "{found:?}");
    let (elsewhere, _) = compiled(&format!("{own}{}", ob1("\"CONCAT\"")), &[], placed("CONCAT", 102));
    assert_eq!((linked(&elsewhere), elsewhere.has_errors()), (vec!["FC 102 = CONCAT".to_owned()], false));
}

#[test]
fn a_project_can_switch_the_library_off() {
    let off = Selection { enabled: false, ..Selection::default() };
    let (by_number, _) = compiled(&ob1("FC 2"), &[], off.clone());
    assert!(by_number.library.is_empty() && by_number.diagnostics.iter().any(|found| found.problem == Problem::P3008));
    let (by_name, _) = compiled(&ob1("\"CONCAT\""), &[], off);
    let found = by_name.diagnostics.iter().find(|found| found.problem == Problem::P3020).expect("the name has no block");
    assert!(found.help.as_ref().is_some_and(|help| help.contains("library = false")), "{found:?}");
}

#[test]
fn a_slip_in_a_call_is_told_in_the_words_of_the_library() {
    let text = |arguments: &str| format!("ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL \"CONCAT\" ({arguments});\nEND_ORGANIZATION_BLOCK\n");
    let (parameter, _) = compiled(&text("IN := DB1.a, IN2 := DB1.b, RET_VAL := DB1.a"), &[], Selection::default());
    let found = parameter.diagnostics.iter().find(|found| found.problem == Problem::P3009).expect("there is no IN");
    assert!(
        found.help.as_ref().is_some_and(|help| help.contains("IN1, IN2, RET_VAL") && help.contains("`CONCAT` of the library")),
        "{found:?}"
    );
    for wrong in ["'abc'", "MW 10", "P#DB1.DBX0.0 BYTE 10"] {
        let (constant, _) = compiled(&text(&format!("IN1 := {wrong}, IN2 := DB1.b, RET_VAL := DB1.a")), &[], Selection::default());
        let found = constant.diagnostics.iter().find(|found| found.problem == Problem::P4011).expect("a variable is needed");
        assert!(found.message.contains(&format!("not `{wrong}`")) && found.message.contains("STRING"), "{found:?}");
    }
    let (name, _) = compiled(&ob1("\"CONCTA\""), &[], Selection::default());
    let found = name.diagnostics.iter().find(|found| found.problem == Problem::P3020).expect("a slip");
    assert!(found.message.contains("did you mean `CONCAT`?"), "{found:?}");
}

#[test]
fn only_what_is_called_is_compared_with_the_names_of_blocks() {
    let stop =
        || SystemBlock { block: BlockId::new(BlockKind::SystemFunction, 46), name: "STP", interface: Interface::default(), only: None };
    let message = |statement: &str| {
        let mut sources = Sources::default();
        sources.add("main.awl", format!("ORGANIZATION_BLOCK OB 1\nBEGIN\n{statement};\nEND_ORGANIZATION_BLOCK\n"));
        let options = Options { mnemonics: Some(Mnemonics::English), system_blocks: vec![stop()], ..Options::default() };
        let compiled = compile(&sources, &SymbolTable::default(), &options);
        compiled.diagnostics.into_iter().find(|found| found.problem == Problem::P3020).expect("no such symbol").message
    };
    assert_eq!(message("A \"Stop\""), "`\"Stop\"` is not in the symbol table");
    assert_eq!(message("CALL \"Stop\""), "`\"Stop\"` is not in the symbol table; did you mean `STP`?");
    assert_eq!(message("CALL \"CONCTA\""), "`\"CONCTA\"` is not in the symbol table; did you mean `CONCAT`?");
}

#[test]
fn every_block_is_whole_small_and_named_as_in_the_table() {
    let mut numbers = BTreeSet::new();
    let mut names = BTreeSet::new();
    for block in library::ALL {
        assert!(numbers.insert(block.block) && names.insert(block.name), "{block:?} stands once in the table");
        let parsed = parse(FileId::default(), block.text, Some(Mnemonics::English));
        assert_eq!(parsed.diagnostics, [], "{block:?}");
        let [source] = parsed.file.blocks.as_slice() else { panic!("{} holds one block", block.path) };
        assert_eq!(source.header.name.as_ref().map(|name| name.text.as_str()), Some(block.name), "{}", block.path);
        assert!(block.path.ends_with(&format!("{:03}_{}.awl", block.block.number, block.name.to_ascii_lowercase())), "{}", block.path);
        let mut sources = Sources::default();
        sources.add(block.path, block.text);
        let compiled = compile(&sources, &SymbolTable::default(), &Options { mnemonics: Some(Mnemonics::English), ..Options::default() });
        // System function blocks are the CPU's: this test has none.
        let expected = [Problem::P3013, Problem::P3018];
        let others: Vec<_> = compiled.diagnostics.iter().filter(|found| !expected.contains(&found.problem)).collect();
        assert!(others.is_empty(), "{block:?}: {others:?}");
        let code = compiled.program.code.get(&block.block).unwrap_or_else(|| panic!("{} has the number of the table", block.path));
        assert!(code.local_size <= LOCAL_BYTES_MAX, "{block:?} needs {} bytes of local data", code.local_size);
        let description = describe(block, &Options::default());
        assert!(!description.title.is_empty() && !description.comment.is_empty() && !description.family.is_empty(), "{block:?}");
        assert!(
            description.interface.parameters().all(|parameter| parameter.name == "RET_VAL" || !parameter.comment.is_empty()),
            "{block:?}"
        );
        let german = sieben_lang::stl::convert::convert(block.text, Some(Mnemonics::English), Mnemonics::German);
        assert!(german.is_ok(), "{block:?}");
    }
}
