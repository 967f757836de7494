#include "recording/recording.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "recording/encoding.h"

namespace halfspace::viewer {
namespace {

/// The columns of a block and of a contact that stand at a fixed place.
constexpr std::size_t present = 0, first_coordinate = 1;

constexpr double angle_step = 0x1p-12, turn_step = 0x1p-11;  // in 2D, in 3D
constexpr double direction_step = 0x1p-6;
constexpr double positions_per_size = 2048;  // of a block
constexpr double steps_per_origin = 0x1p20;
constexpr std::size_t max_frames_per_group = 32, values_per_group = 400000;

constexpr const char* axes[] = {"x", "y", "z"};

/// A column for each axis.
void add_axes(std::vector<Column>& columns, const std::string& name, const char* unit, int dimension,
              Coding coding, double step = 1) {
  for (int axis = 0; axis < dimension; ++axis)
    columns.push_back({.name = name + axes[axis], .unit = unit, .coding = coding, .step = step});
}

/// The vector rotated by a unit quaternion.
Point rotated(const Quaternion& q, const Point& v) {
  const auto cross = [](const Point& a, const Point& b) {
    return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Point axis = {q[0], q[1], q[2]};
  const Point once = cross(axis, v), twice = cross(axis, once);
  Point result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = v[i] + 2 * (q[3] * once[i] + twice[i]);
  return result;
}

Quaternion inverse(const Quaternion& q) { return {-q[0], -q[1], -q[2], q[3]}; }

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The rotation vector nearest to the one before: axis times angle, with so many whole turns.
Point turn_of(const Quaternion& q, const Point& before) {
  const Point part = {q[0], q[1], q[2]};
  const Point& along = dot(part, part) > 0 ? part : before;  // no rotation: any axis
  const double length = std::sqrt(dot(along, along));
  if (length == 0) return {};
  Point turn{};
  for (std::size_t i = 0; i < 3; ++i) turn[i] = along[i] / length;
  const double angle = 2 * std::atan2(std::sqrt(dot(part, part)), q[3]), circle = 2 * std::numbers::pi;
  const double nearest = angle + circle * std::round((dot(turn, before) - angle) / circle);
  for (double& component : turn) component *= nearest;
  return turn;
}

/// The larger one of the extents along the axes.
double size_of(const std::vector<Point>& vertices) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        vertices.begin(), vertices.end(), [&](const Point& p, const Point& q) { return p[axis] < q[axis]; });
    if (low != vertices.end()) size = std::max(size, (*high)[axis] - (*low)[axis]);
  }
  return size;
}

Point mean_of(const std::vector<Point>& points) {
  Point mean{};
  for (const Point& p : points)
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += p[axis] / static_cast<double>(points.size());
  return mean;
}

double square(const Point& vector) { return dot(vector, vector); }

std::string text_of(std::size_t block, const char* what, const double* values, std::size_t count) {
  std::string text = "block " + std::to_string(block) + ": " + what + " is (";
  for (std::size_t i = 0; i < count; ++i) {
    char digits[32];
    text += (i > 0 ? ", " : "") + std::string(digits, std::to_chars(digits, digits + 32, values[i]).ptr);
  }
  return text + ')';
}

/// The page computes with floats, also squares of coordinates.
void require_place(std::size_t block, const char* what, const Point& point) {
  const double limit = std::sqrt(static_cast<double>(std::numeric_limits<float>::max()));
  for (const double coordinate : point)
    if (!(std::abs(coordinate) < limit))
      throw std::invalid_argument(text_of(block, what, point.data(), 3) + "; allowed: below " + json(limit));
}

void require_shape(std::size_t block, const BlockShape& shape) {
  for (const Point& vertex : shape.vertices) require_place(block, "a vertex", vertex);
  for (const std::vector<int>& face : shape.faces) {
    if (face.empty())
      throw std::invalid_argument("block " + std::to_string(block) + ": a face has no vertices");
    for (const int vertex : face)
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= shape.vertices.size())
        throw std::invalid_argument("block " + std::to_string(block) + ": a face has vertex " +
                                    std::to_string(vertex) +
                                    "; vertices: " + std::to_string(shape.vertices.size()));
  }
}

/// The quaternion of length 1 that is the same rotation.
Quaternion unit(std::size_t block, const Quaternion& q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 0 && std::isfinite(length)))
    throw std::invalid_argument(text_of(block, "the rotation", q.data(), 4) + "; allowed: a quaternion");
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

}  // namespace

Recording::Recording(int dimension, std::string title)
    : dimension_(dimension),
      title_(std::move(title)),
      of_blocks_("blocks", {}),
      of_nodes_("nodes", {}),
      of_contacts_("contacts", {}),
      of_bolts_("bolts", {}) {}

std::size_t Recording::add_block(BlockShape shape, const Pose& pose) {
  if (!frame_counts_.empty()) throw std::logic_error("a block that moves was added after a still block");
  require_shape(blocks_.size(), shape);
  require_place(blocks_.size(), "the position", pose.position);
  const Quaternion rotation = unit(blocks_.size(), pose.rotation);
  if (!has_origin_) origin_ = pose.position;
  has_origin_ = has_origin_ || !shape.vertices.empty();
  Block block;
  block.shape = std::move(shape);
  block.turn = turn_of(rotation, {});
  for (Point& vertex : block.shape.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) vertex[axis] -= pose.position[axis];
    vertex = rotated(inverse(rotation), vertex);
  }
  if (deforms(block.shape)) {
    block.first_node = static_cast<int>(node_count_);
    node_count_ += block.shape.vertices.size();
  }
  blocks_.push_back(std::move(block));
  return blocks_.size() - 1;
}

std::size_t Recording::add_still_block(BlockShape shape) {
  require_shape(blocks_.size(), shape);
  blocks_.push_back({.shape = std::move(shape)});
  frame_counts_.push_back(UINT32_MAX);
  return blocks_.size() - 1;
}

void Recording::remove_still_block(std::size_t block) {
  std::size_t& frame_count = frame_counts_[block - moving_count()];
  frame_count = std::min(frame_count, times_.size() - 1);
}

Point Recording::from_origin(const Point& point) const {
  return {point[0] - origin_[0], point[1] - origin_[1], point[2] - origin_[2]};
}

/// The steps of positions follow from the size of the smaller blocks that may move.
void Recording::make_tables() {
  std::vector<double> sizes;
  for (std::size_t b = 0; b < moving_count(); ++b) sizes.push_back(size_of(blocks_[b].shape.vertices));
  std::sort(sizes.begin(), sizes.end());
  const double size = sizes.empty() ? 0 : sizes[sizes.size() / 10];
  const double of_size = std::exp2(std::floor(std::log2((size > 0 ? size : 1) / positions_per_size)));
  const double step = std::max<double>(of_size, std::numeric_limits<float>::min());  // of the page's numbers
  // Near the first block, at a round number: 0 for a run that is at most some hundreds of blocks from it.
  const double spacing = steps_per_origin * step;
  for (double& coordinate : origin_) coordinate = spacing * std::round(coordinate / spacing);
  std::vector<Column> blocks = {{.name = "present", .coding = Coding::flag}};
  std::vector<Column> nodes, contacts = blocks, bolts = blocks;
  add_axes(blocks, "", "m", dimension_, Coding::lattice, step);
  if (dimension_ == 2)
    blocks.push_back({.name = "angle", .coding = Coding::lattice, .step = angle_step});
  else
    add_axes(blocks, "turn_", "", dimension_, Coding::lattice, turn_step);
  add_axes(nodes, "", "m", dimension_, Coding::lattice, step / 16);
  add_axes(contacts, "", "m", dimension_, Coding::lattice, 8 * step);
  for (const char* name : {"block_a", "block_b"})
    contacts.push_back({.name = name, .coding = Coding::lattice, .step = 1});
  contacts.push_back({.name = "force", .unit = "N", .coding = Coding::coarse});
  add_axes(contacts, "direction_", "", dimension_, Coding::lattice, direction_step);
  contacts.push_back({.name = "is_tension", .coding = Coding::flag});
  add_axes(bolts, "a", "m", dimension_, Coding::lattice, step);
  add_axes(bolts, "b", "m", dimension_, Coding::lattice, step);
  bolts.push_back({.name = "tension", .unit = "N"});
  bolts.push_back({.name = "is_ruptured", .coding = Coding::flag});
  of_blocks_ = Table("blocks", std::move(blocks));
  of_nodes_ = Table("nodes", std::move(nodes));
  of_contacts_ = Table("contacts", std::move(contacts));
  of_bolts_ = Table("bolts", std::move(bolts));
  frames_per_group_ =
      std::clamp<std::size_t>(values_per_group / (moving_count() + node_count_ + 1), 4, max_frames_per_group);
}

void Recording::add_frame(double time) {
  if (!std::isfinite(time)) throw std::invalid_argument("time is " + std::to_string(time));
  if (times_.empty()) make_tables();
  if (frames_in_group_ == frames_per_group_) pack_group();
  times_.push_back(time);
  ++frames_in_group_;
  for (Table* table : {&of_blocks_, &of_nodes_, &of_contacts_, &of_bolts_}) table->begin_frame();
}

void Recording::set_rigid(std::size_t block, const Pose& pose) {
  require_place(block, "the position", pose.position);
  const Quaternion rotation = unit(block, pose.rotation);
  of_blocks_.set(present, block, 1);
  std::size_t column = first_coordinate;
  const Point position = from_origin(pose.position);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
    of_blocks_.set(column++, block, position[axis]);
  Point& turn = blocks_[block].turn;
  turn = turn_of(rotation, turn);
  for (std::size_t axis = dimension_ == 2 ? 2 : 0; axis < 3; ++axis)
    of_blocks_.set(column++, block, turn[axis]);
}

void Recording::set_deformed(std::size_t block, const std::vector<Point>& vertices) {
  for (const Point& vertex : vertices) require_place(block, "a vertex", vertex);
  set_rigid(block, {.position = mean_of(vertices)});
  const auto first = static_cast<std::size_t>(blocks_[block].first_node);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
      of_nodes_.set(axis, first + i, vertices[i][axis] - origin_[axis]);
}

void Recording::set_vertices(std::size_t block, const std::vector<Point>& vertices,
                             const Quaternion& rotation) {
  if (is_still(block)) throw std::runtime_error("block " + std::to_string(block) + " of a terrain moves");
  const std::vector<Point>& at_start = blocks_[block].shape.vertices;
  if (vertices.size() != at_start.size())
    throw std::runtime_error("block " + std::to_string(block) + " has " + std::to_string(vertices.size()) +
                             " vertices in a frame, and " + std::to_string(at_start.size()) +
                             " in the first one");
  if (blocks_[block].first_node >= 0) return set_deformed(block, vertices);
  const Point now = mean_of(vertices), from_centroid = rotated(unit(block, rotation), mean_of(at_start));
  set_rigid(block,
            {{now[0] - from_centroid[0], now[1] - from_centroid[1], now[2] - from_centroid[2]}, rotation});
}

void Recording::set_value(const std::string& field, const std::string& unit, std::size_t block,
                          double value) {
  of_blocks_.set(of_blocks_.column(field, unit), block, value, !is_fixed(blocks_[block].shape));
}

void Recording::set_contacts(std::vector<ContactForce> contacts) {
  if (contacts.size() > max_contacts) {
    left_out_contacts_ = std::max(left_out_contacts_, contacts.size() - max_contacts);
    std::nth_element(
        contacts.begin(), contacts.begin() + max_contacts, contacts.end(),
        [](const ContactForce& a, const ContactForce& b) { return square(a.force) > square(b.force); });
    contacts.resize(max_contacts);
  }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> count_of_pair;
  for (const ContactForce& contact : contacts) {
    const std::size_t ordinal = count_of_pair[{contact.block_a, contact.block_b}]++;
    const auto [found, is_new] =
        contact_items_.try_emplace({contact.block_a, contact.block_b, ordinal}, contact_items_.size());
    const std::size_t item = found->second;
    std::size_t column = present;
    const auto set = [&](double value) { of_contacts_.set(column++, item, value); };
    const auto axis_count = static_cast<std::size_t>(dimension_);
    const double force = std::sqrt(square(contact.force));
    set(1);
    for (std::size_t axis = 0; axis < axis_count; ++axis) set(contact.point[axis] - origin_[axis]);
    set(static_cast<double>(contact.block_a));
    set(static_cast<double>(contact.block_b));
    set(force);
    for (std::size_t axis = 0; axis < axis_count; ++axis) set(force > 0 ? contact.force[axis] / force : 0);
    set(contact.normal_force < 0 ? 1 : 0);
  }
}

void Recording::set_bolt(const BoltForce& bolt) {
  const std::size_t item = bolt_items_.try_emplace(bolt.number, bolt_items_.size()).first->second;
  std::size_t column = present;
  const auto set = [&](double value) { of_bolts_.set(column++, item, value); };
  set(1);
  for (const Point& place : {from_origin(bolt.place_a), from_origin(bolt.place_b)})
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) set(place[axis]);
  set(bolt.tension);
  set(bolt.is_ruptured ? 1 : 0);
}

void Recording::set_water(std::vector<Point> points, std::vector<std::vector<std::size_t>> faces) {
  for (Point& point : points) point = from_origin(point);
  if (water_.empty() ? points.empty() : water_.back().points == points) return;
  water_.push_back({times_.size() - 1, std::move(points), std::move(faces)});
}

void Recording::add_crack(Crack crack) {
  crack.position = from_origin(crack.position);
  cracks_.push_back(crack);
}

void Recording::pack_group() {
  std::string bytes(1, static_cast<char>(frames_in_group_));
  for (Table* table : {&of_blocks_, &of_nodes_, &of_contacts_, &of_bolts_}) {
    bytes += table->pack();
    table->clear(table != &of_contacts_);
  }
  contact_items_.clear();
  groups_.push_back(base85(deflated(bytes)));
  frames_in_group_ = 0;
}

}  // namespace halfspace::viewer
