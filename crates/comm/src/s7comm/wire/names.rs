//! Names of blocks: `_0A00012A` in up- and downloads, `0A00012P` in services.

use super::codes::Refusal;
use crate::s7comm::job::{BlockName, BlockPlace, BlockType};

/// The places with their letter.
const PLACES: &[(BlockPlace, u8)] = &[(BlockPlace::Active, b'A'), (BlockPlace::Passive, b'P'), (BlockPlace::Both, b'B')];

/// The name that eight characters mean: two of the type, five digits, one of the place.
///
/// # Errors
/// It is no name of a block, or the number is greater than any block has.
pub fn read(characters: &[u8]) -> Result<BlockName, Refusal> {
    let &[type_1, type_2, ref digits @ .., place] = characters else { return Err(Refusal::BlockNameSyntax) };
    let block_type = BlockType::from_characters([type_1, type_2]).ok_or(Refusal::BlockNameSyntax)?;
    let place = PLACES.iter().find(|row| row.1 == place).ok_or(Refusal::BlockNameSyntax)?.0;
    if digits.len() != 5 {
        return Err(Refusal::BlockNameSyntax);
    }
    let number = decimal(digits).ok_or(Refusal::BlockNameSyntax)?;
    Ok(BlockName { block_type, number: u16::try_from(number).map_err(|_| Refusal::BlockNumber)?, place })
}

/// The eight characters of a name.
pub fn write(name: BlockName) -> [u8; 8] {
    let [type_1, type_2] = name.block_type.characters();
    let digit = |unit: u16| b'0' + (name.number / unit % 10) as u8;
    let place = PLACES.iter().find(|row| row.0 == name.place).map_or(b'A', |row| row.1);
    [type_1, type_2, digit(10_000), digit(1_000), digit(100), digit(10), digit(1), place]
}

/// A decimal number without a sign, as the protocol writes lengths and numbers; at most nine digits.
pub fn decimal(digits: &[u8]) -> Option<u32> {
    if digits.is_empty() || digits.len() > 9 {
        return None;
    }
    digits.iter().try_fold(0_u32, |number, digit| digit.is_ascii_digit().then(|| number * 10 + u32::from(digit - b'0')))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_written_as_it_was_read() {
        for characters in [b"0A00012A", b"0800001P", b"0E16000B", b"0D00014A"] {
            assert_eq!(read(characters).map(write).as_ref(), Ok(characters));
        }
    }

    #[test]
    fn what_is_no_name_is_refused_with_a_reason() {
        let cases: [(&[u8], Refusal); 6] = [
            (b"", Refusal::BlockNameSyntax),
            (b"0A0012A", Refusal::BlockNameSyntax),
            (b"0900001A", Refusal::BlockNameSyntax),
            (b"0A0001xA", Refusal::BlockNameSyntax),
            (b"0A00001C", Refusal::BlockNameSyntax),
            (b"0A70000A", Refusal::BlockNumber),
        ];
        for (characters, refusal) in cases {
            assert_eq!(read(characters), Err(refusal));
        }
    }
}
