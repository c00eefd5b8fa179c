//! Slips of people who type or paste what slides, books and old listings print: what `check` says, what `check --fix` makes of it, and
//! what the program does then.

mod command;

use command::Folder;

/// One slip.
struct Slip {
    /// What the slip is.
    what: &'static str,
    /// The source, as it is pasted.
    source: &'static str,
    /// Parts of what `check` says.
    says: &'static [&'static str],
    /// The source after `check --fix`; the same text where several readings are possible.
    fixed: &'static str,
    /// Arguments of `exec` and parts of what it prints; none if the source still does not compile.
    runs: Option<(&'static [&'static str], &'static [&'static str])>,
}

/// A line that means one thing only.
const fn line(what: &'static str, source: &'static str, says: &'static [&'static str], fixed: &'static str) -> Slip {
    Slip { what, source, says, fixed, runs: Some((&[], &[])) }
}

/// A line with several readings, or none.
const fn open(what: &'static str, source: &'static str, says: &'static [&'static str]) -> Slip {
    Slip { what, source, says, fixed: source, runs: None }
}

/// A program, its fixed text, and what it does.
const fn program(
    what: &'static str,
    source: &'static str,
    says: &'static [&'static str],
    fixed: &'static str,
    arguments: &'static [&'static str],
    prints: &'static [&'static str],
) -> Slip {
    Slip { what, source, says, fixed, runs: Some((arguments, prints)) }
}

const SLIPS: &[Slip] = &[
    // Names and words that only look like slips.
    line(
        "a long label that is called like a heading",
        "A I 0.0\nJC Network\nNetwork: = Q 0.0\n",
        &["the label `Network`"],
        "A I 0.0\nJC Netw\nNetw: = Q 0.0\n",
    ),
    line(
        "a jump that is glued to a long label",
        "JUlanglabel1\nlanglabel1: NOP 0\n",
        &["did you mean `JU langlabel1`?", "the label `langlabel1`"],
        "JU lang\nlang: NOP 0\n",
    ),
    line(
        "a long label that is called like a variable",
        "FUNCTION FC 1 : VOID\nVAR_TEMP\n counter : INT;\nEND_VAR\nBEGIN\nL 5\nT counter\nJU counter\nL counter\ncounter: NOP 0\nEND_FUNCTION\n",
        &["the label `counter`"],
        "FUNCTION FC 1 : VOID\nVAR_TEMP\n counter : INT;\nEND_VAR\nBEGIN\nL 5\nT counter\nJU coun\nL counter\ncoun: NOP 0\nEND_FUNCTION\n",
    ),
    open(
        "a name without a type that ends like one",
        "FUNCTION FC 1 : VOID\nVAR_TEMP\n point;\nEND_VAR\nBEGIN\nNOP 0\nEND_FUNCTION\n",
        &["`po : int`"],
    ),
    open("a name of two words that only a comment joins", "// level_max in a comment\nL level max\nT MW 0\n", &["`level max` has spaces"]),
    open(
        "a word after a statement that may be a comment",
        "A I 0.0\nS Q 0.0 set\n",
        &["`set` begins another statement", "or `//` before a comment"],
    ),
    program(
        "characters of STEP 5 in a German listing",
        "U E 0.0\n= A 0.0\nL KC 12\nT MW 2\n",
        &["`KC 12` is an operand"],
        "U E 0.0\n= A 0.0\nL '12'\nT MW 2\n",
        &["--show", "MW2"],
        &["MW2 = 16#3132"],
    ),
    // Words that are glued to their operands.
    program(
        "a pointer constant, a number and a loop without spaces: a data block is cleared",
        "DATA_BLOCK DB 5\nSTRUCT\n w : ARRAY[0..9] OF WORD := 10 (W#16#FFFF);\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n\
         FUNCTION FC 30 : VOID\nVAR_INPUT\n dbnumber : WORD;\nEND_VAR\nBEGIN\nL #dbnumber\nTMW100\nOPNDB[MW 100]\nLP#18.0\nTMD40\nL10\n\
         next: TMB50\nL0\nTDBW [MD40]\nLMD40\nLP#2.0\n-D\nTMD40\nLMB50\nLOOPnext\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nCALLFC 30 (dbnumber := W#16#5)\nL DB5.DBW 0\nL DB5.DBW 18\nOW\nT MW 2\nEND_ORGANIZATION_BLOCK\n",
        &["`LP#18.0` lacks a space after the instruction: did you mean `L P#18.0`?", "did you mean `OPN DB[MW 100]`?"],
        "DATA_BLOCK DB 5\nSTRUCT\n w : ARRAY[0..9] OF WORD := 10 (W#16#FFFF);\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n\
         FUNCTION FC 30 : VOID\nVAR_INPUT\n dbnumber : WORD;\nEND_VAR\nBEGIN\nL #dbnumber\nT MW100\nOPN DB[MW 100]\nL P#18.0\nT MD40\nL 10\n\
         next: T MB50\nL 0\nT DBW [MD40]\nL MD40\nL P#2.0\n-D\nT MD40\nL MB50\nLOOP next\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 30 (dbnumber := W#16#5)\nL DB5.DBW 0\nL DB5.DBW 18\nOW\nT MW 2\nEND_ORGANIZATION_BLOCK\n",
        &["--show", "MW2,MD40"],
        &["MW2  = 16#0000"],
    ),
    program(
        "an ANY is put together without spaces, its type glued to its name",
        "DATA_BLOCK DB 20\nSTRUCT\n w : ARRAY[0..9] OF WORD := 11, 12, 13, 14, 15, 16, 17, 18, 19, 20;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n\
         FUNCTION FC 12 : VOID\nVAR_TEMP\n aux_pointerANY;\n WF : WORD;\nEND_VAR\nBEGIN\nLAR1P##aux_pointer\nLW#16#1004\nTLW [AR1,P#0.0]\nL3\nTLW [AR1,P#2.0]\n\
         L20\nTWF\nL#WF\nTLW [AR1,P#4.0]\nL P#DBX 8.0\nTLD [AR1,P#6.0]\n\
         CALL SFC 20 (SRCBLK := #aux_pointer, RET_VAL := MW 0, DSTBLK := P#M 100.0 WORD 3)\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nUCFC12\nEND_ORGANIZATION_BLOCK\n",
        &["did you mean `LAR1 P##aux_pointer`?", "`aux_pointerANY` is a name with its type glued to it", "did you mean `T #WF`?"],
        "DATA_BLOCK DB 20\nSTRUCT\n w : ARRAY[0..9] OF WORD := 11, 12, 13, 14, 15, 16, 17, 18, 19, 20;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n\
         FUNCTION FC 12 : VOID\nVAR_TEMP\n aux_pointer : ANY;\n WF : WORD;\nEND_VAR\nBEGIN\nLAR1 P##aux_pointer\nL W#16#1004\nT LW [AR1,P#0.0]\nL 3\nT LW [AR1,P#2.0]\n\
         L 20\nT #WF\nL#WF\nT LW [AR1,P#4.0]\nL P#DBX 8.0\nT LD [AR1,P#6.0]\n\
         CALL SFC 20 (SRCBLK := #aux_pointer, RET_VAL := MW 0, DSTBLK := P#M 100.0 WORD 3)\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nUC FC12\nEND_ORGANIZATION_BLOCK\n",
        &["--show", "MW0,MW100,MW104"],
        &["MW0   = 16#0000", "MW100 = 16#000F", "MW104 = 16#0011"],
    ),
    program(
        "an ANY is taken apart without spaces",
        "FUNCTION FC 13 : VOID\nVAR_INPUT\n what : ANY;\nEND_VAR\nBEGIN\nLP##what\nLAR1\nLB [AR1,P#1.0]\nTMW10\nLW [AR1,P#2.0]\nTMW12\nLD [AR1,P#6.0]\nTMD14\n\
         +AR1P#2.0\nLW [AR1,P#0.0]\nTMW18\nL MW 10\nL2\n==I\nJCsk1\nJUOVER\nsk1: NOP0\nOVER: NOP1\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 13 (what := P#M 5.0 BYTE 7)\nEND_ORGANIZATION_BLOCK\n",
        &["did you mean `L B [AR1,P#1.0]`?", "did you mean `+AR1 P#2.0`?", "did you mean `JC sk1`?", "did you mean `NOP 1`?"],
        "FUNCTION FC 13 : VOID\nVAR_INPUT\n what : ANY;\nEND_VAR\nBEGIN\nL P##what\nLAR1\nL B [AR1,P#1.0]\nT MW10\nL W [AR1,P#2.0]\nT MW12\nL D [AR1,P#6.0]\nT MD14\n\
         +AR1 P#2.0\nL W [AR1,P#0.0]\nT MW18\nL MW 10\nL 2\n==I\nJC sk1\nJU OVER\nsk1: NOP 0\nOVER: NOP 1\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 13 (what := P#M 5.0 BYTE 7)\nEND_ORGANIZATION_BLOCK\n",
        &["--show", "MW10,MW12,MD14,MW18"],
        &["MW10 = 16#0002", "MW12 = 16#0007", "MD14 = 16#8300_0028", "MW18 = 16#0007"],
    ),
    line("a time without its space", "LS5T#4S\nSD T 1\n", &["did you mean `L S5T#4S`?"], "L S5T#4S\nSD T 1\n"),
    line("a counter constant without its space", "LC#5\nT MW 0\n", &["did you mean `L C#5`?"], "L C#5\nT MW 0\n"),
    line(
        "German instructions without spaces",
        "UE0.0\nUNE0.1\n=A4.0\nLEW4\nTAW6\n",
        &["did you mean `U E0.0`?"],
        "U E0.0\nUN E0.1\n=A4.0\nL EW4\nT AW6\n",
    ),
    open("a glued word that is no local variable", "L MW 0\nTWF\n", &["`TWF` is no instruction"]),
    open(
        "a glued word that can be parted twice",
        "JCNsk1\nsk1: NOP 0\nNsk1: NOP 0\n",
        &["can be read in several ways", "`JC Nsk1` or `JCN sk1`"],
    ),
    line("empty statements without their space", "NOP1\nNOP0\n", &["did you mean `NOP 1`?"], "NOP 1\nNOP 0\n"),
    // Lines that lost their ends.
    program(
        "several statements in a line, some without a space between",
        "SET\n= I 4.0\nL 10\nT MW 10\nL P#4.0\nT MD 30\nCLR\nA I 4.0A I[MD30]= M 0.0\nL 11 T MW 60 L C[MW60] T MW 62\n",
        &["`A` begins another statement", "`T` begins another statement"],
        "SET\n= I 4.0\nL 10\nT MW 10\nL P#4.0\nT MD 30\nCLR\nA I 4.0\nA I[MD30]\n= M 0.0\nL 11\nT MW 60\nL C[MW60]\nT MW 62\n",
        &["--show", "M0.0,MW60"],
        &["M0.0 = 1", "MW60 = 16#000B"],
    ),
    line("a label in the middle of a line", "JU sk1 sk1: NOP 0\n", &["`sk1` begins another statement"], "JU sk1\nsk1: NOP 0\n"),
    line(
        "a lost line end keeps its indentation and the line ends of the file",
        "   A I 0.0 = Q 0.0\r\n",
        &["write `=` on a line of its own"],
        "   A I 0.0\r\n   = Q 0.0\r\n",
    ),
    open("words after a statement that are no statement", "A I 0.0 the pump\n", &["`the` does not belong here"]),
    // Area and width.
    line(
        "area and width with a space between them",
        "L P#4.0\nT MD 50\nL I W [MD50]\nT M W 6\nL M B 7\nT Q B1\n",
        &["`I W` has a space between area and width: did you mean `IW`?"],
        "L P#4.0\nT MD 50\nL IW [MD50]\nT MW 6\nL MB 7\nT QB1\n",
    ),
    // Letters of other alphabets.
    program(
        "Cyrillic letters before and behind `#`",
        "L С#42\nT MW 0\nL В#16#10\nT MB 2\nL Р#24.0\nT MD 4\nLAR1 Р#М10.0\nLAR1 P#М10.0\nTAR1\nT MD 8\n",
        &["`С#42` has letters of another alphabet that only look like Latin ones: did you mean `C#42`?", "did you mean `P#M10.0`?"],
        "L C#42\nT MW 0\nL B#16#10\nT MB 2\nL P#24.0\nT MD 4\nLAR1 P#M10.0\nLAR1 P#M10.0\nTAR1\nT MD 8\n",
        &["--show", "MW0,MB2,MD4,MD8"],
        &["MW0 = 16#0042", "MB2 = 16#10", "MD4 = 16#0000_00C0", "MD8 = 16#8300_0050"],
    ),
    line(
        "a Cyrillic letter in the name of a local variable",
        "FUNCTION FC 1 : VOID\nVAR_TEMP\n MAX : INT;\nEND_VAR\nBEGIN\nL 1\nT #МАХ\nLAR1 Р##MAX\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nUC FC 1\nEND_ORGANIZATION_BLOCK\n",
        &["did you mean `#MAX`?", "did you mean `P##MAX`?"],
        "FUNCTION FC 1 : VOID\nVAR_TEMP\n MAX : INT;\nEND_VAR\nBEGIN\nL 1\nT #MAX\nLAR1 P##MAX\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nUC FC 1\nEND_ORGANIZATION_BLOCK\n",
    ),
    program(
        "letters for digits in constants",
        "L 2#1OOO_OOOO_OOOO_OOOO\nT MW 0\nL W#16#1O\nT MW 2\nL 1O\nT MW 4\nL W#16#l2\nT MW 6\n",
        &["`W#16#1O` has letters that only look like digits: did you mean `W#16#10`?", "did you mean `2#1000_0000_0000_0000`?"],
        "L 2#1000_0000_0000_0000\nT MW 0\nL W#16#10\nT MW 2\nL 10\nT MW 4\nL W#16#12\nT MW 6\n",
        &["--show", "MW0,MW2,MW4,MW6"],
        &["MW0 = 16#8000", "MW2 = 16#0010", "MW4 = 16#000A", "MW6 = 16#0012"],
    ),
    // Signs of typesetting.
    program(
        "quotes, dashes and signs of a word processor",
        "L ‘X6’\nT MW 0\nL –5\nT MW 2\nL MW 2\nL 5\n–I\nT MW 4\nL 7\nL 6\n≥I\n= M 6.0\nL\u{a0}MW\u{a0}0\n",
        &["`‘X6’` has quotes of typesetting: did you mean `'X6'`?", "did you mean `>=I`?", "did you mean `-I`?"],
        "L 'X6'\nT MW 0\nL -5\nT MW 2\nL MW 2\nL 5\n-I\nT MW 4\nL 7\nL 6\n>=I\n= M 6.0\nL\u{a0}MW\u{a0}0\n",
        &["--show", "MW0,MW2,MW4,M6.0"],
        &["MW0  = 16#5836", "MW2  = 16#FFFB", "MW4  = 16#FFF6", "M6.0 = 1"],
    ),
    // Marks of a printed page.
    line("a fence around the listing", "```awl\nA I 0.0\n= Q 0.0\n```\n", &["is a fence around a listing"], "\nA I 0.0\n= Q 0.0\n\n"),
    open(
        "an ellipsis where statements are left out",
        "JU sk2\n:\nsk2: ...\n",
        &["is an ellipsis: the page leaves out statements here", "`NOP 0`"],
    ),
    program(
        "headings instead of blocks",
        "OB 1:\nUC FC 30\nBE\nFC30: Example of a call\nSET\n= M 1.0\nBE\n",
        &["`OB 1:` is the heading of a printed block", "In a source a block stands between `FUNCTION FC 30 : VOID` and `END_FUNCTION`"],
        "ORGANIZATION_BLOCK OB 1\nUC FC 30\nBE\nEND_ORGANIZATION_BLOCK\n\nFUNCTION FC 30 : VOID\nTITLE = Example of a call\nSET\n= M 1.0\nBE\nEND_FUNCTION\n",
        &["--show", "M1.0"],
        &["M1.0 = 1"],
    ),
    line(
        "numbered networks in the languages of the courses",
        "Network 1: Opens the valve\nA I 0.0\n= Q 0.0\nNetzwerk 2\nA I 0.1\n= Q 0.1\nСеть 3: Открыть\nA I 0.2\n= Q 0.2\nOmrežje 4:\nA I 0.3\n= Q 0.3\n",
        &["`Network 1: Opens the valve` is the heading of a printed network"],
        "NETWORK\nTITLE = Opens the valve\nA I 0.0\n= Q 0.0\nNETWORK\nA I 0.1\n= Q 0.1\nNETWORK\nTITLE = Открыть\nA I 0.2\n= Q 0.2\nNETWORK\nA I 0.3\n= Q 0.3\n",
    ),
    line("a label that looks like a heading", "JU FC1\nFC1: NOP 0\n", &[], "JU FC1\nFC1: NOP 0\n"),
    // Names with spaces.
    line(
        "names of parameters with spaces",
        "FUNCTION FC 21 : VOID\nVAR_INPUT\n Step_bit_memory : WORD;\nEND_VAR\nVAR_OUTPUT\n Step_display : WORD;\nEND_VAR\nBEGIN\nL #Step_bit_memory\nT #Step_display\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 21\nStep bit memory :=MW10\nStep display :=QW12\nA BR\n= M 0.0\nEND_ORGANIZATION_BLOCK\n",
        &["`Step bit memory` has spaces, and the name of a parameter has none"],
        "FUNCTION FC 21 : VOID\nVAR_INPUT\n Step_bit_memory : WORD;\nEND_VAR\nVAR_OUTPUT\n Step_display : WORD;\nEND_VAR\nBEGIN\nL #Step_bit_memory\nT #Step_display\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 21\nStep_bit_memory :=MW10\nStep_display :=QW12\nA BR\n= M 0.0\nEND_ORGANIZATION_BLOCK\n",
    ),
    line(
        "a symbol with a space and without quotes",
        "L Recipe no// the recipe\nT MW 20\n",
        &["`Recipe no` has spaces: a symbol with spaces stands in quotes"],
        "L \"Recipe no\"// the recipe\nT MW 20\n",
    ),
    open(
        "a symbol with a space that no table has",
        "L Order no\nT MW 20\n",
        &["Write `\"Order no\"` if the symbol is called so, or `Order_no`"],
    ),
    // Words of other languages.
    open("`RET` in a statement list", "SET\nRET\n", &["In STL this is `BEC` or `BEU`"]),
    open("a bit without its area", "A 128.0\n= Q 0.0\n", &["`I 128.0`, `Q 128.0` or `M 128.0`"]),
    line("the misprint JBNI", "JBNI sk1\nsk1: NOP 0\n", &["did you mean `JNBI`?"], "JNBI sk1\nsk1: NOP 0\n"),
    // Declarations.
    line(
        "declarations without `:` and without `OF`",
        "DATA_BLOCK DB 1\nSTRUCT\n Measurement ARRAY[1..8]\n REAL;\n levelINT;\n speed INT;\n limits : ARRAY[1..8] REAL;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNOP 0\nEND_ORGANIZATION_BLOCK\n",
        &["`:` is missing before `ARRAY`", "`OF` is missing before `REAL`", "write `level : INT`", "`:` is missing before `INT`"],
        "DATA_BLOCK DB 1\nSTRUCT\n Measurement : ARRAY[1..8]\n OF REAL;\n level : INT;\n speed : INT;\n limits : ARRAY[1..8] OF REAL;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNOP 0\nEND_ORGANIZATION_BLOCK\n",
    ),
    open(
        "a declaration that can be parted twice",
        "FUNCTION FC 1 : VOID\nVAR_TEMP\n xDINT;\nEND_VAR\nBEGIN\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNOP 0\nEND_ORGANIZATION_BLOCK\n",
        &["Write `x : DINT` or `xD : INT`"],
    ),
    // Small slips.
    program(
        "parted and missing signs",
        "L 5\nL 5\n> = I\n= M 0.0\nL 0\nL 0\n+I\nA =0\n= M 0.1\nL B# (1, 10)\nT MW 2\nL P#25,3\nT MD 4\n",
        &["`> = I` has a space inside: did you mean `>=I`?", "did you mean `==0`?", "did you mean `B#(1, 10)`?"],
        "L 5\nL 5\n>=I\n= M 0.0\nL 0\nL 0\n+I\nA ==0\n= M 0.1\nL B#(1, 10)\nT MW 2\nL P#25.3\nT MD 4\n",
        &["--show", "M0.0,M0.1,MW2,MD4"],
        &["M0.0 = 1", "M0.1 = 1", "MW2  = 16#010A", "MD4  = 16#0000_00CB"],
    ),
    program(
        "AR1 as an operand of AR2",
        "LAR1 P#M 4.0\nLAR2 AR1\nTAR2\nT MD 0\nLAR2 P#M 6.0\nTAR2 AR1\nTAR1\nT MD 4\n",
        &["`LAR2 AR1` is written `TAR1 AR2`", "`TAR2 AR1` is written `LAR1 AR2`"],
        "LAR1 P#M 4.0\nTAR1 AR2\nTAR2\nT MD 0\nLAR2 P#M 6.0\nLAR1 AR2\nTAR1\nT MD 4\n",
        &["--show", "MD0,MD4"],
        &["MD0 = 16#8300_0020", "MD4 = 16#8300_0030"],
    ),
    // STEP 5.
    program(
        "operands of STEP 5 with one meaning",
        "DATA_BLOCK DB 10\nSTRUCT\n w : WORD := W#16#1234;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n\
         A F 10.0\nJC =skip\nL KF +10\nT FW 20\nL KH 00FF\nT FW 22\nL KM 00000001 00000010\nT FW 24\nL KT 10.2\nT FW 26\nL KZ 100\nT FW 28\nL KY 1,10\nT FW 30\nL KC 'AB'\nT FW 32\n\
         C DB 10\nL DBW 0\nT FW 34\nskip: NOP 0\nEND_ORGANIZATION_BLOCK\n",
        &[
            "`F 10.0` is an operand of STEP 5",
            "write `S5T#10S`",
            "`=skip` is a label of STEP 5",
            "`C` with a data block is an instruction of STEP 5",
        ],
        "DATA_BLOCK DB 10\nSTRUCT\n w : WORD := W#16#1234;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n\
         A M 10.0\nJC skip\nL 10\nT MW 20\nL W#16#00FF\nT MW 22\nL 2#00000001_00000010\nT MW 24\nL S5T#10S\nT MW 26\nL C#100\nT MW 28\nL B#(1,10)\nT MW 30\nL 'AB'\nT MW 32\n\
         OPN DB 10\nL DBW 0\nT MW 34\nskip: NOP 0\nEND_ORGANIZATION_BLOCK\n",
        &["--show", "MW20,MW22,MW24,MW26,MW28,MW30,MW32,MW34"],
        &[
            "MW20 = 16#000A",
            "MW22 = 16#00FF",
            "MW24 = 16#0102",
            "MW26 = 16#1100",
            "MW28 = 16#0100",
            "MW30 = 16#010A",
            "MW32 = 16#4142",
            "MW34 = 16#1234",
        ],
    ),
    open("a data word of STEP 5", "L DW 5\nT MW 0\n", &["Write `DBW 10` or `DBW 5`: STEP 5 counts the words of a data block"]),
    open("a data bit of STEP 5", "A D 5.11\n= M 0.0\n", &["Write `DBX 10.3` or `DBX 5.3`"]),
    line(
        "a call of STEP 5",
        "JU FC 5\nBE\nFC 5:\nSET\n",
        &["`JU FC 5` calls a block in STEP 5", "`UC FC 5`"],
        "UC FC 5\nBE\nFUNCTION FC 5 : VOID\nSET\nEND_FUNCTION\n",
    ),
];

/// All that a list of diagnostics says: messages, helps, and what the fixes do.
fn said(json: &str) -> String {
    fn strings(value: &serde_json::Value, out: &mut String) {
        match value {
            serde_json::Value::String(text) => {
                out.push_str(text);
                out.push('\n');
            }
            serde_json::Value::Array(list) => list.iter().for_each(|value| strings(value, out)),
            serde_json::Value::Object(fields) => fields.values().for_each(|value| strings(value, out)),
            _ => {}
        }
    }
    let mut out = String::new();
    strings(&serde_json::from_str(json).unwrap_or_else(|error| panic!("{error}: {json}")), &mut out);
    out
}

#[test]
fn slips_are_named_fixed_and_run() {
    let mut failures = Vec::new();
    for slip in SLIPS {
        let folder = Folder::with(&[("slip.awl", slip.source), ("symbols.csv", "Symbol,Address,Type\nRecipe no,MW 200,INT\n")]);
        let paths = ["slip.awl", "symbols.csv"];
        let with = |verb: &[&'static str]| [verb, &paths].concat();
        let said = said(&folder.run(&with(&["check", "--json"])).stdout);
        for part in slip.says.iter().filter(|part| !said.contains(**part)) {
            failures.push(format!("{}: `{part}` is not said\n{said}", slip.what));
        }
        let run = folder.run(&with(&["check", "--fix"]));
        let fixed = String::from_utf8(folder.read("slip.awl")).expect("UTF-8");
        if fixed != slip.fixed {
            failures.push(format!("{}: --fix makes\n{fixed}\ninstead of\n{}\n{}{}", slip.what, slip.fixed, run.stdout, run.stderr));
        }
        let Some((arguments, prints)) = slip.runs else {
            if run.code != Some(3) {
                failures.push(format!("{}: it compiles\n{}{}", slip.what, run.stdout, run.stderr));
            }
            continue;
        };
        for engine in ["interpreter", "jit"] {
            let ran = folder.run(&[&with(&["exec", "--engine", engine]), arguments].concat());
            if ran.code != Some(0) {
                failures.push(format!("{}: {engine}\n{}{}", slip.what, ran.stdout, ran.stderr));
            }
            for part in prints.iter().filter(|part| !ran.stdout.contains(**part)) {
                failures.push(format!("{}: {engine} does not print `{part}`\n{}", slip.what, ran.stdout));
            }
        }
    }
    assert!(failures.is_empty(), "{} failures\n\n{}", failures.len(), failures.join("\n\n"));
}
