//! Blocks as a page of HTML: each network with what it names, and where else that is used.

use std::collections::BTreeMap;
use std::rc::Rc;

use sieben_ide::cross_reference::{CrossReference, Reference};
use sieben_ide::drawing::page::{self, BlockPage, NetworkPage, PageContent, SymbolRow};
use sieben_ide::drawing::svg;
use sieben_ide::target::Target;
use sieben_model::block::BlockId;
use sieben_workspace::controller;

use super::{CodeBlock, Diagrams, ElementPlaces, Form, Shown, Written};

/// Places of a symbol that are listed; a clock memory bit is used in hundreds.
const REFERENCES_MAX: usize = 20;

/// What the networks of a program name: block and network, rows of their tables.
type Named = BTreeMap<(BlockId, u32), Vec<Rc<SymbolRow>>>;

/// The chosen networks of blocks as a page.
pub(crate) fn html(diagrams: &Diagrams<'_>, chosen: &[(BlockId, &CodeBlock, Vec<&Written>)], form: Form) -> String {
    let references = CrossReference::new(&diagrams.build().compiled);
    let named = named(diagrams, &references);
    let page = |(id, block, networks): &(BlockId, &CodeBlock, Vec<&Written>)| {
        let networks = networks.iter().map(|written| network_page(*id, written, &diagrams.shown(*id, written, form, None), &named));
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
    let network = network_page(id, written, shown, &named(diagrams, &references));
    let block = block_page(diagrams, id, block, vec![network]);
    page::html(&block.name.clone(), &[block])
}

/// The number of the network that a reference stands in; 0 in a block without networks.
fn network_of(diagrams: &Diagrams<'_>, reference: &Reference) -> u32 {
    if reference.network > 0 {
        return reference.network;
    }
    let begins_before = |network: &Written| match network.places {
        ElementPlaces::Bytes(file, from) => file == reference.span.file && from <= reference.span.start,
        ElementPlaces::Statements(_) => false,
    };
    let networks = diagrams.blocks.get(&reference.block).map_or(&[][..], |block| &block.networks);
    match networks.partition_point(begins_before) {
        0 => 0,
        count => networks[count - 1].number,
    }
}

/// `FC 1/2 R`: a place with what happens there.
fn place(diagrams: &Diagrams<'_>, reference: &Reference) -> ((BlockId, u32), String) {
    let network = network_of(diagrams, reference);
    let block = controller::name_in_source(diagrams.build(), reference.block).map_or_else(|| reference.block.to_string(), str::to_owned);
    let number = if network > 0 { format!("/{network}") } else { String::new() };
    ((reference.block, network), format!("{block}{number} {}", reference.usage.word()))
}

fn named(diagrams: &Diagrams<'_>, references: &CrossReference) -> Named {
    let mut named: Named = BTreeMap::new();
    for (target, uses) in references.entries().filter(|(target, _)| !target.is_local()) {
        let (mut places, mut texts): (Vec<(BlockId, u32)>, Vec<String>) = uses.iter().map(|one| place(diagrams, one)).unzip();
        texts.dedup();
        if texts.len() > REFERENCES_MAX {
            let more = texts.len() - REFERENCES_MAX;
            texts.truncate(REFERENCES_MAX);
            texts.push(format!("{more} more"));
        }
        let row = Rc::new(row(diagrams, target, texts));
        places.sort_unstable();
        places.dedup();
        for place in places {
            named.entry(place).or_default().push(Rc::clone(&row));
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

fn network_page(id: BlockId, written: &Written, shown: &Shown, named: &Named) -> NetworkPage {
    let used = named.get(&(id, written.number)).map_or(&[][..], Vec::as_slice);
    NetworkPage {
        number: written.number as usize,
        title: written.title.clone(),
        comment: written.comment.clone(),
        content: content(shown, written),
        reason: shown.reason.clone(),
        symbols: used.to_vec(),
    }
}

fn content(shown: &Shown, written: &Written) -> PageContent {
    match shown.picture() {
        Some(picture) => PageContent::Picture(svg::svg(&picture)),
        None => PageContent::Statements(written.text.clone()),
    }
}

fn row(diagrams: &Diagrams<'_>, target: &Target, references: Vec<String>) -> SymbolRow {
    let places = diagrams.places;
    let symbol = places.symbol(target);
    let known = diagrams.build().project.symbols.find(&symbol);
    SymbolRow {
        address: target.spell(places.mnemonics),
        data_type: known.map(|symbol| symbol.data_type.trim().to_owned()).filter(|text| !text.is_empty()),
        comment: known.map(|symbol| symbol.comment.trim().to_owned()).filter(|text| !text.is_empty()),
        symbol: Some(symbol).filter(|symbol| !symbol.is_empty()),
        references,
    }
}
