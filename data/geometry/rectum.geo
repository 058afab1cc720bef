// Rectum within reach of the finger: a straight tube along y, one layer of tetrahedra through its wall.
// The prostate lies above (+z), the sacrum below, x points to the side.
Include "common.geo";
DefineConstant[
  inner_radius = {12, Name "radius of the lumen [mm]"},
  wall = {4, Name "thickness of the wall [mm]"},
  length = {60, Name "length [mm]"},
  contact_angle = {80, Name "contact: to each side of the top [degree]"},
  margin = {7.5, Name "contact: free of it at each end [mm]"},
  sacral_angle = {23, Name "held by the sacrum: to each side of the bottom [degree]"},
  size = {8.3, Name "edge length aimed at on the outer wall [mm]"},
  lumen_size = {8, Name "edge length aimed at on the lumen [mm]"}
];
inner = inner_radius * mm;
outer_radius = (inner_radius + wall) * mm;
band = margin * mm;
half = length / 2 * mm;

Cylinder(1) = {0, -half, 0, 0, 2*half, 0, outer_radius};
Cylinder(2) = {0, -half, 0, 0, 2*half, 0, inner};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };

// Patches of the outer wall, cut out of it by fragmenting: contact on top, the sacral strip below.
// An angle is counted from +z; a circle lies in the x-y plane and is turned into the x-z plane.
contact = contact_angle * Pi / 180;
sacral = sacral_angle * Pi / 180;
Circle(101) = {0, 0, 0, outer_radius, Pi/2 - contact, Pi/2 + contact};
Circle(102) = {0, 0, 0, outer_radius, 3*Pi/2 - sacral, 3*Pi/2 + sacral};
Rotate{ {1, 0, 0}, {0, 0, 0}, Pi/2 }{ Curve{101, 102}; }
Translate{0, -half + band, 0}{ Curve{101}; }
Translate{0, -half, 0}{ Curve{102}; }
a() = Extrude{0, 2*half - 2*band, 0}{ Curve{101}; };
b() = Extrude{0, 2*half, 0}{ Curve{102}; };
p = newp; Point(p) = {0, 0, inner};  // where the finger presses
BooleanFragments{ Volume{3}; Delete; }{ Surface{a(1), b(1)}; Point{p}; Delete; }

e = 1e-6;
R = outer_radius + e;
contact_faces() = Surface In BoundingBox{-R, -half + band - e, outer_radius*Cos(contact) - e, R, half - band + e, R};
strip_faces() = Surface In BoundingBox{-outer_radius*Sin(sacral) - e, -half - e, -R, outer_radius*Sin(sacral) + e, half + e, -outer_radius*Cos(sacral) + e};
end_faces() = Surface In BoundingBox{-R, -half - e, -R, R, -half + e, R};
end_faces() += Surface In BoundingBox{-R, half - e, -R, R, half + e, R};
lumen_faces() = Surface In BoundingBox{-inner - e, -half - e, -inner - e, inner + e, half + e, inner + e};
Physical Volume("rectum") = Volume{:};
Physical Surface("contact") = contact_faces();
Physical Surface("fixed") = {strip_faces(), end_faces()};
Physical Surface("lumen") = lumen_faces();
side_faces() = Surface{:};
side_faces() -= {contact_faces(), strip_faces(), end_faces(), lumen_faces()};
Physical Surface("side") = side_faces();

MeshSize{ PointsOf{ Volume{:}; } } = size * mm;
MeshSize{ PointsOf{ Surface{lumen_faces()}; } } = lumen_size * mm;
