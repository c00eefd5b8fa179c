//! What happened: list 16#xyA0.

use super::SystemStatus;

/// List 16#00A0: the diagnostic buffer, newest entry first.
pub(super) fn buffer(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    status.diagnostics.entries().map(|entry| entry.bytes().to_vec()).collect()
}

/// List 16#01A0: as many of the newest entries as the index says.
pub(super) fn newest(status: &SystemStatus<'_>, count: u16) -> Option<Vec<Vec<u8>>> {
    Some(status.diagnostics.entries().take(usize::from(count)).map(|entry| entry.bytes().to_vec()).collect())
}
