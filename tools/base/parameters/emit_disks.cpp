#include "parameters/emit_disks.h"

#include <fmt/format.h>

#include "parameters/disk_generator.h"

namespace penumbra::parameters {

namespace {

FloatTable table_of(const std::string& name, const std::string& comment, const DiskPoints& points) {
  FloatTable table{name, comment, 2, {}};
  for (const glm::vec2& point : points) {
    table.values.push_back(point.x);
    table.values.push_back(point.y);
  }
  return table;
}

std::string json_points(const DiskPoints& points) {
  std::string text;
  for (const glm::vec2& point : points) {
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", point.x, point.y);
  }
  return "[" + text + "]";
}

std::string json_quality(const DiskQuality& q) {
  return fmt::format(
      "{{\"centroid\": {:.6f}, \"radial_deviation\": {:.6f}, \"star_discrepancy\": {:.6f}, "
      "\"half_plane_rmse\": {:.6f}, \"spacing\": {:.4f}}}",
      q.centroid, q.radial_deviation, q.star_discrepancy, q.half_plane_rmse, q.spacing);
}

}  // namespace

DiskSet disk_set(bool generate, const std::function<void()>& before_start) {
  DiskSet set{fibonacci_directions(kFibonacciDirections), {}};
  for (int count = 1; count <= kFibonacciDirections; ++count) {
    set.disks.push_back({"fibonacci", vogel_disk(count)});
  }
  for (const int count : kVogelSizes) set.disks.push_back({"vogel", vogel_disk(count)});
  for (const int count : kPoissonSizes) {
    set.disks.push_back(
        {"poisson", generate ? generate_poisson_disk(count, before_start) : poisson_disk(count)});
  }
  return set;
}

std::string disks_table(const DiskSet& set) {
  std::string text = "disk        points   centroid  radial dev.  star disc.  half-plane RMSE   spacing\n";
  for (const Disk& disk : set.disks) {
    const DiskQuality q = disk_quality(disk.points);
    text += fmt::format("{:<10} {:>7} {:>10.4f} {:>12.4f} {:>11.4f} {:>16.5f} {:>9.3f}\n", disk.kind,
                        disk.points.size(), q.centroid, q.radial_deviation, q.star_discrepancy,
                        q.half_plane_rmse, q.spacing);
  }
  return text +
         "\nfibonacci: directions under the uniform law r = sqrt((i + 1/2) / N). Definitions of the "
         "figures:\n"
         "tools/base/parameters/disk_quality.h; 0 is best in all but spacing.\n";
}

std::string disks_json(const DiskSet& set) {
  std::string text = fmt::format("{{\n  \"fibonacci_directions\": {},\n  \"disks\": [\n",
                                 json_points(set.fibonacci_directions));
  for (std::size_t i = 0; i < set.disks.size(); ++i) {
    const Disk& disk = set.disks[i];
    text += fmt::format("    {{\"kind\": \"{}\", \"count\": {}, \"quality\": {},\n     \"points\": {}}}{}\n",
                        disk.kind, disk.points.size(), json_quality(disk_quality(disk.points)),
                        json_points(disk.points), i + 1 < set.disks.size() ? "," : "");
  }
  return text + "  ]\n}\n";
}

std::string disks_source(const DiskSet& set, Language language) {
  SourceFile file;
  file.name = "DiskTables";
  file.comment = {
      "Disk tables: the taps of every disk filter, points of the unit disk.",
      "Written by `penumbra tables`; do not edit. Their quality figures: `penumbra tables --format table`.",
      "",
      "FibonacciDirections: unit vectors, each turned from the last by the golden angle pi (3 - sqrt 5) "
      "(Vogel",
      "  1979; Marques et al. 2013). Scale entry i of N by sqrt((i + 0.5) / N) for taps of equal area, or by",
      "  ((i + 0.5) / N)^exponent for more taps near the centre. One table works for every N up to its "
      "length.",
      "Vogel<N>: the same with the equal-area radius applied, for one fixed N.",
      "Poisson<N>: no two taps close together, no gaps; made by dart throwing, then optimised for straight",
      "  shadow edges (tools/base/parameters/disk_generator.h). Ordered: the first n taps are well spread, "
      "too.",
      "",
      "Guarantees: the same floats in every language; all points within the unit disk. Cost: no fetch.",
      "Use Fibonacci when the count varies at run time, Poisson when it is fixed."};
  file.tables.push_back(
      table_of("FibonacciDirections", "Unit vectors a golden angle apart.", set.fibonacci_directions));
  for (const Disk& disk : set.disks) {
    if (disk.kind == "fibonacci") continue;
    const bool poisson = disk.kind == "poisson";
    file.tables.push_back(table_of(
        fmt::format("{}{}", poisson ? "Poisson" : "Vogel", disk.points.size()),
        fmt::format("Half-plane RMSE {:.5f}.", disk_quality(disk.points).half_plane_rmse), disk.points));
  }
  return source_text(file, language);
}

}  // namespace penumbra::parameters
