//! What can be written in Structured Text.

use sieben_lang::names::{Definition, DefinitionKind};
use sieben_lang::st::Dialect;
use sieben_lang::st::parser::words;
use sieben_lang::st::standard::catalogue::{names, page};
use sieben_model::types::DataType;

use super::super::context::{self, Quoting, call, line_before};
use super::Kind;
use super::collect::{Collector, Rank, detail};
use super::stl::{Section, section};

pub(super) fn collect(to: &mut Collector<'_>, dialect: Dialect) {
    let Some(text) = to.snapshot.text(to.position.text) else { return };
    let text = &*text.text;
    if !to.typed.path.is_empty() {
        return to.members();
    }
    let line = line_before(text, to.typed.start);
    if section(text, to.position.offset) == Section::Declarations {
        match line.rfind(':').is_some_and(|at| !line[at..].starts_with(":=")) {
            true => types(to),
            false if !line.contains(":=") => keyword(to, "END_VAR"),
            false => values(to, dialect),
        }
        return;
    }
    if let Some(call) = call(to.snapshot, to.position)
        && let Some(callee) = call.callee.filter(|_| call.name.is_none())
    {
        let block = context::block_of(to.snapshot, callee);
        let sign = |one: &Definition| if one.kind == DefinitionKind::Output { "=>" } else { ":=" };
        to.parameters(block, &call.given, sign);
    }
    values(to, dialect);
}

fn keyword(to: &mut Collector<'_>, word: &str) {
    to.add(Rank::Word, Kind::Keyword, word, word.to_owned(), "keyword".to_owned(), String::new());
}

fn types(to: &mut Collector<'_>) {
    for word in DataType::words() {
        to.add(Rank::Fitting, Kind::Type, word, word.to_owned(), "type".to_owned(), String::new());
    }
    to.snippet(Rank::Fitting, Kind::Type, "ARRAY", "ARRAY [${1:1}..${2:10}] OF ${3:INT}".to_owned(), "array".to_owned());
    for (written, one, _) in
        to.globals(|one| matches!(one.kind, DefinitionKind::Type | DefinitionKind::FunctionBlock | DefinitionKind::Interface))
    {
        let kind = super::super::symbols::kind(one.kind);
        to.add(Rank::Local, kind, &written.clone(), written, detail(one), one.comment.clone());
    }
}

fn values(to: &mut Collector<'_>, dialect: Dialect) {
    let marks = dialect.base() == Dialect::Tia || to.typed.word.quoting == Quoting::Local;
    to.locals(if marks { "#" } else { "" }, |_| true);
    if to.typed.word.quoting == Quoting::Local {
        return;
    }
    to.symbols(|_| true);
    let fits = |one: &Definition| {
        use DefinitionKind::*;
        matches!(one.kind, Function | DataBlock | Global | Constant | EnumValue | Group | Program | Type)
    };
    for (written, one, target) in to.globals(fits) {
        let kind = super::super::symbols::kind(one.kind);
        let rank = to.rank(target);
        to.add(rank, kind, &written.clone(), written, detail(one), one.comment.clone());
    }
    if to.typed.word.quoting == Quoting::Global {
        return;
    }
    for name in names() {
        let page = page(name);
        let form = page.and_then(|page| page.calls.first()).map_or("", |form| form);
        to.add(Rank::Other, Kind::Function, name, name.to_owned(), form.to_owned(), page.map_or("", |page| page.purpose).to_owned());
    }
    for word in words() {
        keyword(to, word);
    }
    for (label, new_text) in [
        ("IF … END_IF", "IF ${1:condition} THEN\n\t$0\nEND_IF;"),
        ("FOR … END_FOR", "FOR ${1:i} := ${2:1} TO ${3:10} DO\n\t$0\nEND_FOR;"),
        ("CASE … END_CASE", "CASE ${1:value} OF\n\t${2:1}: $0\nEND_CASE;"),
        ("WHILE … END_WHILE", "WHILE ${1:condition} DO\n\t$0\nEND_WHILE;"),
    ] {
        to.snippet(Rank::Word, Kind::Snippet, label, new_text.to_owned(), "statement".to_owned());
    }
}
