// A ball with its top cut off flat, which is held and pushed: it comes down onto a block.
Include "common.geo";
DefineConstant[
  radius = {20, Name "radius [mm]"},
  top = {12, Name "where it is cut off, above its middle [mm]"},
  size = {7.5, Name "edge length aimed at [mm]"}
];
Sphere(1) = {0, 0, radius*mm, radius*mm};
Box(2) = {-2*radius*mm, -2*radius*mm, -radius*mm, 4*radius*mm, 4*radius*mm, (2*radius + top)*mm};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
e = 1e-6;
z = (radius + top) * mm;
cap() = Surface In BoundingBox{-1, -1, z - e, 1, 1, z + e};
side() = Surface{:};
side() -= cap();
Physical Volume("ball") = {3};
Physical Surface("cap") = cap();
Physical Surface("contact") = side();
Mesh.MeshSizeMin = size * mm;
Mesh.MeshSizeMax = size * mm;
