//! `sieben render [PATH…]`: networks as ladder, function block diagram or statements; as text, SVG or a page.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value, json};
use sieben_ide::drawing::text::Characters;
use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_workspace::places::Places;
use sieben_workspace::{controller, finding};

use crate::arguments::ProgramArguments;
use crate::diagrams::{self, CodeBlock, Diagrams, Form, Kind, Shown, Written};
use crate::failure::{Exit, Failure};
use crate::{output, paths};

/// Draw networks as ladder or function block diagrams.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben render pump.awl                            every block as ladder, in the terminal\n  \
  sieben render plant --block Dosing --network 3 --as fbd\n  \
  sieben render plant --block \"FB 20\" -o dosing.html  a block to read and print\n  \
  sieben render plant --block FC1 --network 2 -o two.svg\n\n\
A network that cannot be drawn is shown as STL, and below it stands why.\n\
In git: `git config diff.sieben.textconv 'sieben render --as lad --or-source'`,\n\
and in .gitattributes `*.awl diff=sieben`.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables or a project folder [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// This block: `FC 1`, `FC1` or a symbol [default: all]
    #[arg(long, value_name = "NAME")]
    block: Option<String>,
    /// This network, from 1 [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    network: Option<u32>,
    /// How networks are shown
    #[arg(long = "as", value_name = "FORM", default_value = "lad")]
    form: Form,
    /// Draw text with the characters of ASCII only
    #[arg(long)]
    ascii: bool,
    /// Write to this file, by its ending as SVG, HTML or text
    #[arg(short, long, value_name = "FILE.svg|.html|.txt")]
    output: Option<PathBuf>,
    /// Print the sources as they are where they do not compile, and say nothing: for git, which compares what is printed
    #[arg(long, conflicts_with_all = ["output", "json"])]
    or_source: bool,
    /// Print one JSON object for each network
    #[arg(long, conflicts_with = "output")]
    json: bool,
}

/// A block with the networks of it that are drawn.
type Chosen<'d> = (BlockId, &'d CodeBlock, Vec<&'d Written>);

/// Draws.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let kind = arguments.output.as_deref().map(Kind::of).transpose()?;
    paths::spare_sources(&arguments.output)?;
    let build = arguments.program.load(&arguments.paths)?.compile(arguments.program.overrides()?, false);
    if arguments.or_source && finding::has_errors(&build.findings) {
        let sources = build.project.sources.iter().map(|source| build.project.texts.program.file(source.id).text.as_str());
        output::print(&sources.collect::<String>())?;
        return Ok(Exit::Success);
    }
    let build = match finding::has_errors(&build.findings) {
        true => match super::or_report(build, arguments.json) {
            Ok(build) => build,
            Err(exit) => return Ok(exit),
        },
        false => build,
    };
    let places = Places::new(&build);
    let diagrams = Diagrams::new(&build, &places);
    let chosen = choose(arguments, &diagrams)?;
    let form = arguments.form;
    let text = match kind {
        Some(Kind::Html) => diagrams::html(&diagrams, &chosen, form),
        Some(Kind::Svg) => svg(&diagrams, &chosen, form),
        Some(Kind::Text) | None if arguments.json => return json_lines(&diagrams, &chosen, form, arguments.ascii),
        Some(Kind::Text) | None => text(&diagrams, &chosen, form, arguments.ascii),
    };
    match &arguments.output {
        Some(path) => diagrams::put(path, &text)?,
        None => output::print(&text)?,
    }
    Ok(Exit::Success)
}

fn choose<'d>(arguments: &Arguments, diagrams: &'d Diagrams<'_>) -> Result<Vec<Chosen<'d>>, Failure> {
    let Some(name) = &arguments.block else {
        // Without a block the network of that number in each block that has one.
        let wanted = |number: u32| arguments.network.is_none_or(|wanted| wanted == number);
        let chosen =
            diagrams.blocks().map(|(id, block)| (id, block, block.networks.iter().filter(|network| wanted(network.number)).collect()));
        let chosen: Vec<Chosen<'d>> =
            chosen.filter(|(_, _, networks): &Chosen<'d>| arguments.network.is_none() || !networks.is_empty()).collect();
        return match (arguments.network, chosen.is_empty()) {
            (Some(number), true) => Err(Failure::usage(Problem::P7082, format!("no block has a network {number}"))),
            _ => Ok(chosen),
        };
    };
    let (id, block) = diagrams.block(name)?;
    let networks = match arguments.network {
        Some(number) => vec![diagrams.network(id, block, number)?],
        None => block.networks.iter().collect(),
    };
    Ok(vec![(id, block, networks)])
}

fn characters(ascii: bool) -> Characters {
    if ascii { Characters::Ascii } else { Characters::Unicode }
}

fn text(diagrams: &Diagrams<'_>, chosen: &[Chosen<'_>], form: Form, ascii: bool) -> String {
    let mut out = String::new();
    for (index, (id, block, networks)) in chosen.iter().enumerate() {
        if index > 0 {
            out.push('\n');
        }
        out.push_str(&headed(&diagrams.name(*id), block.title.as_deref(), block.comment.as_deref()));
        for written in networks {
            out.push('\n');
            let heading = format!("Network {}", written.number);
            out.push_str(&headed(&heading, written.title.as_deref(), written.comment.as_deref()));
            let shown = diagrams.shown(*id, written, form, None);
            out.push_str(&drawn(&shown, written, ascii));
        }
    }
    sieben_model::visible::visible(&out).into_owned()
}

/// The picture, or the statements and why they are no picture.
fn drawn(shown: &Shown, written: &Written, ascii: bool) -> String {
    let mut out = shown.text(characters(ascii)).unwrap_or_else(|| format!("{}\n", written.text.trim_end()));
    if let Some(reason) = &shown.reason {
        out.push_str(reason);
        out.push('\n');
    }
    out
}

/// A heading with its title, and the comment in lines of its own.
fn headed(name: &str, title: Option<&str>, comment: Option<&str>) -> String {
    let title = title.filter(|title| !title.is_empty()).map(|title| format!(": {title}")).unwrap_or_default();
    let comment: String = comment.unwrap_or_default().lines().map(|line| format!("{}\n", line.trim_end())).collect();
    format!("{name}{title}\n{comment}")
}

fn svg(diagrams: &Diagrams<'_>, chosen: &[Chosen<'_>], form: Form) -> String {
    let mut all = Vec::new();
    for (id, _, networks) in chosen {
        all.extend(networks.iter().map(|written| (diagrams.shown(*id, written, form, None), *written)));
    }
    diagrams::svg(&all)
}

fn json_lines(diagrams: &Diagrams<'_>, chosen: &[Chosen<'_>], form: Form, ascii: bool) -> Result<Exit, Failure> {
    for (id, _, networks) in chosen {
        let name = controller::name_in_source(diagrams.build(), *id).map_or_else(|| id.to_string(), str::to_owned);
        for written in networks {
            let shown = diagrams.shown(*id, written, form, None);
            output::print_json(&object(&name, &shown, written, form, ascii), false)?;
        }
    }
    Ok(Exit::Success)
}

fn object(name: &str, shown: &Shown, written: &Written, form: Form, ascii: bool) -> Value {
    let is_drawn = shown.layout.is_some();
    let form = if is_drawn || form == Form::Stl { form } else { Form::Stl };
    let text = shown.text(characters(ascii)).unwrap_or_else(|| written.text.clone());
    let mut object = json!({ "block": name, "network": written.number, "as": form.name().to_lowercase(), "text": text });
    if let Some(title) = &written.title {
        object["title"] = title.as_str().into();
    }
    if let Some(reason) = &shown.reason {
        object["reason"] = reason.as_str().into();
    }
    object
}
