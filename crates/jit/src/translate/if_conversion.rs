//! If-conversion: a branch around one assignment, or between two of the same variable, becomes a select of both values. Branches that
//! depend on the plant are predicted badly, and what is available before a select is available after it.

use cranelift_codegen::ir::{InstBuilder, InstructionData, Opcode, Value};
use sieben_engine::ir::{Inst, OnFault, Op, Place, Target, Var};
use sieben_model::address::Width;

use super::Translator;
use super::value::Val;
use crate::passes::Pass;

/// Longer statements are jumped over.
const INSTRUCTIONS_MAX: usize = 8;

/// Which statements a branch chooses from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Arms {
    /// The next one, or none.
    OrNone,
    /// The next one, with a jump behind it, or the one behind that.
    OrOther,
}

/// A condition under which a statement is jumped over.
#[derive(Clone, Copy, Debug)]
pub(super) struct Predicate {
    from: Arms,
    /// What the first of two statements would write.
    first: Option<Val>,
    /// Not 0 if it is …
    value: Value,
    /// … or is not.
    negated: bool,
    /// Whether the value is 0 or 1.
    is_flag: bool,
    /// The bit that decides, which is 1 where the value is not 0.
    bit: Val,
}

/// Whether an operation takes no longer than a jump that was not foreseen.
pub(super) fn is_cheap(op: Op) -> bool {
    use Op as O;
    let logic =
        matches!(op, O::Copy | O::Not | O::And | O::AndNot | O::Or | O::Xor | O::Select | O::Gate | O::AndU32 | O::OrU32 | O::XorU32);
    let numbers = matches!(
        op,
        O::AddU8
            | O::AddU16
            | O::AddU32
            | O::AddU64
            | O::SubU8
            | O::SubU16
            | O::SubU32
            | O::SubU64
            | O::AndU64
            | O::OrU64
            | O::XorU64
            | O::MulU16
            | O::MulU32
            | O::Shl8
            | O::Shr8
            | O::Shl16
            | O::Shr16
            | O::Shl32
            | O::Shr32
            | O::Low8
            | O::Low16
            | O::Low32
            | O::Extend16
            | O::MinI16
            | O::MaxI16
            | O::MinI32
            | O::MaxI32
            | O::NegI32
    );
    let reals = matches!(op, O::AddF32 | O::SubF32 | O::MulF32 | O::NegF32 | O::AbsF32);
    logic || numbers || reals
}

/// Whether a variable that instructions read leads to an address from which they read, too: in a loop that chooses the variable by what it
/// read, each iteration would wait for the choice of the one before, two reads and a comparison. A jump that is foreseen waits for nothing.
fn leads_to_address(insts: &[Inst], variable: Place) -> bool {
    let mut led: Vec<Var> = Vec::new();
    insts.iter().any(|inst| {
        let leads = match *inst {
            Inst::Load { place, .. } if place == variable => true,
            Inst::Load { place: Place::Indirect { pointer, .. } | Place::Crossing { pointer, .. }, .. } if led.contains(&pointer) => {
                return true;
            }
            Inst::Compute { op, args, .. } => args[..op.arity()].iter().any(|arg| led.contains(arg)),
            _ => false,
        };
        if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
            led.retain(|&var| var != dst);
            led.extend(leads.then_some(dst));
        }
        false
    })
}

impl Translator<'_> {
    /// Whether what the running statement jumps over, if a condition holds, is written out as a choice; it is, from now on.
    pub(super) fn chooses(&mut self, index: u32, condition: Val, to: u32) -> bool {
        let Some(from) = self.choice_of(index, to) else { return false };
        let (value, negated) = self.condition(condition);
        let is_flag = !matches!(self.force(condition), Val::At { at: 1.., .. });
        let (bit, _) = self.without_not(condition);
        self.choice = Some(Predicate { from, first: None, value, negated, is_flag, bit });
        true
    }

    fn choice_of(&self, index: u32, to: u32) -> Option<Arms> {
        let next = self.statement + 1;
        let code = &self.native().code;
        let is_last = code.statements.get(next as usize) == Some(&(index + 1));
        if !self.options.does(Pass::IfConversion) || !is_last {
            return None;
        }
        let variable = self.written_by_plain(next)?;
        if leads_to_address(code.statement(self.statement as usize), variable.0) {
            return None;
        }
        if to == next + 1 {
            return Some(Arms::OrNone);
        }
        let jumps = to == next + 2 && matches!(*code.statement(next as usize + 1), [Inst::Jump { to: Target(end) }] if end == to + 1);
        let is_other = jumps && !self.is_entered(next + 1) && self.written_by_plain(to) == Some(variable);
        is_other.then_some(Arms::OrOther)
    }

    /// What a statement writes that is plain and that is entered only from the one before it, or the branch that is looked at.
    fn written_by_plain(&self, statement: u32) -> Option<(Place, Width)> {
        if self.is_entered(statement) || !self.is_plain(statement) {
            return None;
        }
        match self.native().code.statement(statement as usize).last() {
            Some(&Inst::Store { place, width, .. }) => Some((place, width)),
            _ => None,
        }
    }

    /// Whether somebody comes to a statement from elsewhere, or an iteration of a loop begins there.
    pub(super) fn is_entered(&self, statement: u32) -> bool {
        let written_out = self.native().written_out.as_ref();
        self.arrivals.contains_key(&statement)
            || written_out.is_some_and(|it| it.next_iteration(statement).or(it.more(statement)).is_some())
    }

    /// Whether a statement computes one value and writes it, and can neither fail nor be entered elsewhere.
    pub(super) fn is_plain(&self, statement: u32) -> bool {
        let code = &self.native().code;
        if statement as usize >= code.statement_count() {
            return false;
        }
        let insts = code.statement(statement as usize);
        let is_there = |place: Place, width: Width| self.constant_address(place, width).is_some();
        let is_own = |dst: Var| dst.register().is_none();
        let Some((Inst::Store { place, width, .. }, before)) = insts.split_last() else { return false };
        insts.len() <= INSTRUCTIONS_MAX
            && is_there(*place, *width)
            && !self.is_protected(*place)
            && before.iter().all(|inst| match *inst {
                Inst::Constant { dst, .. } => is_own(dst),
                Inst::Compute { op, dst, .. } => is_own(dst) && is_cheap(op),
                Inst::Load { dst, place, width, on_fault: OnFault::SkipStatement } => is_own(dst) && is_there(place, width),
                _ => false,
            })
    }

    /// What is written where a statement that may be jumped over writes a value: what is there already if the condition holds, or what the
    /// other statement writes. `None` if that is to come.
    pub(super) fn chosen(&mut self, choice: Predicate, (place, width): (Place, Width), index: u32, value: Val) -> Option<Val> {
        let Predicate { value: condition, negated, .. } = choice;
        let value = self.force(value);
        let (old, new) = match (choice.from, choice.first) {
            (Arms::OrOther, None) => {
                self.choice = Some(Predicate { first: Some(value), ..choice });
                return None;
            }
            (Arms::OrOther, Some(first)) => (value, first),
            (Arms::OrNone, _) => {
                let free = Var::temporary(self.temporaries.len()).unwrap_or_default();
                self.load(index, free, place, width, OnFault::SkipWrite);
                let old = self.get(free);
                (self.force(old), value)
            }
        };
        if width != Width::Bit
            && let Some(number) = self.chosen_bit(choice, old, new)
        {
            return Some(number);
        }
        if width == Width::DoubleWord
            && let Some(sum) = self.chosen_sum(choice, old, new)
        {
            return Some(Val::Int(sum));
        }
        let (old, new) = if negated { (new, old) } else { (old, new) };
        Some(match width {
            Width::Bit => {
                let [old, new] = [old, new].map(|value| self.bit(value));
                Val::Bit { value: self.b.ins().select(condition, old, new), clean: false }
            }
            Width::QuadWord if [old, new].iter().any(|value| matches!(value, Val::Lreal { .. })) => {
                let bits = [old, new].map(|value| self.word(value));
                let reals = [old, new].map(|value| self.f64(value));
                let real = self.b.ins().select(condition, reals[0], reals[1]);
                Val::Lreal { real, bits: self.b.ins().select(condition, bits[0], bits[1]) }
            }
            Width::QuadWord => {
                let [old, new] = [old, new].map(|value| self.word(value));
                Val::Word(self.b.ins().select(condition, old, new))
            }
            Width::DoubleWord if [old, new].iter().any(|value| matches!(value, Val::Real { .. })) => {
                let bits = [old, new].map(|value| self.int(value));
                let reals = [old, new].map(|value| self.f32(value));
                let real = self.b.ins().select(condition, reals[0], reals[1]);
                Val::Real { real, bits: self.b.ins().select(condition, bits[0], bits[1]) }
            }
            _ => {
                let [old, new] = [old, new].map(|value| self.int(value));
                Val::Int(self.b.ins().select(condition, old, new))
            }
        })
    }

    /// A variable to which something is added if the condition holds that was not negated, or does not hold that was: a sum in any case,
    /// of nothing if need be. Who counts on waits for one addition then, and for no choice.
    fn chosen_sum(&mut self, choice: Predicate, old: Val, new: Val) -> Option<Value> {
        let Predicate { value: condition, negated, is_flag, .. } = choice;
        if self.is_comparison(condition) {
            // It is one with a choice behind it.
            return None;
        }
        let (Val::Int(old), Val::Int(new)) = (old, new) else { return None };
        let (_, InstructionData::Binary { opcode: Opcode::Iadd, args: [a, b] }) = self.definition(new)? else { return None };
        let [of, a, b] = [old, a, b].map(|value| self.b.func.dfg.resolve_aliases(value));
        let added = if a == of { b } else { Some(a).filter(|_| b == of)? };
        let added = match self.iconst(added) {
            Some(number) if is_flag => {
                let given = if negated { condition } else { self.b.ins().bxor_imm_u(condition, 1) };
                self.b.ins().imul_imm_u(given, i64::from(number))
            }
            _ => {
                let none = self.constant(0);
                let (first, second) = if negated { (added, none) } else { (none, added) };
                self.b.ins().select(condition, first, second)
            }
        };
        Some(self.b.ins().iadd(old, added))
    }

    /// A number of which one bit is set, cleared or turned over if the condition holds that was not negated, or does not hold that was: the
    /// bit that decides goes to its place.
    fn chosen_bit(&mut self, choice: Predicate, old: Val, new: Val) -> Option<Val> {
        if self.is_comparison(choice.value) {
            // It is one with a choice behind it.
            return None;
        }
        let (of, changed, opcode) = match (old, new) {
            (Val::Const(old), Val::Const(new)) => {
                let changed = u32::try_from(old ^ new).ok().filter(|_| old == 0)?;
                (None, changed, Opcode::Bor)
            }
            (Val::Int(old), Val::Int(new)) => {
                let (_, InstructionData::Binary { opcode, args: [a, b] }) = self.definition(new)? else { return None };
                let (of, constant) = if let Some(constant) = self.iconst(b) { (a, constant) } else { (b, self.iconst(a)?) };
                let [own, of] = [old, of].map(|value| self.b.func.dfg.resolve_aliases(value));
                let changed = match opcode {
                    Opcode::Bor | Opcode::Bxor => constant,
                    Opcode::Band => !constant,
                    _ => return None,
                };
                (Some(of).filter(|&of| of == own), changed, opcode)
            }
            _ => return None,
        };
        if !changed.is_power_of_two() || of.is_none() && !matches!(old, Val::Const(_)) {
            return None;
        }
        let given = if choice.negated { choice.bit } else { self.not(choice.bit) };
        let bit = self.bit_at(given, changed.trailing_zeros() as u8);
        Some(Val::Int(match (of, opcode) {
            (None, _) => bit,
            (Some(of), Opcode::Bor) => self.b.ins().bor(of, bit),
            (Some(of), Opcode::Bxor) => self.b.ins().bxor(of, bit),
            (Some(of), _) => self.b.ins().band_not(of, bit),
        }))
    }

    fn is_comparison(&self, value: Value) -> bool {
        match self.definition(value) {
            Some((_, InstructionData::Unary { opcode: Opcode::Uextend, arg })) => self.is_comparison(arg),
            Some((_, data)) => matches!(data, InstructionData::IntCompare { .. } | InstructionData::FloatCompare { .. }),
            None => false,
        }
    }
}
