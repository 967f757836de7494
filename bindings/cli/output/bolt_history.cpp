#include "output/bolt_history.h"

#include "common/text.h"

namespace halfspace::cli {

BoltHistory::BoltHistory(int dimension) : dimension_(dimension) {
  text_ = "time,steps,bolt,tension,elongation,plastic_elongation,strain_energy,loss,is_ruptured";
  text_ += dimension == 3 ? ",from_x,from_y,from_z,to_x,to_y,to_z\n" : ",from_x,from_y,to_x,to_y\n";
}

void BoltHistory::add(const Model& model) {
  for (const hs_bolt& bolt : model.bolts()) {
    text_ += shortest(model.report().time) + ',' + std::to_string(model.report().steps) + ',' +
             model.bolt(bolt.number).name;
    for (const double value :
         {bolt.tension, bolt.elongation, bolt.plastic_elongation, bolt.strain_energy, bolt.loss})
      text_ += ',' + shortest(value);
    text_ += bolt.is_ruptured != 0 ? ",1" : ",0";
    for (const double* place : {bolt.place_a, bolt.place_b})
      for (int axis = 0; axis < dimension_; ++axis) text_ += ',' + shortest(place[axis]);
    text_ += '\n';
  }
}

}  // namespace halfspace::cli
