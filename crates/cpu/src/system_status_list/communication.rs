//! Communication, clock and protection: lists 16#xy37, 16#0131, 16#0132 and 16#0232. What counts jobs is 0.

use super::{SystemStatus, record, words};
use crate::communication::{Communication, ProtectionLevel};

/// Bytes of each record.
const BYTES: usize = 40;
/// Bits per second on the MPI network and on the K bus.
const MPI_SPEED: u32 = 187_500;
const K_BUS_SPEED: u32 = 10_500_000;
/// The MPI address of the CPU.
const MPI_ADDRESS: u16 = 2;

/// Bytes of a record of list 16#xy37.
const ETHERNET_BYTES: usize = 48;
/// Where an IP address comes from: not given, and from neither a configuration nor a protocol that gives addresses.
const NO_ADDRESS: u8 = 0;
const OTHER_SOURCE: u8 = 0xFF;

/// List 16#xy37: the Ethernet interface of CPU types that have one. It is that of the computer: neither its mask and router nor its MAC address
/// are known, so they are 0.
pub(super) fn ethernet(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    if !status.cpu_type.name.contains("PN") {
        return Vec::new();
    }
    // The interfaces have the last logical addresses; that of MPI and DP is the very last.
    let logical = u16::try_from(status.cpu_type.peripheral.saturating_sub(2)).unwrap_or(u16::MAX);
    let address = status.communication.address;
    let source = address.map_or(NO_ADDRESS, |_| OTHER_SOURCE);
    let address = address.map_or([0; 4], |address| address.octets());
    vec![record(ETHERNET_BYTES, &[&logical.to_be_bytes(), &address, &[0; 4 + 4 + 6], &[source]])]
}

/// List 16#0131: what communication the CPU is capable of.
pub(super) fn capability(status: &SystemStatus<'_>, index: u16) -> Option<Vec<Vec<u8>>> {
    let record = match index {
        1 => {
            let [pdu, connections] = [status.cpu_type.pdu, status.cpu_type.connections].map(u16::to_be_bytes);
            record(BYTES, &[&[0, 1], &pdu, &connections, &MPI_SPEED.to_be_bytes(), &K_BUS_SPEED.to_be_bytes()])
        }
        // Test functions, cyclic reading, operator control, diagnosis, connections, messages: none of them is there.
        2..=9 | 0x10 => words(BYTES, &[index]),
        _ => return None,
    };
    Some(vec![record])
}

/// List 16#0132: the state of communication.
pub(super) fn status(status: &SystemStatus<'_>, index: u16) -> Option<Vec<Vec<u8>>> {
    let record = match index {
        1 => connections(status),
        2 | 3 | 5 | 6 | 7 | 0xA => words(BYTES, &[index]),
        4 => protection_levels(status),
        8 => clock(status),
        9 => words(BYTES, &[index, MPI_ADDRESS]),
        0xB => meters(status, index, 0),
        0xC => meters(status, index, 4),
        _ => return None,
    };
    Some(vec![record])
}

/// Kept for a programming device and for an operator panel; used by them; two that are configured; free; used by others. What servers take
/// beyond that of a real CPU is shown, and none is free.
fn connections(status: &SystemStatus<'_>) -> Vec<u8> {
    let &Communication { programming_devices, operator_panels, others, .. } = status.communication;
    let taken = [programming_devices.max(1), operator_panels.max(1), others].into_iter().fold(0, u16::saturating_add);
    let free = status.cpu_type.connections.saturating_sub(taken);
    words(BYTES, &[1, 1, 1, programming_devices, operator_panels, 0, 0, free, others, 0])
}

/// Level of the mode switch, level of the configuration (0: none), level that holds, the mode switch (1: RUN), startup (2: warm).
fn protection_levels(status: &SystemStatus<'_>) -> Vec<u8> {
    let level = status.communication.protection;
    let configured = if level == ProtectionLevel::Open { 0 } else { level.number() };
    words(BYTES, &[4, 1, configured, level.number(), 1, 2])
}

/// List 16#0232: protection.
pub(super) fn protection(status: &SystemStatus<'_>, index: u16) -> Option<Vec<Vec<u8>>> {
    (index == 4).then(|| vec![protection_levels(status)])
}

/// Meters that run, 16-bit meters, time of day and what is known about it.
fn clock(status: &SystemStatus<'_>) -> Vec<u8> {
    let meters: Vec<u8> = status
        .meters
        .iter()
        .flat_map(|&hours| u16::try_from(hours).unwrap_or(i16::MAX as u16).min(i16::MAX as u16).to_be_bytes())
        .collect();
    record(
        BYTES,
        &[
            &8_u16.to_be_bytes(),
            &[status.meters_running, 0, 0, 0],
            &meters,
            &[0, 0],
            &status.time.to_bcd(),
            &status.clock_status.to_be_bytes(),
        ],
    )
}

/// Meters that run, which have overflowed, and four 32-bit meters from `first` on.
fn meters(status: &SystemStatus<'_>, index: u16, first: usize) -> Vec<u8> {
    let meters: Vec<u8> = status.meters.iter().skip(first).take(4).flat_map(|hours| hours.to_be_bytes()).collect();
    record(BYTES, &[&index.to_be_bytes(), &[status.meters_running, 0], &meters])
}
