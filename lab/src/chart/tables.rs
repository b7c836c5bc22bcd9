//! Rows as CSV and as a page of Markdown.

use std::fmt::Write;

use super::{Across, Chart, Row};
use crate::markdown::{duration, table};

/// CSV of every row of every chart.
pub fn csv(charts: &[Chart]) -> String {
    let mut out = String::from(
        "chart,method,size,error,error_meaning,median_s,quartile1_s,quartile3_s,runs,points,default,on_front,note\n",
    );
    for chart in charts {
        let front = chart.front();
        for (i, r) in chart.rows.iter().enumerate() {
            let points = r.points.map_or(String::new(), |p| p.to_string());
            // Writing to a String cannot fail.
            let _ = writeln!(
                out,
                "{},{},{},{:e},{},{:e},{:e},{:e},{},{points},{},{},{}",
                chart.file,
                quoted(&r.method),
                quoted(&r.size),
                r.error,
                quoted(&chart.error),
                r.seconds,
                r.quartiles.0,
                r.quartiles.1,
                r.runs,
                r.default,
                front.contains(&i),
                quoted(&r.note)
            );
        }
    }
    out
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_string()
    }
}

/// Page with one section per chart. `machine` describes the computer; `after` is appended.
pub fn markdown(charts: &[Chart], machine: &str, after: &str) -> String {
    let mut out = format!(
        "# Speed against accuracy\n\nMeasured by `gaitcam-lab chart` in one run. {machine}\n\n\
         Times are medians of runs inside one process after a warm-up, with the first and third quartile. \
         ● marks the Pareto front: no other row is both faster and more accurate. \
         ★ marks the default of gaitcam.\n\n## Recommendations\n\n"
    );
    for chart in charts {
        let _ = writeln!(out, "- **{}** {}", chart.title, chart.advice);
    }
    for chart in charts {
        section(&mut out, chart, true);
    }
    out.push_str(after);
    out
}

/// Writes the table of one chart with its task and advice, and its picture if `drawn` is set.
pub fn section(out: &mut String, chart: &Chart, drawn: bool) {
    let front = chart.front();
    let verdict = match (chart.default_on_front(), chart.ahead_of_default()) {
        (None, _) => String::new(),
        (_, None) => " The default lies on the front.".to_string(),
        (_, Some((row, share))) => format!(
            " The default does not lie on the front: {} ({}) reaches its error in {:.0} % of its cost.",
            row.method,
            row.size,
            100.0 * share
        ),
    };
    // Writing to a String cannot fail.
    let _ = write!(out, "\n## {}\n\n{}\n\n", chart.title, chart.task);
    if drawn {
        let _ = write!(
            out,
            "![{}]({}.png)\n\n{}{verdict}\n\n",
            chart.title, chart.file, chart.advice
        );
    }
    // Columns of marks and points, if the chart has any.
    let is_marked = !front.is_empty() || chart.rows.iter().any(|r| r.default);
    let has_points = chart.across == Across::Points;
    let mut head = vec!["method", "size", &chart.error, "time", "quartiles"];
    head.extend(has_points.then_some("points"));
    head.push("remark");
    if is_marked {
        head.insert(0, "");
    }
    let row = |(i, r): (usize, &Row)| {
        let [low, high] = [r.quartiles.0, r.quartiles.1].map(duration);
        let mut cells = vec![r.method.clone(), r.size.clone(), size_of(r.error)];
        cells.extend([duration(r.seconds), format!("{low} … {high}")]);
        cells.extend(has_points.then(|| r.points.map_or(String::new(), |p| p.to_string())));
        cells.push(r.note.clone());
        if is_marked {
            let marks = [(front.contains(&i), "●"), (r.default, "★")];
            cells.insert(
                0,
                marks
                    .into_iter()
                    .filter_map(|(is, mark)| is.then_some(mark))
                    .collect(),
            );
        }
        cells
    };
    out.push_str(&table(&head, chart.rows.iter().enumerate().map(row)));
}

fn size_of(error: f64) -> String {
    if !error.is_finite() {
        "fails".to_string()
    } else if error == 0.0 {
        "0".to_string()
    } else {
        format!("{error:.2e}")
    }
}
