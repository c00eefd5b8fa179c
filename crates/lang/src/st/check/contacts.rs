//! Contacts, coils and EN of diagrams: what they read and write is a BOOL.

use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::places::Reached;
use super::typed::Typed;
use super::types::{Class, Kind};
use super::{Checker, sentence};
use crate::st::ast::{Contact, Expression, NetworkNumber};
use crate::st::standard;
use crate::st::tree::Value;

/// How each dialect writes the first bit of a word, after its name; `None` where bits of a variable have no names.
const FIRST_BIT: [Option<&str>; 4] = [Some(".%X0"), Some(".0"), None, Some(".%X0")];

/// What a BOOL is wanted for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    Contact,
    Coil,
    Enable,
}

impl Checker<'_> {
    /// What a contact reads.
    pub(super) fn contact(&mut self, contact: &Contact) -> Reached {
        let span = contact.operand.span;
        match self.reach(&contact.operand) {
            Reached::Target(target) if *target.data_type.base() == DataType::Bool => Reached::Target(target),
            Reached::Other(bit @ (Typed::Scalar { data_type: DataType::Bool, .. } | Typed::Poison)) => Reached::Other(bit),
            Reached::Other(number @ Typed::Integer { value: 0 | 1, .. }) => {
                let value = self.coerce(number, span, &DataType::Bool);
                Reached::Other(value.map_or(Typed::Poison, |value| Typed::Scalar { value, data_type: DataType::Bool }))
            }
            other => {
                self.no_bit(Use::Contact, &other, span, contact.network);
                Reached::Other(Typed::Poison)
            }
        }
    }

    /// Whether a coil writes a BOOL; what is not known is reported where it is assigned.
    pub(super) fn is_bit_of_coil(&mut self, target: &Expression, network: NetworkNumber) -> bool {
        let reached = self.quietly(|checker| checker.reach(target));
        let is_fine = match &reached {
            Reached::Target(target) => matches!(target.data_type.base(), DataType::Bool | DataType::Void),
            // A constant, which is no target at all.
            Reached::Other(typed) => !matches!(typed, Typed::Scalar { data_type, .. } if *data_type != DataType::Bool),
        };
        if !is_fine {
            self.no_bit(Use::Coil, &reached, target.span, network);
        }
        is_fine
    }

    /// What EN of a box is.
    pub(super) fn enable(&mut self, enable: &Expression, network: NetworkNumber) -> Option<Value> {
        let typed = self.expression(enable);
        match &typed {
            Typed::Scalar { data_type: DataType::Bool, .. } | Typed::Integer { value: 0 | 1, .. } | Typed::Poison => {
                self.coerce(typed, enable.span, &DataType::Bool)
            }
            _ => {
                let reached = match self.quietly(|checker| checker.reach(enable)) {
                    Reached::Target(target) => Reached::Target(target),
                    Reached::Other(_) => Reached::Other(typed),
                };
                self.no_bit(Use::Enable, &reached, enable.span, network);
                None
            }
        }
    }

    /// Reports an operand that is no BOOL.
    fn no_bit(&mut self, wanted: Use, found: &Reached, span: Span, network: NetworkNumber) {
        let (what, name, data_type) = match found {
            Reached::Target(target) => {
                let what = format!("`{}` is {}", target.name, self.words(&target.data_type));
                (what, Some(target.name.clone()), Some(target.data_type.clone()))
            }
            Reached::Other(typed) => {
                let data_type = match typed {
                    Typed::Scalar { data_type, .. } | Typed::Number { data_type, .. } => Some(data_type.clone()),
                    _ => None,
                };
                (format!("this is {}", self.what(typed)), None, data_type)
            }
        };
        let message = match wanted {
            Use::Contact => format!("{network}: {what}, and a contact reads a BOOL"),
            Use::Coil => format!("{network}: {what}, and a coil writes a BOOL"),
            Use::Enable => format!("{network}: {what}, and EN of a box is a BOOL"),
        };
        let help = match found {
            Reached::Other(Typed::Integer { .. } | Typed::Real { .. }) => {
                "Write TRUE, FALSE or a variable that is declared as BOOL.".to_owned()
            }
            _ => self.instead(wanted, name.as_deref().unwrap_or("…"), data_type.as_ref()),
        };
        self.report(Problem::P2444, span, message).help = Some(help);
    }

    /// What to draw instead.
    fn instead(&self, wanted: Use, name: &str, data_type: Option<&DataType>) -> String {
        if let Some(DataType::Instance { block, .. }) = data_type {
            let interface = self.names.interface(*block);
            let wanted_section = if wanted == Use::Coil { Section::Input } else { Section::Output };
            let pin = interface.as_ref().and_then(|interface| {
                interface.variables.iter().find(|variable| variable.section == wanted_section && variable.data_type == DataType::Bool)
            });
            if let Some(pin) = pin {
                return format!("Name a BOOL of the instance: `{name}.{}`.", pin.name);
            }
        }
        let kind = data_type.and_then(|data_type| Kind::of(data_type.base()));
        let bit = kind.filter(|kind| kind.class == Class::Bits).and_then(|_| FIRST_BIT[self.dialect.column()]);
        // A dialect without MOVE has other boxes.
        let assigns = match standard::resolve("MOVE", self.dialect, &[]).is_some() {
            true => format!("draw a box that writes it: `MOVE … => {name}`"),
            false => format!("draw a box that writes it: `SEL G := …, IN0 := {name}, IN1 := … => {name}`"),
        };
        let nothing = match kind.map(|kind| kind.class) {
            Some(Class::Real) => "0.0",
            Some(Class::Bits) => "16#0",
            Some(Class::Duration) => "T#0s",
            Some(Class::Signed | Class::Unsigned) => "0",
            _ => "…",
        };
        match (wanted, kind, bit) {
            (Use::Coil, _, Some(bit)) => format!("Write one bit of it, `{name}{bit}`, or {assigns}."),
            (Use::Coil, Some(_), None) => sentence(&format!("{assigns}.")),
            (Use::Coil, None, _) => "Write a variable that is declared as BOOL.".to_owned(),
            (_, _, Some(bit)) => format!("Read one bit of it, `{name}{bit}`, or compare it: `{name} <> {nothing}`."),
            (_, Some(_), None) => format!("Compare it: `{name} <> {nothing}`."),
            (_, None, _) => "Read a variable that is declared as BOOL.".to_owned(),
        }
    }
}
