// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/io/material_table.h"
#include "host_sim/io/model.h"
#include "host_sim/io/source_text.h"
#include "host_sim/io/warnings.h"

namespace fixrad::host {

/// Appends the positions and faces of an OBJ text to `model`, whose material indices are those of
/// `materials`. Throws InputError with the first error. A positive index may name a vertex that stands
/// further below.
void read_obj_statements(const SourceText& source, Model& model, MaterialTable& materials,
                         Warnings& warnings);

}  // namespace fixrad::host
