//! Every scene in scenes/ is designed through the library, and one through the command with all its files.

use std::fs;
use std::path::{Path, PathBuf};

use gaitcam::cam::Verdict;
use gaitcam::force;
use gaitcam::scene::{self, Scene, Source};
use gaitcam::synth::{Design, synthesise};

use crate::support::{ROOT, command, gaitcam, object, stderr, stdout};

fn all() -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = fs::read_dir(Path::new(ROOT).join("scenes"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "toml"))
        .collect();
    paths.sort();
    paths
}

fn designed(path: &Path) -> (Scene, Design) {
    let mut table: toml::Table = fs::read_to_string(path).unwrap().parse().unwrap();
    name_recording(&mut table);
    let scene = scene::read(&table).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let target = scene.gait.as_ref().map(|g| match &g.source {
        Source::Model(_) | Source::Harmonics(_) => g.model_force().unwrap().unwrap(),
        Source::File(file) => {
            let file = path.parent().unwrap().join(file);
            let bytes = fs::read(&file).unwrap();
            force::force_curve(&file, &bytes, &force::ReadOptions::default(), g.feet).unwrap()
        }
    });
    let design = synthesise(&scene, target.as_ref());
    (
        scene,
        design.unwrap_or_else(|e| panic!("{}: {e}", path.display())),
    )
}

/// Sets a written cycle of the project in a scene that expects its recording from the command line.
fn name_recording(table: &mut toml::Table) {
    let gait = table.get_mut("gait").and_then(toml::Value::as_table_mut);
    if let Some(gait) = gait.filter(|g| !g.contains_key("file") && !g.contains_key("model")) {
        let file = Path::new(ROOT).join("data/gait_curves/young_1.85Hz_700N.csv");
        gait.insert("file".to_string(), file.to_str().unwrap().into());
    }
}

#[test]
fn every_scene_is_built_and_every_check_passes() {
    let paths = all();
    assert!(paths.len() >= 20, "scenes are missing");
    for path in paths {
        let (scene, design) = designed(&path);
        let name = path.file_stem().unwrap().to_string_lossy().to_string();
        assert_eq!(scene.name, name, "a scene is named as its file");
        assert!(
            design.infeasible.is_none(),
            "{name}: {:?}",
            design.infeasible
        );
        for check in &design.checks {
            assert!(check.pass, "{name}: {check:?}");
        }
        assert_ne!(
            design.verdict,
            Verdict::Unacceptable,
            "{name}: {}",
            design.reason(gaitcam::wording::Language::En)
        );
        assert_eq!(design.cam.follower.kind(), scene.cam.follower, "{name}");
    }
}

#[test]
fn printed_numbers_of_camdas_come_out_of_its_scenes() {
    let design = |name: &str| designed(&Path::new(ROOT).join(format!("scenes/{name}.toml"))).1;
    // theory §5, Ejemplo1RT: cam ρ 70.9934…95.8333 mm, φ ±18.2100°.
    let one = design("camdas_01_roller");
    assert!((one.cam.curvature().convex.value - 0.0709934).abs() < 1e-7);
    let (low, high) = one.cam.pressure_angle_extremes();
    assert!((high.value.to_degrees() - 18.21).abs() < 1e-4);
    assert!((low.value.to_degrees() + 18.21).abs() < 1e-4);
    // Ejemplo2RO: the arm starts at 36.42°.
    let two = design("camdas_02_oscillating_roller");
    let start = two.cam.follower.start_angle().unwrap();
    assert!((start.to_degrees() - 36.42).abs() < 1e-3, "{start}");
    // Ejemplo7CRT: 380 mm between the rollers, Ejemplo8DA: conjugate base 80 mm.
    let seven = design("camdas_07_conjugate_roller").conjugate.unwrap();
    let eight = design("camdas_08_conjugate_flat");
    let time = gaitcam_output::Timing::default();
    let second = &gaitcam_output::json::summary(&eight, time)["cam"]["second"];
    assert!((second["base_radius_m"].as_f64().unwrap() - 0.08).abs() < 1e-15);
    let eight = eight.conjugate.unwrap();
    for i in 0..3600 {
        let theta = f64::from(i) * std::f64::consts::TAU / 3600.0;
        assert!((seven.sum(theta) - 0.38).abs() < 1e-12);
        assert!((eight.sum(theta) - 0.225).abs() < 1e-12);
    }
    // Ejemplo5, 6: s(θ) + s(θ + π) is constant, breadth = 2Rb + s_max.
    let six = design("camdas_06_constant_breadth");
    let face = |x: f64| six.cam.follower.base_radius() + six.cam.law.svaj(x).s;
    for i in 0..720 {
        let x = f64::from(i).to_radians() / 2.0;
        assert!((face(x) + face(x + std::f64::consts::PI) - 0.15).abs() < 1e-12);
    }
    // Bautista Morelos (2018): 28.745° at the floor of the groove (theory §4).
    let barrel = design("thesis_barrel").groove.unwrap();
    let steepest = barrel.pressure_angle_extremes(barrel.depth().0).1.value;
    assert!((steepest.to_degrees() - 28.745).abs() < 1e-3);
}

/// Files of `--solid --tool` for a disc cam.
const WRITTEN: [&str; 15] = [
    "law.csv",
    "profile.csv",
    "profile.dxf",
    "profile.svg",
    "profile.stl",
    "profile.3mf",
    "profile.xlsx",
    "cutter.csv",
    "cutter.nc",
    "drawing.pdf",
    "cam.svg",
    "cam.png",
    "report.html",
    "scene.toml",
    "summary.json",
];

#[test]
fn the_command_hands_everything_over_and_reads_its_summary_back() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str], out: &Path| {
        let to = ["--json", "--out", out.to_str().unwrap()];
        let output = gaitcam(&[&["synth"], arguments, &to].concat());
        let fault = stderr(&output);
        assert_eq!(output.status.code(), Some(0), "{fault}");
        object(&output)
    };
    let first = folder.path().join("first");
    let scene = "scenes/camdas_09_eight_motions.toml";
    let arguments = [
        scene,
        "--set",
        "cam.bore=12 mm",
        "--solid",
        "--tool",
        "6 mm",
    ];
    let one = run(&arguments, &first);
    for file in WRITTEN {
        let size = fs::metadata(first.join(file)).unwrap().len();
        assert!(size > 100, "{file} is empty");
    }
    // Both the summary and the scene beside it mean the same cam again, the change included.
    for back in ["summary.json", "scene.toml"] {
        let second = folder.path().join(back.replace('.', "_"));
        let two = run(&[first.join(back).to_str().unwrap()], &second);
        for key in ["name", "law", "cam", "checks", "scene", "verdict"] {
            assert_eq!(one[key], two[key], "{key} from {back}");
        }
        let profile = |d: &Path| fs::read(d.join("profile.csv")).unwrap();
        assert_eq!(profile(&first), profile(&second));
    }
    // The slate of both.
    let out = folder.path().join("slate");
    let output = command(Path::new(ROOT))
        .args(["compare", "--out"])
        .args([&out, &first, &folder.path().join("scene_toml")])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0));
    let text = stdout(&output);
    assert!(
        text.contains("minimum convex radius") && text.contains("11.26 mm"),
        "{text}"
    );
    let page = std::fs::read_to_string(out.join("compare.html")).unwrap();
    assert!(page.contains("11.26 mm") && page.matches("<svg").count() >= 3);
    for name in ["compare_svaj", "compare_force", "compare_profiles"] {
        assert!(
            out.join(format!("{name}.svg")).exists() && out.join(format!("{name}.png")).exists()
        );
    }
}

/// Names and values of the rows of a page's tables with two columns.
fn facts(page: &str) -> Vec<(&str, &str)> {
    let rows = page.split("<th scope=\"row\">").skip(1);
    let pairs = rows.filter_map(|row| row.split_once("</th><td>"));
    pairs
        .filter_map(|(name, rest)| Some((name, rest.split_once("</td>")?.0)))
        .collect()
}

#[test]
fn console_and_report_print_the_same_digits_of_every_figure() {
    use gaitcam::synth::FIGURES;
    use gaitcam::wording::Language;
    use gaitcam_output::report::parts;

    let (mut scenes, mut compared) = (0, 0);
    for path in all() {
        let (scene, design) = designed(&path);
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().to_str().unwrap();
        let mut arguments = vec!["synth", path.to_str().unwrap(), "--no-png", "--out", out];
        if scene.name == "measured_walk" {
            arguments.extend(["--set", "gait.file=data/gait_curves/young_1.85Hz_700N.csv"]);
        }
        let console = stdout(&gaitcam(&arguments));
        let report = fs::read_to_string(folder.path().join("report.html")).unwrap();
        let report = facts(&report);
        assert!(report.len() > 10, "{}: {report:?}", scene.name);
        // A figure that the console names has the value of the report.
        let label = |f: &gaitcam::synth::Figure| f.label_on(&design.cam.follower, Language::En);
        let labels: Vec<String> = FIGURES.iter().map(label).collect();
        for (name, value) in report.iter().filter(|f| labels.iter().any(|l| l == f.0)) {
            let named = format!(", {name} ");
            for (at, before) in console.match_indices(&named) {
                let told = &console[at + before.len()..];
                assert!(
                    told.starts_with(value),
                    "{}: {name} {value}: {told}",
                    scene.name
                );
                compared += 1;
            }
        }
        // The figures of the page are those of the report; the force errors have their own sentence.
        let cards = parts::figures(&design, Language::En);
        for card in cards.iter().filter(|card| card.name == "RMS force error") {
            let told = format!("error {} RMS ({} of the mean)", card.value, &card.more);
            let told = told.replace(" of mean of the mean", " of the mean");
            assert!(console.contains(&told), "{}: {told}: {console}", scene.name);
            compared += 1;
        }
        scenes += 1;
    }
    assert!(
        scenes >= 25 && compared >= 6 * scenes,
        "{scenes} {compared}"
    );
}
