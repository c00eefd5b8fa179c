//! What folds: blocks, networks, sections, loops, comments.

use rowan::{NodeOrToken, SyntaxNode};
use sieben_lang::st::syntax::SyntaxKind as St;
use sieben_lang::stl::syntax::SyntaxKind as Stl;

use super::outline::{Kind, Row};
use super::{Place, Text, Tree, place_of};

/// Something that folds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fold {
    /// From the line that stays to the last one that is hidden.
    pub place: Place,
    /// What it is.
    pub kind: FoldKind,
    /// What is shown in its place, if its first line does not say enough.
    pub shown: Option<String>,
}

/// What folds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FoldKind {
    /// Code.
    Code,
    /// A comment.
    Comment,
    /// A network.
    Network,
}

/// The kinds of a language that matter.
struct Kinds<K> {
    folds: fn(K) -> bool,
    line_comment: K,
    block_comment: K,
    blank: fn(K) -> bool,
    newline: K,
}

impl Text<'_> {
    /// What folds in it, in its order; what lies on one line is among it.
    pub fn folds(&self) -> Vec<Fold> {
        let mut folds = match &self.tree {
            Tree::Stl(parsed) => of_tree(
                &parsed.syntax(),
                &Kinds {
                    folds: |kind| matches!(kind, Stl::Block | Stl::Section | Stl::Struct | Stl::Statement),
                    line_comment: Stl::LineComment,
                    block_comment: Stl::BlockComment,
                    blank: |kind| kind == Stl::Blank,
                    newline: Stl::Newline,
                },
            ),
            Tree::St(parsed) => of_tree(
                &parsed.syntax(&self.text),
                &Kinds {
                    folds: |kind| matches!(kind, St::Block | St::Section | St::Struct | St::Statement | St::CaseArm | St::Arguments),
                    line_comment: St::LineComment,
                    block_comment: St::BlockComment,
                    blank: |kind| kind == St::Blank,
                    newline: St::Newline,
                },
            ),
        };
        networks(&self.outline(), &mut folds);
        folds.sort_by_key(|fold| (fold.place.0, std::cmp::Reverse(fold.place.1), fold.kind));
        folds.dedup_by_key(|fold| fold.place);
        folds
    }
}

fn networks(rows: &[Row], folds: &mut Vec<Fold>) {
    for row in rows {
        if row.kind == Kind::Network {
            let shown = match row.detail.as_str() {
                "" => None,
                title => Some(format!("{}: {title}", row.name)),
            };
            folds.push(Fold { place: row.whole, kind: FoldKind::Network, shown });
        }
        networks(&row.rows, folds);
    }
}

fn of_tree<L: rowan::Language>(root: &SyntaxNode<L>, kinds: &Kinds<L::Kind>) -> Vec<Fold>
where
    L::Kind: Copy + PartialEq,
{
    let mut folds = Vec::new();
    let mut push = |place: Place, kind: FoldKind| folds.push(Fold { place, kind, shown: None });
    // Lines of comments that follow one another fold together.
    let mut comments: Option<Place> = None;
    let mut is_alone = true;
    for element in root.descendants_with_tokens() {
        match element {
            NodeOrToken::Node(node) => {
                if (kinds.folds)(node.kind()) {
                    push(place_of(node.text_range()), FoldKind::Code);
                }
            }
            NodeOrToken::Token(token) => {
                let (kind, place) = (token.kind(), place_of(token.text_range()));
                if kind == kinds.line_comment && is_alone {
                    comments = Some((comments.map_or(place.0, |comments| comments.0), place.1));
                } else if kind == kinds.newline {
                    is_alone = true;
                    continue;
                } else if !(kinds.blank)(kind) {
                    if let Some(place) = comments.take() {
                        push(place, FoldKind::Comment);
                    }
                    if kind == kinds.block_comment {
                        push(place, FoldKind::Comment);
                    }
                }
                if !(kinds.blank)(kind) {
                    is_alone = false;
                }
            }
        }
    }
    if let Some(place) = comments {
        push(place, FoldKind::Comment);
    }
    folds
}
