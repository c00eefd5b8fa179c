//! Diagrams: their text, the statements that they stand for, and what statements can be drawn.

mod blocks;
mod form_b;
mod pins;
mod random;
mod rules;
mod statements;
mod vectors;
