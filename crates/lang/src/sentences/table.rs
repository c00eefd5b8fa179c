//! All sentences, in English and German, with what is filled in between braces.

use super::Language;

macro_rules! sentences {
    ($($(#[doc = $doc:literal])* $Name:ident { en: $en:literal, de: $de:literal })*) => {
        /// A sentence, or a part of one, that says why a statement did what it did.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Sentence {
            $($(#[doc = $doc])* $Name,)*
        }

        impl Sentence {
            /// All of them, by chapter.
            pub const ALL: &[Self] = &[$(Self::$Name),*];
            /// The sentence in a language, with the names of what is filled in between braces.
            pub fn template(self, language: Language) -> &'static str {
                match (self, language) {
                    $((Self::$Name, Language::English) => $en, (Self::$Name, Language::German) => $de,)*
                }
            }
        }
    };
}

sentences! {

// Bit logic. {scan} is "the input I 0.1 is 1, inverted 0".
/// The first scan of a logic string.
ScanFirst { en: "{scan} and begins a logic string, so the RLO becomes {rlo}", de: "{scan} und beginnt eine Verknüpfungskette, also wird das VKE {rlo}" }
/// Both are 1.
AndOne { en: "{scan} and the RLO was 1, so the RLO stays 1", de: "{scan} und das VKE war 1, also bleibt das VKE 1" }
/// The bit makes the RLO 0.
AndBreaks { en: "{scan}, so the RLO becomes 0", de: "{scan}, also wird das VKE 0" }
/// The RLO was 0 before.
AndZero { en: "the RLO was 0 already, so it stays 0; {scan}", de: "das VKE war schon 0, also bleibt es 0; {scan}" }
/// The left side of an AND before OR is 1.
AndBehindOr { en: "what stands before the `O` gave 1 already, so the RLO {rlo_turns}; {scan}", de: "was vor dem `O` steht, ergab schon 1, also {rlo_turns_inverted}; {scan}" }
/// The bit makes the RLO 1.
OrMakes { en: "{scan}, so the RLO becomes 1", de: "{scan}, also wird das VKE 1" }
/// The RLO was 1 before.
OrKeeps { en: "the RLO was 1 already, so it stays 1; {scan}", de: "das VKE war schon 1, also bleibt es 1; {scan}" }
/// Both are 0.
OrNone { en: "{scan} and the RLO was 0, so the RLO stays 0", de: "{scan} und das VKE war 0, also bleibt das VKE 0" }
/// The two differ.
XorDiffers { en: "{scan} and the RLO was {rlo_before}; they differ, so the RLO {rlo_turns}", de: "{scan} und das VKE war {rlo_before}; sie sind verschieden, also {rlo_turns_inverted}" }
/// The two are the same.
XorEqual { en: "{scan} and the RLO was {rlo_before}; they are equal, so the RLO {rlo_turns}", de: "{scan} und das VKE war {rlo_before}; sie sind gleich, also {rlo_turns_inverted}" }
/// `O` with RLO 1.
OrSeparatorOne { en: "the RLO is 1 and kept in OR: the AND string that follows cannot change the result any more", de: "das VKE ist 1 und wird in OR gemerkt: Die folgende UND-Kette kann das Ergebnis nicht mehr ändern" }
/// `O` with RLO 0.
OrSeparatorZero { en: "the RLO is 0, so the AND string that follows decides alone", de: "das VKE ist 0, also entscheidet die folgende UND-Kette allein" }
/// `O` at the beginning.
OrSeparatorEmpty { en: "no logic string is open, so there is nothing to join: the next scan begins one", de: "keine Verknüpfungskette ist offen, also gibt es nichts zu verknüpfen: Die nächste Abfrage beginnt eine" }
/// `A(` inside a string.
Open { en: "the RLO {rlo_before} is put aside; the bracket computes a result of its own, which `)` joins by {joint}", de: "das VKE {rlo_before} wird zurückgelegt; die Klammer berechnet ein eigenes Ergebnis, das `)` mit {joint} verknüpft" }
/// `A(` at the beginning.
OpenFirst { en: "the bracket begins a logic string; what it computes becomes the RLO at `)`{inverted_later}", de: "die Klammer beginnt eine Verknüpfungskette; was sie berechnet, wird bei `)`{inverted_later} das VKE" }
/// `)` of a bracket at the beginning.
CloseFirst { en: "{inner} and began the logic string, so the RLO {rlo_turns}", de: "{inner} und begann die Verknüpfungskette, also {rlo_turns_inverted}" }
/// `)` inside a string.
Close { en: "{inner} and the RLO before it was {saved}; joined by {joint} they make the RLO {rlo}", de: "{inner} und das VKE davor war {saved}; mit {joint} verknüpft ergeben sie das VKE {rlo}" }
/// `)` behind an `O` whose left side was 1.
CloseBehindOr { en: "what stands before the `O` gave 1 already, so the RLO is 1; {inner}", de: "was vor dem `O` steht, ergab schon 1, also ist das VKE 1; {inner}" }
/// `=`.
Assign { en: "the RLO is {rlo}, so {operand} becomes {bit}", de: "das VKE ist {rlo}, also wird {operand} {bit}" }
/// `=` in a zone that is switched off.
AssignMcr { en: "the MCR zone is switched off, so {operand} becomes 0 whatever the RLO is ({rlo})", de: "die MCR-Zone ist abgeschaltet, also wird {operand} 0, gleich was das VKE ist ({rlo})" }
/// `S` with RLO 1.
SetOne { en: "the RLO is 1, so {operand} is set to 1", de: "das VKE ist 1, also wird {operand} auf 1 gesetzt" }
/// `R` with RLO 1.
ResetOne { en: "the RLO is 1, so {operand} is reset to 0", de: "das VKE ist 1, also wird {operand} auf 0 zurückgesetzt" }
/// `S` or `R` with RLO 0.
SetNothing { en: "the RLO is 0, so nothing is written: {operand} stays {bit}", de: "das VKE ist 0, also wird nichts geschrieben: {operand} bleibt {bit}" }
/// `S` or `R` in a zone that is switched off.
SetMcr { en: "the MCR zone is switched off, so nothing is written: {operand} stays {bit}", de: "die MCR-Zone ist abgeschaltet, also wird nichts geschrieben: {operand} bleibt {bit}" }
/// `NOT`.
Not { en: "the RLO was {rlo_before}, so inverted it becomes {rlo}", de: "das VKE war {rlo_before}, also wird es negiert {rlo}" }
/// `SET`, `CLR`.
ConstantRlo { en: "the RLO becomes {rlo} unconditionally; the next scan begins a new logic string", de: "das VKE wird ohne Bedingung {rlo}; die nächste Abfrage beginnt eine neue Verknüpfungskette" }
/// `SAVE`.
Save { en: "the RLO {rlo} is kept in BR", de: "das VKE {rlo} wird im BIE gesichert" }
/// `FP` with an edge.
RisingEdge { en: "{operand} kept 0 from the last time and the RLO is 1 now: a rising edge, so the RLO stays 1", de: "{operand} merkte sich vom letzten Mal 0 und das VKE ist jetzt 1: eine steigende Flanke, also bleibt das VKE 1" }
/// `FP` with RLO 1 as before.
RisingSame { en: "{operand} kept 1 from the last time and the RLO is still 1: no rising edge, so the RLO becomes 0", de: "{operand} merkte sich vom letzten Mal 1 und das VKE ist noch 1: keine steigende Flanke, also wird das VKE 0" }
/// `FP` with RLO 0.
RisingLow { en: "the RLO is 0, so there is no rising edge; {operand} keeps 0 for the next time", de: "das VKE ist 0, also keine steigende Flanke; {operand} merkt sich 0 für das nächste Mal" }
/// `FN` with an edge.
FallingEdge { en: "{operand} kept 1 from the last time and the RLO is 0 now: a falling edge, so the RLO becomes 1", de: "{operand} merkte sich vom letzten Mal 1 und das VKE ist jetzt 0: eine fallende Flanke, also wird das VKE 1" }
/// `FN` with RLO 0 as before.
FallingSame { en: "{operand} kept 0 from the last time and the RLO is still 0: no falling edge, so the RLO stays 0", de: "{operand} merkte sich vom letzten Mal 0 und das VKE ist noch 0: keine fallende Flanke, also bleibt das VKE 0" }
/// `FN` with RLO 1.
FallingHigh { en: "the RLO is 1, so there is no falling edge: the RLO becomes 0; {operand} keeps 1 for the next time", de: "das VKE ist 1, also keine fallende Flanke: Das VKE wird 0; {operand} merkt sich 1 für das nächste Mal" }

// MCR.
/// `MCRA`.
McrActivate { en: "from here on MCR zones have an effect in this block", de: "ab hier wirken MCR-Zonen in diesem Baustein" }
/// `MCRD`.
McrDeactivate { en: "from here on MCR zones have no effect in this block", de: "ab hier wirken MCR-Zonen in diesem Baustein nicht mehr" }
/// `MCR(` with RLO 1.
McrOpenOn { en: "the RLO is 1, so the MCR zone is switched on: statements in it work as usual", de: "das VKE ist 1, also ist die MCR-Zone eingeschaltet: Anweisungen darin wirken wie sonst" }
/// `MCR(` with RLO 0.
McrOpenOff { en: "the RLO is 0, so the MCR zone is switched off: in it `=` and `T` write 0, `S` and `R` nothing", de: "das VKE ist 0, also ist die MCR-Zone abgeschaltet: Darin schreiben `=` und `T` 0, `S` und `R` nichts" }
/// `MCR(` without `MCRA`.
McrNotActive { en: "the MCR is not active here (no MCRA), so the zone has no effect", de: "das MCR ist hier nicht aktiv (kein MCRA), also wirkt die Zone nicht" }
/// `)MCR`.
McrClose { en: "the newest MCR zone ends; {zones} still open", de: "die neueste MCR-Zone endet; noch offen: {zones}" }

// Load and transfer.
/// `L` of a variable.
LoadMemory { en: "{operand} holds {value}, which comes into ACCU 1; ACCU 2 takes the old ACCU 1, {accu1_before}", de: "{operand} enthält {value}, das kommt in AKKU 1; AKKU 2 übernimmt den alten AKKU 1, {accu1_before}" }
/// `L` of a constant.
LoadConstant { en: "the constant {value} comes into ACCU 1; ACCU 2 takes the old ACCU 1, {accu1_before}", de: "die Konstante {value} kommt in AKKU 1; AKKU 2 übernimmt den alten AKKU 1, {accu1_before}" }
/// `L` of a timer.
LoadTimer { en: "{operand} has {value} steps of its time base left, which come into ACCU 1; ACCU 2 takes the old ACCU 1, {accu1_before}", de: "{operand} hat noch {value} Schritte seiner Zeitbasis, die kommen in AKKU 1; AKKU 2 übernimmt den alten AKKU 1, {accu1_before}" }
/// `L` of a counter.
LoadCounter { en: "{operand} is at {value}, which comes into ACCU 1; ACCU 2 takes the old ACCU 1, {accu1_before}", de: "{operand} steht auf {value}, das kommt in AKKU 1; AKKU 2 übernimmt den alten AKKU 1, {accu1_before}" }
/// `L __ACCU 2` and its like.
LoadRegister { en: "the register holds {value}, which comes into ACCU 1; ACCU 2 takes the old ACCU 1, {accu1_before}", de: "das Register enthält {value}, das kommt in AKKU 1; AKKU 2 übernimmt den alten AKKU 1, {accu1_before}" }
/// `L P##x`.
LoadParameterAddress { en: "the caller gave the pointer {value}, which comes into ACCU 1; ACCU 2 takes the old ACCU 1, {accu1_before}", de: "der Aufrufer gab den Zeiger {value}, der kommt in AKKU 1; AKKU 2 übernimmt den alten AKKU 1, {accu1_before}" }
/// `L STW`.
LoadStatusWord { en: "the status word is {value} (BR CC1 CC0 OV OS OR STA RLO /FC as far as the CPU tells); it comes into ACCU 1", de: "das Statuswort ist {value} (BIE A1 A0 OV OS OR STA VKE /ER, soweit die CPU es hergibt); es kommt in AKKU 1" }
/// `L DBNO`.
LoadNumber { en: "the open block of the {register} register is DB {value}; the number comes into ACCU 1", de: "der offene Baustein im {register}-Register ist DB {value}; die Nummer kommt in AKKU 1" }
/// `L DBLG`.
LoadLength { en: "the open block of the {register} register has {value} bytes; the number comes into ACCU 1", de: "der offene Baustein im {register}-Register hat {value} Bytes; die Zahl kommt in AKKU 1" }
/// The same without a block.
LoadNoBlock { en: "no block is open in the {register} register, so ACCU 1 becomes 0", de: "im {register}-Register ist kein Baustein offen, also wird AKKU 1 0" }
/// `LC` of a timer.
LoadTimerBcd { en: "{operand} has {value} left, which comes into ACCU 1 with its time base as BCD digits", de: "{operand} läuft noch {value}, das kommt mit der Zeitbasis in BCD-Ziffern in AKKU 1" }
/// `LC` of a counter.
LoadCounterBcd { en: "{operand} is at {value}, which comes into ACCU 1 as BCD digits", de: "{operand} steht auf {value}, das kommt in BCD-Ziffern in AKKU 1" }
/// `T`.
Transfer { en: "{operand} takes {value} from ACCU 1", de: "{operand} übernimmt {value} aus AKKU 1" }
/// `T` in a zone that is switched off.
TransferMcr { en: "the MCR zone is switched off, so {operand} becomes 0 instead of {value}", de: "die MCR-Zone ist abgeschaltet, also wird {operand} 0 statt {value}" }
/// `T STW`.
TransferStatusWord { en: "the status bits take the low bits of ACCU 1, {value}; the RLO is {rlo}", de: "die Statusbits übernehmen die unteren Bits von AKKU 1, {value}; das VKE ist {rlo}" }

// Address registers and accumulators.
/// `LAR1`.
LoadPointer { en: "{register} takes {value} from ACCU 1", de: "{register} übernimmt {value} aus AKKU 1" }
/// `LAR1 MD 4`.
LoadPointerFrom { en: "{register} takes {value} from {source}", de: "{register} übernimmt {value} von {source}" }
/// `TAR1`.
StorePointer { en: "ACCU 1 takes {value} from {register}; ACCU 2 takes the old ACCU 1, {accu1_before}", de: "AKKU 1 übernimmt {value} aus {register}; AKKU 2 übernimmt den alten AKKU 1, {accu1_before}" }
/// `TAR1 MD 4`.
StorePointerTo { en: "{source} takes {value} from {register}", de: "{source} übernimmt {value} aus {register}" }
/// `CAR`.
SwapPointers { en: "AR1 and AR2 change places: AR1 is {ar1} and AR2 is {ar2} now", de: "AR1 und AR2 tauschen: AR1 ist jetzt {ar1} und AR2 {ar2}" }
/// `+AR1`.
AddPointer { en: "{register} was {before}, so with {offset} added it becomes {value}", de: "{register} war {before}, also wird es mit {offset} dazu {value}" }
/// `TAK`.
Swap { en: "ACCU 1 and ACCU 2 change places: ACCU 1 is {accu1} and ACCU 2 is {accu2} now", de: "AKKU 1 und AKKU 2 tauschen: AKKU 1 ist jetzt {accu1} und AKKU 2 {accu2}" }
/// `PUSH`.
Push { en: "ACCU 2 takes {accu1} from ACCU 1, which keeps it", de: "AKKU 2 übernimmt {accu1} aus AKKU 1, der es behält" }
/// `POP`.
Pop { en: "ACCU 1 takes {accu1} from ACCU 2", de: "AKKU 1 übernimmt {accu1} aus AKKU 2" }
/// `ENT`.
Enter { en: "ACCU 4 takes {accu4} from ACCU 3, and ACCU 3 takes {accu3} from ACCU 2", de: "AKKU 4 übernimmt {accu4} aus AKKU 3, und AKKU 3 übernimmt {accu3} aus AKKU 2" }
/// `LEAVE`.
Leave { en: "ACCU 2 takes {accu2} from ACCU 3, and ACCU 3 takes {accu3} from ACCU 4", de: "AKKU 2 übernimmt {accu2} aus AKKU 3, und AKKU 3 übernimmt {accu3} aus AKKU 4" }
/// `ENT` and `LEAVE` where nothing moves.
TwoAccumulators { en: "this CPU has two accumulators, so nothing moves", de: "diese CPU hat zwei Akkumulatoren, also bewegt sich nichts" }
/// `CAW`, `CAD`.
SwapBytes { en: "the bytes of {before} change places: ACCU 1 is {accu1} now", de: "die Bytes von {before} tauschen: AKKU 1 ist jetzt {accu1}" }
/// `INC`, `DEC`.
Step { en: "{a} {sign} {b} = {result} in the low byte of ACCU 1; the other bytes stay, without a carry", de: "{a} {sign} {b} = {result} im unteren Byte von AKKU 1; die anderen Bytes bleiben, ohne Übertrag" }

// Calculations.
/// `+ 5`.
AddConstant { en: "{a} + {b} = {result}; ACCU 1 takes it, the status bits stay", de: "{a} + {b} = {result}; AKKU 1 übernimmt es, die Statusbits bleiben" }
/// Two numbers and what comes of them.
Calculate { en: "{a} {sign} {b} = {result}", de: "{a} {sign} {b} = {result}" }
/// `/I`.
DivideInt { en: "{a} / {b} = {result}, remainder {remainder} (in the high word of ACCU 1)", de: "{a} / {b} = {result}, Rest {remainder} (im oberen Wort von AKKU 1)" }
/// A division by 0.
DivideByZero { en: "{a} is to be divided by 0, which has no result: OV, OS, CC 1 and CC 0 become 1, ACCU 1 stays", de: "{a} soll durch 0 geteilt werden, das hat kein Ergebnis: OV, OS, A1 und A0 werden 1, AKKU 1 bleibt" }
/// A result above 0.
Positive { en: "above 0, so CC 1 is 1 and CC 0 is 0", de: "größer als 0, also A1 = 1 und A0 = 0" }
/// A result below 0.
Negative { en: "below 0, so CC 1 is 0 and CC 0 is 1", de: "kleiner als 0, also A1 = 0 und A0 = 1" }
/// A result that is 0.
Zero { en: "zero, so CC 1 and CC 0 are 0", de: "null, also A1 = 0 und A0 = 0" }
/// A result that does not fit.
TooLarge { en: "that does not fit {bits} bits, so OV and OS become 1; ACCU 1 holds {value}, CC 1 = {cc1} and CC 0 = {cc0}", de: "das passt nicht in {bits} Bit, also werden OV und OS 1; AKKU 1 enthält {value}, A1 = {cc1} und A0 = {cc0}" }
/// A REAL result that is no number.
RealNone { en: "that is no number, so OV, OS, CC 1 and CC 0 become 1", de: "das ist keine Zahl, also werden OV, OS, A1 und A0 1" }
/// An infinite REAL result.
RealInfinite { en: "that is too large for a REAL, so OV and OS become 1; CC 1 = {cc1} and CC 0 = {cc0}", de: "das ist zu groß für REAL, also werden OV und OS 1; A1 = {cc1} und A0 = {cc0}" }
/// A REAL result too near to 0.
RealTiny { en: "that is too near to 0 for a REAL, so OV and OS become 1; CC 1 = {cc1} and CC 0 = {cc0}", de: "das liegt für REAL zu nahe bei 0, also werden OV und OS 1; A1 = {cc1} und A0 = {cc0}" }
/// `NEGI` and its like.
Negate { en: "{a} with its sign changed is {result}", de: "{a} mit anderem Vorzeichen ist {result}" }
/// `INVI`, `INVD`.
Invert { en: "all bits of {a} inverted are {result}", de: "alle Bits von {a} negiert sind {result}" }
/// `SQRT` and its like.
Function { en: "{function}({a}) = {result}", de: "{function}({a}) = {result}" }

// Conversions.
/// `BTI`, `BTD`.
FromBcd { en: "the BCD number {a} is the integer {result}", de: "die BCD-Zahl {a} ist die ganze Zahl {result}" }
/// `ITB`, `DTB`.
ToBcd { en: "the integer {a} is the BCD number {result}, so OV is 0", de: "die ganze Zahl {a} ist die BCD-Zahl {result}, also ist OV 0" }
/// The same beyond the digits.
ToBcdTooLarge { en: "{a} does not fit {digits} decimal digits, so OV and OS become 1 and ACCU 1 stays", de: "{a} passt nicht in {digits} Dezimalziffern, also werden OV und OS 1 und AKKU 1 bleibt" }
/// `ITD`.
Widen { en: "{a} fills 32 bits with its sign: ACCU 1 is {accu1}", de: "{a} füllt mit seinem Vorzeichen 32 Bit: AKKU 1 ist {accu1}" }
/// `DTR`.
ToReal { en: "the integer {a} is the REAL {result}", de: "die ganze Zahl {a} ist die REAL-Zahl {result}" }
/// `RND` and its like.
Round { en: "{a} {rounding} is {result}", de: "{a} {rounding} ist {result}" }
/// The same beyond 32 bits.
RoundTooLarge { en: "{a} is no 32-bit integer, so OV and OS become 1 and ACCU 1 stays", de: "{a} ist keine ganze Zahl von 32 Bit, also werden OV und OS 1 und AKKU 1 bleibt" }

// Shift, rotate, word logic.
/// `SLW` and its like.
Shift { en: "{a} shifted {way} by {count} is {result}; zeros came in, the last bit moved out was {cc1}, which CC 1 tells", de: "{a} um {count} nach {way} geschoben ist {result}; Nullen kamen nach, das zuletzt hinausgeschobene Bit war {cc1}, das sagt A1" }
/// `SSI`, `SSD`.
ShiftSigned { en: "{a} shifted right by {count} is {result}; the sign came in, the last bit moved out was {cc1}, which CC 1 tells", de: "{a} um {count} nach rechts geschoben ist {result}; das Vorzeichen kam nach, das zuletzt hinausgeschobene Bit war {cc1}, das sagt A1" }
/// A count of 0.
ShiftNothing { en: "the count is 0, so nothing changes, no status bit either", de: "die Anzahl ist 0, also ändert sich nichts, auch kein Statusbit" }
/// `RLD`, `RRD`.
Rotate { en: "{a} rotated {way} by {count} is {result}; the last bit that came round was {cc1}, which CC 1 tells", de: "{a} um {count} nach {way} rotiert ist {result}; das zuletzt herumgekommene Bit war {cc1}, das sagt A1" }
/// `RLDA`, `RRDA`.
RotateThrough { en: "{a} rotated {way} by one bit through CC 1 ({cc1_before}) is {result}; the bit that left it is in CC 1 now: {cc1}", de: "{a} um ein Bit durch A1 ({cc1_before}) nach {way} rotiert ist {result}; das Bit, das herausfiel, steht jetzt in A1: {cc1}" }
/// A result of word logic that is not 0.
WordLogicSome { en: "{a} {joint} {b} = {result}; that is not 0, so CC 1 is 1", de: "{a} {joint} {b} = {result}; das ist nicht 0, also A1 = 1" }
/// A result of word logic that is 0.
WordLogicNone { en: "{a} {joint} {b} = {result}, so CC 1 is 0", de: "{a} {joint} {b} = {result}, also A1 = 0" }

// Comparisons.
/// The relation holds.
CompareTrue { en: "ACCU 2 ({a}) {relation} ACCU 1 ({b}), so the RLO becomes 1", de: "AKKU 2 ({a}) {relation} AKKU 1 ({b}), also wird das VKE 1" }
/// It does not.
CompareFalse { en: "ACCU 2 ({a}) {relation_not} ACCU 1 ({b}), so the RLO becomes 0", de: "AKKU 2 ({a}) {relation_not} AKKU 1 ({b}), also wird das VKE 0" }
/// One of them is no number.
CompareNone { en: "{a} and {b} cannot be compared, because one is no number: the RLO becomes 0, OV, OS, CC 1 and CC 0 become 1", de: "{a} und {b} lassen sich nicht vergleichen, denn eine davon ist keine Zahl: Das VKE wird 0, OV, OS, A1 und A0 werden 1" }
/// A CPU that compares by the difference.
CompareDifference { en: "{a} is compared with {b} by the condition codes of their difference, so the RLO becomes {rlo}", de: "{a} wird mit {b} über die Anzeigen ihrer Differenz verglichen, also wird das VKE {rlo}" }

// Jumps.
/// `JU`.
Jump { en: "jumps to {label} unconditionally", de: "springt ohne Bedingung zu {label}" }
/// A jump by the RLO, taken.
JumpRlo { en: "the RLO is {rlo_before}, so it jumps to {label}{saved}", de: "das VKE ist {rlo_before}, also springt es zu {label}{saved}" }
/// A jump by the RLO, not taken.
StayRlo { en: "the RLO is {rlo_before}, so it does not jump to {label}{saved}; the RLO is 1 behind it", de: "das VKE ist {rlo_before}, also springt es nicht zu {label}{saved}; dahinter ist das VKE 1" }
/// A jump by BR, taken.
JumpBr { en: "BR is {br}, so it jumps to {label}", de: "das BIE ist {br}, also springt es zu {label}" }
/// A jump by BR, not taken.
StayBr { en: "BR is {br}, so it does not jump to {label}", de: "das BIE ist {br}, also springt es nicht zu {label}" }
/// `JO`, taken.
JumpOv { en: "OV is 1 (the last calculation left its range), so it jumps to {label}", de: "OV ist 1 (die letzte Rechnung verließ ihren Bereich), also springt es zu {label}" }
/// `JO`, not taken.
StayOv { en: "OV is 0, so it does not jump to {label}", de: "OV ist 0, also springt es nicht zu {label}" }
/// `JOS`, taken.
JumpOs { en: "OS is 1 (some calculation left its range), so it jumps to {label}; OS becomes 0", de: "OS ist 1 (eine Rechnung verließ ihren Bereich), also springt es zu {label}; OS wird 0" }
/// `JOS`, not taken.
StayOs { en: "OS is 0, so it does not jump to {label}", de: "OS ist 0, also springt es nicht zu {label}" }
/// A jump by the condition codes, taken.
JumpStatus { en: "CC 1 = {cc1} and CC 0 = {cc0} say {status}, so it jumps to {label}", de: "A1 = {cc1} und A0 = {cc0} heißt {status}, also springt es zu {label}" }
/// A jump by the condition codes, not taken.
StayStatus { en: "CC 1 = {cc1} and CC 0 = {cc0} say {status}, so it does not jump to {label}", de: "A1 = {cc1} und A0 = {cc0} heißt {status}, also springt es nicht zu {label}" }
/// `JL` with an entry.
JumpList { en: "the low byte of ACCU 1 is {value}, so it takes the jump with this number of the list, counted from 0: {label}", de: "das untere Byte von AKKU 1 ist {value}, also nimmt es den Sprung mit dieser Nummer aus der Liste, von 0 gezählt: {label}" }
/// `JL` without an entry.
JumpListBeyond { en: "the low byte of ACCU 1 is {value}, but the list ends at {last}, so it jumps to {label}", de: "das untere Byte von AKKU 1 ist {value}, aber die Liste endet bei {last}, also springt es zu {label}" }
/// `LOOP` that goes on.
LoopAgain { en: "{a} - 1 = {result} in the low word of ACCU 1, which is not 0, so it jumps to {label}", de: "{a} - 1 = {result} im unteren Wort von AKKU 1, das ist nicht 0, also springt es zu {label}" }
/// `LOOP` that ends.
LoopEnds { en: "{a} - 1 = 0 in the low word of ACCU 1, so the loop is over: it does not jump to {label}", de: "{a} - 1 = 0 im unteren Wort von AKKU 1, also ist die Schleife zu Ende: kein Sprung zu {label}" }

// Calls and block ends.
/// A call without parameters.
Call { en: "calls {block}", de: "ruft {block} auf" }
/// A call with parameters.
CallWith { en: "calls {block} with {parameters}", de: "ruft {block} auf mit {parameters}" }
/// `CC`, taken.
CallRlo { en: "the RLO is 1, so it calls {block}", de: "das VKE ist 1, also ruft es {block} auf" }
/// `CC`, not taken.
CallNot { en: "the RLO is 0, so {block} is not called; the RLO is 1 behind it", de: "das VKE ist 0, also wird {block} nicht aufgerufen; dahinter ist das VKE 1" }
/// The end of a called block.
End { en: "the block ends; {block}, which called it, goes on", de: "der Baustein endet; {block}, der ihn aufrief, geht weiter" }
/// The end of the outermost block.
EndOuter { en: "the block ends, and with it what the CPU started it for", de: "der Baustein endet, und damit das, wofür die CPU ihn startete" }
/// The end of a block that interrupted another one.
EndInterrupt { en: "the block ends; {block}, which it interrupted, goes on", de: "der Baustein endet; {block}, den er unterbrach, geht weiter" }
/// `BEC`, taken.
EndRlo { en: "the RLO is 1, so the block ends here", de: "das VKE ist 1, also endet der Baustein hier" }
/// `BEC`, not taken.
EndNot { en: "the RLO is 0, so the block goes on; the RLO is 1 behind it", de: "das VKE ist 0, also geht der Baustein weiter; dahinter ist das VKE 1" }

// Timers and counters.
/// A rising RLO starts a timer.
TimerStarts { en: "the RLO rose from 0 to 1, so {operand} starts with {time} from ACCU 1", de: "das VKE stieg von 0 auf 1, also startet {operand} mit {time} aus AKKU 1" }
/// The same with a time of 0.
TimerZero { en: "the RLO rose from 0 to 1, but the time in ACCU 1 is 0: {operand} does not run, its status is {status}", de: "das VKE stieg von 0 auf 1, aber die Zeit in AKKU 1 ist 0: {operand} läuft nicht, ihr Status ist {status}" }
/// RLO 1 as before.
TimerSame { en: "the RLO was 1 the last time already, so {operand} is not started again; {state}", de: "das VKE war schon beim letzten Mal 1, also startet {operand} nicht neu; {state}" }
/// RLO 0 stops a timer.
TimerStops { en: "the RLO is 0, so {operand} does not run and its status is 0", de: "das VKE ist 0, also läuft {operand} nicht und ihr Status ist 0" }
/// RLO 0 leaves a timer alone.
TimerGoesOn { en: "the RLO is 0, which does not stop {operand}; {state}", de: "das VKE ist 0, das hält {operand} nicht an; {state}" }
/// The state of a timer, when what was before is not known.
TimerState { en: "the RLO is {rlo}; {operand}: {state}", de: "das VKE ist {rlo}; {operand}: {state}" }
/// `SF` with a rising RLO.
OffDelayRises { en: "the RLO rose from 0 to 1, so the status of {operand} is 1; the time runs when the RLO falls", de: "das VKE stieg von 0 auf 1, also ist der Status von {operand} 1; die Zeit läuft, wenn das VKE fällt" }
/// `SF` with a falling RLO.
OffDelayFalls { en: "the RLO fell from 1 to 0, so {operand} starts with {time} from ACCU 1; {state}", de: "das VKE fiel von 1 auf 0, also startet {operand} mit {time} aus AKKU 1; {state}" }
/// `SF` without an edge.
OffDelaySame { en: "the RLO is {rlo} as it was the last time, so nothing happens to {operand}; {state}", de: "das VKE ist {rlo} wie beim letzten Mal, also geschieht mit {operand} nichts; {state}" }
/// `R` of a timer or counter.
ResetOne0 { en: "the RLO is 1, so {operand} is reset: value and status are 0", de: "das VKE ist 1, also wird {operand} zurückgesetzt: Wert und Status sind 0" }
/// The same with RLO 0.
ResetNothing { en: "the RLO is 0, so {operand} is not reset; {state}", de: "das VKE ist 0, also wird {operand} nicht zurückgesetzt; {state}" }
/// `FR` of a timer.
TimerEnable { en: "the RLO rose from 0 to 1, so {operand} forgets its edge: a start instruction with RLO 1 starts it again", de: "das VKE stieg von 0 auf 1, also vergisst {operand} ihre Flanke: Eine Startanweisung mit VKE 1 startet sie neu" }
/// `FR` of a counter.
CounterEnable { en: "the RLO rose from 0 to 1, so {operand} forgets its edges: `S`, `CU` and `CD` with RLO 1 have an effect again", de: "das VKE stieg von 0 auf 1, also vergisst {operand} seine Flanken: `S`, `ZV` und `ZR` mit VKE 1 wirken wieder" }
/// `FR` without an edge.
EnableNothing { en: "the RLO is {rlo} and did not rise, so {operand} is not enabled anew", de: "das VKE ist {rlo} und stieg nicht, also wird {operand} nicht neu freigegeben" }
/// `FR`, when what was before is not known.
EnableState { en: "the RLO is {rlo}; a rise from 0 to 1 enables {operand} anew", de: "das VKE ist {rlo}; ein Anstieg von 0 auf 1 gibt {operand} neu frei" }
/// A counter counts.
Counts { en: "the RLO rose from 0 to 1, so {operand} counts from {before} to {count}", de: "das VKE stieg von 0 auf 1, also zählt {operand} von {before} auf {count}" }
/// A counter at its upper limit.
CountsTop { en: "the RLO rose from 0 to 1, but {operand} is at its upper limit: it stays {count}", de: "das VKE stieg von 0 auf 1, aber {operand} steht an der oberen Grenze: Er bleibt {count}" }
/// A counter at 0.
CountsBottom { en: "the RLO rose from 0 to 1, but {operand} cannot go below 0: it stays {count}", de: "das VKE stieg von 0 auf 1, aber {operand} kann nicht unter 0: Er bleibt {count}" }
/// RLO 1 as before.
CountSame { en: "the RLO was 1 the last time already, so nothing happens; {operand} is at {count}", de: "das VKE war schon beim letzten Mal 1, also geschieht nichts; {operand} steht auf {count}" }
/// RLO 0.
CountLow { en: "the RLO is 0, so nothing happens; {operand} is at {count}", de: "das VKE ist 0, also geschieht nichts; {operand} steht auf {count}" }
/// The count, when what was before is not known.
CountState { en: "the RLO is {rlo}; {operand} is at {count}", de: "das VKE ist {rlo}; {operand} steht auf {count}" }
/// `S` of a counter.
CounterSet { en: "the RLO rose from 0 to 1, so {operand} takes {count} from ACCU 1", de: "das VKE stieg von 0 auf 1, also übernimmt {operand} {count} aus AKKU 1" }
/// A timer runs: what {state} is.
StateRuns { en: "it runs, {left} left, status {status}", de: "sie läuft, noch {left}, Status {status}" }
/// A timer does not run.
StateStands { en: "it does not run, status {status}", de: "sie läuft nicht, Status {status}" }
/// A counter.
StateCount { en: "it is at {count}", de: "er steht auf {count}" }

// Data blocks.
/// `OPN`.
OpenBlock { en: "DB {value} is open in the {register} register now; it has {length} bytes", de: "DB {value} ist jetzt im {register}-Register offen; er hat {length} Bytes" }
/// `OPN DB 0`.
CloseBlock { en: "number 0 closes the {register} register: no block is open there", de: "Nummer 0 schließt das {register}-Register: Dort ist kein Baustein offen" }
/// `CDB`.
SwapDataBlocks { en: "the DB and DI registers change places: DB {db} and DI {di} now", de: "DB- und DI-Register tauschen: jetzt DB {db} und DI {di}" }

// The rest.
/// `NOP`, `BLD`.
Nothing { en: "does nothing", de: "tut nichts" }
/// `__ASSERT==`.
AssertHolds { en: "the check was made; /FC becomes 0", de: "die Prüfung wurde gemacht; /ER wird 0" }
/// `__STWRST`.
StatusReset { en: "all status bits become 0", de: "alle Statusbits werden 0" }
/// `__SLEEP`.
Sleep { en: "so many milliseconds pass inside the scan", de: "so viele Millisekunden vergehen im Zyklus" }
/// `__FEATURE`.
Feature { en: "the property {value} comes into ACCU 1", de: "die Eigenschaft {value} kommt in AKKU 1" }

// What stands before: which address a statement came to.
/// Through a pointer in memory.
ThroughMemory { en: "{pointer_place} holds {pointer}, so the address is {address}: ", de: "{pointer_place} enthält {pointer}, also ist die Adresse {address}: " }
/// Through an address register.
ThroughRegister { en: "{register} holds {pointer}, with {offset} the address is {address}: ", de: "{register} enthält {pointer}, mit {offset} ist die Adresse {address}: " }
/// The statement opens a data block first.
OpensFirst { en: "DB {number} is opened in the {register} register; ", de: "DB {number} wird im {register}-Register geöffnet; " }

// Faults.
/// 16#2521.
FaultBcd { en: "a digit is no BCD digit (above 9), so nothing happens{reaction}", de: "eine Ziffer ist keine BCD-Ziffer (über 9), also geschieht nichts{reaction}" }
/// 16#2522, 16#2523.
FaultLength { en: "the address lies outside its area (area length error){zero}{reaction}", de: "die Adresse liegt außerhalb ihres Bereichs (Bereichslängenfehler){zero}{reaction}" }
/// 16#2524, 16#2525.
FaultArea { en: "the pointer names no area (area error){zero}{reaction}", de: "der Zeiger nennt keinen Bereich (Bereichsfehler){zero}{reaction}" }
/// 16#2526.
FaultTimer { en: "the CPU has no timer with this number, so nothing happens{reaction}", de: "die CPU hat keine Zeit mit dieser Nummer, also geschieht nichts{reaction}" }
/// 16#2527.
FaultCounter { en: "the CPU has no counter with this number, so nothing happens{reaction}", de: "die CPU hat keinen Zähler mit dieser Nummer, also geschieht nichts{reaction}" }
/// 16#2528, 16#2529.
FaultAlignment { en: "the pointer leads to a bit that does not begin a byte (alignment error){zero}{reaction}", de: "der Zeiger führt auf ein Bit, das kein Byte beginnt (Ausrichtungsfehler){zero}{reaction}" }
/// 16#2530, 16#2531.
FaultProtected { en: "the data block is write-protected, so nothing is written{reaction}", de: "der Datenbaustein ist schreibgeschützt, also wird nichts geschrieben{reaction}" }
/// 16#2532 to 16#2535.
FaultNumber { en: "no block of this CPU can have this number, so nothing happens{reaction}", de: "kein Baustein dieser CPU kann diese Nummer haben, also geschieht nichts{reaction}" }
/// 16#253A to 16#253F.
FaultMissing { en: "the block is not loaded, so nothing happens{reaction}", de: "der Baustein ist nicht geladen, also geschieht nichts{reaction}" }
/// 16#2942, 16#2943.
FaultAccess { en: "no module answers at this address{zero}{reaction}", de: "an dieser Adresse antwortet keine Baugruppe{zero}{reaction}" }
/// 16#357x.
FaultAbort { en: "the block cannot go on: a limit of the CPU for brackets, MCR zones, calls or local data is used up{reaction}", de: "der Baustein kann nicht weiter: Eine Grenze der CPU für Klammern, MCR-Zonen, Aufrufe oder Lokaldaten ist erreicht{reaction}" }
/// Any other.
FaultOther { en: "the statement failed with event 16#{event}{reaction}", de: "die Anweisung schlug mit Ereignis 16#{event} fehl{reaction}" }
/// What the CPU does about it.
ReactionBlock { en: "; {block} is called", de: "; {block} wird aufgerufen" }
/// What the CPU does about it.
ReactionStop { en: "; the CPU goes to STOP", de: "; die CPU geht in STOP" }
/// A load that failed.
ReactionZero { en: ", so 0 is loaded", de: ", also wird 0 geladen" }
/// Anything else that failed.
ReactionNothing { en: ", so nothing happens", de: ", also geschieht nichts" }

// Structured Text.
/// An assignment, with what was read.
StAssign { en: "{values}, so {target} becomes {value}", de: "{values}, also wird {target} {value}" }
/// An assignment of a constant.
StAssignConstant { en: "{target} becomes {value}", de: "{target} wird {value}" }
/// An assignment whose parts cannot be shown.
StAssignPart { en: "{target} is assigned the value of `{text}`", de: "{target} bekommt den Wert von `{text}`" }
/// The index of a target is outside its array.
StIndexWrite { en: "index {index} of {place} is outside its array ({low} to {high}), so nothing is written", de: "Index {index} von {place} liegt außerhalb des Feldes ({low} bis {high}), also wird nichts geschrieben" }
/// An index is outside its array, and the statement fails.
StIndexLeft { en: "index {index} of {place} is outside its array ({low} to {high}), so the statement is left out", de: "Index {index} von {place} liegt außerhalb des Feldes ({low} bis {high}), also entfällt die Anweisung" }
/// An index of what is read is outside its array.
StIndexRead { en: "index {index} of {place} is outside its array ({low} to {high}), so 0 is read", de: "Index {index} von {place} liegt außerhalb des Feldes ({low} bis {high}), also wird 0 gelesen" }
/// A division by 0.
StDividesByZero { en: "{text} divides by 0", de: "{text} teilt durch 0" }
/// A result that does not fit.
StOverflow { en: "the result of {text} does not fit its type", de: "das Ergebnis von {text} passt nicht in seinen Typ" }
/// A REAL that is no number.
StNoNumber { en: "the result of {text} is infinite or no number", de: "das Ergebnis von {text} ist unendlich oder keine Zahl" }
/// A conversion of a value that does not fit, or a function without a result.
StNoResult { en: "{text} has no result that fits its type", de: "{text} hat kein Ergebnis, das in seinen Typ passt" }
/// What failed, and what came of it all the same.
StFailed { en: "{reason}: {rest}", de: "{reason}: {rest}" }
/// A condition that holds.
StTrue { en: "{values}: `{text}` is TRUE, so what follows it runs", de: "{values}: `{text}` ist TRUE, also läuft, was folgt" }
/// A condition that does not.
StFalse { en: "{values}: `{text}` is FALSE, so what follows it is left out", de: "{values}: `{text}` ist FALSE, also wird ausgelassen, was folgt" }
/// The condition of REPEAT holds.
StUntilTrue { en: "{values}: `{text}` is TRUE, so the loop ends", de: "{values}: `{text}` ist TRUE, also endet die Schleife" }
/// The condition of REPEAT does not.
StUntilFalse { en: "{values}: `{text}` is FALSE, so the loop goes on", de: "{values}: `{text}` ist FALSE, also geht die Schleife weiter" }
/// A condition whose outcome cannot be shown.
StCondition { en: "`{text}` decides what runs next{values}", de: "`{text}` entscheidet, was als Nächstes läuft{values}" }
/// The selector of CASE.
StCase { en: "the selector {values} chooses the branch", de: "der Selektor {values} wählt den Zweig" }
/// FOR.
StFor { en: "the loop counts with {target}, which is {value}", de: "die Schleife zählt mit {target}, das ist {value}" }
/// A call.
StCall { en: "calls {block}", de: "ruft {block} auf" }
/// A call with arguments that can be shown.
StCallWith { en: "calls {block} with {values}", de: "ruft {block} auf mit {values}" }
/// RETURN.
StReturn { en: "the block ends here", de: "der Baustein endet hier" }
/// EXIT.
StExit { en: "the loop ends here", de: "die Schleife endet hier" }
/// CONTINUE.
StContinue { en: "the next pass of the loop begins", de: "der nächste Durchlauf der Schleife beginnt" }
/// GOTO.
StGoto { en: "goes on at the label", de: "geht an der Marke weiter" }
/// A part of a statement for which there are no words.
StStep { en: "a step of `{text}`", de: "ein Schritt von `{text}`" }
/// A call inside of an expression.
StCallInside { en: "calls {block}; the rest of `{text}` follows when it has ended", de: "ruft {block} auf; der Rest von `{text}` folgt, wenn er geendet hat" }
/// The way to the condition of a loop.
StLoop { en: "goes to the condition of the loop", de: "geht zur Bedingung der Schleife" }
/// Parameters and variables before the first statement and behind the last one.
StPrepare { en: "parameters and variables of the block are set or copied", de: "Parameter und Variablen des Bausteins werden gesetzt oder kopiert" }
/// The end of a block.
StEnd { en: "the block ends", de: "der Baustein endet" }

}
