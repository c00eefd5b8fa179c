//! What a database knows after changes is what it would know of the same sources from the beginning, and a change renews only what it
//! touches.

use std::fs;
use std::path::{Path, PathBuf};

use sieben_lang::database::Database;
use sieben_lang::{Options, compile, encoding};
use sieben_model::block::BlockId;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::{Symbol, SymbolTable};

/// Random changes of each project.
const CHANGES: usize = 60;

/// The same numbers in each run.
struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit.max(1)
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Sources of a folder of the repository, in order.
fn folder(path: &str) -> Vec<(String, String)> {
    let mut paths: Vec<PathBuf> = fs::read_dir(root().join(path)).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    paths.sort();
    let is_source = |path: &PathBuf| path.extension().is_some_and(|ending| ["awl", "st", "scl", "exp"].iter().any(|one| ending == *one));
    let read = |path: PathBuf| {
        let text = encoding::read_source(&fs::read(&path).expect("a file")).expect("a text").text;
        (path.file_name().expect("a name").to_string_lossy().into_owned(), text)
    };
    paths.into_iter().filter(is_source).map(read).collect()
}

/// Sources with all kinds of dependencies between blocks.
fn mixed() -> Vec<(String, String)> {
    let files = [
        (
            "types.awl",
            "TYPE UDT 1\nSTRUCT\n a : INT;\n b : ARRAY[0..3] OF BOOL;\nEND_STRUCT;\nEND_TYPE\n\
             DATA_BLOCK DB 9\nSTRUCT\n u : UDT 1;\n x : INT := 5;\nEND_STRUCT;\nBEGIN\n x := 7;\nEND_DATA_BLOCK\n",
        ),
        (
            "blocks.awl",
            "FUNCTION FC 1 : INT\nVAR_INPUT\n a : INT;\nEND_VAR\nBEGIN\nL #a;\nT #RET_VAL;\nEND_FUNCTION\n\
             FUNCTION_BLOCK FB 1\nVAR_INPUT\n in1 : INT;\nEND_VAR\nVAR\n s : INT;\n u : UDT 1;\nEND_VAR\nBEGIN\nCALL FC 1 (a := #in1, RET_VAL := #s);\n\
             L DB9.DBW 8;\nT #u.a;\nEND_FUNCTION_BLOCK\n\
             FUNCTION_BLOCK FB 2\nVAR\n one : FB 1;\n k : INT;\nEND_VAR\nBEGIN\nCALL #one (in1 := #k);\nL \"DB9name\".x;\nT #k;\nEND_FUNCTION_BLOCK\n",
        ),
        (
            "main.awl",
            "DATA_BLOCK DB 1\nFB 1\nBEGIN\n in1 := 3;\nEND_DATA_BLOCK\n\
             ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY[1..20] OF BYTE;\n t : INT;\nEND_VAR\nBEGIN\nCALL FB 1, DB 1 (in1 := MW 2);\nCALL FB 2, DB 2;\n\
             CALL FC 10 (a := MW 4, RET_VAL := MW 6);\nL \"missing\";\nT MW 8;\nL DB9.DBW 2;\nT #t;\nUC FC 11;\nEND_ORGANIZATION_BLOCK\n",
        ),
        (
            "scl.scl",
            "FUNCTION FC10 : INT\nVAR_INPUT\n a : INT;\nEND_VAR\nVAR_TEMP\n r : REAL;\n s : STRING[20];\nEND_VAR\nBEGIN\n r := SQRT(INT_TO_REAL(a));\n\
             s := CONCAT(IN1 := 'a', IN2 := 'b');\n FC10 := FC1(a := a) + LEN(s);\nEND_FUNCTION\n\
             FUNCTION FC11 : VOID\nVAR_TEMP\n i : INT;\nEND_VAR\nBEGIN\n FB1.DB1(in1 := i);\n i := DB1.s + DB9.x;\n IF unknown THEN i := 1; END_IF;\nEND_FUNCTION\n",
        ),
    ];
    files.into_iter().map(|(name, text)| (name.to_owned(), text.to_owned())).collect()
}

/// Objects, global variables, types and a CONFIGURATION.
fn objects() -> Vec<(String, String)> {
    let files = [
        (
            "types.st",
            "TYPE Mode : (Off, Manual, Automatic); Point : STRUCT x, y : INT; m : Mode; END_STRUCT; Pair : ARRAY[0..1] OF Point; END_TYPE\n\
             VAR_GLOBAL CONSTANT\n limit : INT := 10;\nEND_VAR\nVAR_GLOBAL\n count : INT;\n all : Pair;\n timer : TON;\n motor : Motor;\nEND_VAR\n",
        ),
        (
            "motor.st",
            "INTERFACE IRun\nMETHOD Run : BOOL\nVAR_INPUT speed : INT; END_VAR\nEND_METHOD\nEND_INTERFACE\n\
             FUNCTION_BLOCK Base\nVAR PUBLIC\n total : INT;\nEND_VAR\nVAR\n t : TON;\nEND_VAR\nMETHOD PUBLIC Add : INT\nVAR_INPUT v : INT; END_VAR\n total := total + v; Add := total;\nEND_METHOD\n\
             t(IN := TRUE, PT := T#1s);\nEND_FUNCTION_BLOCK\n\
             FUNCTION_BLOCK Motor EXTENDS Base IMPLEMENTS IRun\nVAR_INPUT\n go : BOOL;\nEND_VAR\nVAR\n p : Point;\nEND_VAR\n\
             METHOD PUBLIC Run : BOOL\nVAR_INPUT speed : INT; END_VAR\n Run := Add(v := speed) > limit; p.m := Manual;\nEND_METHOD\n\
             IF go THEN p.x := p.x + 1; END_IF;\nEND_FUNCTION_BLOCK\n",
        ),
        (
            "main.st",
            "FUNCTION Twice : INT\nVAR_INPUT v : INT; END_VAR\n Twice := v * 2;\nEND_FUNCTION\n\
             PROGRAM Main\nVAR\n m : Motor;\n i : INT;\n r : REAL;\n s : STRING;\nEND_VAR\n\
             m(go := TRUE); IF m.Run(speed := Twice(v := count)) THEN i := i + all[0].x; END_IF;\n timer(IN := FALSE, PT := T#2s);\n\
             r := LN(2.0); s := REPLACE(s, 'x', 1, 1); count := LIMIT(0, i, limit); i := undeclared;\nEND_PROGRAM\n",
        ),
    ];
    files.into_iter().map(|(name, text)| (name.to_owned(), text.to_owned())).collect()
}

/// A text with one random change: a line lost, doubled or moved, a blank or a word put in, a digit replaced.
fn changed(text: &str, dice: &mut Dice) -> String {
    let mut lines: Vec<String> = text.split_inclusive('\n').map(str::to_owned).collect();
    if lines.is_empty() {
        return "\n".to_owned();
    }
    let at = dice.below(lines.len());
    match dice.below(7) {
        0 => drop(lines.remove(at)),
        1 => lines.insert(at, lines[at].clone()),
        2 => lines[at] = format!(" {}", lines[at]),
        3 => {
            let line = &lines[at];
            let digit = line.char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(index, _)| index).next_back();
            if let Some(digit) = digit {
                lines[at] = format!("{}{}{}", &line[..digit], dice.below(10), &line[digit + 1..]);
            }
        }
        4 => lines.insert(at, ["// a comment\n", "\n", " extra : INT;\n", "count := 1;\n", "L 5;\n"][dice.below(5)].to_owned()),
        5 => {
            let other = dice.below(lines.len());
            lines.swap(at, other);
        }
        _ => lines[at] = lines[at].replacen("INT", ["DINT", "REAL", "BOOL", "WORD"][dice.below(4)], 1),
    }
    lines.concat()
}

fn same(database: &mut Database, options: &Options, what: &str) {
    let expected = compile(database.sources(), &SymbolTable::default(), options);
    let diagnostics = database.diagnostics();
    assert_eq!(diagnostics, expected.diagnostics, "{what}: diagnostics");
    let got = database.compiled();
    assert_eq!(got.diagnostics, expected.diagnostics, "{what}: diagnostics with code");
    assert_eq!(format!("{:?}", got.program), format!("{:?}", expected.program), "{what}: program");
    assert_eq!(got.bodies, expected.bodies, "{what}: bodies");
    assert_eq!(got.block_names, expected.block_names, "{what}: names");
    assert_eq!((&got.intervals, &got.tests), (&expected.intervals, &expected.tests), "{what}");
    assert_eq!((got.countable, got.library, got.st_library), (expected.countable, expected.library, expected.st_library), "{what}");
}

/// Changes a project at random, each change on top of the ones before.
fn change_at_random(name: &str, files: &[(String, String)], changes: usize) {
    let options = Options { counted: name.len().is_multiple_of(2), extended: true, ..Options::default() };
    let mut database = Database::new(SymbolTable::default(), options.clone());
    for (name, text) in files {
        database.add(name.clone(), text.clone());
    }
    same(&mut database, &options, name);
    let mut dice = Dice(name.len() as u64);
    for change in 0..changes {
        let file = FileId(dice.below(files.len()) as u32);
        // Half of the time a file is as it was, so that mistakes do not pile up.
        let text = match dice.below(2) {
            0 => files[file.0 as usize].1.clone(),
            _ => changed(&database.sources().file(file).text, &mut dice),
        };
        database.replace(file, text);
        same(&mut database, &options, &format!("{name}, change {change} in {}", files[file.0 as usize].0));
    }
}

#[test]
fn changes_of_stl_and_scl_give_what_the_whole_gives() {
    change_at_random("mixed", &mixed(), 4 * CHANGES);
}

#[test]
fn changes_of_objects_give_what_the_whole_gives() {
    change_at_random("objects", &objects(), 4 * CHANGES);
}

#[test]
fn changes_of_the_corpus_give_what_the_whole_gives() {
    for dialect in ["iec", "codesys", "scl", "tia"] {
        let files = folder(&format!("spec/corpus/st/{dialect}"));
        for (index, three) in files.chunks(3).enumerate() {
            change_at_random(&format!("{dialect} {index}"), three, CHANGES / 6);
        }
    }
    for kind in ["legal", "broken"] {
        let files = folder(&format!("spec/corpus/{kind}"));
        for (index, three) in files.chunks(3).enumerate() {
            change_at_random(&format!("{kind} {index}"), three, CHANGES / 6);
        }
    }
}

/// Replaces a source by each of these texts in turn; each time all is as if it had been compiled from the beginning.
fn replaced(files: &[(&str, &str)], file: u32, texts: &[&str]) {
    let options = Options::default();
    let mut database = Database::new(SymbolTable::default(), options.clone());
    for (name, text) in files {
        database.add(*name, *text);
    }
    same(&mut database, &options, "all as it was");
    for text in texts.iter().chain([&files[file as usize].1]).chain(texts.iter().rev()) {
        database.replace(FileId(file), *text);
        same(&mut database, &options, text);
    }
}

#[test]
fn circles_that_come_and_go_give_what_the_whole_gives() {
    let fb = |number: u32, inner: &str| {
        format!("FUNCTION_BLOCK FB {number}\nVAR\n a : INT;\n{inner}END_VAR\nBEGIN\nL #a;\nEND_FUNCTION_BLOCK\n")
    };
    let (one, two) = (fb(1, " in2 : FB 2;\n"), fb(2, ""));
    let files = [("1.awl", one.as_str()), ("2.awl", two.as_str()), ("m.awl", "CALL FB 1, DB 1;\n")];
    replaced(&files, 1, &[&fb(2, " in1 : FB 1;\n"), &fb(2, " in2 : FB 2;\n"), &fb(2, " in3 : FB 3;\n"), ""]);
    let udt = |inner: &str| format!("TYPE UDT 1\nSTRUCT\n a : INT;\n{inner}END_STRUCT;\nEND_TYPE\n");
    let plain = udt("");
    let files = [
        ("1.awl", plain.as_str()),
        ("2.awl", "TYPE UDT 2\nSTRUCT\n b : UDT 1;\nEND_STRUCT;\nEND_TYPE\nDATA_BLOCK DB 1\nUDT 2\nBEGIN\n b.a := 4;\nEND_DATA_BLOCK\n"),
        ("m.awl", "L DB1.DBW 0;\nT MW 0;\n"),
    ];
    replaced(&files, 0, &[&udt(" c : UDT 2;\n"), &udt(" c : DINT;\n"), &udt(" a : INT;\n")]);
    let base = "FUNCTION_BLOCK A\nVAR a : INT; END_VAR\na := a + 1;\nEND_FUNCTION_BLOCK\n";
    let files = [
        ("a.st", base),
        (
            "b.st",
            "FUNCTION_BLOCK B EXTENDS A\nVAR b : INT; END_VAR\nb := a;\nEND_FUNCTION_BLOCK\nPROGRAM Main\nVAR one : B; END_VAR\none();\nEND_PROGRAM\n",
        ),
    ];
    let circle = base.replacen("A\n", "A EXTENDS B\n", 1);
    let constant = base.replacen("VAR a", "VAR CONSTANT k : INT := 3; END_VAR\nVAR a", 1);
    replaced(&files, 0, &[&circle, &constant, &base.replace("INT", "DINT"), &base.replace("VAR a", "VAR PRIVATE a"), ""]);
}

#[test]
fn blocks_that_go_and_sources_that_never_parse_give_what_the_whole_gives() {
    let files = [
        (
            "1.awl",
            "FUNCTION FC 1 : INT\nVAR_INPUT\n a : INT;\nEND_VAR\nBEGIN\nL #a;\nT #RET_VAL;\nEND_FUNCTION\nFUNCTION FC 2 : VOID\nBEGIN\nEND_FUNCTION\n",
        ),
        ("2.scl", "FUNCTION FC3 : INT\nBEGIN\n FC3 := FC1(a := 2);\nEND_FUNCTION\n"),
        ("m.awl", "CALL FC 1 (a := 1, RET_VAL := MW 0);\nUC FC 2;\nUC FC 3;\nL DB7.DBW 0;\n"),
    ];
    let garbage = "\u{0}\u{1}) ;; FUNCTION FUNCTION ( \"\nEND_FUNCTION VAR : = 'x\n";
    replaced(
        &files,
        0,
        &[
            "",
            "FUNCTION FC 2 : VOID\nBEGIN\nEND_FUNCTION\n",
            garbage,
            "DATA_BLOCK DB 7\nSTRUCT\n x : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n",
        ],
    );
    replaced(&files, 1, &["", garbage, "FUNCTION FC3 : REAL\nBEGIN\n FC3 := SQRT(2.0);\nEND_FUNCTION\n"]);
    replaced(&files, 2, &["", garbage]);
}

#[test]
fn what_a_function_keeps_is_where_its_type_says() {
    let inner = |more: &str| {
        format!(
            "FUNCTION_BLOCK Inner\nVAR_INPUT\n{more} on : BOOL;\nEND_VAR\nVAR_OUTPUT\n done : BOOL;\nEND_VAR\ndone := on;\nEND_FUNCTION_BLOCK\n"
        )
    };
    let plain = inner("");
    let keeps = "FUNCTION F : BOOL\nVAR_STAT\n one : Inner;\nEND_VAR\nF := one.done;\nEND_FUNCTION\nPROGRAM PLC_PRG\nVAR b : BOOL; x AT %MX1.0 : BOOL := TRUE; END_VAR\nb := F();\nEND_PROGRAM\n";
    let files = [("a.exp", plain.as_str()), ("b.exp", keeps)];
    replaced(&files, 0, &[&inner(" more : DINT;\n"), &inner(" x, y : INT;\n")]);
}

#[test]
fn a_suggestion_goes_to_the_first_block_that_lacks_a_name() {
    let function = |name: &str, used: &str| format!("FUNCTION {name} : INT\n{name} := {used};\nEND_FUNCTION\n");
    let (first, second) = (function("A", "countt"), function("B", "countt"));
    let files = [("a.st", first.as_str()), ("b.st", second.as_str()), ("g.st", "VAR_GLOBAL\n count : INT;\nEND_VAR\n")];
    replaced(&files, 0, &[&function("A", "count"), &function("A", "1")]);
    replaced(&files, 1, &[&function("B", "count"), &function("B", "1")]);
}

#[test]
fn blocks_of_the_library_go_when_nothing_needs_them() {
    // The source of RAMP_INT uses blocks of its own source.
    let ramp = "PROGRAM PLC_PRG\nVAR\n ramp : RAMP_INT;\n x, y : INT;\nEND_VAR\nramp(IN := x, OUT => y);\nEND_PROGRAM\n";
    let files = [("m.exp", ramp), ("f.exp", "FUNCTION F : INT\nVAR_INPUT a : INT; END_VAR\nF := RAMP_INTS;\nEND_FUNCTION\n")];
    replaced(&files, 0, &["PROGRAM PLC_PRG\nVAR y : INT; END_VAR\ny := F(1);\nEND_PROGRAM\n", &ramp.replace("RAMP_INT", "BLINK"), ""]);
}

#[test]
fn a_name_of_the_library_comes_and_goes_with_the_block_that_writes_it() {
    let by_number = "CALL FB 41, DB 41;\n";
    let files = [
        ("m.awl", by_number),
        ("f.awl", "FUNCTION FC 12 : VOID\nBEGIN\nUC \"CONT_C\";\nEND_FUNCTION\n"),
        ("f.scl", "FUNCTION FC11 : VOID\nBEGIN\n CONT_C.DB42();\nEND_FUNCTION\n"),
    ];
    replaced(&files, 0, &["CALL \"CONT_C\", DB 41;\n"]);
}

#[test]
fn a_block_of_the_library_stays_when_one_of_its_users_goes() {
    let files = [
        ("m.awl", "CALL FC 11 (RET_VAL := MW 2);\nCALL \"CONCAT\";\n"),
        (
            "f.scl",
            "FUNCTION FC11 : INT\nVAR_TEMP\n s : STRING[20];\nEND_VAR\nBEGIN\n s := CONCAT(IN1 := 'a', IN2 := 'b');\n s := DELETE(IN := s, L := 1, P := 1);\n FC11 := LEN(s);\nEND_FUNCTION\n",
        ),
    ];
    replaced(&files, 0, &["CALL FC 11 (RET_VAL := MW 2);\n"]);
}

#[test]
fn messages_quote_what_the_source_says_now() {
    let function = |statements: &str| format!("FUNCTION FC 1 : VOID\nBEGIN\n{statements}END_FUNCTION\n");
    let lower = function("T W#16#ab;\nCALL mw 10;\n");
    replaced(&[("f.awl", lower.as_str())], 0, &[&function("T W#16#AB;\nCALL mw 10;\n"), &function("T W#16#ab;\nCALL MW 10;\n")]);
}

#[test]
fn a_change_that_breaks_many_declarations_has_all_suggestions() {
    let block = |type_name: &str| {
        let variables: String = (0..70).map(|index| format!(" v{index} : {type_name};\n")).collect();
        format!("FUNCTION_BLOCK Fb\nVAR\n{variables}END_VAR\nv0.x := 1;\nEND_FUNCTION_BLOCK\n")
    };
    let right = block("Point");
    let files = [("f.st", right.as_str()), ("t.st", "TYPE Point : STRUCT x, y : INT; END_STRUCT; END_TYPE\n")];
    replaced(&files, 0, &[&block("Poimt")]);
}

#[test]
fn initial_values_at_addresses_are_written_in_the_same_order() {
    // The type has an instance with an address; which block asks for the type first decides when its value is written.
    let first = |type_name: &str| format!("FUNCTION_BLOCK A\nVAR\n q : {type_name};\nEND_VAR\nEND_FUNCTION_BLOCK\n");
    let with_type = first("Shared");
    let files = [
        ("first.exp", with_type.as_str()),
        ("second.exp", "FUNCTION_BLOCK B\nVAR\n q : Shared;\nEND_VAR\nEND_FUNCTION_BLOCK\n"),
        (
            "addresses.exp",
            "FUNCTION_BLOCK C\nVAR\n o AT %MW10 : INT := 4;\nEND_VAR\no := 1;\nEND_FUNCTION_BLOCK\n\
             FUNCTION_BLOCK D\nVAR\n o AT %MW10 : INT := 5;\nEND_VAR\no := 2;\nEND_FUNCTION_BLOCK\n\
             TYPE Shared : STRUCT a : INT; inner : C; END_STRUCT; END_TYPE\n",
        ),
        ("main.exp", "PROGRAM PLC_PRG\nVAR\n first : A;\n second : B;\n third : D;\nEND_VAR\nfirst(); second(); third();\nEND_PROGRAM\n"),
    ];
    replaced(&files, 0, &[&first("INT")]);
}

fn fc(number: u16) -> BlockId {
    BlockId::new(sieben_model::block::BlockKind::Function, number)
}

fn fb(number: u16) -> BlockId {
    BlockId::new(sieben_model::block::BlockKind::FunctionBlock, number)
}

/// The blocks that are checked again when a piece of a file is replaced.
fn checked_after(files: &[(String, String)], file: usize, from: &str, to: &str) -> Vec<BlockId> {
    let mut database = Database::new(SymbolTable::default(), Options::default());
    for (name, text) in files {
        database.add(name.clone(), text.clone());
    }
    let diagnostics = database.diagnostics();
    let errors: Vec<_> = diagnostics.iter().filter(|one| one.severity() == sieben_model::diagnostic::Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:?}");
    assert!(files[file].1.contains(from), "{from} is in {}", files[file].0);
    database.replace(FileId(file as u32), files[file].1.replacen(from, to, 1));
    database.diagnostics();
    database.work().checked.iter().copied().collect()
}

#[test]
fn a_change_checks_its_block_and_what_depends_on_its_interface() {
    let files = [
        (
            "a.awl",
            "FUNCTION FC 1 : INT\nVAR_INPUT\n a : INT;\nEND_VAR\nBEGIN\nL #a;\nT #RET_VAL;\nEND_FUNCTION\n\
             FUNCTION FC 2 : INT\nBEGIN\nL 1;\nT #RET_VAL;\nEND_FUNCTION\n",
        ),
        (
            "b.awl",
            "FUNCTION_BLOCK FB 1\nVAR_INPUT\n i : INT;\nEND_VAR\nVAR\n s : INT;\nEND_VAR\nBEGIN\nCALL FC 1 (a := #i, RET_VAL := #s);\nEND_FUNCTION_BLOCK\n",
        ),
        (
            "c.awl",
            "FUNCTION_BLOCK FB 2\nVAR\n one : FB 1;\nEND_VAR\nBEGIN\nCALL #one (i := 1);\nEND_FUNCTION_BLOCK\n\
             ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY[1..20] OF BYTE;\nEND_VAR\nBEGIN\nCALL FB 2, DB 2;\nCALL FC 2 (RET_VAL := MW 2);\nEND_ORGANIZATION_BLOCK\n\
             DATA_BLOCK DB 2\nFB 2\nBEGIN\nEND_DATA_BLOCK\n",
        ),
        (
            "d.scl",
            "FUNCTION FC10 : INT\nVAR_INPUT\n v : INT;\nEND_VAR\nBEGIN\n FC10 := FC1(a := v);\nEND_FUNCTION\n\
             FUNCTION FC11 : INT\nBEGIN\n FC11 := FC10(v := 1);\nEND_FUNCTION\n",
        ),
    ];
    let files = files.map(|(name, text)| (name.to_owned(), text.to_owned()));
    // A statement: only its block, and in the same file what it moves.
    assert_eq!(checked_after(&files, 0, "L 1;", "L 2;"), [fc(2)]);
    assert_eq!(checked_after(&files, 0, "L #a;", "L #a;;"), [fc(1), fc(2)]);
    assert_eq!(checked_after(&files, 3, "v := 1", "v := 2"), [fc(11)]);
    // A temporary variable is part of no other block; the interface is asked for by callers all the same.
    assert_eq!(checked_after(&files, 1, " s : INT;", " s : DINT;"), [BlockId::ob(1), fb(1), fb(2)]);
    // A parameter: the block, its callers in both languages, and what it moves.
    assert_eq!(checked_after(&files, 0, " a : INT;", " a : WORD;"), [fc(1), fc(2), fc(10), fb(1)]);
    assert_eq!(checked_after(&files, 3, " v : INT;", " v : DINT;"), [fc(10), fc(11)]);
    // The whole text again: nothing.
    assert_eq!(checked_after(&files, 2, "FB 2", "FB 2"), []);
}

#[test]
fn what_blocks_take_from_the_library_is_known_after_a_change() {
    // The outer block uses the library itself, and through what it contains.
    let files = [
        ("a.st", "FUNCTION_BLOCK Outer\nVAR\n t : TON;\n inner : Inner;\n e : R_TRIG;\nEND_VAR\nt(); inner(); e();\nEND_FUNCTION_BLOCK\n"),
        ("b.st", "FUNCTION_BLOCK Inner\nVAR\n c : CTU;\nEND_VAR\nc();\nEND_FUNCTION_BLOCK\n"),
        ("c.st", "FUNCTION_BLOCK A\nVAR\n n : INT;\nEND_VAR\nn := 1;\nEND_FUNCTION_BLOCK\n"),
        ("m.st", "PROGRAM Main\nVAR\n outer : Outer;\n a : A;\nEND_VAR\nouter(); a();\nEND_PROGRAM\n"),
    ];
    let files = files.map(|(name, text)| (name.to_owned(), text.to_owned()));
    assert_eq!(checked_after(&files, 2, "n := 1", "n := 2").len(), 1);
}

#[test]
fn another_symbol_table_is_that_of_the_project() {
    let symbol =
        |address: &str| Symbol { name: "lamp".to_owned(), address: address.to_owned(), data_type: "BOOL".to_owned(), ..Symbol::default() };
    let mut database = Database::new(SymbolTable::new(vec![symbol("Q 0.0")]), Options::default());
    database.add("main.awl", "A I 0.0;\n= \"lamp\";\n");
    database.compiled();
    for table in [vec![symbol("Q 4.1")], vec![symbol("QW 2")], vec![]] {
        let table = SymbolTable::new(table);
        database.set_symbols(table.clone());
        let (got, expected) = (database.compiled(), compile(database.sources(), &table, &Options::default()));
        assert_eq!((got.diagnostics, got.bodies), (expected.diagnostics, expected.bodies));
    }
}

#[test]
fn a_source_that_comes_later_is_part_of_the_project() {
    let mut database = Database::new(SymbolTable::default(), Options::default());
    let main = database.add("main.awl", "CALL FC 1;\n");
    assert!(!database.diagnostics().is_empty());
    database.add("fc1.awl", "FUNCTION FC 1 : VOID\nBEGIN\nNOP 0;\nEND_FUNCTION\n");
    assert_eq!(database.diagnostics(), []);
    database.replace(main, "CALL FC 2;\n");
    let mut sources = Sources::default();
    for (_, file) in database.sources().iter() {
        sources.add(file.name.clone(), file.text.clone());
    }
    assert_eq!(database.diagnostics(), compile(&sources, &SymbolTable::default(), &Options::default()).diagnostics);
}
