//! Where a statement comes from.

use crate::source::Span;

/// Where a statement of a block comes from. What is read today makes the first two; the third is for blocks in machine code of the S7.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Origin {
    /// A statement that is written as text.
    Text {
        /// The statement.
        span: Span,
        /// Its network, from 1; 0 in a language without networks.
        network: u32,
    },
    /// An element of a diagram: a contact, a coil, a box.
    Element {
        /// Where the element stands in the text form of the diagram.
        span: Span,
        /// Its network, from 1.
        network: u32,
        /// Which element of the network, from 1 in the order of the diagram.
        element: u32,
    },
    /// An instruction of a block that has no source.
    Mc7 {
        /// Its network, from 1.
        network: u32,
        /// The byte of the code at which it begins.
        offset: u32,
    },
}

impl Origin {
    /// The place in a source text, if there is one.
    pub const fn span(self) -> Option<Span> {
        match self {
            Self::Text { span, .. } | Self::Element { span, .. } => Some(span),
            Self::Mc7 { .. } => None,
        }
    }

    /// The network, from 1; 0 in a language without networks.
    pub const fn network(self) -> u32 {
        match self {
            Self::Text { network, .. } | Self::Element { network, .. } | Self::Mc7 { network, .. } => network,
        }
    }

    /// The element of its network, in a diagram.
    pub const fn element(self) -> Option<u32> {
        match self {
            Self::Element { element, .. } => Some(element),
            Self::Text { .. } | Self::Mc7 { .. } => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::FileId;

    #[test]
    fn every_origin_has_a_network_and_only_code_without_a_source_has_no_place() {
        let span = Span::new(FileId(1), 4, 9);
        let table = [
            (Origin::Text { span, network: 0 }, Some(span), 0, None),
            (Origin::Text { span, network: 2 }, Some(span), 2, None),
            (Origin::Element { span, network: 3, element: 7 }, Some(span), 3, Some(7)),
            (Origin::Mc7 { network: 1, offset: 20 }, None, 1, None),
        ];
        for (origin, place, network, element) in table {
            assert_eq!((origin.span(), origin.network(), origin.element()), (place, network, element), "{origin:?}");
        }
    }
}
