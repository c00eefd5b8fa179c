//! The bytes of a whole trace: a first line, a head, blocks, an end, each with a checksum.
//!
//! ```text
//! recording := "sieben trace 1\n" frame*
//! frame     := kind length(4, little endian) content checksum(4, CRC-32 of all before it in the frame)
//! kind      := 'H' title program cpu channels (name kind)*    the head, first
//!            | 'B' block                                      in the order of their scans
//!            | 'E' scans 0 | scans 1 scan time                how many scans; where the trigger came
//! ```
//! A recording without its end was cut off; what is whole of it can be read.

use super::code::{self, Decoder, Reader};
use super::store::{Store, StoreError};
use super::{CHANNELS_MAX, Channel, Moment, Origin, Summary, Trace, TraceError};
use crate::names::Kind;

/// The first line without the number of the format.
const NAME: &[u8] = b"sieben trace ";
/// The number of the format and the end of the line.
const FORMAT: &[u8] = b"1\n";
/// Longest name, title or CPU type, in bytes.
const NAME_BYTES_MAX: usize = 4096;
/// Longest content of a frame: one scan of the most channels with the longest texts, and a block before it.
const FRAME_BYTES_MAX: usize = 32 << 20;
/// Bytes of a frame before its content: kind and length.
const FRAME_HEAD: usize = 5;
const CHECKSUM: usize = 4;

/// Where a block lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    /// The number of its first scan.
    pub(super) first_scan: u64,
    offset: u64,
    length: usize,
}

/// Writes the first line and the head.
pub(super) fn write_head(store: &mut dyn Store, origin: &Origin, channels: &[Channel]) -> Result<(), StoreError> {
    let mut head = Vec::new();
    code::text(&mut head, &cut(&origin.title));
    code::number(&mut head, origin.program);
    code::text(&mut head, &cut(&origin.cpu));
    code::number(&mut head, channels.len() as u64);
    for channel in channels {
        code::text(&mut head, &cut(&channel.name));
        code::text(&mut head, &channel.kind.word());
    }
    store.append(&[NAME, FORMAT].concat())?;
    store.append(&frame(b'H', &head))
}

/// Writes a block and says where it lies.
pub(super) fn write_block(store: &mut dyn Store, first_scan: u64, bytes: &[u8]) -> Result<Block, StoreError> {
    let offset = store.size()?;
    store.append(&frame(b'B', bytes))?;
    Ok(Block { first_scan, offset: offset + FRAME_HEAD as u64, length: bytes.len() })
}

/// Writes the end.
pub(super) fn write_end(store: &mut dyn Store, scans: u64, trigger: Option<Moment>) -> Result<(), StoreError> {
    let mut end = Vec::new();
    code::number(&mut end, scans);
    match trigger {
        None => end.push(0),
        Some(moment) => {
            end.push(1);
            code::number(&mut end, moment.scan);
            code::number(&mut end, moment.time_us);
        }
    }
    store.append(&frame(b'E', &end))
}

/// Reads a block that was written or checked before.
pub(super) fn read_block(store: &dyn Store, block: &Block) -> Result<Vec<u8>, TraceError> {
    let mut bytes = vec![0; block.length];
    let count = read_whole(store, block.offset, &mut bytes)?;
    if count < bytes.len() {
        return Err(TraceError::Damaged("the recording became shorter while it was read".to_owned()));
    }
    Ok(bytes)
}

impl Trace {
    /// Reads a recording: checks all of it and finds its blocks. One that was cut off has what is whole of it.
    ///
    /// # Errors
    /// It is no recording, one of another format, or damaged.
    pub fn open(store: Box<dyn Store>) -> Result<Self, TraceError> {
        let mut offset = first_line(&*store)?;
        let Found::Frame(b'H', head) = next(&*store, &mut offset)? else {
            return Err(TraceError::Damaged("the recording ends before it names its channels".to_owned()));
        };
        let (origin, channels) = read_head(&head).ok_or_else(|| TraceError::Damaged("the head of the recording is damaged".to_owned()))?;
        let mut summary = Summary::new(channels.len());
        let (mut blocks, mut end) = (Vec::new(), None);
        let mut decoder = Decoder::new(&channels);
        loop {
            let start = offset;
            match next(&*store, &mut offset)? {
                Found::CutOff | Found::End => break,
                Found::Frame(b'B', bytes) if end.is_none() => {
                    let mut first_scan = None;
                    decoder.block(&bytes, &mut |scans| {
                        first_scan.get_or_insert(scans.first.scan);
                        summary.add(&scans);
                        Ok(())
                    })?;
                    let first_scan = first_scan.unwrap_or_default();
                    blocks.push(Block { first_scan, offset: start + FRAME_HEAD as u64, length: bytes.len() });
                }
                Found::Frame(b'E', bytes) if end.is_none() => {
                    let mut reader = Reader::new(&bytes);
                    end = Some(read_end(&mut reader).ok_or_else(|| TraceError::Damaged("the end of the recording is damaged".to_owned()))?);
                }
                Found::Frame(..) => {
                    return Err(TraceError::Damaged("the recording is damaged: a part stands where none belongs".to_owned()));
                }
            }
        }
        if let Some((scans, _)) = end
            && scans != summary.scans
        {
            return Err(TraceError::Damaged(format!("the recording is damaged: it has {} of {scans} scans", summary.scans)));
        }
        let trigger = end.and_then(|(_, trigger)| trigger);
        Ok(Self { origin, channels, summary, trigger, whole: end.is_some(), blocks, store })
    }
}

/// The same frames with right checksums, as far as the lengths of the frames lead: for mutated recordings, which would be refused at
/// their first byte otherwise.
pub fn with_checksums(bytes: &[u8]) -> Vec<u8> {
    let mut out = bytes.to_vec();
    let mut at = NAME.len() + FORMAT.len();
    while let Some(&[_, a, b, c, d]) = out.get(at..at + FRAME_HEAD) {
        let content = at + FRAME_HEAD;
        let end = content.saturating_add(u32::from_le_bytes([a, b, c, d]) as usize);
        if out.len() < end.saturating_add(CHECKSUM) {
            break;
        }
        let sum = checksum(&out[at..content], &out[content..end]);
        out[end..end + CHECKSUM].copy_from_slice(&sum);
        at = end + CHECKSUM;
    }
    out
}

fn first_line(store: &dyn Store) -> Result<u64, TraceError> {
    let mut line = [0; NAME.len() + FORMAT.len()];
    let count = read_whole(store, 0, &mut line)?;
    match line[..count].strip_prefix(NAME) {
        Some(FORMAT) => Ok(line.len() as u64),
        Some(format) if format.first().is_some_and(u8::is_ascii_digit) => {
            Err(TraceError::Damaged("the recording has a newer format than this version of Sieben reads".to_owned()))
        }
        _ => Err(TraceError::Damaged("the file is no recording; it does not begin with `sieben trace`".to_owned())),
    }
}

fn read_head(bytes: &[u8]) -> Option<(Origin, Vec<Channel>)> {
    let mut reader = Reader::new(bytes);
    let title = reader.text(NAME_BYTES_MAX)?.to_owned();
    let program = reader.number()?;
    let cpu = reader.text(NAME_BYTES_MAX)?.to_owned();
    let count = usize::try_from(reader.number()?).ok().filter(|&count| count <= CHANNELS_MAX)?;
    let mut channels = Vec::with_capacity(count);
    for _ in 0..count {
        let name = reader.text(NAME_BYTES_MAX)?.to_owned();
        channels.push(Channel { name, kind: Kind::from_word(reader.text(NAME_BYTES_MAX)?)? });
    }
    reader.is_empty().then_some((Origin { title, program, cpu }, channels))
}

fn read_end(reader: &mut Reader<'_>) -> Option<(u64, Option<Moment>)> {
    let scans = reader.number()?;
    let trigger = match reader.byte()? {
        0 => None,
        1 => Some(Moment { scan: reader.number()?, time_us: reader.number()? }),
        _ => return None,
    };
    reader.is_empty().then_some((scans, trigger))
}

enum Found {
    /// Kind and content.
    Frame(u8, Vec<u8>),
    /// The store ends inside a frame.
    CutOff,
    /// The store ends here.
    End,
}

/// Reads the frame at a place and moves behind it.
fn next(store: &dyn Store, offset: &mut u64) -> Result<Found, TraceError> {
    let mut head = [0; FRAME_HEAD];
    match read_whole(store, *offset, &mut head)? {
        0 => return Ok(Found::End),
        count if count < FRAME_HEAD => return Ok(Found::CutOff),
        _ => {}
    }
    let length = u32::from_le_bytes([head[1], head[2], head[3], head[4]]) as usize;
    if length > FRAME_BYTES_MAX {
        return Err(TraceError::Damaged("the recording is damaged: a part is longer than any can be".to_owned()));
    }
    let wanted = length + CHECKSUM;
    // The room is taken only for what is there.
    if store.size()?.saturating_sub(*offset) < (FRAME_HEAD + wanted) as u64 {
        return Ok(Found::CutOff);
    }
    let mut content = vec![0; wanted];
    if read_whole(store, *offset + FRAME_HEAD as u64, &mut content)? < wanted {
        return Ok(Found::CutOff);
    }
    let sum = content.split_off(length);
    if sum != checksum(&head, &content) {
        return Err(TraceError::Damaged("the recording is damaged: a checksum is wrong".to_owned()));
    }
    *offset += (FRAME_HEAD + wanted) as u64;
    Ok(Found::Frame(head[0], content))
}

fn frame(kind: u8, content: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(FRAME_HEAD + content.len() + CHECKSUM);
    bytes.push(kind);
    // A block is cut long before it has so many bytes.
    bytes.extend_from_slice(&(content.len() as u32).to_le_bytes());
    let sum = checksum(&bytes, content);
    bytes.extend_from_slice(content);
    bytes.extend_from_slice(&sum);
    bytes
}

fn checksum(head: &[u8], content: &[u8]) -> [u8; CHECKSUM] {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(head);
    hasher.update(content);
    hasher.finalize().to_le_bytes()
}

fn read_whole(store: &dyn Store, offset: u64, into: &mut [u8]) -> Result<usize, StoreError> {
    let mut done = 0;
    while done < into.len() {
        match store.read(offset + done as u64, &mut into[done..])? {
            0 => break,
            count => done += count,
        }
    }
    Ok(done)
}

/// A name that fits into the head.
fn cut(name: &str) -> String {
    let end = (0..=NAME_BYTES_MAX.min(name.len())).rev().find(|&end| name.is_char_boundary(end)).unwrap_or(0);
    name[..end].to_owned()
}
