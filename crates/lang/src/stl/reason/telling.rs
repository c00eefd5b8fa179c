//! Finds the sentences for one executed statement of STL.

use sieben_engine::StatementEvent;
use sieben_engine::machine::{Register, Registers};
use sieben_model::mnemonics::Mnemonics;

use super::operands::Named;
use super::{bits, control, faults, numbers, timers};
use crate::sentences::memory::Reader;
use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, Words, loose_words, one_line, pointer};
use crate::sentences::{Language, Moment, Surroundings};
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::Operand;
use crate::stl::why::Why;

/// What is known of the statement while its sentences are found.
pub(crate) struct Telling<'a> {
    pub(super) around: Surroundings<'a>,
    pub(super) block: &'a ResolvedBlock,
    pub(super) moment: Moment<'a>,
    /// `None` at the end of the block, which no statement says.
    pub(super) statement: Option<&'a Statement>,
    /// Spelling of addresses: that of the source.
    pub(super) mnemonics: Mnemonics,
}

impl<'a> Telling<'a> {
    pub(crate) fn new(around: Surroundings<'a>, block: &'a ResolvedBlock, moment: Moment<'a>) -> Self {
        let statement = block.statements.get(moment.event.place.statement as usize);
        let file = block.statements.first().map(|statement| statement.span().file);
        let mnemonics = file.and_then(|file| around.mnemonics.get(&file)).copied().unwrap_or_default();
        Self { around, block, moment, statement, mnemonics }
    }

    pub(super) fn event(&self) -> &'a StatementEvent {
        self.moment.event
    }

    /// The registers before the statement.
    pub(super) fn before(&self) -> &'a Registers {
        &self.moment.event.before
    }

    /// The registers behind it.
    pub(super) fn after(&self) -> &'a Registers {
        &self.moment.event.after
    }

    pub(super) fn operand(&self) -> &'a Operand {
        self.statement.map_or(&Operand::None, |statement| &statement.operand)
    }

    pub(super) fn why(&self) -> Why {
        self.statement.map_or(Why::End, |statement| statement.instruction.why())
    }

    /// The operand as it is written, in one line.
    pub(super) fn operand_text(&self) -> String {
        let text = self.statement.map_or_else(String::new, |statement| match &statement.stated {
            Some(stated) => stated.to_string(),
            None => one_line(self.around.slice(statement.span())),
        });
        let mnemonic = self.statement.map_or("", |statement| statement.instruction.mnemonic(self.mnemonics));
        match text.get(..mnemonic.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(mnemonic)) {
            true => text[mnemonic.len()..].trim().to_owned(),
            false => text.split_once(' ').map_or_else(String::new, |(_, operand)| operand.trim().to_owned()),
        }
    }

    /// Reads the memory: as it was before the statement, if that was kept.
    pub(super) fn reader(&self) -> Reader<'a> {
        let block = self.event().place.block;
        match self.moment.before {
            Some(before) => Reader::new(before, self.before(), block, false),
            None => Reader::new(self.moment.after, self.before(), block, self.called()),
        }
    }

    /// Whether the newest frame is that of a block which the statement called and whose statements come next. Only where the called
    /// block is the caller's own another one could be taken for it.
    fn called(&self) -> bool {
        let called = match (self.why(), self.operand()) {
            (Why::Call, Operand::Call(call)) => call.callee == self.event().place.block,
            (Why::CallBlock, _) => true,
            (Why::CallIfRlo, _) => self.before().rlo == 1,
            _ => false,
        };
        let frames = &self.moment.after.frames;
        // A call that failed, or of a system function, left no frame: the newest one then is the caller's.
        called && frames.len() > 1 && frames.last().is_some_and(|frame| frame.resume == 0)
    }

    /// The words of a clause with what every sentence may name.
    pub(super) fn words(&self, clause: &Clause) -> Words {
        clause.words(&|name| self.common(name))
    }

    /// What every sentence may name.
    fn common(&self, name: &str) -> Option<Words> {
        let (before, after) = (self.before(), self.after());
        let turns = |words: [[&str; 2]; 2]| {
            let [becomes, stays] = words;
            let words = if before.rlo == after.rlo { stays } else { becomes };
            Words(words.map(|word| format!("{word} {}", after.rlo)))
        };
        Some(match name {
            "rlo" => after.rlo.into(),
            "rlo_before" => before.rlo.into(),
            "rlo_turns" => turns([["becomes", "wird"], ["stays", "bleibt"]]),
            "rlo_turns_inverted" => turns([["becomes", "wird das VKE"], ["stays", "bleibt das VKE"]]),
            "accu1" => loose_words(after.accu1),
            "accu2" => loose_words(after.accu2),
            "accu3" => loose_words(after.accu3),
            "accu4" => loose_words(after.accu4),
            "accu1_before" => loose_words(before.accu1),
            "ar1" => pointer(after.ar1).into(),
            "ar2" => pointer(after.ar2).into(),
            "cc1" => after.cc1.into(),
            "cc0" => after.cc0.into(),
            "cc1_before" => before.cc1.into(),
            "br" => before.br.into(),
            _ => return None,
        })
    }

    /// The sentence.
    pub(crate) fn sentence(&self, language: Language) -> String {
        let named = Named::new(self);
        let render = |clause: &Clause| clause.render(language, &|name| self.common(name));
        let leading: String = named.leading.iter().map(render).collect();
        leading + &self.clauses(&named).iter().map(render).collect::<Vec<_>>().join("; ")
    }

    /// Which sentences fit, without those that lead to an address.
    pub(crate) fn forms(&self) -> Vec<S> {
        self.clauses(&Named::new(self)).iter().map(|clause| clause.sentence).collect()
    }

    /// The sentences that fit, in their order.
    fn clauses(&self, named: &Named) -> Vec<Clause> {
        if let Some(fault) = faults::clause(self, named) {
            return vec![fault];
        }
        let (why, operand) = (self.why(), self.operand());
        let one = |sentence| vec![Clause::new(sentence)];
        let clauses = match why {
            Why::Scan(joint, sense) => bits::scan(self, named, joint, sense),
            Why::OrSeparator => bits::or_separator(self),
            Why::Open(joint, sense) => bits::open(self, joint, sense),
            Why::Close => bits::close(self),
            Why::Assign => bits::assign(self),
            Why::Set | Why::Reset => bits::set_reset(self, why),
            Why::Not => one(S::Not),
            Why::ConstantRlo => one(S::ConstantRlo),
            Why::Save => one(S::Save),
            Why::Rising | Why::Falling => bits::edge(self, why),
            Why::McrActivate => one(S::McrActivate),
            Why::McrDeactivate => one(S::McrDeactivate),
            Why::McrOpen => bits::mcr_open(self),
            Why::McrClose => bits::mcr_close(self),
            Why::Load => operand_load(self, named, operand),
            Why::LoadStatusWord => vec![Clause::new(S::LoadStatusWord).with("value", format!("2#{:09b}", self.after().accu1 & 0x1FF))],
            Why::LoadDataBlockInfo => control::data_block_info(self),
            Why::LoadBcd => timers::load_bcd(self),
            Why::Transfer => transfer(self, named),
            Why::TransferStatusWord => {
                vec![Clause::new(S::TransferStatusWord).with("value", format!("2#{:09b}", self.before().accu1 & 0x1FF))]
            }
            Why::LoadPointer(register) => load_pointer(self, register),
            Why::StorePointer(register) => store_pointer(self, register),
            Why::SwapPointers => one(S::SwapPointers),
            Why::AddPointer(register) => add_pointer(self, register),
            Why::Swap => one(S::Swap),
            Why::Push => one(S::Push),
            Why::Pop => one(S::Pop),
            Why::Enter | Why::Leave => stack(self, why),
            Why::Timer(kind) => timers::start(self, kind),
            Why::TimerReset | Why::CounterReset => timers::reset(self),
            Why::TimerEnable | Why::CounterEnable => timers::enable(self),
            Why::CounterUp | Why::CounterDown | Why::CounterSet => timers::count(self, why),
            Why::OpenBlock => control::open_block(self),
            Why::SwapDataBlocks => {
                let after = self.after();
                vec![Clause::new(S::SwapDataBlocks).with("db", after.db_number).with("di", after.di_number)]
            }
            Why::Nothing => one(S::Nothing),
            Why::Extension => control::extension(self),
            Why::Call | Why::CallBlock | Why::CallIfRlo | Why::End | Why::EndIfRlo => control::call_or_end(self, why),
            _ => match numbers::clauses(self, why) {
                clauses if clauses.is_empty() => control::jump(self, why),
                clauses => clauses,
            },
        };
        // What belongs to the operand is the same for all of them.
        clauses.into_iter().map(|clause| clause.with("operand", named.name.clone())).collect()
    }
}

fn operand_load(telling: &Telling<'_>, named: &Named, operand: &Operand) -> Vec<Clause> {
    let value = telling.after().accu1;
    let clause = match operand {
        Operand::Memory(_) => Clause::new(S::LoadMemory).with("value", named.value(value)),
        Operand::Constant(constant) => Clause::new(S::LoadConstant).with("value", constant.spell()),
        Operand::Timer(_) => Clause::new(S::LoadTimer).with("value", value),
        Operand::Counter(_) => Clause::new(S::LoadCounter).with("value", value),
        Operand::ParameterAddress(_) => Clause::new(S::LoadParameterAddress).with("value", pointer(value)),
        _ => Clause::new(S::LoadRegister).with("value", loose_words(value)),
    };
    vec![clause]
}

fn transfer(telling: &Telling<'_>, named: &Named) -> Vec<Clause> {
    let value = named.value(telling.before().accu1);
    let sentence = if bits::mcr_on(telling) { S::Transfer } else { S::TransferMcr };
    vec![Clause::new(sentence).with("value", value)]
}

fn register_name(register: Register) -> &'static str {
    if register == Register::Ar2 { "AR2" } else { "AR1" }
}

/// What stands behind `LAR1` or `TAR1`, as the place of a pointer.
fn pointer_place(telling: &Telling<'_>) -> Option<Words> {
    match telling.operand() {
        Operand::None => None,
        Operand::AddressRegister2 => Some("AR2".into()),
        Operand::Constant(_) => Some(["the constant", "der Konstante"].into()),
        Operand::ParameterAddress(_) => Some(["the caller", "dem Aufrufer"].into()),
        _ => Some(Named::new(telling).name),
    }
}

fn load_pointer(telling: &Telling<'_>, register: Register) -> Vec<Clause> {
    let value = pointer(telling.after().get(register));
    let clause = match pointer_place(telling) {
        None => Clause::new(S::LoadPointer),
        Some(source) => Clause::new(S::LoadPointerFrom).with("source", source),
    };
    vec![clause.with("register", register_name(register)).with("value", value)]
}

fn store_pointer(telling: &Telling<'_>, register: Register) -> Vec<Clause> {
    let value = pointer(telling.before().get(register));
    let clause = match pointer_place(telling) {
        None => Clause::new(S::StorePointer),
        Some(source) => Clause::new(S::StorePointerTo).with("source", source),
    };
    vec![clause.with("register", register_name(register)).with("value", value)]
}

fn add_pointer(telling: &Telling<'_>, register: Register) -> Vec<Clause> {
    let (before, after) = (telling.before(), telling.after());
    let offset = match telling.operand() {
        Operand::Constant(constant) => Words::from(constant.spell()),
        _ => {
            let bits = before.accu1 as u16 as i16;
            let (sign, size) = (if bits < 0 { "-" } else { "" }, u64::from(bits.unsigned_abs()));
            Words::from([format!("{sign}{} (ACCU 1)", pointer(size)).as_str(), format!("{sign}{} (AKKU 1)", pointer(size)).as_str()])
        }
    };
    let clause = Clause::new(S::AddPointer).with("register", register_name(register)).with("before", pointer(before.get(register)));
    vec![clause.with("offset", offset).with("value", pointer(after.get(register)))]
}

fn stack(telling: &Telling<'_>, why: Why) -> Vec<Clause> {
    let (before, after) = (telling.before(), telling.after());
    let moved = match why {
        Why::Enter => after.accu4 == before.accu3 && after.accu3 == before.accu2,
        _ => after.accu2 == before.accu3 && after.accu3 == before.accu4,
    };
    vec![Clause::new(match why {
        _ if !moved => S::TwoAccumulators,
        Why::Enter => S::Enter,
        _ => S::Leave,
    })]
}
