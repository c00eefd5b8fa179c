//! A block as a page of HTML: its header, and each network with its diagram, its symbols and where they are used; it prints on A4.

use std::fmt::Write as _;
use std::rc::Rc;

use super::style::STYLE;
use super::svg::escaped;

/// A block.
#[derive(Clone, Debug, Default)]
pub struct BlockPage {
    /// `FB 20`.
    pub name: String,
    /// Its symbol.
    pub symbol: Option<String>,
    /// Its title.
    pub title: Option<String>,
    /// Its comment.
    pub comment: Option<String>,
    /// Further rows of its header, such as author and version.
    pub header: Vec<(String, String)>,
    /// Its networks.
    pub networks: Vec<NetworkPage>,
}

/// A network.
#[derive(Clone, Debug, Default)]
pub struct NetworkPage {
    /// Counted from 1.
    pub number: usize,
    /// Its title.
    pub title: Option<String>,
    /// Its comment.
    pub comment: Option<String>,
    /// What is shown.
    pub content: PageContent,
    /// Why it is not shown as it was asked for.
    pub reason: Option<String>,
    /// What it names.
    pub symbols: Vec<Rc<SymbolRow>>,
}

/// How a network is shown.
#[derive(Clone, Debug)]
pub enum PageContent {
    /// As a picture, which [`svg`](super::svg::svg) made.
    Picture(String),
    /// As statements.
    Statements(String),
}

impl Default for PageContent {
    fn default() -> Self {
        Self::Statements(String::new())
    }
}

/// Something that a network names, and where else it is used.
#[derive(Clone, Debug, Default)]
pub struct SymbolRow {
    /// Its address: `I 0.0`.
    pub address: String,
    /// Its symbol.
    pub symbol: Option<String>,
    /// Its type.
    pub data_type: Option<String>,
    /// Its comment.
    pub comment: Option<String>,
    /// Places, each with what happens there: `OB 1/3 R`.
    pub references: Vec<String>,
}

const PAGE_STYLE: &str = r#"body{font:14px/1.45 Inter,ui-sans-serif,system-ui,"Segoe UI",Roboto,"Noto Sans",sans-serif;margin:24px;color:#131a17;background:#fff}
h1{font-size:20px;margin:0 0 4px}
h2{font-size:16px;margin:0 0 4px}
.comment{white-space:pre-line;color:#3f4b45;margin:0 0 8px}
.network{margin:24px 0;break-inside:avoid}
.network svg{max-width:100%;height:auto}
.reason{color:#855400}
pre,table{font:12.5px "JetBrains Mono",ui-monospace,"Cascadia Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace}
table{border-collapse:collapse;margin-top:6px}
th,td{text-align:left;vertical-align:top;padding:1px 12px 1px 0;border-bottom:1px solid #dde1dd}
@media(prefers-color-scheme:dark){body{color:#eaf0ec;background:#131917}.comment{color:#bcc7c1}.reason{color:#ffc861}th,td{border-color:#28322d}}
@page{size:A4;margin:15mm}
@media print{body{margin:0;color:#000;background:#fff}.comment,.reason{color:#000}.block{break-before:page}.block:first-of-type{break-before:auto}}
"#;

/// Blocks as one page.
pub fn html(title: &str, blocks: &[BlockPage]) -> String {
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>{}</title>\n<style>{PAGE_STYLE}{STYLE}</style>\n</head>\n<body>\n",
        escaped(title)
    );
    for block in blocks {
        draw_block(block, &mut out);
    }
    out.push_str("</body>\n</html>\n");
    out
}

/// A heading such as `FB 20 "Dosing": Doses a batch`.
fn heading(name: &str, symbol: Option<&str>, title: Option<&str>) -> String {
    let symbol = symbol.map(|symbol| format!(" \"{symbol}\"")).unwrap_or_default();
    let title = title.filter(|title| !title.is_empty()).map(|title| format!(": {title}")).unwrap_or_default();
    escaped(&format!("{name}{symbol}{title}"))
}

fn paragraph(class: &str, text: Option<&str>, out: &mut String) {
    if let Some(text) = text.filter(|text| !text.is_empty()) {
        let _ = writeln!(out, "<p class=\"{class}\">{}</p>", escaped(text));
    }
}

fn draw_block(block: &BlockPage, out: &mut String) {
    out.push_str("<article class=\"block\">\n");
    let _ = writeln!(out, "<h1>{}</h1>", heading(&block.name, block.symbol.as_deref(), block.title.as_deref()));
    paragraph("comment", block.comment.as_deref(), out);
    if !block.header.is_empty() {
        out.push_str("<table class=\"header\">\n");
        for (name, value) in &block.header {
            let _ = writeln!(out, "<tr><th>{}</th><td>{}</td></tr>", escaped(name), escaped(value));
        }
        out.push_str("</table>\n");
    }
    for network in &block.networks {
        draw_network(network, out);
    }
    out.push_str("</article>\n");
}

fn draw_network(network: &NetworkPage, out: &mut String) {
    let _ = writeln!(out, "<section class=\"network\" data-network=\"{}\">", network.number);
    let _ = writeln!(out, "<h2>{}</h2>", heading(&format!("Network {}", network.number), None, network.title.as_deref()));
    paragraph("comment", network.comment.as_deref(), out);
    match &network.content {
        PageContent::Picture(picture) => out.push_str(picture),
        PageContent::Statements(text) => {
            let _ = writeln!(out, "<pre>{}</pre>", escaped(text.trim_end()));
        }
    }
    paragraph("reason", network.reason.as_deref(), out);
    if !network.symbols.is_empty() {
        out.push_str("<table class=\"symbols\">\n<tr><th>Address</th><th>Symbol</th><th>Type</th><th>Comment</th><th>Used in</th></tr>\n");
        for row in &network.symbols {
            let optional = |text: &Option<String>| text.as_deref().map(escaped).unwrap_or_default();
            let _ = writeln!(
                out,
                "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
                escaped(&row.address),
                optional(&row.symbol),
                optional(&row.data_type),
                optional(&row.comment),
                // A place stays on one line.
                row.references.iter().map(|place| escaped(&place.replace(' ', "\u{a0}"))).collect::<Vec<_>>().join(", ")
            );
        }
        out.push_str("</table>\n");
    }
    out.push_str("</section>\n");
}
