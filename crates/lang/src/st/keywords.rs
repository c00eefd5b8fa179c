//! The reserved words of ST: one row each, with the dialects that reserve it.
//!
//! Words that mean something only at one place (AT, RETAIN, EXTENDS, ON …) are no keywords: the parser knows that place.

use super::dialect::Dialect;

macro_rules! keywords {
    ($( $Name:ident $word:literal $iec:literal $codesys:literal $scl:literal $tia:literal; )*) => {
        /// A reserved word.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub(super) enum Keyword { $( $Name, )* }

        /// By word.
        const ROWS: &[(&str, Keyword, [u8; 4])] = &[$( ($word, Keyword::$Name, [$iec, $codesys, $scl, $tia]) ),*];
    };
}

// What no dialect reserves are the words of test files; the parser sees by their place that they are meant.
#[rustfmt::skip] // A table, sorted by word.
keywords! {
    //                                     iec codesys scl tia
    Action "ACTION"                         1 1 0 0;
    And "AND"                               1 1 1 1;
    AndThen "AND_THEN"                      0 1 0 0;
    Array "ARRAY"                           1 1 1 1;
    Begin "BEGIN"                           0 0 1 1;
    By "BY"                                 1 1 1 1;
    Case "CASE"                             1 1 1 1;
    Class "CLASS"                           1 0 0 0;
    Configuration "CONFIGURATION"           1 1 0 0;
    Const "CONST"                           0 0 1 0;
    Continue "CONTINUE"                     1 1 1 1;
    DataBlock "DATA_BLOCK"                  1 1 1 1;
    Div "DIV"                               0 0 1 1;
    Do "DO"                                 1 1 1 1;
    Else "ELSE"                             1 1 1 1;
    Elsif "ELSIF"                           1 1 1 1;
    EndAction "END_ACTION"                  1 1 1 1;
    EndCase "END_CASE"                      1 1 1 1;
    EndClass "END_CLASS"                    1 1 1 1;
    EndConfiguration "END_CONFIGURATION"    1 1 1 1;
    EndConst "END_CONST"                    1 1 1 1;
    EndDataBlock "END_DATA_BLOCK"           1 1 1 1;
    EndFor "END_FOR"                        1 1 1 1;
    EndFunction "END_FUNCTION"              1 1 1 1;
    EndFunctionBlock "END_FUNCTION_BLOCK"   1 1 1 1;
    EndGet "END_GET"                        1 1 0 0;
    EndIf "END_IF"                          1 1 1 1;
    EndInterface "END_INTERFACE"            1 1 1 1;
    EndLabel "END_LABEL"                    1 1 1 1;
    EndMethod "END_METHOD"                  1 1 1 1;
    EndNamespace "END_NAMESPACE"            1 1 1 1;
    EndOrganizationBlock "END_ORGANIZATION_BLOCK" 1 1 1 1;
    EndProgram "END_PROGRAM"                1 1 1 1;
    EndProperty "END_PROPERTY"              1 1 1 1;
    EndRegion "END_REGION"                  1 1 1 1;
    EndRepeat "END_REPEAT"                  1 1 1 1;
    EndResource "END_RESOURCE"              1 1 1 1;
    EndSet "END_SET"                        1 1 0 0;
    EndSetup "END_SETUP"                    0 0 0 0;
    EndStruct "END_STRUCT"                  1 1 1 1;
    EndTeardown "END_TEARDOWN"              0 0 0 0;
    EndTest "END_TEST"                      0 0 0 0;
    EndType "END_TYPE"                      1 1 1 1;
    EndUnion "END_UNION"                    1 1 1 1;
    EndVar "END_VAR"                        1 1 1 1;
    EndWhile "END_WHILE"                    1 1 1 1;
    Exit "EXIT"                             1 1 1 1;
    False "FALSE"                           1 1 1 1;
    For "FOR"                               1 1 1 1;
    Function "FUNCTION"                     1 1 1 1;
    FunctionBlock "FUNCTION_BLOCK"          1 1 1 1;
    Goto "GOTO"                             0 0 1 1;
    If "IF"                                 1 1 1 1;
    Interface "INTERFACE"                   1 1 0 0;
    Jmp "JMP"                               0 1 0 0;
    Label "LABEL"                           0 0 1 0;
    Method "METHOD"                         1 1 0 0;
    Mod "MOD"                               1 1 1 1;
    Namespace "NAMESPACE"                   1 0 0 0;
    Nil "NIL"                               0 0 1 0;
    Not "NOT"                               1 1 1 1;
    Null "NULL"                             1 0 0 1;
    Of "OF"                                 1 1 1 1;
    Or "OR"                                 1 1 1 1;
    OrganizationBlock "ORGANIZATION_BLOCK"  1 1 1 1;
    OrElse "OR_ELSE"                        0 1 0 0;
    Program "PROGRAM"                       1 1 1 1;
    Property "PROPERTY"                     1 1 0 0;
    Region "REGION"                         0 0 0 1;
    Repeat "REPEAT"                         1 1 1 1;
    Resource "RESOURCE"                     1 0 0 0;
    Return "RETURN"                         1 1 1 1;
    Setup "SETUP"                           0 0 0 0;
    Struct "STRUCT"                         1 1 1 1;
    Super "SUPER"                           1 1 0 0;
    Teardown "TEARDOWN"                     0 0 0 0;
    Test "TEST"                             0 0 0 0;
    Then "THEN"                             1 1 1 1;
    This "THIS"                             1 1 0 0;
    To "TO"                                 1 1 1 1;
    True "TRUE"                             1 1 1 1;
    Type "TYPE"                             1 1 1 1;
    Union "UNION"                           0 1 0 0;
    Until "UNTIL"                           1 1 1 1;
    Using "USING"                           1 0 0 0;
    Var "VAR"                               1 1 1 1;
    VarAccess "VAR_ACCESS"                  1 1 1 1;
    VarConfig "VAR_CONFIG"                  1 1 1 1;
    VarExternal "VAR_EXTERNAL"              1 1 1 1;
    VarGlobal "VAR_GLOBAL"                  1 1 1 1;
    VarInput "VAR_INPUT"                    1 1 1 1;
    VarInst "VAR_INST"                      1 1 1 1;
    VarInOut "VAR_IN_OUT"                   1 1 1 1;
    VarOutput "VAR_OUTPUT"                  1 1 1 1;
    VarStat "VAR_STAT"                      1 1 1 1;
    VarTemp "VAR_TEMP"                      1 1 1 1;
    While "WHILE"                           1 1 1 1;
    Xor "XOR"                               1 1 1 1;
    Catch "__CATCH"                         0 1 0 0;
    EndTry "__ENDTRY"                       0 1 0 0;
    Finally "__FINALLY"                     0 1 0 0;
    Try "__TRY"                             0 1 0 0;
}

/// The longest of them.
const LENGTH_MAX: usize = 22;

impl Keyword {
    /// The keyword that a word is in this dialect, without regard to case.
    pub(super) fn of(word: &str, dialect: Dialect) -> Option<Self> {
        let mut buffer = [0_u8; LENGTH_MAX];
        let upper = buffer.get_mut(..word.len())?;
        upper.copy_from_slice(word.as_bytes());
        upper.make_ascii_uppercase();
        let found = ROWS.binary_search_by(|(row, ..)| row.as_bytes().cmp(upper)).ok()?;
        let (_, keyword, reserved) = &ROWS[found];
        (reserved[dialect.column()] == 1).then_some(*keyword)
    }

    /// The keyword of test files that a word is at its place, without regard to case.
    pub(super) fn of_test_file(word: &str) -> Option<Self> {
        let all = [Self::Setup, Self::EndSetup, Self::Teardown, Self::EndTeardown, Self::Test, Self::EndTest];
        all.into_iter().find(|keyword| keyword.word().eq_ignore_ascii_case(word))
    }

    /// All of them, sorted by word.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        ROWS.iter().map(|row| row.1)
    }

    /// Whether no dialect reserves it: it is a word of test files.
    pub(super) fn is_of_tests(self) -> bool {
        ROWS[self as usize].2 == [0; 4]
    }

    /// All words.
    pub(super) fn words() -> impl Iterator<Item = &'static str> {
        ROWS.iter().map(|row| row.0)
    }

    /// The word.
    pub(super) fn word(self) -> &'static str {
        ROWS[self as usize].0
    }

    /// Words that begin a declaration section.
    pub(super) fn begins_section(self) -> bool {
        (Self::Var..=Self::VarTemp).contains(&self) || matches!(self, Self::Const | Self::Label)
    }

    /// Words that begin something that does not stand inside a block with statements.
    pub(super) fn begins_block(self) -> bool {
        use Keyword::{
            Class, Configuration, DataBlock, Function, FunctionBlock, Interface, Namespace, OrganizationBlock, Program, Setup, Teardown,
            Test, Type, Using,
        };
        matches!(
            self,
            Program
                | Function
                | FunctionBlock
                | Class
                | OrganizationBlock
                | DataBlock
                | Type
                | Setup
                | Teardown
                | Test
                | Interface
                | Namespace
                | Using
                | Configuration
        )
    }

    /// Words that end something.
    pub(super) fn is_end(self) -> bool {
        (Self::EndAction..=Self::EndWhile).contains(&self) || self == Self::EndTry
    }

    /// Words that end a statement, not a block or a section.
    pub(super) fn ends_statement(self) -> bool {
        use Keyword::{EndCase, EndFor, EndIf, EndRegion, EndRepeat, EndTry, EndWhile};
        matches!(self, EndCase | EndFor | EndIf | EndRegion | EndRepeat | EndTry | EndWhile)
    }

    /// Words that begin a statement.
    pub(super) fn begins_statement(self) -> bool {
        use Keyword::{Case, Continue, Exit, For, Goto, If, Jmp, Region, Repeat, Return, Try, While};
        matches!(self, Case | Continue | Exit | For | Goto | If | Jmp | Region | Repeat | Return | Try | While)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_keyword_is_found_by_its_word_in_the_dialects_that_reserve_it() {
        assert!(ROWS.is_sorted_by_key(|row| row.0));
        for (index, &(word, keyword, reserved)) in ROWS.iter().enumerate() {
            assert_eq!(keyword as usize, index);
            assert!(word.len() <= LENGTH_MAX);
            for dialect in Dialect::ALL {
                let found = Keyword::of(&word.to_lowercase(), dialect);
                assert_eq!(found, (reserved[dialect.column()] == 1).then_some(keyword));
            }
        }
        assert_eq!(Keyword::of("ENDIF", Dialect::Iec), None);
    }
}
