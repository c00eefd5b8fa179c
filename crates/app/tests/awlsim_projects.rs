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
