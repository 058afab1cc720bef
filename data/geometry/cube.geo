// Cube of section 4 of Kuroda et al. 2003: its top face at z = 0 is pressed, its bottom face is held.
Include "common.geo";
DefineConstant[
  edge = {50, Name "edge [mm]"},
  size = {16, Name "edge length aimed at [mm]"}
];
a = edge * mm;
e = 1e-6;
Box(1) = {-a/2, -a/2, -a, a, a, a};
Physical Volume("cube") = {1};
Physical Surface("fixed") = Surface In BoundingBox{-a, -a, -a - e, a, a, -a + e};
Physical Surface("contact") = Surface In BoundingBox{-a, -a, -e, a, a, e};
Mesh.MeshSizeMin = size * mm;
Mesh.MeshSizeMax = size * mm;
