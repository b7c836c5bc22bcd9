//! Tables by the Arrow C data interface, without copies.
//!
//! Written out by hand: three structs and the layout of three kinds of columns (64-bit numbers, row numbers, words by a
//! dictionary) against a tree of crates that doubles the build. Specification: Apache Arrow, "The Arrow C data
//! interface" and "The Arrow PyCapsule Interface".

use std::ffi::{CString, c_char, c_int, c_void};
use std::ptr::null_mut;
use std::sync::Arc;

use gaitcam::sweep::{Field, FieldValues, Words};

use crate::table::Data;

const NULLABLE: i64 = 2;

/// `struct ArrowSchema`.
#[repr(C)]
pub struct Schema {
    format: *const c_char,
    name: *const c_char,
    metadata: *const c_char,
    flags: i64,
    n_children: i64,
    children: *mut *mut Schema,
    dictionary: *mut Schema,
    release: Option<unsafe extern "C" fn(*mut Schema)>,
    private: *mut c_void,
}

/// `struct ArrowArray`.
#[repr(C)]
pub struct Array {
    length: i64,
    null_count: i64,
    offset: i64,
    n_buffers: i64,
    n_children: i64,
    buffers: *mut *const c_void,
    children: *mut *mut Array,
    dictionary: *mut Array,
    release: Option<unsafe extern "C" fn(*mut Array)>,
    private: *mut c_void,
}

/// `struct ArrowArrayStream`.
#[repr(C)]
pub struct Stream {
    get_schema: Option<unsafe extern "C" fn(*mut Stream, *mut Schema) -> c_int>,
    get_next: Option<unsafe extern "C" fn(*mut Stream, *mut Array) -> c_int>,
    get_last_error: Option<unsafe extern "C" fn(*mut Stream) -> *const c_char>,
    release: Option<unsafe extern "C" fn(*mut Stream)>,
    private: *mut c_void,
}

// SAFETY: what the pointers lead to is owned by the struct alone, or read only behind an `Arc`.
unsafe impl Send for Schema {}
// SAFETY: as for `Schema`.
unsafe impl Send for Array {}
// SAFETY: as for `Schema`.
unsafe impl Send for Stream {}

/// What a schema points to.
struct SchemaOwner {
    _name: CString,
    _metadata: Vec<u8>,
    children: Vec<*mut Schema>,
    dictionary: *mut Schema,
}

/// What an array points to.
struct ArrayOwner {
    _data: Arc<Data>,
    _validity: Vec<u8>,
    _offsets: Vec<i32>,
    _text: Vec<u8>,
    buffers: Vec<*const c_void>,
    children: Vec<*mut Array>,
    dictionary: *mut Array,
}

struct StreamOwner {
    data: Arc<Data>,
    given: bool,
}

impl Drop for Schema {
    fn drop(&mut self) {
        if let Some(release) = self.release {
            // SAFETY: a struct with a release function is live, and it is ours.
            unsafe { release(self) }
        }
    }
}

impl Drop for Array {
    fn drop(&mut self) {
        if let Some(release) = self.release {
            // SAFETY: as for `Schema`.
            unsafe { release(self) }
        }
    }
}

impl Drop for Stream {
    fn drop(&mut self) {
        if let Some(release) = self.release {
            // SAFETY: as for `Schema`.
            unsafe { release(self) }
        }
    }
}

unsafe extern "C" fn release_schema(schema: *mut Schema) {
    // SAFETY: callers give a live struct made by `schema_of`, whose boxes nobody else holds.
    unsafe {
        let owner = Box::from_raw((*schema).private.cast::<SchemaOwner>());
        for child in owner.children.iter().chain([&owner.dictionary]) {
            if !child.is_null() {
                drop(Box::from_raw(*child));
            }
        }
        (*schema).release = None;
        (*schema).private = null_mut();
    }
}

unsafe extern "C" fn release_array(array: *mut Array) {
    // SAFETY: callers give a live struct made by `array_of`, whose boxes nobody else holds.
    unsafe {
        let owner = Box::from_raw((*array).private.cast::<ArrayOwner>());
        for child in owner.children.iter().chain([&owner.dictionary]) {
            if !child.is_null() {
                drop(Box::from_raw(*child));
            }
        }
        (*array).release = None;
        (*array).private = null_mut();
    }
}

unsafe extern "C" fn release_stream(stream: *mut Stream) {
    // SAFETY: callers give a live struct made by `stream`.
    unsafe {
        drop(Box::from_raw((*stream).private.cast::<StreamOwner>()));
        (*stream).release = None;
        (*stream).private = null_mut();
    }
}

unsafe extern "C" fn stream_schema(stream: *mut Stream, out: *mut Schema) -> c_int {
    // SAFETY: the consumer gives a live stream of ours and room for a schema.
    unsafe {
        let owner = &*(*stream).private.cast::<StreamOwner>();
        out.write(schema(&owner.data));
    }
    0
}

unsafe extern "C" fn stream_next(stream: *mut Stream, out: *mut Array) -> c_int {
    // SAFETY: as in `stream_schema`.
    unsafe {
        let owner = &mut *(*stream).private.cast::<StreamOwner>();
        out.write(if owner.given {
            ended()
        } else {
            array(&owner.data)
        });
        owner.given = true;
    }
    0
}

unsafe extern "C" fn stream_error(_: *mut Stream) -> *const c_char {
    std::ptr::null()
}

/// The whole table as a stream of one batch.
pub fn stream(data: &Arc<Data>) -> Stream {
    let owner = StreamOwner {
        data: Arc::clone(data),
        given: false,
    };
    Stream {
        get_schema: Some(stream_schema),
        get_next: Some(stream_next),
        get_last_error: Some(stream_error),
        release: Some(release_stream),
        private: Box::into_raw(Box::new(owner)).cast(),
    }
}

/// Names, types and units of the columns.
pub fn schema(data: &Data) -> Schema {
    let children = data.records.fields.iter().map(column_schema).collect();
    schema_of(c"+s", "", 0, &data.metadata, children, None)
}

fn column_schema(field: &Field) -> Schema {
    let unit = field.unit();
    let mut metadata = Vec::new();
    if !unit.is_empty() {
        metadata.push(("unit".to_string(), unit.to_string()));
    }
    let of = |format, flags, dictionary| {
        schema_of(
            format,
            &field.name,
            flags,
            &metadata,
            Vec::new(),
            dictionary,
        )
    };
    match &field.values {
        FieldValues::Rows(_) => of(c"L", 0, None),
        FieldValues::Numbers(_) => of(c"g", NULLABLE, None),
        FieldValues::Words(_) => {
            let names = schema_of(c"u", "", NULLABLE, &[], Vec::new(), None);
            of(c"i", NULLABLE, Some(names))
        }
    }
}

fn schema_of(
    format: &'static std::ffi::CStr,
    name: &str,
    flags: i64,
    metadata: &[(String, String)],
    children: Vec<Schema>,
    dictionary: Option<Schema>,
) -> Schema {
    // A name with a zero in it cannot be said in C.
    let name = CString::new(name.replace('\0', "")).unwrap_or_default();
    let metadata = encoded(metadata);
    let boxed = |schema: Schema| Box::into_raw(Box::new(schema));
    let mut owner = Box::new(SchemaOwner {
        children: children.into_iter().map(boxed).collect(),
        dictionary: dictionary.map_or(null_mut(), boxed),
        _name: name,
        _metadata: metadata,
    });
    Schema {
        format: format.as_ptr(),
        name: owner._name.as_ptr(),
        metadata: if owner._metadata.is_empty() {
            std::ptr::null()
        } else {
            owner._metadata.as_ptr().cast()
        },
        flags,
        n_children: owner.children.len() as i64,
        children: owner.children.as_mut_ptr(),
        dictionary: owner.dictionary,
        release: Some(release_schema),
        private: Box::into_raw(owner).cast(),
    }
}

/// Pairs as the interface has them: their number, then each key and value after its length.
fn encoded(pairs: &[(String, String)]) -> Vec<u8> {
    let mut out = Vec::new();
    if pairs.is_empty() {
        return out;
    }
    out.extend((pairs.len() as i32).to_ne_bytes());
    for text in pairs.iter().flat_map(|(key, value)| [key, value]) {
        out.extend((text.len() as i32).to_ne_bytes());
        out.extend(text.as_bytes());
    }
    out
}

/// The whole table as a struct of its columns.
pub fn array(data: &Arc<Data>) -> Array {
    let columns = data.records.fields.iter();
    let children = columns.map(|f| column(data, &f.values)).collect();
    let rows = data.records.len();
    let parts = Parts {
        buffers: vec![std::ptr::null()],
        children,
        ..Parts::default()
    };
    array_of(data, rows, 0, parts)
}

/// Buffers and inner arrays of an array that is being made.
#[derive(Default)]
struct Parts {
    validity: Vec<u8>,
    offsets: Vec<i32>,
    text: Vec<u8>,
    buffers: Vec<*const c_void>,
    children: Vec<Array>,
    dictionary: Option<Array>,
}

fn column(data: &Arc<Data>, values: &FieldValues) -> Array {
    let rows = values.len();
    let plain = |values: *const c_void, nulls: (usize, Vec<u8>), dictionary| {
        let (count, validity) = nulls;
        let valid = if count == 0 {
            std::ptr::null()
        } else {
            validity.as_ptr().cast()
        };
        let parts = Parts {
            buffers: vec![valid, values],
            validity,
            dictionary,
            ..Parts::default()
        };
        array_of(data, rows, count, parts)
    };
    match values {
        FieldValues::Rows(x) => plain(x.as_ptr().cast(), (0, Vec::new()), None),
        FieldValues::Numbers(x) => {
            let missing = nulls(x, |x| x.is_nan());
            plain(x.as_ptr().cast(), missing, None)
        }
        FieldValues::Words(w) => {
            let missing = nulls(&w.codes, |c| *c < 0);
            plain(w.codes.as_ptr().cast(), missing, Some(names(data, w)))
        }
    }
}

/// Number of missing values, and one bit per row that is set where there is a value; no bits where none is missing.
fn nulls<T>(values: &[T], is_missing: impl Fn(&T) -> bool) -> (usize, Vec<u8>) {
    // Counted without branches first: most columns lack nothing.
    let count: usize = values.iter().map(|x| usize::from(is_missing(x))).sum();
    if count == 0 {
        return (0, Vec::new());
    }
    let byte = |eight: &[T]| {
        let bits = eight.iter().enumerate();
        bits.fold(0, |byte, (i, x)| byte | (u8::from(!is_missing(x)) << i))
    };
    (count, values.chunks(8).map(byte).collect())
}

fn names(data: &Arc<Data>, words: &Words) -> Array {
    let mut parts = Parts {
        offsets: vec![0],
        ..Parts::default()
    };
    for name in &words.names {
        parts.text.extend(name.as_bytes());
        parts.offsets.push(parts.text.len() as i32);
    }
    let (offsets, text) = (parts.offsets.as_ptr(), parts.text.as_ptr());
    parts.buffers = vec![std::ptr::null(), offsets.cast(), text.cast()];
    array_of(data, words.names.len(), 0, parts)
}

fn array_of(data: &Arc<Data>, rows: usize, null_count: usize, parts: Parts) -> Array {
    let boxed = |array: Array| Box::into_raw(Box::new(array));
    let mut owner = Box::new(ArrayOwner {
        _data: Arc::clone(data),
        _validity: parts.validity,
        _offsets: parts.offsets,
        _text: parts.text,
        buffers: parts.buffers,
        children: parts.children.into_iter().map(boxed).collect(),
        dictionary: parts.dictionary.map_or(null_mut(), boxed),
    });
    Array {
        length: rows as i64,
        null_count: null_count as i64,
        offset: 0,
        n_buffers: owner.buffers.len() as i64,
        n_children: owner.children.len() as i64,
        buffers: owner.buffers.as_mut_ptr(),
        children: owner.children.as_mut_ptr(),
        dictionary: owner.dictionary,
        release: Some(release_array),
        private: Box::into_raw(owner).cast(),
    }
}

/// What a stream gives after its last batch.
fn ended() -> Array {
    Array {
        length: 0,
        null_count: 0,
        offset: 0,
        n_buffers: 0,
        n_children: 0,
        buffers: null_mut(),
        children: null_mut(),
        dictionary: null_mut(),
        release: None,
        private: null_mut(),
    }
}
