//! Operands of diagrams that the pins of their elements do not take.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use crate::network::pin_types::{Class, TypedPin};
use crate::stl::ast;
use crate::stl::diagrams::class;
use crate::stl::operands::{Call, Operand};

/// A pin of an element, in a network of a block.
#[derive(Clone, Copy)]
pub(super) struct Wired {
    pin: TypedPin,
    /// `LAD network 2`.
    drawing: &'static str,
    network: u32,
}

/// Parameters that a called block writes while logic is wired to them: it writes to a bit that nothing reads.
pub(super) fn lost(block: &ast::Block, network: u32, call: &ast::Call, resolved: &Call) -> Vec<Diagnostic> {
    let drawing = network.checked_sub(1).and_then(|at| block.networks.get(at as usize)).and_then(|own| own.drawing);
    let Some(drawing) = drawing else { return Vec::new() };
    let is_logic = |argument: &&ast::Argument| matches!(argument.value, ast::Operand::Scratch { .. });
    let written = |argument: &ast::Argument| {
        let parameter = resolved.parameters.iter().find(|one| one.name.eq_ignore_ascii_case(&argument.name.text))?;
        let name = &parameter.name;
        let (section, help) = match parameter.section {
            Section::InOut => ("IN_OUT", format!("Wire the operand itself to it: `{name} := =M 0.0`.")),
            Section::Output | Section::Return => ("an output", format!("Wire an operand to it: `{name} => M 0.0`.")),
            _ => return None,
        };
        let message = format!(
            "{} network {network}: `{name}` of `{}` is {section}, and what the block writes there is lost, because logic is wired to it",
            drawing.word(),
            resolved.callee
        );
        Some(Diagnostic::new(Problem::P2411, argument.name.span, message).help(help))
    };
    call.arguments.iter().filter(is_logic).filter_map(written).collect()
}

impl Wired {
    /// The pin that the operand of a statement is wired to, if a diagram shows it. Networks are counted from 1.
    pub(super) fn of(block: &ast::Block, network: u32, statement: usize) -> Option<Self> {
        let own = block.networks.get(network.checked_sub(1)? as usize)?;
        let pin = (*own.pins.get(statement.checked_sub(own.first_statement)?)?)?;
        Some(Self { pin, drawing: own.drawing?.word(), network })
    }

    /// What is wrong with an operand that the pin does not take.
    pub(super) fn misfit(self, operand: &Operand, written: &str, place: Span) -> Option<Diagnostic> {
        let class = class(operand);
        (!self.pin.takes.takes(class)).then(|| self.diagnostic(class, written, place))
    }

    /// The instruction that the element stands for takes something else than an operand.
    pub(super) fn refused(self, takes: &str, written: &str, place: Span) -> Diagnostic {
        let Self { pin, drawing, network } = self;
        Diagnostic::new(Problem::P2410, place, format!("{drawing} network {network}: {} takes {takes}, not `{written}`", pin.shown()))
    }

    /// A message about the operand, with the pin that it is wired to.
    pub(super) fn about(self, message: &str) -> String {
        let Self { pin, drawing, network } = self;
        format!("{drawing} network {network}: {} cannot have it: {message}", pin.shown())
    }

    /// What is wired to the input is of another type, in words.
    pub(super) fn holds(self, what: &str) -> String {
        let Self { pin, drawing, network } = self;
        format!("{drawing} network {network}: {} takes {}, and what is wired to it is {what}", pin.shown(), pin.takes.describe())
    }

    /// The output gives another type than the variable has that is wired to it, in words.
    pub(super) fn gives(self, what: &str) -> String {
        let Self { pin, drawing, network } = self;
        format!("{drawing} network {network}: {} gives {what}, and the variable that is wired to it is of another type", pin.shown())
    }

    fn diagnostic(self, class: Class, written: &str, place: Span) -> Diagnostic {
        let Self { pin, drawing, network } = self;
        let (shown, takes) = (pin.shown(), pin.takes.describe());
        let message = format!("{drawing} network {network}: {shown} takes {takes}, and `{written}` is {}", class.describe());
        let diagnostic = Diagnostic::new(Problem::P2410, place, message);
        match pin.help(class, written) {
            Some(help) => diagnostic.help(help),
            None => diagnostic,
        }
    }
}
