#include "blocks/mesh/number_table.h"

#include <cmath>

#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/surface.h"
#include "blocks/terrain/height_map.h"
#include "catch.h"

using namespace halfspace::cli;

namespace {

std::vector<std::vector<double>> rows_of(const std::string& text) {
  return read_number_table("t.csv", text, "numbers").rows;
}

std::string fault_of(const std::string& text) {
  try {
    read_heights("t.csv", text);
  } catch (const MeshFault& fault) {
    return fault.what();
  }
  return "none";
}

/// x, y and x + 10 y of the nodes of a grid, without one of them.
std::string list_of_nodes(int columns, int rows, int left_out) {
  std::string text;
  for (int i = 0; i < columns * rows; ++i) {
    const int x = i % columns, y = i / columns;
    if (i != left_out)
      text += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(x + 10 * y) + '\n';
  }
  return text;
}

}  // namespace

TEST_CASE("numbers are read as spreadsheets and other programs write them") {
  const std::vector<std::vector<double>> expected{{0, -1.5}, {0.1, 250}};
  for (const char* text : {
           "0,-1.5\n0.1,250\n",                       // commas
           "0;-1,5\n0,1;250\n",                       // decimal commas
           "0\t-1,5\n0,1\t250\n",                     // the same between tabs
           "0 -1,5\n0,1 250\n",                       // and between blanks
           "0, -1.5\n0.1, 250\n",                     // commas and blanks
           "0 , -1.5,\n0.1 , 250,\n",                 // and at the end
           "\"time\",\"value, m\"\n0,-1.5\n0.1,250",  // a header in quotes
           "t;v\n[s];[m]\n0;-1,5\n0,1;250",           // two lines of header
           "\"0\";\"-1,5\"\n\"0,1\";\"250\"\n",       // numbers in quotes
           "# t v\n0 -1.5 # start\n\n0.1 250\n",      // comments
           "% t v\n0 -1.5\n.1 +250\n",                // of another program
           "\xef\xbb\xbf"
           "0,-1.5\n0.1,250\n",  // a byte order mark
           "\xef\xbb\xbftime,v\r\n0,-1.5\r\n0.1,250\r\n",
           "0,-1.5\r0.1,250\r",                  // lines of old systems
           "0.0D+00 -1.5d0\n1.0D-01 2.5D+02\n",  // exponents of Fortran
       }) {
    CAPTURE(text);
    CHECK(rows_of(text) == expected);
  }
}

TEST_CASE("a table with a fault is refused at its line") {
  const std::pair<std::string, std::string> cases[] = {
      {"0 1\nend\n", "t.csv:2: not a finite number: \"end\""},
      {"nan 1\n0 1\n", "t.csv:1: not a finite number: \"nan\""},
      {"0;1.234,5\n", "t.csv:1: not a finite number: \"1.234.5\""},
      {"\"0,5\",\"1,5\"\n",
       "t.csv:1: not a finite number: \"0,5\""},  // commas between numbers and within them
      {"0,,1\n", "t.csv:1: not a finite number: \"\""},
      {"0,1\n2,\n", "t.csv:2: a row of 1 heights; the first row has 2"},
      {"\xff\xfe"
       "0\n",
       "t.csv: text in UTF-16"},
      {"1 2\n-9999 2\n", "t.csv:2: the height -9999, which usually means no data"},
      {"x y z\n0 0 1\n1 0.3 1\n2 0.7 4\n", "t.csv: a list of x, y and height whose points are no grid"},
      {"x y z\n0 0 1\n1 0 1\n0 1 4\n0 0 4\n", "t.csv:5: a second height at [0, 0]"},
      {"id,x,y,z\n1,0,0,1\n", "t.csv: columns id, x, y, z; allowed: x, y and height"},
      {"ncols 2\nnrows 2\ncellsize 1\n1 2 3\n", "t.csv: 3 heights; allowed: ncols times nrows, 2 times 2"},
      {"ncols 2\nnrows 2\n1 2 3 4\n", "t.csv: cellsize is missing or not above 0"},
      {"ncols 2\nnrws 2\n1 2 3 4\n", "t.csv:2: unknown: \"nrws\"; allowed: ncols, nrows"},
  };
  for (const auto& [text, fault] : cases) {
    CAPTURE(text);
    const std::string found = fault_of(text);
    CHECK(found.substr(0, fault.size()) == fault);
  }
}

TEST_CASE("a list of x, y and height is the grid of its nodes, in any order") {
  for (const char* header : {"", "x,y,z\n", "Easting;Northing;Height\n"}) {
    const HeightMap map = read_heights("t.csv", header + list_of_nodes(4, 3, -1));
    CHECK(map.columns == 4);
    CHECK(map.rows == 3);
    CHECK(map.spacing == 1);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        const Point node = map.node(column, row, 1);
        CHECK(node[2] == node[0] + 10 * node[1]);
        CHECK(node[1] == 2.0 - static_cast<double>(row));  // from the north
      }
    }
  }
  const HeightMap gap = read_heights("t.csv", list_of_nodes(4, 3, 5));
  CHECK(std::isnan(gap.height(1, 1)));
  // Rows of three heights on a slope are rows.
  const HeightMap slope = read_heights("t.csv", "0 1 2\n1 2 3\n2 3 4\n3 4 5\n");
  CHECK(slope.columns == 3);
  CHECK(slope.rows == 4);
}

TEST_CASE("an ASCII grid has a place, a spacing, and nodes without data") {
  for (const char* text :
       {"ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 2\nNODATA_value -1\n1 2 -1\n4 5.5 6\n",
        "\xef\xbb\xbfNCOLS 3\r\nNROWS 2\r\nXLLCENTER 101\r\nYLLCENTER 201\r\nCELLSIZE 2,0\r\n"
        "1 2 -9999 4\r\n5,5 6\r\n"}) {
    const HeightMap map = read_heights("t.asc", text);
    CHECK(map.spacing == 2);
    CHECK(map.node(0, 1, 2) == Point{101, 201, 4});
    CHECK(map.node(1, 1, 2) == Point{103, 201, 5.5});
    CHECK(map.node(1, 0, 2) == Point{103, 203, 2});
    CHECK(std::isnan(map.height(2, 0)));
  }
}

TEST_CASE("text STL files may be in capitals, with a byte order mark") {
  const std::string text =
      "\xef\xbb\xbfSOLID part\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1.0D0 0 0\n"
      "VERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID part\n";
  const Surface surface = read_stl("t.stl", text);
  CHECK(surface.faces.size() == 1);
  CHECK(surface.vertices[1] == Point{1, 0, 0});
}
