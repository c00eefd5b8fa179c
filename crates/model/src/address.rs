//! Memory areas, widths and absolute addresses.

use crate::mnemonics::Mnemonics;

/// A memory area that statements address.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Area {
    /// Process image of the inputs, I (E).
    Input,
    /// Process image of the outputs, Q (A).
    Output,
    /// Bit memory, M.
    BitMemory,
    /// Peripheral inputs, PI (PE): the module itself.
    PeripheralInput,
    /// Peripheral outputs, PQ (PA): the module itself.
    PeripheralOutput,
    /// The data block that the DB register holds.
    SharedData,
    /// The data block that the DI register holds.
    InstanceData,
    /// Local data of the running block, L.
    Local,
    /// Local data of the caller, V.
    CallerLocal,
}

impl Area {
    /// The prefix of an address in this area (`I`, `PI`, `DB`), before the width letter.
    pub fn prefix(self, mnemonics: Mnemonics) -> &'static str {
        let german = mnemonics == Mnemonics::German;
        match self {
            Self::Input if german => "E",
            Self::Input => "I",
            Self::Output if german => "A",
            Self::Output => "Q",
            Self::BitMemory => "M",
            Self::PeripheralInput if german => "PE",
            Self::PeripheralInput => "PI",
            Self::PeripheralOutput if german => "PA",
            Self::PeripheralOutput => "PQ",
            Self::SharedData => "DB",
            Self::InstanceData => "DI",
            Self::Local => "L",
            Self::CallerLocal => "V",
        }
    }

    /// The code of the area in byte 3 of an area-crossing pointer; reads and writes of the peripheral share 16#80.
    pub const fn pointer_code(self) -> u8 {
        match self {
            Self::PeripheralInput | Self::PeripheralOutput => 0x80,
            Self::Input => 0x81,
            Self::Output => 0x82,
            Self::BitMemory => 0x83,
            Self::SharedData => 0x84,
            Self::InstanceData => 0x85,
            Self::Local => 0x86,
            Self::CallerLocal => 0x87,
        }
    }
}

/// How much an access reads or writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Width {
    /// One bit.
    Bit,
    /// 8 bits.
    Byte,
    /// 16 bits.
    Word,
    /// 32 bits.
    DoubleWord,
    /// 64 bits; no address of STL has it.
    QuadWord,
}

impl Width {
    /// Bytes that the access touches.
    pub const fn bytes(self) -> u32 {
        match self {
            Self::Bit | Self::Byte => 1,
            Self::Word => 2,
            Self::DoubleWord => 4,
            Self::QuadWord => 8,
        }
    }
    /// Bits that the access touches.
    pub const fn bits(self) -> u32 {
        match self {
            Self::Bit => 1,
            Self::Byte => 8,
            Self::Word => 16,
            Self::DoubleWord => 32,
            Self::QuadWord => 64,
        }
    }
    /// The width of a value of so many bits, if there is one.
    pub const fn of_bits(bits: u64) -> Option<Self> {
        Some(match bits {
            1 => Self::Bit,
            8 => Self::Byte,
            16 => Self::Word,
            32 => Self::DoubleWord,
            64 => Self::QuadWord,
            _ => return None,
        })
    }
    /// The letter behind the area (`B`, `W`, `D`, `L`; `X` for a bit of a data block, none elsewhere).
    pub const fn letter(self) -> &'static str {
        match self {
            Self::Bit => "",
            Self::Byte => "B",
            Self::Word => "W",
            Self::DoubleWord => "D",
            Self::QuadWord => "L",
        }
    }
}

/// An absolute address in one area: `MW 10`, `I 0.3`, `DBX 2.5`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// Which area.
    pub area: Area,
    /// Bit, byte, word, double word or quad word.
    pub width: Width,
    /// Number of the (first) byte.
    pub byte: u32,
    /// Bit in the byte, 0 to 7; 0 for wider accesses.
    pub bit: u8,
}

/// Something that a user can name by its absolute address, as in `--set`, `--show` and symbol tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operand {
    /// An address in an area that needs no data block.
    Address(Address),
    /// An address in a data block: `DB10.DBW2`.
    InDataBlock {
        /// Number of the data block.
        db: u16,
        /// The address, its area always [`Area::SharedData`].
        address: Address,
    },
    /// A timer, `T 1`.
    Timer(u16),
    /// A counter, `C 1` (`Z 1`).
    Counter(u16),
    /// A block, `FC 1`.
    Block(crate::block::BlockId),
}

impl Address {
    /// The address in the spelling of a mnemonic language: `I 0.0`, `MW 10`, `DBX 2.5`.
    pub fn spell(&self, mnemonics: Mnemonics) -> String {
        let prefix = self.area.prefix(mnemonics);
        let letter = match (self.width, self.area) {
            (Width::Bit, Area::SharedData | Area::InstanceData) => "X",
            (width, _) => width.letter(),
        };
        match self.width {
            Width::Bit => format!("{prefix}{letter} {}.{}", self.byte, self.bit),
            _ => format!("{prefix}{letter} {}", self.byte),
        }
    }
}

impl Operand {
    /// The width of an address; `None` for timers, counters and blocks.
    pub fn width(&self) -> Option<Width> {
        match self {
            Self::Address(address) | Self::InDataBlock { address, .. } => Some(address.width),
            Self::Timer(_) | Self::Counter(_) | Self::Block(_) => None,
        }
    }

    /// The operand in the spelling of a mnemonic language.
    pub fn spell(&self, mnemonics: Mnemonics) -> String {
        match self {
            Self::Address(address) => address.spell(mnemonics),
            Self::InDataBlock { db, address } => format!("DB{db}.{}", address.spell(mnemonics)),
            Self::Timer(number) => format!("T {number}"),
            Self::Counter(number) if mnemonics == Mnemonics::German => format!("Z {number}"),
            Self::Counter(number) => format!("C {number}"),
            Self::Block(block) => block.to_string(),
        }
    }

    /// Reads an absolute address in either mnemonic language, blanks optional, without regard to case.
    ///
    /// `None` if the text is no absolute address. A bit number above 7 is no address.
    pub fn parse(text: &str) -> Option<Self> {
        let text: String = text.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase();
        if let Some((block, inner)) = text.split_once('.')
            && let Some(number) = block.strip_prefix("DB")
            && inner.starts_with("DB")
        {
            let db = parse_number(number)?;
            return match Self::parse(inner)? {
                Self::Address(address) if address.area == Area::SharedData => Some(Self::InDataBlock { db, address }),
                _ => None,
            };
        }
        let digits = text.find(|c: char| c.is_ascii_digit())?;
        let (word, number) = text.split_at(digits);
        if let Some(block) = word.strip_suffix('-') {
            return parse_negative(block, number).map(Self::Block);
        }
        match word {
            "T" => return parse_number(number).map(Self::Timer),
            "C" | "Z" => return parse_number(number).map(Self::Counter),
            _ => {}
        }
        if let Some(kind) = crate::block::BlockKind::from_abbreviation(word) {
            return Some(Self::Block(crate::block::BlockId::new(kind, parse_number(number)?)));
        }
        let (area, width) = area_and_width(word)?;
        let (byte, bit) = match (width, number.split_once('.')) {
            (Width::Bit, Some((byte, bit))) => (parse_number::<u32>(byte)?, parse_number::<u8>(bit).filter(|&bit| bit < 8)?),
            (Width::Bit, None) | (_, Some(_)) => return None,
            (_, None) => (parse_number::<u32>(number)?, 0),
        };
        Some(Self::Address(Address { area, width, byte, bit }))
    }
}

/// Area and width that the letters of an address name, in either mnemonic language.
pub fn area_and_width(word: &str) -> Option<(Area, Width)> {
    let word = word.to_ascii_uppercase();
    let (area, rest) = [
        ("PI", Area::PeripheralInput),
        ("PE", Area::PeripheralInput),
        ("PQ", Area::PeripheralOutput),
        ("PA", Area::PeripheralOutput),
        ("DB", Area::SharedData),
        ("DI", Area::InstanceData),
        ("I", Area::Input),
        ("E", Area::Input),
        ("Q", Area::Output),
        ("A", Area::Output),
        ("M", Area::BitMemory),
        ("L", Area::Local),
        ("V", Area::CallerLocal),
    ]
    .into_iter()
    .find_map(|(prefix, area)| word.strip_prefix(prefix).map(|rest| (area, rest)))?;
    let data = matches!(area, Area::SharedData | Area::InstanceData);
    let peripheral = matches!(area, Area::PeripheralInput | Area::PeripheralOutput);
    let width = match rest {
        "" if !data && !peripheral => Width::Bit,
        "X" if !peripheral => Width::Bit,
        "B" => Width::Byte,
        "W" => Width::Word,
        "D" => Width::DoubleWord,
        _ => return None,
    };
    // `ID` is the double word of the inputs; `DID` and `DIX` begin with the longer prefix.
    Some((area, width))
}

/// `SFC -4`: a system function of extended programs.
fn parse_negative(block: &str, number: &str) -> Option<crate::block::BlockId> {
    let kind = crate::block::BlockKind::from_abbreviation(block)?;
    let number: i16 = parse_number(number)?;
    let block = crate::block::BlockId::new(kind, number.checked_neg()? as u16);
    crate::extension::CALLED.contains(&block).then_some(block)
}

fn parse_number<T: std::str::FromStr>(text: &str) -> Option<T> {
    if text.is_empty() || !text.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    text.parse().ok()
}
