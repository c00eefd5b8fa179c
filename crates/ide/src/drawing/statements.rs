//! Statements as a picture, for a network that no diagram stands for.

use sieben_lang::network::model::Place;

use super::layout::{Label, Layout, Outline, Role, Symbol};
use super::names::width;

/// The kind of the symbols that are lines of statements.
const STATEMENT: &str = "statement";

/// Lays lines of text out.
pub fn statements(text: &str) -> Layout {
    let mut layout = Layout::default();
    for line in text.lines() {
        let shown = sieben_model::visible::name(&line.replace('\t', "    "));
        let written = shown.trim_end();
        let indent = written.len() - written.trim_start().len();
        layout.columns = layout.columns.max(width(written) + 1);
        if !written.is_empty() {
            let labels = vec![Label { column: indent, line: layout.lines, text: written.trim_start().to_owned(), role: Role::Name }];
            let (element, place, outline) = (String::new(), Place::default(), Outline::None);
            layout.symbols.push(Symbol { kind: STATEMENT, element, place, outline, labels, before: None, after: None, value: None });
        }
        layout.lines += 1;
    }
    layout
}
