//! Constants: their values and how they are written.

/// The value of a constant, by the type its notation gives it.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The variants are the manual's own names.
pub enum Value {
    Bool(bool),
    /// A signed 16-bit integer without prefix.
    Int(i16),
    /// `L#`.
    DoubleInt(i32),
    Real(f32),
    /// `B#16#`.
    Byte(u8),
    /// `W#16#`, `2#` up to 16 digits, `C#`, `B#(a,b)`.
    Word(u16),
    /// `DW#16#`, `2#` of more digits, `B#(a,b,c,d)`.
    DoubleWord(u32),
    /// One to four characters, code page 1252.
    Characters(Vec<u8>),
    /// `S5T#` as its word.
    S5Time(u16),
    /// `C#` as its BCD word.
    Counter(u16),
    /// `T#` in milliseconds.
    Time(i32),
    /// `D#` in days since 1990-01-01.
    Date(u16),
    /// `TOD#` in milliseconds since midnight.
    TimeOfDay(u32),
    /// `DT#` as its eight bytes.
    DateAndTime([u8; 8]),
    /// `P#...` area-internal (bit 31 = 0) or area-crossing.
    Pointer(u32),
    /// `P#DB10.DBX 12.0` as a POINTER with a DB number, and `P#... REAL 20` as an ANY.
    DataPointer {
        db: u16,
        pointer: u32,
    },
    Any([u8; 10]),
}
