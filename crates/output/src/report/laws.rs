//! `laws.html`: the catalogue of rise laws with formulas, curves, peak factors and when to choose each.

use std::fmt::Write;

use super::{head, paragraph};
use crate::words::{self, Words};
use gaitcam::error::Result;
use gaitcam::law::{Factors, Law, Rise};
use gaitcam::wording::Language;
use gaitcam_base::text::escaped;

/// Points of a curve.
const POINTS: usize = 160;
/// Size of a panel and the room above and below its curve.
const PANEL: [f64; 2] = [180.0, 110.0];
const MARGIN: f64 = 12.0;

/// The page.
///
/// # Errors
/// None that a law of the catalogue has.
pub fn html(language: Language) -> Result<String> {
    let words = words::words(language);
    let mut out = String::with_capacity(1 << 17);
    let title = words.text("laws-title");
    head(&mut out, &title, &words);
    // Writing to a String cannot fail, here and below.
    let _ = writeln!(out, "<header><div><h1>{}</h1>", escaped(&title));
    paragraph(&mut out, &words.text("laws-lead"));
    out.push_str("</div></header>\n<main>\n");
    for rise in Rise::catalogue() {
        section(&mut out, &rise, &words)?;
    }
    out.push_str("</main>\n<footer>\n");
    paragraph(&mut out, &words.text("laws-footer"));
    out.push_str("</footer>\n</body>\n</html>\n");
    Ok(out)
}

/// When to choose a law of the catalogue, in the words of a language.
pub fn advice(rise: &Rise, language: Language) -> String {
    words::words(language).text(&format!("laws-use-{}", rise.name()))
}

fn section(out: &mut String, rise: &Rise, words: &Words) -> Result<()> {
    let (law, factors, ends) = (rise.law()?, rise.factors()?, rise.ends()?);
    let name = rise.name();
    let heading = escaped(&words.name(name));
    let _ = writeln!(
        out,
        "<section id=\"{name}\">\n<h2>{heading}</h2>\n<p><code>motion = \"{name}\"</code></p>"
    );
    for piece in rise.formula().split("; ") {
        let _ = writeln!(out, "<p><code>{}</code></p>", escaped(piece));
    }
    paragraph(out, &advice(rise, words.language()));
    let joins = [ends.start, ends.end].map(|end| end.joins_in(words.language()));
    let [start, end] = &joins;
    let key = if start == end {
        "laws-joins-both"
    } else {
        "laws-joins-each"
    };
    paragraph(out, &words.fill(key, &[("start", start), ("end", end)]));
    panels(out, &law, &factors, words);
    out.push_str("</section>\n");
    Ok(())
}

/// s, v, a, j side by side, each with its largest magnitude.
fn panels(out: &mut String, law: &Law, factors: &Factors, words: &Words) {
    let (start, length) = law.extent();
    let at = |i: usize| law.svaj(start + length * i as f64 / POINTS as f64);
    let rows: Vec<_> = (0..=POINTS).map(at).collect();
    let torque = words.fill("laws-torque", &[("ct", &words.number(factors.ct))]);
    let peaks = [
        ("s", 1.0, "blue"),
        ("v", factors.cv, "green"),
        ("a", factors.ca, "orange"),
        ("j", factors.cj, "red"),
    ];
    out.push_str("<div class=\"laws\">\n");
    for (k, (name, peak, colour)) in peaks.into_iter().enumerate() {
        let curve: Vec<f64> = rows.iter().map(|r| [r.s, r.v, r.a, r.j][k]).collect();
        let symbol = if k == 0 {
            name.to_string()
        } else {
            format!("C{name}")
        };
        let caption = format!("{symbol} = {}", words.number(peak));
        let _ = writeln!(
            out,
            "<figure>{}<figcaption>{}</figcaption></figure>",
            panel(&curve, colour, &caption),
            escaped(&caption)
        );
    }
    let _ = writeln!(out, "</div>\n<p class=\"note\">{}</p>", escaped(&torque));
}

/// One curve over x from 0 to 1, with the line of zero.
fn panel(curve: &[f64], colour: &str, label: &str) -> String {
    let [width, height] = PANEL;
    let finite = || curve.iter().copied().filter(|y| y.is_finite());
    let (low, high) = finite().fold((0.0_f64, 0.0_f64), |(l, h), y| (l.min(y), h.max(y)));
    let range = if high > low { high - low } else { 1.0 };
    let x = |i: usize| MARGIN + (width - 2.0 * MARGIN) * i as f64 / (curve.len() - 1) as f64;
    let y = |value: f64| height - MARGIN - (height - 2.0 * MARGIN) * (value - low) / range;
    let points: Vec<String> = (curve.iter().enumerate())
        .filter(|(_, v)| v.is_finite())
        .map(|(i, v)| format!("{:.1},{:.1}", x(i), y(*v)))
        .collect();
    let zero = y(0.0);
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">\
         <line x1=\"{MARGIN}\" y1=\"{zero:.1}\" x2=\"{:.1}\" y2=\"{zero:.1}\" stroke=\"var(--axis)\"/>\
         <polyline points=\"{}\" fill=\"none\" stroke=\"var(--{colour})\" stroke-width=\"2\" stroke-linejoin=\"round\"/></svg>",
        escaped(label),
        width - MARGIN,
        points.join(" ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_law_has_its_words_in_both_languages() {
        for language in [Language::En, Language::Es] {
            let page = html(language).unwrap();
            assert!(
                !page.contains("laws-"),
                "{:?}",
                page.find("laws-").map(|i| &page[i..i + 40])
            );
            let named = gaitcam::wording::catalogue(language).keys();
            for rise in Rise::catalogue() {
                let name = rise.name();
                assert!(
                    named.contains(&format!("name-{name}")),
                    "{language:?}: {name}"
                );
                let heading = escaped(&words::words(language).name(name));
                assert!(page.contains(&format!("<h2>{heading}</h2>")), "{heading}");
            }
            assert_eq!(page.matches("<section").count(), Rise::catalogue().len());
            assert_eq!(
                page.matches("<polyline").count(),
                4 * Rise::catalogue().len()
            );
        }
    }
}
