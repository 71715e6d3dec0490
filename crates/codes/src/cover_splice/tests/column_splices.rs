//! Least forces of column splices, contact, and members that differ.

use super::fixture::{actions, find, member, near, numbers, open, plain, splice};
use crate::check::{CheckId, Status};
use crate::cover_splice::splice_checks;
use bracket_joint::assembly::{CoverSplice, SpliceUse};
use bracket_joint::spec::loads::LimitState;

fn column(contact: bool, load: [f64; 3]) -> CoverSplice {
    let actions = vec![actions("ULS", load, LimitState::Ultimate)];
    let gap = if contact { 0.0 } else { 10.0 };
    CoverSplice { used: SpliceUse::Column { contact }, gap, actions, category: None, ..splice() }
}

/// 25 % of M_pl = 1471 cm³ · 275 MPa and 2.5 % of A f_y = 85.5 cm² · 275 MPa, 6.2.7.1(13).
#[test]
fn a_column_splice_without_contact_carries_the_least_forces() {
    let e = column(false, [-100e3, 10e3, 20e6]);
    let (moment, shear) = (0.25 * 1471e3 * 275.0, 0.025 * 8550.0 * 275.0);
    near(numbers(&e, "ULS", CheckId::WebCoverShear, "web covers")[0], 1e-3 * shear, 1e-9);
    // the least moment acts in either sense: both flanges are pulled, and both are pushed
    let share = 1.0 - 8.5 * 428f64.powi(3) / 12.0 / 29380e4;
    let by_moment = 1e-3 * share * moment / 440.7;
    let by_axial = 1e-3 * 50e3 * (1.0 - 428.0 * 8.5 / 8550.0);
    for flange in ["upper flange", "lower flange"] {
        let pulled = numbers(&e, "ULS", CheckId::FlangeTension, flange)[0];
        let pushed = numbers(&e, "ULS", CheckId::FlangeCompression, flange)[0];
        near(pulled, by_moment - by_axial, 1e-9);
        near(pushed, by_moment + by_axial, 1e-9);
    }
    // about the weak axis the code asks for more than these checks know
    let open: Vec<CheckId> = splice_checks(&e)
        .checks
        .iter()
        .filter(|c| c.status == Status::Undecided)
        .map(|c| c.id())
        .collect();
    assert_eq!(open, [CheckId::SpliceWeakAxis]);
    // a beam, and larger actions, have their own forces
    let beam = CoverSplice { used: SpliceUse::Beam, ..e.clone() };
    near(numbers(&beam, "ULS", CheckId::WebCoverShear, "web covers")[0], 10.0, 1e-9);
    let large = column(false, [0.0, 90e3, 150e6]);
    near(numbers(&large, "ULS", CheckId::WebCoverShear, "web covers")[0], 90.0, 1e-9);
    assert!(
        splice_checks(&large).checks.iter().all(|c| {
            c.id() != CheckId::FlangeTension || !c.subject.to_string().contains("lower")
        })
    );
}

/// 25 % of the compression goes through the covers, 6.2.7.1(14); all of a tension does.
#[test]
fn contact_transfers_the_rest_of_the_compression() {
    let e = column(true, [-800e3, 10e3, 0.0]);
    let flange = 1e-3 * 400e3 * (1.0 - 428.0 * 8.5 / 8550.0);
    let own = numbers(&e, "ULS", CheckId::FlangeCompression, "upper flange");
    near(own[0], flange, 1e-9);
    let cover = numbers(&e, "ULS", CheckId::CoverCompression, "upper flange, outer cover");
    near(cover[0], 0.25 * flange, 1e-9);
    let bolt = numbers(&e, "ULS", CheckId::SpliceBoltShear, "upper flange, flange bolts");
    near(bolt[0], 0.25 * flange / 6.0, 1e-9);
    assert_eq!(open(&e), Vec::<String>::new());
    let pulled = column(true, [800e3, 10e3, 0.0]);
    let bolt = numbers(&pulled, "ULS", CheckId::SpliceBoltShear, "upper flange, flange bolts");
    near(bolt[0], flange / 6.0, 1e-9);
    // the moment alone: its compression goes by contact, its tension through the cover
    let bent = column(true, [0.0, 0.0, 100e6]);
    let ids = |e: &CoverSplice, part: &str| -> Vec<CheckId> {
        let all = splice_checks(e).checks;
        let of = |c: &&crate::check::Check| c.subject.to_string().ends_with(part);
        all.iter().filter(of).map(|c| c.id()).collect()
    };
    assert!(ids(&bent, "splice, lower flange, flange bolts").is_empty());
    assert!(!ids(&bent, "splice, upper flange, flange bolts").is_empty());
    // an open gap, or flanges that do not meet, are no contact
    let gap = CoverSplice { gap: 10.0, ..e.clone() };
    assert_eq!(open(&gap).len(), 1, "{:?}", open(&gap));
    let right = member("IPE400", plain(275.0, 410.0));
    let other = CoverSplice { right, ..e };
    assert!(open(&other).iter().any(|s| s.contains("do not meet")), "{:?}", open(&other));
}

/// Members of two depths: packs reduce the shear of the bolts, an axis beside that of the actions
/// adds a moment.
#[test]
fn members_that_differ_have_packs_and_an_axis() {
    let mut e = splice();
    e.right = member("IPE400", plain(275.0, 410.0));
    e.right.packs = [26.7, 26.7];
    let whole =
        numbers(&e, "ULS", CheckId::SpliceBoltShear, "left member, upper flange, flange bolts");
    let packed =
        numbers(&e, "ULS", CheckId::SpliceBoltShear, "right member, upper flange, flange bolts");
    near(packed[1] / whole[1], 9.0 * 20.0 / (8.0 * 20.0 + 3.0 * 26.7), 1e-9);
    assert!(packed[0] > whole[0], "the same moment has a shorter lever");
    // flush at the top: the axis lies 26.7 mm higher, and N = −150 kN there pushes below it
    e.right.packs = [0.0, 53.4];
    e.right.axis = 26.7;
    let s = &e.right.section;
    let web = (s.h - 2.0 * s.tf) * s.tw;
    let share = 1.0 - s.tw * (s.h - 2.0 * s.tf).powi(3) / 12.0 / (1e4 * s.i_y);
    let moment = share * (200e6 + 150e3 * 26.7) / (s.h - s.tf);
    let want = 1e-3 * (moment + 75e3 * (1.0 - web / (1e2 * s.area)));
    let got = find(&e, "ULS", CheckId::FlangeCompression, "right member, lower flange");
    near(1e-3 * got.demand.expect("a number"), want, 1e-9);
}
