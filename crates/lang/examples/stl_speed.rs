//! Measures parsing, formatting and converting of 100,000 statements: `cargo run --release -p sieben-lang --example stl_speed`.
#![allow(clippy::print_stdout, clippy::disallowed_methods)] // It is a measurement for a person.

use std::time::Instant;

use sieben_lang::stl;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

const STATEMENTS: usize = 100_000;

fn main() {
    let lines =
        ["      A     I 0.0;\n", "M001: O(;\n", "      L     DB10.DBW 2; // level\n", "      T     #value;\n", "      JC    M001;\n"];
    let text: String = lines.iter().cycle().take(STATEMENTS).copied().collect();
    let start = Instant::now();
    let parsed = stl::parse(FileId::default(), &text, None);
    println!("parse    {:?} ({} diagnostics)", start.elapsed(), parsed.diagnostics.len());
    let start = Instant::now();
    let formatted = stl::format(&text, None).is_ok();
    println!("format   {:?} ({formatted})", start.elapsed());
    let start = Instant::now();
    let converted = stl::convert(&text, None, Mnemonics::German).is_ok();
    println!("convert  {:?} ({converted})", start.elapsed());
}
