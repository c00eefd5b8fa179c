//! The program as a listing, and what is shown of its statements.

use sieben_engine::Program;
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// A line of the listing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Line {
    /// The title of a network.
    Network(String),
    /// A statement of OB 1.
    Statement {
        /// Its index in the block.
        index: u32,
        /// `FP`.
        mnemonic: String,
        /// `M 0.0`.
        operand: String,
        /// `EDGE`.
        symbol: String,
    },
}

/// What a statement left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Seen {
    /// The bit that was scanned or written.
    pub(crate) sta: bool,
    /// The result of the logic operation after it.
    pub(crate) rlo: bool,
    /// Accumulator 1 after it.
    pub(crate) accu1: u32,
}

/// The statements of OB 1 with the titles of their networks.
pub(crate) fn lines(sources: &Sources, program: &Program, symbols: &SymbolTable) -> Vec<Line> {
    let Some(block) = program.code.get(&BlockId::ob(1)) else { return Vec::new() };
    let mut lines = Vec::new();
    let mut behind = 0;
    for (index, &span) in block.spans.iter().enumerate() {
        let statement = sources.slice(span).trim().trim_end_matches(';');
        let (mnemonic, operand) = statement.split_once(char::is_whitespace).unwrap_or((statement, ""));
        // The implied end of the block has the place of the last statement.
        if mnemonic.is_empty() || (span.start as usize) < behind {
            continue;
        }
        // What stands between two statements may begin a network.
        let text = &sources.file(span.file).text;
        let between = text.get(behind..span.start as usize).unwrap_or_default();
        if let Some((_, after)) = between.rsplit_once("NETWORK") {
            let title = after.split_once("TITLE =").map_or("", |(_, title)| title.lines().next().unwrap_or_default());
            lines.push(Line::Network(title.trim().to_owned()));
        }
        behind = span.end as usize;
        let operand = operand.trim();
        let symbol = Operand::parse(operand).and_then(|operand| symbols.find_operand(&operand));
        lines.push(Line::Statement {
            index: index as u32,
            mnemonic: mnemonic.to_owned(),
            operand: Operand::parse(operand).map_or_else(|| operand.to_owned(), |operand| operand.spell(Mnemonics::English)),
            symbol: symbol.map_or_else(String::new, |symbol| symbol.name.clone()),
        });
    }
    lines
}
