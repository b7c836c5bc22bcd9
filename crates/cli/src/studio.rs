//! `gaitcam studio`: local web application in which a cam is redesigned after every change.

use std::path::PathBuf;
use std::process::{Command, Stdio, exit};

use clap::Args;

use crate::console::exit_code::BUILT;
use crate::console::language;
use crate::console::terminal::print;
use gaitcam::error::Result;
use gaitcam_studio::{Options, open};

const EXAMPLES: &str = "Examples:
  gaitcam studio
  gaitcam studio scenes/heel_tester.toml
  gaitcam studio measurements/ --port 8080 --no-open";

/// Arguments of `gaitcam studio`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct StudioArgs {
    /// Scene file, folder with scenes and recordings, or name of a built-in scene
    #[arg(value_name = "SCENE|DIR")]
    open: Option<PathBuf>,
    /// Port of the page (default: a free one)
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    port: u16,
    /// Only print the address; do not open a browser
    #[arg(long)]
    no_open: bool,
}

/// Prints the address and serves the page until the user interrupts the program.
pub fn run(args: &StudioArgs) -> Result<u8> {
    let ready = open(&Options {
        open: args.open.clone(),
        port: args.port,
        language: language::given(),
    })?;
    // A panic ends only one response. Its message is printed in the terminal.
    let _ = std::panic::take_hook();
    // No file is half written between two requests, so Ctrl-C is the normal way to end the program.
    let _ = ctrlc::set_handler(|| exit(i32::from(BUILT)));
    print(&ready.url());
    if !args.no_open {
        show(&ready.url());
    }
    ready.serve()
}

/// Opens the page in the default browser. If this fails, there is no error, because the address is printed.
fn show(url: &str) {
    let (program, before): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        ("cmd", &["/C", "start", ""])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(before).arg(url);
    let quiet = command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let _ = quiet.spawn();
}
