//! The lossless tree of an ST source: every byte of the text is in one of its tokens.

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
    /// `(* … *)`, `/* … */`.
    BlockComment,
    /// `{ … }`.
    Pragma,
    /// What a conditional pragma has switched off.
    Inactive,
    /// `FUNCTION`, `IF`, `AT` …
    Keyword,
    /// What TITLE, AUTHOR and the like say.
    HeaderText,
    /// The name of something that is declared.
    Declared,
    /// The name of a type.
    TypeWord,
    /// Any other name.
    Name,
    /// A direct address.
    Address,
    /// A number.
    Number,
    /// Characters between quotes.
    Characters,
    /// Any other constant.
    Constant,
    /// `+`, `:=`, `AND` …
    Operator,
    /// `;`.
    Semicolon,
    /// `:`, `,`, brackets and the like.
    Punctuation,
    /// The networks of a body that is a diagram.
    Diagram,
    /// Something that does not belong here.
    Unexpected,
    /// A whole source.
    File,
    /// A POU, a method, a namespace: what has a first and a last line.
    Block,
    /// A line of the header.
    HeaderLine,
    /// A VAR section, TYPE, or another list of declarations.
    Section,
    /// One declaration.
    Declaration,
    /// A type.
    TypeName,
    /// STRUCT … END_STRUCT, UNION … END_UNION.
    Struct,
    /// An initial value.
    Initializer,
    /// One statement.
    Statement,
    /// The statements inside another one.
    Body,
    /// Labels of CASE with their statements.
    CaseArm,
    /// An expression.
    Expression,
    /// The arguments of a call, with brackets.
    Arguments,
}

impl From<SyntaxKind> for rowan::SyntaxKind {
    fn from(kind: SyntaxKind) -> Self {
        Self(kind as u16)
    }
}

/// ST for rowan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum St {}

impl rowan::Language for St {
    type Kind = SyntaxKind;
    fn kind_from_raw(raw: rowan::SyntaxKind) -> SyntaxKind {
        SyntaxKind::ALL.get(usize::from(raw.0)).copied().unwrap_or(SyntaxKind::Unexpected)
    }
    fn kind_to_raw(kind: SyntaxKind) -> rowan::SyntaxKind {
        kind.into()
    }
}

/// A node of the tree.
pub type SyntaxNode = rowan::SyntaxNode<St>;
/// A token of the tree.
pub type SyntaxToken = rowan::SyntaxToken<St>;
