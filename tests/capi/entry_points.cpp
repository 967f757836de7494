#include "capi/entry_points.h"

namespace halfspace_test {
namespace {

constexpr double nowhere[3] = {0, 0, 0}, aslant[3] = {1, 2, 0};

hs_block_def block_def(Scene& s) {
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, s.round.get()), s.context.get());
  def.pose.position[1] = 2.5;
  return def;
}

void detect(Scene& s) { require_ok(hs_world_detect(s.world.get(), nullptr), s.context.get()); }

void set_upward_velocity(Scene& s, double velocity) {
  const double up[3] = {0, velocity, 0};
  require_ok(hs_world_set_velocity(s.world.get(), s.upper, up, nowhere), s.context.get());
}

/// The next step takes the upper block so far, towards another, that it uses the neighbour list up and has
/// more pairs in the next.
void throw_upper(Scene& s) {
  set_upward_velocity(s, 0.4 / report_of(s.world.get()).time_step);
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, s.box.get()), s.context.get());
  def.kind = HS_BLOCK_FIXED;
  def.pose.position[1] = 3.25;
  hs_block target = 0;
  require_ok(hs_world_add_block(s.world.get(), s.box.get(), &def, &target), s.context.get());
}

/// Contacts and forces are known as well.
void throw_upper_prepared(Scene& s) {
  throw_upper(s);
  report_of(s.world.get());
}

void throw_upper_detected(Scene& s) {
  throw_upper(s);
  detect(s);
}

/// Forces are known, but of before the change.
void throw_upper_a_little_faster(Scene& s) {
  throw_upper_prepared(s);
  set_upward_velocity(s, 0.41 / report_of(s.world.get()).time_step);
}

/// The blocks stick together where they meet, once their first step begins.
void throw_upper_glued(Scene& s) {
  hs_law_def law = law_def(1e7, 0.5);
  law.cohesion = law.tensile_strength = 1e5;
  require_ok(hs_world_set_default_law(s.world.get(), &law), s.context.get());
  const hs_pose touching = {{0, 1.5, 0}, {0, 0, 0, 1}};
  require_ok(hs_world_set_pose(s.world.get(), s.upper, &touching), s.context.get());
  throw_upper_prepared(s);
}

hs_status step(Scene& s) { return hs_world_step(s.world.get(), 1); }

/// Read from a snapshot, with a list but no contact: the upper block comes down on the lower in the next
/// step.
void throw_upper_down_restored(Scene& s) {
  const hs_pose above = {{0, 1.501, 0}, {0, 0, 0, 1}};
  require_ok(hs_world_set_pose(s.world.get(), s.upper, &above), s.context.get());
  set_upward_velocity(s, -0.025 / report_of(s.world.get()).time_step);
  report_of(s.world.get());
  s.snapshot = saved(s.world.get());
  s.world = restored(s.context.get(), s.snapshot);
}

/// The same by potentials, which need room of their own.
void throw_upper_down_by_potentials(Scene& s) {
  hs_law_def law = law_def(1e7, 0.5);
  law.stiffness_kind = HS_STIFFNESS_POTENTIAL;
  require_ok(hs_world_set_default_law(s.world.get(), &law), s.context.get());
  throw_upper_down_restored(s);
}

hs_status step_into_contact(Scene& s) {
  const hs_status status = step(s);
  if (status != HS_OK) return status;
  require_ok(hs_world_get_contacts(s.world.get(), &s.written.contact, 1, &s.written.counts[0]),
             s.context.get());
  if (s.written.counts[0] != 1) throw std::runtime_error("the blocks have not met");
  return HS_OK;
}

constexpr double strained[9] = {1.001, 0.0002, 0, 0, 0.999, 0, 0, 0, 1};
constexpr double still[9] = {};
constexpr double pressed[9] = {-1e3, 0, 0, 0, -2e3, 0, 0, 0, -1e3};

hs_status set_elasticity(Scene& s) {
  const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-5);
  return hs_world_set_elasticity(s.world.get(), 0, &elasticity);
}

hs_status add_affine(Scene& s, hs_block* block) {
  hs_block_def def = block_def(s);
  def.kind = HS_BLOCK_AFFINE;
  def.pose = s.poses[1];
  return hs_world_add_block(s.world.get(), s.round.get(), &def, block);
}

void make_upper_affine(Scene& s) {
  make_material_elastic(s);
  require_ok(hs_world_remove_block(s.world.get(), s.upper), s.context.get());
  require_ok(add_affine(s, &s.upper), s.context.get());
}

void throw_upper_affine(Scene& s) {
  make_upper_affine(s);
  hs_law_def law = law_def(1e7, 0.5);
  law.stiffness_kind = HS_STIFFNESS_POTENTIAL;
  require_ok(hs_world_set_default_law(s.world.get(), &law), s.context.get());
  throw_upper_prepared(s);
}

hs_status cut(Scene& s) {
  return keep(s.made.shapes[0], [&](hs_shape** behind) {
    return keep(s.made.shapes[1], [&](hs_shape** ahead) {
      return hs_shape_cut(s.round.get(), nowhere, aslant, behind, ahead);
    });
  });
}

hs_status find_impact(Scene& s) {
  hs_motion_def motion;
  require_ok(hs_motion_def_init(&motion, sizeof motion), s.context.get());
  hs_motion_def falling = motion;
  falling.start.position[1] = 5;
  falling.velocity[1] = -10;
  return hs_pair_time_of_impact(s.box.get(), &motion, s.round.get(), &falling, 1, &s.written.impact);
}

hs_status detect_pairs(Scene& s) {
  const hs_shape* shapes[2] = {s.box.get(), s.round.get()};
  const std::int32_t pairs[2] = {0, 1};
  return hs_pairs_detect(s.context.get(), shapes, s.poses, 2, pairs, 1, nullptr, nullptr, &s.written.contact,
                         &s.written.counts[0]);
}

hs_status find_boxes(Scene& s) {
  Points3 lower, upper;
  for (const double x : {0.0, 0.5, 2.0}) {
    lower.push_back({x, 0, 0});
    upper.push_back({x + 1, 1, 1});
  }
  return hs_boxes_find_pairs(s.context.get(), s.dimension, view_of(lower), view_of(upper),
                             s.written.indices[0], 256, &s.written.counts[0]);
}

/// Twice as wide.
hs_status set_vertices(Scene& s) {
  Points3 vertices = vertices_3d_of(s.round.get());
  for (Point3& vertex : vertices) vertex.x *= 2;
  return hs_shape_set_vertices(s.round.get(), view_of(vertices));
}

hs_status check_polyhedron(Scene& s) {
  return hs_polyhedron_check(s.context.get(), view_of(s.solid.vertices), s.solid.faces.sizes.data(), 6,
                             s.solid.faces.vertices.data(), &s.written.fault);
}

hs_status create_from_halfspaces(Scene& s) {
  return keep(s.made.shapes[0], [&](hs_shape** shape) {
    return hs_polyhedron_create_from_halfspaces(s.context.get(), view_of(s.halfspaces.normals),
                                                s.halfspaces.offsets.data(), shape);
  });
}

/// The first coordinates of the points, as a polygon.
hs_view polygon(Scene& s) {
  return {&s.points[0].x, &s.points[0].y, nullptr, sizeof(Point3), std::int64_t(s.points.size())};
}

}  // namespace

void make_material_elastic(Scene& s) { require_ok(set_elasticity(s), s.context.get()); }

Scene::Scene(int d) : dimension(d) {
  hs_context* c = context.get();
  hs_shape* made_round = nullptr;
  if (d == 2) {
    for (int i = 0; i < 50; ++i) points.push_back({std::cos(0.1256 * i), std::sin(0.1256 * i), 0});
    require_ok(hs_polygon_create(c, polygon(*this), &made_round), c);
    box = make_shape(c, halfspace_test::box(-0.5, -0.5, 0.5, 0.5));
  } else {
    Random random(1);
    points = round_points(random, 60);
    require_ok(hs_polyhedron_create_hull(c, view_of(points), &made_round), c);
    box = make_polyhedron(c, solid);
  }
  round.reset(made_round);
  halfspaces = halfspaces_of(make_polyhedron(c, solid).get());
  bar = make_mesh(c, halfspace_test::bar(d));

  hs_world_def settings = world_def();
  settings.dimension = d;
  world = make_world(c, settings);
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 1000, &material), c);
  const hs_law_def law = law_def(1e7, 0.5);
  require_ok(hs_world_set_default_law(world.get(), &law), c);
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, box.get()), c);
  def.kind = HS_BLOCK_FIXED;
  poses[0] = def.pose;
  require_ok(hs_world_add_block(world.get(), box.get(), &def, &lower), c);
  def.kind = HS_BLOCK_RIGID;
  def.pose.position[0] = 0.1;
  def.pose.position[1] = 1.4;
  poses[1] = def.pose;
  require_ok(hs_world_add_block(world.get(), round.get(), &def, &upper), c);
  snapshot = saved(world.get());

  std::memset(static_cast<void*>(&written), 0xee, sizeof written);
  made.context = make_context(&context_def);
  made.shapes[0] = make_shape(c, halfspace_test::box(0, 0, 1, 1));
  made.mesh = make_mesh(c, halfspace_test::bar(d));
  made.world = make_world(c, settings);
}

std::vector<EntryPoint> entry_points_of_shapes_and_blocks() {
  using S = Scene&;
  return {
      {"hs_status_string", Allocates::never,
       [](S) { return hs_status_string(HS_OK) ? HS_OK : HS_ERROR_INTERNAL; }},
      {"hs_version", Allocates::never, [](S) { return hs_version() ? HS_OK : HS_ERROR_INTERNAL; }},
      {"hs_context_last_error", Allocates::never,
       [](S s) { return hs_context_last_error(s.context.get()) ? HS_OK : HS_ERROR_INTERNAL; }},

      {"hs_context_def_init", Allocates::never, [](S) { return fill<hs_context_def>(hs_context_def_init); }},
      {"hs_elasticity_def_init", Allocates::never,
       [](S) { return fill<hs_elasticity_def>(hs_elasticity_def_init); }},
      {"hs_law_def_init", Allocates::never, [](S) { return fill<hs_law_def>(hs_law_def_init); }},
      {"hs_motion_def_init", Allocates::never, [](S) { return fill<hs_motion_def>(hs_motion_def_init); }},
      {"hs_pair_options_init", Allocates::never,
       [](S) { return fill<hs_pair_options>(hs_pair_options_init); }},
      {"hs_world_def_init", Allocates::never,
       [](S) {
         return fill<hs_world_def>(
             [](hs_world_def* def, std::size_t size) { return hs_world_def_init(def, size, 3); });
       }},
      {"hs_block_def_init", Allocates::never, [](S s) { return block_def(s), HS_OK; }},

      {"hs_context_create", Allocates::always,
       [](S s) {
         return keep(s.made.context, [&](hs_context** c) { return hs_context_create(&s.context_def, c); });
       }},
      {"hs_context_destroy", Allocates::never, [](S s) { return s.made.context.reset(), HS_OK; }},
      {"hs_shape_destroy", Allocates::never, [](S s) { return s.made.shapes[0].reset(), HS_OK; }},
      {"hs_world_destroy", Allocates::never, [](S s) { return s.made.world.reset(), HS_OK; }},

      {"hs_polygon_check", Allocates::always,
       [](S s) { return hs_polygon_check(s.context.get(), polygon(s), &s.written.fault); }},
      {"hs_polygon_create", Allocates::always,
       [](S s) {
         const Points corners = halfspace_test::box(0, 0, 2, 1);
         return keep(s.made.shapes[0], [&](hs_shape** shape) {
           return hs_polygon_create(s.context.get(), view_of(corners), shape);
         });
       }},
      {"hs_polygon_create_hull", Allocates::always,
       [](S s) {
         return keep(s.made.shapes[0], [&](hs_shape** shape) {
           return hs_polygon_create_hull(s.context.get(), polygon(s), shape);
         });
       }},
      {"hs_polygon_create_boundary", Allocates::always,
       [](S s) {
         const double first[3] = {2, 1, 0}, second[3] = {-2, 0, 0};
         return keep(s.made.shapes[0], [&](hs_shape** shape) {
           return hs_polygon_create_boundary(s.context.get(), nullptr, first, second, nullptr, 1, shape);
         });
       }},
      {"hs_polygon_clean", Allocates::always,
       [](S s) {
         return hs_polygon_clean(s.context.get(), polygon(s), 0, room(s, 0), &s.written.counts[0],
                                 &s.written.cleaning);
       }},
      {"hs_polyhedron_check", Allocates::always, check_polyhedron},
      {"hs_polyhedron_create", Allocates::always,
       [](S s) {
         return keep(s.made.shapes[0],
                     [&](hs_shape** shape) { return create_polyhedron(s.context.get(), s.solid, shape); });
       }},
      {"hs_polyhedron_create_hull", Allocates::always,
       [](S s) {
         return keep(s.made.shapes[0], [&](hs_shape** shape) {
           return hs_polyhedron_create_hull(s.context.get(), view_of(s.solid.vertices), shape);
         });
       }},
      {"hs_polyhedron_create_fitted", Allocates::always,
       [](S s) {
         return keep(s.made.shapes[0], [&](hs_shape** shape) {
           return hs_polyhedron_create_fitted(s.context.get(), view_of(s.solid.vertices),
                                              s.solid.faces.sizes.data(),
                                              std::int64_t(s.solid.faces.sizes.size()),
                                              s.solid.faces.vertices.data(), 1e-3, shape, &s.written.fitting);
         });
       }},
      {"hs_polyhedron_create_from_halfspaces", Allocates::always, create_from_halfspaces},
      {"hs_shape_cut", Allocates::always, cut},

      {"hs_shape_get_properties", Allocates::never,
       [](S s) {
         return hs_shape_get_properties(s.round.get(), &s.written.properties, sizeof s.written.properties);
       }},
      {"hs_shape_get_vertices", Allocates::never,
       [](S s) { return hs_shape_get_vertices(s.round.get(), room(s, 0), &s.written.counts[0]); }},
      {"hs_shape_get_faces", Allocates::never,
       [](S s) {
         return hs_shape_get_faces(s.round.get(), s.written.indices[0], 512, s.written.indices[1], 512,
                                   &s.written.counts[0], &s.written.counts[1]);
       }},
      {"hs_shape_get_edges", Allocates::never,
       [](S s) {
         return hs_shape_get_edges(s.round.get(), s.written.indices[0], 256, &s.written.counts[0]);
       }},
      {"hs_shape_get_halfspaces", Allocates::never,
       [](S s) { return hs_shape_get_halfspaces(s.round.get(), room(s, 0), nullptr, &s.written.counts[0]); }},

      {"hs_shape_set_vertices", Allocates::never, set_vertices},

      {"hs_shape_cast_ray", Allocates::never,
       [](S s) {
         return hs_shape_cast_ray(s.round.get(), &s.poses[1], nowhere, aslant, 9, &s.written.hits[0]);
       }},
      {"hs_world_cast_ray", Allocates::never,
       [](S s) { return hs_world_cast_ray(s.world.get(), nowhere, aslant, 9, &s.written.hits[1]); }},
      {"hs_pair_distance", Allocates::in_the_plane,
       [](S s) {
         return hs_pair_distance(s.round.get(), &s.poses[0], s.round.get(), &s.poses[1], &s.written.closest);
       }},
      {"hs_boxes_find_pairs", Allocates::always, find_boxes},
      {"hs_points_order_along_curve", Allocates::always,
       [](S s) {
         const Points3 points{{2, 0, 0}, {0, 1, 1}, {1, 1, 0}};
         return hs_points_order_along_curve(s.context.get(), s.dimension, view_of(points),
                                            s.written.indices[0]);
       }},

      {"hs_pair_detect", Allocates::in_the_plane,
       [](S s) {
         return hs_pair_detect(s.box.get(), &s.poses[0], s.round.get(), &s.poses[1], nullptr, nullptr,
                               &s.written.contact);
       }},
      {"hs_pairs_detect", Allocates::in_the_plane, detect_pairs},
      {"hs_pair_time_of_impact", Allocates::always, find_impact},

      {"hs_world_create", Allocates::always,
       [](S s) {
         hs_world_def def = world_def();
         def.dimension = s.dimension;
         return keep(s.made.world,
                     [&](hs_world** world) { return hs_world_create(s.context.get(), &def, world); });
       }},
      {"hs_world_add_material", Allocates::always,
       [](S s) { return hs_world_add_material(s.world.get(), 2000, &s.written.indices[0][0]); }},
      {"hs_world_set_default_law", Allocates::never,
       [](S s) {
         const hs_law_def law = law_def(2e7, 0.1);
         return hs_world_set_default_law(s.world.get(), &law);
       }},
      {"hs_world_set_law", Allocates::always,
       [](S s) {
         const hs_law_def law = law_def(2e7, 0.1);
         return hs_world_set_law(s.world.get(), 0, 0, &law);
       }},
      {"hs_world_add_block", Allocates::always,
       [](S s) {
         const hs_block_def def = block_def(s);
         return hs_world_add_block(s.world.get(), s.round.get(), &def, &s.written.blocks[0]);
       }},
      {"hs_world_remove_block", Allocates::never,
       [](S s) { return hs_world_remove_block(s.world.get(), s.lower); }},
      {"hs_world_get_blocks", Allocates::never,
       [](S s) { return hs_world_get_blocks(s.world.get(), s.written.blocks, 4, &s.written.counts[0]); }},
      {"hs_world_get_block_state", Allocates::never,
       [](S s) { return hs_world_get_block_state(s.world.get(), s.upper, &s.written.state); }},
      {"hs_world_get_block_states", Allocates::never,
       [](S s) {
         return hs_world_get_block_states(s.world.get(), s.written.states, 4, &s.written.counts[0]);
       }},
      {"hs_world_get_block_vertices", Allocates::never,
       [](S s) {
         return hs_world_get_block_vertices(s.world.get(), s.upper, room(s, 0), &s.written.counts[0]);
       }},
      {"hs_world_set_pose", Allocates::never,
       [](S s) { return hs_world_set_pose(s.world.get(), s.upper, &s.poses[0]); }},
      {"hs_world_set_velocity", Allocates::never,
       [](S s) { return hs_world_set_velocity(s.world.get(), s.upper, aslant, nowhere); }},
      {"hs_world_set_applied_force", Allocates::never,
       [](S s) { return hs_world_set_applied_force(s.world.get(), s.upper, aslant, nowhere); }},
      {"hs_world_get_poses", Allocates::never,
       [](S s) { return hs_world_get_poses(s.world.get(), s.written.poses, 4, &s.written.counts[0]); }},
      {"hs_world_set_poses", Allocates::never,
       [](S s) { return hs_world_set_poses(s.world.get(), s.poses, 2); }},
      {"hs_world_get_velocities", Allocates::never,
       [](S s) { return hs_world_get_velocities(s.world.get(), room(s, 0), room(s, 1)); }},
      {"hs_world_set_velocities", Allocates::never,
       [](S s) {
         const Points3 velocities = {{0, 0, 0}, {1, 2, 0}};
         return hs_world_set_velocities(s.world.get(), view_of(velocities), {});
       }},
      {"hs_world_set_applied_forces", Allocates::never,
       [](S s) {
         const Points3 forces = {{0, 0, 0}, {1, 2, 0}};
         return hs_world_set_applied_forces(s.world.get(), view_of(forces), {});
       }},
      {"hs_world_detect", Allocates::always,
       [](S s) { return hs_world_detect(s.world.get(), &s.written.counts[0]); }},
      {"hs_world_step", Allocates::always, step, throw_upper_prepared},
      {"hs_world_get_report", Allocates::always,
       [](S s) { return hs_world_get_report(s.world.get(), &s.written.report, sizeof s.written.report); }},
      {"hs_world_get_plan", Allocates::always,
       [](S s) {
         hs_world_plan plan;
         return hs_world_get_plan(s.world.get(), 1, &plan, sizeof plan);
       }},
      {"hs_world_get_contacts", Allocates::never,
       [](S s) { return hs_world_get_contacts(s.world.get(), &s.written.contact, 1, &s.written.counts[0]); },
       detect},
      {"hs_world_set_shear_force", Allocates::never,
       [](S s) { return hs_world_set_shear_force(s.world.get(), s.lower, s.upper, aslant); }, detect},

      {"hs_world_set_elasticity", Allocates::never, set_elasticity},
      {"hs_world_get_deformation", Allocates::never,
       [](S s) { return hs_world_get_deformation(s.world.get(), s.upper, &s.written.deformations[0]); },
       make_upper_affine},
      {"hs_world_get_deformations", Allocates::never,
       [](S s) {
         return hs_world_get_deformations(s.world.get(), s.written.deformations, 4, &s.written.counts[0]);
       },
       make_upper_affine},
      {"hs_world_set_deformation", Allocates::never,
       [](S s) { return hs_world_set_deformation(s.world.get(), s.upper, strained, still); },
       make_upper_affine},
      {"hs_world_set_stress", Allocates::never,
       [](S s) { return hs_world_set_stress(s.world.get(), s.upper, pressed); }, make_upper_affine},
      {"hs_world_add_surface_load", Allocates::never,
       [](S s) { return hs_world_add_surface_load(s.world.get(), s.upper, 2, aslant); }, make_upper_affine},
      {"hs_world_clear_surface_loads", Allocates::never,
       [](S s) { return hs_world_clear_surface_loads(s.world.get(), s.upper); }, make_upper_affine},

      {"hs_world_save", Allocates::never,
       [](S s) {
         return hs_world_save(s.world.get(), s.snapshot.data(), s.snapshot.size(), &s.written.size);
       }},
      {"hs_world_restore", Allocates::always,
       [](S s) {
         return keep(s.made.world, [&](hs_world** world) {
           return hs_world_restore(s.context.get(), s.snapshot.data(), s.snapshot.size(), world);
         });
       }},
  };
}

std::vector<EntryPoint> entry_points() {
  std::vector<EntryPoint> all;
  for (const auto& part :
       {entry_points_of_shapes_and_blocks(), entry_points_of_meshes(), entry_points_of_actions(),
        entry_points_of_bonds(), entry_points_of_compounds(), entry_points_of_rest(), entry_points_of_loads(),
        entry_points_of_shares(), entry_points_of_definitions()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<EntryPoint> steps_of_changed_worlds() {
  return {{"a step, nothing known", Allocates::always, step, throw_upper},
          {"a step, contacts known", Allocates::always, step, throw_upper_detected},
          {"a step, forces known", Allocates::always, step, throw_upper_a_little_faster},
          {"a step that makes bonds", Allocates::always, step, throw_upper_glued},
          {"a step of a restored world", Allocates::always, step_into_contact, throw_upper_down_restored},
          {"a step of a restored world with potentials", Allocates::always, step_into_contact,
           throw_upper_down_by_potentials},
          {"a step of an affine block", Allocates::always, step, throw_upper_affine},
          {"an affine block beside others", Allocates::always,
           [](Scene& s) { return add_affine(s, &s.written.blocks[0]); }, make_material_elastic}};
}

}  // namespace halfspace_test
