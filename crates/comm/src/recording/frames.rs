//! Recording what goes over the network, as pcapng that tools for protocols open.
//!
//! Of a TCP connection the server sees only the bytes, so the headers of IP and TCP are made up: the client has its own address and port, the
//! server port 102, where every tool expects ISO-on-TCP. A link layer there is none.

use std::net::{IpAddr, SocketAddr};

use super::{Recorder, Sink};

/// Block types of pcapng.
const SECTION: u32 = 0x0A0D_0D0A;
const INTERFACE: u32 = 1;
const PACKET: u32 = 6;
/// The magic number that tells the order of bytes.
const BYTE_ORDER: u32 = 0x1A2B_3C4D;
/// Packets begin with the header of IP.
const LINK_RAW: u16 = 101;
/// Options: a comment, the name of the application, the end.
const COMMENT: u16 = 1;
const APPLICATION: u16 = 4;
const END: u16 = 0;
/// The port of ISO-on-TCP.
const ISO_PORT: u16 = 102;
/// Protocol number of TCP.
const TCP: u8 = 6;
/// Flags of TCP.
const FIN: u8 = 0x01;
const SYN: u8 = 0x02;
const PUSH: u8 = 0x08;
const ACK: u8 = 0x10;
/// Bytes in a packet: with its headers it fits into 16 bits.
const PAYLOAD_BYTES_MAX: usize = 65_000;

/// Records frames.
pub struct Frames {
    recorder: Recorder,
}

/// Which way bytes go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From the client to the server.
    In,
    /// From the server to the client.
    Out,
}

/// A connection in the recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flow {
    client: SocketAddr,
    server: SocketAddr,
    /// The next sequence number of each side.
    next: [u32; 2],
}

impl Frames {
    /// Records into this sink.
    ///
    /// # Errors
    /// The system has no room for another thread.
    pub fn start(sink: Sink) -> std::io::Result<Self> {
        let recorder = Recorder::start("s7 frames", sink, |_| Vec::new())?;
        recorder.put(head());
        Ok(Self { recorder })
    }

    /// A connection begins.
    pub fn begin(&self, client: SocketAddr, server: IpAddr, time_us: u64) -> Flow {
        let mut flow = Flow { client, server: SocketAddr::new(server, ISO_PORT), next: [0, 0] };
        for (direction, flags) in [(Direction::In, SYN), (Direction::Out, SYN | ACK), (Direction::In, ACK)] {
            self.put(&mut flow, direction, flags, &[], time_us, "");
        }
        flow
    }

    /// Bytes went over a connection. The comment says more about them.
    pub fn bytes(&self, flow: &mut Flow, direction: Direction, bytes: &[u8], time_us: u64, comment: &str) {
        for chunk in bytes.chunks(PAYLOAD_BYTES_MAX) {
            self.put(flow, direction, PUSH | ACK, chunk, time_us, comment);
        }
    }

    /// A side of a connection sends nothing any more.
    pub fn end(&self, flow: &mut Flow, direction: Direction, time_us: u64) {
        self.put(flow, direction, FIN | ACK, &[], time_us, "");
    }

    /// How many packets were lost.
    pub fn lost(&self) -> u64 {
        self.recorder.lost()
    }

    fn put(&self, flow: &mut Flow, direction: Direction, flags: u8, bytes: &[u8], time_us: u64, comment: &str) {
        self.recorder.put(packet(&flow.segment(direction, flags, bytes), time_us, comment));
    }
}

impl Flow {
    /// The next packet of a side.
    fn segment(&mut self, direction: Direction, flags: u8, bytes: &[u8]) -> Vec<u8> {
        let (from, to, own) = match direction {
            Direction::In => (self.client, self.server, 0),
            Direction::Out => (self.server, self.client, 1),
        };
        let (sequence, heard) = (self.next[own], self.next[1 - own]);
        let takes = bytes.len() as u32 + u32::from(flags & (SYN | FIN) != 0);
        self.next[own] = sequence.wrapping_add(takes);
        let mut tcp = Vec::with_capacity(20 + bytes.len());
        tcp.extend(from.port().to_be_bytes());
        tcp.extend(to.port().to_be_bytes());
        tcp.extend(sequence.to_be_bytes());
        tcp.extend(if flags & ACK == 0 { 0 } else { heard }.to_be_bytes());
        // Five words of header, the flags, the largest window; checksum and urgent pointer.
        tcp.extend([0x50, flags, 0xFF, 0xFF, 0, 0, 0, 0]);
        tcp.extend(bytes);
        ip(from.ip(), to.ip(), tcp)
    }
}

/// Puts the header of IP before a segment of TCP.
fn ip(from: IpAddr, to: IpAddr, mut tcp: Vec<u8>) -> Vec<u8> {
    let length = tcp.len() as u16;
    match (from.to_canonical(), to.to_canonical()) {
        (IpAddr::V4(from), IpAddr::V4(to)) => {
            let addresses = [from.octets(), to.octets()].concat();
            check(&mut tcp, &addresses);
            let mut head = vec![0x45, 0];
            head.extend((length + 20).to_be_bytes());
            head.extend([0, 0, 0x40, 0, 64, TCP, 0, 0]);
            head.extend(&addresses);
            let sum = checksum(&head).to_be_bytes();
            head.splice(10..12, sum);
            head.extend(tcp);
            head
        }
        (from, to) => {
            let octets = |address: IpAddr| match address {
                IpAddr::V4(address) => address.to_ipv6_mapped().octets(),
                IpAddr::V6(address) => address.octets(),
            };
            let addresses = [octets(from), octets(to)].concat();
            check(&mut tcp, &addresses);
            let mut head = vec![0x60, 0, 0, 0];
            head.extend(length.to_be_bytes());
            head.extend([TCP, 64]);
            head.extend(&addresses);
            head.extend(tcp);
            head
        }
    }
}

/// Fills in the checksum of a segment between these addresses.
fn check(tcp: &mut [u8], addresses: &[u8]) {
    let mut covered = addresses.to_vec();
    covered.extend([0, TCP]);
    covered.extend((tcp.len() as u16).to_be_bytes());
    covered.extend(&*tcp);
    let sum = checksum(&covered).to_be_bytes();
    if let Some(place) = tcp.get_mut(16..18) {
        place.copy_from_slice(&sum);
    }
}

/// The checksum of the Internet protocols.
fn checksum(bytes: &[u8]) -> u16 {
    let word = |pair: &[u8]| u32::from(pair[0]) << 8 | pair.get(1).map_or(0, |&low| u32::from(low));
    let mut sum: u32 = bytes.chunks(2).map(word).fold(0, u32::wrapping_add);
    while sum > 0xFFFF {
        sum = (sum & 0xFFFF) + (sum >> 16);
    }
    !(sum as u16)
}

/// A block of pcapng: its type, its length before and after what it holds.
fn block(kind: u32, content: &[u8]) -> Vec<u8> {
    let length = (content.len() as u32 + 12).to_le_bytes();
    [&kind.to_le_bytes()[..], &length, content, &length].concat()
}

fn option(code: u16, value: &[u8]) -> Vec<u8> {
    let mut option = [code.to_le_bytes(), (value.len() as u16).to_le_bytes()].concat();
    option.extend(value);
    pad(&mut option);
    option
}

fn pad(bytes: &mut Vec<u8>) {
    bytes.resize(bytes.len().next_multiple_of(4), 0);
}

/// What the file begins with.
fn head() -> Vec<u8> {
    let mut section = BYTE_ORDER.to_le_bytes().to_vec();
    // Version 1.0, and no length of the section.
    section.extend([1, 0, 0, 0]);
    section.extend([0xFF; 8]);
    section.extend(option(APPLICATION, b"Sieben"));
    section.extend(option(END, &[]));
    let mut interface = LINK_RAW.to_le_bytes().to_vec();
    // Packets of any length; times are microseconds.
    interface.extend([0; 6]);
    [block(SECTION, &section), block(INTERFACE, &interface)].concat()
}

/// A packet with its time.
fn packet(bytes: &[u8], time_us: u64, comment: &str) -> Vec<u8> {
    let mut content = Vec::with_capacity(bytes.len() + 64);
    let length = (bytes.len() as u32).to_le_bytes();
    content.extend([0; 4]);
    content.extend(((time_us >> 32) as u32).to_le_bytes());
    content.extend((time_us as u32).to_le_bytes());
    content.extend(length);
    content.extend(length);
    content.extend(bytes);
    pad(&mut content);
    if !comment.is_empty() {
        content.extend(option(COMMENT, comment.as_bytes()));
        content.extend(option(END, &[]));
    }
    block(PACKET, &content)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flow(client: &str, server: &str) -> Flow {
        let server: IpAddr = server.parse().expect("an address");
        Flow { client: client.parse().expect("an address"), server: SocketAddr::new(server, ISO_PORT), next: [0, 0] }
    }

    #[test]
    fn packets_have_right_lengths_and_checksums() {
        for (client, server, head) in [("10.0.0.9:50000", "10.0.0.1", 20), ("[fd00::9]:50000", "fd00::1", 40)] {
            let mut flow = flow(client, server);
            let packet = flow.segment(Direction::In, PUSH | ACK, &[3, 0, 0, 7, 2, 0xF0, 0x80]);
            assert_eq!(packet.len(), head + 20 + 7);
            let (ip, tcp) = packet.split_at(head);
            let mut covered = if head == 20 { ip[12..20].to_vec() } else { ip[8..40].to_vec() };
            covered.extend([0, TCP, 0, tcp.len() as u8]);
            covered.extend(tcp);
            assert_eq!(checksum(&covered), 0, "the sum over a segment with its checksum");
            if head == 20 {
                assert_eq!(checksum(ip), 0);
                assert_eq!(ip[2..4], (packet.len() as u16).to_be_bytes());
            }
        }
    }

    #[test]
    fn sequence_numbers_go_on_in_both_directions() {
        let mut flow = flow("10.0.0.9:50000", "10.0.0.1");
        let numbers = |packet: Vec<u8>| {
            let word = |at: usize| u32::from_be_bytes(packet[at..at + 4].try_into().expect("four bytes"));
            (word(24), word(28))
        };
        assert_eq!(numbers(flow.segment(Direction::In, SYN, &[])), (0, 0));
        assert_eq!(numbers(flow.segment(Direction::Out, SYN | ACK, &[])), (0, 1));
        assert_eq!(numbers(flow.segment(Direction::In, PUSH | ACK, &[1; 31])), (1, 1));
        assert_eq!(numbers(flow.segment(Direction::Out, PUSH | ACK, &[1; 22])), (1, 32));
        assert_eq!(numbers(flow.segment(Direction::In, FIN | ACK, &[])), (32, 23));
        assert_eq!(numbers(flow.segment(Direction::Out, FIN | ACK, &[])), (23, 33));
    }

    #[test]
    fn every_block_says_its_length_twice() {
        let mut file = head();
        file.extend(packet(&[1, 2, 3], 1 << 33, "scan 7"));
        let mut rest = &file[..];
        let mut kinds = Vec::new();
        while let Some((kind, more)) = rest.split_first_chunk::<4>() {
            let length = u32::from_le_bytes(more[..4].try_into().expect("four bytes")) as usize;
            assert_eq!(length % 4, 0);
            assert_eq!(rest[length - 4..length], more[..4]);
            kinds.push(u32::from_le_bytes(*kind));
            rest = &rest[length..];
        }
        assert_eq!(kinds, [SECTION, INTERFACE, PACKET]);
    }
}
