// SPDX-License-Identifier: MIT
#include <string>

#include "host_sim/report/mesh_check.h"
#include "host_sim/report/text.h"
#include "host_sim/report/writers.h"

namespace fixrad::host {

void write_csv(const std::filesystem::path& target, const BakedMesh& mesh, const Display& /*display*/) {
  check_mesh(mesh);
  std::string text = "element,face,material,x,y,z,area,B_r,B_g,B_b\n";
  for (const BakedElement& element : mesh.elements) {
    append_number(text, std::int64_t{element.index});
    text += ',';
    append_number(text, std::int64_t{element.input_face});
    text += ',' + csv_field(element.material);
    for (const double value : {element.centroid.x, element.centroid.y, element.centroid.z, element.area,
                               element.radiosity.x, element.radiosity.y, element.radiosity.z}) {
      text += ',';
      append_number(text, value);
    }
    text += '\n';
  }
  write_text(target, text);
}

}  // namespace fixrad::host
