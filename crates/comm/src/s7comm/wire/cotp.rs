//! COTP (ISO 8073, class 0): the TPDUs that open and close a connection and carry data.

use super::Broken;

/// TPDU codes.
mod code {
    pub(super) const CONNECT_REQUEST: u8 = 0xE0;
    pub(super) const CONNECT_CONFIRM: u8 = 0xD0;
    pub(super) const DISCONNECT_REQUEST: u8 = 0x80;
    pub(super) const DISCONNECT_CONFIRM: u8 = 0xC0;
    pub(super) const DATA: u8 = 0xF0;
}

/// Parameters of a connect request.
mod parameter {
    pub(super) const SIZE: u8 = 0xC0;
    pub(super) const CALLING: u8 = 0xC1;
    pub(super) const CALLED: u8 = 0xC2;
}

/// Bytes of the head of a data TPDU.
pub const DATA_HEAD: usize = 3;
/// The smallest TPDU that can be agreed on: 2⁷ bytes.
const SIZE_CODE_MIN: u8 = 7;
/// The largest TPDU that is agreed on: 2¹⁰ bytes hold every PDU.
const SIZE_CODE_MAX: u8 = 10;
/// The reason in a disconnect request: the address is unknown.
pub const ADDRESS_UNKNOWN: u8 = 3;
/// The reason in a disconnect request: too many connections.
pub const CONGESTION: u8 = 1;
/// Bytes of the name of an endpoint. Connections through subnets have 28, and both fit into the head of a confirmation.
const ENDPOINT_BYTES_MAX: usize = 64;
/// Our reference.
const OWN_REFERENCE: u16 = 1;

/// A TPDU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tpdu<'a> {
    /// CR: the other side opens the connection.
    ConnectRequest(ConnectRequest<'a>),
    /// DT.
    Data {
        /// Whether more fragments follow.
        part: Part,
        /// What it carries.
        payload: &'a [u8],
    },
    /// DR: the other side closes the connection.
    DisconnectRequest {
        /// Its reference.
        source: u16,
    },
}

/// Whether more fragments follow after this one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// EOT 0: more follow.
    More,
    /// EOT 1: this is the last one, or the only one.
    Last,
}

/// What the other side of a connection is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Partner {
    /// A programming device, PG.
    ProgrammingDevice,
    /// An operator panel, OP.
    OperatorPanel,
    /// Anything else: S7 basic communication.
    Other,
}

/// What a connect request says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ConnectRequest<'a> {
    /// The reference of the other side.
    pub source: u16,
    /// The largest TPDU, as a power of two.
    pub size_code: u8,
    /// TSAP of the other side.
    pub calling: &'a [u8],
    /// TSAP that it wants.
    pub called: &'a [u8],
}

impl ConnectRequest<'_> {
    /// Bytes of the largest TPDU, head included.
    pub fn tpdu_bytes(&self) -> usize {
        1 << self.size_code
    }

    /// What the other side is: the first byte of the TSAP that it calls.
    pub fn partner(&self) -> Partner {
        match self.called {
            [1, _] => Partner::ProgrammingDevice,
            [2, _] => Partner::OperatorPanel,
            _ => Partner::Other,
        }
    }

    /// Rack and slot of the module that is called, if the TSAP has two bytes.
    pub fn rack_and_slot(&self) -> Option<(u8, u8)> {
        match self.called {
            [_, place] => Some((place >> 5, place & 0x1F)),
            _ => None,
        }
    }
}

/// Reads a TPDU.
///
/// # Errors
/// It is none, or one that class 0 does not have: the connection is closed.
pub fn read(tpdu: &[u8]) -> Result<Tpdu<'_>, Broken> {
    let (&length, rest) = tpdu.split_first().ok_or(Broken)?;
    let (head, payload) = rest.split_at_checked(usize::from(length)).ok_or(Broken)?;
    match head {
        [code::DATA, number] => Ok(Tpdu::Data { part: if number & 0x80 == 0 { Part::More } else { Part::Last }, payload }),
        [code::CONNECT_REQUEST, _, _, source_high, source_low, 0, parameters @ ..] => {
            connect_request(u16::from_be_bytes([*source_high, *source_low]), parameters).map(Tpdu::ConnectRequest)
        }
        [code::DISCONNECT_REQUEST, _, _, source_high, source_low, _, ..] => {
            Ok(Tpdu::DisconnectRequest { source: u16::from_be_bytes([*source_high, *source_low]) })
        }
        _ => Err(Broken),
    }
}

/// The parameters come in any order; unknown ones are skipped.
fn connect_request(source: u16, mut parameters: &[u8]) -> Result<ConnectRequest<'_>, Broken> {
    let mut request = ConnectRequest { source, size_code: SIZE_CODE_MAX, calling: &[1, 0], called: &[1, 2] };
    while let [code, length, rest @ ..] = parameters {
        let (value, rest) = rest.split_at_checked(usize::from(*length)).ok_or(Broken)?;
        match (*code, value) {
            (parameter::SIZE, [size]) if *size >= SIZE_CODE_MIN => request.size_code = (*size).min(SIZE_CODE_MAX),
            (parameter::SIZE, _) => return Err(Broken),
            (parameter::CALLING | parameter::CALLED, value) if value.len() > ENDPOINT_BYTES_MAX => return Err(Broken),
            (parameter::CALLING, value) => request.calling = value,
            (parameter::CALLED, value) => request.called = value,
            _ => {}
        }
        parameters = rest;
    }
    if parameters.is_empty() { Ok(request) } else { Err(Broken) }
}

/// CC: confirms a connect request. It always has all three parameters, because some clients look at its length.
pub fn connect_confirm(out: &mut Vec<u8>, request: &ConnectRequest<'_>) {
    let start = out.len();
    out.extend_from_slice(&[0, code::CONNECT_CONFIRM]);
    out.extend_from_slice(&request.source.to_be_bytes());
    out.extend_from_slice(&OWN_REFERENCE.to_be_bytes());
    out.push(0);
    for (code, value) in
        [(parameter::SIZE, &[request.size_code][..]), (parameter::CALLING, request.calling), (parameter::CALLED, request.called)]
    {
        out.push(code);
        // A parameter comes out of a request, whose head has 254 bytes at most.
        out.push(value.len() as u8);
        out.extend_from_slice(value);
    }
    let length = out.len() - start - 1;
    if let (Some(place), Ok(length)) = (out.get_mut(start), u8::try_from(length)) {
        *place = length;
    }
}

/// DR: refuses or closes a connection.
pub fn disconnect_request(out: &mut Vec<u8>, destination: u16, reason: u8) {
    out.extend_from_slice(&[6, code::DISCONNECT_REQUEST]);
    out.extend_from_slice(&destination.to_be_bytes());
    out.extend_from_slice(&OWN_REFERENCE.to_be_bytes());
    out.push(reason);
}

/// DC: confirms that the other side closes the connection.
pub fn disconnect_confirm(out: &mut Vec<u8>, destination: u16) {
    out.extend_from_slice(&[5, code::DISCONNECT_CONFIRM]);
    out.extend_from_slice(&destination.to_be_bytes());
    out.extend_from_slice(&OWN_REFERENCE.to_be_bytes());
}

/// DT: the head before the bytes that it carries.
pub fn data_head(out: &mut Vec<u8>, part: Part) {
    out.extend_from_slice(&[2, code::DATA, if part == Part::Last { 0x80 } else { 0 }]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_of_a_connect_request_come_in_any_order() {
        let expected = ConnectRequest { source: 0x14, size_code: 9, calling: &[1, 0], called: &[1, 2] };
        let parts: [&[u8]; 4] = [&[0xC0, 1, 9], &[0xC1, 2, 1, 0], &[0xC2, 2, 1, 2], &[0x99, 0]];
        for order in [[0, 1, 2, 3], [1, 2, 0, 3], [3, 2, 1, 0], [2, 3, 0, 1]] {
            let parameters: Vec<u8> = order.iter().flat_map(|&index: &usize| parts[index].iter().copied()).collect();
            let mut tpdu = vec![6 + parameters.len() as u8, 0xE0, 0, 0, 0, 0x14, 0];
            tpdu.extend(parameters);
            assert_eq!(read(&tpdu), Ok(Tpdu::ConnectRequest(expected)));
        }
    }

    #[test]
    fn a_confirmation_swaps_the_references_and_repeats_the_parameters() {
        let mut out = Vec::new();
        connect_confirm(&mut out, &ConnectRequest { source: 0x1234, size_code: 10, calling: &[1, 0], called: &[1, 2] });
        assert_eq!(out, [0x11, 0xD0, 0x12, 0x34, 0, 1, 0, 0xC0, 1, 10, 0xC1, 2, 1, 0, 0xC2, 2, 1, 2]);
    }

    #[test]
    fn a_connect_request_keeps_within_its_lengths() {
        let broken: [&[u8]; 6] = [
            &[],
            &[0xFF, 0xE0],
            &[5, 0xE0, 0, 0, 0, 1],
            &[8, 0xE0, 0, 0, 0, 1, 0, 0xC0, 9],
            &[9, 0xE0, 0, 0, 0, 1, 0, 0xC0, 1, 6],
            &[6, 0xE0, 0, 0, 0, 1, 0x40],
        ];
        for tpdu in broken {
            assert_eq!(read(tpdu), Err(Broken), "{tpdu:02X?}");
        }
    }

    #[test]
    fn a_confirmation_has_room_for_every_request_that_is_taken() {
        for length in [28, 64, 65, 247] {
            let tpdu = [&[8 + length, 0xE0, 0, 0, 0, 1, 0, 0xC2, length][..], &vec![7; usize::from(length)]].concat();
            match read(&tpdu) {
                Ok(Tpdu::ConnectRequest(request)) => {
                    let mut out = Vec::new();
                    connect_confirm(&mut out, &request);
                    assert_eq!(usize::from(out[0]) + 1, out.len());
                }
                other => assert_eq!((other, length > 64), (Err(Broken), true)),
            }
        }
    }
}
