//! The blocks of the CPU and those that wait in its load memory: counts, lists, headers, images.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use sieben_cpu::{BlockView, DateAndTime, Station, system};
use sieben_model::block::{BlockId, BlockKind, BlockLanguage};
use sieben_workspace::gate::Plant;

use super::stored::StoredBlocks;
use crate::s7comm::job::{BlockEntry, BlockName, BlockPlace, BlockType, Download, Reply};
use crate::s7comm::wire::block_image::{FRAME_BYTES, Frame, Image, Interface};
use crate::s7comm::wire::blocks::{LINKED, PASSIVE, SYSTEM};
use crate::s7comm::wire::codes::Refusal;

/// The language of system blocks.
const SYSTEM_LANGUAGE: u8 = 1;
/// The names of the system functions and system function blocks that the CPU has.
static SYSTEM_BLOCKS: LazyLock<BTreeMap<BlockId, &'static str>> =
    LazyLock::new(|| system::numbered().into_iter().filter(|block| block.only.is_none()).map(|block| (block.block, block.name)).collect());

/// The code of a language. Structured Text of other dialects has none: it is shown as SCL.
fn language(language: BlockLanguage) -> u8 {
    match language {
        BlockLanguage::Stl => 1,
        BlockLanguage::Lad => 2,
        BlockLanguage::Fbd => 3,
        BlockLanguage::Scl | BlockLanguage::St => 4,
        BlockLanguage::Data => 5,
        BlockLanguage::CreatedData => 8,
    }
}

/// All blocks of a type, each number once.
fn entries(plant: &Plant, stored: &StoredBlocks, block_type: BlockType) -> BTreeMap<u16, BlockEntry> {
    let passive = stored.of_type(block_type).map(|(number, image)| {
        let language = image.get(4).copied().unwrap_or(0);
        (number, BlockEntry { number, flags: PASSIVE, language })
    });
    let mut entries: BTreeMap<u16, BlockEntry> = passive.collect();
    let Some(kind) = block_type.kind() else { return entries };
    let of_cpu = plant.cpu.blocks().into_iter().filter(|id| id.kind == kind).filter_map(|id| plant.cpu.block(id));
    entries.extend(of_cpu.map(|view| {
        let flags = if view.unlinked { PASSIVE } else { LINKED };
        (view.id.number, BlockEntry { number: view.id.number, flags, language: language(view.attributes.language) })
    }));
    let system = SYSTEM_BLOCKS.keys().filter(|id| id.kind == kind);
    entries.extend(system.map(|id| (id.number, BlockEntry { number: id.number, flags: SYSTEM, language: SYSTEM_LANGUAGE })));
    entries
}

/// How many blocks there are of each type, each number once.
pub(super) fn counts(plant: &Plant, stored: &StoredBlocks) -> Reply {
    let of_cpu: BTreeSet<BlockId> = plant.cpu.blocks().into_iter().chain(SYSTEM_BLOCKS.keys().copied()).collect();
    let count = |block_type: BlockType| {
        let is_of_cpu = |number: u16| block_type.kind().is_some_and(|kind| of_cpu.contains(&BlockId::new(kind, number)));
        let passive = stored.of_type(block_type).filter(|&(number, _)| !is_of_cpu(number)).count();
        let active = of_cpu.iter().filter(|id| Some(id.kind) == block_type.kind()).count();
        u16::try_from(active + passive).unwrap_or(u16::MAX)
    };
    Reply::BlockCounts(BlockType::all().map(|block_type| (block_type, count(block_type))).collect())
}

/// The blocks of a type.
pub(super) fn list(plant: &Plant, stored: &StoredBlocks, block_type: BlockType) -> Reply {
    let entries = entries(plant, stored, block_type);
    if entries.is_empty() { Reply::Refused(Refusal::NoFurtherBlock) } else { Reply::BlockList(entries.into_values().collect()) }
}

/// What a name means.
enum Found<'s> {
    /// A block that the CPU runs with, or one that is UNLINKED.
    Loaded(Box<BlockView>),
    /// A block that belongs to the CPU.
    System(&'static str),
    /// The image of one that was downloaded and not linked.
    Stored(&'s [u8]),
}

/// The block of a name. Clients ask for the linked block of every number in a list, so a passive one is found under that name too.
fn find<'s>(plant: &Plant, stored: &'s StoredBlocks, name: BlockName) -> Option<Found<'s>> {
    let passive = || stored.image(name.block_type, name.number).map(Found::Stored);
    let active = || {
        let id = BlockId::new(name.block_type.kind()?, name.number);
        let system = || SYSTEM_BLOCKS.get(&id).map(|name| Found::System(name));
        plant.cpu.block(id).map(|view| Found::Loaded(Box::new(view))).or_else(system)
    };
    match name.place {
        BlockPlace::Active | BlockPlace::Both => active().or_else(passive),
        BlockPlace::Passive => passive().or_else(active),
    }
}

/// Header and footer of a block of the CPU. Its code has no length until there is machine code of it.
fn frame(view: &BlockView, block_type: BlockType) -> Frame {
    let attributes = &view.attributes;
    let low = |version: u8| version.min(0xF);
    Frame {
        block_type,
        number: view.id.number,
        language: language(attributes.language),
        linked: !view.unlinked,
        know_how_protected: attributes.know_how_protected,
        non_retain: view.non_retain,
        loaded: view.loaded,
        body_bytes: u16::try_from(view.data_bytes).unwrap_or(u16::MAX),
        local_bytes: u16::try_from(view.local_bytes).unwrap_or(u16::MAX),
        interface: interface(view),
        names: [&attributes.author, &attributes.family, &attributes.name].map(String::clone),
        version: (low(attributes.version.0), low(attributes.version.1)),
    }
}

/// The interface that the image of a block has.
fn interface(view: &BlockView) -> Interface {
    let of_block = view.based_on.filter(|id| matches!(id.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock));
    match of_block {
        _ if view.id.kind != BlockKind::DataBlock => Interface::None,
        Some(block) => Interface::Instance(block.number),
        None => Interface::Shared,
    }
}

/// Header and footer of a block that belongs to the CPU.
fn system_frame(name: BlockName, called: &str) -> Frame {
    Frame {
        block_type: name.block_type,
        number: name.number,
        language: SYSTEM_LANGUAGE,
        linked: true,
        know_how_protected: true,
        non_retain: false,
        loaded: DateAndTime::DEFAULT,
        body_bytes: 0,
        local_bytes: 0,
        interface: Interface::None,
        names: [String::new(), String::new(), called.to_owned()],
        version: (1, 0),
    }
}

/// What the header of a block says.
pub(super) fn info(plant: &Plant, stored: &StoredBlocks, name: BlockName) -> Reply {
    let framed = |place: BlockPlace, frame: &Frame| {
        let name = BlockName { place, ..name };
        Reply::BlockInfo { name, header: frame.header(), footer: frame.footer() }
    };
    match find(plant, stored, name) {
        Some(Found::Loaded(view)) => {
            let place = if view.unlinked { BlockPlace::Passive } else { BlockPlace::Active };
            framed(place, &frame(&view, name.block_type))
        }
        Some(Found::System(called)) => framed(BlockPlace::Active, &system_frame(name, called)),
        Some(Found::Stored(image)) => match Image::read(image) {
            Ok(image) => {
                Reply::BlockInfo { name: BlockName { place: BlockPlace::Passive, ..name }, header: image.header, footer: image.footer }
            }
            Err(refusal) => Reply::Refused(refusal),
        },
        None => Reply::Refused(Refusal::BlockNotFound),
    }
}

/// The image of a block: that of a data block has the values of this moment, one that was only stored comes back as it came. Code that was
/// made from a source has no machine code to give, as a block that is protected.
pub(super) fn upload(plant: &Plant, stored: &StoredBlocks, name: BlockName) -> Reply {
    match find(plant, stored, name) {
        Some(Found::Loaded(view)) if view.id.kind == BlockKind::DataBlock => {
            let values = plant.cpu.data_block_values(view.id.number);
            let image = values.and_then(|values| frame(&view, name.block_type).image(&values));
            image.map_or(Reply::Refused(Refusal::BlockTooLarge), Reply::Image)
        }
        Some(Found::Loaded(_) | Found::System(_)) => Reply::Refused(Refusal::Protected),
        Some(Found::Stored(image)) => Reply::Image(image.to_vec()),
        None => Reply::Refused(Refusal::BlockNotFound),
    }
}

/// Takes a block that has come: it is passive until it is linked.
pub(super) fn download(plant: &Plant, stored: &mut StoredBlocks, download: &Download) -> Reply {
    let judged = Image::read(&download.image).and_then(|image| judge(plant, &image, download));
    let kept = judged.and_then(|()| stored.keep(download.name.block_type, download.name.number, download.image.clone()));
    kept.map_or_else(Reply::Refused, |()| Reply::Done)
}

/// Whether a CPU of this type takes such a block.
fn judge(plant: &Plant, image: &Image<'_>, download: &Download) -> Result<(), Refusal> {
    let cpu = plant.cpu.cpu_type();
    if (image.block_type, image.number) != (download.name.block_type, download.name.number) {
        return Err(Refusal::BlockStructure);
    }
    let number = image.number;
    let has_number = match image.block_type {
        BlockType::OrganizationBlock => cpu.has_organization_block(number),
        BlockType::DataBlock => (1..=cpu.db_number_max).contains(&number),
        BlockType::Function | BlockType::FunctionBlock => number <= cpu.fc_number_max,
        BlockType::SystemDataBlock => true,
        // They belong to the CPU.
        BlockType::SystemFunction | BlockType::SystemFunctionBlock => return Err(Refusal::Protected),
    };
    if !has_number {
        return Err(Refusal::BlockNumber);
    }
    if download.image.len().saturating_sub(FRAME_BYTES) as u64 > u64::from(cpu.block_size_max) {
        return Err(Refusal::BlockTooLarge);
    }
    let is_data = image.block_type == BlockType::DataBlock;
    if is_data && (image.body.is_empty() || !image.body.len().is_multiple_of(2)) {
        return Err(Refusal::BlockLengths);
    }
    Ok(())
}
