#include "models/drilling/k410_drilling_fem.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/QR>
#include <fmt/format.h>

namespace verstat::models::k410 {
namespace {

using Index = Eigen::Index;

std::int64_t entries(const std::vector<double>& list) {
  return static_cast<std::int64_t>(list.size());
}

}  // namespace

CuttingSpeed cutting_speed(const DrillRotation& in) {
  return guarded<&cutting_speed>(
      in, [&] { return CuttingSpeed{std::numbers::pi * in.diameter_mm * in.spindle_rpm / 1000}; });
}

DrillingLoads drilling_loads(const Drilling& in) {
  return guarded<&drilling_loads>(in, [&] {
    const double material = std::pow(in.strength_mpa / 750, in.material_exponent);
    const double thrust = 10 * in.thrust_coefficient * std::pow(in.diameter_mm, in.thrust_diameter_exponent) *
                          std::pow(in.feed_mm_rev, in.thrust_feed_exponent) * material;
    const double torque = 10 * in.torque_coefficient * std::pow(in.diameter_mm, in.torque_diameter_exponent) *
                          std::pow(in.feed_mm_rev, in.torque_feed_exponent) * material;
    return DrillingLoads{material, thrust, torque, torque * in.spindle_rpm / 9550};
  });
}

HandbookSpeed drilling_handbook_speed(const DrillLife& in) {
  return guarded<&drilling_handbook_speed>(in, [&] {
    const bool fine = in.feed_mm_rev <= 0.2;
    const double speed = (fine ? 7.0 : 9.8) * std::pow(in.diameter_mm, 0.4) /
                         (std::pow(in.life_min, 0.2) * std::pow(in.feed_mm_rev, fine ? 0.7 : 0.5)) *
                         in.speed_factor;
    return HandbookSpeed{speed, 1000 * speed / (std::numbers::pi * in.diameter_mm)};
  });
}

DrillingTime drilling_main_time(const DrilledHole& in) {
  return guarded<&drilling_main_time>(in, [&] {
    const double cone = in.diameter_mm / (2 * std::tan(in.point_angle_deg / 2 * std::numbers::pi / 180));
    const double path = in.approach_mm + in.depth_mm + (in.through ? cone + in.overrun_mm : 0);
    return DrillingTime{cone, path, path / (in.spindle_rpm * in.feed_mm_rev)};
  });
}

PowerLawFit fit_power_law(const Runs& in) {
  return guarded<&fit_power_law>(in, [&] {
    const std::size_t runs = in.factors.size();
    const std::size_t factors = in.factors.front().size();
    require(factors >= 1, "factors", std::int64_t{0},
            "entries in the first run: at least one factor is needed");
    for (const auto& row : in.factors)
      require(row.size() == factors, "factors", entries(row), "entries in a run: all runs must have as many");
    require(in.response.size() == runs, "response", entries(in.response), "entries: must be as many as runs");
    require(runs >= factors + 1, "response", entries(in.response),
            "entries: at least one more run than factors is needed");
    // Centred logarithms: the intercept drops out and equal scales make the test of rank fair.
    Eigen::MatrixXd x(static_cast<Index>(runs), static_cast<Index>(factors));
    Eigen::VectorXd y(static_cast<Index>(runs));
    for (std::size_t i = 0; i < runs; ++i) {
      y(static_cast<Index>(i)) = std::log(in.response[i]);
      for (std::size_t j = 0; j < factors; ++j)
        x(static_cast<Index>(i), static_cast<Index>(j)) = std::log(in.factors[i][j]);
    }
    const Eigen::RowVectorXd centre = x.colwise().mean();
    const double y_centre = y.mean();
    Eigen::MatrixXd scaled = x.rowwise() - centre;
    Eigen::VectorXd length(static_cast<Index>(factors));
    for (Index j = 0; j < scaled.cols(); ++j) {
      length(j) = scaled.col(j).norm();
      require(length(j) > 1e-12 * (1 + std::abs(centre(j))), "factors",
              in.factors.front()[static_cast<std::size_t>(j)],
              fmt::format("in every run: factor {} must vary between the runs", j + 1));
      scaled.col(j) /= length(j);
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
    qr.setThreshold(1e-10);
    if (qr.rank() < scaled.cols())
      reject("factors: two or more are collinear in logarithms, their exponents are lost");
    const Eigen::VectorXd centred = y.array() - y_centre;
    const Eigen::VectorXd exponents = qr.solve(centred).cwiseQuotient(length);
    const double intercept = y_centre - centre.dot(exponents);
    PowerLawFit fit{};
    fit.coefficient = std::exp(intercept);
    fit.exponents.assign(exponents.data(), exponents.data() + exponents.size());
    const Eigen::VectorXd rest = (x.rowwise() - centre) * exponents - centred;
    const std::size_t freedom = runs - factors - 1;
    fit.rms_log_error = freedom == 0 ? 0 : std::sqrt(rest.squaredNorm() / static_cast<double>(freedom));
    for (Index i = 0; i < rest.size(); ++i)
      fit.max_relative_error = std::max(fit.max_relative_error, std::abs(std::expm1(rest(i))));
    return fit;
  });
}

PowerLawValue power_law_value(const PowerLaw& in) {
  return guarded<&power_law_value>(in, [&] {
    require(in.x.size() == in.exponents.size(), "x", entries(in.x), "entries: must be as many as exponents");
    double value = in.coefficient;
    for (std::size_t j = 0; j < in.x.size(); ++j) value *= std::pow(in.x[j], in.exponents[j]);
    return PowerLawValue{value};
  });
}

Agreement model_agreement(const Comparison& in) {
  return guarded<&model_agreement>(in, [&] {
    require(in.model.size() == in.reference.size(), "reference", entries(in.reference),
            "entries: must be as many as model");
    const double count = static_cast<double>(in.model.size());
    Agreement out{};
    double log_mean = 0;
    for (std::size_t k = 0; k < in.model.size(); ++k) {
      const double error = in.model[k] / in.reference[k] - 1;
      out.mean_relative_error += error / count;
      out.max_abs_relative_error = std::max(out.max_abs_relative_error, std::abs(error));
      log_mean += (std::log(in.model[k]) - std::log(in.reference[k])) / count;
    }
    out.scale = std::exp(-log_mean);
    return out;
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K410",
       .title = "Modeling of the cutting process by the finite element method in the Deform 3D environment",
       .authors = "Globa O. V., Kulbachnyi O. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "Drilling of steel simulated by finite elements, compared with a handbook thrust. The "
                 "results of such "
                 "runs enter as fitted power laws; thrust, torque, speed and time of drilling follow the "
                 "handbook the "
                 "paper cites.",
       .role = "drilling",
       .errata = {
           "Handbooks in kilowatts commonly print M n/9750; the identity of units M n/9550 is used.",
           "The printed 3200 N is the handbook thrust without the factor of material: not a validation for "
           "steel 20 (2073 N)."}});
  const auto diameter = [](auto& f, auto member) {
    f.input(member, "D_mm", "D", "mm", positive(), "diameter of the drill", 10.0);
  };
  const auto rotation = [](auto& f, auto member) {
    f.input(member, "n_rpm", "n", "rpm", positive(), "spindle speed", 600.0);
  };
  const auto feed = [](auto& f, auto member) {
    f.input(member, "feed_mm_rev", "s", "mm/rev", positive(), "feed", 0.35);
  };

  source
      .function<&cutting_speed>("cutting_speed", "Cutting speed of a drill.", "definition", Provenance::paper)
      .with([&](auto& f) {
        diameter(f, &DrillRotation::diameter_mm);
        rotation(f, &DrillRotation::spindle_rpm);
      })
      .output(&CuttingSpeed::speed_m_min, "v_m_min", "v", "m/min", positive(), "cutting speed");
  source
      .function<&drilling_loads>("drilling_loads", "Thrust, torque and power of drilling.",
                                 "handbook the paper cites", Provenance::completion)
      .input(&Drilling::diameter_mm, "D_mm", "D", "mm", closed(2, 60), "diameter of the drill", 10.0)
      .input(&Drilling::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", closed(0.02, 1.2), "feed", 0.35)
      .with([&](auto& f) { rotation(f, &Drilling::spindle_rpm); })
      .optional(&Drilling::strength_mpa, "sigma_u_mpa", "sigma_u", "MPa", closed(300, 1200),
                "tensile strength of the work")
      .optional(&Drilling::thrust_coefficient, "cp", "C_p", "1", positive(), "thrust coefficient")
      .optional(&Drilling::thrust_diameter_exponent, "qp", "q", "1", any(), "exponent of D in thrust")
      .optional(&Drilling::thrust_feed_exponent, "yp", "y", "1", any(), "exponent of s in thrust")
      .optional(&Drilling::torque_coefficient, "cm", "C_m", "1", positive(), "torque coefficient")
      .optional(&Drilling::torque_diameter_exponent, "qm", "q_m", "1", any(), "exponent of D in torque")
      .optional(&Drilling::torque_feed_exponent, "ym", "y_m", "1", any(), "exponent of s in torque")
      .optional(&Drilling::material_exponent, "n_k", "n_k", "1", any(), "exponent of strength")
      .output(&DrillingLoads::material_factor, "k_material", "K_p", "1", positive(), "factor of the material")
      .output(&DrillingLoads::thrust_n, "thrust_N", "P_0", "N", positive(), "thrust")
      .output(&DrillingLoads::torque_nm, "torque_Nm", "M", "N*m", positive(), "torque")
      .output(&DrillingLoads::power_kw, "power_kW", "N", "kW", positive(), "power")
      .note("Twist drill of high-speed steel in structural steel.");
  source
      .function<&drilling_handbook_speed>("drilling_handbook_speed", "Speed of drilling for a drill life.",
                                          "handbook the paper cites", Provenance::completion)
      .with([&](auto& f) {
        diameter(f, &DrillLife::diameter_mm);
        feed(f, &DrillLife::feed_mm_rev);
      })
      .input(&DrillLife::life_min, "T_min", "T", "min", positive(), "drill life", 25.0)
      .optional(&DrillLife::speed_factor, "kv", "K_v", "1", positive(), "factor of the material")
      .output(&HandbookSpeed::speed_m_min, "v_m_min", "v", "m/min", positive(), "cutting speed")
      .output(&HandbookSpeed::spindle_rpm, "n_rpm", "n", "rpm", positive(), "spindle speed")
      .note(
          "Usual lives: 15 min up to 5 mm, 25 to 10, 45 to 20, 50 to 30, 70 to 40, 90 to 50, 110 to 60 mm.");
  source
      .function<&drilling_main_time>("drilling_main_time", "Path and main time of drilling.", "completion",
                                     Provenance::completion)
      .with([&](auto& f) { diameter(f, &DrilledHole::diameter_mm); })
      .input(&DrilledHole::depth_mm, "depth_mm", "l", "mm", positive(), "depth of the hole", 30.0)
      .optional(&DrilledHole::point_angle_deg, "point_angle_deg", "epsilon", "deg", open(0, 180),
                "point angle")
      .input(&DrilledHole::approach_mm, "approach_mm", "l_1", "mm", non_negative(), "approach", 2.0)
      .input(&DrilledHole::overrun_mm, "overrun_mm", "l_2", "mm", non_negative(),
             "overrun, ignored for a blind hole", 1.5)
      .with([&](auto& f) {
        rotation(f, &DrilledHole::spindle_rpm);
        feed(f, &DrilledHole::feed_mm_rev);
      })
      .input(&DrilledHole::through, "through", "-", "-", no_range(), "through hole", true)
      .output(&DrillingTime::cone_mm, "cone_mm", "-", "mm", non_negative(), "height of the drill point")
      .output(&DrillingTime::path_mm, "path_mm", "-", "mm", positive(), "path of the drill")
      .output(&DrillingTime::main_time_min, "t_main_min", "t_0", "min", positive(), "main time");
  source
      .function<&fit_power_law>("fit_power_law", "Power law through a table of runs.", "completion",
                                Provenance::completion)
      .input(&Runs::factors, "factors", "x", "as given", positive(), "factors, one row per run",
             Value::List{Value::List{6.0, 0.15}, Value::List{6.0, 0.35}, Value::List{10.0, 0.15},
                         Value::List{10.0, 0.36}})
      .length(2, 100'000)
      .input(&Runs::response, "response", "y", "as given", positive(), "response of every run",
             Value::List{1102.9, 1976.2, 1766.0, 3261.0})
      .length(2, 100'000)
      .output(&PowerLawFit::coefficient, "C", "C", "as given", positive(), "coefficient")
      .output(&PowerLawFit::exponents, "exponents", "e", "1", any(), "exponents of the factors")
      .output(&PowerLawFit::rms_log_error, "rms_log_error", "-", "1", non_negative(),
              "residual standard deviation of ln y, 0 without degrees of freedom")
      .output(&PowerLawFit::max_relative_error, "max_rel_error", "-", "1", non_negative(),
              "largest |fit/y - 1|");
  source
      .function<&power_law_value>("power_law_value", "Value of a power law.", "completion",
                                  Provenance::completion)
      .input(&PowerLaw::coefficient, "C", "C", "as given", any(), "coefficient", 680.0)
      .input(&PowerLaw::exponents, "exponents", "e", "1", any(), "exponents", Value::List{1.0, 0.7})
      .input(&PowerLaw::x, "x", "x", "as given", positive(), "factors", Value::List{12.0, 0.25})
      .output(&PowerLawValue::value, "value", "y", "as given", any(), "value");
  source
      .function<&model_agreement>("model_agreement", "How far a model agrees with a reference.", "completion",
                                  Provenance::completion)
      .input(&Comparison::model, "model", "-", "as given", positive(), "values of the model",
             Value::List{3150.0, 2210.0, 980.0})
      .length(1, 100'000)
      .input(&Comparison::reference, "reference", "-", "as given", positive(), "values of the reference",
             Value::List{3261.4, 2150.0, 1010.0})
      .length(1, 100'000)
      .output(&Agreement::mean_relative_error, "mean_rel_error", "-", "1", any(),
              "mean of model/reference - 1")
      .output(&Agreement::max_abs_relative_error, "max_abs_rel_error", "-", "1", non_negative(),
              "largest magnitude")
      .output(&Agreement::scale, "scale_to_reference", "-", "1", positive(),
              "factor that calibrates the model");
}

}  // namespace verstat::models::k410
