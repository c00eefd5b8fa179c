//! Every example compiles without a warning, says in its README what its terminals are, and runs the same on both engines.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folders below `examples/`.
fn examples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut examples: Vec<PathBuf> = fs::read_dir(folder)
        .expect("the folder of the examples")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.join("sieben.toml").is_file())
        .collect();
    examples.sort();
    assert!(examples.len() >= 10, "{examples:?}");
    examples
}

fn name(example: &Path) -> String {
    example.file_name().expect("a name").to_string_lossy().into_owned()
}

/// What `sieben` prints and its exit code.
fn sieben(arguments: &[&str], example: &Path) -> (String, Option<i32>) {
    let output = Command::new(env!("CARGO_BIN_EXE_sieben")).env("LC_ALL", "C").args(arguments).arg(example).output().expect("sieben runs");
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    (text, output.status.code())
}

#[test]
fn every_example_is_checked_without_a_warning() {
    for example in examples() {
        assert_eq!(sieben(&["check", "--json"], &example), ("[]\n".to_owned(), Some(0)), "{}", name(&example));
    }
}

#[test]
fn every_example_is_whole() {
    for example in examples() {
        let name = name(&example);
        let readme = fs::read_to_string(example.join("README.md")).expect(&name);
        for heading in ["## Try this", "## Break it"] {
            assert!(readme.contains(heading), "{name}: `{heading}` is missing");
        }
        let symbols = fs::read_to_string(example.join("symbols.csv")).expect(&name);
        for line in symbols.lines().skip(1) {
            let fields: Vec<&str> = line.split(',').collect();
            let terminal = |field: &str| {
                let (area, number) = field.split_once(' ')?;
                (area.len() <= 2 && area.starts_with(['I', 'E', 'Q', 'A']) && number.starts_with(|c: char| c.is_ascii_digit()))
                    .then_some(())
            };
            let address = fields.iter().find(|field| terminal(field).is_some());
            if let Some(address) = address {
                assert!(readme.contains(&format!("| {address} |")), "{name}: {address} is not in the table of the README");
            }
        }
        let tests = fs::read_to_string(example.join(format!("{name}.test.st"))).expect(&name);
        assert!(tests.lines().filter(|line| line.starts_with("TEST ")).count() >= 5, "{name}: fewer than five tests");
        assert!(tests.contains("TEST 'a fault found"), "{name}: no test shows a fault that is found");
        let overview = fs::read_to_string(example.join("../README.md")).expect("the overview");
        assert!(overview.contains(&format!("({name}/README.md)")), "{name} is not in the overview");
    }
}

#[test]
fn every_unit_test_of_every_example_passes_on_both_engines() {
    for example in examples() {
        let name = name(&example);
        for engine in ["interpreter", "jit"] {
            let (text, code) = sieben(&["test", "--engine", engine], &example);
            assert_eq!(code, Some(0), "{name} on {engine}: {text}");
            let passed = text.lines().filter(|line| line.starts_with("ok ")).count();
            assert!(passed >= 5 && text.contains("ok    ") && text.contains(": a fault found: "), "{name} on {engine}: {text}");
        }
    }
}

/// What comes with the binary is what lies in the folder, under another name.
#[test]
fn every_example_can_be_copied() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("copied-examples");
    // Nothing is overwritten: the folder of an earlier run has to go.
    let _ = fs::remove_dir_all(&folder);
    for example in examples() {
        let name = name(&example);
        let copy = folder.join(&name);
        let (text, code) = sieben(&["new", "--example", &name], &copy);
        assert_eq!(code, Some(0), "{name}: {text}");
        let count = |folder: &Path| fs::read_dir(folder).expect("a folder").count();
        assert_eq!(count(&copy), count(&example), "{name}");
        assert_eq!(sieben(&["check", "--json"], &copy), ("[]\n".to_owned(), Some(0)), "{name}");
    }
    let (text, code) = sieben(&["new", "--example", "pump"], &folder.join("pump"));
    assert!(code == Some(2) && text.contains("elevator"), "{text}");
}

/// The story of every example comes true, and is the same recording on each engine.
#[test]
fn every_scenario_comes_true_on_both_engines() {
    for example in examples() {
        let name = name(&example);
        let scenario = example.join(format!("{name}.scenario"));
        let scenario = scenario.to_str().expect("a path in UTF-8");
        let run = |engine: &str| sieben(&["trace", scenario, "--engine", engine, "--csv", "-"], &example);
        let (recorded, code) = run("interpreter");
        assert_eq!(code, Some(0), "{name}: {recorded}");
        assert!(recorded.lines().count() > 5, "{name}: {recorded}");
        assert!((recorded, code) == run("jit"), "{name}: the engines differ");
    }
}

/// A minute of every example on each engine, with plants whose signals fail at random: every value of every scan is the same.
#[test]
fn the_same_seed_is_the_same_run_on_both_engines() {
    let shown = "IB 0,IB 1,IW 2,IW 4,QB 0,QB 1,QW 2,QW 4,QB 8,MD 0,MD 8,MD 16";
    for (name, faults) in [
        ("dosing", vec!["plant.flow bounce=80ms@1s", "plant.start stuck=1@500ms..700ms"]),
        ("tank", vec!["tank.level drift=0.5@10s", "tank.high bounce=300ms"]),
        ("packing", vec!["belt.right_end bounce=50ms", "belt.weight late=300ms"]),
        ("traffic-light", vec!["junction.request late=2s", "junction.side_car bounce=1s"]),
        ("heater", vec!["oven.temperature drift=0.1@20s..40s"]),
        ("elevator", vec!["lift.call_3 stuck=1@1s..2s", "lift.barrier bounce=500ms"]),
    ] {
        let example = examples().into_iter().find(|example| self::name(example) == name).expect(name);
        let run = |engine: &str| {
            let mut arguments = vec!["exec", "--engine", engine, "--for", "60s", "--every", "--json", "--show", shown];
            for fault in &faults {
                arguments.extend(["--fault", fault]);
            }
            arguments.extend(["--set", "I 8.0=1"]);
            sieben(&arguments, &example)
        };
        let (interpreted, code) = run("interpreter");
        assert_eq!(code, Some(0), "{name}: {interpreted}");
        assert_eq!(interpreted.lines().count(), 6000, "{name}");
        let distinct: std::collections::BTreeSet<&str> = interpreted.lines().filter_map(|line| line.split("\"values\"").nth(1)).collect();
        assert!(distinct.len() > 20, "{name}: something happens");
        assert!(interpreted == run("interpreter").0, "{name}: two runs differ");
        assert!(interpreted == run("jit").0, "{name}: the engines differ");
    }
}

/// A program that lies next to the sources of an example as a ladder diagram does the same: what its tests and its scenario say, and what the statement list does in every scan.
#[test]
fn a_ladder_diagram_next_to_an_example_does_the_same() {
    let example =
        examples().into_iter().find(|example| example.join("star-delta.lad").is_file()).expect("an example with a ladder diagram");
    let name = name(&example);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawn-example");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    for entry in fs::read_dir(&example).expect("the example") {
        let path = entry.expect("an entry").path();
        fs::copy(&path, folder.join(path.file_name().expect("a name"))).expect("a copy");
    }
    let settings = fs::read_to_string(example.join("sieben.toml")).expect("settings");
    assert!(settings.contains("star-delta.awl") && !settings.contains("star-delta.lad"), "the diagram is no second program");
    let drawn = settings.replace("star-delta.awl", "star-delta.lad");
    fs::write(folder.join("sieben.toml"), drawn).expect("settings");

    assert_eq!(sieben(&["check", "--json"], &folder), ("[]\n".to_owned(), Some(0)));
    let (text, code) = sieben(&["fmt", "--check"], &folder);
    assert_eq!(code, Some(0), "{text}");
    let outcomes = |folder: &Path, engine: &str| {
        let (text, code) = sieben(&["test", "--engine", engine], folder);
        let text: Vec<String> = text
            .lines()
            .filter(|line| line.starts_with("ok "))
            .map(|line| line.rsplit(": ").next().unwrap_or_default().to_owned())
            .collect();
        (text.len(), code)
    };
    let scenario = example.join(format!("{name}.scenario"));
    let scenario = scenario.to_str().expect("a path in UTF-8");
    let signals = "IB0,IB8,QB0,QB8,T 1,T 2,T 3,Motor1.on,Motor1.star_done,Motor1.differs,Motor1.fault";
    let recorded =
        |folder: &Path, engine: &str| sieben(&["trace", scenario, "--engine", engine, "--channels", signals, "--csv", "-"], folder);
    for engine in ["interpreter", "jit"] {
        assert_eq!(outcomes(&folder, engine), outcomes(&example, engine), "{engine}");
        let (list, diagram) = (recorded(&example, engine), recorded(&folder, engine));
        assert_eq!(list.1, Some(0), "{}", list.0);
        assert!(list.0.lines().count() > 5, "{}", list.0);
        assert!(list == diagram, "{engine}: the programs differ");
    }
}
