//! Fleets as a whole.
