//! Reads names: addresses in either mnemonic language, registers, symbols, fields of data blocks, variables of blocks.

use sieben_engine::Program;
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Operand};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::item::{Item, Local};
use sieben_model::literal::{self, Value};
use sieben_model::symbols::SymbolTable;
use sieben_model::types::{DataType, Structure};

use super::NameError;
use super::local::{self, Scope};

/// Names of the status bits, in either mnemonic language.
pub(super) const STATUS_NAMES: &[(&str, Register)] = &[
    ("BR", Register::Br),
    ("BIE", Register::Br),
    ("CC1", Register::Cc1),
    ("A1", Register::Cc1),
    ("CC0", Register::Cc0),
    ("A0", Register::Cc0),
    ("OV", Register::Ov),
    ("OS", Register::Os),
    ("OR", Register::Or),
    ("STA", Register::Sta),
    ("RLO", Register::Rlo),
    ("VKE", Register::Rlo),
    ("/FC", Register::Fc),
    ("FC", Register::Fc),
    ("/ER", Register::Fc),
    ("ER", Register::Fc),
];

/// Names of the other registers.
const REGISTER_NAMES: &[(&str, Register)] = &[
    ("ACCU1", Register::Accu1),
    ("ACCU2", Register::Accu2),
    ("ACCU3", Register::Accu3),
    ("ACCU4", Register::Accu4),
    ("AR1", Register::Ar1),
    ("AR2", Register::Ar2),
    ("DBNO", Register::DbNumber),
    ("DBLG", Register::DbLength),
    ("DINO", Register::DiNumber),
    ("DILG", Register::DiLength),
];

/// The code of BYTE in an ANY.
const BYTES: u8 = 2;

/// What the status bits are called in German, beside what they are called here.
const GERMAN_STATUS_NAMES: &[(&str, &str)] = &[("BIE", "BR"), ("A1", "CC1"), ("A0", "CC0"), ("VKE", "RLO"), ("/ER", "/FC"), ("ER", "/FC")];

/// Why a text that is almost an address is none: a bit number above 7.
fn bit_above_seven(text: &str) -> Option<NameError> {
    let (byte, bit) = text.rsplit_once('.')?;
    let above = bit.parse::<u32>().is_ok_and(|bit| bit > 7);
    let address = Operand::parse(&format!("{byte}.0"));
    (above && matches!(address, Some(Operand::Address(_) | Operand::InDataBlock { .. })))
        .then(|| NameError::new(format!("`{text}` has a bit number above 7; the bits of a byte are 0 to 7")))
}

/// A register, timer, counter or address; `None` if it is none of them.
pub(super) fn absolute(text: &str) -> Result<Option<Item>, NameError> {
    let plain: String = text.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase();
    if plain == "STW" {
        return Ok(Some(Item::status()));
    }
    if let Some(bit) = plain.strip_prefix("STW.") {
        let german = GERMAN_STATUS_NAMES.iter().find(|&&(german, _)| german == bit);
        let bit = german.map_or(bit, |&(_, english)| english);
        return match STATUS_NAMES.iter().find(|&&(name, _)| name == bit) {
            Some(&(_, register)) => Ok(Some(Item::register(register))),
            None => {
                let message = format!("the status word has no bit `{bit}`; its bits are BR, CC1, CC0, OV, OS, OR, STA, RLO and /FC");
                Err(NameError::new(message))
            }
        };
    }
    let register = plain.strip_prefix("AKKU").map_or_else(|| plain.clone(), |number| format!("ACCU{number}"));
    if let Some(&(_, register)) = REGISTER_NAMES.iter().find(|&&(name, _)| name == register) {
        return Ok(Some(Item::register(register)));
    }
    if let Some(timer) = plain.strip_suffix(".Q")
        && let Some(Operand::Timer(number)) = Operand::parse(timer)
    {
        return Ok(Some(Item::timer_status(number)));
    }
    if plain.starts_with("P#") {
        return bytes(text).map(Some);
    }
    match Operand::parse(&plain) {
        Some(Operand::Block(block)) => {
            Err(NameError::new(format!("`{block}` is a block, which has no value; name an address or a field in it")))
        }
        Some(operand) => Ok(Some(Item::operand(operand))),
        None => Ok(None),
    }
}

/// `P#M 10.0 BYTE 20`, `P#DB1.DBX 0.0 BYTE 20`: bytes of an area or of a data block.
fn bytes(text: &str) -> Result<Item, NameError> {
    let wrong = || NameError::new(format!("`{text}` names no bytes; write `P#M 10.0 BYTE 20`, `P#DB1.DBX 0.0 BYTE 20`, or I or Q"));
    let Ok(Value::Any([_, data_type, count @ .., area, first_1, first_2, first_3])) = literal::parse(text) else { return Err(wrong()) };
    let [count_1, count_2, db_1, db_2] = count;
    let length = u32::from(u16::from_be_bytes([count_1, count_2]));
    let position = u32::from_be_bytes([0, first_1, first_2, first_3]);
    let areas = [Area::Input, Area::Output, Area::BitMemory, Area::SharedData];
    let area = areas.into_iter().find(|known| known.pointer_code() == area).ok_or_else(wrong)?;
    if data_type != BYTES || !position.is_multiple_of(8) || length == 0 {
        return Err(wrong());
    }
    Ok(match area {
        Area::SharedData => Item::data(u16::from_be_bytes([db_1, db_2]), position / 8, length),
        area => Item::area(area, position / 8, length),
    })
}

/// A variable that the program calls by this name alone, or a field of a data block with a name.
pub(super) fn named(text: &str, program: &Program) -> Result<Option<Item>, NameError> {
    let names = &program.names;
    if names.open.is_empty() && names.blocks.is_empty() && names.located.is_empty() {
        return Ok(None);
    }
    if let Some((operand, data_type)) = names.located.get(&text.trim_matches('"').to_lowercase()) {
        return Ok(Some(Item::typed(*operand, Some(data_type))));
    }
    let found = names.open.iter().find_map(|number| {
        let (offset, data_type) = field(&program.data.get(number)?.structure, text).ok()?;
        Some((*number, offset, data_type))
    });
    let (first, path) = split_first(text);
    let in_block = || {
        let number = *names.blocks.get(&first.to_lowercase())?;
        let (offset, data_type) = field(&program.data.get(&number)?.structure, path).ok()?;
        Some((number, offset, data_type))
    };
    match found.or_else(in_block) {
        Some((number, offset, data_type)) => item_of_field(number, offset, &data_type, text).map(Some),
        None => Ok(None),
    }
}

/// A symbol, or a field of a data block.
pub(super) fn symbolic(text: &str, symbols: &SymbolTable, program: &Program) -> Result<Item, NameError> {
    if let Some(error) = bit_above_seven(text) {
        return Err(error);
    }
    let (first, path) = split_first(text);
    if path.is_empty()
        && let Some(symbol) = symbols.find(first)
    {
        return match symbol.operand() {
            Some(Operand::Block(block)) => Err(NameError::new(format!("`{text}` is {block}, which has no value; name a field in it"))),
            Some(operand) => {
                Ok(Item::typed(operand, DataType::from_word(symbol.data_type.trim()).filter(DataType::is_elementary).as_ref()))
            }
            None => Err(NameError::new(format!("the symbol `{text}` has the address `{}`, which is none", symbol.address))),
        };
    }
    // The name of a status bit by itself, where nothing else has it.
    if path.is_empty()
        && let Some(bit) = absolute(&format!("STW.{text}")).unwrap_or_default()
    {
        return Ok(bit);
    }
    let block = match (symbols.operand(first), Operand::parse(first)) {
        (Some(Operand::Block(block)), _) | (None, Some(Operand::Block(block))) => Some(block),
        _ => None,
    };
    let Some(BlockId { kind: BlockKind::DataBlock, number }) = block.filter(|_| !path.is_empty()) else {
        return Err(NameError::new(format!(
            "nothing is called `{text}`; write an address such as `I 0.0`, `MW 10`, `T 1` or `DB1.DBW 0`, a symbol, `DB1.name`, or one of `ACCU1`, `AR1`, `STW`, `STW.RLO`"
        )));
    };
    // `"Data".DBW 2`: the symbol stands for the block.
    if let Some(operand @ Operand::InDataBlock { .. }) = Operand::parse(&format!("DB{number}.{path}")) {
        return Ok(Item::operand(operand));
    }
    let Some(data) = program.data.get(&number) else {
        return Err(NameError::new(format!("the program has no `DB {number}`, which `{text}` wants")));
    };
    let (offset, data_type) = field(&data.structure, path).map_err(|part| {
        let names: Vec<&str> = data.structure.fields.iter().take(8).map(|field| field.name.as_str()).collect();
        NameError::new(format!("`DB {number}` has no `{part}`; its fields begin with {}", names.join(", ")))
    })?;
    item_of_field(number, offset, &data_type, text)
}

fn item_of_field(db: u16, offset: u32, data_type: &DataType, text: &str) -> Result<Item, NameError> {
    if matches!(data_type, DataType::Array { .. } | DataType::Struct(_) | DataType::Instance { .. }) {
        return Err(NameError::new(format!("`{text}` is no single value; name one of its elements, such as `[1]` or `.name`")));
    }
    Ok(Item::field(db, offset, data_type))
}

/// Splits `"a name".path` and `name.path`.
fn split_first(text: &str) -> (&str, &str) {
    if let Some(quoted) = text.strip_prefix('"') {
        let (first, rest) = quoted.split_once('"').unwrap_or((quoted, ""));
        return (first, rest.strip_prefix('.').unwrap_or(rest));
    }
    text.split_once('.').unwrap_or((text, ""))
}

/// Offset in bits and type of `a.b[3].c` in a structure; the part that does not exist if it has none.
fn field<'a>(structure: &Structure, path: &'a str) -> Result<(u32, DataType), &'a str> {
    let (head, rest) = path.split_at(path.find(['.', '[']).unwrap_or(path.len()));
    let head_field = structure.field(head.trim().trim_matches('"')).ok_or(path)?;
    let (offset, data_type) = reach(head_field.data_type.clone(), rest).map_err(|_| path)?;
    Ok((head_field.offset.saturating_add(offset), data_type))
}

/// Offset in bits and type of what `.b[3].c` means behind something of a type; the part that does not exist if there is none.
pub(super) fn reach(mut data_type: DataType, path: &str) -> Result<(u32, DataType), &str> {
    let (mut offset, mut rest) = (0_u64, path);
    while let Some(bracket) = rest.strip_prefix('[') {
        let (indices, behind) = bracket.split_once(']').ok_or(path)?;
        let DataType::Array { element, .. } = &data_type else { return Err(path) };
        let indices: Vec<i64> = indices.split(',').map(|index| index.trim().parse().map_err(|_| path)).collect::<Result<_, _>>()?;
        let number = data_type.element_number(&indices).ok_or(path)?;
        offset = offset.saturating_add(data_type.element_offset(number));
        data_type = (**element).clone();
        rest = behind;
    }
    let offset = u32::try_from(offset).map_err(|_| path)?;
    match (rest.strip_prefix('.'), &data_type) {
        (None, _) if rest.is_empty() => Ok((offset, data_type)),
        (Some(inner), DataType::Struct(structure) | DataType::Instance { structure, .. }) => {
            let (inner_offset, data_type) = field(structure, inner)?;
            Ok((offset.saturating_add(inner_offset), data_type))
        }
        _ => Err(path),
    }
}

/// A variable of a block: `#x` of the block that the scope names, `FC 1.#x` of this one. `None` if the text is none.
pub(super) fn local(text: &str, scope: Option<Scope>, symbols: &SymbolTable, program: &Program) -> Result<Option<Local>, NameError> {
    if let Some(path) = text.strip_prefix('#') {
        let Some(scope) = scope else {
            return Err(NameError::new(format!("`{text}` is a variable of a block, and here is none; name the block: `FC 1.{text}`")));
        };
        return local::parse(scope.block, path, program).map(Some);
    }
    if let Some((first, path)) = text.split_once(".#") {
        let name = first.trim().trim_matches('"');
        let block = match symbols.operand(name).or_else(|| Operand::parse(first.trim())) {
            Some(Operand::Block(block)) => block,
            _ => return Err(NameError::new(format!("`{first}` is no block; write `FC 1.#{path}` or `\"name\".#{path}`"))),
        };
        return local::parse(block, path, program).map(Some);
    }
    if let (Some(scope), Some(address)) = (scope, local::address(text)) {
        return Ok(Some(local::at(scope.block, address)));
    }
    let head = &text[..text.find(['.', '[']).unwrap_or(text.len())];
    let declares = |scope: &Scope| program.code.get(&scope.block).is_some_and(|code| code.interface.variable(head).is_some());
    match scope.filter(|scope| scope.bare && declares(scope)) {
        Some(scope) => local::parse(scope.block, text, program).map(Some),
        None => Ok(None),
    }
}
