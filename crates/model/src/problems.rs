//! The table of problem codes: code, severity, what is wrong and what to do, in English and below it in German.
//!
//! 1xxx characters and words, 2xxx syntax, 3xxx names, 4xxx types and ranges, 5xxx limits of the
//! CPU type, 6xxx files and projects, 7xxx command line, 8xxx run time, 9xxx diagrams. A code is never reused.

use crate::diagnostic::Severity;
use crate::language::{Language, pick};

/// Error or warning, and whether `--strict` makes an error of it.
macro_rules! kind {
    (Error) => {
        (Severity::Error, false)
    };
    (Warning) => {
        (Severity::Warning, false)
    };
    (Refused) => {
        (Severity::Warning, true)
    };
}

macro_rules! problems {
    ($( $Code:ident $Severity:ident $title:literal $help:literal $titel:literal $hilfe:literal; )*) => {
        /// A problem that a source, a project or a command line can have.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Problem { $( #[doc = $title] $Code, )* }

        impl Problem {
            /// All problems, by code.
            pub const ALL: &[Self] = &[$(Self::$Code),*];
            /// The code, `P2001`.
            pub fn code(self) -> &'static str { match self { $(Self::$Code => stringify!($Code)),* } }
            /// Error or warning.
            pub fn severity(self) -> Severity { match self { $(Self::$Code => kind!($Severity).0),* } }
            /// Whether it is a warning about something that STEP 7 refuses: with `--strict` it is an error.
            pub fn is_refused(self) -> bool { match self { $(Self::$Code => kind!($Severity).1),* } }
            /// What is wrong, in one sentence.
            pub fn title(self) -> &'static str { self.title_in(Language::English) }
            /// What to do about it.
            pub fn help(self) -> &'static str { self.help_in(Language::English) }
            /// What is wrong, in a language.
            pub fn title_in(self, language: Language) -> &'static str {
                pick(language, match self { $(Self::$Code => [$title, $titel]),* })
            }
            /// What to do about it, in a language.
            pub fn help_in(self, language: Language) -> &'static str {
                pick(language, match self { $(Self::$Code => [$help, $hilfe]),* })
            }
            /// The problem with this code, without regard to case.
            pub fn from_code(code: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|problem| problem.code().eq_ignore_ascii_case(code))
            }
        }
    };
}

problems! {
    // 1xxx characters and words
    P1001 Error "a character that does not belong here" "Remove it, or put it into a comment or a string."
        "ein Zeichen, das hier nicht hingehört" "Entfernen, oder in einen Kommentar oder eine Zeichenkette setzen.";
    P1002 Error "characters without their closing apostrophe" "Write `'` behind the last character; an apostrophe inside is written `$'`."
        "Zeichen ohne schließendes Hochkomma" "Nach dem letzten Zeichen `'` schreiben; ein Hochkomma im Text wird `$'` geschrieben.";
    P1003 Error "a quoted name without its closing quote" "Write `\"` behind the name, on the same line."
        "ein Name in Anführungszeichen ohne schließendes Anführungszeichen" "Nach dem Namen `\"` schreiben, in derselben Zeile.";
    P1004 Error "a comment without its end" "Write `*)` where the comment ends."
        "ein Kommentar ohne Ende" "`*)` schreiben, wo der Kommentar endet.";
    P1005 Error "a character that only looks like the right one" "Write the letter, digit or sign that the message names."
        "ein Zeichen, das nur so aussieht wie das richtige" "Den Buchstaben, die Ziffer oder das Zeichen schreiben, das die Meldung nennt.";
    P1101 Error "a binary file instead of a source text" "Name the source (.awl, .stl, .csv, .sdf), not a block, an archive or a project database."
        "eine Binärdatei statt eines Quelltexts" "Die Quelle angeben (.awl, .stl, .csv, .sdf), nicht einen Baustein, ein Archiv oder eine Projektdatenbank.";
    P1102 Warning "bytes that mean nothing in the encoding of the file" "Choose another encoding, or save the file as UTF-8."
        "Bytes, die in der Zeichenkodierung der Datei nichts bedeuten" "Eine andere Zeichenkodierung wählen oder die Datei als UTF-8 speichern.";
    P1103 Error "a character that the encoding of the file does not have" "Save the file as UTF-8, or replace the character."
        "ein Zeichen, das es in der Zeichenkodierung der Datei nicht gibt" "Die Datei als UTF-8 speichern oder das Zeichen ersetzen.";
    P1104 Error "a source larger than 64 MiB" "Split it, or check whether the file is a source at all."
        "eine Quelle von mehr als 64 MiB" "Aufteilen, oder prüfen, ob die Datei überhaupt eine Quelle ist.";

    // 2xxx syntax
    P2001 Error "a word where a statement should begin is not an instruction" "Use an instruction of the mnemonic language of the file."
        "ein Wort am Anfang einer Anweisung, das keine Operation ist" "Eine Operation in der Mnemonik der Datei schreiben.";
    P2002 Error "a statement in the other mnemonic language" "Write what the message names, or tell the language of the file with --mnemonics."
        "eine Anweisung in der anderen Mnemonik" "Schreiben, was die Meldung nennt, oder die Mnemonik der Datei mit --mnemonics angeben.";
    P2003 Warning "a word that both mnemonic languages have, and no other word to tell which" "Name the language of the file with --mnemonics."
        "ein Wort, das es in beiden Mnemoniken gibt, und kein anderes, das entscheidet" "Die Mnemonik der Datei mit --mnemonics angeben.";
    P2004 Error "more text where a statement has ended" "Separate statements by `;` or a line end, and begin a comment with `//`."
        "weiterer Text, wo eine Anweisung zu Ende ist" "Anweisungen mit `;` oder einem Zeilenende trennen und einen Kommentar mit `//` beginnen.";
    P2005 Error "an operand that is not understood" "Write an address such as `M 1.0`, a symbol in quotes, `#local` or a constant."
        "ein Operand, der nicht verstanden wird" "Eine Adresse wie `M 1.0`, ein Symbol in Anführungszeichen, `#lokal` oder eine Konstante schreiben.";
    P2006 Refused "a label of more than four characters" "STEP 7 takes at most four letters and digits; shorten the label if the program is for a real CPU."
        "eine Sprungmarke mit mehr als vier Zeichen" "STEP 7 nimmt höchstens vier Buchstaben und Ziffern; die Sprungmarke kürzen, wenn das Programm für eine echte CPU ist.";
    P2007 Error "a misprint of the assignment sign" "Write `:=`."
        "ein verschriebenes Zuweisungszeichen" "`:=` schreiben.";
    P2008 Error "a known misprint of an instruction or operand" "Write what the message names."
        "ein bekannter Schreibfehler in einer Operation oder einem Operanden" "Schreiben, was die Meldung nennt.";
    P2010 Error "a block without a name" "Write the kind and number of the block, such as `FC 1`, or a symbol in quotes."
        "ein Baustein ohne Namen" "Art und Nummer des Bausteins schreiben, etwa `FC 1`, oder ein Symbol in Anführungszeichen.";
    P2011 Error "a block without its end" "Write the END_ keyword of the block behind its last statement."
        "ein Baustein ohne Ende" "Nach der letzten Anweisung das END_-Schlüsselwort des Bausteins schreiben.";
    P2012 Error "a block that ends with the keyword of another kind" "Use the END_ keyword that belongs to the first keyword of the block."
        "ein Baustein, der mit dem Schlüsselwort einer anderen Art endet" "Das END_-Schlüsselwort verwenden, das zum ersten Schlüsselwort des Bausteins gehört.";
    P2013 Error "the end of a block that did not begin" "Remove it, or write the beginning of the block."
        "das Ende eines Bausteins, der nicht begonnen hat" "Entfernen, oder den Anfang des Bausteins schreiben.";
    P2014 Error "a header line that is not understood" "Write it as `AUTHOR : name`, or `TITLE = text`."
        "eine Kopfzeile, die nicht verstanden wird" "Als `AUTHOR : Name` oder `TITLE = Text` schreiben.";
    P2015 Error "an attribute list that is not understood" "Write it as `{ name := 'value' }`."
        "eine Attributliste, die nicht verstanden wird" "Als `{ Name := 'Wert' }` schreiben.";
    P2016 Error "a bracket that is not closed" "Write `]` behind the index or pointer."
        "eine eckige Klammer, die nicht geschlossen wird" "Nach dem Index oder Zeiger `]` schreiben.";
    P2017 Error "an assignment of a data block that is not understood" "Write `name := value;`."
        "eine Zuweisung in einem Datenbaustein, die nicht verstanden wird" "`Name := Wert;` schreiben.";
    P2018 Error "a path into a variable that is not understood" "Write `.field` or `[1]` with whole numbers, without blanks."
        "ein Pfad in eine Variable, der nicht verstanden wird" "`.Feld` oder `[1]` mit ganzen Zahlen schreiben, ohne Leerzeichen.";
    P2019 Error "a keyword where statements stand" "Write declarations before BEGIN, and remove what does not belong to the block."
        "ein Schlüsselwort zwischen den Anweisungen" "Deklarationen vor BEGIN schreiben und entfernen, was nicht zum Baustein gehört.";
    P2020 Error "a declaration that is not understood" "Write `name : INT;`."
        "eine Deklaration, die nicht verstanden wird" "`Name : INT;` schreiben.";
    P2021 Error "a data type that is not understood" "Use an elementary type, STRING [n], ARRAY [1..5] OF, STRUCT, a UDT or a function block."
        "ein Datentyp, der nicht verstanden wird" "Einen elementaren Datentyp, STRING [n], ARRAY [1..5] OF, STRUCT, einen UDT oder einen Funktionsbaustein verwenden.";
    P2022 Error "nesting that is too deep" "Use fewer levels; STEP 7 allows eight."
        "eine zu tiefe Schachtelung" "Weniger Ebenen verwenden; STEP 7 erlaubt acht.";
    P2023 Error "a declaration section without its end" "Write `END_VAR` or `END_STRUCT` behind the last declaration."
        "ein Deklarationsabschnitt ohne Ende" "Nach der letzten Deklaration `END_VAR` oder `END_STRUCT` schreiben.";
    P2024 Error "an initial value that is not understood" "Write a constant, constants with commas, or `3 (0)` for a repetition."
        "ein Anfangswert, der nicht verstanden wird" "Eine Konstante schreiben, Konstanten mit Kommas, oder `3 (0)` für eine Wiederholung.";
    P2030 Error "a parameter that is not understood" "Write `name := value`, with commas between the parameters."
        "ein Parameter, der nicht verstanden wird" "`Name := Wert` schreiben, mit Kommas zwischen den Parametern.";
    P2031 Error "a parameter list without its end" "Write `)` behind the last parameter."
        "eine Parameterliste ohne Ende" "Nach dem letzten Parameter `)` schreiben.";
    P2040 Error "an extension word in a program that is not extended" "Say `--extended`, or `extended = true` under `[project]` in `sieben.toml`, if the program was written for awlsim; a real CPU does not have these words."
        "ein Erweiterungswort in einem Programm, das nicht erweitert ist" "`--extended` angeben, oder `extended = true` unter `[project]` in `sieben.toml`, wenn das Programm für awlsim geschrieben wurde; eine echte CPU kennt diese Wörter nicht.";
    P2041 Error "an extension word with other operands than it takes" "Write it the way the message shows."
        "ein Erweiterungswort mit anderen Operanden, als es nimmt" "So schreiben, wie die Meldung es zeigt.";
    P2042 Warning "an extension word that asks for a CPU with both two and four accumulators" "Ask for one number of accumulators in the whole program, or choose the CPU type with --cpu."
        "ein Erweiterungswort, das eine CPU mit zwei und mit vier Akkumulatoren zugleich verlangt" "Im ganzen Programm dieselbe Zahl von Akkumulatoren verlangen, oder den CPU-Typ mit --cpu wählen.";
    P2043 Error "a mark of a printed listing where statements stand" "Remove the fence; write the statements that the page leaves out, or `NOP 0`."
        "ein Zeichen eines gedruckten Listings zwischen den Anweisungen" "Die Umrandung entfernen; die Anweisungen schreiben, die das Blatt auslässt, oder `NOP 0`.";
    P2044 Error "an operand or instruction of STEP 5" "Write what the message names; STL calls bit memory M, counts the bytes of a data block, and writes constants as W#16#, 2#, C# and S5T#."
        "ein Operand oder eine Operation von STEP 5" "Schreiben, was die Meldung nennt; in AWL heißt der Merker M, ein Datenbaustein zählt in Bytes, und Konstanten schreibt man W#16#, 2#, C# und S5T#.";
    P2045 Error "the heading of a printed block or network" "Begin a block with its keyword, such as `FUNCTION FC 30 : VOID`, and a network with `NETWORK`; what it is called stands after `TITLE =`."
        "die Überschrift eines gedruckten Bausteins oder Netzwerks" "Einen Baustein mit seinem Schlüsselwort beginnen, etwa `FUNCTION FC 30 : VOID`, und ein Netzwerk mit `NETWORK`; der Titel steht nach `TITLE =`.";
    P2046 Error "a name with spaces and without quotes" "Write the symbol in quotes, or the name with underscores."
        "ein Name mit Leerzeichen und ohne Anführungszeichen" "Das Symbol in Anführungszeichen schreiben, oder den Namen mit Unterstrichen.";
    P2199 Error "more problems than are shown" "Mend the problems that are shown first."
        "mehr Probleme, als gezeigt werden" "Zuerst die gezeigten Probleme beheben.";
    P2200 Error "a block header that does not fit its block" "Name a block of the kind that the keyword says: FUNCTION with an FC, FUNCTION_BLOCK with an FB, DATA_BLOCK with a DB, ORGANIZATION_BLOCK with an OB, TYPE with a UDT."
        "ein Bausteinkopf, der nicht zu seinem Baustein passt" "Einen Baustein der Art nennen, die das Schlüsselwort sagt: FUNCTION mit FC, FUNCTION_BLOCK mit FB, DATA_BLOCK mit DB, ORGANIZATION_BLOCK mit OB, TYPE mit UDT.";
    P2201 Error "a VAR section that this kind of block does not have" "An OB has VAR_TEMP; an FC has VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT and VAR_TEMP; only an FB has VAR too."
        "ein VAR-Abschnitt, den diese Bausteinart nicht hat" "Ein OB hat VAR_TEMP; eine FC hat VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT und VAR_TEMP; nur ein FB hat auch VAR.";
    P2203 Error "a bracket that is never closed" "Close it with `)` before the block ends."
        "eine Klammer, die nie geschlossen wird" "Vor dem Ende des Bausteins mit `)` schließen.";
    P2204 Error "a closing bracket without an opening one" "Remove it, or open the bracket with `A(`, `O(`, `X(` or their negated forms."
        "eine schließende Klammer ohne öffnende" "Entfernen, oder die Klammer mit `U(`, `O(`, `X(` oder ihren negierten Formen öffnen.";
    P2205 Error "more than seven open brackets" "Split the logic: assign a part to a memory bit first."
        "mehr als sieben offene Klammern" "Die Verknüpfung aufteilen: einen Teil zuerst einem Merker zuweisen.";
    P2206 Error "a jump into or out of a bracket" "Jump before the bracket is opened or after it is closed."
        "ein Sprung in eine Klammer oder aus ihr heraus" "Springen, bevor die Klammer geöffnet oder nachdem sie geschlossen ist.";
    P2207 Warning "MCR zones that are not balanced" "Open every zone with `MCR(` and close it with `)MCR` in the same block, at most eight inside one another."
        "MCR-Zonen, die nicht ausgeglichen sind" "Jede Zone mit `MCR(` öffnen und im selben Baustein mit `)MCR` schließen, höchstens acht ineinander.";
    P2208 Warning "a statement that is never reached" "Remove it, or put a label before it that a jump leads to."
        "eine Anweisung, die nie erreicht wird" "Entfernen, oder eine Sprungmarke davorsetzen, zu der gesprungen wird.";
    P2209 Error "a jump list with something else than its jumps" "Write only `JU` between `JL` and the statement with its label, at most 255 of them."
        "ein Sprungverteiler, in dem anderes steht als seine Sprünge" "Zwischen `SPL` und der Anweisung mit seiner Marke nur `SPA` schreiben, höchstens 255-mal.";
    P2210 Error "a data block or type without a structure" "Write `STRUCT … END_STRUCT`, or the UDT, FB or SFB that it is based on."
        "ein Datenbaustein oder Datentyp ohne Struktur" "`STRUCT … END_STRUCT` schreiben, oder den UDT, FB oder SFB, auf dem er beruht.";
    P2211 Error "a STRUCT without fields" "Declare at least one field."
        "ein STRUCT ohne Komponenten" "Mindestens eine Komponente deklarieren.";
    P2212 Warning "an initial value where none is kept" "Remove it, and assign the value with a statement."
        "ein Anfangswert, wo keiner gespeichert wird" "Entfernen und den Wert mit einer Anweisung zuweisen.";
    P2213 Error "a block end inside a bracket" "Close the bracket first."
        "ein Bausteinende in einer Klammer" "Zuerst die Klammer schließen.";
    P2214 Warning "a block call inside a bracket" "Close the bracket first: the nesting stack of the caller has to be empty at a call."
        "ein Bausteinaufruf in einer Klammer" "Zuerst die Klammer schließen: Der Klammerstack des Aufrufers muss beim Aufruf leer sein.";
    P2300 Error "a test without a name in quotes" "Write `TEST 'what is true when it passes'`."
        "ein Test ohne Namen in Hochkommas" "`TEST 'was gilt, wenn er besteht'` schreiben.";
    P2301 Error "a part of a test file that is there twice" "Give every test a name of its own, and write SETUP and TEARDOWN once."
        "ein Teil einer Testdatei, der doppelt vorkommt" "Jedem Test einen eigenen Namen geben und SETUP und TEARDOWN nur einmal schreiben.";
    P2302 Error "a test file without a test" "Write `TEST 'what is true' … END_TEST`."
        "eine Testdatei ohne Test" "`TEST 'was gilt' … END_TEST` schreiben.";
    P2303 Error "a statement of a test file outside of a test" "Put it into TEST, SETUP or TEARDOWN."
        "eine Anweisung einer Testdatei außerhalb eines Tests" "In TEST, SETUP oder TEARDOWN schreiben.";
    P2304 Error "a word of a test file outside of one" "Write it in a file whose name ends with `.test.st`, and run that with `sieben test`."
        "ein Wort für Testdateien außerhalb einer Testdatei" "In eine Datei schreiben, deren Name mit `.test.st` endet, und diese mit `sieben test` ausführen.";
    P2305 Error "a word of a test file that is not used as it has to be" "Use it as the message shows."
        "ein Wort für Testdateien, das nicht so verwendet wird, wie es muss" "So verwenden, wie die Meldung es zeigt.";
    P2306 Error "something that cannot be mocked" "Mock an instance of a function block, or a function of the program."
        "etwas, das sich nicht ersetzen lässt (MOCK)" "Eine Instanz eines Funktionsbausteins oder eine Funktion des Programms ersetzen.";

    // 3xxx names
    P2401 Error "a word that is no element of a diagram" "Begin each line with an element (NO, NC, COIL, OR, BRANCH …) or with the name of a box; `sieben explain NO` tells what an element does."
        "ein Wort, das kein Element eines Plans ist" "Jede Zeile mit einem Element (NO, NC, COIL, OR, BRANCH …) oder dem Namen einer Box beginnen; `sieben explain NO` sagt, was ein Element tut.";
    P2402 Error "an element of a diagram without its operand, or with one too many" "Write the operand after the element: `NO I 0.0`, `CMP >I MW 10, 100`."
        "ein Element eines Plans ohne seinen Operanden, oder mit einem zu viel" "Den Operanden nach dem Element schreiben: `NO I 0.0`, `CMP >I MW 10, 100`.";
    P2403 Error "a pin that the box does not have, has twice, or that nothing is wired to" "Name the pins of the box, each once: `IN1 := MW 10`, `OUT => MW 12`."
        "ein Anschluss, den die Box nicht hat, der doppelt vorkommt oder nicht beschaltet ist" "Die Anschlüsse der Box nennen, jeden einmal: `IN1 := MW 10`, `OUT => MW 12`.";
    P2404 Error "a wire of a diagram that leads nowhere" "End the rung with a coil or a box, and each OR and BRANCH with END."
        "eine Verbindung eines Plans, die nirgends hinführt" "Den Strompfad mit einer Spule oder Box beenden, und jedes OR und BRANCH mit END.";
    P2405 Error "a short circuit in a diagram" "Put an element into each branch."
        "ein Kurzschluss in einem Plan" "In jeden Zweig ein Element setzen.";
    P2406 Error "an element of a diagram at a place where it cannot stand" "Coils stand at the right end of a rung; an edge, NOT and a midline output need logic before them."
        "ein Element eines Plans an einer Stelle, wo es nicht stehen kann" "Spulen stehen am rechten Ende eines Strompfads; eine Flanke, NOT und ein Konnektor brauchen eine Verknüpfung davor.";
    P2407 Error "an element that only FBD has, in a network of LAD" "Begin the network with `NETWORK FBD`, or draw it with contacts and NOT."
        "ein Element, das es nur in FUP gibt, in einem KOP-Netzwerk" "Das Netzwerk mit `NETWORK FBD` beginnen, oder mit Kontakten und NOT zeichnen.";
    P2408 Error "a diagram that is too large, or nested too deep" "Divide the network into several."
        "ein zu großer oder zu tief geschachtelter Plan" "Das Netzwerk in mehrere aufteilen.";
    P2409 Error "a diagram on one line that is not understood" "A space is AND, `|` in brackets OR, `/` a normally closed contact, and the coils stand after `->`: `(I 0.0 | Q 0.0) /I 0.1 -> = Q 0.0`."
        "ein Plan auf einer Zeile, der nicht verstanden wird" "Ein Leerzeichen ist UND, `|` in Klammern ODER, `/` ein Öffner, und die Spulen stehen nach `->`: `(I 0.0 | Q 0.0) /I 0.1 -> = Q 0.0`.";
    P2410 Error "an operand that the pin of an element does not take" "Wire an operand of the type that the message names; MOVE takes any width, and I_DINT, DI_REAL, ROUND and the like convert."
        "ein Operand, den der Anschluss eines Elements nicht nimmt" "Einen Operanden des Typs anschließen, den die Meldung nennt; MOVE nimmt jede Breite, und I_DINT, DI_REAL, ROUND und ähnliche wandeln um.";
    P2411 Warning "a parameter that the called block writes, with logic wired to it" "Wire the operand itself to the pin: `p := =M 0.0` for IN_OUT, `p => M 0.0` for an output."
        "ein Parameter, den der aufgerufene Baustein schreibt, an einer Verknüpfung" "Den Operanden selbst anschließen: `p := =M 0.0` bei IN_OUT, `p => M 0.0` bei einem Ausgang.";
    P2412 Warning "SAVE as the last coil of a rung that another one follows" "Put a coil below SAVE, which ends the line, or SAVE into the last rung of the block."
        "SAVE als letzte Spule eines Strompfads, auf den ein weiterer folgt" "Unter SAVE, das die Linie beendet, eine Spule setzen, oder SAVE in den letzten Strompfad des Bausteins.";
    P2440 Error "an element of S7 blocks in a diagram of IEC 61131-3" "Draw what the message names instead."
        "ein Element von S7-Bausteinen in einem Plan nach IEC 61131-3" "Zeichnen, was die Meldung stattdessen nennt.";
    P2441 Error "a coil that nothing is wired to" "Draw what it is to be assigned before it; TRUE is written as a contact."
        "eine Spule, an der nichts angeschlossen ist" "Davor zeichnen, was ihr zugewiesen werden soll; TRUE schreibt man als Kontakt.";
    P2442 Error "a body with statements and a diagram" "Write the diagram in a block or an action of its own."
        "ein Rumpf mit Anweisungen und einem Plan" "Den Plan in einem eigenen Baustein oder einer eigenen Aktion schreiben.";
    P2443 Warning "an instance, a counter or an edge memory that two elements of a diagram use" "Give each element one of its own, or read what the first one delivers."
        "eine Instanz, ein Zähler oder ein Flankenmerker, den zwei Elemente eines Plans verwenden" "Jedem Element etwas Eigenes geben, oder lesen, was das erste liefert.";
    P2444 Error "a contact, a coil or EN of a diagram that is no BOOL" "Read or write one bit, or draw a box: it takes operands of any type."
        "ein Kontakt, eine Spule oder EN eines Plans, die nicht BOOL sind" "Ein Bit lesen oder schreiben, oder eine Box zeichnen: Sie nimmt Operanden jedes Typs.";
    P3001 Error "a name that is not declared" "Declare it in the symbol table or in the VAR sections of the block."
        "ein Name, der nicht deklariert ist" "In der Symboltabelle oder in den VAR-Abschnitten des Bausteins deklarieren.";
    P3002 Error "two blocks with one number" "Give one of them another number, or name only the files that belong together."
        "zwei Bausteine mit derselben Nummer" "Einem von beiden eine andere Nummer geben, oder nur die Dateien nennen, die zusammengehören.";
    P3003 Error "a block named by a symbol that is not in the symbol table" "Add the symbol with the number of the block as its address, for example `FC 1`."
        "ein Baustein mit einem Symbol, das nicht in der Symboltabelle steht" "Das Symbol mit der Nummer des Bausteins als Adresse eintragen, zum Beispiel `FC 1`.";
    P3004 Error "a jump to a label that does not exist" "Write the label before a statement of the same block; case matters."
        "ein Sprung zu einer Marke, die es nicht gibt" "Die Marke vor eine Anweisung desselben Bausteins schreiben; Groß- und Kleinschreibung zählt.";
    P3005 Error "a label that stands twice in a block" "Rename one of them."
        "eine Sprungmarke, die in einem Baustein zweimal steht" "Eine von beiden umbenennen.";
    P3006 Error "a name that is declared twice" "Rename one of them; case does not distinguish names."
        "ein Name, der zweimal deklariert ist" "Einen von beiden umbenennen; Groß- und Kleinschreibung unterscheidet Namen nicht.";
    P3007 Error "a field that the structure does not have" "Use a field of its declaration."
        "eine Komponente, die die Struktur nicht hat" "Eine Komponente ihrer Deklaration verwenden.";
    P3008 Error "a block that does not exist" "Add its source to the project, or correct the number."
        "ein Baustein, den es nicht gibt" "Seine Quelle zum Projekt hinzufügen, oder die Nummer berichtigen.";
    P3009 Error "a parameter that the block does not have" "Use the names of its VAR_INPUT, VAR_OUTPUT and VAR_IN_OUT; the result of a function is RET_VAL."
        "ein Parameter, den der Baustein nicht hat" "Die Namen aus VAR_INPUT, VAR_OUTPUT und VAR_IN_OUT verwenden; das Ergebnis einer Funktion heißt RET_VAL.";
    P3010 Error "a call without all parameters" "Give every parameter of a function a value or a variable."
        "ein Aufruf, dem Parameter fehlen" "Jedem Parameter einer Funktion einen Wert oder eine Variable geben.";
    P3011 Error "a parameter that is given twice" "Remove one of the two."
        "ein Parameter, der zweimal angegeben ist" "Einen von beiden entfernen.";
    P3012 Error "a symbol with more than one address" "Rename one of the rows of the symbol table."
        "ein Symbol mit mehr als einer Adresse" "Eine der Zeilen der Symboltabelle umbenennen.";
    P3013 Warning "no OB 1" "Write the cyclic program as `ORGANIZATION_BLOCK OB 1`; without it the CPU runs and does nothing."
        "kein OB 1" "Das zyklische Programm als `ORGANIZATION_BLOCK OB 1` schreiben; ohne ihn läuft die CPU und tut nichts.";
    P3014 Warning "an instance data block without a source" "It is made with the initial values of the function block; write `DATA_BLOCK DB n FB m BEGIN END_DATA_BLOCK` to have it in the sources."
        "ein Instanz-Datenbaustein ohne Quelle" "Er wird mit den Anfangswerten des Funktionsbausteins angelegt; `DATA_BLOCK DB n FB m BEGIN END_DATA_BLOCK` nimmt ihn in die Quellen auf.";
    P3015 Error "a type that does not exist" "Use an elementary type, ARRAY, STRUCT, or a UDT of the project."
        "ein Datentyp, den es nicht gibt" "Einen elementaren Datentyp, ARRAY, STRUCT oder einen UDT des Projekts verwenden.";
    P3016 Error "a type that contains itself" "Remove the field that closes the circle."
        "ein Datentyp, der sich selbst enthält" "Die Komponente entfernen, die den Kreis schließt.";
    P3017 Error "a data block that is not an instance of the called block" "Call with a data block that is based on this function block."
        "ein Datenbaustein, der keine Instanz des aufgerufenen Bausteins ist" "Mit einem Datenbaustein aufrufen, der auf diesem Funktionsbaustein beruht.";
    P3018 Warning "a block that does not exist when it is opened or called" "Add its source to the project, or correct the number."
        "ein Baustein, den es beim Aufschlagen oder Aufrufen nicht gibt" "Seine Quelle zum Projekt hinzufügen, oder die Nummer berichtigen.";
    P3019 Error "a call with a wrong instance" "An FB or SFB needs a data block behind the comma; an FC, an SFC and a multi-instance have none."
        "ein Aufruf mit falscher Instanz" "Ein FB oder SFB braucht nach dem Komma einen Datenbaustein; FC, SFC und Multiinstanz haben keinen.";
    P3020 Error "a symbol that is not in the symbol table" "Add it to the symbol table, or correct its spelling."
        "ein Symbol, das nicht in der Symboltabelle steht" "In die Symboltabelle eintragen, oder die Schreibweise berichtigen.";
    P3021 Error "a symbol without a usable address" "Correct its address in the symbol table."
        "ein Symbol ohne brauchbare Adresse" "Seine Adresse in der Symboltabelle berichtigen.";

    // 4xxx types and ranges
    P4001 Error "a constant outside its range" "Use a value inside the range."
        "eine Konstante außerhalb ihres Bereichs" "Einen Wert im Bereich verwenden.";
    P4002 Error "an operand that the instruction does not take" "Use an operand of the kind that the message names."
        "ein Operand, den die Operation nicht nimmt" "Einen Operanden der Art verwenden, die die Meldung nennt.";
    P4004 Error "array bounds or a string length outside their range" "An array has 1 to 6 dimensions with bounds from -32768 to 32767, a string 0 to 254 characters."
        "Feldgrenzen oder eine Zeichenkettenlänge außerhalb ihres Bereichs" "Ein Feld hat 1 bis 6 Dimensionen mit Grenzen von -32768 bis 32767, eine Zeichenkette 0 bis 254 Zeichen.";
    P4005 Error "an array index outside the bounds" "Use an index inside the bounds of the declaration, one for each dimension."
        "ein Feldindex außerhalb der Grenzen" "Einen Index innerhalb der deklarierten Grenzen verwenden, einen für jede Dimension.";
    P4006 Error "a value that does not fit the type" "Write the constant in the notation of the type."
        "ein Wert, der nicht zum Datentyp passt" "Die Konstante in der Schreibweise des Datentyps schreiben.";
    P4007 Error "more values than variables" "Remove the values that are too many."
        "mehr Werte als Variablen" "Die überzähligen Werte entfernen.";
    P4008 Error "types nested too deeply" "Put the inner part into a structure of its own."
        "zu tief geschachtelte Datentypen" "Den inneren Teil in eine eigene Struktur legen.";
    P4009 Error "a type that may not stand here" "Use a type that the section allows."
        "ein Datentyp, der hier nicht stehen darf" "Einen Datentyp verwenden, den der Abschnitt erlaubt.";
    P4010 Error "a field or index of something that has none" "Only structures have fields, only arrays and strings have indexes."
        "eine Komponente oder ein Index von etwas, das keine hat" "Nur Strukturen haben Komponenten, nur Felder und Zeichenketten haben Indizes.";
    P4011 Error "a parameter of the wrong type" "Pass a variable or constant of the type that the block declares."
        "ein Parameter vom falschen Datentyp" "Eine Variable oder Konstante des Datentyps übergeben, den der Baustein deklariert.";
    P4012 Warning "a parameter of another type with the same width" "Check that the bits mean the same in both types, or convert the value first."
        "ein Parameter von anderem Datentyp mit derselben Breite" "Prüfen, ob die Bits in beiden Datentypen dasselbe bedeuten, oder den Wert zuerst umwandeln.";
    P4013 Warning "a call without parameters of a block that has some" "Use CALL, which passes the parameters and opens the instance."
        "ein Aufruf ohne Parameter eines Bausteins, der welche hat" "CALL verwenden: Es übergibt die Parameter und schlägt die Instanz auf.";
    P4014 Error "a pointer that lies where it cannot be used" "Put the pointer into M, L, DB or DI: a double word for addresses, a word for the numbers of timers, counters and blocks."
        "ein Zeiger, der dort liegt, wo er nicht verwendet werden kann" "Den Zeiger in M, L, DB oder DI legen: ein Doppelwort für Adressen, ein Wort für Nummern von Zeiten, Zählern und Bausteinen.";
    P4015 Error "an address that is not complete" "A bit has two numbers as in `M 10.3`, all else one as in `MW 10`."
        "eine unvollständige Adresse" "Ein Bit hat zwei Zahlen wie in `M 10.3`, alles andere eine wie in `MW 10`.";
    P4016 Warning "an edge memory in temporary data" "Use a bit of M, of a data block or a static variable of the function block, and each for one edge only."
        "ein Flankenmerker in temporären Daten" "Ein Bit von M, eines Datenbausteins oder eine statische Variable des Funktionsbausteins verwenden, jedes nur für eine Flanke.";
    P4020 Warning "a temporary variable that is read before it is written" "Write it first: VAR_TEMP begins with what other blocks left there."
        "eine temporäre Variable, die gelesen wird, bevor sie geschrieben ist" "Zuerst schreiben: VAR_TEMP beginnt mit dem, was andere Bausteine dort hinterlassen haben.";
    P4021 Warning "a temporary variable that is not written on every path" "Write it before the first branch, or make sure that the other paths are never taken."
        "eine temporäre Variable, die nicht auf jedem Weg geschrieben wird" "Vor der ersten Verzweigung schreiben, oder sicherstellen, dass die anderen Wege nie genommen werden.";
    P4022 Warning "an instruction on a value of another type" "Use the instruction for the type of the value, or convert the value first (ITD, DTR, RND)."
        "eine Operation auf einen Wert von anderem Datentyp" "Die Operation für den Datentyp des Werts verwenden, oder den Wert zuerst umwandeln (ITD, DTR, RND).";
    P4023 Warning "a timer or counter that no logic drives" "Write the condition before it, for example `A I 0.0`, or `SET` if it is always to be executed."
        "eine Zeit oder ein Zähler ohne Verknüpfung davor" "Die Bedingung davor schreiben, zum Beispiel `U E 0.0`, oder `SET`, wenn immer ausgeführt werden soll.";
    P4024 Warning "a temporary variable that a run read before it was written" "Write it on every path that leads to the statement."
        "eine temporäre Variable, die im Lauf gelesen wurde, bevor sie geschrieben war" "Auf jedem Weg schreiben, der zu der Anweisung führt.";
    P4025 Error "more local data than a block of the CPU type can have" "Move large variables from VAR_TEMP into a data block, or choose a larger CPU type: a CPU refuses to load the block."
        "mehr Lokaldaten, als ein Baustein des CPU-Typs haben kann" "Große Variablen aus VAR_TEMP in einen Datenbaustein verlegen oder einen größeren CPU-Typ wählen: Eine CPU lädt den Baustein nicht.";
    P4201 Error "a constant outside the range of its notation" "Use a value inside the range that the message names, or a notation with more bits, such as L# or DW#16#."
        "eine Konstante außerhalb des Bereichs ihrer Schreibweise" "Einen Wert in dem Bereich verwenden, den die Meldung nennt, oder eine Schreibweise mit mehr Bits, etwa L# oder DW#16#.";
    P4202 Error "a constant whose prefix is known, but not what follows it" "Write it the way the message shows."
        "eine Konstante mit bekanntem Präfix und unbekannter Fortsetzung" "So schreiben, wie die Meldung es zeigt.";
    P4203 Error "a date that the calendar does not have" "Check the month and the day; February has 29 days only in leap years."
        "ein Datum, das es im Kalender nicht gibt" "Monat und Tag prüfen; der Februar hat nur in Schaltjahren 29 Tage.";
    P4204 Error "a character that does not fit into one byte" "Use characters of the code pages 1252, 1250 or 1251, or write the byte as `$` and two hex digits."
        "ein Zeichen, das nicht in ein Byte passt" "Zeichen der Codepages 1252, 1250 oder 1251 verwenden, oder das Byte als `$` und zwei Hexadezimalziffern schreiben.";
    P4205 Error "a word that is no constant" "Use a constant such as 5, L#5, 1.5, W#16#00FF, 2#1010, C#20, S5T#2S, T#1H, D#2024-02-29, P#M 10.0, 'A' or TRUE."
        "ein Wort, das keine Konstante ist" "Eine Konstante verwenden, etwa 5, L#5, 1.5, W#16#00FF, 2#1010, C#20, S5T#2S, T#1H, D#2024-02-29, P#M 10.0, 'A' oder TRUE.";
    P4301 Error "an edge in a block that keeps nothing" "Draw it in a FUNCTION_BLOCK or PROGRAM, or hand the edge on as an input."
        "eine Flanke in einem Baustein, der nichts speichert" "In einem FUNCTION_BLOCK oder PROGRAM zeichnen, oder die Flanke als Eingang übergeben.";
    P4302 Error "a value that no line of a diagram carries" "Assign it to a variable at the output, and wire the variable to the input."
        "ein Wert, den keine Linie eines Plans führt" "Am Ausgang einer Variablen zuweisen und diese an den Eingang anschließen.";
    P4303 Error "a box of a function block without an instance" "Declare an instance in VAR and name it after the name of the function block."
        "eine Box eines Funktionsbausteins ohne Instanz" "Unter VAR eine Instanz deklarieren und sie nach dem Namen des Funktionsbausteins nennen.";
    P4304 Error "a box whose instance is of another function block" "Name an instance of the function block, or the function block of the instance."
        "eine Box, deren Instanz zu einem anderen Funktionsbaustein gehört" "Eine Instanz des Funktionsbausteins nennen, oder den Funktionsbaustein der Instanz.";
    P4305 Error "a box without a line to its first input" "Draw a line to the box, or write the input as a pin, such as `IN := x`."
        "eine Box ohne Linie zu ihrem ersten Eingang" "Eine Linie zur Box zeichnen, oder den Eingang als Anschluss schreiben, etwa `IN := x`.";

    // 5xxx limits of the CPU type
    P5001 Warning "an address beyond the areas of the CPU type" "Use an address that the CPU type has, or choose a larger CPU type."
        "eine Adresse außerhalb der Bereiche des CPU-Typs" "Eine Adresse verwenden, die der CPU-Typ hat, oder einen größeren CPU-Typ wählen.";
    P5002 Error "a block larger than 64 KB" "Split it into several blocks."
        "ein Baustein von mehr als 64 KB" "In mehrere Bausteine aufteilen.";
    P5003 Error "a block number that the CPU type does not have" "Use a lower number, or choose another CPU type."
        "eine Bausteinnummer, die der CPU-Typ nicht hat" "Eine kleinere Nummer verwenden, oder einen anderen CPU-Typ wählen.";
    P5004 Warning "a timer or counter that the CPU type does not have" "Use a lower number, or choose a larger CPU type."
        "eine Zeit oder ein Zähler, die der CPU-Typ nicht hat" "Eine kleinere Nummer verwenden, oder einen größeren CPU-Typ wählen.";
    P5005 Warning "an access behind the end of a data block" "Make the data block longer, or correct the address."
        "ein Zugriff hinter dem Ende eines Datenbausteins" "Den Datenbaustein verlängern, oder die Adresse berichtigen.";
    P5006 Error "more data than a CPU holds" "Make the data blocks smaller, or fewer."
        "mehr Daten, als eine CPU aufnimmt" "Die Datenbausteine verkleinern, oder weniger davon verwenden.";
    P5007 Warning "more local data than the CPU type has for a block" "Move large variables from VAR_TEMP into a data block."
        "mehr Lokaldaten, als der CPU-Typ für einen Baustein hat" "Große Variablen aus VAR_TEMP in einen Datenbaustein verlegen.";
    P5008 Warning "an instruction that the CPU type does not have" "Leave it out, or choose a CPU type with four accumulators, such as 416-3."
        "eine Operation, die der CPU-Typ nicht hat" "Weglassen, oder einen CPU-Typ mit vier Akkumulatoren wählen, etwa 416-3.";
    P5009 Warning "more code than a block of the CPU type can have" "Split the block into several, or leave it so if it need not go into a CPU."
        "mehr Code, als ein Baustein des CPU-Typs haben kann" "Den Baustein in mehrere aufteilen, oder so lassen, wenn er in keine CPU muss.";
    P5010 Warning "an organization block that the CPU type does not call" "Choose a CPU type that calls it, or another organization block."
        "ein Organisationsbaustein, den der CPU-Typ nicht aufruft" "Einen CPU-Typ wählen, der ihn aufruft, oder einen anderen Organisationsbaustein.";
    P5020 Warning "a system function that the CPU does not have" "Leave the call out, or evaluate RET_VAL, ERROR and BR: the call answers as a CPU without that hardware does."
        "eine Systemfunktion, die die CPU nicht hat" "Den Aufruf weglassen, oder RET_VAL, ERROR und BIE auswerten: Der Aufruf antwortet wie auf einer CPU ohne diese Hardware.";
    P5021 Warning "a condition that does not guard the load or transfer after it" "Jump over the load and transfer with `JCN` if the condition does not hold; use the condition with `=`, `S` or `R`; or remove it."
        "eine Bedingung, die das Laden oder Transferieren danach nicht schützt" "Laden und Transferieren mit `SPBN` überspringen, wenn die Bedingung nicht erfüllt ist; die Bedingung mit `=`, `S` oder `R` verwenden; oder sie entfernen.";
    P5022 Warning "one timer or counter instance driven twice" "Use a timer of its own for each purpose, or join the conditions and start it once."
        "eine Instanz einer Zeit oder eines Zählers, die zweimal angesteuert wird" "Für jeden Zweck eine eigene Zeit verwenden, oder die Bedingungen verknüpfen und sie einmal starten.";
    P5023 Warning "a zone of the master control relay that is never active" "Write `MCRA` before the zone and `MCRD` after it."
        "eine Zone des Master Control Relay, die nie aktiv ist" "Vor der Zone `MCRA` schreiben und danach `MCRD`.";
    P5024 Warning "a variable of a function block after AR2 or the DI register was changed" "Save the register before it is changed (`TAR2`, or `L DINO`) and restore it before the next parameter or static variable, or copy the variable to VAR_TEMP first."
        "eine Variable eines Funktionsbausteins, nachdem AR2 oder das DI-Register geändert wurde" "Das Register vor der Änderung sichern (`TAR2` oder `L DINO`) und vor dem nächsten Parameter oder der nächsten statischen Variablen wiederherstellen, oder die Variable zuerst nach VAR_TEMP kopieren.";
    P5025 Warning "an access that overwrites AR1" "Load AR1 again after the access, or copy the element to VAR_TEMP before AR1 is loaded."
        "ein Zugriff, der AR1 überschreibt" "AR1 nach dem Zugriff neu laden, oder das Element nach VAR_TEMP kopieren, bevor AR1 geladen wird.";
    P5026 Warning "a parameter as the pointer of an indirect address" "Copy the parameter to a variable of VAR_TEMP, and write that one in the brackets."
        "ein Parameter als Zeiger einer indirekten Adresse" "Den Parameter in eine Variable von VAR_TEMP kopieren und diese in die Klammern schreiben.";
    P5027 Warning "the address of a parameter of a function in an address register" "Load it into ACCU 1 first: `L P##…`, then `LAR1`."
        "die Adresse eines Parameters einer Funktion in einem Adressregister" "Zuerst in AKKU 1 laden: `L P##…`, dann `LAR1`.";
    P5028 Warning "an input that the program writes" "Write an output, bit memory or a data block; a test gives inputs their values from outside."
        "ein Eingang, den das Programm schreibt" "Einen Ausgang, einen Merker oder einen Datenbaustein schreiben; Eingänge erhalten im Test ihre Werte von außen.";
    P5029 Warning "an S5TIME that is much shorter than it is written" "Write a multiple of 10 ms; an IEC timer with TIME counts single milliseconds."
        "eine S5TIME, die viel kürzer ist, als sie geschrieben ist" "Ein Vielfaches von 10 ms schreiben; eine IEC-Zeit mit TIME zählt einzelne Millisekunden.";
    P5030 Warning "a bit that is set and reset again in the same scan" "Leave the block with `BEC` after the first half, or use an edge of the condition for each half."
        "ein Bit, das im selben Zyklus gesetzt und wieder rückgesetzt wird" "Den Baustein nach der ersten Hälfte mit `BEB` verlassen, oder für jede Hälfte eine Flanke der Bedingung verwenden.";

    // 6xxx files and projects
    P6001 Error "a file that cannot be read" "Check the path and the permissions."
        "eine Datei, die nicht gelesen werden kann" "Pfad und Rechte prüfen.";
    P6004 Warning "an empty source file" "Write statements or blocks into it, or take it out of the project."
        "eine leere Quelldatei" "Anweisungen oder Bausteine hineinschreiben, oder sie aus dem Projekt nehmen.";
    P6005 Error "a project without a source" "Put STL sources (`.awl`) into the folder, or name them in `sources` of `sieben.toml`; `sieben new NAME` makes a project that runs."
        "ein Projekt ohne Quelle" "AWL-Quellen (`.awl`) in den Ordner legen oder unter `sources` in `sieben.toml` nennen; `sieben new NAME` legt ein lauffähiges Projekt an.";
    P6006 Error "a folder where a file is wanted" "Name a file inside the folder."
        "ein Ordner, wo eine Datei verlangt ist" "Eine Datei in dem Ordner angeben.";
    P6007 Error "a project file that is not valid TOML" "Mend the line; texts stand in quotes, lists in square brackets."
        "eine Projektdatei, die kein gültiges TOML ist" "Die Zeile berichtigen; Texte stehen in Anführungszeichen, Listen in eckigen Klammern.";
    P6008 Error "a key that a project file does not have" "Use a key that the message names, or remove the line."
        "ein Schlüssel, den eine Projektdatei nicht hat" "Einen Schlüssel verwenden, den die Meldung nennt, oder die Zeile entfernen.";
    P6009 Error "a value that a key of a project file cannot have" "Write the value the way the message shows."
        "ein Wert, den ein Schlüssel einer Projektdatei nicht haben kann" "Den Wert so schreiben, wie die Meldung es zeigt.";
    P6010 Error "a path that leaves the project folder" "Move the file into the project folder and name it by a path without `..` in front."
        "ein Pfad, der den Projektordner verlässt" "Die Datei in den Projektordner legen und mit einem Pfad ohne führendes `..` nennen.";
    P6011 Warning "a pattern of a project file that matches no file" "Check the spelling of the pattern; `**` stands for any number of folders."
        "ein Muster einer Projektdatei, zu dem keine Datei passt" "Die Schreibweise des Musters prüfen; `**` steht für beliebig viele Ordner.";
    P6012 Warning "a key of a project file that this version does not use yet" "Leave it for a later version, or remove it."
        "ein Schlüssel einer Projektdatei, den diese Version noch nicht verwendet" "Für eine spätere Version stehen lassen, oder entfernen.";
    P6013 Error "a file that cannot be written" "Check the path, the permissions and the space on the disk."
        "eine Datei, die nicht geschrieben werden kann" "Pfad, Rechte und freien Platz auf dem Datenträger prüfen.";
    P6014 Error "something of this name exists already" "Choose another name, or remove what is there first; nothing is overwritten."
        "etwas, das es unter diesem Namen schon gibt" "Einen anderen Namen wählen, oder zuerst das Vorhandene entfernen; überschrieben wird nichts.";
    P6015 Error "a folder with too many files" "Name the sources in `sieben.toml`, so that the whole folder need not be searched."
        "ein Ordner mit zu vielen Dateien" "Die Quellen in `sieben.toml` nennen, damit nicht der ganze Ordner durchsucht werden muss.";
    P6030 Warning "a retentive range beyond the CPU type" "Shorten the range, or choose a CPU type with more bit memory, timers or counters."
        "ein remanenter Bereich außerhalb des CPU-Typs" "Den Bereich kürzen, oder einen CPU-Typ mit mehr Merkern, Zeiten oder Zählern wählen.";
    P6031 Error "retentive data that another run is using" "End the other run, name another file with --retain, or run with --no-retain."
        "remanente Daten, die ein anderer Lauf verwendet" "Den anderen Lauf beenden, mit --retain eine andere Datei angeben, oder mit --no-retain laufen lassen.";
    P6032 Error "retentive data that cannot be read" "Check the path and the permissions, or run with --no-retain, which leaves the file alone."
        "remanente Daten, die nicht gelesen werden können" "Pfad und Rechte prüfen, oder mit --no-retain laufen lassen: Dann bleibt die Datei unberührt.";
    P6040 Error "an awlsim project that is not XML" "Save the project anew, or restore the file; a project has neither DTD nor entities of its own."
        "ein awlsim-Projekt, das kein XML ist" "Das Projekt neu speichern oder die Datei wiederherstellen; ein Projekt hat weder DTD noch eigene Entitäten.";
    P6041 Error "a file that is no awlsim project of a known version" "Name a file that awlsim has saved as `.awlpro`, format version 1."
        "eine Datei, die kein awlsim-Projekt einer bekannten Version ist" "Eine Datei angeben, die awlsim als `.awlpro` gespeichert hat, Formatversion 1.";
    P6042 Error "a value that an awlsim project cannot have" "Write the value the way the message shows, or set it in awlsim."
        "ein Wert, den ein awlsim-Projekt nicht haben kann" "Den Wert so schreiben, wie die Meldung es zeigt, oder ihn in awlsim einstellen.";
    P6043 Error "a diagram in an awlsim project" "Write the diagram as STL, or disable it in the project."
        "ein Plan in einem awlsim-Projekt" "Den Plan als AWL schreiben, oder ihn im Projekt abschalten.";
    P6044 Warning "a part of an awlsim project that is not used" "Remove it from the project, or live without it: the rest of the project runs."
        "ein Teil eines awlsim-Projekts, der nicht verwendet wird" "Aus dem Projekt entfernen, oder darauf verzichten: Der Rest des Projekts läuft.";
    P6045 Error "a library block of an awlsim project that Sieben does not have" "Write the block yourself, or take it out of the project; `sieben explain library` lists the blocks there are."
        "ein Bibliotheksbaustein eines awlsim-Projekts, den Sieben nicht hat" "Den Baustein selbst schreiben, oder ihn aus dem Projekt nehmen; `sieben explain library` zeigt die vorhandenen.";
    P6046 Error "a file inside a project that cannot be written alone" "Change the source in the program that wrote the project."
        "eine Datei in einem Projekt, die nicht einzeln geschrieben werden kann" "Die Quelle in dem Programm ändern, das das Projekt geschrieben hat.";
    P6050 Error "a construct that the dialect does not have" "Write what the message names, or name the dialect of the file with --dialect."
        "ein Konstrukt, das der Dialekt nicht hat" "Schreiben, was die Meldung nennt, oder den Dialekt der Datei mit --dialect angeben.";
    P6051 Warning "a construct that is not usual in the dialect" "Write what the message names if the source has to go back into another tool."
        "ein Konstrukt, das im Dialekt nicht üblich ist" "Schreiben, was die Meldung nennt, wenn die Quelle in ein anderes Werkzeug zurück soll.";
    P6052 Error "an operator of another language" "Write the operator that the message names: `=`, `<>`, `<=`, `AND`, `OR`, `NOT`."
        "ein Operator einer anderen Sprache" "Den Operator schreiben, den die Meldung nennt: `=`, `<>`, `<=`, `AND`, `OR`, `NOT`.";
    P6053 Error "a statement or declaration without its semicolon" "Write `;` where the message points."
        "eine Anweisung oder Deklaration ohne Semikolon" "`;` schreiben, wo die Meldung hinzeigt.";
    P6054 Error "a statement that is not understood" "Write an assignment `x := 1;`, a call `f();` or a statement such as IF."
        "eine Anweisung, die nicht verstanden wird" "Eine Zuweisung `x := 1;`, einen Aufruf `f();` oder eine Anweisung wie IF schreiben.";
    P6055 Error "an expression that is not understood" "Write a variable, a constant or a call between two operators."
        "ein Ausdruck, der nicht verstanden wird" "Zwischen zwei Operatoren eine Variable, eine Konstante oder einen Aufruf schreiben.";
    P6056 Error "a keyword that is missing" "Write the keyword that the message names."
        "ein fehlendes Schlüsselwort" "Das Schlüsselwort schreiben, das die Meldung nennt.";
    P6057 Error "a statement without its end" "Write the END_ keyword of the statement behind its last line."
        "eine Anweisung ohne Ende" "Nach ihrer letzten Zeile das END_-Schlüsselwort der Anweisung schreiben.";
    P6058 Error "the end keyword of another statement" "Use the END_ keyword that belongs to the first keyword of the statement."
        "das Endeschlüsselwort einer anderen Anweisung" "Das END_-Schlüsselwort verwenden, das zum ersten Schlüsselwort der Anweisung gehört.";
    P6059 Error "a part of a statement that did not begin" "Remove it, or write the beginning of the statement."
        "ein Teil einer Anweisung, die nicht begonnen hat" "Entfernen, oder den Anfang der Anweisung schreiben.";
    P6060 Error "a keyword in the place of a name" "Choose another name; a keyword cannot be one, in any case of letters."
        "ein Schlüsselwort an der Stelle eines Namens" "Einen anderen Namen wählen; ein Schlüsselwort kann keiner sein, gleich ob groß oder klein geschrieben.";
    P6061 Error "another word for ELSIF" "Write `ELSIF`; `ELSE IF` begins another IF, which needs its own `END_IF`."
        "ein anderes Wort für ELSIF" "`ELSIF` schreiben; `ELSE IF` beginnt ein weiteres IF, das sein eigenes `END_IF` braucht.";
    P6063 Error "a nesting that is too deep" "Put the inner part into a function, or assign a part of the expression to a variable first."
        "eine zu tiefe Schachtelung" "Den inneren Teil in eine Funktion legen, oder einen Teil des Ausdrucks zuerst einer Variablen zuweisen.";
    P6064 Error "RETURN with a value" "Assign the value to the name of the function, then write `RETURN;`."
        "RETURN mit einem Wert" "Den Wert dem Namen der Funktion zuweisen, dann `RETURN;` schreiben.";
    P6065 Error "a round bracket that is not closed" "Write `)` where the message points."
        "eine runde Klammer, die nicht geschlossen wird" "`)` schreiben, wo die Meldung hinzeigt.";
    P6066 Error "a pragma without its end" "Write `}` on the line where the pragma begins or behind its last attribute."
        "ein Pragma ohne Ende" "`}` in der Zeile schreiben, in der das Pragma beginnt, oder nach seinem letzten Attribut.";
    P6071 Error "a label of CASE that is not understood" "Write a constant, constants with commas, or a range `1..5`, and `:` behind it."
        "ein Wert einer CASE-Anweisung, der nicht verstanden wird" "Eine Konstante, Konstanten mit Kommas oder einen Bereich `1..5` schreiben, und danach `:`.";
    P6072 Error "a folder with several programs where one is wanted" "Name the files of one of them instead of the folder."
        "ein Ordner mit mehreren Programmen, wo eines verlangt ist" "Statt des Ordners die Dateien eines der Programme angeben.";
    P6073 Warning "a test file that belongs to no program" "Call it like the program that it tests: `ue1.test.st` for `ue1.awl`."
        "eine Testdatei, die zu keinem Programm gehört" "Wie das Programm nennen, das sie prüft: `ue1.test.st` für `ue1.awl`.";
    P6075 Error "a folder with too much to read for all its programs" "Name its sub-folders one by one, or put what belongs together into projects with a `sieben.toml`."
        "ein Ordner, in dem für alle seine Programme zu viel zu lesen ist" "Die Unterordner einzeln angeben, oder Zusammengehöriges in Projekte mit einer `sieben.toml` legen.";
    P6076 Warning "a source in another language than its name says" "Rename the file: `.awl` or `.stl` for STL, `.st` or `.scl` for Structured Text; it was read as what it holds."
        "eine Quelle in einer anderen Sprache, als ihr Name sagt" "Die Datei umbenennen: `.awl` oder `.stl` für AWL, `.st` oder `.scl` für Strukturierten Text; sie wurde nach ihrem Inhalt gelesen.";
    P6077 Error "a file of TwinCAT that is not XML" "Save the object in TwinCAT again; such a file has neither DTD nor entities of its own."
        "eine Datei von TwinCAT, die kein XML ist" "Das Objekt in TwinCAT noch einmal speichern; eine solche Datei hat weder DTD noch eigene Entitäten.";
    P6078 Error "a body that is a diagram" "Write the body in Structured Text; its declaration was read."
        "ein Rumpf, der ein Plan ist" "Den Rumpf in Strukturiertem Text schreiben; seine Deklaration wurde gelesen.";
    P6079 Error "a file of TwinCAT that holds nothing to read" "Name files with a POU, an interface, a type or a list of global variables."
        "eine Datei von TwinCAT, in der nichts zu lesen ist" "Dateien mit einer POU, einer Schnittstelle, einem Datentyp oder einer Liste globaler Variablen angeben.";
    P6080 Error "a file that holds more than the text of a source" "Lay it out or convert it in the tool that wrote it; `sieben check --fix` changes such files in place."
        "eine Datei, die mehr enthält als den Text einer Quelle" "Im Werkzeug formatieren oder umwandeln, das sie geschrieben hat; `sieben check --fix` ändert solche Dateien an Ort und Stelle.";

    P6101 Error "a symbol that stands twice in the table" "Rename or delete one of the two rows; case does not distinguish symbols."
        "ein Symbol, das zweimal in der Tabelle steht" "Eine der beiden Zeilen umbenennen oder löschen; Groß- und Kleinschreibung unterscheidet Symbole nicht.";
    P6102 Warning "an address with two symbols" "Keep the symbol that the program uses."
        "eine Adresse mit zwei Symbolen" "Das Symbol behalten, das das Programm verwendet.";
    P6103 Error "an address in the symbol table that is not understood" "Write it as in a program, in either mnemonic language: `I 0.0`, `QW 4`, `T 1`, `DB 5`."
        "eine Adresse in der Symboltabelle, die nicht verstanden wird" "Wie im Programm schreiben, in einer der beiden Mnemoniken: `E 0.0`, `AW 4`, `T 1`, `DB 5`.";
    P6104 Error "a symbol table without a necessary column" "Let the first line name the columns, at least `symbol,address`."
        "eine Symboltabelle ohne eine notwendige Spalte" "Die erste Zeile nennt die Spalten, mindestens `symbol,address`.";
    P6105 Error "a line of a symbol table that does not have the form of its format" "Compare the line with its neighbours, or export the table again."
        "eine Zeile einer Symboltabelle, die nicht die Form ihres Formats hat" "Die Zeile mit ihren Nachbarn vergleichen, oder die Tabelle noch einmal exportieren.";
    P6106 Warning "a symbol longer than 24 characters" "Shorten it if the table has to go back into STEP 7 V5."
        "ein Symbol mit mehr als 24 Zeichen" "Kürzen, wenn die Tabelle nach STEP 7 V5 zurück soll.";
    P6107 Warning "a row without a symbol or without an address" "Complete the row or delete it; the program cannot use it."
        "eine Zeile ohne Symbol oder ohne Adresse" "Die Zeile ergänzen oder löschen; das Programm kann sie nicht verwenden.";
    P6108 Error "a quotation mark that is never closed" "Close it at the end of the field; the rows behind it were not read."
        "ein Anführungszeichen, das nie geschlossen wird" "Am Ende des Felds schließen; die Zeilen danach wurden nicht gelesen.";
    P6109 Warning "a data type that does not fit the address" "Change the type or the address, so that both have the same width."
        "ein Datentyp, der nicht zur Adresse passt" "Den Datentyp oder die Adresse ändern, so dass beide dieselbe Breite haben.";
    P6110 Error "a symbol with a character that no symbol may contain" "Remove quotation marks and control characters from the name."
        "ein Symbol mit einem Zeichen, das kein Symbol enthalten darf" "Anführungszeichen und Steuerzeichen aus dem Namen entfernen.";
    P6111 Error "a symbol table that ends too early" "Export the table again; the file seems to be cut."
        "eine Symboltabelle, die zu früh endet" "Die Tabelle noch einmal exportieren; die Datei scheint abgeschnitten zu sein.";
    P6112 Warning "a symbol table with another number of rows than its head says" "Export the table again, or look whether rows are missing."
        "eine Symboltabelle mit einer anderen Zahl von Zeilen, als ihr Kopf sagt" "Die Tabelle noch einmal exportieren, oder nachsehen, ob Zeilen fehlen.";
    P6113 Warning "a symbol table in another format than its name says" "Rename the file; it was read as what it holds."
        "eine Symboltabelle in einem anderen Format, als ihr Name sagt" "Die Datei umbenennen; sie wurde nach ihrem Inhalt gelesen.";
    P6120 Error "an organization block without a number" "Name it `OB1`, or give its name the address of an organization block in the symbol table."
        "ein Organisationsbaustein ohne Nummer" "`OB1` nennen, oder seinem Namen in der Symboltabelle die Adresse eines Organisationsbausteins geben.";
    P6122 Error "a value that is not known when the program is compiled" "Use constants only: numbers, CONST, VAR CONSTANT, values of enumerations."
        "ein Wert, der beim Übersetzen nicht bekannt ist" "Nur Konstanten verwenden: Zahlen, CONST, VAR CONSTANT, Werte von Aufzählungen.";
    P6127 Error "an address or a view that a variable cannot have" "Use an address of the width of the type, or a view that is not longer than its variable."
        "eine Adresse oder Sicht, die eine Variable nicht haben kann" "Eine Adresse von der Breite des Datentyps verwenden, oder eine Sicht, die nicht länger ist als ihre Variable.";
    P6130 Error "a task that the CPU cannot run" "Write an interval of 1 ms to 60 s, or none for the cycle."
        "eine Task, die die CPU nicht ausführen kann" "Ein Intervall von 1 ms bis 60 s schreiben, oder keines für den Zyklus.";
    P6132 Error "an instance where nothing is kept" "Declare it under VAR of a FUNCTION_BLOCK or PROGRAM, or under VAR_GLOBAL."
        "eine Instanz, wo nichts gespeichert wird" "Unter VAR eines FUNCTION_BLOCK oder PROGRAM deklarieren, oder unter VAR_GLOBAL.";
    P6133 Warning "a table without a header that was read as an assignment table" "Write a first line with the names of its columns, such as `number,address,unit,symbol,comment,remark`."
        "eine Tabelle ohne Kopf, die als Zuordnungstabelle gelesen wurde" "Eine erste Zeile mit den Namen der Spalten schreiben, etwa `number,address,unit,symbol,comment,remark`.";

    // 62xx statements of ST
    P6200 Error "a value of another type" "Convert it with a function such as `INT_TO_REAL`, or declare the variable with the type of the value."
        "ein Wert von anderem Datentyp" "Mit einer Funktion wie `INT_TO_REAL` umwandeln, oder die Variable mit dem Datentyp des Werts deklarieren.";
    P6201 Warning "a conversion that may lose something" "Convert the value with a function if this is meant, such as `DINT_TO_REAL`."
        "eine Umwandlung, bei der etwas verloren gehen kann" "Den Wert mit einer Funktion umwandeln, wenn das gewollt ist, etwa `DINT_TO_REAL`.";
    P6202 Error "an operator with operands that it does not take" "Convert the operands, or use the operator for their type."
        "ein Operator mit Operanden, die er nicht nimmt" "Die Operanden umwandeln, oder den Operator für ihren Datentyp verwenden.";
    P6203 Error "a condition that is not BOOL" "Compare the value with something, for example `<> 0`."
        "eine Bedingung, die nicht BOOL ist" "Den Wert mit etwas vergleichen, zum Beispiel `<> 0`.";
    P6204 Error "something that cannot be assigned to" "Assign to a variable that the block may write."
        "etwas, dem nichts zugewiesen werden kann" "Einer Variablen zuweisen, die der Baustein schreiben darf.";
    P6207 Error "a value of CASE that an earlier label covers" "Remove one of the two labels."
        "ein Wert von CASE, den ein früherer schon enthält" "Einen der beiden entfernen.";
    P6208 Warning "a value of CASE that an earlier label covers already" "Remove one of the two labels; the first one is taken."
        "ein Wert von CASE, den ein früherer bereits enthält" "Einen der beiden entfernen; der erste gilt.";
    P6209 Error "an empty range" "Write the lower value first, as in `5..9`."
        "ein leerer Bereich" "Den kleineren Wert zuerst schreiben, wie in `5..9`.";
    P6210 Error "a FOR that does not count with an integer" "Count with an INT or DINT, and compute the REAL from it."
        "ein FOR, das nicht mit einer ganzen Zahl zählt" "Mit INT oder DINT zählen und den REAL daraus berechnen.";
    P6211 Error "a step of 0" "Write a step other than 0, or leave BY away for a step of 1."
        "eine Schrittweite von 0" "Eine Schrittweite ungleich 0 schreiben, oder BY weglassen für die Schrittweite 1.";
    P6212 Warning "a FOR that never or always runs" "Check the first value, the last value and the step."
        "ein FOR, das nie oder immer läuft" "Anfangswert, Endwert und Schrittweite prüfen.";
    P6213 Error "EXIT or CONTINUE outside of a loop" "Use RETURN to leave the block."
        "EXIT oder CONTINUE außerhalb einer Schleife" "Mit RETURN verlässt man den Baustein.";
    P6215 Error "a jump into a statement" "Jump only to labels in the same list of statements, or further out."
        "ein Sprung in eine Anweisung hinein" "Nur zu Marken in derselben Anweisungsliste oder weiter außen springen.";
    P6216 Error "an expression where a statement should stand" "Assign it to a variable with `:=`, or call it with `()`."
        "ein Ausdruck, wo eine Anweisung stehen sollte" "Mit `:=` einer Variablen zuweisen, oder mit `()` aufrufen.";
    P6217 Error "a call of something that cannot be called" "Call a function by its name, and a function block by its instance."
        "ein Aufruf von etwas, das nicht aufgerufen werden kann" "Eine Funktion mit ihrem Namen aufrufen, einen Funktionsbaustein über seine Instanz.";
    P6218 Error "a call without a result where a value is needed" "Write the call as a statement of its own, and read its outputs."
        "ein Aufruf ohne Ergebnis, wo ein Wert gebraucht wird" "Den Aufruf als eigene Anweisung schreiben und seine Ausgänge lesen.";
    P6219 Error "parameters that do not fit the call" "Give inputs with `:=` and outputs with `=>`, each once."
        "Parameter, die nicht zum Aufruf passen" "Eingänge mit `:=` und Ausgänge mit `=>` angeben, jeden einmal.";
    P6221 Warning "a comparison that is always true or always false" "Compare with a value that the variable can have."
        "ein Vergleich, der immer wahr oder immer falsch ist" "Mit einem Wert vergleichen, den die Variable haben kann.";
    P6222 Warning "a variable that is never used" "Remove it, or use it."
        "eine Variable, die nie verwendet wird" "Entfernen, oder verwenden.";
    P6223 Warning "a function whose result is not set on every path" "Assign a value to the name of the function at its beginning."
        "eine Funktion, deren Ergebnis nicht auf jedem Weg gesetzt wird" "Dem Namen der Funktion an ihrem Anfang einen Wert zuweisen.";
    P6225 Error "a part that the value does not have" "Use a number inside the width of the type; bit 0 is the lowest."
        "ein Teil, den der Wert nicht hat" "Eine Zahl innerhalb der Breite des Datentyps verwenden; Bit 0 ist das niedrigste.";
    P6226 Error "something that cannot be compiled yet" "Write it another way; see the list of what is built in the reference of the language."
        "etwas, das noch nicht übersetzt werden kann" "Anders schreiben; die Referenz der Sprache sagt, was es gibt.";
    P6227 Warning "a division by the constant 0" "Divide by something else; the result is 0."
        "eine Division durch die Konstante 0" "Durch etwas anderes teilen; das Ergebnis ist 0.";
    P6228 Error "something that is followed like a reference and is none" "Write `^` only behind a REF_TO or POINTER TO variable."
        "etwas, dem wie einer Referenz gefolgt wird und das keine ist" "`^` nur nach einer Variablen vom Typ REF_TO oder POINTER TO schreiben.";
    P6229 Error "a value that has to be constant" "Use a number, a declared constant or a value of an enumeration."
        "ein Wert, der konstant sein muss" "Eine Zahl, eine deklarierte Konstante oder einen Wert einer Aufzählung verwenden.";
    P6230 Error "a name that means several things" "Write the name of the enumeration before the value."
        "ein Name, der mehreres bedeutet" "Den Namen der Aufzählung vor den Wert schreiben.";
    P6231 Error "a read of something that can only be written" "Read the process image instead."
        "das Lesen von etwas, das nur geschrieben werden kann" "Stattdessen das Prozessabbild lesen.";
    P6232 Warning "a result that nobody uses" "Assign it to a variable, or remove the call."
        "ein Ergebnis, das nicht verwendet wird" "Einer Variablen zuweisen, oder den Aufruf entfernen.";
    P6233 Error "a CASE of something that has no whole numbers" "Use IF and ELSIF."
        "ein CASE über etwas, das keine ganzen Zahlen hat" "IF und ELSIF verwenden.";
    P6240 Error "a test file where a program is wanted" "Run it with `sieben test`."
        "eine Testdatei, wo ein Programm verlangt ist" "Mit `sieben test` ausführen.";

    // 626x scenarios and recordings
    P6260 Error "a line of a scenario that is not understood" "Write one of the lines of the scenario language; `//` begins a comment."
        "eine Zeile eines Szenarios, die nicht verstanden wird" "Eine der Zeilen der Szenariosprache schreiben; `//` beginnt einen Kommentar.";
    P6261 Error "an expectation of a scenario that did not come true" "Compare the values before that scan with what the program should do with them."
        "eine Erwartung eines Szenarios, die nicht eingetroffen ist" "Die Werte vor diesem Zyklus mit dem vergleichen, was das Programm daraus machen soll.";
    P6262 Error "a file that is no recording, or a damaged one" "Name a file that `sieben trace --record` has written."
        "eine Datei, die keine Aufzeichnung oder beschädigt ist" "Eine Datei angeben, die `sieben trace --record` geschrieben hat.";
    P6263 Warning "a recording that was cut off" "What was written before is shown; record again for the rest."
        "eine abgeschnittene Aufzeichnung" "Gezeigt wird, was davor geschrieben wurde; für den Rest noch einmal aufzeichnen.";
    P6264 Error "a recording of another program" "Name the sources it was recorded with, or leave them out to see it all the same."
        "eine Aufzeichnung eines anderen Programms" "Die Quellen angeben, mit denen aufgezeichnet wurde, oder sie weglassen, um die Aufzeichnung trotzdem zu sehen.";

    // 627x simulated devices
    P6270 Error "a kind of module that does not exist" "Use a kind that the message names; `docs/reference/plants.md` describes each."
        "eine Baugruppenart, die es nicht gibt" "Eine Art verwenden, die die Meldung nennt; `docs/reference/plants.md` beschreibt jede.";
    P6271 Error "a module with a value that it cannot have" "Use a value in the range that the message names, and a name of its own for every module."
        "eine Baugruppe mit einem Wert, den sie nicht haben kann" "Einen Wert in dem Bereich verwenden, den die Meldung nennt, und für jede Baugruppe einen eigenen Namen.";
    P6272 Error "a fault that the module cannot have" "Write the signal and how it fails: `level stuck@30s`, `level drift=0.5`, `low late=200ms` or `low bounce=50ms`."
        "ein Fehler, den die Baugruppe nicht haben kann" "Das Signal und seinen Fehler schreiben: `level stuck@30s`, `level drift=0.5`, `low late=200ms` oder `low bounce=50ms`.";

    // 628x classes and interfaces
    P6280 Error "a block that cannot be extended or implemented like this" "Name a FUNCTION_BLOCK or CLASS behind EXTENDS, and INTERFACEs behind IMPLEMENTS."
        "ein Baustein, der so nicht erweitert oder implementiert werden kann" "Nach EXTENDS einen FUNCTION_BLOCK oder eine CLASS nennen, nach IMPLEMENTS Schnittstellen (INTERFACE).";
    P6281 Error "a method or property that is missing" "Declare it with the same parameters, or make the block ABSTRACT."
        "eine fehlende Methode oder Eigenschaft" "Mit denselben Parametern deklarieren, oder den Baustein ABSTRACT machen.";
    P6282 Error "a method with other parameters than the one that it stands for" "Give it the same parameters, types and result."
        "eine Methode mit anderen Parametern als die, für die sie steht" "Ihr dieselben Parameter, Datentypen und dasselbe Ergebnis geben.";
    P6283 Error "a method that does not fit what it overrides" "Override only what is there and not FINAL; leave the statements of an ABSTRACT method away."
        "eine Methode, die nicht zu dem passt, was sie überschreibt" "Nur überschreiben, was es gibt und nicht FINAL ist; bei einer ABSTRACT-Methode die Anweisungen weglassen.";
    P6284 Error "a member that may not be used here" "Make it PUBLIC, or use it inside the block that has it."
        "ein Element, das hier nicht verwendet werden darf" "PUBLIC machen, oder in dem Baustein verwenden, der es hat.";
    P6285 Error "an instance of something that has none" "Declare an instance of a block that is not ABSTRACT, or a variable of the interface."
        "eine Instanz von etwas, das keine hat" "Eine Instanz eines Bausteins deklarieren, der nicht ABSTRACT ist, oder eine Variable der Schnittstelle.";
    P6286 Error "THIS or SUPER where there is none" "Use them in methods and statements of a FUNCTION_BLOCK or CLASS; SUPER where it extends another one."
        "THIS oder SUPER, wo es keines gibt" "In Methoden und Anweisungen eines FUNCTION_BLOCK oder einer CLASS verwenden; SUPER dort, wo er einen anderen erweitert.";
    P6287 Error "a property that is used in a way that it does not have" "Give the property a GET to read it and a SET to assign to it."
        "eine Eigenschaft, die auf eine Art verwendet wird, die sie nicht hat" "Der Eigenschaft ein GET zum Lesen und ein SET zum Zuweisen geben.";

    // 629x recordings that other programs are held against
    P6290 Error "a recording that cannot be written on" "Make room and record again; the scans that were written before are whole and can be used."
        "eine Aufzeichnung, die nicht weitergeschrieben werden kann" "Platz schaffen und noch einmal aufzeichnen; die bis dahin geschriebenen Zyklen sind vollständig und brauchbar.";
    P6291 Error "a run that cannot be recorded" "Record without what the message names, or record the parts before and behind it."
        "ein Lauf, der nicht aufgezeichnet werden kann" "Ohne das aufzeichnen, was die Meldung nennt, oder die Teile davor und danach aufzeichnen.";
    P6292 Error "a recording with names that the program does not have" "Say what they are called here: `--map OLD=NEW`, or `--map FILE` with such a line for each; `--ignore OLD` leaves an output out."
        "eine Aufzeichnung mit Namen, die das Programm nicht hat" "Sagen, wie sie hier heißen: `--map ALT=NEU`, oder `--map DATEI` mit einer solchen Zeile für jeden; `--ignore ALT` lässt einen Ausgang aus.";

    // 630x results of tests
    P6300 Error "a folder that pages of coverage cannot be written into" "Name a folder that does not exist yet, or one that holds such pages: other files are not overwritten."
        "ein Ordner, in den keine Seiten der Testabdeckung geschrieben werden können" "Einen Ordner angeben, den es noch nicht gibt oder der solche Seiten enthält: Andere Dateien werden nicht überschrieben.";

    // 631x configurations
    P6310 Error "a variable that waits for its address" "Give it one in VAR_CONFIG of a CONFIGURATION, or write the address where it is declared."
        "eine Variable, die auf ihre Adresse wartet" "Ihr in VAR_CONFIG einer CONFIGURATION eine geben, oder die Adresse bei der Deklaration schreiben.";
    P6311 Error "a path of VAR_CONFIG or VAR_ACCESS that leads nowhere" "Write the instance of the PROGRAM, the instances inside it and the variable, with points between them."
        "ein Pfad von VAR_CONFIG oder VAR_ACCESS, der nirgends hinführt" "Die Instanz des PROGRAM, die Instanzen darin und die Variable schreiben, mit Punkten dazwischen.";
    P6312 Error "an array of unknown length as a whole" "Use its elements from LOWER_BOUND to UPPER_BOUND, or give it to another ARRAY[*]."
        "ein Feld unbekannter Länge als Ganzes" "Seine Elemente von LOWER_BOUND bis UPPER_BOUND verwenden, oder es an ein anderes ARRAY[*] übergeben.";
    P6320 Error "a conversion without a type to convert to" "Assign the result to a variable in a statement of its own."
        "eine Umwandlung ohne Zieltyp" "Das Ergebnis in einer eigenen Anweisung einer Variablen zuweisen.";
    P6321 Error "a timer or a counter of which no call says what it is" "Write the instruction behind it: `t.TON(IN := …, PT := …)`."
        "eine Zeit oder ein Zähler, zu denen kein Aufruf sagt, was sie sind" "Die Operation dahinter schreiben: `t.TON(IN := …, PT := …)`.";
    P6322 Error "a conversion that does not exist" "Convert to a type that the message or `sieben explain T_CONV` names, or in two steps."
        "eine Umwandlung, die es nicht gibt" "In einen Datentyp umwandeln, den die Meldung oder `sieben explain T_CONV` nennt, oder in zwei Schritten.";
    P6323 Error "a function of the system that does not exist here" "Do without it, as the message shows."
        "eine Funktion des Systems, die es hier nicht gibt" "Ohne sie auskommen, so wie die Meldung es zeigt.";
    P6324 Error "a VARIANT whose type is not known" "Declare the parameter as VARIANT, or use a variable of the type that is meant."
        "ein VARIANT, dessen Datentyp nicht bekannt ist" "Den Parameter als VARIANT deklarieren, oder eine Variable des gemeinten Datentyps verwenden.";
    P6325 Error "a type that is used like a value" "Compare it with another type: `TypeOf(v) = INT`."
        "ein Datentyp, der wie ein Wert verwendet wird" "Mit einem anderen Datentyp vergleichen: `TypeOf(v) = INT`.";
    P6326 Warning "a STRING that is longer than those of the S7" "Mind that characters beyond the 254th are cut off, or declare STRING(254)."
        "ein STRING, der länger ist als die der S7" "Zeichen nach dem 254. werden abgeschnitten; sonst STRING(254) deklarieren.";
    P6327 Error "arguments of an instance that its FB_Init does not take" "Give what FB_Init declares, as constants or variables."
        "Argumente einer Instanz, die ihr FB_Init nicht nimmt" "Angeben, was FB_Init deklariert, als Konstanten oder Variablen.";
    P6328 Warning "a 0 behind the characters of a text" "Give the text its length first, for example by assigning as many blanks, or join it with CONCAT."
        "eine 0 nach den Zeichen einer Zeichenkette" "Der Zeichenkette zuerst ihre Länge geben, etwa durch Zuweisen ebenso vieler Leerzeichen, oder sie mit CONCAT anhängen.";
    P6329 Error "the number of a block of the library is taken" "Give the block of the program another number."
        "die Nummer eines Bausteins der Bibliothek ist vergeben" "Dem Baustein des Programms eine andere Nummer geben.";
    P6330 Warning "a variable whose address nobody tells" "Write the address, or a VAR_CONFIG with it."
        "eine Variable, deren Adresse nirgends steht" "Die Adresse schreiben, oder ein VAR_CONFIG mit ihr.";
    P6331 Error "a body in another language" "Write it in Structured Text."
        "ein Rumpf in einer anderen Sprache" "Ihn in Strukturiertem Text schreiben.";
    P6332 Warning "VAR in an organization block" "Write `VAR_TEMP`, or keep the value in a data block or in bit memory."
        "VAR in einem Organisationsbaustein" "`VAR_TEMP` schreiben, oder den Wert in einem Datenbaustein oder Merker halten.";

    // 7xxx command line
    P7001 Error "an argument that is not understood" "See `sieben help` for what the command takes."
        "ein Argument, das nicht verstanden wird" "`sieben help` zeigt, was der Befehl nimmt.";
    P7002 Error "a CPU type that does not exist" "Use a CPU type that the message names; `sieben explain cpu` shows what each has."
        "ein CPU-Typ, den es nicht gibt" "Einen CPU-Typ verwenden, den die Meldung nennt; `sieben explain cpu` zeigt, was jeder hat.";
    P7003 Error "a name that cannot be set or shown" "Use an address (`I 0.0`, `MW10`, `DB1.DBD4`), `T 1`, `C 1`, `DB1.name`, a symbol, or a register (`ACCU1`, `AR1`, `STW`)."
        "ein Name, der nicht gesetzt oder gezeigt werden kann" "Eine Adresse (`E 0.0`, `MW10`, `DB1.DBD4`), `T 1`, `Z 1`, `DB1.name`, ein Symbol oder ein Register (`AKKU1`, `AR1`, `STW`) verwenden.";
    P7004 Error "a value that does not fit its target" "Use a constant of STL, such as 5, W#16#00FF, 1.5 or S5T#2S; 0 or 1 for a bit."
        "ein Wert, der nicht zu seinem Ziel passt" "Eine Konstante von AWL verwenden, etwa 5, W#16#00FF, 1.5 oder S5T#2S; für ein Bit 0 oder 1.";
    P7005 Error "a duration that is not understood" "Write a number with its unit: `10ms`, `1.5s`, `2m` or `1h`."
        "eine Dauer, die nicht verstanden wird" "Eine Zahl mit ihrer Einheit schreiben: `10ms`, `1.5s`, `2m` oder `1h`.";
    P7007 Error "a word that is not in the tables" "Give an instruction (`A`, `SPB`), a function of Structured Text (`TON`; `sieben explain functions` lists them), a problem code (`P2001`), a status bit (`RLO`), an organization block (`OB 121`), a system function (`SFC 46`), an event (`16#4562`) or a CPU type (`416-3`). `sieben explain --help` names the lists."
        "ein Wort, das nicht in den Tabellen steht" "Eine Operation (`A`, `SPB`), eine Funktion von Strukturiertem Text (`TON`; `sieben explain functions` zeigt alle), einen Problemcode (`P2001`), ein Statusbit (`VKE`), einen Organisationsbaustein (`OB 121`), eine Systemfunktion (`SFC 46`), ein Ereignis (`16#4562`) oder einen CPU-Typ (`416-3`) angeben. `sieben explain --help` nennt die Listen.";
    P7008 Error "a name that cannot be the name of a project" "Use letters, digits, `-` and `_`."
        "ein Name, den ein Projekt nicht haben kann" "Buchstaben, Ziffern, `-` und `_` verwenden.";
    P7009 Error "times that make no sense together" "Give a cycle longer than 0, and times in rising order."
        "Zeiten, die zusammen keinen Sinn ergeben" "Eine Zykluszeit größer als 0 angeben, und Zeiten in steigender Folge.";
    P7020 Error "no test to run" "Name a file `*.test.st`, a program that checks itself, or a folder with such files."
        "kein Test, der ausgeführt werden kann" "Eine Datei `*.test.st`, ein Programm, das sich selbst prüft, oder einen Ordner mit solchen Dateien angeben.";
    P7030 Error "a trigger that is not understood" "Write `I0.0 rises`, `I0.0 falls`, `I0.0 changes`, `MW10 > 5` or `scan 500`."
        "ein Trigger, der nicht verstanden wird" "`I0.0 rises`, `I0.0 falls`, `I0.0 changes`, `MW10 > 5` oder `scan 500` schreiben.";
    P7031 Error "a trigger that did not come" "Run longer with `--scans` or `--for`, or look at the last scans for what keeps it from coming."
        "ein Trigger, der nicht kam" "Mit `--scans` oder `--for` länger laufen lassen, oder in den letzten Zyklen nachsehen, was ihn verhindert.";
    P7032 Error "nothing to record" "Name what to record: `--channels I0.0,Q0.0,MW10`."
        "nichts aufzuzeichnen" "Angeben, was aufgezeichnet werden soll: `--channels I0.0,Q0.0,MW10`.";
    P7033 Error "a part of a trace that is not there" "Name a time that the trace has."
        "ein Teil eines Trace, den es nicht gibt" "Eine Zeit angeben, die der Trace hat.";
    P7040 Error "a command that `sieben step` does not know" "`help` lists the commands."
        "ein Befehl, den `sieben step` nicht kennt" "`help` zeigt die Befehle.";
    P7041 Error "a place that is not in the program" "Write `FC 1:3` (the third statement), `FC 1:label` or `main.awl:12` (a line)."
        "eine Stelle, die es im Programm nicht gibt" "`FC 1:3` (die dritte Anweisung), `FC 1:marke` oder `main.awl:12` (eine Zeile) schreiben.";
    P7042 Error "a condition that is not understood" "Write a name, one of =, <>, >, >=, <, <= and a value: `MW10 > 5`."
        "eine Bedingung, die nicht verstanden wird" "Einen Namen, eines von =, <>, >, >=, <, <= und einen Wert schreiben: `MW10 > 5`.";
    P7043 Error "a recording of another program" "Replay it with the sources and the CPU type that it was recorded with."
        "eine Aufzeichnung eines anderen Programms" "Mit den Quellen und dem CPU-Typ wiedergeben, mit denen aufgezeichnet wurde.";
    P7044 Error "a recording that cannot be used" "Record the run again with `sieben step --record`."
        "eine Aufzeichnung, die nicht verwendet werden kann" "Den Lauf mit `sieben step --record` noch einmal aufzeichnen.";
    P7050 Error "a rule for a name that the recording does not have" "Write the name as the scenario does: `--map`, `--tolerance` and `--ignore` speak of what was recorded."
        "eine Regel für einen Namen, den die Aufzeichnung nicht hat" "Den Namen so schreiben wie das Szenario: `--map`, `--tolerance` und `--ignore` sprechen von dem, was aufgezeichnet wurde.";
    P7051 Error "a rule for a recording that is not understood" "Write `--map OLD=NEW`, `--within 2`, `--tolerance NAME=0.5` or `--tolerance 2%`."
        "eine Regel für eine Aufzeichnung, die nicht verstanden wird" "`--map ALT=NEU`, `--within 2`, `--tolerance NAME=0.5` oder `--tolerance 2%` schreiben.";
    P7080 Error "a block without networks" "Name a block of STL, LAD or FBD; Structured Text has no networks to draw."
        "ein Baustein ohne Netzwerke" "Einen Baustein in AWL, KOP oder FUP angeben; Strukturierter Text hat keine Netzwerke, die gezeichnet werden könnten.";
    P7081 Error "a file that no diagram is written to" "Name a file that ends in `.svg`, `.html` or `.txt`."
        "eine Datei, in die kein Plan geschrieben wird" "Eine Datei angeben, die auf `.svg`, `.html` oder `.txt` endet.";
    P7082 Error "a network that a block does not have" "Name a network of the block by its number, from 1."
        "ein Netzwerk, das ein Baustein nicht hat" "Ein Netzwerk des Bausteins mit seiner Nummer angeben, ab 1.";
    P7083 Error "a network that is no diagram" "Choose a network that can be drawn, or try `--as fbd`; `sieben render` shows which can."
        "ein Netzwerk, das kein Plan ist" "Ein Netzwerk wählen, das sich zeichnen lässt, oder `--as fbd` versuchen; `sieben render` zeigt, welche das sind.";
    P7090 Error "no run that answers" "Start it with `sieben run` in another terminal, with the same folder or files."
        "kein Lauf, der antwortet" "Mit `sieben run` in einem anderen Terminal starten, mit demselben Ordner oder denselben Dateien.";
    P7091 Error "a request that is not understood" "Write one JSON object on one line, such as `{\"id\": 1, \"verb\": \"state\"}`; docs/reference/control-socket.md has all verbs."
        "eine Anforderung, die nicht verstanden wird" "Ein JSON-Objekt auf einer Zeile schreiben, etwa `{\"id\": 1, \"verb\": \"state\"}`; docs/reference/control-socket.md zeigt alle Befehle.";
    P7092 Error "a request beyond a limit" "Ask for less at once, or close a connection that is not needed."
        "eine Anforderung jenseits einer Grenze" "Weniger auf einmal anfordern, oder eine Verbindung schließen, die nicht gebraucht wird.";
    P7093 Error "a request that the CPU does not take now" "Ask for `state`: a start and a memory reset need STOP."
        "eine Anforderung, die die CPU jetzt nicht annimmt" "`state` abfragen: Ein Anlauf und ein Urlöschen brauchen STOP.";
    P7094 Error "a run that is over" "Start it again, and connect again."
        "ein Lauf, der zu Ende ist" "Noch einmal starten und noch einmal verbinden.";
    P7095 Error "a status that cannot be shown" "Name a block with statements (`blocks` lists them) while the CPU scans."
        "ein Status, der nicht gezeigt werden kann" "Einen Baustein mit Anweisungen angeben (`blocks` zeigt sie), während die CPU läuft.";
    P7100 Error "a server that other computers reach" "Choose an address of this computer alone, such as 127.0.0.1:1102, or name the address with `--expose` if you want that."
        "ein Server, den andere Rechner erreichen" "Eine Adresse nur dieses Rechners wählen, etwa 127.0.0.1:1102, oder die Adresse mit `--expose` nennen, wenn das gewollt ist.";
    P7101 Error "an address that is in use" "End the program that listens there, or choose another port."
        "eine Adresse, die schon verwendet wird" "Das Programm beenden, das dort lauscht, oder einen anderen Port wählen.";
    P7102 Error "an address that cannot be listened at" "Choose an address of this computer and a port from 1024, or give the right to listen below."
        "eine Adresse, an der nicht gelauscht werden kann" "Eine Adresse dieses Rechners und einen Port ab 1024 wählen, oder das Recht für kleinere geben.";
    P7103 Error "a file of a server that cannot be written" "Name a file in the folder of the project that this user may write, and look whether the disk is full."
        "eine Datei eines Servers, die nicht geschrieben werden kann" "Eine Datei im Projektordner angeben, die dieser Benutzer schreiben darf, und prüfen, ob der Datenträger voll ist.";
    P7104 Error "something that cannot be pressed like a button" "Name an input bit, such as `I0.0`; everything else is set with `write`."
        "etwas, das nicht wie ein Taster gedrückt werden kann" "Ein Eingangsbit nennen, etwa `E0.0`; alles andere wird mit `write` gesetzt.";
    P7113 Error "a constant that is to be set" "Change it in the source and compile again, or declare it as a variable."
        "eine Konstante, die gesetzt werden soll" "In der Quelle ändern und neu übersetzen, oder als Variable deklarieren.";
    P7125 Error "a format that does not exist" "Write one of the formats of a watch table after the colon, such as `MW10:INT`, or leave it out; `sieben explain formats` lists them."
        "ein Format, das es nicht gibt" "Nach dem Doppelpunkt eines der Formate einer Variablentabelle schreiben, etwa `MW10:INT`, oder es weglassen; `sieben explain formats` zeigt alle.";
    P7126 Error "a format that does not fit the value" "Choose a format for as many bits as the value has, or leave it out; `sieben explain formats` says what each one shows."
        "ein Format, das nicht zum Wert passt" "Ein Format für so viele Bits wählen, wie der Wert hat, oder es weglassen; `sieben explain formats` sagt, was jedes zeigt.";
    P7130 Error "a page that asks for too much" "Ask for less at a time; `docs/reference/page-server.md` has the limits."
        "eine Seite, die zu viel verlangt" "Weniger auf einmal verlangen; `docs/reference/page-server.md` nennt die Grenzen.";
    P7131 Error "a message that the page server does not understand" "Reload the page; a program of your own finds the messages in `docs/reference/page-server.md` and the paths in `/api/v1/openapi.json`."
        "eine Nachricht, die der Server der Seite nicht versteht" "Die Seite neu laden; für ein eigenes Programm stehen die Nachrichten in `docs/reference/page-server.md` und die Pfade in `/api/v1/openapi.json`.";
    P7132 Error "a page without its token" "Open the address with `?token=` that was printed when the run began, or send `Authorization: Bearer` with the token."
        "eine Seite ohne ihr Token" "Die Adresse mit `?token=` öffnen, die zu Beginn des Laufs ausgegeben wurde, oder `Authorization: Bearer` mit dem Token senden.";
    P7133 Error "a page that may only look" "Use the first of the two tokens that were printed when the run began."
        "eine Seite, die nur ansehen darf" "Das erste der beiden Token verwenden, die zu Beginn des Laufs ausgegeben wurden.";
    P7134 Error "a request of another page" "Open the page of the run itself; no other page is let in."
        "eine Anfrage einer anderen Seite" "Die Seite des Laufs selbst öffnen; eine andere wird nicht eingelassen.";
    P7135 Error "a request for another server" "Use the address that was printed when the run began."
        "eine Anfrage an einen anderen Server" "Die Adresse verwenden, die zu Beginn des Laufs ausgegeben wurde.";
    P7136 Error "requests that come too often" "Wait a second, and ask less often."
        "Anfragen, die zu oft kommen" "Eine Sekunde warten und seltener fragen.";
    P7137 Error "an address that the page server does not have" "`/api/v1/openapi.json` describes the interface; the page is at `/`, the book at `/docs/`."
        "eine Adresse, die der Server der Seite nicht hat" "`/api/v1/openapi.json` beschreibt die Schnittstelle; die Seite ist unter `/`, das Buch unter `/docs/`.";
    P7138 Error "a method that an address does not take" "`/api/v1/openapi.json` says which methods each address takes."
        "eine Methode, die eine Adresse nicht annimmt" "`/api/v1/openapi.json` sagt, welche Methoden jede Adresse annimmt.";
    P7139 Error "a scan that is not kept" "Choose one between `oldest` and `newest`."
        "ein Zyklus, der nicht aufgezeichnet ist" "Einen zwischen `oldest` und `newest` wählen.";
    P7140 Error "a token that cannot be kept" "Look whether this user may write in the folder of the project, and whether the file is this user's and has the mode 0600."
        "ein Token, das nicht gespeichert werden kann" "Prüfen, ob dieser Benutzer im Projektordner schreiben darf und ob die Datei ihm gehört und die Rechte 0600 hat.";
    P7145 Error "a project that this page may not change to" "Choose one of the examples that `GET /api/v1/project` lists; a run of another project is begun from the command line."
        "ein Projekt, zu dem diese Seite nicht wechseln darf" "Eines der Beispiele wählen, die `GET /api/v1/project` nennt; ein Lauf eines anderen Projekts beginnt auf der Kommandozeile.";
    P7146 Error "a watch table that cannot be read" "Correct the line: the first one is `name,format,comment`, each other one has up to three such fields; `docs/reference/watch-tables.md` describes them."
        "eine Variablentabelle, die nicht gelesen werden kann" "Die Zeile berichtigen: Die erste ist `name,format,comment`, jede weitere hat bis zu drei solche Felder; `docs/reference/watch-tables.md` beschreibt sie.";
    P7147 Error "a watch table that the project does not have" "`GET /api/v1/watch` names those that it has: files that end in `.watch` in the folder of the project."
        "eine Variablentabelle, die das Projekt nicht hat" "`GET /api/v1/watch` nennt die vorhandenen: Dateien mit der Endung `.watch` im Projektordner.";
    P7155 Error "a language server that cannot start" "Close programs that need many threads, and start it again."
        "ein Sprachserver, der nicht starten kann" "Programme schließen, die viele Threads brauchen, und ihn erneut starten.";
    P7156 Error "a campaign whose file cannot be read" "Write it as `docs/reference/campaign-files.md` shows it: TOML, in UTF-8."
        "eine Kampagne, deren Datei nicht gelesen werden kann" "Sie schreiben, wie `docs/reference/campaign-files.md` es zeigt: TOML, in UTF-8.";
    P7157 Error "a key or value of a campaign that is not understood" "Correct it; `docs/reference/campaign-files.md` lists all keys and what they take."
        "ein Schlüssel oder Wert einer Kampagne, der nicht verstanden wird" "Ihn berichtigen; `docs/reference/campaign-files.md` nennt alle Schlüssel und ihre Werte.";
    P7158 Error "a campaign with more scenarios than can be numbered" "Draw values instead of trying all of them; `samples` says how many."
        "eine Kampagne mit mehr Szenarien, als nummeriert werden können" "Werte ziehen, statt alle durchzugehen; `samples` sagt, wie viele.";
    P7159 Error "what campaigns of this version do not have" "Use what the message names instead."
        "was Kampagnen dieser Version nicht haben" "Stattdessen verwenden, was die Meldung nennt.";
    P7160 Error "an expression of a campaign that is none" "Write a Boolean expression of Structured Text in the names of the program, of a measure one with a number as its value."
        "ein Ausdruck einer Kampagne, der keiner ist" "Einen booleschen Ausdruck in Structured Text mit den Namen des Programms schreiben, bei einem Messwert einen, der eine Zahl ergibt.";
    P7161 Error "a name of a campaign that neither the program nor a plant has" "Write an address, a symbol, a field of a data block, or `PLANT.PARAMETER` of a module of the project."
        "ein Name einer Kampagne, den weder das Programm noch eine Anlage hat" "Eine Adresse, ein Symbol, ein Feld eines Datenbausteins oder `ANLAGE.PARAMETER` eines Moduls des Projekts schreiben.";
    P7162 Error "a value of a campaign that does not fit its name" "Write a value of the type that the name has, within its range."
        "ein Wert einer Kampagne, der nicht zu seinem Namen passt" "Einen Wert des Datentyps schreiben, den der Name hat, innerhalb seines Bereichs.";
    P7163 Error "a program that a campaign cannot use" "Correct the path in the file of the campaign; it counts from the folder of that file."
        "ein Programm, das eine Kampagne nicht verwenden kann" "Den Pfad in der Datei der Kampagne berichtigen; er zählt vom Ordner dieser Datei an.";
    P7164 Warning "an expression of a campaign that names nothing" "Write what the program does into it; a property of constants holds, or breaks, whatever happens."
        "ein Ausdruck einer Kampagne, der nichts benennt" "Hineinschreiben, was das Programm tut; eine Eigenschaft aus Konstanten gilt oder bricht, was auch geschieht.";
    P7165 Error "a NATS server that cannot be reached" "Look whether `nats-server` runs, and whether the address, the port and the certificate are right."
        "ein NATS-Server, der nicht zu erreichen ist" "Prüfen, ob `nats-server` läuft und ob Adresse, Port und Zertifikat stimmen.";
    P7166 Error "a NATS server that does not let this user do it" "Give a user, a token or a file that the server knows, and allow what `docs/reference/campaign-queue.md` lists."
        "ein NATS-Server, der diesen Benutzer nicht lässt" "Einen Benutzer, ein Token oder eine Datei angeben, die der Server kennt, und erlauben, was `docs/reference/campaign-queue.md` aufzählt.";
    P7167 Error "a NATS server that cannot carry the campaign" "Start it with JetStream and enough room, and run each campaign once at a time; `docs/reference/campaign-queue.md` says what it needs."
        "ein NATS-Server, der die Kampagne nicht tragen kann" "Ihn mit JetStream und genug Platz starten und jede Kampagne nur einmal zugleich ausführen; `docs/reference/campaign-queue.md` sagt, was nötig ist.";
    P7168 Error "a campaign that a worker cannot run" "Use the same version of Sieben on all machines, and name the campaign as its run prints it."
        "eine Kampagne, die ein Arbeiter nicht ausführen kann" "Auf allen Rechnern dieselbe Version von Sieben verwenden und die Kampagne so nennen, wie ihr Lauf sie ausgibt.";
    P7169 Error "two results of the same scenarios that differ" "Take the worker that the message names away, and run the campaign again; if it is no stranger, report it as a mistake of Sieben."
        "zwei Ergebnisse derselben Szenarien, die sich unterscheiden" "Den genannten Arbeiter entfernen und die Kampagne noch einmal ausführen; ist er kein fremder, es als Fehler von Sieben melden.";
    P7170 Error "a fleet whose file cannot be read" "Write it as `docs/reference/fleet-files.md` shows it: TOML, in UTF-8."
        "eine Flotte, deren Datei nicht gelesen werden kann" "Sie schreiben, wie `docs/reference/fleet-files.md` es zeigt: TOML, in UTF-8.";
    P7171 Error "a key or value of a fleet that is not understood" "Correct it; `docs/reference/fleet-files.md` lists all keys and what they take."
        "ein nicht verstandener Schlüssel oder Wert einer Flotte" "Ihn berichtigen; `docs/reference/fleet-files.md` nennt alle Schlüssel und was sie annehmen.";
    P7172 Error "a link of a fleet that cannot be made" "Write controllers of the file and names of their programs: `station[i].QB 0`; both ends have the same width."
        "eine Verbindung einer Flotte, die nicht möglich ist" "Steuerungen der Datei und Namen ihrer Programme schreiben: `station[i].QB 0`; beide Enden sind gleich breit.";
    P7173 Error "what fleets of this version do not have" "Use what the message names instead."
        "was Flotten dieser Version nicht haben" "Stattdessen verwenden, was die Meldung nennt.";
    P7174 Error "a controller that a fleet does not have" "Write one of the file with its number: `station[42]`; numbers count from 0."
        "eine Steuerung, die eine Flotte nicht hat" "Eine der Datei mit ihrer Nummer schreiben: `station[42]`; gezählt wird ab 0.";
    P7175 Error "what a run of a campaign left is there" "Go on with it by `--resume`, or remove the folder."
        "was ein Lauf einer Kampagne hinterließ, ist noch da" "Mit `--resume` damit fortfahren oder den Ordner löschen.";
    P7176 Error "a result of another campaign" "Use only results of the same programs, file and seed."
        "ein Ergebnis einer anderen Kampagne" "Nur Ergebnisse derselben Programme, derselben Datei und desselben Startwerts verwenden.";
    P7177 Error "two runs of a campaign on one ledger" "Wait until the other run has ended, or write to another file."
        "zwei Läufe einer Kampagne mit demselben Ergebnis" "Warten, bis der andere Lauf zu Ende ist, oder in eine andere Datei schreiben.";
    P7178 Error "a result of a campaign that cannot be read" "Name a Parquet file that `sieben campaign run --out` or `merge` wrote."
        "ein Ergebnis einer Kampagne, das nicht gelesen werden kann" "Eine Parquet-Datei nennen, die `sieben campaign run --out` oder `merge` geschrieben hat.";
    P7179 Error "a scenario that the engines do not agree on" "This is our mistake: please report the scenario and the program."
        "ein Szenario, bei dem sich die Ausführungen unterscheiden" "Das ist unser Fehler: bitte das Szenario und das Programm melden.";

    // 8xxx run time
    P8001 Error "the CPU went to STOP" "Read the diagnostic buffer: it names the block and the statement."
        "die CPU ist in STOP gegangen" "Den Diagnosepuffer lesen: Er nennt den Baustein und die Anweisung.";
    P8002 Error "two modules at the same address" "Give one of them another address: every input and output byte belongs to at most one module."
        "zwei Baugruppen auf derselben Adresse" "Einer von beiden eine andere Adresse geben: Jedes Eingangs- und Ausgangsbyte gehört zu höchstens einer Baugruppe.";
    P8003 Error "a module beyond the peripheral area of the CPU type" "Use a lower address, or choose a CPU type with a larger peripheral area."
        "eine Baugruppe außerhalb des Peripheriebereichs des CPU-Typs" "Eine kleinere Adresse verwenden, oder einen CPU-Typ mit größerem Peripheriebereich wählen.";
    P8030 Warning "retentive data that cannot be kept" "Make room on the disk or correct the permissions: the CPU goes on, and keeping is tried again every second."
        "remanente Daten, die nicht gespeichert werden können" "Platz auf dem Datenträger schaffen oder die Rechte berichtigen: Die CPU läuft weiter, und das Speichern wird jede Sekunde erneut versucht.";
    P8031 Warning "retentive data that is damaged" "Nothing can be restored from it; check the disk. A copy is set aside."
        "beschädigte remanente Daten" "Daraus lässt sich nichts wiederherstellen; den Datenträger prüfen. Eine Kopie ist beiseite gelegt.";
    P8032 Warning "retentive data of a program with other data blocks" "Run with --adopt and the file where it is now, to take over what still fits."
        "remanente Daten eines Programms mit anderen Datenbausteinen" "Mit --adopt und der jetzigen Datei starten, um zu übernehmen, was noch passt.";
    P8033 Error "a link or a device where retentive data is kept" "Remove it if you do not know it; to keep the data elsewhere, name the file with --retain."
        "ein Link oder ein Gerät, wo remanente Daten gespeichert werden" "Entfernen, wenn es unbekannt ist; um die Daten anderswo zu speichern, die Datei mit --retain angeben.";
    P8034 Warning "retentive data that was removed during a run" "Nothing is lost; leave `.sieben` alone while the CPU runs (`git clean -e .sieben`)."
        "remanente Daten, die während eines Laufs entfernt wurden" "Nichts ist verloren; `.sieben` in Ruhe lassen, solange die CPU läuft (`git clean -e .sieben`).";

    // 9xxx diagrams
    P9001 Warning "a second string of logic in a network that is to be drawn (R-TWO)" "Begin a NETWORK with the second string; `convert --rewrite` does it."
        "eine zweite Verknüpfungskette in einem Netzwerk, das gezeichnet werden soll (R-TWO)" "Mit der zweiten Kette ein NETWORK beginnen; `convert --rewrite` tut das.";
    P9002 Warning "logic that leads to no output, in a network that is to be drawn (R-LOGIC)" "End the string with an output such as `=`, or remove it."
        "eine Verknüpfung, die zu keinem Ausgang führt, in einem Netzwerk, das gezeichnet werden soll (R-LOGIC)" "Die Kette mit einem Ausgang wie `=` beenden, oder sie entfernen.";
    P9003 Warning "a jump that has no coil (R-JUMP)" "Let a network end with JC, JCN or JU, and begin another one with the label."
        "ein Sprung, für den es keine Spule gibt (R-JUMP)" "Ein Netzwerk mit SPB, SPBN oder SPA enden lassen und mit der Marke ein weiteres beginnen.";
    P9004 Warning "a label in the middle of a network that is to be drawn (R-LABEL)" "Begin a NETWORK with the labelled statement."
        "eine Sprungmarke mitten in einem Netzwerk, das gezeichnet werden soll (R-LABEL)" "Mit der Anweisung, die die Marke trägt, ein NETWORK beginnen.";
    P9005 Warning "an instruction that no element of a diagram stands for (R-OPCODE)" "Write the network with instructions that have an element, or leave it as STL: one block may hold both."
        "eine Operation, für die kein Element eines Plans steht (R-OPCODE)" "Das Netzwerk mit Operationen schreiben, für die es ein Element gibt, oder als AWL lassen: Ein Baustein darf beides enthalten.";
    P9006 Warning "an address that is computed at run time, in a network that is to be drawn (R-INDIRECT)" "Leave the network as STL, or use an operand with a fixed address."
        "eine Adresse, die zur Laufzeit berechnet wird, in einem Netzwerk, das gezeichnet werden soll (R-INDIRECT)" "Das Netzwerk als AWL lassen, oder einen Operanden mit fester Adresse verwenden.";
    P9007 Warning "a load, a store or a call after logic, which does not depend on it (R-UNCOND)" "Jump over it with JNB, so that the logic becomes its EN, or put it into a network of its own."
        "ein Laden, Transferieren oder Aufruf nach einer Verknüpfung, von der es nicht abhängt (R-UNCOND)" "Mit SPBNB überspringen, so dass die Verknüpfung zu EN wird, oder in ein eigenes Netzwerk setzen.";
    P9008 Warning "a result of a box that is not stored exactly once (R-STORE)" "Store the result with one T; `convert --rewrite` makes two MOVE boxes of two stores."
        "ein Ergebnis einer Box, das nicht genau einmal gespeichert wird (R-STORE)" "Das Ergebnis mit einem T speichern; `convert --rewrite` macht aus zwei Transfers zwei MOVE-Boxen.";
    P9009 Warning "two operations without a T between them, in a network that is to be drawn (R-CHAIN)" "Store the first result in a temporary variable, and load it for the second operation."
        "zwei Operationen ohne T dazwischen, in einem Netzwerk, das gezeichnet werden soll (R-CHAIN)" "Das erste Ergebnis in einer temporären Variablen speichern und für die zweite Operation laden.";
    P9010 Warning "a slot of a box without its NOP 0 (R-NOP)" "Add `NOP 0` for each open slot; where only one box fits, `convert --rewrite` does it."
        "ein Platz einer Box ohne sein NOP 0 (R-NOP)" "Für jeden offenen Platz `NOP 0` schreiben; wo nur eine Box passt, tut `convert --rewrite` das.";
    P9011 Warning "parts of a timer or counter in another order than its box has them (R-ORDER)" "Put them into the order of the box: start, reset, `L`, `LC`, and the check of its bit last."
        "Teile einer Zeit oder eines Zählers in anderer Reihenfolge als in der Box (R-ORDER)" "In die Reihenfolge der Box bringen: Starten, Rücksetzen, `L`, `LC`, und zuletzt die Abfrage ihres Bits.";
    P9012 Warning "an end of a box that is neither ENO nor NOP 0 (R-ENO)" "End it as its box has it: `AN OV`, SAVE, CLR, `A BR` if it can overflow; `SET`, SAVE, CLR, `A BR` if it cannot; or `NOP 0`."
        "ein Ende einer Box, das weder ENO noch NOP 0 ist (R-ENO)" "So beenden, wie es die Box hat: `UN OV`, SAVE, CLR, `U BIE`, wenn sie überlaufen kann; `SET`, SAVE, CLR, `U BIE`, wenn nicht; oder `NOP 0`.";
    P9013 Warning "brackets that do not match or hold nothing, in a network that is to be drawn (R-BRACKET)" "Close each bracket, and put logic into it."
        "Klammern, die nicht zusammenpassen oder leer sind, in einem Netzwerk, das gezeichnet werden soll (R-BRACKET)" "Jede Klammer schließen und eine Verknüpfung hineinschreiben.";
    P9014 Warning "more than 7 brackets inside of one another (R-DEPTH)" "Store a part of the logic with a midline output or in a variable."
        "mehr als 7 Klammern ineinander (R-DEPTH)" "Einen Teil der Verknüpfung mit einem Konnektor oder in einer Variablen speichern.";
    P9015 Warning "a bit of local data that is stored like that of a T-branch and never read (R-BITLEFT)" "Declare a temporary variable, or use the bit in the same network."
        "ein Lokaldatenbit, das wie das eines T-Abzweigs gespeichert und nie gelesen wird (R-BITLEFT)" "Eine temporäre Variable deklarieren, oder das Bit im selben Netzwerk verwenden.";
    P9016 Warning "a tapped line that would run backwards in ladder (R-BACK)" "Draw the network as FBD: `convert --to fbd`."
        "eine abgezweigte Linie, die in KOP rückwärts laufen würde (R-BACK)" "Das Netzwerk als FUP zeichnen: `convert --to fbd`.";
    P9017 Warning "an edge, a NOT or a box for a part in the middle of a line of ladder (R-NEG)" "Draw the network as FBD: `convert --to fbd`."
        "eine Flanke, ein NOT oder eine Box für einen Teil mitten in einer KOP-Linie (R-NEG)" "Das Netzwerk als FUP zeichnen: `convert --to fbd`.";
    P9018 Warning "an operand of another width or type than the box takes (R-WIDTH)" "Move it to an operand of the right width first; MOVE takes any."
        "ein Operand von anderer Breite oder anderem Datentyp, als die Box nimmt (R-WIDTH)" "Zuerst mit MOVE in einen Operanden der richtigen Breite bringen; MOVE nimmt jede.";
    P9019 Warning "a comparison that is jumped over like a box with EN (R-MIX)" "Compare without the jump: a comparison is a contact."
        "ein Vergleich, der übersprungen wird wie eine Box mit EN (R-MIX)" "Ohne den Sprung vergleichen: Ein Vergleich ist ein Kontakt.";
    P9020 Warning "a network whose diagram means the same but gives other statements" "Use `convert --rewrite` to draw it."
        "ein Netzwerk, dessen Plan dasselbe bedeutet, aber andere Anweisungen ergibt" "Mit `convert --rewrite` zeichnen.";
    P9021 Warning "a network with more elements than a diagram may have (R-SIZE)" "Divide the network into several."
        "ein Netzwerk mit mehr Elementen, als ein Plan haben darf (R-SIZE)" "Das Netzwerk in mehrere aufteilen.";
    P9022 Warning "a network that goes on with the logic of the one before it (R-CARRY)" "End the network before it with an output, not with SAVE alone or an open string."
        "ein Netzwerk, das die Verknüpfung des vorherigen fortsetzt (R-CARRY)" "Das vorherige Netzwerk mit einem Ausgang beenden, nicht nur mit SAVE oder einer offenen Kette.";
}
