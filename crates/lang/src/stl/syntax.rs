//! The lossless tree of an STL source: every byte of the text is in one of its tokens.

macro_rules! kinds {
    ($( $(#[doc = $doc:literal])* $Name:ident, )*) => {
        /// The kinds of tokens and nodes.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u16)]
        pub enum SyntaxKind { $( $(#[doc = $doc])* $Name, )* }

        impl SyntaxKind {
            /// All kinds, tokens first.
            pub const ALL: &[Self] = &[$(Self::$Name),*];
        }
    };
}

kinds! {
    /// Blanks and tabs.
    Blank,
    /// The end of a line.
    Newline,
    /// `// …`.
    LineComment,
    /// `(* … *)`.
    BlockComment,
    /// `FUNCTION`, `VAR_INPUT`, `NETWORK` …
    Keyword,
    /// What TITLE, AUTHOR and the like say.
    HeaderText,
    /// A label before its colon.
    Label,
    /// An instruction word.
    Mnemonic,
    /// Letters of an address: `MW`, `FC`, `DBX`.
    AddressLetters,
    /// The number of an address, an index or a bound.
    Number,
    /// `BR`, `STW`, `==0`.
    StatusWord,
    /// A status bit behind `__STW`.
    StatusBit,
    /// Any other word.
    Name,
    /// `"symbol"`.
    Symbol,
    /// `#local`.
    Local,
    /// `P##name`.
    AddressOf,
    /// A constant.
    Constant,
    /// `;`.
    Semicolon,
    /// `:`, `:=`, `,`, brackets and the like.
    Punctuation,
    /// A network that is written as a diagram.
    Diagram,
    /// Something that does not belong here.
    Unexpected,
    /// A whole source.
    File,
    /// A block with its header and end.
    Block,
    /// A VAR section.
    Section,
    /// One declaration.
    Declaration,
    /// A type.
    TypeName,
    /// STRUCT … END_STRUCT.
    Struct,
    /// `{ … }`.
    Attributes,
    /// A line of the header.
    HeaderLine,
    /// `NETWORK`.
    Network,
    /// One statement with its label.
    Statement,
    /// The operand of a statement.
    Operand,
    /// One parameter of a CALL.
    Argument,
    /// One assignment of a data block.
    Assignment,
}

impl From<SyntaxKind> for rowan::SyntaxKind {
    fn from(kind: SyntaxKind) -> Self {
        Self(kind as u16)
    }
}

/// STL for rowan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stl {}

impl rowan::Language for Stl {
    type Kind = SyntaxKind;
    fn kind_from_raw(raw: rowan::SyntaxKind) -> SyntaxKind {
        SyntaxKind::ALL.get(usize::from(raw.0)).copied().unwrap_or(SyntaxKind::Unexpected)
    }
    fn kind_to_raw(kind: SyntaxKind) -> rowan::SyntaxKind {
        kind.into()
    }
}

/// A node of the tree.
pub type SyntaxNode = rowan::SyntaxNode<Stl>;
/// A token of the tree.
pub type SyntaxToken = rowan::SyntaxToken<Stl>;
