// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace fixrad::host {

// What the reader takes, so that no file makes it take more than some 200 MB or a few seconds. A device
// numbers vertices, faces and elements in 16 bits: what is refused here could not be solved either.
// docs/robustness.md lists these numbers; a test compares.

inline constexpr std::size_t kMaxObjBytes = std::size_t{64} << 20;       ///< of the OBJ file
inline constexpr std::size_t kMaxMtlBytes = std::size_t{4} << 20;        ///< of a scene's MTL files together
inline constexpr std::size_t kMaxStatementBytes = std::size_t{1} << 20;  ///< of a line, and of several joined
inline constexpr std::size_t kMaxVertices = std::size_t{1} << 20;        ///< `v` of a file, used or not
inline constexpr std::size_t kMaxFaces = std::size_t{1} << 17;           ///< `f` of a file
inline constexpr std::size_t kMaxFaceCorners = 1000;  ///< triangulating one costs their square
inline constexpr std::size_t kMaxFileCorners = std::size_t{1} << 19;  ///< of all faces
inline constexpr std::size_t kMaxPieces = std::size_t{1}
                                          << 17;     ///< convex ones, of all faces, before they are joined
inline constexpr std::size_t kMaxMaterials = 65535;  ///< `newmtl` of all MTL files
inline constexpr std::size_t kMaxMtlFiles = 64;
inline constexpr std::size_t kMaxFileLookups = 1024;  ///< what `mtllib` statements may ask the file system
inline constexpr std::size_t kMaxNumberChars = 128;
inline constexpr std::size_t kMaxWarnings = 100;
inline constexpr double kMaxCoordinate = 1e30;  ///< areas, volumes and their squares stay finite
inline constexpr double kMaxEmission = 1e30;
inline constexpr double kMinEmission =
    1e-30;  ///< where there is any: its inverse and the square of that stay finite

}  // namespace fixrad::host
