//! What is wrong with the rows of a symbol table: names, addresses, types, and rows that contradict one another.

use std::collections::HashMap;

use sieben_model::address::{Area, Operand, Width};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::symbols::Symbol;
use sieben_model::types::DataType;

use super::NAME_MAX;

/// Checks each row, and the rows against each other.
pub(super) fn rows(rows: &[(Symbol, Span)], unnamed: bool, diagnostics: &mut Vec<Diagnostic>) {
    let mut names: HashMap<String, usize> = HashMap::new();
    let mut operands: HashMap<Operand, usize> = HashMap::new();
    for (index, (symbol, span)) in rows.iter().enumerate() {
        let (name, address) = (symbol.name.as_str(), symbol.address.trim());
        if (name.is_empty() && !unnamed) || address.is_empty() {
            let message = match name.is_empty() {
                true => format!("this row names no symbol for `{address}`"),
                false => format!("the symbol `{name}` has no address"),
            };
            diagnostics.push(Diagnostic::new(Problem::P6107, *span, message));
        }
        if !name.is_empty() {
            check_name(name, *span, diagnostics);
            match names.get(&name.to_lowercase()) {
                Some(&first) => {
                    let (earlier, place) = &rows[first];
                    let message = format!("the symbol `{name}` stands twice: already for `{}`", earlier.address.trim());
                    diagnostics.push(Diagnostic::new(Problem::P6101, *span, message).related(*place, "first here"));
                }
                None => {
                    names.insert(name.to_lowercase(), index);
                }
            }
        }
        if address.is_empty() {
            continue;
        }
        let Some(operand) = symbol.operand() else {
            if !is_variable_table(address) {
                let message =
                    format!("`{address}` is not an address; write one such as `I 0.0`, `QW 4`, `M 10.3`, `T 1`, `C 0`, `DB 5` or `FC 1`");
                diagnostics.push(Diagnostic::new(Problem::P6103, *span, message));
            }
            continue;
        };
        check_operand(symbol, &operand, *span, diagnostics);
        match operands.get(&operand) {
            Some(&first) => {
                let (earlier, place) = &rows[first];
                let message = format!("`{address}` already has the symbol `{}`", earlier.name);
                diagnostics.push(Diagnostic::new(Problem::P6102, *span, message).related(*place, "first here"));
            }
            None => {
                operands.insert(operand, index);
            }
        }
    }
}

fn check_name(name: &str, span: Span, diagnostics: &mut Vec<Diagnostic>) {
    if name.contains('"') || name.chars().any(char::is_control) {
        diagnostics.push(Diagnostic::new(
            Problem::P6110,
            span,
            format!("the symbol `{}` contains a quotation mark or a control character", name.escape_debug()),
        ));
    }
    let length = name.chars().count();
    if length > NAME_MAX {
        diagnostics.push(Diagnostic::new(
            Problem::P6106,
            span,
            format!("the symbol `{name}` has {length} characters; STEP 7 V5 takes {NAME_MAX}"),
        ));
    }
}

/// Entries of tables of variables, `VAT 1`, stand in exports and mean nothing to a program.
pub(super) fn is_variable_table(address: &str) -> bool {
    let (word, number) = address.split_at(address.find(|character: char| !character.is_ascii_alphabetic()).unwrap_or(address.len()));
    word.eq_ignore_ascii_case("VAT") && number.trim().parse::<u16>().is_ok()
}

/// Whether the address can have a symbol, and whether the data type fits its width.
fn check_operand(symbol: &Symbol, operand: &Operand, span: Span, diagnostics: &mut Vec<Diagnostic>) {
    let address = symbol.address.trim();
    if let Operand::Address(inner) = operand
        && matches!(inner.area, Area::Local | Area::CallerLocal | Area::SharedData | Area::InstanceData)
    {
        let message = format!("`{address}` cannot have a symbol: local data and open data blocks differ from block to block");
        diagnostics.push(Diagnostic::new(Problem::P6103, span, message));
        return;
    }
    let word = symbol.data_type.trim().to_ascii_uppercase();
    let valid = match (operand, word.as_str()) {
        (_, "") => None,
        (Operand::Timer(_), "TIMER") | (Operand::Counter(_), "COUNTER") => None,
        (Operand::Timer(_), _) => Some("TIMER"),
        (Operand::Counter(_), _) => Some("COUNTER"),
        (Operand::Address(inner) | Operand::InDataBlock { address: inner, .. }, _) => {
            match (DataType::from_word(&word).and_then(|data_type| data_type.width()), inner.width) {
                (Some(width), wanted) if width == wanted => None,
                (None, _) => None,
                (_, Width::Bit) => Some("BOOL"),
                (_, Width::Byte) => Some("BYTE or CHAR"),
                (_, Width::Word) => Some("WORD, INT, S5TIME or DATE"),
                (_, Width::DoubleWord | Width::QuadWord) => Some("DWORD, DINT, REAL, TIME or TIME_OF_DAY"),
            }
        }
        (Operand::Block(_), _) => None,
    };
    if let Some(valid) = valid {
        let message = format!("the type `{}` does not fit the address `{address}`, which is {valid}", symbol.data_type.trim());
        diagnostics.push(Diagnostic::new(Problem::P6109, span, message));
    }
}
