//! The grammar of STL, and that of sources whose networks are diagrams: the same around other bodies.

use serde_json::{Value, json};
use sieben_lang::network::boxes::{BOXES, CounterKind, TimerKind};
use sieben_lang::network::elements::ELEMENTS;
use sieben_lang::stl::extension::Word;
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::operands::OperandClass;
use sieben_lang::stl::words::{self, Kind};
use sieben_model::types::DataType;

use super::patterns::{
    ALONE, NAME, address, any_of, any_whole, block_comment, characters, include, indirect_address, line_comment, local, number, numbered,
    parts, region_with_parts, rule, symbol, typed_constant, words as alone,
};

/// What networks hold that do not say it themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bodies {
    /// A statement list.
    Statements,
    /// Ladder or function block diagrams.
    Diagrams,
}

/// Types before `#` in a constant, in both mnemonic languages.
const CONSTANT_TYPES: &str = "S5T|S5TIME|T|TIME|D|DATE|TOD|TIME_OF_DAY|DT|DATE_AND_TIME|L|C|Z|B|W|DW|BYTE|WORD|DWORD";

/// The grammar.
pub(super) fn grammar(bodies: Bodies) -> Value {
    let (name, scope, body) = match bodies {
        Bodies::Statements => ("STL", "source.awl", "statements"),
        Bodies::Diagrams => ("LAD and FBD", "source.lad", "diagram"),
    };
    let head = [include("comments"), include("title"), include("block"), include("data")];
    json!({
        "name": name,
        "scopeName": scope,
        "patterns": head.into_iter().chain([include(body)]).collect::<Vec<_>>(),
        "repository": {
            "comments": { "patterns": [line_comment("awl"), block_comment("awl", r"\(\*", r"\*\)", &[])] },
            "title": title(),
            "block": block(body),
            "data": data(),
            "declarations": declarations(),
            "statements": statements(),
            "diagram": diagram(),
            "networks": networks(),
            "label": label(),
            "instruction": instruction(),
            "call": { "patterns": call() },
            "operands": operands(),
        },
    })
}

/// `TITLE = …`: a `//` in it is no comment.
fn title() -> Value {
    parts(
        r"(?i)^\s*(TITLE)\s*(=)(.*)$",
        &[(1, "keyword.other.head.awl"), (2, "keyword.operator.assignment.awl"), (3, "string.unquoted.title.awl markup.heading.awl")],
    )
}

/// The words that begin blocks of a kind, and those that end them.
fn begin_and_end(data: bool) -> (String, String) {
    let all = words::of(Kind::Block);
    let is_data = |word: &&str| word.ends_with("DATA_BLOCK") || word.ends_with("TYPE");
    let (ends, begins): (Vec<&str>, Vec<&str>) =
        all.into_iter().filter(|word| is_data(word) == data).partition(|word| word.starts_with("END_"));
    (any_of(begins), any_of(ends))
}

/// Where any block begins, if the one before it was not ended.
fn next_block() -> String {
    let all = words::of(Kind::Block);
    format!(r"(?=^\s*(?:{})\b)", any_of(all.into_iter().filter(|word| !word.starts_with("END_"))))
}

/// The name after the word that begins a block.
fn block_name() -> String {
    format!(r#"(?:\s+((?:OB|FB|FC|SFC|SFB|DB|UDT)\s*\d+|"[^"\r\n]*"|{NAME}))?"#)
}

/// A block with statements.
fn block(body: &str) -> Value {
    let (begins, ends) = begin_and_end(false);
    let statements = region_with_parts(
        &format!(r"(?i){ALONE}(BEGIN)\b"),
        &[(1, "keyword.control.block.awl")],
        &format!(r"(?i)(?={ALONE}(?:{ends})\b)|{}", next_block()),
        &[],
        &[include(body)],
    );
    region_with_parts(
        &format!(r"(?i){ALONE}({begins})\b{}", block_name()),
        &[(1, "keyword.control.block.awl"), (2, "entity.name.function.awl")],
        &format!(r"(?i){ALONE}({ends})\b|{}", next_block()),
        &[(1, "keyword.control.block.awl")],
        &[include("comments"), include("title"), statements, include("networks"), include("declarations")],
    )
}

/// A data block or a type: declarations, and values after `BEGIN`.
fn data() -> Value {
    let (begins, ends) = begin_and_end(true);
    region_with_parts(
        &format!(r"(?i){ALONE}({begins})\b{}", block_name()),
        &[(1, "keyword.control.block.awl"), (2, "entity.name.type.awl")],
        &format!(r"(?i){ALONE}({ends})\b|{}", next_block()),
        &[(1, "keyword.control.block.awl")],
        &[include("comments"), include("title"), alone("keyword.control.block.awl", ["BEGIN"]), include("declarations")],
    )
}

/// Heads of blocks and variables.
fn declarations() -> Value {
    let field = any_of(words::of(Kind::Head));
    json!({ "patterns": [
        include("comments"),
        parts(
            &format!(r"(?i)^\s*({field})\s*(:)\s*([^;/'\r\n]*)"),
            &[(1, "keyword.other.head.awl"), (3, "string.unquoted.awl")],
        ),
        rule("meta.attributes.awl constant.other.attributes.awl", r"\{[^}\r\n]*\}?"),
        alone("keyword.other.declaration.awl", words::of(Kind::Declaration)),
        alone("keyword.other.head.awl", words::of(Kind::Head)),
        alone("keyword.other.declaration.awl", ["ARRAY", "OF"]),
        alone("support.type.awl", DataType::words()),
        rule("variable.other.declaration.awl", &format!(r"{NAME}(?=\s*(?:\{{[^}}\r\n]*\}}\s*)?:(?!=))")),
        rule("keyword.operator.assignment.awl", ":="),
        alone("constant.language.awl", ["TRUE", "FALSE"]),
        include("operands"),
    ] })
}

/// A statement list.
fn statements() -> Value {
    json!({ "patterns": [
        include("comments"),
        include("title"),
        include("networks"),
        include("label"),
        rule("keyword.operator.assignment.awl", ":=|=>"),
        include("call"),
        include("instruction"),
        include("operands"),
    ] })
}

/// A label; one that is too long for STEP 7 is marked.
fn label() -> Value {
    let before = r"(?:^|(?<=;))\s*";
    json!({ "patterns": [
        parts(&format!(r"{before}([\p{{L}}_][\p{{L}}\p{{N}}_]{{0,3}})\s*(:)(?!=)"), &[(1, "entity.name.label.awl"), (2, "punctuation.separator.label.awl")]),
        parts(&format!(r"{before}({NAME})\s*(:)(?!=)"), &[(1, "invalid.illegal.label.awl"), (2, "punctuation.separator.label.awl")]),
    ] })
}

/// Instructions, where a statement begins: position decides, so that `A` in `A  A 0.0` stays an address.
fn instruction() -> Value {
    // Neither the name of a parameter nor a label.
    let rule = |scope: &str, rows: &dyn Fn(Instruction) -> bool| {
        let both = Instruction::ALL.iter().filter(|row| rows(**row)).flat_map(|row| [row.english(), row.german()]);
        parts(&format!(r"(?i)(?<=^|;|:)\s*({})(?!\s*(?::|=>))", any_whole(both)), &[(1, scope)])
    };
    let directs = |row: Instruction| {
        matches!(row.operand(), OperandClass::Label | OperandClass::CallBlock | OperandClass::Call)
            || matches!(row, Instruction::BlockEnd | Instruction::BlockEndUnconditional | Instruction::BlockEndConditional)
    };
    let extensions = Word::ALL.map(Word::spelling);
    let jumps = Instruction::ALL.iter().filter(|row| row.operand() == OperandClass::Label).flat_map(|row| [row.english(), row.german()]);
    json!({ "patterns": [
        // A label such as `m001` is no address.
        parts(
            &format!(r"(?i)(?<=^|;|:)\s*({})\s+({NAME})(?!\s*(?::|=>))", any_of(jumps)),
            &[(1, "keyword.control.jump.awl"), (2, "entity.name.label.awl")],
        ),
        rule("keyword.other.instruction.awl", &|row| !directs(row)),
        rule("keyword.control.jump.awl", &directs),
        parts(&format!(r"(?i)(?<=^|;|:)\s*({})", any_of(extensions.iter().map(String::as_str))), &[(1, "keyword.other.extension.awl")]),
    ] })
}

/// The parameters of a call: there no word is an instruction.
fn call() -> Vec<Value> {
    let parameter = rule("variable.parameter.awl", &format!(r"{NAME}(?=\s*(?::=|=>))"));
    let inner = [include("comments"), parameter.clone(), rule("keyword.operator.assignment.awl", ":=|=>"), include("operands")];
    let before = r"(?<=[\s\w,])";
    vec![
        region_with_parts(
            &format!(r"{before}(\()"),
            &[(1, "punctuation.section.parameters.awl")],
            r"(\))|(?=;)",
            &[(1, "punctuation.section.parameters.awl")],
            &inner,
        ),
        // Without parentheses each parameter has a line.
        parts(&format!(r"^\s*({NAME})\s*(:=|=>)"), &[(1, "variable.parameter.awl"), (2, "keyword.operator.assignment.awl")]),
    ]
}

/// Where a network begins: what follows is written as it says.
fn networks() -> Value {
    let end = format!(r"(?i)(?={ALONE}(?:NETWORK|{})\b)", any_of(words::of(Kind::Block)));
    let network = |notations: &str, inner: &str| {
        region_with_parts(
            &format!(r"(?i){ALONE}(NETWORK)\s+({notations})\b"),
            &[(1, "keyword.control.network.awl"), (2, "keyword.other.notation.awl")],
            &end,
            &[],
            &[include("comments"), include("title"), include(inner)],
        )
    };
    json!({ "patterns": [
        network("STL|AWL", "statements"),
        network("LAD|KOP|FBD|FUP", "diagram"),
        alone("keyword.control.network.awl", ["NETWORK"]),
    ] })
}

/// A diagram: elements at the beginning of a line, boxes and outputs anywhere.
fn diagram() -> Value {
    let boxes = BOXES
        .iter()
        .map(|row| row.name)
        .chain(TimerKind::ALL.map(|row| row.2))
        .chain(CounterKind::ALL.map(|row| row.1))
        .chain(["SR", "RS", "CALL"]);
    let boxes = any_of(boxes);
    let is_box = |word: &str| matches!(word, "SR" | "RS" | "CALL");
    let branches = ["OR", "AND", "XOR", "BRANCH", "END", "LABEL", "TAP"];
    let elements = || ELEMENTS.iter().map(|row| row.word).filter(|word| !is_box(word));
    json!({ "patterns": [
        include("comments"),
        include("title"),
        include("networks"),
        parts(&format!(r"^\s*(LABEL)\s+({NAME})(:)?"), &[(1, "keyword.control.branch.awl"), (2, "entity.name.label.awl")]),
        parts(&format!(r"^\s*(/?(?:{}))(?![\w<>])", any_of(branches)), &[(1, "keyword.control.branch.awl")]),
        parts(&format!(r"^\s*(/?(?:{}))(?!\w)(?!\s*(?::=|=>))", any_of(elements())), &[(1, "keyword.other.element.awl")]),
        parts(&format!(r"^\s*({boxes})(?!\w)(?!\s*(?::=|=>))"), &[(1, "support.function.box.awl")]),
        rule("support.function.box.awl", &format!(r"{ALONE}(?:{boxes})(?=\s*[(\[])")),
        parts(&format!(r"(?<=->|,|;)\s*({})(?=\s)(?!\s*(?::=|=>))", any_of(elements().chain(["S", "R"]))), &[(1, "keyword.other.element.awl")]),
        rule("variable.parameter.awl", &format!(r"{NAME}(?=\s*(?::=|=>))")),
        rule("variable.parameter.awl", &format!(r"^\s*{NAME}(?=\s*:)")),
        rule("keyword.operator.assignment.awl", ":=|=>"),
        rule("keyword.operator.awl", r"->|\|-|[|/!&]|(?:==|<>|>=|<=|>|<)[IDR]?\b|="),
        include("operands"),
    ] })
}

/// What instructions and elements are done with.
fn operands() -> Value {
    json!({ "patterns": [
        local("awl"),
        symbol("awl"),
        characters("awl"),
        typed_constant("awl", CONSTANT_TYPES),
        address("awl"),
        numbered("awl"),
        indirect_address("awl"),
        alone("variable.language.status.awl", words::of(Kind::Status)),
        number("awl"),
    ] })
}
