//! Projects of awlsim (`.awlpro`) in every verb that takes a path.

mod command;

use command::Folder;

/// A project with these parts.
fn project(parts: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<awlsim_project format_version=\"1\">\n{parts}\n</awlsim_project>\n"
    )
}

/// A project as awlsim saves one: German mnemonics, four accumulators, a source inside and one beside, two symbol tables.
const WHOLE: &str = "\t<cpu>\n\t\t<specs call_stack_size=\"256\" nr_accus=\"4\" nr_counters=\"50\" nr_flags=\"300\" nr_inputs=\"64\" \
    nr_localbytes=\"1024\" nr_outputs=\"128\" nr_timers=\"40\" />\n\t\t<config clock_memory_byte=\"10\" cycle_time_limit_us=\"5000000\" \
    ext_insns_enable=\"1\" mnemonics=\"2\" ob_startinfo_enable=\"0\" />\n\t</cpu>\n\t<language_awl>\n\
    \t\t<source enabled=\"1\" name=\"Main\"><![CDATA[\nORGANIZATION_BLOCK OB 1\nBEGIN\n\tCALL\tFC 60000 ( wert := \"Zahl\", )\n\t__FEATURE 0\n\
    \t__ASSERT== __ACCU 1, 4\n\t__ASSERT== \"Ziel\", 6\n\tCALL SFC 46\nEND_ORGANIZATION_BLOCK\n]]></source>\n\
    \t\t<source enabled=\"1\" file=\"src\\more.awl\" name=\"More\" />\n\
    \t\t<source enabled=\"0\" name=\"Old\"><![CDATA[this is no program]]></source>\n\t</language_awl>\n\
    \t<language_fup><source enabled=\"1\" name=\"Diagram 1\"><![CDATA[]]></source></language_fup>\n\
    \t<symbols>\n\t\t<source enabled=\"1\" name=\"One\"><![CDATA[Zahl;MW 20;INT;eine Zahl\n]]></source>\n\
    \t\t<source enabled=\"1\" file=\"more.asc\" name=\"Two\" />\n\t</symbols>\n\
    \t<libraries><lib_selection effective_index=\"102\" index=\"2\" name=\"IEC\" type=\"FC\" /></libraries>\n\
    \t<hardware><modules /></hardware>\n\t<gui><editor /></gui>\n\t<core_link><spawn_local enable=\"1\" /></core_link>";

fn whole() -> Folder {
    let folder = Folder::new();
    folder.write("plant/plant.awlpro", project(WHOLE).as_bytes());
    folder.write(
        "plant/src/more.awl",
        b"FUNCTION FC 60000 : VOID\r\nVAR_INPUT\r\n wert : INT; // gr\xF6\xDFer\r\nEND_VAR\r\nBEGIN\r\n\tL #wert\r\n\t+ 6\r\n\tT \"Ziel\"\r\nEND_FUNCTION\r\n",
    );
    let row = format!("126,{:<24}{:<12}{:<10}{:<80}\r\n", "Ziel", "MW   22", "INT", "");
    folder.write("plant/more.asc", row.as_bytes());
    folder
}

#[test]
fn a_whole_project_opens_in_every_verb() {
    let folder = whole();
    let path = "plant/plant.awlpro";
    folder.run(&["check", path]).code(0).stdout("2 blocks in 2 sources, no errors, no warnings.");
    folder.run(&["check", "plant"]).code(0).stdout("2 blocks in 2 sources");
    folder.run(&["test", path]).code(0).stdout("ok    plant/plant.awlpro");
    folder.run(&["test", "plant"]).code(0).stdout("1 passed, 0 failed");
    folder
        .run(&["exec", path, "--set", "Zahl=1", "--show", "Ziel"])
        .code(4)
        .stderr("expected 7 (16#0007) == 6 (16#0006)")
        .stderr("plant.awlpro (Main):6");
    folder.run(&["refs", path, "Ziel"]).code(0).stdout("Ziel");
    folder.run(&["structure", path]).code(0).stdout("FC 60000");
    folder.run(&["assignments", path]).code(0);
    folder.run(&["run", path, "--for", "10ms", "--speed", "max"]).code(4);
}

#[test]
fn the_cpu_of_the_project_has_its_sizes() {
    let folder = Folder::new();
    let source = |statements: &str| {
        let sources = format!("<language_awl><source name=\"Main\"><![CDATA[{statements}]]></source></language_awl>");
        project(&format!("<cpu><specs nr_flags=\"100\" nr_timers=\"8\"/><config clock_memory_byte=\"5\"/></cpu>{sources}"))
    };
    folder.write("flags.awlpro", source("L MB 99; L MB 100").as_bytes());
    folder.run(&["check", "flags.awlpro"]).code(0).stderr("`MB 100` lies outside the 100 bytes that this area has in CPU awlsim");
    folder.write("timers.awlpro", source("U T 7; U T 8").as_bytes());
    folder.run(&["check", "timers.awlpro"]).code(0).stderr("`T 8`: CPU awlsim has timers 0 to 7");
    folder.run(&["check", "flags.awlpro", "--cpu", "416-3"]).code(0).stdout("no warnings");
    folder.write("clock.awlpro", source("L MB 5; T MB 6").as_bytes());
    folder.run(&["exec", "clock.awlpro", "--scan-at", "0ms,60ms", "--show", "MB6"]).code(0).stdout("MB6 = 16#01");
    folder.write("words.awlpro", source("__ASSERT== 1, 1").as_bytes());
    folder.run(&["check", "words.awlpro"]).code(3).stderr("P2040");
}

#[test]
fn what_is_lost_or_wrong_is_said() {
    let awl = "<language_awl><source name=\"Main\"><![CDATA[L 1]]></source></language_awl>";
    for (parts, code, expected) in [
        ("", 3, "P6005"),
        ("<language_fup><source name=\"Grid\" file=\"grid.fup\"/></language_fup>", 3, "P6043] Error: the diagram `Grid` is not compiled"),
        ("<hardware><modules><module name=\"rpigpio\"/></modules></hardware>", 0, "P6044] Warning: the module `rpigpio` is not there"),
        (
            "<libraries><lib_selection name=\"IEC\" type=\"FB\" index=\"99\"/></libraries>",
            3,
            "P6045] Error: there is no `FB 99` in the library `IEC`",
        ),
        ("<cpu><specs nr_timers=\"99999999\"/></cpu>", 3, "P6042] Error: `nr_timers` is a number from 1 to 65535, not `99999999`"),
        ("<language_awl><source name=\"A\" file=\"../secret.awl\"/></language_awl>", 3, "P6010] Error: `../secret.awl` leaves the folder"),
        ("<language_awl><source name=\"A\" file=\"/etc/passwd\"/></language_awl>", 3, "P6010"),
        ("<language_awl><source name=\"A\" file=\"C:\\secret.awl\"/></language_awl>", 3, "P6010"),
        ("<symbols><source name=\"A\" file=\"..\\secret.asc\"/></symbols>", 3, "P6010"),
        ("<language_awl><source name=\"A\" file=\"nowhere.awl\"/></language_awl>", 3, "P6001] Error: there is no file `here/nowhere.awl`"),
        ("<symbols><source name=\"A\"><![CDATA[a;MX 1;BOOL;]]></source></symbols>", 3, "P6103"),
    ] {
        let folder = Folder::new();
        folder.write("secret.awl", b"L 1\n");
        folder.write("secret.asc", b"126,\n");
        let awl = if parts.is_empty() { "" } else { awl };
        folder.write("here/plant.awlpro", project(&format!("{parts}{awl}")).as_bytes());
        folder.run(&["check", "here/plant.awlpro"]).code(code).stderr(expected);
    }
    let folder = Folder::new();
    for (content, expected) in [
        (&b"<!DOCTYPE a [<!ENTITY b \"c\">]><awlsim_project>&b;</awlsim_project>"[..], "P6040"),
        (b"\0\0\0\0", "P1101"),
        (b"not XML", "P6040"),
        (b"<svg/>", "P6041"),
    ] {
        folder.write("bad.awlpro", content);
        folder.run(&["check", "bad.awlpro"]).code(3).stderr(expected);
    }
}

#[cfg(unix)]
#[test]
fn a_link_out_of_the_folder_is_not_followed() {
    let folder = Folder::new();
    folder.write("secret.awl", b"L 1\n");
    folder.write("here/plant.awlpro", project("<language_awl><source name=\"A\" file=\"link.awl\"/></language_awl>").as_bytes());
    std::os::unix::fs::symlink("../secret.awl", folder.path().join("here/link.awl")).expect("a link can be made");
    folder.run(&["check", "here/plant.awlpro"]).code(3).stderr("P6010");
}

#[test]
fn sources_inside_a_project_are_not_written() {
    let folder = Folder::new();
    let content = project("<language_awl><source name=\"Main\"><![CDATA[ u  e 0.0\n]]></source></language_awl>");
    folder.write("plant.awlpro", content.as_bytes());
    folder.run(&["fmt", "plant.awlpro", "--write"]).code(2).stderr("P6046");
    folder.run(&["convert", "--mnemonics", "en", "plant.awlpro"]).code(0).stdout("a  i 0.0");
    assert_eq!(folder.read("plant.awlpro"), content.as_bytes());
}

#[test]
fn local_data_of_a_project_run_out() {
    let folder = Folder::new();
    let whole = |sources: &str| {
        let awl = format!("<language_awl><source name=\"Main\"><![CDATA[{sources}]]></source></language_awl>");
        project(&format!("<cpu><specs nr_localbytes=\"1024\"/></cpu>{awl}"))
    };
    let block = |head: &str, end: &str, bytes: u32, code: &str| {
        format!("{head}\nVAR_TEMP\nb : ARRAY[1..{bytes}] OF BYTE;\nEND_VAR\nBEGIN\n{code}\n{end}\n")
    };
    let fc = |number: u32, bytes: u32, code: &str| block(&format!("FUNCTION FC {number} : VOID"), "END_FUNCTION", bytes, code);
    let ob = |number: u32, bytes: u32, code: &str| block(&format!("ORGANIZATION_BLOCK OB {number}"), "END_ORGANIZATION_BLOCK", bytes, code);
    // A block with more than the CPU has for one is not loaded.
    folder.write("block.awlpro", whole(&ob(1, 1501, "NOP 0;")).as_bytes());
    folder
        .run(&["check", "block.awlpro"])
        .code(3)
        .stderr("P4025] Error: `OB 1` declares 1502 bytes of local data; CPU awlsim has 1024 for a block");
    // The sum of a priority class runs out at the call that needs too much.
    let nested = |third: u32| fc(2, third, "L 3; T MW 4;") + &fc(1, 200, "L 2; T MW 2; UC FC 2;") + &ob(1, 800, "L 1; T MW 0; UC FC 1;");
    for engine in ["jit", "interpreter"] {
        folder.write("sum.awlpro", whole(&nested(200)).as_bytes());
        folder.run(&["exec", "sum.awlpro", "--engine", engine, "--show", "MW2,MW4"]).code(4).stderr("16#4576");
        folder.write("fits.awlpro", whole(&nested(24)).as_bytes());
        folder.run(&["exec", "fits.awlpro", "--engine", engine, "--show", "MW2,MW4"]).code(0).stdout("MW4 = 16#0003");
        // OB 121 belongs to the class of the block with the error.
        let error = ob(121, 200, "L 5; T MW 6;") + &ob(1, 900, "OPN DB 99; L 1; T MW 8;");
        folder.write("error.awlpro", whole(&error).as_bytes());
        folder.run(&["exec", "error.awlpro", "--engine", engine, "--show", "MW6"]).code(4).stderr("16#4576");
        let error = ob(121, 100, "L 5; T MW 6;") + &ob(1, 900, "OPN DB 99; L 1; T MW 8;");
        folder.write("error.awlpro", whole(&error).as_bytes());
        folder.run(&["exec", "error.awlpro", "--engine", engine, "--show", "MW6,MW8"]).code(0).stdout("MW6 = 16#0005");
        // What a call needs beside the declared variables does not count.
        let call = "FUNCTION FC 3 : VOID\nVAR_INPUT\nn : DINT;\nEND_VAR\nBEGIN\nL #n; T MD 0;\nEND_FUNCTION\n".to_owned()
            + &ob(1, 1024, "CALL FC 3 (n := L#7);");
        folder.write("call.awlpro", whole(&call).as_bytes());
        folder.run(&["exec", "call.awlpro", "--engine", engine, "--show", "MD0"]).code(0).stdout("MD0 = 16#0000_0007");
    }
}

#[test]
fn a_project_says_what_it_takes_from_the_library() {
    let folder = Folder::new();
    let source =
        |parts: &str, call: &str| project(&format!("{parts}<language_awl><source name=\"A\"><![CDATA[{call}]]></source></language_awl>"));
    folder.write("none.awlpro", source("", "CALL FC 4").as_bytes());
    folder.run(&["check", "none.awlpro"]).code(3).stderr("P3008] Error: `FC 4` does not exist");
    let chosen = "<libraries><lib_selection name=\"IEC\" type=\"FC\" index=\"21\" effective_index=\"4\"/></libraries>";
    folder.write("chosen.awlpro", source(chosen, "CALL FC 4").as_bytes());
    folder.run(&["check", "chosen.awlpro"]).code(3).stderr("`LEN` of the library");
}

#[test]
fn a_refused_diagram_is_the_only_message() {
    let folder = Folder::new();
    let parts = "<language_fup><source name=\"Grid\"><![CDATA[anything]]></source></language_fup>\
                 <language_awl><source name=\"Main\"><![CDATA[CALL FC 4; U \"made by the diagram\"; CALL FC 1 (a := 1); L DB5.x]]></source></language_awl>";
    folder.write("plant.awlpro", project(parts).as_bytes());
    let ran = folder.run(&["check", "plant.awlpro"]).code(3).stderr("P6043");
    ran.stderr("1 error.");
}

#[test]
fn a_project_of_the_old_format_is_named() {
    let folder = Folder::new();
    folder.write("old.awlpro", b"[AWLSIM_PROJECT]\nfile_version=0\n[CPU]\nawl_files=a.awl\n");
    folder.run(&["check", "old.awlpro"]).code(3).stderr("awlsim-proupgrade");
}

#[test]
fn an_extended_program_may_be_empty() {
    let folder = Folder::new();
    folder.write("empty.awl", b"");
    folder.run(&["check", "empty.awl"]).code(3).stderr("P6005");
    folder.run(&["check", "empty.awl", "--extended"]).code(0);
    folder.run(&["exec", "empty.awl", "--extended", "--show", "MW0"]).code(0).stdout("MW0 = 16#0000");
}

#[test]
fn system_functions_with_negative_numbers_have_symbols() {
    let folder = Folder::new();
    let parts = "<cpu><config clock_memory_byte=\"100\" ext_insns_enable=\"1\"/></cpu>\
                 <language_awl><source name=\"Main\"><![CDATA[L MB 100; T MB 0; CALL \"CLK\"; L MB 100; T MB 1]]></source></language_awl>\
                 <symbols><source name=\"S\"><![CDATA[CLK;SFC -4;SFC -4;]]></source></symbols>";
    folder.write("clock.awlpro", project(parts).as_bytes());
    // The clock memory is 0 at once, and begins anew.
    folder.run(&["exec", "clock.awlpro", "--scan-at", "0ms,60ms", "--show", "MB0,MB1"]).code(0).stdout("MB0 = 16#01").stdout("MB1 = 16#00");
    folder.write("wrong.awlpro", project(&parts.replace("SFC -4;SFC", "SFC -5;SFC")).as_bytes());
    folder.run(&["check", "wrong.awlpro"]).code(3).stderr("P6103");
    folder.write("plant.awl", b"CALL \"CLK\"\n");
    folder.write("plant.csv", b"symbol,address\nCLK,SFC-4\n");
    folder.run(&["check", "plant.awl", "plant.csv", "--extended"]).code(0);
    folder.run(&["check", "plant.awl", "plant.csv"]).code(3).stderr("P2040");
}

#[test]
fn four_accumulators_start_cold_in_the_profile() {
    let folder = Folder::new();
    let project = |accumulators: u32| {
        let block =
            |number: u32, value: u32| format!("ORGANIZATION_BLOCK OB {number}\nBEGIN\nL {value}; T MW 0;\nEND_ORGANIZATION_BLOCK\n");
        let sources = block(102, 5) + &block(100, 6) + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNOP 0;\nEND_ORGANIZATION_BLOCK\n";
        let awl = format!("<language_awl><source name=\"Main\"><![CDATA[{sources}]]></source></language_awl>");
        project(&format!("<cpu><specs nr_accus=\"{accumulators}\"/></cpu>{awl}"))
    };
    for (accumulators, profile, expected) in [(4, "awlsim", "16#0005"), (4, "siemens", "16#0006"), (2, "awlsim", "16#0006")] {
        folder.write("start.awlpro", project(accumulators).as_bytes());
        folder.run(&["exec", "start.awlpro", "--profile", profile, "--show", "MW0"]).code(0).stdout(&format!("MW0 = {expected}"));
    }
}
