//! Numbers in texts: the number that characters spell, and the characters of a number.

use std::fmt::Write;
use std::ops::Range;

use crate::ir::TextAction;

/// Characters that are looked at: as many as a STRING has.
pub(crate) const CHARACTERS_MAX: usize = 254;

/// How a number is spelled, and what it becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NumberForm {
    /// What around it, and what about it, is allowed.
    pub spelling: Spelling,
    /// What it becomes.
    pub kind: NumberKind,
}

/// What a text has to be so that it is a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spelling {
    /// A whole literal with blanks around it; anything else is 0 and fails.
    Literal,
    /// As much at the beginning as is a literal.
    Beginning,
    /// What STRNG_I, STRNG_DI and STRNG_R of the S7 library take.
    S7,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // The names are those of Rust's types; a bit string takes the low bits of any whole number.
pub enum NumberKind {
    I8,
    I16,
    I32,
    I64,
    U8,
    U16,
    U32,
    U64,
    Bits8,
    Bits16,
    Bits32,
    Bits64,
    F32,
    F64,
}

impl NumberForm {
    /// The place of the kind in the word of an instruction.
    const KIND_SHIFT: u32 = 8;

    /// As an instruction holds it.
    #[must_use]
    pub const fn word(self) -> u64 {
        self.spelling as u64 | (self.kind as u64) << Self::KIND_SHIFT
    }

    /// That of an instruction.
    #[must_use]
    pub fn of(word: u64) -> Self {
        let spelling = Spelling::ALL[(word & 0xFF) as usize % Spelling::ALL.len()];
        let kind = NumberKind::ALL[(word >> Self::KIND_SHIFT & 0xFF) as usize % NumberKind::ALL.len()];
        Self { spelling, kind }
    }
}

impl Spelling {
    const ALL: [Self; 3] = [Self::Literal, Self::Beginning, Self::S7];
}

impl NumberKind {
    const ALL: [Self; 14] = [
        Self::I8,
        Self::I16,
        Self::I32,
        Self::I64,
        Self::U8,
        Self::U16,
        Self::U32,
        Self::U64,
        Self::Bits8,
        Self::Bits16,
        Self::Bits32,
        Self::Bits64,
        Self::F32,
        Self::F64,
    ];

    /// Its bits in memory.
    #[must_use]
    pub fn bits(self) -> u32 {
        match self {
            Self::I8 | Self::U8 | Self::Bits8 => 8,
            Self::I16 | Self::U16 | Self::Bits16 => 16,
            Self::I32 | Self::U32 | Self::Bits32 | Self::F32 => 32,
            Self::I64 | Self::U64 | Self::Bits64 | Self::F64 => 64,
        }
    }

    /// The least and the greatest whole number.
    #[must_use]
    pub fn range(self) -> (i128, i128) {
        match self {
            Self::I8 | Self::I16 | Self::I32 | Self::I64 => (-1 << (self.bits() - 1), (1 << (self.bits() - 1)) - 1),
            Self::U8 | Self::U16 | Self::U32 | Self::U64 => (0, (1 << self.bits()) - 1),
            _ => (i64::MIN.into(), u64::MAX.into()),
        }
    }
}

/// The number that characters spell, in its width at the top of 64 bits, and whether they do.
pub(crate) fn read(characters: &[u8], form: u64) -> (u64, bool) {
    let NumberForm { spelling, kind } = NumberForm::of(form);
    let (bits, good) = match (spelling, kind) {
        (Spelling::S7, NumberKind::F32) => {
            let number = s7_real(characters).filter(|number| number.is_finite());
            (number.map_or(0, |number| number.to_bits().into()), number.is_some())
        }
        (_, NumberKind::F32) => {
            let (number, good) = real::<f32>(characters, spelling);
            (number.to_bits().into(), good && number.is_finite())
        }
        (_, NumberKind::F64) => {
            let (number, good) = real::<f64>(characters, spelling);
            (number.to_bits(), good && number.is_finite())
        }
        (Spelling::S7, _) => s7_whole(characters, kind).map_or((0, false), |(number, good)| (number as u64, good)),
        _ => whole(characters, spelling, kind),
    };
    (bits << (64 - kind.bits()), good)
}

/// The blanks from a character on.
fn blanks(characters: &[u8], at: usize) -> usize {
    characters[at..].iter().take_while(|&&character| character == b' ').count()
}

/// Whether there is a sign at a character, and whether it is that of a negative number.
fn sign(characters: &[u8], at: usize) -> (usize, bool) {
    match characters.get(at) {
        Some(b'-') => (1, true),
        Some(b'+') => (1, false),
        _ => (0, false),
    }
}

/// A whole number with at most a sign, a base, and `_` behind a digit. What is too large keeps its low bits.
fn whole(characters: &[u8], spelling: Spelling, kind: NumberKind) -> (u64, bool) {
    let mut at = blanks(characters, 0);
    let (skipped, negative) = sign(characters, at);
    at += skipped;
    let (mut value, mut radix) = (0_u64, 10_u64);
    let (mut fine, mut over) = (false, false);
    while let Some(&character) = characters.get(at) {
        let digit = u64::from(match character {
            b'0'..=b'9' => character - b'0',
            b'A'..=b'F' => character - b'A' + 10,
            b'a'..=b'f' => character - b'a' + 10,
            _ => u8::MAX,
        });
        if digit < radix {
            let (tens, first) = value.overflowing_mul(radix);
            let (sum, second) = tens.overflowing_add(digit);
            value = sum;
            over |= first | second;
            fine = true;
        } else if character == b'#' && fine && radix == 10 && !over && matches!(value, 2 | 8 | 16) {
            // The base stood before the #.
            radix = value;
            value = 0;
            fine = false;
        } else if character != b'_' || !fine {
            break;
        }
        at += 1;
    }
    if spelling == Spelling::Literal {
        at += blanks(characters, at);
        if at < characters.len() || !fine {
            return (0, false);
        }
    }
    let number = if negative { -i128::from(value) } else { i128::from(value) };
    let (least, most) = kind.range();
    (number as u64, fine && !over && (least..=most).contains(&number))
}

/// A whole number of the S7 library and whether it is in the range of its type, whose limit it is else; `None` if it is none.
fn s7_whole(characters: &[u8], kind: NumberKind) -> Option<(i64, bool)> {
    let characters_max = if kind == NumberKind::I16 { 6 } else { 11 };
    let (skipped, negative) = sign(characters, 0);
    let digits = &characters[skipped..];
    if characters.len() > characters_max || digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let value = digits.iter().fold(0_i64, |value, digit| value * 10 + i64::from(digit - b'0'));
    let value = if negative { -value } else { value };
    let (least, most) = if kind == NumberKind::I16 { (i16::MIN.into(), i16::MAX.into()) } else { (i32::MIN.into(), i32::MAX.into()) };
    Some((value.clamp(least, most), (least..=most).contains(&value)))
}

/// A REAL as the S7 library writes it: sign, digit, point, seven digits, E, sign, two digits.
fn s7_real(characters: &[u8]) -> Option<f32> {
    let [b'+' | b'-', _, b'.', .., b'E', b'+' | b'-', _, _] = characters else { return None };
    let is_digit = |place: usize| characters[place].is_ascii_digit();
    let has_form = characters.len() == 14 && [1, 3, 4, 5, 6, 7, 8, 9, 12, 13].into_iter().all(is_digit) && characters[10] == b'E';
    if !has_form {
        return None;
    }
    std::str::from_utf8(characters).ok()?.parse().ok()
}

/// A decimal number with or without a point and an exponent: the one of its type that lies nearest.
fn real<F: std::str::FromStr + std::ops::Neg<Output = F> + std::ops::Sub<Output = F> + Default + Copy>(
    characters: &[u8],
    spelling: Spelling,
) -> (F, bool) {
    let characters = &characters[..characters.len().min(CHARACTERS_MAX)];
    let mut literal = [0_u8; CHARACTERS_MAX];
    let mut length = 0;
    let mut put = |character: u8| {
        literal[length] = character;
        length += 1;
    };
    let mut at = blanks(characters, 0);
    let (skipped, negative) = sign(characters, at);
    at += skipped;
    let (mut fine, mut behind_point) = (false, false);
    while let Some(&character) = characters.get(at) {
        match character {
            b'0'..=b'9' => {
                put(character);
                fine = true;
            }
            b'.' if !behind_point => {
                put(character);
                behind_point = true;
            }
            b'_' => {}
            _ => break,
        }
        at += 1;
    }
    if fine && matches!(characters.get(at), Some(b'E' | b'e')) {
        at += 1;
        let (skipped, minus) = sign(characters, at);
        at += skipped;
        let mut exponent = 0_u32;
        let mut begun = false;
        while let Some(&digit @ b'0'..=b'9') = characters.get(at) {
            if !begun {
                put(b'e');
                if minus {
                    put(b'-');
                }
                begun = true;
            }
            // More than four digits say nothing more about it.
            if exponent < 1000 {
                put(digit);
                exponent = exponent * 10 + u32::from(digit - b'0');
            }
            at += 1;
        }
    }
    if spelling == Spelling::Literal {
        at += blanks(characters, at);
        fine &= at == characters.len();
    }
    let number = std::str::from_utf8(&literal[..length]).ok().filter(|_| fine).and_then(|literal| literal.parse().ok());
    let number: F = number.unwrap_or_default();
    // So -0 is 0.
    (if negative { F::default() - number } else { number }, fine)
}

/// The characters of a number, at the end of their bytes or at the beginning.
pub(crate) struct Characters {
    bytes: [u8; Self::MOST],
    there: Range<usize>,
}

impl Characters {
    /// More than any number has: a sign, 17 digits, a point, and `E-308`, or a sign and 20 digits.
    const MOST: usize = 32;

    /// As an instruction writes it; none if it has none.
    pub(crate) fn of(action: TextAction, number: u64) -> Self {
        let mut it = Self { bytes: [0; Self::MOST], there: 0..0 };
        match action {
            TextAction::Real => {
                let number = f32::from_bits(number as u32);
                it.put_shortest(number.abs(), number.into());
            }
            TextAction::LongReal => {
                let number = f64::from_bits(number);
                it.put_shortest(number.abs(), number);
            }
            TextAction::RealS7 => it.put_s7(f32::from_bits(number as u32)),
            _ => it.put_whole(action, number),
        }
        it
    }

    pub(crate) fn as_bytes(&self) -> &[u8] {
        &self.bytes[self.there.clone()]
    }

    fn put_whole(&mut self, action: TextAction, number: u64) {
        self.there = Self::MOST..Self::MOST;
        let negative = action != TextAction::Unsigned && (number as i64) < 0;
        let mut rest = if negative { (number as i64).unsigned_abs() } else { number };
        // Two digits at a time: the divisions, each of which waits for the one before, are what takes time.
        while rest >= 100 {
            let two = (rest % 100) as u8;
            rest /= 100;
            self.put_before(b'0' + two % 10);
            self.put_before(b'0' + two / 10);
        }
        let two = rest as u8;
        self.put_before(b'0' + two % 10);
        if two >= 10 {
            self.put_before(b'0' + two / 10);
        }
        match action {
            _ if negative => self.put_before(b'-'),
            TextAction::SignedAlways => self.put_before(b'+'),
            _ => {}
        }
    }

    fn put_before(&mut self, character: u8) {
        self.there.start -= 1;
        self.bytes[self.there.start] = character;
    }

    fn put(&mut self, characters: &[u8]) {
        let end = self.there.end + characters.len();
        self.bytes[self.there.end..end].copy_from_slice(characters);
        self.there.end = end;
    }

    /// As few digits as bring the number back, always with a point. `size` is the number with its sign.
    fn put_shortest(&mut self, magnitude: impl std::fmt::LowerExp, size: f64) {
        if size.is_nan() {
            return self.put(b"NaN");
        }
        if size < 0.0 {
            self.put(b"-");
        }
        if size.is_infinite() {
            return self.put(b"Inf");
        }
        if size == 0.0 {
            return self.put(b"0.0");
        }
        let scientific = Scientific::of(format_args!("{magnitude:e}"));
        let (digits, exponent) = (scientific.digits(), scientific.exponent);
        const ZEROS: &[u8] = b"0000000000";
        match exponent {
            0..9 => {
                let front = exponent as usize + 1;
                let (whole, behind) = digits.split_at(front.min(digits.len()));
                self.put(whole);
                self.put(&ZEROS[..front - whole.len()]);
                self.put(b".");
                self.put(if behind.is_empty() { b"0" } else { behind });
            }
            -4..0 => {
                self.put(b"0.");
                self.put(&ZEROS[..(-exponent - 1) as usize]);
                self.put(digits);
            }
            _ => {
                self.put(&digits[..1]);
                self.put(b".");
                self.put(if digits.len() == 1 { b"0" } else { &digits[1..] });
                self.put_exponent(exponent);
            }
        }
    }

    /// `E`, a sign, and at least two digits.
    fn put_exponent(&mut self, exponent: i32) {
        self.put(if exponent < 0 { b"E-" } else { b"E+" });
        let exponent = exponent.unsigned_abs() as u16;
        if exponent >= 100 {
            self.put(&[b'0' + (exponent / 100) as u8]);
        }
        self.put(&[b'0' + (exponent / 10 % 10) as u8, b'0' + (exponent % 10) as u8]);
    }

    /// Sign, digit, point, seven digits, E, sign, two digits; the eight digits are exact and rounded, halves away from zero.
    fn put_s7(&mut self, number: f32) {
        if !number.is_finite() {
            return;
        }
        let magnitude = number.abs();
        let nine = Scientific::of(format_args!("{magnitude:.8e}"));
        let up = match nine.digits()[8] {
            // A half or more, or rounded up to that: all digits know, of which a REAL has no more than 112.
            b'5' => format!("{magnitude:.112e}").as_bytes()[9] >= b'5',
            digit => digit > b'5',
        };
        let eight = nine.digits()[..8].iter().fold(0, |whole, digit| whole * 10 + u32::from(digit - b'0')) + u32::from(up);
        let carries = eight == 100_000_000;
        let digits = Self::of(TextAction::Unsigned, if carries { 10_000_000 } else { eight.into() });
        let digits = if number == 0.0 { b"00000000" } else { digits.as_bytes() };
        self.put(if number.is_sign_negative() { b"-" } else { b"+" });
        self.put(&digits[..1]);
        self.put(b".");
        self.put(&digits[1..]);
        self.put_exponent(nine.exponent + i32::from(carries));
    }
}

/// A number as Rust writes it with an exponent.
struct Scientific {
    bytes: [u8; Self::MOST],
    length: usize,
    exponent: i32,
}

impl Scientific {
    /// 17 digits, a point, and an exponent.
    const MOST: usize = 32;

    fn of(written: std::fmt::Arguments<'_>) -> Self {
        let mut it = Self { bytes: [0; Self::MOST], length: 0, exponent: 0 };
        if it.write_fmt(written).is_err() {
            unreachable!("a number has fewer characters");
        }
        let end = it.bytes[..it.length].iter().position(|&character| character == b'e').unwrap_or(it.length);
        let exponent = std::str::from_utf8(&it.bytes[(end + 1).min(it.length)..it.length]).ok();
        it.exponent = exponent.and_then(|exponent| exponent.parse().ok()).unwrap_or(0);
        it.length = end;
        if it.length > 1 {
            // The digits without the point behind the first one.
            it.bytes.copy_within(2..it.length, 1);
            it.length -= 1;
        }
        it
    }

    fn digits(&self) -> &[u8] {
        &self.bytes[..self.length]
    }
}

impl Write for Scientific {
    fn write_str(&mut self, part: &str) -> std::fmt::Result {
        let end = self.length + part.len();
        self.bytes.get_mut(self.length..end).ok_or(std::fmt::Error)?.copy_from_slice(part.as_bytes());
        self.length = end;
        Ok(())
    }
}
