//! A network as a function of its own.

use sieben_lang::stl::ast::{Network, Operand, Statement};
use sieben_lang::stl::instructions::{Effect, Instruction};
use sieben_lang::stl::operands::OperandClass;
use sieben_lang::stl::parser::parse_as;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

use super::{Action, At, Bytes, Kind};

/// Makes the network at the cursor a function that is called there.
pub(super) fn action(at: &At<'_>) -> Option<Action> {
    let language = at.snapshot.language(at.text)?;
    if language.dialect().is_some() {
        return None;
    }
    let text = at.content();
    let mnemonics = at.snapshot.of_text(at.text)?.mnemonics?;
    // The cursor is in the line of the keyword, or more than one line is selected.
    let line = super::super::context::line_before(text, at.range.start);
    let line_start = at.range.start - line.len();
    let is_head = text.get(line_start..)?.trim_start_matches([' ', '\t']).get(..7).is_some_and(|word| word.eq_ignore_ascii_case("NETWORK"));
    let is_selection = text.get(at.range.start..at.range.end).is_some_and(|selected| selected.contains(['\n', '\r']));
    if !is_head && !is_selection {
        return None;
    }
    let parsed = parse_as(FileId::default(), text, Some(mnemonics), language.drawing());
    let touches = |network: &Network| {
        let start = network.span.start as usize;
        line_start <= start && start <= at.range.end.max(line_start + line.len() + 8)
    };
    let (block, number) = parsed.file.blocks.iter().find_map(|block| Some((block, block.networks.iter().position(touches)?)))?;
    let title = "Extract the network to a function";
    let refused = |reason: String| Some(Action::disabled(Kind::Extract, title, reason));
    let network = &block.networks[number];
    let end = block.networks.get(number + 1).map_or(block.statements.len(), |next| next.first_statement);
    let statements = block.statements.get(network.first_statement..end).unwrap_or_default();
    let (Some(first), Some(last)) = (statements.first(), statements.last()) else {
        return refused("the network has no statements".to_owned());
    };
    if network.drawing.is_some() {
        return refused("the network is a diagram; write it as statements first".to_owned());
    }
    if block.implicit {
        return refused("its statements stand in no block; put them into an organization block first".to_owned());
    }
    if let Some(reason) = statements.iter().find_map(|statement| obstacle(statement, mnemonics)) {
        return refused(reason);
    }
    if !begins(first, mnemonics) {
        return refused(format!("its first statement `{}` works on what the network before it left", first.mnemonic.text));
    }
    if let Some(next) = block.statements.get(end).filter(|next| !begins(next, mnemonics)) {
        return refused(format!("the statement after it, `{}`, works on what it leaves", next.mnemonic.text));
    }
    if let Err(reason) = is_apart(&block.statements, network.first_statement, end, mnemonics) {
        return refused(reason);
    }
    let taken = |number: u16| at.snapshot.names().blocks().any(|(block, _)| block == BlockId::fc(number));
    let Some(free) = (1..=u16::MAX).find(|number| !taken(*number)) else { return refused("no number of a function is free".to_owned()) };
    let (from, to) = (first.span.start as usize, after(text, last.span.end as usize));
    let body_start = from - super::super::context::line_before(text, from).len();
    let body = text.get(body_start..to)?;
    let end_of_line = at.line_end();
    let mut function = format!("FUNCTION FC {free} : VOID{end_of_line}");
    if !network.title.trim().is_empty() {
        function.push_str(&format!("TITLE = {}{end_of_line}", network.title.trim()));
    }
    function.push_str(&format!("BEGIN{end_of_line}NETWORK{end_of_line}{body}{end_of_line}END_FUNCTION{end_of_line}{end_of_line}"));
    let indent: String = body.chars().take_while(|sign| matches!(sign, ' ' | '\t')).collect();
    let call = format!("{indent}CALL  FC {free};");
    let block_start = block.span.start as usize;
    let block_line = block_start - super::super::context::line_before(text, block_start).len();
    let edits = vec![at.edit(Bytes { start: block_line, end: block_line }, function), at.edit(Bytes { start: body_start, end: to }, call)];
    Some(Action::new(Kind::Extract, format!("{title}, FC {free}"), edits))
}

/// Where a statement ends with its semicolon.
fn after(text: &str, end: usize) -> usize {
    let rest = text.get(end..).unwrap_or_default();
    let blanks = rest.len() - rest.trim_start_matches([' ', '\t']).len();
    if rest[blanks..].starts_with(';') { end + blanks + 1 } else { end }
}

/// Why a statement must stay in its block.
fn obstacle(statement: &Statement, mnemonics: Mnemonics) -> Option<String> {
    let english = Instruction::candidates(&statement.mnemonic.text, mnemonics).next().map_or("", Instruction::english);
    let written = &statement.mnemonic.text;
    if let Some(label) = &statement.label {
        return Some(format!("it has the label `{}`, which may be jumped to", label.text));
    }
    if Instruction::candidates(written, mnemonics).any(|row| row.operand() == OperandClass::Label) {
        return Some(format!("`{written}` jumps to a label of its block"));
    }
    match english {
        "BE" | "BEC" | "BEU" => return Some(format!("`{written}` would end the function and no longer its block")),
        "LAR1" | "LAR2" | "TAR1" | "TAR2" | "CAR" | "+AR1" | "+AR2" => {
            return Some(format!("`{written}` works with an address register of its block"));
        }
        "OPN" | "CDB" => return Some(format!("`{written}` changes a data block register of its block")),
        "MCR(" | ")MCR" | "MCRA" | "MCRD" => return Some(format!("`{written}` belongs to the master control relay of its block")),
        _ => {}
    }
    of_operand(&statement.operand)
}

fn of_operand(operand: &Operand) -> Option<String> {
    match operand {
        Operand::Local { name, .. } => Some(format!("it uses `#{}` of its block", name.text)),
        Operand::AddressOf(name) => Some(format!("it takes the address of `#{}` of its block", name.text)),
        Operand::Name { word, .. } => {
            let is_status = matches!(word.text.to_ascii_uppercase().as_str(), "DBLG" | "DBNO" | "DILG" | "DINO" | "AR2");
            match is_status {
                true => Some(format!("`{}` is a register of its block", word.text)),
                // Bits of the status word are not looked at: a name alone may be one.
                false => Some(format!("`{}` may be something of its block", word.text)),
            }
        }
        Operand::Absolute { letters, .. } => of_letters(letters),
        Operand::Indirect { letters, pointer, .. } => of_letters(letters).or_else(|| of_operand(pointer)),
        Operand::RegisterIndirect { register, .. } => Some(format!("it uses the address register {} of its block", register.text)),
        Operand::PointerTo { target, .. } => of_operand(target),
        Operand::Scratch { .. } => Some("it uses local data of its block".to_owned()),
        Operand::List(all) => all.iter().find_map(|(operand, _)| of_operand(operand)),
        Operand::Call(call) => {
            let parts = std::iter::once(&call.callee).chain(call.instance.iter().map(|(instance, _)| instance));
            parts.chain(call.arguments.iter().map(|argument| &argument.value)).find_map(of_operand)
        }
        Operand::Symbol { .. }
        | Operand::None
        | Operand::Constant(_)
        | Operand::InBlock { .. }
        | Operand::BlockField { .. }
        | Operand::Register { .. } => None,
        Operand::Error => Some("it has an operand that is not understood".to_owned()),
    }
}

fn of_letters(letters: &str) -> Option<String> {
    if BlockKind::from_abbreviation(letters).is_some() {
        return None;
    }
    match letters.chars().next() {
        Some('D') => Some(format!("`{letters}` lies in the data block that its block has opened")),
        Some('L' | 'V') => Some(format!("`{letters}` is local data of its block")),
        _ => None,
    }
}

/// Whether a statement works on nothing that statements before it left.
fn begins(statement: &Statement, mnemonics: Mnemonics) -> bool {
    let english = Instruction::candidates(&statement.mnemonic.text, mnemonics).next().map_or("", Instruction::english);
    matches!(
        english,
        "A" | "AN"
            | "O"
            | "ON"
            | "X"
            | "XN"
            | "A("
            | "AN("
            | "O("
            | "ON("
            | "X("
            | "XN("
            | "L"
            | "LC"
            | "SET"
            | "CLR"
            | "CALL"
            | "NOP"
            | "OPN"
            | "UC"
    )
}

/// Whether the statements from `first` to before `end` do the same in a function: a call ends a logic string, clears OS and has its own MCR.
fn is_apart(all: &[Statement], first: usize, end: usize, mnemonics: Mnemonics) -> Result<(), String> {
    let (before, rest) = all.split_at(first.min(all.len()));
    let (_, later) = rest.split_at((end.saturating_sub(first)).min(rest.len()));
    if let Err(statement) = ends_logic(before, mnemonics) {
        return Err(format!("the logic string before it goes on after `{}`, and a call would end it", statement.mnemonic.text));
    }
    if let Err(statement) = ends_logic(&all[..end.min(all.len())], mnemonics) {
        return Err(format!("its logic string goes on after its end, at `{}`, and the call would end it", statement.mnemonic.text));
    }
    // A jump back leads to statements before it.
    let again = if before.iter().any(|one| one.label.is_some()) { before } else { &[] };
    if let Some(reader) = later.iter().chain(again).find(|one| reads_stored_overflow(one, mnemonics)) {
        return Err(format!("`{}` reads the bit OS, which the call clears", reader.mnemonic.text));
    }
    match before.iter().any(|one| one.mnemonic.text.eq_ignore_ascii_case("MCRA")) {
        true => Err("the master control relay is active there, and a function has its own".to_owned()),
        false => Ok(()),
    }
}

/// Whether /FC is 0 and no bracket is open after statements that begin a block; otherwise the statement that leaves it so.
fn ends_logic(statements: &[Statement], mnemonics: Mnemonics) -> Result<(), &Statement> {
    let mut brackets: Vec<&Statement> = Vec::new();
    for statement in statements {
        match statement.mnemonic.text.as_str() {
            ")" => _ = brackets.pop(),
            written if written.ends_with('(') && !written.eq_ignore_ascii_case("MCR(") => brackets.push(statement),
            _ => {}
        }
    }
    if let Some(open) = brackets.last() {
        return Err(open);
    }
    for statement in statements.iter().rev() {
        match first_check(statement, mnemonics) {
            Effect::Cleared => return Ok(()),
            // What jumps here may come from a logic string.
            Effect::Unaffected if statement.label.is_none() => {}
            _ => return Err(statement),
        }
    }
    Ok(())
}

/// What a statement does to /FC: the last column of its status row.
fn first_check(statement: &Statement, mnemonics: Mnemonics) -> Effect {
    if statement.mnemonic.text.is_empty() {
        return Effect::Unaffected;
    }
    let is_status_word = is_name(&statement.operand, "STW");
    let has_operand = statement.operand != Operand::None;
    let all = Instruction::candidates(&statement.mnemonic.text, mnemonics).filter(|row| match row.operand() {
        OperandClass::StatusWord => is_status_word,
        OperandClass::None => !has_operand,
        OperandClass::ScanBit | OperandClass::Transfer | OperandClass::Load => has_operand && !is_status_word,
        _ => true,
    });
    let mut effects = all.map(|row| row.status()[8]);
    let first = effects.next().unwrap_or(Effect::Written);
    if effects.all(|other| other == first) { first } else { Effect::Written }
}

/// Whether a statement reads the bit OS: a jump that depends on it, a scan of it or the whole status word.
fn reads_stored_overflow(statement: &Statement, mnemonics: Mnemonics) -> bool {
    let is_jump = Instruction::candidates(&statement.mnemonic.text, mnemonics).any(|row| row == Instruction::JumpIfStoredOverflow);
    is_jump || is_name(&statement.operand, "OS") || is_name(&statement.operand, "STW")
}

fn is_name(operand: &Operand, name: &str) -> bool {
    matches!(operand, Operand::Name { word, .. } if word.text.eq_ignore_ascii_case(name))
}
