#include "models/gears/k304_disc_cutter_roughing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace verstat::models::k304 {
namespace {

using std::numbers::pi;

constexpr double rad_per_deg = pi / 180;
constexpr double diameter_of_paper_mm = 285;
constexpr double paired_feed_factor = 0.8;

// Table 2: steels 45, 40Kh, ATs40Kh; insert VK10-KhOM; D 285; T 6 h.
struct RegimeRow {
  double module_mm;
  double rpm[2];  // HB 167-217, HB 240
  double feed_mm_min[2];
};
constexpr std::array<RegimeRow, 3> regimes{{
    {8, {110, 100}, {120, 110}},
    {10, {110, 90}, {120, 100}},
    {12, {90, 80}, {100, 90}},
}};
constexpr double speed_printed_m_min[2] = {120, 100};  // printed once per block
constexpr double hardness_first_column_hb = 217;

double speed_m_min(double diameter_mm, double rpm) {
  return pi * diameter_mm * rpm / 1000;
}

std::int64_t whole_strokes(std::int64_t gaps, std::int64_t cutters) {
  return gaps / cutters + (gaps % cutters != 0 ? 1 : 0);
}

GapSection gap_section(const GapShape& in) {
  const double alpha = in.pressure_angle_deg * rad_per_deg;
  const double pitch_mm = pi * in.module_mm / 2 - in.allowance_mm;
  const double bottom_mm = pitch_mm - 2 * (in.depth_mm - in.module_mm) * std::tan(alpha);
  require(bottom_mm > 0, "depth_mm", in.depth_mm, "leaves no width at the bottom of the gap");
  const double top_mm = pitch_mm + 2 * in.module_mm * std::tan(alpha);
  const double flank_mm = in.depth_mm / std::cos(alpha);
  return {bottom_mm, top_mm, flank_mm, in.depth_mm * (bottom_mm + top_mm) / 2, bottom_mm + 2 * flank_mm};
}

// One insert position of the split scheme, ready for the sum.
struct Position {
  double lag_rad;   // behind the first position
  double exit_rad;  // angle from the lowest point at which it leaves the part
  double factor_n;  // force = factor * sin(angle)^(1 - mc)
  double arm_m;
};

std::vector<Position> positions_of(const SplitCut& in) {
  const std::size_t count = in.widths_mm.size();
  const auto as_many = [&](const std::vector<double>& list, std::string_view name) {
    if (list.size() != count)
      throw DomainError(
          std::string(name),
          fmt::format("{} has {} entries, must have as many as widths_mm, {}", name, list.size(), count));
  };
  as_many(in.lead_angles_deg, "lead_angles_deg");
  as_many(in.radial_offsets_mm, "radial_offsets_mm");
  const double radius_mm = in.diameter_mm / 2;
  require(in.depth_mm < radius_mm, "depth_mm", in.depth_mm, "must be below half of diameter_mm");
  const double exponent = 1 - in.mc;
  const double feed_mm = in.feed_mm_min / (in.rpm * static_cast<double>(in.groups));
  const double pitch = 2 * pi / (static_cast<double>(count) * static_cast<double>(in.groups));
  std::vector<Position> positions;
  for (std::size_t k = 0; k < count; ++k) {
    const double offset_mm = in.radial_offsets_mm[k];
    if (!(offset_mm < in.depth_mm))
      require(false, fmt::format("radial_offsets_mm/{}", k), offset_mm, "must be below depth_mm");
    const double sine = std::sin(in.lead_angles_deg[k] * rad_per_deg);
    positions.push_back({pitch * static_cast<double>(k),
                         std::acos((radius_mm - in.depth_mm) / (radius_mm - offset_mm)),
                         in.kc11_mpa * in.widths_mm[k] / sine * std::pow(feed_mm * sine, exponent),
                         (radius_mm - offset_mm) / 1000});
  }
  return positions;
}

// Force and moment at `midpoints` instants of the period between two groups. Positions lag by shares of the
// period, so that most of them meet the same angles: sin^p is tabled once for every offset from the grid.
class Instants {
 public:
  static constexpr int midpoints = 7200;
  Instants(double period_rad, double exponent)
      : step_(period_rad / midpoints),
        exponent_(exponent),
        force_n_(midpoints),
        moment_n_m_(midpoints),
        inserts_(midpoints) {}

  // A position that is at angle 0 when the cutter has turned by `lag_rad`.
  void add(const Position& p, double lag_rad) {
    // Angle at instant i: step (i + 0.5 - lag / step), brought into one period.
    double shift = -lag_rad / step_;
    shift -= midpoints * std::floor(shift / midpoints);
    double whole = std::floor(shift);
    double rest = shift - whole;
    if (rest > 1 - same) {
      whole += 1;
      rest = 0;
    }
    const std::vector<double>& powers = powers_up_to(p.exit_rad, rest < same ? 0 : rest);
    // Instants before the one at which the angle starts again.
    const auto first = static_cast<std::size_t>(whole) % midpoints;
    for (std::size_t j = 0; j < powers.size(); ++j) {
      if (!(angle(j, rest) <= p.exit_rad)) break;
      const std::size_t i = (j + midpoints - first) % midpoints;
      const double force_n = p.factor_n * powers[j];
      force_n_[i] += force_n;
      moment_n_m_[i] += force_n * p.arm_m;
      ++inserts_[i];
    }
  }
  [[nodiscard]] const std::vector<double>& force_n() const { return force_n_; }
  [[nodiscard]] const std::vector<double>& moment_n_m() const { return moment_n_m_; }
  [[nodiscard]] const std::vector<std::int64_t>& inserts() const { return inserts_; }

 private:
  static constexpr double same = 1e-9;
  struct Table {
    double rest;
    std::vector<double> powers;
  };
  [[nodiscard]] double angle(std::size_t j, double rest) const {
    return step_ * (static_cast<double>(j) + 0.5 + rest);
  }
  const std::vector<double>& powers_up_to(double exit_rad, double rest) {
    auto table = std::find_if(tables_.begin(), tables_.end(),
                              [&](const Table& t) { return std::abs(t.rest - rest) < same; });
    if (table == tables_.end()) table = tables_.insert(tables_.end(), Table{rest, {}});
    while (angle(table->powers.size(), rest) <= exit_rad)
      table->powers.push_back(
          std::pow(std::max(0.0, std::sin(angle(table->powers.size(), rest))), exponent_));
    return table->powers;
  }
  double step_, exponent_;
  std::vector<double> force_n_, moment_n_m_;
  std::vector<std::int64_t> inserts_;
  std::vector<Table> tables_;
};

}  // namespace

CutterSpeed disc_cutter_speed(const CutterRotation& in) {
  return guarded<&disc_cutter_speed>(in, [&] { return CutterSpeed{speed_m_min(in.diameter_mm, in.rpm)}; });
}

CutterRpm disc_cutter_rpm(const CutterAtSpeed& in) {
  return guarded<&disc_cutter_rpm>(
      in, [&] { return CutterRpm{1000 * in.cutting_speed_m_min / (pi * in.diameter_mm)}; });
}

CutterFeeds disc_cutter_feeds(const CutterFeed& in) {
  return guarded<&disc_cutter_feeds>(in, [&] {
    const double per_rev_mm = in.feed_mm_min / in.rpm;
    return CutterFeeds{per_rev_mm, per_rev_mm / static_cast<double>(in.teeth_in_line)};
  });
}

Regime recommended_regime(const RegimeChoice& in) {
  return guarded<&recommended_regime>(in, [&] {
    const auto row = std::find_if(regimes.begin(), regimes.end(),
                                  [&](const RegimeRow& r) { return r.module_mm == in.module_mm; });
    require(row != regimes.end(), "module_mm", in.module_mm, "must be 8, 10 or 12: the table has no other");
    const std::size_t column = in.hardness_hb <= hardness_first_column_hb ? 0 : 1;
    return Regime{row->rpm[column], row->feed_mm_min[column] * (in.paired ? paired_feed_factor : 1),
                  speed_printed_m_min[column], speed_m_min(diameter_of_paper_mm, row->rpm[column])};
  });
}

GapTime gap_time(const GapStroke& in) {
  return guarded<&gap_time>(in, [&] {
    const double working_min = in.travel_mm / in.feed_mm_min;
    const double return_min = in.travel_mm / in.return_feed_mm_min;
    return GapTime{working_min, return_min, working_min + return_min + in.indexing_min};
  });
}

RoughingTime gear_roughing_time(const GearGaps& in) {
  return guarded<&gear_roughing_time>(in, [&] {
    const std::int64_t strokes = whole_strokes(in.gaps, in.cutters);
    return RoughingTime{in.per_gap_min * static_cast<double>(in.gaps) / static_cast<double>(in.cutters),
                        strokes, in.per_gap_min * static_cast<double>(strokes)};
  });
}

LifeRange disc_cutter_life(const LifeConditions& in) {
  return guarded<&disc_cutter_life>(in, [&] {
    const double low_min = (in.coolant ? 300 : 180) * (in.coated ? 1.3 : 1);
    const double high_min = (in.coolant ? 360 : 180) * (in.coated ? 1.5 : 1);
    return LifeRange{low_min, high_min, (low_min + high_min) / 2};
  });
}

CutterTravel disc_cutter_travel(const CutterPass& in) {
  return guarded<&disc_cutter_travel>(in, [&] {
    require(in.depth_mm < in.diameter_mm, "depth_mm", in.depth_mm, "must be below diameter_mm");
    const double approach_mm = std::sqrt(in.depth_mm * (in.diameter_mm - in.depth_mm));
    return CutterTravel{approach_mm,
                        in.face_width_mm + approach_mm * (in.full_exit ? 2 : 1) + 2 * in.clearance_mm};
  });
}

Life life_at_speed(const SpeedChange& in) {
  return guarded<&life_at_speed>(in, [&] {
    return Life{in.life_ref_min * std::pow(in.speed_ref_m_min / in.speed_m_min, 1 / in.taylor_exponent)};
  });
}

InsertConsumption insert_consumption(const InsertUse& in) {
  return guarded<&insert_consumption>(in, [&] {
    const auto cutters = static_cast<double>(in.cutters);
    const double changes =
        static_cast<double>(whole_strokes(in.gaps, in.cutters)) * in.working_min / in.life_min;
    return InsertConsumption{cutters * in.life_min / in.working_min, changes,
                             changes * static_cast<double>(in.inserts_per_cutter) * cutters /
                                 static_cast<double>(in.edges_per_insert)};
  });
}

GapSection rack_gap_section(const GapShape& in) {
  return guarded<&rack_gap_section>(in, [&] { return gap_section(in); });
}

InsertLayout split_profile_inserts(const GapShape& in) {
  return guarded<&split_profile_inserts>(in, [&] {
    const GapSection gap = gap_section(in);
    const double half_bottom_mm = gap.bottom_width_mm / 2;
    const double half_flank_mm = (gap.top_width_mm - gap.bottom_width_mm) / 4;
    const double alpha = in.pressure_angle_deg;
    const double low_mm = in.depth_mm / 4, high_mm = 3 * in.depth_mm / 4;
    return InsertLayout{
        {half_bottom_mm, half_bottom_mm, half_flank_mm, half_flank_mm, half_flank_mm, half_flank_mm},
        {90, 90, alpha, alpha, alpha, alpha},
        {0, 0, low_mm, low_mm, high_mm, high_mm}};
  });
}

SplitForce split_scheme_force(const SplitCut& in) {
  return guarded<&split_scheme_force>(in, [&] {
    const std::vector<Position> positions = positions_of(in);
    const double exponent = 1 - in.mc;
    const double period = 2 * pi / static_cast<double>(in.groups);
    const double second_lead = in.second_cutter_offset_deg * rad_per_deg;
    Instants at(period, exponent);
    for (const Position& p : positions) {
      at.add(p, p.lag_rad);
      if (in.second_cutter_offset_deg >= 0) at.add(p, p.lag_rad - second_lead);
    }
    constexpr int midpoints = Instants::midpoints;
    SplitForce out{0, 0, std::numeric_limits<double>::infinity(), 0, 0, 0};
    double moment_n_m = 0;
    for (std::size_t i = 0; i < midpoints; ++i) {
      out.peak_force_n = std::max(out.peak_force_n, at.force_n()[i]);
      out.min_force_n = std::min(out.min_force_n, at.force_n()[i]);
      out.mean_force_n += at.force_n()[i];
      moment_n_m += at.moment_n_m()[i];
      out.inserts_in_contact_max = std::max(out.inserts_in_contact_max, at.inserts()[i]);
    }
    out.mean_force_n /= midpoints;
    moment_n_m /= midpoints;
    require(out.mean_force_n > 0, "depth_mm", in.depth_mm,
            "is too small: no insert is in contact at any of the 7200 instants");
    out.peak_to_mean = out.peak_force_n / out.mean_force_n;
    out.mean_power_kw = moment_n_m * in.rpm / 9549.3;
    return out;
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K304",
       .title = "Technology of rough-down of hardened gear wheels and racks by assembled disc cutters with a "
                "split scheme of cutting",
       .authors = "Mironenko E. V., Klochko A. A., Lebedinskii V. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Tooth gaps of large gears and racks (module 8-20 mm) are roughed one by one or two by two with "
           "disc cutters of 30 indexable inserts, which split the gap among six positions. Times, "
           "recommended "
           "regimes for module 8-12, tool lives; force and power of the split scheme are completions.",
       .role = "gears",
       .errata = {"Table 1: S_o is printed S_z S_f; z_f by dimension and by the next line.",
                  "Test ranges: a feed of 1.25-3.5 m/s is printed; it is the cutting speed (75-210 m/min).",
                  "Table 2: the speeds 120 and 100 m/min do not match the printed rpm at D = 285 (98.5 to "
                  "71.6 m/min); "
                  "use rpm and feed, and the speed as an upper value."}});

  const auto diameter = [](auto pointer) {
    return [pointer](auto& f) {
      f.optional(pointer, "diameter_mm", "D", "mm", positive(), "diameter of the cutter");
    };
  };
  source
      .function<&disc_cutter_speed>("disc_cutter_speed", "Cutting speed of the disc cutter.", "Table 1",
                                    Provenance::paper)
      .with(diameter(&CutterRotation::diameter_mm))
      .input(&CutterRotation::rpm, "rpm", "n", "rpm", positive(), "speed of the cutter", 110.0)
      .output(&CutterSpeed::cutting_speed_m_min, "cutting_speed_m_min", "V", "m/min", positive(),
              "cutting speed");
  source
      .function<&disc_cutter_rpm>("disc_cutter_rpm", "Speed of the disc cutter for a cutting speed.",
                                  "Table 1", Provenance::paper)
      .with(diameter(&CutterAtSpeed::diameter_mm))
      .input(&CutterAtSpeed::cutting_speed_m_min, "cutting_speed_m_min", "V", "m/min", positive(),
             "cutting speed", 120.0)
      .output(&CutterRpm::rpm, "rpm", "n", "rpm", positive(), "speed of the cutter");
  source
      .function<&disc_cutter_feeds>("disc_cutter_feeds", "Feed per revolution and per tooth.", "Table 1",
                                    Provenance::repaired)
      .input(&CutterFeed::feed_mm_min, "feed_mm_min", "S_m", "mm/min", positive(), "feed", 120.0)
      .input(&CutterFeed::rpm, "rpm", "n", "rpm", positive(), "speed of the cutter", 110.0)
      .optional(&CutterFeed::teeth_in_line, "teeth_in_line", "z_f", "1", at_least(1),
                "inserts per position (30: all inserts counted)")
      .output(&CutterFeeds::feed_mm_rev, "feed_mm_rev", "S_o", "mm/rev", positive(), "feed per revolution")
      .output(&CutterFeeds::feed_mm_tooth, "feed_mm_tooth", "S_z", "mm", positive(), "feed per tooth");
  source
      .function<&recommended_regime>("recommended_regime", "Recommended regime for roughing the gaps.",
                                     "Table 2", Provenance::paper)
      .input(&RegimeChoice::module_mm, "module_mm", "m", "mm", positive(), "module: 8, 10 or 12", 10.0)
      .input(&RegimeChoice::hardness_hb, "hardness_hb", "HB", "HB", open_low(0, 240),
             "Brinell hardness; the table ends at 240", 200.0)
      .optional(&RegimeChoice::paired, "paired", "-", "-", no_range(), "two cutters at once: feed x 0.8")
      .output(&Regime::rpm, "rpm", "n", "rpm", positive(), "speed of the cutter")
      .output(&Regime::feed_mm_min, "feed_mm_min", "S_m", "mm/min", positive(), "feed")
      .output(&Regime::speed_printed_m_min, "speed_printed_m_min", "V", "m/min", positive(),
              "cutting speed as printed, an upper value")
      .output(&Regime::speed_actual_m_min, "speed_actual_m_min", "V", "m/min", positive(),
              "cutting speed from the rpm at D = 285")
      .note("Steels 45, 40Kh, ATs40Kh; insert VK10-KhOM; stated for a tool life of 6 h.");
  source.function<&gap_time>("gap_time", "Time of one gap.", "Table 1", Provenance::paper)
      .input(&GapStroke::travel_mm, "travel_mm", "L", "mm", positive(), "travel with approach and overrun",
             360.0)
      .input(&GapStroke::feed_mm_min, "feed_mm_min", "S_m", "mm/min", positive(), "feed", 120.0)
      .input(&GapStroke::return_feed_mm_min, "return_feed_mm_min", "S_m.x", "mm/min", positive(),
             "feed of the return", 1200.0)
      .input(&GapStroke::indexing_min, "indexing_min", "T_d", "min", non_negative(),
             "indexing to the next gap", 0.5)
      .output(&GapTime::working_min, "working_min", "T_p", "min", positive(), "working stroke")
      .output(&GapTime::return_min, "return_min", "T_x", "min", positive(), "return")
      .output(&GapTime::per_gap_min, "per_gap_min", "T_oi", "min", positive(), "all of one gap");
  source
      .function<&gear_roughing_time>("gear_roughing_time", "Main time of the part.", "Table 1",
                                     Provenance::paper)
      .input(&GearGaps::per_gap_min, "per_gap_min", "T_oi", "min", positive(), "time of one gap", 4.6)
      .input(&GearGaps::gaps, "gaps", "z", "1", at_least(1), "number of gaps", 61)
      .input(&GearGaps::cutters, "cutters", "k", "1", at_least(1), "cutters at work at once", 2)
      .output(&RoughingTime::main_time_min, "main_time_min", "T_o", "min", positive(), "as printed, T_oi z/k")
      .output(&RoughingTime::strokes, "strokes", "-", "1", at_least(1), "whole strokes")
      .output(&RoughingTime::main_time_whole_strokes_min, "main_time_whole_strokes_min", "-", "min",
              positive(), "with whole strokes: use this one in the shop (completion)");
  source
      .function<&disc_cutter_life>("disc_cutter_life", "Tool life to 1 mm of flank wear.", "text",
                                   Provenance::paper)
      .optional(&LifeConditions::coolant, "coolant", "-", "-", no_range(), "with coolant")
      .optional(&LifeConditions::coated, "coated", "-", "-", no_range(), "coated inserts")
      .output(&LifeRange::life_low_min, "life_low_min", "T", "min", positive(), "lower value")
      .output(&LifeRange::life_high_min, "life_high_min", "T", "min", positive(), "upper value")
      .output(&LifeRange::life_mid_min, "life_mid_min", "T", "min", positive(), "mean of the two");
  source
      .function<&disc_cutter_travel>("disc_cutter_travel", "Approach and travel of the disc cutter.",
                                     "completion", Provenance::completion)
      .input(&CutterPass::face_width_mm, "face_width_mm", "b", "mm", positive(), "face width", 200.0)
      .input(&CutterPass::depth_mm, "depth_mm", "t", "mm", positive(), "depth of the gap, below the diameter",
             22.5)
      .with(diameter(&CutterPass::diameter_mm))
      .input(&CutterPass::clearance_mm, "clearance_mm", "c", "mm", non_negative(), "clearance on each side",
             3.0)
      .optional(&CutterPass::full_exit, "full_exit", "-", "-", no_range(),
                "the cutter leaves the part completely")
      .output(&CutterTravel::approach_mm, "approach_mm", "e", "mm", positive(), "approach")
      .output(&CutterTravel::travel_mm, "travel_mm", "L", "mm", positive(), "travel");
  source
      .function<&life_at_speed>("life_at_speed", "Tool life at another speed.", "completion (Taylor)",
                                Provenance::completion)
      .input(&SpeedChange::life_ref_min, "life_ref_min", "T_ref", "min", positive(), "known life", 360.0)
      .input(&SpeedChange::speed_ref_m_min, "speed_ref_m_min", "V_ref", "m/min", positive(), "its speed",
             98.5)
      .input(&SpeedChange::speed_m_min, "speed_m_min", "V", "m/min", positive(), "new speed", 120.0)
      .input(&SpeedChange::taylor_exponent, "taylor_exponent", "m", "1", positive(),
             "exponent in V T^m = const, usually 0.2-0.35", 0.25)
      .output(&Life::life_min, "life_min", "T", "min", non_negative(), "life at the new speed");
  source
      .function<&insert_consumption>("insert_consumption", "Insert changes and inserts per part.",
                                     "completion", Provenance::completion)
      .input(&InsertUse::life_min, "life_min", "T", "min", positive(), "tool life", 360.0)
      .input(&InsertUse::working_min, "working_min", "T_p", "min", positive(), "working time per stroke", 3.0)
      .input(&InsertUse::gaps, "gaps", "z", "1", at_least(1), "number of gaps", 60)
      .input(&InsertUse::cutters, "cutters", "k", "1", at_least(1), "cutters at work at once", 1)
      .optional(&InsertUse::inserts_per_cutter, "inserts_per_cutter", "-", "1", at_least(1),
                "inserts on one cutter")
      .input(&InsertUse::edges_per_insert, "edges_per_insert", "-", "1", at_least(1), "edges of an insert", 4)
      .output(&InsertConsumption::gaps_per_life, "gaps_per_life", "-", "1", positive(), "gaps per tool life")
      .output(&InsertConsumption::changes_per_part, "changes_per_part", "-", "1", positive(),
              "insert changes per part, long-run mean")
      .output(&InsertConsumption::inserts_per_part, "inserts_per_part", "-", "1", positive(),
              "inserts per part, long-run mean");
  const auto gap = [](auto& f) {
    f.input(&GapShape::module_mm, "module_mm", "m", "mm", positive(), "module", 10.0)
        .input(&GapShape::depth_mm, "depth_mm", "t", "mm", positive(), "depth of the gap, usually 2.25 m",
               22.5)
        .optional(&GapShape::allowance_mm, "allowance_mm", "Delta", "mm", non_negative(),
                  "left on the tooth thickness")
        .optional(&GapShape::pressure_angle_deg, "pressure_angle_deg", "alpha", "deg", open(0, 45),
                  "pressure angle");
  };
  source
      .function<&rack_gap_section>("rack_gap_section", "Section of the roughed gap.", "completion",
                                   Provenance::completion)
      .with(gap)
      .output(&GapSection::bottom_width_mm, "bottom_width_mm", "w_bottom", "mm", positive(), "bottom width")
      .output(&GapSection::top_width_mm, "top_width_mm", "w_top", "mm", positive(), "top width")
      .output(&GapSection::flank_length_mm, "flank_length_mm", "-", "mm", positive(), "length of a flank")
      .output(&GapSection::area_mm2, "area_mm2", "-", "mm2", positive(), "area")
      .output(&GapSection::profile_length_mm, "profile_length_mm", "-", "mm", positive(),
              "bottom and both flanks");
  source
      .function<&split_profile_inserts>("split_profile_inserts", "Split of the gap among six inserts.",
                                        "completion", Provenance::completion)
      .with(gap)
      .output(&InsertLayout::widths_mm, "widths_mm", "w_k", "mm", positive(),
              "widths along the cutter axis, in the order a to f")
      .output(&InsertLayout::lead_angles_deg, "lead_angles_deg", "kappa_k", "deg", open_low(0, 90),
              "lead angles")
      .output(&InsertLayout::radial_offsets_mm, "radial_offsets_mm", "o_k", "mm", non_negative(),
              "middle of the edge below the largest radius")
      .note("The paper does not say which of the flank inserts cuts lower; c and d are taken.");
  source
      .function<&split_scheme_force>("split_scheme_force", "Force and power of the split scheme.",
                                     "completion (Kienzle)", Provenance::completion)
      .input(&SplitCut::widths_mm, "widths_mm", "w_k", "mm", positive(), "widths of the positions",
             Value::List{2.904354, 2.904354, 4.094665, 4.094665, 4.094665, 4.094665})
      .length(1, 1000)
      .input(&SplitCut::lead_angles_deg, "lead_angles_deg", "kappa_k", "deg", open_low(0, 90),
             "lead angles of the positions", Value::List{90.0, 90.0, 20.0, 20.0, 20.0, 20.0})
      .length(1, 1000)
      .input(&SplitCut::radial_offsets_mm, "radial_offsets_mm", "o_k", "mm", non_negative(),
             "offsets of the positions, below the depth", Value::List{0.0, 0.0, 5.625, 5.625, 16.875, 16.875})
      .length(1, 1000)
      .optional(&SplitCut::groups, "groups", "-", "1", closed(1, 300), "groups of positions")
      .with(diameter(&SplitCut::diameter_mm))
      .input(&SplitCut::depth_mm, "depth_mm", "t", "mm", positive(), "depth, below D/2", 22.5)
      .input(&SplitCut::feed_mm_min, "feed_mm_min", "S_m", "mm/min", positive(), "feed", 120.0)
      .input(&SplitCut::rpm, "rpm", "n", "rpm", positive(), "speed of the cutter", 110.0)
      .input(&SplitCut::kc11_mpa, "kc11_mpa", "k_c1.1", "MPa", positive(),
             "specific cutting force at 1 mm chip", 1900.0)
      .input(&SplitCut::mc, "mc", "m_c", "1", open_high(0, 1), "exponent of the chip thickness", 0.25)
      .optional(&SplitCut::second_cutter_offset_deg, "second_cutter_offset_deg", "-", "deg", any(),
                "lead of a second equal cutter; negative: one cutter")
      .output(&SplitForce::peak_force_n, "peak_force_n", "-", "N", positive(), "largest force")
      .output(&SplitForce::mean_force_n, "mean_force_n", "-", "N", positive(), "mean force")
      .output(&SplitForce::min_force_n, "min_force_n", "-", "N", non_negative(), "smallest force")
      .output(&SplitForce::peak_to_mean, "peak_to_mean", "-", "1", at_least(1), "peak over mean")
      .output(&SplitForce::inserts_in_contact_max, "inserts_in_contact_max", "-", "1", at_least(1),
              "most inserts in contact at once")
      .output(&SplitForce::mean_power_kw, "mean_power_kw", "-", "kW", positive(), "mean cutting power")
      .note("Tangential forces are summed as a scalar, over 7200 midpoints of one period.");
}

}  // namespace verstat::models::k304
