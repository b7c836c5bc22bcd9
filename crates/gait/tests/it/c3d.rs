//! Synthetic C3D files of every processor, storage and plate type.

use std::path::Path;

use gaitcam_gait::error::ReadError;
use gaitcam_gait::{Foot, Note, ReadOptions, Recording, read, stances};

use crate::fault;

use crate::c3d_file::{Build, Processor, build, one_stance};

const RATE: f64 = 500.0;

fn plain(processor: Processor, float: bool, kind: i16) -> Build {
    Build {
        before: 0,
        processor,
        float,
        kind,
        per_frame: 5,
        frames: 160,
        scale: 0.05,
        offset: 7,
    }
}

fn open(b: &Build) -> Recording {
    let bytes = build(b, |i| one_stance(i, RATE));
    read(Path::new("made.c3d"), &bytes, &ReadOptions::default()).unwrap()
}

#[test]
fn every_processor_storage_and_plate_type_gives_the_same_force() {
    for processor in [Processor::Intel, Processor::Dec, Processor::Sgi] {
        for float in [true, false] {
            for kind in 1..=7 {
                let r = open(&plain(processor, float, kind));
                let what = format!("{processor:?} float {float} TYPE {kind}");
                assert_eq!(r.rate_hz, RATE, "{what}");
                assert_eq!(r.mass_kg, Some(70.0), "{what}");
                let c = &r.channels[0];
                assert_eq!(c.force_n.len(), 800, "{what}");
                // Four sensors of a plate of TYPE 3, 6 or 7 are rounded to 0.05 N each.
                for (i, f) in c.force_n.iter().enumerate() {
                    assert!(
                        (f + one_stance(i, RATE)).abs() < 0.11,
                        "{what}: sample {i} is {f}"
                    );
                }
                let s = stances(&r);
                assert_eq!(s.used.len(), 1, "{what}");
                assert_eq!(s.used[0].foot, Some(Foot::Right), "{what}");
                assert!((s.used[0].start_s - 0.5).abs() < 0.01, "{what}");
            }
        }
    }
}

#[test]
fn channels_beyond_255_have_their_own_scale_offset_unit_and_label() {
    for before in [249, 252, 255, 300, 520] {
        for (kind, float) in [(2, true), (4, false), (7, true)] {
            let b = Build {
                before,
                ..plain(Processor::Intel, float, kind)
            };
            let r = open(&b);
            let off = (r.channels[0].force_n.iter().enumerate())
                .map(|(i, f)| (f + one_stance(i, RATE)).abs());
            let off = off.fold(0.0, f64::max);
            assert!(off < 0.11, "{before} channels before TYPE {kind}: {off} N");
            let options = ReadOptions {
                force: vec![format!("c{}", before + 2)],
                ..ReadOptions::default()
            };
            let bytes = build(&b, |i| one_stance(i, RATE));
            assert!(read(Path::new("made.c3d"), &bytes, &options).is_ok());
        }
    }
}

#[test]
fn a_plate_of_unknown_type_is_refused_by_its_number() {
    let bytes = build(&plain(Processor::Intel, true, 21), |i| one_stance(i, RATE));
    let e = read(Path::new("odd.c3d"), &bytes, &ReadOptions::default()).unwrap_err();
    assert_eq!(fault(&e), "odd.c3d: read-plate-type-unknown");
    assert!(matches!(
        e.fault(),
        Some(ReadError::PlateTypeUnknown { kind: 21, .. })
    ));
    // Its vertical channel can still be named.
    let options = ReadOptions {
        force: vec!["c".to_string()],
        ..ReadOptions::default()
    };
    let r = read(Path::new("odd.c3d"), &bytes, &options).unwrap();
    assert_eq!(stances(&r).used.len(), 1);
}

#[test]
fn a_file_cut_short_keeps_its_whole_frames_and_says_so() {
    let b = plain(Processor::Intel, true, 2);
    let whole = build(&b, |i| one_stance(i, RATE));
    let cut = &whole[..whole.len() - 3000];
    let r = read(Path::new("cut.c3d"), cut, &ReadOptions::default()).unwrap();
    assert!(r.channels[0].force_n.len() < 800);
    assert!(
        r.notes
            .iter()
            .any(|n| matches!(n, Note::FramesMissing { announced: 160, .. })),
        "{:?}",
        r.notes
    );
}

#[test]
fn damage_is_named_by_its_byte() {
    let b = plain(Processor::Intel, true, 2);
    let whole = build(&b, |i| one_stance(i, RATE));
    let of = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut bytes = whole.clone();
        change(&mut bytes);
        fault(&read(Path::new("bad.c3d"), &bytes, &ReadOptions::default()).unwrap_err())
    };
    assert_eq!(of(&|b| b[515] = 99), "bad.c3d byte 515: read-processor");
    assert_eq!(of(&|b| b[4] = 0), "bad.c3d byte 4: read-no-analog");
    assert!(of(&|b| b.truncate(1600)).ends_with("read-no-frame"));
    assert_eq!(of(&|b| b[18] = 7), "bad.c3d byte 18: read-odd-analog");
}

#[test]
fn a_channel_counts_from_one_to_the_last_of_the_file() {
    let b = plain(Processor::Intel, true, 2);
    let whole = build(&b, |i| one_stance(i, RATE));
    // A plate of TYPE 2 has six channels and presses on its third, whose number stands behind six bytes on the list's shape.
    let name = b"CHANNEL";
    let list = whole.windows(name.len()).position(|w| w == name).unwrap() + name.len();
    let third = list + 2 + 2 + 2 + 2 * 2;
    assert_eq!(whole[third], 3);
    let read_with = |number: u8, force: &[&str]| {
        let mut bytes = whole.clone();
        bytes[third] = number;
        let options = ReadOptions {
            force: force.iter().map(ToString::to_string).collect(),
            ..ReadOptions::default()
        };
        read(Path::new("c.c3d"), &bytes, &options)
    };
    let first = |r: Recording| r.channels[0].force_n[0].abs();
    for (number, value) in [(1, 3.0), (6, 7.0)] {
        let plate = first(read_with(number, &[]).unwrap());
        let named = first(read_with(3, &[&number.to_string()]).unwrap());
        assert!(
            (plate - value).abs() < 1e-6 && (named - value).abs() < 1e-6,
            "{number}: {plate} {named}"
        );
    }
    for number in [0, 7] {
        // The plate is left out and said to be; the channel labelled "f" is read as a force instead.
        let notes = read_with(number, &[]).unwrap().notes;
        let missing = Note::PlateChannelMissing {
            plate: 1,
            channel: 3,
        };
        assert!(notes.contains(&missing), "{number}: {notes:?}");
        let named = read_with(3, &[&number.to_string()]).map(first).unwrap_err();
        assert_eq!(fault(&named), "c.c3d: read-no-channel");
    }
}

#[test]
fn a_stance_of_a_c3d_file_fills_a_span_and_a_period_alone_is_refused() {
    let bytes = build(&plain(Processor::Intel, true, 2), |i| one_stance(i, RATE));
    let path = Path::new("made.c3d");
    let with = |period_s, span_rad| {
        let options = ReadOptions {
            period_s,
            span_rad,
            ..ReadOptions::default()
        };
        gaitcam_gait::one_cycle(path, &bytes, &options, gaitcam_gait::Feet::Both)
    };
    let curve = with(None, Some(4.0)).unwrap().unwrap();
    assert!(matches!(
        curve.notes.last(),
        Some(Note::StanceFillsSpan { stances: 1, .. })
    ));
    let refused = with(Some(1.1), None).unwrap_err();
    assert_eq!(refused.fault(), Some(&ReadError::CycleInC3d));
    assert!(with(None, None).unwrap().is_none());
}
