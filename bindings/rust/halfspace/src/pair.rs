//! Contact detection of one pair or many pairs, for hosts with their own bodies.

use std::marker::PhantomData;
use std::ptr;

use halfspace_sys as sys;

use crate::call::{call, counted, defaults};
use crate::contact::Contact;
use crate::context::Context;
use crate::error::require;
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
        self.with(|options| options.parallel_angle = parallel_angle)
    }

    /// Distance from the end of an edge (in 3D the boundary of a face) at which a vertex touches
    /// that end, divided by the length of the shorter edge, from 0 to 0.5; by default 1e-6.
    pub fn vertex_zone(self, vertex_zone: f64) -> Self {
        self.with(|options| options.vertex_zone = vertex_zone)
    }

    /// Polygons are in contact up to this gap (skin), from 0 to 1e75 m; by default 0; must be 0 in
    /// 3D.
    pub fn margin(self, margin: f64) -> Self {
        self.with(|options| options.margin = margin)
    }

    /// Reports only the pair of largest gap of polygons in contact, without region, for hosts that
    /// compute their own points. 2D only.
    pub fn without_region(self) -> Self {
        self.with(|options| options.without_region = 1)
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
        self.call(a, b, None, contact)
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
        self.call(a, b, Some(&mut cache.raw), contact)
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
        let check = |holds, text| require(holds, || format!("Detector::detect_pairs: {text}"));
        let count = pairs.len();
        check(
            poses.len() == bodies.len(),
            "poses must have one entry per body",
        )?;
        check(
            contacts.len() == count,
            "contacts must have one entry per pair",
        )?;
        let is_fit = caches.is_empty() || caches.len() == count;
        check(is_fit, "caches must have no entry or one per pair")?;
        let caches = if caches.is_empty() {
            ptr::null_mut()
        } else {
            caches.as_mut_ptr()
        };
        let options = self.options.as_ref();
        let (shapes, contacts) = (bodies.handles.as_ptr(), contacts.as_mut_ptr().cast());
        // SAFETY: the shapes live as long as `bodies` borrows them, and the lengths of all arrays are as given.
        // PairCache and Contact have the layout of the structs of the library.
        counted(|count| {
            call!(context => hs_pairs_detect(
                unsafe shapes, [poses], [pairs], options, unsafe caches.cast(), unsafe contacts, count
            ))
        })
    }

    #[inline]
    fn call(
        &self,
        a: Placed<'_>,
        b: Placed<'_>,
        cache: Option<&mut sys::hs_pair_cache>,
        contact: &mut Contact,
    ) -> Result<()> {
        // The error text is in the context of the first shape.
        let (options, contact) = (self.options.as_ref(), &mut contact.raw);
        call!(a.shape => hs_pair_detect(a.pose, b.shape, b.pose, options, cache, contact))
    }

    fn with(self, change: impl FnOnce(&mut sys::hs_pair_options)) -> Self {
        let mut options = self
            .options
            .unwrap_or_else(|| defaults(sys::hs_pair_options_init));
        change(&mut options);
        Self {
            options: Some(options),
        }
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
