//! The server for S7 communication: one thread that reads and writes all sockets, and enters the gate once for all jobs that have come.

mod connection;
mod event_loop;
mod sockets;
mod view;

use std::io;
use std::net::{SocketAddr, TcpListener};
use std::os::fd::OwnedFd;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

use rustix::event::EventfdFlags;
use sieben_cpu::Communication;
use sieben_model::cpu_type::CpuType;
use sieben_workspace::Gate;

use crate::config::Config;
use crate::recording::Recorders;
use crate::s7comm::session::Shared;
use event_loop::EventLoop;
pub use view::{ConnectionView, Counters, View, Written};

/// The time of the computer in microseconds since 1970, for what is recorded.
pub type WallClock = Box<dyn Fn() -> u64 + Send>;

/// What a server has from those who start it.
pub struct Setup {
    /// What it does and allows.
    pub config: Config,
    /// What all its sessions share.
    pub shared: Shared,
    /// What the CPU is called for those who ask it.
    pub names: Communication,
    /// Where what happens is noted.
    pub recorders: Recorders,
    /// The time, for what is recorded.
    pub clock: WallClock,
}

/// A server that runs; when this is dropped, its connections are closed in order.
pub struct Server {
    address: SocketAddr,
    common: Arc<Common>,
    thread: Option<JoinHandle<()>>,
}

/// What the thread and those who look at it share.
struct Common {
    view: Mutex<View>,
    ends: AtomicBool,
    /// Written to: the thread looks up.
    wake: OwnedFd,
}

impl Common {
    fn view(&self) -> std::sync::MutexGuard<'_, View> {
        self.view.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Listens at an address.
///
/// # Errors
/// Another program listens there, or this process may not.
pub fn listen(address: SocketAddr) -> io::Result<TcpListener> {
    TcpListener::bind(address)
}

impl Server {
    /// Serves the CPU of this type on the other side of the gate, in a thread of its own.
    ///
    /// # Errors
    /// The system has no room for the thread or its handles.
    pub fn start(listener: TcpListener, cpu: &'static CpuType, gate: Arc<Gate>, setup: Setup) -> io::Result<Self> {
        let address = listener.local_addr()?;
        let wake = rustix::event::eventfd(0, EventfdFlags::CLOEXEC | EventfdFlags::NONBLOCK)?;
        let common = Arc::new(Common { view: Mutex::default(), ends: AtomicBool::default(), wake });
        let mut event_loop = EventLoop::new(listener, cpu, gate, setup, Arc::clone(&common))?;
        let thread = std::thread::Builder::new().name("s7".to_owned()).spawn(move || event_loop.run())?;
        Ok(Self { address, common, thread: Some(thread) })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Its connections, and what it has counted.
    pub fn view(&self) -> View {
        self.common.view().clone()
    }

    /// A look at it that outlives it.
    pub fn viewer(&self) -> Viewer {
        Viewer(Arc::clone(&self.common))
    }

    /// Closes all connections in order, and waits until that is done: a second at most.
    pub fn end(&mut self) -> View {
        self.common.ends.store(true, Ordering::Release);
        // It fails only if the thread has been woken already.
        let _ = rustix::io::write(&self.common.wake, &1_u64.to_ne_bytes());
        if let Some(thread) = self.thread.take() {
            // A panic of the thread was reported where it happened.
            let _ = thread.join();
        }
        self.view()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.end();
    }
}

/// A look at a server.
#[derive(Clone)]
pub struct Viewer(Arc<Common>);

impl Viewer {
    /// Its connections, and what it has counted.
    pub fn view(&self) -> View {
        self.0.view().clone()
    }
}
