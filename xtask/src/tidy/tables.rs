//! Tables of documents: each row has as many cells as the heading of its table.

use super::Finding;
use crate::workspace::TextFile;

/// Checks the tables of all documents.
pub fn check(files: &[TextFile]) -> Vec<Finding> {
    files.iter().filter(|file| file.path.ends_with(".md")).flat_map(document).collect()
}

fn document(file: &TextFile) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut in_code = false;
    let mut heading = None;
    for (index, line) in file.text.lines().map(str::trim).enumerate() {
        in_code ^= line.starts_with("```");
        if in_code || !line.starts_with('|') {
            heading = None;
            continue;
        }
        let has = cells(line);
        let wanted = *heading.get_or_insert(has);
        if has != wanted {
            let message = format!("this row has {has} cells, and the heading of its table {wanted}; a `|` inside a cell is written `\\|`");
            findings.push(Finding::line(&file.path, index + 1, message));
        }
    }
    findings
}

/// How many cells a row has: what stands between bars that are not escaped.
fn cells(row: &str) -> usize {
    let bars = row.matches('|').count() - row.matches("\\|").count();
    // The last bar of a row may be missing.
    if row.len() > 1 && row.ends_with('|') && !row.ends_with("\\|") { bars - 1 } else { bars }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Vec<usize> {
        let file = TextFile { path: "docs/a.md".to_owned(), text: text.to_owned() };
        document(&file).into_iter().map(|finding| finding.line).collect()
    }

    #[test]
    fn a_row_with_more_or_fewer_cells_than_the_heading_is_found() {
        assert_eq!(lines("| a | b |\n|---|---|\n| 1 | 2 |\n"), [0; 0]);
        assert_eq!(lines("| a | b |\n|---|---|\n| 1 |\n| 1 | 2 | 3 |\n"), [3, 4]);
    }

    #[test]
    fn an_escaped_bar_code_and_a_second_table_are_no_cells_of_the_first_one() {
        assert_eq!(lines("| a | b |\n|---|---|\n| `x\\|y` | 2 |\n"), [0; 0]);
        assert_eq!(lines("```text\n| 1 | 2 |\n| 1 |\n```\n| a |\n|---|\n| 1 |\n\n| a | b |\n|---|---|\n| 1 | 2 |\n"), [0; 0]);
    }
}
