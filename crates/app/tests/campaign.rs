//! `sieben campaign`: what comes of very many scenarios, and that nothing but program, file, seed and number decides it.

mod command;

use command::Folder;
use serde_json::Value as Json;

/// A motor with two directions; both contactors together are a short circuit. `interlock` is the condition that keeps them apart.
fn motor(interlock: &str) -> String {
    format!(
        "ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 0.0;\n A I 0.2;\n{interlock} = Q 0.0;\n A I 0.1;\n A I 0.2;\n AN I 0.0;\n = Q 0.1;\nEND_ORGANIZATION_BLOCK\n"
    )
}

const INTERLOCK: &str = "[campaign]\nname = \"interlock\"\n[exhaustive]\ninputs = [\"I 0.0..I 0.7\"]\n\
                         [[never]]\nname = \"short circuit\"\nexpr = \"Q0.0 AND Q0.1\"\n[[sometimes]]\nname = \"it runs\"\nexpr = \"Q0.0\"\n";

/// Counts and draws: values of several kinds, a walk, a response.
const COUNTING: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 10;\n L MW 12;\n +I;\n T MW 10;\n L MW 10;\n L MW 14;\n >I;\n = Q 4.0;\n A I 0.0;\n = Q 4.1;\n\
                        END_ORGANIZATION_BLOCK\n";
const DRAWN: &str = "[campaign]\nname = \"counting\"\nfor = \"1s\"\nseed = 3\nsamples = 50\n[sweep]\n\"MW 12\" = { values = [1, 2, 5] }\n\
                     [draw]\n\"MW 14\" = { uniform = [50, 600] }\n\"I 0.0\" = { walk = { every = \"50ms\", chance = 0.3 } }\n\
                     [[never]]\nname = \"over\"\nexpr = \"Q4.0\"\n[[measure]]\nname = \"sum\"\nof = \"last\"\nexpr = \"WORD_TO_INT(MW10)\"\n\
                     [[measure]]\nname = \"rises\"\nof = \"rises\"\nexpr = \"I0.0\"\n";

/// The result without what time it took.
fn timeless(mut result: Json) -> Json {
    result["seconds"] = Json::Null;
    result
}

#[test]
fn every_combination_is_tried_and_the_first_that_breaks_is_told() {
    let sound = Folder::with(&[("main.awl", &motor(" AN I 0.1;\n")), ("c.toml", INTERLOCK)]);
    let result = sound.run(&["campaign", "run", "c.toml", "--json", "--quiet"]).code(0).json();
    assert_eq!((&result["scenarios"], &result["pass"], &result["first_failure"]), (&256.into(), &256.into(), &Json::Null));
    assert_eq!(result["properties"][1]["came"], 64 / 2, "forward and the enabling bit, without the other direction");

    let unsound = Folder::with(&[("main.awl", &motor("").replace(" AN I 0.0;\n", "")), ("c.toml", INTERLOCK)]);
    let run = unsound.run(&["campaign", "run", "c.toml"]).code(1);
    assert!(run.stdout.contains("broken in 32 scenarios, first in 7"), "{}", run.stdout);
    assert!(run.stdout.contains("inputs that are 1: I 0.0, I 0.1, I 0.2"), "{}", run.stdout);
    // The scenario that it names breaks by itself.
    let shown = unsound.run(&["campaign", "show", "c.toml", "7"]).code(0).stdout;
    unsound.write("seven.scenario", shown.as_bytes());
    let test = unsound.run(&["test", "main.awl", "--tests", "seven.scenario"]).code(1);
    assert!(test.stdout.contains("\"short circuit\": `Q0.0 AND Q0.1` must never be true, and is after scan 0 at 0 ms"), "{}", test.stdout);
    unsound.write("main.awl", motor(" AN I 0.1;\n").as_bytes());
    unsound.run(&["test", "main.awl", "--tests", "seven.scenario"]).code(0);
}

#[test]
fn threads_ranges_and_engines_decide_nothing() {
    let folder = Folder::with(&[("main.awl", COUNTING), ("c.toml", DRAWN)]);
    let of = |more: &[&str]| {
        let arguments: Vec<&str> = ["campaign", "run", "c.toml", "--json", "--quiet"].into_iter().chain(more.iter().copied()).collect();
        timeless(folder.run(&arguments).code(1).json())
    };
    let one = of(&["--workers", "1", "--engine", "interpreter"]);
    assert_eq!((&one["scenarios"], &one["run"]), (&150.into(), &150.into()));
    assert!(one["fail"].as_u64().is_some_and(|fail| fail > 20) && one["pass"].as_u64().is_some_and(|pass| pass > 20), "{one}");
    for more in [["--workers", "3"], ["--range", "7"], ["--engine", "jit"], ["--engine", "quick"]] {
        assert_eq!(of(&more), one, "{more:?}");
    }
    // Where the folder lies does not matter, the seed does.
    let elsewhere = Folder::with(&[("main.awl", COUNTING), ("c.toml", DRAWN)]);
    assert_eq!(timeless(elsewhere.run(&["campaign", "run", "c.toml", "--json", "--quiet"]).code(1).json()), one);
    let other = of(&["--seed", "4"]);
    assert_ne!((&other["result_hash"], &other["campaign"]), (&one["result_hash"], &one["campaign"]));
    assert_eq!(other["program"], one["program"]);
}

#[test]
fn parts_make_the_whole_and_the_first_failure_is_the_least() {
    let folder = Folder::with(&[("main.awl", COUNTING), ("c.toml", DRAWN)]);
    let count = |more: &[&str], code| {
        let arguments: Vec<&str> = ["campaign", "run", "c.toml", "--json", "--quiet"].into_iter().chain(more.iter().copied()).collect();
        folder.run(&arguments).code(code).json()
    };
    let whole = count(&[], 1);
    let parts = [count(&["--only", "0..99"], 1), count(&["--only", "100..149"], 1)];
    let sum = |key: &str| parts.iter().filter_map(|part| part[key].as_u64()).sum::<u64>();
    assert_eq!((sum("run"), sum("pass"), sum("fail")), (150, whole["pass"].as_u64().unwrap_or(0), whole["fail"].as_u64().unwrap_or(0)));
    let first = count(&["--stop-on", "first", "--workers", "3", "--range", "1"], 1);
    assert_eq!(first["first_failure"], whole["first_failure"]);
    assert_eq!((&first["fail"], first["run"].as_u64()), (&1.into(), first["first_failure"]["scenario"].as_u64().map(|number| number + 1)));
    let text = folder.run(&["campaign", "run", "c.toml", "--only", "150..150"]).code(2).stderr;
    assert!(text.contains("the campaign has 150 scenarios, 0 to 149"), "{text}");
    folder.run(&["campaign", "show", "c.toml", "150"]).code(2).stderr("there is no scenario 150: the campaign has 150 scenarios, 0 to 149");
    let used_up = count(&["--budget", "0"], 5);
    assert_eq!(used_up["run"], 0);
}

#[test]
fn every_kind_of_property_is_held_against_a_run() {
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 10;\n INC 1;\n T MW 10;\n L 5;\n ==I;\n S Q 4.0;\n L MW 10;\n L 8;\n ==I;\n R Q 4.0;\nEND_ORGANIZATION_BLOCK\n";
    let verdict = |properties: &str| {
        let spec = format!("[campaign]\nfor = \"100ms\"\n{properties}");
        let folder = Folder::with(&[("main.awl", program), ("c.toml", &spec)]);
        let run = folder.run(&["campaign", "run", "c.toml", "--json", "--quiet"]);
        let result = run.json();
        (run.code.unwrap_or(-1), result["first_failure"]["property"].clone(), result["first_failure"]["scan"].clone())
    };
    let passes = (0, Json::Null, Json::Null);
    // Q 4.0 is 1 after the scans 4, 5 and 6.
    assert_eq!(verdict("[[never]]\nexpr = \"Q4.0 AND WORD_TO_INT(MW10) > 7\"\n"), passes);
    assert_eq!(verdict("[[never]]\nname = \"on\"\nexpr = \"Q4.0\"\n"), (1, "on".into(), 4.into()));
    assert_eq!(verdict("[[always]]\nname = \"off\"\nexpr = \"NOT Q4.0\"\n"), (1, "off".into(), 4.into()));
    assert_eq!(verdict("[[sometimes]]\nexpr = \"Q4.0\"\n"), passes);
    assert_eq!(verdict("[[sometimes]]\nexpr = \"Q4.1\"\n").0, 1);
    assert_eq!(verdict("[[finally]]\nexpr = \"NOT Q4.0\"\n"), passes);
    assert_eq!(verdict("[[finally]]\nname = \"end\"\nexpr = \"Q4.0\"\n"), (1, "end".into(), 9.into()));
    let response = |within: &str| format!("[[response]]\nname = \"r\"\nwhen = \"Q4.0\"\nthen = \"NOT Q4.0\"\nwithin = \"{within}\"\n");
    assert_eq!(verdict(&response("40ms")), passes);
    assert_eq!(verdict(&response("20ms")), (1, "r".into(), 6.into()));
}

#[test]
fn a_scenario_has_properties_of_its_own() {
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 10;\n INC 1;\n T MW 10;\n L 5;\n ==I;\n = Q 4.0;\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("main.awl", program)]);
    let run = |property: &str| {
        folder.write("p.scenario", format!("property {property}\nscan 10\n").as_bytes());
        let run = folder.run(&["test", "main.awl", "--tests", "p.scenario"]);
        (run.code.unwrap_or(-1), run.stdout)
    };
    for (property, code, part) in [
        ("never \"a\" Q4.1", 0, "ok"),
        ("never \"a\" Q4.0", 1, "p.scenario:1: \"a\": `Q4.0` must never be true, and is after scan 4 at 40 ms"),
        ("always \"a\" NOT Q4.0", 1, "must always be true, and is not after scan 4"),
        ("finally \"a\" Q4.0", 1, "must be true at the end, and is not after scan 9 at 90 ms"),
        ("response \"a\" within 10ms Q4.0 -> NOT Q4.0", 0, "ok"),
        ("response \"a\" Q4.0 -> NOT Q4.0", 1, "must be answered in time, and was not after scan 4"),
        ("never \"a\" Lamp", 2, "p.scenario:1: `Lamp` is not declared"),
        ("never \"a\"", 2, "is not understood; write `property never"),
        ("sometimes \"a\" Q4.0", 2, "is not understood"),
        ("response \"a\" Q4.0", 2, "is not understood"),
    ] {
        let (found, stdout) = run(property);
        assert!(found == code && stdout.contains(part), "{property}: {found}\n{stdout}");
    }
    folder.write("t.scenario", b"property never \"a\" Q4.0\ntable I 0.0 -> Q 4.0\n0 0\n");
    folder.run(&["test", "main.awl", "--tests", "t.scenario"]).code(2).stdout("runs of their own");
    // Both engines see the same.
    run("never \"a\" Q4.0");
    for engine in ["interpreter", "jit"] {
        let test = folder.run(&["test", "main.awl", "--tests", "p.scenario", "--engine", engine]).code(1);
        assert!(test.stdout.contains("after scan 4"), "{}", test.stdout);
    }
}

#[test]
fn programs_are_compared_scan_by_scan() {
    let slower = COUNTING.replace("L MW 10;\n L MW 14;\n >I;", "L MW 10;\n L MW 14;\n >=I;");
    let spec = "[campaign]\nfor = \"1s\"\nsamples = 20\n[matrix]\nprogram = [\"old\", \"new\"]\n[draw]\n\"MW 14\" = { uniform = [5, 50] }\n\"MW 12\" = { choice = [1] }\n\
                [[same]]\nname = \"lamp\"\nexpr = \"Q4.0\"\n[[same]]\nname = \"sum\"\nexpr = \"WORD_TO_INT(MW10)\"\n";
    let folder = Folder::with(&[("old/main.awl", COUNTING), ("new/main.awl", &slower), ("c.toml", spec)]);
    let result = folder.run(&["campaign", "run", "c.toml", "--json", "--quiet"]).code(1).json();
    assert_eq!((&result["fail"], &result["first_failure"]["property"]), (&20.into(), &"lamp".into()));
    assert_eq!(result["first_failure"]["message"], "in `new`");
    folder.write("new/main.awl", COUNTING.as_bytes());
    folder.run(&["campaign", "run", "c.toml"]).code(0);
}

#[test]
fn a_recording_is_replayed_with_its_inputs_disturbed() {
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 0.0;\n FP M 0.0;\n JCN end;\n L MW 10;\n INC 1;\n T MW 10;\nend: NOP 0;\n L MW 10;\n T QW 4;\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("main.awl", program)]);
    let times = ["--at", "100ms", "I 0.0=1", "--at", "200ms", "I 0.0=0", "--at", "300ms", "I 0.0=1"];
    let record: Vec<&str> = ["record", "main.awl", "--for", "1s", "-o", "plant.scenario"].into_iter().chain(times).collect();
    folder.run(&record).code(0);
    let spec = |more: &str| {
        format!("[campaign]\nprogram = \"main.awl\"\nreplay = \"plant.scenario\"\nwithin = \"20ms\"\nsamples = 100\nseed = 1\n{more}")
    };
    folder.write("c.toml", spec("[disturb]\ntime = { uniform = [\"-15ms\", \"15ms\"] }\n").as_bytes());
    folder.run(&["campaign", "run", "c.toml"]).code(0);
    folder.write("c.toml", spec("[disturb]\nbounce = { chance = 0.2, for = \"30ms\" }\n").as_bytes());
    let result = folder.run(&["campaign", "run", "c.toml", "--json", "--quiet"]).code(1).json();
    assert!(result["first_failure"]["message"].as_str().is_some_and(|message| message.contains("should be")), "{result}");
    let number = result["first_failure"]["scenario"].to_string();
    folder.run(&["campaign", "show", "c.toml", &number, "-o", "found.scenario"]).code(0);
    let found = folder.run(&["test", "main.awl", "--tests", "found.scenario", "--within", "20ms"]).code(1);
    assert!(found.stdout.contains("was changed last by main.awl:"), "{}", found.stdout);
}

#[test]
fn plants_have_their_parameters_and_faults() {
    let project = "[project]\nname = \"oven\"\n[[module]]\nkind = \"thermal\"\nname = \"oven\"\n";
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\n SET;\n = Q 2.0;\n L IW 0;\n T MW 10;\nEND_ORGANIZATION_BLOCK\n";
    let spec = "[campaign]\nfor = \"60s\"\nsamples = 10\n[set]\n\"oven.limit\" = 1500\n\"oven.noise\" = 0\n[sweep]\n\"oven.gain\" = { values = [100, 400] }\n\
                [[fault]]\nchance = 0.5\nsignal = \"oven.temperature\"\nfault = \"stuck=-50\"\nfrom = \"10s\"\nfor = \"5s\"\n\
                [[measure]]\nname = \"hot\"\nof = \"max\"\nexpr = \"WORD_TO_INT(MW10)\"\n[[measure]]\nname = \"cold\"\nof = \"min\"\nexpr = \"WORD_TO_INT(MW10)\"\n";
    let folder = Folder::with(&[("sieben.toml", project), ("main.awl", program), ("c.toml", spec)]);
    let result = folder.run(&["campaign", "run", "c.toml", "--json", "--quiet"]).code(0).json();
    let (hot, cold) = (&result["measures"][0], &result["measures"][1]);
    assert!(
        hot["max_scenario"].as_u64() >= Some(10) && hot["max"].as_f64() > Some(2_000.0) && hot["min"].as_f64() < Some(1_000.0),
        "{hot}"
    );
    assert_eq!(cold["min"], -500.0);
    let shown = folder.run(&["campaign", "show", "c.toml", "10"]).code(0).stdout;
    assert!(shown.contains("plant oven limit=1500 noise=0 gain=400 seed="), "{shown}");
    folder.write("ten.scenario", format!("{shown}expect MW 10=16#7FFF\n").as_bytes());
    folder.run(&["test", "--tests", "ten.scenario"]).code(1);
    folder.write("none.scenario", b"plant furnace gain=5\nscan\nexpect MW 10=0\n");
    let none = folder.run(&["test", "--tests", "none.scenario"]).code(2);
    assert!(none.stdout.contains("the project has no plant `furnace`; it has `oven`"), "{}", none.stdout);
}

#[test]
fn the_margin_is_the_least_distance_to_a_break() {
    // Each scenario counts up by its own step for ten scans.
    let spec =
        "[campaign]\nname = \"margin\"\nfor = \"100ms\"\n[sweep]\n\"MW 12\" = { values = [1, 5, 12] }\n\"MW 14\" = { values = [1000] }\n";
    let never = |expression: &str| format!("[[never]]\nname = \"{expression}\"\nexpr = '{expression}'\n");
    let margin = |properties: &str, code| {
        let folder = Folder::with(&[("main.awl", COUNTING), ("c.toml", &format!("{spec}{properties}"))]);
        let result = folder.run(&["campaign", "run", "c.toml", "--json", "--quiet"]).code(code).json();
        (result["margin"].as_f64(), result["margin_scenario"].as_u64())
    };
    let high = never("WORD_TO_INT(MW10) > 130");
    assert_eq!(margin(&high, 0), (Some(10.0), Some(2)));
    // What has no numbers, such as a time or a bit, takes nothing away from what has; a break is below 0.
    let others = format!("{}{}", never("I0.0 = Q4.0 AND I0.0"), never("T#1s > T#2s AND Q4.1"));
    assert_eq!(margin(&others, 0), (None, None));
    assert_eq!(margin(&format!("{others}{high}"), 0), (Some(10.0), Some(2)));
    assert_eq!(margin(&never("WORD_TO_INT(MW10) > 110 OR Q4.0"), 1), (Some(-10.0), Some(2)));
    assert_eq!(margin(&never("Q4.0 AND WORD_TO_INT(MW10) > 110"), 0), (None, None), "as long as the bit is 0 it is infinitely far");
    assert_eq!(margin("[[always]]\nname = \"a\"\nexpr = \"NOT (WORD_TO_INT(MW10) = 52)\"\n", 0), (Some(2.0), Some(1)));
    assert_eq!(margin("[[finally]]\nname = \"f\"\nexpr = \"WORD_TO_INT(MW10) > 0\"\n", 0), (None, None));
}

#[test]
fn a_stop_is_a_verdict() {
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 0.0;\n JCN end;\n CALL SFC 46;\nend: NOP 0;\nEND_ORGANIZATION_BLOCK\n";
    let spec = "[exhaustive]\ninputs = [\"I 0.0\"]\n[[never]]\nname = \"lamp\"\nexpr = \"Q4.0\"\n";
    let folder = Folder::with(&[("main.awl", program), ("c.toml", spec)]);
    let result = folder.run(&["campaign", "run", "c.toml", "--json", "--quiet"]).code(1).json();
    assert_eq!((&result["pass"], &result["stop"], &result["first_failure"]["verdict"]), (&1.into(), &1.into(), &"stop".into()));
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let with = |spec: &str| {
        let folder = Folder::with(&[("main.awl", COUNTING), ("c.toml", spec)]);
        let run = folder.run(&["campaign", "run", "c.toml"]);
        (run.code.unwrap_or(-1), run.stderr)
    };
    const NEVER: &str = "[[never]]\nexpr = \"Q4.0\"\n";
    for (spec, exit, part, place) in [
        ("[[never]]\nexpr = \"Q4.0 AND Lamp\"\n".to_owned(), 3, "`Lamp` is not declared", "c.toml:2:18"),
        ("[[never]]\nexpr = \"WORD_TO_INT(MW10)\"\n".to_owned(), 3, "BOOL is wanted here", "c.toml:2:9"),
        ("[[never]]\nexpr = \"Q4.0 AND\"\n".to_owned(), 3, "expression", "c.toml:2:"),
        ("[[never]]\nexpr = \"Q4.0; M0.0\"\n".to_owned(), 3, "without `;`", "c.toml:2:9"),
        ("[[measure]]\nof = \"max\"\nexpr = \"Q4.0\"\n".to_owned(), 3, "REAL is wanted here", "c.toml:3:9"),
        (format!("[set]\n\"Lamp\" = 1\n{NEVER}"), 3, "nothing is called `Lamp`", "c.toml:2:2"),
        (format!("[set]\n\"ACCU1\" = 1\n{NEVER}"), 3, "is a register", "c.toml:2:2"),
        (format!("[set]\n\"MW 10\" = 99999\n{NEVER}"), 3, "99999", "c.toml:2:2"),
        (format!("[sweep]\n\"MW 10\" = {{ values = [1.5] }}\n{NEVER}"), 3, "1.5", "c.toml:2:2"),
        (format!("[draw]\n\"Q 4.0\" = {{ uniform = [0, 1] }}\n{NEVER}"), 3, "a bit is drawn by", "c.toml:2:2"),
        (format!("[draw]\n\"MW 10\" = {{ walk = {{ every = \"1s\", chance = 0.5 }} }}\n{NEVER}"), 3, "needs a `step`", "c.toml:2:2"),
        (format!("[draw]\n\"tank.level\" = {{ uniform = [0, 1] }}\n{NEVER}"), 3, "nothing is called `tank.level`", "c.toml:2:2"),
        (format!("[[fault]]\nsignal = \"tank.level\"\nfault = \"stuck\"\n{NEVER}"), 3, "there is no plant `tank`", "c.toml:2:11"),
        (format!("[exhaustive]\ninputs = [\"MW 10\"]\n{NEVER}"), 3, "is no bit", "c.toml:2:12"),
        (format!("[exhaustive]\ninputs = [\"I 0.0..I 9.0\"]\n{NEVER}"), 3, "is no range", "c.toml:2:12"),
        (format!("[exhaustive]\ninputs = [\"I 0.0..I 5.0\"]\n{NEVER}"), 3, "41 bits have 2^41 combinations", "c.toml:2:12"),
        (format!("[exhaustive]\nblock = \"FB 1\"\ninputs = [\"I 0.0\"]\n{NEVER}"), 3, "is not there yet", "c.toml:2:10"),
        (format!("[campaign]\nprogram = \"nowhere\"\n{NEVER}"), 2, "nowhere", ""),
        (format!("[campaign]\nreplay = \"nowhere.scenario\"\n{NEVER}"), 2, "nowhere.scenario", ""),
        (format!("[campaign]\nreplay = \"main.awl\"\n{NEVER}"), 3, "line 1", "c.toml:2:11"),
    ] {
        let (code, stderr) = with(&spec);
        assert_eq!(code, exit, "{spec}\n{stderr}");
        assert!(stderr.contains(part) && stderr.contains(place), "{spec}\n{stderr}");
    }
    let (code, stderr) = with("[[never]]\nexpr = \"FALSE\"\n");
    assert!(code == 0 && stderr.contains("P7164") && stderr.contains("names nothing"), "{stderr}");
    let broken = Folder::with(&[("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\n A Lamp;\nEND_ORGANIZATION_BLOCK\n"), ("c.toml", NEVER)]);
    let run = broken.run(&["campaign", "run", "c.toml"]).code(3);
    assert!(run.stderr.contains("main.awl:3"), "{}", run.stderr);
}
