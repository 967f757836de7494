#include "output/paraview.h"

namespace halfspace::cli {
namespace {

/// A text as a string of Python.
std::string python(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + '"';
}

constexpr const char* begin_of_script =
    R"(# Shows the run in ParaView: paraview --script=show_in_paraview.py, or File > Load State.
import os

from paraview.simple import *

try:
    folder = os.path.dirname(os.path.abspath(__file__))
except NameError:  # by File > Load State or --script
    folder = os.getcwd()


def series(name):
    return PVDReader(registrationName=name, FileName=os.path.join(folder, name))


view = GetActiveViewOrCreate("RenderView")
blocks = series("run.pvd")
animation = GetAnimationScene()
animation.UpdateAnimationUsingDataTimeSteps()
shown = Show(blocks, view)
shown.Representation = "Surface With Edges"
ColorBy(shown, ("CELLS", "displacement", "Magnitude"))
shown.RescaleTransferFunctionToDataRangeOverTime()
shown.SetScalarBarVisibility(view, True)
)";

constexpr const char* contacts_in_script = R"(
# A line along each contact force, as long as the force; the largest one at the end is a tenth of the picture.
contacts = CellCenters(Input=series("contacts.pvd"))
contacts.UpdatePipeline(animation.EndTime)
force = contacts.PointData["force"]
largest = force.GetRange(-1)[1] if force and force.GetRange(-1)[1] > 0 else 1
forces = Glyph(registrationName="contact forces", Input=contacts, GlyphType="Line")
forces.OrientationArray = ["POINTS", "force"]
forces.ScaleArray = ["POINTS", "force"]
forces.GlyphMode = "All Points"
extent = blocks.GetDataInformation().GetBounds()
forces.ScaleFactor = 0.1 * max(extent[1] - extent[0], extent[3] - extent[2]) / largest
shown = Show(forces, view)
ColorBy(shown, ("POINTS", "force", "Magnitude"))
shown.LineWidth = 2
)";

constexpr const char* forces_inside_solids_in_script = R"(
# The forces are seen through the blocks.
GetDisplayProperties(blocks, view).Opacity = 0.4
)";

constexpr const char* bolts_in_script = R"(
shown = Show(series("bolts.pvd"), view)
ColorBy(shown, ("CELLS", "tension"))
shown.LineWidth = 4
)";

constexpr const char* water_in_script = R"(
shown = Show(series("water.pvd"), view)
shown.ColorArrayName = ["POINTS", ""]
shown.DiffuseColor = shown.AmbientColor = [0.2, 0.5, 0.95]
shown.Opacity = 0.5
shown.LineWidth = 2
)";

constexpr const char* view_in_space = R"(
# From the front and above, with z up.
view.CameraViewUp = [0, 0, 1]
view.CameraFocalPoint = [0, 0, 0]
view.CameraPosition = [-0.5, -0.8, 0.35]
view.ResetCamera()
)";

constexpr const char* terrain_in_script = R"(
shown = Show(series("terrain.pvd"), view)
shown.ColorArrayName = ["POINTS", ""]
shown.DiffuseColor = shown.AmbientColor = [0.6, 0.55, 0.5]
)";

}  // namespace

std::string paraview_script(const Scene& scene) {
  std::string script = begin_of_script;
  if (scene.output.contacts) script += contacts_in_script;
  if (scene.output.contacts && scene.world.dimension == 3) script += forces_inside_solids_in_script;
  if (!scene.bolts.empty()) script += bolts_in_script;
  if (has_water(scene)) script += water_in_script;
  if (!scene.terrains.empty()) script += terrain_in_script;
  script += "\ntitle = Text(Text=" + python(scene.title) + ")\nShow(title, view)\n";
  script +=
      scene.world.dimension == 2 ? "view.InteractionMode = \"2D\"\nview.ResetCamera()\n" : view_in_space;
  return script + "Render()\n";
}

}  // namespace halfspace::cli
