//! Texts of figures stay on their sheet and do not overlap, in both languages.
//!
//! The widths come from the advances of the typeface with which the PNG is drawn.

use ab_glyph::{Font, FontRef};
use gaitcam::dynamics::{Model, Run, simulate};
use gaitcam::force::{Feet, Interpretation, ReadOptions, cycle, read, stances};
use gaitcam::scene::SCENES;
use gaitcam::synth::{Design, synthesise};
use gaitcam_output::report::{Running, html, html_of_run};

use gaitcam_output::sweep_plots::{self, Best, Quantity};
use gaitcam_output::{Language, overlay, plots, recording};
use gaitcam_test_support::designs::{footbridge, heel_tester, odd_ones};
use gaitcam_test_support::readers::attribute;

use crate::TIME;

const LANGUAGES: [Language; 2] = [Language::En, Language::Es];

/// A text with its left, top, right and bottom positions, points.
struct Placed {
    text: String,
    corners: [f64; 4],
}

fn width(font: &FontRef, text: &str, bold: bool) -> f64 {
    let em = font.units_per_em().unwrap();
    let advance = |c: char| f64::from(font.h_advance_unscaled(font.glyph_id(c)) / em);
    // The PNG draws bold letters a little wider; browsers take the bold face, about as wide.
    let more = if bold { 0.06 } else { 0.0 };
    text.chars().map(|c| advance(c) + more).sum()
}

/// Distances by which the ink of a text extends above and below its line, em.
fn extent(font: &FontRef, text: &str) -> [f64; 2] {
    let em = font.units_per_em().unwrap();
    let inked = text.chars().filter_map(|c| font.outline(font.glyph_id(c)));
    inked.fold([0.0, 0.0], |[up, down], glyph| {
        // The font's own axis points upwards.
        let ends = [glyph.bounds.min.y, glyph.bounds.max.y].map(|y| f64::from(y / em));
        [
            up.max(ends[0].max(ends[1])),
            down.max(-ends[0].min(ends[1])),
        ]
    })
}

fn texts(svg: &str) -> Vec<Placed> {
    let font = FontRef::try_from_slice(dejavu::sans::regular()).unwrap();
    let parts = svg.split("<text ").skip(1);
    let mut out = Vec::new();
    for part in parts {
        let (head, rest) = part.split_once('>').unwrap();
        let text = rest.split("</text>").next().unwrap();
        let text = text.replace("&lt;", "<").replace("&gt;", ">");
        let text = text.replace("&amp;", "&");
        let head = format!(" {head}");
        let number = |name: &str| attribute(&head, name).parse::<f64>().unwrap();
        if !head.contains(" font-size=") || text.is_empty() {
            // A label that the page fills and sizes itself.
            continue;
        }
        let (x, y, size) = (number("x"), number("y"), number("font-size"));
        let long = size * width(&font, &text, head.contains("bold"));
        let [up, down] = extent(&font, &text).map(|ems| size * ems);
        let start = match () {
            () if head.contains("\"middle\"") => -0.5 * long,
            () if head.contains("\"end\"") => -long,
            () => 0.0,
        };
        let corners = if head.contains("rotate(-90") {
            [x - up, y - start - long, x + down, y - start]
        } else {
            [x + start, y - up, x + start + long, y + down]
        };
        out.push(Placed { text, corners });
    }
    out
}

/// Errors of the texts of every drawing of `page`.
fn faults(of: &str, page: &str) -> Vec<String> {
    let mut out = Vec::new();
    for svg in page.split("<svg ").skip(1) {
        let svg = svg.split("</svg>").next().unwrap();
        let shown = attribute(&format!(" {svg}"), "viewBox");
        let shown: Vec<f64> = shown.split(' ').map(|x| x.parse().unwrap()).collect();
        let all = texts(svg);
        for (i, a) in all.iter().enumerate() {
            let [left, top, right, bottom] = a.corners;
            let inside = left >= shown[0] && top >= shown[1];
            let (most_right, most_down) = (shown[0] + shown[2], shown[1] + shown[3]);
            if !(inside && right <= most_right && bottom <= most_down) {
                out.push(format!("{of}: \"{}\" leaves the picture", a.text));
            }
            for b in &all[i + 1..] {
                let [l, t, r, d] = b.corners;
                let slack = 0.1;
                let apart = right <= l + slack || r <= left + slack;
                if !(apart || bottom <= t + slack || d <= top + slack) {
                    out.push(format!("{of}: \"{}\" lies over \"{}\"", a.text, b.text));
                }
            }
        }
    }
    out
}

/// Designs of the built-in scenes that need no recording, and unusual designs.
fn designs() -> Vec<Design> {
    let mut out = vec![footbridge(), heel_tester()];
    out.extend(odd_ones());
    for scene in &SCENES {
        let Ok(scene) = scene.scene() else {
            continue;
        };
        let Ok(force) = scene.model_force() else {
            continue;
        };
        out.extend(synthesise(&scene, force.as_ref()));
    }
    out
}

#[test]
fn texts_of_designs_and_runs_keep_their_places_in_both_languages() {
    let mut found = Vec::new();
    let designs = designs();
    assert!(designs.len() > 20, "{}", designs.len());
    for design in &designs {
        let mut run = Run::new(design.cam.clone(), design.problem.drive, 720);
        run.drive.speed *= 2.2;
        let outcome = simulate(&run, Model::Rigid).ok();
        for language in LANGUAGES {
            let of = format!("{} {language:?}", design.problem.name);
            for (name, picture) in [
                ("svaj", plots::svaj(design, language)),
                ("force", plots::force(design, language)),
                ("cam", plots::cam(design, language)),
            ] {
                found.extend(faults(&format!("{of} {name}"), &picture.svg()));
            }
            let page = html(design, TIME, language);
            found.extend(faults(&format!("{of} report"), &page));
            if let Some(outcome) = &outcome {
                let running = Running {
                    outcome,
                    second_cam: None,
                };
                let page = html_of_run(design, TIME, &running, language);
                found.extend(faults(&format!("{of} run"), &page));
            }
        }
    }
    found.sort();
    found.dedup();
    assert!(
        found.is_empty(),
        "{} faults:\n{}",
        found.len(),
        found.join("\n")
    );
}

#[test]
fn texts_of_recordings_and_searches_keep_their_places_in_both_languages() {
    const WALK: &[u8] = include_bytes!("../../../../data/recordings/made_walk.csv");
    let recording = read("walk.csv".as_ref(), WALK, &ReadOptions::default()).unwrap();
    let found = stances(&recording);
    let mean = cycle(&recording, &found, Feet::Both).unwrap();
    let known = Interpretation::of("made_walk.csv", &recording, &found, Some(&mean), Feet::Both);
    let column = |label: &str, scale: f64| Quantity {
        label: label.into(),
        values: (0..120)
            .map(|i| scale * (1.0 + (0.37 * f64::from(i)).sin()))
            .collect(),
        words: Vec::new(),
    };
    let [x, y, z] = [
        column("limits.pressure_angle, rad", 0.4),
        column("mayor presión de Hertz, Pa", 4e8),
        column("force_rms_error_percent_of_mean", 0.02),
    ];
    let all: Vec<Quantity> = [&x, &y, &z, &x, &y, &z, &x].map(Clone::clone).to_vec();
    let on_front = [(0.2, 2e8), (0.5, 1e8)];
    let level = [(0.01, "p95"), (0.038, "límite de la escena 0,038")];
    let mut faults_found = Vec::new();
    for language in LANGUAGES {
        let pictures = [
            (
                "recording",
                recording::recording(&known, Some(&mean.curve), language),
            ),
            ("contacts", recording::recording(&known, None, language)),
            (
                "histogram",
                sweep_plots::histogram("Tolerancias", &z, &level, language),
            ),
            (
                "front",
                sweep_plots::front(
                    "Frente",
                    &x,
                    &y,
                    &on_front,
                    Some(on_front[0]),
                    None,
                    language,
                ),
            ),
            (
                "trade-off",
                sweep_plots::front("Compromiso", &x, &y, &on_front, None, Some(1.4e8), language),
            ),
            (
                "heat map",
                sweep_plots::heat_map("Mejor valor", [&x, &y, &z], Best::Least, language),
            ),
            (
                "parallel",
                sweep_plots::parallel("Todos", &all, &[1, 2], Some(3), language),
            ),
        ];
        for (name, picture) in pictures {
            faults_found.extend(faults(&format!("{language:?} {name}"), &picture.svg()));
        }
    }
    assert!(faults_found.is_empty(), "{}", faults_found.join("\n"));
}

#[test]
fn names_of_compared_designs_keep_their_places_however_long() {
    let curve: Vec<(f64, f64)> = (0..=360)
        .map(|t| (f64::from(t), f64::from(t % 90)))
        .collect();
    let outline = vec![[0.02, 0.0], [0.0, 0.03], [-0.02, 0.0], [0.0, -0.02]];
    let mut found = Vec::new();
    for length in [6, 20, 38, 60] {
        for count in [1, 2, 3, 7, 12] {
            let name = |i: usize| format!("{}{i}", "heel t-m".repeat(9)[..length].trim_end());
            let names: Vec<String> = (0..count).map(name).collect();
            let strip = overlay::Strip {
                quantity: "fuerza o momento, N o N·m".into(),
                curves: vec![curve.clone(); count],
            };
            let pictures = [
                overlay::diagrams("Leyes", "de todos", &names, &[strip.clone(), strip]),
                overlay::profiles(
                    "Perfiles",
                    "a escala",
                    &names,
                    &vec![outline.clone(); count],
                    Language::Es,
                ),
            ];
            for picture in pictures {
                found.extend(faults(
                    &format!("{count} names of {length}"),
                    &picture.svg(),
                ));
            }
        }
    }
    assert!(
        found.is_empty(),
        "{} faults:\n{}",
        found.len(),
        found.join("\n")
    );
}
