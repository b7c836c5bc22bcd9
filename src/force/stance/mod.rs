//! Stances: when a foot stands on a plate, which of these contacts are whole walking steps, and why the
//! others are not.

mod classify;
mod contact;
mod shape;
mod sides;
mod types;

use classify::{Usual, missing, rejection, shared};
use contact::{Contact, contacts};
use shape::{Shape, shape};
use sides::name_feet;

use super::recording::{Foot, Recording};

pub(crate) use sides::{footfalls, same_foot};
pub use types::{Point, RejectReason, Rejected, Stance, Stances};

/// Finds the stances of a recording.
pub fn stances(recording: &Recording) -> Stances {
    let live = || {
        recording
            .channels
            .iter()
            .enumerate()
            .filter(|(_, c)| c.idle.is_none())
    };
    let mut contacts: Vec<Contact> = live()
        .filter(|(_, c)| c.rows.is_empty())
        .flat_map(|(i, c)| contacts(i, c, recording.rate_hz))
        .collect();
    contacts.sort_by(|a, b| a.start_s.total_cmp(&b.start_s));
    let usual = Usual::of(&contacts, recording.mass_kg);
    let shared = shared(&contacts, recording);
    let mut out = Stances::default();
    for (contact, shared) in contacts.iter().zip(shared) {
        let channel = &recording.channels[contact.channel];
        let force = &channel.force_n;
        let shape = shape(force, recording.rate_hz, contact.start_s, contact.end_s);
        let reason = rejection(contact, &shape, &usual, shared)
            .or_else(|| missing(contact, channel, recording));
        match reason {
            None => out.used.push(stance(contact, &shape, channel.foot, None)),
            Some(reason) => out.rejected.push(Rejected {
                channel: contact.channel,
                from_s: contact.start_s,
                to_s: contact.end_s,
                reason,
            }),
        }
    }
    for (i, c) in live() {
        out.used.extend(c.rows.iter().map(|row| {
            let contact = Contact {
                channel: i,
                start_s: row.from as f64 / recording.rate_hz,
                end_s: (row.to - 1) as f64 / recording.rate_hz,
                peak_n: 0.0,
                cut: None,
            };
            let shape = shape(
                &c.force_n,
                recording.rate_hz,
                contact.start_s,
                contact.end_s,
            );
            stance(&contact, &shape, c.foot, row.mass_kg)
        }));
    }
    name_feet(&mut out.used, recording);
    out
}

fn stance(contact: &Contact, shape: &Shape, foot: Option<Foot>, mass_kg: Option<f64>) -> Stance {
    Stance {
        channel: contact.channel,
        foot,
        start_s: contact.start_s,
        end_s: contact.end_s,
        p1: shape.p1,
        valley: shape.valley,
        p2: shape.p2,
        impulse_ns: shape.impulse_ns,
        mass_kg,
    }
}
