// Hulls, mass properties, cuts and intersections of half-spaces against CGAL's exact kernel.

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "catch.h"
#include "geometry/polyhedron/cut.h"
#include "geometry/polyhedron/halfspaces.h"
#include "geometry/polyhedron/hull.h"
#include "geometry/precise.h"
#include "geometry/shape.h"

namespace halfspace {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using ExactPoint = Kernel::Point_3;
using ExactVector = Kernel::Vector_3;
using ExactPolyhedron = CGAL::Polyhedron_3<Kernel>;
using Random = std::mt19937_64;
using Cloud = std::vector<Vector<3>>;

constexpr double epsilon = 0x1p-52;

double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

Vector<3> uniform_vector(Random& random, double from, double to) {
  const double x = uniform(random, from, to), y = uniform(random, from, to), z = uniform(random, from, to);
  return {x, y, z};
}

Vector<3> direction(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return Vector<3>(x, y, z).normalized();
}

Cloud turned(Cloud cloud, Random& random) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(uniform(random, 0, 6), direction(random)).toRotationMatrix();
  for (Vector<3>& p : cloud) p = turn * p;
  return cloud;
}

Cloud ball(Random& random, int count) {
  Cloud cloud;
  while (int(cloud.size()) < count) {
    const Vector<3> p = uniform_vector(random, -1, 1);
    if (p.norm() <= 1) cloud.push_back(p);
  }
  return cloud;
}

Cloud sphere(Random& random, int count) {
  Cloud cloud;
  for (int i = 0; i < count; ++i) cloud.push_back(direction(random));
  return cloud;
}

Cloud grid(int nx, int ny, int nz) {
  Cloud cloud;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) cloud.push_back(Vector<3>(i, j, k) / 4);
    }
  }
  return cloud;
}

Cloud stretched(Cloud cloud, const Vector<3>& factors) {
  for (Vector<3>& p : cloud) p = p.cwiseProduct(factors);
  return cloud;
}

Cloud moved(Cloud cloud, const Vector<3>& by) {
  for (Vector<3>& p : cloud) p += by;
  return cloud;
}

/// Every corner of a box is a few points 1e-8 apart.
Cloud short_edges(Random& random) {
  Cloud cloud;
  for (const Vector<3>& corner : grid(2, 2, 2)) {
    for (int i = 0; i < 4; ++i) cloud.push_back(corner + 1e-8 * uniform_vector(random, -1, 1));
  }
  return cloud;
}

struct Family {
  const char* name;
  std::function<Cloud(Random&)> draw;
  bool is_coplanar_by_the_bit;  // what should be in one plane is, in exact arithmetic
};

const std::vector<Family> families = {
    {"tetrahedra", [](Random& r) { return ball(r, 4); }, true},
    {"ball", [](Random& r) { return ball(r, 60); }, true},
    {"sphere", [](Random& r) { return sphere(r, 120); }, true},
    {"lattice", [](Random& r) { return stretched(grid(5, 4, 3), uniform_vector(r, 1, 2)); }, true},
    {"lattice points of a ball",
     [](Random& r) {
       Cloud cloud;
       const double radius = uniform(r, 1.5, 5);
       for (const Vector<3>& p : moved(grid(11, 11, 11), {-1.25, -1.25, -1.25}))
         if (4 * p.norm() <= radius) cloud.push_back(p);
       return cloud;
     },
     true},
    {"turned lattice", [](Random& r) { return turned(grid(5, 4, 3), r); }, false},
    {"slivers 1e-6",
     [](Random& r) {
       return turned(stretched(ball(r, 20), {1, 1, 1e-6}), r);
     },
     true},
    {"needles 1e-6",
     [](Random& r) {
       return turned(stretched(ball(r, 20), {1, 1e-6, 1e-6}), r);
     },
     true},
    {"short edges 1e-8", [](Random& r) { return short_edges(r); }, true},
    {"1e8 from the origin",
     [](Random& r) {
       return moved(ball(r, 30), {1e8, -1e8, 1e8});
     },
     true},
    {"1e8 from the origin, lattice",
     [](Random&) {
       return moved(grid(4, 4, 4), {1e8, 2e8, -1e8});
     },
     true},
};

ExactPoint exact(const Vector<3>& p) { return {p.x(), p.y(), p.z()}; }
double rounded(const Number& x) { return CGAL::to_double(x.exact()); }

ExactPolyhedron exact_hull(const std::vector<ExactPoint>& points) {
  ExactPolyhedron hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return hull;
}

ExactPolyhedron exact_hull(const Cloud& cloud) {
  std::vector<ExactPoint> points;
  for (const Vector<3>& p : cloud) points.push_back(exact(p));
  return exact_hull(points);
}

/// Volume, first moments and second moments about the origin, six-fold volume weights: exact.
struct ExactMoments {
  Number volume = 0;
  Number first[3] = {0, 0, 0};
  Number second[6] = {0, 0, 0, 0, 0, 0};  // xx yy zz xy yz zx

  void add_tetrahedron(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
    const Number v = CGAL::scalar_product(a, CGAL::cross_product(b, c)) / 6;
    const ExactVector s = a + b + c;
    volume += v;
    const int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
    for (int i = 0; i < 3; ++i) first[i] += v * s[i] / 4;
    for (int i = 0; i < 6; ++i) {
      const auto [p, q] = pairs[i];
      second[i] += v * (s[p] * s[q] + a[p] * a[q] + b[p] * b[q] + c[p] * c[q]) / 20;
    }
  }
  Number centroid(int i) const { return first[i] / volume; }
  Number central_second(int i) const {
    const int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
    return second[i] - first[pairs[i][0]] * first[pairs[i][1]] / volume;
  }
};

ExactMoments exact_moments(const ExactPolyhedron& p) {
  ExactMoments moments;
  for (auto f = p.facets_begin(); f != p.facets_end(); ++f) {
    const auto h = f->halfedge();
    moments.add_tetrahedron(h->vertex()->point() - CGAL::ORIGIN, h->next()->vertex()->point() - CGAL::ORIGIN,
                            h->next()->next()->vertex()->point() - CGAL::ORIGIN);
  }
  return moments;
}

/// The same polyhedron as it stands, faces in triangles from their first corner.
ExactMoments exact_moments(const Polyhedron& p) {
  ExactMoments moments;
  for (std::int32_t f = 0; f < p.face_count(); ++f) {
    for (std::size_t i = 1; i + 1 < p.loop(f).size(); ++i) {
      moments.add_tetrahedron(exact(p.corner(f, 0)) - CGAL::ORIGIN, exact(p.corner(f, i)) - CGAL::ORIGIN,
                              exact(p.corner(f, i + 1)) - CGAL::ORIGIN);
    }
  }
  return moments;
}

/// Faces of a triangulated hull: triangles less the edges between two in one plane.
int whole_faces(const ExactPolyhedron& p) {
  std::map<const void*, int> face_of;
  int faces = 0;
  for (auto f = p.facets_begin(); f != p.facets_end(); ++f) {
    if (face_of.count(&*f)) continue;
    std::vector<ExactPolyhedron::Facet_const_handle> waiting{f};
    face_of[&*f] = faces;
    while (!waiting.empty()) {
      const auto g = waiting.back();
      waiting.pop_back();
      auto h = g->halfedge();
      for (int i = 0; i < 3; ++i, h = h->next()) {
        const auto o = h->opposite();
        if (face_of.count(&*o->facet())) continue;
        if (!CGAL::coplanar(h->vertex()->point(), h->next()->vertex()->point(),
                            h->next()->next()->vertex()->point(), o->next()->vertex()->point()))
          continue;
        face_of[&*o->facet()] = faces;
        waiting.push_back(o->facet());
      }
    }
    ++faces;
  }
  return faces;
}

double surface_of(const ExactPolyhedron& p) {
  double surface = 0;
  for (auto f = p.facets_begin(); f != p.facets_end(); ++f) {
    const auto h = f->halfedge();
    const ExactPoint& a = h->vertex()->point();
    const ExactVector n =
        CGAL::cross_product(h->next()->vertex()->point() - a, h->next()->next()->vertex()->point() - a);
    surface += 0.5 * std::sqrt(rounded(n.squared_length()));
  }
  return surface;
}

Memory* memory() { return std::pmr::get_default_resource(); }

}  // namespace

TEST_CASE("hulls hold all points, have CGAL's volume, centroid and whole faces") {
  for (const Family& family : families) {
    Random random(5);
    int refused = 0, other_faces = 0;
    double worst_volume = 0, worst_centroid = 0, worst_height = 0;
    constexpr int rounds = 20;
    for (int round = 0; round < rounds; ++round) {
      const Cloud cloud = family.draw(random);
      const ExactPolyhedron truth = exact_hull(cloud);
      Polyhedron hull(memory());
      const PolyhedronFault report = convex_hull(cloud, hull);
      if (report.fault != Fault::none) {
        UNSCOPED_INFO(family.name << " refused: " << fault_text(report.fault));
        ++refused;
        continue;
      }
      const Shape<3> shape(hull, memory());
      const ExactMoments moments = exact_moments(truth);
      const double reach = largest_coordinate(cloud);
      const double unit = epsilon * reach;

      // Leaving out what is coplanar to rounding moves the surface by the tolerance at most.
      const double volume_error = std::abs(rounded(Number(shape.volume()) - moments.volume));
      worst_volume = std::max(worst_volume, volume_error / (unit * surface_of(truth)));
      for (int i = 0; i < 3; ++i) {
        // First moments err by the volume's error times the distance to its place.
        const double error = std::abs(rounded(Number(shape.centroid()[i]) - moments.centroid(i)));
        const double lever = 2 * shape.bounding_radius() * surface_of(truth) / shape.volume();
        worst_centroid = std::max(worst_centroid, error / (unit * (1 + lever)));
      }
      for (int f = 0; f < shape.face_count(); ++f) {
        const ExactVector n = exact(shape.outline().normal(f)) - CGAL::ORIGIN;
        const ExactPoint c = exact(shape.centroid());
        for (auto v = truth.vertices_begin(); v != truth.vertices_end(); ++v) {
          const Number height = CGAL::scalar_product(n, v->point() - c) - Number(shape.outline().offset[f]);
          if (height > 0) worst_height = std::max(worst_height, rounded(height) / unit);
        }
      }
      other_faces += family.is_coplanar_by_the_bit && whole_faces(truth) != shape.face_count();
    }
    std::printf(
        "%-30s refused %2d, other faces %2d, errors in eps reach: volume %7.2f centroid %7.2f height %7.2f\n",
        family.name, refused, other_faces, worst_volume, worst_centroid, worst_height);
    CHECK(refused == 0);
    CHECK(other_faces == 0);
    // coplanarity_tolerance() and the rounding of the sums.
    CHECK(worst_volume < 16 + 8);
    CHECK(worst_centroid < 16 + 8);
    CHECK(worst_height < flatness_tolerance(1) / epsilon);
  }
}

TEST_CASE("moments of a polyhedron as it stands are those of exact arithmetic") {
  for (const Family& family : families) {
    Random random(6);
    double worst_volume = 0, worst_second = 0;
    for (int round = 0; round < 20; ++round) {
      Polyhedron hull(memory());
      if (convex_hull(family.draw(random), hull).fault != Fault::none) continue;
      const Shape<3> shape(hull, memory());
      const ExactMoments moments = exact_moments(hull);
      // Differences of coordinates are rounded: that is as if the surface moved by as much.
      double surface = 0;
      for (std::int32_t f = 0; f < hull.face_count(); ++f) {
        for (std::size_t i = 1; i + 1 < hull.loop(f).size(); ++i) {
          surface +=
              0.5 * precise_cross_product(hull.corner(f, 0), hull.corner(f, i), hull.corner(f, i + 1)).norm();
        }
      }
      const double radius = shape.bounding_radius();
      const double size = surface * radius;
      worst_volume =
          std::max(worst_volume, std::abs(rounded(Number(shape.volume()) - moments.volume)) / size);
      for (int i = 0; i < 6; ++i) {
        const Number error = Number(shape.second_moment()[i]) - moments.central_second(i);
        worst_second = std::max(worst_second, std::abs(rounded(error)) / (size * radius * radius));
      }
    }
    std::printf("%-30s errors in eps surface radius: volume %8.2f second moment %8.2f\n", family.name,
                worst_volume / epsilon, worst_second / epsilon);
    CHECK(worst_volume < 4 * epsilon);
    CHECK(worst_second < 4 * epsilon);
  }
}

TEST_CASE("parts of a cut have the volume of the exact parts") {
  for (const Family& family : families) {
    Random random(7);
    double worst = 0;
    int too_thin = 0;
    for (int round = 0; round < 20; ++round) {
      Polyhedron hull(memory());
      if (convex_hull(family.draw(random), hull).fault != Fault::none) continue;
      const Shape<3> shape(hull, memory());
      // Through somewhere between two vertices, so that flat shapes are cut, too.
      const auto some = [&] { return hull.vertices[random() % hull.vertices.size()]; };
      const Vector<3> point = some() + uniform(random, 0.2, 0.8) * (some() - some()) * 0.5;
      const Vector<3> normal = direction(random);
      const PolyhedronParts parts = cut_polyhedron(hull, point, normal, memory());
      if (parts.too_thin != Fault::none) {
        ++too_thin;
        continue;
      }
      std::vector<ExactPoint> behind;
      std::vector<Number> height;
      const ExactVector n = exact(normal) - CGAL::ORIGIN;
      for (const Vector<3>& v : hull.vertices)
        height.push_back(CGAL::scalar_product(n, exact(v) - exact(point)));
      for (std::size_t i = 0; i < height.size(); ++i) {
        const ExactPoint p = exact(hull.vertices[i]);
        if (height[i] <= 0) behind.push_back(p);
        for (std::size_t j = 0; j < height.size(); ++j) {
          if (height[i] < 0 && height[j] > 0)
            behind.push_back(p + height[i] / (height[i] - height[j]) * (exact(hull.vertices[j]) - p));
        }
      }
      if (behind.size() < 4) continue;
      const ExactPolyhedron truth = exact_hull(behind);
      if (truth.size_of_facets() < 4) continue;
      const double got = parts.behind.is_empty() ? 0 : Shape<3>(parts.behind, memory()).volume();
      const double error = std::abs(rounded(Number(got) - exact_moments(truth).volume));
      const double unit = epsilon * (largest_coordinate(hull.vertices) + shape.bounding_radius());
      worst = std::max(worst, error / (unit * surface_of(truth)));
    }
    std::printf("%-30s cut: too thin %2d, volume error in eps reach surface %8.2f\n", family.name, too_thin,
                worst);
    CHECK(worst < 16 + 8);
  }
}

TEST_CASE("half-spaces have CGAL's intersection") {
  Random random(8);
  double worst = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<Halfspace<3>> halfspaces;
    std::vector<Kernel::Plane_3> planes;
    for (int i = 0; i < 60; ++i) {
      const Vector<3> n = direction(random);
      const double offset = uniform(random, 0.5, 1);
      halfspaces.push_back({n, offset});
      planes.emplace_back(n.x(), n.y(), n.z(), -offset);
    }
    ExactPolyhedron truth;
    CGAL::halfspace_intersection_3(planes.begin(), planes.end(), truth, ExactPoint(0, 0, 0));
    Polyhedron got(memory());
    std::int64_t redundant = 0;
    REQUIRE(polyhedron_from_halfspaces(halfspaces, got, redundant).fault == Fault::none);
    CHECK(std::size_t(got.face_count()) == truth.size_of_facets());
    CHECK(std::size_t(got.vertex_count()) == truth.size_of_vertices());
    CHECK(redundant == std::int64_t(60 - truth.size_of_facets()));
    std::vector<ExactPoint> vertices(truth.points_begin(), truth.points_end());
    const double volume = rounded(exact_moments(exact_hull(vertices)).volume);
    worst = std::max(worst, std::abs(Shape<3>(got, memory()).volume() - volume) / volume);
  }
  std::printf("half-spaces: worst relative error of volume %g\n", worst);
  // Offsets are exact; each vertex is off by a few roundings over the sine of its least angle.
  CHECK(worst < 1e-13);
}

}  // namespace halfspace
