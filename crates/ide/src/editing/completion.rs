//! What can be written at a position.

mod collect;
mod st;
mod stl;

use super::{Bytes, Position, Role, Snapshot, context};

/// Most proposals of an answer: more are not looked through, and more letters make them fewer.
pub const ITEMS_MAX: usize = 300;

/// What a proposal is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// An instruction of STL.
    Instruction,
    /// A word of the language.
    Keyword,
    /// A symbol of the symbol table.
    Symbol,
    /// A variable or parameter of the block.
    Variable,
    /// A field of a structure, a data block or an instance.
    Field,
    /// A formal parameter of a call.
    Parameter,
    /// A function.
    Function,
    /// A function block.
    FunctionBlock,
    /// A data block.
    DataBlock,
    /// A type.
    Type,
    /// A value of an enumeration or a constant.
    Constant,
    /// A label.
    Label,
    /// A text with places to fill in.
    Snippet,
}

/// A proposal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// What the list shows.
    pub label: String,
    /// What it is.
    pub kind: Kind,
    /// Address and type, or what it does, in a few words.
    pub detail: String,
    /// More about it, in Markdown; may be empty.
    pub documentation: String,
    /// What is replaced: what is written of the word so far, with its quote or `#`.
    pub range: Bytes,
    /// What stands there then.
    pub new_text: String,
    /// Whether `new_text` has places to fill in, `$1` or `${1:name}`, and `$0` for the end.
    pub snippet: bool,
    /// What the word typed so far is compared with: it has the quote or `#` if `range` has.
    pub filter: String,
    /// By what the list is sorted.
    pub sort: String,
}

/// The proposals.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completion {
    /// The proposals, by `sort`.
    pub items: Vec<Item>,
    /// There are more than were listed: ask again when more is typed.
    pub incomplete: bool,
}

/// What can be written at a position.
pub fn completion(snapshot: &Snapshot, position: Position) -> Completion {
    let Some(text) = snapshot.text(position.text).filter(|text| text.role == Role::Source) else { return Completion::default() };
    let (Some(language), Some(offset)) = (snapshot.language(position.text), snapshot.offset(position)) else {
        return Completion::default();
    };
    if context::in_comment(&text.text, offset) {
        return Completion::default();
    }
    let position = Position { offset, ..position };
    let mut typed = context::typed(&text.text, offset, language);
    if language.dialect().is_none() {
        context::with_kind(&text.text, &mut typed);
    }
    let mut collector = collect::Collector::new(snapshot, position, &typed);
    match language.dialect() {
        None => stl::collect(&mut collector, language),
        Some(dialect) => st::collect(&mut collector, dialect),
    }
    collector.finish()
}
