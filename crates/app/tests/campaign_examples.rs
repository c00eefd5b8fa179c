//! The campaigns that come with the examples: they hold on the program as it comes, and find what is wrong with it where one statement is another.
//!
//! `SIEBEN_WHOLE=1`, as `cargo xtask test --all` sets it, runs all scenarios and compares what the pages show; without it a part is run.

#![cfg(feature = "parquet")]

mod command;

use std::fs;
use std::path::{Path, PathBuf};

use command::{Folder, Run};

/// A campaign of an example.
struct Campaign {
    example: &'static str,
    file: &'static str,
    /// How many scenarios it has.
    scenarios: u64,
    /// The scenarios that are run where not all are.
    part: &'static str,
    /// What is made wrong: the source, a statement of it, and what stands there then.
    wrong: (&'static str, &'static str, &'static str),
    /// The scenarios that are run of the wrong program, and the property that one of them breaks.
    finds_in: (&'static str, &'static str),
    /// The file of what was found.
    small: &'static str,
}

const CAMPAIGNS: [Campaign; 3] = [
    Campaign {
        example: "star-delta",
        file: "interlock.campaign.toml",
        scenarios: 4096,
        part: "700..799",
        wrong: ("star-delta.awl", "star_on := \"StarOn\"", "star_on := \"Star\""),
        finds_in: ("303..303", "delta onto a closed star contactor"),
        small: "failures/delta-onto-a-closed-star-contactor-303.scenario",
    },
    Campaign {
        example: "heater",
        file: "gains.campaign.toml",
        scenarios: 80,
        part: "0..1",
        wrong: ("heater.scl", "IF step < 0.0 THEN integral := integral + step; END_IF;", "integral := integral + step;"),
        finds_in: ("20..20", "more than 30 K too hot"),
        small: "failures/more-than-30-K-too-hot-20.scenario",
    },
    Campaign {
        example: "dosing",
        file: "shift.campaign.toml",
        scenarios: 1000,
        part: "80..99",
        wrong: ("dosing.awl", "FP    M 0.0;", "AN    Q 0.0;"),
        finds_in: ("90..95", "DISPLAY as recorded"),
        small: "failures/DISPLAY-as-recorded-94.scenario",
    },
];

fn is_whole() -> bool {
    std::env::var_os("SIEBEN_WHOLE").is_some()
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

impl Campaign {
    /// A folder with a copy of the example, called like it.
    fn copied(&self) -> Folder {
        let folder = Folder::new();
        self.copy_into(&folder);
        folder
    }

    fn copy_into(&self, folder: &Folder) {
        folder.run(&["new", self.example, "--example", self.example]).code(0);
    }

    /// Runs a part of it, or all of it.
    fn run(&self, folder: &Folder, only: Option<&str>, more: &[&str]) -> Run {
        let file = format!("{}/{}", self.example, self.file);
        let only = only.map_or_else(Vec::new, |only| vec!["--only", only]);
        folder.run(&[&["campaign", "run", &file, "--quiet"], only.as_slice(), more].concat())
    }

    /// Makes a statement of the copy another one.
    fn break_it(&self, folder: &Folder) {
        let (source, statement, other) = self.wrong;
        let path = format!("{}/{source}", self.example);
        let text = String::from_utf8(folder.read(&path)).expect("UTF-8");
        assert_eq!(text.matches(statement).count(), 1, "{path}: {statement}");
        folder.write(&path, text.replace(statement, other).as_bytes());
    }
}

#[test]
fn they_hold_on_the_program_as_it_comes_for_each_number_of_threads() {
    for campaign in &CAMPAIGNS {
        let folder = campaign.copied();
        let file = format!("{}/{}", campaign.example, campaign.file);
        let listed = folder.run(&["campaign", "list", &file, "--json"]).code(0).json();
        assert_eq!(listed["scenarios"], campaign.scenarios, "{file}");
        let only = (!is_whole()).then_some(campaign.part);
        let results = ["1", "2"].map(|workers| campaign.run(&folder, only, &["--json", "--workers", workers]).code(0).json());
        for key in ["result_hash", "run", "pass", "campaign", "program"] {
            assert_eq!(results[0][key], results[1][key], "{file}: {key}");
        }
        assert_eq!(results[0]["run"], results[0]["pass"], "{file}");
        // In this part everything comes that has to come sometimes.
        let properties = results[0]["properties"].as_array().expect("properties");
        let sometimes: Vec<_> = properties.iter().filter(|property| property["kind"] == "sometimes").collect();
        assert!(!sometimes.is_empty() && sometimes.iter().all(|property| property["came"].as_u64() > Some(0)), "{file}: {sometimes:?}");
    }
}

/// What is found is made small, and is a test of the project from then on. The snapshots show the statement, what it became, and how small the failure is.
#[test]
fn one_wrong_statement_is_found_and_the_failure_is_small() {
    for campaign in &CAMPAIGNS {
        let folder = campaign.copied();
        campaign.break_it(&folder);
        let ((_, statement, other), (only, property)) = (campaign.wrong, campaign.finds_in);
        let result = campaign.run(&folder, Some(only), &["--json"]).code(1).json();
        let file = format!("{}/{}", campaign.example, campaign.small);
        let broken = &result["first_failure"]["property"];
        assert!(broken == property || broken.is_null() && property.ends_with("as recorded"), "{file}: {broken}");
        assert_eq!(result["first_failure"]["file"], file.as_str());
        let small = String::from_utf8(folder.read(&file)).expect("UTF-8");
        insta::assert_snapshot!(format!("small_{}", campaign.example), format!("{statement}\n{other}\n{small}"));
        folder.run(&["test", campaign.example]).code(1).stdout(&format!("FAIL  {file}"));
        // Mended, it passes.
        let fresh = campaign.copied();
        fresh.write(&file, &folder.read(&file));
        fresh.run(&["test", campaign.example]).code(0).stdout(&format!("ok    {file}"));
    }
}

#[test]
fn the_recording_of_the_dosing_is_what_its_command_records() {
    let readme = fs::read_to_string(root().join("examples/dosing/README.md")).expect("the README");
    let command = readme.lines().find_map(|line| line.strip_prefix("$ sieben record ")).expect("the command");
    let words: Vec<&str> = command.split(' ').map(|word| if word.ends_with("shift.scenario") { "-" } else { word }).collect();
    let recorded = Run::of(&root(), &[&["record"], words.as_slice()].concat()).code(0).stdout;
    assert!(recorded.as_bytes() == fs::read(root().join("examples/dosing/shift.scenario")).expect("the recording"), "{recorded}");
}

/// A fence of a page with commands: the number of its first line, and its lines.
fn fences(text: &str) -> Vec<(usize, Vec<&str>)> {
    let mut fences = Vec::new();
    let mut open: Option<(usize, Vec<&str>)> = None;
    for (index, line) in text.lines().enumerate() {
        match (&mut open, line) {
            (None, "```text") => open = Some((index + 1, Vec::new())),
            (Some(_), "```") => fences.extend(open.take().filter(|(_, lines)| lines.iter().any(|line| line.starts_with("$ ")))),
            (Some((_, lines)), line) => lines.push(line),
            (None, _) => {}
        }
    }
    fences
}

/// What commands of a page print, each after its line.
fn printed(folder: &Folder, lines: &[&str]) -> Vec<String> {
    let mut all = Vec::new();
    for line in lines.iter().filter(|line| line.starts_with("$ ")) {
        all.push((*line).to_owned());
        let words: Vec<&str> = line.trim_start_matches("$ ").split(' ').collect();
        match words.as_slice() {
            // What a project is made of, and what a report says, stands elsewhere.
            ["sieben", "new", ..] => drop(folder.run(&words[1..]).code(0)),
            ["sieben", "campaign", "report", ..] => drop(folder.run(&words[1..])),
            ["sieben", arguments @ ..] => {
                let quiet: &[&str] = if arguments.starts_with(&["campaign", "run"]) { &["--quiet"] } else { &[] };
                let run = folder.run(&[arguments, quiet].concat());
                let lines = run.stdout.lines().chain(run.stderr.lines()).filter(|line| !line.ends_with(" scenarios tried"));
                all.extend(lines.map(|line| line.trim_end().to_owned()));
            }
            // A page whose reader edits a source says how: as one line for a shell.
            ["sed", "-i", ..] => {
                let (_, rest) = line.split_once("'s/").expect("`sed -i 's/…/…/' FILE`");
                let (edit, file) = rest.split_once("/' ").expect("`sed -i 's/…/…/' FILE`");
                let (from, to) = edit.split_once('/').expect("`sed -i 's/…/…/' FILE`");
                let text = String::from_utf8(folder.read(file)).expect("UTF-8");
                assert!(text.contains(from), "{file} has no `{from}`");
                folder.write(file, text.replace(from, to).as_bytes());
            }
            _ => panic!("`{line}` is no command that a page may have here"),
        }
    }
    all
}

/// A line without how long it took.
fn timeless(line: &str) -> &str {
    line.split_once(" scans in ").map_or(line, |(before, _)| before)
}

/// `UPDATE_DOCUMENTS=1 SIEBEN_WHOLE=1` writes what the commands print into the pages.
#[test]
fn pages_show_what_the_campaigns_of_the_examples_print() {
    let examples = CAMPAIGNS.iter().map(|campaign| format!("examples/{}/README.md", campaign.example));
    let update = std::env::var_os("UPDATE_DOCUMENTS").is_some();
    let mut wrong = Vec::new();
    for page in examples.chain(["docs/how-to/campaigns.md".to_owned()]) {
        let text = fs::read_to_string(root().join(&page)).expect(&page);
        let folder = Folder::new();
        for campaign in &CAMPAIGNS {
            for entry in fs::read_dir(root().join("examples").join(campaign.example)).expect("an example") {
                let path = entry.expect("an entry").path();
                let name = format!("examples/{}/{}", campaign.example, path.file_name().expect("a name").to_string_lossy());
                folder.write(&name, &fs::read(&path).expect("a file"));
            }
        }
        named_files(&folder, &text);
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let mut all: Vec<(usize, usize, Vec<String>)> = Vec::new();
        for (first, shown) in fences(&text) {
            // What takes a minute is looked at where there is time for it.
            if shown.iter().any(|line| line.contains("gains.campaign.toml")) && !is_whole() {
                continue;
            }
            let printed = printed(&folder, &shown);
            if printed.iter().map(|line| timeless(line)).ne(shown.iter().map(|line| timeless(line))) {
                wrong.push(format!("{page}:{first}: the commands print\n{}\n", printed.join("\n")));
                all.push((first, shown.len(), printed));
            }
        }
        for (first, count, printed) in all.into_iter().rev() {
            lines.splice(first..first + count, printed);
        }
        if update {
            fs::write(root().join(&page), lines.join("\n") + "\n").expect("a page can be written");
        }
    }
    assert!(update || wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Writes the files that a page shows with a name.
fn named_files(folder: &Folder, page: &str) {
    let mut open: Option<(&str, String)> = None;
    for line in page.lines() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(words)) => open = Some((words.split(' ').nth(1).unwrap_or_default(), String::new())),
            (Some((name, text)), Some(_)) => {
                if !name.is_empty() {
                    folder.write(name, text.as_bytes());
                }
                open = None;
            }
            (Some((_, text)), None) => *text += &format!("{line}\n"),
            (None, None) => {}
        }
    }
}

/// What the page shows of a campaign is in its file.
#[test]
fn the_page_about_campaigns_shows_parts_of_the_files_of_the_examples() {
    let page = fs::read_to_string(root().join("docs/how-to/campaigns.md")).expect("the page");
    let files = CAMPAIGNS.iter().map(|campaign| root().join("examples").join(campaign.example).join(campaign.file));
    let files: Vec<String> = files.map(|path| fs::read_to_string(path).expect("a campaign")).collect();
    let parts: Vec<&str> = page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert_eq!(parts.len(), 2, "{parts:?}");
    for part in parts {
        assert!(files.iter().any(|file| file.contains(part)), "no example has\n{part}");
    }
}

/// The pictures of the page about campaigns. `SIEBEN_GENERATE=1 SIEBEN_WHOLE=1` writes them.
#[test]
fn pictures_of_the_page_about_campaigns_are_those_of_the_reports() {
    let mut pictures = vec!["delta-onto-a-closed-star-contactor-303.svg"];
    let [starter, oven, _] = &CAMPAIGNS;
    let folder = starter.copied();
    starter.break_it(&folder);
    starter.run(&folder, Some(starter.finds_in.0), &["--out", "starter.parquet"]).code(1);
    folder.run(&["campaign", "report", "starter.parquet", "--svg", "pictures"]).code(1);
    if is_whole() {
        oven.copy_into(&folder);
        oven.run(&folder, None, &["--out", "oven.parquet"]).code(0);
        folder.run(&["campaign", "report", "oven.parquet", "--svg", "pictures"]).code(0);
        pictures.extend(["overshoot-in-K-mean.svg", "ready-after-in-s-mean.svg"]);
    }
    for picture in pictures {
        let (stored, now) = (root().join("docs/how-to/campaigns").join(picture), folder.read(&format!("pictures/{picture}")));
        if std::env::var_os("SIEBEN_GENERATE").is_some() {
            fs::create_dir_all(stored.parent().expect("a folder")).expect("a folder");
            fs::write(&stored, &now).expect("a picture can be written");
        }
        assert!(fs::read(&stored).is_ok_and(|stored| stored == now), "{picture} is stale: SIEBEN_GENERATE=1 writes it");
    }
}
