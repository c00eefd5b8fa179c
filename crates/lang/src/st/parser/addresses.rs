//! Direct addresses: `%IX0.0`, `MW10`, `M[i,j]`, `DB10.DW[i]`, and slices such as `.%X3`.

use sieben_model::problems::Problem;

use super::super::ast::{Address, AddressWidth, Area, DataAddress, Expression, ExpressionKind, Location, Name, Position, Quoting, Slice};
use super::super::dialect::{Construct, Judgement};
use super::super::lexer::Raw;
use super::{Parser, SyntaxKind};

/// The letters of areas, longest first, in both mnemonic languages.
#[rustfmt::skip] // A table.
const AREAS: &[(&str, Area)] = &[
    ("PI", Area::PeripheralInput), ("PE", Area::PeripheralInput), ("PQ", Area::PeripheralOutput), ("PA", Area::PeripheralOutput),
    ("I", Area::Input), ("E", Area::Input), ("Q", Area::Output), ("A", Area::Output), ("M", Area::Memory), ("L", Area::Local),
];

fn width(letters: &str) -> Option<AddressWidth> {
    Some(match letters {
        "" | "X" => AddressWidth::Bit,
        "B" => AddressWidth::Byte,
        "W" => AddressWidth::Word,
        "D" => AddressWidth::DoubleWord,
        "L" => AddressWidth::LongWord,
        _ => return None,
    })
}

/// Area and width of upper-case letters.
fn located(letters: &str) -> Option<(Area, AddressWidth)> {
    match letters {
        "T" => return Some((Area::Timer, AddressWidth::Word)),
        "C" | "Z" => return Some((Area::Counter, AddressWidth::Word)),
        _ => {}
    }
    AREAS.iter().find_map(|&(word, area)| Some((area, width(letters.strip_prefix(word)?)?)))
}

/// Width of upper-case letters behind a data block: `DW`, `DBX`.
fn data_width(letters: &str) -> Option<AddressWidth> {
    let rest = letters.strip_prefix('D')?;
    if let Some(width) = width(rest).filter(|&width| width != AddressWidth::LongWord) {
        return Some(width);
    }
    rest.strip_prefix('B').filter(|rest| !rest.is_empty()).and_then(width)
}

/// Letters in upper case and the digits behind them, if the text is nothing else.
fn split(text: &str) -> Option<(String, &str)> {
    let digits = text.find(|c: char| c.is_ascii_digit()).unwrap_or(text.len());
    let (letters, digits) = text.split_at(digits);
    let clean = letters.len() <= 3 && letters.bytes().all(|byte| byte.is_ascii_alphabetic());
    (clean && digits.bytes().all(|byte| byte.is_ascii_digit())).then(|| (letters.to_ascii_uppercase(), digits))
}

fn number(digits: &str) -> u64 {
    digits.parse().unwrap_or(u64::MAX)
}

impl Parser<'_> {
    /// An address without `%`, where the dialect has it and the block declares no such name.
    pub(super) fn bare_address(&mut self) -> Option<Expression> {
        let token = self.token();
        if self.only_names
            || token.raw != Raw::Word
            || token.end - token.start > 12
            || self.dialect.judge(Construct::BareAddress) == Judgement::Reject
        {
            return None;
        }
        let text = self.current();
        let (letters, digits) = split(text)?;
        let (area, width) = located(&letters)?;
        if self.declared.contains(&text.to_uppercase()) {
            return None;
        }
        let timer = matches!(area, Area::Timer | Area::Counter);
        let bit = width == AddressWidth::Bit;
        let next = self.behind(self.at);
        let computed = digits.is_empty() && self.tokens[next].raw == Raw::BracketOpen;
        let bit_behind = self.tokens[next].raw == Raw::Point && self.tokens[self.behind(next)].raw == Raw::Number;
        let complete = !digits.is_empty() && (!bit || bit_behind);
        if !(complete || computed) {
            return None;
        }
        self.judge(if computed { Construct::ComputedAddress } else { Construct::BareAddress }, token.start, token.end);
        let written = Name { text: text.to_owned(), quoting: Quoting::Bare, span: self.span(token.start, token.end) };
        self.bump(SyntaxKind::Address);
        let position = if computed {
            Position::Computed(self.indices().0)
        } else {
            let mut numbers = vec![number(digits)];
            if bit && !timer {
                self.bump(SyntaxKind::Address);
                numbers.push(self.bit_number());
            }
            Position::Fixed(numbers)
        };
        let span = self.since(token.start);
        let address = Address { area, width, position, percent: false, written, span };
        Some(Expression { kind: ExpressionKind::Address(address), span })
    }

    /// `MW 10` and `FC 5` as STL writes them: in ST the number belongs to the word. What was read before the blank went wrong.
    pub(super) fn address_with_blank(&mut self) -> Option<Expression> {
        let token = self.token();
        let next = self.tokens[self.behind(self.at)];
        let line = &self.text[token.end as usize..next.start as usize];
        if self.only_names || token.raw != Raw::Word || next.raw != Raw::Number || line.contains('\n') {
            return None;
        }
        let (letters, digits) = split(self.current())?;
        let block = matches!(letters.as_str(), "DB" | "FB" | "FC" | "SFB" | "SFC");
        let area = located(&letters);
        if !digits.is_empty() || !(block || area.is_some()) || self.declared.contains(&letters) {
            return None;
        }
        let position = self.slice(next).to_owned();
        if !position.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.') {
            return None;
        }
        let bare = block || self.dialect.judge(Construct::BareAddress) != Judgement::Reject;
        let right = format!("{}{}{position}", if bare { "" } else { "%" }, self.current());
        let start = token.start;
        self.bump(SyntaxKind::Address);
        self.bump(SyntaxKind::Address);
        let span = self.since(start);
        self.slip(
            Problem::P2005,
            span,
            &right,
            format!("`{} {position}` is written without a blank", &self.text[start as usize..token.end as usize]),
        );
        let written = Name { text: right, quoting: Quoting::Bare, span };
        let kind = match area {
            Some((area, width)) => {
                let position = Position::Fixed(position.split('.').map(number).collect());
                ExpressionKind::Address(Address { area, width, position, percent: !bare, written, span })
            }
            None => ExpressionKind::Name(written),
        };
        Some(Expression { kind, span })
    }

    /// The number behind the point of a bit.
    fn bit_number(&mut self) -> u64 {
        let token = self.token();
        let text = self.current();
        let value = match text.bytes().all(|byte| byte.is_ascii_digit()) {
            true => number(text),
            false => {
                self.error(
                    Problem::P4015,
                    token.start,
                    token.end,
                    format!("`{text}` is no number of a bit: a bit has a number from 0 to 7"),
                );
                0
            }
        };
        self.bump(SyntaxKind::Address);
        value
    }

    /// An address with `%`; the current token is one.
    pub(super) fn percent_address(&mut self) -> Expression {
        let token = self.token();
        let span = self.span(token.start, token.end);
        let expression = self.read_percent(&self.current()[1..]);
        self.judge(Construct::PercentAddress, token.start, token.end);
        let kind = match expression {
            Some(kind) => kind,
            None => {
                let shown = self.shown();
                self.unexpected(Problem::P2005, format!("{shown} is no address: write it like `%IX0.0`, `%MW10` or `%QB4`"));
                ExpressionKind::Missing
            }
        };
        self.bump(SyntaxKind::Address);
        Expression { kind, span }
    }

    /// The address in the text behind `%`.
    fn read_percent(&self, text: &str) -> Option<ExpressionKind> {
        let token = self.token();
        let span = self.span(token.start, token.end);
        let (text, direct) = match text.split_once(':') {
            Some((text, _)) => (text, true),
            None => (text, false),
        };
        let mut parts = text.split('.');
        let first = parts.next()?;
        let name = |text: &str| Name { text: text.to_owned(), quoting: Quoting::Bare, span };
        if let Some(open) = first.strip_suffix('*') {
            let (area, width) = located(&open.to_ascii_uppercase())?;
            let address = Address { area, width, position: Position::Open, percent: true, written: name(first), span };
            return Some(ExpressionKind::Address(address));
        }
        let (letters, digits) = split(first)?;
        if matches!(letters.as_str(), "DB" | "FB" | "FC" | "OB") && !digits.is_empty() {
            let block = ExpressionKind::Name(name(first));
            let Some(second) = parts.next() else { return Some(block) };
            let (letters, digits) = split(second)?;
            let width = data_width(&letters)?;
            let mut numbers = vec![number(digits)];
            numbers.extend(parts.map(number));
            let valid = !digits.is_empty() && numbers.len() == if width == AddressWidth::Bit { 2 } else { 1 };
            let block = Expression { kind: block, span };
            let address = DataAddress { block, width, position: Position::Fixed(numbers), percent: true, written: name(second) };
            return valid.then(|| ExpressionKind::DataAddress(Box::new(address)));
        }
        let (mut area, width) = located(&letters)?;
        if direct {
            area = match area {
                Area::Input => Area::PeripheralInput,
                Area::Output => Area::PeripheralOutput,
                _ => return None,
            };
        }
        let mut numbers = vec![number(digits)];
        for part in parts {
            numbers.push(part.bytes().all(|byte| byte.is_ascii_digit()).then(|| number(part))?);
        }
        // `%QX75`: the bits are counted through.
        if let (&[bit], AddressWidth::Bit, false) = (numbers.as_slice(), width, matches!(area, Area::Timer | Area::Counter))
            && self.dialect.switches().bits_counted_through
        {
            numbers = vec![bit / 8, bit % 8];
        }
        let address = Address { area, width, position: Position::Fixed(numbers), percent: true, written: name(first), span };
        (!digits.is_empty()).then_some(ExpressionKind::Address(address))
    }

    /// The name of a variable that has none, behind AT: its address.
    pub(super) fn unnamed_address(&self) -> Option<Name> {
        let token = self.tokens[self.behind(self.at)];
        if token.raw != Raw::Percent || self.dialect.judge(Construct::LocatedAt) == Judgement::Reject {
            return None;
        }
        match self.read_percent(&self.slice(token)[1..])? {
            ExpressionKind::Address(address) => {
                Some(Name { text: address.plain()?, quoting: Quoting::Bare, span: self.span(token.start, token.end) })
            }
            _ => None,
        }
    }

    /// The address of AT; the current token is [`Raw::Percent`].
    pub(super) fn located_address(&mut self) -> Option<Address> {
        match self.percent_address().kind {
            ExpressionKind::Address(address) => Some(address),
            _ => None,
        }
    }

    /// `%B2`, `%X3.0`: where a field lies in its STRUCT; `None` for an address with an area.
    pub(super) fn relative_address(&mut self) -> Option<Location> {
        let mut parts = self.current()[1..].split('.');
        let (letters, digits) = split(parts.next().unwrap_or_default())?;
        let width = width(&letters).filter(|_| !letters.is_empty() && !digits.is_empty())?;
        let numbers: Vec<u64> = [digits].into_iter().chain(parts).map(number).collect();
        let offset = match (numbers.as_slice(), width) {
            (&[byte, bit], AddressWidth::Bit) if bit < 8 => byte.checked_mul(8).map(|bits| bits + bit),
            (&[byte], AddressWidth::Byte | AddressWidth::Word | AddressWidth::DoubleWord | AddressWidth::LongWord) => byte.checked_mul(8),
            _ => None,
        };
        let span = self.bump(SyntaxKind::Address);
        Some(Location::Relative { offset, bits: width.bits(), span })
    }

    /// `%DBX0.0`, `%DBW4` behind the name of a data block and its point; else the block comes back.
    pub(super) fn percent_data_address(&mut self, block: Expression) -> Result<ExpressionKind, Expression> {
        let token = self.token();
        let text = &self.current()[1..];
        let mut parts = text.split('.');
        let first = parts.next().unwrap_or_default();
        let read = split(first).and_then(|(letters, digits)| {
            let width = data_width(&letters).filter(|_| letters.starts_with("DB") && !digits.is_empty())?;
            let mut numbers = vec![number(digits)];
            numbers.extend(parts.map(number));
            (numbers.len() == if width == AddressWidth::Bit { 2 } else { 1 }).then_some((width, numbers))
        });
        let Some((width, numbers)) = read else { return Err(block) };
        self.judge(Construct::PercentAddress, token.start, token.end);
        let written = Name { text: first.to_owned(), quoting: Quoting::Bare, span: self.span(token.start, token.end) };
        self.bump(SyntaxKind::Address);
        Ok(ExpressionKind::DataAddress(Box::new(DataAddress { block, width, position: Position::Fixed(numbers), percent: true, written })))
    }

    /// `%X3`, `%B1` behind the point; the current token is [`Raw::Percent`].
    pub(super) fn slice_of(&mut self, left: Expression) -> ExpressionKind {
        let token = self.token();
        let text = &self.current()[1..];
        let read = split(text).and_then(|(letters, digits)| {
            let width = width(&letters).filter(|_| !letters.is_empty() && !digits.is_empty())?;
            Some((width.bits(), number(digits)))
        });
        let Some((bits, index)) = read else {
            let shown = self.shown();
            self.unexpected(Problem::P2018, format!("{shown} is no part of a value: write it like `.%X3`, `.%B1`, `.%W0` or `.%D0`"));
            self.bump_unexpected();
            return ExpressionKind::Parenthesized(Box::new(left));
        };
        self.judge(Construct::Slice, token.start, token.end);
        let span = self.bump(SyntaxKind::Address);
        ExpressionKind::Slice(Box::new(left), Slice { bits, index, percent: true, span })
    }

    /// `DW4`, `DBX0.0`, `DW[i]` behind the point of a data block; what makes an expression of the block.
    pub(super) fn data_address(&mut self, block: &Expression) -> Option<impl FnOnce(Expression) -> ExpressionKind + use<>> {
        let token = self.token();
        let may_be = matches!(block.kind, ExpressionKind::Name(_) | ExpressionKind::Call(_))
            && token.raw == Raw::Word
            && token.end - token.start <= 12
            && self.dialect.judge(Construct::BareAddress) != Judgement::Reject;
        if !may_be {
            return None;
        }
        let text = self.current();
        let (letters, digits) = split(text)?;
        let width = data_width(&letters)?;
        let next = self.behind(self.at);
        let bit = width == AddressWidth::Bit;
        let computed = digits.is_empty() && self.tokens[next].raw == Raw::BracketOpen;
        let bit_behind = self.tokens[next].raw == Raw::Point && self.tokens[self.behind(next)].raw == Raw::Number;
        if !(computed || (!digits.is_empty() && (!bit || bit_behind))) {
            return None;
        }
        let written = Name { text: text.to_owned(), quoting: Quoting::Bare, span: self.span(token.start, token.end) };
        self.bump(SyntaxKind::Address);
        let position = if computed {
            Position::Computed(self.indices().0)
        } else {
            let mut numbers = vec![number(digits)];
            if bit {
                self.bump(SyntaxKind::Address);
                numbers.push(self.bit_number());
            }
            Position::Fixed(numbers)
        };
        Some(move |block| ExpressionKind::DataAddress(Box::new(DataAddress { block, width, position, percent: false, written })))
    }
}
