//! The outline of a source of Structured Text.

use sieben_lang::st::ast::{
    Block, BlockKind, Declaration, Item, Method, Name, Qualifier, SectionKind, TestPart, TypeKind, TypeSpec, VarSection,
};

use super::outline::{Kind, Row};
use super::{Place, Text, place};

pub(super) fn rows(text: &Text<'_>, items: &[Item]) -> Vec<Row> {
    let mut rows = Vec::new();
    for item in items {
        match item {
            Item::Block(one) => rows.push(block(text, one)),
            Item::DataBlock(one) => {
                let mut fields = of_type(text, &one.data_type);
                fields.extend(sections(text, &one.sections));
                rows.push(named(Kind::DataBlock, &one.name, place(one.span), "DATA_BLOCK").rows(fields));
            }
            Item::Type(one) => {
                let row = named(Kind::Type, &one.name, place(one.span), "TYPE");
                rows.push(row.detail(type_text(text, &one.data_type)).rows(of_type(text, &one.data_type)));
            }
            Item::Globals(section) => rows.extend(sections(text, std::slice::from_ref(section))),
            Item::Interface(one) => {
                let mut members: Vec<Row> = one.methods.iter().map(|one| method(text, one)).collect();
                members.extend(one.properties.iter().map(|one| named(Kind::Member, &one.name, place(one.span), "PROPERTY")));
                rows.push(named(Kind::Interface, &one.name, place(one.span), "INTERFACE").rows(members));
            }
            Item::Namespace(one) => {
                let name = text.line(place(one.name.span));
                let row = Row::new(Kind::Namespace, filled(name, "NAMESPACE"), place(one.span), place(one.name.span));
                rows.push(row.rows(self::rows(text, &one.items)));
            }
            Item::Configuration(one) => rows.push(named(Kind::Namespace, &one.name, place(one.span), "CONFIGURATION")),
            Item::Using(_) => {}
        }
    }
    rows
}

/// Editors do not show a row without a name.
fn filled(name: String, otherwise: &str) -> String {
    if name.trim().is_empty() { otherwise.to_owned() } else { name }
}

fn named(kind: Kind, name: &Name, whole: Place, otherwise: &str) -> Row {
    let place = if name.text.is_empty() { (whole.0, whole.0) } else { place(name.span) };
    Row::new(kind, filled(name.text.clone(), otherwise), whole, place)
}

fn block(text: &Text<'_>, block: &Block) -> Row {
    let whole = place(block.span);
    let (kind, word) = match block.kind {
        BlockKind::Program => (Kind::Program, "PROGRAM"),
        BlockKind::OrganizationBlock => (Kind::Program, "ORGANIZATION_BLOCK"),
        BlockKind::Implicit => (Kind::Program, "OB 1"),
        BlockKind::Function => (Kind::Function, "FUNCTION"),
        BlockKind::FunctionBlock => (Kind::FunctionBlock, "FUNCTION_BLOCK"),
        BlockKind::Class => (Kind::FunctionBlock, "CLASS"),
        BlockKind::Interface => (Kind::Interface, "INTERFACE"),
        BlockKind::Method => (Kind::Member, "METHOD"),
        BlockKind::Test(TestPart::Setup) => (Kind::Test, "SETUP"),
        BlockKind::Test(TestPart::Teardown) => (Kind::Test, "TEARDOWN"),
        BlockKind::Test(TestPart::Test) => (Kind::Test, "TEST"),
    };
    let title = block.header.title.as_ref();
    let mut row = match (kind, title) {
        (Kind::Test, Some(title)) => named(kind, title, whole, word),
        _ => named(kind, &block.name, whole, word).detail(title.map(|title| title.text.clone()).unwrap_or_default()),
    };
    let mut rows = sections(text, &block.sections);
    rows.extend(block.methods.iter().map(|one| method(text, one)));
    rows.extend(block.properties.iter().map(|one| named(Kind::Member, &one.name, place(one.span), "PROPERTY")));
    rows.extend(block.actions.iter().map(|one| named(Kind::Member, &one.name, place(one.span), "ACTION")));
    rows.sort_by_key(|row| row.whole);
    row.rows = rows;
    row
}

fn method(text: &Text<'_>, method: &Method) -> Row {
    named(Kind::Member, &method.name, place(method.span), "METHOD").rows(sections(text, &method.sections))
}

fn sections(text: &Text<'_>, sections: &[VarSection]) -> Vec<Row> {
    let row = |section: &VarSection| {
        let whole = place(section.span);
        let word = text.slice(whole).split_whitespace().next().unwrap_or("VAR").to_uppercase();
        let end = (whole.0 + word.len()).min(whole.1);
        let is_constant = section.kind == SectionKind::Const || section.has(Qualifier::Constant);
        let kind = if is_constant { Kind::Constant } else { Kind::Variable };
        Row::new(Kind::Section, word, whole, (whole.0, end)).rows(declarations(text, &section.declarations, kind))
    };
    sections.iter().map(row).collect()
}

fn declarations(text: &Text<'_>, declarations: &[Declaration], kind: Kind) -> Vec<Row> {
    let mut rows = Vec::new();
    for declaration in declarations {
        for name in declaration.names.iter().map(|declared| &declared.name).filter(|name| !name.text.is_empty()) {
            let row = named(kind, name, place(declaration.span), "VAR").detail(type_text(text, &declaration.data_type));
            rows.push(row.rows(of_type(text, &declaration.data_type)));
        }
    }
    rows
}

/// A type in one line; what has fields shows them below.
fn type_text(text: &Text<'_>, data_type: &TypeSpec) -> String {
    match &data_type.kind {
        TypeKind::Struct { .. } => "STRUCT".to_owned(),
        TypeKind::Union(_) => "UNION".to_owned(),
        _ => text.line(place(data_type.span)),
    }
}

fn of_type(text: &Text<'_>, data_type: &TypeSpec) -> Vec<Row> {
    match &data_type.kind {
        TypeKind::Struct { fields, .. } | TypeKind::Union(fields) => declarations(text, fields, Kind::Variable),
        _ => Vec::new(),
    }
}
