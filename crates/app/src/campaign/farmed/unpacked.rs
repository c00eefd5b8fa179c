//! A campaign that came as bytes, unpacked into a folder of its own.

use std::cell::Cell;
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use sieben_campaign::packed::Packed;
use sieben_lang::encoding::Encoding;
use sieben_model::problems::Problem;
use sieben_workspace::campaign::Files;
use sieben_workspace::project::Project;
use sieben_workspace::refusal::Refusal;

use crate::project;

/// The files of a campaign; its folder goes with it.
pub(super) struct Unpacked<'a> {
    folder: PathBuf,
    packed: &'a Packed,
    /// How many programs were unpacked.
    unpacked: Cell<usize>,
}

impl<'a> Unpacked<'a> {
    /// Makes the folder.
    pub(super) fn new(packed: &'a Packed) -> std::io::Result<Self> {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        let name = format!("sieben-worker-{}-{}", std::process::id(), NUMBER.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(name);
        fs::create_dir(&folder)?;
        Ok(Self { folder, packed, unpacked: Cell::new(0) })
    }

    fn unpack(&self, path: &str) -> std::io::Result<PathBuf> {
        // A program is called by its place among those of the campaign: its own name may be anything.
        let place = self.folder.join(self.unpacked.replace(self.unpacked.get() + 1).to_string());
        fs::create_dir(&place)?;
        for (name, text) in self.packed.bundle.files() {
            let Some(name) = name.strip_prefix(path).and_then(|name| name.strip_prefix('/')) else { continue };
            // Whatever it was called, it stays below this folder.
            let inner: PathBuf = Path::new(name).components().filter(|part| matches!(part, Component::Normal(_))).collect();
            let to = place.join(inner);
            if let Some(parent) = to.parent() {
                fs::create_dir_all(parent)?;
            }
            fs::write(to, text)?;
        }
        Ok(place)
    }
}

impl Files for Unpacked<'_> {
    fn project(&self, path: &str) -> Result<Project, Refusal> {
        let place = self.unpack(path).map_err(|error| Refusal::new(Problem::P6013, format!("the program cannot be unpacked: {error}")))?;
        project::load(&[place], Encoding::from_name("utf-8")).map_err(|failure| failure.refusal)
    }

    fn text(&self, path: &str) -> Result<String, Refusal> {
        let found = self.packed.bundle.files().find(|(name, _)| *name == path);
        found
            .map(|(_, text)| text.to_owned())
            .ok_or_else(|| Refusal::new(Problem::P7163, format!("the campaign does not bring `{path}` along")))
    }
}

impl Drop for Unpacked<'_> {
    fn drop(&mut self) {
        // It lies in the folder for temporary files: what stays there does no harm.
        let _ = fs::remove_dir_all(&self.folder);
    }
}
