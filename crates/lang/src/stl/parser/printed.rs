//! What a printed listing has and a source has not: fences, ellipses, headings of blocks and networks, names with spaces.

use std::collections::HashMap;

use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::blocks::{BLOCKS, Keyword, new_block};
use super::statements::LABEL_MAX;
use super::{DIAGNOSTICS_MAX, Parser};
use crate::stl::ast::{Block, BlockName, Operand, Word};
use crate::stl::lexer::{Raw, token, trim_blanks};
use crate::stl::syntax::SyntaxKind;

/// What a network is called in the languages of printed programs, in lower case.
const NETWORK_WORDS: [&str; 37] = [
    "network",
    "netzwerk",
    "nw",
    "сеть",
    "мрежа",
    "мережа",
    "цепь",
    "omrežje",
    "omrezje",
    "mreža",
    "mreza",
    "réseau",
    "reseau",
    "segment",
    "segmento",
    "red",
    "rede",
    "rete",
    "netwerk",
    "nätverk",
    "nettverk",
    "netværk",
    "verkko",
    "võrk",
    "tinklas",
    "tīkls",
    "síť",
    "sít",
    "sieť",
    "sieć",
    "siec",
    "hálózat",
    "halozat",
    "rețea",
    "retea",
    "ağ",
    "δίκτυο",
];

/// A block that began with a heading and has no end of its own.
#[derive(Clone, Copy)]
pub(super) struct Headed {
    /// The keyword that its end needs.
    end: &'static str,
    /// The heading.
    start: usize,
    /// Behind its last statement.
    last: usize,
}

/// The heading of a block: `OB 1:`, `FC30: Example`.
struct Heading {
    /// Its row in the table of blocks.
    index: usize,
    number: u64,
    /// Behind kind and number.
    name_end: usize,
    /// Behind the line.
    end: usize,
    title: String,
}

impl Parser<'_> {
    /// A mark of the printed page between statements; it is taken.
    pub(super) fn printed_mark(&mut self, block: &mut Block) -> bool {
        if self.printed_line() {
            return true;
        }
        let (start, word) = (self.position, self.current());
        // Nearly every statement is sent away here: its instruction word is short, and no number stands directly behind it.
        let numbered = self.text[self.end..].trim_start_matches([' ', '\t']).starts_with(|next: char| next.is_ascii_digit());
        if self.raw != Raw::Word || word.len() < 2 || !(numbered || word.len() > LABEL_MAX) || self.keyword().is_some() {
            return false;
        }
        if !NETWORK_WORDS.contains(&word.to_lowercase().as_str()) {
            return false;
        }
        if !numbered && (self.raw_behind_blanks() != Raw::Colon || word.chars().count() <= LABEL_MAX || self.is_long_label(word)) {
            return false;
        }
        self.network(block);
        self.numbered_network(start, block);
        true
    }

    /// Whether the word before a colon is a label: a jump names it, or a statement follows on its line.
    fn is_long_label(&mut self, word: &str) -> bool {
        let colon = self.behind_blanks(self.end);
        let at = self.behind_blanks(colon + 1);
        self.is_jumped_to(word) || self.statement_at(at).is_some()
    }

    /// A fence or an ellipsis on a line of its own; it is taken.
    pub(super) fn printed_line(&mut self) -> bool {
        let (start, rest) = (self.position, &self.text[self.position..]);
        if !rest.starts_with("```") && !rest.starts_with("~~~") {
            return self.ellipsis();
        }
        let end = self.line_end(start);
        let span = self.span(start, end);
        let message = format!("`{}` is a fence around a listing, not a part of it", self.slice(start, end));
        self.report(Diagnostic::new(Problem::P2043, span, message).fix(span, "", "remove it"));
        self.bump_to(SyntaxKind::Unexpected, end);
        true
    }

    /// `...`, `:` or `…` where a statement should stand; it is taken.
    pub(super) fn ellipsis(&mut self) -> bool {
        if !matches!(self.raw, Raw::Colon | Raw::Point | Raw::Range | Raw::Unknown) {
            return false;
        }
        let start = self.position;
        let end = self.line_end(start);
        if end == start
            || !self.slice(start, end).chars().all(|c| matches!(c, '.' | ':' | '…' | '⋮' | '⁞' | '·' | '•' | ' ' | '\t' | '\u{a0}'))
        {
            return false;
        }
        let span = self.span(start, end);
        let message = format!("`{}` is an ellipsis: the page leaves out statements here", self.slice(start, end));
        let diagnostic = Diagnostic::new(Problem::P2043, span, message).help("write the statements, or `NOP 0` where nothing is missing");
        self.report(diagnostic.guess(span, "NOP   0", "write `NOP 0`"));
        self.bump_to(SyntaxKind::Unexpected, end);
        true
    }

    /// The end of the line without a comment, a `;` and blanks before them.
    fn line_end(&self, start: usize) -> usize {
        let rest = &self.text[start..];
        let line = &rest[..rest.find(['\r', '\n', ';']).unwrap_or(rest.len())];
        let line = &line[..line.find("//").unwrap_or(line.len())];
        start + trim_blanks(line).len()
    }

    /// `NETWORK 1`, `Network 1: Opens a valve`: what stands behind the keyword, if it is a number or a colon.
    pub(super) fn numbered_network(&mut self, start: usize, block: &mut Block) {
        let at = self.behind_blanks(self.position);
        let (raw, _) = token(self.text, at);
        if !matches!(raw, Raw::Number | Raw::Colon) {
            return;
        }
        let end = self.line_end(at);
        let rest = self.slice(at, end);
        let title = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        let title = title.trim_start_matches(|c: char| c.is_whitespace() || matches!(c, ':' | '.' | '-' | '–' | '—')).trim();
        let right = match title {
            "" => "NETWORK".to_owned(),
            title => format!("NETWORK{}TITLE = {title}", self.line_break()),
        };
        let span = self.span(start, end);
        let message = format!("`{}` is the heading of a printed network", self.slice(start, end));
        let help = "a source numbers its networks by itself: `NETWORK`, and what is called `TITLE =` on the next line";
        self.report(Diagnostic::new(Problem::P2045, span, message).help(help).fix(span, right, "write `NETWORK`"));
        if let Some(network) = block.networks.last_mut() {
            network.title = title.to_owned();
        }
        self.blanks();
        self.bump_to(SyntaxKind::Unexpected, end);
    }

    /// How the first line of this source ends.
    pub(super) fn line_break(&self) -> &'static str {
        match self.text.find('\n') {
            Some(at) if self.text[..at].ends_with('\r') => "\r\n",
            _ => "\n",
        }
    }

    /// Whether the heading of a block stands at the current token.
    pub(super) fn at_heading(&mut self) -> bool {
        self.heading().is_some()
    }

    fn heading(&mut self) -> Option<Heading> {
        if self.raw != Raw::Word {
            return None;
        }
        let (start, word) = (self.position, self.current());
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let kind = BlockKind::from_abbreviation(letters)?;
        let index = BLOCKS.iter().position(|&(.., known)| known == kind)?;
        let (digits, name_end) = match &word[letters.len()..] {
            "" => {
                let at = self.behind_blanks(self.end);
                let (raw, end) = token(self.text, at);
                if raw != Raw::Number {
                    return None;
                }
                (&self.text[at..end], end)
            }
            digits => (digits, self.end),
        };
        let number = digits.parse().ok()?;
        let colon = self.behind_blanks(name_end);
        if token(self.text, colon).0 != Raw::Colon {
            return None;
        }
        let end = self.line_end(start);
        let title = self.slice(colon + 1, end.max(colon + 1)).trim().to_owned();
        // `FC1:` may be a label: then a jump names it, or a statement follows.
        let label = name_end == self.end && {
            let behind = self.behind_blanks(colon + 1);
            match title.is_empty() {
                true => self.is_jumped_to(word),
                false => self.try_at(behind, |parser| parser.mnemonic()).0.is_some(),
            }
        };
        (!label).then_some(Heading { index, number, name_end, end, title })
    }

    /// The block that a heading begins.
    pub(super) fn headed_block(&mut self) -> Option<Block> {
        let heading = self.heading()?;
        let (keyword, end_keyword, kind) = BLOCKS[heading.index];
        let (start, end) = (self.position, heading.end);
        let name_span = self.span(start, heading.name_end);
        let span = self.span(start, end);
        let written = self.slice(start, end);
        let message = format!("`{written}` is the heading of a printed block");
        let abbreviation = kind.abbreviation();
        let head = match kind {
            BlockKind::Function => format!("{keyword} {abbreviation} {} : VOID", heading.number),
            _ => format!("{keyword} {abbreviation} {}", heading.number),
        };
        let help = format!("in a source a block stands between `{head}` and `{end_keyword}`");
        let mut diagnostic = Diagnostic::new(Problem::P2045, span, message).help(help);
        let code = !matches!(kind, BlockKind::DataBlock | BlockKind::UserDefinedType);
        let line = self.line_break();
        let before = self.headed.take().map(|headed| format!("{}{line}{line}", headed.end)).unwrap_or_default();
        if code {
            let title = if heading.title.is_empty() { String::new() } else { format!("{line}TITLE = {}", heading.title) };
            diagnostic = diagnostic.fix(span, format!("{before}{head}{title}"), format!("write `{head}`"));
        }
        self.report(diagnostic);
        self.block_start = start;
        self.declared.clear();
        self.comments.clear();
        self.start(SyntaxKind::Block);
        self.bump_to(SyntaxKind::Unexpected, end);
        let name = BlockName::Absolute { kind, number: heading.number, span: name_span };
        let mut block = new_block(kind, name, false, span);
        self.header(&mut block, !code);
        if self.keyword() == Some(Keyword::Begin) {
            self.bump(SyntaxKind::Keyword);
        }
        match code {
            true => self.code(&mut block),
            false => self.assignments(&mut block),
        }
        let last = trim_blanks(self.text[..self.position].trim_end()).len();
        self.trivia();
        if self.keyword() == Some(Keyword::BlockEnd(heading.index)) {
            self.bump(SyntaxKind::Keyword);
        } else if code {
            self.headed = Some(Headed { end: end_keyword, start, last });
        }
        block.span = self.span(start, self.position);
        self.finish();
        self.check_labels(&mut block);
        Some(block)
    }

    /// Reports the end that the last block with a heading needs, where no other heading follows.
    pub(super) fn end_headed(&mut self) {
        let Some(Headed { end, start, last }) = self.headed.take() else { return };
        let heading = self.span(start, self.line_end(start));
        let at = self.span(last, last);
        let message = format!("the block with this heading has no `{end}`");
        let line = self.line_break();
        self.report(Diagnostic::new(Problem::P2011, heading, message).fix(at, format!("{line}{end}"), format!("write `{end}`")));
    }

    /// Where the words and numbers end that begin before a byte and have only blanks between them.
    pub(super) fn spaced_words_end(&self, mut end: usize) -> usize {
        loop {
            match token(self.text, end) {
                (Raw::Blank, behind) => match token(self.text, behind) {
                    (Raw::Word, word_end) => end = word_end,
                    (Raw::Number, word_end) if self.text[behind..word_end].bytes().all(|byte| byte.is_ascii_digit()) => end = word_end,
                    _ => return end,
                },
                _ => return end,
            }
        }
    }

    /// The name of a parameter; one with spaces is reported.
    pub(super) fn argument_name(&mut self) -> Word {
        let start = self.position;
        let end = if self.raw == Raw::Word { self.spaced_words_end(self.end) } else { self.end };
        if end == self.end {
            return self.name_word(SyntaxKind::Name);
        }
        let right = joined(self.slice(start, end));
        let span = self.span(start, end);
        let message = format!("`{}` has spaces, and the name of a parameter has none", self.slice(start, end));
        let diagnostic = Diagnostic::new(Problem::P2046, span, message);
        let title = format!("write `{right}`");
        self.report(match self.mentions(&right) {
            true => diagnostic.fix(span, right.clone(), title),
            false => diagnostic.guess(span, right.clone(), title),
        });
        self.bump_to(SyntaxKind::Name, end);
        Word { text: right, span }
    }

    /// `L Recipe no`: an operand that goes on with words is a symbol that lacks its quotes.
    pub(super) fn spaced_name(&mut self, operand: Operand) -> Operand {
        let Operand::Name { word, path } = &operand else { return operand };
        let start = word.span.start as usize;
        let end = self.spaced_words_end(self.position);
        let words = self.text[self.position..end].trim();
        let over = matches!(
            token(self.text, self.behind_blanks(end)).0,
            Raw::Semicolon | Raw::Newline | Raw::LineComment | Raw::End | Raw::ParenClose
        );
        // `XW 5` is rather an address with wrong letters.
        let address = word.text.len() <= 3 && words.bytes().all(|byte| byte.is_ascii_digit());
        let mnemonic = self.instruction_at(start);
        if !path.is_empty() || words.is_empty() || !over || address || mnemonic || self.statement_begins() {
            return operand;
        }
        let name = self.slice(start, end).to_owned();
        let span = self.span(start, end);
        let under = joined(&name);
        let diagnostic = Diagnostic::new(Problem::P2046, span, format!("`{name}` has spaces: a symbol with spaces stands in quotes"));
        let quoted = format!("\"{name}\"");
        let local = self.declared.contains(&under.to_ascii_uppercase());
        let diagnostic = match (self.mentions(&quoted), local || self.mentions(&under)) {
            (true, false) => diagnostic.fix(span, quoted.clone(), format!("write `{quoted}`")),
            (false, true) => {
                let right = if local { format!("#{under}") } else { under };
                diagnostic.fix(span, right.clone(), format!("write `{right}`"))
            }
            _ => diagnostic.help(format!("write `{quoted}` if the symbol is called so, or `{under}`")).guess(
                span,
                quoted.clone(),
                format!("write `{quoted}`"),
            ),
        };
        self.report(diagnostic);
        self.bump_to(SyntaxKind::Symbol, end);
        Operand::Error
    }

    /// Whether a statement begins at the next word. Nothing is taken.
    fn statement_begins(&mut self) -> bool {
        let at = self.behind_blanks(self.position);
        self.statement_at(at).is_some()
    }

    /// Whether a name stands somewhere in the source outside of comments, without regard to case.
    pub(super) fn mentions(&self, name: &str) -> bool {
        self.times_mentioned(name) > 0
    }

    /// How often a name stands in the source outside of comments, without regard to case.
    pub(super) fn times_mentioned(&self, name: &str) -> usize {
        if self.diagnostics.len() >= DIAGNOSTICS_MAX {
            return 0;
        }
        let names = self.names.get_or_init(|| {
            let mut names = HashMap::new();
            let mut at = 0;
            loop {
                let (raw, end) = token(self.text, at);
                match raw {
                    Raw::End => return names,
                    Raw::Word | Raw::Local | Raw::Symbol => {
                        let name = self.text[at..end].trim_matches(['"', '#']).to_ascii_uppercase();
                        *names.entry(name).or_insert(0) += 1;
                    }
                    _ => {}
                }
                at = end;
            }
        });
        names.get(&name.to_ascii_uppercase()).copied().unwrap_or(0)
    }
}

/// A name with underscores for its spaces.
fn joined(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}
