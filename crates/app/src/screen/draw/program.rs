//! Draws a block with what its statements found and left in a scan.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;
use serde_json::Value;
use sieben_model::visible::visible;

use super::Scene;
use crate::screen::columns::{columns, fitted, padded};
use crate::screen::look::Seen;
use crate::screen::numbers::thousands;
use crate::screen::words;

/// Columns of STA, RLO and ACCU 1.
const STATUS: usize = 16;
/// Columns of a statement with its operand.
const STATEMENT: usize = 12;
/// Columns of a symbol at most.
const SYMBOL: usize = 24;
/// Columns of a value of ST at most.
const VALUE: usize = 20;

impl Scene<'_> {
    pub(super) fn program(&self, frame: &mut Frame<'_>, area: Rect) {
        let program = &self.look.program;
        let state = &self.look.state;
        let scan = thousands(state["scans"].as_u64().unwrap_or_default());
        let cycle = state["cycle_ms"]["last"].as_f64().filter(|&ms| ms > 0.0);
        let cycle = cycle.map_or_else(String::new, |ms| format!("  {} {ms:.2} ms", self.screen.word(words::CYCLE)));
        let foot = format!(" {} {scan}{cycle} ", self.screen.word(words::SCAN));
        let title = if program.title.is_empty() { String::new() } else { format!(" {} ", visible(&program.title)) };
        let mut block = self.palette.frame(title).title_bottom(Line::from(foot));
        if !program.is_same {
            let text = format!(" {} ", self.screen.word(words::NOT_THE_SAME));
            block = block.title_top(Line::styled(text, self.palette.colour(Color::Yellow)).right_aligned());
        }
        let inner = block.inner(area);
        let width = usize::from(inner.width);
        let room = usize::from(inner.height).saturating_sub(1);
        let is_network = |line: &&Value| line.get("network").is_some();
        // Titles of networks are left out where they would push statements out.
        let networks = program.lines.iter().filter(is_network).count();
        let with_titles = program.lines.len() <= room || program.lines.len() - networks > room;
        let wanted = |line: &&Value| with_titles || !is_network(line);
        let all: Vec<&Value> = program.lines.iter().filter(wanted).collect();
        let top = self.screen.top.min(all.len().saturating_sub(room));
        let mut lines = vec![self.head(width)];
        lines.extend(all.into_iter().skip(top).take(room).map(|line| self.line(line, width)));
        if program.lines.is_empty() {
            lines = vec![Line::styled(format!(" {}", self.screen.word(words::NO_LISTING)), self.palette.faint())];
        }
        frame.render_widget(Paragraph::new(lines).block(block), area);
    }

    fn head(&self, width: usize) -> Line<'static> {
        let text = match self.look.program.is_source {
            true => format!("{:>width$}", self.screen.word(words::VALUE)),
            false => {
                let status = format!("STA {:>3} {:>8}", self.screen.word(words::RLO), self.screen.word(words::ACCU));
                format!("{status:>width$}")
            }
        };
        Line::styled(text, self.palette.faint())
    }

    fn line(&self, line: &Value, width: usize) -> Line<'static> {
        let text = |key: &str| line[key].as_str().unwrap_or_default();
        if let Some(number) = line["network"].as_u64() {
            let title = match text("title") {
                "" => format!("// {} {number}", self.screen.word(words::NETWORK)),
                title => format!("// {title}"),
            };
            return Line::styled(fitted(&title, width), self.palette.faint());
        }
        let seen = |number: &Value| number.as_u64().and_then(|number| self.look.program.seen.get(&number));
        match line["statements"].as_array() {
            Some(statements) => self.source_line(text("text"), statements.iter().filter_map(seen).collect(), width),
            None => self.statement(line, seen(&line["statement"]), width),
        }
    }

    fn statement(&self, line: &Value, seen: Option<&Seen>, width: usize) -> Line<'static> {
        let text = line["text"].as_str().unwrap_or_default();
        let (mnemonic, operand) = text.split_once(' ').unwrap_or((text, ""));
        let symbol = line["symbol"].as_str().unwrap_or_default();
        let left = width.saturating_sub(STATUS);
        let statement_width = STATEMENT.min(left);
        let symbol_width = left.saturating_sub(statement_width).min(SYMBOL);
        let statement = format!(" {mnemonic:<3} {operand} ");
        // A long operand takes the place of the symbol.
        let text = match columns(&statement) > statement_width || symbol.is_empty() {
            true => padded(&format!("{statement}{symbol}"), left),
            false => padded(&statement, statement_width) + &padded(&fitted(symbol, symbol_width), left - statement_width),
        };
        let Some(seen) = seen else { return Line::styled(text, self.palette.faint()) };
        let on = self.palette.colour(Color::Green).add_modifier(Modifier::BOLD);
        let bit = |value: bool| Span::styled(if value { "1" } else { "0" }, if value { on } else { self.palette.faint() });
        let style = if seen.rlo { self.palette.colour(Color::Green) } else { Style::new() };
        let accu = if seen.accu1 > 0xFFFF { format!("{:08X}", seen.accu1) } else { format!("{:04X}", seen.accu1) };
        Line::from(vec![
            Span::styled(text, style),
            Span::raw("  "),
            bit(seen.sta),
            Span::raw("   "),
            bit(seen.rlo),
            Span::styled(format!(" {accu:>8}"), self.palette.faint()),
        ])
    }

    /// A line of ST: faint where statements begin in it and none was executed.
    fn source_line(&self, text: &str, seen: Vec<&Seen>, width: usize) -> Line<'static> {
        let value = seen.iter().rev().find_map(|seen| seen.value.clone());
        let value = value.map_or_else(String::new, |value| fitted(&value, VALUE));
        let room = width.saturating_sub(if value.is_empty() { 0 } else { columns(&value) + 1 });
        let style = if seen.is_empty() { self.palette.faint() } else { Style::new() };
        Line::from(vec![
            Span::styled(padded(&text.replace('\t', "    "), room), style),
            Span::raw(if value.is_empty() { "" } else { " " }),
            Span::styled(value, Style::new().add_modifier(Modifier::BOLD)),
        ])
    }
}
