//! The pictures of reports/dynamics.md.

use crate::chart::{self, Across, Chart, Row};
use crate::experiment::peers::rapier;
use crate::experiment::pictures::{Picture as Curves, pictures};
use gaitcam::error::Result;
use gaitcam_output::overlay::{Strip, diagrams};
use gaitcam_output::picture::Picture;

/// Every picture of the report with its file name. Fails as the report does.
pub fn all() -> Result<Vec<(&'static str, Picture)>> {
    let mut out: Vec<(&'static str, Picture)> = pictures()?
        .iter()
        .map(|p| match p.logarithmic {
            true => (p.name, against_points(p)),
            false => (p.name, over_the_turn(p)),
        })
        .collect();
    out.push(("dynamics_rapier", against_time()));
    Ok(out)
}

fn over_the_turn(p: &Curves) -> Picture {
    let names: Vec<String> = p.curves.iter().map(|c| c.name.clone()).collect();
    let strip = Strip {
        quantity: p.y.to_string(),
        curves: p.curves.iter().map(|c| c.points.clone()).collect(),
    };
    diagrams(p.title, "", &names, &[strip])
}

fn chart(file: &str, title: &str, error: &str, across: Across, rows: Vec<Row>) -> Chart {
    Chart {
        file: file.to_string(),
        title: title.to_string(),
        error: error.to_string(),
        across,
        rows,
        ..Chart::default()
    }
}

fn row(method: &str, size: String, error: f64, seconds: f64, points: Option<usize>) -> Row {
    Row {
        method: method.to_string(),
        size,
        error,
        seconds,
        quartiles: (seconds, seconds),
        runs: 1,
        points,
        ..Row::default()
    }
}

fn against_points(p: &Curves) -> Picture {
    let rows = p
        .curves
        .iter()
        .flat_map(|c| {
            c.points
                .iter()
                .map(|&(n, e)| row(&c.name, format!("{n}"), e, 0.0, Some(n as usize)))
        })
        .collect();
    chart::picture(&chart(p.name, p.title, p.y, Across::Points, rows))
}

/// Height error of events and time steps against the wall time of a turn.
fn against_time() -> Picture {
    let rows = rapier()
        .into_iter()
        .map(|p| row(&p.method, p.size, p.rms, p.seconds, None))
        .collect();
    chart::picture(&chart(
        "dynamics_rapier",
        "Eccentric at 35 rad/s: height error of one turn",
        "RMS error of the height, m",
        Across::Time,
        rows,
    ))
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_picture_the_report_names_is_drawn() {
        let text = crate::experiment::report().unwrap();
        let pictures = super::all().unwrap();
        for (name, picture) in &pictures {
            assert!(text.contains(&format!("({name}.png)")), "{name}");
            assert!(!picture.svg().contains("NaN"), "{name}");
        }
        assert_eq!(text.matches(".png)").count(), pictures.len());
    }
}
