//! The image of a block, as it is uploaded and downloaded: a header, its code or values, its interface, its networks, a footer.

use sieben_cpu::DateAndTime;

use super::codes::Refusal;
use crate::s7comm::job::BlockType;

/// Bytes of the header, and of the footer.
pub const HEADER_BYTES: usize = 36;
/// Bytes of header and footer.
pub const FRAME_BYTES: usize = 2 * HEADER_BYTES;
/// What an image begins with.
const BEGIN: [u8; 2] = *b"pp";
/// The version of the format.
const FORMAT: u8 = 1;
/// Attributes in the header: linked, know-how protected, not retentive.
const LINKED: u8 = 1 << 0;
const KNOW_HOW_PROTECTED: u8 = 1 << 3;
const NON_RETAIN: u8 = 1 << 5;
/// The word of protection of a block with know-how protection.
const PROTECTED: u32 = 3;
/// Days from 1984-01-01, where blocks count from, to 1990-01-01, where the clock does.
const DAYS_TO_1990: u64 = 2192;
const DAY_MS: u64 = 86_400_000;
/// The polynomial of the checksum: x¹⁶ + x¹⁵ + x¹² + x + 1.
const POLYNOMIAL: u16 = 0x9003;

/// Bytes of the head of an interface.
const INTERFACE_HEAD: usize = 7;
/// What the interface of a data block begins with, and that of an instance.
const SHARED: u8 = 0x05;
const INSTANCE: u8 = 0x0A;

/// What the interface of an image says. The declarations themselves are left out: the head says that there are none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interface {
    /// There is no interface.
    None,
    /// A shared data block.
    Shared,
    /// An instance of the function block with this number.
    Instance(u16),
}

impl Interface {
    fn bytes(self) -> Vec<u8> {
        let head = |kind: u8, number: u16| {
            let [low, high] = number.to_le_bytes();
            // Two lengths follow, of the declarations and of their initial values.
            vec![kind, low, high, 0, 0, 0, 0]
        };
        match self {
            Self::None => Vec::new(),
            Self::Shared => head(SHARED, 0),
            Self::Instance(number) => head(INSTANCE, number),
        }
    }

    fn length(self) -> usize {
        if self == Self::None { 0 } else { INTERFACE_HEAD }
    }
}

/// Header and footer of a block, as far as they mean anything.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Its type.
    pub block_type: BlockType,
    /// Its number.
    pub number: u16,
    /// The code of its language.
    pub language: u8,
    /// In the work memory.
    pub linked: bool,
    /// Its code is not shown.
    pub know_how_protected: bool,
    /// A warm restart sets it to the values of the load memory.
    pub non_retain: bool,
    /// When it came.
    pub loaded: DateAndTime,
    /// Bytes of its code or values.
    pub body_bytes: u16,
    /// Bytes of local data.
    pub local_bytes: u16,
    /// What its interface says.
    pub interface: Interface,
    /// Author, family and name; eight characters of each are kept.
    pub names: [String; 3],
    /// The version: before and after the point, 0 to 15 each.
    pub version: (u8, u8),
}

impl Frame {
    /// The header. The image has no table of networks.
    pub fn header(&self) -> [u8; HEADER_BYTES] {
        let flag = |on: bool, bit: u8| if on { bit } else { 0 };
        let attributes = flag(self.linked, LINKED) | flag(self.know_how_protected, KNOW_HOW_PROTECTED) | flag(self.non_retain, NON_RETAIN);
        let protection = if self.know_how_protected { PROTECTED } else { 0 };
        let interface_bytes = self.interface.length() as u16;
        let load_bytes = FRAME_BYTES as u32 + u32::from(self.body_bytes) + u32::from(interface_bytes);
        let time = time(self.loaded);
        let mut header = [0; HEADER_BYTES];
        header[..2].copy_from_slice(&BEGIN);
        header[2..6].copy_from_slice(&[FORMAT, attributes, self.language, self.block_type.code()]);
        header[6..8].copy_from_slice(&self.number.to_be_bytes());
        header[8..12].copy_from_slice(&load_bytes.to_be_bytes());
        header[12..16].copy_from_slice(&protection.to_be_bytes());
        header[16..22].copy_from_slice(&time);
        header[22..28].copy_from_slice(&time);
        header[28..30].copy_from_slice(&interface_bytes.to_be_bytes());
        header[32..34].copy_from_slice(&self.local_bytes.to_be_bytes());
        header[34..].copy_from_slice(&self.body_bytes.to_be_bytes());
        header
    }

    /// The footer, with the checksum 0: none.
    pub fn footer(&self) -> [u8; HEADER_BYTES] {
        let mut footer = [0; HEADER_BYTES];
        for (place, name) in footer.chunks_mut(8).zip(&self.names) {
            let characters = name.chars().map(|character| if character.is_ascii_graphic() { character as u8 } else { b'_' });
            for (byte, character) in place.iter_mut().zip(characters) {
                *byte = character;
            }
        }
        footer[24] = self.version.0 << 4 | self.version.1 & 0xF;
        footer
    }

    /// The whole image, if the values are as many as the header says.
    pub fn image(&self, body: &[u8]) -> Option<Vec<u8>> {
        (body.len() == usize::from(self.body_bytes)).then(|| [&self.header()[..], body, &self.interface.bytes(), &self.footer()].concat())
    }
}

/// A point in time as blocks have it: milliseconds of the day, days since 1984.
fn time(time: DateAndTime) -> [u8; 6] {
    let days = u16::try_from(time.ms() / DAY_MS + DAYS_TO_1990).unwrap_or(u16::MAX);
    let [ms_1, ms_2, ms_3, ms_4] = u32::try_from(time.ms() % DAY_MS).unwrap_or(0).to_be_bytes();
    let [days_1, days_2] = days.to_be_bytes();
    [ms_1, ms_2, ms_3, ms_4, days_1, days_2]
}

/// An image whose lengths are right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Image<'i> {
    /// Its type.
    pub block_type: BlockType,
    /// Its number.
    pub number: u16,
    /// The code of its language.
    pub language: u8,
    /// A warm restart sets it to the values of the load memory.
    pub non_retain: bool,
    /// Its header.
    pub header: [u8; HEADER_BYTES],
    /// Its code or values.
    pub body: &'i [u8],
    /// Its footer.
    pub footer: [u8; HEADER_BYTES],
}

impl<'i> Image<'i> {
    /// Reads an image. A checksum of 0 is none; that of a data block is not looked at, because it is that of the values as they were written.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn read(bytes: &'i [u8]) -> Result<Self, Refusal> {
        let (header, rest) = bytes.split_first_chunk::<HEADER_BYTES>().ok_or(Refusal::BlockLengths)?;
        let (rest, footer) = rest.split_last_chunk::<HEADER_BYTES>().ok_or(Refusal::BlockLengths)?;
        if header[..2] != BEGIN || header[2] > FORMAT {
            return Err(Refusal::BlockStructure);
        }
        let block_type = BlockType::from_code(header[5]).ok_or(Refusal::BlockStructure)?;
        let word = |at: usize| u16::from_be_bytes([header[at], header[at + 1]]);
        let [body_bytes, interface_bytes, network_bytes] = [34, 28, 30].map(|at| usize::from(word(at)));
        let load_bytes = u32::from_be_bytes([header[8], header[9], header[10], header[11]]);
        if load_bytes as usize != bytes.len() || body_bytes + interface_bytes + network_bytes != rest.len() {
            return Err(Refusal::BlockLengths);
        }
        let body = rest.get(..body_bytes).ok_or(Refusal::BlockLengths)?;
        let wanted = u16::from_be_bytes([footer[26], footer[27]]);
        if wanted != 0 && block_type != BlockType::DataBlock && checksum(header, body) != wanted {
            return Err(Refusal::BlockChecksum);
        }
        let non_retain = header[3] & NON_RETAIN != 0;
        Ok(Self { block_type, number: word(6), language: header[4], non_retain, header: *header, body, footer: *footer })
    }
}

/// The checksum of a block: over its type, the length of its code and its code.
fn checksum(header: &[u8; HEADER_BYTES], body: &[u8]) -> u16 {
    [header[5], header[34], header[35]].iter().chain(body).fold(0, |crc, &byte| {
        (0..8).fold(crc ^ u16::from(byte) << 8, |crc, _| if crc & 0x8000 == 0 { crc << 1 } else { crc << 1 ^ POLYNOMIAL })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame() -> Frame {
        Frame {
            block_type: BlockType::DataBlock,
            number: 0x0102,
            language: 5,
            linked: true,
            know_how_protected: false,
            non_retain: true,
            // 1994-01-01 00:00:01.002
            loaded: DateAndTime::DEFAULT.plus_us(1_002_000),
            body_bytes: 4,
            local_bytes: 0,
            interface: Interface::Instance(0x0102),
            names: ["Meyer".to_owned(), "far too long".to_owned(), "Ä b".to_owned()],
            version: (1, 2),
        }
    }

    #[test]
    fn an_image_has_its_fields_where_the_format_has_them() {
        let image = frame().image(&[1, 2, 3, 4]).expect("the length is right");
        #[rustfmt::skip] // One field in each line.
        let expected: Vec<u8> = [
            &b"pp"[..], &[1], &[0x21], &[5], &[0x0A], &[1, 2],
            &[0, 0, 0, 83],                         // 36 + 4 + 7 + 36
            &[0, 0, 0, 0],
            &[0, 0, 0x03, 0xEA, 0x0E, 0x45],        // 1002 ms, day 3653: 2192 and four years with a leap day
            &[0, 0, 0x03, 0xEA, 0x0E, 0x45],
            &[0, 7], &[0, 0], &[0, 0], &[0, 4],
            &[1, 2, 3, 4],
            &[0x0A, 2, 1, 0, 0, 0, 0],              // an instance of FB 258, and no declarations
            b"Meyer\0\0\0", b"far_too_", b"__b\0\0\0\0\0",
            &[0x12, 0], &[0, 0], &[0; 8],
        ]
        .concat();
        assert_eq!(image, expected);
        assert_eq!(frame().image(&[1, 2, 3]), None);
        let protected = Frame { know_how_protected: true, linked: false, non_retain: false, ..frame() }.header();
        assert_eq!((protected[3], &protected[12..16]), (8, &[0, 0, 0, 3][..]));
    }

    #[test]
    fn an_image_is_read_as_it_was_written() {
        let image = frame().image(&[1, 2, 3, 4]).expect("an image");
        let read = Image::read(&image).expect("an image");
        assert_eq!((read.block_type, read.number, read.language, read.non_retain), (BlockType::DataBlock, 0x0102, 5, true));
        assert_eq!((read.header, read.body, read.footer), (frame().header(), &[1, 2, 3, 4][..], frame().footer()));
    }

    /// An FC with two bytes of code, three of interface and four of networks.
    fn function() -> Vec<u8> {
        let frame = Frame { block_type: BlockType::Function, language: 1, body_bytes: 2, ..frame() };
        let mut header = frame.header();
        (header[11], header[29], header[31]) = (36 + 2 + 3 + 4 + 36, 3, 4);
        [&header[..], &[0x65, 0], &[9; 3], &[8; 4], &frame.footer()].concat()
    }

    #[test]
    fn a_block_whose_lengths_contradict_one_another_is_refused() {
        let whole = function();
        assert_eq!(Image::read(&whole).map(|image| image.body), Ok(&[0x65, 0][..]));
        for end in 0..whole.len() {
            assert_eq!(Image::read(&whole[..end]), Err(Refusal::BlockLengths), "{end} bytes");
        }
        assert_eq!(Image::read(&[&whole[..], &[0]].concat()), Err(Refusal::BlockLengths));
        for at in [8, 9, 10, 11, 28, 29, 30, 31, 34, 35] {
            for value in [0xFF, whole[at] ^ 1] {
                let mut damaged = whole.clone();
                damaged[at] = value;
                assert_eq!(Image::read(&damaged), Err(Refusal::BlockLengths), "byte {at} = {value}");
            }
        }
    }

    #[test]
    fn a_block_that_is_none_is_refused() {
        for (at, value) in [(0, b'P'), (1, 0), (2, 2), (5, 0x07), (5, 0x10), (5, 9)] {
            let mut damaged = function();
            damaged[at] = value;
            assert_eq!(Image::read(&damaged), Err(Refusal::BlockStructure), "byte {at} = {value}");
        }
    }

    #[test]
    fn the_checksum_counts_where_there_is_one() {
        // One bit in the last byte: the polynomial itself is left.
        let mut header = [0; HEADER_BYTES];
        assert_eq!(checksum(&header, &[]), 0);
        header[35] = 1;
        assert_eq!(checksum(&header, &[]), POLYNOMIAL);
        assert_eq!(checksum(&[0; HEADER_BYTES], &[1]), POLYNOMIAL);
        let right = {
            let image = function();
            let header = image.first_chunk().expect("a header");
            checksum(header, &[0x65, 0])
        };
        let with = |sum: u16| {
            let mut image = function();
            let at = image.len() - 10;
            image[at..at + 2].copy_from_slice(&sum.to_be_bytes());
            image
        };
        assert!(Image::read(&with(right)).is_ok());
        assert_eq!(Image::read(&with(right ^ 1)), Err(Refusal::BlockChecksum));
        // That of a data block is the one of values that were there once.
        let mut data = frame().image(&[1, 2, 3, 4]).expect("an image");
        let at = data.len() - 10;
        data[at] = 7;
        assert!(Image::read(&data).is_ok());
    }
}
