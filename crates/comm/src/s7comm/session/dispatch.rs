//! What is done about a message, and how the answer of the CPU becomes one.

use super::events::{self, Event, What};
use super::input::Arrived;
use super::passwords::Password;
use super::queue::{Due, Form, Task, Work};
use super::shared::Shared;
use super::transfers::{Incoming, Step};
use super::{Session, Stage};
use crate::s7comm::guard::{Function, Legitimation};
use crate::s7comm::job::{Job, Reply};
use crate::s7comm::wire::codes::Refusal;
use crate::s7comm::wire::header::{self, Kind, Message};
use crate::s7comm::wire::security::{self, PasswordRequest};
use crate::s7comm::wire::transfer::{self, function};
use crate::s7comm::wire::userdata::{self, Address, Content, group};
use crate::s7comm::wire::{blocks, clock, services, setup, system_status, variables};

/// Subfunctions of cyclic data: begin, begin on change, end, change.
const CYCLIC_BEGIN: u8 = 1;
const CYCLIC_BEGIN_ON_CHANGE: u8 = 5;
const CYCLIC_END: u8 = 4;
const CYCLIC_CHANGE: u8 = 7;

impl Session {
    /// Takes a message: it is answered, or its job waits in the queue.
    pub(super) fn message(&mut self, bytes: Vec<u8>, shared: &mut Shared, now_us: u64) {
        let message = match header::read(&bytes) {
            Err(_) => return self.end(),
            Ok(Err(misfit)) => return self.queue.push(misfit.reference, Work::Answer(header::refuse(misfit.reference, misfit.refusal))),
            Ok(Ok(message)) => message,
        };
        let begins = message.kind == Kind::Job && message.parameters.first() == Some(&setup::FUNCTION);
        if begins && !self.queue.is_empty() {
            self.barrier = Some(Arrived::Message(bytes));
            return;
        }
        let reference = message.reference;
        let pdu_bytes = match self.stage {
            Stage::Ready { pdu_bytes, .. } => pdu_bytes,
            _ if begins => usize::from(setup::PDU_BYTES_MAX),
            _ => return self.end(),
        };
        if bytes.len() > pdu_bytes && matches!(message.kind, Kind::Job | Kind::Userdata) {
            shared.requests.count(Function::Other);
            return self.queue.push(reference, Work::Answer(header::refuse(reference, Refusal::WrongFrame)));
        }
        match message.kind {
            Kind::Job => {
                let work = self.job(&message, pdu_bytes, shared, now_us);
                let work = work.unwrap_or_else(|refusal| Work::Answer(header::refuse(reference, refusal)));
                self.queue.push(reference, work);
            }
            Kind::Userdata => {
                let work = self.userdata(&message, pdu_bytes, shared, now_us);
                let work = work.unwrap_or_else(|refusal| Work::Answer(header::refuse(reference, refusal)));
                self.queue.push(reference, work);
            }
            Kind::Ack | Kind::AckData => self.answered(&message, now_us),
        }
    }

    /// A job of the first kind.
    fn job(&mut self, message: &Message<'_>, pdu_bytes: usize, shared: &mut Shared, now_us: u64) -> Result<Work, Refusal> {
        let Message { reference, parameters, .. } = *message;
        let &code = parameters.first().ok_or(Refusal::WrongFrame)?;
        // What cannot be read is counted as well, and what is no job for the gate.
        let mut count = |function| shared.requests.count(function);
        let (job, form) = match code {
            setup::FUNCTION => {
                count(Function::Setup);
                return self.set_up(message, shared);
            }
            variables::READ => {
                count(Function::Read);
                (Job::Read(variables::read_request(parameters, pdu_bytes)?), Form::Variables)
            }
            variables::WRITE => {
                count(Function::Write);
                (Job::Write(variables::write_request(parameters, message.data)?), Form::Variables)
            }
            services::SERVICE | services::STOP => {
                let job = services::read(parameters).inspect_err(|_| count(Function::Other))?;
                count(Function::of(&job));
                (job, Form::Service)
            }
            function::START_UPLOAD => {
                count(Function::Upload);
                let name = transfer::read_start_upload(parameters)?;
                self.uploads.has_room(now_us)?;
                (Job::Upload(name), Form::Upload)
            }
            function::UPLOAD => return Ok(Work::Answer(self.uploads.next(reference, parameters, pdu_bytes, now_us))),
            function::END_UPLOAD => return Ok(Work::Answer(self.uploads.end(reference, parameters))),
            function::REQUEST_DOWNLOAD => {
                count(Function::Download);
                return self.begin_download(message, shared, now_us);
            }
            _ => {
                count(Function::Other);
                return Err(Refusal::NotImplemented);
            }
        };
        Ok(Work::Job { job, form })
    }

    fn set_up(&mut self, message: &Message<'_>, shared: &mut Shared) -> Result<Work, Refusal> {
        let (Stage::Connected { tpdu_bytes } | Stage::Ready { tpdu_bytes, .. }) = self.stage else { return Err(Refusal::WrongSequence) };
        let agreed = setup::read(message.parameters)?.agreed(self.rules.cpu, tpdu_bytes);
        self.stage = Stage::Ready { tpdu_bytes, pdu_bytes: usize::from(agreed.pdu_bytes) };
        self.event(shared, message.reference, What::Setup(agreed.pdu_bytes), 0);
        Ok(Work::Answer(header::answer(message.reference, &agreed.write(), &[])))
    }

    fn begin_download(&mut self, message: &Message<'_>, shared: &mut Shared, now_us: u64) -> Result<Work, Refusal> {
        let announced = transfer::read_request_download(message.parameters)?;
        if self.download.as_ref().is_some_and(|download| !download.is_given_up(now_us)) {
            return Err(Refusal::NoResource);
        }
        let reference = self.next_own_reference();
        let judged = self
            .rules
            .judge_download(announced.name, self.legitimation)
            .and_then(|()| Incoming::new(announced, &self.rules, reference, now_us));
        let download =
            judged.inspect_err(|refusal| self.event(shared, message.reference, What::Download(announced.name), refusal.code()))?;
        let ask = download.ask();
        self.download = Some(download);
        // The answer, and after it the first question of the CPU.
        self.queue.push(message.reference, Work::Answer(header::answer(message.reference, &[function::REQUEST_DOWNLOAD], &[])));
        Ok(Work::Answer(ask))
    }

    /// An answer of the client to a job of the CPU.
    fn answered(&mut self, message: &Message<'_>, now_us: u64) {
        let Some(mut download) = self.download.take() else { return };
        let reference = self.next_own_reference();
        match download.answered(message, reference, now_us) {
            Step::Nothing => self.download = Some(download),
            Step::Ask(job) => {
                self.download = Some(download);
                self.send(&job, now_us);
            }
            Step::Complete(block) => {
                self.download = Some(download);
                self.queue.push(reference, Work::Job { job: Job::Download(block), form: Form::Download });
            }
            Step::Over => {}
        }
    }

    /// A request of the second kind.
    fn userdata(&mut self, message: &Message<'_>, pdu_bytes: usize, shared: &mut Shared, now_us: u64) -> Result<Work, Refusal> {
        let reference = message.reference;
        let request = userdata::read(message).inspect_err(|_| shared.requests.count(Function::Other))?;
        let address = request.address;
        let refuse = |refusal| Ok(Work::Answer(userdata::refuse(reference, address, refusal)));
        if request.form == userdata::Form::Next {
            return Ok(Work::Answer(self.remainders.next(reference, address, pdu_bytes, now_us)));
        }
        let data = match request.data {
            Ok(data) => data,
            Err(refusal) => {
                shared.requests.count(Function::Other);
                return refuse(refusal);
            }
        };
        let job = match (address.group, address.subfunction) {
            (group::BLOCKS, subfunction) => blocks::read(subfunction, data),
            (group::CLOCK, subfunction) => clock::read(subfunction, data),
            (group::CPU, subfunction) => system_status::read(subfunction, data),
            (group::SECURITY, subfunction) => {
                shared.requests.count(Function::Password);
                return match security::read(subfunction, data) {
                    Ok(request) => Ok(Work::Password { request, address }),
                    Err(refusal) => refuse(refusal),
                };
            }
            // Variable status, force and cyclic data do not exist here.
            (group::TEST, _) => Err(Refusal::TestNotSupported),
            (group::CYCLIC, CYCLIC_BEGIN | CYCLIC_BEGIN_ON_CHANGE) => Err(Refusal::TooManyCyclicJobs),
            (group::CYCLIC, CYCLIC_END | CYCLIC_CHANGE) => Err(Refusal::NoCyclicJob),
            _ => Err(Refusal::NotImplemented),
        };
        match job {
            Ok(job) => {
                shared.requests.count(Function::of(&job));
                Ok(Work::Job { job, form: Form::Userdata(address) })
            }
            Err(refusal) => {
                shared.requests.count(Function::Other);
                refuse(refusal)
            }
        }
    }

    /// Answers what is first in the queue, as long as it needs no CPU.
    pub(super) fn advance(&mut self, shared: &mut Shared, now_us: u64) {
        while let Some(Task { reference, work }) = self.queue.pop() {
            match work {
                Work::Answer(answer) => self.send(&answer, now_us),
                Work::Held(answer, until_us) if now_us >= until_us => self.send(&answer, now_us),
                Work::Password { request, address } => {
                    let work = self.password(reference, request, address, shared, now_us);
                    self.queue.put_back(reference, work);
                }
                Work::Job { job, form } => {
                    // The audit log keeps what the rules take out of it.
                    let asked = (matches!(job, Job::Write(_)) && self.rules.limit_writes()).then(|| job.clone());
                    let mut job = job;
                    match self.rules.judge(&mut job, self.legitimation) {
                        Ok(()) => {
                            if let Some(asked) = asked {
                                events::refused_items(self.peer, reference, &asked, &job, &mut shared.events);
                            }
                            self.queue.put_back(reference, Work::Ready { job, form });
                            return;
                        }
                        Err(refusal) => self.refused(reference, &job, form, refusal, shared, now_us),
                    }
                }
                Work::Pending { job, form, pending, until_us, look_us, is_due } => {
                    let is_due = if now_us >= look_us.min(until_us) { Due::Now } else { is_due };
                    return self.queue.put_back(reference, Work::Pending { job, form, pending, until_us, look_us, is_due });
                }
                work => return self.queue.put_back(reference, work),
            }
        }
    }

    /// Refuses a job that was not done.
    fn refused(&mut self, reference: u16, job: &Job, form: Form, refusal: Refusal, shared: &mut Shared, now_us: u64) {
        let reply = Reply::Refused(refusal);
        events::of(self.peer, reference, None, job, &reply, &mut shared.events);
        let answer = self.answer(reference, job, form, reply, now_us);
        self.send(&answer, now_us);
    }

    fn password(&mut self, reference: u16, request: PasswordRequest, address: Address, shared: &mut Shared, now_us: u64) -> Work {
        let done = userdata::answer(reference, address, userdata::Place::default(), &[]);
        let (tried, expected) = match (request, self.rules.password) {
            (PasswordRequest::Clear, _) => {
                self.legitimation = Legitimation::None;
                self.event(shared, reference, What::PasswordCleared, 0);
                return Work::Answer(done);
            }
            (PasswordRequest::Enter(_), None) => {
                self.event(shared, reference, What::Password, Refusal::NoPasswordNeeded.code());
                return Work::Answer(userdata::refuse(reference, address, Refusal::NoPasswordNeeded));
            }
            (PasswordRequest::Enter(tried), Some(expected)) => (tried, expected),
        };
        // All eight characters are compared, so that the time says nothing about how many are right.
        let differing = tried.iter().zip(expected).fold(0, |differing, (tried, expected)| differing | (tried ^ expected));
        let found = if differing == 0 { Password::Right } else { Password::Wrong };
        let Some(until_us) = shared.passwords.answered_us(self.peer.ip(), found, now_us) else {
            self.event(shared, reference, What::Password, Refusal::NoResource.code());
            return Work::Answer(userdata::refuse(reference, address, Refusal::NoResource));
        };
        match found {
            Password::Right => {
                self.legitimation = Legitimation::Password;
                self.event(shared, reference, What::Password, 0);
                Work::Held(done, until_us)
            }
            Password::Wrong => {
                self.event(shared, reference, What::Password, Refusal::WrongPassword.code());
                Work::Held(userdata::refuse(reference, address, Refusal::WrongPassword), until_us)
            }
        }
    }

    /// The message that answers a job.
    pub(super) fn answer(&mut self, reference: u16, job: &Job, form: Form, reply: Reply, now_us: u64) -> Vec<u8> {
        let pdu_bytes = match self.stage {
            Stage::Ready { pdu_bytes, .. } => pdu_bytes,
            _ => usize::from(setup::PDU_BYTES_MAX),
        };
        match (form, job, reply) {
            (Form::Download, _, reply) => {
                let error = match reply {
                    Reply::Done => None,
                    Reply::Refused(refusal) => Some(refusal),
                    _ => Some(Refusal::CannotPerform),
                };
                match &mut self.download {
                    Some(download) => download.stored(error, now_us),
                    None => Vec::new(),
                }
            }
            (Form::Userdata(address), _, Reply::Refused(refusal)) => userdata::refuse(reference, address, refusal),
            (_, _, Reply::Refused(refusal)) => header::refuse(reference, refusal),
            (Form::Variables, Job::Read(items), Reply::Values(values)) => {
                // A job that was read has at most 255 variables.
                header::answer(reference, &[variables::READ, items.len() as u8], &variables::values(items, &values))
            }
            (Form::Variables, Job::Write(_), Reply::Written(codes)) => {
                let data: Vec<u8> = codes.iter().map(|code| code.code()).collect();
                header::answer(reference, &[variables::WRITE, codes.len() as u8], &data)
            }
            (Form::Service, job, reply) => {
                let (error, parameters) = services::write(job, &reply);
                match error {
                    Some(refusal) if parameters.is_empty() => header::refuse(reference, refusal),
                    error => {
                        let error = error.map_or(0, Refusal::code);
                        header::write(&Message { kind: Kind::AckData, reference, error, parameters: &parameters, data: &[] })
                    }
                }
            }
            (Form::Upload, _, Reply::Image(image)) => self.uploads.start(reference, image, now_us),
            (Form::Userdata(address), job, reply) => match content(job, &reply) {
                Ok(content) => self.remainders.answer(reference, address, content, pdu_bytes, now_us),
                Err(refusal) => userdata::refuse(reference, address, refusal),
            },
            _ => header::refuse(reference, Refusal::CannotPerform),
        }
    }

    fn event(&self, shared: &mut Shared, pdu_reference: u16, what: What, error: u16) {
        shared.events.push(Event { peer: self.peer, pdu_reference, scan: None, what, error });
    }
}

/// The data of the answer to a job of the second kind.
fn content(job: &Job, reply: &Reply) -> Result<Content, Refusal> {
    match job {
        Job::SystemStatus { .. } => system_status::write(job, reply),
        Job::Clock | Job::SetClock(_) => clock::write(job, reply),
        _ => blocks::write(job, reply),
    }
}
