//! Numbers in decimal digits of four bits each, as S5TIME, counters and DATE_AND_TIME have them.

/// The eight lowest decimal digits of a number.
pub fn encode(mut number: u32) -> u32 {
    let mut word = 0;
    let mut shift = 0;
    while number > 0 && shift < 32 {
        word |= (number % 10) << shift;
        number /= 10;
        shift += 4;
    }
    word
}

/// The number that the lowest `digits` digits mean, at most eight; a digit above 9 counts as it is.
pub fn decode(word: u32, digits: u32) -> u32 {
    (0..digits).rev().fold(0, |number, digit| number * 10 + (word >> (4 * digit) & 0xF))
}

/// Whether the lowest `digits` digits, at most eight, are 0 to 9.
pub fn is_decimal(word: u32, digits: u32) -> bool {
    (0..digits).all(|digit| word >> (4 * digit) & 0xF <= 9)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn digits_above_nine_are_found_where_they_count() {
        assert_eq!([is_decimal(0x9A99, 2), is_decimal(0x9A99, 3)], [true, false]);
        assert_eq!([decode(0x1234, 3), decode(u32::MAX, 8)], [234, 166_666_665]);
    }

    proptest! {
        #[test]
        fn a_number_comes_back(number in 0..=99_999_999_u32) {
            let word = encode(number);
            prop_assert!(is_decimal(word, 8));
            prop_assert_eq!(decode(word, 8), number);
        }
    }
}
