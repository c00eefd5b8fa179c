//! How a block is called: what the caller leaves where, and what the called block finds. It is the same for every language, so that each calls the blocks of the others.
//!
//! A function gets one number per parameter: a pointer to the actual one, or the number of a timer, a counter or a block. A function block finds its parameters in its instance:
//! the DI register is open on it and AR2 points at its first byte, while the DB register keeps what DI had.

pub(crate) mod pointers;
pub(crate) mod registers;
