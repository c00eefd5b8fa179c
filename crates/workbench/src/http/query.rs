//! What stands after `?` in an address.

/// Fields of a query, decoded.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Query(Vec<(String, String)>);

/// Fields that are read at most.
const FIELDS_MAX: usize = 64;

impl Query {
    /// Reads `a=1&b=x%20y`.
    pub(super) fn parse(text: &str) -> Self {
        let field = |field: &str| {
            let (name, value) = field.split_once('=').unwrap_or((field, ""));
            let decode = |text: &str| decoded(&text.replace('+', " "));
            Some((decode(name)?, decode(value)?))
        };
        Self(text.split('&').filter(|field| !field.is_empty()).take(FIELDS_MAX).filter_map(field).collect())
    }

    /// The first value of a field.
    pub(super) fn get(&self, name: &str) -> Option<&str> {
        self.0.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }
}

/// A text whose `%XX` are bytes; `None` if that is no UTF-8.
pub(super) fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let digits = after.get(..2).filter(|_| first == b'%').and_then(|digits| std::str::from_utf8(digits).ok());
        let escaped = digits.filter(|digits| !digits.starts_with('+')).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        match escaped {
            Some(byte) => {
                bytes.push(byte);
                rest = after.get(2..).unwrap_or_default();
            }
            None => {
                bytes.push(first);
                rest = after;
            }
        }
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_decoded() {
        let query = Query::parse("from=1&channels=Q%200.0,%22Motor%22&a+b=c+d&bad=%FF&odd=%4&x");
        for (name, wanted) in [
            ("from", Some("1")),
            ("channels", Some("Q 0.0,\"Motor\"")),
            ("a b", Some("c d")),
            ("bad", None),
            ("odd", Some("%4")),
            ("x", Some("")),
        ] {
            assert_eq!(query.get(name), wanted, "{name}");
        }
        assert_eq!(decoded("%+1%zz%"), Some("%+1%zz%".to_owned()));
    }
}
