// A steel bracket of L shape on a wall, half of it (the plane y = 0 is a plane of symmetry). Lengths in mm.
// What `bracket analyse` needs are the physical groups at the end.
SetFactory("OpenCASCADE");

Box(1) = {0, 0, -60, 15, 25, 75};    // back plate: x from 0 to 15, y from 0 to 25, z from -60 to 15
Box(2) = {15, 0, 0, 55, 25, 15};     // arm: x from 15 to 70, z from 0 to 15
Box(3) = {70, 0, 0, 30, 25, 15};     // its outer end, whose top carries the load: a face of its own

// The volumes share the faces where they meet.
Coherence;

e = 0.01;
wall() = Surface In BoundingBox{-e, -e, -60 - e, e, 25 + e, 15 + e};
seat() = Surface In BoundingBox{70 - e, -e, 15 - e, 100 + e, 25 + e, 15 + e};
symmetry() = Surface In BoundingBox{-e, -e, -60 - e, 100 + e, e, 15 + e};

Physical Volume("BRACKET") = {1, 2, 3};
Physical Surface("WALL") = {wall()};
Physical Surface("SEAT") = {seat()};
Physical Surface("SYMMETRY") = {symmetry()};

// Sizes: 14 mm, 5 mm around the root of the arm, where the hinge forms.
MeshSize{ : } = 14;
MeshSize{ PointsOf{ Surface{Surface In BoundingBox{15 - e, -e, -e, 15 + e, 25 + e, 15 + e}}; } } = 5;
Mesh.MeshSizeExtendFromBoundary = 1;
Mesh.ElementOrder = 1;  // bracket adds its own mid-side nodes
