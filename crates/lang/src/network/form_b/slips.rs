//! What stands in a line of form B where no element can stand: which sign it is, and what was probably meant.

use super::parse::{Parsed, Parser};
use crate::network::model::{Element, Kind, Line};
use crate::network::operand::Operand;

/// Words of coils, which as contacts were read by mistake.
const COILS: [&str; 6] = ["S", "R", "SAVE", "RET", "JMP", "JMPN"];

impl Parser<'_> {
    /// A sign that begins no element, where one is expected. What to do follows a semicolon.
    pub(super) fn no_element<T>(&mut self) -> Option<Parsed<T>> {
        self.scan.space();
        let open = self.scan.open_bracket();
        let sign = self.scan.rest().chars().next();
        let message = match (sign, open) {
            (None, Some(bracket)) => format!("the line ends inside of `{bracket}`; write its closing bracket"),
            (None, None) => return None,
            (Some('='), Some('(')) if self.scan.follows("->") => {
                "an output stands inside of a bracket; close the bracket before `->`: `(a | b) -> = c`".to_owned()
            }
            (Some('='), _) => "`->` is missing before this output; write `a -> = b`".to_owned(),
            (Some('|'), None) => "the branches that `|` divides stand in no bracket; write `(a | b) -> = c`".to_owned(),
            (Some('&'), _) => "`&` is no sign of this form; contacts in series stand side by side: `a b -> = c`".to_owned(),
            (Some(sign @ (')' | ']' | '}')), open) => match open {
                Some(open) if closing(open) == Some(sign) => {
                    format!("an element is expected before `{sign}`; write one, or take the bracket or the empty branch away")
                }
                Some(open) => format!("`{open}` is closed by `{sign}`; close it by its own bracket"),
                None => format!("`{sign}` closes nothing; take it away, or write its opening bracket"),
            },
            (Some(';'), None) => {
                "`;` divides the branches of a T-branch, and there is none; take it away: a network ends with its line".to_owned()
            }
            (Some(sign @ ('|' | ',' | ';' | '<' | '>' | ':')), _) => {
                format!("an element is expected before `{sign}`; write a contact, or take the sign away")
            }
            _ => return None,
        };
        Some(self.scan.wrong(message))
    }

    /// What stands after the last output of a network.
    pub(super) fn after_end<T>(&mut self) -> Parsed<T> {
        match self.scan.rest().chars().next() {
            Some(')' | ']' | '}' | ';' | '|' | '&') if let Some(wrong) = self.no_element() => wrong,
            _ => self.scan.wrong(
                "the network ends before this; more outputs stand after a comma, and another network on a line of its own with `NETWORK` before it",
            ),
        }
    }

    /// A coil that was read as contacts, in a rung that has no output: its sign, or the arrow before it, is missing.
    pub(super) fn not_a_coil(&mut self, line: &Line, arrow: Option<usize>) -> Parsed<()> {
        let contact = |element: Option<&Element>| match element {
            Some(Element { kind: Kind::Contact { operand, negated: false }, .. }) => Some(operand.clone()),
            _ => None,
        };
        let Some(last) = contact(line.last()) else { return Ok(()) };
        let before = line.len().checked_sub(2).and_then(|index| contact(line.get(index)));
        let coil = [before, Some(last.clone())].into_iter().flatten().find(|operand| COILS.contains(&operand.text.as_str()));
        let start = |operand: &Operand| operand.start.map_or(0, |start| start as usize);
        match (coil, arrow) {
            (Some(coil), _) => self.scan.wrong_in_text(
                start(&coil),
                format!(
                    "`->` is missing before this output; write `-> {coil}{}`",
                    if coil == last { String::new() } else { format!(" {last}") }
                ),
            ),
            (None, Some(arrow)) if self.scan.begins_at(&last, arrow) => self.scan.wrong_in_text(
                start(&last),
                format!("the sign of the output is missing; write `-> = {last}`, or `S` or `R` in place of `=`"),
            ),
            _ => Ok(()),
        }
    }
}

/// What closes a bracket.
fn closing(open: char) -> Option<char> {
    Some(match open {
        '(' => ')',
        '[' => ']',
        '{' => '}',
        _ => return None,
    })
}
