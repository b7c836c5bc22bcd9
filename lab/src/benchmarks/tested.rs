//! Requirements of accuracy that tests check.

/// Area, requirement, and the test that checks it.
pub(crate) const TESTED: [(&str, &str, &str); 20] = [
    (
        "main job",
        "C3…C8 of the heel tester to 0.001, theory §2 to 4 digits",
        "main_job",
    ),
    (
        "main job",
        "peaks of the fitted heel tester to 0.01 lb, none above 110.29 lb",
        "main_job",
    ),
    (
        "main job",
        "footbridge ≤ 0.5 % RMS with ≤ 24 spans, stroke 49.2 ± 0.2 mm",
        "main_job",
    ),
    (
        "main job",
        "envelope to 1e-9 m, gap below 1e-7 m at 1440 points",
        "put_back",
    ),
    (
        "synthesis",
        "optima of theory §8 to 1e-6",
        "unit tests of synth",
    ),
    (
        "synthesis",
        "prime circles of theory §6 to 1e-6",
        "cam_geometry",
    ),
    (
        "synthesis",
        "co-designed heel tester: prime radius ≤ 2.05 in",
        "main_job",
    ),
    (
        "synthesis",
        "no limit exceeded by more than 1e-9 on 100 000 points",
        "random_scenes",
    ),
    ("cams", "factors of theory §7 to 1e-5", "laws"),
    ("cams", "theory §2–§5 recomputed", "reproduce"),
    ("cams", "conjugates to 1e-12, breadth to 1e-9 m", "cams"),
    (
        "force",
        "stances, mass and peaks of every file",
        "gait_files, gait_c3d",
    ),
    ("force", "float and integer copies within 0.1 N", "gait_c3d"),
    (
        "dynamics",
        "rigid and contact agree to 1e-6 N below lift-off",
        "unit tests of dynamics",
    ),
    (
        "dynamics",
        "lift-off speeds to 1e-6, residual vibrations to 1e-6",
        "unit tests of dynamics",
    ),
    (
        "dynamics",
        "a lossless bounce keeps its energy to 1e-9 over 1000 impacts",
        "unit tests of dynamics",
    ),
    (
        "sweep",
        "killed and resumed sweeps end in the same table",
        "sweep",
    ),
    (
        "sweep",
        "10 million rows in Parquet ≤ 3 minutes, resumed in ≤ 5 s",
        "by hand: 20 s, 0.06 s",
    ),
    (
        "evidence",
        "integrators break where theory §10 says, to 1 %",
        "stability",
    ),
    ("evidence", "profile.dxf within 0.1 µm", "emit"),
];
