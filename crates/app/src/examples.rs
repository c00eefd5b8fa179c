//! The examples, as they come with the binary.

use std::path::Path;

use sieben_workspace::project::Project;
use sieben_workspace::settings;

/// An example: its name, what it is, and its files.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Example {
    /// What `sieben new --example` calls it.
    pub(crate) name: &'static str,
    /// What it is, in a few words.
    pub(crate) about: &'static str,
    /// Paths inside the project and contents.
    pub(crate) files: &'static [(&'static str, &'static str)],
}

/// What a file of an example is to its program.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Settings,
    Symbols,
    Source,
    Other,
}

fn kind(path: &str) -> Kind {
    match Path::new(path).extension().and_then(|ending| ending.to_str()) {
        _ if path == settings::FILE_NAME => Kind::Settings,
        Some("csv") => Kind::Symbols,
        Some("awl" | "scl" | "st") if !path.contains(".test.") => Kind::Source,
        _ => Kind::Other,
    }
}

macro_rules! examples {
    ($($name:literal $source:literal $(, $beside:literal)* ; $about:literal)*) => {
        /// All examples.
        pub(crate) const ALL: &[Example] = &[$(Example {
            name: $name,
            about: $about,
            files: &[
                ("sieben.toml", include_str!(concat!("../../../examples/", $name, "/sieben.toml"))),
                ("symbols.csv", include_str!(concat!("../../../examples/", $name, "/symbols.csv"))),
                ("README.md", include_str!(concat!("../../../examples/", $name, "/README.md"))),
                ($source, include_str!(concat!("../../../examples/", $name, "/", $source))),
                $(($beside, include_str!(concat!("../../../examples/", $name, "/", $beside))),)*
                (concat!($name, ".watch"), include_str!(concat!("../../../examples/", $name, "/", $name, ".watch"))),
                (concat!($name, ".scenario"), include_str!(concat!("../../../examples/", $name, "/", $name, ".scenario"))),
                (concat!($name, ".test.st"), include_str!(concat!("../../../examples/", $name, "/", $name, ".test.st"))),
            ],
        }),*];
    };
}

examples! {
    "car-park" "car-park.st"; "a car park that counts, in ST"
    "conveyor" "conveyor.awl"; "a conveyor with a jump distributor"
    "decade-switches" "decade-switches.awl"; "decade switches and a display, with German mnemonics"
    "dosing" "dosing.awl", "shift.campaign.toml", "shift.scenario"; "dosing of a liquid, the plant of the demo"
    "elevator" "elevator.scl"; "an elevator with four floors, in SCL"
    "heater" "heater.scl", "gains.campaign.toml"; "an oven with a PI controller, in SCL"
    "packing" "packing.awl"; "packing with pointers"
    "star-delta" "star-delta.awl", "star-delta.lad", "interlock.campaign.toml"; "a star-delta starter, with German mnemonics"
    "tank" "tank.awl"; "a tank whose level is kept"
    "traffic-light" "traffic-light.awl"; "a traffic light, with German mnemonics"
}

impl Example {
    /// The files that its program is made of.
    pub(crate) fn compiled(&self) -> impl Iterator<Item = &'static (&'static str, &'static str)> {
        self.files.iter().filter(|(path, _)| kind(path) != Kind::Other)
    }

    /// The same as a project.
    pub(crate) fn project(&self) -> Project {
        let mut project = Project::new(None);
        for (path, content) in self.compiled() {
            let (file, bytes) = (Path::new(path), content.as_bytes());
            match kind(path) {
                Kind::Settings => project.add_settings(file, bytes),
                Kind::Symbols => project.add_symbols(file, bytes).expect("an example has a small table"),
                Kind::Source => project.add_source(file, bytes),
                Kind::Other => {}
            }
        }
        project
    }

    /// The example of this name.
    pub(crate) fn by_name(name: &str) -> Option<&'static Self> {
        ALL.iter().find(|example| example.name == name)
    }

    /// The files as a project of another name has them: nothing refers to the folder of the examples any more.
    pub(crate) fn renamed(&self, project: &str) -> Vec<(&'static str, String)> {
        let rename = |&(path, content): &(&'static str, &'static str)| {
            let content = match path {
                "README.md" => without_links_outside(content)
                    .replace(&format!("examples/{}/", self.name), "")
                    .replace(&format!("examples/{}", self.name), "."),
                "sieben.toml" => content.replacen(&format!("name = \"{}\"", self.name), &format!("name = \"{project}\""), 1),
                _ => content.to_owned(),
            };
            (path, content)
        };
        self.files.iter().map(rename).collect()
    }
}

/// Links to pages outside of the project become their words.
fn without_links_outside(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("](../") {
        let (before, link) = rest.split_at(at);
        let (Some(open), Some(close)) = (before.rfind('['), link.find(')')) else { break };
        out.push_str(&before[..open]);
        out.push_str(&before[open + 1..]);
        rest = &link[close + 1..];
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_knows_nothing_of_the_folder_of_the_examples() {
        for example in ALL {
            for (path, content) in example.renamed("my-plant") {
                assert!(!content.contains("../") && !content.contains(&format!("examples/{}", example.name)), "{}: {path}", example.name);
            }
            assert!(example.renamed("my-plant")[0].1.contains("name = \"my-plant\""), "{}", example.name);
        }
        assert_eq!(without_links_outside("a [tank](../../x.md#tank) and [b](c.md)"), "a tank and [b](c.md)");
    }
}
