//! The rows as csv and as a page of Markdown.

use std::fmt::Write;

use super::{Across, Chart};

/// Every row of every chart.
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

/// A page with one section per chart; `machine` says where it was measured, `after` follows at the end.
pub fn markdown(charts: &[Chart], machine: &str, after: &str) -> String {
    let mut out = format!(
        "# Speed against accuracy\n\nMeasured by `gaitcam-lab chart` in one run. {machine}\n\n\
         Times are medians of runs inside one process after a warm-up, with the first and third quartile. \
         ● lies on the Pareto front: no other row is both faster and nearer to the truth. \
         ★ is what gaitcam does when nothing else is asked.\n\n## What to choose\n\n"
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

/// The table of one chart with its task and advice, and its picture where one is `drawn`.
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
    let (points, rule) = if chart.across == Across::Points {
        (" points |", "---|")
    } else {
        ("", "")
    };
    // A column of marks where there are any.
    let is_marked = !front.is_empty() || chart.rows.iter().any(|r| r.default);
    let (marks, marks_rule) = if is_marked { ("| ", "|---") } else { ("", "") };
    let _ = write!(
        out,
        "{marks}| method | size | {} | time | quartiles |{points} remark |\n{marks_rule}|---|---|---|---|---|{rule}---|\n",
        chart.error,
    );
    for (i, r) in chart.rows.iter().enumerate() {
        let mut mark = String::from(marks);
        if front.contains(&i) {
            mark.push('●');
        }
        if r.default {
            mark.push('★');
        }
        if is_marked {
            mark.push(' ');
        }
        let points = match (chart.across, r.points) {
            (Across::Points, Some(p)) => format!(" {p} |"),
            (Across::Points, None) => " |".to_string(),
            _ => String::new(),
        };
        let _ = writeln!(
            out,
            "{mark}| {} | {} | {} | {} | {} … {} |{points} {} |",
            r.method,
            r.size,
            size_of(r.error),
            duration(r.seconds),
            duration(r.quartiles.0),
            duration(r.quartiles.1),
            r.note
        );
    }
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

/// A time in the unit that suits it.
fn duration(seconds: f64) -> String {
    if seconds < 1e-6 {
        format!("{:.0} ns", 1e9 * seconds)
    } else if seconds < 1e-3 {
        format!("{:.1} µs", 1e6 * seconds)
    } else if seconds < 1.0 {
        format!("{:.2} ms", 1e3 * seconds)
    } else {
        format!("{seconds:.2} s")
    }
}
