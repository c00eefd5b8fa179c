//! The table of problem codes: code, severity, what is wrong, what to do.
//!
//! 1xxx characters and words, 2xxx syntax, 3xxx names, 4xxx types and ranges, 5xxx limits of the
//! CPU type, 6xxx files and projects, 7xxx command line, 8xxx run time, 9xxx diagrams. A code is never reused.

use crate::diagnostic::Severity;

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
    ($( $Code:ident $Severity:ident $title:literal $help:literal; )*) => {
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
            pub fn title(self) -> &'static str { match self { $(Self::$Code => $title),* } }
            /// What to do about it.
            pub fn help(self) -> &'static str { match self { $(Self::$Code => $help),* } }
            /// The problem with this code, without regard to case.
            pub fn from_code(code: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|problem| problem.code().eq_ignore_ascii_case(code))
            }
        }
    };
}

problems! {
    // 1xxx characters and words
    P1001 Error "a character that does not belong here" "Remove it, or put it into a comment or a string.";
    P1002 Error "characters without their closing apostrophe" "Write `'` behind the last character; an apostrophe inside is written `$'`.";
    P1003 Error "a quoted name without its closing quote" "Write `\"` behind the name, on the same line.";
    P1004 Error "a comment without its end" "Write `*)` where the comment ends.";
    P1005 Error "a character that only looks like the right one" "Write the letter, digit or sign that the message names.";
    P1101 Error "a binary file instead of a source text" "Name the source (.awl, .stl, .csv, .sdf), not a block, an archive or a project database.";
    P1102 Warning "bytes that mean nothing in the encoding of the file" "Choose another encoding, or save the file as UTF-8.";
    P1103 Error "a character that the encoding of the file does not have" "Save the file as UTF-8, or replace the character.";
    P1104 Error "a source larger than 64 MiB" "Split it, or check whether the file is a source at all.";

    // 2xxx syntax
    P2001 Error "a word where a statement should begin is not an instruction" "Use an instruction of the mnemonic language of the file.";
    P2002 Error "a statement in the other mnemonic language" "Write what the message names, or tell the language of the file with --mnemonics.";
    P2003 Warning "a word that both mnemonic languages have, and no other word to tell which" "Name the language of the file with --mnemonics.";
    P2004 Error "more text where a statement has ended" "Separate statements by `;` or a line end, and begin a comment with `//`.";
    P2005 Error "an operand that is not understood" "Write an address such as `M 1.0`, a symbol in quotes, `#local` or a constant.";
    P2006 Refused "a label of more than four characters" "STEP 7 takes at most four letters and digits; shorten the label if the program is for a real CPU.";
    P2007 Error "a misprint of the assignment sign" "Write `:=`.";
    P2008 Error "a known misprint of an instruction or operand" "Write what the message names.";
    P2010 Error "a block without a name" "Write the kind and number of the block, such as `FC 1`, or a symbol in quotes.";
    P2011 Error "a block without its end" "Write the END_ keyword of the block behind its last statement.";
    P2012 Error "a block that ends with the keyword of another kind" "Use the END_ keyword that belongs to the first keyword of the block.";
    P2013 Error "the end of a block that did not begin" "Remove it, or write the beginning of the block.";
    P2014 Error "a header line that is not understood" "Write it as `AUTHOR : name`, or `TITLE = text`.";
    P2015 Error "an attribute list that is not understood" "Write it as `{ name := 'value' }`.";
    P2016 Error "a bracket that is not closed" "Write `]` behind the index or pointer.";
    P2017 Error "an assignment of a data block that is not understood" "Write `name := value;`.";
    P2018 Error "a path into a variable that is not understood" "Write `.field` or `[1]` with whole numbers, without blanks.";
    P2019 Error "a keyword where statements stand" "Write declarations before BEGIN, and remove what does not belong to the block.";
    P2020 Error "a declaration that is not understood" "Write `name : INT;`.";
    P2021 Error "a data type that is not understood" "Use an elementary type, STRING [n], ARRAY [1..5] OF, STRUCT, a UDT or a function block.";
    P2022 Error "nesting that is too deep" "Use fewer levels; STEP 7 allows eight.";
    P2023 Error "a declaration section without its end" "Write `END_VAR` or `END_STRUCT` behind the last declaration.";
    P2024 Error "an initial value that is not understood" "Write a constant, constants with commas, or `3 (0)` for a repetition.";
    P2030 Error "a parameter that is not understood" "Write `name := value`, with commas between the parameters.";
    P2031 Error "a parameter list without its end" "Write `)` behind the last parameter.";
    P2040 Error "an extension word in a program that is not extended" "Say `--extended`, or `extended = true` under `[project]` in `sieben.toml`, if the program was written for awlsim; a real CPU does not have these words.";
    P2041 Error "an extension word with other operands than it takes" "Write it the way the message shows.";
    P2042 Warning "an extension word that asks for a CPU with both two and four accumulators" "Ask for one number of accumulators in the whole program, or choose the CPU type with --cpu.";
    P2043 Error "a mark of a printed listing where statements stand" "Remove the fence; write the statements that the page leaves out, or `NOP 0`.";
    P2044 Error "an operand or instruction of STEP 5" "Write what the message names; STL calls bit memory M, counts the bytes of a data block, and writes constants as W#16#, 2#, C# and S5T#.";
    P2045 Error "the heading of a printed block or network" "Begin a block with its keyword, such as `FUNCTION FC 30 : VOID`, and a network with `NETWORK`; what it is called stands after `TITLE =`.";
    P2046 Error "a name with spaces and without quotes" "Write the symbol in quotes, or the name with underscores.";
    P2199 Error "more problems than are shown" "Mend the problems that are shown first.";
    P2200 Error "a block header that does not fit its block" "Name a block of the kind that the keyword says: FUNCTION with an FC, FUNCTION_BLOCK with an FB, DATA_BLOCK with a DB, ORGANIZATION_BLOCK with an OB, TYPE with a UDT.";
    P2201 Error "a VAR section that this kind of block does not have" "An OB has VAR_TEMP; an FC has VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT and VAR_TEMP; only an FB has VAR too.";
    P2203 Error "a bracket that is never closed" "Close it with `)` before the block ends.";
    P2204 Error "a closing bracket without an opening one" "Remove it, or open the bracket with `A(`, `O(`, `X(` or their negated forms.";
    P2205 Error "more than seven open brackets" "Split the logic: assign a part to a memory bit first.";
    P2206 Error "a jump into or out of a bracket" "Jump before the bracket is opened or after it is closed.";
    P2207 Warning "MCR zones that are not balanced" "Open every zone with `MCR(` and close it with `)MCR` in the same block, at most eight inside one another.";
    P2208 Warning "a statement that is never reached" "Remove it, or put a label before it that a jump leads to.";
    P2209 Error "a jump list with something else than its jumps" "Write only `JU` between `JL` and the statement with its label, at most 255 of them.";
    P2210 Error "a data block or type without a structure" "Write `STRUCT … END_STRUCT`, or the UDT, FB or SFB that it is based on.";
    P2211 Error "a STRUCT without fields" "Declare at least one field.";
    P2212 Warning "an initial value where none is kept" "Remove it, and assign the value with a statement.";
    P2213 Error "a block end inside a bracket" "Close the bracket first.";
    P2214 Warning "a block call inside a bracket" "Close the bracket first: the nesting stack of the caller has to be empty at a call.";
    P2300 Error "a test without a name in quotes" "Write `TEST 'what is true when it passes'`.";
    P2301 Error "a part of a test file that is there twice" "Give every test a name of its own, and write SETUP and TEARDOWN once.";
    P2302 Error "a test file without a test" "Write `TEST 'what is true' … END_TEST`.";
    P2303 Error "a statement of a test file outside of a test" "Put it into TEST, SETUP or TEARDOWN.";
    P2304 Error "a word of a test file outside of one" "Write it in a file whose name ends with `.test.st`, and run that with `sieben test`.";
    P2305 Error "a word of a test file that is not used as it has to be" "Use it as the message shows.";
    P2306 Error "something that cannot be mocked" "Mock an instance of a function block, or a function of the program.";

    // 3xxx names
    P2401 Error "a word that is no element of a diagram" "Begin each line with an element (NO, NC, COIL, OR, BRANCH …) or with the name of a box; `sieben explain NO` tells what an element does.";
    P2402 Error "an element of a diagram without its operand, or with one too many" "Write the operand after the element: `NO I 0.0`, `CMP >I MW 10, 100`.";
    P2403 Error "a pin that the box does not have, has twice, or that nothing is wired to" "Name the pins of the box, each once: `IN1 := MW 10`, `OUT => MW 12`.";
    P2404 Error "a wire of a diagram that leads nowhere" "End the rung with a coil or a box, and each OR and BRANCH with END.";
    P2405 Error "a short circuit in a diagram" "Put an element into each branch.";
    P2406 Error "an element of a diagram at a place where it cannot stand" "Coils stand at the right end of a rung; an edge, NOT and a midline output need logic before them.";
    P2407 Error "an element that only FBD has, in a network of LAD" "Begin the network with `NETWORK FBD`, or draw it with contacts and NOT.";
    P2408 Error "a diagram that is too large, or nested too deep" "Divide the network into several.";
    P2409 Error "a diagram on one line that is not understood" "A space is AND, `|` in brackets OR, `/` a normally closed contact, and the coils stand after `->`: `(I 0.0 | Q 0.0) /I 0.1 -> = Q 0.0`.";
    P2410 Error "an operand that the pin of an element does not take" "Wire an operand of the type that the message names; MOVE takes any width, and I_DINT, DI_REAL, ROUND and the like convert.";
    P2411 Warning "a parameter that the called block writes, with logic wired to it" "Wire the operand itself to the pin: `p := =M 0.0` for IN_OUT, `p => M 0.0` for an output.";
    P2412 Warning "SAVE as the last coil of a rung that another one follows" "Put a coil below SAVE, which ends the line, or SAVE into the last rung of the block.";
    P2440 Error "an element of S7 blocks in a diagram of IEC 61131-3" "Draw what the message names instead.";
    P2441 Error "a coil that nothing is wired to" "Draw what it is to be assigned before it; TRUE is written as a contact.";
    P2442 Error "a body with statements and a diagram" "Write the diagram in a block or an action of its own.";
    P2443 Warning "an instance, a counter or an edge memory that two elements of a diagram use" "Give each element one of its own, or read what the first one delivers.";
    P2444 Error "a contact, a coil or EN of a diagram that is no BOOL" "Read or write one bit, or draw a box: it takes operands of any type.";
    P3001 Error "a name that is not declared" "Declare it in the symbol table or in the VAR sections of the block.";
    P3002 Error "two blocks with one number" "Give one of them another number, or name only the files that belong together.";
    P3003 Error "a block named by a symbol that is not in the symbol table" "Add the symbol with the number of the block as its address, for example `FC 1`.";
    P3004 Error "a jump to a label that does not exist" "Write the label before a statement of the same block; case matters.";
    P3005 Error "a label that stands twice in a block" "Rename one of them.";
    P3006 Error "a name that is declared twice" "Rename one of them; case does not distinguish names.";
    P3007 Error "a field that the structure does not have" "Use a field of its declaration.";
    P3008 Error "a block that does not exist" "Add its source to the project, or correct the number.";
    P3009 Error "a parameter that the block does not have" "Use the names of its VAR_INPUT, VAR_OUTPUT and VAR_IN_OUT; the result of a function is RET_VAL.";
    P3010 Error "a call without all parameters" "Give every parameter of a function a value or a variable.";
    P3011 Error "a parameter that is given twice" "Remove one of the two.";
    P3012 Error "a symbol with more than one address" "Rename one of the rows of the symbol table.";
    P3013 Warning "no OB 1" "Write the cyclic program as `ORGANIZATION_BLOCK OB 1`; without it the CPU runs and does nothing.";
    P3014 Warning "an instance data block without a source" "It is made with the initial values of the function block; write `DATA_BLOCK DB n FB m BEGIN END_DATA_BLOCK` to have it in the sources.";
    P3015 Error "a type that does not exist" "Use an elementary type, ARRAY, STRUCT, or a UDT of the project.";
    P3016 Error "a type that contains itself" "Remove the field that closes the circle.";
    P3017 Error "a data block that is not an instance of the called block" "Call with a data block that is based on this function block.";
    P3018 Warning "a block that does not exist when it is opened or called" "Add its source to the project, or correct the number.";
    P3019 Error "a call with a wrong instance" "An FB or SFB needs a data block behind the comma; an FC, an SFC and a multi-instance have none.";
    P3020 Error "a symbol that is not in the symbol table" "Add it to the symbol table, or correct its spelling.";
    P3021 Error "a symbol without a usable address" "Correct its address in the symbol table.";

    // 4xxx types and ranges
    P4001 Error "a constant outside its range" "Use a value inside the range.";
    P4002 Error "an operand that the instruction does not take" "Use an operand of the kind that the message names.";
    P4004 Error "array bounds or a string length outside their range" "An array has 1 to 6 dimensions with bounds from -32768 to 32767, a string 0 to 254 characters.";
    P4005 Error "an array index outside the bounds" "Use an index inside the bounds of the declaration, one for each dimension.";
    P4006 Error "a value that does not fit the type" "Write the constant in the notation of the type.";
    P4007 Error "more values than variables" "Remove the values that are too many.";
    P4008 Error "types nested too deeply" "Put the inner part into a structure of its own.";
    P4009 Error "a type that may not stand here" "Use a type that the section allows.";
    P4010 Error "a field or index of something that has none" "Only structures have fields, only arrays and strings have indexes.";
    P4011 Error "a parameter of the wrong type" "Pass a variable or constant of the type that the block declares.";
    P4012 Warning "a parameter of another type with the same width" "Check that the bits mean the same in both types, or convert the value first.";
    P4013 Warning "a call without parameters of a block that has some" "Use CALL, which passes the parameters and opens the instance.";
    P4014 Error "a pointer that lies where it cannot be used" "Put the pointer into M, L, DB or DI: a double word for addresses, a word for the numbers of timers, counters and blocks.";
    P4015 Error "an address that is not complete" "A bit has two numbers as in `M 10.3`, all else one as in `MW 10`.";
    P4016 Warning "an edge memory in temporary data" "Use a bit of M, of a data block or a static variable of the function block, and each for one edge only.";
    P4020 Warning "a temporary variable that is read before it is written" "Write it first: VAR_TEMP begins with what other blocks left there.";
    P4021 Warning "a temporary variable that is not written on every path" "Write it before the first branch, or make sure that the other paths are never taken.";
    P4022 Warning "an instruction on a value of another type" "Use the instruction for the type of the value, or convert the value first (ITD, DTR, RND).";
    P4023 Warning "a timer or counter that no logic drives" "Write the condition before it, for example `A I 0.0`, or `SET` if it is always to be executed.";
    P4024 Warning "a temporary variable that a run read before it was written" "Write it on every path that leads to the statement.";
    P4025 Error "more local data than a block of the CPU type can have" "Move large variables from VAR_TEMP into a data block, or choose a larger CPU type: a CPU refuses to load the block.";
    P4201 Error "a constant outside the range of its notation" "Use a value inside the range that the message names, or a notation with more bits, such as L# or DW#16#.";
    P4202 Error "a constant whose prefix is known, but not what follows it" "Write it the way the message shows.";
    P4203 Error "a date that the calendar does not have" "Check the month and the day; February has 29 days only in leap years.";
    P4204 Error "a character that does not fit into one byte" "Use characters of the code pages 1252, 1250 or 1251, or write the byte as `$` and two hex digits.";
    P4205 Error "a word that is no constant" "Use a constant such as 5, L#5, 1.5, W#16#00FF, 2#1010, C#20, S5T#2S, T#1H, D#2024-02-29, P#M 10.0, 'A' or TRUE.";
    P4301 Error "an edge in a block that keeps nothing" "Draw it in a FUNCTION_BLOCK or PROGRAM, or hand the edge on as an input.";
    P4302 Error "a value that no line of a diagram carries" "Assign it to a variable at the output, and wire the variable to the input.";
    P4303 Error "a box of a function block without an instance" "Declare an instance in VAR and name it after the name of the function block.";
    P4304 Error "a box whose instance is of another function block" "Name an instance of the function block, or the function block of the instance.";
    P4305 Error "a box without a line to its first input" "Draw a line to the box, or write the input as a pin, such as `IN := x`.";

    // 5xxx limits of the CPU type
    P5001 Warning "an address beyond the areas of the CPU type" "Use an address that the CPU type has, or choose a larger CPU type.";
    P5002 Error "a block larger than 64 KB" "Split it into several blocks.";
    P5003 Error "a block number that the CPU type does not have" "Use a lower number, or choose another CPU type.";
    P5004 Warning "a timer or counter that the CPU type does not have" "Use a lower number, or choose a larger CPU type.";
    P5005 Warning "an access behind the end of a data block" "Make the data block longer, or correct the address.";
    P5006 Error "more data than a CPU holds" "Make the data blocks smaller, or fewer.";
    P5007 Warning "more local data than the CPU type has for a block" "Move large variables from VAR_TEMP into a data block.";
    P5008 Warning "an instruction that the CPU type does not have" "Leave it out, or choose a CPU type with four accumulators, such as 416-3.";
    P5009 Warning "more code than a block of the CPU type can have" "Split the block into several, or leave it so if it need not go into a CPU.";
    P5010 Warning "an organization block that the CPU type does not call" "Choose a CPU type that calls it, or another organization block.";
    P5020 Warning "a system function that the CPU does not have" "Leave the call out, or evaluate RET_VAL, ERROR and BR: the call answers as a CPU without that hardware does.";
    P5021 Warning "a condition that does not guard the load or transfer after it" "Jump over the load and transfer with `JCN` if the condition does not hold; use the condition with `=`, `S` or `R`; or remove it.";
    P5022 Warning "one timer or counter instance driven twice" "Use a timer of its own for each purpose, or join the conditions and start it once.";
    P5023 Warning "a zone of the master control relay that is never active" "Write `MCRA` before the zone and `MCRD` after it.";
    P5024 Warning "a variable of a function block after AR2 or the DI register was changed" "Save the register before it is changed (`TAR2`, or `L DINO`) and restore it before the next parameter or static variable, or copy the variable to VAR_TEMP first.";
    P5025 Warning "an access that overwrites AR1" "Load AR1 again after the access, or copy the element to VAR_TEMP before AR1 is loaded.";
    P5026 Warning "a parameter as the pointer of an indirect address" "Copy the parameter to a variable of VAR_TEMP, and write that one in the brackets.";
    P5027 Warning "the address of a parameter of a function in an address register" "Load it into ACCU 1 first: `L P##…`, then `LAR1`.";
    P5028 Warning "an input that the program writes" "Write an output, bit memory or a data block; a test gives inputs their values from outside.";
    P5029 Warning "an S5TIME that is much shorter than it is written" "Write a multiple of 10 ms; an IEC timer with TIME counts single milliseconds.";
    P5030 Warning "a bit that is set and reset again in the same scan" "Leave the block with `BEC` after the first half, or use an edge of the condition for each half.";

    // 6xxx files and projects
    P6001 Error "a file that cannot be read" "Check the path and the permissions.";
    P6004 Warning "an empty source file" "Write statements or blocks into it, or take it out of the project.";
    P6005 Error "a project without a source" "Put STL sources (`.awl`) into the folder, or name them in `sources` of `sieben.toml`; `sieben new NAME` makes a project that runs.";
    P6006 Error "a folder where a file is wanted" "Name a file inside the folder.";
    P6007 Error "a project file that is not valid TOML" "Mend the line; texts stand in quotes, lists in square brackets.";
    P6008 Error "a key that a project file does not have" "Use a key that the message names, or remove the line.";
    P6009 Error "a value that a key of a project file cannot have" "Write the value the way the message shows.";
    P6010 Error "a path that leaves the project folder" "Move the file into the project folder and name it by a path without `..` in front.";
    P6011 Warning "a pattern of a project file that matches no file" "Check the spelling of the pattern; `**` stands for any number of folders.";
    P6012 Warning "a key of a project file that this version does not use yet" "Leave it for a later version, or remove it.";
    P6013 Error "a file that cannot be written" "Check the path, the permissions and the space on the disk.";
    P6014 Error "something of this name exists already" "Choose another name, or remove what is there first; nothing is overwritten.";
    P6015 Error "a folder with too many files" "Name the sources in `sieben.toml`, so that the whole folder need not be searched.";
    P6030 Warning "a retentive range beyond the CPU type" "Shorten the range, or choose a CPU type with more bit memory, timers or counters.";
    P6031 Error "retentive data that another run is using" "End the other run, name another file with --retain, or run with --no-retain.";
    P6032 Error "retentive data that cannot be read" "Check the path and the permissions, or run with --no-retain, which leaves the file alone.";
    P6040 Error "an awlsim project that is not XML" "Save the project anew, or restore the file; a project has neither DTD nor entities of its own.";
    P6041 Error "a file that is no awlsim project of a known version" "Name a file that awlsim has saved as `.awlpro`, format version 1.";
    P6042 Error "a value that an awlsim project cannot have" "Write the value the way the message shows, or set it in awlsim.";
    P6043 Error "a diagram in an awlsim project" "Write the diagram as STL, or disable it in the project.";
    P6044 Warning "a part of an awlsim project that is not used" "Remove it from the project, or live without it: the rest of the project runs.";
    P6045 Error "a library block of an awlsim project that Sieben does not have" "Write the block yourself, or take it out of the project; `sieben explain library` lists the blocks there are.";
    P6046 Error "a file inside a project that cannot be written alone" "Change the source in the program that wrote the project.";
    P6050 Error "a construct that the dialect does not have" "Write what the message names, or name the dialect of the file with --dialect.";
    P6051 Warning "a construct that is not usual in the dialect" "Write what the message names if the source has to go back into another tool.";
    P6052 Error "an operator of another language" "Write the operator that the message names: `=`, `<>`, `<=`, `AND`, `OR`, `NOT`.";
    P6053 Error "a statement or declaration without its semicolon" "Write `;` where the message points.";
    P6054 Error "a statement that is not understood" "Write an assignment `x := 1;`, a call `f();` or a statement such as IF.";
    P6055 Error "an expression that is not understood" "Write a variable, a constant or a call between two operators.";
    P6056 Error "a keyword that is missing" "Write the keyword that the message names.";
    P6057 Error "a statement without its end" "Write the END_ keyword of the statement behind its last line.";
    P6058 Error "the end keyword of another statement" "Use the END_ keyword that belongs to the first keyword of the statement.";
    P6059 Error "a part of a statement that did not begin" "Remove it, or write the beginning of the statement.";
    P6060 Error "a keyword in the place of a name" "Choose another name; a keyword cannot be one, in any case of letters.";
    P6061 Error "another word for ELSIF" "Write `ELSIF`; `ELSE IF` begins another IF, which needs its own `END_IF`.";
    P6063 Error "a nesting that is too deep" "Put the inner part into a function, or assign a part of the expression to a variable first.";
    P6064 Error "RETURN with a value" "Assign the value to the name of the function, then write `RETURN;`.";
    P6065 Error "a round bracket that is not closed" "Write `)` where the message points.";
    P6066 Error "a pragma without its end" "Write `}` on the line where the pragma begins or behind its last attribute.";
    P6071 Error "a label of CASE that is not understood" "Write a constant, constants with commas, or a range `1..5`, and `:` behind it.";
    P6072 Error "a folder with several programs where one is wanted" "Name the files of one of them instead of the folder.";
    P6073 Warning "a test file that belongs to no program" "Call it like the program that it tests: `ue1.test.st` for `ue1.awl`.";
    P6075 Error "a folder with too much to read for all its programs" "Name its sub-folders one by one, or put what belongs together into projects with a `sieben.toml`.";
    P6076 Warning "a source in another language than its name says" "Rename the file: `.awl` or `.stl` for STL, `.st` or `.scl` for Structured Text; it was read as what it holds.";
    P6077 Error "a file of TwinCAT that is not XML" "Save the object in TwinCAT again; such a file has neither DTD nor entities of its own.";
    P6078 Error "a body that is a diagram" "Write the body in Structured Text; its declaration was read.";
    P6079 Error "a file of TwinCAT that holds nothing to read" "Name files with a POU, an interface, a type or a list of global variables.";
    P6080 Error "a file that holds more than the text of a source" "Lay it out or convert it in the tool that wrote it; `sieben check --fix` changes such files in place.";

    P6101 Error "a symbol that stands twice in the table" "Rename or delete one of the two rows; case does not distinguish symbols.";
    P6102 Warning "an address with two symbols" "Keep the symbol that the program uses.";
    P6103 Error "an address in the symbol table that is not understood" "Write it as in a program, in either mnemonic language: `I 0.0`, `QW 4`, `T 1`, `DB 5`.";
    P6104 Error "a symbol table without a necessary column" "Let the first line name the columns, at least `symbol,address`.";
    P6105 Error "a line of a symbol table that does not have the form of its format" "Compare the line with its neighbours, or export the table again.";
    P6106 Warning "a symbol longer than 24 characters" "Shorten it if the table has to go back into STEP 7 V5.";
    P6107 Warning "a row without a symbol or without an address" "Complete the row or delete it; the program cannot use it.";
    P6108 Error "a quotation mark that is never closed" "Close it at the end of the field; the rows behind it were not read.";
    P6109 Warning "a data type that does not fit the address" "Change the type or the address, so that both have the same width.";
    P6110 Error "a symbol with a character that no symbol may contain" "Remove quotation marks and control characters from the name.";
    P6111 Error "a symbol table that ends too early" "Export the table again; the file seems to be cut.";
    P6112 Warning "a symbol table with another number of rows than its head says" "Export the table again, or look whether rows are missing.";
    P6113 Warning "a symbol table in another format than its name says" "Rename the file; it was read as what it holds.";
    P6120 Error "an organization block without a number" "Name it `OB1`, or give its name the address of an organization block in the symbol table.";
    P6122 Error "a value that is not known when the program is compiled" "Use constants only: numbers, CONST, VAR CONSTANT, values of enumerations.";
    P6127 Error "an address or a view that a variable cannot have" "Use an address of the width of the type, or a view that is not longer than its variable.";
    P6130 Error "a task that the CPU cannot run" "Write an interval of 1 ms to 60 s, or none for the cycle.";
    P6132 Error "an instance where nothing is kept" "Declare it under VAR of a FUNCTION_BLOCK or PROGRAM, or under VAR_GLOBAL.";
    P6133 Warning "a table without a header that was read as an assignment table" "Write a first line with the names of its columns, such as `number,address,unit,symbol,comment,remark`.";

    // 62xx statements of ST
    P6200 Error "a value of another type" "Convert it with a function such as `INT_TO_REAL`, or declare the variable with the type of the value.";
    P6201 Warning "a conversion that may lose something" "Convert the value with a function if this is meant, such as `DINT_TO_REAL`.";
    P6202 Error "an operator with operands that it does not take" "Convert the operands, or use the operator for their type.";
    P6203 Error "a condition that is not BOOL" "Compare the value with something, for example `<> 0`.";
    P6204 Error "something that cannot be assigned to" "Assign to a variable that the block may write.";
    P6207 Error "a value of CASE that an earlier label covers" "Remove one of the two labels.";
    P6208 Warning "a value of CASE that an earlier label covers already" "Remove one of the two labels; the first one is taken.";
    P6209 Error "an empty range" "Write the lower value first, as in `5..9`.";
    P6210 Error "a FOR that does not count with an integer" "Count with an INT or DINT, and compute the REAL from it.";
    P6211 Error "a step of 0" "Write a step other than 0, or leave BY away for a step of 1.";
    P6212 Warning "a FOR that never or always runs" "Check the first value, the last value and the step.";
    P6213 Error "EXIT or CONTINUE outside of a loop" "Use RETURN to leave the block.";
    P6215 Error "a jump into a statement" "Jump only to labels in the same list of statements, or further out.";
    P6216 Error "an expression where a statement should stand" "Assign it to a variable with `:=`, or call it with `()`.";
    P6217 Error "a call of something that cannot be called" "Call a function by its name, and a function block by its instance.";
    P6218 Error "a call without a result where a value is needed" "Write the call as a statement of its own, and read its outputs.";
    P6219 Error "parameters that do not fit the call" "Give inputs with `:=` and outputs with `=>`, each once.";
    P6221 Warning "a comparison that is always true or always false" "Compare with a value that the variable can have.";
    P6222 Warning "a variable that is never used" "Remove it, or use it.";
    P6223 Warning "a function whose result is not set on every path" "Assign a value to the name of the function at its beginning.";
    P6225 Error "a part that the value does not have" "Use a number inside the width of the type; bit 0 is the lowest.";
    P6226 Error "something that cannot be compiled yet" "Write it another way; see the list of what is built in the reference of the language.";
    P6227 Warning "a division by the constant 0" "Divide by something else; the result is 0.";
    P6228 Error "something that is followed like a reference and is none" "Write `^` only behind a REF_TO or POINTER TO variable.";
    P6229 Error "a value that has to be constant" "Use a number, a declared constant or a value of an enumeration.";
    P6230 Error "a name that means several things" "Write the name of the enumeration before the value.";
    P6231 Error "a read of something that can only be written" "Read the process image instead.";
    P6232 Warning "a result that nobody uses" "Assign it to a variable, or remove the call.";
    P6233 Error "a CASE of something that has no whole numbers" "Use IF and ELSIF.";
    P6240 Error "a test file where a program is wanted" "Run it with `sieben test`.";

    // 626x scenarios and recordings
    P6260 Error "a line of a scenario that is not understood" "Write one of the lines of the scenario language; `//` begins a comment.";
    P6261 Error "an expectation of a scenario that did not come true" "Compare the values before that scan with what the program should do with them.";
    P6262 Error "a file that is no recording, or a damaged one" "Name a file that `sieben trace --record` has written.";
    P6263 Warning "a recording that was cut off" "What was written before is shown; record again for the rest.";
    P6264 Error "a recording of another program" "Name the sources it was recorded with, or leave them out to see it all the same.";

    // 627x simulated devices
    P6270 Error "a kind of module that does not exist" "Use a kind that the message names; `docs/reference/plants.md` describes each.";
    P6271 Error "a module with a value that it cannot have" "Use a value in the range that the message names, and a name of its own for every module.";
    P6272 Error "a fault that the module cannot have" "Write the signal and how it fails: `level stuck@30s`, `level drift=0.5`, `low late=200ms` or `low bounce=50ms`.";

    // 628x classes and interfaces
    P6280 Error "a block that cannot be extended or implemented like this" "Name a FUNCTION_BLOCK or CLASS behind EXTENDS, and INTERFACEs behind IMPLEMENTS.";
    P6281 Error "a method or property that is missing" "Declare it with the same parameters, or make the block ABSTRACT.";
    P6282 Error "a method with other parameters than the one that it stands for" "Give it the same parameters, types and result.";
    P6283 Error "a method that does not fit what it overrides" "Override only what is there and not FINAL; leave the statements of an ABSTRACT method away.";
    P6284 Error "a member that may not be used here" "Make it PUBLIC, or use it inside the block that has it.";
    P6285 Error "an instance of something that has none" "Declare an instance of a block that is not ABSTRACT, or a variable of the interface.";
    P6286 Error "THIS or SUPER where there is none" "Use them in methods and statements of a FUNCTION_BLOCK or CLASS; SUPER where it extends another one.";
    P6287 Error "a property that is used in a way that it does not have" "Give the property a GET to read it and a SET to assign to it.";

    // 629x recordings that other programs are held against
    P6290 Error "a recording that cannot be written on" "Make room and record again; the scans that were written before are whole and can be used.";
    P6291 Error "a run that cannot be recorded" "Record without what the message names, or record the parts before and behind it.";
    P6292 Error "a recording with names that the program does not have" "Say what they are called here: `--map OLD=NEW`, or `--map FILE` with such a line for each; `--ignore OLD` leaves an output out.";

    // 630x results of tests
    P6300 Error "a folder that pages of coverage cannot be written into" "Name a folder that does not exist yet, or one that holds such pages: other files are not overwritten.";

    // 631x configurations
    P6310 Error "a variable that waits for its address" "Give it one in VAR_CONFIG of a CONFIGURATION, or write the address where it is declared.";
    P6311 Error "a path of VAR_CONFIG or VAR_ACCESS that leads nowhere" "Write the instance of the PROGRAM, the instances inside it and the variable, with points between them.";
    P6312 Error "an array of unknown length as a whole" "Use its elements from LOWER_BOUND to UPPER_BOUND, or give it to another ARRAY[*].";
    P6320 Error "a conversion without a type to convert to" "Assign the result to a variable in a statement of its own.";
    P6321 Error "a timer or a counter of which no call says what it is" "Write the instruction behind it: `t.TON(IN := …, PT := …)`.";
    P6322 Error "a conversion that does not exist" "Convert to a type that the message or `sieben explain T_CONV` names, or in two steps.";
    P6323 Error "a function of the system that does not exist here" "Do without it, as the message shows.";
    P6324 Error "a VARIANT whose type is not known" "Declare the parameter as VARIANT, or use a variable of the type that is meant.";
    P6325 Error "a type that is used like a value" "Compare it with another type: `TypeOf(v) = INT`.";
    P6326 Warning "a STRING that is longer than those of the S7" "Mind that characters beyond the 254th are cut off, or declare STRING(254).";
    P6327 Error "arguments of an instance that its FB_Init does not take" "Give what FB_Init declares, as constants or variables.";
    P6328 Warning "a 0 behind the characters of a text" "Give the text its length first, for example by assigning as many blanks, or join it with CONCAT.";
    P6329 Error "the number of a block of the library is taken" "Give the block of the program another number.";
    P6330 Warning "a variable whose address nobody tells" "Write the address, or a VAR_CONFIG with it.";

    // 7xxx command line
    P7001 Error "an argument that is not understood" "See `sieben help` for what the command takes.";
    P7002 Error "a CPU type that does not exist" "Use a CPU type that the message names; `sieben explain cpu` shows what each has.";
    P7003 Error "a name that cannot be set or shown" "Use an address (`I 0.0`, `MW10`, `DB1.DBD4`), `T 1`, `C 1`, `DB1.name`, a symbol, or a register (`ACCU1`, `AR1`, `STW`).";
    P7004 Error "a value that does not fit its target" "Use a constant of STL, such as 5, W#16#00FF, 1.5 or S5T#2S; 0 or 1 for a bit.";
    P7005 Error "a duration that is not understood" "Write a number with its unit: `10ms`, `1.5s`, `2m` or `1h`.";
    P7007 Error "a word that is not in the tables" "Give an instruction (`A`, `SPB`), a function of Structured Text (`TON`; `sieben explain functions` lists them), a problem code (`P2001`), a status bit (`RLO`), an organization block (`OB 121`), a system function (`SFC 46`), an event (`16#4562`) or a CPU type (`416-3`). `sieben explain --help` names the lists.";
    P7008 Error "a name that cannot be the name of a project" "Use letters, digits, `-` and `_`.";
    P7009 Error "times that make no sense together" "Give a cycle longer than 0, and times in rising order.";
    P7020 Error "no test to run" "Name a file `*.test.st`, a program that checks itself, or a folder with such files.";
    P7030 Error "a trigger that is not understood" "Write `I0.0 rises`, `I0.0 falls`, `I0.0 changes`, `MW10 > 5` or `scan 500`.";
    P7031 Error "a trigger that did not come" "Run longer with `--scans` or `--for`, or look at the last scans for what keeps it from coming.";
    P7032 Error "nothing to record" "Name what to record: `--channels I0.0,Q0.0,MW10`.";
    P7033 Error "a part of a trace that is not there" "Name a time that the trace has.";
    P7040 Error "a command that `sieben step` does not know" "`help` lists the commands.";
    P7041 Error "a place that is not in the program" "Write `FC 1:3` (the third statement), `FC 1:label` or `main.awl:12` (a line).";
    P7042 Error "a condition that is not understood" "Write a name, one of =, <>, >, >=, <, <= and a value: `MW10 > 5`.";
    P7043 Error "a recording of another program" "Replay it with the sources and the CPU type that it was recorded with.";
    P7044 Error "a recording that cannot be used" "Record the run again with `sieben step --record`.";
    P7050 Error "a rule for a name that the recording does not have" "Write the name as the scenario does: `--map`, `--tolerance` and `--ignore` speak of what was recorded.";
    P7051 Error "a rule for a recording that is not understood" "Write `--map OLD=NEW`, `--within 2`, `--tolerance NAME=0.5` or `--tolerance 2%`.";
    P7080 Error "a block without networks" "Name a block of STL, LAD or FBD; Structured Text has no networks to draw.";
    P7081 Error "a file that no diagram is written to" "Name a file that ends in `.svg`, `.html` or `.txt`.";
    P7082 Error "a network that a block does not have" "Name a network of the block by its number, from 1.";
    P7083 Error "a network that is no diagram" "Choose a network that can be drawn, or try `--as fbd`; `sieben render` shows which can.";
    P7090 Error "no run that answers" "Start it with `sieben run` in another terminal, with the same folder or files.";
    P7091 Error "a request that is not understood" "Write one JSON object on one line, such as `{\"id\": 1, \"verb\": \"state\"}`; docs/reference/control-socket.md has all verbs.";
    P7092 Error "a request beyond a limit" "Ask for less at once, or close a connection that is not needed.";
    P7093 Error "a request that the CPU does not take now" "Ask for `state`: a start and a memory reset need STOP.";
    P7094 Error "a run that is over" "Start it again, and connect again.";
    P7095 Error "a status that cannot be shown" "Name a block with statements (`blocks` lists them) while the CPU scans.";
    P7100 Error "a server that other computers reach" "Choose an address of this computer alone, such as 127.0.0.1:1102, or name the address with `--expose` if you want that.";
    P7101 Error "an address that is in use" "End the program that listens there, or choose another port.";
    P7102 Error "an address that cannot be listened at" "Choose an address of this computer and a port from 1024, or give the right to listen below.";
    P7103 Error "a file of a server that cannot be written" "Name a file in the folder of the project that this user may write, and look whether the disk is full.";
    P7104 Error "something that cannot be pressed like a button" "Name an input bit, such as `I0.0`; everything else is set with `write`.";
    P7125 Error "a format that does not exist" "Write one of the formats of a watch table after the colon, such as `MW10:INT`, or leave it out; `sieben explain formats` lists them.";
    P7126 Error "a format that does not fit the value" "Choose a format for as many bits as the value has, or leave it out; `sieben explain formats` says what each one shows.";
    P7130 Error "a page that asks for too much" "Ask for less at a time; `docs/reference/page-server.md` has the limits.";
    P7131 Error "a message that the page server does not understand" "Reload the page; a program of your own finds the messages in `docs/reference/page-server.md` and the paths in `/api/v1/openapi.json`.";
    P7132 Error "a page without its token" "Open the address with `?token=` that was printed when the run began, or send `Authorization: Bearer` with the token.";
    P7133 Error "a page that may only look" "Use the first of the two tokens that were printed when the run began.";
    P7134 Error "a request of another page" "Open the page of the run itself; no other page is let in.";
    P7135 Error "a request for another server" "Use the address that was printed when the run began.";
    P7136 Error "requests that come too often" "Wait a second, and ask less often.";
    P7137 Error "an address that the page server does not have" "`/api/v1/openapi.json` describes the interface; the page is at `/`, the book at `/docs/`.";
    P7138 Error "a method that an address does not take" "`/api/v1/openapi.json` says which methods each address takes.";
    P7139 Error "a scan that is not kept" "Choose one between `oldest` and `newest`.";
    P7140 Error "a token that cannot be kept" "Look whether this user may write in the folder of the project, and whether the file is this user's and has the mode 0600.";

    // 8xxx run time
    P8001 Error "the CPU went to STOP" "Read the diagnostic buffer: it names the block and the statement.";
    P8002 Error "two modules at the same address" "Give one of them another address: every input and output byte belongs to at most one module.";
    P8003 Error "a module beyond the peripheral area of the CPU type" "Use a lower address, or choose a CPU type with a larger peripheral area.";
    P8030 Warning "retentive data that cannot be kept" "Make room on the disk or correct the permissions: the CPU goes on, and keeping is tried again every second.";
    P8031 Warning "retentive data that is damaged" "Nothing can be restored from it; check the disk. A copy is set aside.";
    P8032 Warning "retentive data of a program with other data blocks" "Run with --adopt and the file where it is now, to take over what still fits.";
    P8033 Error "a link or a device where retentive data is kept" "Remove it if you do not know it; to keep the data elsewhere, name the file with --retain.";
    P8034 Warning "retentive data that was removed during a run" "Nothing is lost; leave `.sieben` alone while the CPU runs (`git clean -e .sieben`).";

    // 9xxx diagrams
    P9001 Warning "a second string of logic in a network that is to be drawn (R-TWO)" "Begin a NETWORK with the second string; `convert --rewrite` does it.";
    P9002 Warning "logic that leads to no output, in a network that is to be drawn (R-LOGIC)" "End the string with an output such as `=`, or remove it.";
    P9003 Warning "a jump that has no coil (R-JUMP)" "Let a network end with JC, JCN or JU, and begin another one with the label.";
    P9004 Warning "a label in the middle of a network that is to be drawn (R-LABEL)" "Begin a NETWORK with the labelled statement.";
    P9005 Warning "an instruction that no element of a diagram stands for (R-OPCODE)" "Write the network with instructions that have an element, or leave it as STL: one block may hold both.";
    P9006 Warning "an address that is computed at run time, in a network that is to be drawn (R-INDIRECT)" "Leave the network as STL, or use an operand with a fixed address.";
    P9007 Warning "a load, a store or a call after logic, which does not depend on it (R-UNCOND)" "Jump over it with JNB, so that the logic becomes its EN, or put it into a network of its own.";
    P9008 Warning "a result of a box that is not stored exactly once (R-STORE)" "Store the result with one T; `convert --rewrite` makes two MOVE boxes of two stores.";
    P9009 Warning "two operations without a T between them, in a network that is to be drawn (R-CHAIN)" "Store the first result in a temporary variable, and load it for the second operation.";
    P9010 Warning "a slot of a box without its NOP 0 (R-NOP)" "Add `NOP 0` for each open slot; where only one box fits, `convert --rewrite` does it.";
    P9011 Warning "parts of a timer or counter in another order than its box has them (R-ORDER)" "Put them into the order of the box: start, reset, `L`, `LC`, and the check of its bit last.";
    P9012 Warning "an end of a box that is neither ENO nor NOP 0 (R-ENO)" "End it as its box has it: `AN OV`, SAVE, CLR, `A BR` if it can overflow; `SET`, SAVE, CLR, `A BR` if it cannot; or `NOP 0`.";
    P9013 Warning "brackets that do not match or hold nothing, in a network that is to be drawn (R-BRACKET)" "Close each bracket, and put logic into it.";
    P9014 Warning "more than 7 brackets inside of one another (R-DEPTH)" "Store a part of the logic with a midline output or in a variable.";
    P9015 Warning "a bit of local data that is stored like that of a T-branch and never read (R-BITLEFT)" "Declare a temporary variable, or use the bit in the same network.";
    P9016 Warning "a tapped line that would run backwards in ladder (R-BACK)" "Draw the network as FBD: `convert --to fbd`.";
    P9017 Warning "an edge, a NOT or a box for a part in the middle of a line of ladder (R-NEG)" "Draw the network as FBD: `convert --to fbd`.";
    P9018 Warning "an operand of another width or type than the box takes (R-WIDTH)" "Move it to an operand of the right width first; MOVE takes any.";
    P9019 Warning "a comparison that is jumped over like a box with EN (R-MIX)" "Compare without the jump: a comparison is a contact.";
    P9020 Warning "a network whose diagram means the same but gives other statements" "Use `convert --rewrite` to draw it.";
    P9021 Warning "a network with more elements than a diagram may have (R-SIZE)" "Divide the network into several.";
    P9022 Warning "a network that goes on with the logic of the one before it (R-CARRY)" "End the network before it with an output, not with SAVE alone or an open string.";
}
