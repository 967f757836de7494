#include "geometry/polyhedron/quickhull.h"

#include <csetjmp>
#include <cstdio>
#include <new>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace halfspace {
namespace {

/// Loops in plain memory: qhull exits by longjmp, which skips destructors.
struct Loops {
  std::int32_t* first_of_facet;
  std::int32_t* corners;
  std::int32_t max_facets;
  std::int32_t max_corners;
  std::int32_t facets;
};

void copy_loops(qhT* qh, Loops& loops) {
  loops.facets = 0;
  loops.first_of_facet[0] = 0;
  std::int32_t corners = 0;
  facetT* facet;
  FORALLfacets {
    setT* loop = qh_facet3vertex(qh, facet);
    if (loops.facets == loops.max_facets || corners + qh_setsize(qh, loop) > loops.max_corners)
      qh_errexit(qh, qh_ERRqhull, facet, nullptr);  // not the surface of a polyhedron
    vertexT* vertex;
    vertexT** vertexp;
    FOREACHvertex_(loop) loops.corners[corners++] = qh_pointid(qh, vertex->point);
    qh_settempfree(qh, &loop);
    loops.first_of_facet[++loops.facets] = corners;
  }
}

/// Returns qhull's exit code; 0 is success.
int copy_loops_or_return(qhT* qh, Loops& loops) {
  const int code = setjmp(qh->errexit);
  if (code == 0) {
    qh->NOerrexit = False;
    copy_loops(qh, loops);
  }
  qh->NOerrexit = True;
  return code;
}

int run(double* coordinates, int count, double coplanar, std::FILE* messages, Loops& loops) {
  char command[64];
  std::snprintf(command, sizeof command, "qhull Pp C-%.17g", coplanar);
  qhT state;
  qh_zero(&state, messages);
  int code = qh_new_qhull(&state, 3, count, coordinates, False, command, nullptr, messages);
  if (code == 0) code = copy_loops_or_return(&state, loops);
  int long_left;
  int total_left;
  qh_freeqhull(&state, !qh_ALL);
  qh_memfreeshort(&state, &long_left, &total_left);
  return code;
}

}  // namespace

QuickhullResult quickhull(Array<double>& coordinates, double coplanar, Array<std::int32_t>& first_of_facet,
                          Array<std::int32_t>& corners) {
  const auto count = std::int32_t(coordinates.size() / 3);
  // By Euler's formula for triangles only.
  const std::int32_t max_facets = 2 * count - 4;
  first_of_facet.resize(std::size_t(max_facets) + 1);
  corners.resize(std::size_t(3 * max_facets));
  Loops loops{first_of_facet.data(), corners.data(), max_facets, 3 * max_facets, 0};

  // qhull requires a stream for its messages: a buffer that is not read.
#ifdef _WIN32
  std::FILE* messages = std::fopen("NUL", "w");
#else
  char buffer[256];
  std::FILE* messages = fmemopen(buffer, sizeof buffer, "w");
#endif
  if (!messages) throw std::bad_alloc();
  const int code = run(coordinates.data(), count, coplanar, messages, loops);
  std::fclose(messages);

  if (code == qh_ERRmem) throw std::bad_alloc();
  if (code == qh_ERRsingular) return QuickhullResult::flat;
  if (code != qh_ERRnone) return QuickhullResult::failed;
  first_of_facet.resize(std::size_t(loops.facets) + 1);
  corners.resize(std::size_t(first_of_facet.back()));
  return QuickhullResult::ok;
}

}  // namespace halfspace
