//! The formulas in the catalogue are evaluated as written and agree with the laws.

use gaitcam::law::Rise;
use std::f64::consts::PI;

/// Parser state of a formula: the rest of the text, x, and the peak acceleration.
struct Reader<'a> {
    rest: &'a str,
    x: f64,
    ca: f64,
}

impl Reader<'_> {
    fn takes(&mut self, c: char) -> bool {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix(c) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn sum(&mut self) -> f64 {
        let mut total = if self.takes('−') {
            -self.product()
        } else {
            self.product()
        };
        loop {
            if self.takes('+') {
                total += self.product();
            } else if self.takes('−') {
                total -= self.product();
            } else {
                return total;
            }
        }
    }

    /// Product of the next factors. Adjacent factors are multiplied; `/` divides by the next factor.
    fn product(&mut self) -> f64 {
        let mut value = self.power().expect("a factor");
        loop {
            if self.takes('/') {
                value /= self.power().expect("a divisor");
            } else if let Some(factor) = self.power() {
                value *= factor;
            } else {
                return value;
            }
        }
    }

    fn power(&mut self) -> Option<f64> {
        let base = self.factor()?;
        for (n, sign) in "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().enumerate() {
            if self.rest.starts_with(sign) {
                self.takes(sign);
                return Some(base.powi(n as i32));
            }
        }
        Some(base)
    }

    fn factor(&mut self) -> Option<f64> {
        let digits = |c: char| c.is_ascii_digit() || c == '.';
        self.rest = self.rest.trim_start();
        for (word, value) in [
            ("Ca", self.ca),
            ("x", self.x),
            ("π", PI),
            ("½", 0.5),
            ("¼", 0.25),
            ("¾", 0.75),
            ("⅛", 0.125),
            ("⅜", 0.375),
            ("⅝", 0.625),
            ("⅞", 0.875),
        ] {
            if let Some(rest) = self.rest.strip_prefix(word) {
                self.rest = rest;
                return Some(value);
            }
        }
        for (word, function) in [
            ("sin", f64::sin as fn(f64) -> f64),
            ("cos", f64::cos),
            ("", |y| y),
        ] {
            if let Some(rest) = self.rest.strip_prefix(word).filter(|r| r.starts_with('(')) {
                self.rest = &rest[1..];
                let inner = self.sum();
                assert!(self.takes(')'));
                return Some(function(inner));
            }
        }
        let end = self.rest.find(|c| !digits(c)).unwrap_or(self.rest.len());
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        number.parse().ok()
    }
}

fn value(text: &str, x: f64, ca: f64) -> f64 {
    let mut reader = Reader { rest: text, x, ca };
    let value = reader.sum();
    assert!(
        reader.rest.trim().is_empty(),
        "{text} is read as far as {:?}",
        reader.rest
    );
    value
}

/// Piece of a formula for x.
fn piece(pieces: &str, x: f64) -> &str {
    for piece in pieces.split("; ") {
        match piece.split_once(" | x ≤ ") {
            Some((_, until)) if x > value(until, x, 0.0) => {}
            Some((formula, _)) => return formula,
            None => return piece,
        }
    }
    panic!("no piece at {x}")
}

#[test]
fn every_formula_of_the_catalogue_is_its_law() {
    for rise in Rise::catalogue() {
        let (what, pieces) = rise.formula().split_once(" = ").unwrap();
        let law = rise.law().unwrap();
        let ca = rise.factors().unwrap().ca;
        for k in 0..97 {
            // No x is the end of a piece.
            let x = (k as f64 + 0.37) / 97.0;
            let at = law.svaj(x);
            let wanted = if what == "s" { at.s } else { at.a };
            let stated = value(piece(pieces, x), x, ca);
            assert!(
                (stated - wanted).abs() < 1e-11 * (1.0 + ca),
                "{} at {x}: {stated}, {wanted}",
                rise.name()
            );
        }
    }
}
