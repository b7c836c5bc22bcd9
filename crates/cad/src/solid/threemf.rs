//! Writing of meshes as 3MF, a zip archive with three XML parts (3MF core specification 1.3).

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::Mesh;
use gaitcam::error::{Result, WriteError};
use gaitcam_base::text::escaped;

const TYPES: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\
<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\
</Types>\n";

const RELATIONS: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" \
Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

/// Mesh in mm as a 3MF file with one object.
pub fn package(mesh: &Mesh, name: &str) -> Result<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let parts = [
        ("[Content_Types].xml", TYPES.to_string()),
        ("_rels/.rels", RELATIONS.to_string()),
        ("3D/3dmodel.model", model(mesh, name)),
    ];
    for (path, text) in parts {
        // The default options contain no time stamp, so equal meshes give equal bytes.
        zip.start_file(path, SimpleFileOptions::default())
            .map_err(|e| fault(format!("{path}: {e}")))?;
        zip.write_all(text.as_bytes())
            .map_err(|e| fault(format!("{path}: {e}")))?;
    }
    let done = zip.finish().map_err(|e| fault(e.to_string()))?;
    Ok(done.into_inner())
}

fn fault(fault: String) -> WriteError {
    WriteError::NotPutTogether { fault }
}

fn model(mesh: &Mesh, name: &str) -> String {
    let mut out = String::with_capacity(64 * (mesh.vertices.len() + mesh.triangles.len()));
    // Writing to a String cannot fail.
    let _ = write!(
        out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" \
         xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n\
         <metadata name=\"Title\">{}</metadata>\n<resources>\n<object id=\"1\" type=\"model\"><mesh>\n<vertices>\n",
        escaped(name)
    );
    for [x, y, z] in &mesh.vertices {
        let _ = writeln!(out, "<vertex x=\"{x:.6}\" y=\"{y:.6}\" z=\"{z:.6}\"/>");
    }
    out.push_str("</vertices>\n<triangles>\n");
    for [a, b, c] in &mesh.triangles {
        let _ = writeln!(out, "<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\"/>");
    }
    out.push_str(
        "</triangles>\n</mesh></object>\n</resources>\n<build><item objectid=\"1\"/></build>\n</model>\n",
    );
    out
}
