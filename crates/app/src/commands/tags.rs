//! `sieben tags [PATH…]`: what a client can read and write, and where it lies, ready to paste.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use serde_json::{Value as Json, json};
use sieben_ide::tags::{self, Arrays, Place, Tag};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::types::DataType;
use sieben_workspace::finding;

use crate::arguments::ProgramArguments;
use crate::failure::{Exit, Failure};
use crate::{files, output};

/// Print what a client can read and write, and where it lies.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben tags                             the project in this folder, as CSV\n  \
  sieben tags pump --format snap7 -o tags.py\n  \
  sieben tags pump --format nodered -o variables.csv\n\n\
Tags are the symbols with an address and the fields of all data blocks.\n\
Formats: csv, a table with a heading; snap7, a module for Python whose items\n\
`read_multi_vars` of python-snap7 takes as they are; nodered, the list that the\n\
S7 endpoint of Node-RED imports, in addresses of nodes7; json, all of it.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables or a project folder [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Who will read it
    #[arg(long, value_name = "FORMAT", default_value = "csv")]
    format: FormatArgument,
    /// List every element of an array by itself
    #[arg(long)]
    elements: bool,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// What reads the tags.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FormatArgument {
    /// A table for a spreadsheet
    Csv,
    /// A module for python-snap7
    Snap7,
    /// The list of variables of an S7 endpoint in Node-RED
    Nodered,
    /// Everything that is known
    Json,
}

/// Prints the tags.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let json = arguments.format == FormatArgument::Json;
    let build = arguments.program.load(&arguments.paths)?.compile(arguments.program.overrides()?, false);
    if finding::has_errors(&build.findings) {
        return super::or_report(build, json).map_or_else(Ok, |_| Ok(Exit::Success));
    }
    let arrays = if arguments.elements { Arrays::Elements } else { Arrays::Whole };
    let tags = tags::tags(&build.compiled, &build.project.symbols, arrays);
    let text = match arguments.format {
        FormatArgument::Csv => csv(&tags),
        FormatArgument::Snap7 => snap7(&tags),
        FormatArgument::Nodered => {
            let (text, without) = nodered(&tags);
            for tag in without {
                output::message(&format!("Note: `{}` is left out: nodes7 has no type for {}\n", tag.name, tag.data_type));
            }
            text
        }
        FormatArgument::Json => format!("{:#}\n", tags.iter().map(as_json).collect::<Json>()),
    };
    match &arguments.output {
        Some(path) => files::write_whole(path, text.as_bytes())?,
        None => output::print_data(&text)?,
    }
    Ok(Exit::Success)
}

/// The short name of an area that Sieben's own formats use.
fn area_name(place: Place) -> &'static str {
    match place {
        Place::Area(area) => area.prefix(Mnemonics::English),
        Place::DataBlock(_) => "DB",
        Place::Timer => "T",
        Place::Counter => "C",
    }
}

/// The address as STEP 7 writes it; what is longer than a double word by its first byte.
fn address(tag: &Tag) -> String {
    let width = match tag.data_type {
        DataType::Bool => Width::Bit,
        _ if tag.data_type.stands_in_bytes() || tag.count > 1 => Width::Byte,
        _ => tag.data_type.width().unwrap_or(Width::Byte),
    };
    let at = |area| Address { area, width, byte: tag.byte, bit: tag.bit };
    let operand = match tag.place {
        Place::Area(area) => Operand::Address(at(area)),
        Place::DataBlock(db) => Operand::InDataBlock { db, address: at(Area::SharedData) },
        // Numbers of timers and counters fit into 16 bits.
        Place::Timer => Operand::Timer(tag.byte as u16),
        Place::Counter => Operand::Counter(tag.byte as u16),
    };
    operand.spell(Mnemonics::English)
}

fn db_number(tag: &Tag) -> Option<u16> {
    match tag.place {
        Place::DataBlock(db) => Some(db),
        _ => None,
    }
}

fn bit_number(tag: &Tag) -> Option<u8> {
    (tag.data_type == DataType::Bool).then_some(tag.bit)
}

/// The type, of an array with its length.
fn type_name(tag: &Tag) -> String {
    if tag.count == 1 { tag.data_type.to_string() } else { format!("{}[{}]", tag.data_type, tag.count) }
}

fn csv(tags: &[Tag]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let number = |number: Option<u32>| number.map_or_else(String::new, |number| number.to_string());
    let heading = ["name", "address", "area", "db", "byte", "bit", "type", "count", "bytes", "nodes7", "comment"].map(str::to_owned);
    let rows = tags.iter().map(|tag| {
        [
            tag.name.clone(),
            address(tag),
            area_name(tag.place).to_owned(),
            number(db_number(tag).map(u32::from)),
            tag.byte.to_string(),
            number(bit_number(tag).map(u32::from)),
            tag.data_type.to_string(),
            tag.count.to_string(),
            tag.bytes().to_string(),
            nodes7(tag).unwrap_or_default(),
            tag.comment.clone(),
        ]
    });
    for row in std::iter::once(heading).chain(rows) {
        writer.write_record(row).expect("a table in memory takes every row of as many fields as the first");
    }
    String::from_utf8(writer.into_inner().expect("a table in memory is written")).expect("fields are text")
}

/// A module for Python: one dictionary, whose values have the keys that `read_multi_vars` reads, and three more.
fn snap7(tags: &[Tag]) -> String {
    let mut text = String::from(
        "# Tags for python-snap7: client.read_multi_vars([tags[\"NAME\"]]), or client.read_area with its parts.\n\
         # `bit` and `type` say what the bytes mean; size counts timers and counters, and bytes of everything else.\n\
         from snap7.type import Area\n\ntags = {\n",
    );
    for tag in tags {
        let (area, size) = match tag.place {
            Place::Area(Area::Input) => ("PE", tag.bytes()),
            Place::Area(Area::Output) => ("PA", tag.bytes()),
            Place::Area(Area::BitMemory) => ("MK", tag.bytes()),
            Place::DataBlock(_) => ("DB", tag.bytes()),
            Place::Timer => ("TM", tag.count),
            Place::Counter => ("CT", tag.count),
            // The peripheral has no area in python-snap7.
            Place::Area(_) => continue,
        };
        let bit = bit_number(tag).map_or_else(String::new, |bit| format!(", \"bit\": {bit}"));
        let comment = if tag.comment.is_empty() { String::new() } else { format!("  # {}", tag.comment.replace(['\n', '\r'], " ")) };
        let _ = writeln!(
            text,
            "    {}: {{\"area\": Area.{area}, \"db_number\": {}, \"start\": {}, \"size\": {size}{bit}, \"type\": \"{}\"}},{comment}",
            json!(tag.name),
            db_number(tag).unwrap_or_default(),
            tag.byte,
            type_name(tag),
        );
    }
    text.push_str("}\n");
    text
}

/// The lines that an S7 endpoint imports, and the tags that nodes7 has no type for.
fn nodered(tags: &[Tag]) -> (String, Vec<&Tag>) {
    let (mut text, mut without) = (String::new(), Vec::new());
    for tag in tags {
        match nodes7(tag) {
            Some(address) => {
                // A semicolon would end the name.
                let _ = writeln!(text, "{address};{}", tag.name.replace([';', '\n', '\r'], " "));
            }
            None => without.push(tag),
        }
    }
    (text, without)
}

/// What nodes7 calls a type: in a data block, elsewhere. Without a row are those that it would read as another number: SINT has a sign, its bytes have none.
const NODES7: &[(DataType, &str, &str)] = &[
    (DataType::Bool, "X", ""),
    (DataType::Byte, "BYTE", "B"),
    (DataType::UnsignedSmallInt, "BYTE", "B"),
    (DataType::Char, "CHAR", "C"),
    (DataType::Word, "WORD", "W"),
    (DataType::UnsignedInt, "WORD", "W"),
    (DataType::Date, "WORD", "W"),
    (DataType::S5Time, "WORD", "W"),
    (DataType::WideChar, "WORD", "W"),
    (DataType::Int, "INT", "I"),
    (DataType::DoubleWord, "DWORD", "D"),
    (DataType::UnsignedDoubleInt, "DWORD", "D"),
    (DataType::TimeOfDay, "DWORD", "D"),
    (DataType::DoubleInt, "DINT", "DI"),
    (DataType::Time, "DINT", "DI"),
    (DataType::Real, "REAL", "R"),
    (DataType::LongReal, "LREAL", "LR"),
    (DataType::LongInt, "LINT", "LI"),
    (DataType::LongTime, "LINT", "LI"),
    (DataType::DateAndTime, "DT", ""),
];

/// The address in the notation of nodes7: `DB1,REAL4`, `DB1,X2.0`, `MI10`, `DB1,INT4.8` for an array.
fn nodes7(tag: &Tag) -> Option<String> {
    let length = if tag.count == 1 { String::new() } else { format!(".{}", tag.count) };
    match tag.place {
        Place::Timer => return Some(format!("T{}", tag.byte)),
        Place::Counter => return Some(format!("C{}", tag.byte)),
        _ => {}
    }
    if let (DataType::String(characters), Place::DataBlock(db)) = (tag.data_type.base(), tag.place) {
        return Some(format!("DB{db},S{}.{characters}{length}", tag.byte));
    }
    let (_, in_block, elsewhere) = NODES7.iter().find(|(data_type, ..)| data_type == tag.data_type.base())?;
    let bit = bit_number(tag).map_or_else(String::new, |bit| format!(".{bit}"));
    Some(match tag.place {
        Place::Area(_) if elsewhere.is_empty() && *in_block != "X" => return None,
        Place::DataBlock(db) => format!("DB{db},{in_block}{}{bit}{length}", tag.byte),
        Place::Area(area) => format!("{}{elsewhere}{}{bit}{length}", area.prefix(Mnemonics::English), tag.byte),
        Place::Timer | Place::Counter => return None,
    })
}

fn as_json(tag: &Tag) -> Json {
    json!({ "name": tag.name, "address": address(tag), "area": area_name(tag.place), "db": db_number(tag), "byte": tag.byte,
        "bit": bit_number(tag), "type": tag.data_type.to_string(), "count": tag.count, "bytes": tag.bytes(),
        "nodes7": nodes7(tag), "comment": tag.comment })
}
