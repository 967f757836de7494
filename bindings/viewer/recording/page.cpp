#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>

#include "recording/encoding.h"
#include "recording/recording.h"

namespace halfspace::viewer {
namespace {

constexpr const char* place_of_recording = "<!-- recording -->";

void append(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
}

/// The values of all items, by a function of an item, as a JSON array.
template <class Items, class Text>
std::string array(const Items& items, Text text) {
  std::string values;
  for (const auto& item : items) values += (values.empty() ? "" : ",") + text(item);
  return '[' + values + ']';
}

std::string coordinates(const Point& point) {
  return array(point, [](double value) { return json(value); });
}

std::string element(const std::string& id, const std::string& text) {
  return "<script type=\"text/plain\" id=\"" + id + "\">" + text + "</script>\n";
}

/// A text for the content of an element of HTML.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '<' ? std::string("&lt;") : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

}  // namespace

std::string Recording::header() const {
  const auto quoted = [](const std::string& text) { return json(text); };
  std::string text = "{\"dimension\":" + std::to_string(dimension_) + ",\"title\":" + quoted(title_) +
                     ",\"frames_per_group\":" + std::to_string(frames_per_group_) +
                     ",\"left_out_contacts\":" + std::to_string(left_out_contacts_) +
                     ",\"times\":" + array(times_, [](double time) { return json(time); });
  text += ",\"origin\":" + coordinates(origin_);
  text += ",\"names\":" + array(blocks_, [&](const Block& block) { return quoted(block.shape.name); });
  text += ",\"materials\":" + array(materials_, quoted) + ",\"tables\":[";
  for (const Table* table : {&of_blocks_, &of_nodes_, &of_contacts_, &of_bolts_})
    text += (table == &of_blocks_ ? "" : ",") + table->description();
  const auto number = [](std::size_t value) { return std::to_string(value); };
  text += "],\"water\":" + array(water_, [&](const Water& water) {
            return "{\"frame\":" + std::to_string(water.frame) +
                   ",\"points\":" + array(water.points, coordinates) +
                   ",\"faces\":" + array(water.faces, [&](const auto& face) { return array(face, number); }) +
                   '}';
          });
  text += ",\"cracks\":" + array(cracks_, [&](const Crack& crack) {
            return "{\"time\":" + json(crack.time) + ",\"blocks\":" + array(crack.blocks, number) +
                   ",\"position\":" + coordinates(crack.position) +
                   ",\"normal\":" + coordinates(crack.normal) + ",\"area\":" + json(crack.area) +
                   ",\"is_shear\":" + (crack.is_shear ? "true" : "false") + '}';
          });
  return text + ",\"history\":" + quoted(history_) + '}';
}

/// Whole numbers of 32 bits, then the vertices as floats: for each block its kind, material, first node plus
/// 1, number of vertices and of faces; the sizes of all faces; their vertices. At the end are the number of
/// still blocks, and for each of them the number of frames until its removal.
std::string Recording::geometry() const {
  std::string bytes;
  append(bytes, static_cast<std::uint32_t>(blocks_.size()));
  for (const Block& block : blocks_) append(bytes, static_cast<std::uint32_t>(block.shape.kind));
  for (const Block& block : blocks_) append(bytes, static_cast<std::uint32_t>(block.shape.material));
  for (const Block& block : blocks_) append(bytes, static_cast<std::uint32_t>(block.first_node + 1));
  for (const Block& block : blocks_) append(bytes, static_cast<std::uint32_t>(block.shape.vertices.size()));
  for (const Block& block : blocks_) append(bytes, static_cast<std::uint32_t>(block.shape.faces.size()));
  for (const Block& block : blocks_)
    for (const auto& face : block.shape.faces) append(bytes, static_cast<std::uint32_t>(face.size()));
  for (const Block& block : blocks_)
    for (const auto& face : block.shape.faces)
      for (const int vertex : face) append(bytes, static_cast<std::uint32_t>(vertex));
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (const Point& vertex : blocks_[b].shape.vertices)
      for (const double coordinate : is_still(b) ? from_origin(vertex) : vertex)
        append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)));
  append(bytes, static_cast<std::uint32_t>(frame_counts_.size()));
  for (const std::size_t count : frame_counts_) append(bytes, static_cast<std::uint32_t>(count));
  return bytes;
}

std::string Recording::page(const std::string& viewer) {
  if (times_.empty()) throw std::runtime_error("the recording has no frames");
  const std::size_t place = viewer.find(place_of_recording);
  if (place == std::string::npos) throw std::runtime_error("the viewer's page has no place for a recording");
  if (frames_in_group_ > 0) pack_group();
  std::string page = viewer.substr(0, place) + "<title>" + escaped(title_) + "</title>\n";
  page += element("header", base85(deflated(header())));
  page += element("geometry", base85(deflated(geometry())));
  for (std::size_t g = 0; g < groups_.size(); ++g) page += element("group-" + std::to_string(g), groups_[g]);
  return page + viewer.substr(place + std::string(place_of_recording).size());
}

}  // namespace halfspace::viewer
