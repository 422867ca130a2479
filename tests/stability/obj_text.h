// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host_sim/io/model.h"

namespace fixrad::host {

/// A model as the text of an OBJ file that asks for the materials `library`, and as that of the library.
/// Coordinates and colours keep all their digits.
std::string obj_text(const Model& model, const std::string& library);
std::string mtl_text(const Model& model);

/// Writes both into `folder` as NAME.obj and NAME.mtl; returns the path of the first.
std::string write_obj(const Model& model, const std::string& folder, const std::string& name);

}  // namespace fixrad::host
