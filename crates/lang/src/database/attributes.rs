//! What the headers of blocks say of them.

use std::collections::BTreeMap;

use sieben_model::block::{BlockAttributes, BlockId, BlockKind, BlockLanguage};

use super::declarations::Names;
use crate::network::flavour::Drawing;
use crate::st::ast as st;
use crate::st::dialect::Dialect;
use crate::stl::ast as stl;

const KNOW_HOW_PROTECT: &str = "KNOW_HOW_PROTECT";

/// The attributes of all blocks that have a header, or a language that is not that of their kind.
pub(super) fn attributes(names: &Names<'_>) -> BTreeMap<BlockId, BlockAttributes> {
    let of_stl = names.found.iter().filter(|found| found.id.kind != BlockKind::UserDefinedType);
    let of_stl = of_stl.map(|found| (found.id, of_stl_block(found.block)));
    let of_code = names.items.code.iter().map(|(&id, code)| (id, of_header(&code.block.header, language(code.dialect))));
    let of_data = names.items.data.iter().map(|(&number, data)| (BlockId::db(number), of_header(&data.block.header, BlockLanguage::Data)));
    of_stl.chain(of_code).chain(of_data).collect()
}

fn of_stl_block(block: &stl::Block) -> BlockAttributes {
    let stl::Header { title, author, family, name, version, flags, .. } = &block.header;
    let text = |word: &Option<stl::Word>| word.as_ref().map_or_else(String::new, |word| word.text.clone());
    BlockAttributes {
        title: text(title),
        author: text(author),
        family: text(family),
        name: text(name),
        version: version_of(&text(version)),
        know_how_protected: flags.iter().any(|flag| flag.text.eq_ignore_ascii_case(KNOW_HOW_PROTECT)),
        language: match block.kind {
            BlockKind::DataBlock => BlockLanguage::Data,
            _ => drawn(&block.networks),
        },
    }
}

fn of_header(header: &st::Header, language: BlockLanguage) -> BlockAttributes {
    let st::Header { title, author, family, name, version, flags } = header;
    let text = |name: &Option<st::Name>| name.as_ref().map_or_else(String::new, |name| name.text.clone());
    BlockAttributes {
        title: text(title),
        author: text(author),
        family: text(family),
        name: text(name),
        version: version_of(&text(version)),
        know_how_protected: flags.iter().any(|flag| flag.is(KNOW_HOW_PROTECT)),
        language,
    }
}

/// `1.0`; what is none is the version of a block without one.
fn version_of(text: &str) -> (u8, u8) {
    let parts = text.split_once('.').and_then(|(major, minor)| Some((major.trim().parse().ok()?, minor.trim().parse().ok()?)));
    parts.unwrap_or(BlockAttributes::of(BlockLanguage::Stl).version)
}

fn drawn(networks: &[stl::Network]) -> BlockLanguage {
    let first = networks.first().filter(|first| first.first_statement == 0);
    match first.and_then(|first| first.drawing) {
        Some(first) if networks.iter().all(|network| network.drawing.is_some()) => match first {
            Drawing::Lad => BlockLanguage::Lad,
            Drawing::Fbd => BlockLanguage::Fbd,
        },
        _ => BlockLanguage::Stl,
    }
}

fn language(dialect: Dialect) -> BlockLanguage {
    [BlockLanguage::St, BlockLanguage::St, BlockLanguage::Scl, BlockLanguage::Scl][dialect.column()]
}
