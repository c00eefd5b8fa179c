//! The server: one thread has all that is known, takes messages in their order, and answers each from the texts as they are then.

use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender};
use std::time::{Duration, Instant};

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response, ResponseError};
use lsp_types::{Position, Range};
use serde_json::{Value, json};

use super::client::{self, Client, Settings};
use super::diagnostics::{self, Collecting, Told};
use super::documents::{Document, Documents};
use super::folders::Folders;
use super::live::{self, Live};
use super::positions::Columns;
use super::programs::Tests;
use super::transport::{Cancelled, Event, Outbox};
use super::uri::Place;
use super::work::{Answer, refused, survive};
use super::{notifications, requests};
use crate::failure::Exit;

/// Diagnostics wait as long as they took last time, but no longer than this.
const WAIT_MAX: Duration = Duration::from_millis(300);
/// Diagnostics that took no longer than this do not wait at all.
const QUICK: Duration = Duration::from_millis(25);

/// Test files are looked at when nothing was changed for so long: each of them compiles the program with its tests.
const TESTS_WAIT: Duration = Duration::from_millis(300);

/// Where a conversation stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// The client has not said what it can do.
    Begins,
    /// It asks and is answered.
    Runs,
    /// It has said that it wants nothing more.
    Ends,
}

/// The server.
pub(super) struct Server {
    stage: Stage,
    pub(super) client: Client,
    pub(super) documents: Documents,
    pub(super) folders: Folders,
    pub(super) live: Live,
    pub(super) outbox: Outbox,
    pub(super) events: SyncSender<Event>,
    cancelled: Cancelled,
    /// What each text was last said to have wrong.
    told: Told,
    /// What was said of what belongs to no file.
    told_homeless: Vec<String>,
    /// When diagnostics are told next.
    due: Option<Instant>,
    /// When those of test files are, too.
    tests_due: Option<Instant>,
    /// How long they took.
    took: Duration,
    /// The texts that changed since they were told.
    changed: Vec<Place>,
    /// The number of the last request to the client.
    asked: i32,
}

impl Server {
    /// One that was not spoken to yet.
    pub(super) fn new(outbox: Outbox, events: SyncSender<Event>, cancelled: Cancelled) -> Self {
        Self {
            stage: Stage::Begins,
            client: Client::of(&Value::Null),
            documents: Documents::default(),
            folders: Folders::new(super::programs::usual()),
            live: Live::default(),
            outbox,
            events,
            cancelled,
            told: Told::new(),
            told_homeless: Vec::new(),
            due: None,
            tests_due: None,
            took: Duration::ZERO,
            changed: Vec::new(),
            asked: 0,
        }
    }

    /// Answers until the client is gone or says `exit`.
    pub(super) fn run(&mut self, events: &Receiver<Event>) -> Exit {
        loop {
            let event = match self.due.into_iter().chain(self.tests_due).chain(self.live.due).min() {
                None => events.recv().ok(),
                Some(due) => match events.recv_timeout(due.saturating_duration_since(Instant::now())) {
                    Ok(event) => Some(event),
                    Err(RecvTimeoutError::Disconnected) => None,
                    Err(RecvTimeoutError::Timeout) if self.due == Some(due) => {
                        self.tell(Tests::Typed);
                        continue;
                    }
                    Err(RecvTimeoutError::Timeout) if self.tests_due == Some(due) => {
                        self.tell(Tests::All);
                        continue;
                    }
                    Err(RecvTimeoutError::Timeout) => {
                        live::look_again(self);
                        continue;
                    }
                },
            };
            let ended = if self.stage == Stage::Ends { Exit::Success } else { Exit::CheckFailed };
            match event {
                None | Some(Event::Gone(None)) => return ended,
                Some(Event::Gone(Some(why))) => {
                    self.log(1, &format!("the language server ends: {why}"));
                    return Exit::CheckFailed;
                }
                Some(Event::Garbled(answer, why)) => {
                    self.outbox.send_value(&answer);
                    self.log(1, &why);
                }
                Some(Event::Finished(finished)) => self.answer(finished.id, finished.answer),
                Some(Event::Message(Message::Notification(notification))) if notification.method == "exit" => return ended,
                Some(Event::Message(message)) => self.take(message),
            }
        }
    }

    fn take(&mut self, message: Message) {
        match message {
            Message::Request(request) => self.request(request),
            Message::Notification(notification) => self.notification(notification),
            // Nothing that the client is asked for has an answer that matters.
            Message::Response(_) => {}
        }
    }

    fn request(&mut self, request: Request) {
        let Request { id, method, params } = request;
        if self.cancelled.take(&id) {
            return self.answer(id, Err(refused(ErrorCode::RequestCanceled, "the request was given up")));
        }
        match (self.stage, method.as_str()) {
            (Stage::Begins, "initialize") => {
                let answer = self.initialize(&params);
                self.answer(id, Ok(answer));
            }
            (Stage::Begins, _) => self.answer(id, Err(refused(ErrorCode::ServerNotInitialized, "`initialize` comes first"))),
            (_, "initialize") => self.answer(id, Err(refused(ErrorCode::InvalidRequest, "`initialize` comes once"))),
            (Stage::Ends, _) => self.answer(id, Err(refused(ErrorCode::InvalidRequest, "nothing comes after `shutdown` but `exit`"))),
            (Stage::Runs, "shutdown") => {
                self.stage = Stage::Ends;
                (self.due, self.tests_due, self.live.due) = (None, None, None);
                self.answer(id, Ok(Value::Null));
            }
            (Stage::Runs, _) => {
                let answer = survive(&method, || requests::answer(self, &id, &method, params));
                let is_mistake = |error: &ResponseError| error.code == ErrorCode::InternalError as i32;
                if let Err(error) = answer.as_ref()
                    && is_mistake(error)
                {
                    let message = error.message.clone();
                    self.mistaken(&message);
                }
                match answer {
                    Err(error) if error.code == requests::LATER => {}
                    answer => self.answer(id, answer),
                }
            }
        }
    }

    fn notification(&mut self, notification: Notification) {
        if self.stage != Stage::Runs {
            return;
        }
        let Notification { method, params } = notification;
        if let Err(error) = survive(&method, || notifications::take(self, &method, params)) {
            match error.code == ErrorCode::InternalError as i32 {
                true => self.mistaken(&error.message),
                false => self.log(2, &error.message),
            }
        }
    }

    /// What we did wrong is said, and everything is read again: it may be half done.
    fn mistaken(&mut self, message: &str) {
        self.log(1, message);
        self.folders.forget();
    }

    fn initialize(&mut self, parameters: &Value) -> Value {
        self.client = Client::of(parameters);
        self.stage = Stage::Runs;
        self.folders.overrides = self.client.settings.overrides();
        for folder in self.client.folders.clone() {
            self.folders.add(&folder);
        }
        if let Some(process) = self.client.process {
            super::parent::watch(process, self.events.clone());
        }
        json!({
            "capabilities": client::capabilities(&self.client),
            "serverInfo": { "name": "sieben", "version": env!("CARGO_PKG_VERSION") },
        })
    }

    /// The client is ready to be asked and told.
    pub(super) fn initialized(&mut self) {
        if self.client.watches {
            self.ask("client/registerCapability", client::watched());
        }
        for mistake in std::mem::take(&mut self.client.settings.mistakes) {
            self.log(2, &format!("a setting is left out: {mistake}"));
        }
        self.soon();
    }

    /// Other settings hold from now on.
    pub(super) fn set(&mut self, settings: Settings) {
        for mistake in &settings.mistakes {
            self.log(2, &format!("a setting is left out: {mistake}"));
        }
        let overrides = settings.overrides();
        if self.client.settings != settings {
            self.client.settings = settings;
            self.folders.overrides = overrides;
            self.folders.forget();
            self.soon();
        }
    }

    /// How columns are counted.
    pub(super) fn columns(&self) -> Columns {
        self.client.telling.columns
    }

    /// Sends an answer.
    fn answer(&self, id: RequestId, answer: Answer) {
        self.outbox.send(Response { id, response_result: answer });
    }

    /// Sends a notification.
    pub(super) fn say(&self, method: &str, params: Value) {
        self.outbox.send(Notification { method: method.to_owned(), params });
    }

    /// Sends a request.
    pub(super) fn ask(&mut self, method: &str, params: Value) -> i32 {
        self.asked += 1;
        self.outbox.send(Request { id: RequestId::from(self.asked), method: method.to_owned(), params });
        self.asked
    }

    /// Writes into the log of the client: 1 error, 2 warning, 3 remark.
    pub(super) fn log(&self, kind: u32, message: &str) {
        self.say("window/logMessage", json!({ "type": kind, "message": message }));
        if kind == 1 {
            crate::output::message(&format!("{message}\n"));
        }
    }

    /// Shows a message to the user: 1 error, 2 warning, 3 remark.
    pub(super) fn show(&self, kind: u32, message: &str) {
        self.say("window/showMessage", json!({ "type": kind, "message": message }));
    }

    /// Texts changed: diagnostics are told as soon as nothing else is asked, or a little later where they take long.
    pub(super) fn soon(&mut self) {
        let wait = if self.took <= QUICK { Duration::ZERO } else { self.took.min(WAIT_MAX) };
        self.due.get_or_insert_with(|| Instant::now() + wait);
    }

    /// A text changed.
    pub(super) fn changed(&mut self, place: Place) {
        if !self.changed.contains(&place) {
            self.changed.push(place);
        }
        self.soon();
    }

    /// Takes in all texts as they are now.
    pub(super) fn renew(&mut self) {
        let token = (self.folders.has_unread() && self.client.progress).then(|| {
            let token = format!("sieben-{}", self.asked + 1);
            self.ask("window/workDoneProgress/create", json!({ "token": token }));
            let begin = json!({ "kind": "begin", "title": "Sieben", "message": "reads the program", "cancellable": false });
            self.say("$/progress", json!({ "token": token, "value": begin }));
            token
        });
        self.folders.renew(&self.documents);
        if let Some(token) = token {
            self.say("$/progress", json!({ "token": token, "value": { "kind": "end" } }));
        }
    }

    /// Tells the client what is wrong, as far as that is something else than before.
    fn tell(&mut self, tests: Tests) {
        (self.due, self.tests_due) = (None, None);
        let begun = Instant::now();
        let told = survive("diagnostics", || {
            self.diagnose(tests);
            Ok(Value::Null)
        });
        if let Err(error) = told {
            self.log(1, &error.message);
            self.folders.forget();
        }
        if tests == Tests::Typed {
            self.took = begun.elapsed();
            self.tests_due = self.folders.has_old_tests().then(|| Instant::now() + TESTS_WAIT);
        }
    }

    /// What is wrong with all texts.
    pub(super) fn found(&mut self, tests: Tests) -> (Told, Vec<String>) {
        self.renew();
        let mut collecting = Collecting::new(&self.client.telling, &self.documents);
        for (alone, findings, texts) in self.folders.found(&self.documents, tests) {
            collecting.add(alone.as_ref(), &findings, &texts);
        }
        collecting.finish()
    }

    fn diagnose(&mut self, tests: Tests) {
        let (told, homeless) = self.found(tests);
        let changed = std::mem::take(&mut self.changed);
        // Who asks for diagnostics of open texts is told of the others only.
        let is_told = |place: &Place| !(self.client.pulls && self.documents.get(place).is_some());
        let gone = self.told.keys().filter(|place| !told.contains_key(place));
        let empty = Vec::new();
        let mut sent = 0;
        for (place, list) in told.iter().chain(gone.map(|place| (place, &empty))) {
            let is_same = self.told.get(place).unwrap_or(&empty) == list && !changed.contains(place);
            if !is_same && is_told(place) {
                self.publish(place, list);
                sent += 1;
            }
        }
        for place in changed.iter().filter(|place| !told.contains_key(place) && !self.told.contains_key(place)) {
            if self.documents.get(place).is_some() && is_told(place) && !matches!(place, Place::Other(_)) {
                self.publish(place, &empty);
            }
        }
        if self.client.pulls && sent > 0 {
            self.ask("workspace/diagnostic/refresh", Value::Null);
        }
        for message in homeless.iter().filter(|message| !self.told_homeless.contains(message)) {
            self.log(2, message);
        }
        (self.told, self.told_homeless) = (told, homeless);
    }

    fn publish(&self, place: &Place, list: &[Value]) {
        let mut params = json!({ "uri": diagnostics::uri_of(place, &self.documents), "diagnostics": list });
        if let Some(document) = self.documents.get(place) {
            params["version"] = document.version.into();
        }
        self.say("textDocument/publishDiagnostics", params);
    }

    /// An open text; says so if it is not open.
    pub(super) fn document(&self, uri: &str) -> Result<(Place, &Document), ResponseError> {
        let place = Place::of(uri);
        match self.documents.get(&place) {
            Some(document) => Ok((place, document)),
            None => Err(refused(ErrorCode::InvalidParams, format!("`{uri}` is not open"))),
        }
    }

    /// Bytes of an open text as a range.
    pub(super) fn range(&self, document: &Document, start: usize, end: usize) -> Range {
        document.lines().range(document.text(), start, end, self.columns())
    }

    /// The byte of a position in an open text.
    pub(super) fn byte(&self, document: &Document, position: Position) -> usize {
        document.lines().byte(document.text(), position, self.columns())
    }
}
