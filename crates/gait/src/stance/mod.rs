//! Detection of stances: contacts with a plate, the whole walking steps among the contacts, and the reasons for the rejection of the
//! others.

mod classify;
mod contact;
mod outliers;
mod recognise;
mod shape;
mod sides;
mod types;

use classify::{Judged, Usual, beside, missing, rejection};
use contact::{Contact, contacts};
pub(super) use outliers::largest_group;
use outliers::{mark_unlike, of_one_speed};
use recognise::{ballistic, without_stance};
use shape::{Shape, shape};
use sides::name_feet;

use crate::recording::{Foot, Kind, Note, Recording};

pub(crate) use sides::{Footfall, footfalls, same_foot};
pub use types::{Point, RejectReason, Rejected, Stance, Stances};

/// Detects the stances of a recording.
///
/// Running is averaged only if `recording.kind` requests it. Jumps, standing and sit-to-stand are not averaged.
pub fn stances(recording: &Recording) -> Stances {
    let mut contacts: Vec<Contact> = recording
        .live()
        .filter(|(_, c)| c.rows.is_empty())
        .flat_map(|(i, c)| contacts(i, c, recording.rate_hz))
        .collect();
    contacts.sort_by(|a, b| a.start_s.total_cmp(&b.start_s));
    let mut out = judged(&contacts, recording);
    for (i, c) in recording.live() {
        out.used.extend(c.rows.iter().map(|row| {
            let contact = Contact {
                channel: i,
                start_s: row.from as f64 / recording.rate_hz,
                end_s: (row.to - 1) as f64 / recording.rate_hz,
                peak_n: 0.0,
                cut: None,
            };
            stance(
                &contact,
                &shape_of(&contact, recording),
                c.foot,
                row.mass_kg,
            )
        }));
    }
    of_one_speed(&mut out, recording);
    mark_unlike(&mut out.used, recording.channels.len());
    name_feet(&mut out.used, recording);
    settle_kind(&mut out, &contacts, recording);
    out
}

fn shape_of(contact: &Contact, recording: &Recording) -> Shape {
    let channel = &recording.channels[contact.channel];
    let span = (contact.start_s, contact.end_s);
    shape(&channel.force_n, recording.rate_hz, span, channel.noise_n)
}

/// Classifies each contact as used or rejected.
fn judged(contacts: &[Contact], recording: &Recording) -> Stances {
    let shapes: Vec<Shape> = contacts.iter().map(|c| shape_of(c, recording)).collect();
    let mut out = Stances {
        recognised: ballistic(contacts, &shapes, recording),
        ..Stances::default()
    };
    let kind = recording.kind.or(out.recognised).unwrap_or(Kind::Walking);
    let usual = Usual::of(contacts, recording);
    let beside = beside(contacts, &shapes, &usual);
    for (place, (contact, shape)) in contacts.iter().zip(&shapes).enumerate() {
        let channel = &recording.channels[contact.channel];
        let judged = Judged {
            place,
            contact,
            shape,
            beside: beside[place],
        };
        let reason = rejection(&judged, &usual, kind)
            .or_else(|| missing(contact, channel, recording))
            .or_else(|| unasked(kind, recording));
        match reason {
            None => out.used.push(stance(contact, shape, channel.foot, None)),
            Some(reason) => out.rejected.push(Rejected {
                channel: contact.channel,
                from_s: contact.start_s,
                to_s: contact.end_s,
                reason,
            }),
        }
    }
    out
}

/// Reason why whole contacts of this kind of movement are not averaged; `None` if they are.
fn unasked(kind: Kind, recording: &Recording) -> Option<RejectReason> {
    match kind {
        Kind::Walking => None,
        Kind::Running if recording.kind == Some(Kind::Running) => None,
        Kind::Running => Some(RejectReason::Running),
        Kind::Jumping => Some(RejectReason::Jumping),
        Kind::Standing | Kind::SitToStand | Kind::Other => Some(RejectReason::Standing),
    }
}

/// Classifies a recording that is neither running nor jumping. If the contacts contradict the requested kind of movement, a note is added.
fn settle_kind(out: &mut Stances, contacts: &[Contact], recording: &Recording) {
    if out.recognised.is_none() {
        let crosses =
            |r: &&Rejected| matches!(r.reason, RejectReason::TwoPlates | RejectReason::CrossOver);
        out.recognised = if out.used.is_empty() {
            // Feet that cross between belts belong to a walking person, although no stance is whole.
            let crossed = out.rejected.iter().filter(crosses).count() >= 3;
            (!crossed)
                .then(|| without_stance(contacts, recording))
                .flatten()
        } else {
            Some(Kind::Walking)
        };
    }
    out.kind = recording.kind.or(out.recognised);
    if let (Some(asked), Some(found)) = (recording.kind, out.recognised)
        && asked != found
    {
        let (typed, movement) = (asked.name(), found.name());
        out.notes.push(Note::KindDiffers { typed, movement });
    }
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
        unlike: false,
    }
}
