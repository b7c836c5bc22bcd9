//! Reading a TOML table key by key: every fault names its key, unknown keys name their nearest neighbour.

use toml::{Table, Value};

use crate::error::{Error, Result, nearest};
use crate::units::{Dimension, parse};

/// A table being read; keys asked for are remembered, so that the others can be refused.
pub struct Reader<'a> {
    table: &'a Table,
    path: String,
    known: Vec<&'static str>,
}

/// A number or the word "auto".
pub type OrAuto = Option<f64>;

impl<'a> Reader<'a> {
    /// Reads `table`, known to the user as `path` ("" for the whole file).
    pub fn new(table: &'a Table, path: &str) -> Self {
        Reader {
            table,
            path: path.to_string(),
            known: Vec::new(),
        }
    }

    /// The dotted name of a key.
    pub fn name(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_string()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    fn get(&mut self, key: &'static str) -> Option<&'a Value> {
        self.known.push(key);
        self.table.get(key)
    }

    /// A sub-table, if present.
    pub fn table(&mut self, key: &'static str) -> Result<Option<Reader<'a>>> {
        match self.get(key) {
            None => Ok(None),
            Some(Value::Table(t)) => Ok(Some(Reader::new(t, &self.name(key)))),
            Some(other) => Err(self.wrong(
                key,
                other,
                &format!("write it as a table, [{}]", self.name(key)),
            )),
        }
    }

    /// An array of tables; empty if absent.
    pub fn tables(&mut self, key: &'static str) -> Result<Vec<Reader<'a>>> {
        let help = format!("write each as [[{}]]", self.name(key));
        match self.get(key) {
            None => Ok(Vec::new()),
            Some(Value::Array(list)) => list
                .iter()
                .enumerate()
                .map(|(i, v)| match v {
                    Value::Table(t) => {
                        Ok(Reader::new(t, &format!("{}[{}]", self.name(key), i + 1)))
                    }
                    other => Err(self.wrong(key, other, &help)),
                })
                .collect(),
            Some(other) => Err(self.wrong(key, other, &help)),
        }
    }

    /// A text, if present.
    pub fn text(&mut self, key: &'static str) -> Result<Option<&'a str>> {
        match self.get(key) {
            None => Ok(None),
            Some(Value::String(s)) => Ok(Some(s)),
            Some(other) => Err(self.wrong(key, other, "write a text in quotes")),
        }
    }

    /// A text or a list of texts.
    pub fn texts(&mut self, key: &'static str) -> Result<Vec<String>> {
        let help = "write a text in quotes, or a list of them";
        match self.get(key) {
            None => Ok(Vec::new()),
            Some(Value::String(s)) => Ok(vec![s.clone()]),
            Some(Value::Array(list)) => list
                .iter()
                .map(|v| match v {
                    Value::String(s) => Ok(s.clone()),
                    other => Err(self.wrong(key, other, help)),
                })
                .collect(),
            Some(other) => Err(self.wrong(key, other, help)),
        }
    }

    /// One of several words.
    pub fn choice<T: Copy>(
        &mut self,
        key: &'static str,
        choices: &[(&'static str, T)],
    ) -> Result<Option<T>> {
        let Some(word) = self.text(key)? else {
            return Ok(None);
        };
        if let Some(c) = choices.iter().find(|c| c.0 == word) {
            return Ok(Some(c.1));
        }
        let error = Error::key(&self.name(key), format!("\"{word}\" is not known here"));
        let list = choices.iter().map(|c| c.0).collect::<Vec<_>>().join(", ");
        Err(match nearest(word, choices.iter().map(|c| c.0)) {
            Some(n) => error.help(format!("did you mean \"{n}\"? Known are {list}")),
            None => error.help(format!("known are {list}")),
        })
    }

    /// A truth value, if present.
    pub fn flag(&mut self, key: &'static str) -> Result<Option<bool>> {
        match self.get(key) {
            None => Ok(None),
            Some(Value::Boolean(b)) => Ok(Some(*b)),
            Some(other) => Err(self.wrong(key, other, "write true or false")),
        }
    }

    /// A whole number in a range, or "auto".
    pub fn count(&mut self, key: &'static str, low: usize, high: usize) -> Result<Option<usize>> {
        let help = format!("write a whole number from {low} to {high}, or \"auto\"");
        match self.get(key) {
            None => Ok(None),
            Some(Value::String(s)) if s == "auto" => Ok(None),
            Some(v) => {
                let number = match v {
                    Value::Integer(i) => usize::try_from(*i).ok(),
                    Value::String(s) => s.trim().parse().ok(),
                    _ => None,
                };
                number
                    .filter(|n| (low..=high).contains(n))
                    .map(Some)
                    .ok_or_else(|| self.wrong(key, v, &help))
            }
        }
    }

    /// A quantity with its unit; "auto" and absence both give `None`.
    pub fn quantity(&mut self, key: &'static str, dimension: Dimension) -> Result<OrAuto> {
        let help = format!(
            "write a number with its unit in quotes, for example {}",
            dimension.example()
        );
        match self.get(key) {
            None => Ok(None),
            Some(Value::String(s)) if s == "auto" => Ok(None),
            Some(Value::String(s)) => {
                let place = crate::error::Place::Key(self.name(key));
                parse(s, dimension).map(Some).map_err(|e| e.at(place))
            }
            Some(Value::Integer(0)) => Ok(Some(0.0)),
            Some(Value::Float(x)) if *x == 0.0 => Ok(Some(0.0)),
            Some(number @ (Value::Integer(_) | Value::Float(_)))
                if dimension == Dimension::Percent =>
            {
                let place = crate::error::Place::Key(self.name(key));
                parse(&number.to_string(), dimension)
                    .map(Some)
                    .map_err(|e| e.at(place))
            }
            Some(Value::Integer(i)) if dimension == Dimension::Ratio => Ok(Some(*i as f64)),
            Some(Value::Float(x)) if dimension == Dimension::Ratio && x.is_finite() => Ok(Some(*x)),
            Some(other) => Err(self.wrong(key, other, &help)),
        }
    }

    /// A quantity that must be positive.
    pub fn positive(&mut self, key: &'static str, dimension: Dimension) -> Result<OrAuto> {
        let value = self.quantity(key, dimension)?;
        match value {
            Some(x) if x <= 0.0 => Err(Error::key(&self.name(key), format!("{x} is not positive"))
                .help(format!("write for example {}", dimension.example()))),
            _ => Ok(value),
        }
    }

    /// A quantity that must not be negative.
    pub fn not_negative(&mut self, key: &'static str, dimension: Dimension) -> Result<OrAuto> {
        let value = self.quantity(key, dimension)?;
        match value {
            Some(x) if x < 0.0 => Err(Error::key(&self.name(key), format!("{x} is negative"))
                .help(format!("write for example {}", dimension.example()))),
            _ => Ok(value),
        }
    }

    /// Refuses keys that nobody asked for.
    pub fn finish(self) -> Result<()> {
        for key in self.table.keys() {
            if self.known.iter().any(|k| k == key) {
                continue;
            }
            let error = Error::key(&self.name(key), "there is no such key");
            return Err(match nearest(key, self.known.iter().copied()) {
                Some(n) => error.help(format!("did you mean \"{n}\"?")),
                None => error.help(format!("keys here are {}", self.known.join(", "))),
            });
        }
        Ok(())
    }

    fn wrong(&self, key: &str, value: &Value, help: &str) -> Error {
        Error::key(&self.name(key), format!("{value} will not do")).help(help)
    }
}
