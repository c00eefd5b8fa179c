//! Which values in the local data nobody sees but the instructions that name them: a pointer to one value shows no other.

use sieben_engine::Program;
use sieben_engine::ir::{Inst, Place};
use sieben_engine::machine::Register;
use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Options, compile};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockKind;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

const BLOCKS: &str = "\
TYPE Pair : STRUCT a, b : DINT; END_STRUCT; END_TYPE
FUNCTION Longer : STRING
VAR_INPUT text : STRING; END_VAR
Longer := CONCAT(text, '!');
END_FUNCTION
FUNCTION Swapped : Pair
VAR_INPUT pair : Pair; END_VAR
Swapped.a := pair.b; Swapped.b := pair.a;
END_FUNCTION
FUNCTION_BLOCK Counter
VAR_OUTPUT n : DINT; END_VAR
n := n + 1;
END_FUNCTION_BLOCK
";

fn program(statements: &str) -> Program {
    let main = format!("PROGRAM Main\nVAR s : STRING; p : Pair; c : Counter; END_VAR\n{statements}\nc();\nEND_PROGRAM\n");
    let mut sources = Sources::default();
    sources.add("test.st", [BLOCKS, &main].concat());
    let options = Options { dialect: Some(Dialect::Iec), ..Options::default() };
    let compiled = compile(&sources, &SymbolTable::default(), &options);
    assert_eq!(compiled.diagnostics, []);
    compiled.program
}

/// Whether each value is private with which function blocks keep AR2 over calls.
fn kept_pointers(program: &Program) -> Vec<bool> {
    let mut kept = Vec::new();
    for (_, block) in program.code.iter().filter(|(id, _)| id.kind == BlockKind::FunctionBlock) {
        for inst in &block.code.insts {
            if let Inst::Store { place: Place::Fixed { area: Area::Local, position }, width: Width::DoubleWord, src } = *inst
                && src == Register::Ar2.into()
            {
                kept.push(block.private.contains(&(position, Width::DoubleWord)));
            }
        }
    }
    kept
}

#[test]
fn a_pointer_to_a_text_or_a_structure_between_two_calls_shows_nothing_else() {
    for statements in ["", "s := Longer(s);", "s := Longer(Longer(s));", "s := Longer(CONCAT(s, 'a'));", "p := Swapped(Swapped(p));"] {
        let kept = kept_pointers(&program(statements));
        assert!(!kept.is_empty() && kept.iter().all(|&private| private), "{statements}: {kept:?}");
    }
}
