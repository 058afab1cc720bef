// A block under the ball.
Include "common.geo";
DefineConstant[
  side = {50, Name "along x and y [mm]"},
  height = {30, Name "[mm]"},
  size = {7.5, Name "edge length aimed at [mm]"}
];
Box(1) = {-side/2*mm, -side/2*mm, -height*mm, side*mm, side*mm, height*mm};
e = 1e-6;
top() = Surface In BoundingBox{-1, -1, -e, 1, 1, e};
bottom() = Surface In BoundingBox{-1, -1, -height*mm - e, 1, 1, -height*mm + e};
side_faces() = Surface{:};
side_faces() -= {top(), bottom()};
Physical Volume("block") = {1};
Physical Surface("contact") = top();
Physical Surface("fixed") = bottom();
Physical Surface("side") = side_faces();
Mesh.MeshSizeMin = size * mm;
Mesh.MeshSizeMax = size * mm;
