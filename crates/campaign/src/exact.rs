//! A sum of numbers without rounding: whichever way the numbers are divided into parts, the sum of the parts is the sum of all.

use serde_json::Value as Json;

/// Bits of a limb.
const LIMB: i32 = 32;
/// The exponent of the lowest bit that is kept: below it no double has one.
const LEAST: i32 = -34 * LIMB;
/// From the lowest bit of the least double to the highest of the greatest, and room for carries.
const LIMBS: usize = 68;
/// Numbers that are added before carries are moved on: a limb has room for so many.
const ADDED_MAX: u32 = 1 << 29;

/// The sum of any number of doubles, exactly.
#[derive(Clone, Debug)]
pub struct Sum {
    /// Each counts 2^32 times as much as the one before it.
    limbs: [i64; LIMBS],
    added: u32,
}

impl Default for Sum {
    fn default() -> Self {
        Self { limbs: [0; LIMBS], added: 0 }
    }
}

impl PartialEq for Sum {
    fn eq(&self, other: &Self) -> bool {
        self.settled() == other.settled()
    }
}

impl Sum {
    /// Takes a finite number in; any other is left out.
    pub fn add(&mut self, value: f64) {
        if !value.is_finite() || value == 0.0 {
            return;
        }
        let bits = value.to_bits();
        let exponent = (bits >> 52 & 0x7FF) as i32;
        let fraction = bits & ((1 << 52) - 1);
        // A subnormal has no hidden bit, and the exponent of the least normal number.
        let (mantissa, exponent) = if exponent == 0 { (fraction, 1) } else { (fraction | 1 << 52, exponent) };
        let at = (exponent - 1075 - LEAST) as usize;
        let wide = u128::from(mantissa) << (at % LIMB as usize);
        for (limb, part) in self.limbs[at / LIMB as usize..].iter_mut().zip([wide, wide >> 32, wide >> 64]) {
            let part = i64::from(part as u32);
            *limb += if value < 0.0 { -part } else { part };
        }
        self.counted(1);
    }

    /// Takes another sum in.
    pub fn merge(&mut self, other: &Self) {
        let mut other = other.clone();
        other.carry();
        for (limb, part) in self.limbs.iter_mut().zip(other.limbs) {
            *limb += part;
        }
        self.counted(1);
    }

    fn counted(&mut self, count: u32) {
        self.added += count;
        if self.added >= ADDED_MAX {
            self.carry();
        }
    }

    /// Moves what does not fit into 32 bits on; only the last limb has a sign then.
    fn carry(&mut self) {
        let mut carry = 0;
        let (last, rest) = self.limbs.split_last_mut().expect("there are limbs");
        for limb in rest {
            let all = *limb + carry;
            *limb = all & 0xFFFF_FFFF;
            carry = all >> LIMB;
        }
        *last += carry;
        self.added = 0;
    }

    /// Whether it is negative, and its magnitude in limbs of 32 bits: the same for the same sum.
    fn settled(&self) -> (bool, [i64; LIMBS]) {
        let mut sum = self.clone();
        sum.carry();
        let negative = sum.limbs[LIMBS - 1] < 0;
        if negative {
            sum.limbs.iter_mut().for_each(|limb| *limb = -*limb);
            sum.carry();
        }
        (negative, sum.limbs)
    }

    /// The double that is nearest to it.
    pub fn value(&self) -> f64 {
        let (negative, limbs) = self.settled();
        let Some(top) = limbs.iter().rposition(|&limb| limb != 0) else { return 0.0 };
        let low = top.saturating_sub(3);
        let mut high = limbs[low..=top].iter().rev().fold(0_u128, |all, &limb| all << LIMB | u128::from(limb as u64));
        // What is left of it only says on which side of a half it lies.
        if limbs[..low].iter().any(|&limb| limb != 0) {
            high |= 1;
        }
        let magnitude = libm::scalbn(high as f64, LEAST + low as i32 * LIMB);
        if negative { -magnitude } else { magnitude }
    }

    /// For files: the sign, the place of the lowest limb that is not 0, and the limbs from there in hexadecimal digits.
    pub fn to_json(&self) -> Json {
        let (negative, limbs) = self.settled();
        let first = limbs.iter().position(|&limb| limb != 0).unwrap_or(LIMBS);
        let last = limbs.iter().rposition(|&limb| limb != 0).map_or(first, |last| last + 1);
        let digits: String = limbs[first..last].iter().rev().map(|limb| format!("{limb:08x}")).collect();
        format!("{}{digits}@{first}", if negative { "-" } else { "" }).into()
    }

    /// What was written by [`Self::to_json`].
    pub fn from_json(json: &Json) -> Option<Self> {
        let text = json.as_str()?;
        let (negative, text) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
        let (digits, first) = text.split_once('@')?;
        let first: usize = first.parse().ok()?;
        if !digits.is_ascii() || digits.len() % 8 != 0 || digits.len() / 8 + first > LIMBS {
            return None;
        }
        let mut sum = Self::default();
        for (limb, part) in sum.limbs[first..].iter_mut().zip(digits.as_bytes().rchunks(8)) {
            let part = i64::from(u32::from_str_radix(std::str::from_utf8(part).ok()?, 16).ok()?);
            *limb = if negative { -part } else { part };
        }
        Some(sum)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn sum(values: &[f64]) -> Sum {
        let mut sum = Sum::default();
        values.iter().for_each(|&value| sum.add(value));
        sum
    }

    #[test]
    fn nothing_is_rounded_away() {
        assert_eq!(sum(&[1e300, 1.0, -1e300]).value(), 1.0);
        assert_eq!(sum(&[1e16, 1.0, 1.0, -1e16]).value(), 2.0);
        assert_eq!(sum(&[0.1; 10]).value(), 1.0, "ten times what 0.1 is lies nearest to 1");
        assert_eq!(sum(&[f64::MAX, f64::MAX]).value(), f64::INFINITY);
        assert_eq!(sum(&[f64::MAX, f64::MAX, -f64::MAX]).value(), f64::MAX);
        assert_eq!(sum(&[f64::from_bits(1), f64::from_bits(1)]).value(), f64::from_bits(2));
        assert_eq!(sum(&[f64::NAN, f64::INFINITY, 3.0]).value(), 3.0);
        assert_eq!((sum(&[]).value(), sum(&[]).to_json()), (0.0, "@68".into()));
        assert_eq!(sum(&[-2.5]).value(), -2.5);
    }

    #[test]
    fn what_no_sum_wrote_is_none() {
        for text in ["", "1@", "@", "x@1", "00000000000000zz@3", "00000001@68", "éééé@1", "00000001@99999999999999999999"] {
            assert_eq!(Sum::from_json(&text.into()), None, "{text}");
        }
        assert_eq!(Sum::from_json(&Json::Null), None);
    }

    proptest! {
        #[test]
        fn parts_make_the_whole(values in prop::collection::vec(any::<f64>().prop_filter("finite", |value| value.is_finite()), 0..60), cut in 0..60_usize) {
            let whole = sum(&values);
            let cut = cut.min(values.len());
            let mut parts = sum(&values[cut..]);
            parts.merge(&sum(&values[..cut]));
            prop_assert_eq!(&parts, &whole);
            prop_assert_eq!(parts.to_json(), whole.to_json());
            prop_assert_eq!(Sum::from_json(&whole.to_json()), Some(whole.clone()));
            prop_assert_eq!(parts.value().to_bits(), whole.value().to_bits());
        }

        #[test]
        fn whole_numbers_are_added_as_whole_numbers(values in prop::collection::vec(-(1_i64 << 50)..1 << 50, 0..100)) {
            let exact: i64 = values.iter().sum();
            let floats: Vec<f64> = values.iter().map(|&value| value as f64).collect();
            prop_assert_eq!(sum(&floats).value(), exact as f64);
        }
    }
}
