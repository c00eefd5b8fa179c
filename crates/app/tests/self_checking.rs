//! `sieben test`: programs that check themselves, as their users write them.

mod command;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use command::{Folder, Run};

const PASSES: &str = "L 5\nT MW 0\n__ASSERT== MW 0, 5\nCALL SFC 46\n";
const FAILS: &str = "L 5\nT MW 0\n__ASSERT== MW 0, 7\nCALL SFC 46\n";

#[test]
fn a_false_assertion_shows_place_statement_and_both_values() {
    let folder = Folder::with(&[("fails.awl", FAILS), ("passes.awl", PASSES)]);
    folder.run(&["test", "passes.awl"]).code(0).stdout("ok    passes.awl  (1 scan").stdout("1 passed, 0 failed");
    folder
        .run(&["test"])
        .code(1)
        .stdout("FAIL  fails.awl:3: expected 5 (16#0005) == 7 (16#0007)\n        __ASSERT== MW 0, 7  // OB 1, statement 3\n")
        .stdout("1 passed, 1 failed\n");
    let json = folder.run(&["test", "--json", "fails.awl"]).code(1).json();
    let test = &json["tests"][0];
    let seen =
        ["name", "verdict", "file", "statement", "block", "left", "right"].map(|key| test[key].as_str().unwrap_or_default().to_owned());
    assert_eq!(seen, ["fails.awl", "failed", "fails.awl", "__ASSERT== MW 0, 7", "OB 1, statement 3", "5 (16#0005)", "7 (16#0007)"]);
    assert_eq!((test["line"].as_u64(), json["passed"].as_u64(), json["failed"].as_u64()), (Some(3), Some(0), Some(1)));
    folder.run(&["exec", "fails.awl", "--extended"]).code(4).stderr("an assertion is false: expected 5 (16#0005) == 7 (16#0007)");
}

#[test]
fn a_project_below_the_folder_is_tested_as_a_project() {
    let folder = Folder::with(&[
        ("alone.awl", PASSES),
        ("pump/sieben.toml", "[project]\nsources = [\"src/*.awl\"]\nsymbols = [\"symbols.csv\"]\ntests = [\"checks/*.awl\"]\n"),
        ("pump/symbols.csv", "symbol,address,type,comment\nLevel,MW 0,INT,\n"),
        ("pump/src/main.awl", "FUNCTION FC 1 : VOID\nBEGIN\nL 5\nT \"Level\"\nEND_FUNCTION\n"),
        ("pump/checks/level.awl", "UC FC 1\n__ASSERT== \"Level\", 5\nCALL SFC 46\n"),
    ]);
    folder.run(&["test"]).code(0).stdout("ok    alone.awl").stdout("level.awl").stdout("2 passed, 0 failed");
    let whole = Folder::with(&[("sieben.toml", "[project]\nname = \"whole\"\n"), ("main.awl", PASSES)]);
    whole.run(&["test"]).code(0).stdout("ok    whole  (1 scan");
}

#[test]
fn a_test_that_does_not_end_fails_with_the_limit() {
    let folder = Folder::with(&[
        ("never.awl", "L 1\n"),
        ("loop.awl", "m: JU m\n"),
        ("slow.awl", "A T 1\nSET\nL S5T#9S\nSE T 1\nAN T 1\nJC e\nBE\ne: CALL SFC 46\n"),
    ]);
    folder
        .run(&["test", "never.awl", "--scans", "7"])
        .code(1)
        .stdout("did not end within 7 scans; a program that checks itself ends with `CALL SFC 46`");
    folder.run(&["test", "never.awl", "--limit", "100ms"]).code(1).stdout("did not end within 100 ms of virtual time");
    folder.run(&["test", "loop.awl"]).code(1).stdout("FAIL  loop.awl:1: the CPU went to STOP: cycle time exceeded");
    folder.run(&["test", "slow.awl", "--limit", "8s"]).code(1).stdout("did not end");
}

#[test]
fn exit_codes_are_those_of_the_worst_test() {
    let folder = Folder::with(&[("passes.awl", PASSES), ("fails.awl", FAILS), ("broken.awl", "FOO\n")]);
    folder.run(&["test", "passes.awl", "fails.awl"]).code(1);
    folder.run(&["test", "passes.awl", "fails.awl", "broken.awl"]).code(3).stdout("FAIL  broken.awl: does not compile").stdout("P2001");
    folder.run(&["test", "nowhere.awl"]).code(2).stderr("P6001");
    folder.run(&["test", "--filter", "nothing"]).code(2).stderr("P7020");
    folder.run(&["test", "--filter", "passes"]).code(0);
    folder.run(&["test", "--engine", "interpreter", "--jobs", "1", "--filter", "passes"]).code(0);
    Folder::new().run(&["test"]).code(2).stderr("P7020");
}

#[test]
fn build_servers_read_the_results() {
    let folder = Folder::with(&[("passes.awl", PASSES), ("fails.awl", FAILS)]);
    let tap = folder.run(&["test", "--tap", "--junit", "result.xml"]).code(1);
    assert!(
        tap.stdout.starts_with("TAP version 14\n1..2\nnot ok 1 - fails.awl\n  ---\n  message: \"fails.awl:3: expected"),
        "{}",
        tap.stdout
    );
    assert!(tap.stdout.ends_with("ok 2 - passes.awl\n"), "{}", tap.stdout);
    // A file that cannot be written costs the exit code, not the results.
    folder.run(&["test", "--junit", "."]).code(2).stdout("1 passed, 1 failed").stderr("P6013");
    let xml = String::from_utf8(folder.read("result.xml")).expect("UTF-8");
    assert!(xml.contains("<testsuite name=\"sieben\" tests=\"2\" failures=\"1\" errors=\"0\""), "{xml}");
    assert!(xml.contains("<testcase name=\"passes.awl\" classname=\"sieben\""), "{xml}");
    assert!(xml.contains("<failure message=\"fails.awl:3: expected 5 (16#0005) == 7 (16#0007)\">__ASSERT== MW 0, 7"), "{xml}");
}

#[test]
fn tests_of_a_project_replace_its_main_program() {
    let main = "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1\nCALL FC 1\nEND_ORGANIZATION_BLOCK\n\
                FUNCTION FC 1 : VOID\nBEGIN\nL \"Count\"\nINC 1\nT \"Count\"\nEND_FUNCTION\n";
    let test = |wanted| format!("CALL FC 1\n__ASSERT== \"Count\", {wanted}\nCALL SFC 46\n");
    let folder = Folder::with(&[
        ("plant/sieben.toml", "[project]\ntests = [\"checks/*.awl\"]\n"),
        ("plant/src/main.awl", main),
        ("plant/symbols.csv", "symbol,address\nCount,MW 0\n"),
        ("plant/checks/right.awl", &test(1)),
        ("plant/checks/wrong.awl", &test(2)),
    ]);
    folder.run(&["check", "plant"]).code(0).stdout("2 blocks in 1 source");
    folder
        .run(&["test", "plant"])
        .code(1)
        .stdout("ok    plant/checks/right.awl")
        .stdout("FAIL  plant/checks/wrong.awl:2: expected 1 (16#0001) == 2 (16#0002)");
    folder.run(&["test", "plant/src/main.awl", "plant/symbols.csv", "--tests", "plant/checks/right.awl"]).code(0);
}

#[test]
fn a_test_runs_on_the_cpu_of_its_project() {
    // 300 ms are three calls of OB 35 as it comes, and six with the interval of the project.
    let main = "ORGANIZATION_BLOCK OB 35\nBEGIN\nL MW 2\nINC 1\nT MW 2\nEND_ORGANIZATION_BLOCK\n\
                ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 0\n+ 1\nT MW 0\nL 31\n<I\nBEC\n__ASSERT> MW 2, 4\nCALL SFC 46\nEND_ORGANIZATION_BLOCK\n";
    for (settings, code) in [("[cyclic.35]\ninterval = \"50ms\"\n", 0), ("", 1)] {
        let folder = Folder::with(&[("plant/sieben.toml", settings), ("plant/src/main.awl", main)]);
        folder.run(&["test", "plant"]).code(code);
    }
}

#[test]
fn extension_words_are_explained() {
    let folder = Folder::new();
    folder.run(&["explain", "__ASSERT=="]).code(0).stdout("__ASSERT==, an extension word of awlsim").stdout("two operands");
    folder.run(&["explain", "__sleep"]).code(0).stdout("milliseconds");
    folder.run(&["explain", "__NEVER"]).code(2);
}

#[test]
fn extension_words_have_to_be_allowed() {
    let folder = Folder::with(&[("passes.awl", PASSES), ("on/sieben.toml", "[project]\nextended = true\n"), ("on/main.awl", PASSES)]);
    let json = folder.run(&["check", "--json", "passes.awl"]).code(3).json();
    assert_eq!((json.as_array().map(Vec::len), json[0]["code"].as_str()), (Some(1), Some("P2040")), "{json}");
    folder.run(&["check", "--extended", "passes.awl"]).code(0);
    folder.run(&["check", "on"]).code(0);
    folder.write("bad.toml", b"");
    folder.write("on/sieben.toml", b"[project]\nextended = 1\n");
    folder.run(&["check", "on"]).code(3).stderr("P6009");
    let negative = "CALL SFC -1\nL __ACCU 1\nUC SFC -1\n";
    let folder = Folder::with(&[("main.awl", negative)]);
    folder.run(&["check", "main.awl"]).code(3).stderr("`SFC -1` is an extension word");
}

#[test]
fn wrong_operands_of_extension_words_are_explained() {
    for (source, expected) in [
        ("__ASSERT== 1", "`__ASSERT==` takes two operands with a comma between them"),
        ("__ASSERT== 1, 2, 3", "takes two operands"),
        ("__ASSERT==", "takes two operands"),
        ("__STWRST 1", "`__STWRST` takes no operand"),
        ("__SLEEP", "`__SLEEP` takes a number of milliseconds"),
        ("__FEATURE 9", "the properties are 0"),
        ("__FEATURE 0, 3", "`3` is no value of this property; it is 2 or 4"),
        ("__ASSERT== __ACCU 5, 1", "`__ACCU` takes a number from 1 to 4"),
        ("__ASSERT== __STW XYZ, 1", "`__STW` takes the name of a status bit"),
        ("__ASSERT== DB 1, 1", "`DB 1` has no value to compare"),
        ("__ASSERT== PQW 0, 1", "`PQW 0` has no value to compare"),
        ("T __ACCU 1", "does not take `__ACCU 1`"),
        ("CALL SFC -9", "`SFC -9` does not exist"),
        ("__NEVER 1", "`__NEVER` is no instruction"),
    ] {
        let folder = Folder::with(&[("main.awl", &format!("{source}\n"))]);
        folder.run(&["check", "--extended", "main.awl"]).code(3).stderr(expected);
    }
}

/// Where the programs of the corpus lie.
fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/awlsim/programs")
}

#[test]
fn the_corpus_passes() {
    let run = Run::of(&corpus(), &["test", "--json"]).code(0);
    let json = run.json();
    let tests = json["tests"].as_array().map_or(&[][..], Vec::as_slice);
    assert!(tests.len() >= 25, "{} programs", tests.len());
    assert!(tests.iter().all(|test| test["verdict"] == "passed"), "{json:#}");
}

#[test]
fn the_corpus_is_written_as_its_users_write() {
    let mut latin = 0;
    let mut words = BTreeSet::new();
    for entry in fs::read_dir(corpus()).expect("the corpus lies in spec/") {
        let path = entry.expect("a file").path();
        if path.extension().is_none_or(|ending| ending != "awl") {
            continue;
        }
        let bytes = fs::read(&path).expect("a source");
        let name = path.display();
        assert!(bytes.windows(2).any(|pair| pair == b"\r\n"), "{name} has no CRLF");
        assert_eq!(bytes.iter().filter(|&&byte| byte == b'\n').count(), bytes.iter().filter(|&&byte| byte == b'\r').count(), "{name}");
        latin += usize::from(std::str::from_utf8(&bytes).is_err());
        let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
        // A program in which every assertion were gone would pass, too.
        assert!(text.matches("__ASSERT").count() >= 3, "{name} asserts nothing");
        assert!(text.contains("SFC 46") || text.contains("SFC46"), "{name} has no end");
        words.extend(text.lines().filter_map(|line| {
            let line = line.rsplit_once(": ").map_or(line, |(_, rest)| rest);
            line.split(['\t', ' ', ';']).find(|word| !word.is_empty()).map(str::to_owned)
        }));
    }
    assert!(latin >= 10, "{latin} sources in Latin-1");
    // One instruction of every chapter, and those that only German sources have.
    let chapters = [
        "U",
        "UN",
        "O",
        "X",
        "U(",
        ")",
        "=",
        "S",
        "FP",
        "FN",
        "SAVE",
        "L",
        "T",
        "LC",
        "LAR1",
        "TAR1",
        "TAK",
        "PUSH",
        "ENT",
        "INC",
        "+I",
        "*D",
        "/R",
        "MOD",
        "SQRT",
        "BTI",
        "RND",
        "SSI",
        "RLDA",
        "UW",
        "XOD",
        "==I",
        "<>D",
        ">R",
        "SPA",
        "SPB",
        "SPL",
        "LOOP",
        "CALL",
        "UC",
        "CC",
        "BEB",
        "BEA",
        "SI",
        "SV",
        "SE",
        "SS",
        "SA",
        "ZV",
        "ZR",
        "AUF",
        "TDB",
        "MCR(",
        ")MCR",
        "MCRA",
        "NOP",
        "BLD",
        "__STWRST",
        "__SLEEP",
        "__FEATURE",
    ];
    let missing: Vec<&str> = chapters.into_iter().filter(|&word| !words.contains(word)).collect();
    assert!(missing.is_empty(), "no program has {}", missing.join(", "));
}

#[test]
fn the_profile_of_awlsim_has_its_rules_and_no_other_has() {
    let stw = "SET\nSAVE\nSET\nA M 0.0\nL STW\nT MW 0\n";
    // The difference of these two is denormal.
    let tiny = "L 1.5e-38\nL 1.6e-38\n==R\n= M 10.0\nL __CNST_PINF\nL __CNST_PINF\n==R\n= M 10.1\nL 2.0\nL 1.0\n>R\n= M 10.2\n";
    let numbers = "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 60000\nEND_ORGANIZATION_BLOCK\nFUNCTION FC 60000 : VOID\nBEGIN\nEND_FUNCTION\n";
    let folder = Folder::with(&[("stw.awl", stw), ("tiny.awl", tiny), ("numbers.awl", numbers)]);
    for (profile, word, bits, code) in [("siemens", "16#0100", "16#06", 3), ("awlsim", "16#0101", "16#05", 0)] {
        folder.run(&["exec", "stw.awl", "--show", "MW0", "--profile", profile]).code(0).stdout(&format!("MW0 = {word}\n"));
        folder.run(&["exec", "tiny.awl", "--extended", "--show", "MB10", "--profile", profile]).code(0).stdout(&format!("MB10 = {bits}\n"));
        folder.run(&["check", "numbers.awl", "--profile", profile]).code(code);
    }
    folder.write("sieben.toml", b"[project]\nprofile = \"awlsim\"\nsources = \"numbers.awl\"\n");
    folder.run(&["check", "."]).code(0);
    folder.write("sieben.toml", b"[project]\nprofile = \"other\"\nsources = \"numbers.awl\"\n");
    folder.run(&["check", "."]).code(3).stderr("`other` is no profile: write `siemens` or `awlsim`");
    folder.run(&["check", "stw.awl", "--profile", "other"]).code(2);
}

#[test]
fn the_page_on_awlsim_names_every_difference() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/how-to/from-awlsim.md");
    let page = fs::read_to_string(path).expect("the page is there");
    for difference in sieben_model::profile::DIFFERENCES {
        let row = format!("| {} | {} | {} |", difference.name, difference.theirs, difference.ours);
        assert!(page.contains(&row), "docs/how-to/from-awlsim.md lacks\n{row}");
    }
}
