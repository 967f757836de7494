//! Contact detection of one pair or many pairs, for hosts with their own bodies.

use std::marker::PhantomData;
use std::mem::{size_of, MaybeUninit};
use std::ptr;

use halfspace_sys as sys;

use crate::contact::Contact;
use crate::context::Context;
use crate::error::Error;
use crate::placed::Placed;
use crate::pose::Pose;
use crate::shape::Shape;
use crate::Result;

/// Detects the contact of two shapes with default settings and without a cache; see [`Detector`]
/// for others.
#[inline]
pub fn detect(a: Placed<'_>, b: Placed<'_>) -> Result<Contact> {
    Detector::default().detect(a, b)
}

/// Cached state of a pair between calls: the last violated potential contact pair with a separation
/// proof, or the initial contact pair. The default is empty.
///
/// As long as the motion since then is bounded by the gap, detection returns from the proof alone;
/// in contact the initial contact plane is kept. The proof is ignored for other shapes.
#[derive(Clone, Copy, Debug, Default)]
#[repr(transparent)]
pub struct PairCache {
    raw: sys::hs_pair_cache,
}

/// Contact detection with options, and with a [`PairCache`].
///
/// ```
/// use halfspace::{Contact, Context, Detector, PairCache, Pose, Shape};
///
/// let context = Context::new()?;
/// let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// let detector = Detector::default().parallel_angle(0.02);
/// let (mut cache, mut contact) = (PairCache::default(), Contact::default());
/// let below = Pose::default();
/// for step in 0..100 {
///     let falling = Pose::at([0.25, 2.0 - 0.01 * f64::from(step), 0.0]);
///     let (a, b) = (square.at(&below), square.at(&falling));
///     detector.detect_cached(a, b, &mut cache, &mut contact)?;
/// }
/// assert!((contact.gap() - 0.01).abs() < 1e-12);
/// # Ok::<(), halfspace::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
#[must_use]
pub struct Detector {
    /// None is cheaper than the defaults, as the library does not read them.
    options: Option<sys::hs_pair_options>,
}

impl Detector {
    /// Max angle of parallel edges (in 3D also faces, or an edge and a face), in radians, from 0 to
    /// 0.5; by default 0.01.
    pub fn parallel_angle(self, parallel_angle: f64) -> Self {
        Self {
            options: Some(sys::hs_pair_options {
                parallel_angle,
                ..self.known_options()
            }),
        }
    }

    /// Distance from the end of an edge (in 3D the boundary of a face) at which a vertex touches
    /// that end, divided by the length of the shorter edge, from 0 to 0.5; by default 1e-6.
    pub fn vertex_zone(self, vertex_zone: f64) -> Self {
        Self {
            options: Some(sys::hs_pair_options {
                vertex_zone,
                ..self.known_options()
            }),
        }
    }

    /// Polygons are in contact up to this gap (skin), from 0 to 1e75 m; by default 0; must be 0 in
    /// 3D.
    pub fn margin(self, margin: f64) -> Self {
        Self {
            options: Some(sys::hs_pair_options {
                margin,
                ..self.known_options()
            }),
        }
    }

    /// Reports only the pair of largest gap of polygons in contact, without region, for hosts that
    /// compute their own points. 2D only.
    pub fn without_region(self) -> Self {
        Self {
            options: Some(sys::hs_pair_options {
                without_region: 1,
                ..self.known_options()
            }),
        }
    }

    /// Are two shapes in contact, and how?
    #[inline]
    pub fn detect(&self, a: Placed<'_>, b: Placed<'_>) -> Result<Contact> {
        // Constructed in place, as a contact has half a kilobyte.
        let mut result = Ok(Contact::default());
        if let Ok(contact) = &mut result {
            if let Err(error) = self.detect_into(a, b, contact) {
                result = Err(error);
            }
        }
        result
    }

    /// Likewise, into an existing contact. Its ids and forces are not written.
    #[inline]
    pub fn detect_into(&self, a: Placed<'_>, b: Placed<'_>, contact: &mut Contact) -> Result<()> {
        self.call(a, b, ptr::null_mut(), contact)
    }

    /// Likewise, with the cache of this pair from the last call.
    #[inline]
    pub fn detect_cached(
        &self,
        a: Placed<'_>,
        b: Placed<'_>,
        cache: &mut PairCache,
        contact: &mut Contact,
    ) -> Result<()> {
        self.call(a, b, &mut cache.raw, contact)
    }

    /// Detects the contacts of many pairs of bodies, given by indices. Returns the number of pairs
    /// in contact. `contacts` has one entry per pair, `caches` likewise or none.
    ///
    /// ```
    /// use halfspace::{Bodies, Contact, Context, Detector, Pose, Shape};
    ///
    /// let context = Context::new()?;
    /// let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// let bodies = Bodies::from_iter([&square, &square, &square]);
    /// let poses = [0.0, 0.75, 3.0].map(|x| Pose::at([x, 0.0, 0.0]));
    /// let mut contacts = [Contact::default(); 2];
    /// let pairs = [[0, 1], [1, 2]];
    /// let detector = Detector::default();
    /// let touching =
    ///     detector.detect_pairs(&context, &bodies, &poses, &pairs, &mut [], &mut contacts)?;
    /// assert_eq!((touching, contacts[0].gap(), contacts[1].gap()), (1, -0.25, 1.25));
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn detect_pairs(
        &self,
        context: &Context,
        bodies: &Bodies<'_>,
        poses: &[Pose],
        pairs: &[[i32; 2]],
        caches: &mut [PairCache],
        contacts: &mut [Contact],
    ) -> Result<usize> {
        if poses.len() != bodies.len() {
            return Err(Error::argument(
                "Detector::detect_pairs: poses must have one entry per body",
            ));
        }
        if contacts.len() != pairs.len() {
            return Err(Error::argument(
                "Detector::detect_pairs: contacts must have one entry per pair",
            ));
        }
        if !(caches.is_empty() || caches.len() == pairs.len()) {
            return Err(Error::argument(
                "Detector::detect_pairs: caches must have no entry or one per pair",
            ));
        }
        let caches = if caches.is_empty() {
            ptr::null_mut()
        } else {
            caches.as_mut_ptr()
        };
        let mut touching = 0;
        // SAFETY: the shapes live as long as `bodies` borrows them, and the lengths of all arrays
        // are as given. Pose, PairCache and Contact have the layout of the structs of the library.
        let status = unsafe {
            sys::hs_pairs_detect(
                context.handle(),
                bodies.handles.as_ptr(),
                poses.as_ptr().cast(),
                bodies.len() as i64,
                pairs.as_ptr().cast(),
                pairs.len() as i64,
                self.options(),
                caches.cast(),
                contacts.as_mut_ptr().cast(),
                &mut touching,
            )
        };
        context.owner().check(status)?;
        Ok(touching as usize)
    }

    #[inline]
    fn call(
        &self,
        a: Placed<'_>,
        b: Placed<'_>,
        cache: *mut sys::hs_pair_cache,
        contact: &mut Contact,
    ) -> Result<()> {
        // SAFETY: the shapes live and nobody changes them, the cache is NULL or valid, all else are
        // references.
        let status = unsafe {
            sys::hs_pair_detect(
                a.shape.handle(),
                a.pose.raw(),
                b.shape.handle(),
                b.pose.raw(),
                self.options(),
                cache,
                contact.raw_mut(),
            )
        };
        // The error text is in the context of the first shape.
        a.shape.owner().check(status)
    }

    #[inline]
    fn options(&self) -> *const sys::hs_pair_options {
        self.options.as_ref().map_or(ptr::null(), |options| options)
    }

    fn known_options(&self) -> sys::hs_pair_options {
        self.options.unwrap_or_else(|| {
            let mut options = MaybeUninit::<sys::hs_pair_options>::zeroed();
            // SAFETY: the size is that of the struct, for which all zero is valid.
            unsafe {
                sys::hs_pair_options_init(options.as_mut_ptr(), size_of::<sys::hs_pair_options>());
                options.assume_init()
            }
        })
    }
}

/// The shapes of the host's bodies, in order, for [`Detector::detect_pairs`]. Several bodies may
/// use one shape.
///
/// The shapes are borrowed:
///
/// ```compile_fail,E0505
/// # let context = halfspace::Context::new().unwrap();
/// # let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let triangle = halfspace::Shape::polygon(&context, &corners).unwrap();
/// let bodies = halfspace::Bodies::from_iter([&triangle, &triangle]);
/// drop(triangle);
/// println!("{}", bodies.len());
/// ```
#[derive(Clone, Debug, Default)]
pub struct Bodies<'a> {
    handles: Vec<*const sys::hs_shape>,
    borrowed: PhantomData<&'a Shape>,
}

// SAFETY: it is a list of shared references to shapes, which are Sync.
unsafe impl Send for Bodies<'_> {}
// SAFETY: likewise.
unsafe impl Sync for Bodies<'_> {}

impl Bodies<'_> {
    /// Number of bodies.
    pub fn len(&self) -> usize {
        self.handles.len()
    }

    /// Is the list empty?
    pub fn is_empty(&self) -> bool {
        self.handles.is_empty()
    }
}

impl<'a> FromIterator<&'a Shape> for Bodies<'a> {
    fn from_iter<I: IntoIterator<Item = &'a Shape>>(shapes: I) -> Self {
        Self {
            handles: shapes.into_iter().map(Shape::handle).collect(),
            borrowed: PhantomData,
        }
    }
}

impl<'a> Extend<&'a Shape> for Bodies<'a> {
    fn extend<I: IntoIterator<Item = &'a Shape>>(&mut self, shapes: I) {
        self.handles.extend(shapes.into_iter().map(Shape::handle));
    }
}
