//! Form A: a diagram as text with one element on each line, the form in which diagrams are stored.

mod boxes;
mod layout;
mod line;
mod parse;
mod print;
mod recognized;

pub use layout::format;
pub use line::{Comment, comment_start, comments, written_lines};
pub use parse::{NESTING_MAX, Parsed, parse};
pub use print::{CommentsOf, print};
pub use recognized::is_form_a;

#[cfg(test)]
mod tests;
