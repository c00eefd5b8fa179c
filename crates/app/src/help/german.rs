//! The help of the command line in German: each sentence by the English one that stands at its verb or argument.

/// A sentence in English and in German.
pub(super) type Row = (&'static str, &'static str);

/// Names of values, which stand in angle brackets.
pub(super) const VALUES: &[Row] = &[
    ("ADDRESS", "ADRESSE"),
    ("BLOCK", "BAUSTEIN"),
    ("BLOCK/N", "BAUSTEIN/N"),
    ("CONDITION", "BEDINGUNG"),
    ("DIALECT", "DIALEKT"),
    ("DURATION", "DAUER"),
    ("EXAMPLE", "BEISPIEL"),
    ("FACTOR", "FAKTOR"),
    ("FILE", "DATEI"),
    ("FILE.svg", "DATEI.svg"),
    ("FILE.svg|.html|.txt", "DATEI.svg|.html|.txt"),
    ("FOLDER", "ORDNER"),
    ("FROM..TO", "VON..BIS"),
    ("KIND", "ART"),
    ("LANGUAGE", "SPRACHE"),
    ("MODULE.SIGNAL FAULT[@T[..T]]", "BAUGRUPPE.SIGNAL FEHLER[@T[..T]]"),
    ("NAME=VALUE", "NAME=WERT"),
    ("N|DURATION", "N|DAUER"),
    ("OLD", "ALT"),
    ("OLD=NEW|FILE", "ALT=NEU|DATEI"),
    ("PATH", "PFAD"),
    ("PATH|NAME", "PFAD|NAME"),
    ("RECORDING", "AUFZEICHNUNG"),
    ("SCENARIO", "SZENARIO"),
    ("SERVER=ADDRESS", "SERVER=ADRESSE"),
    ("WHICH", "WELCHE"),
    ("WORD", "WORT"),
    ("[NAME=]NUMBER[%]", "[NAME=]ZAHL[%]"),
    ("first|never|N", "first|never|N"),
];

/// What verbs and arguments do.
pub(super) const SENTENCES: &[Row] = &[
    // All verbs.
    (
        "Sieben: an open soft PLC. It runs STEP 7 programs in STL, SCL and Structured Text exactly as an S7-300/400 CPU does",
        "Sieben: eine offene Soft-SPS. Sie führt STEP-7-Programme in AWL, SCL und Strukturiertem Text genau so aus wie eine CPU der S7-300/400",
    ),
    (
        "Language of help, messages and reasons, en or de [default: that of the environment, else en]",
        "Sprache von Hilfe, Meldungen und Begründungen, en oder de [Standard: die der Umgebung, sonst en]",
    ),
    ("Print help", "Diese Hilfe ausgeben"),
    ("Print version", "Die Version ausgeben"),
    ("Print this message or the help of the given subcommand(s)", "Diese Hilfe oder die eines Befehls ausgeben"),
    ("Source files, symbol tables, or a project folder", "Quelldateien, Symboltabellen oder ein Projektordner"),
    (
        "Source files, symbol tables or a project folder [default: this folder]",
        "Quelldateien, Symboltabellen oder ein Projektordner [Standard: dieser Ordner]",
    ),
    (
        "Source files, symbol tables, or a project folder [default: this folder]",
        "Quelldateien, Symboltabellen oder ein Projektordner [Standard: dieser Ordner]",
    ),
    (
        "CPU type: areas, accumulators, limits [default: the project's, else 315-2PN/DP]",
        "CPU-Typ: Bereiche, Akkumulatoren, Grenzen [Standard: der des Projekts, sonst 315-2PN/DP]",
    ),
    (
        "Mnemonic language of the sources; auto judges each file as a whole [default: the project's, else auto]",
        "Mnemonik der Quellen; auto beurteilt jede Datei als Ganzes [Standard: die des Projekts, sonst auto]",
    ),
    (
        "Dialect of the sources of ST and SCL [default: the project's, else judged over each file]",
        "Dialekt der Quellen in ST und SCL [Standard: der des Projekts, sonst aus jeder Datei beurteilt]",
    ),
    (
        "Allow the extension words of awlsim, such as `__ASSERT==` [default: the project's, else not]",
        "Die Erweiterungswörter von awlsim erlauben, etwa `__ASSERT==` [Standard: wie im Projekt, sonst nicht]",
    ),
    (
        "Whose rules hold where awlsim and the manual differ [default: the project's, else siemens]",
        "Wessen Regeln gelten, wo awlsim und das Handbuch sich unterscheiden [Standard: wie im Projekt, sonst siemens]",
    ),
    (
        "Encoding of the files without a byte order mark: utf-8, utf-16le, utf-16be, cp1250, cp1251 or cp1252 [default: guessed from each file]",
        "Zeichenkodierung der Dateien ohne Bytereihenfolge-Marke: utf-8, utf-16le, utf-16be, cp1250, cp1251 oder cp1252 [Standard: aus jeder Datei erkannt]",
    ),
    (
        "What STEP 7 refuses is an error (exit code 3), and so is a statement that fails while the program runs (exit code 1)",
        "Was STEP 7 ablehnt, ist ein Fehler (Exitcode 3), ebenso eine Anweisung, die im Lauf fehlschlägt (Exitcode 1)",
    ),
    ("Print the diagnostic buffer at the end, the newest entry first", "Am Ende den Diagnosepuffer ausgeben, den neuesten Eintrag zuerst"),
    (
        "Let a signal of a [[module]] fail: stuck, stuck=1, drift=0.5, late=200ms or bounce=50ms, at a time or between two",
        "Ein Signal eines [[module]] stören: stuck, stuck=1, drift=0.5, late=200ms oder bounce=50ms, ab einer Zeit oder zwischen zweien",
    ),
    ("Print JSON", "JSON ausgeben"),
    (
        "Print a web page that needs nothing beside it, for reading and printing",
        "Eine Webseite ausgeben, die für sich allein steht, zum Lesen und Drucken",
    ),
    ("Write to this file instead of standard output", "In diese Datei schreiben statt auf die Standardausgabe"),
    (
        "Time from one scan to the next [default: the project's, else 10ms]",
        "Zeit von einem Zyklus zum nächsten [Standard: die des Projekts, sonst 10ms]",
    ),
    ("Which engine runs the program", "Welche Engine das Programm ausführt"),
    ("Print one JSON object", "Ein JSON-Objekt ausgeben"),
    (
        "How the CPU starts: warm keeps retentive data, cold begins with the initial values",
        "Wie die CPU anläuft: warm behält remanente Daten, cold beginnt mit den Anfangswerten",
    ),
    (
        "Set before the first scan: an address, a symbol, DB1.name, ACCU1 to ACCU4, AR1, AR2 or STW",
        "Vor dem ersten Zyklus setzen: eine Adresse, ein Symbol, DB1.name, AKKU1 bis AKKU4, AR1, AR2 oder STW",
    ),
    ("Set at a time, seen by the next scan", "Zu einer Zeit setzen, sichtbar im nächsten Zyklus"),
    (
        "Run so many scans [default: 1 with exec, 100 with trace, without end with record]",
        "So viele Zyklen ausführen [Standard: 1 bei exec, 100 bei trace, ohne Ende bei record]",
    ),
    ("Run all scans that begin before this time", "Alle Zyklen ausführen, die vor dieser Zeit beginnen"),
    ("Scan exactly at these times instead of every cycle", "Genau zu diesen Zeiten einen Zyklus ausführen statt in festem Takt"),
    // demo, run, serve, top
    ("A dosing plant with its controller, live in the terminal", "Eine Dosieranlage mit ihrer Steuerung, live im Terminal"),
    ("Which plant", "Welche Anlage"),
    ("End after this time of the plant", "Nach dieser Zeit der Anlage enden"),
    ("How fast time goes: 1x, 10x, 0.5x, or max", "Wie schnell die Zeit vergeht: 1x, 10x, 0.5x oder max"),
    ("Run a project", "Ein Projekt ausführen"),
    (
        "Time from one scan to the next; 0 runs free [default: the project's, else 10ms]",
        "Zeit von einem Zyklus zum nächsten; 0 läuft frei [Standard: die des Projekts, sonst 10ms]",
    ),
    (
        "1x is real time, 10x ten times as fast, max as fast as it goes in virtual time",
        "1x ist Echtzeit, 10x zehnmal so schnell, max so schnell es geht, in virtueller Zeit",
    ),
    ("Stop after this time of the CPU's clock", "Nach dieser Zeit der CPU-Uhr anhalten"),
    (
        "Look for changed sources, and let them take over between two scans with the data kept",
        "Auf geänderte Quellen achten und sie zwischen zwei Zyklen übernehmen, mit erhaltenen Daten",
    ),
    (
        "With --watch: do not ask when values of data blocks cannot be kept",
        "Mit --watch: nicht nachfragen, wenn Werte von Datenbausteinen nicht erhalten bleiben",
    ),
    (
        "Keep retentive data in this file [default: .sieben/retain.bin of a project folder with a sieben.toml]",
        "Remanente Daten in dieser Datei speichern [Standard: .sieben/retain.bin eines Projektordners mit sieben.toml]",
    ),
    ("Keep no retentive data, and leave alone what was kept", "Keine remanenten Daten speichern und vorhandene unberührt lassen"),
    (
        "Take over the retentive data in this file, also that of a changed program as far as it fits",
        "Die remanenten Daten dieser Datei übernehmen, auch die eines geänderten Programms, soweit sie passen",
    ),
    ("Begin with a memory reset (MRES): retentive data is deleted", "Mit Urlöschen (MRES) beginnen: Remanente Daten werden gelöscht"),
    (
        "Serve S7 clients, at this address [default: that of the project, else 127.0.0.1:1102]",
        "S7-Clients bedienen, unter dieser Adresse [Standard: die des Projekts, sonst 127.0.0.1:1102]",
    ),
    (
        "Serve the page, at this address [default: that of the project, else 127.0.0.1:7300 or the next free port]",
        "Die Seite bereitstellen, unter dieser Adresse [Standard: die des Projekts, sonst 127.0.0.1:7300 oder der nächste freie Port]",
    ),
    ("Serve no page", "Keine Seite bereitstellen"),
    ("Open the page in the browser", "Die Seite im Browser öffnen"),
    (
        "Let others than this computer reach a server, at exactly this address: `s7=0.0.0.0:102`",
        "Auch andere Rechner einen Server erreichen lassen, unter genau dieser Adresse: `s7=0.0.0.0:102`",
    ),
    (
        "Tell Prometheus the numbers of the run, at http://ADDRESS/metrics",
        "Prometheus die Zahlen des Laufs liefern, unter http://ADRESSE/metrics",
    ),
    (
        "Run a project with its servers, for clients over the network, until it is told to end",
        "Ein Projekt mit seinen Servern ausführen, für Clients im Netz, bis es beendet wird",
    ),
    (
        "Serve an editor over standard input and output: what is wrong, what a word means, where it is used",
        "Einen Editor über Standardein- und -ausgabe bedienen: was falsch ist, was ein Wort bedeutet, wo es benutzt wird",
    ),
    (
        "Speak over standard input and output, which is what it always does: some editors say so",
        "Über Standardein- und -ausgabe sprechen, was immer geschieht: manche Editoren geben es an",
    ),
    ("Watch a program that runs, and start, stop or pause it", "Ein laufendes Programm beobachten, starten, stoppen oder pausieren"),
    (
        "Source files, symbol tables, or a project folder, as `run` was given them, or `demo` [default: this folder]",
        "Quelldateien, Symboltabellen oder ein Projektordner, wie bei `run` angegeben, oder `demo` [Standard: dieser Ordner]",
    ),
    (
        "Show values too: addresses, symbols, DB1.name, ACCU1 …, separated by commas",
        "Auch Werte zeigen: Adressen, Symbole, DB1.name, AKKU1 …, durch Kommas getrennt",
    ),
    ("Look once and print what is seen as one JSON object", "Einmal abfragen und das Ergebnis als ein JSON-Objekt ausgeben"),
    // check, exec, step, bench
    ("Report everything that is wrong with a program", "Alles melden, was an einem Programm falsch ist"),
    (
        "Source files, symbol tables, or a folder with one program or several [default: this folder]",
        "Quelldateien, Symboltabellen oder ein Ordner mit einem oder mehreren Programmen [Standard: dieser Ordner]",
    ),
    (
        "Report only what one file alone can tell: no missing symbols or blocks",
        "Nur melden, was eine Datei für sich allein zeigt: keine fehlenden Symbole oder Bausteine",
    ),
    (
        "Also report temporary variables that are read, but not written on every path to that statement",
        "Auch temporäre Variablen melden, die gelesen, aber nicht auf jedem Weg zu dieser Anweisung geschrieben werden",
    ),
    (
        "Also list what an online change from the program in this file or folder would change, and what it could not keep",
        "Auch auflisten, was eine Online-Änderung vom Programm in dieser Datei oder diesem Ordner ändern würde und was sie nicht erhalten könnte",
    ),
    ("How the diagnostics are printed", "Wie die Meldungen ausgegeben werden"),
    ("The same as --output-format json", "Dasselbe wie --output-format json"),
    (
        "Apply the fixes of which there is no doubt to the files, then check again",
        "Die zweifelsfreien Berichtigungen in die Dateien schreiben, dann noch einmal prüfen",
    ),
    ("Run a few scans in virtual time and print values", "Einige Zyklen in virtueller Zeit ausführen und Werte ausgeben"),
    (
        "Print these: as --set, and T 1, C 1, T1.q (status bit), STW.RLO; in a format with MD20:REAL",
        "Diese ausgeben: wie bei --set, dazu T 1, Z 1, T1.q (Statusbit), STW.VKE; mit Format als MD20:REAL",
    ),
    (
        "Print all names that have a value: symbols, variables, fields of data blocks",
        "Alle Namen ausgeben, die einen Wert haben: Symbole, Variablen, Komponenten von Datenbausteinen",
    ),
    (
        "List all names that --show knows, with what they are, and run nothing",
        "Alle Namen auflisten, die --show kennt, mit ihrer Art, und nichts ausführen",
    ),
    ("Print after each scan, not only after the last", "Nach jedem Zyklus ausgeben, nicht nur nach dem letzten"),
    (
        "Watch the local data: report every temporary variable that is read before it is written (exit code 1)",
        "Die Lokaldaten überwachen: jede temporäre Variable melden, die gelesen wird, bevor sie geschrieben ist (Exitcode 1)",
    ),
    (
        "Draw a network with its power flow and values at the end of the last scan; the ending says SVG or text",
        "Ein Netzwerk mit Signalfluss und Werten am Ende des letzten Zyklus zeichnen; die Endung bestimmt SVG oder Text",
    ),
    ("The network that --status draws: `FC1/2`, `Dosing/3`", "Das Netzwerk, das --status zeichnet: `FC1/2`, `Dosing/3`"),
    ("Draw --status as this", "--status so zeichnen"),
    ("Print one JSON object per printed scan", "Ein JSON-Objekt für jeden ausgegebenen Zyklus ausgeben"),
    (
        "Step through a program, one statement at a time, forwards and back",
        "Ein Programm Anweisung für Anweisung durchgehen, vorwärts und zurück",
    ),
    ("There are so many scans [default: as many as are wanted]", "So viele Zyklen gibt es [Standard: so viele wie gewünscht]"),
    ("Read commands from a file, `-` = standard input", "Befehle aus einer Datei lesen, `-` = Standardeingabe"),
    ("Keep what came from outside in a file, to be replayed", "In einer Datei aufzeichnen, was von außen kam, zum Wiedergeben"),
    ("Begin with a run that was recorded, at its end", "Mit einem aufgezeichneten Lauf beginnen, an seinem Ende"),
    ("Print one JSON object per command", "Ein JSON-Objekt für jeden Befehl ausgeben"),
    ("Measure how long a scan takes", "Messen, wie lange ein Zyklus dauert"),
    (
        "Virtual time from one scan to the next [default: the project's, else 10ms]",
        "Virtuelle Zeit von einem Zyklus zum nächsten [Standard: die des Projekts, sonst 10ms]",
    ),
    ("How often to measure", "Wie oft gemessen wird"),
    ("Leave these optimizations of the machine code out", "Diese Optimierungen des Maschinencodes weglassen"),
    ("Shortest time of one measurement, in milliseconds", "Kürzeste Zeit einer Messung, in Millisekunden"),
    ("Scans before anything is measured", "Zyklen vor der ersten Messung"),
    ("Print these as they are after the scans of the warm-up", "Diese ausgeben, so wie sie nach den Zyklen des Aufwärmens sind"),
    (
        "Also let so many controllers of this program run in turn, which share one copy of its code",
        "Auch so viele Steuerungen mit diesem Programm reihum laufen lassen, die sich seinen Code teilen",
    ),
    // test, trace, record
    (
        "Run unit tests, scenarios, and programs that check themselves",
        "Bausteintests, Szenarien und Programme ausführen, die sich selbst prüfen",
    ),
    (
        "Sources, projects of awlsim, symbol tables, or folders [default: this folder]",
        "Quellen, awlsim-Projekte, Symboltabellen oder Ordner [Standard: dieser Ordner]",
    ),
    (
        "Test files, whatever their names: each is run with the program that PATH is; blocks of one that checks itself take the place of those with the same number",
        "Testdateien, gleich wie sie heißen: Jede läuft mit dem Programm, das PFAD ist; Bausteine einer Datei, die sich selbst prüft, ersetzen die mit derselben Nummer",
    ),
    ("Only tests with this text in their name", "Nur Tests mit diesem Text im Namen"),
    (
        "Virtual time in which a test has to end [default: 60s, 100 days for a unit test]",
        "Virtuelle Zeit, in der ein Test enden muss [Standard: 60s, 100 Tage für einen Bausteintest]",
    ),
    (
        "Scans in which a test has to end [default: as many as --limit allows]",
        "Zyklen, in denen ein Test enden muss [Standard: so viele, wie --limit erlaubt]",
    ),
    ("Real time after which a test is given up", "Echtzeit, nach der ein Test abgebrochen wird"),
    ("Run so many tests at once [default: one per processor]", "So viele Tests gleichzeitig ausführen [Standard: einer je Prozessor]"),
    ("Print the results as one JSON object", "Die Ergebnisse als ein JSON-Objekt ausgeben"),
    ("Print the results in the Test Anything Protocol", "Die Ergebnisse im Test Anything Protocol ausgeben"),
    (
        "Count which lines of the programs the tests run, and which way decisions go; write that to this file for lcov. The tests run in the interpreter",
        "Zählen, welche Zeilen der Programme die Tests ausführen und wie Entscheidungen ausgehen; in diese Datei für lcov schreiben. Die Tests laufen im Interpreter",
    ),
    (
        "The same as pages for a browser, written into this folder; index.html is the first",
        "Dasselbe als Seiten für einen Browser, in diesen Ordner geschrieben; index.html ist die erste",
    ),
    (
        "Write the timing diagram of every unit test that fails into this folder, as SVG",
        "Das Impulsdiagramm jedes fehlgeschlagenen Bausteintests als SVG in diesen Ordner schreiben",
    ),
    (
        "Run the tests in an order made from this number, which is printed [default: in the order of the files]",
        "Die Tests in einer Reihenfolge ausführen, die aus dieser Zahl entsteht; sie wird ausgegeben [Standard: in der Reihenfolge der Dateien]",
    ),
    ("Only print the names of the tests", "Nur die Namen der Tests ausgeben"),
    ("Run the tests again when a file changes, until Ctrl+C", "Die Tests wiederholen, wenn sich eine Datei ändert, bis Strg+C"),
    ("Write the results to this file as JUnit XML, too", "Die Ergebnisse zusätzlich als JUnit-XML in diese Datei schreiben"),
    (
        "What a scenario calls OLD is called NEW in this program; or a file with such a line for each",
        "Was ein Szenario ALT nennt, heißt in diesem Programm NEU; oder eine Datei mit einer solchen Zeile für jeden Namen",
    ),
    (
        "An output may come so many scans earlier or later than in the recording, or so much time",
        "Ein Ausgang darf um so viele Zyklen oder so viel Zeit früher oder später kommen als in der Aufzeichnung",
    ),
    (
        "A number may be so far from the recorded one, or so many percent; without NAME every number",
        "Eine Zahl darf um so viel oder so viele Prozent von der aufgezeichneten abweichen; ohne NAME jede Zahl",
    ),
    ("Do not compare these", "Diese nicht vergleichen"),
    (
        "Record values over many scans and draw them as a timing diagram",
        "Werte über viele Zyklen aufzeichnen und als Impulsdiagramm zeichnen",
    ),
    ("Source files, symbol tables, a project folder, a scenario", "Quelldateien, Symboltabellen, ein Projektordner, ein Szenario"),
    (
        "Record these: addresses, symbols, T 1, T1.q, C 1, DB1.name, variables, registers [default: inputs and outputs]",
        "Diese aufzeichnen: Adressen, Symbole, T 1, T1.q, Z 1, DB1.name, Variablen, Register [Standard: Ein- und Ausgänge]",
    ),
    ("Run this scenario (also FILE.scenario among the files)", "Dieses Szenario ausführen (auch DATEI.scenario unter den Dateien)"),
    (
        "Keep only what is around this: `I0.0 rises`, `I0.0 falls`, `I0.0 changes`, `MW10 > 5`, `scan 500`",
        "Nur behalten, was um dies herum liegt: `I0.0 rises`, `I0.0 falls`, `I0.0 changes`, `MW10 > 5`, `scan 500`",
    ),
    ("Scans to keep before the trigger [default: 50]", "Zyklen, die vor dem Trigger behalten werden [Standard: 50]"),
    ("Scans to keep behind the trigger [default: 50]", "Zyklen, die nach dem Trigger behalten werden [Standard: 50]"),
    ("Keep only the last scans", "Nur die letzten Zyklen behalten"),
    ("Write the diagram to this file as SVG", "Das Diagramm als SVG in diese Datei schreiben"),
    (
        "Write a Value Change Dump for GTKWave and other viewers (`-` prints it)",
        "Einen Value Change Dump für GTKWave und andere Betrachter schreiben (`-` gibt ihn aus)",
    ),
    ("Write a table of the values (`-` prints it)", "Eine Tabelle der Werte schreiben (`-` gibt sie aus)"),
    ("Which scans get a row in the table", "Welche Zyklen eine Zeile in der Tabelle bekommen"),
    (
        "Write the recording to this file, to be drawn later with --from",
        "Die Aufzeichnung in diese Datei schreiben, um sie später mit --from zu zeichnen",
    ),
    (
        "Draw this recording; with FILE, refuse one of another program",
        "Diese Aufzeichnung zeichnen; mit DATEI die eines anderen Programms ablehnen",
    ),
    ("Show only this part: two times or two numbers of scans", "Nur diesen Teil zeigen: zwei Zeiten oder zwei Zyklusnummern"),
    ("Write out all values at this time", "Alle Werte zu dieser Zeit ausgeben"),
    (
        "Width in characters, or in pixels of the SVG [default: that of the terminal, 960]",
        "Breite in Zeichen, beim SVG in Pixeln [Standard: die des Terminals, 960]",
    ),
    (
        "Print one JSON object per scan that changed something, and one about the trace",
        "Ein JSON-Objekt für jeden Zyklus ausgeben, der etwas änderte, und eines über den Trace",
    ),
    (
        "Write down what goes into a program and what comes out, to hold another program against it",
        "Aufzeichnen, was in ein Programm hineingeht und was herauskommt, um ein anderes Programm daran zu messen",
    ),
    (
        "Source files, symbol tables, a project folder, a scenario to run [default: this folder]",
        "Quelldateien, Symboltabellen, ein Projektordner, ein Szenario zum Ausführen [Standard: dieser Ordner]",
    ),
    ("Write the recording to this file (`-` prints it)", "Die Aufzeichnung in diese Datei schreiben (`-` gibt sie aus)"),
    (
        "1x is real time, 10x ten times as fast, max as fast as it goes [default: 1x, max for a scenario]",
        "1x ist Echtzeit, 10x zehnmal so schnell, max so schnell es geht [Standard: 1x, bei einem Szenario max]",
    ),
    (
        "How the CPU starts: warm or cold; retentive data of other runs is not there",
        "Wie die CPU anläuft: warm oder cold; remanente Daten anderer Läufe gibt es nicht",
    ),
    ("Record these instead of the outputs that the program uses", "Diese aufzeichnen statt der Ausgänge, die das Programm verwendet"),
    (
        "Record these too: bit memory, timers, fields of data blocks",
        "Auch diese aufzeichnen: Merker, Zeiten, Komponenten von Datenbausteinen",
    ),
    ("No screen: print one line for each change", "Kein Bildschirm: eine Zeile je Änderung ausgeben"),
    ("Print the result as one JSON object", "Das Ergebnis als ein JSON-Objekt ausgeben"),
    // explain, fmt, convert, new
    (
        "Explain an instruction, a problem code, a CPU type, a system function or an event",
        "Eine Operation, einen Problemcode, einen CPU-Typ, eine Systemfunktion oder ein Ereignis erklären",
    ),
    ("What to explain", "Was erklärt werden soll"),
    ("Bring sources of STL, LAD, FBD, ST and SCL into one layout", "Quellen in AWL, KOP, FUP, ST und SCL einheitlich formatieren"),
    ("Source files or a project folder", "Quelldateien oder ein Projektordner"),
    ("Change nothing; exit 1 if something would change", "Nichts ändern; Exitcode 1, wenn sich etwas ändern würde"),
    (
        "Mnemonic language of the sources [default: the project's, else judged over each file]",
        "Mnemonik der Quellen [Standard: die des Projekts, sonst aus jeder Datei beurteilt]",
    ),
    (
        "Change sources from one mnemonic language to the other, or networks into LAD, FBD or STL",
        "Quellen von einer Mnemonik in die andere umwandeln, oder Netzwerke in KOP, FUP oder AWL",
    ),
    (
        "Source files or a project folder [with --to default: this folder]",
        "Quelldateien oder ein Projektordner [mit --to Standard: dieser Ordner]",
    ),
    ("The mnemonic language to change to", "Die Mnemonik, in die umgewandelt wird"),
    (
        "The language that the sources are in [default: judged over each file]",
        "Die Mnemonik, in der die Quellen stehen [Standard: aus jeder Datei beurteilt]",
    ),
    ("What networks become", "Was aus Netzwerken wird"),
    (
        "How diagrams are written: a one element on each line, b one network on each line [default: a]",
        "Wie Pläne geschrieben werden: a ein Element je Zeile, b ein Netzwerk je Zeile [Standard: a]",
    ),
    ("Only the networks of this block", "Nur die Netzwerke dieses Bausteins"),
    ("Rewrite what means the same so that it can be drawn", "Gleichbedeutend umschreiben, damit es sich zeichnen lässt"),
    ("Print what came of each network as JSON", "Als JSON ausgeben, was aus jedem Netzwerk wurde"),
    ("Replace the files instead of printing", "Die Dateien ersetzen statt auszugeben"),
    ("Write UTF-8 instead of the encoding of the file", "UTF-8 schreiben statt in der Zeichenkodierung der Datei"),
    ("Make a project that runs and checks at once", "Ein Projekt anlegen, das sofort läuft und sich prüfen lässt"),
    (
        "The folder to make; its last name is the name of the project",
        "Der Ordner, der angelegt wird; sein letzter Name ist der des Projekts",
    ),
    ("The language of its program", "Die Sprache seines Programms"),
    (
        "Copy an example: program, symbols, plant, scenario and tests",
        "Ein Beispiel kopieren: Programm, Symbole, Anlage, Szenario und Tests",
    ),
    // symbols, tags, refs, render, structure, assignments
    ("Print the assignment table, or convert symbol tables", "Die Zuordnungstabelle ausgeben oder Symboltabellen umwandeln"),
    (
        "Symbol tables: .csv, .sdf, .asc, .dif or .seq; several become one",
        "Symboltabellen: .csv, .sdf, .asc, .dif oder .seq; aus mehreren wird eine",
    ),
    (
        "Write the symbol table in this format instead of the assignment table",
        "Die Symboltabelle in diesem Format schreiben statt der Zuordnungstabelle",
    ),
    ("Print the assignment table (the default)", "Die Zuordnungstabelle ausgeben (der Standard)"),
    ("Print the assignment table as CSV", "Die Zuordnungstabelle als CSV ausgeben"),
    (
        "Print the assignment table as a web page that needs nothing beside it",
        "Die Zuordnungstabelle als Webseite ausgeben, die für sich allein steht",
    ),
    (
        "Print the assignment table, or the diagnostics if it has errors, as JSON",
        "Die Zuordnungstabelle, oder bei Fehlern die Meldungen, als JSON ausgeben",
    ),
    ("Print what a client can read and write, and where it lies", "Ausgeben, was ein Client lesen und schreiben kann und wo es liegt"),
    ("Who will read it", "Wer es lesen wird"),
    ("List every element of an array by itself", "Jedes Element eines Felds einzeln auflisten"),
    (
        "Print where every address, timer, counter and block is used",
        "Ausgeben, wo jede Adresse, jede Zeit, jeder Zähler und jeder Baustein verwendet wird",
    ),
    (
        "Source files, symbol tables or a project folder [default: this folder]; last an address, a symbol or a variable",
        "Quelldateien, Symboltabellen oder ein Projektordner [Standard: dieser Ordner]; zuletzt eine Adresse, ein Symbol oder eine Variable",
    ),
    ("Name beside each address the others that share bits with it", "Zu jeder Adresse die anderen nennen, die Bits mit ihr teilen"),
    ("Show parameters, local and static variables too", "Auch Parameter, lokale und statische Variablen zeigen"),
    ("Show symbols that nothing uses and addresses that have no symbol", "Unbenutzte Symbole und Adressen ohne Symbol zeigen"),
    ("Draw networks as ladder or function block diagrams", "Netzwerke als Kontaktplan oder Funktionsplan zeichnen"),
    ("This block: `FC 1`, `FC1` or a symbol [default: all]", "Dieser Baustein: `FC 1`, `FC1` oder ein Symbol [Standard: alle]"),
    ("This network, from 1 [default: all]", "Dieses Netzwerk, ab 1 [Standard: alle]"),
    ("How networks are shown", "Wie Netzwerke gezeigt werden"),
    ("Draw text with the characters of ASCII only", "Text nur mit ASCII-Zeichen zeichnen"),
    ("Write to this file, by its ending as SVG, HTML or text", "In diese Datei schreiben, je nach Endung als SVG, HTML oder Text"),
    (
        "Print the sources as they are where they do not compile, and say nothing: for git, which compares what is printed",
        "Quellen, die sich nicht übersetzen lassen, unverändert und ohne Meldung ausgeben: für git, das die Ausgaben vergleicht",
    ),
    ("Print one JSON object for each network", "Ein JSON-Objekt für jedes Netzwerk ausgeben"),
    (
        "Print which block calls which, and the local data of every path",
        "Ausgeben, welcher Baustein welchen aufruft, und die Lokaldaten jedes Pfads",
    ),
    (
        "Print which inputs, outputs, bit memory, timers and counters are used",
        "Ausgeben, welche Eingänge, Ausgänge, Merker, Zeiten und Zähler belegt sind",
    ),
    // fleet
    ("Run very many controllers at once, coupled by links", "Sehr viele Steuerungen zugleich ausführen, durch Verbindungen gekoppelt"),
    ("The file of the fleet", "Die Datei der Flotte"),
    ("End after so much time of the controllers", "Nach so viel Zeit der Steuerungen enden"),
    ("max as fast as it goes, 1x in real time, 10x ten times as fast", "max so schnell es geht, 1x in Echtzeit, 10x zehnmal so schnell"),
    ("Another seed of the plants than that of the file", "Ein anderer Startwert der Anlagen als der der Datei"),
    (
        "Write the numbers of each controller to this file, as OpenMetrics",
        "Die Zahlen jeder Steuerung in diese Datei schreiben, als OpenMetrics",
    ),
    (
        "Write what goes into a controller and what comes out to this file, as a scenario (`-` prints it)",
        "Was in eine Steuerung hineingeht und was herauskommt, als Szenario in diese Datei schreiben (`-` gibt es aus)",
    ),
    // campaign
    (
        "Run a program through very many scenarios: every combination of its inputs, drawn values, faults",
        "Ein Programm durch sehr viele Szenarien laufen lassen: jede Kombination seiner Eingänge, gezogene Werte, Fehler",
    ),
    (
        "Print how many scenarios a campaign has, and the columns of its result; nothing runs",
        "Ausgeben, wie viele Szenarien eine Kampagne hat und welche Spalten ihr Ergebnis; nichts läuft",
    ),
    ("Run the scenarios of a campaign", "Die Szenarien einer Kampagne ausführen"),
    ("Print one scenario of a campaign as a *.scenario file", "Ein Szenario einer Kampagne als *.scenario-Datei ausgeben"),
    ("The file of the campaign", "Die Datei der Kampagne"),
    ("Another seed than that of the file", "Ein anderer Startwert als der der Datei"),
    ("Print it as one JSON object", "Als ein JSON-Objekt ausgeben"),
    ("Threads [default: one for each processor]", "Threads [Standard: einer je Prozessor]"),
    (
        "Threads of this computer [default: one for each processor, with `--nats` none]",
        "Threads dieses Rechners [Standard: einer je Prozessor, mit `--nats` keiner]",
    ),
    (
        "Take scenarios through the NATS server at this address [default: that of SIEBEN_NATS]",
        "Szenarien über den NATS-Server mit dieser Adresse nehmen [Standard: die von SIEBEN_NATS]",
    ),
    ("A file with the credentials for the server", "Eine Datei mit den Zugangsdaten für den Server"),
    (
        "A file with the certificate of the authority that the server belongs to",
        "Eine Datei mit dem Zertifikat der Stelle, zu der der Server gehört",
    ),
    // worker
    (
        "Take scenarios of campaigns that other machines run, through a NATS server",
        "Szenarien von Kampagnen, die andere Rechner ausführen, über einen NATS-Server nehmen",
    ),
    ("Work for this campaign only", "Nur für diese Kampagne arbeiten"),
    ("End after so long without work", "Nach so langer Zeit ohne Arbeit enden"),
    ("Only say whether the server can be used, by the exit code", "Nur durch den Exitcode sagen, ob der Server verwendet werden kann"),
    ("Which engine runs the programs", "Welche Engine die Programme ausführt"),
    ("Only these scenarios, both of them too", "Nur diese Szenarien, beide Grenzen eingeschlossen"),
    (
        "Scenarios that a thread takes at once [default: as many as take a quarter of a second]",
        "Szenarien, die ein Thread auf einmal nimmt [Standard: so viele, wie eine Viertelsekunde dauern]",
    ),
    (
        "End after the first failure, or after so many; it is always the one with the least number",
        "Nach dem ersten Fehlschlag enden, oder nach so vielen; es ist immer der mit der kleinsten Nummer",
    ),
    ("End after so much real time", "Nach so viel echter Zeit enden"),
    ("Print lines of progress and the result as JSON", "Zeilen zum Fortschritt und das Ergebnis als JSON ausgeben"),
    ("Print no progress", "Keinen Fortschritt ausgeben"),
    ("The number of the scenario, from 0", "Die Nummer des Szenarios, ab 0"),
    (
        "Keep what comes of it in this Parquet file; while it runs, in the folder FILE.part",
        "Was herauskommt, in dieser Parquet-Datei aufbewahren; während es läuft, im Ordner DATEI.part",
    ),
    (
        "Go on with what an earlier run left in FILE.part; without it, begin",
        "Mit dem fortfahren, was ein früherer Lauf in DATEI.part hinterließ; ist nichts da, beginnen",
    ),
    (
        "Make a scenario that fails as small as it fails in the same way",
        "Ein Szenario, das fehlschlägt, so klein machen, wie es noch auf dieselbe Weise fehlschlägt",
    ),
    ("Say what a result came to", "Sagen, was ein Ergebnis ergab"),
    ("The result", "Das Ergebnis"),
    ("Write a page to this file", "Eine Seite in diese Datei schreiben"),
    (
        "Write its charts, and timing diagrams of what failed, to this folder",
        "Seine Diagramme, und Impulsdiagramme dessen, was fehlschlug, in diesen Ordner schreiben",
    ),
    ("Write a report of JUnit to this file", "Einen JUnit-Bericht in diese Datei schreiben"),
    ("Make one result of the results of parts of a campaign", "Aus den Ergebnissen von Teilen einer Kampagne eines machen"),
    ("The results of the parts", "Die Ergebnisse der Teile"),
    ("Write the result to this file", "Das Ergebnis in diese Datei schreiben"),
    ("Print the summary as one JSON object", "Die Zusammenfassung als ein JSON-Objekt ausgeben"),
];

/// What stands below the arguments: headings, what an example does, paragraphs.
pub(super) const BELOW: &[Row] = &[
    ("Examples:", "Beispiele:"),
    ("Commands, one line each:", "Befehle, je einer auf einer Zeile:"),
    // sieben
    (
        "Without a command Sieben starts the demo plant; where no terminal shows it, it prints this help.",
        "Ohne Befehl startet Sieben die Demo-Anlage; wo kein Terminal sie zeigt, gibt es diese Hilfe aus.",
    ),
    ("a dosing plant, live in the terminal", "eine Dosieranlage, live im Terminal"),
    ("a project that runs and checks at once", "ein Projekt, das sofort läuft und sich prüfen lässt"),
    ("all errors and warnings", "alle Fehler und Warnungen"),
    ("run it", "es ausführen"),
    ("watch it run, from another terminal", "beim Laufen zusehen, aus einem anderen Terminal"),
    ("a few scans, then print values", "einige Zyklen, dann Werte ausgeben"),
    ("why is it 0? Statement by statement, and back", "warum ist es 0? Anweisung für Anweisung, und zurück"),
    ("what happens when, as a timing diagram", "was wann geschieht, als Impulsdiagramm"),
    ("its unit tests, in virtual time", "seine Bausteintests, in virtueller Zeit"),
    ("what an instruction does", "was eine Operation tut"),
    (
        "Exit codes: 0 ok, 1 a check failed, 2 usage, 3 does not compile, 4 the CPU went to STOP, 70 our own error.",
        "Exitcodes: 0 in Ordnung, 1 eine Prüfung schlug fehl, 2 Aufruf, 3 nicht übersetzbar, 4 die CPU ging in STOP, 70 ein Fehler von Sieben.",
    ),
    // demo, run, serve, top
    ("the plant, live in the terminal", "die Anlage, live im Terminal"),
    (
        "An editor starts it and speaks with it over standard input and output (Language Server Protocol). docs/how-to/editors.md says how to set up Neovim, Emacs and Helix; for VS Code there is an extension.",
        "Ein Editor startet ihn und spricht mit ihm über Standardein- und -ausgabe (Language Server Protocol).\ndocs/how-to/editors.md sagt, wie man Neovim, Emacs und Helix einrichtet; für VS Code gibt es eine Erweiterung.",
    ),
    (
        "Exit codes: 0 the editor has ended it, 1 the editor is gone, 2 usage.",
        "Exitcodes: 0 der Editor hat ihn beendet, 1 der Editor ist weg, 2 Aufruf.",
    ),
    (
        "S7 clients reach it at 127.0.0.1:1102, or at the next free port",
        "S7-Clients erreichen sie unter 127.0.0.1:1102 oder dem nächsten freien Port",
    ),
    ("the project in this folder, on a screen, until q", "das Projekt in diesem Ordner, mit Bildschirm, bis q"),
    ("one line for each change", "eine Zeile je Änderung"),
    ("ten seconds, then exit 0", "zehn Sekunden, dann Exitcode 0"),
    ("an hour of virtual time, at full speed", "eine Stunde virtueller Zeit, so schnell es geht"),
    ("with all values as the program declares them", "mit allen Werten, wie das Programm sie deklariert"),
    ("changed sources take over while it runs", "geänderte Quellen werden im Lauf übernommen"),
    ("S7 clients of this computer reach it at 127.0.0.1:1102", "S7-Clients dieses Rechners erreichen es unter 127.0.0.1:1102"),
    (
        "On a terminal the run has a screen: inputs to switch, outputs, the program, faults; ? shows its keys. With a server the run stays up while the CPU is in STOP, except with --for. Ctrl-C stops cleanly; a second Ctrl-C stops at once. Retentive data of a project survives both, and a kill. Exit codes: 0 ok, 1 a statement failed (--strict), 2 usage, 3 does not compile, 4 the CPU went to STOP.",
        "Auf einem Terminal hat der Lauf einen Bildschirm: Eingänge zum Schalten, Ausgänge, das Programm, Fehler; ? zeigt seine Tasten.\nMit einem Server läuft der Prozess weiter, während die CPU in STOP ist, außer mit --for.\nStrg-C hält geordnet an; ein zweites Strg-C sofort. Remanente Daten eines Projekts überstehen beides, auch einen Abbruch (kill).\nExitcodes: 0 in Ordnung, 1 eine Anweisung schlug fehl (--strict), 2 Aufruf, 3 nicht übersetzbar, 4 die CPU ging in STOP.",
    ),
    (
        "the servers of pump/sieben.toml; without any, S7 at 127.0.0.1:1102",
        "die Server aus pump/sieben.toml; ohne welche S7 unter 127.0.0.1:1102",
    ),
    ("other computers reach it too", "auch andere Rechner erreichen es"),
    ("says as JSON where it listens, as soon as it does", "sagt als JSON, wo es lauscht, sobald es lauscht"),
    (
        "It stays up while the CPU is in STOP, and ends in order at Ctrl-C or SIGTERM: connections are closed, retentive data is kept. Exit codes: 0 ended, 1 a statement failed (--strict), 2 usage, 3 does not compile; with --for 4 if the CPU went to STOP.",
        "Der Prozess läuft weiter, während die CPU in STOP ist, und endet geordnet mit Strg-C oder SIGTERM: Verbindungen werden geschlossen, remanente Daten gespeichert.\nExitcodes: 0 beendet, 1 eine Anweisung schlug fehl (--strict), 2 Aufruf, 3 nicht übersetzbar; mit --for 4, wenn die CPU in STOP ging.",
    ),
    ("the run of the project in this folder", "der Lauf des Projekts in diesem Ordner"),
    ("with values", "mit Werten"),
    ("one look, for programs", "eine Abfrage, für Programme"),
    ("the demo", "die Demo"),
    (
        "The run is one that `sieben run` with the same PATH, or `sieben demo`, has started in another terminal. It has the screen of `sieben run`; ? shows its keys, q leaves and lets the run go on. Exit codes: 0 ok, 2 usage, or nothing runs.",
        "Der Lauf ist einer, den `sieben run` mit demselben PFAD oder `sieben demo` in einem anderen Terminal gestartet hat.\nDer Bildschirm ist der von `sieben run`; ? zeigt seine Tasten, q verlässt ihn, und der Lauf geht weiter.\nExitcodes: 0 in Ordnung, 2 Aufruf, oder nichts läuft.",
    ),
    // check, exec, step, bench
    ("the project in this folder", "das Projekt in diesem Ordner"),
    ("each program of a folder of exercises", "jedes Programm eines Ordners mit Übungen"),
    ("a source with its symbol table", "eine Quelle mit ihrer Symboltabelle"),
    ("for an editor or a script", "für einen Editor oder ein Skript"),
    ("annotations in a workflow of GitHub Actions", "Anmerkungen in einem Ablauf von GitHub Actions"),
    ("mend what can mean only one thing", "berichtigen, was nur eines bedeuten kann"),
    ("what an online change from `backup` would do", "was eine Online-Änderung von `backup` aus täte"),
    ("Exit codes: 0 no errors, 3 errors.", "Exitcodes: 0 keine Fehler, 3 Fehler."),
    (
        "Time is virtual: scan k begins at k x cycle, the first at 0. A file of bare statements is the body of OB 1. A register gets what `L` would load (`ACCU1=-1` is 16#0000_FFFF), an address or variable the number in its own width. STW is nine characters: BR CC1 CC0 OV OS OR STA RLO /FC.",
        "Die Zeit ist virtuell: Zyklus k beginnt bei k x Zykluszeit, der erste bei 0. Eine Datei nur mit Anweisungen ist der Rumpf von OB 1. Ein Register erhält, was `L` laden würde (`AKKU1=-1` ist 16#0000_FFFF), eine Adresse oder Variable die Zahl in ihrer eigenen Breite. STW sind neun Zeichen: BIE A1 A0 OV OS OR STA VKE /ER.",
    ),
    (
        "Exit codes: 0 ok, 1 --check-temp found something or a statement failed (--strict), 2 usage, 3 does not compile, 4 the CPU went to STOP.",
        "Exitcodes: 0 in Ordnung, 1 --check-temp fand etwas oder eine Anweisung schlug fehl (--strict), 2 Aufruf, 3 nicht übersetzbar, 4 die CPU ging in STOP.",
    ),
    ("the screen, with keys for every step", "der Bildschirm, mit Tasten für jeden Schritt"),
    ("commands from a file", "Befehle aus einer Datei"),
    ("on", "vorwärts"),
    ("the same steps back", "dieselben Schritte zurück"),
    (
        "Time is virtual, as with `exec`. The columns are the registers after the statement of the row, in ST and SCL the variables that it names; below it stands why, and what it changed.",
        "Die Zeit ist virtuell, wie bei `exec`. Die Spalten sind die Register nach der Anweisung der Zeile, in ST und SCL die Variablen, die sie nennt; darunter steht, warum, und was sie änderte.",
    ),
    (
        "Exit codes: 0 ok, 2 usage or a wrong command, 3 does not compile, 4 the CPU is in STOP.",
        "Exitcodes: 0 in Ordnung, 2 Aufruf oder ein falscher Befehl, 3 nicht übersetzbar, 4 die CPU ist in STOP.",
    ),
    ("the machine code of the first scans", "der Maschinencode der ersten Zyklen"),
    ("the same machine code without one of its optimizations", "derselbe Maschinencode ohne eine seiner Optimierungen"),
    ("ten thousand controllers in one process", "zehntausend Steuerungen in einem Prozess"),
    (
        "Time is virtual; what is measured is the CPU time of the thread, process images and cycle included. Figures of one machine do not carry over to another.",
        "Die Zeit ist virtuell; gemessen wird die Prozessorzeit des Threads, mit Prozessabbildern und Zyklus. Zahlen eines Rechners gelten nicht für einen anderen.",
    ),
    (
        "Exit codes: 0 ok, 2 usage, 3 does not compile, 4 the CPU went to STOP.",
        "Exitcodes: 0 in Ordnung, 2 Aufruf, 3 nicht übersetzbar, 4 die CPU ging in STOP.",
    ),
    // test, trace, record
    ("all tests of the project in this folder", "alle Tests des Projekts in diesem Ordner"),
    ("those of one file, with the program around it", "die einer Datei, mit dem Programm um sie herum"),
    ("their names", "ihre Namen"),
    ("and which lines of the program they run", "und welche Zeilen des Programms sie ausführen"),
    ("the same as pages for a browser", "dasselbe als Seiten für einen Browser"),
    ("a program that checks itself", "ein Programm, das sich selbst prüft"),
    ("every test and program in a folder", "alle Tests und Programme in einem Ordner"),
    ("the tests in ue1.test.st beside it", "die Tests in ue1.test.st daneben"),
    ("those with `shift` in their name", "die mit `shift` im Namen"),
    ("tests of the blocks of a project", "Tests der Bausteine eines Projekts"),
    ("does it what was recorded of another program?", "tut es, was von einem anderen Programm aufgezeichnet wurde?"),
    ("for a build server", "für einen Build-Server"),
    (
        "A unit test stands in a file *.test.st, or any source that begins with TEST, SETUP or TEARDOWN: TEST 'the motor starts' … END_TEST, with ASSERT_EQ(a, b), SCAN(n), ADVANCE_TIME(T#5s) and others. In a folder with several programs ue1.test.st, ue1_test.st and test_ue1.st test ue1.awl. A program has passed when it calls SFC 46, and failed when one of its assertions (`__ASSERT== MW 10, 5`) is false, when the CPU goes to STOP, or when it does not end. A program in a folder that has neither is no test. A scenario (*.scenario) with an expectation is a test, too; one of `sieben record` holds the program against every scan of the recording. Time is virtual, and the extension words need no `--extended`.",
        "Ein Bausteintest steht in einer Datei *.test.st oder einer Quelle, die mit TEST, SETUP oder TEARDOWN beginnt: TEST 'der Motor startet' … END_TEST, mit ASSERT_EQ(a, b), SCAN(n), ADVANCE_TIME(T#5s) und anderen. In einem Ordner mit mehreren Programmen prüfen ue1.test.st, ue1_test.st und test_ue1.st das Programm ue1.awl.\nEin Programm hat bestanden, wenn es SFC 46 aufruft, und nicht bestanden, wenn eine seiner Behauptungen (`__ASSERT== MW 10, 5`) falsch ist, wenn die CPU in STOP geht oder wenn es nicht endet. Ein Programm in einem Ordner, das keines von beiden hat, ist kein Test.\nAuch ein Szenario (*.scenario) mit einer Erwartung ist ein Test; eines von `sieben record` misst das Programm an jedem Zyklus der Aufzeichnung.\nDie Zeit ist virtuell, und die Erweiterungswörter brauchen kein `--extended`.",
    ),
    (
        "Exit codes: 0 all passed, 1 one failed or there is no test, 2 usage, 3 one does not compile.",
        "Exitcodes: 0 alle bestanden, 1 einer nicht bestanden oder kein Test, 2 Aufruf, 3 einer nicht übersetzbar.",
    ),
    ("inputs and outputs, as a diagram", "Ein- und Ausgänge, als Diagramm"),
    ("for GTKWave", "für GTKWave"),
    ("keep it,", "aufheben,"),
    ("and look at it later", "und später ansehen"),
    (
        "Time is virtual, as with `sieben exec`: scan k begins at k x cycle. A sample is taken behind every scan; a value holds until the scan that changed it, and nothing is drawn between. Without --channels these are the inputs and outputs that the program uses. A scenario (FILE.scenario) brings its own inputs, times and expectations.",
        "Die Zeit ist virtuell, wie bei `sieben exec`: Zyklus k beginnt bei k x Zykluszeit. Abgetastet wird nach jedem Zyklus; ein Wert gilt bis zu dem Zyklus, der ihn änderte, und dazwischen wird nichts gezeichnet. Ohne --channels sind es die Ein- und Ausgänge, die das Programm verwendet. Ein Szenario (DATEI.scenario) bringt seine eigenen Eingänge, Zeiten und Erwartungen mit.",
    ),
    (
        "Exit codes: 0 ok, 1 an expectation failed or the trigger did not come, 2 usage, 3 does not compile, 4 the CPU went to STOP.",
        "Exitcodes: 0 in Ordnung, 1 eine Erwartung traf nicht ein oder der Trigger kam nicht, 2 Aufruf, 3 nicht übersetzbar, 4 die CPU ging in STOP.",
    ),
    ("the project with its plants, until Ctrl-C", "das Projekt mit seinen Anlagen, bis Strg-C"),
    ("what the program does in a scenario", "was das Programm in einem Szenario tut"),
    ("print it", "ausgeben"),
    ("does the new program do the same?", "tut das neue Programm dasselbe?"),
    (
        "The recording is a scenario: inputs with their times, interrupts, the times of the scans, and behind every scan the outputs. `sieben test` and `sieben trace` run it again, on the same program scan by scan the same, and without the plants: it has the values of their sensors. Time is virtual: scan k begins at k x cycle; at 1x it is waited for. Ctrl-C ends the recording between two scans. A killed process leaves all but its last second.",
        "Die Aufzeichnung ist ein Szenario: Eingänge mit ihren Zeiten, Alarme, die Zeiten der Zyklen und nach jedem Zyklus die Ausgänge. `sieben test` und `sieben trace` führen es noch einmal aus, mit demselben Programm Zyklus für Zyklus gleich, und ohne die Anlagen: Es enthält die Werte ihrer Geber. Die Zeit ist virtuell: Zyklus k beginnt bei k x Zykluszeit; bei 1x wird darauf gewartet. Strg-C beendet die Aufzeichnung zwischen zwei Zyklen. Ein abgebrochener Prozess hinterlässt alles bis auf die letzte Sekunde.",
    ),
    (
        "Exit codes: 0 ok, 1 an expectation of the scenario failed, 2 usage, 3 does not compile, 4 the CPU went to STOP.",
        "Exitcodes: 0 in Ordnung, 1 eine Erwartung des Szenarios traf nicht ein, 2 Aufruf, 3 nicht übersetzbar, 4 die CPU ging in STOP.",
    ),
    // fleet
    ("10 s of all its controllers, as fast as it goes", "10 s aller ihrer Steuerungen, so schnell es geht"),
    ("an hour, and the result as JSON", "eine Stunde, und das Ergebnis als JSON"),
    ("in real time, until Ctrl-C", "in Echtzeit, bis Strg-C"),
    ("the numbers of each controller", "die Zahlen jeder Steuerung"),
    ("what goes into one of them", "was in eine von ihnen hineingeht"),
    (
        "What comes of it does not depend on threads, engine or speed: what a controller sends arrives at the time that its link says. One that goes to STOP is a row of the result, and the others go on.",
        "Was herauskommt, hängt nicht von Threads, Engine oder Tempo ab: Was eine Steuerung sendet, kommt zu der Zeit an, die ihre Verbindung sagt. Eine, die in STOP geht, ist eine Zeile des Ergebnisses, und die anderen laufen weiter.",
    ),
    ("Exit codes: 0 ok, 2 usage, 3 does not compile, 130 Ctrl+C.", "Exitcodes: 0 in Ordnung, 2 Aufruf, 3 nicht übersetzbar, 130 Strg+C."),
    // campaign
    ("all of it, on all processors", "alles, auf allen Prozessoren"),
    ("the first thousand", "die ersten tausend"),
    ("the failure with the least number", "der Fehlschlag mit der kleinsten Nummer"),
    ("until Ctrl+C", "bis Strg+C"),
    ("as long as there is work", "solange es Arbeit gibt"),
    ("the password in no list of processes", "das Passwort in keiner Prozessliste"),
    (
        "The program comes with the campaign: nothing but this binary is needed.",
        "Das Programm kommt mit der Kampagne: Nichts als diese Binärdatei wird gebraucht.",
    ),
    (
        "Exit codes: 0 ended, 2 usage, or a server that cannot be used.",
        "Exitcodes: 0 zu Ende, 2 Aufruf, oder ein Server, der nicht verwendet werden kann.",
    ),
    ("for the terminal", "für das Terminal"),
    ("its charts and timing diagrams as files", "seine Diagramme und Impulsdiagramme als Dateien"),
    ("one page with charts, without network", "eine Seite mit Diagrammen, ohne Netz"),
    ("a test case for each property", "ein Testfall je Eigenschaft"),
    (
        "Exit codes: 0 all scenarios are there and all held, 1 a property broke, what has to come sometimes never came, or scenarios are missing, 2 usage, or no result that can be read.",
        "Exitcodes: 0 alle Szenarien sind da und alles gilt, 1 eine Eigenschaft brach, was manchmal kommen muss, kam nie, oder Szenarien fehlen, 2 Aufruf, oder kein lesbares Ergebnis.",
    ),
    ("print the small scenario", "das kleine Szenario ausgeben"),
    ("a file for `sieben test`, `trace` and `step`", "eine Datei für `sieben test`, `trace` und `step`"),
    (
        "It breaks the same property, and the same statement wrote what the property says last. Faults go first, then events, then parameters; then times get shorter and numbers rounder.",
        "Es bricht dieselbe Eigenschaft, und dieselbe Anweisung schrieb zuletzt, wovon sie spricht. Zuerst verschwinden Fehler, dann Ereignisse, dann Parameter; danach werden Zeiten kürzer und Zahlen runder.",
    ),
    (
        "Exit codes: 0 ok, 2 usage, or the scenario does not fail, 3 does not compile.",
        "Exitcodes: 0 in Ordnung, 2 Aufruf, oder das Szenario schlägt nicht fehl, 3 nicht übersetzbar.",
    ),
    ("a row of each scenario, kept as it comes", "eine Zeile je Szenario, aufbewahrt, sobald sie da ist"),
    ("lines of progress, then the result", "Zeilen zum Fortschritt, dann das Ergebnis"),
    (
        "The result has the same bytes as that of one run over all scenarios.",
        "Das Ergebnis hat dieselben Bytes wie das eines einzigen Laufs über alle Szenarien.",
    ),
    (
        "Exit codes: 0 all scenarios are there and all held, 1 a property broke, what has to come sometimes never came, or scenarios are missing, 2 usage or results of different campaigns.",
        "Exitcodes: 0 alle Szenarien sind da und alles gilt, 1 eine Eigenschaft brach, was manchmal kommen muss, kam nie, oder Szenarien fehlen, 2 Aufruf oder Ergebnisse verschiedener Kampagnen.",
    ),
    (
        "What comes of it does not depend on threads, engine or machine: a scenario is a function of the program, the file, the seed and its number.",
        "Was herauskommt, hängt nicht von Threads, Engine oder Rechner ab: Ein Szenario ist eine Funktion des Programms, der Datei, des Startwerts und seiner Nummer.",
    ),
    (
        "Exit codes: 0 all held, 1 a property broke or what has to come sometimes never came, 2 usage, 3 does not compile, 5 the time is used up, 70 a fault of ours, 130 Ctrl+C (`--resume` goes on after 5 and 130).",
        "Exitcodes: 0 alles gilt, 1 eine Eigenschaft brach oder was manchmal kommen muss, kam nie, 2 Aufruf, 3 nicht übersetzbar, 5 die Zeit ist aufgebraucht, 70 ein Fehler von uns, 130 Strg+C (nach 5 und 130 geht es mit `--resume` weiter).",
    ),
    // explain, fmt, convert, new
    ("an instruction, in either mnemonic language", "eine Operation, in beiden Mnemoniken"),
    ("quote what the shell would take", "in Anführungszeichen, was die Shell sonst deutet"),
    ("a function or a block of Structured Text", "eine Funktion oder ein Baustein von Strukturiertem Text"),
    ("a problem code", "ein Problemcode"),
    ("an element or a box of a diagram: MID, COIL, S_ODT, ADD_I", "ein Element oder eine Box eines Plans: MID, COIL, S_ODT, ADD_I"),
    (
        "why a network is not drawn; also: what a rewrite changes, W3",
        "warum ein Netzwerk nicht gezeichnet wird; auch: was ein Umschreiben ändert, W3",
    ),
    ("a CPU type", "ein CPU-Typ"),
    ("a bit of the status word", "ein Bit des Statusworts"),
    ("an organization block", "ein Organisationsbaustein"),
    ("a system function, also by its name: STP", "eine Systemfunktion, auch mit ihrem Namen: STP"),
    ("a block of the library, also by its number: FC 2", "ein Baustein der Bibliothek, auch mit seiner Nummer: FC 2"),
    ("an event of the diagnostic buffer", "ein Ereignis des Diagnosepuffers"),
    (
        "a word of a course: a register, a type, a part of an operand",
        "ein Wort aus einem Kurs: ein Register, ein Datentyp, ein Teil eines Operanden",
    ),
    (
        "all of them; also: functions, problems, cpu, library, system, ob",
        "alle Operationen; auch: functions, problems, cpu, library, system, ob",
    ),
    ("what every instruction does to the status word", "was jede Operation mit dem Statuswort tut"),
    ("when every jump jumps", "wann jeder Sprung springt"),
    ("how values can be shown: `--show MD20:REAL`", "wie Werte gezeigt werden können: `--show MD20:REAL`"),
    ("print the formatted source", "die formatierte Quelle ausgeben"),
    ("format all sources of a project in place", "alle Quellen eines Projekts an Ort und Stelle formatieren"),
    ("exit 1 if a source is not formatted", "Exitcode 1, wenn eine Quelle nicht formatiert ist"),
    (
        "Encoding and line ends of a file stay as they are; comments and everything else are kept. A source with syntax errors is left alone (exit 3).",
        "Zeichenkodierung und Zeilenenden einer Datei bleiben, ebenso Kommentare und alles andere. Eine Quelle mit Syntaxfehlern bleibt unberührt (Exitcode 3).",
    ),
    ("print it with A, JC, OPN", "mit A, JC, OPN ausgeben"),
    ("all sources of a project in place", "alle Quellen eines Projekts an Ort und Stelle"),
    ("its networks as ladder, what cannot be drawn stays STL", "seine Netzwerke als KOP, was sich nicht zeichnen lässt, bleibt AWL"),
    (
        "With `--mnemonics` only instructions, addresses and status words change; layout, comments, encoding and line ends stay. A source with syntax errors is left alone (exit 3). With `--to` a network that cannot be drawn stays as it is and is reported (exit 0); `--rewrite` also draws those that mean the same after a rewrite (`sieben explain W2`). A program that does not compile is left alone (exit 3).",
        "Mit `--mnemonics` ändern sich nur Operationen, Adressen und Statuswörter; Anordnung, Kommentare, Zeichenkodierung und Zeilenenden bleiben. Eine Quelle mit Syntaxfehlern bleibt unberührt (Exitcode 3).\nMit `--to` bleibt ein Netzwerk, das sich nicht zeichnen lässt, wie es ist, und wird gemeldet (Exitcode 0); `--rewrite` zeichnet auch die, die umgeschrieben dasselbe bedeuten (`sieben explain W2`). Ein Programm, das sich nicht übersetzen lässt, bleibt unberührt (Exitcode 3).",
    ),
    ("the program in structured text; also stl, scl, lad, fbd", "das Programm in Strukturiertem Text; auch stl, scl, lad, fbd"),
    ("a copy of an example, with its plant and its tests", "eine Kopie eines Beispiels, mit seiner Anlage und seinen Tests"),
    ("Nothing that exists is overwritten.", "Nichts Vorhandenes wird überschrieben."),
    // symbols, tags, refs, render, structure, assignments
    ("the assignment table", "die Zuordnungstabelle"),
    ("the same for a spreadsheet", "dasselbe für eine Tabellenkalkulation"),
    ("a page to print", "eine Seite zum Drucken"),
    ("the name says the format", "der Name bestimmt das Format"),
    (
        "Without --to the assignment table is printed: number, address, unit, technological name, description, remark. The formats sdf, asc, dif and seq are those of STEP 7, written in code page 1252 unless a file that was read had another.",
        "Ohne --to wird die Zuordnungstabelle ausgegeben: Nummer, Adresse, Einheit, technologischer Name, Beschreibung, Bemerkung. Die Formate sdf, asc, dif und seq sind die von STEP 7, geschrieben in Codepage 1252, wenn keine gelesene Datei eine andere hatte.",
    ),
    ("the project in this folder, as CSV", "das Projekt in diesem Ordner, als CSV"),
    (
        "Tags are the symbols with an address and the fields of all data blocks. Formats: csv, a table with a heading; snap7, a module for Python whose items `read_multi_vars` of python-snap7 takes as they are; nodered, the list that the S7 endpoint of Node-RED imports, in addresses of nodes7; json, all of it.",
        "Variablen sind die Symbole mit einer Adresse und die Komponenten aller Datenbausteine. Formate: csv, eine Tabelle mit Überschrift; snap7, ein Modul für Python, dessen Einträge `read_multi_vars` von python-snap7 unverändert nimmt; nodered, die Liste, die der S7-Endpunkt von Node-RED importiert, in Adressen von nodes7; json, alles zusammen.",
    ),
    ("the cross reference of the project in this folder", "die Querverweisliste des Projekts in diesem Ordner"),
    ("one address", "eine Adresse"),
    ("a symbol, with the addresses that share bits with it", "ein Symbol, mit den Adressen, die Bits mit ihm teilen"),
    ("a block; of a data block also its contents", "ein Baustein; von einem Datenbaustein auch sein Inhalt"),
    ("symbols that nothing uses, addresses without a symbol", "unbenutzte Symbole, Adressen ohne Symbol"),
    (
        "Types: R read, W written, RW both, call, open, inst (instance of a call), P# (the address or number is taken). `*` marks an address that is computed at run time.",
        "Arten: R gelesen, W geschrieben, RW beides, call, open, inst (Instanz eines Aufrufs), P# (Adresse oder Nummer wird genommen). `*` bezeichnet eine Adresse, die zur Laufzeit berechnet wird.",
    ),
    ("every block as ladder, in the terminal", "jeder Baustein als KOP, im Terminal"),
    ("a block to read and print", "ein Baustein zum Lesen und Drucken"),
    (
        "A network that cannot be drawn is shown as STL, and below it stands why. In git: `git config diff.sieben.textconv 'sieben render --as lad --or-source'`, and in .gitattributes `*.awl diff=sieben`.",
        "Ein Netzwerk, das sich nicht zeichnen lässt, wird als AWL gezeigt, und darunter steht, warum.\nIn git: `git config diff.sieben.textconv 'sieben render --as lad --or-source'`, und in .gitattributes `*.awl diff=sieben`.",
    ),
    (
        "Each organization block begins a tree. `Local` is what a block needs itself, `Path` what all blocks from the first one down to it need together. What a block calls is written once in a tree. Blocks that nothing calls stand at the end, marked with `x`.",
        "Jeder Organisationsbaustein beginnt einen Baum. `Lokal` ist, was ein Baustein selbst braucht, `Pfad`, was alle Bausteine vom ersten bis zu ihm zusammen brauchen. Was ein Baustein aufruft, steht in einem Baum nur einmal. Bausteine, die nicht aufgerufen werden, stehen am Ende, mit `x` bezeichnet.",
    ),
    (
        "A row for each byte that is used. Bits: X as a bit, o as part of a byte, word or double word, p named by a pointer or range. B, W, D: X where an access begins, | where it goes on. Accesses whose address is computed at run time may reach any byte; they are listed below.",
        "Eine Zeile für jedes belegte Byte. Bits: X als Bit, o als Teil eines Bytes, Worts oder Doppelworts, p von einem Zeiger oder Bereich genannt. B, W, D: X, wo ein Zugriff beginnt, | wo er weitergeht. Zugriffe, deren Adresse zur Laufzeit berechnet wird, können jedes Byte erreichen; sie stehen darunter.",
    ),
];
