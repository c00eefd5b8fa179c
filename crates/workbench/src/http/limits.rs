//! How often an address may ask.

use std::collections::BTreeMap;
use std::net::IpAddr;
use std::sync::{Mutex, PoisonError};

/// Requests of one address in a second at most: opening a page takes about 40.
pub(crate) const PER_SECOND_MAX: u32 = 200;
/// Addresses that are counted at a time.
const ADDRESSES_MAX: usize = 1_024;
const SECOND_US: u64 = 1_000_000;

/// Counts requests by address.
#[derive(Default)]
pub(crate) struct Limits(Mutex<BTreeMap<IpAddr, (u64, u32)>>);

impl Limits {
    /// Counts a request; whether it is not one too many.
    pub(crate) fn allows(&self, peer: IpAddr, now_us: u64) -> bool {
        let mut counts = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if counts.len() >= ADDRESSES_MAX && !counts.contains_key(&peer) {
            counts.retain(|_, (began, _)| now_us.saturating_sub(*began) < SECOND_US);
            if counts.len() >= ADDRESSES_MAX {
                return false;
            }
        }
        let (began, count) = counts.entry(peer).or_insert((now_us, 0));
        if now_us.saturating_sub(*began) >= SECOND_US {
            (*began, *count) = (now_us, 0);
        }
        *count = count.saturating_add(1);
        *count <= PER_SECOND_MAX
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_address_has_its_own_second() {
        let limits = Limits::default();
        let (one, other) = (IpAddr::from([127, 0, 0, 1]), IpAddr::from([10, 0, 0, 1]));
        assert_eq!((0..PER_SECOND_MAX + 50).filter(|_| limits.allows(one, 5)).count() as u32, PER_SECOND_MAX);
        assert!(limits.allows(other, 5));
        assert!(!limits.allows(one, SECOND_US));
        assert!(limits.allows(one, SECOND_US + 5));
    }

    #[test]
    fn many_addresses_need_no_more_memory_than_some() {
        let limits = Limits::default();
        for number in 0..3_000_u32 {
            limits.allows(IpAddr::from(number.to_be_bytes()), 7);
        }
        assert_eq!(limits.0.lock().expect("a test").len(), ADDRESSES_MAX);
        assert!(limits.allows(IpAddr::from([9, 9, 9, 9]), 2 * SECOND_US), "after a second there is room");
    }
}
