"""Areas of the mutation tests, and the faults written by hand."""

import collections

# Package with its handwritten faults, its files as arguments of cargo-mutants, and the sampled fraction 1/n of its mutants. Then test programs with
# filters of tests: those that run first, and the other ones.
Area = collections.namedtuple("Area", "package files one_in first then")
# Inputs from which cargo builds a test program.
KINDS = {"lib": ["--lib"], "it": ["--test", "it"]}


# Tests of the library that are left out: those of more than five seconds, those of its texts and examples, and the test of the
# module order, which does not contain the switches. One of them might still detect a mutant that survives here.
LEFT_OUT = ["layering", "readme", "examples", "wording", "random", "guard", "spans", "widened", "inspect", "leave_no_law",
            "leaves_no_law", "that_fights", "the_smallest_cam_under", "follower_that_swings", "reads_back_exactly"]


def library(*filters):
    skipped = [argument for name in LEFT_OUT for argument in ("--skip", name)]
    return [("gaitcam", "lib", list(filters)), ("gaitcam", "it", [*filters, *skipped])]


def gait(*filters):
    return [("gaitcam-gait", "lib", []), ("gaitcam-gait", "it", list(filters))]


AREAS = {
    "proof": Area("splineqp", ["crates/splineqp/src/certificate*", "src/synth/report/proof.rs"], 5,
                  [("splineqp", "lib", []), ("splineqp", "it", [])], library("proof") + library()),
    "checks": Area("gaitcam", ["src/cam/check*", "src/synth/verdict.rs"], 4,
                   library("verdict", "checks", "refused"), library()),
    "size": Area("gaitcam", ["src/cam/size*", "src/synth/sizing/*.rs"], 9, library("siz", "cam::"), library()),
    "limits": Area("gaitcam", ["src/synth/limits/*.rs"], 30, library("limits"), library()),
    "moving floor": Area("gaitcam", ["src/dynamics/floor.rs", "src/synth/machine/through_floor.rs", "src/synth/optimum/force_price.rs"], 8,
                         library("floor"), library()),
    "suggestions": Area("gaitcam", ["src/synth/relaxation/*.rs"], 15, library("relaxation", "refusal"), library()),
    "cycle averages": Area("gaitcam-gait", ["crates/gait/src/cycle/*.rs", "crates/gait/src/statistics.rs"], 30,
                           gait("cycle", "joint"), gait()),
    "rigid torque": Area("gaitcam", ["src/dynamics/rigid/**/*.rs"], 10, library("dynamics"), library()),
    "result folder": Area("gaitcam-app", ["crates/app/src/result_folder*"], 1, [("gaitcam-app", "lib", [])],
                          [("gaitcam-cli", "it", ["files::"])]),
    "table reader": Area("gaitcam-gait", ["crates/gait/src/read/text/*.rs", "crates/gait/src/read/c3d/*.rs"], 35,
                         gait("c3d", "layouts"), gait()),
}

# An expression that occurs once in a file, and its replacement.
Fault = collections.namedtuple("Fault", "name area file old new")

FAULTS = [
    Fault("every upper check 1e-5 looser", "checks", "src/cam/checks.rs",
          "limit + direction.sign() * slack * limit.abs()", "limit + direction.sign() * (slack + 1e-5) * limit.abs()"),
    Fault("certified without a look at the violation", "proof", "src/synth/report/proof.rs",
          "!certificate.keeps_limits()", "false"),
    Fault("certified at a gap of 1e-3", "proof", "crates/splineqp/src/certificate.rs",
          "self.relative_gap <= PROVED", "self.relative_gap <= 1e-3"),
    Fault("the other sign of an offset candidate", "size", "src/cam/size.rs", "(t2, -1.0, p2),", "(t2, -1.0, -p2),"),
    Fault("a base radius below 0", "size", "src/cam/size.rs", "(rho_min - low.value).max(0.0)", "rho_min - low.value"),
    Fault("spread of cycles over n", "cycle averages", "crates/gait/src/cycle/average.rs",
          "self.count - 1.0", "self.count"),
    Fault("spread of a sample over n", "cycle averages", "crates/gait/src/statistics.rs",
          "(values.len() as f64 - 1.0)", "values.len() as f64"),
    Fault("friction's sign with the turn", "rigid torque", "src/dynamics/rigid/mod.rs",
          "let rub = friction * drive.speed.signum();", "let rub = friction;"),
    Fault("torque as a polynomial where the force pulls", "rigid torque", "src/dynamics/rigid/mod.rs",
          "rub != 0.0 && drive.force_extremes(law).0.value < 0.0", "false"),
    Fault("one channel past the last", "table reader", "crates/gait/src/read/c3d/plates.rs",
          "**n <= analog.channels as f64", "**n <= analog.channels as f64 + 1.0"),
    Fault("undercut 1 mm late", "checks", "src/cam/geometry/shape.rs", "convex.value < 0.0", "convex.value < -1e-3"),
    Fault("a gradient's sign", "limits", "src/synth/limits/pressure_angle.rs", "-side * moves * arm", "side * moves * arm"),
    Fault("missing damping", "limits", "src/synth/limits/dwell_vibration.rs",
          "train.damping + drive.damping", "train.damping"),
    Fault("a velocity jump not judged", "checks", "src/synth/verdict.rs", "jump(cam, k)", "jump(cam, k).filter(|_| k != 1)"),
]
