//! Standard output and standard error. If the reader of a pipe closes the pipe early, this is not an error. A full disk is an error.

use std::fmt::Display;
use std::io::{ErrorKind, Result, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use crate::console::exit_code::INTERNAL_ERROR;
use crate::console::words;

/// Maximum length of a message on standard error, bytes.
const LONGEST_MESSAGE: usize = 2048;

/// Whether a write to standard output has failed.
static STDOUT_FAILED: AtomicBool = AtomicBool::new(false);

/// Prints text and a newline to standard output.
pub fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    record_write_error(writeln!(out, "{text}").and_then(|()| out.flush()));
}

/// Prints a JSON value to standard output.
pub fn print_json(value: &serde_json::Value) {
    print(&serde_json::to_string_pretty(value).unwrap_or_default());
}

/// Prints a message to standard error, shortened to 2 kB. If standard error is closed, nothing is printed.
pub fn report(message: impl Display) {
    let text = message.to_string();
    let shown = shortened(&text, LONGEST_MESSAGE);
    let _ = writeln!(std::io::stderr().lock(), "gaitcam: {shown}");
}

/// Shortens a text of more than `most` bytes to its first `most` bytes and an ellipsis. Characters are not split.
fn shortened(text: &str, most: usize) -> String {
    if text.len() <= most {
        return text.to_string();
    }
    let mut end = most;
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    format!("{} …", &text[..end])
}

/// Records a failure to write to standard output, for the exit code.
pub fn record_write_error(written: Result<()>) {
    if let Err(e) = written
        && !closed_by_reader(&e)
        && !STDOUT_FAILED.swap(true, Ordering::Relaxed)
    {
        let fault = serde_json::json!({"fault": e.to_string()});
        report(words::fill("run-stdout", &fault));
    }
}

/// Whether a write failed because the reader closed the pipe.
fn closed_by_reader(error: &std::io::Error) -> bool {
    // On Windows, a write to a closed pipe can also fail with ERROR_PIPE_NOT_CONNECTED (233), which Rust does not map to `BrokenPipe`.
    error.kind() == ErrorKind::BrokenPipe || cfg!(windows) && error.raw_os_error() == Some(233)
}

/// Exit code of the program: `code`, or the code of an internal error if a write to standard output failed.
pub fn final_exit_code(code: u8) -> u8 {
    if STDOUT_FAILED.load(Ordering::Relaxed) {
        INTERNAL_ERROR
    } else {
        code
    }
}

#[cfg(test)]
mod tests {
    use super::shortened;

    #[test]
    fn long_messages_are_cut_between_characters() {
        assert_eq!(shortened("äöü", 6), "äöü");
        assert_eq!(shortened("äöü", 5), "äö …");
    }
}
