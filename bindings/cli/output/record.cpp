#include "output/record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/text.h"
#include "output/joints.h"
#include "output/paraview.h"
#include "output/picture/picture.h"
#include "output/tables.h"

namespace halfspace::cli {
namespace {

void add_frame_to(Archive& archive, Frame& frame) {
  archive.add(frame.time);
  archive.add(frame.contacts);
  archive.add(frame.bolts);
  archive.add(frame.water);
  archive.add_each(frame.blocks, [&](BlockFrame& block) {
    archive.add(block.state);
    archive.add(block.deformation);
    archive.add(block.vertices);
  });
}

/// True if a frame has all blocks, each with all of its vertices, or none if it is excavated.
bool is_whole(const Frame& frame, const Frame& start) {
  const auto has_vertices_of = [](const BlockFrame& block, const BlockFrame& at_start) {
    return block.vertices.empty() || block.vertices.size() == at_start.vertices.size();
  };
  const std::size_t blocks = start.blocks.size();
  return frame.blocks.size() == blocks &&
         std::equal(frame.blocks.begin(), frame.blocks.end(), start.blocks.begin(), has_vertices_of) &&
         std::all_of(frame.contacts.begin(), frame.contacts.end(), [&](const hs_contact& contact) {
           return contact.block_a < blocks && contact.block_b < blocks;
         });
}

}  // namespace

bool Every::due(const Model& model) {
  if (!model.reached(next())) return false;
  const double passed = (model.report().time + model.report().time_step / 2) / interval_;
  count_ = std::min(std::max(count_ + 1, std::ceil(passed)), std::numeric_limits<double>::max());
  return true;
}

void Every::add_to(Archive& archive, const Model& model) {
  double interval = interval_, count = count_;
  archive.add(interval);
  archive.add(count);
  archive.require(count >= 0 && std::isfinite(count), "invalid number of outputs");
  count_ = count;
  if (interval != interval_)
    count_ = std::floor((model.report().time + model.report().time_step / 2) / interval_) + 1;
}

Record::Record(const Scene& scene, const Model& model, OutputDirectory& directory,
               std::function<void(const Model&)> on_row)
    : scene_(scene),
      model_(model),
      directory_(directory),
      series_(model.layout(), scene, directory),
      history_(scene, model),
      bolts_(scene.world.dimension),
      origins_{model.frame()},
      stage_(scene, origins_.front()),
      frames_(scene.output.frame_interval),
      rows_(scene.output.history_interval),
      on_row_(std::move(on_row)) {}

void Record::begin() {
  peaks_.add(model_.report());
  add_frame();
  add_row();
  save_tables();
}

double Record::next() const { return std::min({frames_.next(), rows_.next(), next_picture()}); }

bool Record::add_due() {
  const bool row_due = rows_.due(model_);
  const bool frame_due = frames_.due(model_);
  if (row_due || frame_due || model_.report().steps % Peaks::steps_between == 0) peaks_.add(model_.report());
  if (row_due) add_row();
  if (frame_due) add_frame();
  while (model_.reached(next_picture())) add_picture();
  return row_due;
}

void Record::end_stage(std::size_t number, bool settles) {
  if (settles && !has_frame_of_now()) add_frame();
  if (settles && last_row_step_ != model_.report().steps) add_row();
  if (!scene_.output.has_stage_pictures) return;
  std::erase_if(of_stages_, [&](const StagePicture& picture) { return picture.stage == number; });
  of_stages_.push_back({number, model_.frame(), origins_.size() - 1});
  stage_.add(of_stages_.back().frame);
}

std::vector<double> Record::times_left() const {
  const std::vector<double>& times = scene_.output.picture_times;
  return {times.begin() + static_cast<std::ptrdiff_t>(pictured_.size()), times.end()};
}

Frame Record::finish() {
  peaks_.add(model_.report());
  if (!has_frame_of_now()) add_frame();
  if (last_row_step_ != model_.report().steps) add_row();
  save_tables();
  const Frame end = model_.frame();
  if (scene_.output.contacts) directory_.write("contacts.csv", contacts_table(model_.layout(), end));
  if (scene_.output.joints)
    directory_.write("joints.csv", joints_table(model_.layout(), start(), end, model_.contacts()));
  stage_.add(end);
  const Stage stage = stage_.stage();
  directory_.write("first.svg", picture(stage, scene_, model_.layout(), start(), start()));
  for (std::size_t i = 0; i < pictured_.size(); ++i) {
    directory_.write(
        "at_" + shortest(scene_.output.picture_times[i]) + "s.svg",
        picture(stage, scene_, model_.layout(), shown_from(origin_of_pictured_[i]), pictured_[i]));
  }
  for (const StagePicture& ended : of_stages_) {
    directory_.write("stage_" + std::to_string(ended.stage) + ".svg",
                     picture(stage, scene_, model_.layout(), shown_from(ended.origin), ended.frame));
  }
  directory_.write("last.svg", picture(stage, scene_, model_.layout(), shown_from(origins_.size() - 1), end));
  return end;
}

void Record::add_to(Archive& archive, bool has_frames) {
  const std::vector<double>& requested = scene_.output.picture_times;
  std::vector<double> times(requested.begin(),
                            requested.begin() + static_cast<std::ptrdiff_t>(pictured_.size()));
  series_.add_to(archive, has_frames);
  history_.add_to(archive);
  bolts_.add_to(archive);
  const auto add_frame = [&](Frame& frame) {
    add_frame_to(archive, frame);
    archive.require(is_whole(frame, start()), "its frames have other blocks");
  };
  std::vector<Frame> origins(origins_.begin(), origins_.end());
  archive.add_each(origins, add_frame);
  for (std::size_t i = origins_.size(); i < origins.size(); ++i) {
    origins_.push_back(std::move(origins[i]));
    stage_.reset_displacement(origins_.back());
  }
  const bool has_same_view = stage_.add_to(archive);
  archive.add(peaks_);
  archive.add(times);
  archive.add_each(pictured_, add_frame);
  archive.add(origin_of_pictured_);
  const auto is_origin = [&](std::size_t origin) { return origin < origins_.size(); };
  archive.require(pictured_.size() == times.size() && origin_of_pictured_.size() == times.size() &&
                      std::all_of(origin_of_pictured_.begin(), origin_of_pictured_.end(), is_origin),
                  "its pictures are inconsistent");
  archive.add_each(of_stages_, [&](StagePicture& ended) {
    archive.add(ended.stage);
    add_frame(ended.frame);
    archive.add(ended.origin);
  });
  archive.require(std::all_of(of_stages_.begin(), of_stages_.end(),
                              [&](const StagePicture& ended) { return is_origin(ended.origin); }),
                  "its pictures are inconsistent");
  if (!has_same_view) {
    stage_.add(origins_.front());
    for (const Frame& frame : pictured_) stage_.add(frame);
    for (const StagePicture& ended : of_stages_) stage_.add(ended.frame);
  }
  frames_.add_to(archive, model_);
  rows_.add_to(archive, model_);
  archive.add(last_row_step_);
  archive.add(last_frame_step_);
  if (archive.reads() &&
      (requested.size() < times.size() || !std::equal(times.begin(), times.end(), requested.begin()) ||
       model_.reached(next_picture())))
    throw std::runtime_error("output.picture.times before the checkpoint differ");
}

void Record::reset_displacement() {
  origins_.push_back(model_.frame());
  stage_.reset_displacement(origins_.back());
}

const Frame& Record::shown_from(std::size_t origin) const {
  return scene_.output.colour == Colour::layer ? origins_.front() : origins_[origin];
}

double Record::next_picture() const {
  const std::vector<double>& times = scene_.output.picture_times;
  return pictured_.size() < times.size() ? times[pictured_.size()] : std::numeric_limits<double>::infinity();
}

void Record::add_row() {
  history_.add(model_, history_stage_, origins_.back());
  bolts_.add(model_);
  last_row_step_ = model_.report().steps;
  if (on_row_) on_row_(model_);
}

void Record::add_picture() {
  pictured_.push_back(model_.frame());
  origin_of_pictured_.push_back(origins_.size() - 1);
  stage_.add(pictured_.back());
}

void Record::save_tables() {
  directory_.write("history.csv", history_.text());
  if (!scene_.bolts.empty()) directory_.write("bolts.csv", bolts_.text());
  if (!scene_.bonds.empty()) directory_.write("cracks.csv", cracks_table(model_));
}

void Record::save_descriptions() {
  directory_.write("blocks.csv", blocks_table(scene_, model_.layout()));
  directory_.write("show_in_paraview.py", paraview_script(scene_));
  has_descriptions_ = true;
}

void Record::add_frame() {
  if (!has_descriptions_) save_descriptions();
  const Frame frame = model_.frame();
  series_.add(frame, origins_.back());
  stage_.add(frame);
  last_frame_step_ = model_.report().steps;
  save_tables();
}

}  // namespace halfspace::cli
