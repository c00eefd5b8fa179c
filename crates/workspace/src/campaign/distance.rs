//! How near the properties of a campaign come to breaking, where they compare numbers.
//!
//! The distance of `a < b` is `b - a`: below 0 it is false. AND takes the least of its sides, OR the greatest, NOT turns the sign round;
//! what is a Boolean by itself is infinitely true or false. What a comparison compares is computed beside the property.

use std::collections::BTreeSet;

use sieben_campaign::slots::{Slot, Wanted};
use sieben_campaign::spec::{Placed, PropertyKind, Spec};
use sieben_lang::st::ast::{BinaryOperator, Expression, ExpressionKind, Item, StatementKind, UnaryOperator};
use sieben_lang::st::dialect::Dialect;
use sieben_lang::st::parser;
use sieben_model::source::{FileId, Span};

/// The distances of all properties that have one, over values that are computed for them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Distances {
    properties: Vec<OfProperty>,
    operands: Vec<Operand>,
}

#[derive(Clone, Debug)]
struct OfProperty {
    tree: Tree,
    /// It breaks where its expression is true.
    never: bool,
}

/// An expression as a distance; a number is the place of an operand.
#[derive(Clone, Debug)]
enum Tree {
    Boolean(usize),
    /// The operand after this one is its right side.
    Compared(BinaryOperator, usize),
    Not(Box<Self>),
    And(Box<Self>, Box<Self>),
    Or(Box<Self>, Box<Self>),
}

/// What is computed for a distance.
#[derive(Clone, Debug)]
struct Operand {
    expression: Placed,
    wanted: Wanted,
    property: usize,
}

impl Distances {
    /// Of the properties of a campaign, as far as their expressions are understood.
    pub(crate) fn of(spec: &Spec, dialect: Dialect) -> Self {
        let mut distances = Self::default();
        for property in &spec.properties {
            if !matches!(property.kind, PropertyKind::Never | PropertyKind::Always) {
                continue;
            }
            let begin = distances.operands.len();
            let tree = distances.read(&property.expression, dialect);
            match tree {
                Some(tree) if tree.compares() => {
                    distances.properties.push(OfProperty { tree, never: property.kind == PropertyKind::Never });
                }
                _ => distances.operands.truncate(begin),
            }
        }
        distances
    }

    fn read(&mut self, expression: &Placed, dialect: Dialect) -> Option<Tree> {
        let source = format!("TEST 'distance'\nx :=\n{}\n;\nEND_TEST\n", expression.text);
        let parsed = parser::parse(FileId(0), &source, dialect.for_tests());
        let Some(Item::Block(block)) = parsed.file.items.first() else { return None };
        let StatementKind::Assign { value, .. } = &block.body.first()?.kind else { return None };
        parsed.diagnostics.is_empty().then(|| self.tree(value, &source, expression.span))
    }

    fn tree(&mut self, expression: &Expression, source: &str, place: Span) -> Tree {
        let mut both = |left, right| (Box::new(self.tree(left, source, place)), Box::new(self.tree(right, source, place)));
        match &expression.kind {
            ExpressionKind::Parenthesized(inner) => self.tree(inner, source, place),
            ExpressionKind::Unary(UnaryOperator::Not, inner) => Tree::Not(Box::new(self.tree(inner, source, place))),
            ExpressionKind::Binary(BinaryOperator::And | BinaryOperator::AndThen, _, left, right) => {
                let (left, right) = both(left, right);
                Tree::And(left, right)
            }
            ExpressionKind::Binary(BinaryOperator::Or | BinaryOperator::OrElse, _, left, right) => {
                let (left, right) = both(left, right);
                Tree::Or(left, right)
            }
            ExpressionKind::Binary(operator, _, left, right) if operator.compares() => {
                let at = self.operand(left, source, place, Wanted::Number);
                self.operand(right, source, place, Wanted::Number);
                Tree::Compared(*operator, at)
            }
            _ => Tree::Boolean(self.operand(expression, source, place, Wanted::Boolean)),
        }
    }

    fn operand(&mut self, expression: &Expression, source: &str, span: Span, wanted: Wanted) -> usize {
        let text = source[expression.span.start as usize..expression.span.end as usize].to_owned();
        self.operands.push(Operand { expression: Placed { text, span }, wanted, property: self.properties.len() });
        self.operands.len() - 1
    }

    /// What is to be computed for them, in the order of its places.
    pub(crate) fn slots(&self) -> impl Iterator<Item = Slot<'_>> {
        self.operands.iter().map(|operand| Slot { wanted: operand.wanted, expression: &operand.expression })
    }

    /// These operands are not what is wanted, such as times: their properties have no distance.
    pub(crate) fn without(&mut self, operands: &BTreeSet<usize>) {
        let gone: BTreeSet<usize> = operands.iter().filter_map(|&operand| Some(self.operands.get(operand)?.property)).collect();
        for &property in gone.iter().rev() {
            let begin = self.operands.partition_point(|operand| operand.property < property);
            let end = self.operands.partition_point(|operand| operand.property <= property);
            self.operands.drain(begin..end);
            self.properties.remove(property);
            for operand in &mut self.operands[begin..] {
                operand.property -= 1;
            }
            for of in &mut self.properties[property..] {
                of.tree.move_down(end - begin);
            }
        }
    }

    /// The least distance to a break, of the values of the operands; nothing if no number says it.
    pub(crate) fn least(&self, values: &[f64]) -> Option<f64> {
        // Adding 0 makes -0 of a distance to 0.
        let distance = |of: &OfProperty| of.tree.value(values) * if of.never { -1.0 } else { 1.0 } + 0.0;
        self.properties.iter().map(distance).filter(|distance| distance.is_finite()).min_by(f64::total_cmp)
    }
}

impl Tree {
    fn compares(&self) -> bool {
        match self {
            Self::Boolean(_) => false,
            Self::Compared(..) => true,
            Self::Not(inner) => inner.compares(),
            Self::And(left, right) | Self::Or(left, right) => left.compares() || right.compares(),
        }
    }

    fn move_down(&mut self, by: usize) {
        match self {
            Self::Boolean(at) | Self::Compared(_, at) => *at -= by,
            Self::Not(inner) => inner.move_down(by),
            Self::And(left, right) | Self::Or(left, right) => {
                left.move_down(by);
                right.move_down(by);
            }
        }
    }

    fn value(&self, values: &[f64]) -> f64 {
        match self {
            Self::Boolean(at) => {
                if values[*at] == 0.0 {
                    f64::NEG_INFINITY
                } else {
                    f64::INFINITY
                }
            }
            Self::Compared(operator, at) => {
                let above = values[*at] - values[*at + 1];
                match operator {
                    BinaryOperator::Greater | BinaryOperator::GreaterEqual => above,
                    BinaryOperator::Equal => -above.abs(),
                    BinaryOperator::NotEqual => above.abs(),
                    _ => -above,
                }
            }
            Self::Not(inner) => -inner.value(values),
            Self::And(left, right) => least(left.value(values), right.value(values)),
            Self::Or(left, right) => -least(-left.value(values), -right.value(values)),
        }
    }
}

/// The less of two; what is no number stays none.
fn least(left: f64, right: f64) -> f64 {
    if left.is_nan() || left < right { left } else { right }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sieben_campaign::spec::Property;

    fn spec(kind: PropertyKind, expressions: &[&str]) -> Spec {
        let span = Span::new(FileId(0), 0, 1);
        let property = |text: &&str| Property {
            kind,
            name: "p".to_owned(),
            span,
            expression: Placed { text: (*text).to_owned(), span },
            then: None,
            within_us: 0,
        };
        Spec { properties: expressions.iter().map(property).collect(), ..Spec::default() }
    }

    fn texts(distances: &Distances) -> Vec<&str> {
        distances.slots().map(|slot| slot.expression.text.as_str()).collect()
    }

    #[test]
    fn comparisons_are_distances_and_booleans_are_infinite() {
        let distances =
            Distances::of(&spec(PropertyKind::Never, &["Level + 1.0 > 95.0 AND NOT (Valve OR x[2].y <= f(z := 3))"]), Dialect::Iec);
        assert_eq!(texts(&distances), ["Level + 1.0", "95.0", "Valve", "x[2].y", "f(z := 3)"]);
        // Not above, and the valve is open: as far as the level is below, or infinitely far.
        assert_eq!(distances.least(&[90.0, 95.0, 0.0, 8.0, 3.0]), Some(5.0));
        assert_eq!(distances.least(&[90.0, 95.0, 1.0, 8.0, 3.0]), None);
        // It is broken by the less of both.
        assert_eq!(distances.least(&[98.0, 95.0, 0.0, 5.0, 3.0]), Some(-2.0));
        assert_eq!(distances.least(&[f64::NAN, 95.0, 0.0, 8.0, 3.0]), None);
    }

    #[test]
    fn each_comparison_breaks_where_its_distance_is_below_zero() {
        for (sign, left, right, distance) in [
            ("<", 1.0, 3.0, 2.0),
            ("<=", 4.0, 3.0, -1.0),
            (">", 1.0, 3.0, -2.0),
            (">=", 4.0, 3.0, 1.0),
            ("=", 1.0, 3.0, -2.0),
            ("<>", 1.0, 3.0, 2.0),
        ] {
            let distances = Distances::of(&spec(PropertyKind::Always, &[&format!("a {sign} b")]), Dialect::Scl);
            assert_eq!(distances.least(&[left, right]), Some(distance), "{sign}");
        }
    }

    #[test]
    fn a_property_without_numbers_takes_no_operands_away_from_the_others() {
        let mut distances = Distances::of(&spec(PropertyKind::Always, &["a < b", "c AND d", "t = u OR v", "e < f", "g <"]), Dialect::Iec);
        assert_eq!(texts(&distances), ["a", "b", "t", "u", "v", "e", "f"]);
        distances.without(&BTreeSet::from([2, 3]));
        assert_eq!(texts(&distances), ["a", "b", "e", "f"]);
        assert_eq!(distances.least(&[1.0, 9.0, 1.0, 3.0]), Some(2.0));
    }
}
