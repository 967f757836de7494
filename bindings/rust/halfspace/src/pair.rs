//! Detection for hosts that keep their own bodies: one pair, or many.

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

/// Are two shapes in contact, and how? By the default settings and without memory of earlier calls;
/// else ask a [`Detector`].
#[inline]
pub fn detect(a: Placed<'_>, b: Placed<'_>) -> Result<Contact> {
    Detector::default().detect(a, b)
}

/// What a pair remembers between calls: the last violated potential pair with a proof of
/// separation, or the pair through which the blocks met. The default is an empty one.
///
/// As long as the blocks have moved less than the gap, the proof alone answers; in contact, the
/// plane through which the pair met is kept. The proof is of its two shapes; with others it is not
/// used.
#[derive(Clone, Copy, Debug, Default)]
#[repr(transparent)]
pub struct PairCache {
    raw: sys::hs_pair_cache,
}

/// Detection with settings of one's own, and with the memory of a [`PairCache`].
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
    /// None is not the same as the defaults: the library need not look at them.
    options: Option<sys::hs_pair_options>,
}

impl Detector {
    /// Edges (in space also faces, or an edge and a face) closer to parallel than this share a
    /// region; in radians, 0 to 0.5, by default 0.01.
    pub fn parallel_angle(self, parallel_angle: f64) -> Self {
        Self {
            options: Some(sys::hs_pair_options {
                parallel_angle,
                ..self.known_options()
            }),
        }
    }

    /// How near the end of an edge (in space the border of a face) a vertex meets what is there:
    /// share of the shorter of the two edges that face each other, 0 to 0.5, by default 1e-6.
    pub fn vertex_zone(self, vertex_zone: f64) -> Self {
        Self {
            options: Some(sys::hs_pair_options {
                vertex_zone,
                ..self.known_options()
            }),
        }
    }

    /// Polygons are apart only when their gap exceeds this, for hosts whose blocks wear a skin; 0 to
    /// 1e75 m, by default 0, as it must be in space.
    pub fn margin(self, margin: f64) -> Self {
        Self {
            options: Some(sys::hs_pair_options {
                margin,
                ..self.known_options()
            }),
        }
    }

    /// A contact between polygons is the pair of largest gap and no more, for hosts that make their
    /// own points. Not in space.
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
        // Written where it is returned: half a kilobyte that is not moved.
        let mut result = Ok(Contact::default());
        if let Ok(contact) = &mut result {
            if let Err(error) = self.detect_into(a, b, contact) {
                result = Err(error);
            }
        }
        result
    }

    /// The same, into a contact that is there already. Its ids and forces stay as they are.
    #[inline]
    pub fn detect_into(&self, a: Placed<'_>, b: Placed<'_>, contact: &mut Contact) -> Result<()> {
        self.call(a, b, ptr::null_mut(), contact)
    }

    /// The same, with the pair's memory from the last call.
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

    /// Detects many pairs of bodies, given by their indices, and returns how many are in contact.
    /// There is a contact for each pair, and a cache, or none at all.
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
                "Detector::detect_pairs: poses are not as many as bodies",
            ));
        }
        if contacts.len() != pairs.len() {
            return Err(Error::argument(
                "Detector::detect_pairs: contacts are not as many as pairs",
            ));
        }
        if !(caches.is_empty() || caches.len() == pairs.len()) {
            return Err(Error::argument(
                "Detector::detect_pairs: caches are not as many as pairs",
            ));
        }
        let caches = if caches.is_empty() {
            ptr::null_mut()
        } else {
            caches.as_mut_ptr()
        };
        let mut touching = 0;
        // SAFETY: the shapes live as long as `bodies` borrows them, and all arrays have as many
        // entries as the counts say. Pose, PairCache and Contact are laid out as the structs of the
        // library.
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
        // SAFETY: the shapes live and are of this thread, the cache is NULL or valid, all else are
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
        // The library leaves its text in the context of the first shape.
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

/// The shapes of a host's bodies, in their order, for [`Detector::detect_pairs`]. Several bodies
/// may share a shape.
///
/// The shapes stay as long as they are listed:
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

impl Bodies<'_> {
    /// How many bodies there are.
    pub fn len(&self) -> usize {
        self.handles.len()
    }

    /// Is there none?
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
