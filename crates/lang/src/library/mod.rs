//! The blocks that Sieben brings along as STL sources: the IEC functions, the converting blocks of the S7 library and its controllers.

pub(crate) mod link;

use std::collections::BTreeMap;
use std::fmt;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::source::FileId;

use crate::scope::key;

/// One block of the library.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct LibraryBlock {
    /// The number it has unless a project places it elsewhere: `FC 2`.
    pub block: BlockId,
    /// Its name: `CONCAT`.
    pub name: &'static str,
    /// Where its source lies in the repository; places inside it are shown with this name.
    pub path: &'static str,
    /// Its source in international mnemonics.
    pub text: &'static str,
}

impl fmt::Debug for LibraryBlock {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} {}", self.block, self.name)
    }
}

/// The one list of the blocks: kind, number, name, source.
macro_rules! blocks {
    ($($kind:ident $number:literal $name:literal $path:literal;)*) => {
        /// All blocks, functions first, in the order of their numbers.
        pub const ALL: &[LibraryBlock] = &[$(LibraryBlock {
            block: BlockId::new(BlockKind::$kind, $number),
            name: $name,
            path: concat!("library/", $path),
            text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../library/", $path)),
        }),*];
    };
}

blocks! {
    Function 1 "AD_DT_TM" "iec/fc001_ad_dt_tm.awl";
    Function 2 "CONCAT" "iec/fc002_concat.awl";
    Function 3 "D_TOD_DT" "iec/fc003_d_tod_dt.awl";
    Function 4 "DELETE" "iec/fc004_delete.awl";
    Function 5 "DI_STRNG" "iec/fc005_di_strng.awl";
    Function 6 "DT_DATE" "iec/fc006_dt_date.awl";
    Function 7 "DT_DAY" "iec/fc007_dt_day.awl";
    Function 8 "DT_TOD" "iec/fc008_dt_tod.awl";
    Function 9 "EQ_DT" "iec/fc009_eq_dt.awl";
    Function 10 "EQ_STRNG" "iec/fc010_eq_strng.awl";
    Function 11 "FIND" "iec/fc011_find.awl";
    Function 12 "GE_DT" "iec/fc012_ge_dt.awl";
    Function 13 "GE_STRNG" "iec/fc013_ge_strng.awl";
    Function 14 "GT_DT" "iec/fc014_gt_dt.awl";
    Function 15 "GT_STRNG" "iec/fc015_gt_strng.awl";
    Function 16 "I_STRNG" "iec/fc016_i_strng.awl";
    Function 17 "INSERT" "iec/fc017_insert.awl";
    Function 18 "LE_DT" "iec/fc018_le_dt.awl";
    Function 19 "LE_STRNG" "iec/fc019_le_strng.awl";
    Function 20 "LEFT" "iec/fc020_left.awl";
    Function 21 "LEN" "iec/fc021_len.awl";
    Function 22 "LIMIT" "iec/fc022_limit.awl";
    Function 23 "LT_DT" "iec/fc023_lt_dt.awl";
    Function 24 "LT_STRNG" "iec/fc024_lt_strng.awl";
    Function 25 "MAX" "iec/fc025_max.awl";
    Function 26 "MID" "iec/fc026_mid.awl";
    Function 27 "MIN" "iec/fc027_min.awl";
    Function 28 "NE_DT" "iec/fc028_ne_dt.awl";
    Function 29 "NE_STRNG" "iec/fc029_ne_strng.awl";
    Function 30 "R_STRNG" "iec/fc030_r_strng.awl";
    Function 31 "REPLACE" "iec/fc031_replace.awl";
    Function 32 "RIGHT" "iec/fc032_right.awl";
    Function 33 "S5TI_TIM" "iec/fc033_s5ti_tim.awl";
    Function 34 "SB_DT_DT" "iec/fc034_sb_dt_dt.awl";
    Function 35 "SB_DT_TM" "iec/fc035_sb_dt_tm.awl";
    Function 36 "SEL" "iec/fc036_sel.awl";
    Function 37 "STRNG_DI" "iec/fc037_strng_di.awl";
    Function 38 "STRNG_I" "iec/fc038_strng_i.awl";
    Function 39 "STRNG_R" "iec/fc039_strng_r.awl";
    Function 40 "TIM_S5TI" "iec/fc040_tim_s5ti.awl";
    Function 93 "SEG" "ti/fc093_seg.awl";
    Function 96 "ENCO" "ti/fc096_enco.awl";
    Function 97 "DECO" "ti/fc097_deco.awl";
    Function 98 "BCDCPL" "ti/fc098_bcdcpl.awl";
    Function 99 "BITSUM" "ti/fc099_bitsum.awl";
    Function 105 "SCALE" "ti/fc105_scale.awl";
    Function 106 "UNSCALE" "ti/fc106_unscale.awl";
    FunctionBlock 41 "CONT_C" "controllers/fb041_cont_c.awl";
    FunctionBlock 42 "CONT_S" "controllers/fb042_cont_s.awl";
    FunctionBlock 43 "PULSEGEN" "controllers/fb043_pulsegen.awl";
}

/// The block with this name, without regard to case.
pub fn by_name(name: &str) -> Option<&'static LibraryBlock> {
    ALL.iter().find(|block| block.name.eq_ignore_ascii_case(name))
}

/// The block that has this number unless a project places it elsewhere.
pub fn by_block(block: BlockId) -> Option<&'static LibraryBlock> {
    ALL.iter().find(|one| one.block == block)
}

/// The source of the block with this name.
pub fn source(name: &str) -> Option<&'static str> {
    by_name(name).map(|block| block.text)
}

/// What a project takes from the library.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// Whether calls of blocks that the project does not define are looked up in the library.
    pub enabled: bool,
    /// Only blocks that the project or its symbol table gives a number are taken, and none by the number that it has as ever.
    pub only_chosen: bool,
    /// Numbers that the project gives to library blocks, by name: `CONCAT` → `FC 102`.
    pub numbers: BTreeMap<String, BlockId>,
}

impl Default for Selection {
    fn default() -> Self {
        Self { enabled: true, only_chosen: false, numbers: BTreeMap::new() }
    }
}

impl Selection {
    /// The number that the project gives to a block of the library.
    pub fn number(&self, block: &LibraryBlock) -> Option<BlockId> {
        self.numbers.iter().find(|(name, _)| key(name) == key(block.name)).map(|(_, number)| *number)
    }
}

/// A block of the library that belongs to a program because something there names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Linked {
    /// The number it has in this program.
    pub id: BlockId,
    /// Which block it is.
    pub block: &'static LibraryBlock,
    /// Its source among those of the program, behind the user's.
    pub file: FileId,
}
