//! How long diagrams take: `cargo bench -p sieben-app --bench diagrams`.
//!
//! A block of 1,000 networks is read and drawn, as text and as SVG, and one of them is changed; then one network of 10,000 contacts, in which
//! the time of a contact shows whether the layout is linear. A figure is CPU time of the thread, because other work on the machine only ever adds time.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

use rustix::time::{ClockId, clock_gettime};
use sieben_ide::drawing::svg::{Picture, svg};
use sieben_ide::drawing::text::{Characters, text};
use sieben_ide::drawing::{Layout, Options as Drawn, function_plan, ladder};
use sieben_lang::network::flavour::Drawing;
use sieben_lang::network::model::{Content, End, Kind, Network, OutputKind, Place, Rung};
use sieben_lang::network::read::{Answer, Mode};
use sieben_lang::stl::redraw::{Form, Redrawing, Source, Target};
use sieben_lang::{CheckedBody, Database, Options, compile};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

/// Networks of the block.
const NETWORKS: usize = 1_000;
/// How often each figure is taken.
const ROUNDS: usize = 20;

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// What the networks hold, one after another: `_#` is a label, @ a byte.
const KINDS: [&str; 6] = [
    "A( ; O I 0.0; O M @.1; ); AN I 0.1; A I 0.2; = M @.1;",
    "A I 0.0; JNB _#; L MW 10; L 100; +I ; T MW 12; AN OV; SAVE; CLR; _#: A BR; = M @.2;",
    "A I 0.0; A( ; L MW 20; L 5; >I ; ); AN M 1.0; S M @.3; R M @.4;",
    "A M 1.0; L S5T#2S; SD T 5; A I 0.7; R T 5; L T 5; T MW 30; NOP 0; A T 5; = M @.5;",
    "A I 0.0; FP M @.0; O ; A I 0.1; A I 0.2; O I 0.3; = M @.6;",
    "A I 0.0; = L 0.0; A L 0.0; BLD 102; = M @.7; A L 0.0; A I 0.5; = M @.1;",
];

fn block() -> String {
    let mut source = "FUNCTION FC 1 : VOID\nBEGIN\n".to_owned();
    for number in 0..NETWORKS {
        let body = KINDS[number % KINDS.len()].replace('@', &(number % 200 + 50).to_string()).replace("_#", &format!("_{number}"));
        source += &format!("NETWORK\nTITLE = {number}\n{body}\n");
    }
    source + "END_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1;\nEND_ORGANIZATION_BLOCK\n"
}

/// A contact after another.
fn row(count: usize) -> Network {
    let line =
        (0..count).map(|index| Kind::contact(format!("I {}.{}", index / 8, index % 8), false).at(Place::new(index, index))).collect();
    let outputs = vec![OutputKind::Assign("Q 4.0".into()).at(Place::new(count, count))];
    Network { label: None, content: Content::Rung(Rung::new(line, End::Outputs(outputs))) }
}

/// CPU time of this thread in milliseconds.
fn now_ms() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e3 + time.tv_nsec as f64 / 1e6
}

fn row_of(name: &str, mut work: impl FnMut() -> usize) {
    let mut sum = 0;
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let begin = now_ms();
            sum += work();
            now_ms() - begin
        })
        .collect();
    times.sort_unstable_by(f64::total_cmp);
    println!("| {name} | {:.1} ms | {:.1} ms | {:.1} ms | {} |", times[0], times[ROUNDS / 2], times[ROUNDS - 1], sum / ROUNDS);
}

/// One of 1,000 networks is changed, which stand in so many blocks, each in its file: the time until all diagnostics are known again.
fn changed_network(blocks: usize) {
    let row = |number: usize| format!("NETWORK LAD\n    NO    I 0.{}\n    NC    I 1.0\n    COIL  M {}.0\n", number % 8, number % 200 + 50);
    let block = |id: usize, changed: &str| {
        let each = NETWORKS / blocks;
        let networks: String = (0..each).map(|number| if number == each / 2 { changed.to_owned() } else { row(number) }).collect();
        format!("FUNCTION FC {id} : VOID\nBEGIN\n{networks}END_FUNCTION\n")
    };
    let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let mut database = Database::new(SymbolTable::default(), options);
    let calls: String = (1..=blocks).map(|id| format!("NETWORK LAD\n    CALL FC {id}\n")).collect();
    database.add("main.awl", format!("ORGANIZATION_BLOCK OB 1\nBEGIN\n{calls}END_ORGANIZATION_BLOCK\n"));
    let files: Vec<_> = (1..=blocks).map(|id| database.add(format!("{id}.awl"), block(id, &row(0)))).collect();
    assert!(database.diagnostics().is_empty(), "the blocks have no mistake");
    let changed = |round: usize| block(1, &format!("NETWORK LAD\n    NO    I 0.{}\n    SET   M 1.{}\n", round % 8, round % 7));
    let mut changes: Vec<String> = (0..ROUNDS).map(changed).collect();
    row_of(&format!("one of 1,000 networks changed, until all diagnostics are known; blocks: {blocks}"), || {
        database.replace(files[0], changes.pop().unwrap_or_default());
        database.diagnostics().len()
    });
}

fn line_of(place: Place) -> usize {
    place.first as usize
}

fn drawn(networks: &[Network], draw: impl Fn(&Network) -> Layout, show: impl Fn(&Layout) -> String) -> usize {
    networks.iter().map(|network| show(&draw(network)).len()).sum()
}

fn main() {
    let mut sources = Sources::default();
    sources.add("block.awl", block());
    let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let compiled = compile(&sources, &SymbolTable::default(), &options);
    assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics.first());
    let blocks = compiled.bodies.values().filter_map(|body| match &**body {
        CheckedBody::Stl(block) => Some(block),
        CheckedBody::St(_) => None,
    });
    let source = Source {
        file: FileId(0),
        text: &sources.file(FileId(0)).text,
        mnemonics: Mnemonics::English,
        drawing: None,
        blocks: blocks.collect(),
    };
    let networks: Vec<Network> = source
        .blocks(Mode::Strict)
        .into_iter()
        .flat_map(|block| block.networks)
        .filter_map(|network| match network.answer {
            Answer::Exact(network) => Some(network),
            Answer::Equivalent(mut reading, None) => reading.networks.pop(),
            _ => None,
        })
        .collect();
    assert!(networks.len() >= NETWORKS, "{} networks can be drawn", networks.len());
    let options = Drawn::new(&line_of);
    let lad = |network: &Network| ladder(network, &options).expect("it can be drawn");
    let fbd = |network: &Network| function_plan(network, &options).expect("it can be drawn");
    let as_text = |layout: &Layout| text(layout, None, Characters::Unicode);
    let as_svg = |layout: &Layout| svg(&Picture { title: "a network", layout, flows: None });
    println!("{NETWORKS} networks\n\n| what | least | median | most | bytes |\n|---|---|---|---|---|");
    row_of("statements read into diagrams", || source.blocks(Mode::Strict).len());
    let redrawing = Redrawing { target: Target::Diagram(Drawing::Lad, Form::A), block: None, mode: Mode::Strict };
    row_of("statements converted to a file of LAD", || source.redraw(&redrawing).text.len());
    row_of("diagrams as LAD, as text", || drawn(&networks, lad, as_text));
    row_of("diagrams as LAD, as SVG", || drawn(&networks, lad, as_svg));
    row_of("diagrams as FBD, as text", || drawn(&networks, fbd, as_text));
    row_of("diagrams as FBD, as SVG", || drawn(&networks, fbd, as_svg));
    [1, 10, 100].into_iter().for_each(changed_network);
    for count in [1_000, 10_000] {
        let large = [row(count)];
        row_of(&format!("a network of {count} contacts as LAD, as text"), || drawn(&large, lad, as_text));
        row_of(&format!("a network of {count} contacts as FBD, as text"), || drawn(&large, fbd, as_text));
    }
}
