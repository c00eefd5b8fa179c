//! The generated part of `docs/compatibility.md`: what is done and what proves it, from the rows of the tables and the pages that use them.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use sieben_lang::encoding::Encoding;
use sieben_lang::library;
use sieben_lang::stl::ast::{BlockName, Operand};
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::parser::parse;
use sieben_lang::symbols::Format;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

use crate::generate::{cell, text_of};
use crate::markdown;
use crate::workspace::TextFile;

/// The page.
pub(crate) const PATH: &str = "docs/compatibility.md";
/// Begins the generated part.
pub(crate) const BEGIN: &str = "<!-- generated: what is done -->\n";
const VECTORS: &str = "spec/vectors/vectors.csv";
const LEGAL: &str = "spec/corpus/legal/";
const BROKEN: &str = "spec/corpus/broken/";
const STRUCTURED: &str = "spec/corpus/st/";
/// Pages that a row names.
const PAGES_SHOWN: usize = 3;

/// What the programs of a page use.
#[derive(Default)]
struct Uses {
    /// How often each instruction stands there, by its international word.
    instructions: BTreeMap<&'static str, usize>,
    /// Called blocks by name or number, in capitals: `SFC 20`, `BLKMOV`.
    calls: BTreeSet<String>,
    /// Blocks that the programs define.
    blocks: BTreeSet<(&'static str, u64)>,
}

impl Uses {
    fn of(text: &str) -> Self {
        let mut uses = Self::default();
        for block in parse(FileId::default(), text, Some(Mnemonics::English)).file.blocks {
            if let BlockName::Absolute { kind, number, .. } = &block.name {
                uses.blocks.insert((kind.abbreviation(), *number));
            }
            for statement in &block.statements {
                if let Some(row) = Instruction::candidates(&statement.mnemonic.text, Mnemonics::English).next() {
                    *uses.instructions.entry(row.english()).or_default() += 1;
                }
                if let Operand::Call(call) = &statement.operand {
                    uses.calls.extend(match &call.callee {
                        Operand::Absolute { letters, number, .. } => Some(format!("{letters} {number}")),
                        Operand::Symbol { name, .. } | Operand::Name { word: name, .. } => Some(name.text.to_ascii_uppercase()),
                        _ => None,
                    });
                }
            }
        }
        uses
    }
}

/// The part between the marks.
pub(crate) fn done(files: &[TextFile]) -> String {
    let pages: Vec<(&str, Uses)> = files
        .iter()
        .filter(|file| file.path.starts_with("spec/") && file.path.ends_with(".md"))
        .map(|file| {
            let fences = markdown::read(&file.text).fences.into_iter().filter(|fence| fence.language == "stl");
            (file.path.as_str(), Uses::of(&fences.map(|fence| fence.text).collect::<Vec<_>>().join("\n")))
        })
        .filter(|(_, uses)| !uses.blocks.is_empty())
        .collect();
    let mut text = String::new();
    instructions(&mut text, files, &pages);
    organization_blocks(&mut text, &pages);
    system_functions(&mut text, &pages);
    library_blocks(&mut text, &pages);
    cpu_types(&mut text);
    symbol_tables(&mut text, files);
    encodings(&mut text, files);
    corpus(&mut text, files);
    text
}

/// The pages where something is used most, as links from `docs/`.
fn links<'a>(pages: impl Iterator<Item = (&'a str, usize)>) -> String {
    let mut pages: Vec<(&str, usize)> = pages.filter(|&(_, count)| count > 0).collect();
    // A tie goes by name, so that the page is the same on every machine.
    pages.sort_by(|left, right| right.1.cmp(&left.1).then(left.0.cmp(right.0)));
    let name = |path: &str| path.trim_start_matches("spec/").trim_end_matches(".md").to_owned();
    let mut shown: Vec<String> = pages.iter().take(PAGES_SHOWN).map(|(path, _)| format!("[{}](../{path})", name(path))).collect();
    if pages.len() > PAGES_SHOWN {
        shown.push("…".to_owned());
    }
    shown.join(", ")
}

fn line(text: &mut String, line: impl AsRef<str>) {
    text.push_str(line.as_ref());
    text.push('\n');
}

fn instructions(text: &mut String, files: &[TextFile], pages: &[(&str, Uses)]) {
    let codes = vector_codes(text_of(files, VECTORS).unwrap_or_default());
    let mut vectors: BTreeMap<&str, usize> = BTreeMap::new();
    for code in &codes {
        for instruction in Uses::of(code).instructions.into_keys() {
            *vectors.entry(instruction).or_default() += 1;
        }
    }
    let mut words: Vec<Instruction> = Vec::new();
    for &row in Instruction::ALL {
        if !words.iter().any(|word| word.english() == row.english()) {
            words.push(row);
        }
    }
    line(text, "### Instructions\n");
    let _ = writeln!(
        text,
        "{} words with {} forms of operands, in both mnemonic languages. Every form is run over all status words and edge values by `crates/lang/tests/status_rows.rs`, in both directions: what its row says changes is \
         seen to change, what it does not say does not. Arithmetic, comparisons, conversions, shifts, logic, accumulators, addresses, jumps, MCR, timers and counters agree on both engines with the independent model in `crates/lang/tests/model/`. \
         `{VECTORS}` has {} rows; a row that uses several instructions counts for each of them. Every form stands in an executable page; the table names those that use the word most.\n",
        words.len(),
        Instruction::ALL.len(),
        codes.len(),
    );
    line(text, "| English | German | forms | vectors | pages |\n|---|---|---|---|---|");
    for word in words {
        let forms = Instruction::ALL.iter().filter(|row| row.english() == word.english()).count();
        // The chapters of the instructions, or what else there is: others use `A` and `=` everywhere.
        let uses = |chapter: bool| {
            let pages = pages.iter().filter(move |(path, _)| !chapter || path.starts_with("spec/stl/"));
            links(pages.map(|(path, uses)| (*path, uses.instructions.get(word.english()).copied().unwrap_or(0))))
        };
        let used = Some(uses(true)).filter(|links| !links.is_empty()).unwrap_or_else(|| uses(false));
        let vectors = vectors.get(word.english()).copied().unwrap_or(0);
        let _ = writeln!(text, "| `{}` | `{}` | {forms} | {vectors} | {used} |", cell(word.english()), cell(word.german()));
    }
}

/// The third column of the vectors: statements.
fn vector_codes(csv: &str) -> Vec<String> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(csv.as_bytes());
    reader.records().filter_map(Result::ok).filter_map(|record| record.get(2).map(str::to_owned)).collect()
}

fn organization_blocks(text: &mut String, pages: &[(&str, Uses)]) {
    let organization_block = BlockKind::OrganizationBlock.abbreviation();
    let numbers: BTreeSet<u64> = pages
        .iter()
        .flat_map(|(_, uses)| &uses.blocks)
        .filter(|(kind, _)| *kind == organization_block)
        .map(|(_, number)| *number)
        .collect();
    line(text, "\n### Organization blocks\n\nThose that run in a page.\n\n| block | pages |\n|---|---|");
    for number in numbers {
        // OB 1 stands in all pages; the page of the cycle explains it.
        let used = pages
            .iter()
            .filter(|(path, _)| path.starts_with("spec/cpu/"))
            .map(|(path, uses)| (*path, usize::from(uses.blocks.contains(&(organization_block, number)))));
        let mut named = links(used);
        if named.is_empty() {
            named = links(pages.iter().map(|(path, uses)| (*path, usize::from(uses.blocks.contains(&(organization_block, number))))));
        }
        let _ = writeln!(text, "| OB {number} | {named} |");
    }
}

fn calls<'a>(pages: &'a [(&'a str, Uses)], block: BlockId, name: &str) -> String {
    let (number, name) = (block.to_string(), name.to_ascii_uppercase());
    // A page that defines a block of this number calls its own.
    let own = (block.kind.abbreviation(), u64::from(block.number));
    let calls = |uses: &Uses| uses.calls.contains(&name) || (uses.calls.contains(&number) && !uses.blocks.contains(&own));
    links(pages.iter().map(|(path, uses)| (*path, usize::from(calls(uses)))))
}

fn system_functions(text: &mut String, pages: &[(&str, Uses)]) {
    let mut blocks = sieben_cpu::system::numbered();
    blocks.sort_by_key(|block| block.block);
    let _ = writeln!(
        text,
        "\n### System functions\n\n{} of them. The pages run them; error codes and BR are part of the pages. A block without a page is tested beside its code in `crates/cpu/src/system/`.\n\n| block | name | pages |\n|---|---|---|",
        blocks.len()
    );
    for block in blocks {
        let _ = writeln!(text, "| {} | {} | {} |", block.block, cell(block.name), calls(pages, block.block, block.name));
    }
}

fn library_blocks(text: &mut String, pages: &[(&str, Uses)]) {
    line(text, "\n### Library\n\nBlocks that come along as STL sources.\n\n| block | name | pages |\n|---|---|---|");
    for block in library::ALL {
        let _ = writeln!(text, "| {} | {} | {} |", block.block, cell(block.name), calls(pages, block.block, block.name));
    }
}

fn cpu_types(text: &mut String) {
    line(
        text,
        "\n### CPU types\n\n| type | accumulators | process image | bit memory | timers | counters | local data | nesting | block size |\n|---|---|---|---|---|---|---|---|---|",
    );
    for cpu in CpuType::ALL {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} + {} | {} |",
            cpu.name,
            cpu.accumulators,
            cpu.process_image,
            cpu.bit_memory,
            cpu.timers,
            cpu.counters,
            cpu.local_data,
            cpu.nesting_depth,
            cpu.nesting_depth_error,
            cpu.block_size_max,
        );
    }
}

fn symbol_tables(text: &mut String, files: &[TextFile]) {
    line(
        text,
        "\n### Symbol tables\n\nRead, and written where the last column says so. Round trips are property tests in `crates/lang/src/symbols/tests.rs`; the fuzz target is `lang-symbols`.\n\n| format | what it is | tables in the corpus | written |\n|---|---|---|---|",
    );
    for format in Format::ALL {
        let ending = format!(".{}", format.extension());
        // A table in a code page is no text file; the text of its source says what was read.
        let read = format!(" symbols from {ending}\n");
        let tables = snapshots(files, LEGAL).filter(|(_, snapshot)| found(snapshot).contains(&read)).count();
        let _ = writeln!(text, "| `{ending}` | {} | {tables} | {} |", format.describe(), format.describe_written());
    }
}

fn snapshots<'a>(files: &'a [TextFile], folder: &'static str) -> impl Iterator<Item = (&'a str, &'a str)> {
    files.iter().filter_map(move |file| {
        let name = file.path.strip_prefix(folder)?.strip_suffix(".txt")?;
        Some((name, file.text.as_str()))
    })
}

fn found(snapshot: &str) -> &str {
    snapshot.split_once("=== found\n").map_or("", |(_, found)| found)
}

fn encodings(text: &mut String, files: &[TextFile]) {
    line(
        text,
        "\n### Encodings\n\nOf sources and symbol tables; the fuzz target is `lang-encoding`.\n\n| encoding | sources in the corpus |\n|---|---|",
    );
    for encoding in Encoding::ALL {
        let head = format!("{},", encoding.name());
        let count = snapshots(files, LEGAL).filter(|(_, snapshot)| found(snapshot).starts_with(&head)).count();
        let _ = writeln!(text, "| {} | {count} |", encoding.name());
    }
}

fn first_sentence(snapshot: &str) -> String {
    snapshot.lines().next().unwrap_or_default().trim().to_owned()
}

fn corpus(text: &mut String, files: &[TextFile]) {
    let legal: Vec<_> = snapshots(files, LEGAL).collect();
    let running = legal.iter().filter(|(_, snapshot)| snapshot.contains("=== check\n")).count();
    let _ = writeln!(
        text,
        "\n### Sources of the wild\n\n{} sources with one oddity of real exports each, written for this project: read without errors, formatted, converted to the other mnemonic language and back; {running} of them run. [How they are kept](../spec/corpus/README.md).\n\n| source | what is odd |\n|---|---|",
        legal.len()
    );
    for (name, snapshot) in legal {
        let _ = writeln!(text, "| [{name}](../{LEGAL}{name}.awl) | {} |", cell(&first_sentence(snapshot)));
    }
    let structured: Vec<_> = snapshots(files, STRUCTURED).collect();
    let _ = writeln!(
        text,
        "\n### Sources of ST in the wild\n\n{} sources with one oddity each, by dialect: read without errors, formatted, and read again with any one of their tokens lost.\n\n| source | what is odd |\n|---|---|",
        structured.len()
    );
    for (name, why) in structured {
        let ending = files
            .iter()
            .find_map(|file| file.path.strip_prefix(STRUCTURED)?.strip_prefix(name)?.strip_prefix('.').filter(|ending| *ending != "txt"));
        let ending = ending.unwrap_or(if name.starts_with("iec/") || name.starts_with("codesys/") { "st" } else { "scl" });
        let _ = writeln!(text, "| [{name}](../{STRUCTURED}{name}.{ending}) | {} |", cell(&first_sentence(why)));
    }
    line(
        text,
        "\n### Mistakes of real life\n\nSources with one mistake each: at most three diagnostics, one of them on the line of the mistake.\n\n| source | mistake | codes |\n|---|---|---|",
    );
    for (name, snapshot) in snapshots(files, BROKEN) {
        let why = first_sentence(snapshot);
        let why = why.rsplit_once(" Line ").map_or(why.as_str(), |(why, _)| why);
        let codes: BTreeSet<&str> =
            found(snapshot).lines().filter(|line| !line.starts_with(' ')).filter_map(|line| line.split(' ').nth(1)).collect();
        let codes: Vec<String> = codes.iter().map(|code| format!("[{code}](problems/{code}.md)")).collect();
        let _ = writeln!(text, "| [{name}](../{BROKEN}{name}.awl) | {} | {} |", cell(why), codes.join(", "));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(path: &str, text: &str) -> TextFile {
        TextFile { path: path.to_owned(), text: text.to_owned() }
    }

    #[test]
    fn the_page_names_what_uses_a_row() {
        let files = [
            file(
                "spec/stl/x.md",
                "# X\n\n```stl\nA I 0.0; A I 0.1;\nORGANIZATION_BLOCK OB 35\nBEGIN\nCALL SFC 46;\nEND_ORGANIZATION_BLOCK\n```\n",
            ),
            file(VECTORS, "id,group,code\nV1,bit,\"A I 0.0; O(\"\nV2,bit,A I 0.0\n"),
            file("spec/corpus/legal/odd.txt", "Very odd.\n\n=== check\nscan\n=== found\ncp1252, CR LF\n"),
            file("spec/corpus/broken/bad.txt", "A | mistake. Line 3.\n\n=== found\n3:1 P2001 no\n    | x\n3:2 P2004 no\n"),
        ];
        let text = done(&files);
        for row in [
            "| `A` | `U` | 1 | 2 | [stl/x](../spec/stl/x.md) |",
            "| OB 35 | [stl/x](../spec/stl/x.md) |",
            "| SFC 46 | STP | [stl/x](../spec/stl/x.md) |",
            "| cp1252 | 1 |",
            "| [odd](../spec/corpus/legal/odd.awl) | Very odd. |",
            "| [bad](../spec/corpus/broken/bad.awl) | A \\| mistake. | [P2001](problems/P2001.md), [P2004](problems/P2004.md) |",
        ] {
            assert!(text.lines().any(|line| line == row), "{row} is missing in\n{text}");
        }
    }
}
