//! The words of STL that are no instructions, by what they are: for editors that colour texts.

use super::parser::{blocks, header, operands};

/// A kind of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Begins or ends a block: `FUNCTION`, `END_FUNCTION`.
    Block,
    /// Begins or ends declarations: `VAR_INPUT`, `END_STRUCT`.
    Declaration,
    /// Divides the statements of a block: `BEGIN`, `NETWORK`, `TITLE`.
    Statements,
    /// Stands in the head of a block, with or without a value: `AUTHOR`, `READ_ONLY`.
    Head,
    /// A part of the status word or a register as an operand: `OV`, `STW`.
    Status,
}

/// All words of a kind, in capital letters.
pub fn of(kind: Kind) -> Vec<&'static str> {
    match kind {
        Kind::Block => blocks::BLOCKS.iter().flat_map(|&(begin, end, _)| [begin, end]).collect(),
        Kind::Declaration => {
            let others = blocks::OTHERS.iter().filter(|(word, _)| !STATEMENTS.contains(word)).map(|&(word, _)| word);
            blocks::SECTIONS.iter().map(|&(word, _)| word).chain(others).collect()
        }
        Kind::Statements => STATEMENTS.to_vec(),
        Kind::Head => header::HEADER_FLAGS.iter().chain(&header::HEADER_FIELDS).copied().collect(),
        Kind::Status => operands::STATUS_WORDS.to_vec(),
    }
}

/// Words between the statements of a block.
const STATEMENTS: [&str; 3] = ["BEGIN", "NETWORK", "TITLE"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_keyword_has_a_kind() {
        let kinds = [Kind::Block, Kind::Declaration, Kind::Statements];
        let all: Vec<&str> = kinds.into_iter().flat_map(of).collect();
        assert!(all.iter().all(|word| blocks::is_keyword(word)), "{all:?}");
        assert_eq!(all.len(), 2 * blocks::BLOCKS.len() + blocks::SECTIONS.len() + blocks::OTHERS.len());
    }
}
