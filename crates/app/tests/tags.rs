//! `sieben tags`: names, addresses and types as clients want them.

mod command;

use command::Folder;
use serde_json::json;

const PROGRAM: &str = "VAR_GLOBAL\n  level : REAL := 1.5; // how high\n  marker AT %MW20 : INT;\n  small : SINT;\n\
                       grid : ARRAY[1..2, 0..2] OF BOOL;\n  big : ARRAY[0..9] OF DINT;\nEND_VAR\n\
                       FUNCTION_BLOCK Counting\nVAR_INPUT step : INT; END_VAR\nVAR level : DINT; text : ARRAY[1..2] OF STRING[3]; END_VAR\nlevel := level + step;\nEND_FUNCTION_BLOCK\n\
                       PROGRAM Main\nVAR one : Counting; level2 : LREAL; END_VAR\n;\nEND_PROGRAM\n";

#[test]
fn variables_of_structured_text_are_tags_with_their_full_names() {
    let folder = Folder::with(&[("main.st", PROGRAM)]);
    let tags = folder.run(&["tags", "main.st", "--dialect", "iec", "--format", "json"]).code(0).json();
    let of = |name: &str| {
        tags.as_array().and_then(|tags| tags.iter().find(|tag| tag["name"] == name)).unwrap_or_else(|| panic!("no {name} in {tags:#}"))
    };
    assert_eq!(
        of("marker"),
        &json!({ "name": "marker", "address": "MW 20", "area": "M", "db": null, "byte": 20, "bit": null, "type": "INT", "count": 1, "bytes": 2, "nodes7": "MI20", "comment": "" })
    );
    assert_eq!((&of("level")["type"], &of("level")["comment"]), (&json!("REAL"), &json!("how high")));
    assert_eq!((&of("small")["type"], &of("small")["nodes7"]), (&json!("SINT"), &json!(null)), "nodes7 has no bytes with a sign");
    assert_eq!((&of("one.level")["type"], &of("one.text[2]")["type"]), (&json!("DINT"), &json!("STRING[3]")));
    assert_eq!((&of("big")["count"], &of("big")["bytes"]), (&json!(10), &json!(40)));
    // Rows of bits begin at even bytes.
    let place = |name: &str| (of(name)["byte"].as_u64().unwrap_or_default() * 8) + of(name)["bit"].as_u64().unwrap_or_default();
    assert_eq!((place("grid[1,2]") - place("grid[1,0]"), place("grid[2,0]") - place("grid[1,0]")), (2, 16));
}

#[test]
fn every_tag_lies_where_its_value_is() {
    let folder = Folder::with(&[("main.st", PROGRAM)]);
    let tags = folder.run(&["tags", "main.st", "--dialect", "iec", "--format", "json", "--elements"]).code(0).json();
    let tags = tags.as_array().expect("a list");
    let single: Vec<_> = tags.iter().filter(|tag| tag["bytes"].as_u64() <= Some(4) && tag["type"] != "LREAL").collect();
    assert!(single.len() > 20, "{tags:#?}");
    for tag in single {
        // What is written by name is read by address.
        let (name, address) = (tag["name"].as_str().expect("a name"), tag["address"].as_str().expect("an address"));
        let bit = tag["type"] == "BOOL";
        let run = folder.run(&["exec", "main.st", "--dialect", "iec", "--scans", "1", "--set", &format!("{name}=1"), "--show", address]);
        let wanted = match tag["type"].as_str() {
            Some("REAL") => "16#3F80_0000",
            _ if bit => "1",
            Some("SINT") => "16#01",
            Some("DINT") => "16#0000_0001",
            _ => "16#0001",
        };
        assert_eq!(run.code(0).stdout, format!("{address} = {wanted}\n"), "{name}");
    }
}

#[test]
fn each_name_is_there_once_and_what_cannot_be_written_is_said() {
    let blocks = "DATA_BLOCK DB 7\nSTRUCT\n  a : INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nL DB7.DBW 0\nT MW 0\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("main.awl", blocks), ("symbols.csv", "symbol,address,type,comment\nDB7.a,MW 0,INT,\"x; y\"\n")]);
    let names = folder.run(&["tags", "--format", "nodered"]).code(0);
    assert_eq!((names.stdout.as_str(), names.stderr.as_str()), ("MI0;DB7.a\nDB7,INT0;DB7.DB7.a\n", ""));
    folder.run(&["tags", "--format", "csv", "-o", "tags.csv"]).code(0);
    assert!(String::from_utf8(folder.read("tags.csv")).expect("a table is UTF-8").contains("DB7.a,MW 0,M,,0,,INT,1,2,MI0,x; y\n"));
    folder.write("small.st", b"VAR_GLOBAL small : SINT; END_VAR\nPROGRAM Main\n;\nEND_PROGRAM\n");
    let names = folder.run(&["tags", "small.st", "--format", "nodered"]).code(0);
    assert_eq!((names.stdout.as_str(), names.stderr.as_str()), ("", "Note: `small` is left out: nodes7 has no type for SINT\n"));
    folder.run(&["tags", "--format", "excel"]).code(2).stderr("csv, snap7, nodered, json");
    folder.write("main.awl", b"ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW\nEND_ORGANIZATION_BLOCK\n");
    assert!(folder.run(&["tags", "--format", "json"]).code(3).stderr.trim_start().starts_with('['));
}
