//! Values of a controller that runs what an editor shows: asked for at its control socket, shown in hints.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::server::Server;
use super::uri::Place;
use crate::control::client::Client;

/// How long a run may take for an answer; an editor waits as long.
const ANSWER_WAIT: Duration = Duration::from_millis(200);
/// How often it is looked whether values are others, or a run is there.
const LOOK_AGAIN: Duration = Duration::from_secs(1);
/// Values that are asked for at a time.
const VALUES_MAX: usize = 200;

/// What an editor was shown last, and the run that it is of.
#[derive(Default)]
pub(super) struct Live {
    run: Option<(PathBuf, Client)>,
    shown: Option<Shown>,
    /// When values are looked at again.
    pub(super) due: Option<Instant>,
}

struct Shown {
    place: Place,
    home: PathBuf,
    names: Vec<String>,
    values: Vec<Option<String>>,
}

impl Live {
    /// The values of these names in the run of a folder; none of a name that it does not have, or where no run answers.
    fn read(&mut self, home: &Path, names: &[String]) -> Vec<Option<String>> {
        let known = self.run.take().filter(|(of, _)| of == home);
        let connected = known.or_else(|| {
            let client = Client::connect(&[home.to_path_buf()]).ok()?;
            client.wait_at_most(ANSWER_WAIT).ok()?;
            Some((home.to_path_buf(), client))
        });
        let Some((home, mut client)) = connected else { return vec![None; names.len()] };
        match client.ask("read", &json!({ "items": names })) {
            Ok(answer) => {
                self.run = Some((home, client));
                let shown = |index| Some(answer["items"].get(index)?.get("shown")?.as_str()?.to_owned());
                (0..names.len()).map(shown).collect()
            }
            // The run is over, or held up: it is connected to again when values are looked at the next time.
            Err(_) => vec![None; names.len()],
        }
    }
}

/// Values of names in the run of the program that a text is part of, in their order. They are looked at again every second as long as the text
/// is open and the editor takes the word that its hints are old.
pub(super) fn values(server: &mut Server, place: &Place, mut names: Vec<String>) -> Vec<Option<String>> {
    names.truncate(VALUES_MAX);
    let is_wanted = server.client.settings.live_values && !names.is_empty();
    let Some(home) = server.folders.home_of(place).filter(|_| is_wanted) else { return Vec::new() };
    let values = server.live.read(&home, &names);
    server.live.shown = Some(Shown { place: place.clone(), home, names, values: values.clone() });
    server.live.due = server.client.refreshes_hints.then(|| Instant::now() + LOOK_AGAIN);
    values
}

/// Looks at the values again, and tells the editor if its hints are old.
pub(super) fn look_again(server: &mut Server) {
    server.live.due = None;
    let Some(shown) = server.live.shown.take().filter(|shown| server.documents.get(&shown.place).is_some()) else { return };
    let values = server.live.read(&shown.home, &shown.names);
    if values != shown.values {
        server.ask("workspace/inlayHint/refresh", Value::Null);
    }
    server.live.shown = Some(Shown { values, ..shown });
    server.live.due = Some(Instant::now() + LOOK_AGAIN);
}
