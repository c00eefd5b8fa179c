//! The four dialects of ST as columns of two tables: what they accept, and what they mean by it.
//!
//! No other file asks which dialect it is: it asks for a row. A table that needs its own four columns uses [`Dialect::column`].

use sieben_model::types::DataType;

use crate::declarations::types::describe;
pub use crate::scope::LostResults;

/// A dialect of ST.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Dialect {
    /// IEC 61131-3, edition 3.
    #[default]
    Iec,
    /// The habits of CODESYS V2.3 and V3.
    Codesys,
    /// S7-SCL V5 for S7-300 and S7-400.
    Scl,
    /// SCL sources of TIA Portal.
    Tia,
    /// A test file in the dialect IEC.
    IecTest,
    /// A test file in the dialect of CODESYS.
    CodesysTest,
    /// A test file in S7-SCL.
    SclTest,
    /// A test file in TIA SCL.
    TiaTest,
}

impl Dialect {
    /// All dialects, in the order of the columns.
    pub const ALL: [Self; 4] = [Self::Iec, Self::Codesys, Self::Scl, Self::Tia];

    /// A type in a message. Where dates have 64 bits, DATE and LDATE are one type, and so are DT and LDT: the shorter word is the usual one.
    pub(crate) fn type_words(self, data_type: &DataType) -> String {
        let text = describe(data_type);
        if self.switches().calendar != Calendar::Long {
            return text;
        }
        let short = |word: &str| match word {
            "LDATE" => "DATE".to_owned(),
            "LDT" => "DATE_AND_TIME".to_owned(),
            other => other.to_owned(),
        };
        let is_word = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
        text.split_inclusive(|letter| !is_word(letter))
            .map(|part| {
                let word = part.trim_end_matches(|letter| !is_word(letter));
                short(word) + &part[word.len()..]
            })
            .collect()
    }

    /// The name on the command line and in project files.
    pub fn name(self) -> &'static str {
        ["iec", "codesys", "scl", "tia"][self.column()]
    }
    /// The dialect of this name, without regard to case.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|dialect| dialect.name().eq_ignore_ascii_case(name))
    }
    /// What it is called in messages.
    pub fn title(self) -> &'static str {
        ["IEC 61131-3", "CODESYS", "S7-SCL", "TIA SCL"][self.column()]
    }
    /// Its column in a table with one column for each dialect, 0 to 3.
    pub fn column(self) -> usize {
        self as usize % Self::ALL.len()
    }
    /// The dialect without what only test files have.
    #[must_use]
    pub fn base(self) -> Self {
        Self::ALL[self.column()]
    }
    /// The dialect for a test file: the same, and it names everything that a program may have, whatever language that is written in.
    #[must_use]
    pub fn for_tests(self) -> Self {
        [Self::IecTest, Self::CodesysTest, Self::SclTest, Self::TiaTest][self.column()]
    }
    /// Whether it is that of a test file.
    pub fn is_test(self) -> bool {
        self as usize >= Self::ALL.len()
    }
    /// What it does with a construct.
    pub fn judge(self, construct: Construct) -> Judgement {
        match self.is_test() && IN_TESTS.contains(&construct) {
            true => Judgement::Accept,
            false => construct.row().judgements[self.column()],
        }
    }
    /// Whether it has POINTER TO, and with it the objects of CODESYS.
    pub fn has_pointers(self) -> bool {
        self.judge(Construct::PointerTo) != Judgement::Reject
    }
    /// Whether instances may be variables of what does not last, and results.
    pub fn has_local_instances(self) -> bool {
        self.judge(Construct::LocalInstance) == Judgement::Accept
    }
    /// What it means by what it accepts.
    pub fn switches(self) -> &'static Switches {
        match self.is_test() {
            true => &TEST_SWITCHES[self.column()],
            false => &SWITCHES[self.column()],
        }
    }
}

/// What every test file accepts: it names blocks, symbols and addresses of programs in any language, and looks into them.
const IN_TESTS: &[Construct] = &[
    Construct::QuotedName,
    Construct::PercentAddress,
    Construct::BareAddress,
    Construct::InstanceOfBlock,
    Construct::GlobalVariables,
    Construct::ControllerBlock,
    Construct::ForeignInternal,
    Construct::NumberToBool,
    Construct::PositionalFbCall,
    Construct::OmittedInput,
    Construct::OmittedInOut,
];

/// What a dialect does with a construct.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// It is part of the dialect.
    Accept,
    /// It is taken, with a warning.
    Note,
    /// It is an error.
    Reject,
}

/// A row of the table of constructs.
#[derive(Clone, Copy, Debug)]
pub struct ConstructRow {
    /// What it is called in messages.
    pub title: &'static str,
    /// What to do instead where it is not accepted.
    pub instead: &'static str,
    /// By [`Dialect::column`].
    pub judgements: [Judgement; 4],
}

macro_rules! constructs {
    ($( $Name:ident $title:literal $iec:ident $codesys:ident $scl:ident $tia:ident $instead:literal; )*) => {
        /// A construct that not every dialect accepts.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Construct { $( #[doc = $title] $Name, )* }

        impl Construct {
            /// All constructs.
            pub const ALL: &[Self] = &[$(Self::$Name),*];
            /// Its row.
            pub fn row(self) -> &'static ConstructRow {
                const ROWS: &[ConstructRow] = &[$( ConstructRow {
                    title: $title,
                    instead: $instead,
                    judgements: [Judgement::$iec, Judgement::$codesys, Judgement::$scl, Judgement::$tia],
                } ),*];
                &ROWS[self as usize]
            }
        }
    };
}

#[rustfmt::skip] // A table.
constructs! {
    //                                                             iec    codesys scl    tia
    SlashComment "a comment `/* … */`"                             Accept Note   Reject Reject "write `(* … *)`";
    NestedComment "a comment inside a comment"                     Accept Accept Reject Accept "close the outer comment first";
    LongName "a name of more than 24 characters"                   Accept Accept Note   Accept "shorten the name";
    DoubleUnderscore "`__` inside a name"                          Note   Accept Accept Accept "write one `_`";
    SystemName "a name that begins with `__`"                      Note   Note   Accept Accept "leave such names to the system";
    ForeignLetter "a letter other than A to Z in a name"           Note   Note   Note   Accept "use letters from A to Z";
    QuotedWideString "`\"…\"` as a WSTRING"                        Accept Accept Reject Reject "write `WSTRING#'…'`";
    QuotedName "a name in `\"…\"`"                                 Reject Reject Accept Accept "write the name without quotes";
    LocalMark "`#` before a name"                                  Reject Reject Note   Accept "write the name without `#`";
    RealWithoutPoint "a REAL without a point"                      Note   Accept Accept Accept "write `1.0E10` for `1E10`";
    DurationOverflow "a later field of a duration that is larger than its unit" Reject Reject Note Note "carry the overflow into the larger unit";
    DecimalToBitString "a decimal number for BYTE, WORD or DWORD"  Accept Accept Reject Note   "write the number with `16#`";
    NumberToBool "`0` or `1` for BOOL"                             Accept Accept Accept Accept "write `FALSE` or `TRUE`";
    PowerOperator "the operator `**`"                              Accept Note   Accept Accept "call `EXPT`";
    ShortCircuit "the operators `AND_THEN` and `OR_ELSE`"          Reject Accept Reject Reject "write `AND` and `OR`, or nested IFs";
    DivOperator "the operator `DIV`"                               Reject Reject Accept Accept "write `/`";
    EndWithoutSemicolon "an end keyword without `;`"               Reject Accept Reject Reject "write `;` behind it";
    ElseColon "`ELSE:`"                                            Note   Note   Accept Note   "write `ELSE` without a colon";
    CaseOfString "CASE of a STRING"                                Reject Reject Reject Note   "write IF and ELSIF";
    CaseOverlap "two equal labels of one CASE"                     Reject Reject Note   Reject "remove one of them";
    Goto "GOTO"                                                    Reject Reject Accept Accept "write IF, a loop, EXIT or RETURN";
    Jmp "JMP"                                                      Reject Accept Reject Reject "write IF, a loop, EXIT or RETURN";
    LabelSection "a LABEL section"                                 Reject Reject Accept Note   "remove it; labels need no declaration";
    UndeclaredLabel "a label that no LABEL section declares"       Accept Accept Reject Accept "declare it in `LABEL … END_LABEL`";
    Region "REGION"                                                Reject Note   Reject Accept "use a comment";
    CombinedAssignment "the assignments `+=`, `-=`, `*=`, `/=`"    Reject Reject Reject Accept "write `a := a + b`";
    AttemptAssignment "the assignment attempt `?=`"                Accept Reject Accept Accept "use `__QUERYINTERFACE`";
    SetAssignment "the assignments `S=`, `R=` and `REF=`"          Reject Accept Reject Reject "write an IF";
    ChainedAssignment "more than one `:=` in a statement"          Reject Accept Reject Accept "write one statement for each";
    AssignmentExpression "an assignment inside an expression"      Reject Accept Reject Reject "assign before the statement";
    PositionalFbCall "parameters of a function block by position"  Note   Note   Reject Reject "write `name := value`";
    OmittedInput "a call of a function without all inputs"         Accept Accept Reject Reject "give every parameter a value";
    OmittedInOut "a call of a function block without all of its VAR_IN_OUT" Reject Reject Accept Accept "give each of them a variable";
    MixedArguments "parameters by position and by name in one call" Reject Note  Reject Reject "name all of them";
    AssignedOutput "an output of a call with `:=`"                 Reject Reject Accept Reject "write `=>`";
    EnEno "EN and ENO in a call"                                   Accept Note   Accept Accept "write IF around the call";
    TempInitial "an initial value in VAR_TEMP"                     Accept Accept Reject Reject "assign the value with a statement";
    VarConstant "VAR CONSTANT"                                     Accept Accept Reject Accept "write `CONST … END_CONST`";
    ConstSection "CONST … END_CONST"                               Reject Reject Accept Reject "write `VAR CONSTANT … END_VAR`";
    Retain "RETAIN"                                                Accept Accept Reject Accept "set retentive ranges of the CPU";
    Persistent "PERSISTENT"                                        Reject Accept Reject Reject "write RETAIN";
    DbSpecific "DB_SPECIFIC"                                       Reject Reject Reject Accept "remove it";
    GlobalVariables "VAR_GLOBAL and VAR_EXTERNAL"                  Accept Accept Reject Reject "declare a data block, or symbols";
    StaticSection "VAR_STAT and VAR_INST"                          Reject Accept Reject Reject "write VAR in a function block";
    EdgeInput "R_EDGE and F_EDGE"                                  Accept Accept Reject Reject "call R_TRIG or F_TRIG";
    ObjectOrientation "METHOD, INTERFACE, EXTENDS and IMPLEMENTS"  Accept Accept Reject Reject "write function blocks and functions";
    SilentOverride "a method that overrides another one without OVERRIDE" Reject Accept Reject Reject "write OVERRIDE before its name";
    ClassAndNamespace "CLASS, NAMESPACE and USING"                 Accept Reject Reject Reject "write function blocks";
    Property "PROPERTY"                                            Note   Accept Reject Reject "write methods";
    Action "ACTION"                                                Accept Accept Reject Reject "write a function block";
    RefTo "REF_TO and `REF()`"                                     Accept Note   Reject Note   "write `POINTER TO` and `ADR()`";
    PointerTo "POINTER TO, REFERENCE TO and `ADR()`"               Reject Accept Reject Reject "write `REF_TO` and `REF()`";
    Union "UNION"                                                  Reject Accept Reject Reject "use slices such as `.%B1`, or AT";
    OpenArray "ARRAY[*]"                                           Accept Accept Reject Accept "give the array bounds";
    OpenArrayInput "ARRAY[*] in VAR_INPUT"                         Accept Reject Reject Accept "write VAR_IN_OUT";
    Enumeration "an enumeration"                                   Accept Accept Reject Reject "declare constants";
    Subrange "a subrange"                                          Accept Accept Reject Reject "use the whole type";
    BitByNumber "a bit as `x.3`"                                   Accept Accept Reject Note   "write `x.%X3`";
    Slice "a slice such as `x.%X3`"                                Accept Note   Reject Accept "use AT, or shift and mask";
    ViewAt "AT with a variable"                                    Reject Reject Accept Note   "use slices such as `.%B1`";
    LocatedAt "AT with an address"                                 Accept Accept Reject Note   "use the symbol table";
    PercentAddress "an address with `%`"                           Accept Accept Note   Accept "write the address without `%`";
    BareAddress "an address without `%`"                           Reject Reject Accept Note   "write `%` before it";
    ComputedAddress "an address with an index, such as `MW[i]`"    Reject Reject Accept Note   "use an array, or PEEK and POKE";
    S5Time "S5TIME"                                                Reject Reject Accept Accept "use TIME";
    LongTypes "a type that an S7-300 does not have"                Accept Accept Reject Accept "use BYTE, WORD, DWORD, INT, DINT, REAL, TIME or DATE";
    VoidResult "the result type VOID"                              Note   Note   Accept Accept "leave the result away";
    InstanceOfBlock "a call with its data block, such as `FB10.DB20()`" Reject Reject Accept Note "declare an instance";
    InstructionCall "a call such as `inst.TON()`"                  Reject Reject Reject Accept "write `inst()`";
    Program "PROGRAM"                                              Accept Accept Note   Note   "write `ORGANIZATION_BLOCK OB1`";
    SectionQualifier "this word after this section"                Note   Accept Accept Accept "leave it away";
    NarrowInitial "a WSTRING that begins with `'…'`"               Note   Accept Accept Accept "write the characters between `\"`";
    EmptyStruct "a STRUCT without fields"                          Reject Accept Reject Reject "declare at least one field";
    ValueStatement "a value that stands alone"                     Reject Note   Reject Reject "assign it to a variable";
    BareCall "a call without brackets"                             Reject Note   Reject Reject "write `()` after it";
    LocalInstance "an instance that does not last"                 Reject Accept Reject Reject "declare it under VAR of a FUNCTION_BLOCK";
    ProgramCall "a call of a PROGRAM by its name"                  Reject Accept Reject Reject "declare a FUNCTION_BLOCK, and an instance of it";
    Configuration "CONFIGURATION"                                  Accept Note   Reject Reject "write organization blocks";
    ControllerBlock "ORGANIZATION_BLOCK and DATA_BLOCK"            Note   Note   Accept Accept "write PROGRAM, and global variables";
    Begin "BEGIN"                                                  Reject Reject Accept Accept "remove it";
    PeekPoke "PEEK and POKE"                                       Reject Reject Reject Accept "use an address";
    CaseOfBits "CASE of a bit string"                              Accept Accept Reject Accept "convert it with a function such as `WORD_TO_INT`";
    Recursion "a function that calls itself"                       Reject Note   Note   Note   "write a loop";
    ForeignInternal "an internal variable of another instance"     Reject Accept Note   Note   "make it an output";
    WrittenInternal "a write to an internal variable of another instance" Reject Reject Accept Accept "make it an input";
    WrittenInput "a write to an own input"                         Reject Note   Note   Note   "copy it to a variable first";
    WrittenControl "a write to the control variable of a FOR"      Note   Accept Note   Accept "write a WHILE loop";
    BareList "the values of an array without `[ ]`"                Reject Accept Accept Accept "write `[ … ]` around them";
    TryCatch "`__TRY` and `__CATCH`"                               Reject Accept Reject Reject "check before the operation";
    BodyWithoutSemicolon "a body without a statement"              Accept Accept Accept Accept "write `;`";
}

/// The order of `**` and the signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PowerRank {
    /// `-2**2` is 4.
    BehindSign,
    /// `-2**2` is -4.
    BeforeSign,
}

/// What the number of a word address without S7 letters counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AddressUnit {
    /// `%MW10` begins at byte 10.
    Byte,
    /// `%MW10` begins at byte 20: the tenth word.
    OwnWidth,
}

/// What happens at run time when an array index is outside the bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IndexFault {
    /// A read gives 0, a write is left out; ENO is FALSE and the CPU notes it in its diagnostic buffer.
    Skip,
    /// The nearest element if the project has CheckBounds, else a programming error (OB 121).
    CheckBounds,
    /// A programming error (OB 121).
    ProgrammingError,
}

/// What happens at run time when an integer is divided by 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DivisionFault {
    /// The result is 0 and ENO (or OK) FALSE; the program goes on.
    Zero,
    /// A programming error, unless the project has the CheckDiv functions.
    CheckDiv,
}

/// Which dates DATE and DATE_AND_TIME can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Calendar {
    /// Nanoseconds since 1970-01-01 in 64 bits: DATE is LDATE, DT is LDT.
    Long,
    /// 16 bits of days since 1990-01-01, eight bytes BCD from 1990 to 2089.
    S7,
}

/// When the bounds and step of a FOR are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForBounds {
    /// Once before the first pass.
    Once,
    /// Before each pass.
    EachPass,
}

/// What a dialect means by what it accepts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switches {
    /// The order of `**` and the signs.
    pub power: PowerRank,
    /// What the number of a word address counts.
    pub address_unit: AddressUnit,
    /// A bit may have one number, which counts the bits of the area through.
    pub bits_counted_through: bool,
    /// What a wrong array index does.
    pub index_fault: IndexFault,
    /// What an integer division by 0 does.
    pub division_fault: DivisionFault,
    /// Which lost results the CPU is told of.
    pub lost_results: LostResults,
    /// What DATE and DATE_AND_TIME hold.
    pub calendar: Calendar,
    /// TIME has a sign (32 bits of milliseconds).
    pub time_signed: bool,
    /// Characters of a STRING without a length.
    pub string_length: u32,
    /// The index of the first character of a STRING.
    pub string_first: u32,
    /// Intermediate results of integers have at least this many bits.
    pub integer_bits_min: u32,
    /// When FOR evaluates its bounds.
    pub for_bounds: ForBounds,
    /// VAR_TEMP, and VAR of a function, begin with their initial or default value at each call.
    pub temporaries_initialised: bool,
    /// A local BOOL named OK, TRUE at the start of a block, goes to ENO at its end.
    pub ok_flag: bool,
    /// A block's own ENO can be read and written as a variable.
    pub eno_variable: bool,
    /// BOOL can be ordered by `<` and `>`.
    pub bool_ordered: bool,
    /// Names of blocks such as `FB10`, `DB5` mean the block with that number.
    pub numbered_blocks: bool,
    /// `$N` in a string is CR LF, else LF.
    pub newline_is_two: bool,
    /// A literal of a REAL that fits no better is a REAL; with `true` it is an LREAL where REAL would lose digits.
    pub real_literal_widens: bool,
    /// Operators such as AND and ADD can be called as functions.
    pub operators_as_functions: bool,
    /// The functions of WSTRINGs have names of their own: WLEN, WLEFT.
    pub wide_names: bool,
    /// Functions of texts take lengths and positions of any integer type.
    pub any_integer_in_texts: bool,
    /// The timers and counters of the CPU can be called as functions: `S_ODT(T_NO := T5, …)`.
    pub s5_functions: bool,
    /// A variable `AT %I*` for which there is no VAR_CONFIG is memory of its own: a tool links it to the hardware.
    pub unlinked_is_memory: bool,
    /// An organization block has inputs, which the CPU gives: `Initial_Call`.
    pub organization_block_inputs: bool,
    /// Temporary variables lie in the local data of an S7-300 or S7-400, which refuses a block with more than it has.
    pub local_data_limited: bool,
    /// TRUNC gives the integer type of where it stands; else DINT.
    pub trunc_takes_type: bool,
    /// The first call of F_TRIG with CLK FALSE is no edge.
    pub quiet_f_trig: bool,
}

macro_rules! switches {
    ($( $field:ident: $iec:expr, $codesys:expr, $scl:expr, $tia:expr; )*) => {
        /// By [`Dialect::column`].
        const SWITCHES: [Switches; 4] = [
            Switches { $($field: $iec),* },
            Switches { $($field: $codesys),* },
            Switches { $($field: $scl),* },
            Switches { $($field: $tia),* },
        ];
    };
}

/// What test files mean: names of blocks such as `FC10` in every dialect.
const TEST_SWITCHES: [Switches; 4] = {
    let mut all = SWITCHES;
    let mut column = 0;
    while column < all.len() {
        all[column].numbered_blocks = true;
        column += 1;
    }
    all
};

use {AddressUnit as Unit, Calendar::*, DivisionFault as Division, ForBounds::*, IndexFault as Index, LostResults as Lost, PowerRank::*};

#[rustfmt::skip] // A table.
switches! {
    //                       iec              codesys            scl                      tia
    power:                   BehindSign,      BehindSign,        BeforeSign,              BeforeSign;
    address_unit:            Unit::Byte,      Unit::OwnWidth,    Unit::Byte,              Unit::Byte;
    bits_counted_through:    true,            false,             false,                   false;
    index_fault:             Index::Skip,     Index::CheckBounds, Index::ProgrammingError, Index::ProgrammingError;
    division_fault:          Division::Zero,  Division::CheckDiv, Division::Zero,         Division::Zero;
    lost_results:            Lost::All,       Lost::Quotients,   Lost::Quotients,         Lost::Quotients;
    calendar:                Long,            Long,              S7,                      S7;
    time_signed:             true,            false,             true,                    true;
    string_length:           254,             80,                254,                     254;
    string_first:            1,               0,                 1,                       1;
    integer_bits_min:        8,               32,                8,                       8;
    for_bounds:              Once,            Once,              Once,                    Once;
    temporaries_initialised: true,            true,              false,                   false;
    ok_flag:                 false,           false,             true,                    false;
    eno_variable:            true,            false,             true,                    true;
    bool_ordered:            true,            true,              false,                   false;
    numbered_blocks:         false,           false,             true,                    true;
    newline_is_two:          false,           false,             true,                    false;
    real_literal_widens:     false,           true,              false,                   false;
    operators_as_functions:  true,            true,              false,                   false;
    wide_names:              false,           true,              false,                   false;
    any_integer_in_texts:    true,            false,             false,                   false;
    s5_functions:            false,           false,             true,                    true;
    unlinked_is_memory:      false,           true,              false,                   false;
    organization_block_inputs: false,         false,             false,                   true;
    local_data_limited:      false,           false,             true,                    false;
    trunc_takes_type:        true,            false,             false,                   false;
    quiet_f_trig:            false,           true,              true,                    true;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_construct_is_accepted_somewhere_and_says_what_to_do_instead() {
        for construct in Construct::ALL {
            let row = construct.row();
            assert!(row.judgements.iter().any(|&judgement| judgement != Judgement::Reject), "{construct:?}");
            assert!(!row.instead.is_empty() && !row.instead.ends_with('.'), "{construct:?}");
        }
    }

    #[test]
    fn a_dialect_is_found_by_its_name() {
        for dialect in Dialect::ALL {
            assert_eq!(Dialect::from_name(&dialect.name().to_uppercase()), Some(dialect));
            let tests = dialect.for_tests();
            assert!(tests.is_test() && !dialect.is_test());
            assert_eq!((tests.base(), tests.name(), tests.for_tests()), (dialect, dialect.name(), tests));
        }
        assert_eq!(Dialect::from_name("st"), None);
    }
}
