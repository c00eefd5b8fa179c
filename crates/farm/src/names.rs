//! What the streams, subjects and objects of a campaign are called.

/// Most digits of the identity of a campaign: those of a SHA-256.
const DIGITS_MAX: usize = 64;

/// The durable consumer that all workers share.
pub(crate) const CONSUMER: &str = "workers";

/// The object with what a campaign brings along.
pub(crate) const PROGRAM: &str = "program";

/// What the streams, subjects and objects of one campaign are called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Names {
    /// The identity of the campaign.
    pub campaign: String,
    /// The stream of the ranges.
    pub jobs: String,
    /// The stream of the results.
    pub results: String,
    /// The bucket of objects.
    pub bucket: String,
    /// The subject of a range.
    pub job: String,
    /// The subject of a result.
    pub result: String,
    /// The subject on which workers say that they are alive.
    pub alive: String,
    /// The subject on which the run says that it is, and when it is over.
    pub state: String,
}

impl Names {
    /// The names of a campaign; `None` if its identity is none.
    pub(crate) fn of(campaign: &str) -> Option<Self> {
        let is_identity =
            (1..=DIGITS_MAX).contains(&campaign.len()) && campaign.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f'));
        is_identity.then(|| Self {
            campaign: campaign.to_owned(),
            jobs: format!("SIEBEN_{campaign}_JOBS"),
            results: format!("SIEBEN_{campaign}_RESULTS"),
            bucket: format!("sieben_{campaign}"),
            job: format!("sieben.{campaign}.job"),
            result: format!("sieben.{campaign}.result"),
            alive: format!("sieben.{campaign}.alive"),
            state: format!("sieben.{campaign}.state"),
        })
    }

    /// The subject on which a worker says that it runs a scenario alone; the bucket keeps it.
    pub(crate) fn mark(&self, number: u64) -> String {
        format!("$O.{}.C.alone.{number}", self.bucket)
    }

    /// The names of the campaign whose ranges are in a stream; `None` if it is a stream of something else.
    pub(crate) fn of_stream(stream: &str) -> Option<Self> {
        Self::of(stream.strip_prefix("SIEBEN_")?.strip_suffix("_JOBS")?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stream_names_its_campaign() {
        let names = Names::of("1f00").expect("an identity");
        assert_eq!(Names::of_stream(&names.jobs), Some(names));
        for stream in ["SIEBEN__JOBS", "SIEBEN_1F_JOBS", "SIEBEN_1f_RESULTS", "ORDERS", "SIEBEN_a.b_JOBS"] {
            assert_eq!(Names::of_stream(stream), None, "{stream}");
        }
    }
}
