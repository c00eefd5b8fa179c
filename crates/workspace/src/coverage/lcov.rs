//! Coverage as a tracefile of lcov.

use std::fmt::Write as _;

use super::Coverage;

impl Coverage {
    /// The tracefile. Each way of a decision is a branch, in the order of the page: RLO 0 before RLO 1, FALSE before TRUE.
    pub fn lcov(&self) -> String {
        let mut out = String::from("TN:\n");
        // Writing to a text cannot fail.
        for (name, file) in &self.files {
            let _ = writeln!(out, "SF:{name}");
            let (mut branches, mut taken) = (0, 0);
            for (number, line) in &file.lines {
                for (index, decision) in line.decisions.iter().enumerate() {
                    for (branch, &(_, count)) in decision.ways.iter().enumerate() {
                        let count_text = if decision.is_reached() { count.to_string() } else { "-".to_owned() };
                        let _ = writeln!(out, "BRDA:{number},{index},{branch},{count_text}");
                        branches += 1;
                        taken += usize::from(count > 0);
                    }
                }
            }
            if branches > 0 {
                let _ = writeln!(out, "BRF:{branches}\nBRH:{taken}");
            }
            for (number, line) in &file.lines {
                let _ = writeln!(out, "DA:{number},{}", line.ran);
            }
            let _ = writeln!(out, "LF:{}\nLH:{}", file.lines().all, file.lines().hit);
            out.push_str("end_of_record\n");
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::file;
    use super::*;

    #[test]
    fn a_decision_that_was_not_reached_has_branches_without_a_count() {
        let mut all = Coverage::default();
        all.merge("a.awl".to_owned(), file(&[(1, 0, &[[0, 0]]), (2, 4, &[[3, 1]])]));
        let branches = "BRDA:1,0,0,-\nBRDA:1,0,1,-\nBRDA:2,0,0,3\nBRDA:2,0,1,1\nBRF:4\nBRH:2\n";
        assert_eq!(all.lcov(), format!("TN:\nSF:a.awl\n{branches}DA:1,0\nDA:2,4\nLF:2\nLH:1\nend_of_record\n"));
    }
}
