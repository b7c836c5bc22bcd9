//! Frames of a WebSocket, RFC 6455 section 5.2: how a message is cut into bytes.

/// What a frame carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// More of the message that has begun.
    Continued,
    /// The beginning of a text.
    Text,
    /// The end of the conversation.
    Close,
    /// A question whether this side is there.
    Ping,
    /// The answer to it.
    Pong,
}

/// Why a conversation ends, as the closing frame says it (section 7.4.1).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// 1000: the other side has ended it.
    Done = 1000,
    /// 1002: bytes that are no frame of a client.
    NoFrame = 1002,
    /// 1003: something other than text.
    NoText = 1003,
    /// 1007: text that is not UTF-8.
    NotUtf8 = 1007,
    /// 1009: larger than the address takes.
    TooLarge = 1009,
    /// 1011: the question failed here.
    Internal = 1011,
}

/// A frame as it came from a client.
#[derive(Debug, PartialEq, Eq)]
pub struct Frame {
    /// What it carries.
    pub kind: Kind,
    /// The last of its message.
    pub ends: bool,
    /// Its contents, unmasked.
    pub data: Vec<u8>,
}

/// Largest contents of a frame that is no part of a message.
const CONTROL: usize = 125;

/// The first frame among the bytes and its length; `None` while it is incomplete.
///
/// # Errors
/// Bytes that a client may not send, and contents above `most` bytes.
pub fn read(bytes: &[u8], most: usize) -> Result<Option<(Frame, usize)>, Reason> {
    let [first, second, rest @ ..] = bytes else {
        return Ok(None);
    };
    let ends = first & 0x80 != 0;
    let kind = kind(first & 0x7f)?;
    let masked = second & 0x80 != 0;
    let (wide, short) = match second & 0x7f {
        126 => (2, 0),
        127 => (8, 0),
        short => (0, usize::from(short)),
    };
    let is_part = matches!(kind, Kind::Text | Kind::Continued);
    if !masked || !is_part && (!ends || wide > 0) {
        return Err(Reason::NoFrame);
    }
    let Some((long, rest)) = rest.split_at_checked(wide) else {
        return Ok(None);
    };
    let long = long.iter().fold(0_u64, |n, byte| n << 8 | u64::from(*byte));
    let length = usize::try_from(long).map_or(usize::MAX, |long| long.max(short));
    if length > most.max(CONTROL) {
        return Err(Reason::TooLarge);
    }
    let Some((mask, rest)) = rest.split_at_checked(4) else {
        return Ok(None);
    };
    let Some(data) = rest.get(..length) else {
        return Ok(None);
    };
    let data = data.iter().zip(mask.iter().cycle()).map(|(d, m)| d ^ m);
    let frame = Frame {
        kind,
        ends,
        data: data.collect(),
    };
    Ok(Some((frame, 2 + wide + 4 + length)))
}

fn kind(first: u8) -> Result<Kind, Reason> {
    Ok(match first {
        0x0 => Kind::Continued,
        0x1 => Kind::Text,
        0x2 => return Err(Reason::NoText),
        0x8 => Kind::Close,
        0x9 => Kind::Ping,
        0xa => Kind::Pong,
        _ => return Err(Reason::NoFrame),
    })
}

/// A whole message as a server sends it: one frame, not masked.
pub fn written(kind: Kind, data: &[u8]) -> Vec<u8> {
    let code = match kind {
        Kind::Continued => 0x0,
        Kind::Text => 0x1,
        Kind::Close => 0x8,
        Kind::Ping => 0x9,
        Kind::Pong => 0xa,
    };
    let mut out = Vec::with_capacity(data.len() + 10);
    out.push(0x80 | code);
    match data.len() {
        short @ 0..=125 => out.push(short as u8),
        middle @ 126..=0xffff => {
            out.push(126);
            out.extend((middle as u16).to_be_bytes());
        }
        long => {
            out.push(127);
            out.extend((long as u64).to_be_bytes());
        }
    }
    out.extend_from_slice(data);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// RFC 6455 section 5.7.
    const HELLO: [u8; 11] = [
        0x81, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58,
    ];

    #[test]
    fn the_examples_of_the_standard() {
        let (hello, length) = read(&HELLO, 100).unwrap().unwrap();
        assert_eq!((&hello.data[..], length), (&b"Hello"[..], 11));
        assert_eq!((hello.kind, hello.ends), (Kind::Text, true));
        let plain = [0x81, 0x05, 0x48, 0x65, 0x6c, 0x6c, 0x6f];
        assert_eq!(written(Kind::Text, b"Hello"), plain);
        assert_eq!(
            written(Kind::Text, &[0; 256])[..4],
            [0x81, 0x7e, 0x01, 0x00]
        );
        let long = written(Kind::Text, &[0; 65536]);
        assert_eq!(long[..10], [0x81, 0x7f, 0, 0, 0, 0, 0, 1, 0, 0]);
    }

    #[test]
    fn a_frame_in_pieces_waits() {
        for cut in 0..HELLO.len() {
            assert_eq!(read(&HELLO[..cut], 100).unwrap(), None, "{cut}");
        }
    }

    #[test]
    fn what_no_client_may_send_is_refused() {
        let endless = [0x81, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff];
        for (bytes, reason) in [
            (&[0x81, 0x05][..], Reason::NoFrame), // not masked
            (&[0xc1, 0x80], Reason::NoFrame),     // a bit of an extension
            (&[0x83, 0x80], Reason::NoFrame),     // a kind that is none
            (&[0x09, 0x80], Reason::NoFrame),     // a ping in pieces
            (&[0x89, 0xfe], Reason::NoFrame),     // a long ping
            (&[0x82, 0x80], Reason::NoText),
            (&[0x81, 0xfe, 0x10, 0x00], Reason::TooLarge),
            (&endless, Reason::TooLarge),
        ] {
            assert_eq!(read(bytes, 1000), Err(reason), "{bytes:x?}");
        }
    }
}
