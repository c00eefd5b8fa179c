//! Who listens to the modules of a rack, and what will be done to their inputs at a time to come.
//!
//! What a program gets from its modules is, beside its own beginning and the times of its scans, all that it does not have from itself: whoever writes that down and
//! says it again at the same times has the same run once more, without the modules.

use std::collections::VecDeque;

use crate::interrupts::Interrupt;

/// Something that came from a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Said {
    /// An input byte has another value than the last time.
    Byte {
        /// The byte.
        byte: u32,
        /// Its value.
        value: u8,
    },
    /// An interrupt.
    Alarm(Interrupt),
}

/// What was said, and when: microseconds like the times of scans.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heard {
    /// When.
    pub at_us: u64,
    /// What.
    pub said: Said,
}

/// Why what was heard is not enough to have the same run again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unrepeatable {
    /// A module gave this input byte two values at one time.
    Byte(u32),
    /// A module raised an interrupt in the middle of the statement that wrote to it.
    AlarmInside,
}

/// Notes what modules say when it is new.
#[derive(Debug, Default)]
pub(crate) struct Listener {
    known: Vec<u8>,
    /// Bytes that changed since [`Self::take`], with the time.
    changed: Vec<(u32, u64)>,
    heard: Vec<Heard>,
    unrepeatable: Option<(u64, Unrepeatable)>,
}

impl Listener {
    /// One who takes all input bytes for 0.
    pub(crate) fn new(bytes: usize) -> Self {
        Self { known: vec![0; bytes], ..Self::default() }
    }

    /// Input bytes as the program sees them now.
    pub(crate) fn bytes(&mut self, at_us: u64, first: usize, bytes: &[u8]) {
        let Some(known) = self.known.get_mut(first..first + bytes.len()) else { return };
        if known == bytes {
            return;
        }
        for ((byte, known), &value) in (first as u32..).zip(known).zip(bytes) {
            if *known == value {
                continue;
            }
            *known = value;
            if self.changed.contains(&(byte, at_us)) {
                self.unrepeatable.get_or_insert((at_us, Unrepeatable::Byte(byte)));
            }
            self.changed.push((byte, at_us));
            self.heard.push(Heard { at_us, said: Said::Byte { byte, value } });
        }
    }

    /// Interrupts that the CPU takes now.
    pub(crate) fn alarms(&mut self, at_us: u64, alarms: &[Interrupt]) {
        self.heard.extend(alarms.iter().map(|&alarm| Heard { at_us, said: Said::Alarm(alarm) }));
    }

    /// A module raised an interrupt while a statement wrote to it.
    pub(crate) fn alarm_inside(&mut self, at_us: u64) {
        self.unrepeatable.get_or_insert((at_us, Unrepeatable::AlarmInside));
    }

    pub(crate) fn take(&mut self) -> Vec<Heard> {
        self.changed.clear();
        std::mem::take(&mut self.heard)
    }

    pub(crate) fn unrepeatable(&self) -> Option<(u64, Unrepeatable)> {
        self.unrepeatable
    }
}

/// Something that will be done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Order {
    /// When, in microseconds.
    pub(crate) at_us: u64,
    pub(crate) what: Ordered,
}

/// What will be done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ordered {
    /// These bits of an input byte get a value.
    Input { byte: u32, mask: u8, value: u8 },
    /// An interrupt comes, as if a module had raised it.
    Alarm(Interrupt),
}

/// What will be done, by its time; what is to be done at the same time stays in its order.
#[derive(Clone, Debug, Default)]
pub(crate) struct Orders {
    waiting: VecDeque<Order>,
}

impl Orders {
    pub(crate) fn add(&mut self, order: Order) {
        let behind = self.waiting.partition_point(|other| other.at_us <= order.at_us);
        self.waiting.insert(behind, order);
    }

    /// The next one that is due by then.
    pub(crate) fn take_due(&mut self, by_us: u64) -> Option<Order> {
        if self.waiting.front()?.at_us <= by_us { self.waiting.pop_front() } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_new_is_heard() {
        let mut listener = Listener::new(4);
        listener.bytes(0, 0, &[0, 1, 0, 0]);
        listener.bytes(5, 1, &[1]);
        listener.bytes(9, 1, &[3, 0]);
        let heard = |at_us, value| Heard { at_us, said: Said::Byte { byte: 1, value } };
        assert_eq!(listener.take(), [heard(0, 1), heard(9, 3)]);
        assert_eq!(listener.take(), []);
        assert_eq!(listener.unrepeatable(), None);
    }

    #[test]
    fn a_byte_with_two_values_at_one_time_cannot_be_repeated() {
        let mut listener = Listener::new(2);
        listener.bytes(7, 0, &[1]);
        listener.bytes(7, 0, &[2]);
        assert_eq!(listener.unrepeatable(), Some((7, Unrepeatable::Byte(0))));
    }

    #[test]
    fn orders_come_in_the_order_of_their_times() {
        let mut orders = Orders::default();
        let order = |at_us, value| Order { at_us, what: Ordered::Input { byte: 0, mask: 0xFF, value } };
        for (at_us, value) in [(20, 1), (10, 2), (20, 3), (30, 4)] {
            orders.add(order(at_us, value));
        }
        let due: Vec<Order> = std::iter::from_fn(|| orders.take_due(20)).collect();
        assert_eq!(due, [order(10, 2), order(20, 1), order(20, 3)]);
    }
}
