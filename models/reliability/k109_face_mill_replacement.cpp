// Description of K109; its formulas stand in k109_mission, k109_chain and k109_time.cpp.
#include "models/reliability/k109_face_mill_replacement.h"

namespace verstat::models::k109 {
namespace {

template <class In>
auto teeth(std::int64_t example, double most = 40) {
  return [=](auto& f) { f.input(&In::teeth, "z", "z", "1", closed(1, most), "teeth of the mill", example); };
}
template <class In>
auto tooth(Range range) {
  return [range](auto& f) {
    f.input(&In::r_tooth, "r_tooth", "R_z", "1", range, "reliability of one tooth over the mission", 0.9);
  };
}
template <class In>
auto allowed(std::int64_t example, double most = 39) {
  return [=](auto& f) {
    f.input(&In::failed_allowed, "failed_allowed", "c", "1", closed(0, most), "failures tolerated, below z",
            example);
  };
}
template <class In>
auto sharing() {
  return [](auto& f) {
    f.optional(&In::alpha, "alpha", "alpha", "1", closed(0, 4),
               "load-sharing exponent: y/m of the Taylor law with kept table feed, 0 with feed cut in "
               "proportion");
  };
}
const auto life = [](auto& f) {
  f.input(&ToothLife::t_mean_min, "t_mean", "T", "min", positive(), "mean life of a tooth at nominal load",
          44.0)
      .optional(&ToothLife::beta, "beta", "beta", "1", closed(0.5, 5), "Weibull shape of tooth life");
};
const auto mill = [](auto& f) {
  f.output(&MillReliability::r_mill, "r_mill", "R_mill", "1", probability(), "reliability of the mill");
};
const auto tooth_out = [](auto& f) {
  f.output(&ToothReliability::r_tooth, "r_tooth", "R_z", "1", probability(), "reliability of one tooth");
};
const Range exact_tooth = open_low(0, 1);
const auto equal_note =
    "Equal sharing: the load of the failed teeth goes to all survivors. With kept table feed the tooth "
    "behind a gap takes it all: mill_reliability_local_sharing is lower for alpha > 1.";

void describe_paper(Source& source) {
  source
      .function<&mill_reliability_paper>("mill_reliability_paper",
                                         "The paper's reliability of a mill: redundancy of multiplicity m.",
                                         "eq. (0), before eq. (1)", Provenance::paper)
      .with(tooth<MillPaper>(open(0, 1)))
      .with(teeth<MillPaper>(10))
      .input(&MillPaper::m, "m", "m", "1", closed(0, 40), "multiplicity, not above z", 6)
      .with(mill)
      .note(
          "The formula of a system with m spare complete mills. It is a lower bound of the load-sharing "
          "reliability with m tolerated failures for alpha <= 2; the paper calls m the working teeth at "
          "replacement, which the formula does not compute.");
  source
      .function<&required_m_paper>("required_m_paper",
                                   "The paper's number of working teeth at which the mill is pulled.",
                                   "eq. (1)", Provenance::paper)
      .input(&MillTarget::r_mill, "r_mill", "R_mill", "1", open(0, 1), "reliability wanted", 0.95)
      .with(tooth<MillTarget>(open(0, 1)))
      .with(teeth<MillTarget>(10))
      .output(&RequiredM::m_real, "m_real", "m", "1", at_least(-1), "m before rounding")
      .output(&RequiredM::m, "m", "m", "1", at_least(0), "teeth still working at replacement, at most 1e9")
      .output(&RequiredM::replace_at_failed, "replace_at_failed", "z-m", "1", at_least(1),
              "failed teeth at which the mill is pulled")
      .output(&RequiredM::feasible, "feasible", "-", "-", no_range(), "m is at most z - 1")
      .note("Rounding up, the clamp to 1..z and feasible are COMPLETION.")
      .note("Conservative for alpha <= 1, can be unsafe above: compare with control_limit.");
  source
      .function<&required_tooth_reliability_paper>("required_tooth_reliability_paper",
                                                   "Tooth reliability that the paper's formula asks for.",
                                                   "eq. (0), inverse", Provenance::paper)
      .input(&MillTargetPaper::r_mill, "r_mill", "R_mill", "1", open(0, 1), "reliability wanted", 0.95)
      .with(teeth<MillTargetPaper>(10))
      .input(&MillTargetPaper::m, "m", "m", "1", closed(0, 40), "multiplicity, not above z", 6)
      .with(tooth_out);
  source
      .function<&property_score>("property_score", "Score of a property relative to the reference design.",
                                 "text, quality index", Provenance::paper)
      .input(&Property::value, "value", "P", "any", positive(), "property of the design", 44.0)
      .input(&Property::reference, "reference", "P_ref", "any", positive(),
             "property of the reference design", 69.0)
      .optional(&Property::higher_is_better, "higher_is_better", "-", "-", no_range(),
                "false inverts the ratio (COMPLETION)")
      .output(&Score::score, "score", "q", "1", positive(), "score");
  source
      .function<&quality_level>("quality_level", "Quality of one level of the quality tree.", "(C10)",
                                Provenance::completion)
      .input(&Scores::scores, "scores", "q_i", "1", any(), "scores of the level", Value::List{0.9, 1.1, 0.8})
      .length(1, 10'000)
      .input(&Scores::weights, "weights", "w_i", "1", non_negative(), "weights, as many as scores",
             Value::List{0.5, 0.3, 0.2})
      .length(1, 10'000)
      .output(&Quality::quality, "quality", "Q", "1", any(), "weighted mean")
      .note("The paper names a convolution with expert weights only; the arithmetic mean is the completion.");
}

void describe_mission(Source& source) {
  source
      .function<&mill_reliability_binomial>("mill_reliability_binomial",
                                            "Reliability of a mill whose teeth fail independently.", "(C1)",
                                            Provenance::completion)
      .with(tooth<MillBinomial>(exact_tooth))
      .with(teeth<MillBinomial>(10))
      .with(allowed<MillBinomial>(3))
      .with(mill);
  source
      .function<&load_factor>("load_factor", "Hazard multiplier of each surviving tooth.", "(C2)",
                              Provenance::completion)
      .with(teeth<Load>(10))
      .input(&Load::failed, "failed", "j", "1", closed(0, 39), "failed teeth, below z", 4)
      .with(sharing<Load>())
      .output(&LoadFactor::factor, "factor", "phi_j", "1", at_least(1), "load factor");
  source
      .function<&failed_teeth_pmf>("failed_teeth_pmf",
                                   "Probabilities of 0..z failed teeth at the end of a mission.", "(C3)",
                                   Provenance::completion)
      .with(tooth<MillMission>(exact_tooth))
      .with(teeth<MillMission>(4))
      .with(sharing<MillMission>())
      .output(&FailedTeethPmf::pmf, "pmf", "P_j", "1", probability(), "probability of j failed teeth")
      .note(equal_note);
  source
      .function<&mill_reliability_load_sharing>("mill_reliability_load_sharing",
                                                "Reliability of a mill whose teeth share the load equally.",
                                                "(C3)", Provenance::completion)
      .with(tooth<MillMission>(exact_tooth))
      .with(teeth<MillMission>(10))
      .with(allowed<MillSharing>(3))
      .with(sharing<MillMission>())
      .with(mill)
      .note(equal_note);
  source
      .function<&mill_reliability_local_sharing>(
          "mill_reliability_local_sharing",
          "Reliability of a mill where the tooth behind a gap takes the extra chip.", "(C4)",
          Provenance::completion)
      .with(tooth<MillMission>(exact_tooth))
      .with(teeth<MillMission>(10, 16))
      .with(allowed<MillSharing>(3, 15))
      .with(sharing<MillMission>())
      .with(mill)
      .note("Exact over the patterns of working teeth. Takes up to 0.2 s for z = 16.");
  source
      .function<&mission_reliability_from_state>("mission_reliability_from_state",
                                                 "Reliability of a mission begun with failed teeth.", "(C3)",
                                                 Provenance::completion)
      .with(tooth<MillMission>(exact_tooth))
      .with(teeth<MillMission>(10))
      .input(&MissionFromState::failed_now, "failed_now", "j", "1", closed(0, 40),
             "failed teeth at the start, not above z", 3)
      .with(allowed<MillSharing>(9))
      .with(sharing<MillMission>())
      .with(mill)
      .note("0 when more teeth have failed than are allowed.")
      .note(equal_note);
  source
      .function<&required_failed_allowed>("required_failed_allowed",
                                          "Failures to be tolerated for a fresh mill to meet a target.",
                                          "(C3)", Provenance::completion)
      .input(&MissionTarget::r_mill_target, "r_mill_target", "R_mill", "1", open(0, 1), "reliability wanted",
             0.95)
      .with(tooth<MillMission>(exact_tooth))
      .with(teeth<MillMission>(10))
      .with(sharing<MillMission>())
      .output(&RequiredFailedAllowed::failed_allowed, "failed_allowed", "c", "1", at_least(0),
              "smallest number of tolerated failures; z - 1 when none is enough")
      .output(&RequiredFailedAllowed::replace_at_failed, "replace_at_failed", "c+1", "1", at_least(1),
              "failed teeth at which the mill is pulled")
      .output(&RequiredFailedAllowed::r_mill_achieved, "r_mill_achieved", "R_mill", "1", probability(),
              "reliability with that number")
      .output(&RequiredFailedAllowed::feasible, "feasible", "-", "-", no_range(), "the target is met")
      .note("The paper's economic range of the target is 0.82-0.95.")
      .note(equal_note);
  source
      .function<&control_limit>("control_limit",
                                "Failed teeth with which the next mission may not be started any more.",
                                "(C3)", Provenance::completion)
      .input(&MissionTarget::r_mill_target, "r_mill_target", "R_mill", "1", open(0, 1), "reliability wanted",
             0.95)
      .with(tooth<MillMission>(exact_tooth))
      .with(teeth<MillMission>(10))
      .with(allowed<ControlTarget>(9))
      .with(sharing<MillMission>())
      .output(&ControlLimit::replace_at_failed, "replace_at_failed", "j", "1", at_least(1),
              "smallest number of failed teeth that forbids the next mission")
      .output(&ControlLimit::working_at_replacement, "working_at_replacement", "z-j", "1", at_least(0),
              "teeth that still work then")
      .output(&ControlLimit::r_last_admissible, "r_last_admissible", "R_mill", "1", probability(),
              "reliability in the worst state still allowed to start")
      .output(&ControlLimit::feasible, "feasible", "-", "-", no_range(), "a fresh mill meets the target")
      .note(equal_note);
  source
      .function<&required_tooth_reliability>("required_tooth_reliability",
                                             "Tooth reliability that gives a mill reliability.",
                                             "(C3), inverse", Provenance::completion)
      .input(&SharingTarget::r_mill, "r_mill", "R_mill", "1", open(0, 1), "reliability wanted", 0.95)
      .with(teeth<SharingTarget>(10))
      .with(allowed<SharingTarget>(3))
      .with(sharing<SharingTarget>())
      .with(tooth_out)
      .note(equal_note);
}

void describe_time(Source& source) {
  source
      .function<&tooth_reliability>("tooth_reliability", "Reliability of a tooth at a cutting time.", "(C5)",
                                    Provenance::completion)
      .input(&ToothAtTime::t_min, "t", "t", "min", non_negative(), "cutting time", 16.0)
      .with(life)
      .with(tooth_out);
  source
      .function<&mission_time>("mission_time", "Cutting time that a tooth survives with a probability.",
                               "(C5), inverse", Provenance::completion)
      .input(&ToothMission::r_tooth, "r_tooth", "R_z", "1", exact_tooth, "probability of survival", 0.9)
      .with(life)
      .output(&Time::t_min, "t", "t", "min", non_negative(), "cutting time");
  source
      .function<&failure_times>("failure_times", "Times and order in which the teeth of a mill fail.", "(C6)",
                                Provenance::completion)
      .input(&ToothLives::lives_min, "tooth_lives", "xi_i", "min", positive(),
             "life of each tooth at nominal load, in order round the mill (tooth i cuts after tooth i-1)",
             Value::List{50.0, 30.0, 44.0, 61.0})
      .length(1, 40)
      .with(sharing<ToothLives>())
      .optional(&ToothLives::rule, "rule", "-", "-", no_range(),
                "who takes the load of failed teeth: all (equal) or the tooth behind the gap (local)")
      .output(&FailureTimes::times_min, "times", "T_n", "min", positive(), "time of each failure")
      .output(&FailureTimes::order, "order", "-", "1", at_least(0), "index of the tooth that fails, from 0");
  source
      .function<&mean_time_to_nth_failure>("mean_time_to_nth_failure", "Mean time to the n-th tooth failure.",
                                           "(C7)", Provenance::completion)
      .input(&NthFailure::n, "n", "n", "1", closed(1, 40), "number of the failure, not above z", 4)
      .with(teeth<NthFailure>(10))
      .with(life)
      .with(sharing<NthFailure>())
      .output(&MeanTime::t_mean_min, "t_mean_n", "E[T_n]", "min", positive(), "mean time")
      .note("Equal sharing, wear-exposure model.");
  source
      .function<&mill_reliability_exposure>(
          "mill_reliability_exposure", "Reliability of a mill whose teeth wear at the rate of their load.",
          "(C8)", Provenance::completion)
      .input(&Exposure::t_min, "t", "t", "min", non_negative(), "cutting time of a fresh mill", 16.0)
      .with(teeth<Exposure>(10))
      .with(allowed<Exposure>(1))
      .with(life)
      .with(sharing<Exposure>())
      .with(mill)
      .note("failed_allowed >= 3: 2^20 draws of a fixed seed, standard error below 5e-4, 0.2 s and more.")
      .note("Equal sharing.");
  source
      .function<&policy_cost>("policy_cost",
                              "Long-run cost of replacing all edges at a failure number or at an age.",
                              "(C9)", Provenance::completion)
      .with(teeth<Policy>(10))
      .with(allowed<Policy>(3))
      .input(&Policy::t_planned_min, "t_planned", "t_p", "min", positive(),
             "planned change age in cutting time; very large = only at failures", 16.0)
      .with(life)
      .with(sharing<Policy>())
      .input(&Policy::edge_cost, "c_edge", "c_edge", "money", non_negative(), "cost of an edge", 2.0)
      .input(&Policy::planned_cost, "c_planned", "c_planned", "money", non_negative(),
             "cost of a planned change", 5.0)
      .input(&Policy::unplanned_cost, "c_unplanned", "c_unplanned", "money", non_negative(),
             "cost of an unplanned change", 40.0)
      .input(&Policy::machine_rate_per_min, "c_machine", "c_machine", "money/min", non_negative(),
             "cost of a machine minute, cutting and changing", 0.8)
      .input(&Policy::change_planned_min, "t_change_planned", "t_pl", "min", non_negative(),
             "time of a planned change", 6.0)
      .input(&Policy::change_unplanned_min, "t_change_unplanned", "t_un", "min", non_negative(),
             "time of an unplanned change", 15.0)
      .output(&PolicyCost::mean_cycle_cutting_min, "mean_cycle_cutting_time", "E_T", "min", positive(),
              "cutting time between changes")
      .output(&PolicyCost::p_unplanned, "p_unplanned", "p_u", "1", probability(),
              "share of the changes that are unplanned")
      .output(&PolicyCost::cost_per_cutting_min, "cost_per_cutting_min", "-", "money/min", non_negative(),
              "cost per cutting minute")
      .output(&PolicyCost::availability, "availability", "A", "1", probability(),
              "share of cutting in cutting and changing")
      .note(equal_note);
}

void describe_kinematics(Source& source) {
  source.function<&spindle_speed>("spindle_speed", "Spindle speed.", "definition", Provenance::completion)
      .input(&SpindleIn::cutting_speed_m_min, "v_c", "v_c", "m/min", positive(), "cutting speed", 180.0)
      .input(&SpindleIn::diameter_mm, "d", "D", "mm", positive(), "diameter of the mill", 32.0)
      .output(&SpindleSpeed::speed_rpm, "n", "n", "1/min", positive(), "spindle speed");
  source.function<&table_feed>("table_feed", "Table feed.", "definition", Provenance::completion)
      .input(&TableFeedIn::feed_per_tooth_mm, "f_z", "S_z", "mm", positive(), "feed per tooth", 0.18)
      .with(teeth<TableFeedIn>(3))
      .input(&TableFeedIn::speed_rpm, "n", "n", "1/min", positive(), "spindle speed", 1800.0)
      .output(&TableFeed::feed_mm_min, "v_f", "S_min", "mm/min", positive(), "table feed");
  source
      .function<&material_removal_rate>("material_removal_rate", "Material removal rate.", "definition",
                                        Provenance::completion)
      .input(&Removal::width_mm, "width", "B", "mm", positive(), "width of cut", 24.0)
      .input(&Removal::depth_mm, "depth", "t", "mm", positive(), "depth of cut", 3.0)
      .input(&Removal::feed_mm_min, "v_f", "S_min", "mm/min", positive(), "table feed", 970.0)
      .output(&RemovalRate::rate_cm3_min, "q", "Q", "cm3/min", positive(), "material removal rate");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K109",
       .title = "Determination of the quality of assembled face mills",
       .authors = "Klimenko G. P., Denisova A. O.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A face mill keeps cutting after single teeth fail; the survivors take over their chip. At how "
           "many "
           "failed teeth should it be pulled so that its reliability stays at an economically rational level "
           "(0.82-0.95)? The paper's redundancy formula, the exact reliabilities that it approximates, life "
           "in "
           "time, and the cost of a replacement policy.",
       .role = "reliability",
       .errata = {
           "Table 1 is headed z = 4 but names a mill with z = 3, and 0.18 mm x 3 x 1800 1/min = 972 mm/min "
           "(printed 970): the row belongs to z = 3.",
           "The text defines m as the teeth that must still work, the formula counts spare complete mills; "
           "the "
           "two contradict each other (one rises with m, the other falls)."}});
  describe_paper(source);
  describe_mission(source);
  describe_time(source);
  describe_kinematics(source);
}

}  // namespace verstat::models::k109
