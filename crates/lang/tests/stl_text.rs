//! What the STL text side must hold for any source: parse, format, convert.
#![allow(missing_docs)]

use sieben_lang::stl::{self, ast};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

fn parse(text: &str) -> stl::Parsed {
    stl::parse(FileId::default(), text, None)
}

#[test]
fn smoke() {
    let text = "ORGANIZATION_BLOCK OB 1\nTITLE = a // b\nVAR_TEMP\n  a, b : ARRAY [1..5, 0 .. 3] OF INT := 3 (0), 5; // hi\nEND_VAR\nBEGIN\nNETWORK\nTITLE = n\n// c\nM001: A( ;\n O I0.0; 0 M 1.0; = Q 4.0; ) ; )MCR; L P#M 1.0 BYTE 4; L DB10.DBW 2; A DB10.DBX0.0; ==I; +I; + 5; L -5; L MW [MD 4]; L W [AR1,P#2.0]; A ==0; JC M001; CALL FB 3 , DB 4 (\n a := MW 4, // x\n b := #x.y[3],);\n CALL #inst; U E 0.0\nTLB 5\nA IO.0\nEND_ORGANIZATION_BLOCK\n";
    let parsed = parse(text);
    assert_eq!(parsed.syntax().text(), text);
    let _ = (ast::File::default(), stl::convert(text, None, Mnemonics::German));
}
