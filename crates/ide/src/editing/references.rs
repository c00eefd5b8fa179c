//! Every use of what a name or an address stands for.

use sieben_lang::names::{self, Found};

use super::{Place, Position, Snapshot};

/// How something is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Access {
    /// Its definition or declaration.
    Definition,
    /// It is read.
    Read,
    /// It is written.
    Write,
    /// Both.
    ReadWrite,
    /// It is called.
    Call,
    /// The data block is opened.
    Open,
    /// It is the instance of a call.
    Instance,
    /// Its address or number is taken.
    Address,
    /// A label is jumped to.
    Jump,
    /// It is named as a type.
    Type,
    /// It is the formal parameter of a call.
    Parameter,
    /// A member of it is used, or it is only mentioned.
    Path,
}

/// How a use is come by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Through {
    /// By its name.
    Name,
    /// By its address.
    Address,
    /// By an address that has bits in common with it.
    Overlap,
    /// By a pointer that may lead to it.
    Pointer,
}

/// One use.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Use {
    /// The name or the address.
    pub place: Place,
    /// How it is used.
    pub access: Access,
    /// How it is come by.
    pub through: Through,
}

/// Every use of what stands at a position, by text and place; the definitions are among them.
pub fn references(snapshot: &Snapshot, position: Position) -> Vec<Use> {
    let Some((_, _, target)) = snapshot.named(position) else { return Vec::new() };
    uses(snapshot, &snapshot.names().uses(target, None))
}

/// What was found, with places and accesses.
pub(super) fn uses(snapshot: &Snapshot, found: &[Found]) -> Vec<Use> {
    let of = |&found: &Found| {
        let access = match snapshot.names().access(found.text, found.occurrence) {
            names::Access::Definition => Access::Definition,
            names::Access::Read | names::Access::Argument => Access::Read,
            names::Access::Write => Access::Write,
            names::Access::ReadWrite => Access::ReadWrite,
            names::Access::Call => Access::Call,
            names::Access::Open => Access::Open,
            names::Access::Instance => Access::Instance,
            names::Access::Address => Access::Address,
            names::Access::Jump => Access::Jump,
            names::Access::Type => Access::Type,
            names::Access::Parameter => Access::Parameter,
            names::Access::Path => Access::Path,
        };
        let through = match found.through {
            names::Through::Name => Through::Name,
            names::Through::Address => Through::Address,
            names::Through::Overlap => Through::Overlap,
            names::Through::Pointer => Through::Pointer,
        };
        Some(Use { place: snapshot.place_of(found)?, access, through })
    };
    let mut uses: Vec<Use> = found.iter().filter_map(of).collect();
    uses.sort_by_key(|one| one.place.clone());
    uses
}
