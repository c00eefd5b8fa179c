//! Promotion of the nesting stack: in straight code it is known what an opened bracket keeps and what its end does with it, so that the
//! nesting stack is only written where an observer may look at it.

use sieben_engine::ir::Op;

use super::Translator;
use super::value::Val;
use crate::passes::Pass;

/// Entries that the nesting stack takes.
const ENTRIES: usize = 7;

/// The newest entry of the nesting stack.
struct Top {
    /// The stack without it.
    below: Val,
    rlo: Val,
    or: Val,
    fc: Val,
    br: Val,
    /// What the bracket does.
    function: u64,
}

impl Translator<'_> {
    /// The result of an operation of the nesting stack, if what is on it is known.
    pub(super) fn nesting(&mut self, op: Op, args: &[Val]) -> Option<Val> {
        if !self.options.passes.has(Pass::BracketPromotion) {
            return None;
        }
        if let Op::NestingEntry | Op::NestingPush = op {
            let known = args.iter().all(|arg| arg.constant().is_some());
            return (!known).then(|| self.waits(op, args));
        }
        let &stack = args.first()?;
        match op {
            Op::NestingHasRoom => self.entries(stack).map(|entries| Val::Const(u64::from(entries < ENTRIES))),
            Op::IsNonzero => matches!(self.waiting(stack)?, (Op::NestingPush, _)).then_some(Val::Const(1)),
            Op::NestingPop => Some(self.top(stack)?.below),
            Op::NestingRlo => {
                let Top { rlo, or, fc, function, .. } = self.top(stack)?;
                let inner = args[1];
                let bit = if function & 1 != 0 { self.not(inner) } else { inner };
                Some(match function >> 1 {
                    0 => {
                        let both = |to: &mut Self| {
                            let both = to.and(rlo, bit);
                            to.or(both, or)
                        };
                        self.choose_bit(fc, both, |_| bit)
                    }
                    of_or => {
                        let kept = self.and(rlo, fc);
                        if of_or == 1 { self.or(kept, bit) } else { self.xor(kept, bit) }
                    }
                })
            }
            Op::NestingOr => {
                let Top { or, fc, function, .. } = self.top(stack)?;
                let never = function >> 1 != 0 || [or, fc].iter().any(|it| it.constant().is_some_and(|bit| bit & 1 == 0));
                let both = [or, fc, Val::Const(0), Val::Const(0)];
                Some(if never { Val::Const(0) } else { self.later(Op::And, both) })
            }
            Op::NestingBr => Some(self.top(stack)?.br),
            _ => None,
        }
    }

    /// The newest entry, if it is known what it is made of.
    fn top(&self, stack: Val) -> Option<Top> {
        if let Val::Const(stack) = stack {
            let [rlo, or, fc, br] = bits(stack);
            return Some(Top { below: Val::Const(stack >> 8), rlo, or, fc, br, function: stack >> 4 & 7 });
        }
        let (Op::NestingPush, [below, entry, Val::Const(function), _]) = self.waiting(stack)? else { return None };
        let [rlo, or, fc, br] = match (entry, self.waiting(entry)) {
            (Val::Const(entry), _) => bits(entry),
            (_, Some((Op::NestingEntry, args))) => args,
            _ => return None,
        };
        Some(Top { below, rlo, or, fc, br, function: function & 7 })
    }

    /// How many entries the stack has, if that is known.
    fn entries(&self, mut stack: Val) -> Option<usize> {
        let mut pushed = 0;
        while let Some((Op::NestingPush, [below, ..])) = self.waiting(stack) {
            pushed += 1;
            stack = below;
        }
        let below = (u64::BITS - stack.constant()?.leading_zeros()).div_ceil(8) as usize;
        Some(pushed + below)
    }
}

/// RLO, OR, /FC and BR of an entry.
fn bits(entry: u64) -> [Val; 4] {
    [0, 1, 2, 3].map(|bit| Val::Const(entry >> bit & 1))
}
