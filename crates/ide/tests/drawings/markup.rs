//! Markup: what comes from outside stays text, and every picture is well formed.

use std::rc::Rc;

use proptest::prelude::*;
use sieben_ide::drawing::page::{BlockPage, NetworkPage, PageContent, SymbolRow, html};
use sieben_ide::drawing::style::STYLE;
use sieben_ide::drawing::{Layout, Options, function_plan, ladder, svg};
use sieben_lang::network::model::{Content, End, Kind, Network, OutputKind, Place, Rung};

use super::generator;

fn line(place: Place) -> usize {
    place.first as usize
}

fn picture(title: &str, layout: &Layout) -> String {
    svg::stand_alone(&[svg::Picture { title, layout, flows: None }])
}

fn named(name: &str) -> Network {
    let line = vec![Kind::contact(name, false).at(Place::default())];
    let outputs = vec![OutputKind::Assign(name.into()).at(Place::default())];
    Network { label: Some(name.into()), content: Content::Rung(Rung::new(line, End::Outputs(outputs))) }
}

const HOSTILE: [&str; 6] =
    ["</text><script>alert(1)</script>", "\" onload=\"x", "]]>&lt;", "a\u{0}b\u{1b}[31m", "\u{FFFE}\u{202E}x", "<!--"];

#[test]
fn a_name_from_outside_never_becomes_markup() {
    for name in HOSTILE {
        let network = named(name);
        for draw in [ladder, function_plan] {
            let layout = draw(&network, &Options::new(&line)).unwrap();
            let text = picture(name, &layout);
            let document = roxmltree::Document::parse(&text).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
            let known = ["svg", "style", "rect", "text", "g", "path", "circle"];
            for node in document.descendants().filter(roxmltree::Node::is_element) {
                assert!(known.contains(&node.tag_name().name()), "{name}: {node:?}");
                let strange = node.attributes().find(|attribute| attribute.name().starts_with("on") || attribute.name() == "style");
                assert_eq!(strange, None, "{name}");
            }
        }
        let page = html(
            name,
            &[BlockPage {
                name: name.to_owned(),
                symbol: Some(name.to_owned()),
                title: Some(name.to_owned()),
                comment: Some(name.to_owned()),
                header: vec![(name.to_owned(), name.to_owned())],
                networks: vec![NetworkPage {
                    number: 1,
                    title: Some(name.to_owned()),
                    comment: Some(name.to_owned()),
                    content: PageContent::Statements(name.to_owned()),
                    reason: Some(name.to_owned()),
                    symbols: vec![Rc::new(SymbolRow {
                        address: name.to_owned(),
                        references: vec![name.to_owned()],
                        ..SymbolRow::default()
                    })],
                }],
            }],
        );
        assert!(!page.contains("<script") && !page.contains("\" onload") && !page.contains("<!--"), "{page}");
    }
}

#[test]
fn the_style_sheet_stands_in_the_file_and_nowhere_else() {
    let layout = ladder(&named("I 0.0"), &Options::new(&line)).unwrap();
    assert_eq!(picture("one", &layout).matches("<style>").count(), 1);
    let bare = svg::svg(&svg::Picture { title: "one", layout: &layout, flows: None });
    assert!(!bare.contains("style") && !bare.contains("script"), "{bare}");
    for rule in ["prefers-color-scheme:dark", "@media print", "stroke-dasharray"] {
        assert!(STYLE.contains(rule), "{rule}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_picture_is_well_formed(seed in any::<u64>()) {
        let network = generator::network(seed);
        for draw in [ladder, function_plan] {
            let layout = draw(&network, &Options::new(&line)).map_err(|refusal| TestCaseError::fail(refusal.message()))?;
            let text = picture("a network", &layout);
            prop_assert!(roxmltree::Document::parse(&text).is_ok(), "{text}");
        }
    }
}
