//! The controller: cycle, organization blocks, process image, system functions.
#![forbid(unsafe_code)]
