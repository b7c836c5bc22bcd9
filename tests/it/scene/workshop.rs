//! Materials of cam and follower, and the nameplate of a motor, in scenes.

use gaitcam::LimitKind;
use gaitcam::scene::{self, Scene};
use gaitcam::synth::{Figures, synthesise};
use std::f64::consts::TAU;

fn footbridge(changes: &[&str]) -> gaitcam::error::Result<Scene> {
    let mut table = scene::built_in("footbridge").unwrap().toml.parse().unwrap();
    for change in changes {
        scene::set(&mut table, change)?;
    }
    scene::read(&table)
}

fn pressure(changes: &[&str]) -> (f64, Option<f64>, bool) {
    let scene = footbridge(changes).unwrap();
    let design = synthesise(&scene, scene.model_force().unwrap().as_ref()).unwrap();
    let check = design
        .checks
        .iter()
        .find(|c| c.name == LimitKind::HertzPressure);
    let most = Figures::of(&design).machine.hertz_pressure_max_pa.unwrap();
    (most, check.map(|c| c.limit), check.is_none_or(|c| c.pass))
}

#[test]
fn pressure_falls_with_the_root_of_the_contact_modulus() {
    let size = "cam.base_radius=60 mm";
    let (steel, none, _) = pressure(&[size]);
    assert_eq!(none, None);
    // E* of steel on steel 113.6 GPa; of PLA on steel: 1/((1 − 0.36²)/3.3 + (1 − 0.3²)/206.8) GPa.
    let [of_steel, of_pla]: [f64; 2] = [(1.0 - 0.09) / 206.8, (1.0 - 0.36 * 0.36) / 3.3];
    let ratio = (2.0 * of_steel / (of_steel + of_pla)).sqrt();
    let (plastic, limit, passes) = pressure(&[size, "cam.material=pla"]);
    assert!((plastic / steel / ratio - 1.0).abs() < 1e-9);
    // First yield of 50 MPa under a line contact: p = Y/0.6.
    assert!((limit.unwrap() / (50e6 / 0.6) - 1.0).abs() < 1e-12);
    assert_eq!(passes, plastic <= 50e6 / 0.6);
    // Either body counts, in both languages, and constants of one's own.
    let same = pressure(&[size, "cam.follower_material=pla"]).0;
    assert!((same / plastic - 1.0).abs() < 1e-12);
    assert_eq!(
        pressure(&[size, "cam.material=Aluminio"]),
        pressure(&[size, "cam.material=aluminium"])
    );
    let own = ["cam.material.young=3.3 GPa", "cam.material.poisson=0.36"];
    let stated = pressure(&[&[size], &own[..]].concat());
    assert!((stated.0 / plastic - 1.0).abs() < 1e-12 && stated.1.is_none());
    let bears = [
        &[size],
        &own[..],
        &["cam.material.allowable_pressure=20 MPa"],
    ]
    .concat();
    assert_eq!(pressure(&bears).1, Some(20e6));
    // A designation of steel, and a limit that the scene states itself.
    assert_eq!(
        pressure(&[size, "cam.material=42CrMo4"]),
        (steel, None, true)
    );
    let stated = ["cam.material=pla", "limits.hertz_pressure=70 MPa"];
    assert_eq!(pressure(&[&[size], &stated[..]].concat()).1, Some(70e6));
    let off = ["cam.material=pla", "limits.hertz_pressure=none"];
    assert_eq!(pressure(&[&[size], &off[..]].concat()).1, None);
    let hard = ["cam.hardness=58 HRC"];
    let borne = pressure(&[&[size], &hard[..]].concat()).1.unwrap();
    assert!((borne / (2.76e6 * 615.0 - 70e6) - 1.0).abs() < 1e-12);
    let unknown = footbridge(&["cam.follower_material=wood"]).unwrap_err();
    assert_eq!(unknown.code(), "scene-unknown-word");
}

#[test]
fn a_nameplate_is_the_line_between_rated_and_synchronous_speed() {
    let rpm = TAU / 60.0;
    let plate = [
        "machine.motor.rated_torque=5.1 N m",
        "machine.motor.rated_speed=1395 rpm",
        "machine.motor.gear=12.7",
        "machine.motor.inertia=18.3 kg cm^2",
        "machine.inertia=0.35 kg m^2",
    ];
    let motor = footbridge(&plate).unwrap().machine.motor().unwrap();
    let rated = motor.torque(1395.0 * rpm / 12.7, 1500.0 * rpm / 12.7)[0];
    assert!((rated / (12.7 * 5.1) - 1.0).abs() < 1e-12);
    assert!((motor.nominal.unwrap() - 1500.0 * rpm / 12.7).abs() < 1e-12);
    assert!((motor.inertia - 0.35 - 18.3e-4 * 12.7 * 12.7).abs() < 1e-12);
    // 60 Hz, eight poles, and a synchronous speed that is stated.
    for (speed, synchronous) in [
        (1725.0, 1800.0),
        (2850.0, 3000.0),
        (700.0, 750.0),
        (1140.0, 1200.0),
    ] {
        let speed = format!("machine.motor.rated_speed={speed} rpm");
        let motor = footbridge(&[&plate[..], &[&speed]].concat())
            .unwrap()
            .machine
            .motor();
        assert!((motor.unwrap().nominal.unwrap() * 12.7 / rpm - synchronous).abs() < 1e-9);
    }
    let code = |change: &str| {
        footbridge(&[&plate[..], &[change]].concat())
            .unwrap_err()
            .code()
    };
    assert_eq!(
        code("machine.motor.synchronous_speed=1390 rpm"),
        "scene-not-synchronous"
    );
    assert_eq!(code("machine.motor.slope=10 N m s/rad"), "scene-motor-line");
    let half = footbridge(&[
        "machine.motor.rated_torque=5 N m",
        "machine.inertia=1 kg m^2",
    ]);
    assert_eq!(half.unwrap_err().code(), "scene-half-nameplate");
    // The rotor alone may be all that turns.
    let alone = footbridge(&plate[..4]).unwrap().machine.motor().unwrap();
    assert!((alone.inertia - 18.3e-4 * 12.7 * 12.7).abs() < 1e-12);
}
