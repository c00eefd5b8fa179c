//! Actual parameters: what stands for a formal one, by its type.

use std::sync::Arc;

use sieben_model::address::{Area, Width};
use sieben_model::block::BlockKind;
use sieben_model::interface::{Section, Variable};
use sieben_model::literal::{Value, any_type_code};
use sieben_model::problems::Problem;
use sieben_model::types::DataType;

use super::{Meaning, Resolver};
use crate::calling::pointers::{IN_DATA_BLOCK, any_type, bytes_of};
use crate::declarations::interface::is_complex;
use crate::declarations::types::describe;
use crate::declarations::values::{Misfit, coerce, natural};
use crate::stl::ast;
use crate::stl::operands::{Access, Actual, BlockOperand, Location, NumberOperand, Operand};

impl Resolver<'_> {
    /// What is passed for a parameter; `None` if it does not fit, which is reported.
    pub(super) fn actual(&mut self, argument: &ast::Argument, formal: &Variable) -> Option<Actual> {
        let span = argument.span;
        if let ast::Operand::PointerTo { target, span: at } = &argument.value
            && matches!(formal.data_type, DataType::Any | DataType::Pointer)
        {
            let (db, position, data_type) = self.pointed_to(target, *at, span)?;
            let pointer = IN_DATA_BLOCK | position;
            return Some(Actual::Constant(match formal.data_type {
                DataType::Pointer => Value::DataPointer { db, pointer },
                _ => any_of_variable(db, pointer, &data_type),
            }));
        }
        // System data blocks are named here and nowhere else.
        if let ast::Operand::Absolute { letters, number, bit: None } = &argument.value
            && letters == "SDB"
            && let Ok(number) = u16::try_from(*number)
        {
            match formal.data_type {
                DataType::Any => return Some(any_of_number(ANY_OF_SYSTEM_DATA, number)),
                DataType::BlockSystemData => return Some(Actual::Block(NumberOperand::Fixed(number))),
                _ => {}
            }
        }
        let meaning = self.meaning(&argument.value, span)?;
        // The declaration of the parameter was wrong, which is reported there.
        if formal.data_type == DataType::Void {
            return None;
        }
        let actual = match &formal.data_type {
            DataType::Timer => match meaning {
                Meaning::Operand(Operand::Timer(number)) => Ok(Actual::Timer(number)),
                _ => Err("a timer".to_owned()),
            },
            DataType::Counter => match meaning {
                Meaning::Operand(Operand::Counter(number)) => Ok(Actual::Counter(number)),
                _ => Err("a counter".to_owned()),
            },
            DataType::BlockFunction => block_actual(meaning, &[BlockKind::Function, BlockKind::SystemFunction], "an FC"),
            DataType::BlockFunctionBlock => block_actual(meaning, &[BlockKind::FunctionBlock, BlockKind::SystemFunctionBlock], "an FB"),
            DataType::BlockData | DataType::BlockSystemData => block_actual(meaning, &[BlockKind::DataBlock], "a data block"),
            DataType::Any => match meaning {
                Meaning::Operand(Operand::Constant(Value::Any(any))) => Ok(Actual::Constant(Value::Any(any))),
                Meaning::Operand(Operand::Timer(NumberOperand::Fixed(number))) => Ok(any_of_number(0x1D, number)),
                Meaning::Operand(Operand::Counter(NumberOperand::Fixed(number))) => Ok(any_of_number(0x1C, number)),
                Meaning::Operand(Operand::Block(block)) => self
                    .any_of_block(&block, &argument.value)
                    .ok_or_else(|| "a variable, a block with its number, or a pointer such as `P#DB5.DBX 0.0 BYTE 10`".to_owned()),
                other => self.whole(other).ok_or_else(|| "a variable or a pointer such as `P#DB5.DBX 0.0 BYTE 10`".to_owned()),
            },
            DataType::Pointer => match meaning {
                Meaning::Operand(Operand::Constant(value)) => match coerce(&value, &DataType::Pointer) {
                    Ok(value) => Ok(Actual::Constant(value)),
                    Err(_) => Err("a variable or a pointer such as `P#DB5.DBX 0.0`".to_owned()),
                },
                other => self.whole(other).ok_or_else(|| "a variable or a pointer such as `P#DB5.DBX 0.0`".to_owned()),
            },
            // Extended programs write constants here: they lie in the local data of the caller, or in the instance.
            complex
                if is_complex(complex)
                    && self.known.extended
                    && formal.section == Section::Input
                    && matches!(meaning, Meaning::Operand(Operand::Constant(_))) =>
            {
                match meaning {
                    Meaning::Operand(Operand::Constant(value)) => {
                        coerce(&value, complex).map(Actual::Constant).map_err(|misfit| match misfit {
                            Misfit::Range => format!("at most as many characters as a {} has", describe(complex)),
                            Misfit::Type => format!("a constant or variable of type {}", describe(complex)),
                        })
                    }
                    _ => unreachable!("the guard saw a constant"),
                }
            }
            complex if is_complex(complex) => match self.whole(meaning) {
                Some(Actual::Complex { location, data_type }) if same_layout(complex, &data_type) => {
                    Ok(Actual::Complex { location, data_type })
                }
                _ => Err(match complex {
                    DataType::String(_) => "a STRING variable of any length".to_owned(),
                    other => format!("a variable of type {}", describe(other)),
                }),
            },
            _ => return self.elementary_actual(argument, formal, meaning),
        };
        match actual {
            Ok(actual) => Some(actual),
            Err(wanted) => {
                self.mismatch(argument, formal, &wanted);
                // A constant is what most people try first.
                if is_complex(&formal.data_type)
                    && matches!(argument.value, ast::Operand::Constant(_))
                    && !self.known.extended
                    && let Some(diagnostic) = self.diagnostics.last_mut()
                {
                    diagnostic.help = Some(format!(
                        "The block gets a pointer, and a constant has no place: declare a {} with this initial value in a data block.",
                        describe(&formal.data_type)
                    ));
                }
                None
            }
        }
    }

    fn mismatch(&mut self, argument: &ast::Argument, formal: &Variable, wanted: &str) {
        let message = format!(
            "the parameter `{}` is {} and takes {wanted}, not `{}`",
            formal.name,
            describe(&formal.data_type),
            self.text(argument.span)
        );
        self.report(Problem::P4011, argument.span, message);
    }

    fn elementary_actual(&mut self, argument: &ast::Argument, formal: &Variable, meaning: Meaning) -> Option<Actual> {
        let span = argument.span;
        let width = formal.data_type.width()?;
        match meaning {
            Meaning::Operand(Operand::Constant(value)) => {
                if formal.section != Section::Input {
                    self.mismatch(argument, formal, "a variable that can be written");
                    return None;
                }
                match coerce(&value, &formal.data_type) {
                    Ok(fitting) => {
                        if !natural(&value, &formal.data_type) {
                            let message =
                                format!("`{}` is passed to `{}`, which is {}", self.text(span), formal.name, describe(&formal.data_type));
                            self.report(Problem::P4012, span, message);
                        }
                        Some(Actual::Constant(fitting))
                    }
                    Err(Misfit::Range) => {
                        let message = format!(
                            "`{}` is outside the range of `{}`, which is {}",
                            self.text(span),
                            formal.name,
                            describe(&formal.data_type)
                        );
                        self.report(Problem::P4001, span, message);
                        None
                    }
                    Err(Misfit::Type) => {
                        self.mismatch(argument, formal, "a constant or variable of that type");
                        None
                    }
                }
            }
            Meaning::Variable { location, data_type, declared } => {
                if data_type.width() != Some(width) {
                    let wanted = match width {
                        Width::Bit => "a bit",
                        Width::Byte => "a byte",
                        Width::Word => "a word",
                        Width::DoubleWord | Width::QuadWord => "a double word",
                    };
                    self.mismatch(argument, formal, wanted);
                    return None;
                }
                let reads = matches!(formal.section, Section::Input | Section::InOut);
                let writes = formal.section != Section::Input;
                match location {
                    Location::Fixed { area: Area::PeripheralOutput, .. } if reads => {
                        self.mismatch(argument, formal, "something that can be read");
                        return None;
                    }
                    Location::Fixed { area: Area::PeripheralInput, .. } if writes => {
                        self.mismatch(argument, formal, "something that can be written");
                        return None;
                    }
                    _ => {}
                }
                if declared && !related(&data_type, &formal.data_type) {
                    let message = format!(
                        "`{}` is {}, the parameter `{}` is {}; the bits are passed as they are",
                        self.text(span),
                        describe(&data_type),
                        formal.name,
                        describe(&formal.data_type)
                    );
                    self.report(Problem::P4012, span, message);
                }
                Some(Actual::Memory(Access { width, location }))
            }
            Meaning::Operand(_) => {
                self.mismatch(argument, formal, "a constant or variable of that type");
                None
            }
        }
    }

    /// The ANY of a block: its kind and its number. The symbol of a data block stands for what is in it.
    fn any_of_block(&self, block: &BlockOperand, written: &ast::Operand) -> Option<Actual> {
        let NumberOperand::Fixed(number) = block.number else { return None };
        let type_code = match block.kind {
            BlockKind::FunctionBlock => "BLOCK_FB",
            BlockKind::Function => "BLOCK_FC",
            BlockKind::DataBlock if !block.instance => "BLOCK_DB",
            _ => return None,
        };
        if matches!(written, ast::Operand::Symbol { .. } | ast::Operand::Name { .. })
            && let Some(contents) = self.whole(Meaning::Operand(Operand::Block(block.clone())))
        {
            return Some(contents);
        }
        Some(any_of_number(any_type_code(type_code)?, number))
    }

    /// A variable of any type, or a whole data block, by place and type.
    fn whole(&self, meaning: Meaning) -> Option<Actual> {
        match meaning {
            Meaning::Variable { location, data_type, .. } => Some(Actual::Complex { location, data_type }),
            Meaning::Operand(Operand::Block(BlockOperand {
                kind: BlockKind::DataBlock,
                instance: false,
                number: NumberOperand::Fixed(db),
            })) => {
                let layout = self.known.blocks.data(db)?;
                Some(Actual::Complex {
                    location: Location::InDataBlock { db, position: 0 },
                    data_type: DataType::Struct(Arc::clone(&layout.structure)),
                })
            }
            Meaning::Operand(_) => None,
        }
    }
}

/// Type code of an ANY that names a system data block.
const ANY_OF_SYSTEM_DATA: u8 = 0x1A;

/// The ANY of one timer, counter or block: its type, one of it, and its number in place of an address.
fn any_of_number(type_code: u8, number: u16) -> Actual {
    let [high, low] = number.to_be_bytes();
    Actual::Constant(Value::Any([0x10, type_code, 0, 1, 0, 0, 0, 0, high, low]))
}

/// The ANY of a variable of a data block as extended programs have it: its type, and for a structure or an array the largest of DWORD, WORD
/// and BYTE that it is a multiple of; an array of BYTE stays one.
fn any_of_variable(db: u16, pointer: u32, data_type: &DataType) -> Value {
    let (code, count) = match data_type {
        DataType::Array { element, .. } if **element == DataType::Byte => any_type(data_type),
        DataType::Array { .. } | DataType::Struct(_) | DataType::Instance { .. } => {
            let bytes = bytes_of(data_type);
            let (word, size) = [("DWORD", 4), ("WORD", 2)].into_iter().find(|(_, size)| bytes.is_multiple_of(*size)).unwrap_or(("BYTE", 1));
            (any_type_code(word).unwrap_or_default(), bytes / size)
        }
        _ => any_type(data_type),
    };
    let mut any = [0x10, code, 0, 0, 0, 0, 0, 0, 0, 0];
    any[2..4].copy_from_slice(&u16::try_from(count).unwrap_or(u16::MAX).to_be_bytes());
    any[4..6].copy_from_slice(&db.to_be_bytes());
    any[6..].copy_from_slice(&pointer.to_be_bytes());
    Value::Any(any)
}

fn block_actual(meaning: Meaning, kinds: &[BlockKind], wanted: &str) -> Result<Actual, String> {
    match meaning {
        Meaning::Operand(Operand::Block(block)) if kinds.contains(&block.kind) => Ok(Actual::Block(block.number)),
        _ => Err(wanted.to_owned()),
    }
}

/// Whether two elementary types of one width may be exchanged without a remark: bit strings carry anything.
fn related(actual: &DataType, formal: &DataType) -> bool {
    let bits = |data_type: &DataType| matches!(data_type, DataType::Bool | DataType::Byte | DataType::Word | DataType::DoubleWord);
    actual == formal || bits(actual) || bits(formal)
}

/// Whether a complex variable can stand for a parameter: the same kind of type with the same layout, names aside.
fn same_layout(formal: &DataType, actual: &DataType) -> bool {
    match (formal, actual) {
        (DataType::String(_), DataType::String(_)) => true,
        (DataType::Array { bounds: a, element: x }, DataType::Array { bounds: b, element: y }) => {
            a.len() == b.len() && formal.elements() == actual.elements() && same_layout(x, y)
        }
        (DataType::Struct(a) | DataType::Instance { structure: a, .. }, DataType::Struct(b) | DataType::Instance { structure: b, .. }) => {
            Arc::ptr_eq(a, b)
                || (a.size == b.size
                    && a.fields.len() == b.fields.len()
                    && a.fields.iter().zip(&b.fields).all(|(a, b)| a.offset == b.offset && same_layout(&a.data_type, &b.data_type)))
        }
        _ => formal == actual,
    }
}
