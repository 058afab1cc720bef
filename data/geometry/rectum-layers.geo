// The rectum of rectum.geo in layers: elements in order, so that its wall may be cut into as many layers as edges are
// cut along it.
Include "common.geo";
SetFactory("Built-in");  // what is extruded shares its faces
DefineConstant[
  inner_radius = {12, Name "radius of the lumen [mm]"},
  wall = {4, Name "thickness of the wall [mm]"},
  length = {60, Name "length [mm]"},
  contact_angle = {80, Name "contact: to each side of the top [degree]"},
  margin = {7.5, Name "contact: free of it at each end [mm]"},
  sacral_angle = {23, Name "held by the sacrum: to each side of the bottom [degree]"},
  layers = {1, Name "layers through the wall"}
];
half = length / 2;
edge[] = {-contact_angle, contact_angle, 180 - sacral_angle, 180 + sacral_angle};  // of the sectors, from +z towards +x
cuts[] = {6 * layers, 3 * layers, 2 * layers, 3 * layers};                         // along each sector
Point(1) = {0, -half*mm, 0};
For i In {0 : 3}
  a = edge[i] * Pi / 180;
  Point(10 + i) = {inner_radius*mm * Sin(a), -half*mm, inner_radius*mm * Cos(a)};
  Point(20 + i) = {(inner_radius + wall)*mm * Sin(a), -half*mm, (inner_radius + wall)*mm * Cos(a)};
  Line(30 + i) = {10 + i, 20 + i};
  Transfinite Curve{30 + i} = layers + 1;
EndFor
// An arc of more than half a turn is none: the widest sector has 160 degrees.
For i In {0 : 3}
  n = (i + 1) % 4;
  Circle(40 + i) = {10 + i, 1, 10 + n};
  Circle(50 + i) = {20 + i, 1, 20 + n};
  Transfinite Curve{40 + i, 50 + i} = cuts[i] + 1;
  Curve Loop(60 + i) = {30 + i, 50 + i, -(30 + n), -(40 + i)};
  Plane Surface(60 + i) = {60 + i};
  Transfinite Surface{60 + i} = {10 + i, 20 + i, 20 + n, 10 + n};
EndFor
front[] = {60 : 63};
volumes[] = {};
contact[] = {}; strip[] = {}; lumen[] = {}; side[] = {};
along[] = {margin, length - 2*margin, margin};
steps[] = {layers, 6 * layers, layers};
base[] = front[];
For part In {0 : 2}
  next[] = {};
  For i In {0 : 3}
    made[] = Extrude{0, along[part]*mm, 0}{ Surface{base[i]}; Layers{steps[part]}; };
    next[] += made[0];
    volumes[] += made[1];
    // Lateral faces in the order of the loop: radial, outer, radial, inner.
    If (i == 0 && part == 1)
      contact[] += made[3];
    ElseIf (i == 2)
      strip[] += made[3];
    Else
      side[] += made[3];
    EndIf
    lumen[] += made[5];
  EndFor
  base[] = next[];
EndFor
Physical Volume("rectum") = {volumes[]};
Physical Surface("contact") = {contact[]};
Physical Surface("fixed") = {strip[], front[], base[]};
Physical Surface("lumen") = {lumen[]};
Physical Surface("side") = {side[]};
