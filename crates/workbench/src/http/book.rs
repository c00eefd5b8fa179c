//! The book: the pages of `docs/` inside of this binary, made into HTML when they are asked for.

use std::collections::BTreeMap;

use axum::body::Body;
use axum::http::{HeaderValue, Response, StatusCode, header};
use pulldown_cmark::{CowStr, Event, HeadingLevel, LinkType, Options, Parser, Tag, TagEnd};
use rust_embed::RustEmbed;
use sieben_ide::drawing::svg::escaped;

use super::{assets, response};

/// The pages, without measurements, and without pictures of the page, which a reader has open beside it.
#[derive(RustEmbed)]
#[folder = "../../docs"]
#[exclude = "benchmarks/*"]
#[exclude = "reference/workbench/*"]
struct Files;

/// Where the book begins.
const BASE: &str = "/docs/";
/// The page that lists all others.
const CONTENTS: &str = "SUMMARY.md";

const STYLE: &str = "body{font:16px/1.55 system-ui,sans-serif;max-width:60rem;margin:0 auto;padding:1.5rem 1rem 4rem;color-scheme:light dark}\
nav{border-bottom:1px solid;margin-bottom:1.5rem;padding-bottom:.5rem}\
code,pre{font-family:ui-monospace,monospace;font-size:.92em}pre{overflow:auto;padding:.75rem;border:1px solid #8888}\
table{border-collapse:collapse;display:block;overflow:auto}th,td{border:1px solid #8888;padding:.25rem .5rem;text-align:left;vertical-align:top}\
img{max-width:100%}";

/// The file of a path below `/docs/`: a page without its ending, the first page of a folder, or what is named.
fn found(path: &str) -> Option<(String, rust_embed::EmbeddedFile)> {
    let plain = path.trim_end_matches('/');
    let names = match plain {
        "" => vec![CONTENTS.to_owned()],
        _ => vec![format!("{plain}.md"), format!("{plain}/README.md"), plain.to_owned()],
    };
    names.into_iter().find_map(|name| Files::get(&name).map(|file| (name, file)))
}

/// Answers a path of the book.
pub(super) fn page(path: &str) -> Result<Response<Body>, sieben_workspace::Refusal> {
    let inside = path.strip_prefix(BASE).unwrap_or_default();
    let decoded = super::query::decoded(inside).unwrap_or_default();
    let Some((name, file)) = found(&decoded) else {
        let body = "<h1>There is no such page</h1>\n<p>It may have another name now: <a href=\"/docs/\">the book begins here</a>.</p>\n";
        let mut response = assets::page(&document("There is no such page", body));
        *response.status_mut() = StatusCode::NOT_FOUND;
        return Ok(response);
    };
    // A folder is written with its stroke, so that links in its page lead where they should.
    let is_folder = name.ends_with("README.md") && !path.ends_with('/') && !path.ends_with("README.md");
    if is_folder || path == "/docs" {
        let folder = name.trim_end_matches("README.md").trim_end_matches(CONTENTS);
        let mut response = response(StatusCode::PERMANENT_REDIRECT, "text/plain; charset=utf-8", "");
        if let Ok(place) = HeaderValue::from_str(&format!("{BASE}{folder}")) {
            response.headers_mut().insert(header::LOCATION, place);
        }
        return Ok(response);
    }
    if !name.ends_with(".md") {
        return Ok(response(StatusCode::OK, assets::kind(&name), file.data.to_vec()));
    }
    let text = String::from_utf8_lossy(&file.data);
    let (title, body) = html(&name, &text);
    Ok(assets::page(&document(&title, &body)))
}

fn document(title: &str, body: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n\
         <title>{} · Sieben</title>\n<style nonce=\"__NONCE__\">{STYLE}</style>\n</head>\n<body>\n\
         <nav><a href=\"/\">The run</a> · <a href=\"/docs/\">The book</a></nav>\n<main>\n{body}</main>\n</body>\n</html>\n",
        escaped(title)
    )
}

/// The title of a page, and the page as HTML. Markup in it is shown as text.
fn html(name: &str, text: &str) -> (String, String) {
    let options = Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH;
    let mut events: Vec<Event<'_>> = Vec::new();
    let mut title = String::new();
    let mut slugs: BTreeMap<String, usize> = BTreeMap::new();
    // Where the heading that is being read began, and its text.
    let mut heading: Option<(usize, HeadingLevel, String)> = None;
    let mut without_link = 0_usize;
    // Of a picture that is not in the book its text is left.
    let mut without_picture = false;
    // Whether a cell of a table has just begun: a word of code there is a place that links can name.
    let mut begins_cell = false;
    let mut words: BTreeMap<String, usize> = BTreeMap::new();
    for event in Parser::new_ext(text, options) {
        let begun = std::mem::replace(&mut begins_cell, matches!(event, Event::Start(Tag::TableCell)));
        match event {
            Event::Code(word) if begun && !word.contains(char::is_whitespace) => {
                words.entry(word.to_string()).or_insert(events.len());
                events.push(Event::Code(word));
            }
            Event::Start(Tag::Heading { level, .. }) => {
                heading = Some((events.len(), level, String::new()));
                events.push(Event::Text(CowStr::Borrowed("")));
            }
            Event::End(TagEnd::Heading(level)) => {
                if let Some((at, _, text)) = heading.take() {
                    let slug = unique(slug(&text), &mut slugs);
                    if let Some(place) = events.get_mut(at) {
                        *place = Event::Html(format!("<{level} id=\"{}\">", escaped(&slug)).into());
                    }
                    if title.is_empty() {
                        title = text;
                    }
                }
                events.push(Event::Html(format!("</{level}>\n").into()));
            }
            Event::Html(markup) | Event::InlineHtml(markup) => {
                // A comment says nothing to a reader.
                if !markup.trim_start().starts_with("<!--") {
                    events.push(Event::Text(markup));
                }
            }
            Event::Start(Tag::Link { link_type, dest_url, title, id }) => match leads(name, &dest_url, link_type) {
                Some(dest_url) => events.push(Event::Start(Tag::Link { link_type, dest_url: dest_url.into(), title, id })),
                None => without_link += 1,
            },
            Event::End(TagEnd::Link) if without_link > 0 => without_link -= 1,
            Event::Start(Tag::Image { link_type, dest_url, title, id }) => match leads(name, &dest_url, link_type) {
                Some(dest_url) => events.push(Event::Start(Tag::Image { link_type, dest_url: dest_url.into(), title, id })),
                None => {
                    without_picture = true;
                    events.push(Event::Start(Tag::Emphasis));
                    events.push(Event::Text(CowStr::Borrowed("Picture: ")));
                }
            },
            Event::End(TagEnd::Image) if without_picture => {
                without_picture = false;
                events.push(Event::End(TagEnd::Emphasis));
            }
            other => {
                if let (Event::Text(part) | Event::Code(part), Some((_, _, text))) = (&other, &mut heading) {
                    text.push_str(part);
                }
                events.push(other);
            }
        }
    }
    for (word, at) in words.into_iter().filter(|(word, _)| !slugs.contains_key(word)) {
        if let Some(place) = events.get_mut(at) {
            let word = escaped(&word);
            *place = Event::Html(format!("<code id=\"{word}\">{word}</code>").into());
        }
    }
    let mut out = String::new();
    pulldown_cmark::html::push_html(&mut out, events.into_iter());
    (title, out)
}

/// Where a link leads from a page: within the book without the ending of a page; `None` if what it names is not in the book.
fn leads(page: &str, link: &str, kind: LinkType) -> Option<String> {
    if matches!(kind, LinkType::Autolink | LinkType::Email) || link.contains("://") || link.starts_with("mailto:") || link.starts_with('#')
    {
        return Some(link.to_owned());
    }
    let (path, anchor) = link.split_once('#').map_or((link, None), |(path, anchor)| (path, Some(anchor)));
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()?),
            part => parts.push(part),
        }
    }
    let target = parts.join("/");
    let (name, _) = found(&target).or_else(|| found(target.strip_suffix(".md")?))?;
    let shown = match (name.strip_suffix("README.md"), name.strip_suffix(".md")) {
        (Some(folder), _) => folder.to_owned(),
        (None, Some(page)) => page.to_owned(),
        (None, None) => name,
    };
    Some(match anchor {
        Some(anchor) => format!("{BASE}{shown}#{anchor}"),
        None => format!("{BASE}{shown}"),
    })
}

/// What a heading is called in links.
fn slug(text: &str) -> String {
    let lower = text.to_lowercase();
    let letters = lower.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    letters.map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// The second heading with a name is `name-1`.
fn unique(slug: String, known: &mut BTreeMap<String, usize>) -> String {
    let count = known.entry(slug.clone()).or_insert(0);
    *count += 1;
    if *count == 1 { slug } else { format!("{slug}-{}", *count - 1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_page_is_made_and_every_link_in_it_leads_somewhere() {
        let pages: Vec<_> = Files::iter().filter(|name| name.ends_with(".md")).collect();
        assert!(pages.len() > 100, "the book is embedded");
        assert!(!pages.iter().any(|name| name.starts_with("benchmarks/")));
        for name in &pages {
            let file = Files::get(name).expect("it was listed");
            let (title, body) = html(name, &String::from_utf8_lossy(&file.data));
            assert!(!title.is_empty(), "{name} has a heading");
            let addresses = ["href=\"", "src=\""].map(|attribute| body.split(attribute).skip(1)).into_iter().flatten();
            for link in addresses.filter_map(|rest| rest.split('"').next()) {
                let path = link.split('#').next().unwrap_or_default();
                let inside = path.strip_prefix(BASE);
                assert!(
                    link.starts_with('#') || link.contains("://") || inside.is_some_and(|inside| found(inside).is_some()),
                    "{name}: {link}"
                );
            }
        }
    }

    #[test]
    fn of_a_picture_that_is_not_in_the_book_its_text_is_left() {
        let (_, body) = html("reference/x.md", "# x\n\n![Live, in the dark](workbench/live.png) ![Beside](signal-diagrams/none.svg)\n");
        assert_eq!(body, "<h1 id=\"x\">x</h1>\n<p><em>Picture: Live, in the dark</em> <em>Picture: Beside</em></p>\n");
        assert!(Files::iter().any(|name| name.ends_with(".svg")), "pictures that are small are in it");
        assert!(!Files::iter().any(|name| name.ends_with(".png")));
    }

    #[test]
    fn a_word_that_begins_a_cell_is_a_place_unless_a_heading_is() {
        let (_, body) = html("x.md", "# x\n\n| word | what |\n|---|---|\n| `+I` | adds `x` |\n| `y` | |\n| `+I` | |\n\n## y\n");
        assert_eq!((body.matches("<code id=\"+I\">+I</code>").count(), body.matches("id=\"y\"").count()), (1, 1), "{body}");
        assert!(body.contains("<h2 id=\"y\">") && body.contains("<code>x</code>"), "{body}");
    }

    #[test]
    fn markup_in_a_page_is_text() {
        let (title, body) =
            html("x.md", "# A `b` c\n\n<script>alert(1)</script>\n\n[out](../spec/stl.md) [in](reference/limits.md#a-b)\n\n## A `b` c\n");
        assert_eq!(title, "A b c");
        assert!(!body.contains("<script"), "{body}");
        assert!(body.contains("out ") && !body.contains("spec/"), "{body}");
        assert!(body.contains("<a href=\"/docs/reference/limits#a-b\">"), "{body}");
        assert!(body.contains("id=\"a-b-c\"") && body.contains("id=\"a-b-c-1\""), "{body}");
    }
}
