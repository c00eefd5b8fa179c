//! The server: a thread with a runtime of its own, one that looks at the CPU, and one that replays scans.

use std::io;
use std::net::{SocketAddr, TcpListener};
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;

use sieben_workspace::Gate;
use sieben_workspace::control::CurrentFacts;
use sieben_workspace::status::Desk;
use tokio::sync::{Semaphore, oneshot};

use crate::access::Access;
use crate::http::{self, Limits};
use crate::hub::Hub;
use crate::projects::Projects;
use crate::reference::Reference;

/// Threads that wait for the CPU on behalf of requests.
const WAITING_THREADS_MAX: usize = 16;
/// Questions about many scans of the past that are answered at a time; those of pages wait.
pub(crate) const QUESTIONS_MAX: usize = 4;
/// How long pages get to hear of the end.
const FAREWELL: Duration = Duration::from_millis(200);

/// Makes the numbers of the run as text; `None` at its end.
pub type MetricsText = Box<dyn Fn() -> Option<String> + Send + Sync>;

/// What a server serves, and to whom.
pub struct Setup {
    /// The way in to the CPU.
    pub gate: Arc<Gate>,
    /// Where the status of scans is asked for.
    pub desk: Arc<Desk>,
    /// What is known of the program.
    pub facts: Arc<CurrentFacts>,
    /// Answers questions about the program as a whole.
    pub reference: Box<dyn Reference>,
    /// The project, what may run instead, and the files beside its program.
    pub projects: Arc<dyn Projects>,
    /// The numbers of the run.
    pub metrics: MetricsText,
    /// Who is answered.
    pub access: Access,
}

/// What all requests share.
pub(crate) struct Shared {
    pub(crate) hub: Arc<Hub>,
    pub(crate) access: Access,
    pub(crate) reference: Arc<dyn Reference>,
    pub(crate) projects: Arc<dyn Projects>,
    pub(crate) metrics: MetricsText,
    pub(crate) limits: Limits,
    /// One for each question about many scans of the past.
    pub(crate) questions: Semaphore,
}

/// A server of the page, until this is dropped.
pub struct Page {
    address: SocketAddr,
    hub: Arc<Hub>,
    end: Option<oneshot::Sender<()>>,
    threads: Vec<JoinHandle<()>>,
}

/// Listens at an address.
///
/// # Errors
/// Another program listens there, or this process may not.
pub fn listen(address: SocketAddr) -> io::Result<TcpListener> {
    TcpListener::bind(address)
}

impl Page {
    /// Serves pages in threads of its own.
    ///
    /// # Errors
    /// The system has no room for the threads or their handles.
    pub fn start(listener: TcpListener, setup: Setup) -> io::Result<Self> {
        let Setup { gate, desk, facts, reference, projects, metrics, mut access } = setup;
        let address = listener.local_addr()?;
        access.listen = address;
        listener.set_nonblocking(true)?;
        let reference: Arc<dyn Reference> = Arc::from(reference);
        let hub = Arc::new(Hub::new(gate, desk, facts, Arc::clone(&reference)));
        hub.desk.past().keep();
        let authors = Arc::clone(&hub.authors);
        hub.facts.add_listener(Box::new(move |peer, changes| authors.note(peer, changes)));
        hub.desk.set_onlooker(Arc::clone(&hub) as Arc<dyn sieben_workspace::status::Onlooker>);
        let shared = Arc::new(Shared {
            hub: Arc::clone(&hub),
            access,
            reference,
            projects,
            metrics,
            limits: Limits::default(),
            questions: Semaphore::new(QUESTIONS_MAX),
        });
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().max_blocking_threads(WAITING_THREADS_MAX).build()?;
        let (end, ends) = oneshot::channel();
        let spawn = |name: &str, body: Box<dyn FnOnce() + Send>| std::thread::Builder::new().name(name.to_owned()).spawn(body);
        let serve = move || {
            runtime.block_on(serve(listener, shared, ends));
            runtime.shutdown_timeout(FAREWELL);
        };
        let (looking, replaying) = (Arc::clone(&hub), Arc::clone(&hub));
        let mut page = Self { address, hub, end: Some(end), threads: Vec::new() };
        page.threads.push(spawn("page", Box::new(serve))?);
        page.threads.push(spawn("page look", Box::new(move || looking.watch()))?);
        // Where another thread replays already, this one ends at once.
        page.threads.push(spawn("page replay", Box::new(move || replaying.desk.replay(|| replaying.is_over())))?);
        Ok(page)
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        self.hub.end();
        if let Some(end) = self.end.take() {
            // It has ended already if nothing hears this.
            let _ = end.send(());
        }
        for thread in self.threads.drain(..) {
            // A panic of the thread was reported where it happened.
            let _ = thread.join();
        }
    }
}

async fn serve(listener: TcpListener, shared: Arc<Shared>, ends: oneshot::Receiver<()>) {
    let Ok(listener) = tokio::net::TcpListener::from_std(listener) else { return };
    tokio::select! {
        () = http::serve(listener, shared) => {}
        _ = ends => tokio::time::sleep(FAREWELL).await,
    }
}
