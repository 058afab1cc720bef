// Prostate: two half ellipsoids that share their widest section; the lower one, towards the rectum, is flatter.
// The rectum lies below (-z). Above its widest section its surface is held.
Include "common.geo";
DefineConstant[
  width = {40, Name "across, along x [mm]"},
  height = {35, Name "apex to base, along y [mm]"},
  depth_below = {10.1, Name "from the widest section to the rectal side [mm]"},
  depth_above = {15.1, Name "from the widest section to the ventral side [mm]"},
  contact_height = {4.5, Name "contact: up to this far below the widest section [mm]"},
  bottom = {16.4, Name "z of the lowest point [mm]"},
  size = {4.25, Name "edge length aimed at on the surface [mm]"},
  inside = {7, Name "edge length aimed at inside [mm]"}
];

// Half a meridian of the unit sphere in the x-z plane, cut where a patch ends; turned about z, then stretched.
low = Asin(contact_height / depth_below);
Circle(1) = {0, 0, 0, 1, -Pi/2, -low};  // contact
Circle(2) = {0, 0, 0, 1, -low, 0};
Circle(3) = {0, 0, 0, 1, 0, Pi/2};     // held
Rotate{ {1, 0, 0}, {0, 0, 0}, Pi/2 }{ Curve{1:3}; }
contact() = Extrude{ {0, 0, 1}, {0, 0, 0}, 2*Pi }{ Curve{1}; };
below() = Extrude{ {0, 0, 1}, {0, 0, 0}, 2*Pi }{ Curve{2}; };
held() = Extrude{ {0, 0, 1}, {0, 0, 0}, 2*Pi }{ Curve{3}; };
Delete{ Curve{1:3}; }
Dilate{ {0, 0, 0}, {width/2 * mm, height/2 * mm, depth_below * mm} }{ Surface{contact(1), below(1)}; }
Dilate{ {0, 0, 0}, {width/2 * mm, height/2 * mm, depth_above * mm} }{ Surface{held(1)}; }
Translate{0, 0, (bottom + depth_below) * mm}{ Surface{contact(1), below(1), held(1)}; }
s() = BooleanFragments{ Surface{contact(1), below(1), held(1)}; Delete; }{};
Surface Loop(1) = {s()};
Volume(1) = {1};
Physical Volume("prostate") = {1};
Physical Surface("contact") = {s(0)};
Physical Surface("side") = {s(1)};
Physical Surface("fixed") = {s(2)};

// Points every size apart on the surface, fewer inside.
MeshSize{ PointsOf{ Surface{:}; } } = size * mm;
Mesh.MeshSizeMin = size * mm;
Mesh.MeshSizeMax = inside * mm;
