//! Writing of meshes as binary STL.

use std::io::Cursor;

use stl_io::{Normal, Triangle, Vertex};

use super::Mesh;
use gaitcam::error::{Result, WriteError};

/// Mesh as a binary STL file, mm.
pub fn file(mesh: &Mesh) -> Result<Vec<u8>> {
    let triangles: Vec<Triangle> = mesh
        .triangles
        .iter()
        .map(|corners| {
            let p = corners.map(|i| mesh.vertices[i]);
            Triangle {
                normal: Normal::new(facing(p).map(|x| x as f32)),
                vertices: p.map(|v| Vertex::new(v.map(|x| x as f32))),
            }
        })
        .collect();
    let mut out = Cursor::new(Vec::new());
    stl_io::write_stl(&mut out, triangles.iter()).map_err(|e| WriteError::NotPutTogether {
        fault: e.to_string(),
    })?;
    Ok(out.into_inner())
}

/// Unit normal of a triangle, outwards.
fn facing([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let u = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    let v = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    let n = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
    n.map(|x| x / length)
}
