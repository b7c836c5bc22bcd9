use super::*;
use crate::force::ForceCurve;
use crate::halt::Halt;
use crate::sweep::{Method, NUMBERS, Outcome, Plan, Sampling};

/// Empty list of files, because no row of these tests has a recording.
static NONE: Files = Files::new();

/// Rows of a plan, each from the kernel and from a single synthesis of the same scene.
fn compared(changes: &[&str], vary: &[&str], count: u64) -> Vec<(Row, Row)> {
    let mut table: Table = scene::DEFAULT.parse().unwrap();
    for change in changes {
        scene::set(&mut table, change).unwrap();
    }
    let (method, seed) = (Method::Latin, 7);
    let sampling = Sampling::Sample {
        method,
        count,
        seed,
    };
    let plan = Plan::of(table, vary, sampling).unwrap();
    let kernel = Kernel::new(&plan, &NONE, &Halt::never, None);
    let batch = plan.batch(0, count as usize);
    let mut bases: HashMap<Vec<String>, Base> = HashMap::new();
    (0..count as usize)
        .map(|row| {
            let words = batch.columns.iter().filter_map(Column::words);
            let base = bases
                .entry(words.map(|w| w[row].to_string()).collect())
                .or_insert_with(|| kernel.base(&batch, row));
            let fast = kernel.row(&batch, row, base);
            let alone = match kernel.read(&batch, row) {
                Ok(scene) => {
                    // This kernel has an empty cache.
                    let other = Kernel::new(&plan, &NONE, &Halt::never, None);
                    other.designed_row(0, &scene, &source(0, &scene))
                }
                Err(e) => Row::error(e.to_string()),
            };
            (fast, alone)
        })
        .collect()
}

fn equal(pairs: &[(Row, Row)]) {
    for (i, (fast, alone)) in pairs.iter().enumerate() {
        assert_eq!(
            (
                fast.outcome,
                fast.verdict,
                fast.tier,
                &fast.failed,
                &fast.error
            ),
            (
                alone.outcome,
                alone.verdict,
                alone.tier,
                &alone.failed,
                &alone.error
            ),
            "row {i}"
        );
        for (k, name) in NUMBERS.iter().enumerate() {
            let (a, b) = (fast.numbers[k], alone.numbers[k]);
            if a.is_nan() && b.is_nan() {
                continue;
            }
            // Force errors are compared relative to the mean force, because an error that consists of rounding has no significant digits.
            let scale = if k < 7 && k != 1 {
                alone.numbers[3].abs().max(b.abs())
            } else {
                b.abs()
            };
            let scale = if k == 1 { 100.0 } else { scale };
            assert!((a - b).abs() <= 1e-9 * scale, "row {i} {name}: {a} for {b}");
        }
    }
}

#[test]
fn closed_rows_equal_single_syntheses_of_a_moving_axis() {
    let pairs = compared(
        &["law.family=harmonic"],
        &[
            "gait.step_frequency=1.6 Hz:2.4 Hz",
            "gait.body_weight=400 N:1200 N",
            "limits.curvature=0 mm:20 mm",
            "gait.model=young,setra,sci-p354",
            "gait.scale=none,to-mass",
            "cam.bore=2 mm:40 mm",
        ],
        60,
    );
    equal(&pairs);
    let spectral = pairs
        .iter()
        .filter(|p| p.0.outcome == Outcome::Built && p.0.failed.is_empty())
        .count();
    assert!(spectral > 30, "{spectral}");
}

#[test]
fn closed_rows_of_own_load_factors_equal_single_syntheses() {
    let pairs = compared(
        &[
            "law.family=harmonic",
            "gait.harmonics=0.4 at 20 deg, 0.1 at -90 deg, 0.1",
        ],
        &[
            "gait.step_frequency=1.6 Hz:2.4 Hz",
            "gait.body_weight=400 N:1200 N",
        ],
        20,
    );
    equal(&pairs);
    assert!(pairs.iter().all(|p| p.0.outcome == Outcome::Built));
}

#[test]
fn rows_under_motors_and_on_moving_floors_equal_single_syntheses() {
    let floor = [
        "machine.floor.frequency=1.85 Hz",
        "machine.floor.damping=0.01",
    ];
    let wheel = ["machine.inertia=1 kg m^2"];
    for family in ["law.family=harmonic", "law.family=spline"] {
        let common = [family, "limits.stroke=200 mm", "accuracy.rms=1 %"];
        for (fixed, swept) in [
            (&floor[..], &["machine.floor.mass=3000 kg:20000 kg"][..]),
            (
                &wheel[..],
                &["machine.motor.slope=4 N m s/rad:40 N m s/rad"],
            ),
            (
                &["machine.motor.stall_torque=40 N m"][..],
                &["machine.inertia=0.6 kg m^2:3 kg m^2"],
            ),
            (
                &[floor[0], floor[1], "machine.motor.slope=10 N m s/rad"][..],
                &[
                    "machine.inertia=1 kg m^2:4 kg m^2",
                    "machine.floor.mass=3000 kg:20000 kg",
                ],
            ),
        ] {
            let scene: Vec<&str> = common.iter().chain(fixed).copied().collect();
            let pairs = compared(&scene, swept, 4);
            equal(&pairs);
            assert!(
                pairs.iter().all(|p| p.0.outcome == Outcome::Built),
                "{family} {swept:?}"
            );
        }
    }
}

#[test]
fn closed_rows_equal_single_syntheses_under_limits_sizes_and_counts() {
    // A cam larger than its limit fails its check in a sweep, too.
    equal(&compared(
        &["law.family=harmonic"],
        &[
            "limits.prime_radius=5 mm:60 mm",
            "limits.curvature=1 mm:60 mm",
        ],
        60,
    ));
    equal(&compared(
        &[
            "law.family=harmonic",
            "drive.speed=111 rpm",
            "accuracy.rms=5 %",
        ],
        &[
            "drive.mass=30 kg:90 kg",
            "gait.scale=none,to-mass",
            "limits.jerk=50 m/s^3:900 m/s^3",
            "cam.base_radius=1 mm:90 mm",
            "law.harmonics=1,2,3,9",
            "limits.force_min=100 N:500 N",
        ],
        80,
    ));
    equal(&compared(
        &[
            "law.family=harmonic",
            "drive.kind=hydraulic",
            "drive.pressure_per_volume=30 psi/in^3",
            "drive.piston_radius=2 cm",
            "gait.step_frequency=2 Hz",
        ],
        &[
            "drive.piston_radius=10 mm:40 mm",
            "accuracy.rms=0.1 %:20 %",
            "gait.body_weight=300 N:900 N",
            "drive.speed=3 rad/s:20 rad/s",
        ],
        60,
    ));
    equal(&compared(
        &[
            "law.family=harmonic",
            "drive.kind=fixed-axis",
            "drive.mass=70 kg",
        ],
        &[
            "drive.spring_rate=0 N/m,4000 N/m",
            "drive.mass=1 kg:50 kg",
            "drive.damping=0 N s/m,3 N s/m",
            "drive.preload=100 N:900 N",
        ],
        30,
    ));
}

/// Limits on torque, power and pressure are checked with the values of the closed form. The force of one foot is not a finite sum of
/// harmonics.
#[test]
fn closed_rows_equal_single_syntheses_under_loads_and_of_single_feet() {
    let loads = compared(
        &["law.family=harmonic"],
        &[
            "limits.torque=5 N m:60 N m",
            "limits.power=100 W:900 W",
            "limits.hertz_pressure=20 MPa:200 MPa",
            "limits.pressure_angle=1 deg:20 deg",
        ],
        60,
    );
    let passing = loads.iter().filter(|p| p.0.failed.is_empty()).count();
    assert!((10..50).contains(&passing), "{passing}");
    equal(&loads);
    let feet = compared(
        &["law.family=harmonic", "gait.model=li-2010"],
        &[
            "gait.step_frequency=1.6 Hz:2.2 Hz",
            "law.harmonics=5,20",
            "accuracy.rms=1 %:30 %",
        ],
        12,
    );
    let spectral = |row: &Row| row.tier == Some(crate::synth::Tier::Spectral);
    assert!(feet.iter().filter(|p| spectral(&p.0)).count() > 3);
    equal(&feet);
}

#[test]
fn faults_are_rows() {
    let pairs = compared(
        &[],
        &[
            "cam.base_radius=4 mm:8 mm",
            "limits.force_min=100 N:1200 N",
            "limits.force_max=500 N:900 N",
            "law.family=program",
        ],
        12,
    );
    equal(&pairs);
    assert!(pairs.iter().all(|p| p.0.outcome == Outcome::Error));
}

/// Row for one varied value, and row of a single synthesis of the scene with this value.
fn swept_and_single(changes: &[&str], vary: &str) -> (Row, Row) {
    let mut table: Table = scene::DEFAULT.parse().unwrap();
    for change in changes {
        scene::set(&mut table, change).unwrap();
    }
    let plan = Plan::of(table.clone(), &[vary], Sampling::Grid).unwrap();
    plan.validate().unwrap();
    let kernel = Kernel::new(&plan, &NONE, &Halt::never, None);
    let batch = plan.batch(0, 1);
    let row = kernel.row(&batch, 0, &mut kernel.base(&batch, 0));
    scene::set(&mut table, vary).unwrap();
    let scene = scene::read(&table).unwrap();
    // This kernel has an empty cache.
    let other = Kernel::new(&plan, &NONE, &Halt::never, None);
    (row, other.designed_row(0, &scene, &source(0, &scene)))
}

#[test]
fn keys_of_force_machine_and_lists_give_what_a_single_synthesis_gives() {
    let size = "cam.base_radius=80 mm";
    let roller = [
        "cam.follower=roller-translating",
        "cam.roller_radius=10 mm",
        "cam.prime_radius=80 mm",
        "limits.stroke=90 mm",
    ];
    let mut pairs = Vec::new();
    for (changes, vary) in [
        (&[][..], "gait.phase=40 deg"),
        (&[], "gait.phase=free"),
        (&[], "gait.band=25 N"),
        (&[size], "limits.torque=12 N m"),
        (&[size], "limits.torque_rate=60 N m/rad"),
        (&[size], "limits.hertz_pressure=150 MPa"),
        (&roller, "limits.hertz_pressure=400 MPa"),
        (&["limits.torque=30 N m", size], "machine.friction=0.1"),
        (&[], "machine.natural_frequency=40 Hz"),
        (&["law.harmonics=4"], "law.family=auto"),
        (&["cam.bore=20 mm"], "cam.thickness=12 mm"),
    ] {
        let pair = swept_and_single(changes, vary);
        assert!(pair.0.error.is_empty(), "{vary}: {}", pair.0.error);
        pairs.push(pair);
    }
    equal(&pairs);
}

#[test]
fn entries_of_a_list_vary_by_their_number() {
    let program = [
        "law.family=program",
        "law.segment=[{motion = \"cycloidal\", lift = \"10 mm\", angle = \"180 deg\"}, \
         {motion = \"3-4-5\", lift = \"-10 mm\", angle = \"180 deg\"}]",
    ];
    let pair = swept_and_single(&program, "law.segment.2.motion=4-5-6-7");
    assert!(pair.0.error.is_empty(), "{}", pair.0.error);
    let other = swept_and_single(&program, "law.segment.2.motion=3-4-5");
    assert!(pair.0.numbers[12] != other.0.numbers[12]);
    equal(&[pair, other]);
}

/// If a number of the recording varies, each row has a separate force.
#[test]
fn a_recording_is_read_with_the_numbers_of_its_row() {
    let text = "[gait]\nfile = \"walk.csv\"\nperiod = \"1 s\"\n[law]\nfamily = \"harmonic\"\n";
    let vary = ["gait.period=0.5 s:1 s:5"];
    let plan = Plan::of(text.parse().unwrap(), &vary, Sampling::Grid).unwrap();
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / 256.0;
    let force = (0..256).map(|i| 700.0 + 200.0 * angle(i).sin());
    let curve = ForceCurve::from_samples("walk", 1.0, force.collect()).unwrap();
    let files = Files::from([(
        (0, "walk.csv".to_string()),
        Arc::new(curve.to_csv(&[]).into_bytes()),
    )]);
    let kernel = Kernel::new(&plan, &files, &Halt::never, None);
    let results = kernel.run(&plan.batch(0, 5), &|| false).unwrap();
    let speed = NUMBERS
        .iter()
        .position(|n| *n == "speed_rad_per_s")
        .unwrap();
    for (row, found) in results.iter().map(|r| r.numbers[speed]).enumerate() {
        let expected = std::f64::consts::TAU / (0.5 + 0.125 * row as f64);
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
}
