//! Bytes of source files ⇄ text: UTF-8, UTF-16 and the code pages of STEP 7.

use std::fmt;

use encoding_rs::{WINDOWS_1250, WINDOWS_1251, WINDOWS_1252};
use sieben_model::problems::Problem;

/// Largest source that is read: beyond it, a file is not a source but a mistake.
pub const MAX_SOURCE_BYTES: usize = 64 << 20;

/// How a file's bytes mean characters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8 without byte order mark; plain ASCII counts as this.
    #[default]
    Utf8,
    /// UTF-8 with byte order mark, as TIA exports.
    Utf8Bom,
    /// UTF-16, low byte first, with byte order mark.
    Utf16Le,
    /// UTF-16, high byte first, with byte order mark.
    Utf16Be,
    /// Windows code page 1250: Central European.
    Cp1250,
    /// Windows code page 1251: Cyrillic.
    Cp1251,
    /// Windows code page 1252: Western European.
    Cp1252,
}

impl Encoding {
    /// All encodings.
    pub const ALL: [Self; 7] = [Self::Utf8, Self::Utf8Bom, Self::Utf16Le, Self::Utf16Be, Self::Cp1250, Self::Cp1251, Self::Cp1252];

    /// The name that users write: `utf-8`, `cp1252`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "utf-8",
            Self::Utf8Bom => "utf-8-bom",
            Self::Utf16Le => "utf-16le",
            Self::Utf16Be => "utf-16be",
            Self::Cp1250 => "cp1250",
            Self::Cp1251 => "cp1251",
            Self::Cp1252 => "cp1252",
        }
    }

    /// The encoding with this name, without regard to case and hyphens; `windows-1252` and `1252` are `cp1252`.
    pub fn from_name(name: &str) -> Option<Self> {
        let plain = |text: &str| text.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_lowercase();
        let wanted = plain(name);
        let wanted = wanted.strip_prefix("windows").or_else(|| wanted.strip_prefix("cp")).unwrap_or(&wanted);
        Self::ALL.into_iter().find(|encoding| {
            let known = plain(encoding.name());
            known.strip_prefix("cp").unwrap_or(&known) == wanted
        })
    }

    /// The table of a code page.
    fn code_page(self) -> Option<&'static encoding_rs::Encoding> {
        match self {
            Self::Cp1250 => Some(WINDOWS_1250),
            Self::Cp1251 => Some(WINDOWS_1251),
            Self::Cp1252 => Some(WINDOWS_1252),
            _ => None,
        }
    }

    /// The byte order mark that files in this encoding begin with.
    fn mark(self) -> &'static [u8] {
        match self {
            Self::Utf8Bom => &[0xEF, 0xBB, 0xBF],
            Self::Utf16Le => &[0xFF, 0xFE],
            Self::Utf16Be => &[0xFE, 0xFF],
            _ => &[],
        }
    }
}

/// A text and how it was encoded; line ends are as they came.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Decoded {
    /// The text without byte order mark.
    pub text: String,
    /// How it was encoded; [`encode`] with it gives the bytes back, if there were no errors.
    pub encoding: Encoding,
    /// Some bytes mean nothing in this encoding; U+FFFD or a control character stands for them.
    pub had_errors: bool,
}

/// Why bytes are not taken as a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unreadable {
    /// NUL bytes or many control characters.
    Binary,
    /// More than [`MAX_SOURCE_BYTES`].
    TooLarge,
}

impl Unreadable {
    /// The problem of the table that belongs to it.
    pub fn problem(self) -> Problem {
        match self {
            Self::Binary => Problem::P1101,
            Self::TooLarge => Problem::P1104,
        }
    }
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Binary => write!(f, "this is a binary file, not a source text"),
            Self::TooLarge => write!(f, "this file is larger than the {} MiB that a source may have", MAX_SOURCE_BYTES >> 20),
        }
    }
}

/// A character that an encoding does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unencodable {
    /// The character.
    pub character: char,
    /// Its first byte in the text.
    pub position: usize,
    /// The encoding.
    pub encoding: Encoding,
}

impl fmt::Display for Unencodable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` does not exist in {}", self.character, self.encoding.name())
    }
}

/// Reads a source file: refuses what is too large or binary, detects the encoding of the rest.
pub fn read_source(bytes: &[u8]) -> Result<Decoded, Unreadable> {
    read_source_as(bytes, None)
}

/// Reads a source file in the encoding that the user chose; a byte order mark is no guess and wins over the choice.
pub fn read_source_as(bytes: &[u8], chosen: Option<Encoding>) -> Result<Decoded, Unreadable> {
    if bytes.len() > MAX_SOURCE_BYTES {
        return Err(Unreadable::TooLarge);
    }
    let chosen = chosen.filter(|_| marked(bytes).is_none());
    // Half of the bytes of UTF-16 are NUL; without its mark only the user can know.
    if !matches!(chosen, Some(Encoding::Utf16Le | Encoding::Utf16Be)) && looks_binary(bytes) {
        return Err(Unreadable::Binary);
    }
    Ok(match chosen {
        Some(encoding) => decode_as(bytes, encoding),
        None => decode(bytes),
    })
}

/// Whether bytes are no text: a NUL without a UTF-16 mark, or more than one control character in fifty bytes.
pub fn looks_binary(bytes: &[u8]) -> bool {
    if [Encoding::Utf16Le, Encoding::Utf16Be].iter().any(|encoding| bytes.starts_with(encoding.mark())) {
        return false;
    }
    if bytes.contains(&0) {
        return true;
    }
    // Tabulator, line ends, form feed and the end mark of DOS are text.
    let controls = bytes.iter().filter(|&&byte| (byte < 0x20 && !matches!(byte, 0x09..=0x0D | 0x1A)) || byte == 0x7F).count();
    controls > 1 + bytes.len() / 50
}

/// Detects the encoding and decodes.
pub fn decode(bytes: &[u8]) -> Decoded {
    decode_as(bytes, detect(bytes))
}

/// Decodes in the encoding that the user chose; a byte order mark of it is dropped.
pub fn decode_as(bytes: &[u8], encoding: Encoding) -> Decoded {
    let body = bytes.strip_prefix(encoding.mark()).unwrap_or(bytes);
    match encoding {
        Encoding::Utf8 | Encoding::Utf8Bom => {
            let text = String::from_utf8_lossy(body);
            let had_errors = matches!(text, std::borrow::Cow::Owned(_));
            Decoded { text: text.into_owned(), encoding, had_errors }
        }
        Encoding::Utf16Le => decode_utf16(body, encoding, u16::from_le_bytes),
        Encoding::Utf16Be => decode_utf16(body, encoding, u16::from_be_bytes),
        Encoding::Cp1250 | Encoding::Cp1251 | Encoding::Cp1252 => {
            let table = encoding.code_page().unwrap_or(WINDOWS_1252);
            let (text, had_errors) = table.decode_without_bom_handling(body);
            // The tables map a byte without meaning to the control character of the same number.
            let had_errors = had_errors || text.chars().any(|character| matches!(character, '\u{80}'..='\u{9F}'));
            Decoded { text: text.into_owned(), encoding, had_errors }
        }
    }
}

fn decode_utf16(body: &[u8], encoding: Encoding, unit: fn([u8; 2]) -> u16) -> Decoded {
    let (pairs, rest) = body.as_chunks::<2>();
    let mut had_errors = !rest.is_empty();
    let text = char::decode_utf16(pairs.iter().map(|&pair| unit(pair)))
        .map(|character| {
            character.unwrap_or_else(|_| {
                had_errors = true;
                char::REPLACEMENT_CHARACTER
            })
        })
        .collect();
    Decoded { text, encoding, had_errors }
}

/// Encodes a text; the first character that the encoding does not have is an error.
pub fn encode(text: &str, encoding: Encoding) -> Result<Vec<u8>, Unencodable> {
    let mut bytes = encoding.mark().to_vec();
    match (encoding, encoding.code_page()) {
        (Encoding::Utf16Le, _) => bytes.extend(text.encode_utf16().flat_map(u16::to_le_bytes)),
        (Encoding::Utf16Be, _) => bytes.extend(text.encode_utf16().flat_map(u16::to_be_bytes)),
        (_, Some(table)) => {
            let (encoded, _, unmappable) = table.encode(text);
            if unmappable && let Some(error) = first_unencodable(text, encoding, table) {
                return Err(error);
            }
            bytes.extend_from_slice(&encoded);
        }
        (_, None) => bytes.extend_from_slice(text.as_bytes()),
    }
    Ok(bytes)
}

fn first_unencodable(text: &str, encoding: Encoding, table: &'static encoding_rs::Encoding) -> Option<Unencodable> {
    let mut buffer = [0; 4];
    let (position, character) =
        text.char_indices().find(|&(_, character)| !character.is_ascii() && table.encode(character.encode_utf8(&mut buffer)).2)?;
    Some(Unencodable { character, position, encoding })
}

/// The encoding of a file by its mark, else by its bytes.
pub fn detect(bytes: &[u8]) -> Encoding {
    marked(bytes).unwrap_or_else(|| if mostly_utf8(bytes) { Encoding::Utf8 } else { detect_code_page(bytes) })
}

/// The encoding that a byte order mark names.
fn marked(bytes: &[u8]) -> Option<Encoding> {
    [Encoding::Utf8Bom, Encoding::Utf16Le, Encoding::Utf16Be].into_iter().find(|encoding| bytes.starts_with(encoding.mark()))
}

/// Valid UTF-8, or UTF-8 with a few broken bytes: at least ten good sequences for each bad one.
fn mostly_utf8(bytes: &[u8]) -> bool {
    let (mut good, mut bad) = (0_usize, 0_usize);
    for chunk in bytes.utf8_chunks() {
        good += chunk.valid().chars().filter(|character| !character.is_ascii()).count();
        bad += usize::from(!chunk.invalid().is_empty());
    }
    bad == 0 || good / 10 >= bad
}

/// Guesses the code page from the letters that the bytes would be.
///
/// German umlauts are the same bytes in 1250 and 1252, so that a wrong guess between these two shows only in other letters.
fn detect_code_page(bytes: &[u8]) -> Encoding {
    if looks_cyrillic(bytes) {
        return Encoding::Cp1251;
    }
    let mut central = 0_usize;
    let mut western = 0_usize;
    for (index, &byte) in bytes.iter().enumerate() {
        if byte < 0x80 {
            continue;
        }
        let inside_word = bytes.get(index + 1).is_some_and(|&next| next.is_ascii_alphabetic() || next >= 0x8A);
        match (byte, inside_word) {
            // š ž Š Ž are the same in both, but only Central European languages use them often; ť ź Ť Ź are no letters in 1252.
            (0x8A | 0x8E | 0x9A | 0x9E | 0x8D | 0x8F | 0x9D | 0x9F, _) => central += 3,
            // ł ą ż Ł Ą Ż ľ ş are ³ ¹ ¿ £ ¥ ¯ ¾ º in 1252, which do not stand before a letter; ě is ì, ś is œ.
            (0x8C | 0x9C | 0xA3 | 0xA5 | 0xAA | 0xAF | 0xB3 | 0xB9 | 0xBA | 0xBE | 0xBF | 0xEC, true) => central += 3,
            // ů is ù; ő is õ, which Portuguese has only before e.
            (0xF9, true) => central += 2,
            (0xF5, _) if bytes.get(index + 1) != Some(&b'e') => central += 2,
            // ř is ø, č is è, ď is ï: as likely as not.
            (0xF8 | 0xE8 | 0xEF, true) => {}
            // ² ³ å, and the letters of French, Italian, Spanish, Danish and Portuguese.
            (0xB2 | 0xB3 | 0xE5, _) => western += 2,
            (0xE0 | 0xE3 | 0xE6 | 0xE8 | 0xEA | 0xEC | 0xF1 | 0xF2 | 0xF5 | 0xF9 | 0xFB, _) => western += 1,
            _ => {}
        }
    }
    if central > western { Encoding::Cp1250 } else { Encoding::Cp1252 }
}

/// Cyrillic words are runs of high bytes; in Latin text such bytes stand alone or in pairs.
fn looks_cyrillic(bytes: &[u8]) -> bool {
    let is_letter = |byte: u8| matches!(byte, 0xC0..=0xFF | 0xA8 | 0xB8 | 0xB2 | 0xB3 | 0xAA | 0xAF | 0xBA | 0xBF);
    // Vowels without Я and я, whose bytes are ß and ÿ: a list of German umlauts is no Russian word.
    let is_vowel = |byte: u8| {
        matches!(byte, 0xE0 | 0xE5 | 0xE8 | 0xEE | 0xF3 | 0xFB | 0xFD | 0xFE | 0xC0 | 0xC5 | 0xC8 | 0xCE | 0xD3 | 0xDB | 0xDD | 0xDE | 0xB3)
    };
    let high = bytes.iter().filter(|&&byte| byte >= 0x80).count();
    let in_words: usize =
        bytes.split(|&byte| !is_letter(byte)).filter(|run| run.len() >= 3 && run.iter().any(|&byte| is_vowel(byte))).map(<[u8]>::len).sum();
    in_words * 2 > high
}

#[cfg(test)]
mod tests {
    use super::*;

    const GERMAN: &str = "// Behälter füllen, Größe 3 m³ bei 20 °C\r\nU E 0.0\r\n";
    const FRENCH: &str = "// Arrêt d'urgence : la vanne à côté est fermée, où le débit règne\r\n";
    const POLISH: &str = "// Załączenie pompy, jeśli zbiornik jest pusty; żółty\r\n";
    const CZECH: &str = "// Řízení čerpadla, když je nádrž prázdná, spustí se míchání\r\n";
    const RUSSIAN: &str = "// Пуск насоса, если уровень ниже 10 м³\r\n";

    #[test]
    fn texts_of_each_code_page_are_recognized_and_come_back_byte_for_byte() {
        for (text, encoding) in [
            (GERMAN, Encoding::Cp1252),
            (FRENCH, Encoding::Cp1252),
            ("ÄÖÜäöüß", Encoding::Cp1252),
            ("Ø 5 mm, à côté", Encoding::Cp1252),
            (POLISH, Encoding::Cp1250),
            (CZECH, Encoding::Cp1250),
            ("// Пуск насоса, если уровень ниже\r\n", Encoding::Cp1251),
            ("\"Двигатель\",\"A  4.0\"", Encoding::Cp1251),
            (GERMAN, Encoding::Utf8),
            (RUSSIAN, Encoding::Utf8Bom),
            (RUSSIAN, Encoding::Utf16Le),
            (CZECH, Encoding::Utf16Be),
            ("A I 0.0\r\n", Encoding::Utf8),
            ("", Encoding::Utf8),
        ] {
            let bytes = encode(text, encoding).unwrap_or_else(|error| panic!("{text}: {error}"));
            let decoded = read_source(&bytes).expect("a text");
            assert_eq!(decoded, Decoded { text: text.to_owned(), encoding, had_errors: false });
            assert_eq!(encode(&decoded.text, decoded.encoding).as_ref(), Ok(&bytes), "{text}");
        }
    }

    #[test]
    fn a_character_that_the_code_page_lacks_is_named_with_its_place() {
        let error = encode("m³ Ж", Encoding::Cp1252).expect_err("no Cyrillic in 1252");
        assert_eq!((error.character, error.position), ('Ж', 4));
        assert_eq!(error.to_string(), "`Ж` does not exist in cp1252");
    }

    #[test]
    fn binary_and_huge_files_are_refused() {
        assert_eq!(read_source(&[0x70, 0x70, 0x01, 0x00]), Err(Unreadable::Binary));
        assert_eq!(read_source(&[0x01; 100]), Err(Unreadable::Binary));
        assert_eq!(read_source(&vec![b' '; MAX_SOURCE_BYTES + 1]), Err(Unreadable::TooLarge));
        assert!(read_source(b"A I 0.0\r\n\x1A").is_ok());
    }

    #[test]
    fn broken_bytes_are_reported_and_the_rest_is_kept() {
        let mut bytes = GERMAN.repeat(10).into_bytes();
        bytes.push(0xE4);
        let decoded = decode(&bytes);
        assert_eq!((decoded.encoding, decoded.had_errors), (Encoding::Utf8, true));
        assert!(decode_as(&[0x81], Encoding::Cp1252).had_errors);
        assert!(decode_as(&[0xFF, 0xFE, 0x41], Encoding::Utf16Le).had_errors);
        assert!(decode_as(&[0xFF, 0xFE, 0x00, 0xD8], Encoding::Utf16Le).had_errors);
    }

    #[test]
    fn the_choice_of_the_user_beats_the_guess_but_not_the_mark() {
        let bytes = encode("// côté où", Encoding::Cp1252).expect("French letters");
        let chosen = |encoding| read_source_as(&bytes, Some(encoding)).expect("a text");
        assert_eq!(chosen(Encoding::Cp1250).text, "// côté oů");
        assert_eq!(chosen(Encoding::Cp1252).text, "// côté où");
        assert!(chosen(Encoding::Utf8).had_errors);
        let marked = encode("// ж", Encoding::Utf8Bom).expect("all of Unicode");
        assert_eq!(read_source_as(&marked, Some(Encoding::Cp1251)).expect("a text").text, "// ж");
        let unmarked = &encode("A I 0.0", Encoding::Utf16Le).expect("all of Unicode")[2..];
        assert_eq!(read_source(unmarked), Err(Unreadable::Binary));
        assert_eq!(read_source_as(unmarked, Some(Encoding::Utf16Le)).expect("a text").text, "A I 0.0");
    }

    #[test]
    fn every_encoding_is_found_by_its_name() {
        for encoding in Encoding::ALL {
            assert_eq!(Encoding::from_name(encoding.name()), Some(encoding));
        }
        assert_eq!(Encoding::from_name("Windows-1250"), Some(Encoding::Cp1250));
        assert_eq!(Encoding::from_name("1251"), Some(Encoding::Cp1251));
        assert_eq!(Encoding::from_name("UTF8"), Some(Encoding::Utf8));
        assert_eq!(Encoding::from_name("latin"), None);
    }
}
