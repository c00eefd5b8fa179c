//! Operands of statements: addresses, symbols, local names, pointers, constants.

use std::borrow::Cow;

use sieben_model::address::{Width, area_and_width};
use sieben_model::block::BlockKind;
use sieben_model::problems::Problem;

use super::{OTHER_ALPHABET, Parser, latin};
use crate::stl::ast::{BlockName, Constant, Operand, Word};
use crate::stl::lexer::{Raw, in_word, token};
use crate::stl::mnemonics::{translate_letters, translate_status};
use crate::stl::syntax::SyntaxKind;

/// Words of the status word and the registers, in both languages.
pub(in crate::stl) const STATUS_WORDS: [&str; 12] = ["STW", "BR", "BIE", "OV", "OS", "UO", "DBLG", "DBNO", "DILG", "DINO", "AR1", "AR2"];

/// What the letters of an address want behind them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Letters {
    /// `I`, `M`, `DBX`: byte and bit.
    Bit,
    /// `MW`, `DBB`: a byte number.
    Wide,
    /// `T`, `C`, `FC`: a number.
    Number,
    /// `DB`, `DI`: a number and perhaps an address in the block.
    Data,
}

fn letters_of(word: &str) -> Option<Letters> {
    if word.is_empty() || word.len() > 3 || !word.is_ascii() {
        return None;
    }
    if ["DB", "DI"].into_iter().any(|letters| word.eq_ignore_ascii_case(letters)) {
        return Some(Letters::Data);
    }
    let number = |letters: &&str| word.eq_ignore_ascii_case(letters);
    if ["T", "C", "Z", "FC", "FB", "SFC", "SFB", "SDB", "OB", "UDT"].iter().any(number) {
        return Some(Letters::Number);
    }
    area_and_width(word).map(|(_, width)| if width == Width::Bit { Letters::Bit } else { Letters::Wide })
}

/// `10`, `10.5`, with the letter O read as zero.
struct AddressNumber {
    number: u64,
    bit: Option<u64>,
    end: usize,
    slip: bool,
}

impl Parser<'_> {
    /// The operand at the current token, or an error; takes at least one token unless the statement ends here.
    pub(super) fn operand(&mut self, wants_label: bool) -> Operand {
        // TIA writes a `%` before absolute addresses.
        if self.current() == "%" && token(self.text, self.end).0 == Raw::Word {
            self.bump_to(SyntaxKind::AddressLetters, self.end);
        }
        match self.raw {
            Raw::Literal if self.at_pointer_to_variable() => {
                self.bump_to(SyntaxKind::AddressOf, self.position + "P#".len());
                self.blanks();
                let start = self.position;
                let target = Box::new(self.operand(false));
                Operand::PointerTo { target, span: self.span(start, self.position) }
            }
            Raw::Local => {
                let name = self.name_word(SyntaxKind::Local);
                let name = self.declared_look_alike(name, "#");
                let mut path = Vec::new();
                self.path(&mut path);
                Operand::Local { name, path }
            }
            Raw::Symbol => self.symbol(),
            Raw::AddressOf => {
                let text = self.current().split_once("##").map_or("", |(_, name)| name);
                let text = super::unquoted(text).to_owned();
                let (start, end) = self.bump(SyntaxKind::AddressOf);
                if let Some(letters) = self.slice(start, end).split_once('#').and_then(|(letters, _)| latin(letters)) {
                    self.slip(Problem::P1005, start, end, &format!("{letters}##{text}"), OTHER_ALPHABET);
                }
                if text.is_empty() {
                    self.error(Problem::P2005, start, end, "`P##` wants the name of a local variable behind it");
                    return Operand::Error;
                }
                Operand::AddressOf(Word { text, span: self.span(start, end) })
            }
            Raw::BracketOpen => self.indirect(String::new()),
            Raw::Word if wants_label => {
                let word = self.name_word(SyntaxKind::Name);
                Operand::Name { word, path: Vec::new() }
            }
            Raw::Word if !self.at_constant() => self.word_operand(),
            Raw::Sign if !self.at_constant() => self.status_scan(),
            _ if self.at_constant() => Operand::Constant(self.constant()),
            Raw::Semicolon | Raw::Newline | Raw::LineComment | Raw::End => {
                let message = format!("{} where an operand stands", self.shown());
                self.error(Problem::P2005, self.position, self.end, message);
                Operand::Error
            }
            Raw::Unknown if self.typeset_sign().is_some() => self.status_scan(),
            Raw::Unknown => {
                let message = format!("{} is no character of STL", self.shown());
                self.error(Problem::P1001, self.position, self.end, message);
                self.skip_operand()
            }
            _ => {
                let message = format!("{} begins no operand; an address, a name or a constant stands here", self.shown());
                self.error(Problem::P2005, self.position, self.end, message);
                self.skip_operand()
            }
        }
    }

    /// `P#DB3.name` or `P#"Sym"`, but not `P#DB3.DBX 1.0`.
    fn at_pointer_to_variable(&self) -> bool {
        if !self.text[self.position..].get(..2).is_some_and(|start| start.eq_ignore_ascii_case("P#")) {
            return false;
        }
        let at = self.behind_blanks(self.position + 2);
        let rest = &self.text[at..];
        if rest.starts_with('"') {
            return true;
        }
        let Some((block, name)) = rest.split_once('.') else { return false };
        let number = block.get(..2).filter(|letters| letters.eq_ignore_ascii_case("DB")).map(|_| block[2..].trim());
        let is_number = number.is_some_and(|number| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()));
        let word = &name[..name.find(|c| !in_word(c)).unwrap_or(name.len())];
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let absolute = area_and_width(letters).is_some() && letters.len() == "DBX".len();
        is_number && !absolute && word.starts_with(|c: char| c == '_' || c.is_alphabetic())
    }

    /// To the end of the statement or the next parameter.
    pub(super) fn skip_operand(&mut self) -> Operand {
        while !self.at_statement_end() && !matches!(self.raw, Raw::Comma | Raw::ParenClose | Raw::BracketClose) {
            self.bump_unexpected();
        }
        Operand::Error
    }

    /// `==0`, `<>0`, `>=0` …
    fn status_scan(&mut self) -> Operand {
        let start = self.position;
        let rest = &self.text[start..];
        let typeset = self.typeset_sign();
        let run = match typeset {
            Some(_) => self.end - start,
            None => rest.bytes().take_while(|byte| b"=<>".contains(byte)).count(),
        };
        let at = self.behind_blanks(start + run);
        let (raw, end) = token(self.text, at);
        let zero = match raw {
            Raw::Number => &self.text[at..end] == "0",
            Raw::Word => self.text[at..end].eq_ignore_ascii_case("O"),
            _ => false,
        };
        let right = match typeset.unwrap_or(&rest[..run]) {
            "==" | "=" => "==0",
            "<>" => "<>0",
            ">" => ">0",
            "<" => "<0",
            ">=" | "=>" => ">=0",
            "<=" | "=<" => "<=0",
            _ => "",
        };
        if !zero || right.is_empty() {
            let message = format!("{} begins no operand; the status word is scanned with ==0, <>0, >0, <0, >=0 and <=0", self.shown());
            self.error(Problem::P2005, start, self.end, message);
            self.bump_unexpected();
            return self.skip_operand();
        }
        if typeset.is_some() {
            self.slip(Problem::P1005, start, end, right, "has a sign of typesetting");
        } else if raw == Raw::Word {
            self.slip(Problem::P1005, start, end, right, "has the letter O for the digit zero");
        } else if &rest[..run] == "=" {
            self.slip(Problem::P2008, start, end, right, "scans nothing: whether a result is 0 is written with two signs");
        } else if matches!(&rest[..run], "=>" | "=<") {
            self.slip(Problem::P2008, start, end, right, "has its signs in the wrong order");
        }
        if at > start + run {
            self.bump_to(SyntaxKind::StatusWord, start + run);
            self.blanks();
        }
        self.bump_to(SyntaxKind::StatusWord, end);
        Operand::Name { word: Word { text: right.to_owned(), span: self.span(start, end) }, path: Vec::new() }
    }

    fn symbol(&mut self) -> Operand {
        let name = self.name_word(SyntaxKind::Symbol);
        if let Some(operand) = self.in_block(&BlockName::Symbol(name.clone()), false) {
            return operand;
        }
        let mut path = Vec::new();
        self.path(&mut path);
        Operand::Symbol { name, path }
    }

    /// `.DBW 2` behind a data block.
    fn in_block(&mut self, block: &BlockName, instance: bool) -> Option<Operand> {
        if self.raw != Raw::Point {
            return None;
        }
        let (raw, end) = token(self.text, self.end);
        if raw != Raw::Word {
            return None;
        }
        let start = self.end;
        let word = self.slice(start, end);
        let letters = word.get(..3).filter(|letters| {
            let letters = letters.to_ascii_uppercase();
            matches!(letters.as_str(), "DBX" | "DBB" | "DBW" | "DBD" | "DIX" | "DIB" | "DIW" | "DID")
        })?;
        let at = if word.len() > 3 { start + 3 } else { self.behind_blanks(end) };
        let number = self.address_number(at, true)?;
        self.bump(SyntaxKind::Punctuation);
        self.bump_to(SyntaxKind::AddressLetters, start + 3);
        self.blanks();
        self.take_number(&number);
        Some(Operand::InBlock {
            block: block.clone(),
            instance,
            letters: letters.to_ascii_uppercase(),
            number: number.number,
            bit: number.bit,
        })
    }

    /// The number of an address at a byte; `None` if something else stands there.
    fn address_number(&self, at: usize, point: bool) -> Option<AddressNumber> {
        let digits = |at: usize| {
            let rest = &self.text[at..];
            at + rest.find(|c: char| !(c.is_ascii_digit() || matches!(c, 'O' | 'o'))).unwrap_or(rest.len())
        };
        let value = |start: usize, end: usize| {
            let text = &self.text[start..end];
            let clean: Cow<'_, str> = if text.contains(['O', 'o']) { text.replace(['O', 'o'], "0").into() } else { text.into() };
            clean.parse::<u64>().unwrap_or(u64::MAX)
        };
        let mut end = digits(at);
        if end == at {
            return None;
        }
        let number = value(at, end);
        let mut bit = None;
        if point && self.text[end..].starts_with('.') {
            let bit_end = digits(end + 1);
            if bit_end > end + 1 {
                bit = Some(value(end + 1, bit_end));
                end = bit_end;
            }
        }
        let slip = self.text[at..end].contains(['O', 'o']);
        // `I 4.0A "Start"`: the line lost its end.
        let parted = bit.is_some() || self.text[..at].ends_with([' ', '\t']);
        let complete = !self.text[end..].starts_with(in_word) || (parted && self.instruction_at(end));
        // Letters alone are a name, not a number.
        let has_digit = self.text[at..end].bytes().any(|byte| byte.is_ascii_digit()) || bit.is_some();
        (complete && (has_digit || !slip)).then_some(AddressNumber { number, bit, end, slip })
    }

    /// Puts the number of an address into the tree, and says so if it has a letter O.
    fn take_number(&mut self, number: &AddressNumber) {
        let start = self.position;
        if number.slip {
            let right = self.slice(start, number.end).replace(['O', 'o'], "0");
            self.slip(Problem::P1005, start, number.end, &right, "has the letter O for the digit zero");
        }
        self.bump_to(SyntaxKind::Number, number.end);
    }

    fn word_operand(&mut self) -> Operand {
        let word = self.current();
        if !self.declared.contains(&word.to_ascii_uppercase())
            && let Some(operand) = self.extension_operand()
        {
            return operand;
        }
        let next = token(self.text, self.end).0;
        let plain = !matches!(next, Raw::Point | Raw::BracketOpen);
        if plain && let Some(operand) = self.status_word() {
            return operand;
        }
        let behind = self.raw_behind_blanks();
        // `t : TIMER` may be declared beside `A T 5`, `A T [MW 2]` and `L T [AR1,P#0.0]`; `t[1]` is no address anyway.
        let declared = !matches!(behind, Raw::Number | Raw::BracketOpen)
            && !self.declared.is_empty()
            && self.declared.contains(&word.to_ascii_uppercase());
        if !declared && let Some(operand) = self.address() {
            return operand;
        }
        if plain
            && !declared
            && let Some(operand) = self.step5_operand()
        {
            return operand;
        }
        let word = self.name_word(SyntaxKind::Name);
        let word = self.declared_look_alike(word, "");
        let mut path = Vec::new();
        self.path(&mut path);
        Operand::Name { word, path }
    }

    /// A name that is not declared, where one is that looks the same in Latin letters: that one is meant.
    fn declared_look_alike(&mut self, name: Word, prefix: &str) -> Word {
        let declared = |name: &str| self.declared.contains(&name.to_uppercase()) || self.declared.contains(&name.to_ascii_uppercase());
        let Some(right) = latin(&name.text).filter(|right| declared(right) && !declared(&name.text)) else { return name };
        let (start, end) = (name.span.start as usize, name.span.end as usize);
        self.slip(Problem::P1005, start, end, &format!("{prefix}{right}"), OTHER_ALPHABET);
        Word { text: right, span: name.span }
    }

    fn status_word(&mut self) -> Option<Operand> {
        let word = self.current();
        if !(2..=4).contains(&word.len()) {
            return None;
        }
        let (start, end) = (self.position, self.end);
        let mut text = word.to_owned();
        if STATUS_WORDS.iter().any(|status| word.eq_ignore_ascii_case(status)) {
            if let Some(right) = translate_status(word, self.mnemonics.other()) {
                self.foreign(start, end, right);
                text = right.to_owned();
            }
        } else if word.eq_ignore_ascii_case("AO") {
            self.slip(Problem::P2008, start, end, "UO", "is a misprint of the course texts");
            text = "UO".to_owned();
        } else {
            return None;
        }
        self.bump(SyntaxKind::StatusWord);
        Some(Operand::Name { word: Word { text, span: self.span(start, end) }, path: Vec::new() })
    }

    /// An absolute address, memory- or register-indirect too; nothing is taken if it is none.
    pub(super) fn address(&mut self) -> Option<Operand> {
        let (start, end) = (self.position, self.end);
        let written = self.current();
        let word: Cow<'_, str> = match latin(written) {
            Some(latin) => latin.into(),
            None if written.is_ascii() => written.into(),
            None => return None,
        };
        let letters_length = word.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(word.len());
        let (mut letters, mut rest) = word.split_at(letters_length);
        let mut kind = letters_of(letters);
        if kind.is_none() && letters.contains(['O', 'o']) {
            // `IO.0`, `MWO`: the letters end before the letter O that should be a zero.
            let head = letters.trim_end_matches(['O', 'o']);
            kind = letters_of(head).filter(|kind| match kind {
                Letters::Bit => token(self.text, end).0 == Raw::Point,
                Letters::Wide => true,
                Letters::Number | Letters::Data => !rest.is_empty(),
            });
            (letters, rest) = word.split_at(head.len());
        }
        if matches!(word.as_ref(), "B" | "W" | "D" | "b" | "w" | "d") {
            // `W [AR1,P#2.0]`: the area is in the register.
            let (raw, bracket_end) = token(self.text, self.behind_blanks(end));
            let inside = self.behind_blanks(bracket_end);
            let register =
                raw == Raw::BracketOpen && self.text.get(inside..inside + 2).is_some_and(|letters| letters.eq_ignore_ascii_case("AR"));
            if register {
                let letters = word.to_ascii_uppercase();
                self.bump(SyntaxKind::AddressLetters);
                self.blanks();
                return Some(self.indirect(letters));
            }
        }
        if rest.is_empty()
            && let Some(operand) = self.parted_letters(letters)
        {
            return Some(operand);
        }
        let kind = kind?;
        // Byte where the letters end in the source; look-alikes are longer there.
        let letters_end = start + written.char_indices().nth(letters.len()).map_or(written.len(), |(at, _)| at);
        let letters = letters.to_ascii_uppercase();
        let at = if rest.is_empty() { self.behind_blanks(end) } else { letters_end };
        if rest.is_empty()
            && let (Raw::BracketOpen, bracket_end) = token(self.text, at)
        {
            // `MW [MD 4]` has a pointer in the brackets, `mw[4]` an index.
            let inside = token(self.text, self.behind_blanks(bracket_end)).0;
            if matches!(inside, Raw::Number | Raw::Sign) {
                return None;
            }
            let letters = self.take_letters(letters, letters_end);
            self.blanks();
            return Some(self.indirect(letters));
        }
        if rest.is_empty()
            && let Some((number, number_end)) = self.negative_number(&letters, at)
        {
            let letters = self.take_letters(letters, letters_end);
            self.blanks();
            self.bump_to(SyntaxKind::Number, number_end);
            return Some(Operand::Absolute { letters, number, bit: None });
        }
        let number = match self.address_number(at, kind != Letters::Data) {
            Some(number) => number,
            // `MWO`: only letters.
            None if kind == Letters::Wide && !rest.is_empty() && rest.bytes().all(|byte| matches!(byte, b'O' | b'o')) => {
                AddressNumber { number: 0, bit: None, end, slip: true }
            }
            None => return None,
        };
        if kind == Letters::Bit && number.bit.is_none() && !rest.is_empty() {
            // `M001` without a point is a name.
            return None;
        }
        let letters = self.take_letters(letters, letters_end);
        self.blanks();
        self.take_number(&number);
        if kind != Letters::Data || self.raw != Raw::Point {
            return Some(Operand::Absolute { letters, number: number.number, bit: number.bit });
        }
        let instance = letters == "DI";
        let block = BlockName::Absolute { kind: BlockKind::DataBlock, number: number.number, span: self.span(start, number.end) };
        if let Some(operand) = self.in_block(&block, instance) {
            return Some(operand);
        }
        let mut path = Vec::new();
        self.path(&mut path);
        Some(Operand::BlockField { block, path })
    }

    /// `I W [MD 4]`, `M W10`: area and width with a space between them.
    fn parted_letters(&mut self, letters: &str) -> Option<Operand> {
        let start = self.position;
        let at = self.behind_blanks(self.end);
        let (raw, word_end) = token(self.text, at);
        let word = &self.text[at..word_end];
        let width = word.get(..1).filter(|width| raw == Raw::Word && matches!(*width, "X" | "B" | "W" | "D" | "x" | "b" | "w" | "d"))?;
        let letters = format!("{letters}{width}").to_ascii_uppercase();
        if at == self.end || letters.len() < 2 || !matches!(letters_of(&letters)?, Letters::Bit | Letters::Wide) {
            return None;
        }
        let letters_end = at + 1;
        let behind = if word_end == letters_end { self.behind_blanks(word_end) } else { letters_end };
        let indirect = word_end == letters_end && token(self.text, behind).0 == Raw::BracketOpen;
        let number = self.address_number(behind, true);
        if !indirect && number.is_none() {
            return None;
        }
        let letters = translate_letters(&letters, self.mnemonics.other()).map_or(letters, str::to_owned);
        self.slip(Problem::P2008, start, letters_end, &letters, "has a space between area and width");
        self.bump(SyntaxKind::AddressLetters);
        self.blanks();
        self.bump_to(SyntaxKind::AddressLetters, letters_end);
        self.blanks();
        match number {
            Some(number) if !indirect => {
                self.take_number(&number);
                Some(Operand::Absolute { letters, number: number.number, bit: number.bit })
            }
            _ => Some(self.indirect(letters)),
        }
    }

    /// Puts the letters of an address into the tree; the letters in the language of the file.
    fn take_letters(&mut self, letters: String, end: usize) -> String {
        let start = self.position;
        if !self.slice(start, end).is_ascii() {
            self.slip(Problem::P1005, start, end, &letters, OTHER_ALPHABET);
        }
        self.bump_to(SyntaxKind::AddressLetters, end);
        match translate_letters(&letters, self.mnemonics.other()) {
            Some(right) => {
                self.foreign(start, end, right);
                right.to_owned()
            }
            None => letters,
        }
    }

    /// `[MD 4]` or `[AR1,P#2.0]` behind letters.
    fn indirect(&mut self, letters: String) -> Operand {
        if !self.deeper() {
            self.bump_unexpected();
            return self.skip_operand();
        }
        self.bump(SyntaxKind::Punctuation);
        self.blanks();
        let operand = if self.at_word("AR1") || self.at_word("AR2") {
            let mut register = self.name_word(SyntaxKind::Name);
            register.text.make_ascii_uppercase();
            self.blanks();
            if self.raw == Raw::Comma {
                self.bump(SyntaxKind::Punctuation);
                self.blanks();
            }
            if self.raw == Raw::Literal {
                let offset = self.constant();
                Operand::RegisterIndirect { letters, register, offset }
            } else {
                let message = format!("{} where the offset stands; write `[{},P#0.0]`", self.shown(), register.text);
                self.error(Problem::P2005, self.position, self.end, message);
                let offset = Constant { value: None, extended: false, span: self.span(self.position, self.position) };
                self.skip_to_bracket();
                Operand::RegisterIndirect { letters, register, offset }
            }
        } else {
            let start = self.position;
            let pointer = self.operand(false);
            let pointer_span = self.span(start, self.position.max(start));
            Operand::Indirect { letters, pointer: Box::new(pointer), pointer_span }
        };
        self.depth -= 1;
        self.blanks();
        if self.raw != Raw::BracketClose {
            let message = format!("{} where `]` closes the bracket", self.shown());
            self.error(Problem::P2016, self.position, self.end, message);
            self.skip_to_bracket();
        }
        if self.raw == Raw::BracketClose {
            self.bump(SyntaxKind::Punctuation);
        }
        operand
    }

    fn skip_to_bracket(&mut self) {
        while !self.at_statement_end() && !matches!(self.raw, Raw::BracketClose | Raw::ParenClose) {
            self.bump_unexpected();
        }
    }
}
