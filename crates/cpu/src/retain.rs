//! Retentive data: what survives a restart and a power failure, handed out and taken back as one image.
//!
//! The CPU says what is retentive and copies it between two scans; where the image is kept is a matter of those
//! who run the CPU. An image is one whole scan's, and it is taken back whole or not at all.

mod areas;
mod declaration;
mod image;
mod keeper;
mod restore;
#[cfg(test)]
mod tests;

pub use areas::{Numbers, RetentiveAreas};
pub use image::{RetainImage, fuzz};
pub use restore::{Adoption, Refusal, Restored, data_blocks};

pub(crate) use declaration::Declarations;
pub(crate) use keeper::Keeper;
pub(crate) use restore::judge;
