//! Columns of logs: all kinds of units, names and layouts lead to the same machine. Other columns are rejected by name.

use std::f64::consts::{PI, TAU};

use gaitcam::error::Result;
use gaitcam::identify::{Identified, Log, LogColumns, LogOptions, identify};
use gaitcam::scene::{self, Scene};
use gaitcam::synth::Design;

use super::{scatter, shaker};

/// Encoder counts per turn, and between two samples.
const COUNTS: usize = 7200;
const STEP: usize = 13;

/// The shaker with a motor, and its log in SI units.
fn logged() -> ((Scene, Design), LogColumns) {
    let (scene, _) = shaker();
    let mut table = scene.to_table();
    scene::set(&mut table, "machine.inertia=0.5 kg m^2").unwrap();
    let scene = scene::read(&table).unwrap();
    let design = scene.design().unwrap();
    let speed = design.problem.drive.speed;
    let counts = (0..5000).map(|i| i * STEP);
    let theta: Vec<f64> = counts.map(|c| TAU * c as f64 / COUNTS as f64).collect();
    let at = |x: &f64| design.cam.law.svaj(*x);
    let force = theta.iter().enumerate().map(|(i, x)| {
        73.0 * (9.81 + speed * speed * at(x).a) + 4.0 * (2.0 * x).sin() + 3.0 * scatter(i)
    });
    let force: Vec<f64> = force.collect();
    let ripple = |x: &f64| speed * (1.0 + 0.01 * x.sin());
    let torque = theta.iter().zip(&force).map(|(x, f)| {
        let rate = ripple(x) * 0.01 * speed * x.cos();
        0.5 * rate + f * at(x).v + 1.5
    });
    let columns = LogColumns {
        time: Some(theta.iter().map(|x| x / speed).collect()),
        torque: Some(torque.collect()),
        speed: Some(theta.iter().map(ripple).collect()),
        theta: Some(theta),
        force,
    };
    ((scene, design), columns)
}

/// Layout of a log: header rows, size of the unit of each column, period of the angle in its unit, separator and decimal mark.
struct Layout {
    header: &'static str,
    units: [f64; 5],
    period: Option<f64>,
    marks: [&'static str; 2],
}

const LBF: f64 = 4.448_221_615_260_5;

fn text(columns: &LogColumns, layout: &Layout) -> String {
    let [separator, decimal] = layout.marks;
    let all = [
        columns.time.as_ref(),
        columns.theta.as_ref(),
        Some(&columns.force),
        columns.speed.as_ref(),
        columns.torque.as_ref(),
    ];
    let mut out = format!("{}\n", layout.header);
    for i in 0..columns.force.len() {
        let cells = (0..5).map(|k| {
            let mut x = all[k].unwrap()[i] / layout.units[k];
            if let (1, Some(period)) = (k, layout.period) {
                x %= period;
            }
            x.to_string().replace('.', decimal)
        });
        out += &cells.collect::<Vec<_>>().join(separator);
        out.push('\n');
    }
    out
}

fn found(machine: &(Scene, Design), text: &str, options: &LogOptions) -> Result<Identified> {
    let log = Log::read("log.csv".as_ref(), text.as_bytes(), options)?;
    identify(&machine.1, &machine.0, &[log])
}

fn named(time: &str, angle: &str, force: &str) -> LogOptions {
    let some = |x: &str| Some(x.to_string());
    LogOptions {
        time: some(time),
        angle: some(angle),
        force: some(force),
        ..LogOptions::default()
    }
}

#[test]
fn the_same_log_in_every_unit_and_layout_gives_the_same_machine() {
    let (machine, columns) = logged();
    let deg = PI / 180.0;
    let rpm = TAU / 60.0;
    let plain = Layout {
        header: "time_s,theta_rad,force_n,speed_rad_per_s,torque_n_m",
        units: [1.0; 5],
        period: None,
        marks: [",", "."],
    };
    let layouts = [
        (
            "t_ms,master_deg,F_N,rpm,torque_n_mm",
            [1e-3, deg, 1.0, rpm, 1e-3],
            Some(360.0),
            [",", "."],
        ),
        (
            "Time [us];Angle (deg);Force [kN];Speed (deg/s);Torque [N·m]",
            [1e-6, deg, 1e3, deg, 1.0],
            None,
            [";", ","],
        ),
        (
            "Zeit\tWinkel\tKraft\tDrehzahl\tDrehmoment\nms\tdeg\tN\trpm\tN m",
            [1e-3, deg, 1.0, rpm, 1.0],
            Some(360.0),
            ["\t", ","],
        ),
        (
            "tiempo_s;angulo_rev;fuerza_lbf;velocidad_rpm;par_lbf_in",
            [1.0, TAU, LBF, rpm, LBF * 0.0254],
            Some(1.0),
            [";", "."],
        ),
        (
            "Time (sec),Cam angle (turns),Load cell (lbf),Shaft speed (1/min),Torque (in·lb)",
            [1.0, TAU, LBF, rpm, LBF * 0.0254],
            None,
            [",", "."],
        ),
        (
            "time,phi,load,omega,moment\ns,rad,kgf,rev/s,Nm",
            [1.0, 1.0, 9.806_65, TAU, 1.0],
            Some(TAU),
            [",", "."],
        ),
        (
            "[ms];[°];[N];[RPM];[Nmm]",
            [1e-3, deg, 1.0, rpm, 1e-3],
            None,
            [";", "."],
        ),
        (
            "time_s;Encoder;force_n;speed_rad_per_s;torque_n_m",
            [1.0, TAU / COUNTS as f64, 1.0, 1.0, 1.0],
            Some(COUNTS as f64),
            [";", "."],
        ),
        (
            "time_s;position [counts];force_n;speed_rad_per_s;torque_n_m",
            [1.0, TAU / COUNTS as f64, 1.0, 1.0, 1.0],
            None,
            [";", "."],
        ),
    ];
    let reference = found(&machine, &text(&columns, &plain), &LogOptions::default()).unwrap();
    assert!(
        reference
            .parameters
            .iter()
            .any(|p| p.key == "machine.inertia")
    );
    let arrays = Log::new("log 1".as_ref(), columns.clone()).unwrap();
    let arrays = identify(&machine.1, &machine.0, &[arrays]).unwrap();
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(1e-3);
    let same = |other: &Identified, what: &str| {
        assert_eq!(other.parameters.len(), reference.parameters.len(), "{what}");
        for (a, b) in reference.parameters.iter().zip(&other.parameters) {
            assert_eq!((a.key, a.identifiable), (b.key, b.identifiable), "{what}");
            assert!(close(a.value, b.value), "{what}: {a:?} {b:?}");
            for (a, b) in [(a.low, b.low), (a.high, b.high)] {
                assert!(
                    close(a.unwrap_or(0.0), b.unwrap_or(0.0)),
                    "{what}: {a:?} {b:?}"
                );
            }
        }
    };
    same(&arrays, "arrays");
    for (header, units, period, marks) in layouts {
        let layout = Layout {
            header,
            units,
            period,
            marks,
        };
        let counts_per_turn = header
            .to_lowercase()
            .contains("co")
            .then_some(COUNTS as f64);
        let options = LogOptions {
            counts_per_turn,
            ..LogOptions::default()
        };
        let text = text(&columns, &layout);
        same(
            &found(&machine, &text, &options).unwrap_or_else(|e| panic!("{header}: {e}")),
            header,
        );
    }
    // Without header, and with names that say nothing: the options name the columns, in SI.
    let [rows, letters] =
        ["", "a,b,c,d,e"].map(|header| text(&columns, &Layout { header, ..plain }));
    for (text, options) in [
        (rows, named("1", "2", "3")),
        (letters, named("A", "b", "3")),
    ] {
        let options = LogOptions {
            speed: Some("4".into()),
            torque: Some("5".into()),
            ..options
        };
        same(&found(&machine, &text, &options).unwrap(), "named");
    }
}

/// Log of 60 rows with three columns.
fn short(header: &str) -> String {
    let rows = (0..60).map(|i| format!("{},{},{}\n", 0.01 * f64::from(i), 3 * i, 700 + i));
    format!("{header}\n{}", rows.collect::<String>())
}

#[test]
fn columns_that_cannot_be_read_are_refused_by_name_with_the_option_that_settles_it() {
    let none = LogOptions::default;
    let counts = |n: f64| LogOptions {
        counts_per_turn: Some(n),
        ..none()
    };
    let cases: [(&str, LogOptions, &str, &[&str]); 19] = [
        (
            "t_s,x,weight",
            none(),
            "log-no-column",
            &["line 1", "t_s, x, weight", "force"],
        ),
        (
            "row,x,F_N",
            none(),
            "log-no-column",
            &["row, x, F_N", "time", "angle"],
        ),
        ("", none(), "log-no-column", &["1, 2, 3"]),
        (
            "time,x,F_N",
            none(),
            "log-no-unit",
            &["time", "time [s]", "option time"],
        ),
        (
            "time_s,Angle,F_N",
            none(),
            "log-no-unit",
            &["Angle [rad]", "option angle"],
        ),
        (
            "time [h],x,F_N",
            none(),
            "log-unknown-unit",
            &["time [h]", " h", "ms"],
        ),
        (
            "time_s,Angle [gon],F_N",
            none(),
            "log-unknown-unit",
            &["gon", "deg"],
        ),
        (
            "time_s,x,force [V]",
            none(),
            "log-unknown-unit",
            &["force [V]", "V", "kN"],
        ),
        (
            "time_s,force_1_n,force_2_n",
            none(),
            "log-many-columns",
            &["force_1_n, force_2_n", "option force"],
        ),
        (
            "time_s,encoder,F_N",
            none(),
            "log-counts",
            &["encoder", "counts-per-turn"],
        ),
        ("time_s,encoder,F_N", counts(0.0), "log-bad-counts", &["0"]),
        (
            "time_s,encoder,F_N",
            counts(f64::NAN),
            "log-bad-counts",
            &[],
        ),
        (
            "time_s,x,F_N",
            counts(4096.0),
            "log-no-counts",
            &["time_s, x, F_N"],
        ),
        (
            "time_s,theta_rad,F_N",
            counts(4096.0),
            "log-no-counts",
            &["theta_rad"],
        ),
        (
            "time_s,angle_deg,F_N",
            counts(4096.0),
            "log-no-counts",
            &["option angle"],
        ),
        (
            "time_s,x,F_N",
            named("time", "2", "3"),
            "read-misspelt-column",
            &["time_s"],
        ),
        (
            "time_s,x,F_N",
            named("1", "something else", "3"),
            "read-no-column",
            &["time_s"],
        ),
        (
            "",
            named("1", "9", "3"),
            "read-no-column-number",
            &["1 to 3"],
        ),
        (
            "time_s,x,F_N",
            named("F_N", "2", "3"),
            "log-unknown-unit",
            &["F_N", "ms"],
        ),
    ];
    for (header, options, code, says) in cases {
        let error = Log::read("plc.csv".as_ref(), short(header).as_bytes(), &options).unwrap_err();
        let said = error.to_string();
        assert_eq!(error.code(), code, "{header}: {said}");
        assert!(said.starts_with("plc.csv"), "{said}");
        for word in says {
            assert!(said.contains(word), "{header}: {said} without {word}");
        }
    }
    // Columns that no log has are ignored: a position in millimetres is not an angle.
    let log = Log::read(
        "plc.csv".as_ref(),
        short("time_s,position_mm,F_N").as_bytes(),
        &none(),
    );
    assert!(log.unwrap().columns().theta.is_none());
}

#[test]
fn arrays_that_are_no_log_are_refused() {
    type Change = fn(&mut LogColumns);
    let time: Vec<f64> = (0..60).map(|i| 0.01 * f64::from(i)).collect();
    let force: Vec<f64> = (0..60).map(|i| 700.0 + f64::from(i)).collect();
    let with = |change: Change| {
        let mut columns = LogColumns {
            time: Some(time.clone()),
            force: force.clone(),
            ..LogColumns::default()
        };
        change(&mut columns);
        Log::new("log 1".as_ref(), columns).map_err(|e| e.code().to_string())
    };
    assert!(with(|_| ()).is_ok());
    let cases: [(&str, Change); 9] = [
        ("log-no-column", |c| c.time = None),
        ("log-lengths", |c| c.theta = Some(vec![0.0; 39])),
        ("log-lengths", |c| c.force.clear()),
        ("log-value", |c| c.force[7] = f64::NAN),
        ("log-value", |c| c.force[7] = f64::INFINITY),
        ("log-order", |c| c.time.as_mut().unwrap()[9] = 0.0),
        ("log-no-motion", |c| c.theta = Some(vec![2.0; 60])),
        ("log-no-force", |c| c.force.fill(5.0)),
        ("log-few-rows", |c| {
            c.time = Some(vec![1.0]);
            c.force = vec![1.0];
        }),
    ];
    for (code, change) in cases {
        assert_eq!(with(change), Err(code.to_string()));
    }
}
