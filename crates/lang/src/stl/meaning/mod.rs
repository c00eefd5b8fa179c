//! What each instruction does, by the chapters of the manual.
