//! A program of Structured Text as a plant has it, of as many lines as wanted: the same on every run.

use std::fmt::Write as _;

/// Types, functions and blocks that every station uses.
const COMMON: &str = "TYPE Mode : (Off, Manual, Automatic, Fault); END_TYPE
TYPE Reading :
STRUCT
    raw : INT;
    value : REAL;
    low, high : REAL;
    valid : BOOL;
END_STRUCT;
END_TYPE

FUNCTION Scaled : REAL
VAR_INPUT
    raw : INT;
    low, high : REAL;
END_VAR
Scaled := INT_TO_REAL(raw) / 27648.0 * (high - low) + low;
END_FUNCTION

FUNCTION_BLOCK Motor
VAR_INPUT
    start, stop, running : BOOL;
    delay : TIME := T#500ms;
END_VAR
VAR_OUTPUT
    on, failed : BOOL;
    starts : DINT;
END_VAR
VAR
    watch : TON;
    edge : R_TRIG;
END_VAR
edge(CLK := start);
IF stop OR failed THEN
    on := FALSE;
ELSIF edge.Q THEN
    on := TRUE;
    starts := starts + 1;
END_IF;
watch(IN := on AND NOT running, PT := delay);
IF watch.Q THEN
    failed := TRUE;
END_IF;
END_FUNCTION_BLOCK

";

/// A plant of at least so many lines.
pub(crate) fn source(lines: usize) -> String {
    let mut text = COMMON.to_owned();
    let mut stations = 0;
    let mut written = COMMON.lines().count();
    while written + 4 + stations < lines {
        let station = station(stations);
        written += station.lines().count();
        text.push_str(&station);
        stations += 1;
    }
    text.push_str("PROGRAM Main\nVAR\n");
    for number in 0..stations {
        let _ = writeln!(text, "    station{number} : Station{number};");
    }
    text.push_str("END_VAR\n");
    for number in 0..stations {
        let _ = writeln!(text, "station{number}(enable := %IX{}.{});", number / 8 % 64, number % 8);
    }
    text.push_str("END_PROGRAM\n");
    text
}

/// One of its stations; no two are the same.
fn station(number: usize) -> String {
    let byte = number % 100;
    let mut text = format!(
        "FUNCTION_BLOCK Station{number}
VAR_INPUT
    enable : BOOL;
END_VAR
VAR_OUTPUT
    mode : Mode;
    done : BOOL;
END_VAR
VAR
    readings : ARRAY[0..7] OF Reading;
    motors : ARRAY[1..3] OF Motor;
    pause : TON;
    parts : CTU;
    step, i : INT;
    sum, average : REAL;
    pattern : WORD;
    text : STRING[20];
END_VAR
"
    );
    for channel in 0..8 {
        let _ = write!(
            text,
            "readings[{channel}].raw := WORD_TO_INT(%IW{});
readings[{channel}].value := Scaled(readings[{channel}].raw, {channel}.0, {}.5);
readings[{channel}].valid := readings[{channel}].raw > -500 AND readings[{channel}].raw < 28000;
",
            (byte + channel * 2) % 120,
            100 + number
        );
    }
    for motor in 1..=3 {
        let _ = write!(
            text,
            "motors[{motor}](start := step = {motor}0 AND enable, stop := NOT enable, running := %IX{byte}.{motor}, delay := T#{}ms);
%QX{byte}.{motor} := motors[{motor}].on;
",
            200 + number * 10
        );
    }
    text.push_str(
        "sum := 0.0;
FOR i := 0 TO 7 DO
    IF readings[i].valid THEN
        sum := sum + readings[i].value;
    ELSE
        pattern := pattern OR SHL(WORD#1, i);
    END_IF;
END_FOR;
average := sum / 8.0;
pause(IN := step = 5, PT := T#1s);
parts(CU := done, R := NOT enable, PV := 100);
CASE step OF
    0:
        IF enable THEN
            step := 5;
            mode := Automatic;
        END_IF;
    5:
        IF pause.Q THEN
            step := 10;
        END_IF;
",
    );
    for motor in 1..=3 {
        let _ = write!(
            text,
            "    {motor}0:
        done := FALSE;
        IF motors[{motor}].failed THEN
            mode := Fault;
            step := 90;
        ELSIF motors[{motor}].on AND (average > {}.0 OR parts.Q) THEN
            step := {};
        END_IF;
",
            motor * 20 + number % 7,
            if motor == 3 { 80 } else { motor * 10 + 10 }
        );
    }
    let _ = write!(
        text,
        "    80:
        done := TRUE;
        step := 0;
    90:
        text := CONCAT('station ', INT_TO_STRING({number}));
        IF NOT enable THEN
            step := 0;
            mode := Off;
        END_IF;
ELSE
    step := 0;
END_CASE;
WHILE pattern <> 0 AND i < 16 DO
    pattern := SHR(pattern, 1);
    i := i + 1;
END_WHILE;
END_FUNCTION_BLOCK

"
    );
    text
}
