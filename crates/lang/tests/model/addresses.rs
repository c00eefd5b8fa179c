//! Address registers, pointer arithmetic and the accesses that use them.

use proptest::prelude::*;
use sieben_engine::machine::Registers;
use sieben_model::address::Area;

use super::bench::Bench;

/// Bytes of M, I and Q on a CPU 315.
const BYTES: i128 = 2048;

/// Byte and bit of a pointer plus an offset: both are numbers of bits, 24 bits long.
fn sum(pointer: u32, offset: i128) -> i128 {
    (i128::from(pointer & 0x00FF_FFFF) + offset).rem_euclid(1 << 24)
}

fn pointer() -> impl Strategy<Value = u32> {
    let area = prop_oneof![4 => 0x81..=0x83_u32, 1 => any::<u8>().prop_map(u32::from)];
    let address = prop_oneof![4 => (0..2100_u32).prop_map(|byte| byte * 8), 1 => 0..0x4200_u32, 1 => 0..0x0100_0000_u32];
    (area, address).prop_map(|(area, address)| area << 24 | address)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn address_registers(ar1 in any::<u32>(), ar2 in any::<u32>(), accu1 in any::<u32>(), words in prop::collection::vec(0..14_usize, 1..20), byte in 0..4096_u32, bit in 0..8_u32) {
        let (mut one, mut two, mut accu, mut second) = (ar1, ar2, accu1, 0_u32);
        let mut memory = [0_u32; 2];
        let mut piece = String::new();
        for word in words {
            let add = |register: u32, offset: i128| register & 0xFF00_0000 | sum(register, offset) as u32;
            let text = match word {
                0 => { one = accu; "LAR1".to_owned() }
                1 => { two = accu; "LAR2".to_owned() }
                2 => { one = two; "LAR1 AR2".to_owned() }
                3 => { two = one; "TAR1 AR2".to_owned() }
                4 => { (second, accu) = (accu, one); "TAR1".to_owned() }
                5 => { (second, accu) = (accu, two); "TAR2".to_owned() }
                6 => { (one, two) = (two, one); "CAR".to_owned() }
                7 => { one = add(one, i128::from(accu as u16 as i16)); "+AR1".to_owned() }
                8 => { two = add(two, i128::from(accu as u16 as i16)); "+AR2".to_owned() }
                9 => { one = add(one, i128::from(byte * 8 + bit)); format!("+AR1 P#{byte}.{bit}") }
                10 => { two = add(two, i128::from(byte * 8 + bit)); format!("+AR2 P#{byte}.{bit}") }
                11 => { memory[0] = one; two = memory[1]; "TAR1 MD 0; LAR2 MD 4".to_owned() }
                12 => { memory[1] = two; one = memory[0]; "TAR2 MD 4; LAR1 MD 0".to_owned() }
                _ => { one = 0x8200_0000 | (byte * 8 + bit); format!("LAR1 P#Q {byte}.{bit}") }
            };
            piece.push_str(&text);
            piece.push_str(";\n");
        }
        let mut bench = Bench::new("315-2PN/DP", std::slice::from_ref(&piece));
        let registers = Registers { ar1: u64::from(ar1), ar2: u64::from(ar2), accu1: u64::from(accu1), ..Registers::fresh() };
        let after = bench.run(0, registers).expect("nothing here fails");
        prop_assert_eq!([after.ar1, after.ar2, after.accu1, after.accu2], [one, two, accu, second].map(u64::from), "{}", piece);
    }

    /// `L B/W/D [AR1,P#…]` and `L MB/MW/MD [MD 2000]`, `[AR2,P#…]`: the value, or a fault outside the area, across bits and in areas that do not exist.
    #[test]
    fn indirect_accesses(pointer in pointer(), byte in 0..4096_u32, bit in prop_oneof![6 => Just(0_u32), 1 => 0..8_u32], fill in any::<u8>()) {
        let offset = byte % 64 * 8 + bit;
        let at = format!("P#{}.{bit}", byte % 64);
        let mut pieces = Vec::new();
        for width in ["B", "W", "D"] {
            pieces.push(format!("L {width} [AR1,{at}];"));
            pieces.push(format!("L M{width} [AR2,{at}];"));
            pieces.push(format!("L M{width} [MD 2000];"));
        }
        pieces.push(format!("A [AR1,{at}];"));
        let mut bench = Bench::new("315-2PN/DP", &pieces);
        let mut content = |area: Area, seed: u8| {
            let bytes: Vec<u8> = (0..2048_u32).map(|index| (index as u8).wrapping_mul(31).wrapping_add(seed)).collect();
            bench.machine.memory.area_mut(area).copy_from_slice(&bytes);
            bytes
        };
        let inputs = content(Area::Input, fill);
        let outputs = content(Area::Output, fill.wrapping_add(1));
        let mut flags = content(Area::BitMemory, fill.wrapping_add(2));
        flags[2000..2004].copy_from_slice(&pointer.to_be_bytes());
        bench.machine.memory.area_mut(Area::BitMemory)[2000..2004].copy_from_slice(&pointer.to_be_bytes());
        let read = |bytes: &[u8], position: i128, width: i128| -> Option<u64> {
            let first = position / 8;
            if position % 8 != 0 || first + width > BYTES {
                return None;
            }
            Some((first..first + width).fold(0, |value, index| value << 8 | u64::from(bytes[index as usize])))
        };
        let crossing = match pointer >> 24 {
            0x81 => Some(&inputs),
            0x82 => Some(&outputs),
            0x83 => Some(&flags),
            _ => None,
        };
        // The peripheral, data blocks that are not open, and the local data have tests of their own.
        let judged = crossing.is_some() || !(0x80..=0x87).contains(&(pointer >> 24));
        let registers = || Registers { ar1: u64::from(pointer), ar2: u64::from(pointer), ..Registers::fresh() };
        for (index, width) in [1, 2, 4].into_iter().enumerate() {
            let moved = sum(pointer, i128::from(offset));
            if judged {
                let expected = crossing.and_then(|bytes| read(bytes, moved, width));
                prop_assert_eq!(bench.run(3 * index, registers()).map(|after| after.accu1), expected, "{} {:#x}", pieces[3 * index], pointer);
            }
            let expected = read(&flags, moved, width);
            prop_assert_eq!(bench.run(3 * index + 1, registers()).map(|after| after.accu1), expected, "{} {:#x}", pieces[3 * index + 1], pointer);
            let expected = read(&flags, sum(pointer, 0), width);
            prop_assert_eq!(bench.run(3 * index + 2, registers()).map(|after| after.accu1), expected, "{} {:#x}", pieces[3 * index + 2], pointer);
        }
        if judged {
            let position = sum(pointer, i128::from(offset));
            let expected = crossing.and_then(|bytes| bytes.get((position / 8) as usize)).map(|byte| byte >> (position % 8) & 1 == 1);
            prop_assert_eq!(bench.run(9, registers()).map(|after| after.rlo == 1), expected, "{} {:#x}", pieces[9], pointer);
        }
    }
}
