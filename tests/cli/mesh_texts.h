#pragma once

/// Files of blocks as text, for the tests of their readers.
namespace mesh_texts {

/// A box of 2 x 1 x 1.
inline constexpr const char* obj_box = R"(# box
mtllib box.mtl
o box
v 0 0 0
v 2 0 0
v 2 1 0
v 0 1 0
v 0 0 1
v 2 0 1
v +2.0e0 1 1 1.0
v 0 1 1
vn 0 0 1
usemtl stone
f 1 4 3 2
f 5//1 6//1 7//1 8//1
f 1/1 2/1 6/1 5/1
f -7 -6 -2 -3
f 3 4 8 7
f 4 1 5 8
)";

/// A hexahedron, a prism, a pyramid and a tetrahedron, and a triangle of the boundary.
inline constexpr const char* gmsh_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 1 "rock"
$EndPhysicalNames
$Nodes
11
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
9 2 0 0
10 2 0 1
20 0.5 0.5 2
$EndNodes
$Elements
5
1 5 2 1 1 1 2 3 4 5 6 7 8
2 2 2 1 1 1 2 3
3 6 2 1 1 2 9 3 6 10 7
4 7 2 1 1 5 6 7 8 20
5 4 2 1 1 6 10 7 20
$EndElements
)";

inline constexpr const char* gmsh_4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 0 1
1 0 0 0 2 1 2 0 0
$EndEntities
$Nodes
2 11 1 20
3 1 0 8
1
2
3
4
5
6
7
8
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
3 2 0 3
9
10
20
2 0 0
2 0 1
0.5 0.5 2
$EndNodes
$Elements
5 5 1 5
2 1 2 1
2 1 2 3
3 1 5 1
1 1 2 3 4 5 6 7 8
3 1 6 1
3 2 9 3 6 10 7
3 1 7 1
4 5 6 7 8 20
3 1 4 1
5 6 10 7 20
$EndElements
)";

}  // namespace mesh_texts
