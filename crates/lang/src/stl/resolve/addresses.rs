//! Absolute and indirect addresses, and what lies inside data blocks.

use std::sync::Arc;

use sieben_model::address::{Area, Width, area_and_width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::extension::is_negative;
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::{Meaning, Resolver, Written};
use crate::stl::ast;
use crate::stl::declare::names::block_of_name;
use crate::stl::declare::path::follow;
use crate::stl::operands::{AddressRegister, BlockOperand, Location, NumberOperand, Operand};

impl Resolver<'_> {
    pub(super) fn timer(&mut self, number: u16, span: Span) -> Operand {
        if number >= self.known.cpu.timers {
            let message = format!("`T {number}`: CPU {} has timers 0 to {}", self.known.cpu.name, self.known.cpu.timers - 1);
            self.report(Problem::P5004, span, message);
        }
        Operand::Timer(NumberOperand::Fixed(number))
    }

    pub(super) fn counter(&mut self, number: u16, span: Span) -> Operand {
        if number >= self.known.cpu.counters {
            let message = format!("`{}`: CPU {} has counters 0 to {}", self.text(span), self.known.cpu.name, self.known.cpu.counters - 1);
            self.report(Problem::P5004, span, message);
        }
        Operand::Counter(NumberOperand::Fixed(number))
    }

    pub(super) fn block(block: BlockId, instance: bool) -> Operand {
        Operand::Block(BlockOperand { kind: block.kind, instance, number: NumberOperand::Fixed(block.number) })
    }

    pub(super) fn absolute(&mut self, written: &Written<'_>, span: Span) -> Option<Meaning> {
        let letters = written.letters.to_ascii_uppercase();
        let number = |resolver: &mut Self| match u16::try_from(written.number) {
            Ok(number) if written.bit.is_none() => Some(number),
            Ok(_) => {
                resolver.report(Problem::P4015, span, format!("`{letters}` takes one number, without a point"));
                None
            }
            Err(_) => {
                resolver.report(Problem::P4001, span, format!("`{letters} {}` has a number above 65535", written.number));
                None
            }
        };
        match letters.as_str() {
            "T" => return number(self).map(|number| Meaning::Operand(self.timer(number, span))),
            "C" | "Z" => return number(self).map(|number| Meaning::Operand(self.counter(number, span))),
            "DI" => return number(self).map(|number| Meaning::Operand(Self::block(BlockId::db(number), true))),
            _ => {}
        }
        if let Some(kind) = BlockKind::from_abbreviation(&letters) {
            let block = BlockId::new(kind, number(self)?);
            if is_negative(block) && !self.extended(span) {
                return None;
            }
            return Some(Meaning::Operand(Self::block(block, false)));
        }
        let (area, width, position) = self.area_address(written, span)?;
        let location = Location::Fixed { area, position };
        self.check_area(&location, width, span);
        Some(Meaning::Variable { location, data_type: bare_type(width), declared: false })
    }

    fn area_address(&mut self, written: &Written<'_>, span: Span) -> Option<(Area, Width, u32)> {
        let Some((area, width)) = area_and_width(written.letters) else {
            let message = match written.letters.to_ascii_uppercase().as_str() {
                "PI" | "PQ" | "PE" | "PA" => {
                    format!("the peripheral has no bits; `{}B`, `{}W` and `{}D` exist", written.letters, written.letters, written.letters)
                }
                _ => format!("`{}` is no memory area", written.letters),
            };
            self.report(Problem::P4015, span, message);
            return None;
        };
        let bit = match (width, written.bit) {
            (Width::Bit, Some(bit @ 0..=7)) => bit as u32,
            (Width::Bit, Some(bit)) => {
                self.report(Problem::P4015, span, format!("a byte has bits 0 to 7, not {bit}"));
                return None;
            }
            (Width::Bit, None) => {
                let message = format!("a bit has two numbers: `{} {}.0`", written.letters, written.number);
                self.report(Problem::P4015, span, message);
                return None;
            }
            (_, Some(_)) => {
                let message = format!("`{}` takes one number: `{} {}`", written.letters, written.letters, written.number);
                self.report(Problem::P4015, span, message);
                return None;
            }
            (_, None) => 0,
        };
        let position = self.position(written.number, bit, span)?;
        Some((area, width, position))
    }

    pub(super) fn position(&mut self, byte: u64, bit: u32, span: Span) -> Option<u32> {
        if byte > 65_535 {
            self.report(Problem::P4001, span, format!("a byte address lies between 0 and 65535, not {byte}"));
            return None;
        }
        Some(byte as u32 * 8 + bit)
    }

    /// Warns of an address that the CPU type does not have: the statement would fail at run time.
    pub(super) fn check_area(&mut self, location: &Location, width: Width, span: Span) {
        let cpu = self.known.cpu;
        let (position, limit, what) = match location {
            Location::Fixed { area, position } => {
                let limit = match area {
                    Area::Input | Area::Output => cpu.process_image,
                    Area::BitMemory => cpu.bit_memory,
                    Area::PeripheralInput | Area::PeripheralOutput => cpu.peripheral,
                    Area::Local | Area::CallerLocal => cpu.local_data_block,
                    Area::SharedData | Area::InstanceData => 65_536,
                };
                (*position, limit, Problem::P5001)
            }
            Location::InDataBlock { db, position } | Location::InInstanceBlock { db, position } => match self.known.blocks.data(*db) {
                Some(layout) => (*position, layout.structure.size, Problem::P5005),
                None => {
                    if !self.known.blocks.exists(BlockId::db(*db)) {
                        let message = format!("`DB {db}` does not exist; the statement fails unless the program creates it");
                        self.report(Problem::P3018, span, message).may_be_elsewhere = true;
                    }
                    return;
                }
            },
            _ => return,
        };
        if position / 8 + width.bytes() <= limit {
            return;
        }
        let text = self.text(span).to_owned();
        let message = match (what, location) {
            (Problem::P5005, Location::InDataBlock { db, .. } | Location::InInstanceBlock { db, .. }) => {
                format!("`{text}` lies behind the end of `DB {db}`, which has {limit} bytes")
            }
            _ => format!("`{text}` lies outside the {limit} bytes that this area has in CPU {}", cpu.name),
        };
        self.report(what, span, message);
    }

    /// The data block that is named before a point.
    pub(super) fn data_block(&mut self, name: &ast::BlockName) -> Option<u16> {
        match block_of_name(self.known.scope, name) {
            Ok(BlockId { kind: BlockKind::DataBlock, number }) => Some(number),
            Ok(other) => {
                self.report(Problem::P4002, name.span(), format!("`{other}` is not a data block"));
                None
            }
            Err(message) => {
                self.report(Problem::P3020, name.span(), message).may_be_elsewhere = true;
                None
            }
        }
    }

    pub(super) fn in_block(&mut self, block: &ast::BlockName, instance: bool, written: &Written<'_>, span: Span) -> Option<Meaning> {
        let db = self.data_block(block)?;
        let (area, width, position) = self.area_address(written, span)?;
        let location = match (instance, area) {
            (false, Area::SharedData) => Location::InDataBlock { db, position },
            (true, Area::InstanceData) => Location::InInstanceBlock { db, position },
            _ => {
                let valid = if instance { "DIX, DIB, DIW or DID" } else { "DBX, DBB, DBW or DBD" };
                self.report(Problem::P4015, span, format!("behind the point stands {valid}, not `{}`", written.letters));
                return None;
            }
        };
        self.check_area(&location, width, span);
        Some(Meaning::Variable { location, data_type: bare_type(width), declared: false })
    }

    /// `"DB".field[3]`.
    pub(super) fn field(&mut self, db: u16, path: &[ast::PathElement], span: Span) -> Option<Meaning> {
        let Some(layout) = self.known.blocks.data(db) else {
            // A data block whose declaration is wrong is reported there.
            if !self.known.blocks.exists(BlockId::db(db)) {
                self.report(Problem::P3008, span, format!("`DB {db}` does not exist, so it has no fields")).may_be_elsewhere = true;
            }
            return None;
        };
        let whole = DataType::Struct(Arc::clone(&layout.structure));
        match follow(self.known.scope, self.known.field_names, &whole, path, span) {
            // The declaration of such a field was wrong, which is reported there.
            Ok(reached) if reached.data_type == DataType::Void => None,
            Ok(reached) => Some(Meaning::Variable {
                location: Location::InDataBlock { db, position: reached.offset as u32 },
                data_type: reached.data_type,
                declared: true,
            }),
            Err(diagnostic) => {
                self.diagnostics.push(*diagnostic);
                None
            }
        }
    }

    /// `MW [MD 4]`, `T [MW 2]`, `DB [MW 4]`.
    pub(super) fn indirect(&mut self, letters: &str, pointer: &ast::Operand, pointer_span: Span, span: Span) -> Option<Meaning> {
        let upper = letters.to_ascii_uppercase();
        let number = match upper.as_str() {
            "T" | "C" | "Z" | "DB" | "DI" => true,
            _ => BlockKind::from_abbreviation(&upper).is_some(),
        };
        let wanted = if number { Width::Word } else { Width::DoubleWord };
        let location = Box::new(self.pointer(pointer, wanted, pointer_span)?);
        let number = NumberOperand::Indirect(location.clone());
        let block = |kind, instance| Operand::Block(BlockOperand { kind, instance, number: number.clone() });
        Some(Meaning::Operand(match upper.as_str() {
            "T" => Operand::Timer(number),
            "C" | "Z" => Operand::Counter(number),
            "DB" => block(BlockKind::DataBlock, false),
            "DI" => block(BlockKind::DataBlock, true),
            _ => match (BlockKind::from_abbreviation(&upper), area_and_width(&upper)) {
                (Some(kind @ (BlockKind::Function | BlockKind::FunctionBlock)), _) => block(kind, false),
                (None, Some((area, width))) => {
                    let location = Location::MemoryIndirect { area, pointer: location };
                    return Some(Meaning::Variable { location, data_type: bare_type(width), declared: false });
                }
                _ => {
                    let message = format!("`{letters}` cannot be addressed indirectly");
                    self.report(Problem::P4015, span, message);
                    return None;
                }
            },
        }))
    }

    /// The word or double word in which a pointer lies.
    fn pointer(&mut self, pointer: &ast::Operand, wanted: Width, span: Span) -> Option<Location> {
        let what = if wanted == Width::Word { "a word (MW, LW, DBW, DIW)" } else { "a double word (MD, LD, DBD, DID)" };
        match self.meaning(pointer, span)? {
            Meaning::Variable { location, data_type, .. } if data_type.width() == Some(wanted) => match location {
                Location::Fixed { area: Area::BitMemory | Area::Local | Area::SharedData | Area::InstanceData, .. }
                | Location::Instance { .. } => Some(location),
                Location::Parameter { .. } | Location::InstancePointer { .. } => {
                    let message = format!("the parameter `{}` cannot hold a pointer for an access", self.text(span));
                    self.report(Problem::P4014, span, message).help =
                        Some("Copy it to a variable of VAR_TEMP first and use that.".to_owned());
                    None
                }
                _ => {
                    let message = format!("a pointer lies in {what}, not in `{}`", self.text(span));
                    self.report(Problem::P4014, span, message);
                    None
                }
            },
            _ => {
                let message = format!("the pointer of this access is {what}, not `{}`", self.text(span));
                self.report(Problem::P4014, span, message);
                None
            }
        }
    }

    pub(super) fn register_indirect(&mut self, letters: &str, register: &ast::Word, offset: &ast::Constant, span: Span) -> Option<Meaning> {
        let register = match register.text.to_ascii_uppercase().as_str() {
            "AR1" => AddressRegister::Ar1,
            "AR2" => AddressRegister::Ar2,
            other => {
                let message = format!("the address registers are `AR1` and `AR2`, not `{other}`");
                self.report(Problem::P4015, span, message);
                return None;
            }
        };
        let (area, width) = match letters.to_ascii_uppercase().as_str() {
            "" => (None, Width::Bit),
            "B" => (None, Width::Byte),
            "W" => (None, Width::Word),
            "D" => (None, Width::DoubleWord),
            upper => match area_and_width(upper) {
                Some((area, width)) => (Some(area), width),
                None => {
                    self.report(Problem::P4015, span, format!("`{letters}` is no memory area"));
                    return None;
                }
            },
        };
        let offset = match offset.value.as_ref()? {
            Value::Pointer(offset @ 0..=0x7FFF) => *offset,
            _ => {
                self.report(Problem::P4001, offset.span, "the offset lies between `P#0.0` and `P#4095.7`");
                return None;
            }
        };
        let location = Location::RegisterIndirect { area, register, offset };
        Some(Meaning::Variable { location, data_type: bare_type(width), declared: false })
    }
}

/// The type of an address of which only the width is known.
pub(super) fn bare_type(width: Width) -> DataType {
    match width {
        Width::Bit => DataType::Bool,
        Width::Byte => DataType::Byte,
        Width::Word => DataType::Word,
        Width::DoubleWord | Width::QuadWord => DataType::DoubleWord,
    }
}
