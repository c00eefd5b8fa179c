//! What the checks want to know of a Markdown page: links, headings, code.

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// A block of code between three backticks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fence {
    /// The first word behind the opening backticks: `stl`, `sh`.
    pub language: String,
    /// The second word: the file that the code is.
    pub name: String,
    /// The code.
    pub text: String,
    /// The line of the opening backticks, counted from 1.
    pub line: usize,
}

/// What a page holds.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Page {
    /// Targets of links and pictures, with their lines.
    pub links: Vec<(String, usize)>,
    /// The anchors that headings give.
    pub anchors: Vec<String>,
    /// Code inside a sentence, with its line.
    pub spans: Vec<(String, usize)>,
    /// Blocks of code.
    pub fences: Vec<Fence>,
}

/// Reads a page.
pub fn read(text: &str) -> Page {
    let mut page = Page::default();
    let mut fence: Option<Fence> = None;
    let mut heading: Option<String> = None;
    for (event, range) in Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH).into_offset_iter() {
        let line = text[..range.start].matches('\n').count() + 1;
        match event {
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => page.links.push((dest_url.to_string(), line)),
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => page.anchors.extend(heading.take().map(|title| anchor(&title))),
            Event::Start(Tag::CodeBlock(kind)) => {
                let words = match kind {
                    CodeBlockKind::Fenced(words) => words.to_string(),
                    CodeBlockKind::Indented => String::new(),
                };
                let mut words = words.split_whitespace().map(str::to_owned);
                let (language, name) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
                fence = Some(Fence { language, name, text: String::new(), line });
            }
            Event::End(TagEnd::CodeBlock) => page.fences.extend(fence.take()),
            Event::Text(words) => {
                if let Some(fence) = &mut fence {
                    fence.text.push_str(&words);
                } else if let Some(heading) = &mut heading {
                    heading.push_str(&words);
                }
            }
            Event::Code(words) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&words);
                }
                page.spans.push((words.to_string(), line));
            }
            _ => {}
        }
    }
    page
}

/// The anchor of a heading: lower-case, blanks to `-`, punctuation gone.
fn anchor(title: &str) -> String {
    title
        .trim()
        .chars()
        .filter_map(|c| match c {
            ' ' => Some('-'),
            '-' | '_' => Some(c),
            c if c.is_alphanumeric() => Some(c.to_ascii_lowercase()),
            _ => None,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_gives_its_links_anchors_and_code() {
        let page = read("# To add a row\n\nSee [it](a.md#b) and `crates/x`.\n\n```sh\nsieben check\n```\n");
        assert_eq!(page.links, [("a.md#b".to_owned(), 3)]);
        assert_eq!(page.anchors, ["to-add-a-row"]);
        assert_eq!(page.spans, [("crates/x".to_owned(), 3)]);
        assert_eq!(page.fences, [Fence { language: "sh".to_owned(), name: String::new(), text: "sieben check\n".to_owned(), line: 5 }]);
    }
}
