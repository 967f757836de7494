//! One statement: words, numbers and constants.

use std::fmt;

use crate::fields;

pub struct Words {
    words: Vec<String>,
}

impl Words {
    pub fn new(line: &str) -> Self {
        let statement = line.split('#').next().unwrap_or_default();
        Self {
            words: statement.split_whitespace().map(str::to_owned).collect(),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    pub fn first(&self) -> &str {
        self.word(0)
    }

    pub fn word(&self, i: usize) -> &str {
        self.words
            .get(i)
            .unwrap_or_else(|| panic!("{self}: there is no word {i}"))
    }

    /// All words from `i` on.
    pub fn from(&self, i: usize) -> &[String] {
        &self.words[i.min(self.words.len())..]
    }

    pub fn text_from(&self, i: usize) -> String {
        self.from(i).join(" ")
    }

    pub fn number(&self, i: usize) -> f64 {
        number(self.word(i))
    }

    pub fn whole(&self, i: usize) -> i32 {
        self.number(i) as i32
    }

    pub fn numbers_from(&self, i: usize) -> Vec<f64> {
        self.from(i).iter().map(|word| number(word)).collect()
    }

    pub fn vector(&self, i: usize) -> [f64; 3] {
        [0, 1, 2].map(|k| self.number(i + k))
    }

    pub fn quaternion(&self, i: usize) -> [f64; 4] {
        [0, 1, 2, 3].map(|k| self.number(i + k))
    }

    /// Row by row.
    pub fn tensor(&self, i: usize) -> [[f64; 3]; 3] {
        [0, 3, 6].map(|k| self.vector(i + k))
    }

    pub fn points_from<const D: usize>(&self, i: usize) -> Vec<[f64; D]> {
        self.numbers_from(i)
            .chunks_exact(D)
            .map(|point| point.try_into().expect("D numbers"))
            .collect()
    }

    /// Pairs of a field's name and its numbers.
    pub fn fields_from(&self, i: usize) -> Vec<(&str, Vec<f64>)> {
        let mut fields = Vec::<(&str, Vec<f64>)>::new();
        for word in self.from(i) {
            match (parse(word), fields.last_mut()) {
                (Some(value), Some((_, values))) => values.push(value),
                _ => fields.push((word, Vec::new())),
            }
        }
        fields
    }
}

impl fmt::Display for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words.join(" "))
    }
}

pub fn number(word: &str) -> f64 {
    parse(word).unwrap_or_else(|| panic!("{word} is neither a number nor a constant"))
}

/// A decimal number or a constant.
fn parse(word: &str) -> Option<f64> {
    let constant = fields::constant(word).map(f64::from);
    constant.or_else(|| word.parse().ok())
}
