//! Files of TwinCAT and exports of CoDeSys 2.3, what is read of them, and that bad ones do no harm.

use super::*;

const POU: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject Version="1.1.0.1" ProductVersion="3.1.4024.0">
  <POU Name="FB_Pump" Id="{1}" SpecialFunc="None">
    <Declaration><![CDATA[(* Ein Gerät *)
{attribute 'x'}
FUNCTION_BLOCK FB_Pump
VAR n : INT; END_VAR
]]></Declaration>
    <Implementation>
      <ST><![CDATA[n := n + 1;]]></ST>
    </Implementation>
    <Action Name="Reset" Id="{2}">
      <Implementation>
        <ST><![CDATA[n := 0;]]></ST>
      </Implementation>
    </Action>
    <Method Name="Twice" Id="{3}">
      <Declaration><![CDATA[METHOD Twice : INT
]]></Declaration>
      <Implementation>
        <ST><![CDATA[Twice := n * 2;]]></ST>
      </Implementation>
    </Method>
    <Property Name="Count" Id="{4}">
      <Declaration><![CDATA[PROPERTY Count : INT]]></Declaration>
      <Get Name="Get" Id="{5}">
        <Declaration><![CDATA[]]></Declaration>
        <Implementation>
          <ST><![CDATA[Count := n;]]></ST>
        </Implementation>
      </Get>
    </Property>
  </POU>
</TcPlcObject>
"#;

/// The words of what is read.
fn words(name: &str, text: &str) -> String {
    let read = read(FileId::default(), name, text).expect("such a file");
    let text = read.text.split_whitespace().collect::<Vec<_>>().join(" ");
    let told: Vec<&str> = read.diagnostics.iter().map(|one| one.problem.code()).collect();
    [told, vec![text.as_str()]].concat().join(" ")
}

#[test]
fn a_block_of_twincat_is_read_with_its_members_where_they_lie() {
    let expected = "(* Ein Gerät *) {attribute 'x'} FUNCTION_BLOCK FB_Pump VAR n : INT; END_VAR n := n + 1; ACTION Reset: n := 0; END_ACTION \
        METHOD Twice : INT Twice := n * 2; END_METHOD PROPERTY Count : INT GET Count := n; END_GET END_PROPERTY END_FUNCTION_BLOCK";
    assert_eq!(words("FB_Pump.TcPOU", POU), expected);
    // Without any space between the elements there is room as well.
    let tight: String = POU.lines().map(|line| if line.starts_with("  ") { line.trim().to_owned() } else { format!("{line}\n") }).collect();
    let together = |text: &str| text.replace(' ', "");
    assert_eq!(together(&words("FB_Pump.TcPOU", &tight)), together(expected));
    let read = read(FileId::default(), "FB_Pump.TcPOU", POU).expect("such a file");
    for part in ["n := n + 1;", "Twice := n * 2;", "Count := n;", "n := 0;"] {
        assert_eq!(read.text.find(part), POU.find(part), "{part}");
    }
}

#[test]
fn what_is_no_structured_text_of_twincat_is_said_once() {
    let diagram = POU.replace("<ST><![CDATA[n := n + 1;]]></ST>", "<NWL><XmlArchive/></NWL>");
    assert!(words("a.TcPOU", &diagram).starts_with("P6078 (* Ein"));
    assert_eq!(words("a.TcPOU", "<TcPlcObject><Visu/></TcPlcObject>"), "P6079 ");
    assert_eq!(words("a.TcPOU", "<TcPlcObject><POU>"), "P6077 ");
    assert_eq!(words("a.TcPOU", "<!DOCTYPE a [<!ENTITY b SYSTEM \"/etc/passwd\">]><TcPlcObject>&b;</TcPlcObject>"), "P6077 ");
    let deep = format!("<TcPlcObject>{}{}</TcPlcObject>", "<a>".repeat(50_000), "</a>".repeat(50_000));
    assert!(words("a.TcPOU", &deep).starts_with("P60"));
    assert_eq!(
        words("a.TcDUT", "<TcPlcObject><DUT><Declaration>TYPE T : INT; END_TYPE</Declaration></DUT></TcPlcObject>"),
        "TYPE T : INT; END_TYPE"
    );
    assert_eq!(words("a.TcDUT", "<TcPlcObject><DUT><Declaration>a &lt; b</Declaration></DUT></TcPlcObject>"), "P6077 ");
}

#[test]
fn an_export_is_read_without_its_sections_and_diagrams() {
    let text = "(* @NESTEDCOMMENTS := 'Yes' *)\n(* @PATH := '' *)\nPROGRAM A\nVAR\nx : INT;\nEND_VAR\n(* @END_DECLARATION := '0' *)\n_FBD_BODY\n\
        _NETWORKS : 1\n_NETWORK\nEND_PROGRAM\nFUNCTION F : INT\nF := 1;\nEND_FUNCTION\n(* a comment\nLIBRARY\n*)\nLIBRARY\nStandard.lib 2.3\n\
        NumOfPOUs: 1\nEND_LIBRARY\nPLC_CONFIGURATION\n_GLOBAL\nPLC_END\nVAR_GLOBAL\ny : INT;\nEND_VAR\n";
    let expected = "P6078 (* @NESTEDCOMMENTS := 'Yes' *) (* @PATH := '' *) PROGRAM A VAR x : INT; END_VAR (* @END_DECLARATION := '0' *) END_PROGRAM \
        FUNCTION F : INT F := 1; END_FUNCTION (* a comment LIBRARY *) VAR_GLOBAL y : INT; END_VAR";
    assert_eq!(words("a.exp", text), expected);
    assert_eq!(read(FileId::default(), "a.exp", "PROGRAM A\nEND_PROGRAM\n").map(|read| read.text), None);
}

#[test]
fn no_cut_and_no_exchange_of_bytes_panics() {
    for at in 0..POU.len() {
        fuzz(&POU.as_bytes()[..at]);
        for other in [b'<', b'>', b'&', b'"', 0xFF, b']', b'/'] {
            let mut changed = POU.as_bytes().to_vec();
            changed[at] = other;
            fuzz(&changed);
        }
    }
}
