//! Who the CPU is: lists 16#xy11, 16#xy12 and 16#xy1C.

use sieben_model::literal::character_byte;

use super::{SystemStatus, record, words};

/// CPU type, order number, name in the module, firmware.
const CPUS: &[(&str, &str, &str, [u8; 3])] = &[
    ("315-2PN/DP", "6ES7 315-2EH14-0AB0", "CPU 315-2 PN/DP", [3, 2, 6]),
    ("317-2PN/DP", "6ES7 317-2EK14-0AB0", "CPU 317-2 PN/DP", [3, 2, 6]),
    ("319-3PN/DP", "6ES7 318-3EL01-0AB0", "CPU 319-3 PN/DP", [3, 2, 6]),
    ("416-3", "6ES7 416-3XS07-0AB0", "CPU 416-3 DP", [7, 0, 0]),
    ("417-4", "6ES7 417-4XT07-0AB0", "CPU 417-4", [7, 0, 0]),
];

/// Type of a module: a CPU.
const CPU: u16 = 0x00C0;

fn cpu(status: &SystemStatus<'_>) -> (&'static str, &'static str, [u8; 3]) {
    // A type that is missing here is one of the first.
    let row = CPUS.iter().find(|row| row.0 == status.cpu_type.name).unwrap_or(&CPUS[0]);
    (row.1, row.2, row.3)
}

/// List 16#xy11: order number, hardware and firmware. The firmware stands last: some clients read the end of the answer.
pub(super) fn module(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let (order, _, [major, minor, patch]) = cpu(status);
    let order = format!("{order:<20}");
    let row = |index: u16, release: [u8; 4]| record(28, &[&index.to_be_bytes(), order.as_bytes(), &CPU.to_be_bytes(), &release]);
    vec![row(1, [0, 1, 0, 1]), row(6, [0, 1, 0, 1]), row(7, [b'V', major, minor, patch])]
}

/// Features of the CPU by group (the higher byte): clock, behaviour, instructions.
const FEATURES: &[u16] = &[0x0002, 0x0101, 0x0104, 0x0202, 0x0301, 0x0302, 0x0303];
/// Hot restart.
const HOT_RESTART: u16 = 0x0203;

fn all_features(status: &SystemStatus<'_>) -> Vec<u16> {
    let hot = status.cpu_type.has_ob88.then_some(HOT_RESTART);
    let mut features: Vec<u16> = FEATURES.iter().copied().chain(hot).collect();
    features.sort_unstable();
    features
}

/// List 16#0012.
pub(super) fn features(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    all_features(status).into_iter().map(|feature| words(2, &[feature])).collect()
}

/// List 16#0112: the features of a group.
pub(super) fn features_of_group(status: &SystemStatus<'_>, group: u16) -> Option<Vec<Vec<u8>>> {
    let features: Vec<Vec<u8>> =
        all_features(status).into_iter().filter(|feature| feature & 0xFF00 == group).map(|feature| words(2, &[feature])).collect();
    (!features.is_empty()).then_some(features)
}

/// Characters of the names of system and module, and of the designation of the plant.
const NAME: usize = 24;
const DESIGNATION: usize = 32;

/// List 16#xy1C: names and numbers, in the order that clients count on.
pub(super) fn component(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let (_, name, _) = cpu(status);
    let text = |index: u16, text: &str| record(34, &[&index.to_be_bytes(), text.as_bytes()]);
    let given = |index: u16, name: &str, otherwise: &str, length: usize| {
        let name = if name.is_empty() { otherwise } else { name };
        let bytes: Vec<u8> = name.chars().map(|character| character_byte(character).unwrap_or(b'?')).take(length).collect();
        record(34, &[&index.to_be_bytes(), &bytes])
    };
    let names = status.communication;
    vec![
        given(1, &names.system_name, "Sieben", NAME),
        given(2, &names.module_name, name, NAME),
        given(3, &names.plant_name, "", DESIGNATION),
        text(4, "Soft PLC"),
        text(5, "0"),
        text(7, name),
        text(8, ""),
        // The manufacturer has no number: 0.
        record(34, &[&9_u16.to_be_bytes(), &[0, 0, 0xF6, 0]]),
        text(0xA, ""),
        text(0xB, ""),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use sieben_model::cpu_type::CpuType;

    #[test]
    fn every_cpu_type_has_an_order_number() {
        for cpu in CpuType::ALL {
            assert!(CPUS.iter().any(|row| row.0 == cpu.name && row.1.len() <= 20), "{}", cpu.name);
        }
    }
}
