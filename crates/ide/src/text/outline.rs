//! The outline of a source: its blocks with their declarations and networks.

use sieben_lang::stl::ast::{Block, Declaration, TypeKind, TypeName};
use sieben_model::block::BlockKind;

use super::{Place, Text, Tree, outline_st, place};

/// What a row of an outline is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An organization block or a program.
    Program,
    /// A function.
    Function,
    /// A function block or a class.
    FunctionBlock,
    /// A data block.
    DataBlock,
    /// A type.
    Type,
    /// A list of declarations.
    Section,
    /// A variable, parameter or field.
    Variable,
    /// A constant.
    Constant,
    /// A network.
    Network,
    /// A label that is jumped to.
    Label,
    /// A method, an action or a property.
    Member,
    /// An interface.
    Interface,
    /// A namespace or a configuration.
    Namespace,
    /// A test of a test file.
    Test,
}

/// A row of an outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What it is called.
    pub name: String,
    /// More about it: a title, a type.
    pub detail: String,
    /// What it is.
    pub kind: Kind,
    /// All of it.
    pub whole: Place,
    /// Its name; it lies inside of the whole.
    pub named: Place,
    /// What is in it.
    pub rows: Vec<Row>,
}

impl Row {
    pub(super) fn new(kind: Kind, name: impl Into<String>, whole: Place, named: Place) -> Self {
        // Editors drop an outline whose names lie elsewhere.
        let inside = |at: usize| at.clamp(whole.0, whole.1.max(whole.0));
        let named = (inside(named.0), inside(named.1.max(named.0)));
        Self { name: name.into(), detail: String::new(), kind, whole, named, rows: Vec::new() }
    }

    pub(super) fn detail(mut self, detail: impl Into<String>) -> Self {
        self.detail = detail.into();
        self
    }

    pub(super) fn rows(mut self, rows: Vec<Row>) -> Self {
        self.rows = rows;
        self
    }
}

impl Text<'_> {
    /// Its outline.
    pub fn outline(&self) -> Vec<Row> {
        match &self.tree {
            Tree::Stl(parsed) => parsed.file.blocks.iter().map(|block| self.block(block)).collect(),
            Tree::St(parsed) => outline_st::rows(self, &parsed.file.items),
        }
    }

    /// A text in one line.
    pub(super) fn line(&self, place: Place) -> String {
        self.slice(place).split_whitespace().collect::<Vec<_>>().join(" ")
    }

    fn block(&self, block: &Block) -> Row {
        let kind = match block.kind {
            BlockKind::OrganizationBlock => Kind::Program,
            BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock => Kind::FunctionBlock,
            BlockKind::DataBlock => Kind::DataBlock,
            BlockKind::UserDefinedType => Kind::Type,
            _ => Kind::Function,
        };
        let whole = place(block.span);
        let (name, named) = match block.implicit {
            true => ("OB 1".to_owned(), (whole.0, whole.0)),
            false => (self.line(place(block.name.span())), place(block.name.span())),
        };
        let mut rows: Vec<Row> = Vec::new();
        for section in &block.sections {
            let whole = place(section.span);
            let word = self.slice(whole).split_whitespace().next().unwrap_or("VAR").to_uppercase();
            let fields = self.declarations(&section.declarations);
            rows.push(Row::new(Kind::Section, word.clone(), whole, (whole.0, whole.0 + word.len())).rows(fields));
        }
        if let Some(body) = &block.body_type {
            rows.extend(self.fields(body));
        }
        rows.extend(self.networks(block));
        let title = block.header.title.as_ref().map(|title| title.text.clone()).unwrap_or_default();
        Row::new(kind, name, whole, named).detail(title).rows(rows)
    }

    fn declarations(&self, declarations: &[Declaration]) -> Vec<Row> {
        let mut rows = Vec::new();
        for declaration in declarations {
            let data_type = match &declaration.data_type.kind {
                TypeKind::Struct(_) => "STRUCT".to_owned(),
                _ => self.line(place(declaration.data_type.span)),
            };
            for name in &declaration.names {
                let row = Row::new(Kind::Variable, name.text.clone(), place(declaration.span), place(name.span));
                rows.push(row.detail(data_type.clone()).rows(self.fields(&declaration.data_type)));
            }
        }
        rows
    }

    fn fields(&self, data_type: &TypeName) -> Vec<Row> {
        match &data_type.kind {
            TypeKind::Struct(fields) => self.declarations(fields),
            TypeKind::Array { element, .. } => self.fields(element),
            _ => Vec::new(),
        }
    }

    fn networks(&self, block: &Block) -> Vec<Row> {
        let end = place(block.span).1;
        let begins = |index: usize| block.networks.get(index).map(|network| place(network.span).0);
        let mut rows: Vec<Row> = Vec::new();
        for (index, network) in block.networks.iter().enumerate() {
            let named = place(network.span);
            let last = block.statements.last().map_or(named.1, |statement| place(statement.span).1.max(named.1));
            let to = begins(index + 1).unwrap_or(if network.drawing.is_some() { end } else { last });
            let to = named.1.max(named.0 + self.slice((named.0, to)).trim_end().len());
            let name = format!("Network {}", index + 1);
            rows.push(Row::new(Kind::Network, name, (named.0, to), named).detail(network.title.clone()));
        }
        for label in block.statements.iter().filter_map(|statement| statement.label.as_ref()) {
            let named = place(label.span);
            let row = Row::new(Kind::Label, label.text.clone(), named, named);
            match rows.iter_mut().find(|network| (network.whole.0..=network.whole.1).contains(&named.0)) {
                Some(network) => network.rows.push(row),
                None => rows.push(row),
            }
        }
        rows
    }
}
