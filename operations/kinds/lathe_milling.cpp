#include "operations/kinds/lathe_milling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::LatheMilling> {
  static std::vector<Field> fields() {
    using S = operations::LatheMilling;
    return {
        may<S>(&S::shape, "shape", "-", no_range(), "closed polygon or separate flats"),
        may<S>(&S::faces, "faces", "1", closed(1, 1000), "faces of the polygon (3 or more), or flats"),
        need<S>(&S::apothem_mm, "apothem_mm", "mm", open_low(0, 1e4), "distance of a face from the axis"),
        need<S>(&S::blank_diameter_mm, "blank_diameter_mm", "mm", open_low(0, 1e4),
                "diameter of the round blank"),
        need<S>(&S::axial_length_mm, "axial_length_mm", "mm", open_low(0, 1e4), "length along the part axis"),
        need<S>(&S::axial_depth_mm, "axial_depth_mm", "mm", open_low(0, 1e3), "axial depth of a pass a_p"),
        may<S>(&S::width_of_cut_mm, "width_of_cut_mm", "mm", open_low(0, 1e3),
               "flats: radial depth of a layer; the whole depth when not given"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1e4), "approach of every axial pass"),
        need<S>(&S::tool_diameter_mm, "tool_diameter_mm", "mm", open_low(0, 1e3), "cutter diameter"),
        may<S>(&S::teeth, "teeth", "1", closed(1, 100), "number of teeth"),
        may<S>(&S::helix_deg, "helix_deg", "deg", closed(0, 60), "helix angle"),
        need<S>(&S::tool_speed_rpm, "tool_speed_rpm", "rpm", open_low(0, 1e5), "cutter speed"),
        may<S>(&S::mode, "mode", "-", no_range(), "down (climb) or up milling"),
        need<S>(&S::kc11_mpa, "kc11_mpa", "MPa", open_low(0, 1e5),
                "specific cutting force at 1 mm chip thickness"),
        may<S>(&S::mc, "mc", "1", closed(0, 0.9), "exponent of the specific cutting force"),
        need<S>(&S::force_limit_n, "force_limit_n", "N", open_low(0, 1e6), "allowed peak tangential force"),
        may<S>(&S::feed, "feed", "-", no_range(), "constant, or stabilised by force"),
        may<S>(&S::feed_min_mm_min, "feed_min_mm_min", "mm/min", open_low(0, 1e5), "smallest contour feed"),
        need<S>(&S::feed_max_mm_min, "feed_max_mm_min", "mm/min", open_low(0, 1e5), "largest contour feed"),
        need<S>(&S::x_rate_max_mm_min, "x_rate_max_mm_min", "mm/min", open_low(0, 1e6),
                "largest feed of the X axis"),
        need<S>(&S::c_rate_max_deg_min, "c_rate_max_deg_min", "deg/min", open_low(0, 1e7),
                "largest speed of the C axis"),
        may<S>(&S::block_time_ms, "block_time_ms", "ms", open_low(0, 1e4),
               "time that the control needs for a block"),
        may<S>(&S::block_length_mm, "block_length_mm", "mm", open_low(0, 1e3),
               "length of the blocks of the program"),
        may<S>(&S::chord_tolerance_mm, "chord_tolerance_mm", "mm", open_low(0, 10),
               "tolerance that decides the length of the blocks when that is not given")};
  }
};

namespace verstat::operations {

namespace k301 = models::k301;
namespace s4 = models::s4;

namespace {

constexpr double pi = std::numbers::pi;

// Number of passes of this depth; a hair more than a whole number is no further pass.
double passes_of(double length_mm, double depth_mm) {
  return std::ceil(length_mm / depth_mm - 1e-9);
}

void check(const LatheMilling& spec) {
  const double blank_radius_mm = spec.blank_diameter_mm / 2;
  models::require(spec.apothem_mm < blank_radius_mm, "apothem_mm", spec.apothem_mm,
                  "must be below the blank radius: otherwise nothing is cut");
  models::require(spec.feed_min_mm_min <= spec.feed_max_mm_min, "feed_min_mm_min", spec.feed_min_mm_min,
                  "must not exceed feed_max_mm_min");
  const bool has_length = spec.block_length_mm || spec.chord_tolerance_mm;
  if (spec.block_time_ms.has_value() != has_length)
    models::reject(
        "the feed limit of the control needs block_time_ms and one of block_length_mm, chord_tolerance_mm");
  if (spec.shape == LatheShape::polygon) {
    models::require(spec.faces >= 3, "faces", spec.faces, "a polygon has 3 faces or more");
    models::require(blank_radius_mm <= spec.apothem_mm + spec.tool_diameter_mm, "blank_diameter_mm",
                    spec.blank_diameter_mm,
                    "must not exceed 2 (apothem + tool diameter): an outer ring would be left standing");
    models::require(!spec.width_of_cut_mm, "width_of_cut_mm", spec.width_of_cut_mm.value_or(0),
                    "belongs to shape \"flats\"; a polygon is milled to depth in one turn");
    return;
  }
  if (spec.feed == k301::FeedStrategy::stabilized)
    models::reject("feed = \"stabilized\" belongs to shape \"polygon\"");
  models::require(spec.width_of_cut_mm.value_or(0) <= spec.tool_diameter_mm, "width_of_cut_mm",
                  spec.width_of_cut_mm.value_or(0), "must not exceed the tool diameter");
}

struct BlockLimit {
  double length_mm;
  double feed_mm_min;
};

// A block linear in X and C is an arc about the part axis where the cutter is nearest: there it leaves the
// line of the face by the sagitta of its length, the most of all places.
std::optional<BlockLimit> block_limit(const LatheMilling& spec) {
  if (!spec.block_time_ms) return std::nullopt;
  const double nearest_mm = spec.apothem_mm + spec.tool_diameter_mm / 2;
  const double length_mm =
      spec.block_length_mm
          ? *spec.block_length_mm
          : s4::block_length_for_tolerance({nearest_mm, *spec.chord_tolerance_mm}).block_length_mm;
  return BlockLimit{length_mm, s4::block_feed_limit({length_mm, *spec.block_time_ms}).max_feed_mm_min};
}

struct Milled {
  double time_min;
  double feed_low_mm_min, feed_high_mm_min;
  double peak_force_n;
};

Milled mill_polygon(const LatheMilling& spec, double feed_min, double feed_max, k301::FeedStrategy feed) {
  k301::PolygonPass pass;
  pass.faces = spec.faces;
  pass.apothem_mm = spec.apothem_mm;
  pass.cutter_radius_mm = spec.tool_diameter_mm / 2;
  pass.blank_radius_mm = spec.blank_diameter_mm / 2;
  pass.axial_depth_mm = std::min(spec.axial_depth_mm, spec.axial_length_mm);
  pass.teeth = spec.teeth;
  pass.helix_deg = spec.helix_deg;
  pass.rpm = spec.tool_speed_rpm;
  pass.kc11_mpa = spec.kc11_mpa;
  pass.mc = spec.mc;
  pass.force_limit_n = spec.force_limit_n;
  pass.feed_min_mm_min = feed_min;
  pass.feed_max_mm_min = feed_max;
  pass.x_rate_max_mm_min = spec.x_rate_max_mm_min;
  pass.c_rate_max_deg_min = spec.c_rate_max_deg_min;
  pass.strategy = feed;
  const double passes = passes_of(spec.axial_length_mm, spec.axial_depth_mm);
  models::require(passes <= 1e6, "axial_depth_mm", spec.axial_depth_mm,
                  "is too small: more than a million passes");
  pass.axial_passes = static_cast<std::int64_t>(passes);
  pass.approach_mm = spec.approach_mm;
  const k301::PolygonTime t = k301::polygon_milling_time(pass);
  return {t.main_time_min, t.feed_low_mm_min, t.feed_high_mm_min, t.peak_force_high_n};
}

Milled mill_flats(const LatheMilling& spec, double feed_min, double feed_max) {
  const double radius_mm = spec.tool_diameter_mm / 2;
  const double depth_mm = spec.blank_diameter_mm / 2 - spec.apothem_mm;
  const double width_mm = std::min(spec.width_of_cut_mm.value_or(depth_mm), depth_mm);
  models::require(width_mm <= spec.tool_diameter_mm, "width_of_cut_mm", width_mm,
                  "the layer must not exceed the tool diameter");

  k301::ToothLoadCut cut;  // the layer at its full width
  cut.exit_angle_deg = std::acos(std::max(-1.0, 1 - width_mm / radius_mm)) * 180 / pi;
  cut.feed_per_tooth_mm = 1;
  cut.axial_depth_mm = std::min(spec.axial_depth_mm, spec.axial_length_mm);
  cut.cutter_radius_mm = radius_mm;
  cut.teeth = spec.teeth;
  cut.helix_deg = spec.helix_deg;
  cut.kc11_mpa = spec.kc11_mpa;
  cut.mc = spec.mc;
  const double at_one_mm_n = k301::peak_milling_force(cut).peak_force_n;
  const double teeth_per_min = spec.tool_speed_rpm * static_cast<double>(spec.teeth);
  const double by_force = teeth_per_min * std::pow(spec.force_limit_n / at_one_mm_n, 1 / (1 - spec.mc));
  const double nearest_mm = spec.apothem_mm + radius_mm;
  // Fastest turn in the middle of the flat, fastest X at its ends.
  const double edge_sine = std::sqrt(1 - std::pow(nearest_mm / (spec.blank_diameter_mm / 2 + radius_mm), 2));
  const double feed_mm_min =
      std::min({std::max(std::min(by_force, feed_max), feed_min), spec.x_rate_max_mm_min / edge_sine,
                spec.c_rate_max_deg_min * pi / 180 * nearest_mm});

  s4::FlatPass pass;
  pass.blank_radius_mm = spec.blank_diameter_mm / 2;
  pass.depth_mm = depth_mm;
  pass.width_of_cut_mm = width_mm;
  pass.flat_axial_length_mm = spec.axial_length_mm;
  pass.axial_depth_mm = spec.axial_depth_mm;
  pass.tool_radius_mm = radius_mm;
  pass.surface_feed_mm_min = feed_mm_min;
  const s4::FlatTime t = s4::flat_milling_time(pass);
  const double approaches = static_cast<double>(t.layers * t.axial_passes) * spec.approach_mm / feed_mm_min;
  return {static_cast<double>(spec.faces) * (t.time_min + approaches), feed_mm_min, feed_mm_min,
          at_one_mm_n * std::pow(feed_mm_min / teeth_per_min, 1 - spec.mc)};
}

}  // namespace

CutPlan plan(const LatheMilling& spec, const PlanContext& context) {
  check(spec);
  const bool polygon = spec.shape == LatheShape::polygon;
  const std::optional<BlockLimit> block = block_limit(spec);
  const double feed_max = block ? std::min(spec.feed_max_mm_min, block->feed_mm_min) : spec.feed_max_mm_min;
  const double feed_min = std::min(spec.feed_min_mm_min, feed_max);
  const Milled milled =
      polygon ? mill_polygon(spec, feed_min, feed_max, spec.feed) : mill_flats(spec, feed_min, feed_max);

  s4::FlatCut face;
  face.blank_radius_mm = spec.blank_diameter_mm / 2;
  face.depth_mm = face.blank_radius_mm - spec.apothem_mm;
  face.tool_radius_mm = spec.tool_diameter_mm / 2;
  face.tool_speed_rpm = spec.tool_speed_rpm;
  face.surface_feed_mm_min = milled.feed_high_mm_min;
  face.mode = spec.mode;
  const s4::FlatSpeeds speeds = s4::flat_milling_speeds(face);
  const double speed_m_min =
      std::max({speeds.entry_speed_m_min, speeds.middle_speed_m_min, speeds.exit_speed_m_min});
  const double feed_per_tooth_mm =
      milled.feed_high_mm_min / (spec.tool_speed_rpm * static_cast<double>(spec.teeth));
  const s4::FinishingRule finishing =
      s4::finishing_rule({speed_m_min, spec.axial_depth_mm / feed_per_tooth_mm, 0.2});

  const char* time_origin = polygon ? "K301.polygon_milling_time" : "S4.flat_milling_time";
  const char* force_origin = polygon ? "K301.polygon_milling_time" : "K301.peak_milling_force";
  CutPlan p;
  p.quantities.reserve(16);
  p.set_main_time(milled.time_min, time_origin);
  p.quantities.push_back({"feed_low_mm_min", milled.feed_low_mm_min, "mm/min", force_origin,
                          "smallest contour feed of the cutter centre"});
  p.quantities.push_back({"feed_high_mm_min", milled.feed_high_mm_min, "mm/min", force_origin,
                          "largest contour feed of the cutter centre"});
  p.quantities.push_back(
      {"feed_per_tooth_mm", feed_per_tooth_mm, "mm", "definition", "feed per tooth at the largest feed"});
  p.quantities.push_back(
      {"peak_force_n", milled.peak_force_n, "N", force_origin, "largest tangential force"});
  if (block) {
    p.quantities.push_back({"block_length_mm", block->length_mm, "mm",
                            spec.block_length_mm ? "given" : "S4.block_length_for_tolerance",
                            "length of a block"});
    p.quantities.push_back({"block_feed_limit_mm_min", block->feed_mm_min, "mm/min", "S4.block_feed_limit",
                            "feed at which the control keeps up; larger feeds are lowered to it"});
  }
  p.quantities.push_back({"entry_speed_m_min", speeds.entry_speed_m_min, "m/min", "S4.flat_milling_speeds",
                          "resultant cutting speed at the start of a face"});
  p.quantities.push_back({"middle_speed_m_min", speeds.middle_speed_m_min, "m/min", "S4.flat_milling_speeds",
                          "resultant cutting speed in the middle of a face"});
  p.quantities.push_back({"exit_speed_m_min", speeds.exit_speed_m_min, "m/min", "S4.flat_milling_speeds",
                          "resultant cutting speed at the end of a face"});
  p.quantities.push_back({"finishing_rule_applies", finishing.applies ? 1.0 : 0.0, "1", "S4.finishing_rule",
                          "1 where high speed promises Ra 1.6 to 3.2 um without grinding"});

  p.spindle.teeth = spec.teeth;
  MachineLoad load;
  load.spindle_speed_rpm = spec.tool_speed_rpm;
  load.feed_rate_mm_min = milled.feed_high_mm_min;
  load.torque_nm = milled.peak_force_n * spec.tool_diameter_mm / 2000;
  load.power_kw = milled.peak_force_n * speed_m_min / 60'000;
  p.quantities.push_back({"torque_nm", *load.torque_nm, "N m", force_origin, "peak torque at the cutter"});
  p.quantities.push_back(
      {"cutting_power_kw", *load.power_kw, "kW", "COMPLETION: peak force times speed", "peak cutting power"});
  p.limits.push_back({"peak_force_n", milled.peak_force_n,
                      // The feed law meets the limit to rounding: a hair above it is met.
                      spec.force_limit_n * (1 + 1e-9), true, "N", force_origin});
  add_machine_limits(p, context, load);
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, speed_m_min, feed_per_tooth_mm, spec.axial_depth_mm);
  return p;
}

namespace lathe_milling {
void add_to(Kinds& kinds) {
  kinds.add<LatheMilling>("Flats and polygons milled on a turning centre.", {"S4", "K301"});
}
}  // namespace lathe_milling

}  // namespace verstat::operations
