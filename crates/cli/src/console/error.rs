//! Errors of the command-line program: wrong files, flags and folders. Their messages are in `words/`.

use serde::Serialize;
use strum::VariantNames;

use crate::console::words;
use gaitcam::error::Fault;
use gaitcam::wording::Catalogue;

/// Errors of the command-line program. Text fields contain input of the user or messages of the operating system.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
// `NoParquet` is used only in builds without Parquet.
#[cfg_attr(feature = "parquet", allow(dead_code))]
pub enum CliError {
    CannotOpen { fault: String },
    SceneName { shown: String, fault: NameFault },
    FewRows { rows: u32, least: u32 },
    CycleEnding { file: String },
    NotStances { file: String },
    StancesOfSeveral { table: String },
    TableChanged,
    Cams { typed: String, most: usize },
    AmongRecordings { folder: String },
    NotCover,
    SceneNotRecording,
    RecordingNotScene,
    NoKeyContains { pattern: String },
    InputTime { limit: String },
    NoModel { typed: String },
    Speeds { typed: String, most: usize },
    CamIsMade { key: String },
    BrokenTable { fault: String },
    FieldNotNumber,
    EmptyTable,
    NoBlocks,
    NotSweepTable { column: String },
    NoParquet,
    TableEnding { file: String },
    NoBaseScene,
    RowNotNumber { row: u64, cell: String },
    NothingVaries,
    ListCell,
    ListValue { fault: String },
    EmptyList,
    NoRecordings { endings: String },
    NotRecordings { files: usize, endings: String },
    ManyRows { rows: String },
    ScatterCsv,
    TooManySamples { count: String, most: String },
    NoSample,
    PartialRows { rows: u64 },
    NotPartial,
    RowsSafe { fault: String, rows: u64 },
    AllRowsSafe { fault: String },
    CannotRepair { fault: String },
    FileIsThere,
    UnknownFlag { near: Option<String> },
    OneTooMany,
    UnknownVerb { typed: String, near: Option<String> },
    InLab { typed: String },
    FlagWithoutValue,
    FlagChoice { typed: String, choices: String },
    FlagValue { typed: String, fault: String },
    FlagWhole { typed: String },
    FlagRange { typed: String, range: String },
    MissingArguments { missing: String, choices: String },
    FlagConflict { other: String },
    FlagCount,
    Arguments { fault: String },
    NegativeBall { typed: String },
    NoWalk,
    NothingToWalk,
    VariesTooMuch { most: String },
    StridesMissing { count: usize, recorded: usize },
    FewStrides { strides: usize, needed: usize },
    ClippedWalk,
    ProgrammeColumn { column: String },
}

/// Reasons why a scene's name cannot be a folder name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NameFault {
    Blank,
    Dash,
    Control,
    NotPlain,
}

impl Fault for CliError {
    const AREA: &'static str = "cli";
    const WORDS: &'static Catalogue = &words::WORDS;
}
