//! How a screen asks a run: at its control socket, or in the same process. It knows no more than any client can.

use std::io::{self, ErrorKind};
use std::sync::Arc;

use serde_json::{Value, json};
use sieben_model::problems::Problem;
use sieben_workspace::Gate;
use sieben_workspace::control::{Control, CurrentFacts};
use sieben_workspace::status::Desk;

use crate::control::Client;

/// Answers the requests of the control socket.
pub(crate) trait Asks {
    /// Asks and waits for the answer.
    ///
    /// # Errors
    /// The run is over ([`ErrorKind::UnexpectedEof`]), or does not answer.
    fn ask(&mut self, verb: &str, fields: &Value) -> io::Result<Value>;
}

impl Asks for Client {
    fn ask(&mut self, verb: &str, fields: &Value) -> io::Result<Value> {
        Client::ask(self, verb, fields).map_err(|error| match error.kind() {
            ErrorKind::BrokenPipe | ErrorKind::ConnectionReset => ErrorKind::UnexpectedEof.into(),
            _ => error,
        })
    }
}

/// The run of this process, asked as a client asks.
pub(crate) struct Direct {
    gate: Arc<Gate>,
    desk: Arc<Desk>,
    control: Control,
}

impl Direct {
    /// A client of this run.
    pub(crate) fn new(gate: &Arc<Gate>, desk: &Arc<Desk>, facts: &Arc<CurrentFacts>) -> Self {
        Self { gate: Arc::clone(gate), desk: Arc::clone(desk), control: Control::new(Arc::clone(facts)) }
    }
}

impl Asks for Direct {
    fn ask(&mut self, verb: &str, fields: &Value) -> io::Result<Value> {
        let mut request = json!({ "verb": verb });
        for (key, value) in fields.as_object().into_iter().flatten() {
            request[key] = value.clone();
        }
        let answer = self.control.answer_line(&self.gate, &self.desk, request.to_string().as_bytes());
        serde_json::from_str(&answer).map_err(io::Error::other)
    }
}

/// Why a request was refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Refused {
    /// The code of the problem.
    pub(crate) code: String,
    /// What is wrong.
    pub(crate) message: String,
}

impl Refused {
    /// The refusal that an answer, or an item of one, has.
    pub(crate) fn of(answer: &Value) -> Option<Self> {
        let text = |key: &str| answer["error"][key].as_str().unwrap_or_default().to_owned();
        answer.get("error").map(|_| Self { code: text("code"), message: text("message") })
    }
}

/// What was asked for, or why it was refused. A run that is over is an error of the connection.
pub(crate) fn asked(asks: &mut dyn Asks, verb: &str, fields: &Value) -> io::Result<Result<Value, Refused>> {
    let answer = asks.ask(verb, fields)?;
    match Refused::of(&answer) {
        Some(refused) if refused.code == Problem::P7094.code() => Err(ErrorKind::UnexpectedEof.into()),
        Some(refused) => Ok(Err(refused)),
        None => Ok(Ok(answer)),
    }
}
