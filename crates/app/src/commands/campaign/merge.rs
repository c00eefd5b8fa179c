//! `sieben campaign merge`: one result of the results of parts.

use std::path::PathBuf;

use clap::Args;

use crate::failure::{Exit, Failure};

/// Make one result of the results of parts of a campaign.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben campaign merge r0.parquet r1.parquet -o r.parquet\n\n\
The result has the same bytes as that of one run over all scenarios.\n\n\
Exit codes: 0 all scenarios are there and all held, 1 a property broke, what has to come\n\
sometimes never came, or scenarios are missing, 2 usage or results of different campaigns.")]
pub(super) struct Arguments {
    /// The results of the parts
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// Write the result to this file
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Print the summary as one JSON object
    #[arg(long)]
    json: bool,
}

/// Merges them.
#[cfg(feature = "parquet")]
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    use sieben_campaign::row::Verdict;

    use crate::campaign::said;
    use crate::output;

    let merged = crate::campaign::files::merge(&arguments.files, &arguments.output)?;
    let missing: Vec<_> = merged.there.missing(0..merged.scenarios).collect();
    if arguments.json {
        output::print_json(&merged.summary, false)?;
    } else {
        let count = |verdict: Verdict| merged.summary[verdict.word()].as_u64().unwrap_or(0);
        let others: String =
            Verdict::ALL[1..].iter().filter(|&&one| count(one) > 0).map(|&one| format!(", {} {}", count(one), one.word())).collect();
        let all = said::scenarios(merged.there.count());
        output::print(&format!("{}: {all}, {} pass{others}\n", arguments.output.display(), count(Verdict::Pass)))?;
    }
    if !missing.is_empty() {
        let shown: Vec<String> = missing.iter().take(5).map(|range| format!("{}..{}", range.start, range.end - 1)).collect();
        let more = if missing.len() > shown.len() { ", and more" } else { "" };
        output::message(&format!("missing: scenarios {}{more}\n", shown.join(", ")));
    }
    let never = merged.summary["properties"]
        .as_array()
        .into_iter()
        .flatten()
        .any(|property| property["kind"] == "sometimes" && property["came"] == 0);
    let held = merged.summary[Verdict::Pass.word()] == merged.there.count();
    Ok(if held && missing.is_empty() && !never { Exit::Success } else { Exit::CheckFailed })
}

/// Merges them.
#[cfg(not(feature = "parquet"))]
pub(super) fn run(_: &Arguments) -> Result<Exit, Failure> {
    Err(super::without_files())
}
