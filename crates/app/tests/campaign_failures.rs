//! What fails in a campaign, made small: a scenario that fails alone, with the statement that did it.

mod command;

use command::Folder;

/// Two contactors; the second one forgets the first where it is switched by hand, which takes the button for three scans.
const MOTOR: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 0.0;\n AN Q 0.1;\n = Q 0.0;\n A I 0.1;\n AN Q 0.0;\n = Q 0.1;\n L MW 10;\n L 1;\n +I;\n T MW 10;\n \
                     AN I 0.2;\n JCN hand;\n L 0;\n T MW 10;\nhand: L MW 10;\n L 3;\n >=I;\n S Q 0.1;\nEND_ORGANIZATION_BLOCK\n";
const SPEC: &str = "[campaign]\nname = \"motor\"\nfor = \"5s\"\nsamples = 60\n[draw]\n\"I 0.0\" = { walk = { every = \"100ms\", chance = 0.2 } }\n\
                    \"I 0.1\" = { walk = { every = \"70ms\", chance = 0.2 } }\n\"I 0.2\" = { walk = { every = \"90ms\", chance = 0.3 } }\n\"MW 20\" = { uniform = [1, 900] }\n\
                    [[never]]\nname = \"both contactors\"\nexpr = \"Q0.0 AND Q0.1\"\n";

#[test]
fn a_failure_becomes_a_small_scenario_that_a_test_runs() {
    let folder = Folder::with(&[("main.awl", MOTOR), ("c.toml", SPEC)]);
    let result = folder.run(&["campaign", "run", "c.toml", "--json", "--quiet"]).code(1).json();
    let file = result["first_failure"]["file"].as_str().expect("it was written").to_owned();
    let number = result["first_failure"]["scenario"].as_u64().expect("it has a number");
    assert!(file.ends_with(&format!("failures/both-contactors-{number}.scenario")), "{file}");
    let text = String::from_utf8(folder.read(&file)).expect("text");
    assert!(text.contains("\"both contactors\": `Q0.0 AND Q0.1` must never be true, and is after scan"), "{text}");
    assert!(text.contains("`Q0.1` was changed last by main.awl:20 `S Q 0.1`"), "{text}");
    // Two buttons at the same moment are all that it takes.
    let events = text.lines().filter(|line| line.starts_with("at ")).count();
    assert!((1..=3).contains(&events) && !text.contains("MW 20"), "{text}");
    let test = folder.run(&["test", "main.awl", "--tests", &file]).code(1);
    assert!(test.stdout.contains("must never be true, and is after"), "{}", test.stdout);
    // The same once more, and by the command.
    let shrunk = folder.run(&["campaign", "shrink", "c.toml", &number.to_string()]).code(0);
    assert_eq!(shrunk.stdout, text);
    folder.run(&["campaign", "shrink", "c.toml", &number.to_string(), "-o", "f.scenario"]).code(0).stderr("was changed last by");
    assert_eq!(folder.read("f.scenario"), text.as_bytes());
    // Mended, it passes.
    folder.write("main.awl", MOTOR.replace(" >=I;\n S Q 0.1;", " >=I;\n AN Q 0.0;\n S Q 0.1;").as_bytes());
    folder.run(&["test", "main.awl", "--tests", "f.scenario"]).code(0);
    folder.run(&["campaign", "shrink", "c.toml", &number.to_string()]).code(2).stderr(&format!("scenario {number} does not fail"));
}

#[test]
fn the_smallest_combination_is_that_with_the_fewest_ones() {
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 0.0;\n A I 0.3;\n = Q 0.0;\nEND_ORGANIZATION_BLOCK\n";
    let spec = "[campaign]\n[exhaustive]\ninputs = [\"I 0.0..I 0.5\"]\n[[never]]\nname = \"on\"\nexpr = \"Q0.0\"\n";
    let folder = Folder::with(&[("main.awl", program), ("c.toml", spec)]);
    let shrunk = folder.run(&["campaign", "shrink", "c.toml", "63"]).code(0).stdout;
    assert!(shrunk.contains("set I 0.0=1 I 0.1=0 I 0.2=0 I 0.3=1 I 0.4=0 I 0.5=0\n"), "{shrunk}");
    folder.run(&["campaign", "shrink", "c.toml", "1"]).code(2).stderr("scenario 1 does not fail");
    folder.run(&["campaign", "shrink", "c.toml", "64"]).code(2);
}
