//! What a course says, as the command line takes it: its words, its assignment table, and the JSON of what is wrong.

mod command;

use command::{Folder, sieben};
use serde_json::Value;
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::operands::OperandClass;
use sieben_model::problems::Problem;

#[test]
fn words_of_a_course_are_explained() {
    let folder = Folder::new();
    for (word, expected) in [
        ("NOP 0", "Does nothing"),
        ("NOP0", "Does nothing"),
        ("NOP1", "Does nothing"),
        ("NOP", "Does nothing"),
        ("ACCU1", "ACCU 1"),
        ("ACCU 1", "ACCU 1"),
        ("AR1", "address registers"),
        ("DBNO", "number of the open data block"),
        ("DBLG", "length of the open data block"),
        ("DB", "a data block"),
        ("DI", "instance data block"),
        ("MCR", "master control relay"),
        ("POINTER", "6 bytes"),
        ("ANY", "10 bytes"),
        ("EN", "enable input"),
        ("S5T#", "S5 timer"),
        ("P#", "pointer constant"),
        ("LAD", "ladder diagram"),
        ("FBD", "function block diagram"),
        ("STW", "status word"),
        ("RET", "BEC"),
        ("CMP >I", "L a; L b; >I"),
        ("cmp <=r", "if a <= b"),
        ("CMP", "drawn as a contact"),
        ("R-TEXT", "comments between the statements"),
        ("СС0", "CC0, a bit of the status word"),
    ] {
        folder.run(&["explain", word]).code(0).stdout(expected);
    }
    let both = folder.run(&["explain", "OR"]).code(0).stdout;
    assert!(both.contains("a bit of the status word") && both.contains("XOR"), "{both}");
    folder.run(&["explain", "JBNI"]).code(2).stderr("id you mean `JNBI`?");
}

#[test]
fn the_tables_of_all_instructions_have_all_rows() {
    let folder = Folder::new();
    let status = folder.run(&["explain", "status"]).code(0).stdout;
    assert_eq!(status.lines().filter(|line| !line.is_empty()).count(), Instruction::ALL.len() + 2);
    let jumps = folder.run(&["explain", "jumps"]).code(0).stdout;
    let rows = Instruction::ALL.iter().filter(|row| row.operand() == OperandClass::Label);
    assert_eq!(jumps.lines().count(), rows.clone().count() + 1);
    for row in rows {
        assert!(jumps.contains(row.doc()) && jumps.contains(row.german()), "{}", row.name());
    }
}

/// The table of the dosing exercise, with a header of its own and without one.
const ROWS: &str =
    "1\tI 0.0\t–\tSTART\tpush button\tmakes\n2\tI 0.7\tpulse/l\tFLOW\tmeter\t–\n3\tQW 4\tl\t–\tdisplay\tBCD\n4\tC 0\tl\t–\tremaining\t\n";

#[test]
fn the_assignment_table_of_a_course_is_a_symbol_table() {
    let headers = [
        "Št.\tNaslov\tEnota\tTeh nol. oznaka\tOpis\tOpomba",
        "Nr.\tAdresse\tEinheit\tTechnologische Bezeichnung\tBeschreibung\tBemerkung",
        "No.\tAddress\tUnit\tTechnological name\tDescription\tRemark",
        "№\tАдрес\tЕдиница\tОбозначение\tОписание\tПримечание",
        "Jrk\tAadress\tÜhik\tTähis\tKirjeldus\tMärkus",
        "N°\tAdresse\tUnité\tRepère\tDescription\tRemarque",
        "Núm.\tDirección\tUnidad\tDesignación\tDescripción\tObservaciones",
        "N.\tIndirizzo\tUnità\tSigla\tDescrizione\tNota",
    ];
    for header in headers {
        for delimiter in ["\t", ";", ","] {
            let table = format!("{header}\n{ROWS}").replace('\t', delimiter);
            let folder = Folder::with(&[("table.csv", &table), ("main.awl", "A \"START\"\nA \"FLOW\"\n= Q 0.0\n")]);
            folder.run(&["check", "main.awl", "table.csv"]).code(0).stdout("no warnings");
            let printed = folder.run(&["symbols", "table.csv"]).code(0);
            assert_eq!(printed.stderr, "", "{table}");
            assert!(printed.stdout.contains("1    I 0.0             START") || printed.stdout.contains("START"), "{}", printed.stdout);
            assert!(!printed.stdout.contains('–'), "{}", printed.stdout);
        }
    }
    // Without a header it is read the same way, and that is said; whatever the file is called.
    for name in ["table.csv", "table.seq", "table.txt"] {
        let folder = Folder::with(&[(name, ROWS)]);
        let printed = folder.run(&["symbols", name]).code(0).stderr("P6133");
        assert!(printed.stdout.lines().nth(2).is_some_and(|row| row.starts_with("1 ") && row.contains("START")), "{}", printed.stdout);
    }
    // Too few columns to know which they are: refused, and never read as something else.
    let folder = Folder::with(&[("table.txt", "1\tI 0.0\tSTART\n2\tI 0.1\tSTOP\n")]);
    folder.run(&["symbols", "table.txt"]).code(1).stderr("P6104");
}

#[test]
fn what_symbols_prints_as_csv_can_be_read_back() {
    let native = "symbol,address,type,comment,number,unit,remark\nStart,I 0.0,BOOL,green,1,,makes\nLevel,IW 4,INT,\"0, 1\",2,l,\n";
    let folder = Folder::with(&[("first.csv", native)]);
    let csv = folder.run(&["symbols", "first.csv", "--csv"]).code(0).stdout;
    folder.write("again.csv", csv.as_bytes());
    let again = folder.run(&["symbols", "again.csv", "--csv"]).code(0);
    assert_eq!((again.stdout, again.stderr), (csv, String::new()));
    for format in ["csv", "sdf", "asc", "dif", "seq"] {
        let file = format!("plant.{format}");
        folder.run(&["symbols", "again.csv", "--to", format, "-o", &file]).code(0);
        let printed = folder.run(&["symbols", &file]).code(0);
        assert_eq!(printed.stderr, "", "{format}");
        assert!(printed.stdout.contains("Start") && printed.stdout.contains("IW 4"), "{format}: {}", printed.stdout);
    }
}

/// Instances of system blocks, which only a CPU has.
#[test]
fn an_instance_that_is_called_twice_is_said_in_stl() {
    let program = |first: &str| {
        format!(
            "DATA_BLOCK DB 4\nSFB 4\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL SFB 4, DB 4 (IN := {first}, PT := T#1S);\n\
             CALL SFB 4, DB 4 (IN := I 0.1, PT := T#1S);\nEND_ORGANIZATION_BLOCK\n"
        )
    };
    let folder = Folder::with(&[("twice.awl", &program("I 0.0")), ("ready.awl", &program("FALSE")), ("same.awl", &program("I 0.1"))]);
    folder.run(&["check", "twice.awl"]).code(0).stderr("P5022");
    folder.run(&["check", "ready.awl"]).code(0).stdout("no warnings");
    folder.run(&["check", "same.awl"]).code(0).stdout("no warnings");
}

/// Every verb that has `--json`.
const VERBS: [&str; 12] =
    ["check", "run", "exec", "step", "bench", "test", "trace", "record", "symbols", "refs", "structure", "assignments"];

/// A list of diagnostics in the documented form.
fn is_list_of_diagnostics(text: &str) -> Result<(), String> {
    let list: Value = serde_json::from_str(text).map_err(|error| format!("no JSON ({error}): {text}"))?;
    let list = list.as_array().filter(|list| !list.is_empty()).ok_or_else(|| format!("no list: {text}"))?;
    for one in list {
        let strings = ["code", "severity", "file", "message"].iter().all(|field| one[*field].is_string());
        let numbers = ["line", "column", "end_line", "end_column"].iter().all(|field| one[*field].is_number() || one[*field].is_null());
        let known = one["code"].as_str().and_then(Problem::from_code).is_some();
        if !(strings && numbers && known && (one["help"].is_string() || one["help"].is_null())) {
            return Err(format!("not the documented form: {one}"));
        }
    }
    Ok(())
}

#[test]
fn with_json_every_verb_says_what_is_wrong_in_one_form() {
    let folder = Folder::with(&[("wrong.awl", "A I 0.0\nXYZ 5\n"), ("wrong.csv", "symbol,address\nA,I 0.9\n")]);
    let mut failures = Vec::new();
    for verb in VERBS {
        let broken = if verb == "symbols" { "wrong.csv" } else { "wrong.awl" };
        let for_refs = |path: &'static str| if verb == "refs" { vec![verb, path, "MW0", "--json"] } else { vec![verb, path, "--json"] };
        for (what, arguments) in [
            ("a program that does not compile", for_refs(broken)),
            ("a file that is not there", for_refs("missing.awl")),
            ("an option that does not exist", vec![verb, "wrong.awl", "--json", "--no-such-option"]),
        ] {
            let run = folder.run(&arguments);
            let text = if verb == "check" { &run.stdout } else { &run.stderr };
            // A test that cannot be run is a result of its own.
            if verb == "test" && what == "a program that does not compile" && serde_json::from_str::<Value>(&run.stdout).is_ok() {
                continue;
            }
            if let Err(error) = is_list_of_diagnostics(text) {
                failures.push(format!("{verb}, {what}: {error}"));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    let version = sieben(folder.path(), &["--version", "--json"]).output().expect("the binary starts");
    assert!(String::from_utf8_lossy(&version.stdout).starts_with("sieben "));
}

#[test]
fn numbers_are_numbers_in_json_and_64_bits_are_strings() {
    let program = "PROGRAM Main\nVAR r : REAL := 1.5; d : LREAL := 0.1; n : LREAL; z : LREAL; u : UINT := 65535; l : LINT := 5; END_VAR\n\
                   n := 1.0 / z;\nEND_PROGRAM\n";
    let folder = Folder::with(&[("values.st", program)]);
    let lines = folder.run(&["exec", "values.st", "--dialect", "iec", "--json", "--show", "r,d,n,u,l"]).code(0).lines();
    let values = &lines.last().expect("a scan")["values"];
    assert_eq!(values["r"], 1.5);
    assert_eq!(values["d"], 0.1);
    assert_eq!(values["u"], 65535);
    assert!(values["l"].is_string(), "{values}");
    assert!(values["n"].is_string() || values["n"].is_number(), "{values}");
}

#[test]
fn no_problem_has_a_help_that_only_repeats_its_title() {
    let words = |text: &str| -> Vec<String> {
        text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_lowercase).collect()
    };
    let repeats = Problem::ALL.iter().filter(|problem| {
        let title = words(problem.title());
        words(problem.help()).iter().all(|word| title.contains(word))
    });
    let repeats: Vec<&str> = repeats.map(|problem| problem.code()).collect();
    assert_eq!(repeats, [""; 0]);
}

#[test]
fn a_help_that_says_no_more_than_the_message_is_left_out() {
    let folder = Folder::with(&[("slip.awl", "L 5\nТ MW 0\n")]);
    let list = folder.run(&["check", "slip.awl", "--json"]).json();
    assert_eq!(list[0]["code"], "P1005", "{list}");
    assert!(list[0]["help"].is_null(), "{list}");
    let text = folder.run(&["check", "slip.awl"]);
    assert!(!text.stderr.contains("Help:") && !text.stdout.contains("Help:"), "{}{}", text.stdout, text.stderr);
}
