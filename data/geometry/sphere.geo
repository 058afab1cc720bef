// Ball of section 4 of Kuroda et al. 2003, held at two small caps at its sides, as between two fingers: pushed on
// top it gives way as a whole and presses with its underside, and no rigid motion is left.
Include "common.geo";
DefineConstant[
  radius = {20, Name "radius [mm]"},
  cap_angle = {18, Name "held: to each side of the x axis [degree]"},
  contact_angle = {60, Name "contact: to each side of the bottom [degree]"},
  bottom = {0.1, Name "z of the lowest point [mm]"},
  size = {10, Name "edge length aimed at [mm]"}
];
R = radius * mm;
cap = cap_angle * Pi / 180;
contact = contact_angle * Pi / 180;

Sphere(1) = {0, 0, 0, R};
Rotate{ {1, 1, 1}, {0, 0, 0}, -2*Pi/3 }{ Volume{1}; }  // poles on the y axis, seam over the top
// Patches of the surface: arcs in the x-y plane, turned about the x axis (caps) and about the z axis (contact).
Circle(101) = {0, 0, 0, R, 0, cap};
Circle(102) = {0, 0, 0, R, Pi - cap, Pi};
Circle(103) = {0, 0, 0, R, -Pi/2, -Pi/2 + contact};
Rotate{ {1, 0, 0}, {0, 0, 0}, Pi/2 }{ Curve{103}; }
right() = Extrude{ {1, 0, 0}, {0, 0, 0}, 2*Pi }{ Curve{101}; };
left() = Extrude{ {1, 0, 0}, {0, 0, 0}, 2*Pi }{ Curve{102}; };
below() = Extrude{ {0, 0, 1}, {0, 0, 0}, 2*Pi }{ Curve{103}; };
top = newp; Point(top) = {0, 0, R};
BooleanFragments{ Volume{1}; Delete; }{ Surface{right(1), left(1), below(1)}; Point{top}; Delete; }
Translate{0, 0, bottom * mm + R}{ Volume{:}; }

e = 1e-6;
z = bottom * mm + R;
fixed_faces() = Surface In BoundingBox{R*Cos(cap) - e, -R, z - R, R + e, R, z + R};
fixed_faces() += Surface In BoundingBox{-R - e, -R, z - R, -R*Cos(cap) + e, R, z + R};
contact_faces() = Surface In BoundingBox{-R, -R, z - R - e, R, R, z - R*Cos(contact) + e};
Physical Volume("sphere") = Volume{:};
Physical Surface("fixed") = fixed_faces();
Physical Surface("contact") = contact_faces();
Mesh.MinimumCircleNodes = 4;  // the caps stay small on coarse meshes
Mesh.MeshSizeMin = size * mm;
Mesh.MeshSizeMax = size * mm;
