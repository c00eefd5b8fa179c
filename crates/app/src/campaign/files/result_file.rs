//! The result of a campaign: a Parquet file whose bytes depend on the campaign alone.

use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use arrow_array::RecordBatch;
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::{Compression, ZstdLevel};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use serde_json::Value as Json;
use sieben_campaign::identity;
use sieben_campaign::part::FAILURES_MAX;
use sieben_campaign::ranges::Ranges;
use sieben_campaign::row::Row;
use sieben_campaign::spec::Keep;
use sieben_campaign::tally::Tally;
use sieben_model::problems::Problem;

use super::columns::Columns;
use super::head::Head;
use crate::campaign::summary;
use crate::failure::Failure;
use crate::{files, panics};

/// Scenarios of a row group.
const ROW_GROUP: usize = 65_536;
/// Rows that are written at once: a row group is a whole number of them.
const BATCH: usize = 8_192;

/// Writes the rows of a result in the order of their numbers.
pub(crate) struct Writer<'f, 'a> {
    writer: ArrowWriter<&'f mut (dyn Write + Send)>,
    columns: &'a Columns,
    waiting: Vec<Row>,
    /// Rows that may still come.
    room: usize,
    path: &'a Path,
}

impl Writer<'_, '_> {
    /// Writes a result as a whole: `fill` pushes its rows.
    ///
    /// # Errors
    /// It cannot be written.
    pub(crate) fn write(
        path: &Path,
        columns: &Columns,
        head: &Head,
        spec: &str,
        summary: &Json,
        fill: &mut dyn FnMut(&mut Writer<'_, '_>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let mut failed = None;
        let done = files::write_with(path, &mut |file| {
            let properties = WriterProperties::builder()
                .set_created_by("sieben".to_owned())
                .set_compression(Compression::ZSTD(ZstdLevel::default()))
                .set_max_row_group_row_count(Some(ROW_GROUP));
            let writer = ArrowWriter::try_new(file, columns.schema().clone(), Some(properties.build())).map_err(io::Error::other)?;
            let room = if head.keep == Keep::Failures { FAILURES_MAX } else { usize::MAX };
            let mut rows = Writer { writer, columns, waiting: Vec::with_capacity(BATCH), room, path };
            if let Err(failure) = fill(&mut rows).and_then(|()| rows.flush()) {
                failed = Some(failure);
                return Err(io::Error::other("the rows are not there"));
            }
            let all = [
                ("campaign", head.campaign.clone()),
                ("program", head.program.clone()),
                ("spec", spec.to_owned()),
                ("seed", head.seed.to_string()),
                ("version", head.meaning.to_string()),
                ("scenarios", head.scenarios.to_string()),
                ("summary", summary.to_string()),
            ];
            for (key, value) in all {
                rows.writer.append_key_value_metadata(KeyValue::new(format!("sieben.{key}"), value));
            }
            rows.writer.close().map(drop).map_err(io::Error::other)
        });
        failed.map_or(done, Err)
    }

    /// Writes the next row.
    ///
    /// # Errors
    /// It cannot be written.
    pub(crate) fn push(&mut self, row: Row) -> Result<(), Failure> {
        if self.room > 0 {
            self.room -= 1;
            self.waiting.push(row);
            if self.waiting.len() == BATCH {
                self.flush()?;
            }
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Failure> {
        let batch = self.columns.batch(&self.waiting);
        self.waiting.clear();
        self.writer.write(&batch).map_err(|error| files::unwritable(self.path, &io::Error::other(error)))
    }
}

/// A result that was read, but for its rows.
pub(crate) struct ResultFile {
    /// Where it is.
    pub(crate) path: PathBuf,
    /// What it is of.
    pub(crate) head: Head,
    /// The file of the campaign.
    pub(crate) spec: String,
    /// What the scenarios came to.
    pub(crate) tally: Tally,
    /// The same with all names, as it lies in the file.
    pub(crate) summary: Json,
    /// Its columns.
    pub(crate) columns: Columns,
}

impl ResultFile {
    /// Reads a result.
    ///
    /// # Errors
    /// It cannot be read, or is none.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let file = files::open(path)?;
        let builder = panics::survive(|| ParquetRecordBatchReaderBuilder::try_new(file).map_err(|error| error.to_string()))
            .map_err(|trouble| none(path, &trouble.of_bytes()))?;
        let metadata = builder.metadata().file_metadata().key_value_metadata().cloned().unwrap_or_default();
        let text = |key: &str| metadata.iter().find(|pair| pair.key.strip_prefix("sieben.") == Some(key))?.value.clone();
        let read = || {
            let spec = text("spec")?;
            let summary: Json = serde_json::from_str(&text("summary")?).ok()?;
            let head = Head {
                campaign: text("campaign")?,
                program: text("program")?,
                spec: identity::of_text(&spec),
                seed: text("seed")?.parse().ok()?,
                meaning: text("version")?.parse().ok()?,
                scenarios: text("scenarios")?.parse().ok()?,
                keep: Keep::from_word(summary["keep"].as_str()?)?,
            };
            let name = |property: &Json| property["name"].as_str().map(str::to_owned);
            let properties = summary["properties"].as_array()?.iter().map(name).collect::<Option<_>>()?;
            let columns = Columns::of_schema(builder.schema(), properties)?;
            let tally = Tally::from_json(&summary)?;
            let fits = tally.measures.len() == columns.named("m.").len();
            fits.then(|| Self { path: path.to_path_buf(), head, spec, tally, summary, columns })
        };
        read().ok_or_else(|| none(path, "it has no summary of a campaign"))
    }

    /// Which scenarios it is of.
    pub(crate) fn there(&self) -> Ranges {
        summary::there(&self.summary)
    }

    /// Its rows, one batch after the other.
    ///
    /// # Errors
    /// It cannot be read.
    pub(crate) fn rows(&self) -> Result<impl Iterator<Item = Result<Vec<Row>, Failure>> + '_, Failure> {
        let file: File = files::open(&self.path)?;
        let reader = ParquetRecordBatchReaderBuilder::try_new(file)
            .and_then(|builder| builder.with_batch_size(BATCH).build())
            .map_err(|error: ParquetError| none(&self.path, &error.to_string()))?;
        let mut reader = reader.into_iter();
        Ok(std::iter::from_fn(move || {
            let next = panics::survive(|| reader.next().transpose().map_err(|error| error.to_string()));
            let rows = |batch: RecordBatch| self.columns.rows(&batch).map_err(|error| none(&self.path, &error.to_string()));
            next.map_err(|trouble| none(&self.path, &trouble.of_bytes())).transpose().map(|batch| batch.and_then(rows))
        }))
    }
}

fn none(path: &Path, reason: &str) -> Failure {
    Failure::usage(Problem::P7178, format!("`{}` is no result of a campaign that can be read: {reason}", path.display()))
}
