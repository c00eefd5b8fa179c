//! `sieben symbols FILE…`: the assignment table, and symbol tables from one format to another.

use std::ffi::OsStr;
use std::fmt;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use sieben_lang::encoding::{self, Encoding};
use sieben_lang::symbols::{self, Format, Layout, assignment};
use sieben_model::problems::Problem;
use sieben_model::symbols::SymbolTable;
use sieben_workspace::finding::{self, Texts};

use crate::arguments::EncodingArgument;
use crate::document::{Document, Section};
use crate::failure::{Exit, Failure};
use crate::report;
use crate::{files, output, symbol_files};

/// Print the assignment table, or convert symbol tables.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben symbols symbols.csv         the assignment table\n  \
  sieben symbols symbols.csv --csv   the same for a spreadsheet\n  \
  sieben symbols symbols.csv --html -o table.html  a page to print\n  \
  sieben symbols plant.sdf --to csv -o symbols.csv\n  \
  sieben symbols plant.sdf -o plant.asc          the name says the format\n\n\
Without --to the assignment table is printed: number, address, unit,\n\
technological name, description, remark. The formats sdf, asc, dif and seq\n\
are those of STEP 7, written in code page 1252 unless a file that was read had another.")]
pub(crate) struct Arguments {
    /// Symbol tables: .csv, .sdf, .asc, .dif or .seq; several become one
    #[arg(required = true, value_name = "FILE")]
    paths: Vec<PathBuf>,
    /// Write the symbol table in this format instead of the assignment table
    #[arg(long, value_name = "FORMAT", conflicts_with_all = ["assignments", "csv"])]
    to: Option<FormatArgument>,
    /// Print the assignment table (the default)
    #[arg(long)]
    assignments: bool,
    /// Print the assignment table as CSV
    #[arg(long)]
    csv: bool,
    /// Print the assignment table as a web page that needs nothing beside it
    #[arg(long, conflicts_with_all = ["to", "csv", "json"])]
    html: bool,
    /// Print the assignment table, or the diagnostics if it has errors, as JSON
    #[arg(long, conflicts_with_all = ["to", "csv"])]
    json: bool,
    #[command(flatten)]
    encoding: EncodingArgument,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// A format to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FormatArgument {
    // Native, UTF-8.
    Csv,
    // STEP 7 V5, quoted fields.
    Sdf,
    // STEP 7 V5, fixed widths.
    Asc,
    // STEP 7 V5, for spreadsheets.
    Dif,
    // STEP 5, without data types.
    Seq,
}

impl FormatArgument {
    fn format(self) -> Format {
        match self {
            Self::Csv => Format::Csv,
            Self::Sdf => Format::Sdf,
            Self::Asc => Format::Asc,
            Self::Dif => Format::Dif,
            Self::Seq => Format::Seq,
        }
    }
}

impl fmt::Display for FormatArgument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.format().extension())
    }
}

/// Prints or converts the tables.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let mut texts = Texts::default();
    let mut findings = Vec::new();
    let mut table = SymbolTable::default();
    let mut code_page = None;
    let mut columns = None;
    for path in &arguments.paths {
        let file = symbol_files::read(path, arguments.encoding.chosen(), &mut texts.documents)?;
        findings.extend(file.findings);
        if matches!(file.encoding, Encoding::Cp1250 | Encoding::Cp1251 | Encoding::Cp1252) {
            code_page = code_page.or(Some(file.encoding));
        }
        columns = columns.or_else(|| Some(file.read.table.columns().to_vec()));
        for symbol in file.read.table.symbols() {
            table.push(symbol.clone());
        }
    }
    table.set_columns(columns.unwrap_or_default());
    finding::sort(&mut findings);
    if !findings.is_empty() {
        report::print(&findings, &texts, arguments.json);
    }
    // A table with errors is still printed: seeing it is the way to mend it. Only a conversion must not lose rows.
    let failed = finding::has_errors(&findings);
    let exit = if failed { Exit::CheckFailed } else { Exit::Success };
    let (to, html) = meant(arguments);
    match to {
        None => {
            let text = if arguments.csv {
                assignment::csv(&table)
            } else if arguments.json {
                format!("{:#}\n", as_json(&table))
            } else if html {
                as_document(&table).html()
            } else {
                assignment::text(&table)
            };
            put(arguments, text.as_bytes())?;
        }
        Some(_) if failed => {}
        Some(to) => convert(arguments, to, &table, code_page)?,
    }
    Ok(exit)
}

/// What is written, from the options or, where they say nothing, from the name of the file: nobody who names `plant.asc` wants the
/// printed table in it.
fn meant(arguments: &Arguments) -> (Option<FormatArgument>, bool) {
    if arguments.to.is_some() || arguments.assignments || arguments.csv || arguments.html || arguments.json {
        return (arguments.to, arguments.html);
    }
    let extension = arguments.output.as_deref().and_then(Path::extension).and_then(OsStr::to_str).map(str::to_ascii_lowercase);
    match extension.as_deref() {
        Some("csv") => (Some(FormatArgument::Csv), false),
        Some("sdf") => (Some(FormatArgument::Sdf), false),
        Some("asc") => (Some(FormatArgument::Asc), false),
        Some("dif") => (Some(FormatArgument::Dif), false),
        Some("seq") => (Some(FormatArgument::Seq), false),
        Some("html" | "htm") => (None, true),
        _ => (None, false),
    }
}

fn convert(arguments: &Arguments, to: FormatArgument, table: &SymbolTable, code_page: Option<Encoding>) -> Result<(), Failure> {
    let written = symbols::write(table, Layout::new(to.format()));
    for loss in &written.losses {
        output::message(&format!("Note: {loss}\n"));
    }
    // STEP 7 V5 knows no UTF-8; on a terminal or pipe the text stays what the system reads.
    let encoding = match to {
        FormatArgument::Csv => Encoding::Utf8,
        _ if arguments.output.is_some() => code_page.unwrap_or(Encoding::Cp1252),
        _ => Encoding::Utf8,
    };
    let bytes = encoding::encode(&written.text, encoding).map_err(|unencodable| {
        Failure::usage(Problem::P1103, format!("the table cannot be written as {to}: {unencodable}"))
            .help("replace the character, or write `--to csv`, which is UTF-8")
    })?;
    put(arguments, &bytes)
}

fn put(arguments: &Arguments, bytes: &[u8]) -> Result<(), Failure> {
    match &arguments.output {
        Some(path) => files::write_whole(path, bytes),
        None => output::print_data(&String::from_utf8_lossy(bytes)),
    }
}

fn as_document(table: &SymbolTable) -> Document {
    let rows = assignment::rows(table).into_iter().map(|row| row.to_vec()).collect();
    let section = Section { headings: assignment::HEADINGS.to_vec(), rows, ..Section::default() };
    Document { title: "Assignment table".to_owned(), sections: vec![section], ..Document::default() }
}

fn as_json(table: &SymbolTable) -> serde_json::Value {
    assignment::rows(table)
        .into_iter()
        .map(|[number, address, unit, tag, description, remark]| {
            serde_json::json!({ "number": number, "address": address, "unit": unit,
                "technological_name": tag, "description": description, "remark": remark })
        })
        .collect()
}
