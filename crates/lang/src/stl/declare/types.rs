//! Types as written in STL → types with a layout.

use std::collections::HashSet;
use std::sync::Arc;

use sieben_model::address;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Field, STRING_LENGTH_MAX, Structure, place};

use crate::declarations::reuse::Knows;
use crate::declarations::types::{Types, describe};
use crate::declarations::values::{Misfit, coerce};
use crate::declarations::{BLOCK_BYTES_MAX, NESTING_MAX};
use crate::scope::{did_you_mean, key};
use crate::stl::ast;

/// Dimensions an array may have.
const DIMENSIONS_MAX: usize = 6;

/// Types of other languages and of later controllers, and what an S7-300/400 has for them.
const ELSEWHERE: &[(&str, &str)] = &[
    ("INTEGER", "`INT`"),
    ("BOOLEAN", "`BOOL`"),
    ("BIT", "`BOOL`"),
    ("FLOAT", "`REAL`"),
    ("DOUBLE", "`REAL`"),
    ("LREAL", "`REAL`"),
    ("SINT", "`INT`"),
    ("USINT", "`BYTE` or `INT`"),
    ("UINT", "`WORD` or `DINT`"),
    ("UDINT", "`DWORD` or `DINT`"),
    ("LINT", "`DINT`"),
    ("LWORD", "an array of two `DWORD`"),
    ("LTIME", "`TIME`"),
    ("WSTRING", "`STRING`"),
    ("VARIANT", "`ANY`"),
];

/// Where a type stands, which decides what it may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Usage {
    /// A variable of this section of a block of this kind.
    Variable(BlockKind, Section),
    /// A field of a STRUCT, or an element of an array.
    Field,
}

/// The structure of a user-defined type of STL.
pub(super) fn user_defined<K: Knows>(types: &mut Types<'_, K>, id: BlockId, block: &ast::Block) -> Option<Arc<Structure>> {
    match &block.body_type {
        Some(ast::TypeName { kind: ast::TypeKind::Struct(fields), span }) => types.structure(fields, Some(id.to_string()), *span),
        Some(other) => match types.data_type(other, Usage::Field) {
            Some(DataType::Struct(structure)) => Some(structure),
            Some(_) => {
                types.report(Problem::P2210, other.span, "a TYPE consists of a STRUCT");
                None
            }
            None => None,
        },
        None => {
            types.report(Problem::P2210, block.name.span(), format!("`{id}` has no STRUCT"));
            None
        }
    }
}

impl<K: Knows> Types<'_, K> {
    /// The type as written, with its layout; `None` if something was wrong with it (which is reported).
    pub(super) fn data_type(&mut self, name: &ast::TypeName, usage: Usage) -> Option<DataType> {
        if !self.enter(name.span) {
            return None;
        }
        let data_type = self.data_type_inside(name, usage);
        self.leave();
        let data_type = data_type?;
        if let Some(why) = misplaced(&data_type, usage) {
            let message = format!("{} may not stand here: {why}", describe(&data_type));
            self.report(Problem::P4009, name.span, message);
            return None;
        }
        Some(data_type)
    }

    fn data_type_inside(&mut self, name: &ast::TypeName, usage: Usage) -> Option<DataType> {
        let span = name.span;
        match &name.kind {
            ast::TypeKind::Missing => None,
            ast::TypeKind::Word(word) => match DataType::from_word(word) {
                Some(data_type) => Some(data_type),
                None => self.type_of_symbol(word, span),
            },
            ast::TypeKind::String(None) => Some(DataType::String(STRING_LENGTH_MAX)),
            ast::TypeKind::String(Some(length)) => match u8::try_from(*length) {
                Ok(length @ 0..=STRING_LENGTH_MAX) => Some(DataType::String(length)),
                _ => {
                    self.report(Problem::P4004, span, format!("a STRING has 0 to 254 characters, not {length}"));
                    None
                }
            },
            ast::TypeKind::Array { bounds, element } => {
                let element = self.data_type(element, Usage::Field);
                let bounds = self.bounds(bounds, span)?;
                let element = element?;
                if matches!(element, DataType::Instance { .. }) && usage == Usage::Field {
                    return None;
                }
                let array = DataType::Array { bounds, element: Box::new(element) };
                if array.bits() > BLOCK_BYTES_MAX * 8 {
                    let message = format!("this array needs {} bytes; a block has at most {BLOCK_BYTES_MAX}", array.bits().div_ceil(8));
                    self.report(Problem::P5002, span, message);
                    return None;
                }
                Some(array)
            }
            ast::TypeKind::Struct(fields) => self.structure(fields, None, span).map(DataType::Struct),
            ast::TypeKind::Block(kind, number) => match u16::try_from(*number) {
                Ok(number) => self.type_of_block(BlockId::new(*kind, number), span),
                Err(_) => {
                    let message = format!("`{} {number}` has a number above 65535", kind.abbreviation());
                    self.report(Problem::P3015, span, message);
                    None
                }
            },
            ast::TypeKind::Symbol(symbol) => self.type_of_symbol(symbol, span),
        }
    }

    fn type_of_symbol(&mut self, symbol: &str, span: Span) -> Option<DataType> {
        if let Some(block) = self.scope.block(symbol) {
            return self.type_of_block(block, span);
        }
        let nearest =
            self.scope.nearest(symbol, DataType::words().chain(["ARRAY", "STRUCT"])).or_else(|| self.scope.nearest_symbol(symbol));
        let elsewhere = ELSEWHERE.iter().find(|(word, _)| symbol.eq_ignore_ascii_case(word));
        let message = format!("there is no type `{symbol}`{}", did_you_mean(nearest));
        let diagnostic = self.report(Problem::P3015, span, message);
        diagnostic.may_be_elsewhere = elsewhere.is_none();
        diagnostic.help = elsewhere.map(|(_, own)| format!("An S7-300/400 has {own} instead."));
        None
    }

    fn bounds(&mut self, bounds: &[(i64, i64)], span: Span) -> Option<Vec<(i32, i32)>> {
        if bounds.is_empty() || bounds.len() > DIMENSIONS_MAX {
            let message = format!("an array has 1 to {DIMENSIONS_MAX} dimensions, not {}", bounds.len());
            self.report(Problem::P4004, span, message);
            return None;
        }
        let mut checked = Vec::with_capacity(bounds.len());
        for &(low, high) in bounds {
            // An index beyond 16 bits cannot be written anywhere; the size is judged first, because it is what the user got wrong.
            let (Ok(low_index), Ok(high_index)) = (i16::try_from(low), i16::try_from(high)) else {
                let count = i128::from(high) - i128::from(low) + 1;
                if count > i128::from(BLOCK_BYTES_MAX) * 8 {
                    let message = format!("an array of {count} elements is larger than a block of {BLOCK_BYTES_MAX} bytes");
                    self.report(Problem::P5002, span, message);
                } else {
                    let message = format!("array bounds lie between -32768 and 32767, not {low}..{high}");
                    self.report(Problem::P4004, span, message);
                }
                return None;
            };
            if low > high {
                let message = format!("the lower array bound {low} is above the upper bound {high}");
                self.report(Problem::P4004, span, message);
                return None;
            }
            checked.push((i32::from(low_index), i32::from(high_index)));
        }
        Some(checked)
    }

    /// The fields of a STRUCT, one behind the other.
    pub(super) fn structure(&mut self, declarations: &[ast::Declaration], name: Option<String>, span: Span) -> Option<Arc<Structure>> {
        let mut structure = Structure { name, ..Structure::default() };
        let mut names = HashSet::new();
        let mut cursor = 0;
        let mut whole = true;
        for declaration in declarations {
            let Some(data_type) = self.data_type(&declaration.data_type, Usage::Field) else {
                whole = false;
                continue;
            };
            let initial = self.initial(&declaration.initial, &data_type);
            for word in &declaration.names {
                if !names.insert(key(&word.text)) {
                    self.report(Problem::P3006, word.span, format!("`{}` is declared twice in this STRUCT", word.text));
                    continue;
                }
                let (offset, behind) = place(cursor, &data_type);
                cursor = behind;
                if cursor > BLOCK_BYTES_MAX * 8 {
                    let message = format!("with `{}` this STRUCT is larger than {BLOCK_BYTES_MAX} bytes", word.text);
                    self.report(Problem::P5002, word.span, message);
                    return None;
                }
                structure.fields.push(Field {
                    name: word.text.clone(),
                    data_type: data_type.clone(),
                    offset: offset as u32,
                    initial: initial.clone(),
                    comment: declaration.comment.clone(),
                });
            }
        }
        if whole { self.closed(structure, cursor, span) } else { None }
    }

    /// Initial values as canonical values of the type, one per array element.
    pub(super) fn initial(&mut self, initial: &[ast::Initial], data_type: &DataType) -> Vec<Value> {
        if initial.is_empty() {
            return Vec::new();
        }
        let element = match data_type {
            DataType::Array { element, .. } => element,
            other => other,
        };
        let mut values = Vec::new();
        let mut room = Room { left: data_type.elements().min(BLOCK_BYTES_MAX * 8) as usize, full: None };
        for one in initial {
            self.expand(one, element, &mut values, &mut room, 0);
        }
        if let Some(span) = room.full {
            let message = match data_type {
                DataType::Array { .. } => format!("more initial values than the {} elements of the array", data_type.elements()),
                _ => "more than one initial value for one variable".to_owned(),
            };
            self.report(Problem::P4007, span, message);
        }
        values
    }

    fn expand(&mut self, initial: &ast::Initial, element: &DataType, values: &mut Vec<Value>, room: &mut Room, depth: usize) {
        match initial {
            ast::Initial::Value(constant) => {
                if room.left == 0 {
                    room.full.get_or_insert(constant.span);
                    return;
                }
                if let Some(value) = self.fitting(constant, element) {
                    room.left -= 1;
                    values.push(value);
                }
            }
            ast::Initial::Number { operand, span } => {
                if room.left == 0 {
                    room.full.get_or_insert(*span);
                    return;
                }
                if let Some(value) = self.number_of(operand, element, *span) {
                    room.left -= 1;
                    values.push(value);
                }
            }
            ast::Initial::Repeat { count, values: group, span } => {
                if depth >= NESTING_MAX {
                    self.report(Problem::P4008, *span, format!("repeated values are nested deeper than {NESTING_MAX} levels"));
                    return;
                }
                let before = values.len();
                let problems = self.diagnostics.len();
                if *count > 0 {
                    for one in group {
                        self.expand(one, element, values, room, depth + 1);
                    }
                }
                let once: Vec<Value> = values[before..].to_vec();
                if once.is_empty() || self.diagnostics.len() > problems || *count < 2 {
                    return;
                }
                for _ in 1..*count {
                    if room.left < once.len() {
                        let fitting = room.left;
                        values.extend_from_slice(&once[..fitting]);
                        room.left = 0;
                        room.full.get_or_insert(*span);
                        return;
                    }
                    values.extend_from_slice(&once);
                    room.left -= once.len();
                }
            }
        }
    }

    /// The number of a timer, a counter or a block as the value of a variable of that type, or a diagnostic.
    fn number_of(&mut self, operand: &ast::Operand, data_type: &DataType, span: Span) -> Option<Value> {
        let named = match operand {
            ast::Operand::Absolute { letters, number, bit: None } => Some((letters.clone(), *number)),
            ast::Operand::Symbol { name, path } if path.is_empty() => {
                let Some(global) = self.scope.global(&name.text) else {
                    let nearest = did_you_mean(self.scope.nearest_symbol(&name.text));
                    self.report(Problem::P3001, span, format!("`\"{}\"` is not in the symbol table{nearest}", name.text));
                    return None;
                };
                match &global.operand {
                    Some(address::Operand::Timer(number)) => Some(("T".to_owned(), u64::from(*number))),
                    Some(address::Operand::Counter(number)) => Some(("C".to_owned(), u64::from(*number))),
                    Some(address::Operand::Block(block)) => Some((block.kind.abbreviation().to_owned(), u64::from(block.number))),
                    _ => None,
                }
            }
            _ => None,
        };
        let letters: &[&str] = match data_type {
            DataType::Timer => &["T"],
            DataType::Counter => &["C", "Z"],
            DataType::BlockFunction => &["FC", "SFC"],
            DataType::BlockFunctionBlock => &["FB", "SFB"],
            DataType::BlockData => &["DB"],
            DataType::BlockSystemData => &["SDB", "DB"],
            _ => &[],
        };
        match named {
            Some((written, number)) if letters.contains(&written.as_str()) => match u16::try_from(number) {
                Ok(number) => Some(Value::Word(number)),
                Err(_) => {
                    self.report(Problem::P4001, span, format!("`{written} {number}` has a number above 65535"));
                    None
                }
            },
            _ => {
                let message = format!("this is no value of type {}; write {}", describe(data_type), example(data_type));
                self.report(Problem::P4006, span, message);
                None
            }
        }
    }

    /// The constant as a value of the type, or a diagnostic.
    pub(super) fn fitting(&mut self, constant: &ast::Constant, data_type: &DataType) -> Option<Value> {
        let value = constant.value.as_ref()?;
        if constant.extended && !self.scope.extended {
            let message = "this constant is written as only extended programs may, and this program is not extended";
            self.report(Problem::P2040, constant.span, message);
            return None;
        }
        match coerce(value, data_type) {
            Ok(value) => Some(value),
            Err(Misfit::Type) => {
                let message = match data_type {
                    DataType::Struct(_) | DataType::Instance { .. } | DataType::Array { .. } => {
                        format!("{} takes no value as a whole; give one to each of its fields", describe(data_type))
                    }
                    _ => format!("this constant is not one of type {}; write {}", describe(data_type), example(data_type)),
                };
                self.report(Problem::P4006, constant.span, message);
                None
            }
            Err(Misfit::Range) => {
                self.report(Problem::P4001, constant.span, format!("this constant is outside the range of {}", describe(data_type)));
                None
            }
        }
    }
}

/// How many values an array still takes, and where there was one too many.
struct Room {
    left: usize,
    full: Option<Span>,
}

/// Why the type may not stand here, if it may not.
fn misplaced(data_type: &DataType, usage: Usage) -> Option<&'static str> {
    let parameter = matches!(usage, Usage::Variable(_, Section::Input | Section::Output | Section::InOut));
    Some(match data_type {
        DataType::Void => "it is only the result of a function",
        passed if !parameter && (passed.is_number() || *passed == DataType::Pointer) => {
            "it is only for parameters (VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT)"
        }
        DataType::Any if !parameter && !matches!(usage, Usage::Variable(_, Section::Temp)) => "it is only for parameters and VAR_TEMP",
        DataType::Instance { .. } if usage != Usage::Variable(BlockKind::FunctionBlock, Section::Static) => {
            "an instance of a function block can only be declared under VAR of a FUNCTION_BLOCK"
        }
        _ => return None,
    })
}

/// A constant of the type, as an example.
fn example(data_type: &DataType) -> &'static str {
    match data_type {
        DataType::Bool => "`TRUE` or `FALSE`",
        DataType::Byte => "for example `B#16#1F`",
        DataType::Char => "for example `'A'`",
        DataType::Word => "for example `W#16#1F`",
        DataType::Int => "for example `5`",
        DataType::DoubleWord => "for example `DW#16#1F`",
        DataType::DoubleInt => "for example `L#5`",
        DataType::Real => "for example `1.5`",
        DataType::Date => "for example `D#2024-01-31`",
        DataType::TimeOfDay => "for example `TOD#12:30:0`",
        DataType::Time => "for example `T#5S`",
        DataType::S5Time => "for example `S5T#5S`",
        DataType::DateAndTime => "for example `DT#2024-01-31-12:30:0`",
        DataType::String(_) => "for example `'text'`",
        DataType::Pointer => "for example `P#DB5.DBX 0.0`",
        DataType::Any => "for example `P#DB5.DBX 0.0 BYTE 10`",
        DataType::Timer => "for example `T 5`",
        DataType::Counter => "for example `C 5`",
        DataType::BlockFunction => "for example `FC 5`",
        DataType::BlockFunctionBlock => "for example `FB 5`",
        DataType::BlockData => "for example `DB 5`",
        DataType::BlockSystemData => "for example `SDB 5`",
        _ => "a variable",
    }
}
