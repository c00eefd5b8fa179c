//! Diagrams: their text, and the statements that they stand for.

mod form_b;
