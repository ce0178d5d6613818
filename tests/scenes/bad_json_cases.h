// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace plumbline {

/// A change that spoils a good scene file, and the line that it gets.
struct BadJson {
    const char* from;  ///< text of the good file
    const char* to;    ///< what stands there instead
    const char* line;
};

const BadJson bad_json_cases[] = {
    {"\"name\": \"small\",", "\"name\": \"small\"",
     "s.json:3:15: syntax error while parsing object - unexpected string literal; expected '}'; "
     "correct the JSON here"},
    {"\"name\": \"small\",", "\"name\": small,",
     "s.json:2:13: syntax error while parsing value - invalid literal; last read: '\"name\": s'; "
     "correct the JSON here"},
    {"\"name\": \"small\",", "\"name\": \"small\", \"name\": \"again\",",
     "s.json: /name: this key stands twice in one object; keep one"},
    {"\"name\": \"small\",", "\"nmae\": \"small\",",
     "s.json: unknown key \"nmae\"; did you mean \"name\"?"},
    {"\"name\": \"small\",", "", "s.json: has no \"name\"; add it"},
    {"\"name\": \"small\",", "\"name\": 3,", "s.json: /name: is 3; write a text in quotes"},
    {"\"materials\"", "\"material\"",
     "s.json: unknown key \"material\"; did you mean \"materials\"?"},
    {"\"frames\": 10", "\"framez\": 10",
     "s.json: unknown key \"framez\"; did you mean \"frames\"?"},
    {"\"albedo\": 0.7", "\"albedo\": 1.5",
     "s.json: /materials/0/albedo: is 1.5, outside [0, 1]; a surface cannot reflect more light "
     "than falls on it, nor less than none"},
    {"\"albedo\": 0.7", "\"albedo\": [0.5, -0.25, 1]",
     "s.json: /materials/0/albedo: is -0.25, outside [0, 1]; a surface cannot reflect more light "
     "than falls on it, nor less than none"},
    {"\"albedo\": 0.7", "\"albedo\": [0.5, 0.5]",
     "s.json: /materials/0/albedo: is an array of 2; write an array of three numbers"},
    {"\"albedo\": 0.7", "\"albedo\": \"red\"",
     "s.json: /materials/0/albedo: is the text \"red\"; write an array of three numbers"},
    {"\"albedo\": 0.7", "\"albedo\": NaN",
     "s.json:3:46: syntax error while parsing value - invalid literal; last read: '\"albedo\": N'; "
     "correct the JSON here"},
    {"\"albedo\": 0.7", "\"albedo\": 1e999",
     "s.json:3:46: the number \"1e999\" is too large; it must be finite as a 32-bit float, so "
     "below 3.4e38"},
    {"\"albedo\": 0.7", "\"albedo\": 1e39",
     "s.json: /materials/0/albedo: 1e+39 is too large for a 32-bit float; stay below 3.4e38"},
    {"\"albedo\": 0.7", "\"albdo\": 0.7",
     "s.json: /materials/0: unknown key \"albdo\"; did you mean \"albedo\"?"},
    {"\"albedo\": 0.7", "\"albedo\": 0.7, \"emission\": -1",
     "s.json: /materials/0/emission: is negative (-1); light has a power of 0 or more"},
    {"\"albedo\": 0.7", "\"albedo\": 0.7, \"two_sided\": \"yes\"",
     "s.json: /materials/0/two_sided: is the text \"yes\"; write true or false"},
    {"\"albedo\": 0.7}", "\"albedo\": 0.7}, {\"name\": \"grey\", \"albedo\": 0}",
     "s.json: /materials/1/name: \"grey\" is the name of an earlier one too; give each a name of "
     "its own"},
    {"\"radius\": 1", "\"radius\": 0", "s.json: /objects/0/sphere/radius: is 0; it is above 0"},
    {"\"radius\": 1", "\"radius\": -2", "s.json: /objects/0/sphere/radius: is -2; it is above 0"},
    {"\"radius\": 1", "\"radius\": \"1\"",
     "s.json: /objects/0/sphere/radius: is the text \"1\"; write a number"},
    {"\"radius\": 1", "\"diameter\": 2",
     "s.json: /objects/0/sphere: unknown key \"diameter\"; known are \"center\", \"radius\", "
     "\"inward\", \"material\""},
    {"\"radius\": 1, \"material\": \"grey\"", "\"radius\": 1, \"material\": \"gray\"",
     "s.json: /objects/0/sphere/material: there is no material \"gray\"; did you mean \"grey\"?"},
    {"\"radius\": 1, \"material\": \"grey\"", "\"radius\": 1, \"material\": \"mirror\"",
     "s.json: /objects/0/sphere/material: there is no material \"mirror\"; known are \"grey\""},
    {"\"scale\": 2", "\"scale\": [1, 2, 1]",
     "s.json: /objects/0: is a sphere, but \"ball\" scales it unevenly; scale a sphere alike along "
     "x, y and z, or use a mesh"},
    {"\"scale\": 2", "\"scale\": 0",
     "s.json: /objects/0/scale: is zero along an axis, for good; scale by something else, or "
     "animate it"},
    {"\"scale\": 2", "\"scale\": 2, \"quad\": {}",
     "s.json: /objects/0: has several shapes; keep one of \"box\", \"quad\", \"sphere\" and "
     "\"mesh\", and give the others objects of their own"},
    {"\"scale\": 2", "\"scale\": 2, \"parent\": \"box\"",
     "s.json: /objects/0/parent: \"ball\" is its own ancestor, directly or through others; leave "
     "\"parent\" out of the topmost object"},
    {"\"scale\": 2", "\"scale\": 2, \"parent\": \"bxo\"",
     "s.json: /objects/0/parent: there is no object \"bxo\"; did you mean \"box\"?"},
    {"\"scale\": 2",
     "\"scale\": 2, \"animation\": {\"scale\": {\"frames\": [0, 1], \"values\": [1, [1, 1, 2]]}}",
     "s.json: /objects/0: is a sphere, but \"ball\" scales it unevenly; scale a sphere alike along "
     "x, y and z, or use a mesh"},
    {"\"parent\": \"ball\"", "\"parent\": \"box\"",
     "s.json: /objects/1/parent: \"box\" is its own ancestor, directly or through others; leave "
     "\"parent\" out of the topmost object"},
    {"\"name\": \"leaf\"", "\"name\": \"ball\"",
     "s.json: /objects/2/name: \"ball\" is the name of an earlier one too; give each a name of its "
     "own"},
    {"\"axis\": [0, 1, 0], \"degrees\": 30", "\"axis\": [0, 0, 0], \"degrees\": 30",
     "s.json: /objects/1/rotation/axis: has length zero; [0, 1, 0] turns about the y axis"},
    {"\"axis\": [0, 1, 0], \"degrees\": 30", "\"axis\": [0, 1, 0]",
     "s.json: /objects/1/rotation: must say the angle once; write either \"degrees\" or "
     "\"radians\""},
    {"\"axis\": [0, 1, 0], \"degrees\": 30", "\"axis\": [0, 1, 0], \"degrees\": 30, \"radians\": 1",
     "s.json: /objects/1/rotation: must say the angle once; write either \"degrees\" or "
     "\"radians\""},
    {"{\"axis\": [0, 1, 0], \"degrees\": 30}", "[0, 1, 0]",
     "s.json: /objects/1/rotation: is an array of 3; write four numbers x, y, z, w, or {\"axis\", "
     "\"degrees\"}"},
    {"{\"axis\": [0, 1, 0], \"degrees\": 30}", "[0, 1, 0, 1]",
     "s.json: /objects/1/rotation: has length 1.41421; the quaternion x, y, z, w of a rotation has "
     "length 1"},
    {"\"upper\": [1, 1, 1]", "\"upper\": [1, 0, 1]",
     "s.json: /objects/1/box/upper: is not above \"lower\" along every axis; swap them, or use a "
     "quad for something flat"},
    {"\"upper\": [1, 1, 1], \"material\": \"grey\"",
     "\"upper\": [1, 1, 1], \"faces\": {\"+x\": \"grey\"}",
     "s.json: /objects/1/box: its face -x has no material; add \"material\" for all faces that "
     "\"faces\" does not name"},
    {"\"upper\": [1, 1, 1], \"material\": \"grey\"",
     "\"upper\": [1, 1, 1], \"material\": \"grey\", \"faces\": {\"x\": \"grey\"}",
     "s.json: /objects/1/box/faces: unknown key \"x\"; did you mean \"+x\"?"},
    {"\"upper\": [1, 1, 1], \"material\": \"grey\"", "\"upper\": [1, 1, 1]",
     "s.json: /objects/1/box: its face +x has no material; add \"material\" for all faces that "
     "\"faces\" does not name"},
    {"\"frames\": [1, 5]", "\"frames\": [5, 1]",
     "s.json: /objects/1/animation/translation/frames/1: 1 comes after 5; keyframes must rise"},
    {"\"frames\": [1, 5]", "\"frames\": [1]",
     "s.json: /objects/1/animation/translation: has 1 frames and 2 values; give one value a frame"},
    {"\"frames\": [1, 5]", "\"frames\": []",
     "s.json: /objects/1/animation/translation/frames: is empty; leave the whole property out, or "
     "give keyframes"},
    {"\"frames\": [1, 5]", "\"frames\": [1, 5], \"interpolation\": \"cubic\"",
     "s.json: /objects/1/animation/translation/interpolation: there is no interpolation \"cubic\"; "
     "known are \"linear\", \"step\""},
    {"\"translation\": {\"frames\"", "\"position\": {\"frames\"",
     "s.json: /objects/1/animation: unknown key \"position\"; known are \"translation\", "
     "\"rotation\", \"scale\""},
    {"\"edge_v\": [0, 1, 0]", "\"edge_v\": [2, 0, 0]",
     "s.json: /objects/2/quad: has no area; its edges must differ from zero and from each other's "
     "direction"},
    {"\"mesh\": \"triangle\"", "\"mesh\": \"triangel\"",
     "s.json: /objects/3/mesh: there is no mesh \"triangel\"; did you mean \"triangle\"?"},
    {"\"mesh\": \"triangle\"",
     "\"mesh\": {\"positions\": [], \"triangles\": [], \"material\": \"grey\"}",
     "s.json: /objects/3/mesh/positions: is empty; a mesh has vertices"},
    {"\"mesh\": \"triangle\"", "\"mesh\": {\"file\": \"../secret.obj\"}",
     "s.json: /objects/3/mesh/file: \"../secret.obj\" is not in the scene's folder; put the file "
     "into that folder or below, and name it relative to it"},
    {"\"mesh\": \"triangle\"", "\"mesh\": {\"file\": \"/etc/passwd\"}",
     "s.json: /objects/3/mesh/file: \"/etc/passwd\" is not in the scene's folder; put the file "
     "into that folder or below, and name it relative to it"},
    {"\"mesh\": \"triangle\"", "\"mesh\": {\"file\": \"missing.obj\"}",
     "missing.obj: No such file or directory; check its name, and that you may read it"},
    {"\"mesh\": \"triangle\"", "\"mesh\": {\"file\": \"mesh.stl\"}",
     "s.json: /objects/3/mesh/file: meshes are not read from \".stl\"; use .obj, .gltf or .glb"},
    {"[[0, 1, 2]]", "[[0, 1, 3]]",
     "s.json: /meshes/0/triangles/0/2: is 3; write a whole number from 0 to 2"},
    {"[[0, 1, 2]]", "[[0, 1, -1]]",
     "s.json: /meshes/0/triangles/0/2: is -1; write a whole number from 0 to 2"},
    {"[[0, 1, 2]]", "[[0, 1.5, 2]]",
     "s.json: /meshes/0/triangles/0/1: is 1.5; write a whole number from 0 to 2"},
    {"[[0, 1, 2]], \"material\": \"grey\"",
     "[[0, 1, 2]], \"triangle_materials\": [\"grey\", \"grey\"]",
     "s.json: /meshes/0/triangle_materials: has 2 entries for 1 triangles; give one a triangle"},
    {"[[0, 1, 2]], \"material\": \"grey\"", "[[0, 1, 2]]",
     "s.json: /meshes/0: must say its materials once; give either \"material\", or "
     "\"triangle_materials\" with one a triangle"},
    {"\"positions\": [[0, 0, 0], ", "\"vertex_albedo\": [[1, 1, 1]], \"positions\": [[0, 0, 0], ",
     "s.json: /meshes/0/vertex_albedo: has 1 entries for 3 positions; give one a position, or "
     "none"},
    {"\"intensity\": [1, 1, 1]", "\"intensity\": [1, -1, 1]",
     "s.json: /lights/0/intensity: is negative (-1); light has a power of 0 or more"},
    {"\"intensity\": [1, 1, 1]", "\"white_radiance\": [1, 1, 1]",
     "s.json: /lights/0/white_radiance: does not go with falloff inverse_square; give "
     "\"intensity\", in W/sr, or set \"falloff\" to \"none\""},
    {"\"intensity\": [1, 1, 1]", "\"falloff\": \"none\", \"intensity\": [1, 1, 1]",
     "s.json: /lights/0/intensity: does not go with falloff none; give \"white_radiance\", the "
     "radiance of a white surface that faces it"},
    {"\"intensity\": [1, 1, 1]", "\"falloff\": \"nonne\", \"white_radiance\": [1, 1, 1]",
     "s.json: /lights/0/falloff: there is no falloff \"nonne\"; did you mean \"none\"?"},
    {"\"intensity\": [1, 1, 1]", "\"power\": 1",
     "s.json: /lights/0: unknown key \"power\"; known are \"name\", \"type\", \"position\", "
     "\"falloff\", \"intensity\", \"white_radiance\", \"radius\""},
    {"\"intensity\": [1, 1, 1]", "\"intensity\": 1, \"radius\": -1",
     "s.json: /lights/0/radius: is -1; it is 0, or 1e-08 or more"},
    {"\"intensity\": [1, 1, 1]", "\"intensity\": 1, \"type\": \"spott\"",
     "s.json: /lights/0/type: there is no light of type \"spott\"; did you mean \"spot\"?"},
    {"\"intensity\": [1, 1, 1]", "\"intensity\": 1, \"type\": \"spot\"",
     "s.json: /lights/0: has no \"direction\"; add it"},
    {"\"intensity\": [1, 1, 1]", "\"intensity\": 1, \"type\": \"spot\", \"direction\": [0, 0, 0]",
     "s.json: /lights/0/direction: has length zero; [0, -1, 0] is straight down"},
    {"\"intensity\": [1, 1, 1]",
     "\"intensity\": 1, \"type\": \"spot\", \"direction\": [0, 1, 0], \"outer_angle\": 91",
     "s.json: /lights/0/outer_angle: is 91 degrees; it is above 0 and at most 90"},
    {"\"intensity\": [1, 1, 1]",
     "\"intensity\": 1, \"type\": \"spot\", \"direction\": [0, 1, 0], \"inner_angle\": 45",
     "s.json: /lights/0/inner_angle: is 45 degrees; it is at least 0 and below the outer angle, "
     "45"},
    {"{\"name\": \"lamp\", \"position\": [0, 5, 0], \"intensity\": [1, 1, 1]}",
     "{\"type\": \"directional\", \"direction\": [0, -1, 0], \"irradiance\": -2}",
     "s.json: /lights/0/irradiance: is negative (-2); light has a power of 0 or more"},
    {"\"target\": [0, 0, 0]", "\"target\": [0, 0, 5]",
     "s.json: /camera/target: is the eye itself; look elsewhere"},
    {"\"up\": [0, 1, 0]", "\"up\": [0, 0, 2]",
     "s.json: /camera/up: is parallel to the view; [0, 0, 1] serves when looking along y"},
    {"\"up\": [0, 1, 0]", "\"up\": [0, 0, 0]",
     "s.json: /camera/up: has length zero; [0, 1, 0] is y up"},
    {"\"vertical_fov\": 45", "\"vertical_fov\": 0",
     "s.json: /camera/vertical_fov: is 0; it lies between 0 and 180 degrees"},
    {"\"vertical_fov\": 45", "\"vertical_fov\": 180",
     "s.json: /camera/vertical_fov: is 180; it lies between 0 and 180 degrees"},
    {"\"width\": 64", "\"width\": 0",
     "s.json: /camera/width: is 0; write a whole number from 1 to 16384"},
    {"\"width\": 64", "\"width\": 100000",
     "s.json: /camera/width: is 100000; write a whole number from 1 to 16384"},
    {"\"width\": 64", "\"width\": 6.4",
     "s.json: /camera/width: is 6.4; write a whole number from 1 to 16384"},
    {"\"width\": 64, \"height\": 32", "\"width\": 16384, \"height\": 16385",
     "s.json: /camera/height: is 16385; write a whole number from 1 to 16384"},
    {"\"frames\": 10", "\"frames\": 0",
     "s.json: /frames: is 0; write a whole number from 1 to 10000000"},
    {"\"frames\": 10", "\"frames\": 10, \"report_frame\": 10",
     "s.json: /report_frame: is 10; the scene has frames 0 to 9"},
    {"\"frames\": 10", "\"frames\": 1e12",
     "s.json: /frames: is 1000000000000.0; write a whole number from 1 to 10000000"},
    {"\"frames_per_second\": 24", "\"frames_per_second\": 0",
     "s.json: /frames_per_second: is 0; it is above 0"},
    {"\"spacing\": 0.5", "\"spacing\": 0",
     "s.json: /probes/spacing: is 0; the distance between probes is 1e-08 or more"},
    {"\"spacing\": 0.5", "\"spacing\": -1",
     "s.json: /probes/spacing: is -1; the distance between probes is 1e-08 or more"},
    {"\"counts\": [2, 3, 4]", "\"counts\": [2, 0, 4]",
     "s.json: /probes/counts/1: is 0; write a whole number from 1 to 100000000"},
    {"\"counts\": [2, 3, 4]", "\"counts\": [20000, 20000, 20000]",
     "s.json: /probes/counts: ask for 20000 x 20000 x 20000 probes; each is at least 1, and all "
     "probes at most 100000000"},
    {"\"counts\": [2, 3, 4]", "\"counts\": [2, 3]",
     "s.json: /probes/counts: is an array of 2; write an array of three whole numbers"},
    {"\"probes\": {", "\"environment\": -1, \"probes\": {",
     "s.json: /environment: is negative (-1); light has a power of 0 or more"},
    {"\"probes\": {", "\"thesis\": {\"ambient\": 1}, \"probes\": {",
     "s.json: /thesis: has no \"falloffRegulator\"; add it"},
};

}  // namespace plumbline
