#include "output/tables.h"

#include "common/text.h"

namespace halfspace::cli {
namespace {

void add_vector(std::string& row, const double* values, int count) {
  for (int i = 0; i < count; ++i) row += ',' + shortest(values[i]);
}

/// The names of a vector's components as columns.
std::string columns(const std::string& name, int dimension) {
  std::string text = ',' + name + "x," + name + 'y';
  if (dimension == 3) text += ',' + name + 'z';
  return text;
}

}  // namespace

std::string blocks_table(const Scene& scene, const Layout& layout) {
  constexpr const char* kinds[] = {"fixed", "prescribed", "rigid", "affine", "mesh"};
  std::string text = "number,name,kind,material_number,material\n";
  for (std::size_t i = 0; i < layout.blocks.size(); ++i) {
    const LayoutBlock& block = layout.blocks[i];
    text += std::to_string(i) + ',' + csv_value(block.name) + ',' + kinds[block.kind] + ',' +
            std::to_string(block.material) + ',' +
            csv_value(scene.materials[static_cast<std::size_t>(block.material)].name) + '\n';
  }
  return text;
}

std::string contacts_table(const Layout& layout, const Frame& frame) {
  const int dimension = layout.dimension;
  std::string text = "block_a,block_b,gap,area" + columns("", dimension) + columns("normal_", dimension) +
                     ",normal_force" + columns("force_", dimension) + '\n';
  for (const hs_contact& contact : frame.contacts) {
    text += csv_value(layout.blocks[contact.block_a].name) + ',' +
            csv_value(layout.blocks[contact.block_b].name) + ',' + shortest(contact.gap) + ',' +
            shortest(contact.area);
    add_vector(text, contact.force_point, dimension);
    add_vector(text, contact.normal, dimension);
    text += ',' + shortest(contact.normal_force);
    add_vector(text, contact.force, dimension);
    text += '\n';
  }
  return text;
}

std::string cracks_table(const Model& model) {
  const Layout& layout = model.layout();
  std::string text = "time,steps,block_a,block_b,point,failure" + columns("", layout.dimension) +
                     columns("normal_", layout.dimension) + ",area,normal_traction,shear_traction,energy\n";
  for (const hs_bond_event& event : model.bond_events()) {
    const auto& [block_a, block_b] = model.blocks_of_bond(static_cast<std::size_t>(event.bond));
    text += shortest(event.time) + ',' + std::to_string(event.step) + ',' +
            csv_value(layout.blocks[block_a].name) + ',' + csv_value(layout.blocks[block_b].name) + ',' +
            std::to_string(event.point) + ',' + (event.failure == HS_BOND_TENSION ? "tension" : "shear");
    add_vector(text, event.position, layout.dimension);
    add_vector(text, event.normal, layout.dimension);
    for (const double value : {event.area, event.normal_traction, event.shear_traction, event.energy})
      text += ',' + shortest(value);
    text += '\n';
  }
  return text;
}

}  // namespace halfspace::cli
