// SPDX-License-Identifier: MIT
#include "host_sim/cli/info_page.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace fixrad::host {
namespace {

__attribute__((format(printf, 1, 2))) std::string format(const char* text, ...) {
  char line[256];
  std::va_list arguments;
  va_start(arguments, text);
  std::vsnprintf(line, sizeof line, text, arguments);
  va_end(arguments);
  return line;
}

std::string line(const char* name, const std::string& text) {
  return format("  %-17s  ", name) + text + "\n";
}

// Three digits, and no exponent for what is large.
std::string short_number(double value) {
  if (value < 1000) {
    return format("%.3g", value);
  }
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return format("%.0f", unit * std::round(value / unit));
}

std::string ratio(const Extent& extent) {
  return "1 : " + short_number(extent.least > 0 ? extent.most / extent.least : 0.0);
}

// "0.2", or "0.2 to 3.1" where that is not one value.
std::string range(const Extent& extent) {
  return (extent.most > 1.001 * extent.least ? short_number(extent.least) + " to " : std::string()) +
         short_number(extent.most);
}

std::string closed_text(const SceneNeeds& needs) {
  if (needs.result.is_closed) {
    return needs.is_enclosed ? "yes: back faces are not drawn, no light can escape"
                             : "yes, but seen from outside: light escapes past the body";
  }
  return format("no: %zu of %zu edges have a face on one side only; back faces block and are counted",
                needs.open_edges, needs.edges);
}

std::string hiding_text(const SceneNeeds& needs) {
  if (needs.is_convex) {
    return "none, the scene is convex: no depth is tested, no eye is buried";
  }
  return "faces hide each other" + (needs.views == 0 ? std::string()
                                                     : format("; seen from %zu of %zu eye points none does",
                                                              needs.views_without_depth, needs.views));
}

std::string shots_text(const SceneNeeds& needs) {
  const BakeResult& result = needs.result;
  return format("%u from %u eye points (%u buried ones thrown away), %.2f s on this machine", result.shots,
                result.eyes, result.withdrawn, result.seconds);
}

std::string needs_text(const InfoPage& page) {
  const SceneNeeds& needs = page.needs;
  const BakeResult& result = needs.result;
  const Model& model = page.scene->model;
  const BakeOptions& options = page.options->bake;
  std::string text =
      model.path + format(": what it needs (profile %s, %u elements, R = %d)\n", options.profile.c_str(),
                          result.plan.sizes.elements, result.plan.resolution);
  text += line("faces", format("%zu in the file, %u convex planar ones with %u vertices on the grid, moved "
                               "by at most %.3g",
                               model.file_faces, result.plan.sizes.faces, result.plan.sizes.vertices,
                               page.scene->prepared.vertices.largest_error));
  text += line("colour", needs.is_grey ? "grey: one channel is carried" : "three channels");
  text += line("closed", closed_text(needs));
  text += line("hiding", hiding_text(needs));
  if (needs.sealed_faces > 0 && !result.is_closed) {
    text += line("sealed bodies", format("%zu faces whose backs no eye sees", needs.sealed_faces));
  }
  if (needs.buried_elements > 0) {
    text += line("buried",
                 format("%zu elements have their centroid under or in something", needs.buried_elements));
  }
  text += line("lamps", format("%zu elements that emit %s W each", needs.lamp_elements,
                               range(needs.lamp_watts).c_str()));
  text += line("element sizes", range(needs.element_area) + " square units, " + ratio(needs.element_area));
  text += line("radiosity", range(needs.radiosity) + " W/m^2, " + ratio(needs.radiosity));
  text +=
      line("precision",
           format("one flux unit is %.2g W; the darkest element that light reaches has received %d, %d bits",
                  result.device.unit_watts, needs.darkest_units,
                  bit_length(static_cast<std::uint32_t>(needs.darkest_units))));
  text += line("span pool", format("%u used of %u", result.spans_used, result.plan.sizes.spans));
  return text + line(format("shots to %.3g %%", 100 * options.unshot).c_str(), shots_text(needs));
}

std::string saved_text(const SceneNeeds& needs, const std::optional<double>& saved) {
  if (!saved || !needs.cost) {
    return "not known for this engine";
  }
  return format("%8s M, %4.1f %%", short_number(*saved / 1e6).c_str(), 100 * *saved / (*needs.cost + *saved));
}

std::string omissions_text(const InfoPage& page) {
  const SceneNeeds& needs = page.needs;
  if (needs.omissions.empty()) {
    return "left out because of that: nothing\n";
  }
  std::string text = format("%-56s %12s   %s\n", "left out because of that, and what it saves",
                            "bytes of RAM", (page.model->unit + " on " + page.model->target).c_str());
  for (const Omission& omission : needs.omissions) {
    text += format("  %-54s %12u   %s\n", omission.text.c_str(), omission.ram,
                   saved_text(needs, omission.cost).c_str());
  }
  return text;
}

std::string figures(const SweepPoint& point) {
  return format("%u elements in profile %s (%u bytes): %.3g %%", point.elements,
                point.options.profile.c_str(), point.ram_bytes, 100 * point.mean_error);
}

std::string wanted_text(const WantedError& wanted) {
  std::string text =
      format("mean error of at most %.3g %% over faces (path-traced truth, itself to %.2g %%)\n",
             100 * wanted.max_error, 100 * wanted.truth_standard_error);
  const ElementNeed& need = wanted.need;
  if (need.enough) {
    text += line("enough", figures(*need.enough));
  } else if (need.closest) {
    text += line("out of reach", "the closest is " + figures(*need.closest));
  }
  if (need.enough && need.too_few) {
    text += line("too few", figures(*need.too_few));
  }
  return text;
}

std::string profiles_text(const std::vector<ProfileCost>& profiles) {
  std::string text =
      "  profile       RAM  chip                         elements  patches      R  RAM used     flash\n";
  for (const ProfileCost& cost : profiles) {
    const Profile& profile = cost.profile;
    text += format("  %-7s %9u  %-28s ", profile.name.c_str(), profile.ram_bytes, profile.chip.c_str());
    text += cost.plan
                ? format("%8u %8u %6d %9u %9zu\n", cost.plan->sizes.elements, cost.plan->meshing.patch_count,
                         cost.plan->resolution, cost.plan->ram(), cost.rom_bytes)
                : std::string("does not fit\n");
  }
  return text;
}

}  // namespace

std::string info_text(const InfoPage& page) {
  return needs_text(page) + "\n" + omissions_text(page) + "\n" +
         (page.wanted ? wanted_text(*page.wanted) + "\n" : std::string()) + profiles_text(page.profiles);
}

}  // namespace fixrad::host
