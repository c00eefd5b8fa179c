//! What the text side of STL must hold for any source: parsing, formatting, converting.

#![allow(clippy::disallowed_methods)] // What is expected lies beside the sources; `SIEBEN_BLESS` writes it again.

use std::fmt::Write as _;

use proptest::prelude::*;
use sieben_lang::stl::{self, ast};
use sieben_model::mnemonics::Mnemonics::{self, English, German};
use sieben_model::problems::Problem;
use sieben_model::source::FileId;

/// Every form of the language that a source can have.
const CORPUS: &[&str] = &[
    include_str!("stl/blocks.awl"),
    include_str!("stl/statements.awl"),
    include_str!("stl/german.awl"),
    include_str!("stl/slips.awl"),
    include_str!("stl/broken.awl"),
];

fn parse(text: &str) -> stl::Parsed {
    stl::parse(FileId::default(), text, None)
}

/// Tokens that are no blanks and line ends, one after the other.
fn words(text: &str) -> Vec<String> {
    parse(text)
        .syntax()
        .descendants_with_tokens()
        .filter_map(|element| element.into_token())
        .filter(|token| !matches!(token.kind(), stl::syntax::SyntaxKind::Blank | stl::syntax::SyntaxKind::Newline))
        .map(|token| token.text().to_owned())
        .collect()
}

fn operand(operand: &ast::Operand) -> String {
    use ast::Operand::*;
    match operand {
        None => String::new(),
        Error => "<error>".to_owned(),
        Constant(constant) => constant.value.as_ref().map_or_else(|| "<bad constant>".to_owned(), |value| value.spell()),
        AddressOf(word) => format!("P##{}", word.text),
        PointerTo { target, .. } => format!("P#({})", self::operand(target)),
        Absolute { letters, number, bit } => format!("{letters} {number}{}", bit.map_or_else(String::new, |bit| format!(".{bit}"))),
        InBlock { block, instance, letters, number, bit } => {
            format!(
                "in {}{} {letters} {number}{}",
                name(block),
                if *instance { " (DI)" } else { "" },
                bit.map_or_else(String::new, |bit| format!(".{bit}"))
            )
        }
        BlockField { block, path: steps } => format!("in {} field {}", name(block), path(steps)),
        Symbol { name, path: steps } => format!("symbol <{}>{}", name.text, path(steps)),
        Local { name, path: steps } => format!("local <{}>{}", name.text, path(steps)),
        Indirect { letters, pointer, .. } => format!("{letters} at [{}]", self::operand(pointer)),
        RegisterIndirect { letters, register, offset } => {
            format!("{letters} at {} + {}", register.text, offset.value.as_ref().map_or_else(|| "?".to_owned(), |value| value.spell()))
        }
        Name { word, path: steps } => format!("name <{}>{}", word.text, path(steps)),
        Register { name, number } => format!("register {} {number}", name.text),
        Scratch { bit } => format!("scratch bit {bit}"),
        List(operands) => operands.iter().map(|(operand, _)| self::operand(operand)).collect::<Vec<_>>().join(" , "),
        Call(call) => {
            let mut text = self::operand(&call.callee);
            if let Some((instance, _)) = &call.instance {
                let _ = write!(text, " with {}", self::operand(instance));
            }
            for argument in &call.arguments {
                let _ = write!(text, " | {} := {}", argument.name.text, self::operand(&argument.value));
            }
            text
        }
    }
}

fn path(steps: &[ast::PathElement]) -> String {
    steps
        .iter()
        .map(|step| match step {
            ast::PathElement::Field(word) => format!(".{}", word.text),
            ast::PathElement::Index(indices, _) => format!("{indices:?}"),
        })
        .collect()
}

fn name(name: &ast::BlockName) -> String {
    match name {
        ast::BlockName::Absolute { kind, number, .. } => format!("{} {number}", kind.abbreviation()),
        ast::BlockName::Symbol(word) => format!("<{}>", word.text),
    }
}

fn type_name(data_type: &ast::TypeName) -> String {
    use ast::TypeKind::*;
    match &data_type.kind {
        Word(word) => word.clone(),
        String(length) => format!("STRING {length:?}"),
        Array { bounds, element } => format!("ARRAY {bounds:?} OF {}", type_name(element)),
        Struct(fields) => format!("STRUCT ({})", fields.iter().map(declaration).collect::<Vec<_>>().join("; ")),
        Block(kind, number) => format!("{} {number}", kind.abbreviation()),
        Symbol(symbol) => format!("<{symbol}>"),
        Missing => "<missing>".to_owned(),
    }
}

fn initial(value: &ast::Initial) -> String {
    match value {
        ast::Initial::Value(constant) => constant.value.as_ref().map_or_else(|| "?".to_owned(), |value| value.spell()),
        ast::Initial::Number { operand, .. } => self::operand(operand),
        ast::Initial::Repeat { count, values, .. } => format!("{count} x ({})", values.iter().map(initial).collect::<Vec<_>>().join(", ")),
    }
}

fn declaration(declaration: &ast::Declaration) -> String {
    let names: Vec<&str> = declaration.names.iter().map(|name| name.text.as_str()).collect();
    let mut text = format!("{}: {}", names.join(","), type_name(&declaration.data_type));
    if !declaration.initial.is_empty() {
        let _ = write!(text, " := {}", declaration.initial.iter().map(initial).collect::<Vec<_>>().join(", "));
    }
    for (name, value) in &declaration.attributes {
        let _ = write!(text, " {{{}={}}}", name.text, value.text);
    }
    if !declaration.comment.is_empty() {
        let _ = write!(text, " // {}", declaration.comment);
    }
    text
}

/// What was understood, one line each.
fn understood(text: &str) -> String {
    let parsed = parse(text);
    assert_eq!(parsed.syntax().text(), text, "the tree holds every byte");
    let mut out = format!("{:?}\n", parsed.mnemonics);
    for block in &parsed.file.blocks {
        let _ = write!(out, "{} {}", block.kind.abbreviation(), name(&block.name));
        if block.implicit {
            out.push_str(" (implicit)");
        }
        if let Some(data_type) = &block.return_type {
            let _ = write!(out, " : {}", type_name(data_type));
        }
        out.push('\n');
        let header = &block.header;
        for (field, word) in [
            ("title", &header.title),
            ("author", &header.author),
            ("family", &header.family),
            ("name", &header.name),
            ("version", &header.version),
        ] {
            if let Some(word) = word {
                let _ = writeln!(out, "  {field} = {}", word.text);
            }
        }
        if !header.comment.is_empty() {
            let _ = writeln!(out, "  comment = {:?}", header.comment);
        }
        for (name, value) in &header.attributes {
            let _ = writeln!(out, "  attribute {} = {}", name.text, value.text);
        }
        for flag in &header.flags {
            let _ = writeln!(out, "  flag {}", flag.text);
        }
        for section in &block.sections {
            let _ = writeln!(out, "  {:?}", section.section);
            for item in &section.declarations {
                let _ = writeln!(out, "    {}", declaration(item));
            }
        }
        if let Some(data_type) = &block.body_type {
            let _ = writeln!(out, "  body {}", type_name(data_type));
        }
        for assignment in &block.assignments {
            let _ = writeln!(
                out,
                "  set {} := {}",
                path(&assignment.path),
                assignment.values.iter().map(initial).collect::<Vec<_>>().join(", ")
            );
        }
        for (index, statement) in block.statements.iter().enumerate() {
            for network in block.networks.iter().filter(|network| network.first_statement == index) {
                let _ = writeln!(out, "  network {:?} {:?}", network.title, network.comment);
            }
            let label = statement.label.as_ref().map_or_else(String::new, |label| format!("{}: ", label.text));
            let _ = writeln!(out, "  {label}{} {}", statement.mnemonic.text, operand(&statement.operand));
        }
    }
    for diagnostic in &parsed.diagnostics {
        let span = diagnostic.span;
        let _ = write!(
            out,
            "{} at `{}`: {}",
            diagnostic.problem.code(),
            text[span.start as usize..span.end as usize].escape_debug(),
            diagnostic.message
        );
        if let Some(fix) = &diagnostic.fix {
            let _ = write!(out, " [{}]", fix.title);
        }
        out.push('\n');
    }
    out
}

/// Compares what was understood with the file beside the source; `SIEBEN_BLESS` in the environment writes it.
fn compare(name: &str, actual: &str) {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/stl").join(name);
    if std::env::var_os("SIEBEN_BLESS").is_some() {
        std::fs::write(&path, actual).expect("the test folder can be written");
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(actual, expected.replace("\r\n", "\n"), "{name}");
}

#[test]
fn sources_are_understood_as_written_beside_them() {
    for (index, name) in ["blocks", "statements", "german", "slips", "broken"].into_iter().enumerate() {
        compare(&format!("{name}.understood.txt"), &understood(CORPUS[index]));
    }
}

#[test]
fn sources_are_formatted_as_written_beside_them() {
    // The first lines of the slips have letters that only look right: those are refused.
    let slips: String = CORPUS[3].split_inclusive('\n').skip(3).collect();
    let refused = stl::format(CORPUS[3], None).expect_err("they are errors");
    assert!(refused.iter().all(|diagnostic| diagnostic.problem == Problem::P1005), "{refused:?}");
    for (name, source) in ["blocks", "statements", "german", "slips"].into_iter().zip([CORPUS[0], CORPUS[1], CORPUS[2], &slips]) {
        // Without its first lines the slips have more words of German.
        let language = (name == "slips").then_some(English);
        let formatted = stl::format(source, language).expect("only misprints");
        compare(&format!("{name}.formatted.awl"), &formatted);
        assert_eq!(stl::format(&formatted, language).as_deref(), Ok(formatted.as_str()), "{name}: formatting twice changes nothing");
        assert_eq!(words(&formatted).concat(), words(source).concat(), "{name}: no word is lost");
    }
}

#[test]
fn converting_there_and_back_changes_nothing() {
    for (source, from) in [(CORPUS[0], English), (CORPUS[1], English), (CORPUS[2], German)] {
        for source in [source.to_owned(), source.replace('\n', "\r\n")] {
            let other = stl::convert(&source, Some(from), from.other()).expect("no syntax errors");
            assert_ne!(other, source);
            assert_eq!(parse(&other).mnemonics, from.other());
            assert_eq!(parse(&other).diagnostics, [], "{other}");
            assert_eq!(stl::convert(&other, Some(from.other()), from).expect("no syntax errors"), source);
        }
    }
}

#[test]
fn convert_rewrites_only_words_of_the_language() {
    for (english, german) in [
        ("A I 0.0\r\nA( \t;AN BR;)  ; = Q4.1 // A I 0.0\r\n", "U E 0.0\r\nU( \t;UN BIE;)  ; = A4.1 // A I 0.0\r\n"),
        ("SE T 1; SD T 1; SP T 1; SS T 1; SF T 1", "SV T 1; SE T 1; SI T 1; SS T 1; SA T 1"),
        ("L PIW 256; T PQD[AR1,P#0.0]; L C 5; CU C [MW 2]", "L PEW 256; T PAD[AR1,P#0.0]; L Z 5; ZV Z [MW 2]"),
        (
            "L P#I 1.0; LAR1 P#Q1.0; CALL FC 1 (a := P#Q 0.0 BYTE 4, A := I 0.0)",
            "L P#E 1.0; LAR1 P#A1.0; CALL FC 1 (a := P#A 0.0 BYTE 4, A := E 0.0)",
        ),
        ("JC A; A: JU JC; JC: a i 1.0; L #I; L \"Q\"", "SPB A; A: SPA JC; JC: u e 1.0; L #I; L \"Q\""),
        ("OPN DB 1; OPN DI 2; CDB; CAW; CAR; L DB1.DBW 2", "AUF DB 1; AUF DI 2; TDB; TAW; TAR; L DB1.DBW 2"),
    ] {
        assert_eq!(stl::convert(english, Some(English), German).as_deref(), Ok(german));
        assert_eq!(stl::convert(german, Some(German), English).as_deref(), Ok(english));
        assert_eq!(stl::convert(german, None, English).as_deref(), Ok(english), "the language is found");
    }
}

#[test]
fn the_language_is_judged_over_the_whole_file() {
    let judged = |text: &str| {
        let parsed = parse(text);
        (parsed.mnemonics, parsed.diagnostics.iter().map(|diagnostic| diagnostic.problem.code()).collect::<Vec<_>>())
    };
    assert_eq!(judged("A M 1.0\nA M 1.1\n= M 1.2\n"), (English, vec![]));
    assert_eq!(judged("U M 1.0\nSE T 1\n"), (German, vec![]));
    assert_eq!(judged("L S5T#1S\nSE T 1\n"), (English, vec!["P2003"]));
    assert_eq!(judged("L 1\nT MW 2\n"), (English, vec![]));
    assert_eq!(judged("U E 0.0\nU E 0.1\nA I 0.2\nSPB M001\nM001: NOP 0"), (German, vec!["P2002"]));
    assert_eq!(judged(""), (English, vec![]));
    // A label, a parameter and a declaration prove nothing.
    assert_eq!(judged("A M 0.0; U: CALL FC 1 (U := 1, UN := 2)\n"), (English, vec![]));
}

#[test]
fn a_cut_or_a_missing_word_is_no_panic() {
    for text in CORPUS {
        let mut places = vec![0];
        for element in parse(text).syntax().descendants_with_tokens() {
            if let Some(token) = element.into_token() {
                places.push(usize::from(token.text_range().end()));
            }
        }
        for pair in places.windows(2) {
            let cut = &text[..pair[1]];
            assert_eq!(parse(cut).syntax().text(), cut);
            let without = format!("{}{}", &text[..pair[0]], &text[pair[1]..]);
            assert_eq!(parse(&without).syntax().text(), without.as_str());
        }
    }
}

#[test]
fn hostile_sources_end_soon() {
    let many = 4_000;
    for text in [
        "(".repeat(many),
        "[".repeat(many),
        "{".repeat(many),
        "\"".repeat(many),
        "'".repeat(many),
        "(*".repeat(many),
        "A(;".repeat(many),
        "L MW [MD [".repeat(many),
        "\0".repeat(many),
        "FUNCTION ".repeat(many),
        "VAR ".repeat(many),
        "#".repeat(many),
        "P#".repeat(many),
        "a:".repeat(many),
        "CALL FC 1 (a:=\n".repeat(many),
        "CALL FC 1,\n".repeat(many),
        format!("DATA_BLOCK DB 1 {}", "STRUCT a : ".repeat(many)),
        format!("DATA_BLOCK DB 1 STRUCT a : {} INT", "ARRAY [1..2] OF ".repeat(many)),
        format!("DATA_BLOCK DB 1 STRUCT a : ARRAY [1..2] OF INT := {}1", "2 (".repeat(many)),
        format!("DATA_BLOCK DB 1 STRUCT a : STRING [{}]; b : UDT {}", "9".repeat(many), "9".repeat(many)),
        format!("L MW {}.{}", "9".repeat(many), "9".repeat(many)),
        "\r".repeat(many),
        "; ".repeat(many),
        format!("{}:", "Z".repeat(many)),
        "L (* a *) (* b *) ".repeat(many),
        "(* a *) ".repeat(many),
    ] {
        let parsed = parse(&text);
        assert_eq!(parsed.syntax().text(), text.as_str());
        assert!(parsed.diagnostics.len() <= stl::parser::DIAGNOSTICS_MAX + 1);
        stl::fuzz(text.as_bytes());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn no_text_panics(text in "\\PC{0,60}") {
        stl::fuzz(text.as_bytes());
    }

    #[test]
    fn no_bytes_panic(bytes in proptest::collection::vec(any::<u8>(), 0..80)) {
        stl::fuzz(&bytes);
    }

    #[test]
    fn no_mixture_of_words_panics(picks in proptest::collection::vec((0..CORPUS.len(), any::<prop::sample::Index>(), 0..4_u8), 1..60)) {
        let corpus: Vec<Vec<String>> = CORPUS.iter().map(|text| words(text)).collect();
        let mut text = String::new();
        for (source, pick, separator) in picks {
            let word: &String = pick.get(&corpus[source]);
            text.push_str(word);
            text.push_str([" ", "\n", "", "; "][usize::from(separator)]);
        }
        stl::fuzz(text.as_bytes());
    }
}

/// All words of the instruction table: each is understood and there is only one translation.
#[test]
fn every_instruction_is_read_in_both_languages() {
    use sieben_lang::stl::instructions::Instruction;
    for &instruction in Instruction::ALL {
        for language in [English, German] {
            let word = instruction.mnemonic(language);
            let other = instruction.mnemonic(language.other());
            assert_eq!(stl::mnemonics::translate_instruction(word, language), Some(other), "{word} has one translation");
            let parsed = stl::parse(FileId::default(), word, Some(language));
            assert_eq!(parsed.file.blocks[0].statements[0].mnemonic.text, word);
            assert!(parsed.diagnostics.is_empty() || word == "CALL", "{word}: {:?}", parsed.diagnostics);
            let _: Mnemonics = parsed.mnemonics;
        }
    }
}
