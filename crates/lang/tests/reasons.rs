//! Every instruction says why it did what it did, in both languages, and what it says is true.

#[path = "strict/mod.rs"]
mod strict;

use std::collections::BTreeSet;
use std::sync::Arc;

use sieben_engine::{Context, Entry, FaultPlace, Interpreter, Layout, Machine, StatementEvent, Tracer};
use sieben_lang::reason::{Moment, Reasons};
use sieben_lang::{Compiled, Options, compile};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Sources;
use sieben_model::symbols::{Symbol, SymbolTable};

use sieben_lang::reason::Language;
use sieben_lang::reason::examples;
use sieben_lang::sentences::table::Sentence;
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::why::Why;

/// The names between the braces of a template.
fn names(template: &str) -> BTreeSet<&str> {
    template.split('{').skip(1).map(|rest| rest.split('}').next().expect("a closing brace")).collect()
}

#[test]
fn a_sentence_fills_in_the_same_in_both_languages() {
    for &sentence in Sentence::ALL {
        let [english, german] = Language::ALL.map(|language| names(sentence.template(language)));
        // Where the word order differs, the turned words stand for the same.
        let plain =
            |names: BTreeSet<&'static str>| names.into_iter().map(|name| name.trim_end_matches("_inverted")).collect::<BTreeSet<_>>();
        assert_eq!(plain(english), plain(german), "{sentence:?}");
    }
}

#[test]
fn every_instruction_has_an_example_in_both_languages() {
    let mut wrong = Vec::new();
    for &instruction in Instruction::ALL {
        let examples = examples::of(instruction);
        if examples.is_empty() {
            wrong.push(format!("{instruction:?} has no example"));
        }
        for example in &examples {
            for text in example.sentence.iter().chain(&example.statement) {
                if text.is_empty() || text.contains(['{', '}']) || text.contains("  ") {
                    wrong.push(format!("{instruction:?}: {text:?}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Faults have sentences of their own.
fn is_fault(sentence: Sentence) -> bool {
    format!("{sentence:?}").starts_with("Fault")
}

#[test]
fn an_instruction_says_only_what_its_row_lists() {
    for &instruction in Instruction::ALL {
        for example in examples::of(instruction) {
            for form in example.forms {
                assert!(
                    is_fault(form) || instruction.why().forms().contains(&form),
                    "{instruction:?} says {form:?}: {:?}",
                    example.sentence
                );
            }
        }
    }
}

#[test]
fn every_sentence_that_a_row_lists_is_brought_out_by_an_example() {
    // Without the machine before a statement, with four accumulators or in a switched-off zone things are otherwise; these stand in tests of their own.
    let elsewhere = [
        Sentence::TimerState,
        Sentence::CountState,
        Sentence::EnableState,
        Sentence::AssignMcr,
        Sentence::SetMcr,
        Sentence::TransferMcr,
        Sentence::CompareDifference,
        Sentence::TwoAccumulators,
        Sentence::LoadRegister,
        Sentence::EndOuter,
        Sentence::McrNotActive,
    ];
    let mut seen = BTreeSet::new();
    let mut listed = BTreeSet::new();
    for &instruction in Instruction::ALL {
        listed.extend(instruction.why().forms().iter().copied());
        seen.extend(examples::of(instruction).into_iter().flat_map(|example| example.forms));
    }
    listed.retain(|sentence| !elsewhere.contains(sentence));
    let missing: Vec<_> = listed.difference(&seen).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn the_words_of_an_extension_have_sentences_too() {
    assert_eq!(Instruction::Extension.why(), Why::Extension);
}

/// A program that is run once from OB 1.
struct Run {
    compiled: Compiled,
    sources: Sources,
    symbols: SymbolTable,
}

/// Keeps what happens, with the machine before each statement.
struct Keep {
    before: Machine,
    seen: Vec<(StatementEvent, Machine, Machine)>,
}

impl Tracer for Keep {
    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        self.seen.push((event.clone(), self.before.clone(), machine.clone()));
    }
    fn pauses_before(&mut self, machine: &Machine, _: FaultPlace) -> bool {
        self.before = machine.clone();
        false
    }
}

impl Run {
    fn new(name: &str, text: &str, symbols: &[(&str, &str, &str)]) -> Self {
        let mut sources = Sources::default();
        sources.add(name, text);
        let symbol = |&(name, address, data_type): &(&str, &str, &str)| Symbol {
            name: name.to_owned(),
            address: address.to_owned(),
            data_type: data_type.to_owned(),
            ..Symbol::default()
        };
        let symbols = SymbolTable::new(symbols.iter().map(symbol).collect());
        let compiled = compile(&sources, &symbols, &Options::default());
        assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics);
        Self { compiled, sources, symbols }
    }

    /// Statements and their reasons.
    fn reasons(&self, language: Language) -> Vec<String> {
        let layout = Arc::new(Layout::new(&CpuType::ALL[0], &self.compiled.program));
        let engine = Interpreter::load(&self.compiled.program, &layout);
        let mut machine = Machine::new(layout);
        for (&number, block) in &self.compiled.program.data {
            let entry = machine.memory.data_block(u64::from(number)).expect("a block of the program");
            machine.memory.arena[entry.base as usize..][..block.image.len()].copy_from_slice(&block.image);
        }
        let mut keep = Keep { before: machine.clone(), seen: Vec::new() };
        let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: None };
        engine.run(&mut Context { machine: &mut machine, host: &mut strict::Strict, tracer: Some(&mut keep) }, &entry);
        let reasons = Reasons::new(&self.compiled, &self.sources, &self.symbols);
        let say = |(event, before, after): &(StatementEvent, Machine, Machine)| {
            let moment = Moment { event, before: Some(before), after, fault: None };
            format!("{}: {}", reasons.statement(event.place), reasons.sentence(&moment, language))
        };
        keep.seen.iter().map(say).collect()
    }
}

#[test]
fn structured_text_says_what_it_read_and_what_came_of_it() {
    let text = "FUNCTION Twice : INT\nVAR_INPUT x : INT; END_VAR\nTwice := x * 2;\nEND_FUNCTION\n\
                PROGRAM Main\nVAR a : BOOL := TRUE; b : BOOL; x : BOOL; n : INT := 3; r : REAL := 1.5; i : INT; v : ARRAY[1..3] OF INT; END_VAR\n\
                x := a AND b;\n\
                n := n + 2;\n\
                r := r * 2.0;\n\
                IF n > 10 THEN\n  x := TRUE;\nELSIF a THEN\n  x := a;\nEND_IF;\n\
                v[2] := 7;\n\
                n := v[2];\n\
                n := Twice(n);\n\
                WHILE n > 13 DO\n  n := n - 1;\nEND_WHILE;\n\
                RETURN;\nEND_PROGRAM\n";
    let run = Run::new("main.st", text, &[]);
    let english = run.reasons(Language::English);
    let expected = [
        "Main: calls Main",
        "Twice: parameters and variables of the block are set or copied",
        "Twice := x * 2: Twice becomes 14",
        "x := a AND b: a is TRUE, b is FALSE, so x becomes FALSE",
        "n := n + 2: n is 3, so n becomes 5",
        "r := r * 2.0: r is 1.5, so r becomes 3.0",
        "n > 10: n is 5: `n > 10` is FALSE, so what follows it is left out",
        "a: a is TRUE: `a` is TRUE, so what follows it runs",
        "x := a: a is TRUE, so x becomes TRUE",
        "v[2] := 7: v[2] becomes 7",
        "n := v[2]: v[2] is 7, so n becomes 7",
        "n := Twice(n): calls Twice; the rest of `n := Twice(n)` follows when it has ended",
        "n > 13: n is 14: `n > 13` is TRUE, so what follows it runs",
        "n := n - 1: n is 14, so n becomes 13",
        "n > 13: n is 13: `n > 13` is FALSE, so what follows it is left out",
        "RETURN: the block ends here",
    ];
    for line in expected {
        assert!(english.iter().any(|said| said == line), "{line}\n{english:#?}");
    }
    assert!(!english.iter().any(|line| line.starts_with("x := TRUE")), "the branch is not taken\n{english:#?}");
    let german = run.reasons(Language::German);
    assert!(german.contains(&"x := a AND b: a ist TRUE, b ist FALSE, also wird x FALSE".to_owned()), "{german:#?}");
    assert_eq!(english.len(), german.len());
}

#[test]
fn names_and_types_of_variables_are_shown() {
    let text = "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  LEVEL : REAL;\nEND_VAR\nVAR\n  FULL : BOOL;\nEND_VAR\nVAR_TEMP\n  T0 : S5TIME;\nEND_VAR\n\
                BEGIN\n      L #LEVEL;\n      L 2.5;\n      >R;\n      = #FULL;\n      L S5T#2S;\n      T #T0;\n      L #T0;\nEND_FUNCTION_BLOCK\n\
                DATA_BLOCK DB 1 FB 1\nBEGIN\n  LEVEL := 3.0;\nEND_DATA_BLOCK\n\
                ORGANIZATION_BLOCK OB 1\nBEGIN\n      A \"Start\";\n      = Q 4.0;\n      L \"Speed\";\n      CALL FB 1, DB 1;\n\
                      L DB1.DBD 0;\n      L MW [MD 20];\n      L T 999;\nEND_ORGANIZATION_BLOCK\n";
    let run = Run::new("plant.awl", text, &[("Start", "I 0.1", "BOOL"), ("Speed", "MW 10", "INT"), ("Lamp", "Q 4.0", "BOOL")]);
    let english = run.reasons(Language::English);
    let expected = [
        "A \"Start\": \"Start\" (I 0.1) is 0 and begins a logic string, so the RLO becomes 0",
        "= Q 4.0: the RLO is 0, so Q 4.0 \"Lamp\" becomes 0",
        "L \"Speed\": \"Speed\" (MW 10) holds 0, which comes into ACCU 1; ACCU 2 takes the old ACCU 1, 0",
        "CALL FB 1, DB 1: calls FB 1",
        "L #LEVEL: #LEVEL (DB1.DBD 0) holds 3.0, which comes into ACCU 1; ACCU 2 takes the old ACCU 1, 0",
        ">R: ACCU 2 (3.0) is greater than ACCU 1 (2.5), so the RLO becomes 1",
        "= #FULL: the RLO is 1, so #FULL (DB1.DBX 4.0) becomes 1",
    ];
    for line in expected {
        assert!(english.iter().any(|said| said == line), "{line}\n{english:#?}");
    }
    assert!(english.iter().any(|line| line.starts_with("L #T0: #T0 (LW 0) holds S5T#2S, ")), "{english:#?}");
    let last = english.last().expect("statements ran");
    assert_eq!(last, "L T 999: the CPU has no timer with this number, so nothing happens", "{english:#?}");
}
