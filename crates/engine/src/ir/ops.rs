//! The scalar operations of the IR: one row each, one meaning each.
//!
//! The Rust expression is the definition. The interpreter and the constant folder run it through
//! [`Op::eval`]; machine code calls it through [`Op::shim`] until it has an inline form.

use sieben_model::bcd;

/// A value as a variable holds it: 64 bits, narrowed by each operation's own types.
pub type Word = u64;

/// A type that travels through a variable.
pub trait Slot: Copy {
    /// The value in the low bits.
    fn from_word(word: Word) -> Self;
    /// The value, zero-extended.
    fn to_word(self) -> Word;
}

macro_rules! integer_slots {
    ($($ty:ty as $unsigned:ty),*) => {$(impl Slot for $ty {
        #[inline(always)]
        fn from_word(word: Word) -> Self { word as $ty }
        #[inline(always)]
        fn to_word(self) -> Word { Word::from(self as $unsigned) }
    })*};
}
integer_slots!(i16 as u16, u16 as u16, i32 as u32, u32 as u32, i64 as u64, u64 as u64, i8 as u8, u8 as u8);

impl Slot for bool {
    #[inline(always)]
    fn from_word(word: Word) -> Self {
        word & 1 != 0
    }
    #[inline(always)]
    fn to_word(self) -> Word {
        Word::from(self)
    }
}
impl Slot for f32 {
    #[inline(always)]
    fn from_word(word: Word) -> Self {
        Self::from_bits(word as u32)
    }
    #[inline(always)]
    fn to_word(self) -> Word {
        Word::from(self.to_bits())
    }
}

impl Slot for f64 {
    #[inline(always)]
    fn from_word(word: Word) -> Self {
        Self::from_bits(word)
    }
    #[inline(always)]
    fn to_word(self) -> Word {
        self.to_bits()
    }
}

macro_rules! ops {
    ($( $(#[doc = $doc:literal])* $name:ident = $Variant:ident ( $($arg:ident : $ty:ty),* ) -> $ret:ty = $body:expr; )*) => {
        /// An operation over scalars.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[repr(u16)]
        pub enum Op { $( $(#[doc = $doc])* $Variant, )* }

        impl Op {
            /// All operations, in the order of the table.
            pub const ALL: &[Self] = &[$(Self::$Variant),*];

            /// The name in IR text.
            pub fn name(self) -> &'static str { match self { $(Self::$Variant => stringify!($name)),* } }
            /// How many arguments it takes.
            pub fn arity(self) -> usize { match self { $(Self::$Variant => [$(stringify!($arg)),*].len()),* } }
            /// Whether its result may have more than 32 bits.
            pub fn is_wide(self) -> bool { match self { $(Self::$Variant => matches!(stringify!($ret), "u64" | "i64" | "f64")),* } }
            /// What it computes, in one sentence.
            pub fn doc(self) -> &'static str { match self { $(Self::$Variant => concat!($($doc),*).trim_ascii()),* } }

            /// The definition; arguments beyond the arity are ignored.
            #[inline(always)]
            pub fn eval(self, args: [Word; 4]) -> Word {
                match self { $(Self::$Variant => {
                    #[allow(unused_mut, unused_variables)]
                    let mut args = args.into_iter();
                    $(let $arg = <$ty>::from_word(args.next().unwrap_or(0));)*
                    let result: $ret = $body;
                    result.to_word()
                }),* }
            }

            /// The same body as a function that machine code calls.
            pub fn shim(self) -> *const u8 {
                match self { $(Self::$Variant => {
                    extern "C" fn shim($($arg: Word),*) -> Word {
                        $(let $arg = <$ty>::from_word($arg);)*
                        let result: $ret = $body;
                        result.to_word()
                    }
                    shim as *const u8
                }),* }
            }
        }
    };
}

ops! {
    /// The value itself.
    copy = Copy(a: u64) -> u64 = a;

    // Bits.
    /// NOT.
    not = Not(a: bool) -> bool = !a;
    /// AND.
    and = And(a: bool, b: bool) -> bool = a & b;
    /// a AND NOT b.
    and_not = AndNot(a: bool, b: bool) -> bool = a & !b;
    /// OR.
    or = Or(a: bool, b: bool) -> bool = a | b;
    /// XOR.
    xor = Xor(a: bool, b: bool) -> bool = a ^ b;
    /// RLO after `A`: at a first check the bit, else RLO AND bit, OR the left side of an AND-before-OR.
    scan_and = ScanAnd(rlo: bool, bit: bool, or: bool, fc: bool) -> bool = if fc { (rlo & bit) | or } else { bit };
    /// RLO after `AN`.
    scan_and_not = ScanAndNot(rlo: bool, bit: bool, or: bool, fc: bool) -> bool = if fc { (rlo & !bit) | or } else { !bit };
    /// RLO after `O`: at a first check the bit, else RLO OR bit.
    scan_or = ScanOr(rlo: bool, bit: bool, fc: bool) -> bool = (rlo & fc) | bit;
    /// RLO after `ON`.
    scan_or_not = ScanOrNot(rlo: bool, bit: bool, fc: bool) -> bool = (rlo & fc) | !bit;
    /// RLO after `X`.
    scan_xor = ScanXor(rlo: bool, bit: bool, fc: bool) -> bool = (rlo & fc) ^ bit;
    /// RLO after `XN`.
    scan_xor_not = ScanXorNot(rlo: bool, bit: bool, fc: bool) -> bool = (rlo & fc) ^ !bit;
    /// OR after an `O` without operand: (RLO OR OR) AND /FC.
    or_begin = OrBegin(rlo: bool, or: bool, fc: bool) -> bool = (rlo | or) & fc;
    /// The bit after `S`: 1 if the condition holds.
    set_bit = SetBit(old: bool, condition: bool) -> bool = old | condition;
    /// The bit after `R`: 0 if the condition holds.
    reset_bit = ResetBit(old: bool, condition: bool) -> bool = old & !condition;

    // Choice.
    /// a if the condition holds, else b.
    select = Select(condition: bool, a: u64, b: u64) -> u64 = if condition { a } else { b };
    /// a if the condition holds, else 0.
    gate = Gate(a: u64, condition: bool) -> u64 = if condition { a } else { 0 };
    /// Whether a is not 0.
    is_nonzero = IsNonzero(a: u64) -> bool = a != 0;
    /// Whether a = b.
    equal = Equal(a: u64, b: u64) -> bool = a == b;
    /// Whether a < b, unsigned.
    below = Below(a: u64, b: u64) -> bool = a < b;

    // Nesting stack: one byte per open bracket, 16#80 + function (bits 4 to 6) + BR, /FC, OR, RLO (bits 3 to 0).
    /// The entry of an opened bracket, without its function.
    nesting_entry = NestingEntry(rlo: bool, or: bool, fc: bool, br: bool) -> u8 =
        0x80 | u8::from(rlo) | u8::from(or) << 1 | u8::from(fc) << 2 | u8::from(br) << 3;
    /// The stack with an entry pushed.
    nesting_push = NestingPush(stack: u64, entry: u8, function: u8) -> u64 = stack << 8 | u64::from(entry | function << 4);
    /// Whether another bracket may be opened (at most seven).
    nesting_has_room = NestingHasRoom(stack: u64) -> bool = stack >> 48 == 0;
    /// The stack without its newest entry.
    nesting_pop = NestingPop(stack: u64) -> u64 = stack >> 8;
    /// RLO behind `)`: the saved one combined with the inner one by the function of the bracket.
    nesting_rlo = NestingRlo(stack: u64, inner: bool) -> bool = {
        let entry = stack as u8;
        let (saved, or, fc) = (entry & 1 != 0, entry & 2 != 0, entry & 4 != 0);
        let function = entry >> 4 & 7;
        let bit = inner ^ (function & 1 != 0);
        match function >> 1 {
            0 if fc => (saved & bit) | or,
            0 => bit,
            1 => (saved & fc) | bit,
            _ => (saved & fc) ^ bit,
        }
    };
    /// OR behind `)`: the saved one after `A(` and `AN(` with /FC = 1, else 0.
    nesting_or = NestingOr(stack: u64) -> bool = stack & 0x66 == 0x06;
    /// BR behind `)`: the saved one.
    nesting_br = NestingBr(stack: u64) -> bool = stack & 8 != 0;

    // MCR stack: a 1 followed by one bit per open zone.
    /// Whether another zone may be opened (at most eight).
    mcr_has_room = McrHasRoom(stack: u64) -> bool = stack < 0x100;
    /// The stack with a zone opened.
    mcr_push = McrPush(stack: u64, rlo: bool) -> u64 = stack << 1 | u64::from(rlo);
    /// Whether a zone is open.
    mcr_is_open = McrIsOpen(stack: u64) -> bool = stack > 1;
    /// The stack with the newest zone closed.
    mcr_pop = McrPop(stack: u64) -> u64 = (stack >> 1).max(1);
    /// Whether statements take effect: MCR not active, or every open zone is 1.
    mcr_on = McrOn(active: bool, stack: u64) -> bool = !active | (stack & stack.wrapping_add(1) == 0);

    // Integers. Wide results are exact; `merge_low16` puts them back.
    /// Low word of `low` under the high word of `high`.
    merge_low16 = MergeLow16(high: u32, low: u32) -> u32 = high & 0xFFFF_0000 | low & 0xFFFF;
    /// Low byte of `low` under the rest of `high`.
    merge_low8 = MergeLow8(high: u32, low: u32) -> u32 = high & 0xFFFF_FF00 | low & 0xFF;
    /// Low word, zero-extended.
    low16 = Low16(a: u16) -> u16 = a;
    /// Low byte, zero-extended.
    low8 = Low8(a: u8) -> u8 = a;
    /// Sign-extended low word.
    extend16 = Extend16(a: i16) -> i32 = i32::from(a);
    /// a + b, exact.
    add_i16_wide = AddI16Wide(a: i16, b: i16) -> i32 = i32::from(a) + i32::from(b);
    /// a − b, exact.
    sub_i16_wide = SubI16Wide(a: i16, b: i16) -> i32 = i32::from(a) - i32::from(b);
    /// a × b, exact.
    mul_i16_wide = MulI16Wide(a: i16, b: i16) -> i32 = i32::from(a) * i32::from(b);
    /// Quotient of a / b towards 0, exact (−32768 / −1 = 32768); 0 for b = 0.
    div_i16_wide = DivI16Wide(a: i16, b: i16) -> i32 = i32::from(a).checked_div(i32::from(b)).unwrap_or(0);
    /// ACCU 1 after `/I`: remainder in the high word, quotient in the low word; `old` for b = 0.
    div_i16_pair = DivI16Pair(a: i16, b: i16, old: u32) -> u32 = {
        let (a, b) = (i32::from(a), i32::from(b));
        if b == 0 { old } else { ((a % b) as u32) << 16 | (a / b) as u32 & 0xFFFF }
    };
    /// −a, exact.
    neg_i16_wide = NegI16Wide(a: i16) -> i32 = -i32::from(a);
    /// Whether the value does not fit a 16-bit integer.
    overflows_i16 = OverflowsI16(a: i32) -> bool = i16::try_from(a).is_err();
    /// Whether the low word is above 0.
    positive_i16 = PositiveI16(a: i16) -> bool = a > 0;
    /// Whether the low word is below 0.
    negative_i16 = NegativeI16(a: i16) -> bool = a < 0;
    /// a + b, wrapped.
    add_u32 = AddU32(a: u32, b: u32) -> u32 = a.wrapping_add(b);
    /// a − b, wrapped.
    sub_u32 = SubU32(a: u32, b: u32) -> u32 = a.wrapping_sub(b);
    /// a + b, exact.
    add_i32_wide = AddI32Wide(a: i32, b: i32) -> i64 = i64::from(a) + i64::from(b);
    /// a − b, exact.
    sub_i32_wide = SubI32Wide(a: i32, b: i32) -> i64 = i64::from(a) - i64::from(b);
    /// a × b, exact.
    mul_i32_wide = MulI32Wide(a: i32, b: i32) -> i64 = i64::from(a) * i64::from(b);
    /// Quotient of a / b towards 0, exact; 0 for b = 0.
    div_i32_wide = DivI32Wide(a: i32, b: i32) -> i64 = i64::from(a).checked_div(i64::from(b)).unwrap_or(0);
    /// Remainder of a / b with the sign of a, exact; 0 for b = 0.
    rem_i32_wide = RemI32Wide(a: i32, b: i32) -> i64 = i64::from(a).checked_rem(i64::from(b)).unwrap_or(0);
    /// −a, exact.
    neg_i32_wide = NegI32Wide(a: i32) -> i64 = -i64::from(a);
    /// Low 32 bits.
    low32 = Low32(a: u32) -> u32 = a;
    /// Whether the value does not fit a 32-bit integer.
    overflows_i32 = OverflowsI32(a: i64) -> bool = i32::try_from(a).is_err();
    /// Whether the low 32 bits are above 0.
    positive_i32 = PositiveI32(a: i32) -> bool = a > 0;
    /// Whether the low 32 bits are below 0.
    negative_i32 = NegativeI32(a: i32) -> bool = a < 0;
    /// Whether the exact value is above 0.
    positive_i64 = PositiveI64(a: i64) -> bool = a > 0;
    /// Whether the exact value is below 0.
    negative_i64 = NegativeI64(a: i64) -> bool = a < 0;

    // Comparison.
    /// a = b as 16-bit integers.
    eq_i16 = EqI16(a: i16, b: i16) -> bool = a == b;
    /// a ≠ b as 16-bit integers.
    ne_i16 = NeI16(a: i16, b: i16) -> bool = a != b;
    /// a < b as 16-bit integers.
    lt_i16 = LtI16(a: i16, b: i16) -> bool = a < b;
    /// a ≤ b as 16-bit integers.
    le_i16 = LeI16(a: i16, b: i16) -> bool = a <= b;
    /// a > b as 16-bit integers.
    gt_i16 = GtI16(a: i16, b: i16) -> bool = a > b;
    /// a ≥ b as 16-bit integers.
    ge_i16 = GeI16(a: i16, b: i16) -> bool = a >= b;
    /// a = b as 32-bit integers.
    eq_i32 = EqI32(a: i32, b: i32) -> bool = a == b;
    /// a ≠ b as 32-bit integers.
    ne_i32 = NeI32(a: i32, b: i32) -> bool = a != b;
    /// a < b as 32-bit integers.
    lt_i32 = LtI32(a: i32, b: i32) -> bool = a < b;
    /// a ≤ b as 32-bit integers.
    le_i32 = LeI32(a: i32, b: i32) -> bool = a <= b;
    /// a > b as 32-bit integers.
    gt_i32 = GtI32(a: i32, b: i32) -> bool = a > b;
    /// a ≥ b as 32-bit integers.
    ge_i32 = GeI32(a: i32, b: i32) -> bool = a >= b;
    /// a = b as REAL.
    eq_f32 = EqF32(a: f32, b: f32) -> bool = a == b;
    /// a ≠ b as REAL; false if either is no number, as the CPU has it.
    ne_f32 = NeF32(a: f32, b: f32) -> bool = a != b && !a.is_nan() && !b.is_nan();
    /// a < b as REAL.
    lt_f32 = LtF32(a: f32, b: f32) -> bool = a < b;
    /// a ≤ b as REAL.
    le_f32 = LeF32(a: f32, b: f32) -> bool = a <= b;
    /// a > b as REAL.
    gt_f32 = GtF32(a: f32, b: f32) -> bool = a > b;
    /// a ≥ b as REAL.
    ge_f32 = GeF32(a: f32, b: f32) -> bool = a >= b;
    /// Whether either REAL is no number.
    unordered_f32 = UnorderedF32(a: f32, b: f32) -> bool = a.is_nan() | b.is_nan();

    // REAL.
    /// a + b.
    add_f32 = AddF32(a: f32, b: f32) -> f32 = quiet(a + b);
    /// a − b.
    sub_f32 = SubF32(a: f32, b: f32) -> f32 = quiet(a - b);
    /// a × b.
    mul_f32 = MulF32(a: f32, b: f32) -> f32 = quiet(a * b);
    /// a / b.
    div_f32 = DivF32(a: f32, b: f32) -> f32 = quiet(a / b);
    /// a².
    sqr_f32 = SqrF32(a: f32) -> f32 = quiet(a * a);
    /// √a.
    sqrt_f32 = SqrtF32(a: f32) -> f32 = through_f64(a, libm::sqrt);
    /// e to the power a.
    exp_f32 = ExpF32(a: f32) -> f32 = through_f64(a, libm::exp);
    /// Natural logarithm; no number for a ≤ 0.
    ln_f32 = LnF32(a: f32) -> f32 = if a <= 0.0 { f32::NAN } else { through_f64(a, libm::log) };
    /// Sine of an angle in radians.
    sin_f32 = SinF32(a: f32) -> f32 = through_f64(a, libm::sin);
    /// Cosine of an angle in radians.
    cos_f32 = CosF32(a: f32) -> f32 = through_f64(a, libm::cos);
    /// Tangent of an angle in radians.
    tan_f32 = TanF32(a: f32) -> f32 = through_f64(a, libm::tan);
    /// Arc sine in radians.
    asin_f32 = AsinF32(a: f32) -> f32 = through_f64(a, libm::asin);
    /// Arc cosine in radians.
    acos_f32 = AcosF32(a: f32) -> f32 = through_f64(a, libm::acos);
    /// Arc tangent in radians.
    atan_f32 = AtanF32(a: f32) -> f32 = through_f64(a, libm::atan);
    /// CC 1 after a REAL result: above 0, or no number; 0 for a denormal one.
    real_cc1 = RealCc1(a: f32) -> bool = a.is_nan() || (a > 0.0 && !a.is_subnormal());
    /// CC 0 after a REAL result: below 0, or no number; 0 for a denormal one.
    real_cc0 = RealCc0(a: f32) -> bool = a.is_nan() || (a < 0.0 && !a.is_subnormal());
    /// OV after a REAL result: no number, infinite or denormal.
    real_overflow = RealOverflow(a: f32) -> bool = !a.is_finite() || a.is_subnormal();
    /// OV after a product or quotient: as `real_overflow`, and an exact 0 from operands that are not 0.
    real_product_overflow = RealProductOverflow(result: f32, a: f32, b: f32, quotient: bool) -> bool =
        !result.is_finite() || result.is_subnormal() || (result == 0.0 && a != 0.0 && b != 0.0 && !(quotient && b.is_infinite()));
    /// OV of EXP: as `real_overflow`, and an exact 0 from a finite argument.
    real_exp_overflow = RealExpOverflow(result: f32, a: f32) -> bool =
        !result.is_finite() || result.is_subnormal() || (result == 0.0 && a.is_finite());
    /// −a: bit 31 inverted.
    neg_f32 = NegF32(a: u32) -> u32 = a ^ 0x8000_0000;
    /// |a|: bit 31 cleared.
    abs_f32 = AbsF32(a: u32) -> u32 = a & 0x7FFF_FFFF;

    // Conversion.
    /// Whether the three digits of a BCD word are digits.
    is_bcd16 = IsBcd16(a: u16) -> bool = bcd::is_decimal(u32::from(a), 3);
    /// Whether the seven digits of a BCD double word are digits.
    is_bcd32 = IsBcd32(a: u32) -> bool = bcd::is_decimal(a, 7);
    /// BCD word (three digits, sign in bit 15) to integer.
    bcd_to_i16 = BcdToI16(a: u16) -> i16 = {
        let magnitude = bcd::decode(u32::from(a), 3) as i16;
        if a & 0x8000 != 0 { -magnitude } else { magnitude }
    };
    /// BCD double word (seven digits, sign in bit 31) to integer.
    bcd_to_i32 = BcdToI32(a: u32) -> i32 = {
        let magnitude = bcd::decode(a, 7) as i32;
        if a & 0x8000_0000 != 0 { -magnitude } else { magnitude }
    };
    /// Whether a 16-bit integer does not fit three BCD digits.
    overflows_bcd16 = OverflowsBcd16(a: i16) -> bool = a.unsigned_abs() > 999;
    /// Whether a 32-bit integer does not fit seven BCD digits.
    overflows_bcd32 = OverflowsBcd32(a: i32) -> bool = a.unsigned_abs() > 9_999_999;
    /// Integer to BCD word; the word itself if it does not fit.
    i16_to_bcd = I16ToBcd(a: i16) -> u16 = {
        let magnitude = u32::from(a.unsigned_abs());
        if magnitude > 999 { a as u16 } else { bcd::encode(magnitude) as u16 | if a < 0 { 0xF000 } else { 0 } }
    };
    /// Integer to BCD double word; the double word itself if it does not fit.
    i32_to_bcd = I32ToBcd(a: i32) -> u32 = {
        let magnitude = a.unsigned_abs();
        if magnitude > 9_999_999 { a as u32 } else { bcd::encode(magnitude) | if a < 0 { 0xF000_0000 } else { 0 } }
    };
    /// Integer to REAL, nearest even.
    i32_to_f32 = I32ToF32(a: i32) -> f32 = a as f32;
    /// REAL rounded to the nearest even integer.
    round_f32 = RoundF32(a: f32) -> f32 = quiet(a.round_ties_even());
    /// REAL rounded up.
    ceil_f32 = CeilF32(a: f32) -> f32 = quiet(a.ceil());
    /// REAL rounded down.
    floor_f32 = FloorF32(a: f32) -> f32 = quiet(a.floor());
    /// REAL rounded towards 0.
    trunc_f32 = TruncF32(a: f32) -> f32 = quiet(a.trunc());
    /// Whether an integral REAL does not fit a 32-bit integer.
    overflows_f32_i32 = OverflowsF32I32(a: f32) -> bool = !(-2_147_483_648.0..2_147_483_648.0).contains(&a);
    /// An integral REAL as integer; `old` if it does not fit.
    f32_to_i32 = F32ToI32(a: f32, old: u32) -> u32 =
        if (-2_147_483_648.0..2_147_483_648.0).contains(&a) { a as i32 as u32 } else { old };
    /// Bytes of the low word exchanged.
    swap16 = Swap16(a: u32) -> u32 = a & 0xFFFF_0000 | u32::from((a as u16).swap_bytes());
    /// Bytes in reverse order.
    swap32 = Swap32(a: u32) -> u32 = a.swap_bytes();

    // Word logic.
    /// AND of all bits.
    and_u32 = AndU32(a: u32, b: u32) -> u32 = a & b;
    /// OR of all bits.
    or_u32 = OrU32(a: u32, b: u32) -> u32 = a | b;
    /// XOR of all bits.
    xor_u32 = XorU32(a: u32, b: u32) -> u32 = a ^ b;

    // Shifts. The count is 0 to 255; results with count 0 are the value itself.
    /// Word shifted left.
    shl16 = Shl16(a: u16, n: u8) -> u16 = if n > 16 { 0 } else { (u32::from(a) << n) as u16 };
    /// Word shifted right.
    shr16 = Shr16(a: u16, n: u8) -> u16 = if n > 16 { 0 } else { (u32::from(a) >> n) as u16 };
    /// Word shifted right with its sign.
    sar16 = Sar16(a: i16, n: u8) -> u16 = (i32::from(a) >> n.min(16)) as u16;
    /// Double word shifted left.
    shl32 = Shl32(a: u32, n: u8) -> u32 = if n > 32 { 0 } else { (u64::from(a) << n) as u32 };
    /// Double word shifted right.
    shr32 = Shr32(a: u32, n: u8) -> u32 = if n > 32 { 0 } else { (u64::from(a) >> n) as u32 };
    /// Double word shifted right with its sign.
    sar32 = Sar32(a: i32, n: u8) -> u32 = (i64::from(a) >> n.min(32)) as u32;
    /// Double word rotated left.
    rol32 = Rol32(a: u32, n: u8) -> u32 = a.rotate_left(u32::from(n) % 32);
    /// Double word rotated right.
    ror32 = Ror32(a: u32, n: u8) -> u32 = a.rotate_right(u32::from(n) % 32);
    /// The bit that a left shift of a word pushed out last; 0 beyond 16.
    shl16_out = Shl16Out(a: u16, n: u8) -> bool = matches!(n, 1..=16) && a >> (16 - n) & 1 != 0;
    /// The bit that a right shift of a word pushed out last; 0 beyond 16.
    shr16_out = Shr16Out(a: u16, n: u8) -> bool = matches!(n, 1..=16) && a >> (n - 1) & 1 != 0;
    /// The bit that a signed right shift of a word pushed out last; the sign beyond 16.
    sar16_out = Sar16Out(a: i16, n: u8) -> bool = n > 0 && i32::from(a) >> (n - 1).min(16) & 1 != 0;
    /// The bit that a left shift of a double word pushed out last; 0 beyond 32.
    shl32_out = Shl32Out(a: u32, n: u8) -> bool = matches!(n, 1..=32) && a >> (32 - n) & 1 != 0;
    /// The bit that a right shift of a double word pushed out last; 0 beyond 32.
    shr32_out = Shr32Out(a: u32, n: u8) -> bool = matches!(n, 1..=32) && a >> (n - 1) & 1 != 0;
    /// The bit that a signed right shift of a double word pushed out last; the sign beyond 32.
    sar32_out = Sar32Out(a: i32, n: u8) -> bool = n > 0 && i64::from(a) >> (n - 1).min(32) & 1 != 0;
    /// Bit 0 of a rotated value: what a left rotation moved last.
    lowest_bit = LowestBit(a: u32) -> bool = a & 1 != 0;
    /// Bit 31 of a value: what a right rotation moved last.
    highest_bit = HighestBit(a: u32) -> bool = a >> 31 != 0;
    /// Rotation left by one through a carry bit.
    rol33 = Rol33(a: u32, carry: bool) -> u32 = a << 1 | u32::from(carry);
    /// Rotation right by one through a carry bit.
    ror33 = Ror33(a: u32, carry: bool) -> u32 = a >> 1 | u32::from(carry) << 31;

    // Pointers and status.
    /// A pointer for a block one call further in: V (the caller's local data) then lies one call further out, which bits 19 to 23 count.
    pass_on_pointer = PassOnPointer(pointer: u32) -> u32 =
        if pointer >> 24 == 0x87 && pointer & 0x00F8_0000 != 0x00F8_0000 { pointer + 0x0008_0000 } else { pointer };
    /// Address register after `+AR`: bits 0 to 23 plus a signed word, bits 24 to 31 kept.
    add_pointer = AddPointer(register: u32, offset: i16) -> u32 =
        register & 0xFF00_0000 | register.wrapping_add(i32::from(offset) as u32) & 0x00FF_FFFF;
    /// Four status bits packed from bit 0 up.
    pack4 = Pack4(b0: bool, b1: bool, b2: bool, b3: bool) -> u8 = u8::from(b0) | u8::from(b1) << 1 | u8::from(b2) << 2 | u8::from(b3) << 3;
    /// `low` plus `high` moved up by `shift` bits.
    join = Join(low: u32, high: u32, shift: u8) -> u32 = low | high.checked_shl(u32::from(shift)).unwrap_or(0);
    /// One bit of a value.
    bit_of = BitOf(a: u64, bit: u8) -> bool = a >> (bit & 63) & 1 != 0;
    /// Position of a LOOP counter: low word − 1, wrapped.
    decrement16 = Decrement16(a: u16) -> u16 = a.wrapping_sub(1);

    // Numbers of every size. A value stands zero-extended in its variable: what is the same for both signs has one row.
    /// a + b, wrapped to 8 bits.
    add_u8 = AddU8(a: u8, b: u8) -> u8 = a.wrapping_add(b);
    /// a + b, wrapped to 16 bits.
    add_u16 = AddU16(a: u16, b: u16) -> u16 = a.wrapping_add(b);
    /// a + b, wrapped to 64 bits.
    add_u64 = AddU64(a: u64, b: u64) -> u64 = a.wrapping_add(b);
    /// a − b, wrapped to 8 bits.
    sub_u8 = SubU8(a: u8, b: u8) -> u8 = a.wrapping_sub(b);
    /// a − b, wrapped to 16 bits.
    sub_u16 = SubU16(a: u16, b: u16) -> u16 = a.wrapping_sub(b);
    /// a − b, wrapped to 64 bits.
    sub_u64 = SubU64(a: u64, b: u64) -> u64 = a.wrapping_sub(b);
    /// a × b, wrapped to 8 bits.
    mul_u8 = MulU8(a: u8, b: u8) -> u8 = a.wrapping_mul(b);
    /// a × b, wrapped to 16 bits.
    mul_u16 = MulU16(a: u16, b: u16) -> u16 = a.wrapping_mul(b);
    /// a × b, wrapped to 32 bits.
    mul_u32 = MulU32(a: u32, b: u32) -> u32 = a.wrapping_mul(b);
    /// a × b, wrapped to 64 bits.
    mul_u64 = MulU64(a: u64, b: u64) -> u64 = a.wrapping_mul(b);
    /// −a, wrapped to 8 bits.
    neg_i8 = NegI8(a: i8) -> i8 = a.wrapping_neg();
    /// −a, wrapped to 16 bits.
    neg_i16 = NegI16(a: i16) -> i16 = a.wrapping_neg();
    /// −a, wrapped to 32 bits.
    neg_i32 = NegI32(a: i32) -> i32 = a.wrapping_neg();
    /// −a, wrapped to 64 bits.
    neg_i64 = NegI64(a: i64) -> i64 = a.wrapping_neg();
    /// |a|, wrapped: the least 8-bit integer stays as it is.
    abs_i8 = AbsI8(a: i8) -> i8 = a.wrapping_abs();
    /// |a|, wrapped: the least 16-bit integer stays as it is.
    abs_i16 = AbsI16(a: i16) -> i16 = a.wrapping_abs();
    /// |a|, wrapped: the least 32-bit integer stays as it is.
    abs_i32 = AbsI32(a: i32) -> i32 = a.wrapping_abs();
    /// |a|, wrapped: the least 64-bit integer stays as it is.
    abs_i64 = AbsI64(a: i64) -> i64 = a.wrapping_abs();
    /// Quotient of a / b towards 0, wrapped; 0 for b = 0.
    div_i8 = DivI8(a: i8, b: i8) -> i8 = if b == 0 { 0 } else { a.wrapping_div(b) };
    /// Quotient of a / b towards 0, wrapped; 0 for b = 0.
    div_i16 = DivI16(a: i16, b: i16) -> i16 = if b == 0 { 0 } else { a.wrapping_div(b) };
    /// Quotient of a / b towards 0, wrapped; 0 for b = 0.
    div_i32 = DivI32(a: i32, b: i32) -> i32 = if b == 0 { 0 } else { a.wrapping_div(b) };
    /// Quotient of a / b towards 0, wrapped; 0 for b = 0.
    div_i64 = DivI64(a: i64, b: i64) -> i64 = if b == 0 { 0 } else { a.wrapping_div(b) };
    /// Quotient of a / b, unsigned; 0 for b = 0.
    div_u64 = DivU64(a: u64, b: u64) -> u64 = a.checked_div(b).unwrap_or(0);
    /// Remainder of a / b with the sign of a; 0 for b = 0.
    rem_i8 = RemI8(a: i8, b: i8) -> i8 = if b == 0 { 0 } else { a.wrapping_rem(b) };
    /// Remainder of a / b with the sign of a; 0 for b = 0.
    rem_i16 = RemI16(a: i16, b: i16) -> i16 = if b == 0 { 0 } else { a.wrapping_rem(b) };
    /// Remainder of a / b with the sign of a; 0 for b = 0.
    rem_i32 = RemI32(a: i32, b: i32) -> i32 = if b == 0 { 0 } else { a.wrapping_rem(b) };
    /// Remainder of a / b with the sign of a; 0 for b = 0.
    rem_i64 = RemI64(a: i64, b: i64) -> i64 = if b == 0 { 0 } else { a.wrapping_rem(b) };
    /// Remainder of a / b, unsigned; 0 for b = 0.
    rem_u64 = RemU64(a: u64, b: u64) -> u64 = a.checked_rem(b).unwrap_or(0);
    /// The smaller of two signed 8-bit integers.
    min_i8 = MinI8(a: i8, b: i8) -> i8 = a.min(b);
    /// The greater of two signed 8-bit integers.
    max_i8 = MaxI8(a: i8, b: i8) -> i8 = a.max(b);
    /// The smaller of two signed 16-bit integers.
    min_i16 = MinI16(a: i16, b: i16) -> i16 = a.min(b);
    /// The greater of two signed 16-bit integers.
    max_i16 = MaxI16(a: i16, b: i16) -> i16 = a.max(b);
    /// The smaller of two signed 32-bit integers.
    min_i32 = MinI32(a: i32, b: i32) -> i32 = a.min(b);
    /// The greater of two signed 32-bit integers.
    max_i32 = MaxI32(a: i32, b: i32) -> i32 = a.max(b);
    /// The smaller of two signed 64-bit integers.
    min_i64 = MinI64(a: i64, b: i64) -> i64 = a.min(b);
    /// The greater of two signed 64-bit integers.
    max_i64 = MaxI64(a: i64, b: i64) -> i64 = a.max(b);
    /// The smaller of two unsigned values.
    min_u64 = MinU64(a: u64, b: u64) -> u64 = a.min(b);
    /// The greater of two unsigned values.
    max_u64 = MaxU64(a: u64, b: u64) -> u64 = a.max(b);
    /// Whether a ≠ b.
    differ = Differ(a: u64, b: u64) -> bool = a != b;
    /// Whether a ≤ b, unsigned.
    le_u64 = LeU64(a: u64, b: u64) -> bool = a <= b;
    /// Whether a > b, unsigned.
    gt_u64 = GtU64(a: u64, b: u64) -> bool = a > b;
    /// Whether a ≥ b, unsigned.
    ge_u64 = GeU64(a: u64, b: u64) -> bool = a >= b;
    /// a < b as signed 8-bit integers.
    lt_i8 = LtI8(a: i8, b: i8) -> bool = a < b;
    /// a ≤ b as signed 8-bit integers.
    le_i8 = LeI8(a: i8, b: i8) -> bool = a <= b;
    /// a > b as signed 8-bit integers.
    gt_i8 = GtI8(a: i8, b: i8) -> bool = a > b;
    /// a ≥ b as signed 8-bit integers.
    ge_i8 = GeI8(a: i8, b: i8) -> bool = a >= b;
    /// a < b as signed 64-bit integers.
    lt_i64 = LtI64(a: i64, b: i64) -> bool = a < b;
    /// a ≤ b as signed 64-bit integers.
    le_i64 = LeI64(a: i64, b: i64) -> bool = a <= b;
    /// a > b as signed 64-bit integers.
    gt_i64 = GtI64(a: i64, b: i64) -> bool = a > b;
    /// a ≥ b as signed 64-bit integers.
    ge_i64 = GeI64(a: i64, b: i64) -> bool = a >= b;

    // What those of limited size lost.
    /// Whether a + b does not fit a signed 8-bit integer.
    add_overflows_i8 = AddOverflowsI8(a: i8, b: i8) -> bool = a.checked_add(b).is_none();
    /// Whether a + b does not fit a signed 16-bit integer.
    add_overflows_i16 = AddOverflowsI16(a: i16, b: i16) -> bool = a.checked_add(b).is_none();
    /// Whether a + b does not fit a signed 32-bit integer.
    add_overflows_i32 = AddOverflowsI32(a: i32, b: i32) -> bool = a.checked_add(b).is_none();
    /// Whether a + b does not fit a signed 64-bit integer.
    add_overflows_i64 = AddOverflowsI64(a: i64, b: i64) -> bool = a.checked_add(b).is_none();
    /// Whether a + b does not fit an unsigned 8-bit integer.
    add_overflows_u8 = AddOverflowsU8(a: u8, b: u8) -> bool = a.checked_add(b).is_none();
    /// Whether a + b does not fit an unsigned 16-bit integer.
    add_overflows_u16 = AddOverflowsU16(a: u16, b: u16) -> bool = a.checked_add(b).is_none();
    /// Whether a + b does not fit an unsigned 32-bit integer.
    add_overflows_u32 = AddOverflowsU32(a: u32, b: u32) -> bool = a.checked_add(b).is_none();
    /// Whether a + b does not fit an unsigned 64-bit integer.
    add_overflows_u64 = AddOverflowsU64(a: u64, b: u64) -> bool = a.checked_add(b).is_none();
    /// Whether a − b does not fit a signed 8-bit integer.
    sub_overflows_i8 = SubOverflowsI8(a: i8, b: i8) -> bool = a.checked_sub(b).is_none();
    /// Whether a − b does not fit a signed 16-bit integer.
    sub_overflows_i16 = SubOverflowsI16(a: i16, b: i16) -> bool = a.checked_sub(b).is_none();
    /// Whether a − b does not fit a signed 32-bit integer.
    sub_overflows_i32 = SubOverflowsI32(a: i32, b: i32) -> bool = a.checked_sub(b).is_none();
    /// Whether a − b does not fit a signed 64-bit integer.
    sub_overflows_i64 = SubOverflowsI64(a: i64, b: i64) -> bool = a.checked_sub(b).is_none();
    /// Whether a − b does not fit an unsigned 8-bit integer.
    sub_overflows_u8 = SubOverflowsU8(a: u8, b: u8) -> bool = a.checked_sub(b).is_none();
    /// Whether a − b does not fit an unsigned 16-bit integer.
    sub_overflows_u16 = SubOverflowsU16(a: u16, b: u16) -> bool = a.checked_sub(b).is_none();
    /// Whether a − b does not fit an unsigned 32-bit integer.
    sub_overflows_u32 = SubOverflowsU32(a: u32, b: u32) -> bool = a.checked_sub(b).is_none();
    /// Whether a − b does not fit an unsigned 64-bit integer.
    sub_overflows_u64 = SubOverflowsU64(a: u64, b: u64) -> bool = a.checked_sub(b).is_none();
    /// Whether a × b does not fit a signed 8-bit integer.
    mul_overflows_i8 = MulOverflowsI8(a: i8, b: i8) -> bool = a.checked_mul(b).is_none();
    /// Whether a × b does not fit a signed 16-bit integer.
    mul_overflows_i16 = MulOverflowsI16(a: i16, b: i16) -> bool = a.checked_mul(b).is_none();
    /// Whether a × b does not fit a signed 32-bit integer.
    mul_overflows_i32 = MulOverflowsI32(a: i32, b: i32) -> bool = a.checked_mul(b).is_none();
    /// Whether a × b does not fit a signed 64-bit integer.
    mul_overflows_i64 = MulOverflowsI64(a: i64, b: i64) -> bool = a.checked_mul(b).is_none();
    /// Whether a × b does not fit an unsigned 8-bit integer.
    mul_overflows_u8 = MulOverflowsU8(a: u8, b: u8) -> bool = a.checked_mul(b).is_none();
    /// Whether a × b does not fit an unsigned 16-bit integer.
    mul_overflows_u16 = MulOverflowsU16(a: u16, b: u16) -> bool = a.checked_mul(b).is_none();
    /// Whether a × b does not fit an unsigned 32-bit integer.
    mul_overflows_u32 = MulOverflowsU32(a: u32, b: u32) -> bool = a.checked_mul(b).is_none();
    /// Whether a × b does not fit an unsigned 64-bit integer.
    mul_overflows_u64 = MulOverflowsU64(a: u64, b: u64) -> bool = a.checked_mul(b).is_none();
    /// Whether a / b has no 8-bit result: b = 0, or the least integer by −1.
    div_fails_i8 = DivFailsI8(a: i8, b: i8) -> bool = a.checked_div(b).is_none();
    /// Whether a / b has no 16-bit result: b = 0, or the least integer by −1.
    div_fails_i16 = DivFailsI16(a: i16, b: i16) -> bool = a.checked_div(b).is_none();
    /// Whether a / b has no 32-bit result: b = 0, or the least integer by −1.
    div_fails_i32 = DivFailsI32(a: i32, b: i32) -> bool = a.checked_div(b).is_none();
    /// Whether a / b has no 64-bit result: b = 0, or the least integer by −1.
    div_fails_i64 = DivFailsI64(a: i64, b: i64) -> bool = a.checked_div(b).is_none();
    /// Whether −a does not fit 8 bits: a is the least integer.
    neg_overflows_i8 = NegOverflowsI8(a: i8) -> bool = a == i8::MIN;
    /// Whether −a does not fit 16 bits: a is the least integer.
    neg_overflows_i16 = NegOverflowsI16(a: i16) -> bool = a == i16::MIN;
    /// Whether −a does not fit 32 bits: a is the least integer.
    neg_overflows_i32 = NegOverflowsI32(a: i32) -> bool = a == i32::MIN;
    /// Whether −a does not fit 64 bits: a is the least integer.
    neg_overflows_i64 = NegOverflowsI64(a: i64) -> bool = a == i64::MIN;
    /// Whether b = 0.
    divisor_is_zero = DivisorIsZero(a: u64, b: u64) -> bool = { let _ = a; b == 0 };
    /// Whether a signed value is outside least…most.
    outside_i64 = OutsideI64(value: i64, least: i64, most: i64) -> bool = !(least..=most).contains(&value);
    /// Whether an LREAL is outside least…most or no number.
    outside_f64 = OutsideF64(value: f64, least: f64, most: f64) -> bool = !(least..=most).contains(&value);

    // Bit strings of every size.
    /// AND of all 64 bits.
    and_u64 = AndU64(a: u64, b: u64) -> u64 = a & b;
    /// OR of all 64 bits.
    or_u64 = OrU64(a: u64, b: u64) -> u64 = a | b;
    /// XOR of all 64 bits.
    xor_u64 = XorU64(a: u64, b: u64) -> u64 = a ^ b;
    /// All 8 bits inverted.
    not_u8 = NotU8(a: u8) -> u8 = !a;
    /// All 16 bits inverted.
    not_u16 = NotU16(a: u16) -> u16 = !a;
    /// All 32 bits inverted.
    not_u32 = NotU32(a: u32) -> u32 = !a;
    /// All 64 bits inverted.
    not_u64 = NotU64(a: u64) -> u64 = !a;
    /// Byte shifted left.
    shl8 = Shl8(a: u8, n: u8) -> u8 = a.checked_shl(u32::from(n)).unwrap_or(0);
    /// Byte shifted right.
    shr8 = Shr8(a: u8, n: u8) -> u8 = a.checked_shr(u32::from(n)).unwrap_or(0);
    /// Byte shifted right with its sign.
    sar8 = Sar8(a: i8, n: u8) -> i8 = a >> n.min(7);
    /// 64 bits shifted left.
    shl64 = Shl64(a: u64, n: u8) -> u64 = a.checked_shl(u32::from(n)).unwrap_or(0);
    /// 64 bits shifted right.
    shr64 = Shr64(a: u64, n: u8) -> u64 = a.checked_shr(u32::from(n)).unwrap_or(0);
    /// 64 bits shifted right with their sign.
    sar64 = Sar64(a: i64, n: u8) -> i64 = a >> n.min(63);
    /// Byte rotated left.
    rol8 = Rol8(a: u8, n: u8) -> u8 = a.rotate_left(u32::from(n) % 8);
    /// Byte rotated right.
    ror8 = Ror8(a: u8, n: u8) -> u8 = a.rotate_right(u32::from(n) % 8);
    /// Word rotated left.
    rol16 = Rol16(a: u16, n: u8) -> u16 = a.rotate_left(u32::from(n) % 16);
    /// Word rotated right.
    ror16 = Ror16(a: u16, n: u8) -> u16 = a.rotate_right(u32::from(n) % 16);
    /// 64 bits rotated left.
    rol64 = Rol64(a: u64, n: u8) -> u64 = a.rotate_left(u32::from(n) % 64);
    /// 64 bits rotated right.
    ror64 = Ror64(a: u64, n: u8) -> u64 = a.rotate_right(u32::from(n) % 64);
    /// A count of shifted places: at most 255.
    shift_count = ShiftCount(n: u64) -> u8 = n.min(255) as u8;
    /// A value with one bit (0 to 63, else none) set to `value`.
    with_bit = WithBit(a: u64, bit: u64, value: bool) -> u64 = match 1_u64.checked_shl(u32::try_from(bit).unwrap_or(64)) { Some(mask) if value => a | mask, Some(mask) => a & !mask, None => a };
    /// How many bits are 1.
    count_ones = CountOnes(a: u64) -> u8 = a.count_ones() as u8;
    /// Number of the lowest bit that is 1; 64 for 0.
    lowest_one = LowestOne(a: u64) -> u8 = a.trailing_zeros() as u8;
    /// Eight bytes in reverse order.
    swap64 = Swap64(a: u64) -> u64 = a.swap_bytes();

    // LREAL, and what REAL has beyond the S7.
    /// Whether two REALs differ: true if either is no number, as IEEE 754 has it.
    differ_f32 = DifferF32(a: f32, b: f32) -> bool = a != b;
    /// The smaller REAL; the other one if one is no number.
    min_f32 = MinF32(a: f32, b: f32) -> f32 = quiet(libm::fminf(a, b));
    /// The greater REAL; the other one if one is no number.
    max_f32 = MaxF32(a: f32, b: f32) -> f32 = quiet(libm::fmaxf(a, b));
    /// Natural logarithm; −∞ for 0.
    log_f32 = LogF32(a: f32) -> f32 = through_f64(a, libm::log);
    /// Logarithm to base 10; −∞ for 0.
    log10_f32 = Log10F32(a: f32) -> f32 = through_f64(a, libm::log10);
    /// 10 to the power a.
    exp10_f32 = Exp10F32(a: f32) -> f32 = through_f64(a, libm::exp10);
    /// a to the power b.
    pow_f32 = PowF32(a: f32, b: f32) -> f32 = quiet(libm::pow(f64::from(a), f64::from(b)) as f32);
    /// Angle of the point (x, y) in radians.
    atan2_f32 = Atan2F32(y: f32, x: f32) -> f32 = quiet(libm::atan2(f64::from(y), f64::from(x)) as f32);
    /// a + b.
    add_f64 = AddF64(a: f64, b: f64) -> f64 = quiet64(a + b);
    /// a − b.
    sub_f64 = SubF64(a: f64, b: f64) -> f64 = quiet64(a - b);
    /// a × b.
    mul_f64 = MulF64(a: f64, b: f64) -> f64 = quiet64(a * b);
    /// a / b.
    div_f64 = DivF64(a: f64, b: f64) -> f64 = quiet64(a / b);
    /// −a: bit 63 inverted.
    neg_f64 = NegF64(a: u64) -> u64 = a ^ 1 << 63;
    /// |a|: bit 63 cleared.
    abs_f64 = AbsF64(a: u64) -> u64 = a & !(1 << 63);
    /// a = b as LREAL.
    eq_f64 = EqF64(a: f64, b: f64) -> bool = a == b;
    /// a < b as LREAL.
    lt_f64 = LtF64(a: f64, b: f64) -> bool = a < b;
    /// a ≤ b as LREAL.
    le_f64 = LeF64(a: f64, b: f64) -> bool = a <= b;
    /// a > b as LREAL.
    gt_f64 = GtF64(a: f64, b: f64) -> bool = a > b;
    /// a ≥ b as LREAL.
    ge_f64 = GeF64(a: f64, b: f64) -> bool = a >= b;
    /// Whether two LREALs differ: true if either is no number.
    differ_f64 = DifferF64(a: f64, b: f64) -> bool = a != b;
    /// The smaller LREAL; the other one if one is no number.
    min_f64 = MinF64(a: f64, b: f64) -> f64 = quiet64(libm::fmin(a, b));
    /// The greater LREAL; the other one if one is no number.
    max_f64 = MaxF64(a: f64, b: f64) -> f64 = quiet64(libm::fmax(a, b));
    /// Whether a REAL is infinite or no number.
    overflows_f32 = OverflowsF32(a: f32) -> bool = !a.is_finite();
    /// Whether an LREAL is infinite or no number.
    overflows_f64 = OverflowsF64(a: f64) -> bool = !a.is_finite();
    /// √a.
    sqrt_f64 = SqrtF64(a: f64) -> f64 = quiet64(libm::sqrt(a));
    /// e to the power a.
    exp_f64 = ExpF64(a: f64) -> f64 = quiet64(libm::exp(a));
    /// 10 to the power a.
    exp10_f64 = Exp10F64(a: f64) -> f64 = quiet64(libm::exp10(a));
    /// Natural logarithm; −∞ for 0.
    log_f64 = LogF64(a: f64) -> f64 = quiet64(libm::log(a));
    /// Logarithm to base 10; −∞ for 0.
    log10_f64 = Log10F64(a: f64) -> f64 = quiet64(libm::log10(a));
    /// Sine of an angle in radians.
    sin_f64 = SinF64(a: f64) -> f64 = quiet64(libm::sin(a));
    /// Cosine of an angle in radians.
    cos_f64 = CosF64(a: f64) -> f64 = quiet64(libm::cos(a));
    /// Tangent of an angle in radians.
    tan_f64 = TanF64(a: f64) -> f64 = quiet64(libm::tan(a));
    /// Arc sine in radians.
    asin_f64 = AsinF64(a: f64) -> f64 = quiet64(libm::asin(a));
    /// Arc cosine in radians.
    acos_f64 = AcosF64(a: f64) -> f64 = quiet64(libm::acos(a));
    /// Arc tangent in radians.
    atan_f64 = AtanF64(a: f64) -> f64 = quiet64(libm::atan(a));
    /// a to the power b.
    pow_f64 = PowF64(a: f64, b: f64) -> f64 = quiet64(libm::pow(a, b));
    /// Angle of the point (x, y) in radians.
    atan2_f64 = Atan2F64(y: f64, x: f64) -> f64 = quiet64(libm::atan2(y, x));
    /// LREAL rounded to the nearest even integer.
    round_f64 = RoundF64(a: f64) -> f64 = quiet64(a.round_ties_even());
    /// LREAL rounded to the nearest integer, halves away from 0.
    round_away_f64 = RoundAwayF64(a: f64) -> f64 = quiet64(a.round());
    /// LREAL rounded up.
    ceil_f64 = CeilF64(a: f64) -> f64 = quiet64(a.ceil());
    /// LREAL rounded down.
    floor_f64 = FloorF64(a: f64) -> f64 = quiet64(a.floor());
    /// LREAL rounded towards 0.
    trunc_f64 = TruncF64(a: f64) -> f64 = quiet64(a.trunc());

    // Conversion between sizes and kinds of numbers.
    /// Sign-extended from 8 to 16 bits.
    extend_i8_i16 = ExtendI8I16(a: i8) -> i16 = i16::from(a);
    /// Sign-extended from 8 to 32 bits.
    extend_i8_i32 = ExtendI8I32(a: i8) -> i32 = i32::from(a);
    /// Sign-extended from 8 to 64 bits.
    extend_i8_i64 = ExtendI8I64(a: i8) -> i64 = i64::from(a);
    /// Sign-extended from 16 to 64 bits.
    extend_i16_i64 = ExtendI16I64(a: i16) -> i64 = i64::from(a);
    /// Sign-extended from 32 to 64 bits.
    extend_i32_i64 = ExtendI32I64(a: i32) -> i64 = i64::from(a);
    /// Integer to LREAL, exact.
    i32_to_f64 = I32ToF64(a: i32) -> f64 = f64::from(a);
    /// Signed 64-bit integer to REAL, nearest even.
    i64_to_f32 = I64ToF32(a: i64) -> f32 = a as f32;
    /// Signed 64-bit integer to LREAL, nearest even.
    i64_to_f64 = I64ToF64(a: i64) -> f64 = a as f64;
    /// Unsigned 64-bit integer to REAL, nearest even.
    u64_to_f32 = U64ToF32(a: u64) -> f32 = a as f32;
    /// Unsigned 64-bit integer to LREAL, nearest even.
    u64_to_f64 = U64ToF64(a: u64) -> f64 = a as f64;
    /// REAL to LREAL, exact.
    f32_to_f64 = F32ToF64(a: f32) -> f64 = quiet64(f64::from(a));
    /// LREAL to REAL, nearest even.
    f64_to_f32 = F64ToF32(a: f64) -> f32 = quiet(a as f32);
    /// LREAL cut to a signed 8-bit integer; the nearest limit outside its range, 0 if no number.
    f64_to_i8 = F64ToI8(a: f64) -> i8 = a as i8;
    /// LREAL cut to a signed 16-bit integer; the nearest limit outside its range, 0 if no number.
    f64_to_i16 = F64ToI16(a: f64) -> i16 = a as i16;
    /// LREAL cut to a signed 32-bit integer; the nearest limit outside its range, 0 if no number.
    f64_to_i32 = F64ToI32(a: f64) -> i32 = a as i32;
    /// LREAL cut to a signed 64-bit integer; the nearest limit outside its range, 0 if no number.
    f64_to_i64 = F64ToI64(a: f64) -> i64 = a as i64;
    /// LREAL cut to an unsigned 8-bit integer; the nearest limit outside its range, 0 if no number.
    f64_to_u8 = F64ToU8(a: f64) -> u8 = a as u8;
    /// LREAL cut to an unsigned 16-bit integer; the nearest limit outside its range, 0 if no number.
    f64_to_u16 = F64ToU16(a: f64) -> u16 = a as u16;
    /// LREAL cut to an unsigned 32-bit integer; the nearest limit outside its range, 0 if no number.
    f64_to_u32 = F64ToU32(a: f64) -> u32 = a as u32;
    /// LREAL cut to an unsigned 64-bit integer; the nearest limit outside its range, 0 if no number.
    f64_to_u64 = F64ToU64(a: f64) -> u64 = a as u64;
    /// The number that the lowest `digits` decimal digits (at most 16) mean.
    bcd_decode = BcdDecode(a: u64, digits: u8) -> u64 = (0..digits.min(16)).rev().fold(0, |number, digit| number * 10 + (a >> (4 * digit) & 0xF));
    /// The sixteen lowest decimal digits of a number.
    bcd_encode = BcdEncode(a: u64) -> u64 = u64::from(bcd::encode((a % 100_000_000) as u32)) | u64::from(bcd::encode((a / 100_000_000 % 100_000_000) as u32)) << 32;
    /// Whether the lowest `digits` decimal digits (at most 16) are digits.
    is_bcd = IsBcd(a: u64, digits: u8) -> bool = (0..digits.min(16)).all(|digit| a >> (4 * digit) & 0xF <= 9);
}

/// Any NaN becomes the quiet NaN that the project shows, so that both engines and all machines agree.
#[inline(always)]
fn quiet(a: f32) -> f32 {
    if a.is_nan() { f32::NAN } else { a }
}

/// The same for LREAL.
#[inline(always)]
fn quiet64(a: f64) -> f64 {
    if a.is_nan() { f64::NAN } else { a }
}

/// A function computed in f64 and rounded to f32: the same bits on every machine.
fn through_f64(a: f32, function: fn(f64) -> f64) -> f32 {
    quiet(function(f64::from(a)) as f32)
}

#[cfg(test)]
mod tests {
    use super::Op;

    /// The shims are safe functions with the body of `eval`; that they agree is proven by the engine that calls them.
    #[test]
    fn every_operation_has_a_name_a_sentence_and_a_shim() {
        for &op in Op::ALL {
            assert!(!op.doc().is_empty(), "{} has no sentence", op.name());
            assert!(op.arity() <= 4, "{} takes too many arguments", op.name());
            assert!(!op.shim().is_null());
        }
    }

    #[test]
    fn every_operation_is_total_on_edge_values() {
        const EDGES: &[u64] = &[
            0,
            1,
            2,
            15,
            16,
            17,
            31,
            32,
            33,
            0x7F,
            0x80,
            0xFF,
            0x0999,
            0x7FFF,
            0x8000,
            0xFFFF,
            0x7FFF_FFFF,
            0x8000_0000,
            0xFFFF_FFFF,
            0x7FC0_0000,
            u64::MAX,
        ];
        for &op in Op::ALL {
            for &a in EDGES {
                for &b in EDGES {
                    for c in [0, 1, 0x8000_0000] {
                        let result = op.eval([a, b, c, 1]);
                        assert_eq!(result, op.eval([a, b, c, 1]), "{} is a function", op.name());
                    }
                }
            }
        }
    }
}
