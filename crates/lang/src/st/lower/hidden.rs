//! Hidden local data: values that outlive an IR statement, actual parameters, texts on their way.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use sieben_model::address::Width;

/// What a piece of hidden local data is for; a piece is used again only for the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Kind {
    /// A value that only this block sees.
    Scalar(Width),
    /// So many bytes that a pointer leads to.
    Shown(u32),
}

/// The hidden local data of a block.
#[derive(Debug, Default)]
pub(super) struct Hidden {
    end: u32,
    free: HashMap<Kind, Vec<u32>>,
    used: Vec<(Kind, u32)>,
    /// All pieces to which pointers lead: bits.
    shown: BTreeMap<u32, u32>,
}

/// Pieces given out before.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark(usize);

impl Hidden {
    /// Begins behind the declared local data of so many bytes.
    pub(super) fn behind(bytes: u32) -> Self {
        Self { end: bytes.next_multiple_of(2), ..Self::default() }
    }

    /// Bytes of all local data.
    pub(super) fn end(&self) -> u32 {
        self.end
    }

    /// Room for a value that only this block sees; its position in bits.
    pub(super) fn scalar(&mut self, width: Width) -> u32 {
        self.take(Kind::Scalar(width), width.bytes())
    }

    /// Room for bytes to which a pointer leads; the position in bits.
    pub(super) fn shown(&mut self, bytes: u32) -> u32 {
        let bytes = bytes.next_multiple_of(2);
        let position = self.take(Kind::Shown(bytes), bytes);
        self.shown.insert(position, position.saturating_add(bytes.saturating_mul(8)));
        position
    }

    /// All pieces to which pointers lead, in bits. Their places are used for nothing else.
    pub(super) fn all_shown(&self) -> Vec<Range<u32>> {
        self.shown.iter().map(|(&start, &end)| start..end).collect()
    }

    /// The piece to which pointers lead and to which a position belongs.
    pub(super) fn shown_at(&self, position: u32) -> Option<Range<u32>> {
        let (&start, &end) = self.shown.range(..=position).next_back()?;
        (position < end).then_some(start..end)
    }

    fn take(&mut self, kind: Kind, bytes: u32) -> u32 {
        let position = self.free.get_mut(&kind).and_then(Vec::pop).unwrap_or_else(|| {
            let position = self.end.saturating_mul(8);
            self.end = self.end.saturating_add(bytes.next_multiple_of(2));
            position
        });
        self.used.push((kind, position));
        position
    }

    /// What is given out from now on can be given back.
    pub(super) fn mark(&self) -> Mark {
        Mark(self.used.len())
    }

    /// What was given out since the mark is free again.
    pub(super) fn give_back(&mut self, mark: Mark) {
        for (kind, position) in self.used.drain(mark.0..) {
            self.free.entry(kind).or_default().push(position);
        }
    }

    /// What was given out until now is never free again.
    pub(super) fn keep(&mut self) {
        self.used.clear();
    }
}
