//! Pictures beside the diagrams that they show, in `drawings/`, and what holds for the picture of every diagram.

#[path = "drawings/generator.rs"]
mod generator;
#[path = "drawings/invariants.rs"]
mod invariants;
#[path = "drawings/markup.rs"]
mod markup;
#[path = "drawings/status.rs"]
mod status;

use proptest::prelude::*;
use sieben_ide::drawing::text::{Characters, text};
use sieben_ide::drawing::{Layout, NESTING_MAX, Options, Refusal, function_plan, ladder};
use sieben_lang::network::flavour::Flavour;
use sieben_lang::network::form_b;
use sieben_lang::network::model::{Branch, Content, End, Kind, Network, OutputKind, Place, Rung};

const PAGES: [(&str, &str); 2] =
    [("elements.md", include_str!("drawings/elements.md")), ("networks.md", include_str!("drawings/networks.md"))];

/// A diagram of a page, and its pictures there.
struct Case {
    title: String,
    network: Network,
    pictures: [String; 2],
}

/// The lines of the fenced blocks of a section, each with the words after its fence.
fn blocks(section: &str) -> Vec<(&str, String)> {
    let mut blocks = Vec::new();
    let mut open: Option<(&str, String)> = None;
    for line in section.lines() {
        match (line.strip_prefix("```"), open.take()) {
            (Some(_), Some(block)) => blocks.push(block),
            (Some(info), None) => open = Some((info, String::new())),
            (None, Some((info, mut text))) => {
                text += line;
                text.push('\n');
                open = Some((info, text));
            }
            (None, None) => {}
        }
    }
    blocks
}

fn cases(page: &str) -> Vec<Case> {
    let sections = page.split("\n## ").skip(1);
    let case = |section: &str| {
        let title = section.lines().next().unwrap_or_default().to_owned();
        let blocks = blocks(section);
        let [(info, line), (lad, first), (fbd, second)] = blocks.as_slice() else { panic!("{title}: three blocks") };
        assert_eq!((*lad, *fbd), ("lad", "fbd"), "{title}");
        let flavour = if *info == "form-b iec" { Flavour::Iec } else { Flavour::S7 };
        let network = form_b::parse(line.trim(), 0, flavour).unwrap_or_else(|wrong| panic!("{title}: {wrong:?}"));
        Case { title, network, pictures: [first.clone(), second.clone()] }
    };
    sections.map(case).collect()
}

fn first_byte(place: Place) -> usize {
    place.first as usize
}

fn options() -> Options<'static> {
    Options::new(&first_byte)
}

fn picture(drawn: &Result<Layout, Refusal>) -> String {
    match drawn {
        Ok(layout) => text(layout, None, Characters::Unicode),
        Err(refusal) => format!("{}\n", refusal.message()),
    }
}

#[test]
fn every_page_shows_what_is_drawn() {
    for (name, page) in PAGES {
        let mut wrong = String::new();
        for case in cases(page) {
            let drawn = [ladder(&case.network, &options()), function_plan(&case.network, &options())].map(|drawn| picture(&drawn));
            for (drawn, wanted) in drawn.iter().zip(&case.pictures) {
                if drawn != wanted {
                    wrong += &format!("{}\n{drawn}", case.title);
                }
            }
        }
        assert!(wrong.is_empty(), "{name}: what is drawn now:\n{wrong}");
    }
}

#[test]
fn ascii_uses_no_other_characters_for_lines() {
    let network = form_b::parse("[MW 10 >I 100] { /I 0.1 MOVE(MW 12 => QW 4) -> = Q 4.1 ; -> S M 2.0 }", 0, Flavour::S7).unwrap();
    let layout = ladder(&network, &options()).unwrap();
    let drawn = text(&layout, None, Characters::Ascii);
    let wanted = "\
| MW 10    I 0.1        +-MOVE-+        Q 4.1
+--|>I|--+--|/|---------|EN ENO|---------( )--+
   100   |         MW 12|IN OUT| QW 4
         |              +------+
         |                              M 2.0
         +-------------------------------(S)--+
";
    assert_eq!(drawn, wanted);
}

#[test]
fn the_same_element_has_the_same_name_in_both_drawings() {
    let network = form_b::parse("(I 0.0 | I 0.1) SR[M 0.0](R := I 0.2) -> = Q 4.0, S M 0.1", 0, Flavour::S7).unwrap();
    let of_line = |_: Place| 7;
    let names = |layout: Layout| {
        let mut names: Vec<String> = layout.symbols.into_iter().map(|symbol| symbol.element).filter(|name| !name.is_empty()).collect();
        names.sort();
        names
    };
    let ladder = names(ladder(&network, &Options::new(&of_line)).unwrap());
    assert_eq!(ladder, ["coil-7", "coil-7-2", "contact-7", "contact-7-2", "contact-7-3", "flipflop-7"]);
    let mut plan = names(function_plan(&network, &Options::new(&of_line)).unwrap());
    plan.retain(|name| name != "or-7");
    assert_eq!(plan, ladder);
}

/// A contact after another, so many in all.
fn row(count: usize) -> Network {
    let line =
        (0..count).map(|index| Kind::contact(format!("I {}.{}", index / 8, index % 8), false).at(Place::new(index, index))).collect();
    let outputs = vec![OutputKind::Assign("Q 4.0".into()).at(Place::new(count, count))];
    Network { label: None, content: Content::Rung(Rung::new(line, End::Outputs(outputs))) }
}

/// Branches in branches, so many levels deep.
fn nest(depth: usize) -> Network {
    let contact = || Kind::contact("I 0.0", false).at(Place::default());
    let mut line = vec![contact()];
    for _ in 0..depth {
        let branches = vec![Branch { line, bracketed: false }, Branch { line: vec![contact()], bracketed: false }];
        line = vec![contact(), Kind::Parallel { branches, negated: false }.at(Place::default())];
    }
    let outputs = vec![OutputKind::Assign("Q 4.0".into()).at(Place::default())];
    Network { label: None, content: Content::Rung(Rung::new(line, End::Outputs(outputs))) }
}

/// Takes a nested network apart without recursion.
fn take_apart(network: Network) {
    let Content::Rung(rung) = network.content else { return };
    let mut lines = vec![rung.line];
    while let Some(line) = lines.pop() {
        for element in line {
            if let Kind::Parallel { branches, .. } = element.kind {
                lines.extend(branches.into_iter().map(|branch| branch.line));
            }
        }
    }
}

#[test]
fn a_large_network_is_drawn_in_linear_size() {
    for draw in [ladder, function_plan] {
        let sizes = [1_000, 10_000].map(|count| {
            let layout = draw(&row(count), &options()).unwrap();
            assert!(layout.columns <= 140, "{}", layout.columns);
            assert_eq!(layout.symbols.iter().filter(|symbol| symbol.kind == "contact").count(), count);
            layout.lines * layout.columns
        });
        assert!(sizes[1] <= sizes[0] * 11, "{sizes:?}");
    }
}

#[test]
fn a_deep_network_is_drawn_or_refused() {
    for draw in [ladder, function_plan] {
        let deep = nest(1_000);
        assert_eq!(draw(&deep, &options()), Err(Refusal::TooDeep));
        take_apart(deep);
        let layout = draw(&nest(NESTING_MAX), &options()).unwrap();
        assert!(layout.columns <= 200, "{}", layout.columns);
        invariants::check(&layout).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_symbol_touches_another_and_no_line_goes_through_one(seed in any::<u64>()) {
        let network = generator::network(seed);
        let contacts = generator::contacts(&network);
        let outputs = generator::outputs(&network);
        for (name, drawn) in [("LAD", ladder(&network, &options())), ("FBD", function_plan(&network, &options()))] {
            let layout = drawn.map_err(|refusal| TestCaseError::fail(refusal.message()))?;
            let shown = text(&layout, None, Characters::Unicode);
            if let Err(problem) = invariants::check(&layout) {
                return Err(TestCaseError::fail(format!("{name}: {problem}\n{shown}")));
            }
            let count = |kinds: &[&str]| layout.symbols.iter().filter(|symbol| kinds.contains(&symbol.kind)).count();
            prop_assert_eq!(count(&["contact"]), contacts, "{}: each contact is drawn once\n{}", name, shown);
            prop_assert_eq!(count(&["coil", "jump"]), outputs, "{}: each output is drawn once\n{}", name, shown);
        }
    }
}
