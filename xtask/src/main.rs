//! Tasks of the project: `cargo xtask TASK`.
#![forbid(unsafe_code)]
#![allow(clippy::print_stdout)] // A task talks to the person who started it.

use std::process::ExitCode;

use xtask::{aarch64, ablate, clients, fuzz, generate, soak, test, tidy, vscode, web};

const USAGE: &str = "usage: cargo xtask TASK

  test [ARGUMENTS]      build everything and run all tests (arguments go to the test runner)
  test --all            the same, after `clients`; then the tests of the page and of the
                        extension for VS Code in Chromium
  clients               install other people's S7 clients below target/clients/, for the tests
  web                   build the page of the workbench into crates/workbench/dist
  web --check           whether crates/workbench/dist is what its sources build
  web --test [ARGUMENTS]
                        the tests of the page alone (arguments go to Playwright)
  web --bench           measure the page: first paint, size, work for an update
  vsix [--bundle FILE]  build the extension for VS Code into target/, with this binary of Sieben in it
  vsix --test [ARGUMENTS]
                        the tests of the extension alone (arguments go to Playwright)
  screenshots           take the pictures of docs/reference/workbench/ again
  tidy                  check the house rules: arrows, pages, links, words
  generate              write the generated pages again
  fuzz --seconds N      run all fuzz targets for N seconds together
       [--target NAME]  only this one
       [--seed N]       other inputs than the last time
  fuzz --replay TARGET FILE
                        run one target on one input
  aarch64               all programs of the manual as machine code for aarch64, checked and not run
  ablate [NAME,…]       measure what each optimization of the machine code is worth, and write
                        docs/benchmarks/ablation.md
  soak kill [--count N] kill a running program N times (1000) and look at its retentive data
  soak run [--minutes N]
                        run a program for N minutes (60) and watch its memory
  soak page [--minutes N]
                        leave a page open for N minutes (60) and watch its memory
  soak fuzz [--minutes N]
                        all fuzz targets, round after round with other inputs
  soak programs [--times N]
                        N times (10) as many random programs as the tests make";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (task, rest) = match arguments.split_first() {
        Some((task, rest)) => (task.as_str(), rest),
        None => ("help", [].as_slice()),
    };
    let outcome = match task {
        "test" => test::run(rest),
        "clients" => clients::run(),
        "web" => web::run(rest),
        "screenshots" => web::screenshots(rest),
        "vsix" => vscode::run(rest),
        "tidy" => tidy::run(),
        "generate" => generate::run(),
        "fuzz" => fuzz::run(rest),
        "aarch64" => aarch64::run(),
        "ablate" => ablate::run(rest),
        "soak" => soak::run(rest),
        "help" | "--help" | "-h" => {
            println!("{USAGE}");
            Ok(())
        }
        unknown => Err(format!("`{unknown}` is no task\n\n{USAGE}")),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
