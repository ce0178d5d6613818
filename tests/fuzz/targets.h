// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace plumbline::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Each hands bytes to one of the program's readers and, if they are accepted, does with the result
/// what the program would. Bad input may only be refused by an InputError of one line; whatever
/// else goes wrong ends the process or leaves as another exception.
void scene_json(Bytes text);
/// .gltf or .glb: a file that begins with "glTF" is taken for the latter.
void gltf(Bytes file);
/// An OBJ file and, behind the first byte 0, its MTL file.
void obj(Bytes files);
/// A picture of any format: as one to compare, as surroundings, as a texture.
void image(Bytes file);
/// The words of a command line, with a byte 0 between them. Read in full, never carried out.
void command_line(Bytes words);

}  // namespace plumbline::fuzz
