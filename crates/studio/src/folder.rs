//! Access to the opened folder. Its files can be read, and new files can be written. Files outside the folder are not accessed.

use std::fs;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::SystemTime;

use serde::Serialize;

use crate::lock;
use gaitcam::error::{Error, Place, Placed, Result};
use gaitcam_app::folder::write_new;
use gaitcam_app::page::fault::StudioError;
use gaitcam_app::page::{Hash, Recent};
use gaitcam_app::read::read_at_most;

/// Hash and content of a file.
type Content = (Hash, Arc<Vec<u8>>);

/// Maximum size of a file that can be read, bytes.
const LARGEST: u64 = 256 << 20;
/// Maximum number of files that are listed. [`DEPTH`] is the maximum number of levels of subfolders.
const LISTED: usize = 500;
const DEPTH: usize = 3;

/// Number of files in the cache. A cached file is used until the file on the disk changes.
const READ: usize = 8;

/// Version of a file: path, size in bytes, and time of the last change.
type Stamp = (PathBuf, u64, Option<SystemTime>);

/// Folder that is opened in the studio.
pub struct Folder {
    root: PathBuf,
    read: Mutex<Recent<Stamp, Content>>,
}

/// File of the folder that the page can open.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Listed {
    /// Path of the file relative to the folder, with `/` as separator.
    pub path: String,
    /// Whether the file is a scene. All other listed files are recordings.
    pub scene: bool,
}

impl Folder {
    /// Opens an existing folder.
    ///
    /// # Errors
    ///
    /// The folder does not exist.
    pub fn open(path: &Path) -> Result<Folder> {
        let root = fs::canonicalize(path).map_err(|e| unread(path, &e))?;
        let read = Mutex::new(Recent::new(READ));
        Ok(Folder { root, read })
    }

    /// Path of the opened folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Real path of a file in the folder, with links resolved.
    ///
    /// # Errors
    ///
    /// The path leads out of the folder (by `..`, from the root, or through a link), or the file does not exist.
    pub fn find(&self, path: &Path) -> Result<PathBuf> {
        let outside = || StudioError::Outside.in_file(path);
        let upwards = path.components().any(|c| c == Component::ParentDir);
        if upwards {
            return Err(outside());
        }
        let found = fs::canonicalize(self.root.join(path)).map_err(|e| unread(path, &e))?;
        if found.starts_with(&self.root) {
            Ok(found)
        } else {
            Err(outside())
        }
    }

    /// Content of a file in the folder.
    ///
    /// # Errors
    ///
    /// An error of [`Folder::find`], a path that is not a regular file, or a file that is too large.
    pub fn read(&self, path: &Path) -> Result<Vec<u8>> {
        let found = self.find(path)?;
        read_at_most(&found, LARGEST).map_err(|e| e.placed(Place::File(path.to_path_buf())))
    }

    /// Content of a file with its hash. Both are cached, because files are requested repeatedly.
    ///
    /// # Errors
    ///
    /// The errors of [`Folder::read`].
    pub fn hashed(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)> {
        let found = self.find(path)?;
        let about = fs::metadata(&found).map_err(|e| unread(path, &e))?;
        let stamp = (found, about.len(), about.modified().ok());
        let known = lock(&self.read).get(&stamp);
        if let Some(known) = known {
            return Ok(known);
        }
        let bytes = self.read(path)?;
        let read = (Hash::of(&bytes), Arc::new(bytes));
        lock(&self.read).put(stamp, read.clone());
        Ok(read)
    }

    /// Rejects a file name that is invalid on one of the platforms, is hidden or contains a folder.
    ///
    /// # Errors
    ///
    /// The file name is invalid.
    pub fn check_name(&self, name: &str) -> Result<()> {
        let plain = !name.is_empty()
            && !name.starts_with('.')
            && !name
                .chars()
                .any(|c| c.is_control() || "/\\:*?\"<>|".contains(c));
        if plain {
            return Ok(());
        }
        let name = name.to_string();
        Err(StudioError::FileName { name }.into())
    }

    /// Writes a new file and returns its name. If a file with the requested name exists, the first free number is added (`walk.toml`,
    /// `walk-2.toml`). Existing files are not replaced.
    ///
    /// # Errors
    ///
    /// The file name is invalid, or the folder is not writable.
    pub fn write_new(&self, name: &str, bytes: &[u8]) -> Result<String> {
        self.check_name(name)?;
        let (stem, ending) = name.rsplit_once('.').unwrap_or((name, "toml"));
        for number in 1.. {
            let name = match number {
                1 => format!("{stem}.{ending}"),
                k => format!("{stem}-{k}.{ending}"),
            };
            let path = self.root.join(&name);
            match write_new(&path, bytes) {
                Ok(()) => return Ok(name),
                Err(e) if e.kind() == std::io::ErrorKind::AlreadyExists => {
                    // If a file of this name has the same content, no second file is written.
                    if self.read(name.as_ref()).is_ok_and(|old| old == bytes) {
                        return Ok(name);
                    }
                }
                Err(e) => {
                    let fault = e.to_string();
                    return Err(
                        Error::from(StudioError::CannotWrite { fault }).at(Place::File(path))
                    );
                }
            }
        }
        Ok(name.to_string())
    }

    /// Scenes and recordings in the folder and its subfolders, in alphabetical order.
    pub fn list(&self) -> Vec<Listed> {
        let mut out = Vec::new();
        self.look(&self.root, 0, &mut out);
        out.sort();
        out
    }

    fn look(&self, folder: &Path, depth: usize, out: &mut Vec<Listed>) {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let (path, name) = (entry.path(), entry.file_name());
            let Ok(kind) = entry.file_type() else {
                continue;
            };
            if out.len() >= LISTED || name.to_string_lossy().starts_with('.') {
                continue;
            }
            if kind.is_dir() && depth < DEPTH && name != "target" && name != "node_modules" {
                self.look(&path, depth + 1, out);
            }
            // Links and pipes are not opened, because reading a pipe may never end.
            if !kind.is_file() {
                continue;
            }
            let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
            let scene = match ending.as_deref() {
                Some("toml") => is_scene(&path),
                Some("c3d" | "mot" | "sto") => false,
                Some("csv" | "txt" | "tsv") if depth == 0 => false,
                _ => continue,
            };
            let recording = path.extension().is_none_or(|e| e != "toml");
            if let (true, Ok(inside)) = (scene || recording, path.strip_prefix(&self.root)) {
                let parts = inside.components().map(|c| c.as_os_str().to_string_lossy());
                let path = parts.collect::<Vec<_>>().join("/");
                out.push(Listed { path, scene });
            }
        }
    }
}

/// Whether a TOML file contains at least one of the tables of a scene.
fn is_scene(path: &Path) -> bool {
    let small = fs::metadata(path).is_ok_and(|m| m.len() < 1 << 20);
    let text = if small {
        fs::read_to_string(path).unwrap_or_default()
    } else {
        String::new()
    };
    let tables = ["[cam]", "[gait]", "[law]", "[drive]", "[limits]"];
    text.lines().any(|line| tables.contains(&line.trim()))
}

fn unread(path: &Path, e: &std::io::Error) -> Error {
    let fault = gaitcam_app::read::fault(e);
    StudioError::CannotRead { fault }.in_file(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_file_never_takes_the_place_of_another() {
        let here = tempfile::tempdir().unwrap();
        let folder = Folder::open(here.path()).unwrap();
        assert_eq!(folder.write_new("a.toml", b"one").unwrap(), "a.toml");
        assert_eq!(folder.write_new("a.toml", b"two").unwrap(), "a-2.toml");
        assert_eq!(folder.write_new("a.toml", b"one").unwrap(), "a.toml");
        assert_eq!(fs::read(here.path().join("a.toml")).unwrap(), b"one");
        assert_eq!(fs::read_dir(here.path()).unwrap().count(), 2);
        for name in ["../a.toml", "a/b.toml", "", ".toml", "a\0.toml", "C:a"] {
            assert!(folder.write_new(name, b"x").is_err(), "{name:?}");
        }
    }

    #[test]
    fn saves_of_one_name_at_once_keep_their_own_text() {
        let here = tempfile::tempdir().unwrap();
        let folder = Folder::open(here.path()).unwrap();
        let save = &|i: usize| {
            let text = format!("scene {i}").repeat(1000);
            let name = folder.write_new("a.toml", text.as_bytes()).unwrap();
            (name, text)
        };
        let saved: Vec<(String, String)> = std::thread::scope(|scope| {
            let threads: Vec<_> = (0..60).map(|i| scope.spawn(move || save(i))).collect();
            threads.into_iter().map(|t| t.join().unwrap()).collect()
        });
        for (name, text) in saved {
            assert_eq!(
                fs::read_to_string(here.path().join(&name)).unwrap(),
                text,
                "{name}"
            );
        }
        assert_eq!(fs::read_dir(here.path()).unwrap().count(), 60);
    }

    #[cfg(unix)]
    #[test]
    fn what_may_never_end_is_neither_listed_nor_read() {
        let here = tempfile::tempdir().unwrap();
        std::os::unix::fs::symlink("/dev/zero", here.path().join("a.toml")).unwrap();
        let made = std::process::Command::new("mkfifo")
            .arg(here.path().join("b.toml"))
            .status();
        assert!(made.unwrap().success());
        fs::write(here.path().join("c.toml"), "[cam]\n").unwrap();
        let folder = Folder::open(here.path()).unwrap();
        let listed: Vec<String> = folder.list().into_iter().map(|l| l.path).collect();
        assert_eq!(listed, ["c.toml"]);
        for name in ["a.toml", "b.toml"] {
            assert!(folder.read(Path::new(name)).is_err());
        }
        assert_eq!(folder.write_new("b.toml", b"x").unwrap(), "b-2.toml");
    }

    #[cfg(unix)]
    #[test]
    fn neither_dots_nor_roots_nor_links_lead_out() {
        let here = tempfile::tempdir().unwrap();
        let (inside, secret) = (here.path().join("open"), here.path().join("secret.csv"));
        fs::create_dir(&inside).unwrap();
        fs::write(&secret, b"secret").unwrap();
        fs::write(inside.join("own.csv"), b"own").unwrap();
        std::os::unix::fs::symlink(&secret, inside.join("link.csv")).unwrap();
        let folder = Folder::open(&inside).unwrap();
        assert_eq!(folder.read(Path::new("own.csv")).unwrap(), b"own");
        for path in [
            "../secret.csv",
            "link.csv",
            "x/../../secret.csv",
            "/etc/passwd",
        ] {
            assert!(folder.read(Path::new(path)).is_err(), "{path}");
        }
    }
}
