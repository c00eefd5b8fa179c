//! `cargo xtask aarch64`: every program of the executable manual as machine code for aarch64, checked by Cranelift and never run.
//!
//! The code generator for a second processor would nearly double the time of every test build, so that it is a feature of this task
//! alone, with a folder of its own below `target/`.

#[cfg(feature = "aarch64")]
pub use check::run;

/// The folder of this build, so that it does not displace the usual one.
#[cfg(not(feature = "aarch64"))]
const FOLDER: &str = "target/aarch64";

/// Builds this task with the other code generator, and runs it.
#[cfg(not(feature = "aarch64"))]
pub fn run() -> Result<(), String> {
    let arguments = ["run", "--quiet", "--package", "xtask", "--features", "aarch64", "--target-dir", FOLDER, "--", "aarch64"];
    match std::process::Command::new("cargo").args(arguments).current_dir(crate::workspace::root()).status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err("some program does not become code for aarch64".to_owned()),
        Err(error) => Err(format!("cargo does not start: {error}")),
    }
}

#[cfg(feature = "aarch64")]
mod check {
    use sieben_engine::Layout;
    use sieben_jit::Jit;
    use sieben_lang::Options;
    use sieben_model::cpu_type::CpuType;
    use sieben_model::diagnostic::Severity;
    use sieben_model::source::Sources;
    use sieben_model::symbols::SymbolTable;

    use crate::{markdown, workspace};

    /// Compiles all programs.
    pub fn run() -> Result<(), String> {
        let (mut programs, mut bytes, mut failures) = (0, 0, Vec::new());
        for file in workspace::text_files(&workspace::root()) {
            let texts: Vec<(usize, String)> = if file.path.starts_with("spec/") && file.path.ends_with(".md") {
                let fences = markdown::read(&file.text).fences.into_iter();
                fences.filter(|fence| fence.language == "stl").map(|fence| (fence.line, fence.text)).collect()
            } else if file.path.ends_with(".awl") && !file.path.starts_with("spec/corpus") {
                vec![(1, file.text.clone())]
            } else {
                continue;
            };
            for (line, text) in texts {
                match compile(&text) {
                    None => {}
                    Some(Ok(found)) => (programs, bytes) = (programs + 1, bytes + found),
                    Some(Err(reason)) => failures.push(format!("{}:{line}: {reason}", file.path)),
                }
            }
        }
        println!("{programs} programs in three tiers, {bytes} bytes of code for aarch64");
        if failures.is_empty() { Ok(()) } else { Err(failures.join("\n")) }
    }

    /// Bytes of code, if the text is a program that compiles.
    fn compile(text: &str) -> Option<Result<usize, String>> {
        let cpu_type = CpuType::by_name("417-4")?;
        let mut sources = Sources::default();
        sources.add("page.awl", text);
        let extended = text.contains("__");
        let mut system_blocks = sieben_cpu::system::interfaces();
        if extended {
            system_blocks.extend(sieben_cpu::system::extension_interfaces());
        }
        let options = Options { cpu: Some(cpu_type), extended, system_blocks, ..Options::default() };
        let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
        if compiled.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error) {
            return None;
        }
        let layout = Layout::new(cpu_type, &compiled.program);
        Some(Jit::check_aarch64(&compiled.program, &layout))
    }
}
