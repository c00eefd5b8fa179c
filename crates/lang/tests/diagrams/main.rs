//! Diagrams: their text, the statements that they stand for, and what statements can be drawn.

mod form_b;
mod pins;
mod random;
mod rules;
mod statements;
mod vectors;
