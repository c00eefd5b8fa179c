//! What the statements of a network did, from the events of a run.

use std::collections::HashMap;

use sieben_cpu::Cpu;
use sieben_engine::machine::Registers;
use sieben_engine::{FaultPlace, Program, StatementEvent};
use sieben_ide::drawing::flow::{Executed, Status};
use sieben_model::block::BlockId;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::{Kind, Name, Scope};
use sieben_workspace::names;

use super::Written;

/// Watches the statements of one network; keeps what they did when they were executed last.
#[derive(Debug)]
pub(crate) struct Watch {
    block: BlockId,
    /// The place in the network of each statement, by its number in the block.
    places: HashMap<u32, usize>,
    /// The registers after each statement that was executed.
    after: Vec<Option<Registers>>,
    /// The statement that was executed last: an earlier one begins again.
    last: Option<usize>,
}

impl Watch {
    /// For the statements of a network.
    pub(crate) fn new(block: BlockId, network: &Written) -> Self {
        let numbered = network.numbers.iter().copied().zip(0..);
        // A label alone is no statement, and has no number of its own.
        let places = numbered.filter(|&(number, index)| number > 0 || index == 0 && network.number == 1).collect();
        Self { block, places, after: vec![None; network.statements.len()], last: None }
    }

    /// A scan begins: what was seen before is forgotten.
    pub(crate) fn begin(&mut self) {
        self.after.fill(None);
        self.last = None;
    }

    /// Takes in a statement that was executed.
    pub(crate) fn note(&mut self, event: &StatementEvent) {
        self.take(event.place, &event.after);
    }

    /// Takes in a statement with the registers after it.
    pub(crate) fn take(&mut self, place: FaultPlace, after: &Registers) {
        let Some(&index) = self.places.get(&place.statement).filter(|_| place.block == self.block) else { return };
        if self.last.is_some_and(|last| index <= last) {
            self.begin();
        }
        self.last = Some(index);
        self.after[index] = Some(after.clone());
    }

    /// What they did; addresses have the values that the CPU has now.
    pub(crate) fn status(&self, network: &Written, cpu: &Cpu, symbols: &SymbolTable) -> Status {
        self.status_with(network, (cpu.program(), symbols), &|operand| value_now(operand, cpu, symbols))
    }

    /// What they did; `value_now` has the values of addresses.
    pub(crate) fn status_with(
        &self,
        network: &Written,
        (program, symbols): (&Program, &SymbolTable),
        value_now: &dyn Fn(&str) -> Option<String>,
    ) -> Status {
        let statements = network.statements.iter().zip(&self.after).map(|(statement, after)| {
            let Some(after) = after else { return Executed::default() };
            let found = match statement.mnemonic {
                "A" | "AN" | "O" | "ON" | "X" | "XN" => Some(after.sta != 0),
                "FP" | "FN" | "NOT" => Some(after.rlo != 0),
                "CALL" => Some(after.br != 0),
                mnemonic if sieben_lang::network::boxes::COMPARISONS.contains(&mnemonic) => Some(after.rlo != 0),
                _ => None,
            };
            let mut values = Vec::new();
            if !statement.operand.is_empty() {
                // A variable of the block is as it was seen.
                let is_local = statement.operand.starts_with('#');
                let seen = match statement.mnemonic {
                    "A" | "AN" | "O" | "ON" | "X" | "XN" => Some(u8::from(after.sta != 0).to_string()),
                    "=" => Some(u8::from(after.rlo != 0).to_string()),
                    "L" | "T" if is_local => Some(self.local(&statement.operand, after.accu1, program, symbols)),
                    _ => None,
                };
                let value = value_now(&statement.operand).or(seen);
                values.extend(value.map(|value| (statement.operand.text.clone(), value)));
            }
            for parameter in &statement.parameters {
                let value = value_now(&parameter.actual);
                values.extend(value.map(|value| (parameter.actual.text.clone(), value)));
            }
            let logic = matches!(statement.mnemonic, "A" | "AN" | "O" | "ON" | "X" | "XN").then_some(after.rlo != 0);
            Executed { ran: true, found, logic, values }
        });
        Status { statements: statements.collect() }
    }

    /// What ACCU 1 has of a variable of the block, in the notation of its type.
    fn local(&self, operand: &str, accu1: u64, program: &Program, symbols: &SymbolTable) -> String {
        let scope = Scope { block: self.block, bare: false };
        let name = Name::parse_in(operand, Some(scope), symbols, program).ok().map(Name::readable);
        // A parameter that names a timer or a counter holds its number, not what was loaded.
        let is_number = |kind: &Kind| matches!(kind, Kind::Number) || matches!(kind, Kind::Typed(data_type) if data_type.is_number());
        match name.filter(|name| matches!(name.kind().width(), 8 | 16 | 32) && !is_number(name.kind())) {
            Some(name) => name.show_bits(accu1 & (u64::MAX >> (64 - name.kind().width()))).readable(),
            None => (accu1 as u32 as i32).to_string(),
        }
    }
}

/// The value of an address or symbol at this moment.
fn value_now(operand: &str, cpu: &Cpu, symbols: &SymbolTable) -> Option<String> {
    // What begins so is a constant, or lies in the local data of a block that has ended.
    if operand.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '#' | '-' | '+' | '\'')) || operand.contains('#') {
        return None;
    }
    let name = Name::parse(operand, symbols, cpu.program()).ok()?;
    name.read(cpu).ok()?;
    Some(names::readable(&name, cpu))
}
