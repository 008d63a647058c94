#include "sim/shop/lots.h"

#include <cmath>

#include "models/inspection/k119_cutter_certification.h"
#include "models/math/normal.h"

namespace verstat::shop {

namespace {

double sample_correlation(const scenarios::CertifiedLots& spec) {
  if (spec.ln_sd_between == 0) return 0;  // all lots alike: the sample shows scatter only
  return spec.test_correlation * models::k119::lot_mean_correlation({.ln_sd_between = spec.ln_sd_between,
                                                                     .ln_sd_within = spec.ln_sd_within,
                                                                     .sample_size = spec.sample_size})
                                     .rho_lot;
}

}  // namespace

LotSource::LotSource(const scenarios::CertifiedLots& spec, std::uint64_t seed, const std::string& insert,
                     std::uint64_t replication)
    : spec_(&spec),
      lot_stream_(seed, insert, "lot mean life", replication),
      sample_stream_(seed, insert, "lot sample", replication),
      correlation_(sample_correlation(spec)),
      threshold_(models::normal_quantile(spec.reject_fraction)) {}

double LotSource::next_life_factor() {
  if (left_ == 0) open_lot();
  --left_;
  return life_factor_;
}

void LotSource::open_lot() {
  left_ = spec_->lot_size;
  for (;;) {
    const double lot_score = models::normal_quantile(lot_stream_.uniform());
    const double scatter = models::normal_quantile(sample_stream_.uniform());
    const double sample_score =
        correlation_ * lot_score + std::sqrt(1 - correlation_ * correlation_) * scatter;
    const double s = spec_->ln_sd_between;
    life_factor_ = std::exp(s * lot_score - s * s / 2);
    ++counts_.tested;
    counts_.cost += spec_->test_cost * static_cast<double>(spec_->sample_size);
    if (sample_score >= threshold_) return;
    ++counts_.rejected;
    if (spec_->rejected == scenarios::RejectedLot::retreat) {
      life_factor_ *= spec_->retreat_life_factor;
      counts_.cost += spec_->retreat_cost * static_cast<double>(spec_->lot_size);
      return;
    }
  }
}

}  // namespace verstat::shop
