//! Blocks as a page of HTML: each network with what it names, and where else that is used.

use std::collections::BTreeMap;

use sieben_ide::cross_reference::{CrossReference, Reference};
use sieben_ide::drawing::page::{self, BlockPage, NetworkPage, PageContent, SymbolRow};
use sieben_ide::drawing::svg;
use sieben_ide::target::Target;
use sieben_model::block::BlockId;

use super::{CodeBlock, Diagrams, Form, Shown, Written};
use crate::controller;

/// Places of a symbol that are listed; a clock memory bit is used in hundreds.
const REFERENCES_MAX: usize = 20;

/// What the networks of a program name: block and network, targets.
type Named<'c> = BTreeMap<(BlockId, u32), Vec<(&'c Target, &'c [Reference])>>;

/// The chosen networks of blocks as a page.
pub(crate) fn html(diagrams: &Diagrams<'_>, chosen: &[(BlockId, &CodeBlock, Vec<&Written>)], form: Form) -> String {
    let references = CrossReference::new(&diagrams.build().compiled);
    let named = named(&references);
    let page = |(id, block, networks): &(BlockId, &CodeBlock, Vec<&Written>)| {
        let networks =
            networks.iter().map(|written| network_page(diagrams, *id, written, &diagrams.shown(*id, written, form, None), &named));
        block_page(diagrams, *id, block, networks.collect())
    };
    let blocks: Vec<BlockPage> = chosen.iter().map(page).collect();
    let title = match blocks.as_slice() {
        [one] => one.name.clone(),
        _ => "Networks".to_owned(),
    };
    page::html(&title, &blocks)
}

/// One network, as it is shown.
pub(crate) fn html_of(diagrams: &Diagrams<'_>, id: BlockId, block: &CodeBlock, written: &Written, shown: &Shown) -> String {
    let references = CrossReference::new(&diagrams.build().compiled);
    let network = network_page(diagrams, id, written, shown, &named(&references));
    let block = block_page(diagrams, id, block, vec![network]);
    page::html(&block.name.clone(), &[block])
}

fn named(references: &CrossReference) -> Named<'_> {
    let mut named: Named<'_> = BTreeMap::new();
    for (target, uses) in references.entries() {
        let mut places: Vec<(BlockId, u32)> = uses.iter().map(|one| (one.block, one.network)).collect();
        places.sort_unstable();
        places.dedup();
        for place in places {
            named.entry(place).or_default().push((target, uses));
        }
    }
    named
}

fn block_page(diagrams: &Diagrams<'_>, id: BlockId, block: &CodeBlock, networks: Vec<NetworkPage>) -> BlockPage {
    BlockPage {
        name: controller::name_in_source(diagrams.build(), id).map_or_else(|| id.to_string(), str::to_owned),
        symbol: controller::name_in_source(diagrams.build(), id)
            .is_none()
            .then(|| diagrams.places.block_symbol(id))
            .filter(|symbol| !symbol.is_empty()),
        title: block.title.clone(),
        comment: block.comment.clone(),
        header: block.header.clone(),
        networks,
    }
}

fn network_page(diagrams: &Diagrams<'_>, id: BlockId, written: &Written, shown: &Shown, named: &Named<'_>) -> NetworkPage {
    let used = named.get(&(id, written.number)).map_or(&[][..], Vec::as_slice);
    NetworkPage {
        number: written.number as usize,
        title: written.title.clone(),
        comment: written.comment.clone(),
        content: content(shown, written),
        reason: shown.reason.clone(),
        symbols: used.iter().filter(|(target, _)| !target.is_local()).map(|(target, uses)| row(diagrams, target, uses)).collect(),
    }
}

fn content(shown: &Shown, written: &Written) -> PageContent {
    match shown.picture() {
        Some(picture) => PageContent::Picture(svg::svg(&picture)),
        None => PageContent::Statements(written.text.clone()),
    }
}

fn row(diagrams: &Diagrams<'_>, target: &Target, uses: &[Reference]) -> SymbolRow {
    let places = diagrams.places;
    let symbol = places.symbol(target);
    let known = diagrams.build().project.symbols.find(&symbol);
    let mut references: Vec<String> = uses
        .iter()
        .map(|one| match one.network {
            0 => format!("{} {}", one.block, one.usage.word()),
            network => format!("{}/{network} {}", one.block, one.usage.word()),
        })
        .collect();
    references.dedup();
    if references.len() > REFERENCES_MAX {
        let more = references.len() - REFERENCES_MAX;
        references.truncate(REFERENCES_MAX);
        references.push(format!("{more} more"));
    }
    SymbolRow {
        address: target.spell(places.mnemonics),
        data_type: known.map(|symbol| symbol.data_type.trim().to_owned()).filter(|text| !text.is_empty()),
        comment: known.map(|symbol| symbol.comment.trim().to_owned()).filter(|text| !text.is_empty()),
        symbol: Some(symbol).filter(|symbol| !symbol.is_empty()),
        references,
    }
}
