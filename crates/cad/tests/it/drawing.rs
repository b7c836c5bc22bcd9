//! Independent reader of DXF groups: entities, layers, header variables.

use std::collections::HashMap;

/// A drawing as read back.
pub struct Drawing {
    /// Layer, vertices (x, y, bulge) in mm, and whether the polyline is closed.
    pub polylines: Vec<(String, Vec<[f64; 3]>, bool)>,
    /// Layer and radius, mm.
    pub circles: Vec<(String, f64)>,
    /// Layers of all entities.
    pub layers: Vec<String>,
    /// Groups of each header variable.
    pub header: HashMap<String, Vec<(i32, String)>>,
}

/// Groups of a file: code and value.
pub fn groups(bytes: &[u8]) -> Vec<(i32, String)> {
    let text = std::str::from_utf8(bytes).unwrap();
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    assert!(lines.len().is_multiple_of(2));
    lines
        .chunks_exact(2)
        .map(|p| (p[0].parse().unwrap(), p[1].to_string()))
        .collect()
}

/// Reads the entities of a DXF file.
pub fn read(bytes: &[u8]) -> Drawing {
    let all = groups(bytes);
    let mut out = Drawing {
        polylines: Vec::new(),
        circles: Vec::new(),
        layers: Vec::new(),
        header: HashMap::new(),
    };
    let mut section = String::new();
    let mut variable = String::new();
    let starts: Vec<usize> = (0..all.len()).filter(|&i| all[i].0 == 0).collect();
    for (k, &start) in starts.iter().enumerate() {
        let end = starts.get(k + 1).copied().unwrap_or(all.len());
        let object = &all[start..end];
        if object[0].1 == "SECTION" {
            section = object[1].1.clone();
        }
        match section.as_str() {
            "HEADER" => {
                for (code, value) in &object[1..] {
                    if *code == 9 {
                        variable = value.clone();
                    }
                    let groups = out.header.entry(variable.clone()).or_default();
                    groups.push((*code, value.clone()));
                }
            }
            "ENTITIES" => out.entity(object),
            _ => {}
        }
    }
    out
}

impl Drawing {
    fn entity(&mut self, object: &[(i32, String)]) {
        let text = |code: i32| object.iter().find(|g| g.0 == code).map(|g| g.1.clone());
        let number = |code: i32| text(code).map_or(0.0, |t| t.parse::<f64>().unwrap());
        let layer = text(8).unwrap_or_default();
        let closed = number(70) == 1.0;
        match object[0].1.as_str() {
            "SECTION" | "ENDSEC" | "EOF" => return,
            "POLYLINE" => self.polylines.push((layer.clone(), Vec::new(), closed)),
            "VERTEX" => {
                let vertex = [number(10), number(20), number(42)];
                self.polylines.last_mut().unwrap().1.push(vertex);
            }
            "LWPOLYLINE" => {
                let mut vertices: Vec<[f64; 3]> = Vec::new();
                for (code, value) in object {
                    let x = || value.parse::<f64>().unwrap();
                    match code {
                        10 => vertices.push([x(), 0.0, 0.0]),
                        20 => vertices.last_mut().unwrap()[1] = x(),
                        42 => vertices.last_mut().unwrap()[2] = x(),
                        _ => {}
                    }
                }
                assert_eq!(vertices.len() as f64, number(90));
                self.polylines.push((layer.clone(), vertices, closed));
            }
            "CIRCLE" => self.circles.push((layer.clone(), number(40))),
            _ => {}
        }
        self.layers.push(layer);
    }

    /// The only polyline of a layer, and whether it is closed.
    pub fn outline(&self, layer: &str) -> (Vec<[f64; 3]>, bool) {
        let all: Vec<_> = self.polylines.iter().filter(|p| p.0 == layer).collect();
        assert_eq!(all.len(), 1, "{layer} is drawn {} times", all.len());
        (all[0].1.clone(), all[0].2)
    }

    /// x and y of a header variable.
    pub fn corner(&self, variable: &str) -> [f64; 2] {
        let groups = &self.header[variable];
        [10, 20].map(|code| {
            let (_, value) = groups.iter().find(|g| g.0 == code).unwrap();
            value.parse().unwrap()
        })
    }
}
