//! What a wrong password costs: time, for the address that it came from.

use std::net::IpAddr;

/// What the first wrong password of an address costs, in microseconds; each further one twice as much.
const FIRST_US: u64 = 100_000;
/// The most that a wrong password costs, in microseconds.
const COST_US_MAX: u64 = 3_000_000;
/// A password that would have to wait longer than this is not looked at, in microseconds: a flood closes the line for a moment, not for hours.
const LINE_US_MAX: u64 = 30_000_000;
/// After so many microseconds without a wrong password an address begins again.
const FORGOTTEN_AFTER_US: u64 = 600_000_000;
/// Addresses that are remembered; of more the one goes that has waited longest.
const ADDRESSES_MAX: usize = 256;

/// Whether a password was the right one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Password {
    /// It was.
    Right,
    /// It was not.
    Wrong,
}

/// The addresses that wrong passwords came from.
#[derive(Clone, Debug, Default)]
pub struct WrongPasswords {
    addresses: Vec<Tries>,
}

/// The wrong passwords of one address.
#[derive(Clone, Debug)]
struct Tries {
    address: IpAddr,
    /// How many there were.
    wrong: u32,
    /// Until when the next one waits.
    until_us: u64,
}

impl WrongPasswords {
    /// When a password is answered that came now. Those of an address wait for one another, over all its connections: the answer to the right one
    /// waits as well, or many connections would guess faster than one. `None`: the line is too long, and the client does not learn whether it was the right one.
    pub fn answered_us(&mut self, address: IpAddr, password: Password, now_us: u64) -> Option<u64> {
        let address = address.to_canonical();
        self.addresses.retain(|tries| now_us < tries.until_us.saturating_add(FORGOTTEN_AFTER_US));
        let known = self.addresses.iter().position(|tries| tries.address == address);
        let begin_us = known.and_then(|at| self.addresses.get(at)).map_or(now_us, |tries| tries.until_us.max(now_us));
        if begin_us.saturating_sub(now_us) > LINE_US_MAX {
            return None;
        }
        match (password, known) {
            (Password::Right, None) => {}
            (Password::Right, Some(at)) => drop(self.addresses.swap_remove(at)),
            (Password::Wrong, known) => {
                let mut tries = match known {
                    Some(at) => self.addresses.swap_remove(at),
                    None => Tries { address, wrong: 0, until_us: 0 },
                };
                let cost_us = FIRST_US.saturating_mul(2_u64.saturating_pow(tries.wrong)).min(COST_US_MAX);
                tries.wrong = tries.wrong.saturating_add(1);
                tries.until_us = begin_us.saturating_add(cost_us);
                let until_us = tries.until_us;
                if self.addresses.len() >= ADDRESSES_MAX
                    && let Some((oldest, _)) = self.addresses.iter().enumerate().min_by_key(|(_, tries)| tries.until_us)
                {
                    self.addresses.swap_remove(oldest);
                }
                self.addresses.push(tries);
                return Some(until_us);
            }
        }
        Some(begin_us)
    }
}

#[cfg(test)]
mod tests {
    use std::net::Ipv4Addr;

    use super::*;

    const A: IpAddr = IpAddr::V4(Ipv4Addr::new(10, 0, 0, 1));
    const B: IpAddr = IpAddr::V4(Ipv4Addr::new(10, 0, 0, 2));

    #[test]
    fn a_wrong_password_costs_twice_what_the_one_before_did_up_to_three_seconds() {
        let mut table = WrongPasswords::default();
        let mut now_us = 1_000;
        let costs: Vec<u64> = (0..70)
            .map(|_| {
                let answered_us = table.answered_us(A, Password::Wrong, now_us).expect("one after the other");
                let cost = answered_us - now_us;
                now_us = answered_us;
                cost / 1000
            })
            .collect();
        assert_eq!(costs[..7], [100, 200, 400, 800, 1600, 3000, 3000]);
        assert!(costs[7..].iter().all(|&cost| cost == 3000));
    }

    #[test]
    fn passwords_of_an_address_wait_for_one_another_and_those_of_others_do_not() {
        let mut table = WrongPasswords::default();
        assert_eq!(table.answered_us(A, Password::Wrong, 0), Some(100_000));
        assert_eq!(table.answered_us(A, Password::Wrong, 0), Some(300_000));
        assert_eq!(table.answered_us(B, Password::Right, 0), Some(0));
        assert_eq!(table.answered_us(A, Password::Right, 10), Some(300_000));
        assert_eq!(table.answered_us(A, Password::Wrong, 300_000), Some(400_000));
    }

    #[test]
    fn a_flood_of_passwords_closes_the_line_for_half_a_minute_and_not_for_hours() {
        let mut table = WrongPasswords::default();
        let waits = (0..10_000).filter(|_| table.answered_us(A, Password::Wrong, 0).is_some()).count();
        assert_eq!(waits, 14, "0.1 + 0.2 + 0.4 + 0.8 + 1.6 and nine times 3 s");
        assert_eq!(table.answered_us(A, Password::Right, 0), None, "the right one is not told apart");
        assert_eq!(table.answered_us(A, Password::Right, 4_000_000), Some(30_100_000));
    }

    #[test]
    fn addresses_are_forgotten_after_a_while_and_never_too_many() {
        let mut table = WrongPasswords::default();
        for number in 0..1_000 {
            table.answered_us(IpAddr::V4(Ipv4Addr::from_bits(number)), Password::Wrong, u64::from(number));
        }
        assert_eq!(table.addresses.len(), ADDRESSES_MAX);
        table.answered_us(A, Password::Right, u64::MAX);
        assert!(table.addresses.is_empty());
    }
}
