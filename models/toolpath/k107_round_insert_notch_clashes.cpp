#include "models/toolpath/k107_round_insert_notch_clashes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "models/math/trig_degrees.h"

namespace verstat::models::k107 {
namespace {

// Rounding of the ends of the open intervals: they must pass when used as feed or depth.
constexpr double clash_allowance_deg = 1e-9;

double trail_rad(double radius_mm, double feed_mm_rev) {
  return std::asin(feed_mm_rev / (2 * radius_mm));
}
// arccos((r - t)/r), without cancellation at small depths.
double lead_rad(double radius_mm, double depth_mm) {
  return 2 * std::asin(std::sqrt(depth_mm / (2 * radius_mm)));
}

double feed_of(double radius_mm, double slope_deg) {
  return 2 * radius_mm * sin_deg(slope_deg);
}
// r (1 - cos(omega)) without cancellation.
double depth_of(double radius_mm, double slope_deg) {
  const double half = sin_deg(slope_deg / 2);
  return slope_deg == 90 ? radius_mm : 2 * radius_mm * half * half;
}

double guard_deg(double radius_mm, double half_width_mm) {
  return to_degrees(half_width_mm / radius_mm);
}

using Interval = std::pair<double, double>;

// (C1) for either quantity; `of` turns a slope into a feed or a depth.
template <class Of>
Interval interval(double radius_mm, double slope_deg, double half_width_mm, Of of) {
  const double guard = guard_deg(radius_mm, half_width_mm);
  return {of(radius_mm, std::clamp(slope_deg - guard, 0.0, 90.0)),
          of(radius_mm, std::clamp(slope_deg + guard, 0.0, 90.0))};
}

// Largest value not above `wanted` outside every open interval. Taking the intervals from the top down, one
// pass finds what repeating until nothing changes would.
template <class Of>
double largest_allowed(double wanted, double radius_mm, const std::vector<double>& slopes_deg,
                       double half_width_mm, Of of) {
  std::vector<Interval> forbidden;
  forbidden.reserve(slopes_deg.size());
  for (const double slope : slopes_deg) forbidden.push_back(interval(radius_mm, slope, half_width_mm, of));
  std::sort(forbidden.begin(), forbidden.end(),
            [](const Interval& a, const Interval& b) { return a.second > b.second; });
  double x = wanted;
  for (const auto& [low, high] : forbidden)
    if (low < x && x < high) x = low;
  return std::max(0.0, x);
}

void check_width(double half_width_mm, double radius_mm) {
  require(half_width_mm < radius_mm, "w", half_width_mm, "must be below r");
}
void check_feed(double feed_mm_rev, double radius_mm) {
  require(feed_mm_rev < 2 * radius_mm, "s", feed_mm_rev, "must be below 2 r");
}
void check_depth(double depth_mm, double radius_mm) {
  require(depth_mm <= radius_mm, "t", depth_mm, "must not be above r");
}

}  // namespace

NotchAngles notch_angles(const Engagement& in) {
  return guarded<&notch_angles>(in, [&] {
    check_feed(in.feed_mm_rev, in.radius_mm);
    check_depth(in.depth_mm, in.radius_mm);
    return NotchAngles{to_degrees(trail_rad(in.radius_mm, in.feed_mm_rev)),
                       to_degrees(lead_rad(in.radius_mm, in.depth_mm))};
  });
}

ForbiddenFeed forbidden_feed(const EntrySlope& in) {
  return guarded<&forbidden_feed>(in, [&] { return ForbiddenFeed{feed_of(in.radius_mm, in.slope_deg)}; });
}

ForbiddenDepth forbidden_depth(const ExitSlope& in) {
  return guarded<&forbidden_depth>(in, [&] { return ForbiddenDepth{depth_of(in.radius_mm, in.slope_deg)}; });
}

FeedInterval forbidden_feed_interval(const EntryBand& in) {
  return guarded<&forbidden_feed_interval>(in, [&] {
    check_width(in.half_width_mm, in.radius_mm);
    const auto [low, high] = interval(in.radius_mm, in.slope_deg, in.half_width_mm, feed_of);
    return FeedInterval{low, high};
  });
}

DepthInterval forbidden_depth_interval(const ExitBand& in) {
  return guarded<&forbidden_depth_interval>(in, [&] {
    check_width(in.half_width_mm, in.radius_mm);
    const auto [low, high] = interval(in.radius_mm, in.slope_deg, in.half_width_mm, depth_of);
    return DepthInterval{low, high};
  });
}

AllowedFeed allowed_feed(const WantedFeed& in) {
  return guarded<&allowed_feed>(in, [&] {
    check_width(in.half_width_mm, in.radius_mm);
    return AllowedFeed{
        largest_allowed(in.feed_mm_rev, in.radius_mm, in.slopes_deg, in.half_width_mm, feed_of)};
  });
}

AllowedDepth allowed_depth(const WantedDepth& in) {
  return guarded<&allowed_depth>(in, [&] {
    check_width(in.half_width_mm, in.radius_mm);
    return AllowedDepth{
        largest_allowed(in.depth_mm, in.radius_mm, in.slopes_deg, in.half_width_mm, depth_of)};
  });
}

ProfileClashes profile_clashes(const Profile& in) {
  return guarded<&profile_clashes>(in, [&] {
    check_feed(in.feed_mm_rev, in.radius_mm);
    check_depth(in.depth_mm, in.radius_mm);
    check_width(in.half_width_mm, in.radius_mm);
    const double lead = to_degrees(lead_rad(in.radius_mm, in.depth_mm));
    const double trail = to_degrees(trail_rad(in.radius_mm, in.feed_mm_rev));
    const double guard = guard_deg(in.radius_mm, in.half_width_mm);
    const std::size_t n = in.slopes_deg.size();
    ProfileClashes out{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = in.persistent ? 0 : i + 1; k < n; ++k) {
        if (k == i) continue;
        const auto test = [&](double notch_deg, NotchZone zone) {
          const double distance = std::abs(in.slopes_deg[k] - notch_deg);
          out.margin_deg = std::min(out.margin_deg, distance - guard);
          if (distance < guard - clash_allowance_deg)
            out.clashes.push_back({static_cast<std::int64_t>(i), static_cast<std::int64_t>(k), zone});
        };
        test(in.slopes_deg[i] + lead, NotchZone::lead);
        test(in.slopes_deg[i] - trail, NotchZone::trail);
      }
    }
    return out;
  });
}

EdgeLength active_edge_length(const Engagement& in) {
  return guarded<&active_edge_length>(in, [&] {
    check_feed(in.feed_mm_rev, in.radius_mm);
    check_depth(in.depth_mm, in.radius_mm);
    return EdgeLength{in.radius_mm *
                      (lead_rad(in.radius_mm, in.depth_mm) + trail_rad(in.radius_mm, in.feed_mm_rev))};
  });
}

Scallop scallop_height(const ScallopInputs& in) {
  return guarded<&scallop_height>(in, [&] {
    check_feed(in.feed_mm_rev, in.radius_mm);
    const double half = in.feed_mm_rev / 2;
    const double r = in.radius_mm;
    return Scallop{1000 * half * half / (r + std::sqrt((r - half) * (r + half)))};
  });
}

ConcaveFit concave_radius_ok(const ConcaveRadius& in) {
  return guarded<&concave_radius_ok>(in,
                                     [&] { return ConcaveFit{in.least_concave_radius_mm > in.radius_mm}; });
}

InsertSize insert_rnun_070300(const NoInputs& in) {
  return guarded<&insert_rnun_070300>(in, [] { return InsertSize{7, 3.18, 3.5}; });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K107",
       .title = "The choice of process parameters for turning complex profiles with round CBN inserts "
                "depending on wear",
       .authors = "Manovytsky O. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "A round insert wears notches at both ends of its contact arc. On a shaped part the point "
                 "of the edge that forms the surface moves with the slope and may land on a notch: feeds and "
                 "depths that a list of slopes forbids, and which segments of a profile clash.",
       .role = "toolpath",
       .errata = {"Eqs. (2) and (4) are printed with the subscript of the entry slope; the sentence before "
                  "them and the geometry ask for the exit slope."}});

  const Range insert_radius = closed(2, 16);
  const char* half_width = "half-width of the notch zone along the edge, below r";
  source
      .function<&notch_angles>("notch_angles", "Angles from the tip to the two notches.",
                               "eqs. (1), (2) read backwards", Provenance::paper)
      .input(&Engagement::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&Engagement::feed_mm_rev, "s", "S", "mm/rev", positive(), "feed along the generatrix, below 2 r",
             0.3)
      .input(&Engagement::depth_mm, "t", "t", "mm", positive(), "depth normal to the generatrix, at most r",
             0.2)
      .output(&NotchAngles::trail_deg, "theta_trail", "theta_trail", "deg", closed(0, 90),
              "angle of the trailing notch")
      .output(&NotchAngles::lead_deg, "theta_lead", "theta_lead", "deg", closed(0, 90),
              "angle of the leading notch");
  source
      .function<&forbidden_feed>("forbidden_feed", "Feed that a descending slope forbids.", "eq. (3)",
                                 Provenance::paper)
      .input(&EntrySlope::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&EntrySlope::slope_deg, "omega_in", "omega_in", "deg", closed(0, 90), "descending slope", 2.5)
      .output(&ForbiddenFeed::feed_mm_rev, "s_forbidden", "S", "mm/rev", non_negative(), "forbidden feed");
  source
      .function<&forbidden_depth>("forbidden_depth", "Depth that an ascending slope forbids.", "eq. (4)",
                                  Provenance::repaired)
      .input(&ExitSlope::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&ExitSlope::slope_deg, "omega_out", "omega_out", "deg", closed(0, 90), "ascending slope", 20.0)
      .output(&ForbiddenDepth::depth_mm, "t_forbidden", "t", "mm", non_negative(), "forbidden depth");
  source
      .function<&forbidden_feed_interval>("forbidden_feed_interval",
                                          "Open interval of feeds that a descending slope forbids.",
                                          "eq. (C1)", Provenance::completion)
      .input(&EntryBand::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&EntryBand::slope_deg, "omega_in", "omega_in", "deg", closed(0, 90), "descending slope", 2.5)
      .optional(&EntryBand::half_width_mm, "w", "w", "mm", non_negative(), half_width)
      .output(&FeedInterval::low_mm_rev, "s_low", "S_low", "mm/rev", non_negative(), "lower end")
      .output(&FeedInterval::high_mm_rev, "s_high", "S_high", "mm/rev", non_negative(), "upper end")
      .note("Notch widths are not published: measure w on worn inserts.");
  source
      .function<&forbidden_depth_interval>("forbidden_depth_interval",
                                           "Open interval of depths that an ascending slope forbids.",
                                           "eq. (C1)", Provenance::completion)
      .input(&ExitBand::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&ExitBand::slope_deg, "omega_out", "omega_out", "deg", closed(0, 90), "ascending slope", 20.0)
      .optional(&ExitBand::half_width_mm, "w", "w", "mm", non_negative(), half_width)
      .output(&DepthInterval::low_mm, "t_low", "t_low", "mm", non_negative(), "lower end")
      .output(&DepthInterval::high_mm, "t_high", "t_high", "mm", non_negative(), "upper end");
  source
      .function<&allowed_feed>("allowed_feed", "Largest feed outside every forbidden interval.", "eq. (C1)",
                               Provenance::completion)
      .input(&WantedFeed::feed_mm_rev, "s_wanted", "S", "mm/rev", non_negative(), "wanted feed", 0.3)
      .input(&WantedFeed::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&WantedFeed::slopes_deg, "omegas_in", "omega_in", "deg", open_low(0, 90),
             "descending slopes; may be empty", Value::List{2.5})
      .optional(&WantedFeed::half_width_mm, "w", "w", "mm", non_negative(), half_width)
      .output(&AllowedFeed::feed_mm_rev, "s", "S", "mm/rev", non_negative(), "allowed feed; 0 when none");
  source
      .function<&allowed_depth>("allowed_depth", "Largest depth outside every forbidden interval.",
                                "eq. (C1)", Provenance::completion)
      .input(&WantedDepth::depth_mm, "t_wanted", "t", "mm", non_negative(), "wanted depth", 0.21)
      .input(&WantedDepth::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&WantedDepth::slopes_deg, "omegas_out", "omega_out", "deg", open_low(0, 90),
             "ascending slopes; may be empty", Value::List{20.0})
      .optional(&WantedDepth::half_width_mm, "w", "w", "mm", non_negative(), half_width)
      .output(&AllowedDepth::depth_mm, "t", "t", "mm", non_negative(), "allowed depth; 0 when none");
  source
      .function<&profile_clashes>("profile_clashes", "Segments of a profile whose tip lands on a notch.",
                                  "eq. (C2)", Provenance::completion)
      .input(&Profile::slopes_deg, "slopes", "alpha_k", "deg", open(-90, 90),
             "slopes of the straight segments in order of machining, ascending positive",
             Value::List{0.0, -2.5, 0.0, 20.0, 0.0})
      .length(2, 2000)
      .input(&Profile::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&Profile::feed_mm_rev, "s", "S", "mm/rev", positive(), "feed along the generatrix, below 2 r",
             0.3)
      .input(&Profile::depth_mm, "t", "t", "mm", positive(), "depth normal to the generatrix, at most r", 0.2)
      .optional(&Profile::half_width_mm, "w", "w", "mm", non_negative(), half_width)
      .optional(&Profile::persistent, "persistent", "-", "-", no_range(),
                "the edge has already cut whole parts: every pair is tested both ways")
      .output(&ProfileClashes::clashes, "clashes", "-", "-", no_range(),
              "marking segment, clashing segment (from zero), notch")
      .output(&ProfileClashes::margin_deg, "margin", "-", "deg", any(),
              "smallest distance of tip and notch less the guard; negative = clash")
      .note(
          "For feeds below about 2 w the trailing notch lies within w of the tip and every pair of equal "
          "slopes clashes: the limit of the guard's sense.")
      .note("Only straight segments are tested; on a curve the tip passes the notch for a moment.");
  source
      .function<&active_edge_length>("active_edge_length", "Length of the edge in contact.", "eq. (C3)",
                                     Provenance::completion)
      .input(&Engagement::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&Engagement::feed_mm_rev, "s", "S", "mm/rev", positive(), "feed along the generatrix, below 2 r",
             0.3)
      .input(&Engagement::depth_mm, "t", "t", "mm", positive(), "depth normal to the generatrix, at most r",
             0.2)
      .output(&EdgeLength::length_mm, "b", "b", "mm", non_negative(), "active edge length");
  source
      .function<&scallop_height>("scallop_height", "Theoretical height of the ridges.", "eq. (C4)",
                                 Provenance::completion)
      .input(&ScallopInputs::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&ScallopInputs::feed_mm_rev, "s", "S", "mm/rev", positive(),
             "feed along the generatrix, below 2 r", 0.3)
      .output(&Scallop::height_um, "r_th", "R_th", "um", non_negative(), "ridge height");
  source
      .function<&concave_radius_ok>("concave_radius_ok",
                                    "Whether the insert fits the hollows of the profile.", "text",
                                    Provenance::paper)
      .input(&ConcaveRadius::radius_mm, "r", "r", "mm", insert_radius, "insert radius", 3.5)
      .input(&ConcaveRadius::least_concave_radius_mm, "rho_min", "rho_min", "mm", positive(),
             "smallest concave radius of the profile", 5.0)
      .output(&ConcaveFit::ok, "ok", "-", "-", no_range(), "rho_min is above r");
  source
      .function<&insert_rnun_070300>("insert_rnun_070300", "Dimensions of the insert RNUN 070300.", "text",
                                     Provenance::paper)
      .output(&InsertSize::diameter_mm, "diameter", "d", "mm", positive(), "diameter")
      .output(&InsertSize::thickness_mm, "thickness", "s", "mm", positive(), "thickness")
      .output(&InsertSize::radius_mm, "r", "r", "mm", positive(), "radius");
}

}  // namespace verstat::models::k107
