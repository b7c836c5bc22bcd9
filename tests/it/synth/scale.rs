//! Scale invariance. All lengths of a scene are multiplied by a factor, and speed and forces change so that the equations stay the same. The cam is
//! then the same, multiplied by this factor.

use gaitcam::synth::Design;

/// Length scales from an atom to a crater.
const SCALES: [f64; 7] = [1e-9, 1e-6, 1e-4, 1e-2, 1e1, 1e2, 1e3];

fn design(text: &str) -> Design {
    gaitcam_test_support::design::<&str>(text, &[]).unwrap()
}

const POINTS: &str = "minimise = \"jerk\"\n[[law.point]]\nangle = \"0 deg\"\nlift = \"0\"\nvelocity = \"0\"\n[[law.point]]\nangle = \"120 deg\"\nlift = \"{0.012} m\"\n[[law.point]]\nangle = \"230 deg\"\nlift = \"{0.005} m\"\n";

/// Table `[law]` of a spline through the points with `spans` spans.
fn law(spans: usize) -> String {
    format!("[law]\nfamily = \"spline\"\nspans = {spans}\n{POINTS}")
}

/// Law for the smallest cam.
fn sized() -> String {
    law(24).replace("minimise = \"jerk\"", "minimise = \"size\"")
}

fn scene(law: &str, cam: &str) -> String {
    let mass = if cam.contains("oscillating") {
        ""
    } else {
        "mass = \"2 kg\"\n"
    };
    let drive = format!("[drive]\nkind = \"fixed-axis\"\nspeed = \"10 rad/s\"\n{mass}");
    format!("name = \"scale\"\n{drive}{law}[cam]\n{cam}")
}

/// Scenes in which `{x}` stands for x metres at a scale of 1.
fn scenes() -> Vec<(&'static str, String)> {
    [rollers(), flat_faces()].concat()
}

fn rollers() -> Vec<(&'static str, String)> {
    vec![
        (
            "roller, size after the law",
            scene(
                &law(24),
                "follower = \"roller-translating\"\nroller_radius = \"{0.006} m\"\noffset = \"0\"\n[limits]\npressure_angle = \"30 deg\"\ncurvature = \"{0.002} m\"\n",
            ),
        ),
        (
            "roller, size among the variables",
            scene(
                &sized(),
                "follower = \"roller-translating\"\nroller_radius = \"{0.006} m\"\n[limits]\npressure_angle = \"30 deg\"\ncurvature = \"{0.002} m\"\n",
            ),
        ),
        (
            "roller, size limited",
            scene(
                &law(24),
                "follower = \"roller-translating\"\nroller_radius = \"{0.006} m\"\n[limits]\npressure_angle = \"30 deg\"\ncurvature = \"{0.002} m\"\nprime_radius = \"{0.012} m\"\n",
            ),
        ),
        (
            "knife edge without a limit",
            scene(
                &law(16),
                "follower = \"knife-translating\"\noffset = \"0\"\n",
            ),
        ),
        (
            "arm, size after the law",
            scene(
                &law(24)
                    .replace("{0.012} m", "12 deg")
                    .replace("{0.005} m", "5 deg"),
                "follower = \"roller-oscillating\"\npivot_distance = \"{0.08} m\"\narm = \"{0.065} m\"\nroller_radius = \"{0.008} m\"\n[limits]\npressure_angle = \"40 deg\"\n",
            ),
        ),
    ]
}

fn flat_faces() -> Vec<(&'static str, String)> {
    vec![
        (
            "flat face, limits that bind",
            scene(
                &law(24),
                "follower = \"flat-translating\"\nbase_radius = \"{0.02} m\"\n[limits]\ncurvature = \"{0.009} m\"\nacceleration = \"{1.35} m/s^2\"\n",
            ),
        ),
        (
            "flat face, smallest size",
            scene(
                &sized(),
                "follower = \"flat-translating\"\n[limits]\ncurvature = \"{0.004} m\"\n",
            ),
        ),
        (
            "refused",
            scene(
                &law(24),
                "follower = \"flat-translating\"\nbase_radius = \"{0.02} m\"\n[limits]\nacceleration = \"{0.3} m/s^2\"\n",
            ),
        ),
    ]
}

/// Scene with every `{x}` replaced by x times the scale.
fn scaled(text: &str, scale: f64) -> String {
    let mut out = String::new();
    for (k, part) in text.split(['{', '}']).enumerate() {
        if k % 2 == 0 {
            out += part;
        } else {
            out += &format!("{:e}", scale * part.parse::<f64>().unwrap());
        }
    }
    out
}

#[test]
fn a_cam_has_no_scale() {
    for (name, text) in scenes() {
        let one = design(&scaled(&text, 1.0));
        for scale in SCALES {
            let other = design(&scaled(&text, scale));
            let told = format!("{name} at {scale:e}");
            assert_eq!(one.verdict, other.verdict, "{told}");
            assert_eq!(one.solver.certified, other.solver.certified, "{told}");
            assert_eq!(one.solver.tier.name(), other.solver.tier.name(), "{told}");
            // A sequence ends at its own tolerance.
            let same = if one.solver.steps.is_empty() {
                1e-8
            } else {
                1e-5
            };
            let near = |a: f64, b: f64, of: f64| (a - b).abs() <= same * of;
            let length = if name.starts_with("arm") { 1.0 } else { scale };
            let stroke = one.cam.law.stroke();
            for degree in 0..360 {
                let at = f64::from(degree).to_radians();
                let (a, b) = (one.cam.law.svaj(at), other.cam.law.svaj(at));
                assert!(near(a.s, b.s / length, stroke), "{told}, lift at {degree}");
                assert!(
                    near(a.a, b.a / length, 30.0 * stroke),
                    "{told}, acceleration at {degree}"
                );
            }
            let radii = [&one, &other].map(|d| d.cam.follower.base_radius());
            assert!(
                near(radii[0], radii[1] / scale, radii[0]),
                "{told}: {radii:?}"
            );
            for (a, b) in one.checks.iter().zip(&other.checks) {
                assert_eq!((a.name, a.pass), (b.name, b.pass), "{told}");
            }
        }
    }
}
