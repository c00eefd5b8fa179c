//! The timers and counters of S5 and S7-300/400 as functions: what each does in which order, as its box does.

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::machine::TimerKind;
use sieben_model::types::DataType;

use crate::st::dialect::Dialect;

/// One of the functions.
#[derive(Debug)]
pub struct S5Function {
    /// Its names, in English and in German mnemonics.
    names: [&'static str; 2],
    /// What it works on.
    pub device: &'static Device,
    /// What it does to it, in this order.
    pub steps: &'static [Step],
}

/// A timer or a counter as the functions see it.
#[derive(Debug)]
pub struct Device {
    /// The parameter with its number.
    pub number: &'static str,
    /// The type of that parameter.
    pub data_type: DataType,
    /// The outputs, and what delivers each.
    pub outputs: &'static [(&'static str, DataType, Intrinsic)],
    /// The type of the result, and what delivers it.
    pub result: (DataType, Intrinsic),
}

/// An input that does something.
#[derive(Debug)]
pub struct Step {
    /// The BOOL input.
    pub trigger: &'static str,
    /// The value that it takes over, without which the input cannot be given, nor it without the input.
    pub preset: Option<(&'static str, DataType)>,
    /// What happens with the number, the input and the value.
    pub intrinsic: Intrinsic,
}

impl S5Function {
    /// The function with this name in a dialect, without regard to case.
    pub fn find(name: &str, dialect: Dialect) -> Option<&'static Self> {
        if !dialect.switches().s5_functions {
            return None;
        }
        ALL.iter().find(|function| function.names.iter().any(|one| one.eq_ignore_ascii_case(name)))
    }

    /// All its parameters in order.
    pub fn parameters(&self) -> Vec<&'static str> {
        let steps = self.steps.iter().flat_map(|step| [Some(step.trigger), step.preset.as_ref().map(|(name, _)| *name)]);
        let outputs = self.device.outputs.iter().map(|(name, ..)| *name);
        [self.device.number].into_iter().chain(steps.flatten()).chain(outputs).collect()
    }
}

static TIMER: Device = Device {
    number: "T_NO",
    data_type: DataType::Timer,
    outputs: &[("BI", DataType::Word, Intrinsic::TimerValue), ("Q", DataType::Bool, Intrinsic::TimerStatus)],
    result: (DataType::S5Time, Intrinsic::TimerBcd),
};

static COUNTER: Device = Device {
    number: "C_NO",
    data_type: DataType::Counter,
    outputs: &[("CV", DataType::Word, Intrinsic::CounterValue), ("Q", DataType::Bool, Intrinsic::CounterStatus)],
    result: (DataType::Word, Intrinsic::CounterBcd),
};

const fn start(kind: TimerKind) -> Step {
    Step { trigger: "S", preset: Some(("TV", DataType::S5Time)), intrinsic: Intrinsic::TimerStart(kind) }
}

const RESET: Step = Step { trigger: "R", preset: None, intrinsic: Intrinsic::TimerReset };
const UP: Step = Step { trigger: "CU", preset: None, intrinsic: Intrinsic::CounterUp };
const DOWN: Step = Step { trigger: "CD", preset: None, intrinsic: Intrinsic::CounterDown };
const SET: Step = Step { trigger: "S", preset: Some(("PV", DataType::Word)), intrinsic: Intrinsic::CounterSet };
const CLEAR: Step = Step { trigger: "R", preset: None, intrinsic: Intrinsic::CounterReset };

#[rustfmt::skip] // A table.
static ALL: &[S5Function] = &[
    S5Function { names: ["S_PULSE", "S_IMPULS"], device: &TIMER, steps: &[start(TimerKind::Pulse), RESET] },
    S5Function { names: ["S_PEXT", "S_VIMP"], device: &TIMER, steps: &[start(TimerKind::ExtendedPulse), RESET] },
    S5Function { names: ["S_ODT", "S_EVERZ"], device: &TIMER, steps: &[start(TimerKind::OnDelay), RESET] },
    S5Function { names: ["S_ODTS", "S_SEVERZ"], device: &TIMER, steps: &[start(TimerKind::RetentiveOnDelay), RESET] },
    S5Function { names: ["S_OFFDT", "S_AVERZ"], device: &TIMER, steps: &[start(TimerKind::OffDelay), RESET] },
    S5Function { names: ["S_CU", "Z_VORW"], device: &COUNTER, steps: &[UP, SET, CLEAR] },
    S5Function { names: ["S_CD", "Z_RUECK"], device: &COUNTER, steps: &[DOWN, SET, CLEAR] },
    S5Function { names: ["S_CUD", "ZAEHLER"], device: &COUNTER, steps: &[UP, DOWN, SET, CLEAR] },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_both_languages_and_of_no_other_dialect() {
        let parameters = |name| S5Function::find(name, Dialect::Scl).map(S5Function::parameters);
        assert_eq!(parameters("s_everz"), Some(vec!["T_NO", "S", "TV", "R", "BI", "Q"]));
        assert_eq!(parameters("S_CUD"), Some(vec!["C_NO", "CU", "CD", "S", "PV", "R", "CV", "Q"]));
        assert!(S5Function::find("S_ODT", Dialect::Iec).is_none());
    }
}
