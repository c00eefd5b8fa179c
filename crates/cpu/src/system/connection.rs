//! What the blocks that communicate over a configured connection have in common. There is no configuration of connections:
//! every job ends with the error of a connection that is not there.

use super::Call;
use super::instance::Instance;
use super::parameters::Refused;

/// No such connection is configured, or it is broken.
const NO_CONNECTION: u16 = 1;
/// Type or length of an area is wrong.
const BAD_AREA: u16 = 4;
/// An area of this CPU cannot be accessed.
const NO_ACCESS: u16 = 10;

/// Where things lie in the instance of such a block. REQ or EN_R is bit 0.0.
pub(super) struct Block {
    /// DONE or NDR (bit 0) and ERROR (bit 1); STATUS lies two bytes behind.
    pub(super) outputs: usize,
    /// ANYs of areas in the partner.
    pub(super) remote: &'static [usize],
    /// ANYs of areas in this CPU.
    pub(super) local: &'static [usize],
    /// Whether this CPU receives.
    pub(super) receives: bool,
    /// LEN, where there is one.
    pub(super) length: Option<usize>,
    /// Memory of the edge of REQ or EN_R; the last variable.
    pub(super) edge: usize,
}

/// What a given area of this CPU is worth.
enum Area {
    NotGiven,
    Bytes(usize),
    Refused(u16),
}

/// One call: a rising edge starts a job, which fails at once; the next call without an edge forgets the error. The answer is BR.
pub(super) fn call(call: &mut Call<'_, '_>, block: &Block) -> bool {
    let bytes = block.edge as u32 + 2;
    let Some(mut instance) = Instance::open(call.machine, bytes) else { return false };
    let request = instance.bit(0, 0);
    let started = instance.rising(block.edge, 0, request);
    let read_any = |at: &usize| -> [u8; 10] { std::array::from_fn(|index| instance.byte(at + index)) };
    let local: Vec<[u8; 10]> = block.local.iter().map(read_any).collect();
    let remote: Vec<[u8; 10]> = block.remote.iter().map(read_any).collect();
    let length = block.length.map(|at| usize::from(instance.word(at)));
    let status = if started { status(call, block, &local, &remote, length) } else { 0 };
    let Some(mut instance) = Instance::open(call.machine, bytes) else { return false };
    instance.set_bit(block.outputs, 0, false);
    instance.set_bit(block.outputs, 1, started);
    instance.set_word(block.outputs + 2, status);
    !started
}

/// STATUS of a job: the areas are looked at before the connection.
fn status(call: &Call<'_, '_>, block: &Block, local: &[[u8; 10]], remote: &[[u8; 10]], length: Option<usize>) -> u16 {
    let areas: Vec<Area> = local.iter().map(|&any| area(call, any, block.receives)).collect();
    if let Some(status) = areas.iter().find_map(|area| if let Area::Refused(status) = area { Some(*status) } else { None }) {
        return status;
    }
    // What is sent or fetched has an area on both sides, of the same length.
    let fits = |(area, remote): (&Area, &[u8; 10])| match area {
        Area::Bytes(bytes) => remote_bytes(*remote) == Some(*bytes),
        _ => !given(*remote),
    };
    if !remote.is_empty() && !areas.iter().zip(remote).all(fits) {
        return BAD_AREA;
    }
    match (areas.first(), length) {
        (Some(Area::NotGiven) | None, _) => BAD_AREA,
        (Some(Area::Bytes(bytes)), Some(length)) if !block.receives && length > *bytes => BAD_AREA,
        _ => NO_CONNECTION,
    }
}

/// An ANY that no call has filled has the type NIL.
fn given(any: [u8; 10]) -> bool {
    any[1] != 0
}

fn area(call: &Call<'_, '_>, any: [u8; 10], write: bool) -> Area {
    if !given(any) {
        return Area::NotGiven;
    }
    match call.area(any, write) {
        Ok(bytes) if !bytes.is_empty() => Area::Bytes(bytes.len()),
        Ok(_) => Area::Refused(BAD_AREA),
        Err(Refused::DB_NOT_LOADED) => Area::Refused(NO_ACCESS),
        Err(refused) if refused == Refused::LENGTH.when(write) => Area::Refused(NO_ACCESS),
        Err(_) => Area::Refused(BAD_AREA),
    }
}

/// Bytes of an area of the partner, which this CPU cannot look up.
fn remote_bytes(any: [u8; 10]) -> Option<usize> {
    let count = usize::from(u16::from_be_bytes([any[2], any[3]]));
    match any[1] {
        0x01 => Some(count.div_ceil(8)),
        code => super::any::element_bytes(code).map(|element| count * element as usize),
    }
}
