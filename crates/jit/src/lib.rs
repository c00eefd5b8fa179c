//! The same IR as machine code (empty until the native engine exists).
