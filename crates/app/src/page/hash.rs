//! SHA-256 hashes that identify files and designs.

use std::fmt;

/// SHA-256 hash as 64 hexadecimal digits.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
pub struct Hash(String);

impl Hash {
    /// SHA-256 hash of `bytes`.
    pub fn of(bytes: &[u8]) -> Hash {
        Hash::of_parts(&[bytes])
    }

    /// SHA-256 hash of several byte strings in the given order.
    pub fn of_parts(parts: &[&[u8]]) -> Hash {
        let mut sum = hmac_sha256::Hash::new();
        for part in parts {
            sum.update(part);
        }
        let sum = sum.finalize();
        Hash(sum.iter().map(|b| format!("{b:02x}")).collect())
    }

    /// Hexadecimal digits of the hash.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Debug for Hash {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Display for Hash {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_the_standard() {
        // FIPS 180-2, appendix B.1 and B.2.
        let known = [
            (
                "abc",
                "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
            ),
            (
                "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
                "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1",
            ),
        ];
        for (text, digits) in known {
            assert_eq!(Hash::of(text.as_bytes()).as_str(), digits);
        }
    }
}
