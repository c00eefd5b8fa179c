//! Findings as one line each: for editors and scripts, and as workflow commands of GitHub Actions.

use sieben_model::diagnostic::Severity;

use super::{Finding, Origin, Texts, help_of};

/// `line4.awl:3:5: error[P1005]: …`, one line each.
pub fn concise(findings: &[Finding], texts: &Texts) -> String {
    let line = |finding: &Finding| {
        let (file, place) = place(finding, texts);
        let place = place.map_or_else(String::new, |(line, column)| format!("{line}:{column}: "));
        let file = if file.is_empty() {
            file
        } else if place.is_empty() {
            format!("{file}: ")
        } else {
            format!("{file}:")
        };
        let (code, message) = (finding.diagnostic.problem.code(), finding.message());
        format!("{file}{place}{}[{code}]: {message}", severity(finding)).replace(['\r', '\n'], " ") + "\n"
    };
    findings.iter().map(line).collect()
}

/// `::error file=line4.awl,line=3,col=5,title=…::…`: each becomes an annotation of the line.
pub fn github(findings: &[Finding], texts: &Texts) -> String {
    let line = |finding: &Finding| {
        let (file, place) = place(finding, texts);
        let problem = finding.diagnostic.problem;
        let file = if file.is_empty() { String::new() } else { format!("file={},", property(&file)) };
        let place = place.map_or_else(String::new, |(line, column)| format!("line={line},col={column},"));
        let title = property(&format!("{}: {}", problem.code(), problem.title()));
        let help = help_of(&finding.diagnostic).map_or_else(String::new, |help| format!("\n{help}"));
        let message = data(&format!("{}{help}", finding.message()));
        format!("::{} {file}{place}title={title}::{message}\n", severity(finding))
    };
    findings.iter().map(line).collect()
}

fn severity(finding: &Finding) -> &'static str {
    match finding.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    }
}

/// The file of a finding, and the line and column in it.
fn place(finding: &Finding, texts: &Texts) -> (String, Option<(usize, usize)>) {
    let span = finding.diagnostic.span;
    match (&finding.origin, texts.of(&finding.origin)) {
        (Origin::File(path), _) => (path.clone(), None),
        (_, Some(sources)) => (sources.file(span.file).name.clone(), Some(sources.line_column(span))),
        (_, None) => (String::new(), None),
    }
}

/// The message of a workflow command: it ends with its line.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// A property of a workflow command: it ends with `,` or `::`, too.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use sieben_model::diagnostic::Diagnostic;
    use sieben_model::problems::Problem;
    use sieben_model::source::Span;

    use super::*;

    #[test]
    fn each_finding_is_one_line_whatever_stands_in_it() {
        let mut texts = Texts::default();
        let file = texts.program.add("50%, c:\\a\nb.awl", "A I 0.0\n= ü\n");
        let diagnostic = Diagnostic::new(Problem::P2001, Span::new(file, 12, 13), "100 % `a`:\r\n`b`, c").help("write 5%\nor less");
        let findings =
            [Finding::program(diagnostic), Finding::file(Problem::P1102, "x,y.awl", "lost"), Finding::file(Problem::P6005, "", "no")];
        assert_eq!(
            concise(&findings, &texts),
            "50%, c:\\a b.awl:2:4: error[P2001]: 100 % `a`:  `b`, c\nx,y.awl: warning[P1102]: lost\nerror[P6005]: no\n"
        );
        let text = github(&findings, &texts);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[0],
            "::error file=50%25%2C c%3A\\a%0Ab.awl,line=2,col=4,title=P2001%3A a word where a statement should begin is not an \
             instruction::100 %25 `a`:%0D%0A`b`, c%0AWrite 5%25%0Aor less"
        );
        assert!(lines[1].starts_with("::warning file=x%2Cy.awl,title=P1102%3A ") && lines[1].contains("::lost%0A"), "{}", lines[1]);
        assert!(lines[2].starts_with("::error title=P6005%3A "), "{}", lines[2]);
        assert_eq!(lines.len(), 3);
    }
}
