#include "tables.h"

#include <stdexcept>

namespace box2d_comparison {

Table::Table(const std::filesystem::path& path, const std::string& header) : file_(path) {
  // A disk that is full is to be heard of.
  file_.exceptions(std::ios::failbit | std::ios::badbit);
  file_.precision(9);
  file_ << header << '\n';
}

Table& Table::add(const std::string& text) {
  if (row_begun_) file_ << ',';
  row_begun_ = true;
  if (text.find_first_of(",\"\n") == std::string::npos) {
    file_ << text;
    return *this;
  }
  file_ << '"';
  for (const char c : text) file_ << (c == '"' ? "\"\"" : std::string(1, c));
  file_ << '"';
  return *this;
}

Table& Table::add(double number) {
  if (row_begun_) file_ << ',';
  row_begun_ = true;
  file_ << number;
  return *this;
}

void Table::end_row() {
  file_ << '\n';
  row_begun_ = false;
}

Tables::Tables(const std::filesystem::path& folder)
    : scenes_(folder / "scenes.csv", "scene,title,stands_for,stands,on_slopes,stiffness,why_no_forces"),
      steps_(folder / "steps.csv",
             "scene,world,time,kinetic,potential,drift,median_drift,largest_speed,jitter,contact_points,"
             "seconds"),
      summary_(
          folder / "summary.csv",
          "scene,world,judged,wrong_verdicts,worst_wrong_verdict,touching,worst_depth_error,mean_depth_error,"
          "worst_normal_error,quiet_pairs,flicker,ns_per_pair,rest_time,drift,median_drift,creep,energy_"
          "gained,"
          "jitter,sub_steps,frames_per_second") {}

void Tables::add(const Scene& scene, std::optional<double> stiffness) {
  scenes_.add(scene.name).add(scene.title).add(scene.stands_for).add(std::int64_t(scene.stands));
  scenes_.add(std::int64_t(scene.on_slopes)).add(stiffness).add(scene.forces.why_not).end_row();
}

void Tables::add(const Scene& scene, const std::string& world, const std::vector<MotionRow>& rows) {
  for (const MotionRow& row : rows) {
    steps_.add(scene.name)
        .add(world)
        .add(row.time)
        .add(row.kinetic)
        .add(row.potential)
        .add(row.drift)
        .add(row.median_drift);
    steps_.add(row.largest_speed).add(row.jitter).add(std::int64_t(row.contact_points)).add(row.seconds);
    steps_.end_row();
  }
}

void Tables::add(const Scene& scene, const std::string& world, int sub_steps, const MotionSummary& motion,
                 const PairQuality* quality, std::int64_t quiet_pairs) {
  summary_.add(scene.name).add(world);
  if (quality) {
    const std::optional<double> none, touching = quality->touching ? std::optional(1.) : none;
    const auto where_touching = [&](double error) { return touching ? std::optional(error) : none; };
    summary_.add(quality->judged).add(quality->wrong_verdicts);
    summary_.add(quality->worst_wrong_verdict).add(quality->touching);
    summary_.add(where_touching(quality->worst_depth_error)).add(where_touching(quality->mean_depth_error()));
    summary_.add(where_touching(quality->worst_normal_error));
    summary_.add(quiet_pairs).add(quality->flicker()).add(quality->ns_per_pair());
  } else {
    constexpr int columns_of_pairs = 10;
    for (int i = 0; i < columns_of_pairs; ++i) summary_.add(std::string());
  }
  summary_.add(motion.rest_time)
      .add(motion.drift)
      .add(motion.median_drift)
      .add(motion.creep)
      .add(motion.energy_gained);
  summary_.add(motion.jitter).add(std::int64_t(sub_steps)).add(motion.frames_per_second).end_row();
}

}  // namespace box2d_comparison
