//! Statements.

use super::{DiagramBox, Expression, Name, NetworkNumber, Wire};
use sieben_model::source::Span;

/// One statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// What it does.
    pub kind: StatementKind,
    /// The whole statement without its `;`.
    pub span: Span,
}

/// The statements.
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `;`.
    Empty,
    /// `a := x`, `a := b := x`, `a += x`.
    Assign {
        /// What is written to, from left to right; more than one only with [`AssignOperator::Becomes`].
        targets: Vec<Expression>,
        /// How.
        operator: AssignOperator,
        /// The value.
        value: Expression,
    },
    /// A call, or another expression where a statement stands (which is an error unless it is a call).
    Expression(Expression),
    /// IF.
    If {
        /// IF and each ELSIF; at least one.
        branches: Vec<Branch>,
        /// ELSE.
        otherwise: Option<Vec<Statement>>,
    },
    /// CASE.
    Case {
        /// What is compared.
        selector: Expression,
        /// The arms in order.
        arms: Vec<CaseArm>,
        /// ELSE.
        otherwise: Option<Vec<Statement>>,
    },
    /// FOR.
    For(Box<ForLoop>),
    /// WHILE.
    While {
        /// Tested before each pass.
        condition: Expression,
        /// The statements.
        body: Vec<Statement>,
    },
    /// REPEAT.
    Repeat {
        /// The statements.
        body: Vec<Statement>,
        /// UNTIL: tested behind each pass.
        until: Expression,
    },
    /// EXIT.
    Exit,
    /// CONTINUE.
    Continue,
    /// RETURN.
    Return,
    /// `GOTO label`, `JMP label`.
    Goto(Name),
    /// `label:` before a statement.
    Label(Name),
    /// `REGION name … END_REGION`.
    Region {
        /// The rest of its first line.
        name: String,
        /// The statements.
        body: Vec<Statement>,
    },
    /// `__TRY … __CATCH … __FINALLY … __ENDTRY`.
    Try {
        /// The statements.
        body: Vec<Statement>,
        /// The variable of `__CATCH(x)`.
        exception: Option<Expression>,
        /// The statements behind `__CATCH`.
        catch: Vec<Statement>,
        /// The statements behind `__FINALLY`.
        finally: Vec<Statement>,
    },
    /// A value of a diagram that is evaluated here, once, for all that read it.
    Wire(Wire, Expression),
    /// A box of a diagram.
    Box(Box<DiagramBox>),
    /// Not understood; a diagnostic was given.
    Missing,
}

/// FOR.
#[derive(Clone, Debug, PartialEq)]
pub struct ForLoop {
    /// The control variable.
    pub variable: Expression,
    /// The first value.
    pub from: Expression,
    /// The last value.
    pub to: Expression,
    /// BY; 1 if it is not written.
    pub by: Option<Expression>,
    /// The statements.
    pub body: Vec<Statement>,
    /// END_FOR: the place of the step.
    pub end: Span,
}

/// The ways to assign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AssignOperator {
    /// `:=`.
    Becomes,
    /// `+=`.
    Add,
    /// `-=`.
    Subtract,
    /// `*=`.
    Multiply,
    /// `/=`.
    Divide,
    /// `?=`: the assignment attempt of references, NULL where the types do not match.
    Attempt,
    /// `S=`: set the target if the value is TRUE, else keep it.
    Set,
    /// `R=`: reset the target if the value is TRUE, else keep it.
    Reset,
    /// `REF=`: let a REFERENCE TO refer to the variable.
    Refer,
    /// A coil of a diagram: `:=` to a BOOL.
    Coil(NetworkNumber),
    /// A set coil of a diagram: `S=`.
    SetCoil(NetworkNumber),
    /// A reset coil of a diagram: `R=`.
    ResetCoil(NetworkNumber),
}

/// IF or ELSIF with its statements.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The condition.
    pub condition: Expression,
    /// The statements.
    pub body: Vec<Statement>,
}

/// `1, 3, 5..9: …`.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseArm {
    /// The labels; at least one.
    pub labels: Vec<CaseLabel>,
    /// The statements.
    pub body: Vec<Statement>,
}

/// A label of CASE.
#[derive(Clone, Debug, PartialEq)]
pub enum CaseLabel {
    /// `5`, a constant expression.
    Value(Expression),
    /// `5..9`, constant expressions.
    Range(Expression, Expression),
}

impl CaseLabel {
    /// The place.
    pub fn span(&self) -> Span {
        match self {
            Self::Value(value) => value.span,
            Self::Range(low, high) => low.span.to(high.span),
        }
    }
}
