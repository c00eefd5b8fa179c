//! The tokens of a source with what each is, for colours.

use rowan::NodeOrToken;
use sieben_lang::st::syntax::SyntaxKind as St;
use sieben_lang::stl::syntax::SyntaxKind as Stl;

use super::{Place, Text, Tree, place_of};

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A comment.
    Comment,
    /// A keyword.
    Keyword,
    /// An instruction.
    Instruction,
    /// A label.
    Label,
    /// A symbol in quotes.
    Symbol,
    /// A variable.
    Variable,
    /// The name of a parameter in a call.
    Parameter,
    /// A type.
    Type,
    /// Something that is called.
    Function,
    /// A number or another constant.
    Number,
    /// Characters.
    Characters,
    /// A sign.
    Operator,
    /// An address.
    Address,
    /// The number of a block.
    Block,
    /// A status bit or another register.
    Status,
    /// A title or what else a header says.
    Heading,
}

/// A token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// Where it stands; a comment may have several lines.
    pub place: Place,
    /// What it is.
    pub kind: Kind,
    /// It declares what it names.
    pub declares: bool,
}

impl Text<'_> {
    /// All tokens that have a colour, in their order.
    pub fn tokens(&self) -> Vec<Token> {
        let mut tokens = Vec::new();
        match &self.tree {
            Tree::Stl(parsed) => {
                for token in parsed.syntax().descendants_with_tokens().filter_map(NodeOrToken::into_token) {
                    let parent = token.parent().map_or(Stl::File, |node| node.kind());
                    let place = place_of(token.text_range());
                    match token.kind() {
                        Stl::Diagram => of_diagram(token.text(), place.0, &mut tokens),
                        kind => push(&mut tokens, place, of_stl(kind, parent, token.text())),
                    }
                }
            }
            Tree::St(parsed) => {
                let all: Vec<_> = parsed.syntax(&self.text).descendants_with_tokens().filter_map(NodeOrToken::into_token).collect();
                for (index, token) in all.iter().enumerate() {
                    let parent = token.parent().map_or(St::File, |node| node.kind());
                    let next = all[index + 1..].iter().find(|next| next.kind() != St::Blank).map_or("", |next| next.text());
                    let place = place_of(token.text_range());
                    match token.kind() {
                        St::Diagram => of_diagram(token.text(), place.0, &mut tokens),
                        kind => push(&mut tokens, place, of_st(kind, parent, token.text(), next)),
                    }
                }
            }
        }
        tokens
    }
}

fn push(tokens: &mut Vec<Token>, place: Place, kind: Option<(Kind, bool)>) {
    let Some((kind, declares)) = kind else { return };
    // `MW` and `10` are one address, with the space between them.
    if let Some(last) = tokens.last_mut()
        && matches!(kind, Kind::Address | Kind::Block)
        && last.kind == kind
        && place.0 - last.place.1 <= 1
    {
        last.place.1 = place.1;
        return;
    }
    tokens.push(Token { place, kind, declares });
}

fn of_stl(kind: Stl, parent: Stl, text: &str) -> Option<(Kind, bool)> {
    let plain = |kind: Kind| Some((kind, false));
    match kind {
        Stl::LineComment | Stl::BlockComment => plain(Kind::Comment),
        Stl::Keyword => plain(Kind::Keyword),
        Stl::HeaderText => plain(Kind::Heading),
        Stl::Label => Some((Kind::Label, true)),
        Stl::Mnemonic => plain(Kind::Instruction),
        Stl::AddressLetters | Stl::Number => match (parent, kind) {
            (Stl::Block | Stl::TypeName, _) if is_block(text) || kind == Stl::Number && parent == Stl::Block => plain(Kind::Block),
            (Stl::Operand | Stl::Argument | Stl::Assignment, _) => plain(Kind::Address),
            _ => plain(Kind::Number),
        },
        Stl::StatusWord | Stl::StatusBit => plain(Kind::Status),
        Stl::Symbol => Some((Kind::Symbol, parent == Stl::Block)),
        Stl::Local | Stl::AddressOf => plain(Kind::Variable),
        Stl::Name => match parent {
            Stl::Declaration => Some((Kind::Variable, true)),
            Stl::TypeName => plain(Kind::Type),
            Stl::Argument => plain(Kind::Parameter),
            Stl::Operand => plain(Kind::Label),
            Stl::Attributes | Stl::HeaderLine => plain(Kind::Heading),
            _ => plain(Kind::Variable),
        },
        Stl::Constant if text.starts_with('\'') => plain(Kind::Characters),
        Stl::Constant => plain(Kind::Number),
        Stl::Punctuation if matches!(text, ":=" | "=>") => plain(Kind::Operator),
        _ => None,
    }
}

fn is_block(text: &str) -> bool {
    matches!(text.to_ascii_uppercase().as_str(), "OB" | "FB" | "FC" | "DB" | "UDT" | "SFB" | "SFC")
}

fn of_st(kind: St, parent: St, text: &str, next: &str) -> Option<(Kind, bool)> {
    let plain = |kind: Kind| Some((kind, false));
    match kind {
        St::LineComment | St::BlockComment | St::Pragma | St::Inactive => plain(Kind::Comment),
        St::Keyword => plain(Kind::Keyword),
        St::HeaderText => plain(Kind::Heading),
        St::Declared if parent == St::Block => Some((Kind::Function, true)),
        St::Declared => Some((Kind::Variable, true)),
        St::TypeWord => plain(Kind::Type),
        St::Name if next == "(" => plain(Kind::Function),
        St::Name if parent == St::Arguments && matches!(next, ":=" | "=>") => plain(Kind::Parameter),
        St::Name if text.starts_with('"') => plain(Kind::Symbol),
        St::Name => plain(Kind::Variable),
        St::Address => plain(Kind::Address),
        St::Number | St::Constant => plain(Kind::Number),
        St::Characters => plain(Kind::Characters),
        St::Operator if text.starts_with(char::is_alphabetic) => plain(Kind::Keyword),
        St::Operator => plain(Kind::Operator),
        _ => None,
    }
}

/// The words of a diagram, which no tree takes apart: comments, symbols, the first word of each line, addresses.
fn of_diagram(text: &str, start: usize, tokens: &mut Vec<Token>) {
    let mut at = 0;
    let mut is_first = true;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let line = rest.find(['\r', '\n']).unwrap_or(rest.len());
        let (length, kind) = match first {
            '\r' | '\n' => {
                is_first = true;
                (1, None)
            }
            '/' if rest.starts_with("//") => (line, Some(Kind::Comment)),
            '"' => (rest[1..].find(['"', '\r', '\n']).map_or(rest.len(), |end| end + 2).min(line.max(1)), Some(Kind::Symbol)),
            '\'' => (rest[1..].find(['\'', '\r', '\n']).map_or(rest.len(), |end| end + 2).min(line.max(1)), Some(Kind::Characters)),
            first if first.is_alphabetic() || matches!(first, '_' | '#') => {
                let length = rest[first.len_utf8()..].find(|c: char| !c.is_alphanumeric() && !matches!(c, '_' | '#')).unwrap_or(rest.len());
                let length = (length + first.len_utf8()).min(rest.len());
                let kind = if first == '#' {
                    Kind::Variable
                } else if is_first {
                    Kind::Instruction
                } else {
                    Kind::Parameter
                };
                is_first = false;
                (length, Some(kind))
            }
            first if first.is_ascii_digit() => {
                (rest.find(|c: char| !c.is_alphanumeric() && !matches!(c, '.' | '#' | '_')).unwrap_or(rest.len()), Some(Kind::Number))
            }
            other => (other.len_utf8(), None),
        };
        if let Some(kind) = kind {
            tokens.push(Token { place: (start + at, start + at + length), kind, declares: false });
        }
        at += length.max(1);
        while !text.is_char_boundary(at.min(text.len())) {
            at += 1;
        }
    }
}
