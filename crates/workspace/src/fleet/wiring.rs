//! Links between controllers, resolved: who sends what to whom.

use sieben_model::address::{Area, Operand, Width};
use sieben_sim::names::Name;

use super::endpoint::Index;

/// A link with its names looked up.
#[derive(Clone, Debug)]
pub(super) struct Wire {
    /// The group of controllers that sends.
    pub(super) from: usize,
    pub(super) from_index: Index,
    /// What is sent, after each scan in which it has changed.
    pub(super) source: Operand,
    /// Whether it is put out, so that it is 0 in STOP.
    pub(super) is_output: bool,
    /// The group of controllers that receives.
    pub(super) to: usize,
    pub(super) to_index: Index,
    /// Where it goes.
    pub(super) target: Name,
    pub(super) latency_us: u64,
}

/// A value under way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Message {
    /// When it arrives, in microseconds.
    pub(super) at_us: u64,
    /// The controller that sent it.
    pub(super) sender: u32,
    /// How many it had sent before.
    pub(super) number: u64,
    /// The link.
    pub(super) wire: u32,
    pub(super) value: u32,
}

/// Controllers of a wire: from the first up to, but not including, the second, counted in their group.
pub(super) type Senders = std::ops::Range<u32>;

impl Wire {
    /// Whether this controller of the sending group sends, with so many controllers in the receiving one.
    pub(super) fn sends(&self, index: u32, receivers: u32) -> bool {
        match (self.from_index, self.to_index) {
            (Index::Each(from), Index::Each(to)) => within(i64::from(index) - from + to, receivers).is_some(),
            (Index::At(at), _) => at == index,
            (Index::Only | Index::Each(_), _) => true,
        }
    }

    /// Those of the sending group that this controller of the receiving group hears, with so many controllers in the sending one.
    pub(super) fn senders_to(&self, index: u32, senders: u32) -> Senders {
        let hears = match self.to_index {
            Index::At(at) => at == index,
            Index::Only | Index::Each(_) => true,
        };
        let sender = match (self.from_index, self.to_index) {
            _ if !hears => None,
            (Index::Each(from), Index::Each(to)) => within(i64::from(index) - to + from, senders),
            (Index::Each(_), _) => return 0..senders,
            (Index::At(at), _) => Some(at),
            (Index::Only, _) => Some(0),
        };
        sender.map_or(0..0, |sender| sender..sender + 1)
    }
}

fn within(index: i64, count: u32) -> Option<u32> {
    u32::try_from(index).ok().filter(|&index| index < count)
}

/// What a link can carry, as an address with so many bits; else why not.
pub(super) fn carried(name: &Name) -> Result<(Operand, u32), String> {
    let text = name.text();
    let width = name.item().width();
    match name.operand() {
        Some(operand @ (Operand::Address(_) | Operand::InDataBlock { .. }))
            if operand.width().is_some_and(|width| width != Width::QuadWord) =>
        {
            Ok((*operand, width))
        }
        Some(Operand::Address(_) | Operand::InDataBlock { .. }) => Err(format!("`{text}` has {width} bits; a link carries up to 32")),
        _ => Err(format!("`{text}` is no bit, byte, word or double word of inputs, outputs, bit memory or a data block")),
    }
}

/// The area of an address; none of one in a data block.
pub(super) fn area(operand: &Operand) -> Option<Area> {
    match operand {
        Operand::Address(address) => Some(address.area),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::address::Address;

    use super::*;

    fn wire(from_index: Index, to_index: Index) -> Wire {
        let source = Operand::Address(Address { area: Area::Output, width: Width::Byte, byte: 0, bit: 0 });
        let target = Name::at("IB 0", source, None);
        Wire { from: 0, from_index, source, is_output: true, to: 0, to_index, target, latency_us: 1000 }
    }

    #[test]
    fn an_index_beyond_the_ends_has_no_link() {
        let chain = wire(Index::Each(0), Index::Each(1));
        assert_eq!([0, 1, 9].map(|index| chain.senders_to(index, 10)), [0..0, 0..1, 8..9]);
        assert_eq!([0, 8, 9].map(|index| chain.sends(index, 10)), [true, true, false]);
        let back = wire(Index::Each(0), Index::Each(-1));
        assert_eq!([0, 9].map(|index| back.senders_to(index, 10)), [1..2, 0..0]);
        assert_eq!([0, 9].map(|index| back.sends(index, 10)), [false, true]);
        let far = wire(Index::Each(i64::from(u32::MAX)), Index::Each(-i64::from(u32::MAX)));
        assert_eq!((far.senders_to(9, 10), far.sends(0, 10)), (0..0, false));
    }

    #[test]
    fn one_may_send_to_all_and_all_to_one() {
        let broadcast = wire(Index::Only, Index::Each(0));
        assert_eq!([0, 9].map(|index| broadcast.senders_to(index, 1)), [0..1, 0..1]);
        let gather = wire(Index::Each(0), Index::Only);
        assert_eq!((gather.senders_to(0, 10), gather.sends(7, 1)), (0..10, true));
        let one = wire(Index::At(3), Index::At(5));
        assert_eq!([3, 5].map(|index| one.senders_to(index, 10)), [0..0, 3..4]);
        assert_eq!([3, 5].map(|index| one.sends(index, 10)), [true, false]);
    }

    /// Senders and receivers say the same of who is connected with whom.
    #[test]
    fn what_is_sent_is_heard_and_nothing_else() {
        let all = [Index::Only, Index::At(0), Index::At(4), Index::Each(0), Index::Each(2), Index::Each(-3)];
        for from in all {
            for to in all {
                // A group of one is called without an index.
                let (senders, receivers) = (if from == Index::Only { 1 } else { 5 }, if to == Index::Only { 1 } else { 7 });
                let wire = wire(from, to);
                for sender in 0..senders {
                    let heard = (0..receivers).any(|receiver| wire.senders_to(receiver, senders).contains(&sender));
                    assert_eq!(wire.sends(sender, receivers), heard, "{from:?} {to:?} {sender}");
                }
            }
        }
    }
}
