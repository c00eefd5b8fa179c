//! What the pins of the elements of the S7 take, and which operands fit them.

use super::boxes::{BOXES, BoxRow, COMPARISONS, CounterKind, TimerKind};

/// What an operand is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// A timer.
    Timer,
    /// A counter.
    Counter,
    /// Something of so many bits.
    Bits(u8),
    /// A constant.
    Constant(Constant),
    /// Not known, or nothing that is loaded or checked.
    Unknown,
}

/// What a constant is by its notation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constant {
    /// `0` or `0.0`: the same in every type.
    Zero,
    /// `5`: a number without a prefix, which 32 bits hold as 16 do.
    Int,
    /// `-5`: the upper half of 32 bits would be 0.
    NegativeInt,
    /// `L#5`, `T#2S`: a number of 32 bits.
    DoubleInt,
    /// `2.5`.
    Real,
    /// `S5T#2S`.
    S5Time,
    /// `C#20`.
    Count,
    /// `W#16#FF`, `'ab'`: so many bits.
    Bits(u8),
}

/// What a pin takes. Absolute addresses fit by their width alone, as they do in STEP 7.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PinType {
    /// Any elementary value, of 8, 16 or 32 bits.
    Any,
    /// INT.
    Int,
    /// DINT.
    DoubleInt,
    /// REAL.
    Real,
    /// WORD.
    Word,
    /// DWORD.
    DoubleWord,
    /// S5TIME.
    S5Time,
    /// The value of a counter: three decimal digits as BCD.
    Count,
    /// What a contact reads.
    Contact,
    /// A bit that is written, or kept from one scan to the next.
    Bit,
    /// A bit, a timer or a counter.
    Resettable,
    /// A timer.
    Timer,
    /// A counter.
    Counter,
    /// Something that is no value: a block.
    Block,
}

impl PinType {
    /// What the operands of a comparison are.
    pub fn of_comparison(operation: &str) -> Self {
        match operation.as_bytes().last() {
            Some(b'D') => Self::DoubleInt,
            Some(b'R') => Self::Real,
            _ => Self::Int,
        }
    }

    /// In words: "takes …".
    pub fn describe(self) -> &'static str {
        match self {
            Self::Any => "8, 16 or 32 bits",
            Self::Int => "an INT (16 bits)",
            Self::DoubleInt => "a DINT (32 bits)",
            Self::Real => "a REAL (32 bits)",
            Self::Word => "a WORD (16 bits)",
            Self::DoubleWord => "a DWORD (32 bits)",
            Self::S5Time => "an S5TIME (16 bits)",
            Self::Count => "a value from C#0 to C#999 (16 bits)",
            Self::Contact => "a bit, a timer, a counter or a status bit",
            Self::Bit => "a bit",
            Self::Resettable => "a bit, a timer or a counter",
            Self::Timer => "a timer",
            Self::Counter => "a counter",
            Self::Block => "a block",
        }
    }

    /// The name of its type alone, as in a declaration.
    pub fn name(self) -> &'static str {
        match self {
            Self::Any => "any width",
            Self::Count => "WORD",
            other => other.describe().split(' ').nth(1).unwrap_or_default(),
        }
    }

    /// The bits of a value at it; `None` if it takes no value, or several widths.
    pub fn bits(self) -> Option<u8> {
        match self {
            Self::Int | Self::Word | Self::S5Time | Self::Count => Some(16),
            Self::DoubleInt | Self::Real | Self::DoubleWord => Some(32),
            Self::Any | Self::Contact | Self::Bit | Self::Resettable | Self::Timer | Self::Counter | Self::Block => None,
        }
    }

    /// Whether an operand fits. One that is not known does.
    pub fn takes(self, class: Class) -> bool {
        match (self, class) {
            (_, Class::Unknown) | (Self::Block, _) => true,
            (Self::Contact | Self::Bit | Self::Resettable, Class::Bits(bits)) => bits == 1,
            (Self::Contact | Self::Resettable | Self::Timer, Class::Timer) => true,
            (Self::Contact | Self::Resettable | Self::Counter, Class::Counter) => true,
            (Self::Contact | Self::Bit | Self::Resettable | Self::Timer | Self::Counter, _) => false,
            (Self::Any, Class::Bits(bits)) => bits != 1,
            (Self::Any, _) => true,
            // The time or the count that is left is a word.
            (_, Class::Timer | Class::Counter) => self.bits() == Some(16),
            (_, Class::Bits(bits)) => self.bits() == Some(bits),
            (_, Class::Constant(constant)) => self.takes_constant(constant),
        }
    }

    fn takes_constant(self, constant: Constant) -> bool {
        match (self, constant) {
            (_, Constant::Zero) => true,
            (Self::S5Time, constant) => matches!(constant, Constant::S5Time | Constant::Bits(8 | 16)),
            (Self::Count, constant) => matches!(constant, Constant::Count | Constant::Int | Constant::Bits(8 | 16)),
            (Self::Real, constant) => matches!(constant, Constant::Real | Constant::Bits(32)),
            (Self::Int | Self::Word, constant) => !matches!(constant, Constant::DoubleInt | Constant::Real | Constant::Bits(32)),
            (Self::DoubleInt, constant) => !matches!(constant, Constant::Real | Constant::NegativeInt),
            // A pattern of bits may be written in any way.
            _ => true,
        }
    }
}

impl Class {
    /// In words: "… is".
    pub fn describe(self) -> &'static str {
        match self {
            Self::Timer => "a timer",
            Self::Counter => "a counter",
            Self::Bits(1) => "a bit",
            Self::Bits(8) => "a byte",
            Self::Bits(16) => "a word",
            Self::Bits(32) => "a double word",
            Self::Constant(Constant::Zero | Constant::Int) => "an INT",
            Self::Constant(Constant::NegativeInt) => "an INT, whose upper half would be 0",
            Self::Constant(Constant::DoubleInt) => "a number of 32 bits",
            Self::Constant(Constant::Real) => "a REAL",
            Self::Constant(Constant::S5Time) => "an S5TIME",
            Self::Constant(Constant::Count) => "the value of a counter",
            Self::Constant(Constant::Bits(_)) => "a constant of another width",
            Self::Bits(_) | Self::Unknown => "something else",
        }
    }
}

/// A pin of an element, and what it takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TypedPin {
    /// The word of the element: `ADD_I`, `>I`, `NO`.
    pub element: &'static str,
    /// The name of the pin; empty for the operand of the element itself.
    pub name: &'static str,
    /// What it takes.
    pub takes: PinType,
}

impl TypedPin {
    /// A pin with its name.
    pub const fn new(element: &'static str, name: &'static str, takes: PinType) -> Self {
        Self { element, name, takes }
    }

    /// The operand of an element itself.
    pub const fn operand(element: &'static str, takes: PinType) -> Self {
        Self { element, name: "", takes }
    }

    /// The input of a box, or its output after the last of them.
    pub fn of_box(row: &'static BoxRow, index: usize) -> Option<Self> {
        let takes = row.types.get(index).copied()?;
        Some(Self { element: row.name, name: row.inputs.get(index).copied().unwrap_or("OUT"), takes })
    }

    /// IN1 and IN2 of a comparison.
    pub fn of_comparison(operation: &'static str) -> [Self; 2] {
        ["IN1", "IN2"].map(|name| Self::new(operation, name, PinType::of_comparison(operation)))
    }

    /// TV, BI and BCD of a timer box.
    pub fn of_timer(kind: TimerKind) -> [Self; 3] {
        let pin = |name, takes| Self::new(kind.box_name(), name, takes);
        [pin("TV", PinType::S5Time), pin("BI", PinType::Word), pin("BCD", PinType::Word)]
    }

    /// The time value of a timer coil.
    pub fn time_of_coil(kind: TimerKind) -> Self {
        Self::new(kind.instruction(), "TV", PinType::S5Time)
    }

    /// PV, CV and CV_BCD of a counter box.
    pub fn of_counter(kind: CounterKind) -> [Self; 3] {
        let pin = |name, takes| Self::new(kind.box_name(), name, takes);
        [pin("PV", PinType::Count), pin("CV", PinType::Word), pin("CV_BCD", PinType::Word)]
    }

    /// The value of the coil SC.
    pub const COUNT_OF_COIL: Self = Self::new("SC", "PV", PinType::Count);

    /// What a message calls it.
    pub fn shown(&self) -> String {
        let word = if COMPARISONS.contains(&self.element) { "CMP " } else { "" };
        match self.name {
            "" => format!("`{word}{}`", self.element),
            name => format!("`{name}` of `{word}{}`", self.element),
        }
    }

    /// What to do about an operand that does not fit.
    pub fn help(&self, class: Class, written: &str) -> Option<String> {
        match (self.takes, class) {
            (PinType::S5Time, _) => return Some("A time value is written as `S5T#2S`, or lies in a word.".to_owned()),
            (PinType::Count, _) => return Some("The value of a counter is written as `C#20`, or lies in a word.".to_owned()),
            (PinType::Real, Class::Constant(Constant::Int | Constant::NegativeInt)) => {
                return Some(format!("Write it with a decimal point: `{written}.0`."));
            }
            (PinType::Contact, Class::Bits(16)) => return Some(format!("Compare it with a number: `CMP <>I {written}, 0`.")),
            (PinType::Contact, Class::Bits(32)) => return Some(format!("Compare it with a number: `CMP <>D {written}, 0`.")),
            (PinType::Contact | PinType::Bit | PinType::Resettable, _) => {
                return Some("Name a bit: `M 10.0`, or a variable of type BOOL. MOVE writes to bytes, words and double words.".to_owned());
            }
            (PinType::Timer, _) => return Some("Name a timer: `T 5`.".to_owned()),
            (PinType::Counter, _) => return Some("Name a counter: `C 5`.".to_owned()),
            (PinType::DoubleInt, Class::Constant(Constant::NegativeInt)) => return Some(format!("Write `L#{written}`.")),
            _ => {}
        }
        let other = self.relatives().find(|other| other.takes.takes(class))?;
        Some(format!("{} takes it; or use an operand that fits.", other.shown_element()))
    }

    fn shown_element(&self) -> String {
        Self { name: "", ..*self }.shown()
    }

    /// The same pin of elements that do the same with other types: ADD_DI for ADD_I.
    fn relatives(&self) -> impl Iterator<Item = Self> {
        let own = *self;
        let boxes = BOXES.iter().filter_map(move |row| {
            let same = row.name != own.element && stem(row.name).is_some() && stem(row.name) == stem(own.element);
            let index = row.inputs.iter().position(|name| *name == own.name).unwrap_or(row.inputs.len());
            same.then(|| Self::of_box(row, index)).flatten()
        });
        let sign = |operation: &'static str| operation.trim_end_matches(['I', 'D', 'R']);
        let comparisons =
            COMPARISONS.into_iter().filter(move |other| COMPARISONS.contains(&own.element) && sign(other) == sign(own.element));
        boxes.chain(comparisons.map(move |other| Self::new(other, own.name, PinType::of_comparison(other))))
    }
}

/// What a box does, without its type: ADD of ADD_I, and whether it does so with numbers. A box without one has no relatives.
fn stem(name: &str) -> Option<(&str, bool)> {
    let (stem, kind) = name.rsplit_once('_')?;
    match kind {
        "I" | "DI" | "R" => Some((stem, true)),
        "W" | "DW" => Some((stem, false)),
        _ => None,
    }
}
