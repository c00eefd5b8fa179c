//! What the CPU is doing: lights, organization blocks and operating modes, lists 16#xy19, 16#xy22, 16#xy24 and 16#xy74.

use sieben_model::block::{BlockId, BlockKind};

use super::{SystemStatus, record};
use crate::diagnostic_buffer::DiagnosticEntry;
use crate::forcing::Forces;
use crate::mode::OperatingMode;
use crate::start_information::StartInformation;

/// Lights: SF, INTF, EXTF, RUN, STOP, FRCE, CRST, BAF, BUS1F, BUS2F.
const LIGHTS: &[u16] = &[1, 2, 3, 4, 5, 6, 7, 8, 0xB, 0xC];
const LIGHT_SF: u16 = 1;
const LIGHT_INTF: u16 = 2;
const LIGHT_RUN: u16 = 4;
const LIGHT_STOP: u16 = 5;
const LIGHT_FRCE: u16 = 6;
/// Blinking with 2 Hz, and with 0.5 Hz.
const FAST: u8 = 1;
const SLOW: u8 = 2;

/// Lists 16#xy19 and 16#xy74: which light is on, and how it blinks.
pub(super) fn lights(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let mode = status.mode;
    // A STOP that something caused shows as an internal error.
    let error = mode == OperatingMode::Stop && status.diagnostics.newest().is_some_and(|entry| entry.event() & 0xFF00 == 0x4500);
    let light = |&number: &u16| {
        let (on, blink) = match (number, mode) {
            (LIGHT_SF | LIGHT_INTF, _) => (error, 0),
            (LIGHT_FRCE, _) => (status.forces == Forces::Some, 0),
            (LIGHT_RUN, OperatingMode::Run) | (LIGHT_STOP, OperatingMode::Stop) => (true, 0),
            (LIGHT_RUN, OperatingMode::Startup) => (true, FAST),
            (LIGHT_RUN, OperatingMode::Hold) => (true, SLOW),
            (LIGHT_STOP, OperatingMode::Startup | OperatingMode::Hold) => (true, 0),
            _ => (false, 0),
        };
        record(4, &[&number.to_be_bytes(), &[u8::from(on), blink]])
    };
    LIGHTS.iter().map(light).collect()
}

/// Bit of the state of an organization block: it is loaded.
const LOADED: u16 = 1 << 4;

/// One organization block: start information, state, what happens without it, 4 reserved bytes.
fn class(status: &SystemStatus<'_>, number: u16) -> Vec<u8> {
    // What has not run yet has told nothing but its number.
    let nothing = || StartInformation { block: u8::try_from(number).unwrap_or(u8::MAX), ..StartInformation::default() };
    let information = status.started.get(&number).copied().unwrap_or_else(nothing);
    record(28, &[&information.bytes(status.time), &LOADED.to_be_bytes(), &[0, 0]])
}

/// List 16#0022: all organization blocks that are loaded.
pub(super) fn organization_blocks(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let blocks = status.program.code.keys().filter(|block| block.kind == BlockKind::OrganizationBlock);
    blocks.map(|block| class(status, block.number)).collect()
}

/// List 16#0222: the organization block whose number is the index. OB 1 is there even if it is not loaded.
pub(super) fn organization_block(status: &SystemStatus<'_>, number: u16) -> Option<Vec<Vec<u8>>> {
    let there = number == 1 || status.program.code.contains_key(&BlockId::ob(number));
    there.then(|| vec![class(status, number)])
}

/// Codes of the modes in a mode change.
const STOP: u8 = 4;
const WARM: u8 = 5;
const HOT: u8 = 7;
const RUN: u8 = 8;
const HOLD: u8 = 0xA;

fn code(mode: OperatingMode) -> u8 {
    match mode {
        OperatingMode::Stop => STOP,
        OperatingMode::Startup => WARM,
        OperatingMode::Run => RUN,
        OperatingMode::Hold => HOLD,
    }
}

/// Modes before and after an event of the diagnostic buffer that changes the mode.
fn modes(entry: &DiagnosticEntry) -> Option<(u8, u8)> {
    let startup = if entry.fields.block == 101 { HOT } else { WARM };
    Some(match entry.event() {
        0x4301 => (STOP, startup),
        0x4302 => (startup, RUN),
        0x4303 | 0x4304 | 0x4541..=0x45FF => (RUN, STOP),
        0x4305 => (RUN, HOLD),
        0x4306 => (HOLD, RUN),
        0x430A => (HOLD, STOP),
        _ => return None,
    })
}

/// Event, identification, modes, four reserved bytes, four bytes of startup information, time.
fn change(event: u16, modes: u8, startup: &StartInformation, time: [u8; 8]) -> Vec<u8> {
    record(20, &[&event.to_be_bytes(), &[0xFF, modes], &[0; 4], &startup.info_2.to_be_bytes(), &time])
}

/// Mode changes that the list keeps.
const CHANGES_MAX: usize = 4;

/// List 16#0024: the last mode changes, newest first.
pub(super) fn mode_changes(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let changes = status.diagnostics.entries().filter_map(|entry| Some((entry, modes(entry)?)));
    let record = |(entry, (before, after)): (&DiagnosticEntry, (u8, u8))| {
        change(entry.event(), before << 4 | after, &status.startup, entry.time.to_bcd())
    };
    changes.take(CHANGES_MAX).map(record).collect()
}

/// List 16#0124: the last mode change.
pub(super) fn last_mode_change(status: &SystemStatus<'_>, _index: u16) -> Option<Vec<Vec<u8>>> {
    let mut changes = mode_changes(status);
    changes.truncate(1);
    Some(changes)
}

/// The event of list 16#0424 as real CPUs answer it.
const CURRENT_MODE: u16 = 0x5144;

/// List 16#0424: the mode now.
pub(super) fn mode(status: &SystemStatus<'_>, _index: u16) -> Option<Vec<Vec<u8>>> {
    let since = status.diagnostics.entries().find(|entry| modes(entry).is_some());
    let time = since.map_or(status.time, |entry| entry.time).to_bcd();
    // The mode before is 0 here: clients take anything else in this byte for STOP.
    Some(vec![change(CURRENT_MODE, code(status.mode), &status.startup, time)])
}
