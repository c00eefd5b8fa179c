//! Tests of reading, checking and writing symbol tables.

use super::*;
use proptest::prelude::*;

const CSV: &str = "number,symbol,address,type,comment,unit,tag,remark,cabinet\n\
    1,START,I 0.0,BOOL,Start button,,S1,\"makes, contact\",A\n\
    2,Ventil_Ä,A  0.0,BOOL,\"says \"\"open\"\"\",,Y1,,A\n\
    ,Display,QW 4,WORD,,l,H1,,\n";

fn codes(read: &Read) -> Vec<&'static str> {
    read.diagnostics.iter().map(|diagnostic| diagnostic.problem.code()).collect()
}

fn read_csv(text: &str) -> Read {
    read(FileId(0), text, Format::Csv)
}

#[test]
fn a_native_table_comes_back_as_it_was() {
    for text in [
        CSV.to_owned(),
        CSV.replace('\n', "\r\n"),
        CSV.replace(',', ";").replace("makes;", "makes,").replace("\"makes, contact\"", "makes, contact"),
    ] {
        let first = read_csv(&text);
        assert_eq!(codes(&first), [""; 0], "{:?}", first.diagnostics);
        assert_eq!(write(&first.table, first.layout), Written { text, losses: Vec::new() });
        let valve = first.table.find("ventil_ä").expect("the valve");
        assert_eq!((valve.comment.as_str(), valve.extra.clone()), ("says \"open\"", vec![("cabinet".to_owned(), "A".to_owned())]));
    }
}

#[test]
fn the_formats_of_step_7_round_trip() {
    let native = read_csv("symbol,address,type,comment\nMotor ein,A   4.0,BOOL,Förderband\nTank,DB 99,FB 100,\nVAT_1,VAT 1,,\n").table;
    for format in [Format::Sdf, Format::Asc, Format::Dif] {
        let written = write(&native, Layout::new(format));
        assert_eq!(written.losses, Vec::<String>::new());
        assert!(written.text.ends_with("\r\n"));
        assert_eq!(detect("x", &written.text), Some(format));
        let again = read(FileId(0), &written.text, format);
        assert_eq!(codes(&again), [""; 0], "{:?}", again.diagnostics);
        assert_eq!(again.table.symbols(), native.symbols());
        assert_eq!(write(&again.table, again.layout), written);
    }
    let line = write(&native, Layout::new(Format::Asc)).text;
    assert!(line.lines().all(|line| line.starts_with("126,") && line.chars().count() == 130));
    let line = write(&native, Layout::new(Format::Sdf)).text;
    assert!(line.starts_with("\"Motor ein               \",\"A   4.0     \",\"BOOL      \",\"Förderband"));
}

#[test]
fn unpadded_sdf_and_tag_tables_of_tia_are_read() {
    let read = read(
        FileId(0),
        "\"Start\",\"I 0.0\",\"BOOL\",\"\"\n\"Stop\",\"%I0.1\",\"Bool\",\"True\",\"True\",\"False\",\"stops\",\"\",\"True\"\n",
        Format::Sdf,
    );
    assert_eq!(codes(&read), [""; 0], "{:?}", read.diagnostics);
    assert_eq!(read.table.operand("START"), Operand::parse("I 0.0"));
    assert_eq!(read.table.operand("STOP"), Operand::parse("I 0.1"));
    assert_eq!(read.table.find("STOP").map(|symbol| symbol.comment.as_str()), Some("stops"));
}

#[test]
fn each_fault_of_a_table_has_its_code_and_its_line() {
    for (text, code, line) in [
        ("symbol,address\nA,I 0.0\na,I 0.1\n", "P6101", 3),
        ("symbol,address\nA,I 0.0\nB,E 0.0\n", "P6102", 3),
        ("symbol,address\nA,I 0.8\n", "P6103", 2),
        ("symbol,address\nA,LW 2\n", "P6103", 2),
        ("symbol,type\nA,BOOL\n", "P6104", 1),
        ("", "P6104", 1),
        ("symbol,address\nA,I 0.0,more\n", "P6105", 2),
        ("symbol,address\nA_name_that_is_longer_than_24,I 0.0\n", "P6106", 2),
        ("symbol,address\n,I 0.0\n", "P6107", 2),
        ("symbol,address\nA,\n", "P6107", 2),
        ("symbol,address\nB,I 1.0\n\"A,I 0.0\n", "P6108", 3),
        ("symbol,address,type\nA,MW 2,BOOL\n", "P6109", 2),
        ("symbol,address,type\nA,T 2,BOOL\n", "P6109", 2),
        ("symbol,address\n\"A\"\"B\",I 0.0\n", "P6110", 2),
    ] {
        let read = read_csv(text);
        assert_eq!(codes(&read), [code], "{text}: {:?}", read.diagnostics);
        let before = &text[..read.diagnostics[0].span.start as usize];
        assert_eq!(before.lines().count() + 1, line, "{text}");
    }
    let asc = read(FileId(0), "A I 0.0\r\n126,Start                   I       0.0 BOOL\r\n", Format::Asc);
    assert_eq!(codes(&asc), ["P6105"]);
    assert_eq!(asc.table.symbols().len(), 1);
    let sdf = read(FileId(0), "\"Start\",\"I 0.0\"\r\n", Format::Sdf);
    assert_eq!(codes(&sdf), ["P6105"]);
}

#[test]
fn what_a_format_cannot_hold_is_said() {
    let table = read_csv("symbol,address,comment,remark,x\nA_name_that_is_longer_than_24,I 0.0,two lines,r,y\n").table;
    assert_eq!(
        write(&table, Layout::new(Format::Asc)).losses,
        [
            "the name of `A_name_that_is_longer_than_24` is cut from 29 to 24 characters",
            "the column `remark` has no place in this format",
            "the column `x` has no place in this format"
        ]
    );
}

#[test]
fn no_space_stands_before_an_address() {
    for address in ["Q 4.0", " Q 4.0", "   MW10", "\tT 1", "DB 5"] {
        let mut table = SymbolTable::default();
        let native = read_csv("symbol,address,type\nMotor,Q 4.0,BOOL\n").table;
        for symbol in native.symbols() {
            table.push(Symbol { address: address.to_owned(), ..symbol.clone() });
        }
        for format in Format::ALL {
            let text = write(&table, Layout::new(format)).text;
            let bare = address.trim();
            let wanted = match format {
                Format::Dif => format!("\"{bare}\"\n").replace('\n', if text.contains("\r\n") { "\r\n" } else { "\n" }),
                Format::Seq => format!("\t{bare}\t"),
                Format::Csv => continue,
                _ => bare.to_owned(),
            };
            assert!(text.contains(&wanted), "{format:?}: {text:?}");
        }
    }
}

#[test]
fn formats_are_known_by_content_and_else_by_extension() {
    assert_eq!(detect("a/SYMBOLS.SDF", ""), Some(Format::Sdf));
    assert_eq!(detect("table.txt", CSV), Some(Format::Csv));
    assert_eq!(detect("table.txt", "A I 0.0"), None);
    for (text, format) in [
        ("126,Start                   I       0.0 BOOL\r\n", Format::Asc),
        ("\"Start\",\"I 0.0\",\"BOOL\",\"\"\r\n", Format::Sdf),
        (DIF, Format::Dif),
        ("\tE 1.0\tStart\tTaster\r\n", Format::Seq),
        ("Start\tE 1.0\r\n", Format::Seq),
        ("; Zuordnungsliste\r\nE 1.0\tStart\r\n", Format::Seq),
        ("\"Symbol\",\"Address\",\"Type\",\"Comment\"\n", Format::Csv),
        ("Name\tLogical Address\n", Format::Csv),
    ] {
        assert_eq!(detect("wrong.sdf", text), Some(format), "{text}");
    }
}

const DIF: &str = "TABLE\r\n0,1\r\n\"EXCEL\"\r\nVECTORS\r\n0,2\r\n\"\"\r\nTUPLES\r\n0,4\r\n\"\"\r\nDATA\r\n0,0\r\n\"\"\r\n\
    -1,0\r\nBOT\r\n1,0\r\n\"Motor \"\"ein\"\"\"\r\n1,0\r\n\"A     4.0   \"\r\n1,0\r\n\"BOOL\"\r\n1,0\r\n\"Förderband\"\r\n\
    -1,0\r\nBOT\r\n0,4711\r\nV\r\n1,0\r\nDB 99\r\n1,0\r\n\"FB 100\"\r\n1,0\r\n\"\"\r\n-1,0\r\nEOD\r\n";

#[test]
fn a_spreadsheet_in_dif_is_read_cell_by_cell() {
    let found = read(FileId(0), DIF, Format::Dif);
    assert_eq!(codes(&found), ["P6110"], "only the quotation mark in the name: {:?}", found.diagnostics);
    let rows: Vec<[&str; 4]> = found
        .table
        .symbols()
        .iter()
        .map(|symbol| [&symbol.name, &symbol.address, &symbol.data_type, &symbol.comment].map(String::as_str))
        .collect();
    assert_eq!(rows, [["Motor \"ein\"", "A     4.0", "BOOL", "Förderband"], ["4711", "DB 99", "FB 100", ""]]);
    // A spreadsheet swaps the counts and writes its headings as a row.
    let swapped = DIF.replace("VECTORS\r\n0,2", "VECTORS\r\n0,4").replace("TUPLES\r\n0,4", "TUPLES\r\n0,3").replace(
        "\"\"\r\n-1,0\r\nBOT\r\n1,0\r\n\"Motor",
        "\"\"\r\n-1,0\r\nBOT\r\n1,0\r\n\"Symbol\"\r\n1,0\r\n\"Adresse\"\r\n-1,0\r\nBOT\r\n1,0\r\n\"Motor",
    );
    assert_ne!(swapped.len(), DIF.len());
    assert_eq!(read(FileId(0), &swapped, Format::Dif).table.symbols(), found.table.symbols());
    assert_eq!(codes(&read(FileId(0), &swapped, Format::Dif)), ["P6110"]);
}

#[test]
fn faults_of_a_dif_are_told_once_and_the_rows_behind_them_are_read() {
    let plain = DIF.replace("\"\"ein\"\"", "ein");
    let found = |text: &str| {
        let read = read(FileId(0), text, Format::Dif);
        let lines: Vec<usize> = read.diagnostics.iter().map(|found| text[..found.span.start as usize].matches('\n').count() + 1).collect();
        (codes(&read), lines, read.table.symbols().len())
    };
    assert_eq!(found(&plain), (vec![], vec![], 2));
    assert_eq!(found(plain.trim_end().trim_end_matches("-1,0\r\nEOD")), (vec!["P6111"], vec![32], 2));
    assert_eq!(found("TABLE\n0,1\n\"\"\nDATA\n0,0\n"), (vec!["P6111"], vec![1], 0));
    assert_eq!(found(&plain.replace("0,2", "0,7")), (vec!["P6112"], vec![5], 2));
    assert_eq!(found(&plain.replace("0,2", "many")), (vec!["P6105"], vec![5], 0));
    assert_eq!(found(&plain.replacen("1,0\r\n\"BOOL\"", "\"BOOL\"", 1)), (vec!["P6105"], vec![19], 1));
    assert_eq!(found(&plain.replacen("1,0\r\nDB 99", "1,0\r\nDB 99\r\n1,0\r\nx\r\n1,0\r\ny", 1)), (vec!["P6105"], vec![26], 1));
}

#[test]
fn assignment_lists_of_step_5_are_read_in_both_orders() {
    let expected = [["Start", "E 1.0", "Taster grün"], ["Motor ein", "A   4.0", ""], ["Pos", "DB 10", "x"]];
    for text in [
        "\tE 1.0\tStart\tTaster grün\r\n\tA   4.0\tMotor ein\r\n; Ende\r\n\tDB 10\tPos\tx\r\n\x1A",
        "E 1.0\tStart\tTaster grün\nA   4.0\tMotor ein\t\n\nDB 10\tPos\tx",
        "Start\tE 1.0\tTaster grün\nMotor ein\tA   4.0\t\nPos\tDB 10\tx\n",
        "E 1.0    Start      Taster grün\nA   4.0  Motor ein  \nDB 10 Pos x\n",
        "Start      E 1.0    Taster grün\nMotor ein  A   4.0\nPos DB 10 x\n",
    ] {
        // Addresses of several blanks stand in files with tabulators or columns.
        let found = read(FileId(0), text, Format::Seq);
        let rows: Vec<[String; 3]> =
            found.table.symbols().iter().map(|symbol| [symbol.name.clone(), symbol.address.clone(), symbol.comment.clone()]).collect();
        assert_eq!(rows, expected, "{text}");
        assert_eq!(codes(&found), [""; 0], "{text}: {:?}", found.diagnostics);
    }
    let wrong = read(FileId(0), "\tE 1.0\tStart\nno address\n\tE 1.9\tStop\n", Format::Seq);
    assert_eq!(codes(&wrong), ["P6105", "P6103"]);
    let lossy = read_csv("symbol,address,type\nStart,I 0.0,BOOL\n").table;
    assert_eq!(write(&lossy, Layout::new(Format::Seq)).losses, ["the data types have no place in this format"]);
}

#[test]
fn columns_of_other_tools_are_understood() {
    for text in [
        "Name,Path,Data Type,Logical Address,Comment\nStart,Table,Bool,%I0.0,green\n",
        "Symbol;Adresse;Datentyp;Kommentar\nStart;E 0.0;BOOL;green\n",
        "Symbol\tAddress\tData type\tComment\nStart\tI 0.0\tBOOL\tgreen\n",
    ] {
        let found = read_csv(text);
        assert_eq!(codes(&found), [""; 0], "{text}: {:?}", found.diagnostics);
        assert_eq!(found.table.operand("start"), Operand::parse("I 0.0"), "{text}");
        assert_eq!(found.table.find("start").map(|symbol| symbol.comment.as_str()), Some("green"));
        assert_eq!(write(&found.table, found.layout).text, text);
    }
    // Our own name of a column wins over one of the others.
    let own = read_csv("name,symbol,address\nx,Start,I 0.0\n");
    assert_eq!(own.table.symbols()[0].extra, [("name".to_owned(), "x".to_owned())]);
}

#[test]
fn tables_in_every_encoding_are_the_same_table() {
    use crate::encoding::{Encoding, encode, read_source};
    let text = "126,Ventil_Größe            A       4.0 BOOL      Öffnen für 3 s\r\n";
    for encoding in [Encoding::Utf8, Encoding::Utf8Bom, Encoding::Utf16Le, Encoding::Utf16Be, Encoding::Cp1252] {
        let decoded = read_source(&encode(text, encoding).expect("all letters exist")).expect("a text");
        let found = read(FileId(0), &decoded.text, detect("x", &decoded.text).expect("a format"));
        assert_eq!(found.table.find("ventil_grösse").is_none(), found.table.find("ventil_größe").is_some(), "{encoding:?}");
    }
    for (name, encoding) in [("Двигатель", Encoding::Cp1251), ("Zawór_główny", Encoding::Cp1250)] {
        let text = format!("\"{name}\",\"A 4.0\",\"BOOL\",\"{name} {name}\"\r\n");
        let decoded = read_source(&encode(&text, encoding).expect("all letters exist")).expect("a text");
        assert_eq!(decoded.encoding, encoding);
        assert!(read(FileId(0), &decoded.text, Format::Sdf).table.find(name).is_some(), "{name}");
    }
}

/// A text without line ends and without blanks at its ends, which formats with padding cannot keep, and no dash alone, which says that there is nothing.
fn any_text(length: usize) -> impl Strategy<Value = String> {
    proptest::collection::vec(prop_oneof![any::<char>(), prop::sample::select(vec![',', ';', '"', ' ', 'ä', 'I', '0'])], 0..length)
        .prop_map(|characters| characters.into_iter().filter(|character| !character.is_control()).collect::<String>().trim().to_owned())
        .prop_map(|text| if super::headings::is_dash(&text) { String::new() } else { text })
}

fn any_symbol() -> impl Strategy<Value = Symbol> {
    (any_text(20), any_text(10), any_text(8), any_text(30), any_text(5), any_text(9)).prop_map(
        |(name, address, data_type, comment, number, remark)| Symbol {
            name: format!("n{name}"),
            address,
            data_type,
            comment,
            number,
            remark,
            ..Symbol::default()
        },
    )
}

proptest! {
    #[test]
    fn any_table_comes_back_from_csv(symbols in proptest::collection::vec(any_symbol(), 0..8), delimiter in prop::sample::select(vec![b',', b';'])) {
        let table = SymbolTable::new(symbols);
        let layout = Layout { delimiter, ..Layout::new(Format::Csv) };
        let again = read(FileId(0), &write(&table, layout).text, Format::Csv);
        prop_assert_eq!(again.table.symbols(), table.symbols());
        prop_assert_eq!(again.layout, layout);
    }

    #[test]
    fn what_fits_comes_back_from_the_formats_of_step_7(symbols in proptest::collection::vec(any_symbol(), 0..8)) {
        let plain = |symbol: Symbol| Symbol { number: String::new(), remark: String::new(), ..symbol };
        let table = SymbolTable::new(symbols.into_iter().map(plain).collect());
        for format in [Format::Sdf, Format::Asc, Format::Dif] {
            let written = write(&table, Layout::new(format));
            prop_assert_eq!(&written.losses, &Vec::<String>::new());
            let again = read(FileId(0), &written.text, format);
            prop_assert_eq!(again.table.symbols(), table.symbols());
            prop_assert_eq!(write(&again.table, again.layout), written);
        }
    }

    #[test]
    fn an_assignment_list_keeps_all_but_the_types(
        symbols in proptest::collection::vec(any_symbol(), 0..8),
        addresses in proptest::collection::vec(prop::sample::select(vec!["E 1.0", "I   4.7", "DB 5", "MW  10", "VAT 3", "Z 1"]), 8),
    ) {
        let plain = |(symbol, address): (Symbol, &str)| {
            Symbol { name: symbol.name, address: address.to_owned(), comment: symbol.comment, ..Symbol::default() }
        };
        let table = SymbolTable::new(symbols.into_iter().zip(addresses).map(plain).collect());
        let written = write(&table, Layout::new(Format::Seq));
        prop_assert_eq!(&written.losses, &Vec::<String>::new());
        let again = read(FileId(0), &written.text, Format::Seq);
        prop_assert_eq!(again.table.symbols(), table.symbols());
        prop_assert_eq!(write(&again.table, again.layout), written);
    }
}

#[test]
fn no_bytes_panic() {
    let seeds: [&[u8]; 6] =
        [CSV.as_bytes(), b"126,Start", b"126,\xC4\xD6", b"\"\"\"\"", b"symbol;address\n\";;\r\r\n,", b"\xFF\xFE\x22\x00"];
    for seed in seeds {
        for end in 0..=seed.len() {
            fuzz(&seed[..end]);
            let mut changed = seed.to_vec();
            if let Some(byte) = changed.get_mut(end) {
                *byte = byte.wrapping_mul(31).wrapping_add(7);
            }
            fuzz(&changed);
        }
    }
}
