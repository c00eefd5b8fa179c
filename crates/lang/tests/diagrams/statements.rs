//! Statements in one line, and what is known of their operands by how they are written.

use sieben_lang::network::operand::Operand;
use sieben_lang::network::read::notation::ByNotation;
use sieben_lang::network::statement::{Parameter, Passing, Statement};
use sieben_lang::network::write::scratch_number;
use sieben_lang::stl::instructions::Instruction;

/// Nothing is known but how operands are written.
pub(crate) const PLAIN: ByNotation = ByNotation { branch_result_matters: false };

fn mnemonic(text: &str) -> &'static str {
    let german = match text {
        "U" => "A",
        "UN" => "AN",
        other => other,
    };
    Instruction::ALL.iter().map(|row| row.english()).find(|name| *name == german).unwrap_or_else(|| panic!("{text} is no instruction"))
}

/// `A I0.0; = Q4.0`.
pub(crate) fn statements(text: &str) -> Vec<Statement> {
    text.split("; ").map(|part| statement(part.trim())).collect()
}

fn statement(text: &str) -> Statement {
    let (label, text) = match text.split_once(": ") {
        Some((label, rest)) if !label.contains(' ') => (Some(Operand::from(label)), rest),
        _ => (None, text),
    };
    let (name, operand) = text.split_once(' ').unwrap_or((text, ""));
    let operand = match name {
        "U" | "UN" => operand.replace('E', "I"),
        "=" if operand.starts_with("A ") => operand.replace('A', "Q"),
        _ => operand.to_owned(),
    };
    let squeezed = |text: &str| Operand::from(text.replace(' ', ""));
    if name != "CALL" {
        return Statement { label, ..Statement::new(mnemonic(name), squeezed(&operand)) };
    }
    let (head, list) = operand.split_once(" (").map_or((operand.as_str(), ""), |(head, list)| (head, list.trim_end_matches(')')));
    let (block, instance) = head.split_once(',').map_or((head, None), |(block, instance)| (block, Some(squeezed(instance))));
    let parameters = list.split(',').filter_map(|one| one.split_once(":=")).map(|(name, actual)| Parameter {
        name: squeezed(name),
        actual: squeezed(actual),
        passing: Passing::In,
    });
    Statement { label, instance, parameters: parameters.collect(), ..Statement::new("CALL", squeezed(block)) }
}

/// The first bit of local data that statements use for T-branches and pins.
pub(crate) fn first_scratch(statements: &[Statement]) -> u32 {
    statements.iter().filter(|one| one.mnemonic == "=").find_map(|one| scratch_number(&one.operand)).unwrap_or(160)
}

fn shown(statement: &Statement) -> String {
    let label = statement.label.as_ref().map(|label| format!("{label}: ")).unwrap_or_default();
    let operand = if statement.operand.is_empty() { String::new() } else { format!(" {}", statement.operand) };
    let instance = statement.instance.as_ref().map(|instance| format!(", {instance}")).unwrap_or_default();
    let parameters: Vec<String> = statement.parameters.iter().map(|one| format!("{} := {}", one.name, one.actual)).collect();
    let parameters = if parameters.is_empty() { String::new() } else { format!(" ( {} )", parameters.join(", ")) };
    format!("{label}{}{operand}{instance}{parameters}", statement.mnemonic)
}

/// Statements in one line.
pub(crate) fn all_shown(statements: &[Statement]) -> String {
    statements.iter().map(shown).collect::<Vec<_>>().join("; ")
}
